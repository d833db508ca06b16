#include "app/panels/chart_drawing.h"

#include "app/panels/style.h"

namespace app {

namespace {

constexpr Colour paper{238, 235, 226};
constexpr Colour main_paper{240, 214, 228};
constexpr Colour lit_paper{255, 247, 190};
constexpr Colour absent{58, 64, 73};
constexpr Colour ink{34, 37, 43};

knit::Label label_of(knit::ChartSymbol symbol) {
  switch (symbol) {
    case knit::ChartSymbol::m1r:
      return knit::Label::m1r;
    case knit::ChartSymbol::m1l:
      return knit::Label::m1l;
    case knit::ChartSymbol::k2tog:
      return knit::Label::k2tog;
    case knit::ChartSymbol::ssk:
      return knit::Label::ssk;
    case knit::ChartSymbol::cast_on:
    case knit::ChartSymbol::bind_off:
      return knit::Label::cast;
    case knit::ChartSymbol::no_stitch:
    case knit::ChartSymbol::knit:
      break;
  }
  return knit::Label::knit;
}

Colour ground_of(const knit::ChartSquare& square, bool lit) {
  if (square.symbol == knit::ChartSymbol::no_stitch) return absent;
  if (lit) return lit_paper;
  return square.main ? main_paper : paper;
}

// Places within the square, from the upper left corner, as shares of its side.
struct Pen {
  ImDrawList& list;
  ImVec2 low;
  float side;
  ImU32 colour;
  void line(float x0, float y0, float x1, float y1) const {
    const auto at = [&](float x, float y) { return ImVec2(low.x + x * side, low.y + y * side); };
    list.AddLine(at(x0, y0), at(x1, y1), colour, 0.1f * side + 0.6f);
  }
};

void draw_symbol(const Pen& pen, knit::ChartSymbol symbol) {
  switch (symbol) {
    case knit::ChartSymbol::k2tog:
      return pen.line(0.2f, 0.8f, 0.8f, 0.2f);
    case knit::ChartSymbol::ssk:
      return pen.line(0.2f, 0.2f, 0.8f, 0.8f);
    case knit::ChartSymbol::m1r:
      pen.line(0.3f, 0.82f, 0.7f, 0.18f);
      return pen.line(0.5f, 0.5f, 0.22f, 0.25f);
    case knit::ChartSymbol::m1l:
      pen.line(0.7f, 0.82f, 0.3f, 0.18f);
      return pen.line(0.5f, 0.5f, 0.78f, 0.25f);
    case knit::ChartSymbol::cast_on:
      return pen.line(0.2f, 0.82f, 0.8f, 0.82f);
    case knit::ChartSymbol::bind_off:
      return pen.line(0.2f, 0.2f, 0.8f, 0.2f);
    case knit::ChartSymbol::no_stitch:
    case knit::ChartSymbol::knit:
      break;
  }
}

}  // namespace

void draw_square(ImDrawList& list, ImVec2 low, const knit::ChartSquare& square, const SquareLook& look) {
  const float gap = look.side >= 5.0f ? 1.0f : 0.0f;
  const ImVec2 high(low.x + look.side - gap, low.y + look.side - gap);
  list.AddRectFilled(low, high, style::packed(ground_of(square, look.lit)));
  if (look.side >= 5.0f) {
    const knit::Label label = label_of(square.symbol);
    const Colour colour = label == knit::Label::knit ? ink : palette::of(label);
    draw_symbol({list, low, look.side - gap, style::packed(colour)}, square.symbol);
  } else if (label_of(square.symbol) != knit::Label::knit) {
    list.AddRectFilled(low, high, style::packed(palette::of(label_of(square.symbol))));
  }
  if (look.hovered) list.AddRect(low, high, style::packed(style::accent), 0.0f, 0, 2.0f);
}

const char* name_of(knit::ChartSymbol symbol) {
  switch (symbol) {
    case knit::ChartSymbol::no_stitch:
      return "no stitch";
    case knit::ChartSymbol::knit:
      return "knit";
    case knit::ChartSymbol::m1r:
      return "m1r: make one right";
    case knit::ChartSymbol::m1l:
      return "m1l: make one left";
    case knit::ChartSymbol::k2tog:
      return "k2tog: knit two together";
    case knit::ChartSymbol::ssk:
      return "ssk: slip, slip, knit";
    case knit::ChartSymbol::cast_on:
      return "cast on";
    case knit::ChartSymbol::bind_off:
      return "bind off";
  }
  return "";
}

}  // namespace app
