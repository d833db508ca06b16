#include "app/describe/describe_coarse.h"

#include "app/session/document.h"
#include "app/session/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace app {

namespace {

// Not every number, or each turn of the wheel would make all shapes anew.
constexpr std::array strides{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

std::size_t stitches_of(const knit::State& state) {
  std::size_t count = 0;
  for (const auto& row : state.rows) count += row->stitches.size();
  return count;
}

std::size_t cells_of(const knit::Row& row, int stride) {
  const std::size_t n = row.stitches.size();
  return std::max<std::size_t>(3, n / static_cast<std::size_t>(stride));
}

// The i-th of `cells` places along a row, round and round.
glm::vec3 place_of(const knit::Row& row, std::size_t i, std::size_t cells) {
  const std::size_t n = row.stitches.size();
  return glm::vec3(row.stitches[(i % cells) * n / cells].position);
}

std::shared_ptr<const std::vector<Line>> edges_of(const knit::Row& row, int stride, Colour colour) {
  std::vector<Line> lines;
  const std::size_t cells = cells_of(row, stride);
  for (std::size_t i = 0; i < cells; ++i)
    lines.push_back({place_of(row, i, cells), place_of(row, i + 1, cells), colour, 1.0F});
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

int weight_of(knit::Label label) { return knit::is_shaping(label) ? 2 : label == knit::Label::knit ? 0 : 1; }

// What a strip's faces say at each of `cells` places: what is rarer counts.
std::vector<knit::Label> labels_of(const knit::Strip& strip, std::size_t cells) {
  std::vector<knit::Label> labels(cells, knit::Label::knit);
  for (std::size_t i = 0; i < strip.faces.size(); ++i) {
    knit::Label& label = labels[i * cells / strip.faces.size()];
    if (weight_of(strip.faces[i].label) > weight_of(label)) label = strip.faces[i].label;
  }
  return labels;
}

std::shared_ptr<const FaceShape> faces_of(const Theme& theme, const knit::Row& below, const knit::Row& above,
                                          const knit::Strip& strip, int stride) {
  FaceShape shape;
  const std::size_t cells = std::max(cells_of(below, stride), cells_of(above, stride));
  const std::vector<knit::Label> labels = labels_of(strip, cells);
  shape.faces.reserve(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const glm::vec3 a = place_of(below, i, cells);
    const glm::vec3 b = place_of(below, i + 1, cells);
    const glm::vec3 c = place_of(above, i + 1, cells);
    const glm::vec3 d = place_of(above, i, cells);
    const glm::vec3 across = glm::cross(c - a, d - b);
    const float length = glm::length(across);
    const glm::vec3 normal = length > 0.0F ? across / length : glm::vec3(0, 1, 0);
    shape.faces.push_back({{a, b, c, d}, normal, theme.of(labels[i])});
  }
  return std::make_shared<const FaceShape>(std::move(shape));
}

}  // namespace

int coarseness(const Session& session, double height_px) {
  const knit::Timeline& timeline = session.document->timeline;
  if (stitches_of(timeline.state()) <= always_whole_stitches) return 1;
  const double radius = timeline.input().bounds.radius;
  const double distance =
      std::max(session.view->gaze.camera.distance - 0.5 * radius, 0.25 * session.view->gaze.camera.distance);
  const double unit_px =
      height_px / (2.0 * distance * std::tan(0.5 * session.view->gaze.camera.field_of_view));
  const double stitch_px = timeline.parameters().stitch_width * unit_px;
  const auto wide_enough = std::find_if(strides.begin(), strides.end(),
                                        [&](int stride) { return stride * stitch_px >= coarse_stitch_px; });
  return wide_enough != strides.end() ? *wide_enough : strides.back();
}

void Coarse::describe(const Session& session, int stride, bool in_pieces, Scene& scene) {
  if (theme_ != scene.theme || stride_ != stride) kept_.clear();
  theme_ = scene.theme;
  stride_ = stride;
  const knit::State& state = session.document->timeline.state();
  std::size_t i = 0;
  std::size_t made = 0;  // cells
  for (std::size_t low = 0; low < state.rows.size(); low += static_cast<std::size_t>(stride), ++i) {
    if (i == kept_.size()) kept_.emplace_back();
    Kept& kept = kept_[i];
    // Faces reach as far as strips are made.
    const std::size_t high =
        std::min({low + static_cast<std::size_t>(stride), state.rows.size() - 1, state.strips.size()});
    const bool covered = high > low;
    const auto below = state.rows[low].pointer();
    const auto above = covered ? state.rows[high].pointer() : nullptr;
    const auto strip = covered ? state.strips[low].pointer() : nullptr;
    const bool same_faces = !covered || (kept.above == above && kept.strip == strip);
    if (kept.below != below || !same_faces) {
      if (in_pieces && made > cells_a_frame) {
        scene.unfinished = true;
        return;
      }
      made += 2 * cells_of(*below, stride);
    }
    if (kept.below != below)
      kept = {below, nullptr, nullptr, edges_of(*below, stride, theme_->row_edge), nullptr};
    if (covered && (kept.above != above || kept.strip != strip)) {
      kept.above = above;
      kept.strip = strip;
      kept.faces = faces_of(*theme_, *below, *above, *strip, stride);
    }
    if (session.view->shows(Layer::row_edges)) scene.line_sets.push_back(kept.edges);
    if (session.view->shows(Layer::faces) && covered) scene.faces.push_back(kept.faces);
  }
  if (state.rows.size() > 1 && session.view->shows(Layer::row_edges)) {
    const knit::Row& last = *state.rows.back();
    const auto lines = edges_of(last, stride, theme_->row_edge);
    scene.lines.insert(scene.lines.end(), lines->begin(), lines->end());
  }
}

}  // namespace app
