// What is right about tubes: how many there are, what a row begins on, which loop waits, where a yarn is broken.
#include <algorithm>

#include "app/lessons/lesson_truths.h"
#include "app/session/document.h"
#include "knit/insight/waiting.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/words.h"
#include "knit/tubes/plan.h"

namespace app::truths {

using knit::EventKind;
using knit::Stage;

namespace {

Truth no_tubes(const knit::Timeline& timeline) {
  return timeline.complete() ? untold("This run plans no tubes; set the page up again.") : not_yet();
}

std::int64_t count_of(const knit::TubePlan& plan, EventKind kind) {
  return std::count_if(plan.events.begin(), plan.events.end(),
                       [&](const knit::TubeEvent& event) { return event.kind == kind; });
}

std::string tubes_words(const knit::TubePlan& plan) {
  std::string names;
  for (std::size_t id = 0; id < plan.tubes.size(); ++id) {
    if (plan.tubes[id].rows() > 0)
      names += (names.empty() ? "" : ", ") + knit::tube_name(static_cast<std::int32_t>(id));
  }
  return "The tubes that have rounds are " + names + ".";
}

// A number of the plan, and why it is so.
struct TubeNumber {
  std::int64_t value = 0;
  std::string why;
};

TubeNumber number_named(const knit::TubePlan& plan, const std::string& word) {
  const std::int64_t splits = count_of(plan, EventKind::split), joins = count_of(plan, EventKind::join);
  const std::int64_t rings =
      count_of(plan, EventKind::ring_cast_on) + count_of(plan, EventKind::ring_bind_off);
  if (word == "tubes") {
    const auto worked = std::count_if(plan.tubes.begin(), plan.tubes.end(),
                                      [](const knit::Tube& tube) { return tube.rows() > 0; });
    return {worked, tubes_words(plan)};
  }
  if (word == "yarns") {
    const std::int64_t at_places =
        count_of(plan, EventKind::cast_on) + splits + count_of(plan, EventKind::ring_cast_on);
    return {plan.yarns,
            knit::plural(plan.yarns, "yarn is", "yarns are") +
                " begun: one at each cast on, and one more wherever two tubes begin at the same place, "
                "as only one of them can go on with the yarn" +
                (plan.yarns == at_places
                     ? "."
                     : "; but none where a tube has no round, and another where the yarn hangs elsewhere.")};
  }
  if (word == "holders") {
    return {plan.held_most, "At most " + knit::plural(plan.held_most, "loop waits", "loops wait") +
                                " on holders at the same time, in the order in which the tubes are worked."};
  }
  if (word == "splits")
    return {splits, "The level sets part at " + knit::plural(splits, "saddle.", "saddles.")};
  if (word == "joins") return {joins, "The level sets meet at " + knit::plural(joins, "saddle.", "saddles.")};
  if (word == "rings") {
    return {rings, "Two tubes share a whole edge at " + knit::plural(rings, "place.", "places.")};
  }
  const std::int64_t handles = knit::genus_of(plan);
  return {handles, "The tubes close " + knit::plural(handles, "loop", "loops") +
                       " among themselves, one for each hole that one can look through."};
}

}  // namespace

Truth tube_count(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.furthest().tubes) return no_tubes(timeline);
  const TubeNumber number = number_named(*timeline.furthest().tubes, call.word);
  return {{str(number.value)}, number.why, 0.0};
}

// --- what a row is worked on -------------------------------------------------------------------------------

namespace {

// Of the tube with this letter; null: it has none, or not yet.
const knit::Row* first_row_of(const knit::Timeline& timeline, const std::string& tube) {
  for (const auto& row : timeline.furthest().fabric.rows()) {
    if (knit::tube_name(row->tube) == tube) return &*row;
  }
  return nullptr;
}
Truth no_such_tube(const knit::Timeline& timeline, const std::string& tube) {
  return timeline.complete() ? untold("This run has no tube " + tube + " with rows; set the page up again.")
                             : not_yet();
}
std::string cast_on_words(const knit::Row& row) {
  return "Row " + str(row.id) + " is cast on; nothing hangs below it.";
}

// The tube with rows already whose first row faces this one across a ring; -1: none.
knit::TubeId across_a_ring(const knit::State& run, const knit::Row& row) {
  if (!run.tubes || !row.on.empty()) return -1;
  const knit::TubeEvent& bottom = run.tubes->event(run.tubes->tube(row.tube).bottom);
  if (bottom.kind != EventKind::ring_cast_on) return -1;
  for (knit::RowId id = 1; id < row.id; ++id) {
    const knit::TubeId tube = run.fabric.row(id).tube;
    const bool other =
        tube != row.tube && std::find(bottom.above.begin(), bottom.above.end(), tube) != bottom.above.end();
    if (other) return tube;
  }
  return -1;
}

// What was done last to the loop that a row takes, where that was a deal; none: it was a row.
std::optional<std::size_t> dealt_before(const knit::Timeline& timeline, const knit::Row& row) {
  const auto& deals = timeline.furthest().fabric.deals();
  for (std::size_t i = deals.size(); i-- > 0;) {
    const auto& to = deals[i]->to;
    const auto at = std::find(to.begin(), to.end(), row.tube);
    if (at == to.end() || deals[i]->given[static_cast<std::size_t>(at - to.begin())] != row.on) continue;
    const knit::StepRange steps = knit::steps_of_deal(timeline, static_cast<std::int32_t>(i) + 1);
    if (steps.begin < steps.end) return steps.end - 1;
  }
  return std::nullopt;
}

std::string worked_words(const knit::Timeline& timeline, const knit::Row& row) {
  const std::string words = "Row " + str(row.id) + " is worked on " + knit::stitch_count_text(row.on.size());
  const auto dealt = dealt_before(timeline, row);
  return words + (dealt ? " that were dealt to it: " + said_by(timeline, *dealt) : ", the row below.");
}

}  // namespace

