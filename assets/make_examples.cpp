// make_examples OUTDIR: writes OUTDIR/<example>/mesh.obj for every example. A file that is already right
// stays untouched; the others are written beside and renamed.
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>

#include "knit/mesh/branching_shapes.h"
#include "knit/mesh/shapes.h"

namespace {

namespace fs = std::filesystem;

struct Example {
  const char* name;
  knit::Mesh (*make)();
};

// Why these: see assets/README.md.
constexpr unsigned segments = 128;
constexpr double spacing = 0.07;

constexpr std::array<Example, 17> examples{{
    {"thesis-sphere", [] { return knit::sphere(segments, 65, true); }},
    {"sphere", [] { return knit::sphere(segments, 45); }},
    {"stretched-sphere", [] { return knit::stretched_sphere(segments, spacing); }},
    {"egg", [] { return knit::egg(segments, spacing); }},
    {"capsule", [] { return knit::capsule(segments, spacing); }},
    {"cone", [] { return knit::cone(segments, spacing); }},
    {"vase", [] { return knit::vase(segments, spacing); }},
    {"torus", [] { return knit::torus(segments, 28, 0.68, 0.32); }},
    {"heel", [] { return knit::heel(0.06); }},
    {"trousers", [] { return knit::trousers(0.06); }},
    {"y", [] { return knit::letter_y(0.055); }},
    {"starfish", [] { return knit::starfish(0.05); }},
    {"octopus", [] { return knit::octopus(0.07); }},
    {"mug", [] { return knit::mug(0.066); }},
    {"cup", [] { return knit::cup(0.07); }},
    {"double-torus", [] { return knit::double_torus(0.06); }},
    {"chain-of-three", [] { return knit::chain_of_three(0.055); }},
}};

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& folder, const Example& example) {
  std::ostringstream text;
  knit::write_obj(text, example.make(),
                  std::string(example.name) + ", made by make_examples of knit-mesh (MIT)");
  const fs::path path = folder / "mesh.obj";
  if (fs::is_regular_file(path) && contents(path) == text.str()) return;
  fs::create_directories(folder);
  fs::path aside = path;
  aside += ".new";
  {
    std::ofstream out(aside, std::ios::binary);
    out << text.str();
    out.close();
    if (!out) throw fs::filesystem_error("cannot write", aside, std::make_error_code(std::errc::io_error));
  }
  fs::rename(aside, path);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_examples OUTDIR\n";
    return 2;
  }
  try {
    for (const Example& example : examples) write(fs::path(argv[1]) / example.name, example);
  } catch (const std::exception& error) {
    std::cerr << "make_examples: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
