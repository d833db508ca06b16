// The drawing of tubes: where they stand and which yarn they have; the panel that shows it, at every step and under a click.
#include <array>
#include <memory>
#include <optional>
#include <set>

#include "app/panels/tubes/tube_names.h"
#include "app/panels/tubes/tubes_layout.h"
#include "app/panels/tubes/tubes_words.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/model/words.h"
#include "tests/support/bodies.h"
#include "tests/support/desk.h"

namespace {

using namespace desk;
using knit::EventKind;
using knit::TubeEvent;
using knit::TubeId;
using knit::TubePlan;
using test_support::Dice;

// From pairs of events, the lower one first; an event is what its tubes make it. Each tube has two rows.
TubePlan drawn_plan(const std::vector<std::array<std::int32_t, 2>>& tubes) {
  TubePlan plan;
  plan.stitch_width = plan.stitch_height = 1.0;
  for (const auto& [bottom, top] : tubes) {
    const auto id = static_cast<TubeId>(plan.tubes.size());
    plan.events.resize(std::max(plan.events.size(), static_cast<std::size_t>(top) + 1));
    plan.events[static_cast<std::size_t>(bottom)].above.push_back(id);
    plan.events[static_cast<std::size_t>(top)].below.push_back(id);
    plan.tubes.emplace_back();
    plan.tubes.back().bottom = bottom;
    plan.tubes.back().top = top;
    plan.tubes.back().curves.resize(2);
    plan.tubes.back().lengths = {6.0, 8.0};
    plan.tubes.back().twins = {id};
  }
  for (std::size_t i = 0; i < plan.events.size(); ++i) {
    TubeEvent& event = plan.events[i];
    event.value = static_cast<double>(i);
    event.kind = event.below.empty()       ? EventKind::cast_on
                 : event.above.empty()     ? EventKind::bind_off
                 : event.above.size() == 2 ? EventKind::split
                                           : EventKind::join;
  }
  const knit::TubeOrder order = knit::order_tubes(plan.tubes, plan.events);
  plan.order = order.order;
  plan.yarns = order.yarns;
  plan.held_most = order.held_most;
  return plan;
}

// Events one after another; what is open at the end is bound off.
TubePlan random_plan(Dice& dice, std::size_t steps) {
  std::vector<std::array<std::int32_t, 2>> tubes;
  std::vector<std::size_t> open;
  std::int32_t event = 0;
  const auto begin = [&] {
    open.push_back(tubes.size());
    tubes.push_back({event, 0});
  };
  const auto end = [&] {
    const auto at = open.begin() + static_cast<std::ptrdiff_t>(dice.below(open.size()));
    tubes[*at][1] = event;
    open.erase(at);
  };
  for (std::size_t i = 0; i < steps || !open.empty(); ++i) {
    const std::size_t choice = i < steps ? dice.below(3) : 3;
    if (choice == 2 && open.size() < 2) continue;
    if (choice > 0 && open.empty()) continue;
    if (choice > 0) end();
    if (choice == 2) end();
    if (choice < 3) begin();
    if (choice == 1) begin();
    ++event;
  }
  return drawn_plan(tubes);
}

TubePlan plan_of(const knit::Mesh& mesh, const glm::dvec3& axis, double width) {
  const auto input = knit::make_input(mesh);
  const auto graph = knit::find_tubes(knit::make_morse(*input, test_support::field_along(*input, axis)));
  return knit::plan_tubes(graph, {width, 0.72 * width, 1});
}

// Four legs, a seat, a back of two posts that end apart.
const std::vector<std::array<std::int32_t, 2>> chair{{0, 4}, {1, 5}, {2, 4}, {3, 5}, {4, 6},
                                                     {5, 6}, {6, 7}, {7, 8}, {7, 9}};
// Two rings, one above the other.
const std::vector<std::array<std::int32_t, 2>> eight{{0, 1}, {1, 2}, {1, 2}, {2, 3}, {3, 4}, {3, 4}, {4, 5}};
// Three nodes each tied to three others, which no plane holds; two of the ties have an end of their own between.
const std::vector<std::array<std::int32_t, 2>> tangle{{0, 1}, {1, 2}, {1, 6}, {2, 3}, {2, 4}, {3, 5}, {3, 7},
                                                      {4, 7}, {4, 5}, {5, 6}, {6, 8}, {7, 8}, {8, 9}};

void check_places(const TubePlan& plan, const TubesLayout& layout) {
  REQUIRE(layout.tubes.size() == plan.tubes.size());
  REQUIRE(layout.events.size() == plan.events.size());
  for (std::size_t i = 1; i < layout.events.size(); ++i) CHECK(layout.events[i - 1].y < layout.events[i].y);
  CHECK(layout.events.front().y == 0.0);
  CHECK(layout.events.back().y == Approx(1.0));
  for (std::size_t i = 0; i < plan.tubes.size(); ++i) {
    const TubePlace& a = layout.tubes[i];
    CHECK(a.low == layout.events[static_cast<std::size_t>(plan.tubes[i].bottom)].y);
    CHECK(a.high == layout.events[static_cast<std::size_t>(plan.tubes[i].top)].y);
    CHECK(a.x >= 0.5 * layout.column - 1e-12);
    CHECK(a.x <= 1.0 - 0.5 * layout.column + 1e-12);
    for (std::size_t j = 0; j < i; ++j) {
      const TubePlace& b = layout.tubes[j];
      if (a.low < b.high && b.low < a.high) CHECK(std::abs(a.x - b.x) >= layout.column - 1e-12);
    }
  }
}

void check_rows(const TubePlan& plan, const TubesLayout& layout) {
  knit::RowId row = 0;
  for (const TubeId id : plan.order) {
    const knit::RowId first = row + 1;
    CHECK(layout.tubes[static_cast<std::size_t>(id)].first_row == (plan.tube(id).rows() > 0 ? first : 0));
    for (std::int32_t i = 0; i < plan.tube(id).rows(); ++i) CHECK(tube_of_row(plan, layout, ++row) == id);
  }
  CHECK(layout.rounds == row);
  CHECK(tube_of_row(plan, layout, 0) == -1);
  CHECK(tube_of_row(plan, layout, row + 1) == -1);
}

void check_yarns(const TubePlan& plan, const TubesLayout& layout) {
  CHECK(layout.yarns == plan.yarns);
  std::set<std::int32_t> met;
  for (const TubePlace& place : layout.tubes) {
    CHECK(place.yarn < layout.yarns);
    if (place.yarn >= 0) met.insert(place.yarn);
  }
  CHECK(met.size() == static_cast<std::size_t>(layout.yarns));
}

TubesLayout checked(const TubePlan& plan) {
  const TubesLayout layout = lay_out(plan);
  check_places(plan, layout);
  check_rows(plan, layout);
  check_yarns(plan, layout);
  return layout;
}

// Two legs that become one, in few stitches.
knit::Parameters contours() {
  knit::Parameters parameters;
  parameters.rows.source = knit::RowSource::contours;
  knit::give_width(parameters, 0.3);
  return parameters;
}

void open_arch(Desk& desk) {
  desk.session.document = Document(knit::Timeline(knit::make_input(test_support::arch()), contours()));
  desk.session.document->timeline.extend_to_end();
  desk.session.view->side = SidePanel::tubes;
  desk.settle();
}

}  // namespace

