// Undo, redo, and parameters as text.
#include "app/session/changes.h"

#include "app/actions/parameters_text.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "tests/support/beside.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

knit::Parameters with(knit::Parameters parameters, const char* key, const std::string& value) {
  INFO(key);
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(key), parameters, value));
  return parameters;
}

void tune(Session& session, const char* key, const std::string& value, bool held = false) {
  apply(session, Tune{with(session.document->timeline.parameters(), key, value), held});
}

// What a session is about, for going there and back.
struct Mark {
  Knobs knobs;
  knit::Place place;
  std::uint64_t end = 0;
};
Mark mark(Session session) {
  session.document->timeline.extend_to_end();  // and back to its place
  return {knobs_of(session.document->timeline), session.document->timeline.place(),
          knit::hash_of(session.document->timeline.furthest())};
}

}  // namespace

TEST_CASE("undo and redo go through every kind of change, exactly, and keep the place") {
  Session session = small_session(true);
  apply(session, SeekPlace{{knit::Stage::rows, 6, 4}});
  std::vector<Mark> marks{mark(session)};
  const auto noted = [&] { marks.push_back(mark(session)); };
  tune(session, "epsilon", "0.2"), noted();
  apply(session, EditFromHere{with(session.document->timeline.parameters(), "epsilon", "0.28")}), noted();
  tune(session, "close", "thesis"), noted();
  tune(session, "weld", "on"), noted();
  apply(session, ApplyPreset{"best-rows"}), noted();
  apply(session, RemoveEdit{0}), noted();
  apply(session, PasteParameters{"stitch-width = 0.35\n"}), noted();
  apply(session, SetPicking{Picking::end});
  apply(session, PickVertex{70}), noted();
  REQUIRE(session.document->changes.undo.size() == marks.size() - 1);
  for (std::size_t i = marks.size() - 1; i-- > 0;) {
    CAPTURE(i);
    apply(session, Undo{});
    CHECK(mark(session).knobs == marks[i].knobs);
    CHECK(mark(session).end == marks[i].end);
  }
  apply(session, Undo{});
  CHECK(mark(session).knobs == marks.front().knobs);
  for (std::size_t i = 1; i < marks.size(); ++i) {
    CAPTURE(i);
    apply(session, Redo{});
    CHECK(mark(session).knobs == marks[i].knobs);
    CHECK(mark(session).end == marks[i].end);
  }
  apply(session, Redo{});
  CHECK(mark(session).knobs == marks.back().knobs);
  CHECK(session.outbox->notices.empty());
}

TEST_CASE("a drag is one entry, another parameter or a new hand is another") {
  Session session = small_session();
  const Knobs before = knobs_of(session.document->timeline);
  for (const char* width : {"0.31", "0.32", "0.33"}) tune(session, "stitch-width", width, true);
  CHECK(session.document->changes.undo.size() == 1);
  tune(session, "epsilon", "0.16", true);
  tune(session, "epsilon", "0.17", true);
  CHECK(session.document->changes.undo.size() == 2);
  apply(session, PassTime{0.1});
  apply(session, Orbit{0.1, 0.1});
  tune(session, "epsilon", "0.18", true);
  CHECK(session.document->changes.undo.size() == 2);
  apply(session, Settle{});
  tune(session, "epsilon", "0.19", true);
  CHECK(session.document->changes.undo.size() == 3);
  tune(session, "epsilon", "0.2");  // a click
  tune(session, "epsilon", "0.21");
  CHECK(session.document->changes.undo.size() == 5);
  for (int i = 0; i < 5; ++i) apply(session, Undo{});
  CHECK(knobs_of(session.document->timeline) == before);
}

TEST_CASE("a drag that counts from here is one entry too") {
  Session session = small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 6, 4}});
  for (const char* epsilon : {"0.16", "0.17", "0.18"})
    apply(session, EditFromHere{with(session.document->timeline.parameters(), "epsilon", epsilon), true});
  CHECK(session.document->changes.undo.size() == 1);
  CHECK(session.document->timeline.edits().size() == 1);
  apply(session, Undo{});
  CHECK(session.document->timeline.edits().empty());
}

