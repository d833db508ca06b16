#include "knit/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

namespace knit {

namespace {

template <auto Field, class Enum>
constexpr Choice choice(std::span<const std::string_view> names) {
  return {[](const Parameters& p) { return static_cast<int>(p.*Field); },
          [](Parameters& p, int value) { p.*Field = static_cast<Enum>(value); }, names};
}

constexpr std::array<std::string_view, 2> stall_names{"continue", "stop"};
constexpr std::array<std::string_view, 2> anchor_names{"keep", "drop"};
constexpr std::array<std::string_view, 2> switch_names{"on", "off"};
constexpr std::array<std::string_view, 3> closing_names{"none", "thesis", "arc"};
constexpr std::array<std::string_view, 2> placement_names{"thesis", "even"};
constexpr std::array<std::string_view, 2> weld_names{"off", "on"};

const std::array table{
    ParameterInfo{"weld", "Weld", "", "Merge vertices at exactly the same place when the mesh is opened.",
                  Stage::import, choice<&Parameters::weld, Weld>(weld_names)},
    ParameterInfo{"axis", "Axis", "",
                  "The direction of knitting: x, y, z or a direction X,Y,Z. The time rises along it.",
                  Stage::timing, AxisChoice{}},
    ParameterInfo{
        "start", "Start vertex", "vertex",
        "Where the time is 0: a vertex of the mesh, counted from 0, or auto for the lowest along the axis.",
        Stage::timing, PickedVertex{&Parameters::start}},
    ParameterInfo{
        "end", "End vertex", "vertex",
        "Where the time is 1: a vertex of the mesh, counted from 0, or auto for the highest along the axis.",
        Stage::timing, PickedVertex{&Parameters::end}},
    ParameterInfo{
        "level-tolerance", "Level tolerance", "of the time, 0 to 1",
        "Vertices whose times lie closer together than this belong to one level, one cycle to pick from.",
        Stage::timing, Number{&Parameters::level_tolerance, 0.0, 0.1}},
    ParameterInfo{"cast-on", "Cast on", "stitches",
                  "Stitches of the first row, spread evenly along the first cycle.", Stage::cast_on,
                  Count{&Parameters::cast_on, 3, 1000}},
    ParameterInfo{"stitch-width", "Stitch width w", "mesh units",
                  "The distance that Algorithm 2 looks for between neighbouring stitches of a row.",
                  Stage::cast_on, Number{&Parameters::stitch_width, 0.0, 1e12}},
    ParameterInfo{
        "epsilon", "Epsilon \xCE\xB5", "mesh units",
        "Half the band's width: a vertex is accepted at a distance within [w - \xCE\xB5, w + \xCE\xB5]. The "
        "first one wins, so \xCE\xB5 sets the stitch length as much as w does.",
        Stage::rows, Number{&Parameters::epsilon, 0.0, 1e12}},
    ParameterInfo{
        "on-stall", "When nothing is in the band", "",
        "continue: take the vertex nearest to the stitch width, and log it. stop: end the run there.",
        Stage::rows, choice<&Parameters::on_stall, OnStall>(stall_names)},
    ParameterInfo{
        "last-anchor", "Last anchor", "",
        "keep: the last vertex picked is always a stitch. drop: not when it is nearer than w/2 to the first.",
        Stage::rows, choice<&Parameters::last_anchor, LastAnchor>(anchor_names)},
    ParameterInfo{
        "resample", "Resample jumps", "",
        "on: a row that more than doubles or halves is spread anew within that limit, and logged. off: stop.",
        Stage::rows, choice<&Parameters::resample, Resample>(switch_names)},
    ParameterInfo{
        "close", "Closing gap", "",
        "How the gap between last and first stitch is shared out: none, the thesis's shift, or equal arcs.",
        Stage::rows, choice<&Parameters::close, Closing>(closing_names)},
    ParameterInfo{"placement", "Placement", "",
                  "Where mains and shaping go: the thesis's rules (R0-R4), or sections as even as can be.",
                  Stage::stitches, choice<&Parameters::placement, PlacementPolicy>(placement_names)},
};

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Axis> parse_axis(std::string_view text) {
  if (text == "x") return Axis{AxisKind::x, {0.0, 1.0, 0.0}};
  if (text == "y") return Axis{AxisKind::y, {0.0, 1.0, 0.0}};
  if (text == "z") return Axis{AxisKind::z, {0.0, 1.0, 0.0}};
  glm::dvec3 direction(0.0);
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 2)) return std::nullopt;
    const auto number = parse_number(text.substr(0, comma));
    if (!number) return std::nullopt;
    direction[i] = *number;
    if (i < 2) text.remove_prefix(comma + 1);
  }
  if (!(glm::length(direction) > 0.0) || !std::isfinite(glm::length(direction))) return std::nullopt;
  return Axis{AxisKind::custom, direction};
}

std::string refused(const ParameterInfo& info, std::string_view text) {
  return "--" + std::string(info.key) + " cannot be \"" + std::string(text) + "\"; give " + range_text(info) +
         ".";
}

bool set_from(const Number& number, Parameters& p, std::string_view text) {
  const auto value = parse_number(text);
  const bool above = value && (number.low == 0.0 ? *value > 0.0 : *value >= number.low);
  if (!above || *value > number.high) return false;
  p.*number.field = *value;
  return true;
}

bool set_from(const Count& count, Parameters& p, std::string_view text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value < count.low || value > count.high) return false;
  p.*count.field = value;
  return true;
}

