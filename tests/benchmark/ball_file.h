// A mesh, a sphere for one, as a file of its own in the system's place for such, gone with it.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "knit/mesh/shapes.h"

namespace benchmark {

// Of about so many triangles, in rings.
inline knit::Mesh ball(std::size_t triangles) {
  const auto side = static_cast<unsigned>(std::lround(std::sqrt(0.5 * static_cast<double>(triangles))));
  return knit::sphere(side, side + 1);
}

class MeshFile {
 public:
  MeshFile(const std::string& name, const knit::Mesh& mesh)
      : path(std::filesystem::temp_directory_path() /
             ("knit-mesh-" + name + "-" + std::to_string(getpid()) + ".obj")) {
    std::ofstream out(path, std::ios::binary);
    knit::write_obj(out, mesh, "");
  }
  ~MeshFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;
  const std::filesystem::path path;
};

class BallFile : public MeshFile {
 public:
  explicit BallFile(std::size_t triangles) : MeshFile("ball", ball(triangles)) {}
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace benchmark
