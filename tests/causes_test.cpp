// What decided, in words with the numbers: counts of rows, labels, vertices refused just before a stitch.
#include "knit/insight/causes.h"

#include <cstdlib>

#include "app/explain/why_words.h"
#include "app/script/queries.h"
#include "app/session/document.h"
#include "knit/insight/cause_parts.h"
#include "knit/insight/longest_wale.h"
#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "knit/rows/rows.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace knit;
using test_support::contains;

namespace {

Timeline whole(Timeline timeline) {
  timeline.extend_to_end();
  return timeline;
}

Timeline example(const std::string& name) {
  app::Session session = test_support::example_session(name);
  REQUIRE(session.document);
  return whole(std::move(session.document->timeline));
}

Timeline contours(double width, double height, std::int32_t cast_on) {
  Parameters parameters = test_support::small_parameters();
  parameters.rows.source = RowSource::contours;
  parameters.rows.cast_on = cast_on;
  give_width(parameters, width);
  give_height(parameters, height);
  return whole({test_support::small_sphere(), parameters});
}

// The number that stands before these words.
std::int32_t number_before(const std::string& text, const std::string& words) {
  const std::size_t end = text.find(words);
  REQUIRE(end != std::string::npos);
  std::size_t begin = end;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(text[begin - 1])) != 0) --begin;
  return std::atoi(text.substr(begin, end - begin).c_str());
}

}  // namespace

TEST_CASE("causes: why row 7 of the thesis sphere has 33 stitches, with the numbers that decided") {
  const Timeline timeline = example("thesis-sphere");
  CHECK(why_count(timeline, 7) ==
        "Row 7 has 33 stitches: the first of the 129 vertices of its cycle and every 4th after it. The 4th "
        "after "
        "a stitch is 0.06507 away, the first in the band, which begins at 0.05; the 3rd is only 0.04883 "
        "away, too "
        "near. The last stands on the first, of which the cycle's last vertex is a copy. Row 8 takes every "
        "3rd of "
        "129: there the 3rd is already 0.05548 away.");
  // The other way round, where the row beside it needs more vertices.
  CHECK(why_count(timeline, 12)
            .ends_with("Row 11 takes every 3rd of 129: there the 2nd is only 0.04975 away."));
  CHECK(contains(why_count(timeline, 12), "the next is only 0.0269 away, too near"));
  CHECK(contains(why_count(timeline, 1), "6 stitches: so many are cast on unless a person asks for others"));
  CHECK(why_count(timeline, 65).empty());
  CHECK(why_count(timeline, 0).empty());
}

TEST_CASE("causes: the pace that is told gives the row's stitches") {
  const Timeline timeline = whole({test_support::small_sphere(), test_support::small_parameters()});
  std::size_t even = 0;
  for (RowId row = 2; row <= timeline.furthest().fabric.row_count(); ++row) {
    const std::string why = why_count(timeline, row);
    INFO(why);
    REQUIRE_FALSE(why.empty());
    if (contains(why, "mostly") || contains(why, "spread evenly") || contains(why, "dropped")) continue;
    ++even;
    const auto ring = ring_of_row(timeline.furthest(), row);
    const bool all = contains(why, "all of the");
    const std::int32_t every = all ? 1
                                   : number_before(why, contains(why, "nd after it")   ? "nd after it"
                                                        : contains(why, "rd after it") ? "rd after it"
                                                                                       : "th after it");
    const auto vertices = static_cast<std::int32_t>(ring->vertices.size());
    CHECK(number_before(why, " vertices of") == vertices);
    CHECK(size_of(timeline.furthest().fabric.row(row)) == (vertices - 1) / every + 1);
  }
  CHECK(even > 5);
}

