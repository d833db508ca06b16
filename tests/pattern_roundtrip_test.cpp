// From the run to text and back: what a knitter reads leads to the very graph that was written.
#include <random>

#include "app/files/pattern_export.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/checked_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "knit/run/timeline.h"
#include "knit/stitches/placement.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"

using namespace knit;

namespace {

void check_reads_back(const std::string& text, const KnitGraph& graph) {
  const ReadPattern read = read_pattern(text);
  if (!read.mistakes.empty()) {
    CAPTURE(text, read.mistakes.front().sentence);
    FAIL_CHECK("the reader finds a mistake");
    return;
  }
  CHECK(graph_of(read.rounds) == graph);
}

// The checker works the same text to counts alone: it holds there too, and has as many rounds.
void check_counts(const std::string& text, const KnitGraph& graph) {
  const CheckedPattern checked = check_pattern(text);
  CHECK(checked.verdict == PatternVerdict::holds);
  CHECK(checked.not_understood == 0);
  CHECK(checked.rounds + 1 == graph.rows.size());
  CHECK(checked.remark == "");
}

void check_round_trip(const State& state, const Gauge& gauge, bool counts = false) {
  const Rounds rounds = rounds_of(state);
  const KnitGraph graph = graph_of(state);
  CHECK(graph_of(rounds) == graph);
  const Chart chart = chart_of(rounds);
  for (const bool stars : {false, true}) {
    PatternOptions options;
    options.stars = stars;
    options.markers = stars;
    const WrittenPattern pattern = write_pattern(rounds, gauge, options, "piece");
    check_reads_back(pattern_as_text(pattern) + chart_as_text(chart), graph);
    if (counts) check_counts(pattern_as_text(pattern) + chart_as_text(chart), graph);
    if (stars) continue;
    if (counts) {
      check_counts(pattern_as_markdown(pattern) + chart_as_markdown(chart), graph);
      check_counts(app::pattern_html(pattern, chart), graph);
    }
    check_reads_back(pattern_as_markdown(pattern) + chart_as_markdown(chart), graph);
    check_reads_back(app::pattern_html(pattern, chart), graph);
  }
  check_reads_back(app::pattern_knitspeak(rounds), graph);
}

// The rows of a tube of these sizes, without places: labels need none.
State tube_of(const std::vector<std::int32_t>& sizes, PlacementPolicy policy) {
  State state;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Row row;
    row.id = static_cast<RowId>(i) + 1;
    row.on = state.fabric.live(0);
    row.stitches.resize(static_cast<std::size_t>(sizes[i]));
    state.fabric.add(std::move(row));
  }
  for (Join& join : plan_joins(sizes, policy)) state.fabric.add(Shared(std::move(join)));
  return state;
}

}  // namespace

TEST_CASE("round trip: every shape, placement and row source comes back from its text") {
  const std::vector<std::pair<const char*, Mesh>> shapes{{"sphere", sphere(64, 33, false)},
                                                         {"stretched", stretched_sphere(64, 0.1)},
                                                         {"egg", egg(64, 0.1)},
                                                         {"capsule", capsule(64, 0.1)},
                                                         {"cone", cone(64, 0.1)},
                                                         {"vase", vase(64, 0.1)}};
  for (const auto& [name, mesh] : shapes) {
    const auto input = make_input(mesh);
    for (const RowSource source : {RowSource::rings, RowSource::contours}) {
      for (std::size_t i = 0; i < placement_names.size(); ++i) {
        const auto policy = static_cast<PlacementPolicy>(i);
        CAPTURE(name, static_cast<int>(source), static_cast<int>(policy));
        Parameters parameters;
        give_width(parameters, 0.15);
        give_epsilon(parameters, 0.05);
        parameters.timing.kind = source == RowSource::rings ? TimingKind::linear : TimingKind::arc_length;
        parameters.rows.source = source;
        parameters.stitches.placement = policy;
        Timeline timeline(input, parameters);
        timeline.extend_to_end();
        REQUIRE(timeline.furthest().finished());
        check_round_trip(timeline.furthest(), timeline.parameters().stitch.gauge, true);
      }
    }
  }
}

TEST_CASE("round trip: a thousand random tubes come back") {
  std::mt19937_64 random(7);
  const auto draw = [&](std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  for (int tube = 0; tube < test_support::repeated(1000); ++tube) {
    std::vector<std::int32_t> sizes{draw(3, 24)};
    const std::int32_t rows = draw(3, 16);
    while (static_cast<std::int32_t>(sizes.size()) < rows) {
      const std::int32_t below = sizes.back();
      sizes.push_back(draw(std::max(3, (below + 1) / 2), std::min(90, 2 * below)));
    }
    CAPTURE(tube);
    const auto policy = tube % 2 == 0 ? PlacementPolicy::thesis : PlacementPolicy::even;
    check_round_trip(tube_of(sizes, policy), {22.0, 32.0});
  }
}

// Words straight from Appendix A's labels, cell by cell.
std::vector<Hand> hands_of(const std::string& labels) {
  std::vector<Hand> hands;
  for (const char label : labels)
    hands.push_back(label == '1' ? Hand::m1r : label == '2' ? Hand::m1l : Hand::knit);
  return hands;
}

TEST_CASE("the pattern's rounds say what Appendix A's labels say, for its sizes") {
  const std::vector<std::int32_t> sizes{6, 12, 17, 22, 26, 32, 32, 43, 43, 43, 44, 62, 65};
  const Rounds rounds = rounds_of(tube_of(sizes, PlacementPolicy::thesis));
  CHECK(rounds.cast_on == 6);
  const std::vector<std::pair<std::size_t, std::string>> appendix{
      {2, "616261626162"},
      {3, "61002610006100061"},
      {4, "6100002610000610000002"},
      {8, "6100002610000261000026100002610000000610002"},
      {12, "61000261000261000261000261000261000261000261000000000002610002"}};
  for (const auto& [number, labels] : appendix) {
    CAPTURE(number);
    const Round& round = rounds.rounds.at(number - 2);
    REQUIRE(round.number == static_cast<std::int32_t>(number));
    std::vector<Hand> hands;
    for (const Operation& operation : round.operations) hands.push_back(operation.hand);
    CHECK(hands == hands_of(labels));
    CHECK(round.after == static_cast<std::int32_t>(labels.size()));
  }
}

TEST_CASE("the thesis sphere's pattern casts on 6 and has a round for each of its 64 rows") {
  Parameters parameters;
  parameters.rows.close = Closing::thesis;
  Timeline timeline(make_input(sphere(128, 65, true)), parameters);
  timeline.extend_to_end();
  const Rounds rounds = rounds_of(timeline.furthest());
  CHECK(rounds.cast_on == 6);
  CHECK(rounds.rounds.size() == 63);
  CHECK(rounds.last_count() == 6);
  check_round_trip(timeline.furthest(), timeline.parameters().stitch.gauge, true);
}
