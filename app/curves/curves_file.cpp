#include "app/curves/curves_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "app/curves/curve_wish.h"
#include "knit/curves/cons_file.h"
#include "knit/curves/refused.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view curves_format = "knit-mesh curves";
constexpr std::int64_t curves_version = 1;
constexpr double farthest_point = 1e12;
constexpr std::size_t most_bytes = std::size_t{16} << 20U;

constexpr std::array<std::string_view, 2> end_words{"start", "end"};
constexpr std::array<std::string_view, 7> kind_keys{"boundary", "circle",   "band",  "plane",
                                                    "path",     "farthest", "vertex"};

Json point_json(const glm::dvec3& at) { return {at.x, at.y, at.z}; }

Json curve_json(const knit::Cycle& cycle) {
  Json json;
  json["as"] = knit::word_of(cycle.as);
  if (!cycle.name.empty()) json["name"] = cycle.name;
  json["kind"] = knit::word_of(cycle.kind);
  if (!cycle.points.empty()) json["points"] = Json::array();
  for (const glm::dvec3& point : cycle.points) json["points"].push_back(point_json(point));
  if (cycle.radius) json["radius"] = *cycle.radius;
  if (cycle.normal) json["normal"] = point_json(*cycle.normal);
  if (cycle.kind == knit::CycleKind::vertex) json["vertex"] = cycle.vertex;
  if (cycle.value) json["value"] = *cycle.value;
  return json;
}

// Three numbers; what is wrong is said of `key`.
glm::dvec3 read_point(JsonFields& fields, const std::string& key, const nlohmann::json& json) {
  glm::dvec3 at(0.0);
  bool good = json.is_array() && json.size() == 3;
  for (int i = 0; i < 3 && good; ++i) {
    const nlohmann::json& number = json[static_cast<std::size_t>(i)];
    good = number.is_number() && std::abs(number.get<double>()) <= farthest_point;
    if (good) at[i] = number.get<double>();
  }
  if (!good) fields.set_fault(key, "must be three numbers, [x, y, z].");
  return at;
}

struct PointCount {
  std::size_t least = 0, most = 0;
  std::string_view words;
};

PointCount points_wanted(const knit::Cycle& cycle) {
  constexpr std::size_t any = SIZE_MAX;
  switch (cycle.kind) {
    case knit::CycleKind::boundary:
      return {0, 1, "one point, or none"};
    case knit::CycleKind::circle:
      return {1, 1, "one point"};
    case knit::CycleKind::band:
      return {1, any, "a point at least"};
    case knit::CycleKind::plane:
      return cycle.normal ? PointCount{1, 1, "one point, beside its normal"}
                          : PointCount{3, 3, "three points"};
    case knit::CycleKind::path:
      return {3, any, "three points at least"};
    default:
      return {0, 0, "no points"};
  }
}

void read_vertex(JsonFields& fields, knit::Cycle& cycle) {
  if (cycle.kind == knit::CycleKind::vertex)
    cycle.vertex = static_cast<knit::VertexId>(fields.whole("vertex", 0, knit::no_vertex - 1));
}

knit::Cycle read_curve(JsonFields fields) {
  knit::Cycle cycle;
  cycle.as = fields.choice("as", end_words) == 0 ? knit::CycleEnd::start : knit::CycleEnd::end;
  if (fields.has("name")) cycle.name = fields.text("name");
  cycle.kind = *knit::cycle_kind(kind_keys.at(fields.choice("kind", kind_keys)));
  if (fields.has("points"))
    for (const nlohmann::json& point : fields.array("points"))
      cycle.points.push_back(read_point(fields, "points", point));
  if (fields.has("normal")) cycle.normal = read_point(fields, "normal", fields.json()["normal"]);
  if (fields.has("radius")) cycle.radius = fields.number("radius", 0.0, farthest_point);
  if (fields.has("value")) cycle.value = fields.number("value", 0.0, 1.0);
  read_vertex(fields, cycle);
  if (cycle.kind == knit::CycleKind::band && !cycle.radius) fields.set_fault("radius", "is missing.");
  const PointCount wanted = points_wanted(cycle);
  if (cycle.points.size() < wanted.least || cycle.points.size() > wanted.most)
    fields.set_fault("points", "must be " + std::string(wanted.words) + ".");
  return cycle;
}

knit::Bounds read_box(JsonFields fields) {
  knit::Bounds box;
  if (fields.json().is_object()) {
    for (const auto& [key, corner] : {std::pair{"low", &box.low}, std::pair{"high", &box.high}})
      *corner = read_point(fields, key, fields.array(key));
  }
  if (fields.fault().empty() && !(box.diagonal() > 0.0)) fields.set_fault("high", "must lie above \"low\".");
  return box;
}

std::string fault_of_format(const nlohmann::json& json) {
  if (!json.is_object() || !json.contains("format") || json["format"] != curves_format)
    return "it holds no curves: \"format\": \"knit-mesh curves\" is missing; give a file that --save-curves "
           "wrote, "
           "or a .cons of autoknit.";
  if (json.contains("version") && json["version"].is_number_integer() && json["version"] == curves_version)
    return "";
  return "it is of another version, and this program reads version 1; open it with the knit-mesh that wrote "
         "it.";
}

