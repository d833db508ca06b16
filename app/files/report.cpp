#include "app/files/report.h"

#include <array>

#include "app/files/card.h"
#include "app/files/knitted.h"
#include "app/files/pattern_export.h"
#include "app/session/document.h"
#include "app/session/remarks.h"
#include "app/session/shown.h"
#include "app/session/view.h"

#include "knit/insight/narrate.h"
#include "knit/insight/step_fields.h"
#include "knit/model/words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/short_form.h"
#include "knit/quality/measures.h"

namespace app {

namespace {

struct ParameterValue {
  const knit::Parameters& p;
  const knit::ParameterInfo& info;
  using Json = nlohmann::ordered_json;
  Json operator()(const knit::Number& number) const {
    return knit::is_auto(number, p) ? Json("auto") : Json(number.get(p));
  }
  Json operator()(const knit::Count& count) const {
    return count.zero_means_auto && count.get(p) == 0 ? Json("auto") : Json(count.get(p));
  }
  Json operator()(const knit::PickedVertex& picked) const {
    return picked.get(p) == knit::no_vertex ? Json("auto") : Json(picked.get(p));
  }
  Json operator()(const knit::AxisChoice& /*axis*/) const { return knit::value_text(info, p); }
  Json operator()(const knit::DirectionChoice& /*direction*/) const { return knit::value_text(info, p); }
  Json operator()(const knit::GaugeChoice& /*gauge*/) const { return knit::value_text(info, p); }
  Json operator()(const knit::Choice& /*choice*/) const { return knit::value_text(info, p); }
};

}  // namespace

nlohmann::ordered_json to_json(const knit::Parameters& parameters) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    json[std::string(info.key)] = std::visit(ParameterValue{parameters, info}, info.kind);
  }
  return json;
}

nlohmann::ordered_json to_json(const knit::Step& step, std::size_t index,
                               const knit::Parameters& parameters) {
  nlohmann::ordered_json json;
  json["step"] = index;
  json["stage"] = knit::name_of(step.place.stage);
  json["row"] = step.place.row;
  json["item"] = step.place.item;
  json["kind"] = knit::kind_name(step);
  for (const knit::StepField& field : knit::fields_of(step)) {
    std::visit([&](const auto& value) { json[std::string(field.name)] = value; }, field.value);
  }
  json["what"] = knit::narrate(step, parameters);
  return json;
}

namespace {

using Json = nlohmann::ordered_json;

Json value_if(bool there, double value) { return there ? Json(value) : Json(nullptr); }

Json ratio(double part, double whole) { return value_if(whole > 0.0, part / whole); }

Json spread_json(const knit::Spread& spread) {
  if (spread.count == 0) return nullptr;
  const knit::Histogram& histogram = spread.histogram;
  return {{"mean", spread.mean},
          {"cv", spread.cv},
          {"min", spread.low},
          {"max", spread.high},
          {"p95", spread.p95},
          {"histogram", {{"low", histogram.low}, {"high", histogram.high}, {"bins", histogram.bins}}}};
}

Json rows_json(const std::vector<knit::RowFit>& rows) {
  Json all = Json::array();
  for (const knit::RowFit& row : rows) {
    all.push_back({{"row", row.row},
                   {"stitches", row.stitches},
                   {"length", row.length},
                   {"ideal", row.ideal},
                   {"course_cv", row.course_cv}});
  }
  return all;
}

// Of each tube, as far as it is there.
Json tube_fits_json(const std::vector<knit::TubeFit>& tubes) {
  Json all = Json::array();
  for (const knit::TubeFit& tube : tubes) {
    all.push_back({{"name", knit::tube_name(tube.tube)},
                   {"rounds", tube.rounds},
                   {"stitches", tube.stitches},
                   {"wale_cv", value_if(tube.wales > 0, tube.wale_cv)},
                   {"wale_max", value_if(tube.wales > 0, tube.longest_wale)},
                   {"worst_course_cv_in_row", tube.worst_course_cv_in_row}});
  }
  return all;
}

Json mirror_json(const std::optional<knit::MirrorError>& mirror) {
  if (!mirror) return nullptr;
  return {{"mean", mirror->mean}, {"max", mirror->max}};
}

Json distances_json(const knit::Distances& distances, double diagonal) {
  if (distances.samples == 0) return nullptr;
  return {{"mean", distances.mean},
          {"max", distances.max},
          {"mean_share", ratio(distances.mean, diagonal)},
          {"max_share", ratio(distances.max, diagonal)}};
}

}  // namespace

