// Fabrics with short rows: what hangs on the needle, joins and labels, faces, the knitting path, and what settles.
#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "knit/fabric/fabric.h"
#include "knit/model/bug.h"
#include "knit/settle/graph.h"
#include "knit/stitches/operations.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/short_tube.h"

using namespace knit;
using test_support::ShortArc;
using test_support::ShortTube;

namespace {

// What the faces of all strips make together.
struct Sewn {
  std::int32_t stitches = 0, edges = 0, faces = 0, triangles = 0, turns = 0, boundary = 0;
  std::int32_t twice = 0;        // sides that two faces run along the same way
  std::int32_t turned_over = 0;  // faces that look inwards
  [[nodiscard]] std::int32_t euler() const { return stitches - edges + faces; }
};

Sewn sewn(const Fabric& fabric) {
  Sewn all;
  const std::vector<glm::dvec3> path = knitting_path(fabric);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  all.stitches = static_cast<std::int32_t>(path.size());
  for (const auto& strip : fabric.strips()) {
    for (const Face& face : strip->faces) {
      ++all.faces;
      all.triangles += face.corner_count == 3 ? 1 : 0;
      all.turns += is_turn(face.label) ? 1 : 0;
      const auto count = static_cast<std::size_t>(face.corner_count);
      for (std::size_t i = 0; i < count; ++i) ++sides[{face.corners[i], face.corners[(i + 1) % count]}];
      const auto at = [&](std::size_t i) { return path[face.corners[i]]; };
      const glm::dvec3 normal = glm::cross(at(2) - at(0), count == 4 ? at(3) - at(1) : at(0) - at(1));
      glm::dvec3 outward = at(0) + at(1) + at(2);
      outward.y = 0.0;
      all.turned_over += glm::dot(normal, outward) <= 0.0 ? 1 : 0;
    }
  }
  for (const auto& [side, count] : sides) {
    const bool back = sides.count({side.second, side.first}) > 0;
    all.twice += count > 1 ? 1 : 0;
    all.boundary += back ? 0 : 1;
    all.edges += !back || side.first < side.second ? 1 : 0;
  }
  return all;
}

std::int32_t pairs_of(const ShortTube& tube) {
  std::size_t pairs = 0;
  for (const auto& arcs : tube.pairs) pairs += arcs.size();
  return static_cast<std::int32_t>(pairs);
}

std::int32_t shaped(const ShortTube& tube) {
  std::int32_t all = 0;
  for (std::size_t k = 1; k < tube.sizes.size(); ++k) all += std::abs(tube.sizes[k] - tube.sizes[k - 1]);
  return all;
}

std::vector<StitchRef> refs(const LiveStitches& live) {
  std::vector<StitchRef> all;
  for (std::int32_t i = 0; i < live.size(); ++i) all.push_back(live.at(i));
  return all;
}

}  // namespace

TEST_CASE("a short row takes an arc of the loop and puts its own stitches there", "[short-rows]") {
  const Fabric fabric = test_support::rows_of({{8, 8}, {{{2, 4}}}});
  REQUIRE(fabric.row_count() == 4);
  const Row& out = fabric.row(2);
  const Row& back = fabric.row(3);
  CHECK(out.on == LiveStitches{{{1, 2, 3}}, false});
  CHECK(back.on == LiveStitches{{{2, 0, 3}}, false});
  CHECK(out.turned->marked() == StitchRef{1, 5});
  CHECK(back.turned->marked() == StitchRef{1, 1});
  CHECK(fabric.row(4).on == LiveStitches{{{1, 0, 2}, {3, 0, 3}, {1, 5, 3}}, true});
  CHECK(fabric.under_short_rows(fabric.row(4).on) == all_of(fabric.row(1)));
  for (const RowId id : {2, 3, 4}) CHECK(fabric.row_below(id) == &fabric.row(1));
  CHECK_FALSE(fabric.continues(2));
  CHECK(fabric.continues(3));
  CHECK_FALSE(fabric.continues(4));
  CHECK(fabric.rows_on(1) == std::vector<RowId>{2, 4});
  CHECK(fabric.live(0) == all_of(fabric.row(4)));
}

TEST_CASE("an arc over the beginning of the round leaves the round beginning where it did", "[short-rows]") {
  const Fabric fabric = test_support::rows_of({{8, 8}, {{{-2, 1}}}});
  CHECK(fabric.row(2).on == LiveStitches{{{1, 6, 2}, {1, 0, 2}}, false});
  CHECK(fabric.row(4).on == LiveStitches{{{3, 2, 2}, {1, 2, 4}, {3, 0, 2}}, true});
  CHECK(fabric.under_short_rows(fabric.row(4).on) == all_of(fabric.row(1)));
}

