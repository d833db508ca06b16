// A finished product: immutable, shared, compared and hashed by content.
//
// Copying a Shared costs one pointer. The hash is taken once, when the product is finished, so that hashing a
// state does not grow with what is finished. Nobody can change the past.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "knit/model/hash.h"

namespace knit {

template <class T>
class Shared {
 public:
  Shared() = default;
  explicit Shared(T value) {
    const std::uint64_t hash = content_hash_of(value);
    boxed_ = std::make_shared<const Boxed>(Boxed{std::move(value), hash});
  }

  explicit operator bool() const { return boxed_ != nullptr; }
  const T& operator*() const { return boxed_->value; }
  const T* operator->() const { return &boxed_->value; }
  // Null when empty. Keeps the product alive; the pointer is its identity (a renderer's cache key).
  [[nodiscard]] std::shared_ptr<const T> pointer() const {
    return boxed_ ? std::shared_ptr<const T>(boxed_, &boxed_->value) : nullptr;
  }

  [[nodiscard]] std::uint64_t content_hash() const { return boxed_ ? boxed_->hash : 0; }
  friend bool operator==(const Shared& a, const Shared& b) {
    if (a.boxed_ == b.boxed_) return true;
    return a.boxed_ && b.boxed_ && a.boxed_->hash == b.boxed_->hash && a.boxed_->value == b.boxed_->value;
  }

 private:
  struct Boxed {
    T value;
    std::uint64_t hash;
  };
  std::shared_ptr<const Boxed> boxed_;
};

}  // namespace knit