bool set_from(const PickedVertex& picked, Parameters& p, std::string_view text) {
  if (text == "auto") {
    p.*picked.field = no_vertex;
    return true;
  }
  VertexId value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value == no_vertex) return false;
  p.*picked.field = value;
  return true;
}

bool set_from(const AxisChoice& /*axis*/, Parameters& p, std::string_view text) {
  const auto axis = parse_axis(text);
  if (axis) p.axis = *axis;
  return axis.has_value();
}

bool set_from(const Choice& choice, Parameters& p, std::string_view text) {
  const auto found = std::find(choice.names.begin(), choice.names.end(), text);
  if (found == choice.names.end()) return false;
  choice.set(p, static_cast<int>(found - choice.names.begin()));
  return true;
}

std::string axis_text(const Axis& axis) {
  switch (axis.kind) {
    case AxisKind::x:
      return "x";
    case AxisKind::y:
      return "y";
    case AxisKind::z:
      return "z";
    case AxisKind::custom:
      break;
  }
  return number_text(axis.custom.x) + "," + number_text(axis.custom.y) + "," + number_text(axis.custom.z);
}

}  // namespace

glm::dvec3 Axis::direction() const {
  switch (kind) {
    case AxisKind::x:
      return {1.0, 0.0, 0.0};
    case AxisKind::y:
      return {0.0, 1.0, 0.0};
    case AxisKind::z:
      return {0.0, 0.0, 1.0};
    case AxisKind::custom:
      break;
  }
  return glm::normalize(custom);
}

Parameters default_parameters(const Bounds& bounds) {
  Parameters parameters;
  parameters.stitch_width = 0.03 * bounds.diagonal();
  parameters.epsilon = 0.5 * parameters.stitch_width;
  return parameters;
}

std::span<const ParameterInfo> parameter_table() { return table; }

const ParameterInfo* find_parameter(std::string_view key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const ParameterInfo& i) { return i.key == key; });
  return found == table.end() ? nullptr : &*found;
}

std::string value_text(const ParameterInfo& info, const Parameters& p) {
  struct Text {
    const Parameters& p;
    std::string operator()(const Number& n) const { return number_text(p.*n.field); }
    std::string operator()(const Count& c) const { return std::to_string(p.*c.field); }
    std::string operator()(const PickedVertex& v) const {
      return p.*v.field == no_vertex ? "auto" : std::to_string(p.*v.field);
    }
    std::string operator()(const AxisChoice& /*axis*/) const { return axis_text(p.axis); }
    std::string operator()(const Choice& c) const {
      return std::string(c.names[static_cast<std::size_t>(c.get(p))]);
    }
  };
  return std::visit(Text{p}, info.kind);
}

std::optional<std::string> set_value(const ParameterInfo& info, Parameters& parameters,
                                     std::string_view text) {
  const bool done = std::visit([&](const auto& kind) { return set_from(kind, parameters, text); }, info.kind);
  return done ? std::nullopt : std::optional(refused(info, text));
}

std::string range_text(const ParameterInfo& info) {
  struct Text {
    std::string operator()(const Number& n) const {
      const std::string low = n.low == 0.0 ? "a number above 0" : "a number from " + number_text(n.low);
      return n.high >= 1e12 ? low : low + " up to " + number_text(n.high);
    }
    std::string operator()(const Count& c) const {
      return "a whole number from " + std::to_string(c.low) + " to " + std::to_string(c.high);
    }
    std::string operator()(const PickedVertex& /*v*/) const {
      return "a vertex number counted from 0, or auto";
    }
    std::string operator()(const AxisChoice& /*a*/) const {
      return "x, y, z or a direction X,Y,Z that is not 0,0,0";
    }
    std::string operator()(const Choice& c) const {
      std::string names;
      for (std::size_t i = 0; i < c.names.size(); ++i) {
        if (i > 0) names += i + 1 == c.names.size() ? " or " : ", ";
        names += c.names[i];
      }
      return names;
    }
  };
  return std::visit(Text{}, info.kind);
}

std::optional<std::string> fault_of(const Parameters& p, const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  for (const auto& [key, vertex] : {std::pair{"--start", p.start}, std::pair{"--end", p.end}}) {
    if (vertex != no_vertex && vertex >= vertices) {
      return std::string(key) + " " + std::to_string(vertex) + " is not a vertex of this mesh; it has " +
             std::to_string(vertices) + ", counted from 0.";
    }
  }
  if (p.start != no_vertex && p.start == p.end) {
    return "--start and --end are both vertex " + std::to_string(p.start) + "; pick two different ones.";
  }
  if (p.epsilon >= p.stitch_width) {
    return "epsilon " + number_text(p.epsilon) + " is not below the stitch width " +
           number_text(p.stitch_width) +
           ", so a vertex would be a stitch away from itself; make epsilon smaller or the stitches wider.";
  }
  return std::nullopt;
}

Stage first_reader_of_change(const Parameters& a, const Parameters& b) {
  Stage first = Stage::done;
  for (const ParameterInfo& info : table) {
    if (info.first_reader < first && value_text(info, a) != value_text(info, b)) first = info.first_reader;
  }
  return first;
}

Parameters with_change(const Parameters& base, const Parameters& from, const Parameters& to) {
  Parameters result = base;
  for (const ParameterInfo& info : table) {
    const std::string text = value_text(info, to);
    if (value_text(info, from) != text) set_value(info, result, text);
  }
  return result;
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace knit
