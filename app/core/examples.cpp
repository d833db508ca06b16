#include <algorithm>
#include <array>

#include "app/core/action.h"

namespace app {

namespace {
// The menu's order; what else lies in the folder follows by name.
constexpr std::array<std::string_view, 8> known_order{
    "thesis-sphere", "sphere", "stretched-sphere", "egg", "capsule", "cone", "vase", "torus"};
}  // namespace

std::vector<std::string> list_examples(const std::filesystem::path& assets) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(assets, error)) {
    const bool example = std::filesystem::exists(entry.path() / "mesh.obj", error) &&
                         std::filesystem::exists(entry.path() / "parameters.json", error);
    if (example) names.push_back(entry.path().filename().string());
  }
  const auto rank = [](const std::string& name) {
    return std::find(known_order.begin(), known_order.end(), name) - known_order.begin();
  };
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::pair{rank(a), a} < std::pair{rank(b), b};
  });
  return names;
}

}  // namespace app
