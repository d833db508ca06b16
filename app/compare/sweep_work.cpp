#include "app/compare/sweep_work.h"

#include "app/base/beside.h"
#include "knit/model/settings_table.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace app {

namespace {
constexpr std::size_t steps_a_look = 256;  // between two looks whether it is still wanted
}

struct SweepWork::Shared {
  SweepBase base;
  SweepPlan plan;
  std::vector<double> first, second;
  std::vector<SweepRun> runs;
  std::unique_ptr<std::atomic<bool>[]> ready;
  RunTally prefix;  // written before the other threads start
  std::atomic<std::size_t> next{0}, done{0};
  std::atomic<bool> cancelled{false};
  std::mutex mutex;
  std::condition_variable ended;
  unsigned threads = 0;                                                  // still at it; guarded by the mutex
  std::array<std::optional<QuietStretch>, narrowed_kinds.size()> quiet;  // written before `narrowed` is set
  std::atomic<bool> narrowed{false};

  [[nodiscard]] std::vector<double> values_at(std::size_t index) const {
    if (second.empty()) return {first[index]};
    return {first[index / second.size()], second[index % second.size()]};
  }

  // False: no longer wanted.
  bool go_on_while_wanted(RunTally& run, const Knobs& knobs, knit::Stage before) const {
    while (go_on(run, *base.input, knobs, steps_a_look, before)) {
      if (cancelled.load(std::memory_order_relaxed)) return false;
    }
    return true;
  }

  // A fault of ours in one run is its result, too: the others go on.
  bool work_out(SweepRun& run) const {
    try {
      return work_out_soundly(run);
    } catch (const std::exception& error) {
      run.refused = std::string("this run went wrong inside the program: ") + error.what() + ".";
      return true;
    }
  }

  bool work_out_soundly(SweepRun& run) const {
    const auto knobs = swept_knobs(base, plan, run.values);
    if (const auto* fault = std::get_if<std::string>(&knobs)) {
      run.refused = *fault;
      return true;
    }
    RunTally tally = prefix;
    if (!go_on_while_wanted(tally, std::get<Knobs>(knobs), knit::Stage::done)) return false;
    run.figures = figures_of(tally, std::get<Knobs>(knobs));
    run.tubes = tube_figures_of(tally.state);
    const knit::StitchSize& stitch = parameters_at(std::get<Knobs>(knobs), tally.state.next).stitch;
    if (tally.state.tubes) run.uncovered = uncovered_share(*base.input, tally.state, stitch);
    return true;
  }

  // Where even this goes wrong, each run begins at the beginning and tells.
  bool work_out_prefix() {
    try {
      return go_on_while_wanted(prefix, base.knobs, first_reader_of(plan, base.knobs));
    } catch (const std::exception&) {
      prefix = {};
      return true;
    }
  }

  // The next run. False: there is none, or it is no longer wanted.
  bool work_on() {
    const std::size_t index = next.fetch_add(1, std::memory_order_relaxed);
    if (index >= runs.size() || cancelled.load(std::memory_order_relaxed)) return false;
    runs[index].values = values_at(index);
    if (!work_out(runs[index])) return false;
    ready[index].store(true, std::memory_order_release);
    done.fetch_add(1, std::memory_order_release);
    return true;
  }

  // One run, or the end of this hand's work.
  bool work_or_leave() {
    if (work_on()) return true;
    leave();
    return false;
  }

  // The runs between two neighbours, each once although both kinds may ask for it. Null: no longer wanted.
  const SweepRun* between(std::vector<std::unique_ptr<SweepRun>>& tried, double value) const {
    for (const auto& run : tried) {
      if (run->values.front() == value) return run.get();
    }
    auto run = std::make_unique<SweepRun>();
    run->values = {value};
    if (!work_out(*run)) return nullptr;
    return tried.emplace_back(std::move(run)).get();
  }

  static bool is_quiet(const SweepRun& run, std::optional<knit::ProblemKind> kind) {
    const knit::ProblemCounts& problems = run.figures.problems;
    return run.refused.empty() && run.figures.finished && (kind ? problems.of(*kind) : problems.total()) == 0;
  }

  void narrow() {
    if (!second.empty() || done.load(std::memory_order_acquire) < runs.size()) return;
    const bool whole = std::holds_alternative<knit::Count>(knit::find_parameter(plan.axis.key)->kind);
    std::vector<std::unique_ptr<SweepRun>> tried;
    for (std::size_t k = 0; k < narrowed_kinds.size(); ++k) {
      const std::optional<knit::ProblemKind> kind = narrowed_kinds.at(k);
      std::vector<bool> answers;
      for (const SweepRun& run : runs) answers.push_back(is_quiet(run, kind));
      auto& stretch = quiet.at(k) = longest_quiet(first, answers);
      if (!stretch) continue;
      narrow_down(*stretch, whole, [&](double value) -> std::optional<bool> {
        const SweepRun* run = between(tried, value);
        return run != nullptr ? std::optional(is_quiet(*run, kind)) : std::nullopt;
      });
    }
  }

