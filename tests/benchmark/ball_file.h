// A sphere as a file of its own in the system's place for such, gone with it.
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

class BallFile {
 public:
  explicit BallFile(std::size_t triangles)
      : path(std::filesystem::temp_directory_path() /
             ("knit-mesh-ball-" + std::to_string(getpid()) + ".obj")) {
    std::ofstream out(path, std::ios::binary);
    knit::write_obj(out, ball(triangles), "");
  }
  ~BallFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  BallFile(const BallFile&) = delete;
  BallFile& operator=(const BallFile&) = delete;
  const std::filesystem::path path;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace benchmark
