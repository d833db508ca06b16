// Going to a place by its name: what is understood, where it leads and what is said of it, with figures worked out beside.
#include "app/explain/destination.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/explain/destination_reader.h"
#include "app/script/queries.h"
#include "app/session/outbox.h"
#include "app/session/remarks.h"
#include "knit/insight/causes.h"
#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

Destination there(const Session& session, const std::string& typed) {
  const auto found = destination_of(session, typed);
  const auto* none = std::get_if<NoDestination>(&found);
  INFO(typed << ": " << (none != nullptr ? none->why : ""));
  REQUIRE(none == nullptr);
  return std::get<Destination>(found);
}

// The sentence of why not.
NoDestination nowhere_at(const Session& session, const std::string& typed) {
  const auto found = destination_of(session, typed);
  INFO(typed);
  REQUIRE(std::holds_alternative<NoDestination>(found));
  return std::get<NoDestination>(found);
}

bool says(const std::string& words, const std::string& part) { return words.find(part) != std::string::npos; }

const knit::Fabric& fabric_of(const Session& session) { return session.document->timeline.furthest().fabric; }

}  // namespace

TEST_CASE("a place is read in any case and in the words that people use, and nothing else is") {
  const auto is = [](const std::string& typed, Goal goal) {
    const auto wish = read_place_wish(typed);
    INFO(typed);
    REQUIRE(wish);
    CHECK(wish->goal == goal);
    return *wish;
  };
  CHECK(is("Row 7", Goal::row).number == 7);
  CHECK(is("  go to the row 7 ", Goal::row).number == 7);
  CHECK(is("round 12 of Leg A", Goal::round).piece == "leg a");
  CHECK(is("STITCH 20:5", Goal::stitch).row == 20);
  CHECK(is("stitch 5 of row 20", Goal::stitch).number == 5);
  CHECK(is("vertex 2461", Goal::vertex).number == 2461);
  CHECK(is("step 17342", Goal::step).number == 17342);
  is("widest round", Goal::widest);
  is("longest wale", Goal::longest_wale);
  CHECK(is("first problem", Goal::problem).which == WhichOne{WhichOne::Kind::nth, 1});
  CHECK(is("problem 3", Goal::problem).which.count == 3);
  CHECK(is("43 to 65", Goal::change).second == 65);
  CHECK(is("43 -> 65", Goal::change).second == 65);
  CHECK(is("43\xE2\x86\x92"
           "65",
           Goal::change)
            .number == 43);
  CHECK(is("third k2tog of round 24", Goal::operation).row == 24);
  CHECK(is("k2tog 3 of row 24", Goal::operation).which.count == 3);
  CHECK(is("12th m1l", Goal::operation).which.count == 12);
  CHECK(is("3rd k2tog after the widest round", Goal::operation).after_widest);
  for (const char* falling :
       {"third k2tog of the decreasing half", "3rd k2tog in the second half", "k2tog 3 of the upper half"})
    CHECK(is(falling, Goal::operation).after_widest);
  for (const char* rising :
       {"first m1l of the increasing half", "m1l 2 of the first half", "last increase in the lower half"})
    CHECK(is(rising, Goal::operation).until_widest);
  CHECK(is("third k2tog of the decreasing half", Goal::operation).which.count == 3);
  CHECK(is("next decrease", Goal::operation).which.kind == WhichOne::Kind::next);
  CHECK(is("why row 7", Goal::row).why);
  CHECK(is("why not vertex 120?", Goal::vertex).why);
  CHECK(is("why did it stop", Goal::stop).why);
  CHECK(is("rows:14:12", Goal::at).at == "rows:14:12");
  for (const char* no : {"",
                         "7",
                         "row",
                         "row seven",
                         "row 7 of",
                         "banana",
                         "stitch",
                         "stitch 20",
                         "43 to",
                         "step",
                         "third",
                         "third row 7",
                         "0th k2tog",
                         "k2tog 0 of row 3",
                         "widest",
                         "why",
                         "why banana",
                         "third k2tog of the other half",
                         "third k2tog after the decreasing half",
                         "third k2tog of the decreasing half of it",
                         "round 7 with Leg A",
                         "vertex 1 2",
                         "problem",
                         "-3 to 4 to 5"}) {
    INFO(no);
    CHECK_FALSE(read_place_wish(no));
  }
}

