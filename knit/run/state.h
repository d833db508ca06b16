// All that a run knows between two steps: a regular value — copyable, comparable, hashable.
//
// Finished products are shared and immutable, so a copy costs what is in progress and a few pointers a row.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/model/products.h"
#include "knit/model/stage.h"
#include "knit/relax/knitted.h"
#include "knit/relax/relax.h"
#include "knit/rhythm/tube_rhythm.h"
#include "knit/rows/cast_on_stage.h"
#include "knit/rows/contour_stage.h"
#include "knit/rows/ring_stage.h"
#include "knit/settle/settle.h"
#include "knit/short_rows/kept_choice.h"
#include "knit/short_rows/short_rows_stage.h"
#include "knit/stitches/faces_stage.h"
#include "knit/stitches/index_stage.h"
#include "knit/stitches/pattern_stage.h"
#include "knit/timing/timing_stage.h"
#include "knit/tubes/tubes_stage.h"

namespace knit {

// What places the stitches where pairs of short rows were: they turn beside the shaping that it gives.
struct PlacedBy {
  StitchSettings stitches;
  double stitch_width = 0.0;
  RoundStart round_start = RoundStart::follow;
  bool for_good = false;  // a pair is worked: an edit comes too late
  [[nodiscard]] auto fields() const {
    return std::tie(stitches.placement, stitches.stacking_penalty, stitches.follow_mains, stitch_width,
                    round_start, for_good);
  }
  friend bool operator==(const PlacedBy&, const PlacedBy&) = default;
};

// Short rows, while rows are made: the tube that is planned, those that are, and the gap that is filled.
struct ShortRowsMade {
  ChosenFor chosen_for;  // what the tries and the choice are of
  std::vector<KeptTry> tries;
  std::optional<std::int32_t> kept;  // beside events, where a run chose; no_short_rows: none
  std::vector<Shared<PlannedPairs>>
      ahead;  // the plans of all ways, while they are tried; then of the chosen one
  std::optional<PlannedPairs> planning;
  std::vector<Shared<PlannedPairs>> tubes;
  GapWork gap;
  std::vector<Shared<Join>> foreseen;  // into the first rows, as they will be joined
  std::optional<PlacedBy> foreseen_by;
  [[nodiscard]] auto fields() const {
    return std::tie(chosen_for, tries, kept, ahead, planning, tubes, gap, foreseen, foreseen_by);
  }
  friend bool operator==(const ShortRowsMade&, const ShortRowsMade&) = default;
};

struct Finished {
  [[nodiscard]] auto fields() const { return std::tuple<>(); }
  friend bool operator==(const Finished&, const Finished&) = default;
};

using Work = std::variant<TimingWork, TubesWork, CastOnWork, RowWork, ContourWork, IndexWork, FacesWork,
                          SettleWork, RelaxWork, PatternWork, Finished>;

struct State {
  Place next{Stage::timing, 0, 0};  // the place of the step to come
  Shared<Timing> timing;
  RowSource rows_from = RowSource::by_itself;  // until the rows are made from something
  Shared<TubeGraph> graph;                     // with contours: of the time, or of the smoothed one
  Shared<TubePlan> tubes;                      // with contours: what is knitted
  std::vector<Shared<TubeRhythm>> rhythms;     // with contours and counts in rhythm, as they were planned
  ShortRowsMade short_rows;
  std::int32_t last_level = -1;  // the last level that makes a row, once cast on
  Fabric fabric;
  // Where stitches were placed, along the path, once they settle; the fabric has them where they settled to.
  Shared<std::vector<glm::dvec3>> placed;
  // What comes off the needles, once it has come to rest in the air; the fabric stays on the mesh.
  Shared<KnittedPiece> relaxed;
  std::vector<Shared<CountedLine>> lines;
  Work work;

  [[nodiscard]] Stage stage() const { return next.stage; }
  [[nodiscard]] bool finished() const { return std::holds_alternative<Finished>(work); }
  [[nodiscard]] auto fields() const {
    return std::tie(next.stage, next.row, next.item, timing, rows_from, graph, tubes, rhythms, short_rows,
                    last_level, fabric, relaxed, lines, work);
  }
  friend bool operator==(const State&, const State&) = default;
};

inline std::uint64_t hash_of(const State& state) { return content_hash_of(state); }

// The fabric as its stitches were placed, whether they have settled or not.
Fabric placed_fabric(const State& state);

// Where its stitches lie in the air, along the path, as far as they have come; null before the stage relax.
std::shared_ptr<const std::vector<glm::dvec3>> relaxed_places(const State& state);

// Finished or in progress; null until it is planned.
const Join* planned_join(const State& state, RowId into);
const Strip* planned_strip(const State& state, RowId into);

// What a copy costs, roughly: what is in progress and the pointers, not what is shared.
std::size_t copy_bytes(const State& state);

}  // namespace knit
