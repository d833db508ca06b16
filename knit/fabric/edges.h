// Pairs of neighbours, in order; the last and the first only of what is closed.
#pragma once

#include <cstddef>

namespace knit {

class Edges {
 public:
  struct Edge {
    std::size_t from, to;
  };
  class Iterator {
   public:
    Iterator(std::size_t at, std::size_t count) : at_(at), count_(count) {}
    Edge operator*() const { return {at_, at_ + 1 < count_ ? at_ + 1 : 0}; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    std::size_t at_, count_;
  };

  Edges(std::size_t count, bool closed) : count_(count), edges_(closed || count == 0 ? count : count - 1) {}
  [[nodiscard]] Iterator begin() const { return {0, count_}; }
  [[nodiscard]] Iterator end() const { return {edges_, count_}; }
  [[nodiscard]] std::size_t size() const { return edges_; }

 private:
  std::size_t count_, edges_;
};

}  // namespace knit
