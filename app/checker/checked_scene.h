// From a checked pattern to what there is to see of it: rings and strips, those of lines that do not add up or are
// not understood in their colours, that of the caret's line lit, pieces with their names.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/checker/checked_shape.h"

namespace app {

// Keeps what it has made, so that a renderer uploads it once: it is made anew for another text, size, gauge or theme.
class CheckedScene {
 public:
  // The scene's theme and background are set before; the rest is set here.
  void describe(const Checker& checker, double aspect, Scene& scene);

 private:
  void make(const Checker& checker, const Theme& theme);

  std::shared_ptr<const knit::CheckedPattern> checked_;
  std::size_t size_ = 0;
  CheckedGauge gauge_;
  const Theme* theme_ = nullptr;
  CheckedShape shape_;
  std::vector<std::shared_ptr<const FaceShape>> faces_;
  std::vector<std::shared_ptr<const std::vector<Line>>> lines_;
};

}  // namespace app
