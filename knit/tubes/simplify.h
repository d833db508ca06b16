// The graph of tubes without what is smaller than a row (plan.h has the rules): on numbers alone, without the surface.
//
// A limb that is pruned, or a handle that is left out, makes the nodes at its ends regular: the two tubes left there become
// one chain. Heights add up, of girths the greatest counts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/tubes/plan.h"

namespace knit {

// What is asked of a tube of the graph.
struct TubeSize {
  double height = 0.0;
  double longest = 0.0;  // of its curves
};

// Tubes of the graph that follow each other.
struct TubeChain {
  std::vector<std::int32_t> parts;   // from below; the first is the lowest number
  std::int32_t bottom = 0, top = 0;  // nodes
  double height = 0.0;
  double longest = 0.0;
  std::int32_t rows = 0;
  bool forced = false;
};

struct SimpleGraph {
  std::vector<TubeChain> chains;  // in the order in which they begin
  // Of the graph; `below` and `above` are chains, rising, and both empty where it is regular now.
  std::vector<GraphNode> nodes;
  // Limbs without height and girth are not told: rounding made them.
  std::vector<LeftOut> left_out;  // in order; `from` and `to` are vertices of the Morse surface
  [[nodiscard]] const TubeChain& chain(TubeId id) const { return chains[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const GraphNode& node(std::int32_t id) const { return nodes[static_cast<std::size_t>(id)]; }
  [[nodiscard]] bool is_kept(std::int32_t id) const;
  // Of a node that is kept, once rows are given: with a rowless leaf a split or a join is a ring.
  [[nodiscard]] EventKind kind_of(std::int32_t id) const;
};

SimpleGraph simplify_tubes(std::span<const GraphNode> nodes, std::span<const GraphTube> tubes,
                           std::span<const TubeSize> sizes, const TubeSettingsNow& settings);

// How far, in rows, the first and the last row stand from the ends of a tube; rings are not looked at.
struct RowOffsets {
  double low = 0.0, high = 0.0;
  // What a tube is higher by, in rows, than its number of rows.
  [[nodiscard]] double more() const { return low + high - 1.0; }
};
RowOffsets row_offsets(const GraphNode& bottom, const GraphNode& top);

// In a tube so high.
std::int32_t rows_that_fit(double height, const RowOffsets& offsets, double stitch_height);

}  // namespace knit
