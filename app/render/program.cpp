#include "app/render/program.h"

#include <algorithm>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <system_error>

#include "shaders_embedded.h"

namespace app {

namespace {

// Empty in a build that does not look at files.
std::filesystem::path piece_file([[maybe_unused]] const std::string& name) {
#ifdef KNIT_SHADER_DIR
  return std::filesystem::path(KNIT_SHADER_DIR) / name;
#else
  return {};
#endif
}

std::string piece_text(const std::string& name) {
  if (const auto file = piece_file(name); !file.empty()) {
    std::ifstream in(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (!text.empty()) {
      return text;
    }
  }
  const std::string_view text = shaders::source(name);
  if (text.empty()) {
    throw GlError("The program was built without its shader " + name + ". Build it again.");
  }
  return std::string(text);
}

template <class GetNumber, class GetLog>
std::string log_of(GLuint id, GetNumber get_number, GetLog get_log) {
  GLint length = 0;
  get_number(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  get_log(id, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  while (!log.empty() && log.back() == '\n') log.pop_back();
  std::string line;  // drivers write several, and a sentence is one
  for (const char c : log) line += c == '\n' ? std::string("; ") : std::string(1, c);
  return line;
}

GlShader compile(GLenum kind, const ShaderProgram::Pieces& pieces) {
  std::string text = std::string(shader_version) + shader_precision;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    text += "#line 1 " + std::to_string(i) + "\n" + piece_text(pieces[i]);
  }
  GlShader shader(glCreateShader(kind));
  const GLchar* source = text.c_str();
  glShaderSource(shader.id(), 1, &source, nullptr);
  glCompileShader(shader.id());
  GLint good = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
  if (good == GL_FALSE) {
    throw GlError("The graphics driver rejects the shader " + pieces.back() + ": " +
                  log_of(shader.id(), glGetShaderiv, glGetShaderInfoLog) +
                  ". Update the graphics driver, or correct the shader.");
  }
  return shader;
}

}  // namespace

ShaderProgram::ShaderProgram(Pieces vertex, Pieces fragment)
    : vertex_(std::move(vertex)), fragment_(std::move(fragment)), built_of_(newest_piece()) {
  build();
}

void ShaderProgram::build() {
  const GlShader vertex = compile(GL_VERTEX_SHADER, vertex_);
  const GlShader fragment = compile(GL_FRAGMENT_SHADER, fragment_);
  GlProgram program = GlProgram::make();
  glAttachShader(program.id(), vertex.id());
  glAttachShader(program.id(), fragment.id());
  glLinkProgram(program.id());
  GLint good = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &good);
  if (good == GL_FALSE) {
    throw GlError("The graphics driver cannot link " + vertex_.back() + " and " + fragment_.back() + ": " +
                  log_of(program.id(), glGetProgramiv, glGetProgramInfoLog) +
                  ". Update the graphics driver, or correct the shaders.");
  }
  glDetachShader(program.id(), vertex.id());
  glDetachShader(program.id(), fragment.id());
  program_ = std::move(program);
  locations_.clear();
  GLint count = 0;
  glGetProgramiv(program_.id(), GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    GLchar name[128] = {};
    GLsizei length = 0;
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program_.id(), static_cast<GLuint>(i), sizeof name, &length, &size, &type, name);
    locations_[name] = glGetUniformLocation(program_.id(), name);
  }
}

std::filesystem::file_time_type ShaderProgram::newest_piece() const {
  auto newest = std::filesystem::file_time_type::min();
  for (const Pieces* pieces : {&vertex_, &fragment_}) {
    for (const std::string& name : *pieces) {
      if (const auto file = piece_file(name); !file.empty()) {
        std::error_code error;
        const auto time = std::filesystem::last_write_time(file, error);
        newest = error ? newest : std::max(newest, time);
      }
    }
  }
  return newest;
}

bool ShaderProgram::refresh() {
  const auto newest = newest_piece();
  if (newest == built_of_) {
    return false;
  }
  built_of_ = newest;
  try {
    build();
    problem_.clear();
  } catch (const GlError& error) {
    problem_ = error.what();
  }
  return true;
}

GLint ShaderProgram::location(std::string_view name) const {
  const auto found = locations_.find(name);
  return found == locations_.end() ? -1 : found->second;
}

void ShaderProgram::set(std::string_view name, float value) const { glUniform1f(location(name), value); }
void ShaderProgram::set(std::string_view name, int value) const { glUniform1i(location(name), value); }
void ShaderProgram::set(std::string_view name, const glm::vec2& value) const {
  glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(std::string_view name, const glm::vec3& value) const {
  glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(std::string_view name, const glm::vec4& value) const {
  glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(std::string_view name, const glm::mat4& value) const {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace app
