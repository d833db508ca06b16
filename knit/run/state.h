// All that a run knows between two steps: a regular value — copyable, comparable, hashable.
//
// Finished products are shared and immutable, so a copy costs what is in progress and a few pointers a row.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/model/growing.h"
#include "knit/model/parameters.h"
#include "knit/model/products.h"
#include "knit/model/stage.h"
#include "knit/rows/rows.h"
#include "knit/timing/fields.h"

namespace knit {

struct TimingWork {
  std::optional<Ends> ends;
  TimingKind kind = TimingKind::linear;  // once the ends are found
  // Of the timings that are solved for on the surface, each once it is there.
  Shared<IntrinsicMesh> net;
  Shared<std::vector<double>> heat;
  Shared<EdgeSlopes> slopes;
  Shared<std::vector<double>> field;  // what the times are read from, in [0, 1] at the referenced vertices
  Shared<HeightScale> scale;
  Growing<double> times;
  std::int32_t outside = 0;
  Shared<Criticals> criticals;
  [[nodiscard]] auto fields() const {
    return std::tie(ends, kind, net, heat, slopes, field, scale, times, outside, criticals);
  }
  friend bool operator==(const TimingWork&, const TimingWork&) = default;
};

struct CastOnWork {
  std::int32_t level = -1;
  Shared<Ring> ring;
  std::vector<Stitch> stitches;
  [[nodiscard]] auto fields() const { return std::tie(level, ring, stitches); }
  friend bool operator==(const CastOnWork&, const CastOnWork&) = default;
};

enum class RowPhase : std::uint8_t { gather, order, measure, missed, resample, share };
struct RowWork {
  RowPhase phase = RowPhase::gather;
  std::int32_t level = 0;
  Shared<Ring> ring;
  Walk walk;
  ClosedRow closed;
  [[nodiscard]] auto fields() const { return std::tie(phase, level, ring, walk, closed); }
  friend bool operator==(const RowWork&, const RowWork&) = default;
};

inline RowWork row_work_at(std::int32_t level) {
  RowWork work;
  work.level = level;
  return work;
}

// A row from a cut through the surface; row 1 belongs to the stage cast on, the others to rows.
enum class ContourPhase : std::uint8_t { plan, cut, loop, measure, count, place };
struct ContourWork {
  ContourPhase phase = ContourPhase::plan;
  Shared<CutPlan> plan;
  std::int32_t cut = 0;    // of plan->cuts: the one at hand
  std::int32_t count = 0;  // of stitches, once chosen
  std::vector<Stitch> stitches;
  [[nodiscard]] auto fields() const { return std::tie(phase, plan, cut, count, stitches); }
  friend bool operator==(const ContourWork&, const ContourWork&) = default;
};

enum class IndexPhase : std::uint8_t { count, space, place };
struct IndexWork {
  IndexPhase phase = IndexPhase::count;
  Shared<Join> plan;        // from `place` on
  std::int32_t placed = 0;  // of plan->placed
  [[nodiscard]] auto fields() const { return std::tie(phase, plan, placed); }
  friend bool operator==(const IndexWork&, const IndexWork&) = default;
};

struct FacesWork {
  Shared<Strip> plan;
  std::int32_t made = 0;  // of plan->faces
  [[nodiscard]] auto fields() const { return std::tie(plan, made); }
  friend bool operator==(const FacesWork&, const FacesWork&) = default;
};

struct PatternWork {
  [[nodiscard]] auto fields() const { return std::tuple<>(); }
  friend bool operator==(const PatternWork&, const PatternWork&) = default;
};

struct Finished {
  [[nodiscard]] auto fields() const { return std::tuple<>(); }
  friend bool operator==(const Finished&, const Finished&) = default;
};

using Work =
    std::variant<TimingWork, CastOnWork, RowWork, ContourWork, IndexWork, FacesWork, PatternWork, Finished>;

struct State {
  Place next{Stage::timing, 0, 0};  // the place of the step to come
  Shared<Timing> timing;
  std::int32_t last_level = -1;  // the last level that makes a row, once cast on
  Fabric fabric;
  std::vector<Shared<PatternLine>> lines;
  Work work;

  [[nodiscard]] Stage stage() const { return next.stage; }
  [[nodiscard]] bool finished() const { return std::holds_alternative<Finished>(work); }
  [[nodiscard]] auto fields() const {
    return std::tie(next.stage, next.row, next.item, timing, last_level, fabric, lines, work);
  }
  friend bool operator==(const State&, const State&) = default;
};

inline std::uint64_t hash_of(const State& state) { return content_hash_of(state); }

// Finished or in progress; null until it is planned.
const Join* planned_join(const State& state, RowId into);
const Strip* planned_strip(const State& state, RowId into);

// What a copy costs, roughly: what is in progress and the pointers, not what is shared.
std::size_t copy_bytes(const State& state);

}  // namespace knit