TEST_CASE("a short row that does not fit its needle is refused", "[short-rows]") {
  const Fabric fabric = test_support::rows_of({{8}, {}});
  std::vector<ShortArc> arcs{{2, 4}};
  test_support::ShortRowPlaces places(8, arcs, 0.0, 1.0);
  const Row good = test_support::short_row_at(fabric, arcs.front(), false, places);
  const auto refused = [&](const auto& change) {
    Row row = good;
    change(row);
    Fabric copy = fabric;
    try {
      copy.add(std::move(row));
    } catch (const Bug&) {
      return true;
    }
    return false;
  };
  CHECK_FALSE(refused([](Row&) {}));
  CHECK(refused([](Row& row) { row.stitches.pop_back(); }));
  CHECK(refused([](Row& row) { row.closed = true; }));
  CHECK(refused([](Row& row) { row.turned->after = {1, 6}; }));
  CHECK(refused([](Row& row) { row.turned->before = {1, 2}; }));
  CHECK(refused([](Row& row) { row.on = LiveStitches{{{1, 2, 2}, {1, 5, 1}}, false}; }));
  CHECK(refused([](Row& row) { row.on = LiveStitches{{{2, 0, 3}}, false}; }));
}

TEST_CASE("short rows end with the labels of their turns and the round over them has the marks",
          "[short-rows]") {
  const Fabric fabric = test_support::fabric_of({{10, 10}, {{{3, 6}}}});
  const auto& out = fabric.join_into(2)->labels;
  const auto& back = fabric.join_into(3)->labels;
  CHECK(out.back() == Label::turn_left);
  CHECK(back.front() == Label::turn_right);
  CHECK(std::count_if(out.begin(), out.end(), is_turn) == 1);
  CHECK(std::count_if(back.begin(), back.end(), is_turn) == 1);
  const Join& round = *fabric.join_into(4);
  std::vector<std::int32_t> marked;
  for (std::int32_t cell = 0; cell < 10; ++cell) {
    if (round.labels[static_cast<std::size_t>(cell)] == Label::marked)
      marked.push_back(ends_of(round, cell).below);
  }
  std::vector<std::int32_t> wanted;
  for (const std::int32_t place : {2, 7}) {
    if (!std::binary_search(round.mains.begin(), round.mains.end(), place)) wanted.push_back(place);
  }
  CHECK(marked == wanted);
  CHECK(fabric.marked_below(4) == std::vector<std::int32_t>{2, 7});
}

TEST_CASE("a wider pair works the marks of the one inside it", "[short-rows]") {
  const Fabric fabric = test_support::fabric_of({{12, 12}, {{{4, 6}, {2, 8}}}});
  CHECK(fabric.marked_below(4) == std::vector<std::int32_t>{1, 5});
  CHECK(fabric.marked_below(5).empty());
  CHECK(fabric.marked_below(6) == std::vector<std::int32_t>{1, 9});
}

TEST_CASE("the knitting path runs back through a short row on the wrong side", "[short-rows]") {
  const Fabric fabric = test_support::fabric_of({{8, 8}, {{{2, 4}}}});
  const std::vector<glm::dvec3> path = knitting_path(fabric);
  const KnittingPath numbers(fabric);
  REQUIRE(path.size() == 22);
  CHECK(numbers.at(8) == StitchRef{2, 0});
  CHECK(numbers.at(11) == StitchRef{3, 2});
  CHECK(numbers.at(13) == StitchRef{3, 0});
  for (std::uint32_t i = 0; i < path.size(); ++i) {
    CHECK(fabric.path_index(numbers.at(i)) == i);
    CHECK(numbers.position(i) == path[i]);
  }
  CHECK(fabric.path_indices(all_of(fabric.row(3))) == std::vector<std::uint32_t>{13, 12, 11});
  std::vector<glm::dvec3> shifted = path;
  for (glm::dvec3& place : shifted) place.y += 1.0;
  const Fabric moved = fabric.moved_to(shifted);
  CHECK(knitting_path(moved) == shifted);
  CHECK(fabric.moved_to(path) == fabric);
}

TEST_CASE("a turn is two triangles at the marked stitch", "[short-rows]") {
  const Fabric fabric = test_support::fabric_of({{8, 8}, {{{2, 4}}}});
  const Strip& out = *fabric.strip_into(2);
  REQUIRE(out.faces.size() == 4);
  // Stitches 3 to 5 of the cast on are 2, 3 and 4 along the path; the short row out is 8, 9, 10 and the one back 13, 12, 11.
  CHECK(out.faces[2] == Face{{4, 10, 5, 0}, 3, 2, Label::turn_left});
  CHECK(out.faces[3] == Face{{1, 8, 2, 0}, 3, 0, Label::turn_right});
  const Strip& back = *fabric.strip_into(3);
  CHECK(back.faces[2] == Face{{10, 11, 5, 0}, 3, 2, Label::turn_left});
  CHECK(back.faces[3] == Face{{1, 13, 8, 0}, 3, 0, Label::turn_right});
}

