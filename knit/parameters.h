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

#include "knit/mesh.h"
#include "knit/stage.h"

namespace knit {

enum class AxisKind : std::uint8_t { x, y, z, custom };
struct Axis {
  AxisKind kind = AxisKind::y;
  glm::dvec3 custom{0.0, 1.0, 0.0};            // read only when kind is custom; any length but zero
  [[nodiscard]] glm::dvec3 direction() const;  // unit length
  friend bool operator==(const Axis&, const Axis&) = default;
};

enum class Closing : std::uint8_t { none, thesis, arc };     // how the closing gap is shared out
enum class LastAnchor : std::uint8_t { keep, drop };         // drop: when nearer than w/2 to the first stitch
enum class OnStall : std::uint8_t { continue_, stop };       // when no vertex lies in the band
enum class Resample : std::uint8_t { on, off };              // when a row more than doubles or halves
enum class PlacementPolicy : std::uint8_t { thesis, even };  // where mains and shaping go
enum class Weld : std::uint8_t { off, on };                  // merge coincident vertices on import

struct Parameters {
  Axis axis;
  VertexId start = no_vertex;  // picked by hand; no_vertex: the extreme vertex along the axis
  VertexId end = no_vertex;
  double level_tolerance = 1e-5;  // vertices whose times differ by less are of one level
  int cast_on = 6;
  double stitch_width = 0.1;
  double epsilon = 0.05;
  OnStall on_stall = OnStall::continue_;
  LastAnchor last_anchor = LastAnchor::keep;
  Resample resample = Resample::on;
  Closing close = Closing::arc;
  PlacementPolicy placement = PlacementPolicy::thesis;
  Weld weld = Weld::off;
  friend bool operator==(const Parameters&, const Parameters&) = default;
};

// Stitch width 3 % of the bounding box's diagonal and half of it as epsilon.
Parameters default_parameters(const Bounds& bounds);

struct Number {
  double Parameters::*field;
  double low, high;  // low is exclusive when it is 0
};
struct Count {
  int Parameters::*field;
  int low, high;
};
struct PickedVertex {
  VertexId Parameters::*field;
};
struct AxisChoice {};
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
  std::string_view help;  // one sentence
  Stage first_reader;     // nothing before this stage depends on it
  std::variant<Number, Count, PickedVertex, AxisChoice, Choice> kind;
};

std::span<const ParameterInfo> parameter_table();  // in the order of the pipeline
const ParameterInfo* find_parameter(std::string_view key);

// A value as text, as the command line takes it: "0.1", "y", "1,0,0", "auto" (a vertex not picked), "thesis".
std::string value_text(const ParameterInfo& info, const Parameters& parameters);
// Sets one value from text; an error is one sentence and leaves the parameters as they were.
std::optional<std::string> set_value(const ParameterInfo& info, Parameters& parameters,
                                     std::string_view text);
std::string range_text(const ParameterInfo& info);

// What the parameters get wrong together or on this mesh (a picked vertex out of range), as one sentence.
std::optional<std::string> fault_of(const Parameters& parameters, const Mesh& mesh);

// The first stage that reads any parameter in which the two differ; `done` when they are equal.
Stage first_reader_of_change(const Parameters& a, const Parameters& b);

// `changed` applied to `base`: every parameter in which `from` and `to` differ takes `to`'s value.
Parameters with_change(const Parameters& base, const Parameters& from, const Parameters& to);

// Shortest text that reads back as the same double.
std::string number_text(double value);

}  // namespace knit
