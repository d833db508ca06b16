// Why a critical vertex is what it is: what begins, ends, parts, meets or is left out there, with rows from contours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "knit/run/timeline.h"

namespace knit {

// Several critical vertices of the graph of tubes may stand at one vertex of the mesh. Steps are indices of a timeline's.
struct CriticalStory {
  std::vector<std::size_t> found;    // the steps that found it critical, rising
  std::vector<std::int32_t> events;  // of the plan of tubes, rising
  std::vector<std::int32_t> deals;   // from 1: those of its events, as far as they are dealt, rising
  std::vector<std::size_t> dealt;    // their steps: gaps that are found, loops that are dealt, rising
  std::vector<std::int32_t>
      left_out;  // of the plan: limbs and holes that have an end here, in the order of leaving out
  std::vector<std::size_t> leaving_out;  // the steps that told of them, rising
  // The step that decided what happens here: the first that deals, else that leaves out, else that found it.
  [[nodiscard]] std::optional<std::size_t> decided() const;
};
// None where no level curve begins, parts, meets or ends, or it is not known yet. Cost: the steps of the stage tubes and of
// the deals.
std::optional<CriticalStory> critical_story(const Timeline& timeline, VertexId vertex);

// Whether the tubes that a join takes hang together already, so that it closes a handle.
bool closes_handle(const TubePlan& plan, std::int32_t event);

}  // namespace knit
