// The choice of short rows as alternatives in the window: what each comes to, which one is in force, a click on another.
#include "app/panels/parameters/kept_choices.h"

#include <nlohmann/json.hpp>

#include "app/files/report.h"
#include "app/session/document.h"
#include "knit/quality/measures.h"
#include "tests/support/bent_ellipsoid.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

struct HighDesk : Desk {
  HighDesk() : Desk(1280, 2400) {}
};

void open_bent(Desk& desk, double turn) {
  const auto input = test_support::bent_ellipsoid(turn);
  const knit::Parameters parameters = test_support::parameters_of(*input, knit::ShortRows::automatic);
  desk.session.document = Document(knit::Timeline(input, parameters));
  desk.session.document->defaults = parameters;
  desk.session.document->timeline.extend_to_end();
  desk.settle();
}

const knit::ShortRowSettings& settings_of(const Desk& desk) {
  return desk.session.document->timeline.parameters().short_rows;
}

void click(Desk& desk, const char* control) {
  REQUIRE(desk.ui.controls.count(control) == 1);
  desk.act(desk.click(control));
  desk.session.document->timeline.extend_to_end();
  desk.settle();
}

}  // namespace

TEST_CASE("the ways of short rows stand below their knob and a click takes one") {
  HighDesk desk;
  open_bent(desk, 1.8);
  REQUIRE(desk.ui.controls.count("kept/none") == 1);
  CHECK(desk.ui.controls.count("kept/0") == 1);
  CHECK(desk.ui.controls.count("kept/1") == 0);  // a piece of one tube has no events
  click(desk, "kept/none");
  CHECK(settings_of(desk).rows == knit::ShortRows::off);
  CHECK(desk.ui.controls.count("kept/0") == 1);  // still there to be compared
  click(desk, "kept/0");
  CHECK(settings_of(desk).rows == knit::ShortRows::automatic);
  CHECK(settings_of(desk).kept == knit::KeptBeside::none);
  CHECK(desk.ui.controls.count("kept/none") == 1);
}

TEST_CASE("what a way comes to is what the run has when it is taken") {
  HighDesk desk;
  open_bent(desk, 1.8);
  const knit::State& chosen = desk.session.document->timeline.furthest();
  const auto& tries = chosen.short_rows.tries;
  REQUIRE(tries.size() == 2);
  CHECK(tries.at(1).wale_cv == Approx(knit::wale_figures(chosen).cv).epsilon(1e-5));
  apply(desk.session, ToLast{});
  const nlohmann::json report = nlohmann::json::parse(report_json(desk.session).dump());
  REQUIRE(report["short_rows"]["tries"].size() == 2);
  CHECK(report["short_rows"]["tries"][1]["chosen"] == true);
  CHECK(report["short_rows"]["tries"][0]["rows_kept"] == -1);
  const double without = static_cast<double>(tries.front().wale_cv);
  click(desk, "kept/none");
  CHECK(knit::wale_figures(desk.session.document->timeline.furthest()).cv == Approx(without).epsilon(1e-5));
}

TEST_CASE("where no pair pays it is said") {
  HighDesk desk;
  open_bent(desk, 0.0);
  CHECK(desk.ui.controls.count("kept/none") == 0);
  CHECK(desk.ui.controls.count("kept/untold") == 1);
}
