// The piece as yarn [knit/yarn/yarn.h], as it comes off the needles and is stuffed [knit/relax], in files of four kinds.
//
//   .obj          polylines with 24 places a stitch, one a row
//   .bcc          control points of uniform Catmull-Rom curves, exactly (C. Yuksel's binary curve collection)
//   .yarns        points of quadratic B-splines, 24 a stitch (Textiles Lab, Carnegie Mellon)
//   .glb, .gltf   tubes with six sides and 24 rings a stitch; the node's scale makes metres of mesh units, by the gauge
// Curves, in working order, one for each yarn. Else than in glTF lengths are in mesh units. Worked out anew by each call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "knit/yarn/yarn.h"

namespace app {

enum class YarnFormat : std::uint8_t { obj, bcc, yarns, gltf_binary, gltf_text };

inline constexpr std::size_t yarn_places_a_point = 2;  // from one control point to the next: 24 a stitch

// By the ending. None for any other.
std::optional<YarnFormat> yarn_format_of(const std::filesystem::path& path);
inline constexpr const char* yarn_endings = ".obj, .bcc, .yarns, .glb or .gltf";

// Why there is none yet; nothing when it can be written.
std::optional<std::string> yarn_missing(const Session& session);

// A file whole. Requires that nothing is missing.
std::string yarn_file(const Session& session, YarnFormat format);

// Of any yarn. `metres`: a mesh unit.
std::string yarn_obj(const knit::Fabric& fabric, const knit::Yarn& yarn);
std::string yarn_bcc(const knit::Yarn& yarn);
std::string yarn_yarns(const knit::Yarn& yarn);
std::string yarn_gltf(const knit::Yarn& yarn, double metres, bool binary);

}  // namespace app
