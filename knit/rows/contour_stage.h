// Stages 2 and 3 with contours, one smallest step at a time: tube after tube in working order, a row for each of its curves,
// and between tubes the deals that their events make.
//
// A deal is done right before the first tube that is worked on what it gives is taken up, as a knitter does it: until then the
// loops that it takes wait as they are. Its steps count towards the row to come. A ring's strip is there with its second side.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/heard.h"
#include "knit/model/products.h"
#include "knit/rhythm/tube_rhythm.h"
#include "knit/rows/contour_events.h"
#include "knit/tubes/plan.h"

namespace knit {

enum class ContourPhase : std::uint8_t { take, cut, loop, measure, count, begin, place, bridge, give };
struct ContourWork {
  ContourPhase phase = ContourPhase::take;
  std::int32_t taken =
      0;                 // tubes of the plan's order that were taken up; the last of them is the current one
  std::int32_t row = 0;  // of the current tube: the one in progress, from 0
  std::int32_t count = 0;  // of stitches, once chosen
  Shared<Ring> curve;      // begun where the round begins
  std::vector<Stitch> stitches;
  Shared<Deal> deal;                // in progress
  std::int32_t bridged = 0;         // of its bridge
  std::vector<std::uint8_t> dealt;  // per event of the plan, once there is one
  // Roughly, beside its own size.
  [[nodiscard]] std::size_t copy_bytes() const { return stitches.size() * sizeof(Stitch) + dealt.size(); }
  [[nodiscard]] auto fields() const {
    return std::tie(phase, taken, row, count, curve, stitches, deal, bridged, dealt);
  }
  friend bool operator==(const ContourWork&, const ContourWork&) = default;
};

// The last that was planned for the tube; null: none.
const TubeRhythm* rhythm_of(std::span<const Shared<TubeRhythm>> rhythms, TubeId tube);

// The tube that is worked now; -1 before the first.
TubeId current_tube(const TubePlan& plan, const ContourWork& work);
// Of the row in progress; requires a tube with rows.
const Ring& current_curve(const TubePlan& plan, const ContourWork& work);

// What a row or a deal is made on.
struct ContourAt {
  const Input& input;
  const Timing& timing;
  const TubeGraph& graph;
  const TubePlan& plan;
  const Fabric& fabric;
  std::span<const Shared<TubeRhythm>> rhythms = {};
  // How the row in progress will hang, where its rhythm says so: a cell of the larger row each, its stitch in the smaller.
  std::span<const std::int32_t> links = {};
  // Rounds begin where their curves do.
  bool begins_on_curve = false;
};
// A product, once it has ended.
struct ContourMade {
  std::optional<Row>& row;
  std::optional<Deal>& deal;
  std::optional<TubePlan>& plan;  // in place of the one before, when the stitch was changed on the way
  std::optional<TubeRhythm>& rhythm;
};
Advanced<ContourEvent> advance_contours(const RowsSettings& rows, const RhythmSettings& rhythm,
                                        const StitchSize& stitch, const ContourAt& at, ContourWork& work,
                                        ContourMade made, const Heard& heard = {});
// Whether the next step plans the counts of all rows to come; `heard` hears of it.
bool next_plans_rhythm(const RhythmSettings& rhythm, const StitchSize& stitch, const ContourAt& at,
                       const ContourWork& work);

}  // namespace knit
