// The pseudo-code as a panel: lines, values and variables that can be pointed at.
#include <set>

#include "app/explain/code_variables.h"
#include "app/panels/kit/run_cache.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

namespace {

using namespace desk;

bool begins(const std::string& name, const std::string& with) { return name.rfind(with, 0) == 0; }

void seek_to_candidate(Desk& desk) {
  desk.session.document->timeline.seek(
      desk.session.document->timeline.position_of({knit::Stage::rows, 4, 6}));
  REQUIRE(knit::is<knit::CandidateMeasured>(*last_step(desk.session)));
  desk.settle();
}

}  // namespace

TEST_CASE("pointing at a variable wishes it once, leaving it wishes none") {
  Desk desk;
  desk.open();
  seek_to_candidate(desk);
  const Actions pointed = desk.frames({desk.over("variable/d")});
  CHECK(only<PointAt>(pointed).variable == "d");
  desk.act(pointed);
  CHECK(desk.frame().empty());
  const Actions other = desk.frames({desk.over("value/verdict")});
  CHECK(only<PointAt>(other).variable == "verdict");
  desk.act(other);
  const Actions left = desk.frames({desk.over("view")});
  CHECK(count_of<PointAt>(left) == 1);
  desk.act(left);
  CHECK(desk.session.learning->pointed_variable.empty());
  CHECK(count_of<PointAt>(desk.frame()) == 0);
}

TEST_CASE("what a script points at stays until a person points, and goes with the side") {
  Desk desk;
  desk.open();
  seek_to_candidate(desk);
  apply(desk.session, PointAt{"epsilon"});
  CHECK(desk.frame().empty());
  desk.session.view->side = SidePanel::report;
  CHECK(only<PointAt>(desk.frame()).variable.empty());
}

TEST_CASE("every line and every value has its place in a low window, at every stage, and the lists too") {
  for (const float scale : {1.0f, 1.5f}) {
    Desk desk(1280 * scale, 720 * scale, scale, KNIT_ASSETS_DIR "/fonts");
    desk.open();
    for (const RunCache::Stretch& stage : std::vector(desk.ui.own<RunCache>().stages())) {
      for (const std::size_t position : {stage.begin + 1, (stage.begin + stage.end) / 2, stage.end}) {
        desk.session.document->timeline.seek(position);
        desk.settle();
        const auto at = explained(desk.session);
        const std::size_t lines = at->code->lines.size();
        INFO(at->code->title << " at " << position);
        for (std::size_t line = 1; line <= lines; ++line)
          CHECK(desk.ui.controls.count("code/" + std::to_string(line)) == 1);
        for (const Variable& variable : variables_of(desk.session)) {
          INFO(variable.of->key);
          const std::string name(variable.of->key);
          CHECK((variable.value.empty() || desk.ui.controls.count("variable/" + name) == 1 ||
                 desk.ui.controls.count("value/" + name) == 1));
        }
        const Box step = desk.ui.controls.at("step");
        for (const auto& [name, box] : desk.ui.controls) {
          if (!begins(name, "code/") && !begins(name, "variable/") && !begins(name, "value/")) continue;
          INFO(name);
          CHECK(box.x >= step.x);
          CHECK(box.right() <= step.right() + 0.5f);
          CHECK(box.bottom() <= step.bottom() + 0.5f);
        }
        CHECK(desk.layout.explanation.bottom() - step.bottom() > 130.0f * scale);
      }
    }
  }
}

TEST_CASE("no two values of the code stand on each other") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  desk.open();
  seek_to_candidate(desk);
  std::vector<std::pair<std::string, Box>> boxes;
  for (const auto& [name, box] : desk.ui.controls) {
    if (begins(name, "value/") || begins(name, "variable/")) boxes.emplace_back(name, box);
  }
  CHECK(boxes.size() > 12);
  for (const auto& [name, a] : boxes) {
    for (const auto& [other, b] : boxes) {
      INFO(name << " and " << other);
      const bool apart =
          a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y + 0.5f || b.bottom() <= a.y + 0.5f;
      CHECK((name == other || apart));
    }
  }
}
