// Numbers in the panels: typed, tabbed and dragged, with frames so slow that all of it comes within one.
#include "app/panels/kit/number_field.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/panels/kit/view_help.h"
#include "app/panels/parameters/parameters.h"
#include "app/session/outbox.h"
#include "knit/model/settings_table.h"
#include "tests/support/hands.h"

using namespace desk;

namespace {

const knit::Parameters& now(const Desk& desk) { return desk.session.document->timeline.parameters(); }
std::string value(const Desk& desk, std::string_view key) {
  return knit::value_text(*knit::find_parameter(key), now(desk));
}

// Nothing but values was wished: no layer, no speed, no step.
void only_values(const Actions& wishes) {
  for (const Action& wish : wishes) CHECK((wish.is<Tune>() || wish.is<Settle>() || wish.is<HoverRounds>()));
}

}  // namespace

TEST_CASE(
    "every number of the table is clicked, typed and entered within one slow frame, and no key goes "
    "elsewhere") {
  for (const knit::RowSource source : {knit::RowSource::rings, knit::RowSource::contours}) {
    Desk desk(1280, 1900);
    knit::Parameters parameters = wide_band();
    parameters.rows.source = source;
    parameters.timing.axis = {knit::AxisKind::custom, {0.125, 1.0, 0.25}};
    parameters.rows.start_direction = glm::dvec3(1.0, 0.125, 0.25);
    desk.open(parameters);
    Hands hands(desk);
    const std::vector<NumberKnob> knobs = number_knobs(desk);
    CHECK(knobs.size() >= 14);
    CHECK(std::count_if(knobs.begin(), knobs.end(), [](const NumberKnob& knob) { return knob.part >= 0; }) ==
          8);
    for (const NumberKnob& knob : knobs) {
      // Picked vertices have a test of their own; a neighbour may have put a field away.
      if (desk.ui.controls.count(knob.control) == 0 || knob.key == knit::keys::start || knob.key == "end")
        continue;
      if (knob.key == knit::keys::stitch_width) continue;
      CAPTURE(knob.control);
      hands.click(knob.control);
      // Epsilon has to stay below the width, which the gauge may have changed.
      const bool epsilon = knob.key == knit::keys::epsilon;
      const std::string half = knit::number_text(std::round(5000.0 * now(desk).stitch.width) / 10000.0);
      hands.type(epsilon ? half : knob.typed);
      hands.press(Key::Enter);
      only_values(hands.drain());
      CHECK(value_of(desk, knob) == (epsilon ? half : knob.typed));
      CHECK_FALSE(number_field_open(desk.ui));
    }
  }
}

TEST_CASE("Tab goes from field to field and takes each value, Shift+Tab goes back, Escape restores") {
  Desk desk(1280, 1900);
  desk.open();
  Hands hands(desk);
  hands.click("knob/stitch-width");
  hands.type("0.5");
  hands.press(Key::Tab);  // to the height
  hands.type("0.3");
  hands.press(Key::Tab, {.shift = true});
  hands.type("0.6");
  hands.press(Key::Tab);
  only_values(hands.drain());
  CHECK(value(desk, "stitch-width") == "0.6");
  CHECK(value(desk, "stitch-height") == "0.3");
  CHECK(number_field_open(desk.ui));
  hands.type("7");
  hands.press(Key::Escape);
  only_values(hands.drain());
  CHECK(value(desk, "stitch-height") == "0.3");
  CHECK_FALSE(number_field_open(desk.ui));
  CHECK(count_of<StepBy>(desk.press({Key::Right, {}, 0})) == 1);  // keys are the view's again
}

