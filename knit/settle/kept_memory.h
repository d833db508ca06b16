// Memory that is used again from step to step and is no part of the value that holds it: all are equal, and nothing that
// comes out depends on it. Copies share it, on whatever thread; who needs it while another has it makes its own.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace knit {

template <class T>
class KeptMemory {
 public:
  // Holds nothing, and will not keep what it is given.
  KeptMemory() = default;
  static KeptMemory made() {
    KeptMemory kept;
    kept.shelf_ = std::make_shared<Shelf>();
    return kept;
  }

  // What was given back last, or a new one.
  [[nodiscard]] std::unique_ptr<T> take() const {
    std::unique_ptr<T> memory;
    if (shelf_) {
      const std::lock_guard lock(shelf_->one_at_a_time);
      memory = std::move(shelf_->held);
    }
    if (!memory) memory = std::make_unique<T>();
    return memory;
  }
  void give_back(std::unique_ptr<T> memory) const {
    if (!shelf_) return;
    const std::lock_guard lock(shelf_->one_at_a_time);
    shelf_->held = std::move(memory);
  }
  friend bool operator==(const KeptMemory& /*a*/, const KeptMemory& /*b*/) { return true; }

 private:
  struct Shelf {
    std::mutex one_at_a_time;
    std::unique_ptr<T> held;
  };
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace knit