TEST_CASE("a row, a stitch, a vertex and a step lead to where they were made, and are told before") {
  Session session = test_support::finished_small_session();
  const knit::Fabric& fabric = fabric_of(session);
  const Destination row = there(session, "row 3");
  CHECK(says(row.words, "Row 3 has " + knit::stitch_count_text(knit::size_of(fabric.row(3)))));
  REQUIRE(row.place);
  apply(session, GoTo{"ROW 3"});
  CHECK(session.document->timeline.state().fabric.row_count() == 3);
  CHECK(session.document->place_note == row.words);
  const Destination stitch = there(session, "stitch 3:5");
  CHECK(stitch.thing == knit::Element(knit::StitchElement{3, 4}));
  CHECK(there(session, "stitch 5 of row 3").thing == stitch.thing);
  apply(session, GoTo{"stitch 3:5"});
  CHECK(session.document->travel.selected == stitch.thing);
  CHECK(session.document->timeline.position() ==
        *knit::made_by(session.document->timeline, *stitch.thing) + 1);
  CHECK(there(session, "step 12").position == 12);
  CHECK(there(session, "vertex 100").thing);
  // Back to where one was, as after any jump.
  apply(session, GoBack{});
  CHECK(session.document->timeline.state().fabric.row_count() == 3);
}

TEST_CASE("what is not there is said in one sentence, and nobody is moved") {
  Session session = test_support::finished_small_session();
  const std::size_t position = session.document->timeline.position();
  for (const char* no : {"row 999", "row 0", "stitch 3:999", "stitch 999:1", "vertex 99999999",
                         "step 99999999", "1 to 2", "999th k2tog", "k2tog 1 of row 2", "round 12 of Leg A",
                         "why stitch", "why not vertex", "next k2tog", "999th problem"}) {
    const NoDestination none = nowhere_at(session, no);
    INFO(no << ": " << none.why);
    CHECK(none.understood);
    CHECK(test_support::is_one_sentence(none.why));
    apply(session, GoTo{no});
    CHECK(session.document->timeline.position() == position);
    REQUIRE(!session.outbox->notices.empty());
    CHECK(session.outbox->notices.back().text == none.why);
  }
  CHECK_FALSE(nowhere_at(session, "banana").understood);
  CHECK(says(nowhere_at(session, "banana").why, "third k2tog of round 24"));
}

TEST_CASE("widest, longest and a change of counts are those of the rows themselves") {
  Session session = test_support::finished_small_session();
  const knit::Fabric& fabric = fabric_of(session);
  std::int32_t most = 0, widest = 0;
  for (const auto& row : fabric.rows()) {
    if (knit::size_of(*row) <= most) continue;
    most = knit::size_of(*row);
    widest = row->id;
  }
  CHECK(says(there(session, "widest round").words,
             "row " + std::to_string(widest) + ": " + knit::stitch_count_text(most)));
  CHECK(there(session, "widest row").place->row == widest);
  const std::string change =
      std::to_string(knit::size_of(fabric.row(1))) + " to " + std::to_string(knit::size_of(fabric.row(2)));
  CHECK(there(session, change).place->row == 2);
  double longest = 0.0;
  const knit::KnittingPath path(fabric);
  for (const auto& strip : fabric.strips())
    for (const auto& edge : strip->column_edges)
      longest = std::max(longest, glm::distance(path.position(edge[0]), path.position(edge[1])));
  const Destination wale = there(session, "longest wale");
  CHECK(says(wale.words, ": " + knit::short_number(longest) + " in mesh units"));
  CHECK_FALSE(wale.position);  // it is seen already
  apply(session, ToFirst{});
  CHECK(there(session, "longest wale").position);
}

TEST_CASE("a widest round that is far from what the mesh has around says so") {
  Session session = test_support::example_session("thesis-sphere");
  session.document->timeline.extend_to_end();
  const std::string near = there(session, "widest round").words;
  CHECK(says(near, "65 stitches, 39 cm around"));
  CHECK_FALSE(says(near, "The mesh is"));
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::give_gauge(parameters, {22.0, 32.0});
  apply(session, Tune{parameters});
  session.document->timeline.extend_to_end();
  CHECK(says(there(session, "widest round").words,
             "129 stitches, 58.64 cm around at 22 stitches in 10 cm. 27 more rows have as "
             "many. The mesh is 37.68 cm around at its widest."));
}

