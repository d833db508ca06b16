#include "app/core/report.h"

#include "app/core/quality_json.h"
#include "app/core/step_json.h"
#include "app/core/work_beside.h"
#include "knit/measures.h"
#include "knit/narrate.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const knit::LengthFigures& figures) {
  return {{"mean", figures.mean}, {"cv", figures.cv}, {"min", figures.low}, {"max", figures.high}};
}

Json problem_json(const knit::Step& step, std::size_t number, const knit::Parameters& parameters) {
  return {{"step", number},
          {"stage", knit::name_of(step.place.stage)},
          {"row", step.place.row},
          {"item", step.place.item},
          {"what", knit::narrate(step, parameters)}};
}

Json problems_json(const Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  Json problems = Json::array();
  for (std::size_t i = 0; i < timeline.position(); ++i) {
    const knit::Parameters& parameters = timeline.parameters_of_step(i);
    if (!knit::is_unusual(timeline.step(i), parameters)) continue;
    problems.push_back(problem_json(timeline.step(i), i + 1, parameters));
  }
  if (const knit::Step* stop = stop_shown(session)) {
    problems.push_back(problem_json(*stop, timeline.position() + 1, timeline.parameters()));
  }
  return problems;
}

Json integers(const std::vector<knit::Label>& labels) {
  Json list = Json::array();
  for (const knit::Label label : labels) list.push_back(static_cast<int>(label));
  return list;
}

// One array a row, as Appendix A has them; `transitions` tells the rest.
Json labels_json(const knit::State& state) {
  Json all = Json::array();
  if (state.rows.empty()) return all;
  for (const knit::LabelRow& row : label_rows(state)) {
    if (!row.into) all.push_back(integers(row.labels));
  }
  return all;
}

Json transitions_json(const knit::State& state) {
  Json all = Json::array();
  for (const auto& t : state.transitions) {
    all.push_back({{"row", t->row},
                   {"from", t->below},
                   {"to", t->above},
                   {"rule", knit::name_of(t->rule)},
                   {"labels", integers(t->labels)},
                   {"links", t->link}});
  }
  return all;
}

Json edits_json(const knit::Timeline& timeline) {
  Json all = Json::array();
  for (const knit::Edit& edit : timeline.edits()) {
    all.push_back({{"stage", knit::name_of(edit.at.stage)},
                   {"row", edit.at.row},
                   {"item", edit.at.item},
                   {"parameters", app::to_json(edit.parameters)}});
  }
  return all;
}

}  // namespace

std::vector<knit::LabelRow> label_rows(const knit::State& state) {
  std::vector<const knit::Transition*> transitions;
  for (const auto& transition : state.transitions) transitions.push_back(&*transition);
  return knit::appendix_view(static_cast<std::int32_t>(state.rows.front()->stitches.size()), transitions,
                             state.stage() > knit::Stage::stitches);
}

Json report_json(const Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  const knit::State& state = timeline.state();
  const knit::Mesh& mesh = timeline.input().mesh;
  const knit::FaceCounts faces = knit::count_faces(state);
  const knit::ShapingFigures shaping = knit::shaping_figures(state);

  Json report;
  report["mesh"] = {
      {"name", mesh.name}, {"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
  for (const knit::MendStep& step : session.mended) report["mesh"]["mended"].push_back(step.did);
  report["parameters"] = app::to_json(timeline.base_parameters());
  if (!timeline.edits().empty()) report["edits"] = edits_json(timeline);
  report["steps"] = timeline.position();
  report["finished"] = state.finished();
  report["rows"] = Json::array();
  for (const auto& row : state.rows) report["rows"].push_back(row->stitches.size());
  report["labels"] = labels_json(state);
  report["transitions"] = transitions_json(state);
  report["faces"] = {{"quads", faces.quads}, {"triangles", faces.triangles}};
  report["euler"] = knit::euler_characteristic(state);
  report["course"] = to_json(knit::course_figures(state));
  report["wale"] = to_json(knit::wale_figures(state));
  report["shaping"] = {{"increases", shaping.increases},
                       {"decreases", shaping.decreases},
                       {"max_in_a_row", shaping.max_in_a_row}};
  const knit::Parameters& parameters = timeline.parameters();
  const auto closeness = closeness_now(session);
  report["quality"] = quality_json(knit::measure_quality(timeline.input(), state, parameters.stitch_width,
                                                         knit::stitch_height_of(parameters)),
                                   closeness.get());
  report["problems"] = problems_json(session);
  report["pattern"] = Json::array();
  for (const auto& line : state.lines) report["pattern"].push_back(line->text);
  report["milliseconds"] = {{"load", session.load_ms}, {"run", session.run_ms}};
  return report;
}

}  // namespace app
