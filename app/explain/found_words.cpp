#include "app/explain/found_words.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "app/session/document.h"
#include "app/session/run_figures.h"
#include "knit/import/check_topology.h"
#include "knit/insight/narrate.h"
#include "knit/model/words.h"
#include "knit/rows/first_choice.h"
#include "knit/run/machine.h"

namespace app {

namespace {

constexpr std::array<const char*, 4> axis_words{"x", "y", "z", "its axis"};

std::string name_of_axis(knit::AxisKind kind) { return axis_words.at(static_cast<std::size_t>(kind)); }

// Whether every level along it is a ring, as the run itself finds out.
bool has_rings(const knit::Input& input, knit::AxisKind axis) {
  Knobs knobs{knit::first_parameters(input), {}};
  knobs.base.timing.axis.kind = axis;
  knobs.base.timing.kind = knit::TimingKind::linear;
  RunTally run;
  while (go_on(run, input, knobs, 100000, knit::Stage::tubes)) {
  }
  return !run.stop && as_chosen(knobs.base, run.state).rows.source == knit::RowSource::rings;
}

// "x", "x and y", "x, y and z"
std::string listed(const std::vector<std::string>& names) {
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return words;
}

std::string ring_words(const knit::Input& input) {
  if (input.mesh.triangles.size() > most_searched_triangles) return "";
  std::vector<std::string> axes;
  for (const knit::AxisKind axis : {knit::AxisKind::x, knit::AxisKind::y, knit::AxisKind::z})
    if (has_rings(input, axis)) axes.push_back(name_of_axis(axis));
  return axes.empty() ? "; rings along no axis" : "; rings along " + listed(axes);
}

// " with 3 limbs": ends of tubes, of which one tube and a ring have two.
std::string limb_words(const knit::TubePlan& plan) {
  const auto ends = std::count_if(plan.events.begin(), plan.events.end(), [](const knit::TubeEvent& event) {
    return event.kind == knit::EventKind::cast_on || event.kind == knit::EventKind::bind_off;
  });
  return ends > 2 ? " with " + std::to_string(ends) + " limbs" : "";
}

}  // namespace

std::string shape_words(const knit::Input& input) {
  const glm::dvec3 size = input.bounds.high - input.bounds.low;
  const std::size_t handles = knit::handles_of(input);
  const std::string handle_words =
      handles == 0 ? "no handle" : knit::plural(static_cast<std::int64_t>(handles), "handle", "handles");
  return "Closed, " +
         knit::plural(static_cast<std::int64_t>(input.mesh.triangles.size()), "triangle", "triangles") +
         ", " + knit::short_number(size.x) + " x " + knit::short_number(size.y) + " x " +
         knit::short_number(size.z) + " units" + ring_words(input) + "; " + handle_words + ".";
}

std::string knitted_words(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::State& state = timeline.furthest();
  const knit::Parameters chosen = as_chosen(timeline.parameters_of_stop(), state);
  if (!state.timing || chosen.rows.source == knit::RowSource::by_itself) return "";
  std::string words = "Knitted along " + name_of_axis(chosen.timing.axis.kind) +
                      (chosen.rows.source == knit::RowSource::rings ? " from rings" : " from contours");
  if (state.tubes)
    words += ", as " + knit::plural(static_cast<std::int64_t>(state.tubes->order.size()), "tube", "tubes") +
             limb_words(*state.tubes);
  return words + ".";
}

namespace {

// " 28 rounds, 2 yarns, 1 split, 1 join." Of one tube there is nothing to add.
std::string plan_words(const knit::State& state) {
  if (!state.tubes || state.tubes->tubes.size() < 2) return "";
  const auto count = [&](auto holds) {
    return static_cast<std::int64_t>(
        std::count_if(state.tubes->events.begin(), state.tubes->events.end(), holds));
  };
  const auto splits = count([](const knit::TubeEvent& event) { return event.above.size() == 2; });
  const auto joins = count([](const knit::TubeEvent& event) { return event.below.size() == 2; });
  std::string words = " " + knit::plural(state.fabric.row_count(), "round", "rounds") + ", " +
                      knit::plural(state.tubes->yarns, "yarn", "yarns");
  if (splits > 0) words += ", " + knit::plural(splits, "split", "splits");
  if (joins > 0) words += ", " + knit::plural(joins, "join", "joins");
  return words + ".";
}

// The same run with rows from rings, until its rows are there.
std::string rings_words(const knit::Timeline& timeline) {
  const knit::Input& input = timeline.input();
  if (input.mesh.triangles.size() > most_searched_triangles) return "";
  Knobs knobs = knobs_of(timeline);
  knobs.base.rows.source = knit::RowSource::rings;
  for (knit::Edit& edit : knobs.edits) edit.parameters.rows.source = knit::RowSource::rings;
  RunTally run;
  while (go_on(run, input, knobs, 100000, knit::Stage::stitches)) {
  }
  if (!run.stop) return " With rows from rings it would not have stopped either.";
  return " With rows from rings it would have stopped: " +
         knit::narrate(*run.stop, parameters_at(knobs, run.stop->place));
}

}  // namespace

std::string finished_words(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const std::string knitted = knitted_words(session);
  const bool contours =
      as_chosen(timeline.parameters_of_stop(), timeline.furthest()).rows.source == knit::RowSource::contours;
  return "The run did not stop: it is finished." + (knitted.empty() ? "" : " " + knitted) +
         plan_words(timeline.furthest()) + (contours ? rings_words(timeline) : "");
}

}  // namespace app