Truth begins_on(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Row* row = first_row_of(timeline, call.word);
  if (row == nullptr) return no_such_tube(timeline, call.word);
  if (!row->on.empty()) return {{"loop"}, worked_words(timeline, *row), 0.0};
  const knit::TubeId other = across_a_ring(timeline.furthest(), *row);
  if (other < 0) return {{"nothing"}, cast_on_words(*row), 0.0};
  return {{"edge"},
          "Row " + str(row->id) + " starts from the edge that tube " + knit::tube_name(other) +
              " was cast on with.",
          0.0};
}

Truth worked_on(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Row* row = first_row_of(timeline, call.word);
  if (row == nullptr) return no_such_tube(timeline, call.word);
  if (row->on.empty()) return untold(cast_on_words(*row));
  return {{str(row->on.size())}, worked_words(timeline, *row), 0.0};
}

// --- holders and yarns -------------------------------------------------------------------------------------

// At the place that is shown.
Truth waiting_tube(const Session& session, const JudgeCall& /*call*/) {
  const knit::State& state = session.document->timeline.state();
  const auto* work = std::get_if<knit::ContourWork>(&state.work);
  if (work == nullptr || work->taken == 0)
    return untold("No tube is being worked at this place; set the page up again.");
  const std::string worked =
      "while tube " + knit::tube_name(knit::current_tube(*state.tubes, *work)) + " is worked.";
  const std::vector<knit::TubeId> waiting = knit::waiting_tubes(state);
  if (waiting.empty()) return {{"none"}, "No loop waits on a holder " + worked, 0.0};
  Truth truth;
  for (const knit::TubeId tube : waiting) truth.answers.push_back(knit::tube_name(tube));
  truth.reason = "Tube " + truth.answers.front() + " waits on a holder with its " +
                 knit::stitch_count_text(state.fabric.live(waiting.front()).size()) + " " + worked;
  return truth;
}

Truth yarn_broken(const Session& session, const JudgeCall& call) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::State& run = timeline.furthest();
  if (!timeline.complete() || !knit::limbs_are_known(run)) return not_yet();
  if (!knit::has_limbs(run))
    return {{"row:" + str(run.fabric.row_count())}, "One yarn goes through all rows, to the last one.", 0.0};
  const knit::LimbPlan limbs = knit::plan_limbs(run);
  Truth truth;
  for (std::int32_t i = 0; i < limbs.count(); ++i) {
    if (limbs.piece(i).end.kind == knit::LimbEndKind::goes_on) continue;
    const knit::RowId row = limbs.piece(i).rows.back();
    if (truth.answers.empty() || row == call.row) {
      truth.reason = "After row " + str(row) +
                     " the yarn is broken: no piece goes on where it hangs, at the end of " + "piece " +
                     knit::tube_name(i) + ".";
    }
    truth.answers.push_back("row:" + str(row));
  }
  return truth;
}

std::string why_not_broken(const Session& session, const JudgeCall& /*call*/, const std::string& answer) {
  const knit::State& run = session.document->timeline.furthest();
  const std::int32_t row = row_of_answer(answer);
  if (!run.fabric.has_row(row) || !knit::has_limbs(run)) return "";
  const bool goes_on =
      run.fabric.has_row(row + 1) && run.fabric.row(row + 1).tube == run.fabric.row(row).tube;
  return goes_on ? "After row " + str(row) + " the next row of the same tube goes on with the yarn."
                 : "After row " + str(row) + " a piece goes on with the yarn that hangs there.";
}

// --- where tubes meet --------------------------------------------------------------------------------------

Truth join_vertex(const Session& session, const JudgeCall& /*call*/) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.furthest().tubes) return no_tubes(timeline);
  Truth truth{{}, "", near_enough(session)};
  for (const knit::TubeEvent& event : timeline.furthest().tubes->events) {
    if (event.kind == EventKind::join) truth.answers.push_back(vertex_name(event.vertex));
  }
  const auto joins = static_cast<std::int64_t>(truth.answers.size());
  truth.reason =
      "Two loops become one at " + knit::plural(joins, "saddle of this run.", "saddles of this run.");
  return joins == 0 ? untold("Nothing joins in this run; set the page up again.") : truth;
}

}  // namespace app::truths