TEST_CASE("causes: of a row from a contour the length, what it holds, the limit and the rows ahead") {
  const Timeline doubled = contours(0.1, 0.3, 7);
  CHECK(contains(why_count(doubled, 1), "7 stitches: so many were asked for to cast on; its loop is"));
  CHECK(contains(why_count(doubled, 2), "but a row at most doubles what it is worked on: 2 x 7 = 14."));
  CHECK(contains(why_count(contours(0.4, 0.1, 7), 2),
                 "but a row has at least half of what it is worked on: 7 / 2 = 3.5."));
  CHECK(contains(why_count(contours(0.3, 0.1, 7), 30), "holds 2.11 stitches of 0.3, but a round needs 3."));
  CHECK(why_count(contours(0.1, 0.1, 7), 29) ==
        "Row 29 has 12 stitches: its loop is 1.264 long, which holds 12.64 stitches of 0.1; on the 19 below "
        "there "
        "may be 10 to 38. The row above holds 6.33; on 13 row 30 could have no fewer than 7, on 12 as few as "
        "6.");
  const std::string plain = why_count(doubled, 8);
  CHECK(contains(plain, " stitches of 0.1, rounded; on the "));
}

TEST_CASE("causes: a row after a deal says whose loops it is worked on") {
  const Timeline timeline = example("trousers");
  const Fabric& fabric = timeline.furthest().fabric;
  std::size_t told = 0;
  for (RowId row = 2; row <= fabric.row_count(); ++row) {
    const Row* below = fabric.row_below(row);
    const bool first =
        !fabric.row(row).on.empty() && (below == nullptr || below->tube != fabric.row(row).tube);
    const std::string why = why_count(timeline, row);
    CHECK(contains(why, "It is the first row of tube ") == first);
    if (first) CHECK(contains(why, "of the bridge of deal 1"));
    told += first ? 1U : 0U;
  }
  CHECK(told == 1);
}

TEST_CASE("causes: a spread row says what was picked before") {
  Parameters parameters = test_support::small_parameters();
  give_epsilon(parameters, 0.02);
  parameters.rows.cast_on = 3;  // so that the next row is more than twice as many
  const Timeline timeline = whole({test_support::small_sphere(), parameters});
  std::size_t spread = 0, missed = 0;
  for (RowId row = 2; row <= timeline.furthest().fabric.row_count(); ++row) {
    const std::string why = why_count(timeline, row);
    const bool resampled = is<RowResampled>(timeline.step(*count_decided_by(timeline, row)));
    CHECK(contains(why, ": they are spread evenly. Row ") == resampled);
    spread += resampled ? 1U : 0U;
    missed += contains(why, "the vertex nearest to the stitch width was taken") ? 1U : 0U;
  }
  CHECK(spread > 0);
  CHECK(missed > 0);
}

TEST_CASE("causes: each label says which rule and which neighbour decided, and never contradicts the join") {
  const std::string name = GENERATE("thesis-sphere", "trousers");
  CAPTURE(name);
  const Timeline timeline = example(name);
  std::size_t shaping = 0;
  for (const auto& join : timeline.furthest().fabric.joins()) {
    for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(join->labels.size()); ++cell) {
      const std::string why = why_label(timeline, {join->to, cell});
      REQUIRE(why.size() > 20);
      const Label label = join->labels[static_cast<std::size_t>(cell)];
      if (join->rule == Rule::nearest && label == Label::main) {
        const Row* below = timeline.furthest().fabric.row_below(join->to);
        CHECK(contains(why, "spread evenly") == (below != nullptr && below->on.empty()));
      }
      if (!is_shaping(label) || join->rule == Rule::from_cast_on || join->rule == Rule::dense) continue;
      ++shaping;
      CHECK(contains(why, "is " + std::string(name_of(label))));
      if (join->rule == Rule::nearest) continue;
      // The main that is named stands there.
      const std::int32_t main = std::atoi(why.substr(why.find("main in cell ") + 13).c_str()) - 1;
      CHECK(join->labels[static_cast<std::size_t>(main)] == Label::main);
    }
  }
  CHECK(shaping > 20);
  CHECK(why_label(timeline, {1, 0}).empty());
  CHECK(why_label(timeline, {2, 9999}).empty());
}

TEST_CASE("causes: which vertex was refused just before stitch 5 of row 20, and what was taken instead") {
  app::Session session = test_support::example_session("thesis-sphere");
  const app::Answer answer = app::why_answer(session, app::text_of(StitchElement{20, 4}));
  CHECK(contains(answer.out,
                 "Just before it vertex 2459 was refused: 0.04039 from stitch 4, nearer than 0.05."));
  CHECK(contains(answer.out, "refused\tstep 10672\t"));
  const Timeline& timeline = session.document->timeline;
  CHECK(contains(app::why_words(timeline, VertexElement{2459}),
                 "Vertex 2460 became stitch 5 instead, 0.08076 away."));
  CHECK(why_refused_before(timeline, {20, 0}).empty());
  CHECK(why_refused_before(timeline, {1, 3}).empty());
}

