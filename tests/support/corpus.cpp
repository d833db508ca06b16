#include "tests/support/corpus.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "knit/mesh/shapes.h"

namespace corpus {

std::vector<Case> all_cases() {
  std::vector<Case> all = text_cases();
  for (Case& shape : shape_cases()) all.push_back(std::move(shape));
  return all;
}

std::filesystem::path write(const Case& bad, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / bad.name;
  std::ofstream out(path, std::ios::binary);
  out << bad.bytes();
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path.string());
  return path;
}

std::string obj_of(const knit::Mesh& mesh) {
  std::ostringstream out;
  knit::write_obj(out, mesh, "");
  return out.str();
}

knit::Mesh ball() { return knit::sphere(24, 12); }

knit::Mesh moved(knit::Mesh mesh, double scale, double by) {
  for (glm::dvec3& p : mesh.positions) p = p * scale + glm::dvec3(by);
  return mesh;
}

}  // namespace corpus
