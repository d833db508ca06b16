// What two writers of glTF 2.0 share: numbers that the standard names, and the binary container.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "app/base/little_endian.h"

namespace app {

inline constexpr int gltf_u16 = 5123, gltf_u32 = 5125, gltf_f32 = 5126;  // a component's type
inline constexpr int gltf_vertices = 34962, gltf_indices = 34963;        // a buffer view's target

inline void append_vec3(std::string& bytes, const glm::vec3& v) {
  for (int axis = 0; axis < 3; ++axis) append_f32(bytes, v[axis]);
}

// Section 4.4 of the standard: a header, the JSON padded with spaces to four bytes, then the buffer. Requires a buffer of
// whole fours of bytes.
inline std::string glb_of(std::string json, const std::string& buffer) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string file = "glTF";
  append_u32(file, 2);
  append_u32(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append_u32(file, static_cast<std::uint32_t>(json.size()));
  file += "JSON" + json;
  append_u32(file, static_cast<std::uint32_t>(buffer.size()));
  file += std::string("BIN\0", 4) + buffer;
  return file;
}

}  // namespace app
