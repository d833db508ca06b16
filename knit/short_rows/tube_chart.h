// The chart of a tube: where each flow line of its own harmonic time is at each level, and how far up it is there.
//
//   t   harmonic, 0 on the low rim, 1 on the high one. On an annulus it has no critical point: one loop a level.
//   s   the angle, of period 1: least squares of grad s - J grad t / G, J the quarter turn about the normal, G the flux of
//       grad t through a level. Both by the exact cotangent Laplacian: with weights clipped at 0 the angle is lost.
// Columns are s = j / columns in working order, column 0 where rounds begin on the low rim. Levels lie evenly in mean height,
// weighted by arc, about h/8 apart, found by retiming four times. Between them everything is taken to run straight.
// A chart is only a chart: nothing that reads it takes its columns for evenly wide. Lengths are in mesh units.
// Cost: two sparse factorisations of the part's points, and a pass over its triangles a level.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "knit/model/heard.h"
#include "knit/model/ring.h"
#include "knit/short_rows/tube_part.h"

namespace knit {

struct TubeChart {
  std::int32_t columns = 0;
  std::vector<double> times;       // t of each level, rising from 0 to 1
  std::vector<glm::dvec3> points;  // X[l * columns + j]
  std::vector<double> heights;     // Y[l * columns + j]: length of column j from the low rim up to level l
  double mean_height = 0.0;        // of the high rim
  double residual = 0.0;  // of the angle: its share of squared slope that is not the quarter turn of t's
  std::optional<std::int32_t>
      mirror;  // column j lies opposite mirror - j (chart_mirror.h); none: no mirror image of itself
  [[nodiscard]] std::int32_t levels() const { return static_cast<std::int32_t>(times.size()); }
  [[nodiscard]] double last_level() const { return static_cast<double>(levels() - 1); }
  [[nodiscard]] auto fields() const {
    return std::tie(columns, times, points, heights, mean_height, residual, mirror);
  }
  friend bool operator==(const TubeChart&, const TubeChart&) = default;
};

inline constexpr std::int32_t chart_columns = 256;  // at least four times the most stitches of a round
inline constexpr double greatest_residual =
    0.1;  // of the angle; beyond it a chart says little of the surface

struct ChartRefusal {
  enum class Reason : std::uint8_t { residual, not_solved } reason = Reason::residual;
  double residual = 0.0;
  friend bool operator==(const ChartRefusal&, const ChartRefusal&) = default;
};
std::string sentence_of(const ChartRefusal& refusal);

std::variant<TubeChart, ChartRefusal> make_tube_chart(const TubePart& part, double stitch_height,
                                                      std::int32_t columns = chart_columns,
                                                      const Heard& heard = {});

// The place at a level in [0, last level] and a column; columns wrap.
glm::dvec3 point_at(const TubeChart& chart, double level, double column);

// Of each column, the length up to a level.
std::vector<double> heights_at(const TubeChart& chart, double level);

// A level as a round's curve in working order, beginning at a column: one point a column, the first at that column.
Ring ring_at(const TubeChart& chart, double level, double first_column);

// Which column a place on such a curve is in, by its arc: in [first_column, first_column + columns].
double column_of(const TubeChart& chart, const Ring& ring, double first_column, double arc);

}  // namespace knit
