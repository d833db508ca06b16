// A pair of shaders, made of pieces from shaders/. A build for developers reads the pieces again when they
// change.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/render/gl_handle.h"

namespace app {

class ShaderProgram {
 public:
  using Pieces = std::vector<std::string>;  // file names in shaders/, in order; the version line is added

  // Throws GlError with the driver's log.
  ShaderProgram(Pieces vertex, Pieces fragment);

  // Compiles again if a piece was saved since. If that fails the old program stays and problem() says why.
  bool refresh();
  const std::string& problem() const { return problem_; }

  void use() const { glUseProgram(program_.id()); }
  // For the program in use. A name that the driver optimised away is no error.
  void set(std::string_view name, float value) const;
  void set(std::string_view name, int value) const;
  void set(std::string_view name, const glm::vec2& value) const;
  void set(std::string_view name, const glm::vec3& value) const;
  void set(std::string_view name, const glm::vec4& value) const;
  void set(std::string_view name, const glm::mat4& value) const;

 private:
  GLint location(std::string_view name) const;
  std::filesystem::file_time_type newest_piece() const;
  void build();

  Pieces vertex_, fragment_;
  GlProgram program_;
  std::map<std::string, GLint, std::less<>> locations_;
  std::filesystem::file_time_type built_of_;
  std::string problem_;
};

}  // namespace app
