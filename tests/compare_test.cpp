// The pinned run beside the one at hand: what differs, the swap, and the ghost.
#include "app/compare/compare_runs.h"

#include <algorithm>
#include <set>

#include "app/describe/describe.h"
#include "app/scene/palette.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "knit/model/stitch_size.h"
#include "tests/support/beside.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;
using test_support::is_one_sentence;
using test_support::small_session;

namespace {

void tune_epsilon(Session& session, double epsilon) {
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::give_epsilon(parameters, epsilon);
  apply(session, Tune{parameters});
}

RunDifference difference_now(Session& session) {
  session.document->timeline.extend_to_end();
  const Knobs knobs = knobs_of(session.document->timeline);
  const RunTally run = tally_of(session.document->timeline);
  const RunFigures figures = figures_of(run, knobs);
  const Pin& pin = *session.document->pinned;
  return difference_of({*pin.input, pin.knobs, pin.end, pin.figures},
                       {session.document->timeline.input(), knobs, run.state, figures});
}

const FigureLine& figure(const RunDifference& difference, const std::string& key) {
  const auto found = std::find_if(difference.figures.begin(), difference.figures.end(),
                                  [&](const FigureLine& line) { return line.key == key; });
  REQUIRE(found != difference.figures.end());
  return *found;
}

using LineSets = std::set<const std::vector<Line>*>;
LineSets ghosts_of(const Scene& scene) {
  LineSets sets;
  for (const auto& lines : scene.line_sets) {
    if (!lines->empty() && lines->front().colour == dark_theme.ghost) sets.insert(lines.get());
  }
  return sets;
}

}  // namespace

TEST_CASE("figures: recorded or not, a run counts the same", "[compare]") {
  Session session = test_support::finished_small_session();
  const Knobs knobs = knobs_of(session.document->timeline);
  const RunTally bare = whole_run(session.document->timeline.input(), knobs);
  const RunTally recorded = tally_of(session.document->timeline);
  CHECK(bare.state == recorded.state);
  CHECK(bare.steps == session.document->timeline.known());
  CHECK(bare.steps == recorded.steps);
  CHECK(bare.problems == recorded.problems);
  const RunFigures figures = figures_of(bare, knobs);
  CHECK(figures.finished);
  CHECK(figures.stop.empty());
  CHECK(figures.rows == session.document->timeline.furthest().fabric.rows().size());
  const RowFigures rows = row_figures_of(bare.state, 0.3);
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.stitches.size(); ++i) sum += rows.stitches[i] * rows.course[i] * 0.3;
  CHECK(sum == Approx(figures.course.mean * static_cast<double>(figures.course.count)));
}

TEST_CASE("compare: equal runs do not differ", "[compare]") {
  Session session = small_session();
  apply(session, PinRun{});
  REQUIRE(session.document->pinned);
  REQUIRE(session.document->pinned->known);
  const RunDifference difference = difference_now(session);
  CHECK_FALSE(difference.any());
  CHECK(text_of(difference, "a", "b") == "Nothing differs.\n");
}

TEST_CASE("compare: the first row that differs, the settings and the figures", "[compare]") {
  Session session = small_session();
  apply(session, PinRun{});
  const knit::State before = session.document->pinned->end;
  tune_epsilon(session, 0.05);
  const RunDifference difference = difference_now(session);
  REQUIRE(difference.parameters.size() == 1);
  CHECK(difference.parameters[0].key == "epsilon");
  CHECK(difference.parameters[0].a == "0.15");
  CHECK(difference.parameters[0].b == "0.05");
  const knit::State& after = session.document->timeline.furthest();
  std::size_t row = 0;
  while (before.fabric.rows()[row]->stitches == after.fabric.rows()[row]->stitches) ++row;
  REQUIRE(difference.first_row);
  CHECK(difference.first_row->row == static_cast<int>(row) + 1);
  std::int32_t differ = 0;
  const std::size_t rows = std::max(before.fabric.rows().size(), after.fabric.rows().size());
  for (std::size_t i = 0; i < rows; ++i) {
    const bool both = i < before.fabric.rows().size() && i < after.fabric.rows().size();
    differ += both && before.fabric.rows()[i]->stitches == after.fabric.rows()[i]->stitches ? 0 : 1;
  }
  CHECK(difference.rows_differ >= differ);  // alike, they may be made otherwise
  CHECK(difference.rows_differ <= difference.rows - static_cast<std::int32_t>(row));
  const std::string words = std::to_string(difference.rows_differ) + " of " + std::to_string(rows) +
                            " rows differ, first row " + std::to_string(row + 1) + ": ";
  CHECK(rows_words(difference).rfind(words, 0) == 0);
  CHECK(contains(text_of(difference, "a", "b"), words));
  const auto change =
      static_cast<long>(after.fabric.stitch_count()) - static_cast<long>(before.fabric.stitch_count());
  REQUIRE(change < 0);
  CHECK(figure(difference, "stitches").difference == "\xE2\x88\x92" + std::to_string(-change));
  CHECK(contains(text_of(difference, "a", "b"), "--epsilon"));
}

