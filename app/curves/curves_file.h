// Curves in files, by position: what was clicked is kept, never a vertex's number, so that they fit a finer export of the
// mesh too. JSON with a version; the same list of curves stands in a session. autoknit's constraints (.cons) are read.
//
//   { "format": "knit-mesh curves", "version": 1,
//     "mesh": { "name": "sphere", "low": [-1,-1,-1], "high": [1,1,1] },
//     "curves": [ { "as": "start", "name": "brim", "kind": "circle", "points": [[0.6,-0.7,0.3]], "radius": 0.6 },
//                 { "as": "end", "kind": "path", "points": [[...], ...] } ] }
// Mesh units. A "plane" may have a "normal", any curve a "value", its time from 0 to 1. Fields that are not known are
// left alone. A circle without a radius is that of a cast on. Errors are one sentence.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/base/json_fields.h"
#include "knit/curves/cycle.h"
#include "knit/mesh/mesh.h"

namespace app {

struct CurvesFile {
  std::vector<knit::Cycle> curves;
  std::optional<knit::Bounds> drawn_on;  // of the mesh then; none: the file does not say
};

// The list, as it stands in files: a curve about a vertex becomes a circle about its place.
nlohmann::ordered_json curves_json(std::span<const knit::Cycle> curves,
                                   std::span<const glm::dvec3> positions);
// Likewise, about a vertex by its number: in a session, which knows its mesh.
nlohmann::ordered_json curves_json(std::span<const knit::Cycle> curves);
// The list that stands at `key`; what is wrong with it becomes the fields' fault.
std::vector<knit::Cycle> read_curve_list(JsonFields& fields, const std::string& key);

// The whole file.
std::string curves_text(std::span<const knit::Cycle> curves, const knit::Mesh& mesh);
std::variant<CurvesFile, std::string> read_curves_text(std::string_view text);
// By its ending: .cons, else JSON.
std::variant<CurvesFile, std::string> read_curves_file(const std::filesystem::path& path);

// By its ending: .curves.json or .cons.
bool is_curves_file(const std::filesystem::path& path);

// The file's curves on a mesh with these bounds; moved and scaled with it where `scale` wants that, and else refused where
// its size is another by more than 2 %.
std::variant<std::vector<knit::Cycle>, std::string> fitted(const CurvesFile& file, const knit::Bounds& bounds,
                                                           bool scale);

}  // namespace app
