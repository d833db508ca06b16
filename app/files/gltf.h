// The knit mesh as glTF 2.0, for programs that show and print three-dimensional things.
//
// Faces in the colours of their labels (COLOR_0, linear), normals outward; row edges and column edges as
// lines. Positions are in mesh units; the node's scale makes them metres, by the gauge. Before faces are made
// there are only the rows' lines.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace app {

enum class GltfFormat : std::uint8_t { binary, text };

// By the ending: .glb or .gltf. None for any other.
std::optional<GltfFormat> gltf_format_of(const std::filesystem::path& path);
inline constexpr const char* gltf_endings = ".glb or .gltf";

// Why there is none yet; nothing when it can be written.
std::optional<std::string> gltf_missing(const Session& session);

// A file whole, at the session's position. Requires that nothing is missing.
std::string gltf_file(const Session& session, GltfFormat format);

}  // namespace app
