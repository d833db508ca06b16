// The curves that a person wants a mesh to be cut along, as they are asked for: some in a file, some by themselves.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "knit/curves/cycle.h"
#include "knit/mesh/mesh.h"

namespace app {

struct CurveWish {
  std::filesystem::path file;       // of curves; empty: none
  bool scale = false;               // the file's are made to fit a mesh of another size
  std::vector<knit::Cycle> curves;  // each in place of those of the file that are the same end
  [[nodiscard]] bool none() const { return file.empty() && curves.empty(); }
  friend bool operator==(const CurveWish&, const CurveWish&) = default;
};

// Of a mesh with these bounds. The error is one sentence.
std::variant<std::vector<knit::Cycle>, std::string> curves_for(const CurveWish& wish,
                                                               const knit::Bounds& bounds);

// `given` with `curve` in place of those that are the same end.
std::vector<knit::Cycle> with_curve(std::vector<knit::Cycle> given, const knit::Cycle& curve);

}  // namespace app
