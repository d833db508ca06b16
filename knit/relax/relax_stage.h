// Stage relax, one iteration a step: the piece comes off the needles and finds its shape. docs/algorithm.md, Relaxing.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "knit/model/event.h"
#include "knit/relax/knitted.h"
#include "knit/relax/relax.h"
#include "knit/relax/relax_events.h"

namespace knit {

struct RelaxAt {
  const Fabric& fabric;  // with faces; stays as it is
  const StitchSize& stitch;
  glm::dvec3 along;  // the direction of knitting
};

// The first step plans, the last one measures and gives the piece.
Advanced<RelaxEvent> advance_relax(const RelaxAt& at, const RelaxSettings& settings, RelaxWork& work,
                                   std::optional<KnittedPiece>& piece, const Heard& heard = {});

// Whether the stuffing was more than the springs hold: it ended neither at rest nor with its last iteration. What lies there then
// has no size that is worth telling.
bool swelled_without_bound(std::int32_t iterations, bool came_to_rest, const RelaxSettings& settings);
inline constexpr std::string_view swelled_words =
    "Stuffed so, it swells without bound: no yarn would hold it. Choose less stuffing.";

// Whether a keyframe is to stand after the next step: iterations are replayed at some milliseconds each.
bool relaxing_sweeps(const RelaxWork& work);
// Whether the next step may factor.
bool next_factors(const RelaxWork& work);

}  // namespace knit
