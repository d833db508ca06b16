#include <cmath>

#include "knit/model/words.h"
#include "knit/short_rows/kept_choice.h"
#include "knit/short_rows/short_row_events.h"
#include "knit/short_rows/short_row_variables.h"
#include "knit/tubes/plan.h"

namespace knit {

namespace {

std::string_view word_of(NoChart none) {
  switch (none) {
    case NoChart::no:
      return "no";
    case NoChart::no_loop:
      return "no loop";
    case NoChart::apart:
      return "apart";
    case NoChart::no_annulus:
      return "no annulus";
    case NoChart::residual:
      return "residual";
    case NoChart::not_solved:
      return "not solved";
    case NoChart::crowded:
      return "crowded";
    case NoChart::no_pair:
      return "no pair";
  }
  return "";
}

std::string why_words(NoChart none) {
  switch (none) {
    case NoChart::no_loop:
      return "the surface has no loop where it begins or ends";
    case NoChart::apart:
      return "its two ends are not joined by one part of the surface";
    case NoChart::no_annulus:
      return "its part of the surface has a handle or a hole";
    case NoChart::residual:
      return "its chart would be too crooked";
    case NoChart::not_solved:
      return "its equations have no solution";
    case NoChart::crowded:
      return "its near side leaves no room for a round";
    case NoChart::no_pair:
      return "no row is missing on either side";
    case NoChart::no:
      break;
  }
  return "";
}

std::string_view word_of(DropReason reason) {
  switch (reason) {
    case DropReason::no_plain_stitch:
      return "no plain stitch";
    case DropReason::too_few:
      return "too few";
    case DropReason::too_many:
      return "too many";
  }
  return "";
}

std::string gap_words(std::int32_t gap) { return "Gap " + std::to_string(gap + 1); }

// "3 stitches before to 4 stitches after the beginning of the round", "stitches 5 to 9".
std::string where_words(std::int32_t first, std::int32_t last) {
  if (first >= 0) return "stitches " + std::to_string(first + 1) + " to " + std::to_string(last + 1);
  return stitch_count_text(-first) + " before to " + std::to_string(last + 1) +
         " after the beginning of the round";
}

// "2 rows kept at events".
std::string kept_words(std::int32_t kept) {
  if (kept == no_short_rows) return "no short rows";
  return kept == 0 ? "no row kept at events" : plural(kept, "row", "rows") + " kept at events";
}

std::string thousandths(float sum) { return short_number(1000.0 * static_cast<double>(sum)); }

// Nothing was settled ahead, so nothing could be compared.
std::string unsettled_words(const KeptChosen& chosen) {
  const std::string why = chosen.by == ChosenBy::unsettled
                              ? "stitches are not to settle"
                              : "the piece has too many stitches to settle it in each way";
  if (chosen.kept == no_short_rows)
    return "No short rows: " + why +
           ", and unsettled it can't be seen whether they help a piece that branches. Say how many rows "
           "tubes "
           "keep at events to have them.";
  return "Chosen: " + plural(chosen.pairs, "pair of short rows", "pairs of short rows") + ", because " + why +
         " and a piece of one tube is mostly better with them.";
}

}  // namespace

std::string KeptTried::sentence(const Telling& /*at*/) const {
  std::string text = "Tried: " + kept_words(kept);
  if (kept != no_short_rows) text += ", " + plural(pairs, "pair of short rows", "pairs of short rows");
  if (!std::isfinite(sum)) return text + "; it can't be worked so.";
  return text + ", " + stitch_count_text(stitches) + "; settled, " + thousandths(sum) +
         " thousandths a stitch are left" +
         (best    ? ", the least so far."
          : worse ? "; but its wales are less even than without short rows, or the longest is longer."
                  : ".");
}
StepFields KeptTried::numbers() const {
  return {{var::rows_kept, kept}, {var::pairs, pairs}, {var::settled_sum, static_cast<double>(sum)}};
}

std::string KeptChosen::sentence(const Telling& /*at*/) const {
  switch (by) {
    case ChosenBy::no_arc_pays:
      return "No short rows: no arc of any tube gains more than its turns cost.";
    case ChosenBy::unsettled:
    case ChosenBy::too_many:
      return unsettled_words(*this);
    case ChosenBy::wales:
      return "No short rows: with them less is left, but wales come out less even than without, or the "
             "longest "
             "is longer.";
    case ChosenBy::settling:
      break;
  }
  if (kept == no_short_rows) return "No short rows: the piece settles best without.";
  return "Chosen: " + kept_words(kept) + ", " + plural(pairs, "pair of short rows", "pairs of short rows") +
         "; " + thousandths(sum) + " thousandths a stitch are left, and " + thousandths(without) +
         " without short rows.";
}
StepFields KeptChosen::numbers() const {
  return {{var::rows_kept, kept},
          {var::pairs, pairs},
          {var::settled_sum, static_cast<double>(sum)},
          {var::sum_without, static_cast<double>(without)}};
}

std::string TubeCharted::sentence(const Telling& /*at*/) const {
  const std::string name = "Tube " + tube_name(tube);
  if (none != NoChart::no) return name + " keeps its level rows without short rows: " + why_words(none) + ".";
  return name + " gets a chart of its own of " + plural(levels, "level", "levels") + ", " +
         short_number(100.0 * static_cast<double>(residual)) + " % from square, and " +
         plural(rounds, "full round", "full rounds") + " in place of " + plural(rows, "row", "rows") + ", " +
         short_number(static_cast<double>(spacing)) + " apart on its near side.";
}
StepFields TubeCharted::numbers() const {
  return {{var::chart_levels, levels},
          {var::full_rounds, rounds},
          {var::residual, static_cast<double>(residual)},
          {var::near_spacing, static_cast<double>(spacing)},
          {var::no_chart, word_of(none)}};
}

std::string GapMeasured::sentence(const Telling& /*at*/) const {
  return gap_words(gap) + ": up to " + short_number(static_cast<double>(greatest)) +
         " rows are missing on the far side, at column " + std::to_string(column) + ", and " +
         short_number(static_cast<double>(least)) + " on the near one.";
}
StepFields GapMeasured::numbers() const {
  return {{var::short_gap, gap + 1},
          {var::lag_column, column},
          {var::lag, static_cast<double>(greatest)},
          {var::least_lag, static_cast<double>(least)}};
}

std::string ArcTried::sentence(const Telling& /*at*/) const {
  const std::string text = gap_words(gap) + ": the best arc, columns " + std::to_string(from) + " to " +
                           std::to_string(to) + ", gains " + short_number(static_cast<double>(gain)) +
                           " for " + short_number(static_cast<double>(price));
  return text + (taken ? "; it gets a pair of short rows." : "; that does not pay.");
}
StepFields ArcTried::numbers() const {
  return {{var::short_gap, gap + 1},
          {var::arc_from, from},
          {var::arc_to, to},
          {var::gain, static_cast<double>(gain)},
          {var::price, static_cast<double>(price)},
          {var::arc_taken, taken}};
}

std::string PairsChosen::sentence(const Telling& /*at*/) const {
  return "Tube " + tube_name(tube) + " gets " + plural(pairs, "pair of short rows", "pairs of short rows") +
         " over " + plural(rounds, "full round", "full rounds") + "; at most " +
         short_number(static_cast<double>(greatest_lag)) + " rows are missing or too many anywhere.";
}
StepFields PairsChosen::numbers() const {
  return {
      {var::pairs, pairs}, {var::full_rounds, rounds}, {var::lag_left, static_cast<double>(greatest_lag)}};
}

std::string PairPlaced::sentence(const Telling& at) const {
  std::string text = at.row() + ": a pair of short rows goes over " + where_words(first, last) +
                     " of the round below; " + short_number(static_cast<double>(lag)) +
                     " rows are missing there, and it gains " + short_number(static_cast<double>(gain)) +
                     " for " + short_number(static_cast<double>(price));
  if (moved > 0) text += "; a turn is moved by " + stitch_count_text(moved) + " to a plain one";
  return text + ".";
}
StepFields PairPlaced::numbers() const {
  return {{var::first_stitch, first + 1},
          {var::last_stitch, last + 1},
          {var::turn_moved, moved},
          {var::gain, static_cast<double>(gain)},
          {var::price, static_cast<double>(price)},
          {var::lag, static_cast<double>(lag)}};
}

std::string PairDropped::sentence(const Telling& at) const {
  return sentence_of(DroppedPair{0, first, last, reason}, at.place.row);
}
StepFields PairDropped::numbers() const {
  return {{var::first_stitch, first + 1}, {var::last_stitch, last + 1}, {var::drop_reason, word_of(reason)}};
}

std::string ShortRowWorked::sentence(const Telling& at) const {
  return at.row() + ": a short row of " + stitch_count_text(stitches) + " is worked on the " +
         (back ? "wrong" : "right") + " side over " + where_words(first, last) + ", and the work is turned.";
}
StepFields ShortRowWorked::numbers() const {
  return {{var::short_stitches, stitches},
          {var::first_stitch, first + 1},
          {var::last_stitch, last + 1},
          {var::wrong_side, back}};
}

}  // namespace knit
