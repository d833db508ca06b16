// What lies between a start and an end on a surface: the mesh is cut along all cycles, its pieces are told apart, and the
// piece that has both on its border is handed on, with its rims. Nothing is found by homology: edges, Euler's number
// and which piece lies beside which decide. On a piece with two rims and Euler's number 0 the rows never part.
//
// Several starts and ends may be given; each rim of the piece keeps its time. Mesh units.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "knit/curves/cycle.h"
#include "knit/mesh/mesh.h"

namespace knit {

struct BetweenSettings {
  double stitch_width = 0.0;  // a circle without a radius has 6 of them around
  glm::dvec3 up{0.0, 1.0, 0.0};
};

// A border of the piece that is knitted.
struct CutRim {
  CycleEnd as = CycleEnd::start;
  std::string name;                // as in called()
  double time = 0.0;               // 0 at a start, 1 at an end, or as given
  std::vector<VertexId> vertices;  // of the piece, as its triangles run along them
};

struct CutCap {
  double share = 0.0;               // of the whole surface
  std::vector<std::string> beyond;  // names of the cycles on its border
};

struct Between {
  Mesh mesh;  // the piece that is knitted, with vertices of its own
  std::vector<VertexId>
      before;  // per vertex of it, which one of the mesh given it was; no_vertex if the cut made it
  std::vector<CutRim> rims;  // in the order of the cycles
  std::vector<CutCap> caps;
  std::vector<std::string> notes;  // what was chosen for the person, and what is left out: a sentence each
};

// The error is one sentence: the first of the checks that fails. Cycles that are not given are chosen: the lowest edge
// of the mesh as a start, its other edge as an end; where there is none, the point farthest from the other cycle.
std::variant<Between, std::string> between_cycles(const Mesh& mesh, std::span<const Cycle> cycles,
                                                  const BetweenSettings& settings);

// The piece as the stages take it: its rims have their parts in it (Input::rims).
std::shared_ptr<const Input> input_of(const Between& piece);

}  // namespace knit
