// WholeCounts of rows from contours of which no change is undone within eight rounds.
#include "knit/rows/lasting_counts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <string>

#include "knit/insight/causes.h"
#include "knit/insight/narrate.h"
#include "knit/model/stitch_size.h"
#include "knit/rhythm/deviation.h"
#include "knit/rows/contour_rows.h"
#include "knit/rows/row_code.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"

using namespace knit;

namespace {

using Ideals = std::vector<double>;
using WholeCounts = std::vector<std::int32_t>;

// Rows of a ball whose widest holds `belt` stitches.
Ideals ball_ideals(double belt, std::size_t rows) {
  Ideals ideals;
  for (std::size_t row = 0; row < rows; ++row) {
    const double turn = std::numbers::pi * (static_cast<double>(row) + 0.5) / static_cast<double>(rows);
    ideals.push_back(belt * std::sin(turn));
  }
  return ideals;
}

// Increases that a decrease follows within eight rounds.
std::size_t increases_undone(std::span<const std::int32_t> counts) {
  std::size_t undone = 0;
  for (std::size_t row = 1; row < counts.size(); ++row)
    undone += counts[row] > counts[row - 1] && is_undone(counts, row) ? 1U : 0U;
  return undone;
}

double most_off(const Ideals& ideals, const WholeCounts& counts, double from) {
  double most = 0.0;
  for (std::size_t row = 0; row < ideals.size(); ++row) {
    if (ideals[row] >= from) most = std::max(most, std::abs(counts[row] - ideals[row]) / ideals[row]);
  }
  return most;
}

// Another way to the same: all counts that are near enough are gone through. Undone are changes within eight rounds after
// the last one of the other sign.
struct Tried {
  int undone = 1000;
  double misfit = 0.0;
};
class AllCounts {
 public:
  explicit AllCounts(const Ideals& ideals) : ideals_(ideals) { go(0, 0, 0, 0, {0, 0.0}); }
  [[nodiscard]] const Tried& best() const { return best_; }

 private:
  void go(std::size_t row, std::int32_t below, int sign, std::size_t changed, Tried so_far) {
    if (row == ideals_.size()) {
      const bool better =
          so_far.undone != best_.undone ? so_far.undone < best_.undone : so_far.misfit < best_.misfit;
      if (better) best_ = so_far;
      return;
    }
    for (auto count = static_cast<std::int32_t>(0.9 * ideals_[row]); count <= 1.1 * ideals_[row]; ++count) {
      const bool near = std::abs(count - ideals_[row]) <= lasting_tolerance * ideals_[row];
      if (!near && count != nearest_count(ideals_[row])) continue;
      Tried next = so_far;
      next.misfit += misfit_of(ideals_[row], count);
      const int turn = row == 0 || count == below ? 0 : count > below ? 1 : -1;
      if (turn * sign < 0 && row - changed <= 8) ++next.undone;
      go(row + 1, count, turn == 0 ? sign : turn, turn == 0 ? changed : row, next);
    }
  }

  const Ideals& ideals_;
  Tried best_;
};

Tried cost_of(const Ideals& ideals, const WholeCounts& counts) {
  Tried cost{0, 0.0};
  int sign = 0;
  std::size_t changed = 0;
  for (std::size_t row = 0; row < counts.size(); ++row) {
    cost.misfit += misfit_of(ideals[row], counts[row]);
    const int turn = row == 0 || counts[row] == counts[row - 1] ? 0 : counts[row] > counts[row - 1] ? 1 : -1;
    if (turn == 0) continue;
    if (turn * sign < 0 && row - changed <= 8) ++cost.undone;
    sign = turn;
    changed = row;
  }
  return cost;
}

struct Body {
  std::string name;
  Mesh mesh;
};
Mesh ellipsoid(const glm::dvec3& axes) {
  Mesh mesh = icosphere(4);
  for (glm::dvec3& p : mesh.positions) p *= axes;
  return mesh;
}
std::vector<Body> convex_bodies() {
  std::vector<Body> bodies{{"sphere", sphere(48, 31)},
                           {"egg", egg(48, 0.1)},
                           {"capsule", capsule(48, 0.1)},
                           {"stretched sphere", stretched_sphere(48, 0.1)}};
  test_support::Dice dice(20);
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 axes{dice.between(0.6, 1.6), dice.between(0.6, 1.6), dice.between(0.6, 1.6)};
    bodies.push_back({"ellipsoid " + std::to_string(i), ellipsoid(axes)});
  }
  return bodies;
}

