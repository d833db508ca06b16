// How settings are read from text, written as text and compared, by the table.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/base/number_text.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"

namespace knit {

namespace {

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = number_from(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

// "X,Y,Z", not all 0.
std::optional<glm::dvec3> parse_direction(std::string_view text) {
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
  return direction;
}

std::optional<Axis> parse_axis(std::string_view text) {
  if (text == "x") return Axis{AxisKind::x, {0.0, 1.0, 0.0}};
  if (text == "y") return Axis{AxisKind::y, {0.0, 1.0, 0.0}};
  if (text == "z") return Axis{AxisKind::z, {0.0, 1.0, 0.0}};
  const auto direction = parse_direction(text);
  return direction ? std::optional(Axis{AxisKind::custom, *direction}) : std::nullopt;
}

bool may_be_auto(const Number& number) { return number.zero == Zero::follows || number.zero == Zero::chosen; }

std::string refused(const ParameterInfo& info, std::string_view text) {
  return "--" + std::string(info.key) + " cannot be \"" + std::string(text) + "\"; give " + range_text(info) +
         ".";
}

bool set_from(const Number& number, Parameters& p, std::string_view text) {
  for (const NamedNumber& named : number.names) {
    if (named.name != text) continue;
    number.set(p, named.value);
    return true;
  }
  if (may_be_auto(number) && text == "auto") {
    number.set(p, 0.0);
    return true;
  }
  const auto value = parse_number(text);
  const bool above_zero = number.low == 0.0 && number.zero != Zero::allowed;
  const bool above = value && (above_zero ? *value > 0.0 : *value >= number.low);
  if (!above || *value > number.high) return false;
  number.set(p, *value);
  return true;
}

bool set_from(const Count& count, Parameters& p, std::string_view text) {
  if (count.zero_means_auto && text == "auto") {
    count.set(p, 0);
    return true;
  }
  int value = 0;
  const char* end = text.data() + text.size();
  const auto result = number_from(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value < count.low || value > count.high) return false;
  count.set(p, value);
  return true;
}

bool set_from(const PickedVertex& picked, Parameters& p, std::string_view text) {
  if (text == "auto") {
    picked.set(p, no_vertex);
    return true;
  }
  VertexId value = 0;
  const char* end = text.data() + text.size();
  const auto result = number_from(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value == no_vertex) return false;
  picked.set(p, value);
  return true;
}

bool set_from(const AxisChoice& choice, Parameters& p, std::string_view text) {
  const auto axis = parse_axis(text);
  if (axis) choice.set(p, *axis);
  return axis.has_value();
}

bool set_from(const DirectionChoice& choice, Parameters& p, std::string_view text) {
  const auto direction = parse_direction(text);
  if (direction || text == "auto") choice.set(p, direction);
  return direction || text == "auto";
}

bool set_from(const GaugeChoice& choice, Parameters& p, std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  const auto stitches = parse_number(text.substr(0, comma));
  const auto rounds = parse_number(text.substr(comma + 1));
  if (!stitches || !rounds || *stitches <= 0.0 || *rounds <= 0.0) return false;
  choice.set(p, {*stitches, *rounds});
  return true;
}

bool set_from(const Choice& choice, Parameters& p, std::string_view text) {
  const auto found = std::find(choice.names.begin(), choice.names.end(), text);
  if (found == choice.names.end()) return false;
  choice.set(p, static_cast<int>(found - choice.names.begin()));
  return true;
}

std::string direction_text(const glm::dvec3& d) {
  return number_text(d.x) + "," + number_text(d.y) + "," + number_text(d.z);
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
  return direction_text(axis.custom);
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

const ParameterInfo* find_parameter(std::string_view key) {
  const auto table = parameter_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const ParameterInfo& i) { return i.key == key; });
  return found == table.end() ? nullptr : &*found;
}

std::string value_text(const ParameterInfo& info, const Parameters& p) {
  struct Text {
    const Parameters& p;
    std::string operator()(const Number& n) const {
      for (const NamedNumber& named : n.names) {
        if (named.value == n.get(p)) return std::string(named.name);
      }
      return is_auto(n, p) ? "auto" : number_text(n.get(p));
    }
    std::string operator()(const Count& c) const {
      return c.zero_means_auto && c.get(p) == 0 ? "auto" : std::to_string(c.get(p));
    }
    std::string operator()(const PickedVertex& v) const {
      return v.get(p) == no_vertex ? "auto" : std::to_string(v.get(p));
    }
    std::string operator()(const AxisChoice& a) const { return axis_text(a.get(p)); }
    std::string operator()(const DirectionChoice& d) const {
      const auto direction = d.get(p);
      return direction ? direction_text(*direction) : "auto";
    }
    std::string operator()(const GaugeChoice& g) const {
      return number_text(g.get(p).stitches) + "," + number_text(g.get(p).rounds);
    }
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

std::optional<std::string> set_values(std::span<const Setting> settings, Parameters& parameters) {
  for (const bool sizes : {false, true}) {
    for (const auto& [info, text] : settings) {
      if ((info->key == keys::sizes) != sizes) continue;
      if (auto fault = set_value(*info, parameters, text)) return fault;
    }
  }
  return std::nullopt;
}

std::optional<ViewClash> clash_of_views(std::span<const Setting> settings) {
  ViewClash clash{};
  for (const auto& [info, text] : settings) {
    if (info->key == keys::sizes) return std::nullopt;
    const auto view = view_of(*info);
    if (view) (*view == SizesFrom::mesh ? clash.mesh : clash.gauge) = info;
  }
  return clash.mesh != nullptr && clash.gauge != nullptr ? std::optional(clash) : std::nullopt;
}

std::string range_text(const ParameterInfo& info) {
  struct Text {
    std::string operator()(const Number& n) const {
      const bool from_low = n.low != 0.0 || n.zero == Zero::allowed;
      const std::string low = from_low ? "a number from " + number_text(n.low) : "a number above 0";
      std::string range = n.high >= no_limit ? low : low + " up to " + number_text(n.high);
      for (const NamedNumber& named : n.names)
        range += (&named == &n.names.back() ? " or " : ", ") + std::string(named.name);
      return may_be_auto(n) ? range + ", or auto" : range;
    }
    std::string operator()(const Count& c) const {
      return "a whole number from " + std::to_string(c.low) + " to " + std::to_string(c.high) +
             (c.zero_means_auto ? ", or auto" : "");
    }
    std::string operator()(const PickedVertex& /*v*/) const {
      return "a vertex number counted from 0, or auto";
    }
    std::string operator()(const AxisChoice& /*a*/) const {
      return "x, y, z or a direction X,Y,Z that is not 0,0,0";
    }
    std::string operator()(const DirectionChoice& /*d*/) const {
      return "a direction X,Y,Z that is not 0,0,0, or auto";
    }
    std::string operator()(const GaugeChoice& /*g*/) const { return "two numbers above 0, as 22,32"; }
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

namespace {

// Whether a face has a corner there; one with two corners at the same place is no part of the surface.
bool is_on_surface(VertexId vertex, const Mesh& mesh) {
  const glm::dvec3 place = mesh.positions[vertex];
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    return (a == place || b == place || c == place) && a != b && b != c && c != a;
  });
}

std::optional<std::string> picked_vertex_fault(std::string_view option, VertexId vertex, const Mesh& mesh) {
  if (vertex == no_vertex) return std::nullopt;
  const std::string picked = std::string(option) + " " + std::to_string(vertex);
  if (vertex >= mesh.positions.size()) {
    return picked + " is not a vertex of this mesh; it has " + std::to_string(mesh.positions.size()) +
           ", counted from 0.";
  }
  if (is_on_surface(vertex, mesh)) return std::nullopt;
  return picked + " belongs to no face of this mesh; pick a vertex of the surface, or auto.";
}

std::optional<std::string> start_direction_fault(const Settings& settings, const Mesh& mesh) {
  const auto& start = settings.rows.start_direction;
  if (!start) return std::nullopt;
  const glm::dvec3 along = knitting_direction(settings.timing, mesh);
  const glm::dvec3 side = glm::cross(*start, along);
  if (glm::length(side) > 1e-6 * glm::length(*start) * glm::length(along)) return std::nullopt;
  return "--start-direction " + direction_text(*start) +
         " points along the direction of knitting; give one across it.";
}

// Values that no text could have given: out of range, or no numbers.
std::optional<std::string> range_fault(const Parameters& p) {
  for (const ParameterInfo& info : parameter_table()) {
    Parameters read_back = p;
    if (auto fault = set_value(info, read_back, value_text(info, p))) return fault;
  }
  return std::nullopt;
}

std::optional<std::string> ends_fault(const TimingSettings& timing, const Mesh& mesh) {
  for (const auto& [option, vertex] : {std::pair{"--start", timing.start}, std::pair{"--end", timing.end}}) {
    if (auto fault = picked_vertex_fault(option, vertex, mesh)) return fault;
  }
  if (timing.start == no_vertex || timing.start != timing.end) return std::nullopt;
  return "--start and --end are both vertex " + std::to_string(timing.start) + "; pick two different ones.";
}

}  // namespace

std::optional<std::string> fault_of(const Parameters& parameters, const Input& input) {
  if (auto fault = range_fault(parameters)) return fault;
  const Parameters p = resolved(parameters, input);
  if (auto fault = range_fault(p)) return fault;
  if (auto fault = ends_fault(p.timing, input.mesh)) return fault;
  if (auto fault = start_direction_fault(p, input.mesh)) return fault;
  if (p.rows.source != RowSource::contours && p.epsilon() >= p.stitch.width) {
    return "\xCE\xB5 must be smaller than the stitch width: \xCE\xB5 " + number_text(p.epsilon()) + " at w " +
           number_text(p.stitch.width) +
           " would accept a vertex as a stitch away from itself; make \xCE\xB5 smaller or the stitches "
           "wider.";
  }
  return std::nullopt;
}

bool is_auto(const Number& number, const Parameters& parameters) {
  return may_be_auto(number) && number.get(parameters) == 0.0;
}

std::optional<double> effective_value(const Number& number, const Parameters& parameters) {
  if (!is_auto(number, parameters)) return number.get(parameters);
  return number.zero == Zero::follows ? std::optional(parameters.stitch.height) : std::nullopt;
}

std::optional<SizesFrom> view_of(const ParameterInfo& info) {
  if (info.tie == Tie::mesh_view) return SizesFrom::mesh;
  if (info.tie == Tie::gauge_view) return SizesFrom::gauge;
  return std::nullopt;
}

bool is_read(const ParameterInfo& info, const Parameters& parameters) {
  return info.read_when == nullptr || info.read_when(parameters);
}

bool can_change_at(const ParameterInfo& info, const Place& next) {
  return info.not_from_here.empty() || next <= Place{info.first_reader, 1, 0};
}

std::optional<std::string> why_not_from_here(const Parameters& before, const Parameters& after,
                                             const Place& next) {
  for (const ParameterInfo& info : parameter_table()) {
    if (can_change_at(info, next) || same_value(info, before, after)) continue;
    std::string words(info.not_from_here);
    const std::size_t value = words.find("{}");
    if (value != std::string::npos) words.replace(value, 2, value_text(info, before));
    return words;
  }
  return std::nullopt;
}

bool only_follows(const ParameterInfo& info, const Parameters& from, const Parameters& to) {
  if (info.tie == Tie::width) return from.rows.epsilon == to.rows.epsilon;
  const auto view = view_of(info);
  return view && *view != to.size.from();
}

bool same_value(const ParameterInfo& info, const Parameters& a, const Parameters& b) {
  return std::visit([&](const auto& kind) { return kind.get(a) == kind.get(b); }, info.kind);
}

Stage first_stage_to_read(const ParameterInfo& info, const Parameters& parameters) {
  const bool makes_stitches = info.first_reader > Stage::tubes && info.first_reader <= Stage::stitches;
  const bool orders_tubes =
      makes_stitches && parameters.rows.source != RowSource::rings && is_read(info, parameters);
  // Whether there are short rows, and how many rows tubes keep, is chosen by how each way settles.
  const ShortRowSettings& short_rows = parameters.short_rows;
  const bool settles_ahead =
      info.first_reader == Stage::settle && parameters.rows.source != RowSource::rings &&
      short_rows.rows == ShortRows::automatic && short_rows.kept == KeptBeside::by_itself;
  if (orders_tubes || settles_ahead) return Stage::tubes;
  // What follows the last step of settling is read by that, where it is known that there is one.
  const bool settles =
      parameters.settle.settling == Settling::on ||
      (parameters.settle.settling == Settling::by_itself && parameters.rows.source == RowSource::contours);
  return info.key == keys::relax && settles ? Stage::settle : info.first_reader;
}

Stage first_reader_of_change(const Parameters& a, const Parameters& b) {
  Stage first = Stage::done;
  for (const ParameterInfo& info : parameter_table()) {
    // The timing groups levels for contours too; but no row of contours reads what is the rings' own.
    const bool by_none = info.first_reader > Stage::timing && !is_read(info, a) && !is_read(info, b);
    if (by_none || same_value(info, a, b)) continue;
    first = std::min({first, first_stage_to_read(info, a), first_stage_to_read(info, b)});
  }
  return first;
}

Parameters with_change(const Parameters& base, const Parameters& from, const Parameters& to) {
  Parameters result = base;
  for (const ParameterInfo& info : parameter_table()) {
    if (same_value(info, from, to) || only_follows(info, from, to)) continue;
    std::visit([&](const auto& kind) { kind.set(result, kind.get(to)); }, info.kind);
  }
  return result;
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto result = number_into(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace knit
