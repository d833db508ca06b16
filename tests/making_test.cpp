// What makes a large mesh anew is done beside the window: welding it otherwise, going back to how it was welded.
#include "app/actions/opening.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "knit/model/stitch_size.h"
#include "tests/support/beside.h"

using namespace app;
using namespace test_support;

namespace {

// With a seam, so that welding makes it another.
struct Window {
  Window() {
    session.program->assets = KNIT_ASSETS_DIR;
    const auto ball = std::make_shared<const knit::Mesh>(knit::sphere(160, 70, true));
    session.document = Document(knit::Timeline(knit::make_input(*ball), large_parameters()));
    session.document->original = ball;
    session.document->source.example = "ball";
    session.document->timeline.extend_to_end();
    session.jobs->beside = true;
    apply(session, SeekTo{5000});
  }
  void weld(knit::Weld weld) {
    knit::Parameters parameters = session.document->timeline.parameters();
    parameters.mesh.weld = weld;
    apply(session, Tune{parameters});
  }
  void wait() {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(3);
    while (session.jobs->opening) {
      apply(session, PassTime{0.001});
      REQUIRE(std::chrono::steady_clock::now() < give_up);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] std::size_t vertices() const {
    return session.document->timeline.input().mesh.positions.size();
  }
  [[nodiscard]] bool is_welded() const { return vertices() < session.document->original->positions.size(); }

  Session session;
};

}  // namespace

TEST_CASE("making: welding a large mesh is done beside the window, and undone and done again so") {
  Window window;
  const knit::Place place = window.session.document->timeline.place();
  window.weld(knit::Weld::on);
  REQUIRE(window.session.jobs->opening);
  CHECK_FALSE(window.is_welded());
  CHECK(window.session.document->timeline.parameters().mesh.weld == knit::Weld::off);
  apply(window.session, StepBy{});  // what is shown goes on
  CHECK(window.session.document->timeline.position() == 5001);
  apply(window.session, StepBy{Unit::item, -1});
  window.wait();
  CHECK(window.is_welded());
  CHECK(window.session.document->timeline.parameters().mesh.weld == knit::Weld::on);
  CHECK(window.session.document->timeline.sought().value_or(window.session.document->timeline.place()) ==
        place);
  REQUIRE(window.session.document->changes.undo.size() == 1);

  apply(window.session, Undo{});
  REQUIRE(window.session.jobs->opening);
  CHECK(window.session.document->changes.undo.size() == 1);
  window.wait();
  CHECK_FALSE(window.is_welded());
  CHECK(window.session.document->changes.undo.empty());
  REQUIRE(window.session.document->changes.redo.size() == 1);
  apply(window.session, Redo{});
  window.wait();
  CHECK(window.is_welded());
  CHECK(window.session.jobs->made_mesh == nullptr);
}

TEST_CASE("making: another change gives it up, and so does cancelling") {
  Window window;
  window.weld(knit::Weld::on);
  const auto work = window.session.jobs->opening;
  knit::Parameters other = window.session.document->timeline.parameters();
  knit::give_epsilon(other, other.epsilon() * 1.1);
  apply(window.session, Tune{other});
  CHECK_FALSE(window.session.jobs->opening);
  CHECK(work->progress->stopped());
  CHECK(window.session.document->timeline.parameters().epsilon() == other.epsilon());
  CHECK_FALSE(window.is_welded());
  window.weld(knit::Weld::on);
  REQUIRE(window.session.jobs->opening);
  apply(window.session, CancelWork{});
  CHECK_FALSE(window.session.jobs->opening);
  CHECK_FALSE(window.is_welded());
  CHECK(window.session.document->timeline.parameters().mesh.weld == knit::Weld::off);
}

TEST_CASE("making: without a window, and for a small mesh, it is done at once") {
  Window window;
  window.session.jobs->beside = false;
  window.weld(knit::Weld::on);
  CHECK_FALSE(window.session.jobs->opening);
  CHECK(window.is_welded());

  Session small = example_session("thesis-sphere");
  small.jobs->beside = true;
  knit::Parameters welded = small.document->timeline.parameters();
  welded.mesh.weld = knit::Weld::on;
  apply(small, Tune{welded});
  CHECK_FALSE(small.jobs->opening);
  CHECK(small.document->timeline.parameters().mesh.weld == knit::Weld::on);
}
