#include "knit/insight/as_asked.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "knit/model/words.h"

namespace knit {

namespace {

bool is_off(double knitted, double asked) {
  return asked > 0.0 && std::abs(knitted - asked) > size_off * asked;
}

// To half a centimetre, as the pattern says sizes.
std::string cm_text(double cm) {
  const double step = cm < 5.0 ? 0.1 : 0.5;
  return short_number(std::round(cm / step) * step) + " cm";
}

std::string size_text(const PieceSize& size) {
  const std::string around = cm_text(size.around_cm) + " around";
  return size.height_cm ? cm_text(*size.height_cm) + " high and " + around : around + " at the widest";
}

std::string to_step(double value, double step) { return short_number(std::round(value / step) * step); }

}  // namespace

PieceSize size_asked(const State& state, const Parameters& parameters) {
  double longest = 0.0;
  for (const auto& row : state.fabric.rows())
    if (row->ring) longest = std::max(longest, row->ring->length);
  return {parameters.size.height_cm, longest * parameters.stitch.centimetres_per_unit};
}

std::optional<Remark> remark_on_size(const PieceSize& knitted, const PieceSize& asked,
                                     const Parameters& parameters) {
  const bool high = knitted.height_cm && asked.height_cm && is_off(*knitted.height_cm, *asked.height_cm);
  if (!high && !is_off(knitted.around_cm, asked.around_cm)) return std::nullopt;
  const PieceSize beside{knitted.height_cm ? asked.height_cm : std::nullopt, asked.around_cm};
  const bool rings = parameters.rows.source == RowSource::rings;
  return Remark{RemarkKind::size,
                "Knitted, it comes out about " + size_text(knitted) + "; asked for was " + size_text(beside) +
                    (rings ? ". Rows from contours come out as asked." : ". Finer stitches come nearer.")};
}

std::optional<double> rounds_that_go_with(const Gauge& gauge) {
  const double share = gauge.stitches / gauge.rounds;  // a stitch's height over its width
  if (share >= flattest_stitch && share <= tallest_stitch) return std::nullopt;
  return std::max(1.0, std::round(gauge.stitches / height_of_width));
}

std::optional<Remark> remark_on_swatch(const Parameters& parameters) {
  const Gauge& gauge = parameters.stitch.gauge;
  const auto rounds = rounds_that_go_with(gauge);
  if (!rounds) return std::nullopt;
  const double share = gauge.stitches / gauge.rounds;
  const std::string fabric =
      "A stitch " + to_step(share, 0.01) +
      " as high as it is wide is hardly knitted fabric: " + to_step(gauge.stitches, 0.1) + " stitches and " +
      to_step(gauge.rounds, 0.1) + " rounds in 10 cm, where stockinette has 0.65 to 0.77.";
  const std::string usual = to_step(*rounds, 1.0);
  return Remark{RemarkKind::swatch, parameters.size.from() == SizesFrom::gauge
                                        ? fabric + " " + to_step(gauge.stitches, 0.1) +
                                              " stitches go with about " + usual +
                                              " rounds; measure a swatch."
                                        : fabric + " Stitch height auto makes it 0.72."};
}

std::optional<Remark> remark_on_placement(const State& state, const Parameters& wished) {
  const std::optional<PlacedBy>& by = state.short_rows.foreseen_by;
  if (!by || !by->for_good) return std::nullopt;
  StitchSettings stitches = wished.stitches;
  if (stitches.placement == PlacementPolicy::by_itself) stitches.placement = by->stitches.placement;
  if (stitches == by->stitches && wished.rows.round_start == by->round_start) return std::nullopt;
  return Remark{
      RemarkKind::placement,
      "Stitches are placed as before the change: short rows turn beside the shaping that this gave. "
      "Applied from the start, the change holds everywhere."};
}

}  // namespace knit
