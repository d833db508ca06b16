// A = L D L^T of a sparse symmetric positive definite matrix, row by row, so that it can be heard and broken off.
//
// Row k of L is x with L(above k) D x = A(k, before k). Only what a path of the elimination tree leads to, from where A's
// row has a number up to k, is not 0; the paths are gone along in the order of A's row, the last first. Cost: the squares
// of the columns' sizes. The same bits as Eigen's SimplicialLDLT, which cannot be broken off.
// T. Davis, "Algorithm 849: a concise sparse Cholesky factorization package", 2005.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "knit/model/heard.h"

namespace knit {

// The lower half of a symmetric matrix with its diagonal, column by column: where each begins, and the end; its rows,
// rising; its numbers.
struct LowerHalf {
  std::span<const int> first, row;
  std::span<const double> value;
  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
};

class Elimination {
 public:
  // In the order of the rows.
  explicit Elimination(const LowerHalf& matrix, const Heard& heard = {});
  // False: a pivot is 0, and nothing can be solved.
  [[nodiscard]] bool factored() const { return factored_; }
  // A x = what `x` is.
  void solve(std::span<double> x, const Heard& heard = {}) const;
  // Three such at once, in one walk through L.
  void solve(std::span<glm::dvec3> x, const Heard& heard = {}) const;
  // How many numbers L has below its diagonal.
  [[nodiscard]] std::size_t entries() const { return value_.size(); }

 private:
  void turn(const LowerHalf& matrix);
  void plan(const Heard& heard);
  void make_room(const Heard& heard);
  void factor(const Heard& heard);
  [[nodiscard]] std::size_t gather_row(std::uint32_t k);
  [[nodiscard]] double solve_row(std::uint32_t k, std::size_t first);
  template <class Number>
  void solve_for(std::span<Number> x, const Heard& heard) const;

  std::uint32_t size_ = 0;
  // A's rows: where each begins, and the end; its columns up to the diagonal, rising; its numbers.
  std::vector<std::size_t> of_row_;
  std::vector<std::uint32_t> across_;
  std::vector<double> given_;

  std::vector<std::uint32_t> parent_;  // in the elimination tree
  std::vector<std::size_t> column_;    // where L's columns begin, and the end
  std::vector<std::size_t> filled_;    // and where each has come to
  std::vector<std::uint32_t> row_;
  std::vector<double> value_;
  std::vector<double> pivot_;
  bool factored_ = true;
  // Of the row that is worked on: who is on it, who they are in order from some place to the end, and their numbers.
  std::vector<std::uint32_t> tag_, path_;
  std::vector<double> number_;
};

}  // namespace knit
