// Every knob of the pipeline, and the one table that says unit, range, meaning and first reader of each.
//
// The command line, the panel, the report and tuning all work from the table. Lengths are in mesh units.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/placement_policy.h"
#include "knit/model/stage.h"

namespace knit {

enum class AxisKind : std::uint8_t { x, y, z, custom };
struct Axis {
  AxisKind kind = AxisKind::y;
  glm::dvec3 custom{0.0, 1.0, 0.0};            // read only when kind is custom; any length but zero
  [[nodiscard]] glm::dvec3 direction() const;  // unit length
  friend bool operator==(const Axis&, const Axis&) = default;
};

enum class TimingKind : std::uint8_t { linear, arc_length, geodesic, harmonic };
enum class RowSource : std::uint8_t { rings, contours };  // the mesh's own vertices, or cuts through edges
enum class Metric : std::uint8_t { euclidean, arc, geodesic };  // the ruler of Algorithm 2
enum class SizesFrom : std::uint8_t { mesh, gauge };      // which view of the stitch size is the given one
enum class Closing : std::uint8_t { none, thesis, arc };  // how the closing gap is shared out
enum class LastAnchor : std::uint8_t { keep, drop };      // drop: when nearer than w/2 to the first stitch
enum class OnStall : std::uint8_t { continue_, stop };    // when no vertex lies in the band
enum class Resample : std::uint8_t { on, off };           // when a row more than doubles or halves
enum class FollowMains : std::uint8_t { off, on };        // nearest: shaping stands beside mains
enum class Weld : std::uint8_t { off, on };               // merge coincident vertices on import

// A knitter's swatch: stitches and rounds in 10 cm.
struct Gauge {
  double stitches = 22.0;
  double rounds = 32.0;
  friend bool operator==(const Gauge&, const Gauge&) = default;
};

struct Parameters {
  Axis axis;
  VertexId start = no_vertex;  // picked by hand; no_vertex: the extreme vertex along the axis
  VertexId end = no_vertex;
  TimingKind timing = TimingKind::linear;
  double level_tolerance = 1e-5;  // vertices whose times differ by less are of one level
  // Stitch sizes twice: in mesh units, and as a gauge with a finished height. `sizes` says which is given;
  // agreed() (gauge.h) keeps the other equal to it. The stages read mesh units only.
  SizesFrom sizes = SizesFrom::mesh;
  double stitch_width = 0.1;
  double stitch_height = 0.0;  // 0: 0.72 of the width, see stitch_height_of
  Gauge gauge;
  double height_cm = 12.0;  // of the finished object, along the axis
  RowSource rows = RowSource::rings;
  std::optional<glm::dvec3> start_direction;  // where rounds begin, any length but zero; none: -z, or -x
  int cast_on = 0;                            // 0: 6 for rings, as the length says for contours
  Metric metric = Metric::euclidean;
  double epsilon = 0.05;
  OnStall on_stall = OnStall::continue_;
  LastAnchor last_anchor = LastAnchor::keep;
  Resample resample = Resample::on;
  Closing close = Closing::arc;
  PlacementPolicy placement = PlacementPolicy::thesis;
  double stacking_penalty = 0.0;  // nearest: in squared stitch widths, for shaping above shaping
  FollowMains follow_mains = FollowMains::off;
  Weld weld = Weld::off;
  friend bool operator==(const Parameters&, const Parameters&) = default;
};

// In mesh units, what `auto` stands for included.
double stitch_height_of(const Parameters& parameters);

// Stitch width 3 % of the bounding box's diagonal and half of it as epsilon.
Parameters default_parameters(const Bounds& bounds);

inline constexpr double no_limit = 1e12;  // a Number as high as this has no upper bound
enum class Zero : std::uint8_t { refused, allowed, means_auto };
struct Number {
  double Parameters::*field;
  double low, high;  // a low of 0 is exclusive, but see zero
  Zero zero = Zero::refused;
};
struct Count {
  int Parameters::*field;
  int low, high;
  bool zero_means_auto = false;
};
struct PickedVertex {
  VertexId Parameters::*field;
};
struct AxisChoice {};
struct DirectionChoice {
  std::optional<glm::dvec3> Parameters::*field;
};
struct GaugeChoice {
  Gauge Parameters::*field;
};
// A choice among named values; index 0 is the enum's 0.
struct Choice {
  int (*get)(const Parameters&);
  void (*set)(Parameters&, int);
  std::span<const std::string_view> names;
};

struct ParameterInfo {
  std::string_view key;    // "stitch-width": the option --stitch-width and the key in the report
  std::string_view label;  // "Stitch width"
  std::string_view unit;
  std::string_view help;   // one sentence
  std::string_view group;  // what belongs together for people: "Timing"
  Stage first_reader;      // nothing before this stage depends on it; `done`: no stage reads it
  std::variant<Number, Count, PickedVertex, AxisChoice, DirectionChoice, GaugeChoice, Choice> kind;
};

std::span<const ParameterInfo> parameter_table();  // in the order of the pipeline
const ParameterInfo* find_parameter(std::string_view key);

// A value as text, as the command line takes it: "0.1", "y", "1,0,0", "auto" (not picked, or worked out), "22,32", "thesis".
std::string value_text(const ParameterInfo& info, const Parameters& parameters);
// Sets one value from text; an error is one sentence and leaves the parameters as they were.
std::optional<std::string> set_value(const ParameterInfo& info, Parameters& parameters,
                                     std::string_view text);
std::string range_text(const ParameterInfo& info);
// Whether anything reads it with these parameters: epsilon is idle while rows come from contours.
bool is_read(const ParameterInfo& info, const Parameters& parameters);

// What the parameters get wrong together or on this mesh (a picked vertex out of range), as one sentence.
std::optional<std::string> fault_of(const Parameters& parameters, const Mesh& mesh);

// The first stage that reads any parameter in which the two differ; `done` when they are equal.
Stage first_reader_of_change(const Parameters& a, const Parameters& b);

// `changed` applied to `base`: every parameter in which `from` and `to` differ takes `to`'s value.
Parameters with_change(const Parameters& base, const Parameters& from, const Parameters& to);

// Shortest text that reads back as the same double.
std::string number_text(double value);

}  // namespace knit
