#include "app/describe/describe_ghost.h"

#include <algorithm>

#include "app/describe/describe_step.h"
#include "app/describe/thing_places.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

using Lines = std::shared_ptr<const std::vector<Line>>;

constexpr float thin_px = 1.0F;

Lines row_lines(const Theme& theme, const knit::Row& row) {
  std::vector<Line> lines;
  for (const auto& [from, to] : knit::edges_of(row)) {
    lines.push_back(
        {glm::vec3(row.stitches[from].position), glm::vec3(row.stitches[to].position), theme.ghost, thin_px});
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

Lines column_lines(const Theme& theme, const knit::Strip& strip, const knit::KnittingPath& path) {
  std::vector<Line> lines = columns_of(theme, strip, strip.column_edges.size(), path);
  for (Line& line : lines) {
    line.colour = theme.ghost;
    line.width_px = thin_px;
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

const knit::Deal* deal_at(const knit::Fabric& fabric, knit::RowId bridge) {
  const auto number = static_cast<std::size_t>(-bridge);
  return number <= fabric.deals().size() ? &*fabric.deals()[number - 1] : nullptr;
}

// Whether the current run has this row, or bridge, stitch by stitch.
bool has_row(const knit::Fabric& here, const knit::Fabric& pinned, knit::RowId id) {
  if (id < 0) {
    const knit::Deal* deal = deal_at(here, id);
    return deal != nullptr && deal->bridge == deal_at(pinned, id)->bridge;
  }
  if (!here.has_row(id)) return false;
  return here.shared_row(id) == pinned.shared_row(id) || here.row(id).stitches == pinned.row(id).stitches;
}

bool has_all(const knit::Fabric& here, const knit::Fabric& pinned,
             const std::vector<knit::LiveStitches>& loops) {
  return std::all_of(loops.begin(), loops.end(), [&](const knit::LiveStitches& loop) {
    return std::all_of(loop.spans.begin(), loop.spans.end(),
                       [&](const knit::StitchSpan& span) { return has_row(here, pinned, span.row); });
  });
}

// The same deal of stitches at the same places: its edges and its strip are the same.
bool has_deal(const knit::Fabric& here, const knit::Fabric& pinned, knit::RowId id) {
  const knit::Deal* mine = deal_at(here, id);
  const knit::Deal& theirs = *deal_at(pinned, id);
  return mine != nullptr && *mine == theirs && has_all(here, pinned, theirs.taken) &&
         has_all(here, pinned, theirs.given);
}

// The same, and all that it hangs on by the same columns.
bool has_columns(const knit::Fabric& here, const knit::Fabric& pinned, knit::RowId id) {
  const knit::Strip* strip = here.strip_into(id);
  const knit::Join* join = here.join_into(id);
  if (strip == nullptr || join == nullptr || !has_row(here, pinned, id)) return false;
  return has_all(here, pinned, {here.row(id).on}) &&
         strip->column_edges.size() == pinned.strip_into(id)->column_edges.size() &&
         *join == *pinned.join_into(id);
}

Lines deal_lines(const Theme& theme, const knit::Fabric& fabric, const knit::Deal& deal) {
  std::vector<Line> lines;
  for (const auto& [from, to] : edges_added(deal))
    lines.push_back({glm::vec3(fabric.position(from)), glm::vec3(fabric.position(to)), theme.ghost, thin_px});
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

}  // namespace

void Ghost::refresh(const Session& session, const Theme& theme, const Pin& pin) {
  const auto here = session.document->timeline.input_pointer();
  if (here != here_ || pin.input != input_) same_mesh_ = is_of_this_mesh(session, pin);
  const std::uint64_t end = knit::hash_of(pin.end);
  const Positions positions = session.view->positions;
  const bool same_run = end == end_ && pin.input == input_ && theme_ == &theme && positions == positions_;
  positions_ = positions;
  theme_ = &theme;
  here_ = here;
  input_ = pin.input;
  end_ = end;
  if (same_run) return;
  rows_.clear();
  const auto in_the_air = positions == Positions::relaxed ? knit::relaxed_places(pin.end) : nullptr;
  const knit::Fabric fabric = in_the_air                       ? pin.end.fabric.moved_to(*in_the_air)
                              : positions == Positions::placed ? knit::placed_fabric(pin.end)
                                                               : pin.end.fabric;
  const knit::KnittingPath path(fabric);
  for (const auto& row : fabric.rows()) {
    const knit::Strip* strip = fabric.strip_into(row->id);
    rows_.push_back({row->id, row_lines(theme, *row), strip ? column_lines(theme, *strip, path) : nullptr});
  }
  const auto& deals = fabric.deals();
  for (std::size_t i = 0; i < deals.size(); ++i) {
    const auto id = knit::bridge_row(static_cast<std::int32_t>(i) + 1);
    const bool ring = !deals[i]->column_edges.empty() && is_sewn(fabric, *deals[i]);
    rows_.push_back({id, deal_lines(theme, fabric, *deals[i]),
                     ring ? column_lines(theme, strip_of(*deals[i]), path) : nullptr});
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
    const bool deal = row.id < 0;
    const bool same_edges =
        deal ? has_deal(here, pin.end.fabric, row.id) : has_row(here, pin.end.fabric, row.id);
    if (session.view->shows(Layer::row_edges) && !same_edges) scene.line_sets.push_back(row.edges);
    if (!row.columns || !session.view->shows(Layer::column_edges)) continue;
    const bool same_columns = deal ? same_edges : has_columns(here, pin.end.fabric, row.id);
    if (!same_columns) scene.line_sets.push_back(row.columns);
  }
}

}  // namespace app