TEST_CASE("operations count as hands work them, and next and previous go by the steps") {
  Session session = test_support::finished_small_session();
  const knit::Fabric& fabric = fabric_of(session);
  // The third of all decreases, counted here.
  std::vector<knit::LabelElement> decreases;
  for (const auto& join : fabric.joins())
    for (std::size_t cell = 0; cell < join->labels.size(); ++cell)
      if (knit::is_decrease(join->labels[cell]))
        decreases.push_back({join->to, static_cast<std::int32_t>(cell)});
  REQUIRE(decreases.size() > 3);
  CHECK(there(session, "third decrease").thing == knit::Element(decreases[2]));
  CHECK(there(session, "decrease 3 after the widest round").thing == knit::Element(decreases[2]));
  CHECK(there(session, "third decrease of the decreasing half").thing == knit::Element(decreases[2]));
  CHECK(says(there(session, "third decrease of the decreasing half").words, ", the widest: "));
  const auto widest = there(session, "widest round").place->row;
  const auto last_increase = there(session, "last increase of the first half").thing;
  REQUIRE(last_increase);
  CHECK(std::get<knit::LabelElement>(*last_increase).row <= widest);
  CHECK(says(nowhere_at(session, "first decrease of the increasing half").why,
             "There is no decrease up to row "));
  CHECK(there(session, "last decrease").thing == knit::Element(decreases.back()));
  const std::string in_row = "first decrease of round " + std::to_string(decreases[0].row);
  CHECK(there(session, in_row).thing == knit::Element(decreases[0]));
  apply(session, GoTo{"third decrease"});
  const std::size_t third = session.document->timeline.position();
  CHECK(third == *knit::made_by(session.document->timeline, decreases[2]) + 1);
  apply(session, GoTo{"next decrease"});
  CHECK(session.document->timeline.position() > third);
  apply(session, GoTo{"previous decrease"});
  CHECK(session.document->timeline.position() == third);
}

TEST_CASE("why is asked of what is shown or selected, and the answer stays") {
  Session session = test_support::finished_small_session();
  apply(session, GoTo{"why row 4"});
  const auto decided = knit::count_decided_by(session.document->timeline, 4);
  REQUIRE(decided);
  CHECK(session.document->timeline.position() == *decided + 1);
  CHECK(session.outbox->notices.back().text == knit::why_count(session.document->timeline, 4));
  CHECK(says(there(session, "why row").words, "Row 4 has "));
  apply(session, Select{knit::StitchElement{3, 4}});
  CHECK(says(there(session, "why stitch").words, "Stitch 5 of row 3 (step "));
  CHECK(nowhere_at(session, "why not vertex").why.rfind("Click a vertex", 0) == 0);
  apply(session, Select{knit::VertexElement{100}});
  CHECK(there(session, "why not vertex").thing == knit::Element(knit::VertexElement{100}));
  CHECK(there(session, "why stopped").words ==
        "The run did not stop: it is finished. Knitted along y from rings.");
  for (const WhyQuestion& question : why_questions()) {
    INFO(question.words);
    CHECK(read_place_wish(std::string(question.where))->why);
  }
}

TEST_CASE("a run that stopped says where and why") {
  Session session = test_support::torus_from_rings();
  apply(session, ToLast{});
  REQUIRE(session.document->timeline.stop() != nullptr);
  const Destination stop = there(session, "why stopped");
  CHECK(stop.position == session.document->timeline.known());
  CHECK(says(there(session, "last problem").words, stop.words));
}

TEST_CASE("of a run in the making what is known counts, and rows to come are waited for") {
  Session session = test_support::small_session();
  session.document->timeline.extend(1);
  const Destination row = there(session, "row 5");
  CHECK(says(row.words, "not worked out yet"));
  apply(session, GoTo{"row 5"});
  CHECK(session.document->timeline.place().row == 5);
}

TEST_CASE("what is typed is completed by the forms") {
  const Session session = test_support::finished_small_session();
  const auto has = [&](const std::string& typed, const std::string& text) {
    const auto texts = completions_of(session, typed);
    INFO(typed << ": " << text);
    CHECK(std::find(texts.begin(), texts.end(), text) != texts.end());
  };
  has("wi", "widest round");
  has("WI", "widest round");
  has("why", "why stopped");
  has("third k2tog of", "third k2tog of the decreasing half");
  CHECK(completions_of(session, "banana").empty());
  for (const std::string& form : completions_of(session, "")) {
    INFO(form);
    CHECK(read_place_wish(form));
  }
}

