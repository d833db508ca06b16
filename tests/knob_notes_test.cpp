// Under a knob: what follows its change, and a gauge that is hardly one fabric.
#include "app/panels/parameters/knob_notes.h"

#include <map>
#include <string>

#include "knit/insight/as_asked.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace app;
using desk::Desk;
using desk::only;

namespace {

const knit::ParameterInfo& info_of_key(std::string_view key) { return *knit::find_parameter(key); }

bool says_words(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("what follows a typed value is said with what it was and is, and nothing that nothing reads") {
  const auto input = test_support::example_session("thesis-sphere").document->timeline.input_pointer();
  knit::Parameters before;
  knit::give_width(before, 0.1);
  before.rows.source = knit::RowSource::rings;
  before = knit::resolved(before, *input);
  knit::Parameters now = before;
  knit::give_gauge(now, {22.0, 32.0});
  now = knit::resolved(now, *input);
  const std::string words = follow_words(info_of_key(knit::keys::gauge), before, now);
  CHECK(says_words(words, "Follows: "));
  CHECK(says_words(words, "w 0.1 \xE2\x86\x92 0.075758"));
  CHECK(says_words(words, "\xCE\xB5 0.05 \xE2\x86\x92 0.037879"));
  CHECK_FALSE(says_words(words, "Gauge"));
  now.rows.source = knit::RowSource::contours;
  CHECK_FALSE(says_words(follow_words(info_of_key(knit::keys::gauge), before, now), "\xCE\xB5"));
  CHECK(follow_words(info_of_key(knit::keys::gauge), before, before).empty());
}

TEST_CASE("a knob says what follows as long as it has the value that was given") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  desk.settle();
  desk.act(desk.click("knob/stitch-width", 0.3f));
  desk.settle();
  for (const char c : std::string("0.5")) desk.act(desk.frames({Text{static_cast<char32_t>(c)}}));
  desk.act(desk.press({Key::Enter}));
  desk.settle();
  REQUIRE(desk.session.document->timeline.parameters().stitch.width == 0.5);
  CHECK(desk.ui.controls.count("knob-follows/stitch-width") == 1);
  CHECK(desk.ui.own<KnobFollow>().before->stitch.width == 0.45);
  apply(desk.session, Undo{});
  desk.settle();
  CHECK(desk.ui.controls.count("knob-follows/stitch-width") == 0);
}

TEST_CASE("rounds that hardly go with the stitches of a gauge are remarked at once, with those that do") {
  CHECK_FALSE(knit::rounds_that_go_with({18, 25}));
  CHECK(knit::rounds_that_go_with({18, 30.093}) == 25.0);
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  desk.settle();
  CHECK(desk.ui.controls.count("knob-swatch") == 0);
  knit::Parameters parameters = desk.session.document->timeline.parameters();
  knit::give_gauge(parameters, {18, 30.093});
  apply(desk.session, Tune{parameters});
  desk.settle();
  REQUIRE(desk.ui.controls.count("knob-swatch") == 1);
  const knit::Parameters taken = only<Tune>(desk.click("knob-swatch/take")).parameters;
  CHECK(taken.stitch.gauge == knit::Gauge{18, 25});
}

TEST_CASE("the name of a parameter stands beside its field and not on a line of its own") {
  // As wide as at 1280 x 720, and so high that all knobs are seen.
  Desk desk(1280, 2400, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  if (GENERATE(true, false)) {  // else rows from rings
    knit::Parameters parameters = desk.session.document->timeline.parameters();
    for (const auto& [key, value] :
         {std::pair("rows", "contours"), {"counts", "rhythm"}, {"short-rows", "auto"}, {"settle", "on"}}) {
      INFO(key);
      REQUIRE_FALSE(knit::set_value(info_of_key(key), parameters, value));
    }
    apply(desk.session, Tune{parameters});
  }
  desk.settle();
  std::size_t names = 0;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const auto name = desk.ui.controls.find("knob-label/" + std::string(info.key));
    const auto field = desk.ui.controls.find("knob/" + std::string(info.key));
    if (name == desk.ui.controls.end() || field == desk.ui.controls.end()) continue;
    ++names;
    INFO(info.label << ", field " << field->second.width << " wide");
    CHECK(name->second.y < field->second.y + field->second.height);
    CHECK(field->second.y < name->second.y + name->second.height);
    CHECK(name->second.right() <= field->second.x);
    CHECK(field->second.width >= 72.0f);
  }
  CHECK(names >= 10);
}

TEST_CASE("knobs keep their places when the panel's scrollbar comes or goes") {
  std::map<std::string, Box> first;
  for (const float height : {720.0f, 2400.0f}) {
    Desk desk(1280, height, 1, KNIT_ASSETS_DIR "/fonts");
    desk.open();
    knit::Parameters parameters = desk.session.document->timeline.parameters();
    parameters.rows.source = knit::RowSource::contours;
    apply(desk.session, Tune{parameters});
    desk.settle();
    for (const auto& [name, box] : desk.ui.controls) {
      if (name.rfind("knob", 0) != 0) continue;
      if (height < 1000.0f) {
        first[name] = box;
      } else if (const auto before = first.find(name); before != first.end()) {
        INFO(name);
        CHECK(box.x == before->second.x);
        CHECK(box.y == before->second.y);
        CHECK(box.width == before->second.width);
      }
    }
  }
  CHECK(first.size() >= 20);
}
