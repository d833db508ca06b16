// What holds the knitted thing together in the air: springs along courses, wales and diagonals, and what resists bending.
//
//   E = sum over springs of k/2 (|e| - rest)^2 + sum over bends of bending/2 |a - 2 m + b|^2        [knit/relax/relax.h]
//
//   course      sides of faces that are no wale: rows, bridges      rest w                  k = h/w, half of it at an opening
//   drawn end   of an opening of at most 12 stitches                rest 0.35 w             k = 2 h/w
//   wale        rest h; sqrt(h^2 + w^2/4) beside shaping, where it leans                    k = 2 w/h
//   shear       both diagonals of a quad between rows               rest sqrt(w^2 + h^2)    k = 0.1 w h/(w^2 + h^2)
//   bend        three in a row of at least 5, and three up a wale   rest straight
// A wale that leans needs its own rest: with h each increase makes its row lower, and a ball of 12 cm comes out at 11.4
// instead of 12.3. Wool is not stiffer the longer it is, so w and h are the asked ones, never measured. Mesh units.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/fabric/fabric.h"
#include "knit/model/settings.h"

namespace knit {

inline constexpr double course_stiffness = 1.0, wale_stiffness = 2.0, shear_stiffness = 0.1,
                        bend_stiffness = 0.02;
inline constexpr std::size_t drawn_end = 12;  // stitches, at most
inline constexpr double drawn_to = 0.35;      // of their width

enum class SpringKind : std::uint8_t { course, wale, shear, drawn };
struct Spring {
  std::uint32_t a = 0, b = 0;  // along the knitting path; of a wale, a is the lower one
  double rest = 1.0, stiffness = 1.0;
  SpringKind kind = SpringKind::course;
  [[nodiscard]] auto fields() const { return std::tie(a, b, rest, stiffness, kind); }
  friend bool operator==(const Spring&, const Spring&) = default;
};

struct SpringNet {
  std::uint32_t stitches = 0;
  std::vector<Spring> springs;                      // courses, wales, diagonals
  std::vector<std::array<std::uint32_t, 3>> bends;  // the middle one second
  [[nodiscard]] auto fields() const { return std::tie(stitches, springs, bends); }
  friend bool operator==(const SpringNet&, const SpringNet&) = default;
};

// Requires a fabric with faces.
SpringNet make_spring_net(const Fabric& fabric, const StitchSize& stitch);

// What springs and bends pull each stitch by is added to `force`.
void add_pull(const SpringNet& net, std::span<const glm::dvec3> at, std::span<glm::dvec3> force);

// Who is joined to whom by courses and wales, and how many steps of that kind lie between two stitches.
class Joined {
 public:
  Joined() = default;
  explicit Joined(const SpringNet& net);
  // All within so many steps of one, itself too, rising. Cost: as many.
  void within(std::uint32_t stitch, int steps, std::vector<std::uint32_t>& found);

 private:
  std::vector<std::uint32_t> first_, beside_, met_;
  std::uint32_t searches_ = 0;
};

}  // namespace knit