TEST_CASE("a value is taken when it is whole, on leaving too, and never while it is half typed") {
  Desk desk(1280, 1900);
  desk.open();
  Hands hands(desk);
  hands.click("knob/stitch-width");
  hands.type("0.1");
  hands.type("2");
  CHECK(hands.drain().empty());
  hands.push({desk.over("view"), MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}});
  CHECK(count_of<Tune>(hands.drain()) == 1);
  CHECK(value(desk, "stitch-width") == "0.12");
  CHECK(desk.session.outbox->notices.empty());
  hands.click("knob/stitch-width");
  hands.press(Key::Enter);  // unchanged: nothing happens
  CHECK(hands.drain().empty());
  hands.click("knob/stitch-height");
  hands.type("auto");
  hands.press(Key::Enter);
  hands.drain();
  CHECK(value(desk, "stitch-height") == "auto");
}

TEST_CASE("what is typed wrong is said at its field until it is right, and nothing else changes") {
  Desk desk(1280, 1900);
  desk.open();
  Hands hands(desk);
  for (const char* words : {"9", "-1", "0.1.2"}) {
    hands.click("knob/epsilon");
    hands.type(words);
    hands.press(Key::Enter);
    CHECK(hands.drain().empty());
    CHECK(desk.ui.own<KnobTroubles>().size() == 1);
    CHECK(desk.ui.controls.count("knob-trouble/epsilon") == 1);
    // No tip covers it.
    for (int i = 0; i < 3; ++i) desk.frame({desk.over("knob/epsilon")});
    CHECK(desk.ui.controls.count("tip") == 0);
  }
  hands.click("knob/epsilon");
  hands.type("0.3");
  hands.press(Key::Enter);
  CHECK(count_of<Tune>(hands.drain()) == 1);
  CHECK(desk.ui.own<KnobTroubles>().empty());
  for (int i = 0; i < 3; ++i) desk.frame({desk.over("knob/epsilon")});
  CHECK(desk.ui.controls.count("tip") == 1);
  CHECK(desk.session.outbox->notices.empty());
}

TEST_CASE("a drag keeps to what is allowed, at its pace, and slower with Shift") {
  Desk desk(1280, 1900);
  desk.open();
  Hands hands(desk);
  const double before = now(desk).epsilon();
  hands.drag("knob/epsilon", 40.0f);
  const double after = now(desk).epsilon();
  CHECK(after == Approx(before * std::pow(1.01, 10.0)).epsilon(0.002));
  hands.drag("knob/epsilon", -40.0f, 10, {.shift = true});
  CHECK(now(desk).epsilon() == Approx(after / std::pow(1.01, 1.0)).epsilon(0.002));
  hands.drag("knob/epsilon", 2000.0f, 40);
  const double width = now(desk).stitch.width;
  CHECK(now(desk).epsilon() < width);
  CHECK(now(desk).epsilon() > 0.98 * width);
  hands.drag("knob/height-cm", -9000.0f, 5);
  CHECK(now(desk).size.height_cm > 0.0);
  CHECK(desk.session.outbox->notices.empty());  // never one that was refused
  CHECK(desk.ui.own<KnobTroubles>().empty());
}

TEST_CASE("digits over a panel are for no layer, and over the view they are") {
  Desk desk;
  desk.open();
  const MouseMove view = desk.over("view");
  desk.frame({desk.over("knob-label/epsilon")});
  for (const char* c : {"0", ".", "1", "2"}) {
    CHECK(desk.frames({KeyPress{Key::Digit1, true, {}}, Text{static_cast<char32_t>(*c)},
                       KeyPress{Key::Digit1, false, {}}})
              .empty());
  }
  desk.frame({view});
  CHECK(count_of<SetLayer>(
            desk.frames({KeyPress{Key::Digit1, true, {}}, KeyPress{Key::Digit1, false, {}}})) == 1);
}

