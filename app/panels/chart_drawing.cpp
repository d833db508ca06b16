#include "app/panels/chart_drawing.h"

#include "app/core/chart_strokes.h"
#include "app/panels/style.h"

namespace app {

namespace {

constexpr Colour paper{238, 235, 226};
constexpr Colour main_paper{240, 214, 228};
constexpr Colour lit_paper{255, 247, 190};
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
  if (square.symbol == knit::ChartSymbol::no_stitch) return theme().hovered;
  if (lit) return lit_paper;
  return square.main ? main_paper : paper;
}

// Strokes that go on one from another are one line.
void draw_symbol(ImDrawList& list, ImVec2 low, float side, ImU32 colour, knit::ChartSymbol symbol) {
  const auto at = [&](const ChartPoint& point) {
    return ImVec2(low.x + static_cast<float>(point.x) * side, low.y + static_cast<float>(point.y) * side);
  };
  const std::span<const ChartStroke> strokes = shape_of(symbol).strokes;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const ChartStroke& stroke = strokes[i];
    if (i == 0 || strokes[i - 1].to != stroke.from) list.PathLineTo(at(stroke.from));
    if (stroke.bend) {
      list.PathBezierQuadraticCurveTo(at(*stroke.bend), at(stroke.to));
    } else {
      list.PathLineTo(at(stroke.to));
    }
    if (i + 1 == strokes.size() || strokes[i + 1].from != stroke.to)
      list.PathStroke(colour, ImDrawFlags_None, 0.1f * side + 0.6f);
  }
}

}  // namespace

void draw_square(ImDrawList& list, ImVec2 low, const knit::ChartSquare& square, const SquareLook& look) {
  const float gap = look.side >= 5.0f ? 1.0f : 0.0f;
  const ImVec2 high(low.x + look.side - gap, low.y + look.side - gap);
  // The lines between squares: the ground alone would not part pale squares in the light theme.
  if (gap > 0.0f)
    list.AddRectFilled(low, ImVec2(low.x + look.side, low.y + look.side), style::packed(theme().outline));
  list.AddRectFilled(low, high, style::packed(ground_of(square, look.lit)));
  if (look.side >= 5.0f) {
    const knit::Label label = label_of(square.symbol);
    const Colour colour = label == knit::Label::knit ? ink : theme().of(label);
    draw_symbol(list, low, look.side - gap, style::packed(colour), square.symbol);
  } else if (label_of(square.symbol) != knit::Label::knit) {
    list.AddRectFilled(low, high, style::packed(theme().of(label_of(square.symbol))));
  }
  if (look.hovered) list.AddRect(low, high, style::packed(theme().accent), 0.0f, 0, 2.0f);
}

}  // namespace app
