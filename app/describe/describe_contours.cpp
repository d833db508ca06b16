#include "app/describe/describe_contours.h"

#include <algorithm>
#include <array>

#include "app/explain/code_variables.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/rows/contour.h"
#include "knit/timing/heights.h"

namespace app {

namespace {

constexpr int isoline_count = 20;
constexpr std::size_t most_names = 24;  // more would only cover each other

const knit::Step* step_shown(const Session& session) {
  const knit::Step* stop = stop_shown(session);
  return stop != nullptr ? stop : last_step(session);
}

void add_crossings(const knit::Ring& curve, Colour colour, Scene& scene) {
  for (const glm::dvec3& point : curve.points) scene.points.push_back({glm::vec3(point), colour, 4.5F});
}

void add_stitches(const Session& session, const knit::ContourWork& work, Scene& scene) {
  if (!session.view->shows(Layer::stitches)) return;
  // Of any tube that nothing hangs below.
  const knit::State& state = session.document->timeline.state();
  const bool cast_on = state.fabric.live(knit::current_tube(*state.tubes, work)).empty();
  const Colour colour = cast_on ? scene.theme->of(knit::Label::cast) : scene.theme->stitch;
  for (const knit::Stitch& stitch : work.stitches)
    scene.points.push_back({glm::vec3(stitch.position), colour, 7.0F});
}

// A chart's level, or an arc of it.
void add_level(const knit::TubeChart& chart, double level, const std::array<std::int32_t, 2>& columns,
               const Line& look, Scene& scene) {
  for (std::int32_t column = columns[0]; column < columns[1]; ++column) {
    Line line = look;
    line.from = glm::vec3(knit::point_at(chart, level, column));
    line.to = glm::vec3(knit::point_at(chart, level, column + 1));
    scene.lines.push_back(line);
  }
}

// What is planned of short rows: the gap, where most rows are missing, and the arc.
void add_planning(const knit::State& state, const knit::Step& step, Scene& scene) {
  const knit::ShortRowsMade& made = state.short_rows;
  const knit::PlannedPairs* pairs = made.planning        ? &*made.planning
                                    : made.tubes.empty() ? nullptr
                                                         : &*made.tubes.back();
  if (pairs == nullptr || !pairs->chart) return;
  const knit::TubeChart& chart = *pairs->chart;
  const auto level = [&](std::int32_t gap) { return pairs->rounds.levels[static_cast<std::size_t>(gap)]; };
  const auto gap = [&](std::int32_t at) {
    for (const std::int32_t round : {at, at + 1})
      add_level(chart, level(round), {0, chart.columns}, {{}, {}, scene.theme->ring, 1.6F}, scene);
  };
  if (knit::is<knit::TubeCharted>(step) || knit::is<knit::PairsChosen>(step)) {
    for (const double round : pairs->rounds.levels)
      add_level(chart, round, {0, chart.columns}, {{}, {}, scene.theme->ring, 1.2F}, scene);
    for (const knit::PairArc& arc : pairs->search.arcs) {
      const double middle = 0.5 * (level(arc.gap) + level(arc.gap + 1));
      add_level(chart, middle, {arc.from, arc.to}, {{}, {}, scene.theme->anchor, 2.6F}, scene);
    }
  }
  if (const auto* lag = knit::get_if<knit::GapMeasured>(step)) {
    gap(lag->gap);
    const glm::vec3 at(knit::point_at(chart, level(lag->gap + 1), lag->column));
    scene.points.push_back({at, scene.theme->anchor, 10.0F});
    scene.captions.push_back(
        {at, knit::short_number(static_cast<double>(lag->greatest)) + " rows missing", scene.theme->anchor});
  }
  if (const auto* arc = knit::get_if<knit::ArcTried>(step)) {
    gap(arc->gap);
    const double middle = 0.5 * (level(arc->gap) + level(arc->gap + 1));
    const Colour colour = arc->taken ? scene.theme->anchor : scene.theme->too_near;
    add_level(chart, middle, {arc->from, arc->to}, {{}, {}, colour, 4.0F}, scene);
  }
}

std::string_view word_of(knit::CriticalKind kind) {
  switch (kind) {
    case knit::CriticalKind::minimum:
      return "minimum";
    case knit::CriticalKind::saddle:
      return "saddle";
    case knit::CriticalKind::maximum:
      return "maximum";
  }
  return "";
}

Colour colour_of(const Theme& theme, knit::CriticalKind kind) {
  switch (kind) {
    case knit::CriticalKind::minimum:
      return theme.time_low;
    case knit::CriticalKind::saddle:
      return theme.problem;
    case knit::CriticalKind::maximum:
      return theme.time_high;
  }
  return theme.ring;
}

}  // namespace

void add_loop(const knit::Ring& ring, Colour colour, float width_px, std::vector<Line>& lines) {
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const glm::dvec3& next = ring.points[(i + 1) % ring.points.size()];
    lines.push_back({glm::vec3(ring.points[i]), glm::vec3(next), colour, width_px});
  }
}

