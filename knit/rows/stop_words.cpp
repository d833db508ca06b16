#include "knit/rows/stop_words.h"

#include "knit/model/words.h"
#include "knit/rows/rows.h"

namespace knit {

namespace {

// The way that knits any shape.
constexpr const char* contours_words = "take rows from contours (--rows contours, or --preset best-rows)";

// Why a level set falls into several loops, and what a person may do.
std::string split_text(const std::string& where, const Stopped& s) {
  const std::string head = where + ": at level " + std::to_string(s.level) + ", t = " + short_number(s.time) +
                           ", the level set splits into " + std::to_string(s.count) + " loops, ";
  const std::string saddle =
      "the saddle at " + vertex_text(s.vertex) + " (t = " + short_number(s.value) + ")";
  const std::string why =
      s.cause == CriticalKind::saddle
          ? "because the surface parts at " + saddle
          : "because another lowest part of the shape has begun, which joins the first only at " + saddle;
  return head + why + ". One tube cannot follow several: " + contours_words +
         ", which knit each as a tube of its own. A shape without a handle may have rings along another "
         "axis; one with a handle, like a ring, branches along every axis.";
}

}  // namespace

std::string band_text(const Parameters& parameters) {
  const Band band = band_of(parameters.rows, parameters.stitch);
  return "[" + short_number(band.low) + ", " + short_number(band.high) + "]";
}

std::string rows_stop_sentence(const Stopped& s, const Telling& at) {
  std::string where = at.place.stage == Stage::cast_on ? "Cast on" : at.row();
  const std::string level = "level " + std::to_string(s.level) + " at t = " + short_number(s.time);
  switch (s.reason) {
    case StopReason::no_extent:
    case StopReason::too_many_tubes:
    case StopReason::too_fine:
    case StopReason::open_edge:
      break;
    case StopReason::no_row_levels:
      if (s.time > 0.0) {
        return "Cast on: of the " + std::to_string(s.level) +
               " levels of this mesh only that at t = " + short_number(s.time) +
               " makes a row, and one row is no piece; " + contours_words +
               ", another axis, or a mesh with more rings across it.";
      }
      return "Cast on: none of the " + std::to_string(s.level) +
             " levels of this mesh makes a first row between start and end; " + contours_words +
             ", another axis, a mesh with rings across it, or a stitch width below " + short_number(s.value) +
             ".";
    case StopReason::not_a_ring:
      return where + ": no closed ring can be made of the " + plural(s.count, "vertex", "vertices") + " of " +
             level + " (" + vertex_text(s.vertex) + "); " + contours_words +
             ", another axis, or a mesh with rings across it.";
    case StopReason::splits:
      return split_text(where, s);
    case StopReason::stall:
      return where + ": nothing within " + band_text(at.parameters) + " of stitch " +
             std::to_string(s.count) + " (" + vertex_text(s.vertex) + "); nearest " + short_number(s.value) +
             ". Widen epsilon, change the stitch width, or continue on a stall.";
    case StopReason::changes_too_much:
      return where + ": " + stitch_count_text(s.count) + " cannot follow " + std::to_string(s.other) +
             "; a row may at most double or halve. Change the stitch width, or let such rows be resampled.";
  }
  return where;
}

}  // namespace knit