Json to_json(const knit::Quality& quality) {
  const bool any_wale = quality.wale.count > 0;
  const bool any_face = quality.faces.quads + quality.faces.triangles > 0;
  Json json;
  json["stitch_width"] = quality.stitch_width;
  json["stitch_height"] = quality.stitch_height;
  json["course"] = spread_json(quality.course);
  json["long_course"] = spread_json(quality.long_course);
  json["worst_course_cv_in_row"] = value_if(quality.course.count > 0, quality.worst_course_cv_in_row);
  json["wale"] = spread_json(quality.wale);
  json["corner"] = spread_json(quality.corner);
  json["corner_off"] = spread_json(quality.corner_off);
  json["rows"] = rows_json(quality.rows);
  json["tubes"] = tube_fits_json(quality.tubes);
  json["quad_share"] = value_if(any_face, quality.quad_share);
  json["regular_share"] = value_if(any_wale && quality.rows.size() > 2, quality.regular_share);
  json["shaping"] = {{"increases", quality.shaping.increases},
                     {"decreases", quality.shaping.decreases},
                     {"max_in_a_row", quality.shaping.max_in_a_row},
                     {"steady", quality.steady_shaping}};
  json["offset"] = value_if(any_wale, quality.offset);
  json["long_offset"] = value_if(any_wale && quality.long_course.count > 0, quality.long_offset);
  json["mirror"] = mirror_json(quality.mirror);
  return json;
}

Json to_json(const knit::Closeness& closeness) {
  return {{"distance",
           {{"knit_to_mesh", distances_json(closeness.knit_to_mesh, closeness.diagonal)},
            {"mesh_to_knit", distances_json(closeness.mesh_to_knit, closeness.diagonal)}}},
          {"area_ratio", ratio(closeness.knit_area, closeness.mesh_area)}};
}

Json to_json(const knit::Uncovered& uncovered) {
  Json where = Json::array();
  for (const knit::UncoveredPlace& place : uncovered.places) {
    where.push_back(
        {{"vertex", place.vertex}, {"at", {place.at.x, place.at.y, place.at.z}}, {"share", place.share}});
  }
  return {{"share", uncovered.share}, {"where", where}};
}

Json to_json(const std::vector<knit::Stretched>& stretched) {
  Json all = Json::array();
  for (const knit::Stretched& rows : stretched) {
    all.push_back({{"tube", knit::tube_name(rows.tube)},
                   {"from", rows.from},
                   {"to", rows.to},
                   {"longest", rows.longest},
                   {"share", rows.share}});
  }
  return all;
}

Json quality_json(const knit::Quality& quality, const knit::Closeness* closeness) {
  Json json = to_json(quality);
  json.update(closeness != nullptr ? to_json(*closeness)
                                   : Json{{"distance", nullptr}, {"area_ratio", nullptr}});
  return json;
}

