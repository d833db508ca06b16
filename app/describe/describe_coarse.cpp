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

// Of so many stitches.
std::size_t cells_of(std::size_t n, int stride) {
  return std::max<std::size_t>(3, n / static_cast<std::size_t>(stride));
}

// The i-th of `cells` places along a row or a loop.
glm::vec3 place_of(const std::vector<knit::Stitch>& stitches, std::size_t i, std::size_t cells) {
  return glm::vec3(stitches[i * stitches.size() / cells].position);
}

std::shared_ptr<const std::vector<Line>> edges_of(const Theme& theme, const knit::Row& row,
                                                  const CoarseLook& look) {
  std::vector<Line> lines;
  const std::size_t cells = cells_of(row.stitches.size(), look.stride);
  for (const auto& [from, to] : knit::Edges(cells, row.closed)) {
    lines.push_back(
        {place_of(row.stitches, from, cells), place_of(row.stitches, to, cells), theme.row_edge, 1.0F});
  }
  const double merged = static_cast<double>(row.stitches.size()) / static_cast<double>(cells);
  if (look.stretch) colour_by_stretch(theme, merged * look.stretch->width, look.stretch->full, lines);
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

FaceShape faces_of(const Theme& theme, const std::vector<knit::Stitch>& below, const knit::Row& above,
                   const knit::Strip& strip, int stride) {
  FaceShape shape;
  const std::size_t cells = cells_of(std::max(below.size(), above.stitches.size()), stride);
  const std::vector<knit::Label> labels = labels_of(strip, cells);
  shape.faces.reserve(cells);
  for (const auto& [i, next] : knit::Edges(cells, above.closed)) {
    const glm::vec3 a = place_of(below, i, cells);
    const glm::vec3 b = place_of(below, next, cells);
    const glm::vec3 c = place_of(above.stitches, next, cells);
    const glm::vec3 d = place_of(above.stitches, i, cells);
    const glm::vec3 across = glm::cross(c - a, d - b);
    const float length = glm::length(across);
    const glm::vec3 normal = length > 0.0F ? across / length : glm::vec3(0, 1, 0);
    shape.faces.push_back({{a, b, c, d}, normal, theme.of(labels[i])});
  }
  return shape;
}

// By how high they are, `height` being at ease; corners 1 and 2 stand over each other.
void colour_by_height(const Theme& theme, double height, FaceShape& shape) {
  for (FaceShape::Face& face : shape.faces) {
    const double high = static_cast<double>(glm::distance(face.corners[1], face.corners[2]));
    face.colour = stretch_colour(theme, high / height);
  }
}

std::vector<std::shared_ptr<const void>> about(const knit::Fabric& fabric, knit::RowId low,
                                               knit::RowId high) {
  std::vector<std::shared_ptr<const void>> products;
  if (high > 0) products = fabric.products_about(high);
  if (low > 0) products.push_back(fabric.shared_row(low).pointer());
  if (high > 0) products.push_back(fabric.shared_strip(low > 0 ? low + 1 : high).pointer());
  return products;
}

}  // namespace

// Along each chain of rows that stand on each other; the last row of one has no faces of its own above it.
std::vector<Coarse::Band> Coarse::bands_of(const knit::Fabric& fabric, int stride) {
  std::vector<Band> bands;
  const knit::RowId reach = fabric.strips().empty() ? 0 : fabric.strips().back()->to;
  for (knit::RowId first = 1, last = 0; first <= fabric.row_count(); first = last + 1) {
    for (last = first; fabric.continues(last + 1);) ++last;
    if (!fabric.row(first).on.empty() && first <= reach) bands.push_back({0, first});
    for (knit::RowId low = first; low < last; low += stride) {
      const knit::RowId high = std::min({low + stride, last, reach});
      bands.push_back({low, high > low ? high : 0});
    }
    bands.push_back({last, 0});
  }
  return bands;
}

void Coarse::make(const knit::Fabric& fabric, const Band& band, Kept& kept) const {
  if (band.low > 0 && kept.edges == nullptr) kept.edges = edges_of(*theme_, *kept.below, look_);
  if (kept.above == nullptr) return;
  const knit::Strip& strip = *fabric.strip_into(band.low > 0 ? band.low + 1 : band.high);
  const std::vector<knit::Stitch> below =
      kept.below != nullptr ? kept.below->stitches : fabric.stitches_of(kept.above->on);
  FaceShape faces = faces_of(*theme_, below, *kept.above, strip, look_.stride);
  const double rows = band.low > 0 ? band.high - band.low : 1;
  if (look_.stretch) colour_by_height(*theme_, rows * look_.stretch->height, faces);
  kept.faces = std::make_shared<const FaceShape>(std::move(faces));
}

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

void Coarse::describe(const Session& session, const knit::Fabric& fabric, const CoarseLook& look,
                      bool in_pieces, Scene& scene) {
  if (theme_ != scene.theme || look_ != look) kept_.clear();
  theme_ = scene.theme;
  look_ = look;
  const std::vector<Band> bands = bands_of(fabric, look.stride);
  std::size_t made = 0;  // cells
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (i == kept_.size()) kept_.emplace_back();
    Kept& kept = kept_[i];
    const auto row_at = [&](knit::RowId id) { return id > 0 ? fabric.shared_row(id).pointer() : nullptr; };
    const auto below = row_at(bands[i].low), above = row_at(bands[i].high);
    auto parts = about(fabric, bands[i].low, bands[i].high);
    if (kept.below != below || kept.above != above || kept.about != parts) {
      if (in_pieces && made > cells_a_frame) {
        scene.unfinished = true;
        return;
      }
      made += 2 * cells_of((below ? below : above)->stitches.size(), look.stride);
      kept = {below, above, std::move(parts), below == kept.below ? kept.edges : nullptr, nullptr};
      make(fabric, bands[i], kept);
    }
    if (session.view->shows(Layer::row_edges) && kept.edges) scene.line_sets.push_back(kept.edges);
    if (session.view->shows(Layer::faces) && kept.faces) scene.faces.push_back(kept.faces);
  }
}

}  // namespace app
