// Labels against Appendix A, and what must hold for every join.
#include "knit/stitches/placement.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "knit/stitches/appendix.h"
#include "knit/stitches/faces.h"
#include "tests/support/catch.h"
#include "tests/support/join.h"

using namespace knit;

namespace {

const std::vector<std::int32_t> appendix_sizes{6, 12, 17, 22, 26, 32, 32, 43, 43, 43, 44, 62, 65};

std::vector<std::int32_t> mirror_sizes() {
  std::vector<std::int32_t> sizes = appendix_sizes;
  sizes.insert(sizes.end(), 38, 65);
  for (const std::int32_t size : {62, 44, 43, 43, 43, 32, 32, 26, 22, 17, 12, 6, 5}) sizes.push_back(size);
  return sizes;
}

std::map<std::int32_t, std::string> lines_of(const std::vector<std::int32_t>& sizes) {
  const std::vector<Join> joins = plan_joins(sizes, PlacementPolicy::thesis);
  std::vector<const Join*> view;
  for (const Join& t : joins) view.push_back(&t);
  std::map<std::int32_t, std::string> lines;
  for (const LabelRow& row : appendix_view(sizes.front(), view)) {
    CHECK_FALSE(row.into);
    lines[row.row] = text_of(row);
  }
  return lines;
}

// The policies that plan from sizes alone.
std::vector<PlacementPolicy> by_sizes() {
  std::vector<PlacementPolicy> policies;
  for (const Placement& placement : placements()) {
    if (!placement.by_place) policies.push_back(placement.policy);
  }
  return policies;
}

std::int32_t count_shaping(const Join& t) {
  return static_cast<std::int32_t>(std::count_if(t.labels.begin(), t.labels.end(), is_shaping));
}

// Everything that the stages after it rely on.
void check_sound(const Join& t) {
  CAPTURE(t.to, t.below, t.above, static_cast<int>(t.rule));
  const std::int32_t big = std::max(t.below, t.above);
  const std::int32_t small = std::min(t.below, t.above);
  CHECK(static_cast<std::int32_t>(t.labels.size()) == big);
  CHECK(count_shaping(t) == std::abs(t.change()));
  for (const Label label : t.labels) {
    if (is_shaping(label)) CHECK(is_increase(label) == (t.change() > 0));
  }
  std::vector<int> links(static_cast<std::size_t>(small), 0);
  for (std::size_t cell = 0; cell < t.link.size(); ++cell) {
    ++links[static_cast<std::size_t>(t.link[cell])];
    if (cell > 0) CHECK(t.link[cell] - t.link[cell - 1] >= 0);
    if (cell > 0) CHECK(t.link[cell] - t.link[cell - 1] <= 1);
  }
  for (const int count : links) CHECK((count == 1 || count == 2));
  CHECK(t.link.front() == 0);
  CHECK(t.link.back() == small - 1);

  const OperationCount counted = count(operations_of(t));
  CHECK(counted.consumed == t.below);
  CHECK(counted.produced == t.above);

  const Strip strip = test_support::strip_of(t);
  const auto quads = std::count_if(strip.faces.begin(), strip.faces.end(),
                                   [](const Face& f) { return f.corner_count == 4; });
  CHECK(quads == small);
  CHECK(static_cast<std::int32_t>(strip.faces.size()) - quads == std::abs(t.change()));
  for (const Face& face : strip.faces) {
    if (face.corner_count == 3) CHECK(is_shaping(face.label));
  }
}

}  // namespace

TEST_CASE("Appendix A: rows 1, 2, 3, 4, 8 and 12 to the letter") {
  const auto lines = lines_of(appendix_sizes);
  CHECK(lines.at(1) == "1: [5, 5, 5, 5, 5, 5]");
  CHECK(lines.at(2) == "2: [6, 1, 6, 2, 6, 1, 6, 2, 6, 1, 6, 2]");
  CHECK(lines.at(3) == "3: [6, 1, 0, 0, 2, 6, 1, 0, 0, 0, 6, 1, 0, 0, 0, 6, 1]");
  CHECK(lines.at(4) == "4: [6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 6, 1, 0, 0, 0, 0, 0, 0, 2]");
  CHECK(lines.at(8) ==
        "8: [6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, "
        "0, 0, 0, 0, "
        "0, 6, 1, 0, 0, 0, 2]");
  CHECK(lines.at(12) ==
        "12: [6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, "
        "1, 0, 0, 0, "
        "2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2]");
}

TEST_CASE("Appendix A: rows 5 to 7 have its labels in its order, with the zeros that the print lacks") {
  const auto lines = lines_of(appendix_sizes);
  CHECK(lines.at(5) == "5: [6, 1, 0, 0, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2]");
  CHECK(
      lines.at(7) ==
      "7: [6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0]");
}