TEST_CASE("compare: rows alike that are made otherwise are told by their shaping", "[compare]") {
  Session session = small_session();
  apply(session, PinRun{});
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.stitches.placement = knit::PlacementPolicy::even;
  apply(session, Tune{parameters});
  const RunDifference difference = difference_now(session);
  REQUIRE(difference.first_row);
  CHECK(difference.first_row->how == RowDiffers::shaping);
  const auto& a = session.document->pinned->end.fabric.joins();
  const auto& b = session.document->timeline.furthest().fabric.joins();
  const auto at = static_cast<std::size_t>(difference.first_row->row) - 2;
  CHECK(a[at]->labels != b[at]->labels);
  CHECK((at == 0 || a[at - 1]->labels == b[at - 1]->labels));
}

TEST_CASE("swap: the pinned knobs come to hand at the same place, and back", "[compare]") {
  Session session = small_session();
  apply(session, PinRun{});
  const std::uint64_t first = knit::hash_of(session.document->timeline.furthest());
  apply(session, SeekPlace{{knit::Stage::rows, 4, 0}});
  const knit::Place place = session.document->timeline.place();
  tune_epsilon(session, 0.07);
  session.document->timeline.extend_to_end();
  knit::Parameters edited = session.document->timeline.parameters();
  edited.rows.close = knit::Closing::none;
  apply(session, EditFromHere{edited});
  session.document->timeline.extend_to_end();
  const std::uint64_t second = knit::hash_of(session.document->timeline.furthest());
  REQUIRE(first != second);
  apply(session, SwapPinned{});
  CHECK(session.document->timeline.parameters().epsilon() == 0.15);
  CHECK(session.document->timeline.edits().empty());
  session.document->timeline.extend_to_end();
  CHECK(knit::hash_of(session.document->timeline.furthest()) == first);
  CHECK(session.document->timeline.place() == place);
  CHECK(knit::hash_of(session.document->pinned->end) == second);
  apply(session, SwapPinned{});
  session.document->timeline.extend_to_end();
  CHECK(session.document->timeline.edits().size() == 1);
  CHECK(knit::hash_of(session.document->timeline.furthest()) == second);
  CHECK(knit::hash_of(session.document->pinned->end) == first);
  apply(session, Unpin{});
  CHECK_FALSE(session.document->pinned);
  apply(session, SwapPinned{});
  CHECK(knit::hash_of(session.document->timeline.furthest()) == second);
}

TEST_CASE("swap: welding is swapped with, another mesh is refused", "[compare]") {
  Session session = small_session(true);
  apply(session, PinRun{});
  const std::size_t loose = session.document->timeline.input().mesh.positions.size();
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.mesh.weld = knit::Weld::on;
  apply(session, Tune{parameters});
  REQUIRE(session.document->timeline.input().mesh.positions.size() < loose);
  apply(session, SwapPinned{});
  CHECK(session.outbox->notices.empty());
  CHECK(session.document->timeline.input().mesh.positions.size() == loose);
  CHECK(session.document->timeline.base_parameters().mesh.weld == knit::Weld::off);
  apply(session, OpenExample{"thesis-sphere"});
  const knit::Parameters here = session.document->timeline.parameters();
  const std::size_t notices = session.outbox->notices.size();
  apply(session, SwapPinned{});
  REQUIRE(session.outbox->notices.size() == notices + 1);
  CHECK(is_one_sentence(session.outbox->notices.back().text));
  CHECK(session.document->timeline.parameters() == here);
}

