#include "app/describe/describe_symbols.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/describe/chart_strokes.h"
#include "app/describe/describe_step.h"
#include "app/describe/describe_stretch.h"
#include "app/describe/state_shown.h"
#include "app/describe/thing_places.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr int bend_parts = 4;
constexpr float stroke_px = 2.0F;

std::optional<knit::ChartSymbol> symbol_of(knit::Label label) {
  switch (label) {
    case knit::Label::m1r:
      return knit::ChartSymbol::m1r;
    case knit::Label::m1l:
      return knit::ChartSymbol::m1l;
    case knit::Label::k2tog:
      return knit::ChartSymbol::k2tog;
    case knit::Label::ssk:
      return knit::ChartSymbol::ssk;
    default:
      return std::nullopt;  // a blank square in the chart
  }
}

// A face as a square on the surface, as the knitter sees it from outside.
struct Square {
  glm::vec3 centre, right, up;  // half sides
  [[nodiscard]] glm::vec3 at(const ChartPoint& p) const {
    return centre + (2.0F * static_cast<float>(p.x) - 1.0F) * right -
           (2.0F * static_cast<float>(p.y) - 1.0F) * up;
  }
};

std::optional<Square> square_of(const knit::Face& face, knit::RowId row_above,
                                const knit::KnittingPath& path) {
  glm::vec3 low(0.0F);
  glm::vec3 high(0.0F);
  float lows = 0.0F;
  float highs = 0.0F;
  for (std::int32_t i = 0; i < face.corner_count; ++i) {
    const std::uint32_t number = face.corners[static_cast<std::size_t>(i)];
    const bool lower = path.at(number).row != row_above;
    (lower ? low : high) += place_on(path, number);
    (lower ? lows : highs) += 1.0F;
  }
  if (lows == 0.0F || highs == 0.0F) return std::nullopt;
  low /= lows;
  high /= highs;
  const glm::vec3 a = place_on(path, face.corners[0]);
  const glm::vec3 normal =
      glm::cross(place_on(path, face.corners[1]) - a, place_on(path, face.corners[2]) - a);
  const glm::vec3 up = high - low;
  const glm::vec3 right = glm::cross(up, normal);
  const float height = glm::length(up);
  if (height <= 0.0F || glm::length(right) <= 0.0F) return std::nullopt;
  // A triangle has less room beside its middle.
  const float half = (face.corner_count == 4 ? 0.36F : 0.26F) * height;
  return Square{0.5F * (low + high), half * glm::normalize(right), half * up / height};
}

void draw(const Square& square, std::span<const ChartStroke> strokes, Colour colour,
          std::vector<Line>& lines) {
  for (const ChartStroke& stroke : strokes) {
    const int parts = stroke.bend ? bend_parts : 1;
    glm::vec3 from = square.at(stroke.from);
    for (int i = 1; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      const ChartPoint bend = stroke.bend.value_or(
          ChartPoint{0.5 * (stroke.from.x + stroke.to.x), 0.5 * (stroke.from.y + stroke.to.y)});
      const auto along = [&](double a, double b, double c) {
        return (1.0 - t) * (1.0 - t) * a + 2.0 * t * (1.0 - t) * b + t * t * c;
      };
      const glm::vec3 to =
          square.at({along(stroke.from.x, bend.x, stroke.to.x), along(stroke.from.y, bend.y, stroke.to.y)});
      lines.push_back({from, to, colour, stroke_px});
      from = to;
    }
  }
}

// On the screen, about the middle of what is looked at.
double stitch_px(const Session& session, double height_px) {
  const Camera& camera = session.view->gaze.camera;
  const double radius = session.document->timeline.input().bounds.radius;
  const double distance = std::max(camera.distance - radius, 0.2 * camera.distance);
  return session.document->timeline.parameters().stitch.width * height_px /
         (2.0 * distance * std::tan(0.5 * camera.field_of_view));
}

}  // namespace

void Symbols::describe(const Session& session, double height_px, Scene& scene) {
  if (!session.view->shows(Layer::faces) || scene.coarse > 1 || stretch_shown(session)) return;
  const double size_px = stitch_px(session, height_px);
  const double share = (size_px - symbol_first_px) / (symbol_full_px - symbol_first_px);
  if (share <= 0.0) return;
  const auto alpha = static_cast<std::uint8_t>(std::lround(255.0 * std::min(share, 1.0)));
  const StateShown state(session);
  std::vector<Line> lines;
  const knit::KnittingPath path(state->fabric);
  for (const MadeStrip& strip : made_strips(*state)) {
    for (const knit::Face& face : strip.faces) {
      const auto symbol = symbol_of(face.label);
      const auto square = symbol ? square_of(face, strip.row, path) : std::nullopt;
      const Colour ink = with_alpha(scene.theme->symbol_on(face.label), alpha);
      if (square) draw(*square, shape_of(*symbol).strokes, ink, lines);
    }
  }
  // Among what is finished: those of the far side do not shine through.
  if (lines.empty()) return;
  if (lines_ == nullptr || *lines_ != lines)
    lines_ = std::make_shared<const std::vector<Line>>(std::move(lines));
  scene.line_sets.push_back(lines_);
}

}  // namespace app
