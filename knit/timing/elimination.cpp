#include "knit/timing/elimination.h"

#include <algorithm>

namespace knit {

namespace {

constexpr std::uint32_t no_parent = UINT32_MAX;
// Heard after so many products, numbers gone through, or rows planned: some milliseconds.
constexpr std::uint32_t rows_between = 4096;
constexpr std::size_t products_between = std::size_t{1} << 22U, numbers_between = std::size_t{1} << 19U;

}  // namespace

Elimination::Elimination(const LowerHalf& matrix, const Heard& heard)
    : size_(static_cast<std::uint32_t>(matrix.size())) {
  turn(matrix);
  plan(heard);
  make_room(heard);
  factor(heard);
}

// A's rows, from its columns.
void Elimination::turn(const LowerHalf& matrix) {
  of_row_.assign(std::size_t{size_} + 1, 0);
  for (const int row : matrix.row) ++of_row_[static_cast<std::size_t>(row) + 1];
  for (std::uint32_t k = 0; k < size_; ++k) of_row_[k + 1] += of_row_[k];
  std::vector<std::size_t> next(of_row_.begin(), of_row_.end() - 1);
  across_.resize(matrix.row.size());
  given_.resize(matrix.row.size());
  for (std::uint32_t column = 0; column < size_; ++column) {
    for (auto at = static_cast<std::size_t>(matrix.first[column]);
         at < static_cast<std::size_t>(matrix.first[column + 1]); ++at) {
      const std::size_t to = next[static_cast<std::size_t>(matrix.row[at])]++;
      across_[to] = column;
      given_[to] = matrix.value[at];
    }
  }
}

// The tree, and how large the columns get.
void Elimination::plan(const Heard& heard) {
  parent_.assign(size_, no_parent);
  tag_.assign(size_, no_parent);
  column_.assign(std::size_t{size_} + 1, 0);
  for (std::uint32_t k = 0; k < size_; ++k) {
    if (k % rows_between == 0) hear(heard, 0.0);
    tag_[k] = k;
    for (std::size_t at = of_row_[k]; at < of_row_[k + 1]; ++at) {
      for (std::uint32_t i = across_[at]; tag_[i] != k; i = parent_[i]) {
        if (parent_[i] == no_parent) parent_[i] = k;
        ++column_[i + 1];
        tag_[i] = k;
      }
    }
  }
  for (std::uint32_t k = 0; k < size_; ++k) column_[k + 1] += column_[k];
}

// New memory is slow to come.
void Elimination::make_room(const Heard& heard) {
  row_.reserve(column_.back());
  value_.reserve(column_.back());
  while (value_.size() < column_.back()) {
    hear(heard, 0.0);
    row_.resize(std::min(column_.back(), value_.size() + numbers_between));
    value_.resize(row_.size());
  }
}

void Elimination::factor(const Heard& heard) {
  filled_.assign(column_.begin(), column_.end() - 1);
  pivot_.assign(size_, 0.0);
  number_.assign(size_, 0.0);
  path_.assign(size_, 0);
  tag_.assign(size_, no_parent);
  double all = 1.0, done = 0.0, said = 0.0;
  for (std::uint32_t k = 0; k < size_; ++k) {
    const auto entries = static_cast<double>(column_[k + 1] - column_[k]);
    all += 0.5 * entries * (entries + 1.0);
  }
  for (std::uint32_t k = 0; k < size_ && factored_; ++k) {
    const std::size_t first = gather_row(k);
    for (std::size_t at = first; at < size_; ++at)
      done += static_cast<double>(filled_[path_[at]] - column_[path_[at]] + 1);
    pivot_[k] = solve_row(k, first);
    factored_ = pivot_[k] != 0.0;
    if (done - said < static_cast<double>(products_between)) continue;
    hear(heard, done / all);
    said = done;
  }
}

// A's row: its numbers, and whom it leads to; from where in path_ these stand.
std::size_t Elimination::gather_row(std::uint32_t k) {
  std::size_t first = path_.size();
  tag_[k] = k;
  for (std::size_t at = of_row_[k]; at < of_row_[k + 1]; ++at) {
    std::uint32_t i = across_[at];
    number_[i] += given_[at];
    std::size_t length = 0;
    for (; tag_[i] != k; i = parent_[i]) {
      path_[length++] = i;  // there is room below `first`: all of them are different
      tag_[i] = k;
    }
    while (length > 0) path_[--first] = path_[--length];
  }
  return first;
}

// L's row, written into the columns. Its pivot.
double Elimination::solve_row(std::uint32_t k, std::size_t first) {
  double pivot = number_[k];
  number_[k] = 0.0;
  double* const numbers = number_.data();
  const double* const values = value_.data();
  const std::uint32_t* const rows = row_.data();
  for (std::size_t at = first; at < path_.size(); ++at) {
    const std::uint32_t i = path_[at];
    const double number = numbers[i];
    numbers[i] = 0.0;
    const std::size_t end = filled_[i]++;
    for (std::size_t p = column_[i]; p < end; ++p) numbers[rows[p]] -= values[p] * number;
    const double value = number / pivot_[i];
    pivot -= value * number;
    row_[end] = k;
    value_[end] = value;
  }
  return pivot;
}

template <class Number>
void Elimination::solve_for(std::span<Number> x, const Heard& heard) const {
  std::size_t said = 0;
  for (std::uint32_t k = 0; k < size_; ++k) {
    const Number number = x[k];
    for (std::size_t p = column_[k]; p < column_[k + 1]; ++p) x[row_[p]] -= number * value_[p];
    if (column_[k + 1] - said < numbers_between) continue;
    said = column_[k + 1];
    hear(heard, 0.5 * static_cast<double>(said) / static_cast<double>(column_.back()));
  }
  for (std::uint32_t k = 0; k < size_; ++k) x[k] *= 1.0 / pivot_[k];
  said = column_.back();
  for (std::uint32_t k = size_; k-- > 0;) {
    Number number = x[k];
    for (std::size_t p = column_[k]; p < column_[k + 1]; ++p) number -= value_[p] * x[row_[p]];
    x[k] = number;
    if (said - column_[k] < numbers_between) continue;
    said = column_[k];
    hear(heard, 1.0 - 0.5 * static_cast<double>(said) / static_cast<double>(column_.back()));
  }
}

void Elimination::solve(std::span<double> x, const Heard& heard) const { solve_for(x, heard); }
void Elimination::solve(std::span<glm::dvec3> x, const Heard& heard) const { solve_for(x, heard); }

}  // namespace knit