namespace {

using Json = nlohmann::ordered_json;

Json lengths_json(const knit::LengthFigures& figures) {
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
  const knit::Timeline& timeline = session.document->timeline;
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
  if (state.fabric.rows().empty()) return all;
  for (const TubeLabels& tube : label_rows(state)) {
    for (const knit::LabelRow& row : tube.rows) {
      if (!row.into && row.short_row == 0) all.push_back(integers(row.labels));
    }
  }
  return all;
}

Json joins_json(const knit::State& state) {
  Json all = Json::array();
  for (const auto& t : state.fabric.joins()) {
    all.push_back({{"row", t->to},
                   {"from", t->below},
                   {"to", t->above},
                   {"rule", knit::name_of(t->rule)},
                   {"labels", integers(t->labels)},
                   {"links", t->link}});
  }
  return all;
}

std::string_view word_of(knit::EventKind kind) {
  constexpr std::array<std::string_view, 6> words{"cast-on",  "split",        "join",
                                                  "bind-off", "ring-cast-on", "ring-bind-off"};
  return words.at(static_cast<std::size_t>(kind));
}

Json names_json(const std::vector<knit::TubeId>& tubes) {
  Json names = Json::array();
  for (const knit::TubeId tube : tubes) names.push_back(knit::tube_name(tube));
  return names;
}

// As they are planned, with the rows that are there.
Json tubes_json(const knit::State& state) {
  Json all = Json::array();
  const knit::TubePlan& plan = *state.tubes;
  for (std::size_t id = 0; id < plan.tubes.size(); ++id) {
    const knit::Tube& tube = plan.tubes[id];
    std::size_t stitches = 0;
    Json rows = Json::array();
    for (const auto& row : state.fabric.rows()) {
      if (row->tube != static_cast<knit::TubeId>(id)) continue;
      stitches += row->stitches.size();
      rows.push_back(row->id);
    }
    std::vector<knit::TubeId> twins = tube.twins;
    std::erase(twins, static_cast<knit::TubeId>(id));
    all.push_back({{"name", knit::tube_name(static_cast<std::int32_t>(id))},
                   {"from", word_of(plan.event(tube.bottom).kind)},
                   {"to", word_of(plan.event(tube.top).kind)},
                   {"rounds", tube.rows()},
                   {"rows", rows},
                   {"stitches", stitches},
                   {"height", tube.height},
                   {"inner", tube.inner},
                   {"twin_of", names_json(twins)}});
  }
  return all;
}

Json events_json(const knit::State& state) {
  Json all = Json::array();
  for (std::size_t i = 0; i < state.tubes->events.size(); ++i) {
    const knit::TubeEvent& event = state.tubes->events[i];
    Json entry{{"kind", word_of(event.kind)},
               {"vertex", event.vertex},
               {"below", names_json(event.below)},
               {"above", names_json(event.above)}};
    for (const auto& deal : state.fabric.deals()) {
      if (deal->event != static_cast<std::int32_t>(i)) continue;
      entry["after_row"] = deal->after;
      entry["arcs"] = deal->arcs;
      entry["bridge"] = deal->bridge.size();
      entry["gap"] = deal->gap;
    }
    all.push_back(std::move(entry));
  }
  return all;
}

Json left_out_json(const knit::TubePlan& plan) {
  Json all = Json::array();
  for (const knit::LeftOut& left : plan.left_out) {
    all.push_back({{"what", left.handle ? "hole" : "limb"},
                   {"vertex", left.from},
                   {"height", left.height},
                   {"girth", left.girth},
                   {"width_that_keeps", left.width_that_keeps}});
  }
  return all;
}

// Of the graph as it was found, before anything was left out.
Json graph_json(const knit::TubeGraph& graph) {
  std::array<std::int32_t, 4> kinds{};
  for (const knit::GraphNode& node : graph.nodes) ++kinds.at(static_cast<std::size_t>(node.kind()));
  return {{"minima", kinds[0]},
          {"splits", kinds[1]},
          {"joins", kinds[2]},
          {"maxima", kinds[3]},
          {"unfolded", graph.surface.unfolded},
          {"tubes", graph.tubes.size()},
          {"loops", graph.loops()}};
}

// Known with the closeness, if that was measured with it.
Json uncovered_json(const knit::Timeline& timeline, const knit::Closeness* closeness) {
  if (closeness == nullptr) return nullptr;
  const knit::StitchSize& stitch = timeline.parameters().stitch;
  const auto coverage = closeness->coverage ? closeness->coverage
                                            : knit::measure_coverage(timeline.input(), timeline.state(),
                                                                     stitch.width, stitch.height);
  return coverage ? to_json(coverage->uncovered) : Json(nullptr);
}

// Size as knitted and as asked, and what is not as asked; of a finished run.
void add_as_asked(const knit::Timeline& timeline, const knit::Closeness* closeness, Json& report) {
  report["size"] = nullptr;
  report["remarks"] = Json::array();
  if (!timeline.state().finished()) return;
  const auto size_json = [](const knit::PieceSize& size) {
    return Json{{"height_cm", size.height_cm ? Json(*size.height_cm) : Json(nullptr)},
                {"around_cm", size.around_cm}};
  };
  const knit::Parameters& parameters = timeline.parameters();
  report["size"] = {{"knitted", size_json(size_knitted(timeline.state(), parameters.stitch.gauge))},
                    {"asked", size_json(knit::size_asked(timeline.state(), parameters))}};
  const bool measured = closeness != nullptr && closeness->coverage;
  for (const knit::Remark& remark : remarks_of(timeline, measured ? &*closeness->coverage : nullptr)) {
    report["remarks"].push_back(
        {{"about", knit::remark_keys.at(static_cast<std::size_t>(remark.kind))}, {"what", remark.words}});
  }
}

void add_tubes(const knit::State& state, Json& report) {
  const knit::TubePlan& plan = *state.tubes;
  report["graph"] = graph_json(*state.graph);
  report["tubes"] = tubes_json(state);
  report["events"] = events_json(state);
  report["genus"] = knit::genus_of(plan);
  const auto ends = [](const knit::TubeEvent& event) {
    return event.kind == knit::EventKind::cast_on || event.kind == knit::EventKind::bind_off;
  };
  std::ptrdiff_t openings = 0;
  for (const knit::TubeEvent& event : plan.events) {
    const knit::TubeId tube = event.below.empty() ? event.above.front() : event.below.front();
    openings += ends(event) && plan.tube(tube).rows() > 0 ? 1 : 0;
  }
  report["openings"] = openings;
  report["held_most"] = plan.held_most;
  report["yarns"] = plan.yarns;
  report["left_out"] = left_out_json(plan);
}

// Both figures of stitches that have settled, small enough to be read side by side.
Json positions_json(const knit::Quality& quality, const knit::Closeness* closeness) {
  const knit::Coverage* coverage =
      closeness != nullptr && closeness->coverage ? &*closeness->coverage : nullptr;
  const auto distance = [&](knit::Distances knit::Closeness::*which) {
    return closeness != nullptr ? ratio((closeness->*which).max, closeness->diagonal) : Json(nullptr);
  };
  return {{"wale_cv", quality.wale.cv},
          {"wale_max", quality.wale.high},
          {"course_cv", quality.course.cv},
          {"corner_off", quality.corner_off.mean},
          {"corner_off_p95", quality.corner_off.p95},
          {"turned", coverage != nullptr ? Json(coverage->turned.faces) : Json(nullptr)},
          {"uncovered", coverage != nullptr ? Json(coverage->uncovered.share) : Json(nullptr)},
          {"knit_to_mesh", distance(&knit::Closeness::knit_to_mesh)},
          {"mesh_to_knit", distance(&knit::Closeness::mesh_to_knit)}};
}

Json settled_json(const knit::Timeline& timeline, const knit::Closeness* closeness) {
  const auto both = settled_figures(timeline);
  if (!both) return nullptr;
  const double width = both->settled.stitch_width;
  return {{"iterations", both->iterations},
          {"moved",
           {{"mean", both->moves.mean / width},
            {"max", both->moves.most / width},
            {"row", both->moves.of.row},
            {"stitch", both->moves.of.stitch}}},
          {"placed", positions_json(both->placed, closeness != nullptr ? closeness->placed.get() : nullptr)},
          {"settled", positions_json(both->settled, closeness)}};
}

std::size_t characters_of(const std::vector<knit::RoundLine>& lines) {
  std::size_t characters = 0;
  for (const knit::RoundLine& line : lines) characters += line.text().size();
  return characters;
}

// How long the rounds are to read, in both forms.
void add_lengths(const knit::State& state, Json& json) {
  json["lines"] = nullptr;
  json["characters"] = {{"short", nullptr}, {"full", nullptr}};
  if (state.stage() <= knit::Stage::stitches) return;
  const knit::Rounds rounds = knit::rounds_of(state);
  json["characters"]["full"] = characters_of(knit::round_lines(rounds, {}));
  const auto form = knit::short_form(rounds, knit::stuffed_after(rounds));
  if (!form) return;
  std::size_t characters = characters_of(form->lines);
  for (const knit::NamedRound& round : form->named) characters += round.text().size();
  json["lines"] = form->lines.size() + form->named.size();
  json["characters"]["short"] = characters;
}

Json segments_json(const knit::RhythmPlan& plan) {
  constexpr std::array<std::string_view, 3> kinds{"plain", "change-last", "change-first"};
  Json all = Json::array();
  for (const knit::RhythmSegment& segment : plan.segments) {
    all.push_back({{"kind", kinds.at(static_cast<std::size_t>(segment.kind))},
                   {"rows", segment.rows},
                   {"change", segment.change},
                   {"times", segment.times}});
    if (!plan.fronts.empty()) all.back()["front"] = segment.front;
  }
  return all;
}

Json rhythm_json(const knit::State& state, const knit::TubeRhythm& rhythm, const knit::Gauge& gauge) {
  const knit::RhythmPlan& plan = rhythm.plan;
  Json json{{"from", rhythm.from + 1},
            {"first", plan.counts.front()},
            {"changes", plan.changes},
            {"sections", plan.sections},
            {"style", knit::rhythm_style_names.at(static_cast<std::size_t>(rhythm.settings.style))},
            {"segments", segments_json(plan)},
            {"seen", {{"local", plan.seen.local}, {"belt", plan.seen.belt}, {"rms", plan.seen.rms}}},
            {"within", plan.within},
            {"what", rhythm_sentences_of(state, rhythm, gauge)}};
  if (!plan.fronts.empty())
    json["halves"] = {{"fronts", plan.fronts}, {"front_off", plan.front_off}, {"back_off", plan.back_off}};
  return json;
}

// Of one tube it is told at the top too.
Json rhythm_json(const knit::State& state, const knit::Gauge& gauge) {
  constexpr std::array<std::string_view, 3> reasons{"", "few-rows", "fits-none"};
  Json tubes = Json::array();
  bool any = false;
  for (const knit::TubeRhythm* rhythm : rhythms_of_run(state)) {
    const bool has_one = rhythm->none == knit::NoRhythm::no;
    any = any || has_one;
    Json tube{{"name", knit::tube_name(rhythm->tube)},
              {"none", has_one ? Json(nullptr) : Json(reasons.at(static_cast<std::size_t>(rhythm->none)))}};
    if (has_one) tube.update(rhythm_json(state, *rhythm, gauge));
    tubes.push_back(std::move(tube));
  }
  if (!any) return nullptr;
  const knit::TubeRhythm* alone = rhythm_of_run(state);
  Json json = alone != nullptr ? rhythm_json(state, *alone, gauge) : Json::object();
  if (alone != nullptr) add_lengths(state, json);
  json["tubes"] = std::move(tubes);
  return json;
}

Json edits_json(const knit::Timeline& timeline) {
  Json all = Json::array();
  for (const knit::Edit& edit : timeline.edits()) {
    all.push_back({{"stage", knit::name_of(edit.at.stage)},
                   {"row", edit.at.row},
                   {"item", edit.at.item},
                   {"parameters", to_json(edit.parameters)}});
  }
  return all;
}

// What was left out is known once the rows are made.
Json short_rows_json(const knit::State& state) {
  std::size_t rows = 0, stitches = 0, planned = 0;
  for (const auto& row : state.fabric.rows()) {
    if (!knit::is_short(*row)) continue;
    ++rows;
    stitches += row->stitches.size();
  }
  for (const auto& tube : state.short_rows.tubes) planned += tube->search.arcs.size();
  const std::size_t pairs = rows / 2;
  Json tries = Json::array();
  for (const knit::KeptTry& way : state.short_rows.tries) {
    tries.push_back({{"rows_kept", way.kept},
                     {"pairs", way.pairs},
                     {"stitches", way.stitches},
                     {"settled_sum", static_cast<double>(way.sum)},  // infinite where the run stopped: null
                     {"wale_cv", static_cast<double>(way.wale_cv)},
                     {"wale_max", static_cast<double>(way.longest_wale)},
                     {"chosen", state.short_rows.kept == way.kept}});
  }
  if (state.stage() <= knit::Stage::rows) planned = pairs;
  return {{"pairs", pairs},
          {"stitches", stitches},
          {"dropped", planned > pairs ? planned - pairs : 0},
          {"tries", tries}};
}

}  // namespace