TEST_CASE("causes: why of a row by name, and what cannot be one") {
  app::Session session = test_support::finished_small_session();
  const app::Answer answer = app::why_answer(session, "row 7");
  CHECK(answer.exit_code == app::exit_done);
  CHECK(answer.out.find("Row 7 has ") == 0);
  CHECK(contains(answer.out, "\ndecided\tstep "));
  const auto decided = count_decided_by(session.document->timeline, 7);
  CHECK(session.document->timeline.position() == *decided + 1);
  CHECK(app::why_answer(session, "row 700").exit_code == app::exit_usage);
  CHECK(app::row_named("row:12") == 12);
  for (const char* wrong : {"row", "row 0", "row -1", "row x", "rows 3", "row7"}) {
    CAPTURE(wrong);
    CHECK_FALSE(app::row_named(wrong));
    CHECK(app::fault_of_why(wrong));
  }
}

TEST_CASE("causes: the last step of a row says why it has its stitches, in every stage") {
  app::Session session = test_support::finished_small_session();
  const Timeline& timeline = session.document->timeline;
  for (const Stage stage : {Stage::rows, Stage::stitches, Stage::faces, Stage::pattern}) {
    const StepRange steps = steps_of_row(timeline, stage, 5);
    REQUIRE(steps.begin < steps.end);
    CHECK(contains(cause_of(timeline, steps.end - 1), why_count(timeline, 5)));
  }
  const StepRange rows = steps_of_row(timeline, Stage::rows, 5);
  CHECK(cause_of(timeline, rows.begin).empty());
  CHECK(cause_of(timeline, timeline.known() + 5).empty());
  CHECK(app::cause(app::Session{}).empty());
}

TEST_CASE("causes: the why of a label says its step and which of its kind it is") {
  const Timeline timeline = example("thesis-sphere");
  for (const auto& join : timeline.furthest().fabric.joins()) {
    std::int32_t seen = 0;
    for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(join->labels.size()); ++cell) {
      if (join->labels[static_cast<std::size_t>(cell)] != Label::k2tog || ++seen != 3) continue;
      const LabelElement third{join->to, cell};
      const std::string words = app::why_words(timeline, third);
      CHECK(contains(words, "It is K2tog 3 of "));
      CHECK(contains(words, "Made at step " + std::to_string(*made_by(timeline, third) + 1) + "."));
      return;
    }
  }
  FAIL("no third k2tog");
}

TEST_CASE("causes: how long the longest wale is, and where") {
  app::Session session = test_support::example_session("thesis-sphere");
  const app::Answer answer = app::why_answer(session, "longest wale");
  CHECK(answer.exit_code == app::exit_done);
  const Timeline& timeline = session.document->timeline;
  const auto longest = longest_wale(timeline.furthest().fabric);
  REQUIRE(longest);
  CHECK(longest->length == Approx(wale_figures(timeline.furthest()).high));
  CHECK(contains(answer.out, "The longest wale: it is " + short_number(longest->length) + " long, "));
  const auto end = [](const StitchRef& ref) {
    return "stitch " + std::to_string(ref.stitch + 1) + " of row " + std::to_string(ref.row);
  };
  CHECK(contains(answer.out, " h, from " + end(longest->below) + " to " + end(longest->above) + "."));
  const ColumnEdgeElement other{2, longest->row == 2 && longest->cell == 0 ? 1 : 0};
  CHECK(contains(app::why_words(timeline, other), " It is "));
  CHECK_FALSE(contains(app::why_words(timeline, other), "longest"));
  CHECK_FALSE(longest_wale(Fabric()));
  CHECK_FALSE(app::fault_of_why("longest wale"));
}

TEST_CASE("causes: ordinals") {
  for (const auto& [n, words] : {std::pair{1, "1st"},
                                 {2, "2nd"},
                                 {3, "3rd"},
                                 {4, "4th"},
                                 {11, "11th"},
                                 {12, "12th"},
                                 {13, "13th"},
                                 {21, "21st"},
                                 {102, "102nd"},
                                 {111, "111th"}})
    CHECK(nth_text(n) == words);
}
