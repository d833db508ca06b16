// The one table of settings: what each is called, takes and means, who reads it first, and how it is read and set.
//
// The command line, the panel, the report, sessions, lessons, sweeps and tuning all work from the table, so that the same
// words make the same run whichever door they come through.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/settings.h"
#include "knit/model/stage.h"

namespace knit {

// How a value is read and set. A stitch size is read in both views, whichever is given.
template <class T>
struct Access {
  T (*get)(const Parameters&);
  void (*set)(Parameters&, T);
};

inline constexpr double no_limit = 1e12;  // a Number as high as this has no upper bound
// What 0 is where `low` is 0. `follows` and `chosen` are both auto: it follows from the other settings, as the stitch's height
// does, and no other yet; or only the run can say.
enum class Zero : std::uint8_t { refused, allowed, follows, chosen };
struct NamedNumber {
  std::string_view name;
  double value;
};
struct Number : Access<double> {
  double low, high;  // both are allowed, but a `low` of 0 as `zero` says
  Zero zero = Zero::refused;
  std::span<const NamedNumber> names = {};  // read as numbers, and written where a number has one
};
struct Count : Access<int> {
  int low, high;
  bool zero_means_auto = false;
};
struct PickedVertex : Access<VertexId> {};
struct AxisChoice : Access<Axis> {};
struct DirectionChoice : Access<std::optional<glm::dvec3>> {};
struct GaugeChoice : Access<Gauge> {};
// A choice among named values; index 0 is the enum's 0.
struct Choice : Access<int> {
  std::span<const std::string_view> names;
};

enum class Tie : std::uint8_t {
  none,
  mesh_view,
  gauge_view,
  width
};  // what it goes with while it is not set itself

struct ParameterInfo {
  std::string_view key;    // "stitch-width": the option --stitch-width and the key in the report
  std::string_view label;  // "Stitch width"
  std::string_view unit;
  std::string_view help;   // one sentence
  std::string_view group;  // what belongs together for people: "Timing"
  Stage
      first_reader;  // of its value itself; first_stage_to_read: also of what follows. `done`: no stage reads it
  std::variant<Number, Count, PickedVertex, AxisChoice, DirectionChoice, GaugeChoice, Choice> kind;
  // What it depends on whether anything reads it; null: it always is.
  bool (*read_when)(const Parameters&) = nullptr;
  Tie tie = Tie::none;
  std::string_view fallback = {};  // the default in words, where it depends on the mesh
  // Why it cannot be changed on the way once its first reader has begun, {} being its value; empty: it can.
  std::string_view not_from_here = {};
};

// The settings that code must name.
namespace keys {
inline constexpr std::string_view start = "start";
inline constexpr std::string_view sizes = "sizes";
inline constexpr std::string_view stitch_width = "stitch-width";
inline constexpr std::string_view gauge = "gauge";
inline constexpr std::string_view rows = "rows";
inline constexpr std::string_view metric = "metric";
inline constexpr std::string_view epsilon = "epsilon";
inline constexpr std::string_view relax = "relax";
}  // namespace keys

std::span<const ParameterInfo> parameter_table();  // in the order of the pipeline
const ParameterInfo* find_parameter(std::string_view key);

// A value as text, as the command line takes it: "0.1", "y", "1,0,0", "auto" (not picked, or worked out), "22,32", "thesis".
std::string value_text(const ParameterInfo& info, const Parameters& parameters);
// Sets one value from text; an error is one sentence and leaves the parameters as they were.
std::optional<std::string> set_value(const ParameterInfo& info, Parameters& parameters,
                                     std::string_view text);
// Sets several; in whatever order they stand, `sizes` says last which view of the stitch size is given. An error is one
// sentence.
using Setting = std::pair<const ParameterInfo*, std::string>;
std::optional<std::string> set_values(std::span<const Setting> settings, Parameters& parameters);

// Two of them that give the stitch size in both views, with no `sizes` to say which counts.
struct ViewClash {
  const ParameterInfo* mesh;
  const ParameterInfo* gauge;
};
std::optional<ViewClash> clash_of_views(std::span<const Setting> settings);

std::string range_text(const ParameterInfo& info);
bool is_auto(const Number& number, const Parameters& parameters);
// What auto stands for included; none: only the run finds that.
std::optional<double> effective_value(const Number& number, const Parameters& parameters);
// In which view it gives the stitch size; none: it does not.
std::optional<SizesFrom> view_of(const ParameterInfo& info);
// Whether anything reads it with these parameters: epsilon is idle while rows come from contours.
bool is_read(const ParameterInfo& info, const Parameters& parameters);
// Whether it can be changed for what comes from `next` on.
bool can_change_at(const ParameterInfo& info, const Place& next);
// Why what differs cannot be changed any more at `next`; nothing when it can.
std::optional<std::string> why_not_from_here(const Parameters& before, const Parameters& after,
                                             const Place& next);

// What the parameters get wrong together or on this mesh (a picked vertex out of range), as one sentence.
std::optional<std::string> fault_of(const Parameters& parameters, const Input& input);

// Whether a difference came only from what else was set: the view that is not given, an epsilon that goes with the width.
bool only_follows(const ParameterInfo& info, const Parameters& from, const Parameters& to);
bool same_value(const ParameterInfo& info, const Parameters& a, const Parameters& b);
// Nothing before this stage depends on it: its first reader, or, with contours, the stage that looks for the order of tubes among
// the stitches that its rows will have.
Stage first_stage_to_read(const ParameterInfo& info, const Parameters& parameters);
// The first stage that reads any parameter in which the two differ; `done` when they are equal.
Stage first_reader_of_change(const Parameters& a, const Parameters& b);

// `changed` applied to `base`: every parameter in which `from` and `to` differ takes `to`'s value. What only follows is
// not carried over; it follows anew.
Parameters with_change(const Parameters& base, const Parameters& from, const Parameters& to);

// Shortest text that reads back as the same double.
std::string number_text(double value);

}  // namespace knit