TEST_CASE("only real changes are entries, and a new one ends redo") {
  Session session = small_session();
  apply(session, Tune{session.document->timeline.parameters()});
  tune(session, "start", "999999");  // refused
  apply(session, RemoveEdit{3});
  apply(session, ApplyPreset{"no such preset"});
  CHECK(session.document->changes.undo.empty());
  tune(session, "epsilon", "0.16", true);
  tune(session, "epsilon", "0.15", true);  // dragged back
  CHECK(session.document->changes.undo.empty());
  tune(session, "epsilon", "0.2");
  apply(session, Undo{});
  CHECK(session.document->changes.redo.size() == 1);
  tune(session, "close", "thesis");
  CHECK(session.document->changes.redo.empty());
  apply(session, OpenExample{"sphere"});
  REQUIRE(session.document);
  CHECK(session.document->changes.undo.empty());
  for (std::size_t i = 0; i < Changes::most + 20; ++i) tune(session, "cast-on", std::to_string(3 + i % 2));
  CHECK(session.document->changes.undo.size() == Changes::most);
}

TEST_CASE("what is cancelled leaves nothing to undo") {
  Session session = beside_session(large_parameters());
  tick_until(session, run_is_complete);
  const Knobs before = knobs_of(session.document->timeline);
  tune(session, "timing", "geodesic");
  tick_until(session, is_working);
  CHECK(session.document->changes.undo.size() == 1);
  apply(session, CancelWork{});
  CHECK(knobs_of(session.document->timeline) == before);
  CHECK(session.document->changes.undo.empty());
}

TEST_CASE("parameters as text read back equal, in the table's order") {
  knit::Parameters all =
      with(with(with(small_parameters(), "axis", "1,0.5,0.25"), "gauge", "21.7,33"), "start", "7");
  all.timing.level_tolerance = 1.0 / 30000.0;
  for (const knit::Parameters& p :
       {small_parameters(), knit::Parameters{}, all, with(all, "sizes", "gauge")}) {
    const std::string text = parameters_text(p);
    CHECK(lines_of(text).size() == knit::parameter_table().size());
    CHECK(text.rfind("weld = off\naxis = ", 0) == 0);
    const auto read = read_parameters_text("# a comment\r\n\n" + text, knit::Parameters{});
    REQUIRE(std::holds_alternative<knit::Parameters>(read));
    for (const knit::ParameterInfo& info : knit::parameter_table())
      CHECK(knit::same_value(info, std::get<knit::Parameters>(read), p));
  }
}

TEST_CASE("pasted text sets what it names, and a size makes its view the given one") {
  const auto read = read_parameters_text("  epsilon=0.07   # wider\nclose = thesis", small_parameters());
  REQUIRE(std::holds_alternative<knit::Parameters>(read));
  CHECK(std::get<knit::Parameters>(read) ==
        with(with(small_parameters(), "epsilon", "0.07"), "close", "thesis"));
  const auto gauge = read_parameters_text("gauge = 20,28", small_parameters());
  CHECK(std::get<knit::Parameters>(gauge).size.from() == knit::SizesFrom::gauge);
}

TEST_CASE("text that cannot be read is one sentence that names the line, and nothing is half done") {
  struct Case {
    std::string text, says;
  };
  const std::string long_word(5000, 'x');
  for (const Case& c : {Case{"close = arc\nepsilom = 0.1", "line 2: there is no parameter \"epsilom\""},
                        Case{"epsilon = wide", "line 1: epsilon cannot be \"wide\""},
                        Case{"\n\nepsilon = 0.1\nepsilon = 0.2", "line 4: epsilon is given a second time"},
                        Case{"hello", "line 1: \"hello\" is not \"key = value\""}, Case{"", "no parameter"},
                        Case{"# only a comment", "no parameter"}, Case{long_word, "..."},
                        Case{"gauge = 20,30\nstitch-width = 0.1", "sizes = mesh"},
                        Case{std::string("\x01\x02 = \xff", 6), "?"}}) {
    CAPTURE(c.says);
    const auto read = read_parameters_text(c.text, small_parameters());
    REQUIRE(std::holds_alternative<std::string>(read));
    const std::string& error = std::get<std::string>(read);
    CAPTURE(error);
    CHECK(contains(error, c.says));
    CHECK(is_one_sentence(error));
    CHECK(error.size() < 300);
    Session session = small_session();
    const Knobs before = knobs_of(session.document->timeline);
    apply(session, PasteParameters{c.text});
    CHECK(knobs_of(session.document->timeline) == before);
    REQUIRE(session.outbox->notices.size() == 1);
    CHECK(session.outbox->notices[0].kind == Notice::Kind::error);
  }
}

TEST_CASE("copy gives the clipboard what paste understands") {
  Session session = small_session();
  tune(session, "epsilon", "0.21");
  apply(session, CopyParameters{});
  REQUIRE(session.outbox->clipboard);
  Session other = small_session();
  apply(other, PasteParameters{*session.outbox->clipboard});
  CHECK(other.document->timeline.base_parameters() == session.document->timeline.base_parameters());
  CHECK(other.document->changes.undo.size() == 1);
}
