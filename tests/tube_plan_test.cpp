// Which tubes are knitted, with how many rows, and in which order.
#include "knit/tubes/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "knit/tubes/simplify.h"
#include "knit/tubes/twins.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;
using test_support::Dice;

namespace {

constexpr double pi = std::numbers::pi;

// A graph made by hand.
struct DrawnTube {
  std::int32_t bottom, top;
  double height, longest;
};
struct Drawn {
  std::vector<GraphNode> nodes;
  std::vector<GraphTube> tubes;
  std::vector<TubeSize> sizes;
};
Drawn draw(const std::vector<DrawnTube>& tubes, std::vector<double> values = {}) {
  Drawn drawn;
  for (const DrawnTube& tube : tubes) {
    const auto id = static_cast<std::int32_t>(drawn.tubes.size());
    const auto bottom = static_cast<std::size_t>(tube.bottom);
    const auto top = static_cast<std::size_t>(tube.top);
    drawn.nodes.resize(std::max(drawn.nodes.size(), top + 1));
    drawn.nodes[bottom].above.push_back(id);
    drawn.nodes[top].below.push_back(id);
    drawn.tubes.push_back({tube.bottom, tube.top});
    drawn.sizes.push_back({tube.height, tube.longest});
  }
  for (std::size_t i = 0; i < drawn.nodes.size(); ++i) {
    drawn.nodes[i].vertex = static_cast<VertexId>(100 + i);
    drawn.nodes[i].value = values.empty() ? static_cast<double>(i) : values[i];
  }
  return drawn;
}

SimpleGraph simplified(const Drawn& drawn, const TubeSettingsNow& settings = {1.0, 1.0, 1}) {
  return simplify_tubes(drawn.nodes, drawn.tubes, drawn.sizes, settings);
}

std::vector<std::int32_t> rows_of(const SimpleGraph& graph) {
  std::vector<std::int32_t> rows;
  for (const TubeChain& chain : graph.chains) rows.push_back(chain.rows);
  return rows;
}
using Rows = std::vector<std::int32_t>;

TubeGraph graph_of(const Mesh& mesh, const glm::dvec3& axis) {
  const auto input = make_input(mesh);
  return find_tubes(make_morse(*input, test_support::field_along(*input, axis)));
}
TubePlan plan_of(const Mesh& mesh, const glm::dvec3& axis, double width) {
  return plan_tubes(graph_of(mesh, axis), {width, 0.72 * width, 1});
}

std::vector<std::int32_t> rows_of(const TubePlan& plan) {
  std::vector<std::int32_t> rows;
  for (const Tube& tube : plan.tubes) rows.push_back(tube.rows());
  return rows;
}

std::vector<EventKind> kinds_of(const TubePlan& plan) {
  std::vector<EventKind> kinds;
  for (const TubeEvent& event : plan.events) kinds.push_back(event.kind);
  return kinds;
}
using Kinds = std::vector<EventKind>;

std::int32_t count_of(const std::vector<TubeEvent>& events, EventKind kind) {
  return static_cast<std::int32_t>(
      std::count_if(events.begin(), events.end(), [&](const TubeEvent& e) { return e.kind == kind; }));
}

// Of yarns: a ring cast on has a rowless leaf, which is cast on, below what is a split.
std::int32_t cast_ons_and_splits(const std::vector<TubeEvent>& events) {
  return count_of(events, EventKind::cast_on) + count_of(events, EventKind::split) +
         count_of(events, EventKind::ring_cast_on);
}

// Events put together at random.
class EventGraph {
 public:
  std::vector<Tube> tubes;
  std::vector<TubeEvent> events;

  EventGraph(Dice& dice, std::size_t steps, bool rings) {
    end_with(EventKind::cast_on, {}, 1);
    for (std::size_t i = 0; i < steps; ++i) {
      const std::size_t choice = dice.below(rings ? 5 : 3);
      if (choice == 0) end_with(EventKind::cast_on, {}, 1);
      if (choice == 1 && !open_.empty()) end_with(EventKind::split, {take(dice)}, 2);
      if (choice == 3) {
        end_with(EventKind::cast_on, {}, 1);
        const TubeId leaf = open_.back();
        open_.pop_back();
        end_with(EventKind::ring_cast_on, {leaf}, 2);
      }
      if (open_.size() < 2) continue;
      if (choice == 2) end_with(EventKind::join, {take(dice), take(dice)}, 1);
      if (choice == 4) {
        end_with(EventKind::ring_bind_off, {take(dice), take(dice)}, 1);
        const TubeId leaf = open_.back();
        open_.pop_back();
        end_with(EventKind::bind_off, {leaf}, 0);
      }
    }
    while (!open_.empty()) end_with(EventKind::bind_off, {take(dice)}, 0);
  }