std::vector<TubeLabels> label_rows(const knit::State& state) {
  const knit::Fabric& fabric = state.fabric;
  const bool all_labelled = state.stage() > knit::Stage::stitches;
  std::vector<TubeLabels> tubes;
  for (knit::RowId id = 1; id <= fabric.row_count();) {
    const knit::Row& first = fabric.row(id);
    std::vector<const knit::Join*> joins;
    const bool cast_on = first.on.empty();
    knit::RowId last = id;
    for (; id <= fabric.row_count() && fabric.row(id).tube == first.tube; ++id) {
      last = id;
      if (knit::is_short(fabric.row(id))) continue;
      if (const knit::Join* join = fabric.join_into(id)) joins.push_back(join);
    }
    const bool ends = fabric.deals().empty() || !fabric.live(first.tube).empty();
    const std::int32_t below = cast_on ? knit::size_of(first) : first.on.size();
    tubes.push_back(
        {first.tube, knit::appendix_view(below, joins, all_labelled && ends, cast_on ? first.id : 0)});
    knit::add_short_rows(fabric, first.tube, tubes.back().rows);
    tubes.back().last = last;
  }
  return tubes;
}

Json report_json(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::State state = shown_state(session);
  const knit::Mesh& mesh = timeline.input().mesh;
  const knit::FaceCounts faces = knit::count_faces(state);
  const knit::ShapingFigures shaping = knit::shaping_figures(state);
  Json report;
  report["mesh"] = {
      {"name", mesh.name}, {"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
  for (const knit::RepairStep& step : session.document->repaired)
    report["mesh"]["mended"].push_back(step.did);
  report["parameters"] = to_json(timeline.base_parameters());
  if (!timeline.edits().empty()) report["edits"] = edits_json(timeline);
  report["steps"] = timeline.position();
  report["finished"] = state.finished();
  report["rows"] = Json::array();
  for (const auto& row : state.fabric.rows()) report["rows"].push_back(row->stitches.size());
  report["labels"] = labels_json(state);
  report["transitions"] = joins_json(state);
  report["faces"] = {{"quads", faces.quads}, {"triangles", faces.triangles}};
  report["euler"] = knit::euler_characteristic(state);
  report["course"] = lengths_json(knit::course_figures(state));
  report["wale"] = lengths_json(knit::wale_figures(state));
  if (state.tubes) add_tubes(state, report);
  report["shaping"] = {{"increases", shaping.increases},
                       {"decreases", shaping.decreases},
                       {"max_in_a_row", shaping.max_in_a_row}};
  report["short_rows"] = short_rows_json(state);
  const knit::Parameters& parameters = timeline.parameters();
  const auto closeness = closeness_now(*session.document);
  const knit::Closeness* shown = closeness_shown(closeness.get(), session.view->positions);
  report["positions"] = positions_keys.at(static_cast<std::size_t>(session.view->positions));
  report["quality"] = quality_json(
      knit::measure_quality(timeline.input(), state, parameters.stitch.width, parameters.stitch.height),
      shown);
  report["settled"] = settled_json(timeline, closeness.get());
  report["uncovered"] = uncovered_json(timeline, shown);
  report["knitted"] = knitted_json(session);
  report["stretched"] = to_json(knit::stretched_rows(state, parameters.stitch.height));
  add_as_asked(timeline, shown, report);
  report["problems"] = problems_json(session);
  report["rhythm"] = rhythm_json(state, parameters.stitch.gauge);
  report["pattern"] = pattern_instructions(session);
  report["milliseconds"] = {{"load", session.document->load_ms}, {"run", session.document->run_ms}};
  return report;
}

}  // namespace app
