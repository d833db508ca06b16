// What makes a large mesh anew is done beside the window: welding it otherwise, going back to how it was welded.
#include "app/actions/opening.h"
#include "tests/support/beside.h"

using namespace app;
using namespace test_support;

namespace {

// With a seam, so that welding makes it another.
struct Window {
  Window() {
    session.assets = KNIT_ASSETS_DIR;
    session.original = std::make_shared<const knit::Mesh>(knit::sphere(160, 70, true));
    session.source.example = "ball";
    session.timeline.emplace(knit::make_input(*session.original), large_parameters());
    session.timeline->extend_to_end();
    session.beside = true;
    apply(session, SeekTo{5000});
  }
  void weld(knit::Weld weld) {
    knit::Parameters parameters = session.timeline->parameters();
    parameters.weld = weld;
    apply(session, Tune{parameters});
  }
  void wait() {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(3);
    while (session.opening) {
      apply(session, PassTime{0.001});
      REQUIRE(std::chrono::steady_clock::now() < give_up);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] std::size_t vertices() const { return session.timeline->input().mesh.positions.size(); }
  [[nodiscard]] bool is_welded() const { return vertices() < session.original->positions.size(); }

  Session session;
};

}  // namespace

TEST_CASE("making: welding a large mesh is done beside the window, and undone and done again so") {
  Window window;
  const knit::Place place = window.session.timeline->place();
  window.weld(knit::Weld::on);
  REQUIRE(window.session.opening);
  CHECK_FALSE(window.is_welded());
  CHECK(window.session.timeline->parameters().weld == knit::Weld::off);
  apply(window.session, StepBy{});  // what is shown goes on
  CHECK(window.session.timeline->position() == 5001);
  apply(window.session, StepBy{Unit::item, -1});
  window.wait();
  CHECK(window.is_welded());
  CHECK(window.session.timeline->parameters().weld == knit::Weld::on);
  CHECK(window.session.timeline->sought().value_or(window.session.timeline->place()) == place);
  REQUIRE(window.session.changes.undo.size() == 1);

  apply(window.session, Undo{});
  REQUIRE(window.session.opening);
  CHECK(window.session.changes.undo.size() == 1);
  window.wait();
  CHECK_FALSE(window.is_welded());
  CHECK(window.session.changes.undo.empty());
  REQUIRE(window.session.changes.redo.size() == 1);
  apply(window.session, Redo{});
  window.wait();
  CHECK(window.is_welded());
  CHECK(window.session.made_mesh == nullptr);
}

TEST_CASE("making: another change gives it up, and so does cancelling") {
  Window window;
  window.weld(knit::Weld::on);
  const auto work = window.session.opening;
  knit::Parameters other = window.session.timeline->parameters();
  other.epsilon *= 1.1;
  apply(window.session, Tune{other});
  CHECK_FALSE(window.session.opening);
  CHECK(work->progress->stopped());
  CHECK(window.session.timeline->parameters().epsilon == other.epsilon);
  CHECK_FALSE(window.is_welded());
  window.weld(knit::Weld::on);
  REQUIRE(window.session.opening);
  apply(window.session, CancelWork{});
  CHECK_FALSE(window.session.opening);
  CHECK_FALSE(window.is_welded());
  CHECK(window.session.timeline->parameters().weld == knit::Weld::off);
}

TEST_CASE("making: without a window, and for a small mesh, it is done at once") {
  Window window;
  window.session.beside = false;
  window.weld(knit::Weld::on);
  CHECK_FALSE(window.session.opening);
  CHECK(window.is_welded());

  Session small = example_session("thesis-sphere");
  small.beside = true;
  knit::Parameters welded = small.timeline->parameters();
  welded.weld = knit::Weld::on;
  apply(small, Tune{welded});
  CHECK_FALSE(small.opening);
  CHECK(small.timeline->parameters().weld == knit::Weld::on);
}