 private:
  TubeId take(Dice& dice) {
    const auto at = open_.begin() + static_cast<std::ptrdiff_t>(dice.below(open_.size()));
    const TubeId id = *at;
    open_.erase(at);
    return id;
  }
  void end_with(EventKind kind, std::vector<TubeId> below, int above) {
    TubeEvent event;
    event.kind = kind;
    std::sort(below.begin(), below.end());
    const auto id = static_cast<std::int32_t>(events.size());
    for (const TubeId tube : below) tubes[static_cast<std::size_t>(tube)].top = id;
    event.below = std::move(below);
    for (int i = 0; i < above; ++i) {
      open_.push_back(static_cast<TubeId>(tubes.size()));
      event.above.push_back(open_.back());
      tubes.emplace_back();
      tubes.back().bottom = id;
    }
    events.push_back(std::move(event));
  }
  std::vector<TubeId> open_;
};

bool has(const std::vector<TubeId>& ids, TubeId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool is_order(const EventGraph& graph, const std::vector<TubeId>& order) {
  std::vector<TubeId> done;
  for (const TubeId id : order) {
    const TubeEvent& bottom =
        graph.events[static_cast<std::size_t>(graph.tubes[static_cast<std::size_t>(id)].bottom)];
    for (const TubeId below : bottom.below) {
      if (!has(done, below)) return false;
    }
    if (has(done, id)) return false;
    done.push_back(id);
  }
  return done.size() == graph.tubes.size();
}

// What an order takes, by going through it with the loops in hand; without rings.
struct Taken {
  std::int32_t held_most = 0, yarns = 0, held_sum = 0;
  friend auto operator<=>(const Taken&, const Taken&) = default;
};
Taken work_through(const EventGraph& graph, const std::vector<TubeId>& order) {
  Taken taken;
  std::vector<TubeId> done;
  for (const TubeId id : order) {
    const std::vector<TubeId>& feet =
        graph.events[static_cast<std::size_t>(graph.tubes[static_cast<std::size_t>(id)].bottom)].below;
    std::int32_t held = 0;
    for (const TubeEvent& event : graph.events) {
      if (!event.below.empty() &&
          std::all_of(event.below.begin(), event.below.end(), [&](TubeId i) { return has(done, i); })) {
        for (const TubeId above : event.above) held += above != id && !has(done, above) ? 1 : 0;
      } else {
        for (const TubeId below : event.below) held += has(done, below) ? 1 : 0;
      }
    }
    taken.held_most = std::max(taken.held_most, held);
    taken.held_sum += held;
    taken.yarns += !done.empty() && has(feet, done.back()) ? 0 : 1;
    done.push_back(id);
  }
  return taken;
}

struct BestOrder {
  Taken taken{1000000, 0, 0};
  std::vector<TubeId> order;
};
// Of all orders there are; the first of equals in the order of tube numbers.
void try_all(const EventGraph& graph, std::vector<TubeId>& so_far, BestOrder& best) {
  if (so_far.size() == graph.tubes.size()) {
    const Taken taken = work_through(graph, so_far);
    if (taken < best.taken) best = {taken, so_far};
    return;
  }
  for (TubeId id = 0; id < static_cast<TubeId>(graph.tubes.size()); ++id) {
    const std::vector<TubeId>& feet =
        graph.events[static_cast<std::size_t>(graph.tubes[static_cast<std::size_t>(id)].bottom)].below;
    if (has(so_far, id) ||
        !std::all_of(feet.begin(), feet.end(), [&](TubeId foot) { return has(so_far, foot); }))
      continue;
    so_far.push_back(id);
    try_all(graph, so_far, best);
    so_far.pop_back();
  }
}

}  // namespace

TEST_CASE("tube plan: a single tube has the rows that fit between its ends", "[tube-plan]") {
  CHECK(rows_of(simplified(draw({{0, 1, 10.0, 9.0}}))) == Rows{9});
  CHECK(rows_of(simplified(draw({{0, 1, 10.49, 9.0}}))) == Rows{9});
  CHECK(rows_of(simplified(draw({{0, 1, 10.5, 9.0}}))) == Rows{10});
  CHECK(rows_of(simplified(draw({{0, 1, 10.5 - 1e-13, 9.0}}))) == Rows{10});
  const SimpleGraph tiny = simplified(draw({{0, 1, 0.2, 1.0}}));
  CHECK(rows_of(tiny) == Rows{1});
  CHECK(tiny.chains[0].forced);
}

TEST_CASE("tube plan: a limb lower than a row is pruned, and what it met is one tube", "[tube-plan]") {
  const auto body_with_limb = [](double height, double girth) {
    return draw({{0, 2, 10.0, 9.0}, {1, 2, height, girth}, {2, 3, 5.0, 12.0}});
  };
  const SimpleGraph graph = simplified(body_with_limb(0.3, 4.0));
  REQUIRE(graph.chains.size() == 1);
  CHECK(graph.chains[0].parts == std::vector<std::int32_t>{0, 2});
  CHECK(graph.chains[0].height == 15.0);
  CHECK(graph.chains[0].longest == 12.0);
  CHECK(graph.chains[0].rows == 14);
  CHECK(graph.is_kept(0));
  CHECK_FALSE(graph.is_kept(1));
  CHECK_FALSE(graph.is_kept(2));
  REQUIRE(graph.left_out.size() == 1);
  CHECK(graph.left_out[0] == LeftOut{false, 0.3, 4.0, 101, 102, graph.left_out[0].width_that_keeps});
  // The width that is said to keep it does.
  for (const auto& [height, girth] : {std::array{0.3, 4.0}, std::array{20.0, 2.0}, std::array{0.9, 2.2}}) {
    const Drawn drawn = body_with_limb(height, girth);
    REQUIRE(simplified(drawn).left_out.size() == 1);
    const double width = simplified(drawn).left_out[0].width_that_keeps;
    CHECK(width < 1.0);
    CHECK(simplified(drawn, {1.001 * width, 1.001 * width, 1}).left_out.size() == 1);
    CHECK(rows_of(simplified(drawn, {0.999 * width, 0.999 * width, 1}))[1] >= 1);
  }
  // Limbs may be asked to have more rows than one.
  CHECK(rows_of(simplified(body_with_limb(2.3, 4.0))) == Rows{9, 2, 5});
  CHECK(rows_of(simplified(body_with_limb(2.3, 4.0), {1.0, 1.0, 2})) == Rows{9, 2, 5});
  CHECK(rows_of(simplified(body_with_limb(2.3, 4.0), {1.0, 1.0, 3})) == Rows{14});
  // A thin one too, however high.
  CHECK(rows_of(simplified(body_with_limb(20.0, 2.5))) == Rows{9, 19, 5});
  CHECK(rows_of(simplified(body_with_limb(20.0, 2.4))) == Rows{14});
}

TEST_CASE("tube plan: the smallest limb goes first, of equal ones the lower number", "[tube-plan]") {
  const auto fork = [](double left, double right) {
    return simplified(draw({{0, 1, 9.0, 9.0}, {1, 2, left, 4.0}, {1, 3, right, 4.0}}));
  };
  CHECK(fork(0.1, 0.2).chains[0].parts == std::vector<std::int32_t>{0, 2});
  CHECK(fork(0.2, 0.1).chains[0].parts == std::vector<std::int32_t>{0, 1});
  for (const double hair : {-1e-13, 0.0, 1e-13})
    CHECK(fork(0.1 + hair, 0.1).chains[0].parts == std::vector<std::int32_t>{0, 2});
}

TEST_CASE("tube plan: a plateau of one row is pruned", "[tube-plan]") {
  const std::vector<DrawnTube> tubes{{0, 2, 10.0, 9.0}, {1, 2, 1.5, 9.0}, {2, 3, 5.0, 9.0}};
  CHECK(rows_of(simplified(draw(tubes, {0.0, 9.0, 10.0, 15.0}))) == Rows{9, 1, 5});
  const SimpleGraph flat = simplified(draw(tubes, {0.0, 9.99, 10.0, 15.0}));
  CHECK(rows_of(flat) == Rows{14});
  CHECK(flat.left_out[0].width_that_keeps == Approx(1.5 / 2.25));
  // Two rows of it are believed.
  CHECK(rows_of(simplified(draw({{0, 2, 10.0, 9.0}, {1, 2, 2.5, 9.0}, {2, 3, 5.0, 9.0}},
                                {0.0, 9.99, 10.0, 15.0}))) == Rows{9, 2, 5});
}

TEST_CASE("tube plan: a handle without rows is left out where rowless tubes close the ring", "[tube-plan]") {
  const auto ring = [](double left, double girth, double right) {
    return simplified(draw({{0, 1, 5.0, 9.0}, {1, 2, left, girth}, {1, 2, right, 4.0}, {2, 3, 5.0, 9.0}}));
  };
  const SimpleGraph closed = ring(0.3, 4.0, 0.3);
  REQUIRE(closed.left_out.size() == 1);
  CHECK(closed.left_out[0] == LeftOut{true, 0.3, 4.0, 101, 102, closed.left_out[0].width_that_keeps});
  CHECK(closed.left_out[0].width_that_keeps == Approx(0.6));
  REQUIRE(closed.chains.size() == 1);
  CHECK(closed.chains[0].parts == std::vector<std::int32_t>{0, 1, 3});
  CHECK(ring(0.4, 4.0, 0.3).chains[0].parts == std::vector<std::int32_t>{0, 2, 3});
  // Beside one with rows it stays, and is only dealt through.
  const SimpleGraph open = ring(0.3, 4.0, 5.0);
  CHECK(rows_of(open) == Rows{4, 0, 5, 5});
  CHECK(open.left_out.empty());
  CHECK(open.kind_of(1) == EventKind::split);
  CHECK(open.kind_of(2) == EventKind::join);
  // A thread goes in any case.
  CHECK(rows_of(ring(9.0, 1.5, 5.0)) == Rows{4, 0, 5, 5});
  CHECK(rows_of(ring(9.0, 1.4, 5.0)) == Rows{14});
}

TEST_CASE("tube plan: a thin tube that alone holds two bodies together stays", "[tube-plan]") {
  const SimpleGraph graph = simplified(
      draw({{0, 2, 5.0, 9.0}, {1, 3, 5.0, 9.0}, {2, 3, 9.0, 1.0}, {2, 4, 5.0, 9.0}, {3, 5, 5.0, 9.0}}));
  CHECK(rows_of(graph) == Rows{4, 4, 0, 5, 5});
  CHECK(graph.left_out.empty());
}

TEST_CASE("tube plan: a rowless leaf is a ring beside two tubes with rows, else it is given a row",
          "[tube-plan]") {
  const SimpleGraph lying =
      simplified(draw({{0, 1, 0.1, 9.0}, {1, 2, 10.0, 12.0}, {1, 2, 10.0, 6.0}, {2, 3, 0.1, 9.0}}));
  CHECK(rows_of(lying) == Rows{0, 10, 10, 0});
  CHECK(lying.kind_of(0) == EventKind::cast_on);
  CHECK(lying.kind_of(1) == EventKind::ring_cast_on);
  CHECK(lying.kind_of(2) == EventKind::ring_bind_off);
  CHECK(lying.kind_of(3) == EventKind::bind_off);
  // The second of the tubes above divides again before it has a row.
  const std::vector<DrawnTube> three{
      {0, 1, 0.1, 9.0}, {1, 3, 5.0, 6.0}, {1, 2, 0.1, 9.0}, {2, 4, 5.0, 6.0}, {2, 5, 5.0, 6.0}};
  const SimpleGraph forced = simplified(draw(three));
  CHECK(rows_of(forced) == Rows{1, 5, 0, 5, 5});
  CHECK(forced.chains[0].forced);
  CHECK_FALSE(forced.chains[2].forced);
  CHECK(forced.kind_of(1) == EventKind::split);
}

TEST_CASE("tube plan: tubes alike in height and girth get the same rows", "[tube-plan]") {
  const auto legs = [](double left, double right, double right_girth) {
    const Drawn drawn = draw({{0, 2, left, 8.0}, {1, 2, right, right_girth}, {2, 3, 9.0, 12.0}});
    SimpleGraph graph = simplified(drawn);
    std::vector<TubeProfile> profiles;
    for (const TubeSize& size : drawn.sizes)
      profiles.push_back(
          {{0.0, 0.5, 1.0}, {0.0, 0.5 * size.height, size.height}, {0.8 * size.longest, size.longest}});
    const auto twins = match_twins(graph, profiles, 1.0);
    return std::pair{twins, rows_of(graph)};
  };
  using Twins = std::vector<std::vector<TubeId>>;
  const Twins pair{{0, 1}, {0, 1}, {2}}, none{{0}, {1}, {2}};
  CHECK(legs(10.2, 10.26, 8.0) == std::pair{pair, Rows{9, 9, 9}});
  CHECK(legs(10.2, 10.4, 8.0) == std::pair{pair, Rows{10, 10, 9}});  // 9 and 10 alone; 10.3 in the mean
  CHECK(legs(10.2, 10.4, 8.8) == std::pair{pair, Rows{10, 10, 9}});
  CHECK(legs(10.2, 10.4, 9.0) == std::pair{none, Rows{9, 10, 9}});
  CHECK(legs(10.0, 10.6, 8.0) == std::pair{none, Rows{9, 10, 9}});
}

TEST_CASE("tube order: yarns are the cast ons and the splits", "[tube-plan]") {
  Dice dice(5);
  for (int run = 0; run < test_support::repeated(200); ++run) {
    const EventGraph graph(dice, 3 + dice.below(10), run % 2 == 1);
    const TubeOrder order = order_tubes(graph.tubes, graph.events);
    CAPTURE(run);
    REQUIRE(is_order(graph, order.order));
    CHECK(order.yarns == cast_ons_and_splits(graph.events));
    if (run % 2 == 1 || !order.exact) continue;
    const Taken taken = work_through(graph, order.order);
    CHECK(order.held_most == taken.held_most);
    CHECK(order.yarns == taken.yarns);
  }
}

TEST_CASE("tube order: none is better", "[tube-plan]") {
  Dice dice(6);
  for (int run = 0; run < test_support::repeated(300); ++run) {
    const EventGraph graph(dice, 3 + dice.below(4), false);
    if (graph.tubes.size() > 8) continue;
    BestOrder best;
    std::vector<TubeId> so_far;
    try_all(graph, so_far, best);
    const TubeOrder order = order_tubes(graph.tubes, graph.events);
    CAPTURE(run);
    CHECK(order.exact);
    CHECK(order.order == best.order);
    CHECK(order.held_most == best.taken.held_most);
    CHECK(order.yarns == best.taken.yarns);
  }
}

TEST_CASE("tube order: of very many tubes, a good one", "[tube-plan]") {
  Dice dice(7);
  for (const std::size_t steps : {40U, 70U}) {
    const EventGraph graph(dice, steps, true);
    const TubeOrder order = order_tubes(graph.tubes, graph.events);
    CAPTURE(steps, graph.tubes.size());
    CHECK(is_order(graph, order.order));
    CHECK(order.yarns == cast_ons_and_splits(graph.events));
  }
}

TEST_CASE("tube plan: a sphere is one tube, rows as far from its poles as from each other", "[tube-plan]") {
  const TubePlan plan = plan_of(sphere(96, 49), {0, 1, 0}, 0.14);
  CHECK(kinds_of(plan) == Kinds{EventKind::cast_on, EventKind::bind_off});
  REQUIRE(plan.tubes.size() == 1);
  const Tube& tube = plan.tubes[0];
  CHECK(tube.height == Approx(pi).epsilon(1e-3));
  CHECK(tube.longest == Approx(2 * pi).epsilon(2e-3));
  REQUIRE(tube.rows() == 30);  // 31.2 rows' heights
  CHECK(tube.spacing == Approx(tube.height / 31.0));
  CHECK(tube.lowest == tube.curves.front());
  CHECK_FALSE(tube.inner);
  CHECK_FALSE(tube.forced);
  CHECK(tube.twins == std::vector<TubeId>{0});
  for (std::size_t i = 0; i < 30; ++i) {
    const double angle = pi * static_cast<double>(i + 1) / 31.0;
    CHECK(tube.lengths[i] == Approx(2 * pi * std::sin(angle)).epsilon(5e-3));
    CHECK(tube.lengths[i] == tube.curves[i]->length);
    for (const glm::dvec3& p : tube.curves[i]->points) CHECK(p.y == Approx(-std::cos(angle)).margin(5e-3));
  }
  CHECK(plan.order == std::vector<TubeId>{0});
  CHECK(plan.held_most == 0);
  CHECK(plan.yarns == 1);
  CHECK(plan.order_is_exact);
}

TEST_CASE("tube plan: a standing torus divides and meets again, its arms alike", "[tube-plan]") {
  const TubePlan plan = plan_of(torus(64, 32, 1.0, 0.4), {1, 0, 0}, 0.15);
  CHECK(kinds_of(plan) == Kinds{EventKind::cast_on, EventKind::split, EventKind::join, EventKind::bind_off});
  REQUIRE(plan.tubes.size() == 4);
  CHECK(plan.tubes[1].twins == std::vector<TubeId>{1, 2});
  CHECK(plan.tubes[2].twins == std::vector<TubeId>{1, 2});
  CHECK(plan.tubes[1].lengths == plan.tubes[2].lengths);
  CHECK(plan.events[1].position.x == Approx(-0.6).margin(1e-9));
  CHECK(plan.events[1].below == std::vector<TubeId>{0});
  CHECK(plan.events[1].above == std::vector<TubeId>{1, 2});
  for (const Tube& tube : plan.tubes) CHECK_FALSE(tube.inner);
  CHECK(plan.order == std::vector<TubeId>{0, 1, 2, 3});
  CHECK(plan.held_most == 1);
  CHECK(plan.yarns == 2);
  CHECK(plan.left_out.empty());
}

TEST_CASE("tube plan: a lying torus is a ring cast on, an outer and an inner tube, and a graft",
          "[tube-plan]") {
  // Its lowest and its highest ring are level: which of their vertices come first is anybody's guess.
  for (const double hair : {0.0, 1e-13}) {
    Dice dice(3);
    Mesh mesh = torus(64, 32, 1.0, 0.4);
    for (glm::dvec3& p : mesh.positions) p.y += dice.between(-hair, hair);
    const TubePlan plan = plan_of(mesh, {0, 1, 0}, 0.15);
    CHECK(kinds_of(plan) ==
          Kinds{EventKind::cast_on, EventKind::ring_cast_on, EventKind::ring_bind_off, EventKind::bind_off});
    REQUIRE(plan.tubes.size() == 4);
    CHECK(rows_of(plan) == Rows{12, 12, 0, 0});
    const Tube& outer = plan.tubes[plan.tubes[0].inner ? 1 : 0];
    const Tube& inner = plan.tubes[plan.tubes[0].inner ? 0 : 1];
    CHECK_FALSE(outer.inner);
    CHECK(inner.inner);
    CHECK(outer.longest == Approx(2 * pi * 1.4).epsilon(5e-3));
    CHECK(outer.spacing == Approx(outer.height / 12.0));  // half a row beside the rings
    CHECK(plan.held_most == 1);
    CHECK(plan.yarns == 2);
    CHECK(plan.order == std::vector<TubeId>{2, 0, 1, 3});  // numbered by rows, the leaves last
  }
}

TEST_CASE("tube plan: an arch stands on two feet", "[tube-plan]") {
  const TubePlan up = plan_of(test_support::arch(), {0, 1, 0}, 0.1);
  CHECK(kinds_of(up) == Kinds{EventKind::cast_on, EventKind::cast_on, EventKind::join, EventKind::bind_off});
  CHECK(up.tubes[0].twins == std::vector<TubeId>{0, 1});
  CHECK(up.tubes[0].rows() == up.tubes[1].rows());
  const TubePlan down = plan_of(test_support::arch(), {0, -1, 0}, 0.1);
  CHECK(kinds_of(down) ==
        Kinds{EventKind::cast_on, EventKind::split, EventKind::bind_off, EventKind::bind_off});
  CHECK(down.yarns == 2);
  // With stitches too large for one leg's girth both legs are one tube's.
  const TubePlan coarse = plan_of(test_support::arch(), {0, 1, 0}, 0.9);
  CHECK(coarse.tubes.size() == 1);
  REQUIRE(coarse.left_out.size() == 1);
  // Up to the stitch that is said, each has a row of its own.
  const double keeps = coarse.left_out[0].width_that_keeps;
  CHECK(plan_of(test_support::arch(), {0, 1, 0}, 1.001 * keeps).tubes.size() == 1);
  const TubePlan kept = plan_of(test_support::arch(), {0, 1, 0}, 0.999 * keeps);
  REQUIRE(kept.tubes.size() == 3);
  CHECK(kept.tubes[0].rows() == 1);
  CHECK(kept.tubes[0].height / kept.stitch_height == Approx(std::sqrt(0.75 * 1.75)).epsilon(0.01));
}

namespace {

// Outside at a vertex, by area.
glm::dvec3 normal_at(const MorseSurface& surface, VertexId vertex) {
  glm::dvec3 sum{0.0};
  const auto& p = surface.positions;
  for (const Triangle& t : surface.triangles) {
    if (std::find(t.begin(), t.end(), vertex) != t.end())
      sum += glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  }
  return sum;
}

void check_rows(const TubePlan& plan, const Tube& tube) {
  REQUIRE(tube.values.size() == tube.curves.size());
  REQUIRE(tube.lengths.size() == tube.curves.size());
  CHECK(std::is_sorted(tube.values.begin(), tube.values.end()));
  for (const double value : tube.values) {
    CHECK(value >= plan.event(tube.bottom).value);
    CHECK(value <= plan.event(tube.top).value);
  }
  for (const TubeId twin : tube.twins) CHECK(plan.tube(twin).twins == tube.twins);
  CHECK(tube.lowest->points.size() >= 3);
  const bool is_leaf =
      plan.event(tube.bottom).kind == EventKind::cast_on || plan.event(tube.top).kind == EventKind::bind_off;
  const bool at_ring = plan.event(tube.top).kind == EventKind::ring_cast_on ||
                       plan.event(tube.bottom).kind == EventKind::ring_bind_off;
  CHECK((tube.rows() > 0 || !is_leaf || at_ring));
}

void check_plan(const TubeGraph& graph, const TubePlan& plan, const glm::dvec3& axis) {
  const auto handles = static_cast<std::int32_t>(
      std::count_if(plan.left_out.begin(), plan.left_out.end(), [](const LeftOut& l) { return l.handle; }));
  CHECK(static_cast<std::int32_t>(plan.tubes.size() - plan.events.size()) + 1 == graph.loops() - handles);
  CHECK(plan.yarns == cast_ons_and_splits(plan.events));
  CHECK(plan.order.size() == plan.tubes.size());
  for (const LeftOut& left_out : plan.left_out) CHECK(left_out.width_that_keeps < plan.stitch_width);
  for (std::size_t i = 0; i < plan.tubes.size(); ++i) {
    const Tube& tube = plan.tubes[i];
    check_rows(plan, tube);
    CHECK(has(plan.event(tube.bottom).above, static_cast<TubeId>(i)));
    CHECK(has(plan.event(tube.top).below, static_cast<TubeId>(i)));
    // A level curve lies in a plane and never turns inside out within a part.
    if (plan.event(tube.top).kind != EventKind::bind_off || tube.rows() == 0 || tube.parts.size() > 1)
      continue;
    const VertexId top = graph.nodes[static_cast<std::size_t>(plan.event(tube.top).node)].vertex;
    CHECK(tube.inner == (glm::dot(normal_at(graph.surface, top), axis) < 0.0));
  }
}

}  // namespace

TEST_CASE("tube plan: whatever the shape, the direction and the stitch", "[tube-plan]") {
  for (const Mesh& mesh : {torus(40, 24, 1.0, 0.4), test_support::arch(), vase(48, 0.1)}) {
    for (const glm::dvec3& axis : test_support::random_axes(6, 11)) {
      const TubeGraph graph = graph_of(mesh, axis);
      for (const double width : {0.08, 0.2, 0.5, 1.0}) {
        CAPTURE(mesh.name, axis.x, axis.y, axis.z, width);
        const TubePlan plan = plan_tubes(graph, {width, 0.72 * width, 1});
        check_plan(graph, plan, axis);
        CHECK(plan == plan_tubes(graph, {width, 0.72 * width, 1}));
      }
    }
  }
}
