// A value kept apart from the whole that it belongs to, so that who only hands the whole on need not know what
// the part is made of. Copied and compared as the value itself; it may be missing.
#pragma once

#include <memory>
#include <utility>

namespace app {

template <class Value>
class Part {
 public:
  Part() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a part is its value
  Part(Value value) : value_(std::make_unique<Value>(std::move(value))) {}
  Part(const Part& other) : value_(other.value_ ? std::make_unique<Value>(*other.value_) : nullptr) {}
  Part(Part&& other) noexcept = default;
  Part& operator=(const Part& other) {
    if (this != &other) *this = Part(other);
    return *this;
  }
  Part& operator=(Part&& other) noexcept = default;
  ~Part() = default;

  explicit operator bool() const { return value_ != nullptr; }
  [[nodiscard]] bool has_value() const { return value_ != nullptr; }
  void reset() { value_.reset(); }

  // Require that it is there.
  Value& operator*() { return *value_; }
  const Value& operator*() const { return *value_; }
  Value* operator->() { return value_.get(); }
  const Value* operator->() const { return value_.get(); }

  friend bool operator==(const Part& a, const Part& b) {
    return a.value_ && b.value_ ? *a.value_ == *b.value_ : !a.value_ && !b.value_;
  }

 private:
  std::unique_ptr<Value> value_;
};

}  // namespace app
