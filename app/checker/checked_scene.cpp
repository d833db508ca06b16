#include "app/checker/checked_scene.h"

#include <glm/geometric.hpp>
#include <utility>

namespace app {

namespace {

constexpr float plain_px = 1.2F, told_px = 2.6F, lit_px = 4.0F;

knit::LineVerdict verdict_of(const knit::CheckedSize& size, std::size_t number) {
  const knit::CheckedLine* line = line_numbered(size, number);
  return line != nullptr ? line->verdict : knit::LineVerdict::holds;
}

// A plain ring is no mark.
Line look_of(const Theme& theme, knit::LineVerdict verdict) {
  Line line;
  line.width_px = told_px;
  if (verdict == knit::LineVerdict::does_not_add_up) {
    line.colour = theme.problem;
  } else if (verdict == knit::LineVerdict::not_understood || verdict == knit::LineVerdict::not_claimed) {
    line.colour = theme.warning;
  } else {
    line.colour = theme.column_edge;
    line.width_px = plain_px;
  }
  return line;
}

void add_round(const PlacedPiece& piece, const PlacedRound& round, const Line& look,
               std::vector<Line>& lines) {
  const auto corners = corners_of(piece, round);
  const std::size_t edges = piece.flat ? 1 : corners.size();
  for (std::size_t i = 0; i < edges; ++i)
    lines.push_back(
        {glm::vec3(corners[i]), glm::vec3(corners[(i + 1) % corners.size()]), look.colour, look.width_px});
}

void add_band(const PlacedPiece& piece, const PlacedRound& low, const PlacedRound& high, Colour colour,
              FaceShape& shape) {
  const auto below = corners_of(piece, low);
  const auto above = corners_of(piece, high);
  const std::size_t faces = piece.flat ? 1 : below.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const std::size_t next = (i + 1) % below.size();
    // Where two corners are one, as at a closed end, the other diagonal says which way it looks.
    const glm::dvec3 across = glm::cross(below[next] - above[i], above[next] - below[i]);
    const double length = glm::length(across);
    if (length <= 0.0) continue;
    shape.faces.push_back(
        {{glm::vec3(below[i]), glm::vec3(below[next]), glm::vec3(above[next]), glm::vec3(above[i])},
         glm::vec3(across / length),
         colour});
  }
}

}  // namespace

void CheckedScene::make(const Checker& checker, const Theme& theme) {
  checked_ = checker.checked;
  size_ = checker.size;
  gauge_ = checker.gauge;
  theme_ = &theme;
  faces_.clear();
  lines_.clear();
  const knit::CheckedSize* size = checker.shown();
  shape_ = size != nullptr ? shape_of(*size, gauge_) : CheckedShape{};
  const std::size_t stride = stride_of(shape_);
  for (const PlacedPiece& piece : shape_.pieces) {
    FaceShape faces;
    std::vector<Line> lines;
    const std::size_t last = piece.rounds.size() - 1;
    std::size_t before = 0;
    for (std::size_t i = 0; i <= last; ++i) {
      const Line look = look_of(theme, verdict_of(*size, piece.rounds[i].line));
      const bool drawn = i % stride == 0 || i == last;
      if (drawn || look.width_px > plain_px) add_round(piece, piece.rounds[i], look, lines);
      if (drawn && i > 0)
        add_band(piece, piece.rounds[before], piece.rounds[i], theme.of(knit::Label::knit), faces);
      if (drawn) before = i;
    }
    faces_.push_back(std::make_shared<const FaceShape>(std::move(faces)));
    lines_.push_back(std::make_shared<const std::vector<Line>>(std::move(lines)));
  }
}

void CheckedScene::describe(const Checker& checker, double aspect, Scene& scene) {
  if (checked_ != checker.checked || size_ != checker.size || gauge_ != checker.gauge ||
      theme_ != scene.theme)
    make(checker, *scene.theme);
  scene.view = checker.camera.view(aspect);
  scene.faces = faces_;
  scene.line_sets = lines_;
  for (const PlacedPiece& piece : shape_.pieces) {
    for (const PlacedRound& round : piece.rounds) {
      if (round.line != checker.caret.line) continue;
      Line look;
      look.colour = scene.theme->selected;
      look.width_px = lit_px;
      add_round(piece, round, look, scene.lines);
    }
    if (piece.name.empty()) continue;
    const double above = piece.rounds.back().height + 0.04 * shape_.bounds.radius;
    scene.captions.push_back(
        {glm::vec3(piece.middle - 0.5 * piece.half, above, 0.0), piece.name, scene.theme->text});
  }
}

}  // namespace app
