// Twins: tubes so alike that they get the same rows (plan.h), as the limbs of a symmetric shape.
#pragma once

#include <span>
#include <vector>

#include "knit/tubes/graph.h"
#include "knit/tubes/simplify.h"

namespace knit {

// A height in a chain: in which part of it, and how high there.
struct ChainPlace {
  std::int32_t part = 0;  // tube of the graph
  double height = 0.0;
};
ChainPlace place_in(const TubeChain& chain, std::span<const TubeProfile> profiles, double height);

// Gives twins their rows, by their mean height. Of each chain: all that are alike, itself too, rising. Only chains with rows
// have twins, and who is alike with one twin is with all.
std::vector<std::vector<TubeId>> match_twins(SimpleGraph& graph, std::span<const TubeProfile> profiles,
                                             double stitch_height);

}  // namespace knit