TEST_CASE("tubes panel: tubes stand beside each other, upward, with the yarns of the plan", "[tubes-panel]") {
  for (const auto& tubes : {chair, eight, tangle}) checked(drawn_plan(tubes));
  CHECK(checked(drawn_plan({{0, 1}})).column == 1.0);
  CHECK(checked(plan_of(test_support::arch(), {0, 1, 0}, 0.1)).column == 0.5);
  CHECK(checked(plan_of(test_support::arch(), {0, -1, 0}, 0.1)).yarns == 2);
  for (const glm::dvec3& axis : {glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}})
    CHECK(checked(plan_of(knit::torus(64, 32, 1.0, 0.4), axis, 0.15)).crossings == 0);
  Dice dice(11);
  for (int run = 0; run < 60; ++run) {
    CAPTURE(run);
    const TubePlan plan = random_plan(dice, 2 + dice.below(12));
    if (!plan.tubes.empty()) checked(plan);
  }
}

TEST_CASE("tubes panel: an event stands between the tubes that it has", "[tubes-panel]") {
  const TubesLayout layout = lay_out(drawn_plan(eight));
  CHECK(layout.tubes[0].x == Approx(0.5));
  CHECK(std::abs(layout.tubes[1].x - layout.tubes[2].x) == Approx(0.5));
  CHECK(layout.events[1].x == Approx(0.5 * (layout.tubes[1].x + layout.tubes[2].x)));
  CHECK(layout.events[2].x == layout.tubes[3].x);
}

