// How far long reading has come, and the wish that it stop: one value that the thread at work and the one that
// waits for it share.
//
// Whoever works says what it is at and how much of that is done, from 0 to 1; where it says so it stops, by
// throwing Cancelled, once that is wished. A null pointer to a Progress: nobody asks.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace knit {

struct Cancelled {};

class Progress {
 public:
  enum class Task : std::uint8_t { reading, checking, preparing };

  void begin(Task task) {
    task_.store(task, std::memory_order_relaxed);
    at(0.0);
  }
  // Throws Cancelled when stop() has been called.
  void at(double share) {
    share_.store(std::clamp(share, 0.0, 1.0), std::memory_order_relaxed);
    if (stopped_.load(std::memory_order_relaxed)) throw Cancelled{};
  }
  void stop() { stopped_.store(true, std::memory_order_relaxed); }

  [[nodiscard]] Task task() const { return task_.load(std::memory_order_relaxed); }
  [[nodiscard]] double share() const { return share_.load(std::memory_order_relaxed); }
  [[nodiscard]] bool stopped() const { return stopped_.load(std::memory_order_relaxed); }

 private:
  std::atomic<Task> task_{Task::reading};
  std::atomic<double> share_{0.0};
  std::atomic<bool> stopped_{false};
};

// A part of a task: its own 0 to 1 is `from` to `to` of the whole. Says so only every so often, as saying costs.
class PartProgress {
 public:
  PartProgress(Progress* whole, double from, double to) : whole_(whole), from_(from), size_(to - from) {}
  void at(std::size_t done, std::size_t of) {
    if (whole_ == nullptr || (++calls_ & 0xFFFU) != 0) return;
    whole_->at(from_ + size_ * static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(of, 1)));
  }

 private:
  Progress* whole_;
  double from_, size_;
  std::size_t calls_ = 0;
};

}  // namespace knit
