// Relaxing: the knitted thing comes off the needles, is stuffed, and takes the shape that its stitches make.
//
//   E = springs and bends [knit/relax/springs.h] - p V [volume.h] + sum over pairs that touch of k/2 max(0, w - |e|)^2
//   p = stuffing (course + wale stiffness) / R, R of the ball that has the fabric's area
// One iteration a call, accelerated gradient steps that one factorisation makes as long as the piece is large:
//   L = sum of 1.2 k over courses, wales, drawn ends and pairs that touch, as a graph's Laplacian, + 1e-6 I
//   y = x + b (x - previous);  x' = y - L^-1 gradient E(y)
//   t' = (1 + sqrt(1 + 4 t^2)) / 2, b = min((t - 1)/t', 0.9); where sum (y - x').(x' - x) > 0: b = 0, t' = 1, a restart
// Every 40 iterations, at first too, pairs are found anew: nearer than 1.8 w and more than 5 steps of fabric apart. Where they
// are others than before, L is factored anew; the momentum is kept.
// It ends when no stitch moved by 1/1000 w in each of 5 iterations, none of them within 10 of a restart or a new factor, or
// after as many as are allowed. Cost: once about n^1.5, then n log n an iteration; their number does not grow with n.
// The room is that of the walls: lids lie over inner rows. Neither genus nor links can change.
// A. Beck, M. Teboulle, "A fast iterative shrinkage-thresholding algorithm", 2009; B. O'Donoghue, E. Candès, "Adaptive restart
// for accelerated gradient schemes", 2015.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/model/heard.h"
#include "knit/model/relax_settings.h"
#include "knit/model/shared.h"
#include "knit/relax/contact.h"
#include "knit/relax/springs.h"
#include "knit/relax/volume.h"
#include "knit/settle/kept_memory.h"

namespace knit {

// What stays the same while stitches move.
struct RelaxPlan {
  SpringNet net;
  Enclosure walls;                   // without what lids lie over
  std::vector<RowId> lidded;         // inner rows
  std::vector<glm::dvec3> start;     // along the knitting path
  double width = 1.0, height = 1.0;  // of a stitch
  double radius = 1.0;               // R
  double pressure = 0.0;             // p; negative where faces run clockwise seen from outside
  [[nodiscard]] auto fields() const {
    return std::tie(net, walls, lidded, start, width, height, radius, pressure);
  }
  friend bool operator==(const RelaxPlan&, const RelaxPlan&) = default;
};

struct RelaxPlaces {
  std::vector<glm::dvec3> at, before;
  [[nodiscard]] auto fields() const { return std::tie(at, before); }
  friend bool operator==(const RelaxPlaces&, const RelaxPlaces&) = default;
};

struct RelaxMemory;  // L's factor, and what an iteration works with

struct RelaxWork {
  Shared<RelaxPlan> plan;
  Shared<RelaxPlaces> places;
  Shared<std::vector<StitchPair>> touching;
  double t = 1.0, momentum = 0.0;  // b
  std::int32_t iteration = 0;
  std::int32_t still = 0;         // iterations in a row in which next to nothing moved
  std::int32_t unsettled_at = 0;  // the last restart or new factor
  double last_move = 0.0;         // in w, the greatest of the last iteration
  bool done = false;
  KeptMemory<RelaxMemory> memory;
  [[nodiscard]] auto fields() const {
    return std::tie(plan, places, touching, t, momentum, iteration, still, unsettled_at, last_move, done);
  }
  [[nodiscard]] std::size_t copy_bytes() const {
    return places ? 2 * places->at.size() * sizeof(glm::dvec3) : 0;
  }
  friend bool operator==(const RelaxWork&, const RelaxWork&) = default;
};

// What one iteration did.
struct RelaxIteration {
  std::int32_t iteration = 0;
  double greatest_move = 0.0;  // in w
  double volume = 0.0;         // inside the walls
  std::int32_t touching = 0;   // pairs
  bool restarted = false;
  friend bool operator==(const RelaxIteration&, const RelaxIteration&) = default;
};

// Requires a fabric with faces. It begins where the stitches are; a start that crosses itself stays crossed.
void begin_relaxing(const Fabric& fabric, const StitchSize& stitch, const RelaxSettings& settings,
                    RelaxWork& work, const Heard& heard = {});

// Requires a plan, and that it is not done.
RelaxIteration advance_relaxing(const RelaxSettings& settings, RelaxWork& work, const Heard& heard = {});

// Whether an iteration looks for pairs, and may factor anew.
inline constexpr std::int32_t contact_every = 40;
inline bool finds_touching(std::int32_t iteration) { return (iteration - 1) % contact_every == 0; }

// Where all stitches come to lie, by number along the knitting path, turned and moved back as near to the start as can be.
struct Relaxed {
  std::vector<glm::dvec3> positions;
  std::int32_t iterations = 0;
  double last_move = 0.0;            // in w
  bool settled = false;              // else the iterations ran out
  std::vector<StitchPair> touching;  // pairs that push each other apart
  [[nodiscard]] auto fields() const { return std::tie(positions, iterations, last_move, settled, touching); }
  friend bool operator==(const Relaxed&, const Relaxed&) = default;
};

// Requires that it is done.
Relaxed finish_relaxing(const RelaxWork& work);

// All of it at once.
Relaxed relax(const Fabric& fabric, const StitchSize& stitch, const RelaxSettings& settings,
              const Heard& heard = {});

// `places` turned and moved, not stretched, so that the squares of the ways to `onto`, one by one, are least.
// B. Horn, "Closed-form solution of absolute orientation using unit quaternions", 1987.
std::vector<glm::dvec3> laid_onto(std::span<const glm::dvec3> places, std::span<const glm::dvec3> onto);

}  // namespace knit