TEST_CASE("tubes panel: nothing crosses that need not, and then a machine could make it", "[tubes-panel]") {
  const auto verdict = [](const TubePlan& plan) { return machine_verdict(plan, lay_out(plan)); };
  CHECK(lay_out(drawn_plan(chair)).crossings == 0);
  CHECK(verdict(drawn_plan(chair)) == MachineVerdict::tree);
  CHECK(loops_of(drawn_plan(eight)) == 2);
  CHECK(verdict(drawn_plan(eight)) == MachineVerdict::drawn);
  const TubePlan crossed = drawn_plan(tangle);
  CHECK(lay_out(crossed).crossings > 0);
  CHECK(verdict(crossed) == MachineVerdict::not_known);
  // Of the same graphs, however their drawing turned out.
  TubesLayout bad = lay_out(drawn_plan(eight));
  bad.crossings = 1;
  CHECK(machine_verdict(drawn_plan(eight), bad) == MachineVerdict::series_parallel);
}

TEST_CASE("tubes panel: its sentences tell what there is and what was left out", "[tubes-panel]") {
  TubePlan plan = drawn_plan(chair);
  plan.left_out.push_back({false, 0.5, 2.0, 7, 8, 0.25});
  plan.left_out.push_back({true, 0.5, 2.0, 7, 8, 0.0});
  const std::vector<std::string> words = plan_words(plan, lay_out(plan), nullptr);
  REQUIRE(words.size() == 4);
  CHECK(words[0].find("9 tubes, 18 rounds, " + std::to_string(plan.yarns) + " yarns") == 0);
  CHECK(words[1].find("a limb at vertex 7, 0.5 rounds high and 2 stitches round") != std::string::npos);
  CHECK(words[1].find("narrower than 0.25 would keep it.") != std::string::npos);
  CHECK(words[2].find("a hole") != std::string::npos);
  CHECK(words[3].find("tree") != std::string::npos);
  plan.left_out.resize(30, plan.left_out.front());
  CHECK(plan_words(plan, lay_out(plan), nullptr).size() == 6);

  const TubesLayout layout = lay_out(plan);
  CHECK(tube_words(plan, layout, 0, {0, 0}).find("Tube A: 2 rounds, about 14 stitches.") == 0);
  CHECK(tube_words(plan, layout, 0, {2, 15}).find("Tube A: 2 rounds, 15 stitches.") == 0);
  CHECK(event_words(plan, 4).find("Tubes A and C join to E") == 0);
}

TEST_CASE("tubes panel: without tubes it says what to do", "[tubes-panel]") {
  Desk desk;
  desk.session.view->side = SidePanel::tubes;
  CHECK(desk.frame().empty());
  CHECK(desk.ui.controls.count("tubes/none") == 1);
  desk.open();  // rows from rings
  CHECK(desk.frame().empty());
  CHECK(desk.ui.controls.count("tubes/none") == 1);
  CHECK(desk.ui.controls.count("tubes/drawing") == 0);
}

TEST_CASE("tubes panel: drawn at every step without a wish, in any size", "[tubes-panel]") {
  for (const float scale : {1.0f, 2.0f}) {
    for (const float width : {640.0f, 1280.0f}) {
      Desk desk(scale * width, scale * 0.6f * width, scale);
      open_arch(desk);
      const std::size_t known = desk.session.document->timeline.known();
      for (std::size_t i = 0; i <= 60; ++i) {
        desk.session.document->timeline.seek(i * known / 60);
        CHECK(desk.frame().empty());
        CHECK(desk.ui.controls.count("tubes/drawing") == 1);
      }
      for (const char* name : {"tube/A", "tube/B", "tube/C"}) CHECK(desk.ui.controls.count(name) == 1);
    }
  }
}

TEST_CASE("tubes panel: a click on a tube goes to its first row, once, and hovering lights its rounds",
          "[tubes-panel]") {
  Desk desk;
  open_arch(desk);
  const knit::State& end = desk.session.document->timeline.furthest();
  const TubesLayout layout = lay_out(*end.tubes);
  for (const knit::Stage stage : {knit::Stage::timing, knit::Stage::rows, knit::Stage::faces}) {
    for (std::size_t tube = 0; tube < layout.tubes.size(); ++tube) {
      desk.act({SeekPlace{{stage, 0, 0}}});
      desk.settle();
      const std::string name = "tube/" + knit::tube_name(static_cast<TubeId>(tube));
      INFO(name);
      const Actions wishes = desk.click(name);
      REQUIRE(count_of<SeekPlace>(wishes) == 1);
      CHECK(count_of<SeekPlace>(wishes) + count_of<HoverRounds>(wishes) == wishes.size());
      for (const Action& wish : wishes) {
        if (wish.is<SeekPlace>()) CHECK(wish.get<SeekPlace>().place.row == layout.tubes[tube].first_row);
      }
      desk.act(wishes);
      const knit::Step* step = last_step(desk.session);
      REQUIRE(step != nullptr);
      CHECK(step->place.row == layout.tubes[tube].first_row);
    }
  }
  desk.act(desk.frames({desk.over("tube/B")}));
  const auto& rounds = desk.session.view->gaze.hovered_rounds;
  REQUIRE(rounds);
  CHECK(rounds->first == layout.tubes[1].first_row);
  CHECK(rounds->last == rounds->first + end.tubes->tubes[1].rows() - 1);
}

