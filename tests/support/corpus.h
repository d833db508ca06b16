// Bad meshes, and odd ones that are good, made by a generator: every way that is known of a file to be no mesh to
// knit. Deterministic: the same bytes each time. Meshes by others stay in ../shared/meshes.
//
// What else can be wrong with a file (a pipe, a folder, no permission, gone, far too large) is not in its bytes:
// corpus_files_test.cpp makes those.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "knit/mesh/mesh.h"

namespace corpus {

// How opening it ends.
struct Opens {
  std::size_t vertices = 0, triangles = 0;
  std::vector<std::string> warnings;  // words of each, in order; none but these
};
struct Refused {
  std::vector<std::string> words;  // all in the one sentence: what is wrong, and what to do
  std::string repairs;  // that would make it fit, by their keys: "doubles,holes"; empty: none would
};

struct Case {
  std::string name;  // of the file
  std::function<std::string()> bytes;
  bool opens = false;
  Opens opened{};
  Refused refused{};
};

std::vector<Case> text_cases();   // of what a file says, and how
std::vector<Case> shape_cases();  // of what a mesh is like
std::vector<Case> all_cases();

// Writes the file into the folder; its path.
std::filesystem::path write(const Case& bad, const std::filesystem::path& folder);

// As a file.
std::string obj_of(const knit::Mesh& mesh);
// A closed ball of 266 vertices and 528 triangles: what is spoilt.
knit::Mesh ball();
// Scaled, then moved.
knit::Mesh moved(knit::Mesh mesh, double scale, double by);

}  // namespace corpus
