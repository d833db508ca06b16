// Long work beside the window: a pure function of values, run on a thread of its own.
//
// Whoever starts work asks `ready` every frame. Work that takes a knit::Heard says how far it has come, and ends where it
// says so once the last Work for it is gone. Other work then finishes unheard: nobody waits for it, and nothing of it is
// kept.
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "app/base/beside.h"
#include "knit/model/heard.h"

namespace app {

// Thrown through work that nobody waits for any more.
struct NobodyWaits {};

template <class Result>
class Work {
 public:
  Work() = default;
  template <class Function>
  explicit Work(Function function) : shared_(std::make_shared<Box>()) {
    start_beside(
        [waiting = std::weak_ptr(shared_), function = std::make_shared<Function>(std::move(function))] {
          std::optional<Result> result;
          std::exception_ptr error;
          try {
            if constexpr (std::is_invocable_v<Function&, const knit::Heard&>) {
              result.emplace((*function)(heard_by(waiting)));
            } else {
              result.emplace((*function)());
            }
          } catch (...) {
            error = std::current_exception();
          }
          const auto box = waiting.lock();
          if (!box) return;
          box->result = std::move(result);
          box->error = error;
          box->done.store(true, std::memory_order_release);
        });
  }

  [[nodiscard]] bool running() const { return shared_ != nullptr; }
  [[nodiscard]] bool ready() const { return shared_ && shared_->done.load(std::memory_order_acquire); }
  // How much of it is done, from 0 to 1, as far as it has said.
  [[nodiscard]] double share() const {
    return shared_ ? shared_->share.load(std::memory_order_relaxed) : 0.0;
  }
  // The result, once; requires ready(). An exception of the work's comes out here.
  Result take() {
    const std::shared_ptr<Box> box = std::move(shared_);
    shared_ = nullptr;
    if (box->error) std::rethrow_exception(box->error);
    return std::move(*box->result);
  }
  void drop() { shared_ = nullptr; }

 private:
  struct Box {
    std::optional<Result> result;
    std::exception_ptr error;
    std::atomic<bool> done{false};
    std::atomic<double> share{0.0};
  };
  static knit::Heard heard_by(std::weak_ptr<Box> waiting) {
    return [waiting = std::move(waiting)](double share) {
      const auto box = waiting.lock();
      if (!box) throw NobodyWaits{};
      box->share.store(share, std::memory_order_relaxed);
    };
  }
  std::shared_ptr<Box> shared_;
};

}  // namespace app
