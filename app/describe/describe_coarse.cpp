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

std::size_t cells_of(const knit::Row& row, int stride) {
  const std::size_t n = row.stitches.size();
  return std::max<std::size_t>(3, n / static_cast<std::size_t>(stride));
}

// The i-th of `cells` places along a row.
glm::vec3 place_of(const knit::Row& row, std::size_t i, std::size_t cells) {
  const std::size_t n = row.stitches.size();
  return glm::vec3(row.stitches[i * n / cells].position);
}

std::shared_ptr<const std::vector<Line>> edges_of(const knit::Row& row, int stride, Colour colour) {
  std::vector<Line> lines;
  const std::size_t cells = cells_of(row, stride);
  for (const auto& [from, to] : knit::Edges(cells, row.closed))
    lines.push_back({place_of(row, from, cells), place_of(row, to, cells), colour, 1.0F});
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
  for (const auto& [i, next] : knit::Edges(cells, above.closed)) {
    const glm::vec3 a = place_of(below, i, cells);
    const glm::vec3 b = place_of(below, next, cells);
    const glm::vec3 c = place_of(above, next, cells);
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
  if (timeline.state().fabric.stitch_count() <= always_whole_stitches) return 1;
  const double radius = timeline.input().bounds.radius;
  const double distance =
      std::max(session.view->gaze.camera.distance - 0.5 * radius, 0.25 * session.view->gaze.camera.distance);
  const double unit_px =
      height_px / (2.0 * distance * std::tan(0.5 * session.view->gaze.camera.field_of_view));
  const double stitch_px = timeline.parameters().stitch.width * unit_px;
  const auto wide_enough = std::find_if(strides.begin(), strides.end(),
                                        [&](int stride) { return stride * stitch_px >= coarse_stitch_px; });
  return wide_enough != strides.end() ? *wide_enough : strides.back();
}

void Coarse::describe(const Session& session, int stride, bool in_pieces, Scene& scene) {
  if (theme_ != scene.theme || stride_ != stride) kept_.clear();
  theme_ = scene.theme;
  stride_ = stride;
  const knit::Fabric& fabric = session.document->timeline.state().fabric;
  const auto reach = std::min(fabric.row_count(), static_cast<knit::RowId>(fabric.strips().size()) + 1);
  std::size_t i = 0;
  std::size_t made = 0;  // cells
  for (knit::RowId low = 1; low <= fabric.row_count(); low += stride, ++i) {
    if (i == kept_.size()) kept_.emplace_back();
    Kept& kept = kept_[i];
    // Faces reach as far as strips are made.
    const knit::RowId high = std::min(low + stride, reach);
    const bool covered = high > low;
    const auto below = fabric.shared_row(low).pointer();
    const auto above = covered ? fabric.shared_row(high).pointer() : nullptr;
    const auto strip = covered ? fabric.shared_strip(low + 1).pointer() : nullptr;
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
  if (fabric.row_count() > 1 && session.view->shows(Layer::row_edges)) {
    const knit::Row& last = fabric.row(fabric.row_count());
    const auto lines = edges_of(last, stride, theme_->row_edge);
    scene.lines.insert(scene.lines.end(), lines->begin(), lines->end());
  }
}

}  // namespace app
