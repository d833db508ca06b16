// The program's colours in one place. Labels use the Okabe-Ito set, which colour-blind people tell apart:
// warm for increases, blue for decreases, as in the thesis's figures.
#pragma once

#include "app/core/scene.h"
#include "knit/products.h"
#include "knit/stage.h"

namespace app::palette {

inline constexpr Colour background{24, 27, 33};
inline constexpr Colour ground{96, 102, 112};
inline constexpr Colour time_low{102, 86, 160};
inline constexpr Colour time_middle{52, 138, 141};
inline constexpr Colour time_high{221, 206, 92};
inline constexpr Colour isoline{20, 24, 32, 120};
inline constexpr Colour text{226, 228, 232};
inline constexpr Colour faint_text{150, 156, 166};

inline constexpr Colour ring{150, 156, 166};  // the cycle's vertices not yet measured
inline constexpr Colour too_near{120, 126, 138};
inline constexpr Colour too_far{160, 110, 90};
inline constexpr Colour accepted{255, 255, 255};
inline constexpr Colour anchor{255, 214, 64};
inline constexpr Colour band{255, 214, 64, 110};
inline constexpr Colour selected{140, 255, 150};
inline constexpr Colour stitch{244, 240, 228};
inline constexpr Colour row_edge{236, 232, 220};
inline constexpr Colour column_edge{40, 44, 52};
inline constexpr Colour ghost{150, 176, 214, 150};  // the pinned run behind the one at hand
inline constexpr Colour problem{230, 90, 70};
inline constexpr Colour break_hit{186, 156, 255};

inline constexpr Colour of(knit::Label label) {
  switch (label) {
    case knit::Label::knit:
      return {206, 202, 190};
    case knit::Label::m1r:
      return {213, 94, 0};
    case knit::Label::m1l:
      return {230, 159, 0};
    case knit::Label::k2tog:
      return {0, 114, 178};
    case knit::Label::ssk:
      return {86, 180, 233};
    case knit::Label::cast:
      return {0, 158, 115};
    case knit::Label::main:
      return {204, 121, 167};
  }
  return {};
}

// The timeline's stretches, one a stage.
inline constexpr Colour of(knit::Stage stage) {
  switch (stage) {
    case knit::Stage::timing:
      return {104, 92, 160};
    case knit::Stage::cast_on:
      return {0, 158, 115};
    case knit::Stage::rows:
      return {70, 130, 180};
    case knit::Stage::stitches:
      return {204, 121, 167};
    case knit::Stage::faces:
      return {200, 180, 110};
    case knit::Stage::pattern:
      return {140, 150, 160};
    case knit::Stage::import:
    case knit::Stage::done:
      break;
  }
  return ground;
}

}  // namespace app::palette
