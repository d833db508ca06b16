#include "knit/settle/blocks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "knit/model/bug.h"
#include "knit/timing/dissection.h"

namespace knit {

namespace {

using Rows = std::vector<std::vector<std::uint32_t>>;
using Pairs = std::span<const std::array<std::uint32_t, 2>>;

constexpr std::uint32_t none = UINT32_MAX;
// Panels are joined where that leaves at least so much of them filled, or where they are no wider than this.
constexpr double least_filled = 0.8;
constexpr std::size_t narrow = 4;

// --- the pattern
// --------------------------------------------------------------------------------------------------------

std::vector<std::uint32_t> places_of(Pairs coupled, std::span<const glm::dvec3> positions) {
  Spokes spokes;
  spokes.first.assign(positions.size() + 1, 0);
  for (const auto& [a, b] : coupled) {
    ++spokes.first[a + 1];
    ++spokes.first[b + 1];
  }
  for (std::size_t i = 0; i < positions.size(); ++i) spokes.first[i + 1] += spokes.first[i];
  std::vector<std::uint32_t> next(spokes.first.begin(), spokes.first.end() - 1);
  spokes.spokes.resize(2 * coupled.size());
  for (const auto& [a, b] : coupled) {
    spokes.spokes[next[a]++] = {b, 0.0};
    spokes.spokes[next[b]++] = {a, 0.0};
  }
  std::vector<std::uint32_t> place(positions.size(), none);
  std::uint32_t count = 0;
  for (const VertexId stitch : order_by_dissection(spokes, positions)) place[stitch] = count++;
  for (std::uint32_t& at : place) {
    if (at == none) at = count++;  // coupled with nothing
  }
  return place;
}

// Below the diagonal, by column.
Rows columns_of(const std::vector<std::uint32_t>& place, Pairs coupled) {
  Rows columns(place.size());
  for (const auto& [a, b] : coupled)
    columns[std::min(place[a], place[b])].push_back(std::max(place[a], place[b]));
  for (auto& column : columns) std::sort(column.begin(), column.end());
  return columns;
}

// The rows of L: elimination passes a column's rows on to the first of them.
Rows filled(Rows columns) {
  std::vector<std::uint32_t> both;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j].size() < 2) continue;
    std::vector<std::uint32_t>& parent = columns[columns[j].front()];
    both.clear();
    std::set_union(columns[j].begin() + 1, columns[j].end(), parent.begin(), parent.end(),
                   std::back_inserter(both));
    parent.assign(both.begin(), both.end());
  }
  return columns;
}

// Whether column `next` may join the panel of `width` columns before it, of which the last has its rows.
bool joins(const Rows& l, std::uint32_t next, std::size_t width, std::size_t filled_blocks) {
  const std::vector<std::uint32_t>& last = l[next - 1];
  if (last.empty() || last.front() != next) return false;
  const std::size_t all = (width + 1) * (width + 2) / 2 + (width + 1) * l[next].size();
  return width < narrow ||
         static_cast<double>(filled_blocks + l[next].size() + 1) >= least_filled * static_cast<double>(all);
}

void add_panels(const Rows& l, BlockPattern& pattern) {
  pattern.panel_first.push_back(0);
  for (std::uint32_t begin = 0; begin < l.size();) {
    std::uint32_t end = begin + 1;
    std::size_t blocks = l[begin].size() + 1;
    for (; end < l.size() && joins(l, end, end - begin, blocks); ++end) blocks += l[end].size() + 1;
    pattern.panel.push_back(begin);
    pattern.panel_row.insert(pattern.panel_row.end(), l[end - 1].begin(), l[end - 1].end());
    pattern.panel_first.push_back(static_cast<std::uint32_t>(pattern.panel_row.size()));
    begin = end;
  }
  pattern.panel.push_back(static_cast<std::uint32_t>(l.size()));
}

// --- dense pieces
// -------------------------------------------------------------------------------------------------------

// Two numbers of a column, in one register where the machine has such.
using Two __attribute__((vector_size(16))) = double;

Two load_two(const double* from) {
  Two two;
  std::memcpy(&two, from, sizeof(two));
  return two;
}
void store_two(double* to, Two two) { std::memcpy(to, &two, sizeof(two)); }

constexpr std::size_t up_to_four(std::size_t count) { return (count + 3) / 4 * 4; }

// Columns of four.
using Square = std::array<std::array<Two, 2>, 4>;

// sum over k < depth of a(i, k) b(j, k), for four i and four j; a and b are columns `stride` apart.
Square products(const double* a, const double* b, std::size_t stride, std::size_t depth) {
  Two c00{}, c01{}, c02{}, c03{}, c10{}, c11{}, c12{}, c13{};
  for (std::size_t k = 0; k < depth; ++k, a += stride, b += stride) {
    const Two high = load_two(a), low = load_two(a + 2);
    c00 += high * b[0];
    c10 += low * b[0];
    c01 += high * b[1];
    c11 += low * b[1];
    c02 += high * b[2];
    c12 += low * b[2];
    c03 += high * b[3];
    c13 += low * b[3];
  }
  return {{{c00, c10}, {c01, c11}, {c02, c12}, {c03, c13}}};
}

}  // namespace