TEST_CASE("tubes panel: names stand where there is room, those first that choose first", "[tubes-panel]") {
  const Box ground{0, 0, 100, 100};
  const Box here{10, 10, 20, 10}, there{50, 50, 20, 10}, outside{90, 90, 20, 10};
  using Placed = std::vector<std::optional<Box>>;
  CHECK(place_names({{here}, {here, there}, {here, there}}, {}, ground) == Placed{here, there, std::nullopt});
  CHECK(place_names({{here, there}}, {{29, 19, 5, 5}}, ground) == Placed{there});
  CHECK(place_names({{here}}, {{30, 10, 5, 5}}, ground) == Placed{here});  // they touch
  CHECK(place_names({{outside}, {outside, here}}, {}, ground) == Placed{std::nullopt, here});
  CHECK(place_names({{}}, {}, ground) == Placed{std::nullopt});
}

TEST_CASE("tubes panel: the list has a line for each tube, which leads there and lights its rounds",
          "[tubes-panel]") {
  Desk desk;
  open_arch(desk);
  const knit::TubePlan& plan = *desk.session.document->timeline.furthest().tubes;
  const TubesLayout layout = lay_out(plan);
  for (std::size_t tube = 0; tube < layout.tubes.size(); ++tube) {
    desk.act({SeekPlace{{knit::Stage::faces, 0, 0}}});
    desk.settle();
    const std::string name = "tube-line/" + knit::tube_name(static_cast<TubeId>(tube));
    INFO(name);
    const Actions wishes = desk.click(name);
    REQUIRE(count_of<SeekPlace>(wishes) == 1);
    for (const Action& wish : wishes) {
      if (wish.is<SeekPlace>()) CHECK(wish.get<SeekPlace>().place.row == layout.tubes[tube].first_row);
    }
  }
  desk.act(desk.frames({desk.over("tube-line/C")}));
  const auto& rounds = desk.session.view->gaze.hovered_rounds;
  REQUIRE(rounds);
  CHECK(rounds->first == layout.tubes[2].first_row);
}

TEST_CASE("tubes panel: of very many tubes the list scrolls and every one has its place", "[tubes-panel]") {
  for (const float scale : {1.0f, 2.0f}) {
    Desk desk(scale * 1280.0f, scale * 720.0f, scale);
    knit::Parameters parameters = contours();
    knit::give_width(parameters, 0.15);
    desk.session.document = Document(knit::Timeline(knit::make_input(knit::octopus(0.15)), parameters));
    desk.session.document->timeline.extend_to_end();
    desk.session.view->side = SidePanel::tubes;
    desk.settle();
    const auto& plan = *desk.session.document->timeline.furthest().tubes;
    CAPTURE(scale, plan.tubes.size());
    REQUIRE(plan.tubes.size() > 8);
    for (std::size_t tube = 0; tube < plan.tubes.size(); ++tube)
      CHECK(desk.ui.controls.count("tube/" + knit::tube_name(static_cast<TubeId>(tube))) == 1);
    CHECK(desk.ui.controls.count("tube-line/A") == 1);
    CHECK(desk.ui.controls.count("tube-line/" +
                                 knit::tube_name(static_cast<TubeId>(plan.tubes.size() - 1))) == 0);
  }
}

TEST_CASE("tubes panel: names in a narrow column are short where letters follow each other",
          "[tubes-panel]") {
  CHECK(short_names({}).empty());
  CHECK(short_names({2}) == "C");
  CHECK(short_names({3, 2}) == "C, D");
  CHECK(short_names({8, 3, 4, 5, 6, 7, 1}) == "B, D to I");
  CHECK(short_names({0, 1, 2, 4, 5}) == "A to C, E, F");
}
