// Tubes on the timeline, and events in both: which tube is worked at a position, where loops are dealt, and clicks on either.
#include "app/panels/timeline/tube_band.h"
#include "app/panels/tubes/tubes_layout.h"
#include "knit/insight/why.h"
#include "knit/model/words.h"
#include "tests/support/bodies.h"
#include "tests/support/desk.h"

namespace {

using namespace desk;

void open_run(Desk& desk, const knit::Mesh& mesh, knit::Smoothing smoothing = knit::Smoothing::by_itself) {
  knit::Parameters parameters;
  parameters.rows.source = knit::RowSource::contours;
  parameters.tubes.smoothing = smoothing;
  knit::give_width(parameters, 0.3);
  desk.session.document = Document(knit::Timeline(knit::make_input(mesh), parameters));
  desk.session.document->timeline.extend_to_end();
  REQUIRE(desk.session.document->timeline.stop() == nullptr);
  desk.settle();
}

// What a click wishes for, beside the round that it points at.
std::size_t position_wished(Desk& desk, const Actions& wishes) {
  CHECK(count_of<SeekTo>(wishes) + count_of<SeekPlace>(wishes) == 1);
  desk.act(wishes);
  return desk.session.document->timeline.position();
}

}  // namespace

TEST_CASE("timeline: every step of a row lies in its tube's stretch, in all stages that go by rows") {
  Desk desk;
  open_run(desk, test_support::arch());
  const knit::Timeline& timeline = desk.session.document->timeline;
  TubeBand band;
  band.refresh(timeline);
  REQUIRE(band.stretches().size() >= 9);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const knit::Step& step = timeline.step(i);
    const bool by_rows = step.place.stage >= knit::Stage::cast_on &&
                         step.place.stage <= knit::Stage::pattern &&
                         step.place.stage != knit::Stage::settle && step.place.row > 0;
    const TubeBand::Stretch* at = band.at(i + 1);
    if (!by_rows || at == nullptr) {
      wrong += by_rows ? 1U : 0U;
      continue;
    }
    const knit::Row* row = timeline.furthest().fabric.find_row(step.place.row);
    if (row != nullptr) wrong += row->tube == at->tube ? 0U : 1U;
  }
  CHECK(wrong == 0);
  CHECK(band.at(0) == nullptr);
  for (std::size_t i = 1; i < band.stretches().size(); ++i)
    CHECK(band.stretches()[i - 1].end <= band.stretches()[i].begin);
}

TEST_CASE("timeline: of one tube there is no band") {
  Desk desk;
  open_run(desk, knit::sphere(24, 12, false));
  TubeBand band;
  band.refresh(desk.session.document->timeline);
  CHECK(band.stretches().empty());
  CHECK(band.marks().empty());
  CHECK(desk.ui.controls.count("track/event/1") == 0);
}

TEST_CASE(
    "timeline: a click on an event's mark goes to the step that deals it, in any size, and a drag follows") {
  for (const float scale : {1.0f, 2.0f}) {
    Desk desk(1280 * scale, 960 * scale, scale);
    open_run(desk, test_support::arch());
    const knit::Timeline& timeline = desk.session.document->timeline;
    const auto& deals = timeline.furthest().fabric.deals();
    REQUIRE(deals.size() == 1);
    const std::string mark = "track/event/" + std::to_string(deals[0]->event);
    const knit::StepRange steps = knit::steps_of_deal(timeline, 1);
    desk.session.document->timeline.seek(0);
    desk.settle();
    // A little beside its middle, too.
    for (const float across : {0.5f, 0.05f, 0.95f}) {
      desk.session.document->timeline.seek(0);
      CHECK(position_wished(desk, desk.click(mark, across)) == steps.begin + 1);
    }
    CHECK(knit::is<knit::GapsFound>(*last_step(desk.session)));
    CHECK(count_of<SeekTo>(desk.frames({desk.over(mark), MouseClick{MouseButton::Left, true}})) ==
          0);  // it is there
    const Box track = desk.ui.controls.at("track");
    const Actions moved = desk.frames({MouseMove{track.x + 2000.0f * scale, track.y + 0.5f * track.height}});
    REQUIRE(count_of<SeekTo>(moved) == 1);
    const auto sought =
        std::find_if(moved.begin(), moved.end(), [](const Action& wish) { return wish.is<SeekTo>(); });
    CHECK(sought->get<SeekTo>().position == timeline.known());
    desk.frames({MouseClick{MouseButton::Left, false}, MouseLeave{}});
  }
}

TEST_CASE("tubes panel: a click on an event goes to where it happens", "[tubes-panel]") {
  Desk desk;
  open_run(desk, test_support::arch());
  desk.session.view->side = SidePanel::tubes;
  desk.settle();
  const knit::State& end = desk.session.document->timeline.furthest();
  for (std::size_t i = 0; i < end.tubes->events.size(); ++i) {
    desk.session.document->timeline.seek(0);
    desk.settle();
    const std::string name = "tube-event/" + std::to_string(i);
    INFO(name);
    position_wished(desk, desk.click(name));
    const knit::Step* step = last_step(desk.session);
    REQUIRE(step != nullptr);
    const knit::TubeEvent& event = end.tubes->events[i];
    if (event.kind == knit::EventKind::join) CHECK(knit::is<knit::GapsFound>(*step));
    if (event.kind == knit::EventKind::join) continue;
    const bool begins = event.kind == knit::EventKind::cast_on;
    const knit::TubeId tube = begins ? event.above.front() : event.below.front();
    CHECK(end.fabric.row(step->place.row).tube == tube);
    const knit::Row* next = end.fabric.find_row(step->place.row + (begins ? -1 : 1));
    CHECK((next == nullptr || next->tube != tube));
  }
}
