// The report card: how good the knit mesh is, as figures. Pure functions of the run so far.
//
// Course edges run along a row, wale edges from row to row. Course lengths are counted in stitch widths w,
// wale lengths in stitch heights h, so 1 is right for both; sideways shifts in w; distances in mesh units,
// beside the bounding box's diagonal that they are judged by. What is not there yet (no strips while rows are
// built) has the count 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "knit/mesh/mesh.h"
#include "knit/quality/closeness.h"
#include "knit/quality/measures.h"
#include "knit/run/state.h"

namespace knit {

// Equal bins over [low, high]; what lies beyond is in the first or last one.
struct Histogram {
  double low = 0.0, high = 1.0;
  std::vector<std::size_t> bins;
};

struct Spread {
  std::size_t count = 0;
  double mean = 0.0, cv = 0.0;  // cv: standard deviation / mean
  double low = 0.0, high = 0.0;
  double p95 = 0.0;  // the value that 95 % do not exceed (nearest rank)
  Histogram histogram;
};
Spread spread_of(std::span<const double> values, double histogram_low, double histogram_high,
                 std::size_t bins);

// Where a figure is: an edge of the strip below a row, or of a deal by its bridge's row. Row 0: nowhere.
struct EdgeAt {
  RowId row = 0;
  std::int32_t edge = 0;
  [[nodiscard]] bool known() const { return row != 0; }
  friend bool operator==(const EdgeAt&, const EdgeAt&) = default;
};

struct RowFit {
  std::int32_t row = 1;
  std::int32_t stitches = 0;
  double length = 0.0;     // of the closed curve that the row was taken from
  double ideal = 0.0;      // length / w
  double course_cv = 0.0;  // of this row's course lengths
};

// Of one tube, whose rows follow each other.
struct TubeFit {
  TubeId tube = 0;
  std::int32_t first_row = 1, rounds = 0, stitches = 0;
  // Of the wales that end in its rows, in h; 0 while there are none.
  std::size_t wales = 0;
  double wale_cv = 0.0, longest_wale = 0.0;
  double worst_course_cv_in_row = 0.0;
  EdgeAt longest{};
  RowId uneven_row = 0;  // the one of the worst cv
};

struct MirrorError {
  double mean = 0.0, max = 0.0;  // in w
};

struct Quality {
  double stitch_width = 0.0, stitch_height = 0.0;  // what was asked, mesh units
  Spread course;                                   // length / w, all rows
  Spread long_course;                              // the same, rows of 12 stitches or more
  double worst_course_cv_in_row = 0.0;
  Spread wale;        // length / h
  Spread corner;      // inner angles of all faces, degrees
  Spread corner_off;  // how far those of quads are from a right angle, degrees
  std::vector<RowFit> rows;
  std::vector<TubeFit> tubes;  // in working order; one where nothing branches
  FaceCounts faces;
  double quad_share = 0.0;     // of all faces
  double regular_share = 0.0;  // of the stitches between first and last row: one link down and one up
  ShapingFigures shaping;
  std::int32_t steady_shaping = 0;  // ceil(2 pi h / w): what a flat disc takes in a row
  // A wale edge's part along its rows, in w: the largest; and over edges whose two rows have at least 12.
  double offset = 0.0, long_offset = 0.0;
  // How far wale edges move under reflection in the plane of the axis and the direction in which rounds
  // begin, measured to the nearest wale edge of their strip.
  std::optional<MirrorError> mirror;
  // Where the largest of these are; of equals the first in knitting order.
  EdgeAt longest_course{};  // from this stitch of the row to the next
  EdgeAt longest_wale{}, leans_most{};
  RowId uneven_row = 0, most_shaped_row = 0;
};

// Cheap enough to be live: no look at the mesh that came in. Requires stitches of a size above 0.
Quality measure_quality(const Input& input, const State& state, double stitch_width, double stitch_height);

// Inner angles of a face, degrees; a triangle's fourth is 0. `path`: knitting_path of its fabric.
std::array<double, 4> corner_angles(const Face& face, std::span<const glm::dvec3> path);

}  // namespace knit