TEST_CASE("pin: beside a window it takes its end when there is one", "[compare]") {
  Session session = small_session();
  session.jobs->beside = true;
  apply(session, PinRun{});
  REQUIRE(session.document->pinned);
  const bool tuned = GENERATE(false, true);
  const std::uint64_t whole =
      knit::hash_of(whole_run(session.document->timeline.input(), session.document->pinned->knobs).state);
  CHECK_FALSE(session.document->pinned->known);
  CHECK(pin_is_pending(session));
  if (tuned) tune_epsilon(session, 0.05);
  test_support::tick_until(session, [](const Session& s) { return s.document->pinned->known; });
  CHECK_FALSE(pin_is_pending(session));
  CHECK(knit::hash_of(session.document->pinned->end) == whole);
  CHECK(session.document->pinned->figures.finished);
}

TEST_CASE("ghost: what differs of the pinned run, in lines that stay the same", "[compare]") {
  Session session = small_session();
  Describer describer;
  apply(session, PinRun{});
  CHECK(ghosts_of(describer.describe(session)).empty());
  tune_epsilon(session, 0.05);
  session.document->timeline.extend_to_end();
  const LineSets first = ghosts_of(describer.describe(session));
  const RunDifference difference = difference_now(session);
  const auto same = static_cast<std::size_t>(difference.first_row->row) - 1;
  CHECK(first.size() > session.document->pinned->end.fabric.rows().size() - same);
  CHECK(first.size() <= session.document->pinned->end.fabric.rows().size() +
                            session.document->pinned->end.fabric.strips().size() - same);
  apply(session, ToFirst{});
  CHECK(ghosts_of(describer.describe(session)) == first);
  apply(session, SetLayer{Layer::column_edges, false});
  const LineSets rows = ghosts_of(describer.describe(session));
  CHECK(rows.size() < first.size());
  CHECK(std::includes(first.begin(), first.end(), rows.begin(), rows.end()));
  tune_epsilon(session, 0.15);
  session.document->timeline.extend_to_end();
  CHECK(ghosts_of(describer.describe(session)).empty());
  apply(session, Unpin{});
  tune_epsilon(session, 0.05);
  CHECK(ghosts_of(describer.describe(session)).empty());
}

TEST_CASE("set_knobs: exactly these parameters and edits, as a run of its own", "[timeline]") {
  Session session = small_session();
  knit::Timeline& timeline = session.document->timeline;
  timeline.extend_to_end();
  timeline.seek(timeline.position_of({knit::Stage::rows, 6, 2}));
  const knit::Place place = timeline.place();
  knit::Parameters base = timeline.base_parameters();
  knit::give_epsilon(base, 0.1);
  knit::Parameters later = base;
  later.rows.close = knit::Closing::none;
  const std::vector<knit::Edit> edits{{{knit::Stage::rows, 8, 0}, later}};
  timeline.set_knobs(base, edits);
  const Knobs wanted = resolved(Knobs{base, edits}, timeline.input());
  CHECK(timeline.base_parameters() == wanted.base);
  CHECK(timeline.edits() == wanted.edits);
  timeline.extend_to_end();
  CHECK(timeline.place() == place);
  CHECK(knit::hash_of(timeline.furthest()) ==
        knit::hash_of(whole_run(timeline.input(), {base, edits}).state));
  timeline.set_knobs(base, {});
  timeline.extend_to_end();
  CHECK(knit::hash_of(timeline.furthest()) == knit::hash_of(whole_run(timeline.input(), {base, {}}).state));
}

TEST_CASE("compare: what one of two runs lacks has a dash as its difference", "[compare]") {
  Session session = small_session();
  apply(session, PinRun{});
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.on_stall = knit::OnStall::stop;
  knit::give_epsilon(parameters, 0.001);
  apply(session, Tune{parameters});
  const RunDifference difference = difference_now(session);
  REQUIRE_FALSE(difference.stop_b.empty());
  const std::string dash = "\xE2\x80\x93";
  CHECK(figure(difference, "wale-cv").b == dash);
  CHECK(figure(difference, "wale-cv").difference == dash);
  CHECK(figure(difference, "wale-cv").differs());
  CHECK(figure(difference, "stalls").difference == "+1");
  apply(session, PinRun{});
  const RunDifference none = difference_now(session);
  CHECK(figure(none, "wale-cv").difference == dash);
  CHECK_FALSE(none.any());
}