// What a run's rows hold, what they have, and why. Stitches so wide that about so many go round, as high as at 22 x 32.
struct CountedRows {
  Ideals ideals;
  WholeCounts counts;
  std::vector<CountReason> reasons;
};
Parameters contours_of(const Input& input, double stitches, PlacementPolicy placement) {
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = placement;
  const glm::dvec3 extent = input.bounds.high - input.bounds.low;
  const double width = std::numbers::pi * 0.5 * (extent.x + extent.z) / stitches;
  give_width(parameters, width);
  give_height(parameters, 22.0 / 32.0 * width);
  return parameters;
}
CountedRows counted_rows(const Timeline& timeline) {
  CountedRows rows;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const auto* chosen = knit::get_if<CountChosen>(timeline.step(i));
    if (chosen == nullptr) continue;
    rows.ideals.push_back(chosen->ideal);
    rows.counts.push_back(chosen->count);
    rows.reasons.push_back(chosen->reason);
  }
  return rows;
}

// Whether nine rows on end, of which one is from `first` to `last`, could have one count.
bool could_last(const Ideals& ideals, std::size_t first, std::size_t last) {
  for (std::size_t from = first > 8 ? first - 8 : 0; from <= last && from + 9 <= ideals.size(); ++from) {
    const auto nine = std::span(ideals).subspan(from, 9);
    const auto [low, high] = std::minmax_element(nine.begin(), nine.end());
    for (auto count = static_cast<std::int32_t>(0.95 * *low); count <= 1.05 * *high; ++count) {
      const auto near = [&](double ideal) {
        return std::abs(count - ideal) <= lasting_tolerance * ideal || count == nearest_count(ideal);
      };
      if (std::all_of(nine.begin(), nine.end(), near)) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("lasting counts: the ball of 12 cm keeps its widest count for nine rounds", "[lasting]") {
  const Ideals ideals = ball_ideals(82.94, 59);
  WholeCounts single;
  for (const double ideal : ideals) single.push_back(nearest_count(ideal));
  CHECK(increases_undone(single) == 5);
  const WholeCounts counts = lasting_counts(ideals);
  CHECK(increases_undone(counts) == 0);
  CHECK(most_off(ideals, counts, 24.0) <= lasting_tolerance);
  CHECK(std::count(counts.begin(), counts.end(), 82) == 9);
  CHECK(*std::max_element(counts.begin(), counts.end()) == 82);
  CHECK(seen_deviation(counts, ideals).local < 2.0);
  // Away from the widest rounds nothing changes.
  for (std::size_t row = 0; row < 24; ++row) CHECK(counts[row] == single[row]);
}

TEST_CASE("lasting counts: a waist of three rounds is filled, and rounds that jump to and fro are levelled",
          "[lasting]") {
  const Ideals waist{40, 39, 38, 37, 36.4, 36, 35.6, 35.4, 35.6, 36, 36.4, 37, 38, 39, 40};
  const WholeCounts kept = lasting_counts(waist);
  CHECK(std::count(kept.begin(), kept.end(), 36) == 9);
  CHECK(kept.front() == 40);
  CHECK(kept.back() == 40);
  CHECK(lasting_counts(Ideals{60.6, 60.4, 60.6, 60.4, 60.7, 60.3}) == WholeCounts{61, 61, 61, 61, 61, 60});
  CHECK(lasting_counts(Ideals{20.0}) == WholeCounts{20});
  CHECK(lasting_counts({}).empty());
}

TEST_CASE("lasting counts: where a shape swells and narrows too fast it wins, and its step says so",
          "[lasting]") {
  const Ideals cone{8, 14, 20, 26, 32, 38, 44, 42, 40, 38, 36, 34, 32, 30, 28};
  const WholeCounts counts = lasting_counts(cone);
  for (std::size_t row = 0; row < cone.size(); ++row) CHECK(counts[row] == std::lround(cone[row]));
  CHECK(choose_count(cone, 5, 32, 1.0, 0).reason == CountReason::undone);
  CHECK(choose_count(cone, 6, 38, 1.0, 0).reason == CountReason::undone);
  CHECK(choose_count(cone, 7, 44, 1.0, 0).reason == CountReason::ideal);
  CHECK_FALSE(could_last(cone, 5, 7));
}

TEST_CASE("lasting counts: no other counts that are near enough have fewer changes undone, or fit better",
          "[lasting]") {
  test_support::Dice dice(8);
  std::size_t changed = 0;
  for (int run = 0; run < 16; ++run) {
    const double start = dice.between(12.0, 34.0);
    const double slope = dice.between(-1.5, 1.5);
    Ideals ideals;
    for (int row = 0; row < 11; ++row)
      ideals.push_back(start + slope * (row < 5 ? row : 9 - row) + dice.between(-0.6, 0.6));
    const WholeCounts counts = lasting_counts(ideals);
    const Tried wanted = AllCounts(ideals).best();
    const Tried found = cost_of(ideals, counts);
    INFO("run " << run);
    CHECK(found.undone == wanted.undone);
    CHECK(found.misfit == Approx(wanted.misfit).margin(1e-8));
    for (std::size_t row = 0; row < counts.size(); ++row)
      changed += counts[row] != nearest_count(ideals[row]) ? 1U : 0U;
  }
  CHECK(changed > 10);
}

TEST_CASE(
    "lasting counts: on convex bodies no increase is undone within eight rounds, unless the shape forces it",
    "[lasting]") {
  std::map<CountReason, int> reasons;
  std::map<double, int> forced_runs;  // by how many stitches go round
  for (const Body& body : convex_bodies()) {
    const auto input = make_input(body.mesh);
    for (const double stitches : {24.0, 50.0, 83.0}) {
      Timeline timeline(input, contours_of(*input, stitches, PlacementPolicy::nearest));
      timeline.extend_to_end();
      REQUIRE(timeline.stop() == nullptr);
      const CountedRows rows = counted_rows(timeline);
      bool forced = false;
      for (std::size_t row = 1; row < rows.counts.size(); ++row) {
        INFO(body.name << ", " << stitches << " round it, row " << row + 1);
        const bool undone = is_undone(rows.counts, row);
        if (rows.counts[row] > rows.counts[row - 1] && undone) {
          // Where a row makes room for others, or doubles, its step says that.
          CHECK(rows.reasons[row] != CountReason::ideal);
          CHECK(rows.reasons[row] != CountReason::would_be_undone);
          CHECK_FALSE(could_last(rows.ideals, row, row + 8));
          forced = true;
        }
        if (rows.reasons[row] == CountReason::undone) CHECK(undone);
        ++reasons[rows.reasons[row]];
      }
      forced_runs[stitches] += forced ? 1 : 0;
      if (!forced) CHECK(seen_deviation(rows.counts, rows.ideals).local <= 3.5);
    }
  }
  // On fewer than 50 the nine widest rounds are too many of a round body to be alike.
  CHECK(forced_runs == std::map<double, int>{{24.0, 7}, {50.0, 3}, {83.0, 0}});
  CHECK(reasons[CountReason::would_be_undone] > 20);
}

TEST_CASE("lasting counts: in any placement", "[lasting]") {
  const auto input = make_input(sphere(48, 31));
  for (const PlacementPolicy placement : {PlacementPolicy::thesis, PlacementPolicy::even,
                                          PlacementPolicy::nearest, PlacementPolicy::by_itself}) {
    Timeline timeline(input, contours_of(*input, 60.0, placement));
    timeline.extend_to_end();
    REQUIRE(timeline.stop() == nullptr);
    const CountedRows rows = counted_rows(timeline);
    CHECK(increases_undone(rows.counts) == 0);
    CHECK(std::count(rows.reasons.begin(), rows.reasons.end(), CountReason::would_be_undone) > 0);
  }
}

TEST_CASE("lasting counts: a step, its cause and the line of pseudo-code say why", "[lasting]") {
  const auto input = make_input(sphere(48, 31));
  Timeline timeline(input, contours_of(*input, 60.0, PlacementPolicy::nearest));
  timeline.extend_to_end();
  const CountedRows rows = counted_rows(timeline);
  const auto found = std::find(rows.reasons.begin(), rows.reasons.end(), CountReason::would_be_undone);
  REQUIRE(found != rows.reasons.end());
  const auto row = static_cast<RowId>(found - rows.reasons.begin()) + 1;
  CHECK(
      why_count(timeline, row) ==
      "Row 18 has 59 stitches: its loop is 6.018 long, which holds 57.54 stitches of 0.1046; on the 56 below "
      "there may be 28 to 112. Rows 18 to 26 hold 57.54 to 59.96 and all have 59: with what each holds, a "
      "change would be undone within 8 rounds.");
  std::string told;
  bool lit = true;
  for (std::size_t i = 0; i < timeline.known(); ++i) {
    const auto* chosen = knit::get_if<CountChosen>(timeline.step(i));
    if (chosen == nullptr) continue;
    const auto& lines = contour_code.lines;
    const auto line = std::find_if(lines.begin(), lines.end(), [](const CodeLine& l) {
      return l.text.find("if undone in 8 rounds") != std::string_view::npos;
    });
    REQUIRE(line != lines.end());
    const bool is_lasting = chosen->reason == CountReason::would_be_undone;
    lit = lit && line->lit(any_event(timeline.step(i))) == is_lasting;
    if (is_lasting && told.empty()) told = narrate(timeline.step(i), timeline.parameters_of_step(i));
  }
  CHECK(lit);
  CHECK(told ==
        "Row 18: 59 stitches, not the 58 that its length holds, so that no change is undone within 8 "
        "rounds, each 0.102 wide.");
}
