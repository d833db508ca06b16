// The two frames between which each loop lies, and the strands that are lifted [yarn.h].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "knit/yarn/loop_shape.h"
#include "knit/yarn/worked_from.h"

namespace knit {

struct LoopFrames {
  std::vector<LoopFrame> stitch;  // as the stitch stands, its head's place moved
  std::vector<LoopFrame> base, head;
  // Of each stitch, the increase that the strand after it is lifted for, along the yarn; no_stitch: it lies where it is.
  std::vector<std::uint32_t> lifted_after;
  std::vector<std::uint8_t> bar_of;  // an increase that has a bar

  // The width of a stitch between two that follow each other on the yarn.
  [[nodiscard]] glm::dvec3 course_at(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] LoopFrame bar_base(std::uint32_t a, std::uint32_t b, double width, double radius) const;
  [[nodiscard]] LoopFrame bar_head(std::uint32_t made, double radius) const;
};

LoopFrames loop_frames(std::vector<LoopFrame> stitches, std::span<const WorkedFrom> worked,
                       std::span<const YarnPath> paths, double radius);

}  // namespace knit
