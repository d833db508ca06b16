// The program's colours in one place, in a dark and a light theme. Labels use the Okabe-Ito set, which
// colour-blind people tell apart: warm for increases, blue for decreases, as in the thesis's figures.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "app/scene/colour.h"
#include "knit/model/label.h"
#include "knit/model/stage.h"

namespace app {

enum class ThemeKind : std::uint8_t { dark, light };
inline constexpr std::array<std::string_view, 2> theme_keys{"dark", "light"};

struct Theme {
  // The view.
  Colour background{24, 27, 33};
  Colour ground{96, 102, 112};
  Colour time_low{102, 86, 160};
  Colour time_middle{52, 138, 141};
  Colour time_high{221, 206, 92};
  Colour isoline{20, 24, 32, 120};

  Colour ring{150, 156, 166};  // the cycle's vertices not yet measured
  Colour too_near{120, 126, 138};
  Colour too_far{160, 110, 90};
  Colour accepted{255, 255, 255};
  Colour anchor{255, 214, 64};
  Colour band{255, 214, 64, 190};
  Colour selected{140, 255, 150};
  Colour stitch{244, 240, 228};
  Colour row_edge{236, 232, 220};
  Colour column_edge{40, 44, 52};
  // Of the chart, on faces: what shows better on a label's colour.
  Colour symbol{24, 26, 30};
  Colour pale_symbol{255, 255, 255};
  Colour ghost{150, 176, 214, 150};  // the pinned run behind the current one
  Colour problem{240, 104, 84};
  Colour break_hit{186, 156, 255};
  Colour one_side{255, 148, 56};  // of a split or a join, and the other
  Colour other_side{72, 184, 255};
  // Edges while stitches settle: too short, at ease, too long. Blue and orange are told apart by all.
  Colour stretch_short{72, 184, 255};
  Colour stretch_even{158, 162, 170};
  Colour stretch_long{255, 148, 56};

  // The chart's squares: plain, of a main line, of the current round; in both themes.
  Colour paper{238, 235, 226};
  Colour main_paper{240, 214, 228};
  Colour lit_paper{255, 247, 190};

  // The panels.
  Colour text{226, 228, 232};
  Colour faint_text{168, 174, 184};
  Colour panel{31, 35, 42};
  Colour raised{43, 48, 57};
  Colour hovered{57, 64, 76};
  Colour pressed{64, 73, 87};
  Colour outline{52, 58, 68};
  Colour accent{96, 160, 224};
  Colour on_accent{16, 20, 26};  // words on it
  Colour warning{230, 170, 60};
  // How much of a stage's colour its stretch of the timeline has, before the scrubber has passed and after: the
  // stage's name must be readable on both.
  std::uint8_t stage_ahead = 45, stage_done = 115;

  // By number: as words and as lines of the chart, on its squares; dark enough for the darkest of them.
  std::array<Colour, 10> label_inks{{{34, 37, 43},
                                     {156, 68, 0},
                                     {125, 86, 0},
                                     {0, 98, 154},
                                     {42, 98, 128},
                                     {0, 107, 78},
                                     {131, 77, 107},
                                     {150, 40, 40},
                                     {92, 58, 140},
                                     {86, 86, 30}}};
  // By number, and by stage: the timeline's stretches.
  std::array<Colour, 10> labels{{{206, 202, 190},
                                 {213, 94, 0},
                                 {230, 159, 0},
                                 {0, 114, 178},
                                 {86, 180, 233},
                                 {0, 158, 115},
                                 {204, 121, 167},
                                 {240, 128, 128},
                                 {176, 144, 224},
                                 {240, 228, 66}}};
  std::array<Colour, 9> stages{{{96, 102, 112},
                                {104, 92, 160},
                                {64, 128, 148},
                                {0, 158, 115},
                                {70, 130, 180},
                                {204, 121, 167},
                                {200, 180, 110},
                                {140, 150, 160},
                                {96, 102, 112}}};
  // The pinned run's line in a plot, beside the current one's in accent, its numbers and its words.
  Colour pinned{240, 150, 206};

  [[nodiscard]] constexpr Colour of(knit::Label label) const {
    return labels[static_cast<std::size_t>(label)];
  }
  [[nodiscard]] constexpr Colour ink_of(knit::Label label) const {
    return label_inks[static_cast<std::size_t>(label)];
  }
  [[nodiscard]] constexpr Colour symbol_on(knit::Label label) const {
    return label == knit::Label::k2tog ? pale_symbol : symbol;
  }
  [[nodiscard]] constexpr Colour of(knit::Stage stage) const {
    return stages[static_cast<std::size_t>(stage)];
  }
};

inline constexpr Theme dark_theme{};

constexpr Theme make_light_theme() {
  Theme theme;
  theme.background = {243, 242, 239};
  theme.ground = {186, 190, 198};
  // Paler, so that dark points and lines stand out on it.
  theme.time_low = {152, 140, 208};
  theme.time_middle = {114, 184, 182};
  theme.time_high = {238, 224, 132};
  theme.isoline = {20, 24, 32, 90};
  theme.ring = {96, 102, 114};
  theme.too_near = {118, 124, 136};
  theme.too_far = {150, 84, 58};
  theme.accepted = {14, 16, 20};
  theme.anchor = {176, 84, 0};
  theme.band = {214, 120, 0, 190};
  theme.selected = {0, 128, 48};
  theme.stitch = {52, 50, 46};
  theme.row_edge = {84, 80, 72};
  theme.column_edge = {60, 62, 68};
  theme.ghost = {62, 92, 140, 150};
  theme.pinned = {164, 28, 116};
  theme.problem = {190, 44, 28};
  theme.break_hit = {110, 70, 190};
  theme.one_side = {184, 62, 0};
  theme.other_side = {0, 84, 176};
  theme.stretch_short = {0, 84, 176};
  theme.stretch_even = {132, 138, 148};
  theme.stretch_long = {184, 62, 0};
  theme.text = {28, 31, 36};
  theme.faint_text = {90, 96, 106};
  theme.panel = {252, 251, 249};
  theme.raised = {234, 234, 232};
  theme.hovered = {220, 222, 224};
  theme.pressed = {202, 206, 212};
  theme.outline = {212, 212, 210};
  theme.accent = {28, 104, 178};
  theme.on_accent = {255, 255, 255};
  theme.warning = {150, 92, 0};
  theme.stage_ahead = 70;
  theme.stage_done = 190;
  return theme;
}
inline constexpr Theme light_theme = make_light_theme();

constexpr const Theme& theme_of(ThemeKind kind) {
  return kind == ThemeKind::light ? light_theme : dark_theme;
}

}  // namespace app