std::variant<CurvesFile, std::string> curves_of_cons(std::string_view bytes) {
  auto read = knit::read_cons(bytes);
  if (auto* fault = std::get_if<std::string>(&read)) return std::move(*fault);
  return CurvesFile{std::get<0>(std::move(read)), std::nullopt};
}

}  // namespace

Json curves_json(std::span<const knit::Cycle> curves) {
  Json list = Json::array();
  for (const knit::Cycle& cycle : curves) list.push_back(curve_json(cycle));
  return list;
}

Json curves_json(std::span<const knit::Cycle> curves, std::span<const glm::dvec3> positions) {
  Json list = Json::array();
  for (knit::Cycle cycle : curves) {
    if (cycle.kind == knit::CycleKind::vertex && cycle.vertex < positions.size()) {
      cycle.kind = knit::CycleKind::circle;
      cycle.points = {positions[cycle.vertex]};
    }
    list.push_back(curve_json(cycle));
  }
  return list;
}

std::vector<knit::Cycle> read_curve_list(JsonFields& fields, const std::string& key) {
  std::vector<knit::Cycle> curves;
  const std::size_t count = fields.array(key).size();
  for (std::size_t i = 0; i < count && fields.fault().empty(); ++i)
    curves.push_back(read_curve(fields.entry(key, i)));
  return curves;
}

std::string curves_text(std::span<const knit::Cycle> curves, const knit::Mesh& mesh) {
  const knit::Bounds bounds = knit::bounds_of(mesh.positions);
  Json json;
  json["format"] = curves_format;
  json["version"] = curves_version;
  json["mesh"] = {{"name", mesh.name}, {"low", point_json(bounds.low)}, {"high", point_json(bounds.high)}};
  json["curves"] = curves_json(curves, mesh.positions);
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::variant<CurvesFile, std::string> read_curves_text(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::string("it is no JSON; give a file that --save-curves wrote.");
  if (auto fault = fault_of_format(json); !fault.empty()) return fault;
  JsonFields fields(json);
  CurvesFile file;
  if (fields.has("mesh")) file.drawn_on = read_box(fields.object("mesh"));
  file.curves = read_curve_list(fields, "curves");
  if (!fields.fault().empty()) return fields.fault();
  return file;
}

std::variant<CurvesFile, std::string> read_curves_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return path.string() + " does not exist; give a file of curves.";
  if (std::filesystem::is_directory(path, error))
    return path.string() + " is a folder; give a file of curves.";
  std::ifstream in(path, std::ios::binary);
  std::string text(most_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  if (in.bad() || (text.empty() && !in.eof()))
    return path.string() + " cannot be read; see to its permissions.";
  if (text.size() > most_bytes) return path.string() + " is larger than 16 MB, so it holds no curves.";
  auto read = path.extension() == ".cons" ? curves_of_cons(text) : read_curves_text(text);
  if (auto* fault = std::get_if<std::string>(&read)) return path.string() + ": " + *fault;
  return read;
}

bool is_curves_file(const std::filesystem::path& path) {
  return path.extension() == ".cons" || path.filename().string().ends_with(".curves.json");
}

std::variant<std::vector<knit::Cycle>, std::string> fitted(const CurvesFile& file, const knit::Bounds& bounds,
                                                           bool scale) {
  std::vector<knit::Cycle> curves = file.curves;
  if (!file.drawn_on) return curves;
  const double times = bounds.diagonal() / file.drawn_on->diagonal();
  if (!scale && std::abs(times - 1.0) <= 0.02) return curves;
  if (!scale)
    return "the mesh is " + knit::three_digits(times) +
           " times the size it was when the curves were drawn; give --curves-scale auto to scale them with "
           "it.";
  for (knit::Cycle& cycle : curves) {
    for (glm::dvec3& point : cycle.points) point = bounds.low + times * (point - file.drawn_on->low);
    if (cycle.radius) *cycle.radius *= times;
  }
  return curves;
}

std::variant<std::vector<knit::Cycle>, std::string> curves_for(const CurveWish& wish,
                                                               const knit::Bounds& bounds) {
  std::vector<knit::Cycle> curves;
  if (!wish.file.empty()) {
    auto read = read_curves_file(wish.file);
    if (auto* fault = std::get_if<std::string>(&read)) return std::move(*fault);
    auto fit = fitted(std::get<CurvesFile>(read), bounds, wish.scale);
    if (auto* fault = std::get_if<std::string>(&fit)) return wish.file.string() + ": " + *fault;
    curves = std::get<0>(std::move(fit));
  }
  for (const knit::Cycle& curve : wish.curves) curves = with_curve(std::move(curves), curve);
  return curves;
}

std::vector<knit::Cycle> with_curve(std::vector<knit::Cycle> given, const knit::Cycle& curve) {
  std::erase_if(given, [&](const knit::Cycle& one) { return one.as == curve.as; });
  const auto at = curve.as == knit::CycleEnd::start ? given.begin() : given.end();
  given.insert(at, curve);
  return given;
}

}  // namespace app
