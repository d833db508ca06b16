// A finished product: immutable, shared, compared and hashed by content.
//
// Copying a Shared costs one pointer. The hash is taken once, when somebody first asks for it, so that hashing a
// state does not grow with what is finished, and a run that nobody hashes does without. Nobody can change the past.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "knit/hash.h"

namespace knit {

template <class T>
class Shared {
 public:
  Shared() = default;
  explicit Shared(T value) : boxed_(std::make_shared<const Boxed>(std::move(value))) {}

  explicit operator bool() const { return boxed_ != nullptr; }
  const T& operator*() const { return boxed_->value; }
  const T* operator->() const { return &boxed_->value; }
  // Null when empty. Keeps the product alive; the pointer is its identity (a renderer's cache key).
  [[nodiscard]] std::shared_ptr<const T> pointer() const {
    return boxed_ ? std::shared_ptr<const T>(boxed_, &boxed_->value) : nullptr;
  }

  [[nodiscard]] std::uint64_t content_hash() const { return boxed_ ? boxed_->hash() : 0; }
  friend bool operator==(const Shared& a, const Shared& b) {
    if (a.boxed_ == b.boxed_) return true;
    return a.boxed_ && b.boxed_ && a.boxed_->value == b.boxed_->value;
  }

 private:
  class Boxed {
   public:
    explicit Boxed(T finished) : value(std::move(finished)) {}
    // Two threads may both take it: they find the same.
    [[nodiscard]] std::uint64_t hash() const {
      std::uint64_t hash = hash_.load(std::memory_order_relaxed);
      if (hash == not_taken) {
        hash = content_hash_of(value);
        hash_.store(hash, std::memory_order_relaxed);
      }
      return hash;
    }
    const T value;

   private:
    static constexpr std::uint64_t not_taken = 0;
    mutable std::atomic<std::uint64_t> hash_{not_taken};
  };
  std::shared_ptr<const Boxed> boxed_;
};

}  // namespace knit
