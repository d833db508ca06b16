// A sequence that only grows, in blocks: full blocks are shared between copies.
//
// Copying costs a pointer a block and the last, unfinished block; hashing costs a word a block and that
// block. It lets a keyframe in the middle of a long stage (times of a million vertices) stay small.
#pragma once

#include <cstddef>
#include <vector>

#include "knit/model/shared.h"

namespace knit {

template <class T>
class Growing {
 public:
  static constexpr std::size_t block_size = 512;

  void push_back(T value) {
    tail_.push_back(std::move(value));
    if (tail_.size() == block_size) {
      full_.emplace_back(Shared<std::vector<T>>(std::move(tail_)));
      tail_ = {};
      tail_.reserve(block_size);
    }
  }

  [[nodiscard]] std::size_t size() const { return full_.size() * block_size + tail_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  const T& operator[](std::size_t i) const {
    const std::size_t block = i / block_size;
    return block < full_.size() ? (*full_[block])[i % block_size] : tail_[i % block_size];
  }

  [[nodiscard]] std::vector<T> to_vector() const {
    std::vector<T> all;
    all.reserve(size());
    for (const auto& block : full_) all.insert(all.end(), block->begin(), block->end());
    all.insert(all.end(), tail_.begin(), tail_.end());
    return all;
  }

  // What a copy of this sequence costs, not counting what is shared.
  [[nodiscard]] std::size_t copy_bytes() const {
    return full_.size() * sizeof(Shared<std::vector<T>>) + tail_.size() * sizeof(T);
  }

  auto fields() const { return std::tie(full_, tail_); }
  friend bool operator==(const Growing&, const Growing&) = default;

 private:
  std::vector<Shared<std::vector<T>>> full_;
  std::vector<T> tail_;
};

}  // namespace knit