  // The last one narrows down.
  void leave() {
    {
      const std::lock_guard lock(mutex);
      if (threads > 1) {
        --threads;
        return;
      }
    }
    narrow();
    narrowed.store(true, std::memory_order_release);
    const std::lock_guard lock(mutex);
    threads = 0;
    ended.notify_all();
  }
};

SweepWork::SweepWork(SweepBase base, const SweepPlan& plan, unsigned threads)
    : shared_(std::make_shared<Shared>()) {
  Shared& shared = *shared_;
  shared.base = std::move(base);
  shared.plan = plan;
  shared.first = values_of(plan.axis);
  if (plan.second) shared.second = values_of(*plan.second);
  shared.runs.resize(shared.first.size() * std::max<std::size_t>(1, shared.second.size()));
  shared.ready = std::make_unique<std::atomic<bool>[]>(shared.runs.size());
  const unsigned wanted = threads > 0 ? threads : hands_beside();
  shared.threads = static_cast<unsigned>(std::min<std::size_t>(wanted, shared.runs.size()));
  // The first thread runs what is shared, then all of them take runs.
  start_in_pieces([box = shared_, count = shared.threads, begun = false]() mutable {
    if (begun) return box->work_or_leave();
    begun = true;
    const bool wanted_still = box->work_out_prefix();
    for (unsigned i = 1; i < count; ++i) {
      if (wanted_still)
        start_in_pieces([box] { return box->work_or_leave(); });
      else
        box->leave();
    }
    if (!wanted_still) box->leave();
    return wanted_still;
  });
}

SweepWork::~SweepWork() { cancel(); }

void SweepWork::cancel() { shared_->cancelled.store(true, std::memory_order_relaxed); }

void SweepWork::wait() {
  std::unique_lock lock(shared_->mutex);
  shared_->ended.wait(lock, [&] { return shared_->threads == 0; });
}

std::size_t SweepWork::total() const { return shared_->runs.size(); }
std::size_t SweepWork::done() const { return shared_->done.load(std::memory_order_acquire); }
bool SweepWork::running() const { return !cancelled() && !shared_->narrowed.load(std::memory_order_acquire); }
bool SweepWork::cancelled() const { return shared_->cancelled.load(std::memory_order_relaxed); }

const SweepRun* SweepWork::run(std::size_t index) const {
  if (index >= total() || !shared_->ready[index].load(std::memory_order_acquire)) return nullptr;
  return &shared_->runs[index];
}

const QuietStretch* SweepWork::quiet(std::optional<knit::ProblemKind> kind) const {
  const auto* found = std::find(narrowed_kinds.begin(), narrowed_kinds.end(), kind);
  if (found == narrowed_kinds.end() || !shared_->narrowed.load(std::memory_order_acquire)) return nullptr;
  const auto& stretch = shared_->quiet.at(static_cast<std::size_t>(found - narrowed_kinds.begin()));
  return stretch ? &*stretch : nullptr;
}
const SweepPlan& SweepWork::plan() const { return shared_->plan; }
const SweepBase& SweepWork::base() const { return shared_->base; }
const std::vector<double>& SweepWork::first_values() const { return shared_->first; }
const std::vector<double>& SweepWork::second_values() const { return shared_->second; }

bool swept_otherwise(const SweepWork& work, const knit::Timeline& now) {
  const SweepPlan& plan = work.plan();
  const SweepBase& base = work.base();
  if (now.input_pointer() != base.input || now.edits().size() != base.knobs.edits.size()) return true;
  const auto is_swept = [&](std::string_view key) {
    return key == plan.axis.key || (plan.second && key == plan.second->key);
  };
  const auto table = knit::parameter_table();
  const std::string_view sizes = knit::find_parameter(knit::keys::sizes)->group;
  // Stitch sizes follow each other.
  const bool sizes_swept = std::any_of(table.begin(), table.end(), [&](const knit::ParameterInfo& info) {
    return info.group == sizes && is_swept(info.key);
  });
  return std::any_of(table.begin(), table.end(), [&](const knit::ParameterInfo& info) {
    if (is_swept(info.key) || (sizes_swept && info.group == sizes)) return false;
    if (sizes_swept && knit::only_follows(info, base.current, now.parameters())) return false;
    return !knit::same_value(info, now.parameters(), base.current);
  });
}

}  // namespace app
