#include "app/describe/describe_ghost.h"

#include <algorithm>

#include "app/describe/describe_step.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr float thin_px = 1.0F;

std::shared_ptr<const std::vector<Line>> row_lines(const Theme& theme, const knit::Row& row) {
  std::vector<Line> lines;
  for (const auto& [from, to] : knit::edges_of(row)) {
    lines.push_back(
        {glm::vec3(row.stitches[from].position), glm::vec3(row.stitches[to].position), theme.ghost, thin_px});
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

std::shared_ptr<const std::vector<Line>> column_lines(const Theme& theme, const knit::Strip& strip,
                                                      const knit::KnittingPath& path) {
  std::vector<Line> lines = columns_of(theme, strip, strip.column_edges.size(), path);
  for (Line& line : lines) {
    line.colour = theme.ghost;
    line.width_px = thin_px;
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

// Whether the current run has this row, stitch by stitch.
bool has_row(const knit::Fabric& here, const knit::Fabric& pinned, knit::RowId id) {
  if (!here.has_row(id)) return false;
  return here.shared_row(id) == pinned.shared_row(id) || here.row(id).stitches == pinned.row(id).stitches;
}

// The same, and all that it hangs on by the same columns.
bool has_columns(const knit::Fabric& here, const knit::Fabric& pinned, knit::RowId id) {
  const knit::Strip* strip = here.strip_into(id);
  const knit::Join* join = here.join_into(id);
  if (strip == nullptr || join == nullptr || !has_row(here, pinned, id)) return false;
  const auto& on = here.row(id).on.spans;
  const bool same_below = std::all_of(
      on.begin(), on.end(), [&](const knit::StitchSpan& span) { return has_row(here, pinned, span.row); });
  return same_below && strip->column_edges.size() == pinned.strip_into(id)->column_edges.size() &&
         *join == *pinned.join_into(id);
}

}  // namespace

void Ghost::refresh(const Session& session, const Theme& theme, const Pin& pin) {
  const auto here = session.document->timeline.input_pointer();
  if (here != here_ || pin.input != input_) same_mesh_ = is_of_this_mesh(session, pin);
  const std::uint64_t end = knit::hash_of(pin.end);
  const bool same_run = end == end_ && pin.input == input_ && theme_ == &theme;
  theme_ = &theme;
  here_ = here;
  input_ = pin.input;
  end_ = end;
  if (same_run) return;
  rows_.clear();
  const knit::KnittingPath path(pin.end.fabric);
  for (const auto& row : pin.end.fabric.rows()) {
    const knit::Strip* strip = pin.end.fabric.strip_into(row->id);
    rows_.push_back({row->id, row_lines(theme, *row), strip ? column_lines(theme, *strip, path) : nullptr});
  }
}

void Ghost::describe(const Session& session, Scene& scene) {
  if (!session.document->pinned || !session.document->pinned->known) {
    *this = Ghost();
    return;
  }
  const Pin& pin = *session.document->pinned;
  refresh(session, *scene.theme, pin);
  if (!same_mesh_) return;
  const knit::Fabric& here = session.document->timeline.furthest().fabric;
  for (const RowLines& row : rows_) {
    if (session.view->shows(Layer::row_edges) && !has_row(here, pin.end.fabric, row.id))
      scene.line_sets.push_back(row.edges);
    if (row.columns && session.view->shows(Layer::column_edges) && !has_columns(here, pin.end.fabric, row.id))
      scene.line_sets.push_back(row.columns);
  }
}

}  // namespace app