std::uint32_t BlockPattern::slot(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t column = std::min(place[a], place[b]), wanted = std::max(place[a], place[b]);
  for (std::uint32_t at = first[column]; at < first[column + 1]; ++at) {
    if (row[at] == wanted) return at;
  }
  throw Bug("two stitches are coupled that share no face");
}

BlockPattern make_block_pattern(Pairs coupled, std::span<const glm::dvec3> positions) {
  BlockPattern pattern;
  pattern.place = places_of(coupled, positions);
  const Rows columns = columns_of(pattern.place, coupled);
  pattern.first.push_back(0);
  for (const auto& column : columns) {
    pattern.row.insert(pattern.row.end(), column.begin(), column.end());
    pattern.first.push_back(static_cast<std::uint32_t>(pattern.row.size()));
  }
  add_panels(filled(columns), pattern);
  return pattern;
}

BlockSolver::BlockSolver(const BlockPattern& pattern)
    : pattern_(&pattern), panel_of_(pattern.size()), local_(pattern.size()), solved_(2 * pattern.size()) {
  std::size_t numbers = 0;
  for (std::uint32_t s = 0; s + 1 < pattern.panel.size(); ++s) {
    const std::size_t columns = pattern.panel[s + 1] - pattern.panel[s];
    const std::size_t stride = up_to_four(2 * (columns + rows_below(s).size()));
    panels_.push_back({numbers, stride, 2 * columns});
    numbers += stride * 2 * columns;
    for (std::uint32_t column = pattern.panel[s]; column < pattern.panel[s + 1]; ++column)
      panel_of_[column] = s;
  }
  numbers_.resize(numbers + 4);  // four may be read behind the last
  head_.resize(panels_.size());
  next_.resize(panels_.size());
  done_.resize(panels_.size());
}

std::span<const std::uint32_t> BlockSolver::rows_below(std::uint32_t panel) const {
  const BlockPattern& p = *pattern_;
  return std::span(p.panel_row)
      .subspan(p.panel_first[panel], p.panel_first[panel + 1] - p.panel_first[panel]);
}

void BlockSolver::load(const BlockSystem& system, double shift, std::uint32_t panel) {
  const BlockPattern& p = *pattern_;
  const Panel& at = panels_[panel];
  const std::uint32_t begin = p.panel[panel], end = p.panel[panel + 1];
  for (std::uint32_t column = begin; column < end; ++column) local_[column] = column - begin;
  std::uint32_t local = end - begin;
  for (const std::uint32_t row : rows_below(panel)) local_[row] = local++;
  std::fill_n(numbers_.begin() + static_cast<std::ptrdiff_t>(at.begin), at.stride * at.columns, 0.0);
  const auto put = [&](std::uint32_t row, std::uint32_t column, const Block& block) {
    double* to = &numbers_[at.begin + 2 * (column - begin) * at.stride + 2 * local_[row]];
    to[0] = block[0];
    to[1] = block[2];
    to[at.stride] = block[1];
    to[at.stride + 1] = block[3];
  };
  for (std::uint32_t column = begin; column < end; ++column) {
    const Block& d = system.diagonal[column];
    put(column, column, {d[0] + shift, d[1], d[2], d[3] + shift});
    for (std::uint32_t slot = p.first[column]; slot < p.first[column + 1]; ++slot)
      put(p.row[slot], column, system.below[slot]);
  }
}

void BlockSolver::hang_on(std::uint32_t before, std::uint32_t row) {
  done_[before] = row;
  if (row == pattern_->panel_first[before + 1]) return;
  const std::uint32_t panel = panel_of_[pattern_->panel_row[row]];
  next_[before] = head_[panel];
  head_[panel] = before;
}

// What the panel `before` takes from this one.
void BlockSolver::take_from(std::uint32_t before, std::uint32_t panel) {
  const BlockPattern& p = *pattern_;
  const Panel &from = panels_[before], &to = panels_[panel];
  const std::uint32_t begin = done_[before], end = p.panel_first[before + 1];
  std::uint32_t own = begin;  // the end of the rows that are columns of this panel
  while (own < end && p.panel_row[own] < p.panel[panel + 1]) ++own;
  const std::size_t rows = 2 * (end - begin), columns = 2 * (own - begin);
  const double* a = &numbers_[from.begin + from.columns + 2 * (begin - p.panel_first[before])];
  const std::size_t stride = up_to_four(rows);
  product_.resize(stride * up_to_four(columns));
  for (std::size_t j = 0; j < columns; j += 4) {
    for (std::size_t i = j; i < rows; i += 4) {
      const Square c = products(a + i, a + j, from.stride, from.columns);
      for (std::size_t k = 0; k < 4; ++k) {
        store_two(&product_[(j + k) * stride + i], c[k][0]);
        store_two(&product_[(j + k) * stride + i + 2], c[k][1]);
      }
    }
  }
  for (std::uint32_t column = begin; column < own; ++column) {
    const double* c = &product_[2 * (column - begin) * stride];
    double* at = &numbers_[to.begin + 2 * local_[p.panel_row[column]] * to.stride];
    for (std::uint32_t row = column; row < end; ++row) {
      double* x = at + 2 * local_[p.panel_row[row]];
      const double* y = c + 2 * (row - begin);
      x[0] -= y[0];
      x[1] -= y[1];
      x[to.stride] -= y[stride];
      x[to.stride + 1] -= y[stride + 1];
    }
  }
  hang_on(before, own);
}