TEST_CASE("rounds of pieces go by the pieces' names, letters, or words that only one has") {
  Session session = test_support::example_session("trousers");
  apply(session, ToLast{});
  apply(session, SetPieceNames{{{"A", "Shin"}}});
  REQUIRE(piece_names_of(session).front() == "Shin A");
  const Destination third = there(session, "round 3 of Shin A");
  CHECK(says(third.words, "Round 3 of Shin A. Row "));
  CHECK(there(session, "ROUND 3 OF a").place == third.place);
  CHECK(there(session, "round 3 in shin").place == third.place);
  CHECK(there(session, "round 3 of b").place != third.place);
  CHECK(says(nowhere_at(session, "round 3").why, "round 3 of Shin A, "));
  CHECK(says(nowhere_at(session, "round 999 of Shin A").why, "Shin A has "));
  CHECK(says(nowhere_at(session, "round 3 of Tail").why, "No piece is called \"tail\"."));
  const auto texts = completions_of(session, "round 3 of sh");
  REQUIRE(texts.size() == 1);
  CHECK(texts[0] == "round 3 of Shin A");
}

TEST_CASE("where no step is a problem, what is remarked on the whole run is gone to") {
  Session session = test_support::example_session("thesis-sphere");
  apply(session, ToLast{});
  CHECK(says(nowhere_at(session, "first problem").why, "No step of the run is a problem."));
  session.document->closeness = closeness_now(*session.document);
  const Destination remark = there(session, "first problem");
  CHECK(says(remark.words, "No step of the run is a problem; remark 1 of "));
  CHECK(there(session, "problem 2").thing);  // of rows; the first is about the whole piece
  CHECK(nowhere_at(session, "problem 999").understood);
  // As the list has them: what was found in the mesh counts, and comes first.
  session.document->findings.push_back(
      {knit::FindingKind::unreferenced, knit::Severity::warning, 3, {}, "It has 3 loose vertices."});
  const std::vector<ListedRemark> listed = listed_remarks(session);
  const std::string of_all = " of " + std::to_string(listed.size()) + ": ";
  CHECK(says(there(session, "problem 1").words, "remark 1" + of_all + "Mesh: It has 3 loose vertices."));
  CHECK(says(there(session, "problem 2").words, "remark 2" + of_all + "Piece: "));
  CHECK(says(there(session, "last problem").words, "remark " + std::to_string(listed.size()) + of_all));
}

TEST_CASE("past the last step that is a problem the remarks go on") {
  Session session = test_support::torus_from_rings();
  apply(session, ToLast{});
  CHECK(says(nowhere_at(session, "problem 2").why, "The run has 1 problem."));
  session.document->findings.push_back(
      {knit::FindingKind::unreferenced, knit::Severity::warning, 3, {}, "It has 3 loose vertices."});
  CHECK(says(there(session, "problem 1").words, "Problem 1 of 1: "));
  CHECK(there(session, "problem 2").words ==
        "The run has 1 problem; remark 1 of 1: Mesh: It has 3 loose vertices.");
  CHECK(nowhere_at(session, "problem 3").why == "The run has 1 problem, and there is 1 remark.");
}

TEST_CASE("a script goes to a place by its name and is told what is there") {
  Session session = test_support::small_session();
  const Answer answer = go_to_answer(session, "row 3");
  CHECK(answer.exit_code == exit_done);
  CHECK(answer.out.rfind("Row 3 has ", 0) == 0);
  CHECK(answer.out.back() == '\n');
  CHECK(session.document->timeline.state().fabric.row_count() == 3);
  CHECK(go_to_answer(session, "row 999").exit_code == exit_usage);
  CHECK_FALSE(fault_of_go_to("row 999"));
  CHECK(test_support::is_one_sentence(fault_of_go_to("banana").value_or("")));
}

TEST_CASE("why a run from contours did not stop says how it is knitted, and why rings would have stopped") {
  Session session = test_support::example_session("torus");
  session.document->timeline.extend_to_end();
  REQUIRE(session.document->timeline.stop() == nullptr);
  const std::string words = there(session, "why stopped").words;
  INFO(words);
  CHECK(says(words, "The run did not stop: it is finished. Knitted along "));
  CHECK(words.find(" from contours, as 4 tubes. 28 rounds, 2 yarns, 1 split, 1 join.") != std::string::npos);
  Session rings = test_support::torus_from_rings();
  rings.document->timeline.extend_to_end();
  const knit::Timeline& stopped = rings.document->timeline;
  REQUIRE(stopped.stop() != nullptr);
  CHECK(words.ends_with(" With rows from rings it would have stopped: " +
                        knit::narrate(*stopped.stop(), stopped.parameters_of_stop())));
}