TEST_CASE("mirror-completed sizes: decreases stand on rows 51-53, 56 and 58-63, the cast off on 64") {
  const std::vector<std::int32_t> sizes = mirror_sizes();
  REQUIRE(sizes.size() == 64);
  const std::vector<Join> joins = plan_joins(sizes, PlacementPolicy::thesis);
  std::vector<const Join*> view;
  for (const Join& t : joins) view.push_back(&t);
  std::vector<std::int32_t> decreasing;
  std::vector<Label> last;
  for (const LabelRow& row : appendix_view(6, view)) {
    if (std::any_of(row.labels.begin(), row.labels.end(), is_decrease)) decreasing.push_back(row.row);
    last = row.labels;
  }
  CHECK(decreasing == std::vector<std::int32_t>{51, 52, 53, 56, 58, 59, 60, 61, 62, 63});
  CHECK(last == std::vector<Label>(5, Label::cast));
  for (const Join& t : joins) check_sound(t);
}

TEST_CASE("worked decreases: 12 to 6 and 6 to 5 as the study has them") {
  const auto lines = lines_of(mirror_sizes());
  CHECK(lines.at(62) == "62: [6, 4, 0, 3, 6, 4, 0, 3, 6, 4, 0, 3]");
  CHECK(lines.at(63) == "63: [6, 4, 0, 0, 0, 0]");
}

TEST_CASE(
    "every legal change between two rows is sound by every policy of sizes, with and without mains below") {
  const PlacementPolicy policy = GENERATE(from_range(by_sizes()));
  for (std::int32_t below = 3; below <= 40; ++below) {
    for (std::int32_t above = std::max(3, (below + 1) / 2); above <= 2 * below; ++above) {
      check_sound(placement_of(policy).plan({{below, {}, true}, above, 2}));
      const std::vector<std::int32_t> mains{0, below / 3, below / 2};
      check_sound(placement_of(policy).plan({{below, mains, false}, above, 3}));
    }
  }
}

TEST_CASE("random tubes are sound from end to end") {
  std::mt19937 random(7);
  for (int tube = 0; tube < 200; ++tube) {
    std::vector<std::int32_t> sizes{std::uniform_int_distribution<std::int32_t>(3, 12)(random)};
    for (int row = 0; row < 30; ++row) {
      const std::int32_t p = sizes.back();
      sizes.push_back(std::uniform_int_distribution<std::int32_t>(std::max(3, (p + 1) / 2),
                                                                  std::min(2 * p, 200))(random));
    }
    const PlacementPolicy policy = by_sizes()[static_cast<std::size_t>(tube) % by_sizes().size()];
    for (const Join& t : plan_joins(sizes, policy)) {
      check_sound(t);
      CHECK(std::is_sorted(t.mains.begin(), t.mains.end()));
      CHECK(
          std::all_of(t.mains.begin(), t.mains.end(), [&](std::int32_t m) { return m >= 0 && m < t.above; }));
    }
  }
}

TEST_CASE("a row that is grown into and shrunk out of keeps both lists") {
  const std::vector<Join> joins = plan_joins(std::vector<std::int32_t>{6, 12, 8}, PlacementPolicy::thesis);
  const std::vector<const Join*> view{joins.data(), joins.data() + 1};
  const std::vector<LabelRow> rows = appendix_view(6, view);
  REQUIRE(rows.size() == 4);
  CHECK(rows[1].row == 2);
  CHECK(std::count_if(rows[1].labels.begin(), rows[1].labels.end(), is_increase) == 6);
  CHECK(rows[2].into == 3);
  CHECK(std::count_if(rows[2].labels.begin(), rows[2].labels.end(), is_decrease) == 4);
  CHECK(text_of(rows[3]) == "3: [5, 5, 5, 5, 5, 5, 5, 5]");
}

TEST_CASE("while more rows are to come, the newest row is no cast off") {
  const std::vector<std::int32_t> sizes{6, 12, 12, 10};
  const std::vector<Join> joins = plan_joins(sizes, PlacementPolicy::thesis);
  const std::vector<const Join*> plain{joins.data(), joins.data() + 1};
  CHECK(appendix_view(6, plain, true).back().labels == std::vector<Label>(12, Label::cast));
  CHECK(appendix_view(6, plain, false).back().labels == joins[1].labels);
  const std::vector<const Join*> shrunk{joins.data(), joins.data() + 1, joins.data() + 2};
  const std::vector<Label> carried = appendix_view(6, shrunk, false).back().labels;
  CHECK(carried.size() == 10);
  CHECK(std::count(carried.begin(), carried.end(), Label::main) == 1);
  CHECK(std::count(carried.begin(), carried.end(), Label::cast) == 0);
}
