// Settling: the stitches that were placed are moved on the surface until wales are h and courses w long, as well as can be.
//
// Levenberg-Marquardt, one accepted iteration a call:
//   x = -(A + shift / w^2)^-1 b in the tangent planes; each stitch's own step is shortened to at most 1 w, and goes to the
//   nearest place of the surface that it can walk to; taken if the sum has fallen there
//   else those around whom the terms have grown most are held back: they go half the way, a quarter, ... at most 8 times,
//   and those beside them at most twice as far. So a few stitches at a sharp edge, where the surface is not what the
//   planes promise, hold up nobody but themselves
//   else the shift grows: 16, 64, 256 fold, at most 4 tries; after a first try that was taken whole it falls to a third
// It ends when three iterations in a row gained less than 1/5000 each, when a try failed that promised no more than that or
// no shift helped, or after as many as are allowed. Only positions change; rows, links and words stay as they are.
// Cost of a try: a sparse factorisation of 2 unknowns a stitch, a walk a stitch and a pass over all terms; of holding back,
// three passes and the walks of those who are held.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <tuple>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"
#include "knit/model/shared.h"
#include "knit/settle/blocks.h"
#include "knit/settle/energy.h"
#include "knit/settle/kept_memory.h"
#include "knit/settle/surface.h"

namespace knit {

// Where all stitches are, by number along the knitting path.
struct Settled {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> triangles;  // of the mesh, that they are on
  [[nodiscard]] auto fields() const { return std::tie(positions, triangles); }
  friend bool operator==(const Settled&, const Settled&) = default;
};

// What stays the same while stitches move.
struct SettlePlan {
  SettleTerms terms;
  BlockPattern pattern;
  VertexNormals normals;  // of the mesh
  Settled start;
  [[nodiscard]] auto fields() const { return std::tie(terms, pattern, normals, start); }
  friend bool operator==(const SettlePlan&, const SettlePlan&) = default;
};

struct SettleMemory;  // what an iteration works with, kept for the next one

struct SettleWork {
  Shared<SettlePlan> plan;
  Shared<Settled> at;  // the last that was taken
  std::int32_t iteration = 0;
  std::int32_t idle = 0;  // iterations in a row that gained next to nothing
  double shift = 0.01;
  double sum = 0.0;
  bool done = false;
  KeptMemory<SettleMemory> memory;  // goes with the plan
  [[nodiscard]] auto fields() const { return std::tie(plan, at, iteration, idle, shift, sum, done); }
  friend bool operator==(const SettleWork&, const SettleWork&) = default;
};

// What one iteration did. Moves are in w, of this iteration. Nothing was moved where `taken` is false: no shift helped.
struct SettleIteration {
  std::int32_t iteration = 0;
  std::int32_t tries = 0;
  double before = 0.0, after = 0.0;  // the sum
  double shift = 0.0;                // that was used
  double mean_move = 0.0, greatest_move = 0.0;
  bool taken = false;
  friend bool operator==(const SettleIteration&, const SettleIteration&) = default;
};

// The first step: puts the stitches onto the surface, and works out the plan. Requires a fabric with faces.
void begin_settling(const Input& input, const Fabric& fabric, const StitchSize& stitch,
                    const SettleSettings& settings, SettleWork& work, const Heard& heard = {});

// Requires a plan, and that it is not done.
SettleIteration advance_settling(const Input& input, const SettleSettings& settings, SettleWork& work,
                                 const Heard& heard = {});

}  // namespace knit