TEST_CASE("random tubes with random pairs are whole", "[short-rows]") {
  std::int32_t pairs = 0, with_pairs = 0, over = 0, shaping = 0;
  const std::uint32_t all = test_support::repeated(400U);
  for (std::uint32_t seed = 1; seed <= all; ++seed) {
    const ShortTube tube = test_support::random_short_tube(seed);
    const Fabric fabric = test_support::fabric_of(tube);
    const Sewn whole = sewn(fabric);
    CAPTURE(seed, pairs_of(tube));
    CHECK(whole.twice == 0);
    CHECK(whole.euler() == 0);
    CHECK(whole.boundary == tube.sizes.front() + tube.sizes.back());
    CHECK(whole.triangles == shaped(tube) + 4 * pairs_of(tube));
    CHECK(whole.turns == 4 * pairs_of(tube));
    CHECK(whole.turned_over == 0);
    pairs += pairs_of(tube);
    with_pairs += pairs_of(tube) > 0 ? 1 : 0;
    shaping += shaped(tube);
    for (const auto& arcs : tube.pairs)
      over += static_cast<std::int32_t>(
          std::count_if(arcs.begin(), arcs.end(), [](const ShortArc& arc) { return arc.first < 0; }));
  }
  if (!test_support::whole()) return;
  CHECK(pairs > 800);
  CHECK(with_pairs > 200);
  CHECK(over > 100);
  CHECK(shaping > 400);
}

TEST_CASE("counts and links of rounds are the same with and without short rows", "[short-rows]") {
  const std::uint32_t all = test_support::repeated(100U);
  for (std::uint32_t seed = 1; seed <= all; ++seed) {
    const ShortTube tube = test_support::random_short_tube(seed);
    const Fabric with = test_support::fabric_of(tube);
    const Fabric without = test_support::fabric_of({tube.sizes, {}});
    std::vector<const Join*> rounds;
    for (const auto& join : with.joins()) {
      CAPTURE(seed, join->to);
      const OperationCount made = count(operations_of(*join));
      CHECK(made.consumed == join->below);
      CHECK(made.produced == join->above);
      if (!is_short(with.row(join->to))) rounds.push_back(&*join);
    }
    REQUIRE(rounds.size() == without.joins().size());
    for (std::size_t i = 0; i < rounds.size(); ++i) {
      const Join& plain = *without.joins()[i];
      CHECK(rounds[i]->link == plain.link);
      CHECK(rounds[i]->mains == plain.mains);
      CHECK(refs(with.under_short_rows(rounds[i]->from)).size() == refs(plain.from).size());
    }
  }
}

TEST_CASE("the pairs of a fabric are those that it was made with", "[short-rows]") {
  const std::uint32_t all = test_support::repeated(50U);
  for (std::uint32_t seed = 1; seed <= all; ++seed) {
    const ShortTube tube = test_support::random_short_tube(seed);
    const Fabric fabric = test_support::rows_of(tube);
    std::size_t k = 0;
    for (RowId id = fabric.next_worked(0); id != 0; id = fabric.next_worked(id)) {
      if (is_short(fabric.row(id))) continue;
      std::vector<std::array<std::int32_t, 2>> made;
      for (const ShortArc& arc : tube.pairs[k]) made.push_back({arc.first, arc.last});
      CAPTURE(seed, id);
      CHECK(short_arcs_below(fabric, id) == made);
      ++k;
    }
  }
}

TEST_CASE("no yarn runs across a turn when stitches settle", "[short-rows]") {
  const Fabric fabric = test_support::fabric_of({{8, 8}, {{{2, 4}}}});
  const SettleGraph graph = make_settle_graph(fabric);
  const auto has = [](const auto& pairs, std::uint32_t a, std::uint32_t b) {
    return std::find(pairs.begin(), pairs.end(), std::array{std::min(a, b), std::max(a, b)}) != pairs.end();
  };
  for (const auto& [end, beside] : {std::pair{10U, 5U}, {11U, 5U}, {8U, 1U}, {13U, 1U}}) {
    CHECK_FALSE(has(graph.courses, end, beside));
    CHECK_FALSE(has(graph.wales, end, beside));
    CHECK(has(graph.beside, end, beside));
  }
  // Of rounds 8 each, of short rows 2 each; columns 8 and 2 times 3.
  CHECK(graph.courses.size() == 20);
  CHECK(graph.wales.size() == 14);
  // The round's quads over the turns lead over them below.
  CHECK(graph.quads.size() == 4 + 8 - 2);
  CHECK(graph.rims.size() == 2);
}