TEST_CASE("equal messages are one with a number, and those of values go with a right value") {
  Session session;
  session.document = Document(small_run(wide_band()));
  knit::Parameters wrong = wide_band();
  knit::give_epsilon(wrong, 9.0);
  for (int i = 0; i < 3; ++i) apply(session, Tune{wrong});
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(session.outbox->notices[0].times == 3);
  apply(session, OpenFile{"no-such.obj"});
  knit::Parameters right = wide_band();
  knit::give_epsilon(right, 0.25);
  apply(session, Tune{right});
  REQUIRE(session.outbox->notices.size() == 1);  // the file's is no matter of values
  CHECK(session.outbox->notices[0].times == 1);
}

TEST_CASE("numbers on the screen have at most five digits, and all of them in the tip and while one types") {
  CHECK(shown_number(0.052631578947368421) == "0.052632");
  CHECK(shown_number(123456.0) == "123456");
  CHECK(shown_number(0.1) == "0.1");
  CHECK(shown_number(1e-5) == "1e-05");
  CHECK(shown_number(0.0) == "0");
  CHECK(exact_words("0.052632", "0.05263157894736842") == "\nExactly 0.05263157894736842.");
  CHECK(exact_words("0.1", "0.1").empty());
}

TEST_CASE("a wrapped text never breaks at the point of a number") {
  Desk desk;
  desk.open();
  const std::string words = "It is 0.0538 and 12.75, at most 1.5 of 3.25 cm. Then more.";
  desk.frame();
  for (float width = 20.0f; width < 500.0f; width += 7.0f) {
    std::string lines = wrapped_at_blanks(words, width);
    std::replace(lines.begin(), lines.end(), '\n', ' ');
    CHECK(lines == words);  // only blanks became line feeds
  }
  CHECK(wrapped_at_blanks("a\n\nb  c", 1000.0f) == "a\n\nb  c");
}

TEST_CASE("a wrapped text keeps a value with its name and sign") {
  Desk desk;
  desk.open();
  desk.frame();
  const std::string words = "Level 3 at t = 0.01254 splits at vertex 0 (t = 0), more there.";
  for (float width = 20.0f; width < 500.0f; width += 7.0f) {
    const std::string lines = wrapped_at_blanks(words, width);
    CHECK(lines.find("t = 0.01254") != std::string::npos);
    CHECK(lines.find("(t = 0),") != std::string::npos);
  }
  CHECK(wrapped_at_blanks("one two", 1.0f) == "one\ntwo");
  CHECK(wrapped_at_blanks("a == b", 1.0f) == "a\n==\nb");
  CHECK(wrapped_at_blanks("of 15 % spare, 12.5 cm high", 1.0f) == "of\n15 %\nspare,\n12.5 cm\nhigh");
  CHECK(wrapped_at_blanks("5 cmx 5 loops", 1.0f) == "5\ncmx\n5\nloops");
}

TEST_CASE("the view's hint has as many whole parts as fit, and always the way to the rest") {
  Desk desk;
  desk.open();
  desk.frame();
  const std::string all = hint_words(1e6f);
  const std::string least = hint_words(0.0f);
  CHECK(least == "? lists the keys");
  CHECK(all.ends_with(", " + least));
  for (float width = 100.0f; width < 900.0f; width += 50.0f) {
    const std::string words = hint_words(width);
    CHECK((words == least || ImGui::CalcTextSize(words.c_str()).x <= width));
    CHECK(words.ends_with(least));
    CHECK(all.starts_with(words.substr(0, words.size() - least.size())));
  }
}

TEST_CASE("numbers of the other panels are fields too: speed, sizes of pictures, the values of a sweep") {
  Desk desk(1600, 1000);
  desk.open();
  Hands hands(desk);
  hands.click("speed");
  hands.type("1234.5");
  hands.press(Key::Enter);
  CHECK(only<SetSpeed>(hands.drain()).steps_per_second == 1234.5);
  hands.click("speed");
  hands.type("0");
  hands.press(Key::Enter);
  CHECK(hands.drain().empty());
  CHECK(desk.ui.own<NumberFields>().trouble.words == "\"0\" is not a number from 1 to 100000.");
}