void describe_contours(const Session& session, const knit::ContourWork& work, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const knit::Ring* curve = curve_shown(state);
  const knit::Step* step = step_shown(session);
  if (step != nullptr && session.view->shows(Layer::cycle)) add_planning(state, *step, scene);
  if (curve == nullptr) return;
  if (step == nullptr || !session.view->shows(Layer::cycle)) return add_stitches(session, work, scene);
  if (work.phase == knit::ContourPhase::loop) return add_crossings(*curve, scene.theme->ring, scene);
  const bool begun = work.phase == knit::ContourPhase::place;
  add_loop(*curve, scene.theme->anchor, begun ? 1.6F : 2.6F, scene.lines);
  const glm::vec3 start(curve->points.front());
  if (begun) scene.points.push_back({start, scene.theme->anchor, 10.0F});
  if (const auto* measured = knit::get_if<knit::LengthMeasured>(*step))
    scene.captions.push_back({start, "L = " + knit::short_number(measured->length), scene.theme->anchor});
  if (const auto* chosen = knit::get_if<knit::CountChosen>(*step))
    scene.captions.push_back({start, knit::stitch_count_text(chosen->count), scene.theme->anchor});
  add_stitches(session, work, scene);
  if (knit::is<knit::StitchPlaced>(*step) && !work.stitches.empty())
    scene.points.push_back({glm::vec3(work.stitches.back().position), scene.theme->accepted, 10.0F});
}

std::shared_ptr<const std::vector<Line>> isolines_of(const Theme& theme, const knit::Input& input,
                                                     const knit::Timing& timing) {
  std::vector<double> times;
  std::vector<double> values;
  for (int i = 1; i < isoline_count; ++i) {
    times.push_back(static_cast<double>(i) / isoline_count);
    const double height = times.back() * timing.scale.total();
    values.push_back(timing.retimed ? knit::value_at(timing.scale, height) : times.back());
  }
  const knit::RowFrame frame = knit::row_frame(timing.ends.direction, std::nullopt);
  std::vector<Line> lines;
  for (const knit::Cut& cut : knit::cut_surface(input, timing.cut_field(), values, times, frame)) {
    for (const auto& loop : cut.loops) add_loop(*loop, theme.isoline, 1.0F, lines);
  }
  return std::make_shared<const std::vector<Line>>(std::move(lines));
}

void describe_criticals(const Session& session, Scene& scene) {
  const knit::State& state = session.document->timeline.state();
  const auto* work = std::get_if<knit::TimingWork>(&state.work);
  const knit::Criticals* criticals = state.timing                         ? &state.timing->criticals
                                     : work != nullptr && work->criticals ? &*work->criticals
                                                                          : nullptr;
  if (criticals == nullptr || !session.view->shows(Layer::criticals)) return;
  const knit::Step* step = step_shown(session);
  const auto* stopped = step != nullptr ? knit::get_if<knit::Stopped>(*step) : nullptr;
  // On the finished piece they would only be specks.
  if (state.stage() > knit::Stage::faces && stopped == nullptr) return;
  const bool news = step != nullptr && knit::is<knit::CriticalsFound>(*step);
  std::size_t names = 0;
  for (const knit::CriticalPoint& point : criticals->points) {
    const bool to_blame = stopped != nullptr && stopped->reason == knit::StopReason::splits &&
                          stopped->vertex == point.vertex && point.kind == knit::CriticalKind::saddle;
    const glm::vec3 at(session.document->timeline.input().mesh.positions[point.vertex]);
    const Colour colour = colour_of(*scene.theme, point.kind);
    scene.points.push_back({at, colour, to_blame ? 14.0F : 8.0F});
    if (!to_blame && !(news && names < most_names)) continue;
    ++names;
    // A ring of minima is a minimum and a saddle at one place.
    const bool same_place = news && !scene.captions.empty() && scene.captions.back().position == at;
    if (same_place) {
      scene.captions.back().text += " and " + std::string(word_of(point.kind));
    } else {
      scene.captions.push_back({at, std::string(word_of(point.kind)), colour});
    }
  }
}

}  // namespace app