// Four columns at a time: first what the columns before take, then the four among themselves.
bool BlockSolver::factor_panel(const Panel& panel) {
  double* const x = &numbers_[panel.begin];
  const std::size_t stride = panel.stride;
  for (std::size_t j = 0; j < panel.columns; j += 4) {
    const std::size_t width = std::min<std::size_t>(4, panel.columns - j);
    for (std::size_t i = j; i < stride && j > 0; i += 4) {
      const Square c = products(x + i, x + j, stride, j);
      for (std::size_t k = 0; k < width; ++k) {
        double* const to = x + (j + k) * stride + i;
        store_two(to, load_two(to) - c[k][0]);
        store_two(to + 2, load_two(to + 2) - c[k][1]);
      }
    }
    for (std::size_t k = 0; k < width; ++k) {
      double* const column = x + (j + k) * stride;
      const double pivot = column[j + k];
      if (!(pivot > 0.0)) return false;
      const double root = std::sqrt(pivot);
      for (std::size_t i = j; i < stride; i += 2) store_two(column + i, load_two(column + i) / root);
      for (std::size_t m = k + 1; m < width; ++m) {
        double* const later = x + (j + m) * stride;
        const double factor = column[j + m];
        for (std::size_t i = j; i < stride; i += 2)
          store_two(later + i, load_two(later + i) - factor * load_two(column + i));
      }
    }
  }
  return true;
}

bool BlockSolver::factor(const BlockSystem& system, double shift) {
  std::fill(head_.begin(), head_.end(), none);
  for (std::uint32_t panel = 0; panel < panels_.size(); ++panel) {
    load(system, shift, panel);
    for (std::uint32_t before = head_[panel]; before != none;) {
      const std::uint32_t next = next_[before];
      take_from(before, panel);
      before = next;
    }
    if (!factor_panel(panels_[panel])) return false;
    hang_on(panel, pattern_->panel_first[panel]);
  }
  return true;
}

void BlockSolver::substitute(std::span<const std::uint32_t> rows_below, const Panel& panel,
                             std::uint32_t first_column) {
  double* const own = &solved_[2 * std::size_t{first_column}];
  for (std::size_t k = 0; k < panel.columns; ++k) {
    const double* const column = &numbers_[panel.begin + k * panel.stride];
    own[k] /= column[k];
    for (std::size_t i = k + 1; i < panel.columns; ++i) own[i] -= column[i] * own[k];
    const double* below = column + panel.columns;
    for (const std::uint32_t row : rows_below) {
      solved_[2 * std::size_t{row}] -= *below++ * own[k];
      solved_[2 * std::size_t{row} + 1] -= *below++ * own[k];
    }
  }
}

void BlockSolver::substitute_back(std::span<const std::uint32_t> rows_below, const Panel& panel,
                                  std::uint32_t first_column) {
  double* const own = &solved_[2 * std::size_t{first_column}];
  for (std::size_t k = panel.columns; k-- > 0;) {
    const double* const column = &numbers_[panel.begin + k * panel.stride];
    double sum = own[k];
    for (std::size_t i = k + 1; i < panel.columns; ++i) sum -= column[i] * own[i];
    const double* below = column + panel.columns;
    for (const std::uint32_t row : rows_below) {
      sum -= *below++ * solved_[2 * std::size_t{row}];
      sum -= *below++ * solved_[2 * std::size_t{row} + 1];
    }
    own[k] = sum / column[k];
  }
}

bool BlockSolver::solve(const BlockSystem& system, double shift, std::vector<glm::dvec2>& solution) {
  if (!factor(system, shift)) return false;
  const BlockPattern& p = *pattern_;
  for (std::size_t i = 0; i < p.size(); ++i) {
    solved_[2 * i] = system.right[i].x;
    solved_[2 * i + 1] = system.right[i].y;
  }
  for (std::uint32_t panel = 0; panel < panels_.size(); ++panel)
    substitute(rows_below(panel), panels_[panel], p.panel[panel]);
  for (auto panel = static_cast<std::uint32_t>(panels_.size()); panel-- > 0;)
    substitute_back(rows_below(panel), panels_[panel], p.panel[panel]);
  solution.clear();
  for (const std::uint32_t at : p.place)
    solution.emplace_back(solved_[2 * std::size_t{at}], solved_[2 * std::size_t{at} + 1]);
  return true;
}

}  // namespace knit
