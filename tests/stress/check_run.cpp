#include "tests/stress/check_run.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <exception>
#include <set>
#include <vector>

#include "knit/insight/narrate.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/limbs_reader.h"
#include "knit/run/timeline.h"
#include "tests/stress/settling.h"
#include "tests/support/promises.h"
#include "tests/support/rough_sphere.h"

namespace stress {

namespace {

using knit::Timeline;
using test_support::Dice;

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Of the surface by positions, without the program's own graph.
std::int64_t euler_of(const knit::Input& input) {
  std::vector<std::array<knit::VertexId, 2>> edges;
  std::set<knit::VertexId> vertices;
  std::int64_t faces = 0;
  for (const knit::Triangle& t : input.mesh.triangles) {
    const knit::Triangle at{input.twin[t[0]], input.twin[t[1]], input.twin[t[2]]};
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
    ++faces;
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({std::min(at.at(k), at.at((k + 1) % 3)), std::max(at.at(k), at.at((k + 1) % 3))});
      vertices.insert(at.at(k));
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto distinct = std::unique(edges.begin(), edges.end()) - edges.begin();
  return static_cast<std::int64_t>(vertices.size()) - distinct + faces;
}

std::int64_t count_of(const std::vector<knit::TubeEvent>& events, knit::EventKind kind) {
  return std::count_if(events.begin(), events.end(),
                       [&](const knit::TubeEvent& event) { return event.kind == kind; });
}

// Loops are the genus, counts of nodes are the Euler characteristic's, what is left out is told, yarns are the fewest.
std::string broken_graph(const knit::Input& input, const knit::State& state) {
  const knit::TubeGraph& graph = *state.graph;
  const knit::TubePlan& plan = *state.tubes;
  std::int64_t sum = 0;
  for (const knit::GraphNode& node : graph.nodes) {
    const bool extreme = node.kind() == knit::NodeKind::minimum || node.kind() == knit::NodeKind::maximum;
    sum += extreme ? 1 : -1;
    if (node.below.size() + node.above.size() != (extreme ? 1U : 3U)) return "a node has one tube or three";
  }
  const std::int64_t euler = euler_of(input);
  if (sum != euler) return "minima - saddles + maxima is the Euler characteristic";
  if (2 * graph.loops() != 2 - euler) return "the graph's loops are the genus";
  const auto handles = std::count_if(plan.left_out.begin(), plan.left_out.end(),
                                     [](const knit::LeftOut& left_out) { return left_out.handle; });
  if (knit::genus_of(plan) != graph.loops() - handles)
    return "the plan's genus is the graph's less handles left out";
  const std::int64_t yarns = count_of(plan.events, knit::EventKind::cast_on) +
                             count_of(plan.events, knit::EventKind::split) +
                             count_of(plan.events, knit::EventKind::ring_cast_on);
  return knit::order_tubes(plan.tubes, plan.events).yarns == yarns ? "" : "yarns are cast ons and splits";
}

// A position and its state's hash when the run had come just so far.
struct Mark {
  std::size_t position;
  std::uint64_t hash;
};

// Works the run out in ever longer parts.
std::string work_out(Timeline& timeline, std::vector<Mark>& marks) {
  for (std::size_t part = 40; !timeline.complete(); part += part / 2) {
    timeline.extend(part);
    marks.push_back({timeline.known(), knit::hash_of(timeline.furthest())});
    if (std::string broken = test_support::broken_promise(timeline.furthest()); !broken.empty())
      return broken + ", after " + std::to_string(timeline.known()) + " steps";
  }
  return {};
}

// Each mark once more, in any order, a few steps back and forth from it; and on from one to the next.
std::string broken_rewind(Timeline& timeline, std::vector<Mark> marks, Dice& dice) {
  for (std::size_t i = marks.size(); i > 1; --i) std::swap(marks[i - 1], marks[dice.below(i)]);
  for (const Mark& mark : marks) {
    const auto here = [&] {
      return timeline.position() == mark.position && knit::hash_of(timeline.state()) == mark.hash;
    };
    const std::string at = ", at step " + std::to_string(mark.position);
    timeline.seek(mark.position);
    if (!here()) return "seeking leads to the same state" + at;
    const auto away = static_cast<std::size_t>(dice.below(4));
    std::size_t gone = 0;
    while (gone < away && timeline.back()) ++gone;
    for (; gone > 0; --gone) timeline.forward();
    if (!here()) return "going back and forth leads to the same state" + at;
  }
  timeline.seek(marks.front().position);
  for (int i = 0; i < 200 && timeline.position() < timeline.known(); ++i) timeline.forward();
  const std::size_t there = timeline.position();
  const std::uint64_t hash = knit::hash_of(timeline.state());
  timeline.seek(0);
  timeline.seek(there);
  return knit::hash_of(timeline.state()) == hash ? "" : "stepping leads where seeking does";
}

// To another stitch and back again.
std::string broken_tuning(Timeline& timeline, std::uint64_t whole, Dice& dice) {
  const knit::Parameters first = timeline.parameters();
  knit::Parameters other = first;
  knit::give_width(other, first.stitch.width * dice.between(0.8, 1.3));
  timeline.seek(dice.below(timeline.known() + 1));
  timeline.tune(other);
  timeline.extend_to_end();
  if (std::string broken = test_support::broken_promise(timeline.furthest()); !broken.empty())
    return broken + ", tuned to a stitch width of " + std::to_string(other.stitch.width);
  timeline.tune(first);
  timeline.extend_to_end();
  return knit::hash_of(timeline.furthest()) == whole ? "" : "tuning there and back leads to the same state";
}

// The same run without settling.
std::string broken_by_settling(const RandomRun& run, const knit::State& settled) {
  knit::Parameters parameters = run.parameters;
  parameters.settle.settling = knit::Settling::off;
  Timeline timeline(run.input, parameters);
  timeline.extend_to_end();
  if (!timeline.furthest().finished()) return "a run ends with settling as without";
  return test_support::broken_settling(*run.input, settled, timeline.furthest());
}

// The written pattern of a shape that branches reads back without a mistake.
std::string broken_pattern(const RandomRun& run, const knit::State& state) {
  if (!knit::has_limbs(state)) return {};
  const knit::LimbPlan plan = knit::plan_limbs(state);
  knit::RowId row = 0;
  for (const knit::LimbPiece& piece : plan.pieces) {
    for (const knit::RowId of_piece : piece.rows) {
      if (of_piece != ++row) return "rows are made in the order in which pieces are written";
    }
  }
  if (state.tubes && plan.held_most != state.tubes->held_most)
    return "as many holders are planned as the pattern needs";
  const auto written = knit::write_pattern(plan, run.parameters.stitch.gauge, {}, "shape");
  const knit::ReadLimbs read = knit::read_limbs(knit::pattern_as_text(written));
  return read.mistakes.empty() ? std::string() : "a pattern reads back: " + read.mistakes.front().sentence;
}

std::string broken_run(const RandomRun& run, Outcome& outcome) {
  Dice dice(run.dice);
  const std::size_t budget = dice.below(3) == 0 ? 20000 : Timeline::default_budget_bytes;
  Timeline timeline(run.input, run.parameters, budget);
  std::vector<Mark> marks;
  const double start = processor_ms();
  if (std::string broken = work_out(timeline, marks); !broken.empty()) return broken;
  outcome.milliseconds = processor_ms() - start;
  const knit::State& state = timeline.furthest();
  outcome.steps = timeline.known();
  outcome.deals = state.fabric.deals().size();
  outcome.stitches = state.fabric.stitch_count();
  if (state.graph && state.tubes) {
    outcome.tubes = state.tubes->tubes.size();
    outcome.left_out = state.tubes->left_out.size();
    for (const knit::LeftOut& left_out : state.tubes->left_out)
      outcome.handles_left_out += left_out.handle ? 1U : 0U;
    if (std::string broken = broken_graph(*run.input, state); !broken.empty()) return broken;
  }
  const std::uint64_t whole = knit::hash_of(state);
  if (std::string broken = broken_rewind(timeline, marks, dice); !broken.empty()) return broken;
  if (timeline.stop() != nullptr) {
    outcome.verdict = Verdict::stopped;
    outcome.words = knit::narrate(*timeline.stop(), timeline.parameters_of_stop());
    return {};
  }
  if (!state.finished()) return "a run ends or says why";
  if (std::string broken = broken_pattern(run, state); !broken.empty()) return broken;
  if (run.parameters.settle.settling == knit::Settling::on) {
    ++outcome.settled;
    if (std::string broken = broken_by_settling(run, state); !broken.empty()) return broken;
  }
  return dice.below(8) == 0 ? broken_tuning(timeline, whole, dice) : std::string();
}

}  // namespace

Outcome check_run(const RandomRun& run) {
  Outcome outcome;
  try {
    outcome.words += broken_run(run, outcome);
  } catch (const std::exception& error) {
    outcome.words = std::string("thrown: ") + error.what();
    outcome.verdict = Verdict::broken;
    return outcome;
  }
  if (outcome.verdict != Verdict::stopped && !outcome.words.empty()) outcome.verdict = Verdict::broken;
  return outcome;
}

}  // namespace stress
