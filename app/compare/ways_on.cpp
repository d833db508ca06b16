#include "app/compare/ways_on.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

#include "app/base/beside.h"
#include "app/session/presets.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "knit/run/machine.h"

namespace app {

namespace {

constexpr std::size_t steps_between_looks = 256;       // whether it is still wanted
constexpr std::size_t most_way_steps = 20'000'000;     // of one way: longer ones are not offered
constexpr std::size_t most_solved_triangles = 200000;  // times that are solved for take long beyond
constexpr std::string_view presets_way = "best-rows";

using Ways = std::vector<WayOn>;

std::string count_with_commas(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

// A size that a person would have typed.
double three_digits(double value) {
  if (!(value > 0.0)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::round(value / unit) * unit;
}

void add_axes(Ways& ways, const knit::Parameters& at_stop) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto kind = static_cast<knit::AxisKind>(i);
    if (at_stop.timing.axis.kind == kind) continue;
    const std::string axis(axes[i]);
    ways.push_back(
        {"axis-" + axis, "Along " + axis, [kind](knit::Parameters& p) { p.timing.axis.kind = kind; }, ""});
  }
}

void take_contours(knit::Parameters& parameters) { parameters.rows.source = knit::RowSource::contours; }

void add_contours(Ways& ways, const knit::Input& input) {
  ways.push_back({"contours", "Rows from contours", take_contours, ""});
  if (input.mesh.triangles.size() > most_solved_triangles) return;
  const auto with_timing = [](knit::TimingKind kind) {
    return [kind](knit::Parameters& p) {
      take_contours(p);
      p.timing.kind = kind;
    };
  };
  ways.push_back(
      {"geodesic", "Geodesic timing, rows from contours", with_timing(knit::TimingKind::geodesic), ""});
  ways.push_back(
      {"harmonic", "Harmonic timing, rows from contours", with_timing(knit::TimingKind::harmonic), ""});
}

void add_sizes(Ways& ways, const knit::Input& input, const knit::Parameters& at_stop) {
  const double usual = knit::default_parameters(input.bounds).stitch.width;
  for (const double part : {1.0, 0.5}) {
    if (std::abs(part * usual - at_stop.stitch.width) < 0.01 * usual) continue;
    const double width = three_digits(part * usual);
    const bool usual_size = part > 0.9;
    ways.push_back(
        {usual_size ? "usual-stitch" : "small-stitch",
         (usual_size ? "Stitches of the usual width, " : "Narrower stitches, ") + knit::short_number(width),
         [width](knit::Parameters& p) { knit::give_width(p, width); }, ""});
  }
}

void add_picked_ends(Ways& ways) {
  ways.push_back({"own-ends", "Start and end as the axis has them",
                  [](knit::Parameters& p) { p.timing.start = p.timing.end = knit::no_vertex; }, ""});
}

void add_preset(Ways& ways) {
  const Preset* preset = find_preset(presets_way);
  if (preset == nullptr) return;
  ways.push_back({std::string(presets_way), "Best rows",
                  [preset](knit::Parameters& p) { p = with_preset(*preset, p); },
                  "--preset " + std::string(presets_way)});
}

void add_wider_band(Ways& ways, const knit::Parameters& at_stop) {
  const double epsilon = three_digits(0.8 * at_stop.stitch.width);
  ways.push_back({"epsilon", "A wider band, epsilon " + knit::short_number(epsilon),
                  [epsilon](knit::Parameters& p) { knit::give_epsilon(p, epsilon); }, ""});
}

// What is about the stop alone, before the ways that knit any shape.
void add_by_reason(Ways& ways, const knit::Input& input, const knit::Parameters& at_stop,
                   const knit::Stopped& stop) {
  switch (stop.reason) {
    case knit::StopReason::stall:
      ways.push_back({"continue", "Take the nearest on a stall",
                      [](knit::Parameters& p) { p.rows.on_stall = knit::OnStall::continue_; }, ""});
      return add_wider_band(ways, at_stop);
    case knit::StopReason::changes_too_much:
      ways.push_back({"resample", "Such rows resampled",
                      [](knit::Parameters& p) { p.rows.resample = knit::Resample::on; }, ""});
      return;
    case knit::StopReason::too_many_tubes:
      ways.push_back({"smooth", "The time smoothed over 4 rows",
                      [](knit::Parameters& p) {
                        p.tubes.smoothing = knit::Smoothing::on;
                        p.tubes.smoothing_length = 4.0;
                      },
                      ""});
      return;
    case knit::StopReason::too_fine:
      return add_sizes(ways, input, at_stop);
    case knit::StopReason::open_edge:
      ways.push_back({"harmonic", "Harmonic timing, rows from contours",
                      [](knit::Parameters& p) {
                        p.timing.kind = knit::TimingKind::harmonic;
                        p.rows.source = knit::RowSource::contours;
                      },
                      ""});
      return;
    case knit::StopReason::no_row_levels:
      add_contours(ways, input);
      return add_sizes(ways, input, at_stop);
    default:
      return;
  }
}

// What a command line would have to say beside what is in force.
std::string options_between(const knit::Parameters& now, const knit::Parameters& then) {
  std::string text;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (knit::same_value(info, now, then) || knit::only_follows(info, now, then)) continue;
    text += (text.empty() ? "--" : " --") + std::string(info.key) + " " + knit::value_text(info, then);
  }
  return text;
}

}  // namespace

