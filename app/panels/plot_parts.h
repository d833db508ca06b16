// What every plot stands on: its ground, the axis below, words around. For the files that draw plots.
#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "app/panels/panels.h"
#include "app/panels/style.h"

namespace app::plot_parts {

inline Colour bar() { return theme().accent; }

// One plot on the screen: the title above, the ground that values are drawn on, the axis below.
struct Stand {
  ImDrawList& list;
  float left;  // of the title
  Box ground;
  float line;      // of its thin lines
  float axis_top;  // of the words below
  bool clicked;
  bool hovered;  // long enough for a tooltip
  bool inside;   // the pointer is over the ground, hovered or clicking
};

// Takes the item's room and draws title and ground; `gutter` is left free beside the ground for words.
Stand begin_stand(PanelFrame& frame, const std::string& name, const std::string& title, ImVec2 size,
                  float gutter);
// The axis itself comes last, over the feet of what stands on it.
void draw_foot(const Stand& stand);
// Instead of values.
void draw_missing(const PanelFrame& frame, const Stand& stand, const std::string& words,
                  const std::string& help);

// Whole units, so that thin lines are as wide everywhere.
float whole(float x);
void fill(const Stand& stand, float x0, float y0, float x1, float y1, ImU32 colour);

// Words below the axis. Those given first are drawn first, and what would touch them is left out.
struct AxisWord {
  float x;
  float align;
  std::string words;
  Colour colour = theme().faint_text;
};
void draw_axis_words(const PanelFrame& frame, const Stand& stand, std::span<const AxisWord> words);

// Words at the right end of the title's line: in the colour of what they speak of, or with a line of it before
// them.
struct Key {
  std::string words;
  Colour colour;
  bool line;
};
// Gives where they begin, so that the next stand before them. Left out where they would touch the title.
float draw_key(const PanelFrame& frame, const Stand& stand, const std::string& title, float right,
               const Key& key);

}  // namespace app::plot_parts
