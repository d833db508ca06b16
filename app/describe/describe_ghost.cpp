#include "app/describe/describe_ghost.h"

#include "app/describe/describe_step.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

namespace {

constexpr float thin_px = 1.0F;

std::shared_ptr<const std::vector<Line>> row_lines(const Theme& theme, const knit::Row& row) {
  std::vector<Line> lines;
  const std::size_t n = row.stitches.size();
  for (std::size_t i = 0; i < n; ++i) {
    lines.push_back({glm::vec3(row.stitches[i].position), glm::vec3(row.stitches[(i + 1) % n].position),
                     theme.ghost, thin_px});
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

std::shared_ptr<const std::vector<Line>> column_lines(const Theme& theme, const knit::State& state,
                                                      std::size_t strip) {
  const knit::Strip& made = *state.strips[strip];
  std::vector<Line> lines = columns_of(theme, made, made.column_edges.size(), places_of(state, strip));
  for (Line& line : lines) {
    line.colour = theme.ghost;
    line.width_px = thin_px;
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

// Whether the run at hand has this row, stitch by stitch.
bool has_row(const knit::State& here, const knit::State& pinned, std::size_t i) {
  if (i >= here.rows.size()) return false;
  return here.rows[i] == pinned.rows[i] || here.rows[i]->stitches == pinned.rows[i]->stitches;
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
  columns_.clear();
  for (const auto& row : pin.end.rows) rows_.push_back(row_lines(theme, *row));
  for (std::size_t i = 0; i < pin.end.strips.size(); ++i) columns_.push_back(column_lines(theme, pin.end, i));
}

void Ghost::describe(const Session& session, Scene& scene) {
  if (!session.document->pinned || !session.document->pinned->known) {
    *this = Ghost();
    return;
  }
  const Pin& pin = *session.document->pinned;
  refresh(session, *scene.theme, pin);
  if (!same_mesh_) return;
  const knit::State& here = session.document->timeline.furthest();
  bool below = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool same = has_row(here, pin.end, i);
    if (!same && session.view->shows(Layer::row_edges)) scene.line_sets.push_back(rows_[i]);
    if (i > 0 && i - 1 < columns_.size() && session.view->shows(Layer::column_edges)) {
      const bool made =
          i - 1 < here.strips.size() && same && below &&
          here.strips[i - 1]->column_edges.size() == pin.end.strips[i - 1]->column_edges.size() &&
          here.transitions[i - 1] == pin.end.transitions[i - 1];
      if (!made) scene.line_sets.push_back(columns_[i - 1]);
    }
    below = same;
  }
}

}  // namespace app