std::string FoundWay::result() const { return count_with_commas(rows) + (rows == 1 ? " row" : " rows"); }

knit::Parameters with_way(const WayOn& way, knit::Parameters parameters) {
  way.set(parameters);
  return parameters;
}

std::vector<WayOn> ways_to_try(const knit::Input& input, const knit::Parameters& at_stop,
                               const knit::Step& stop) {
  Ways ways;
  if (const auto* stopped = knit::get_if<knit::Stopped>(stop)) add_by_reason(ways, input, at_stop, *stopped);
  add_picked_ends(ways);
  add_contours(ways, input);
  add_axes(ways, at_stop);
  add_preset(ways);
  Ways kept;
  for (WayOn& way : ways) {
    const bool same = with_way(way, at_stop) == at_stop;
    const bool twice =
        std::any_of(kept.begin(), kept.end(), [&](const WayOn& w) { return w.key == way.key; });
    if (same || twice) continue;
    if (way.options.empty()) way.options = options_between(at_stop, with_way(way, at_stop));
    kept.push_back(std::move(way));
  }
  return kept;
}

struct WaysOnWork::Shared {
  SweepBase base;
  Ways ways;
  mutable std::mutex mutex;
  std::condition_variable ended;
  std::vector<FoundWay> found;  // these three are guarded by the mutex; only the one at it changes them
  std::size_t tried = 0;
  bool done = false;
  std::atomic<bool> cancelled{false};

  // Nothing: it does not finish, is refused, or is no longer wanted.
  [[nodiscard]] std::optional<FoundWay> worked_out(const WayOn& way) const {
    const knit::Parameters wanted = with_way(way, base.current);
    if (knit::fault_of(wanted, *base.input)) return std::nullopt;
    const Knobs knobs = tuned(base.knobs, base.current, wanted, *base.input);
    RunTally run;
    while (go_on(run, *base.input, knobs, steps_between_looks)) {
      if (cancelled.load(std::memory_order_relaxed) || run.steps > most_way_steps) return std::nullopt;
    }
    if (!run.state.finished()) return std::nullopt;
    return FoundWay{way, run.state.fabric.rows().size(), run.state.fabric.stitch_count()};
  }

  // With the same rows and stitches it is no choice. Requires the mutex.
  [[nodiscard]] bool is_known(const FoundWay& way) const {
    return std::any_of(found.begin(), found.end(), [&](const FoundWay& other) {
      return other.rows == way.rows && other.stitches == way.stitches;
    });
  }

  [[nodiscard]] std::optional<FoundWay> worked_out_soundly(const WayOn& way) const {
    try {
      return worked_out(way);
    } catch (const std::exception&) {
      return std::nullopt;  // a way that goes wrong is none
    }
  }

  // True while there is another.
  bool try_next() {
    auto one = tried < ways.size() ? worked_out_soundly(ways[tried]) : std::nullopt;
    const std::lock_guard lock(mutex);
    tried = std::min(tried + 1, ways.size());
    if (one && !is_known(*one)) found.push_back(std::move(*one));
    done = tried == ways.size() || found.size() >= enough_ways || cancelled.load(std::memory_order_relaxed);
    if (done) ended.notify_all();
    return !done;
  }
};

WaysOnWork::WaysOnWork(const knit::Timeline& timeline) : shared_(std::make_shared<Shared>()) {
  shared_->base = sweep_base_of(timeline);
  shared_->base.current = timeline.parameters_of_stop();
  shared_->ways = ways_to_try(*shared_->base.input, shared_->base.current, *timeline.stop());
  start_in_pieces([box = shared_] { return box->try_next(); });
}

WaysOnWork::~WaysOnWork() { shared_->cancelled.store(true, std::memory_order_relaxed); }

void WaysOnWork::wait() const {
  std::unique_lock lock(shared_->mutex);
  shared_->ended.wait(lock, [&] { return shared_->done; });
}

bool WaysOnWork::running() const {
  const std::lock_guard lock(shared_->mutex);
  return !shared_->done;
}

std::size_t WaysOnWork::tried() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->tried;
}

std::size_t WaysOnWork::total() const { return shared_->ways.size(); }

std::vector<FoundWay> WaysOnWork::found() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->found;
}

std::string words_of(const WaysOnWork& work) {
  const std::size_t found = work.found().size();
  const std::string tried = knit::plural(static_cast<std::int64_t>(work.tried()), "other way", "other ways");
  if (work.running())
    return "Trying other ways: " + std::to_string(work.tried()) + " of " + std::to_string(work.total()) +
           " so far.";
  if (found == 0) return "None of " + tried + " tried knits this mesh to the end.";
  return found == 1 ? "One way knits it to the end:" : std::to_string(found) + " ways knit it to the end:";
}

}  // namespace app
