// Long work beside the window: a pure function of values, run on a thread of its own.
//
// Whoever starts work asks `ready` every frame. Dropping a Work lets it finish unheard: a solve inside a
// library cannot be broken off, but nobody waits for it and nothing of it is kept.
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace app {

template <class Result>
class Work {
 public:
  Work() = default;
  template <class Function>
  explicit Work(Function function) : shared_(std::make_shared<Box>()) {
    std::thread([box = shared_, function = std::move(function)]() mutable {
      try {
        box->result.emplace(function());
      } catch (...) {
        box->error = std::current_exception();
      }
      box->done.store(true, std::memory_order_release);
    }).detach();
  }

  [[nodiscard]] bool running() const { return shared_ != nullptr; }
  [[nodiscard]] bool ready() const { return shared_ && shared_->done.load(std::memory_order_acquire); }
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
  };
  std::shared_ptr<Box> shared_;
};

}  // namespace app
