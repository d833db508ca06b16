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
constexpr std::size_t narrow = 3;

// --- the pattern
// --------------------------------------------------------------------------------------------------------

std::vector<std::uint32_t> places_of(Pairs coupled, std::span<const glm::dvec3> positions,
                                     const Heard& heard) {
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
  for (const VertexId stitch : order_by_dissection(spokes, positions, heard)) place[stitch] = count++;
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

// Two pieces of columns, `stride` apart, `depth` of them; and where their products go, in columns `out_stride` apart.
struct Pieces {
  const double* a = nullptr;
  const double* b = nullptr;
  std::size_t stride = 0, depth = 0;
  double* out = nullptr;
  std::size_t out_stride = 0;
};

// out(i, j) = sum over k < depth of a(i, k) b(j, k), for four i and four j, in the order of k; `take`: less the sum.
template <bool take>
void four_by_four(const Pieces& p) {
  Two c00{}, c01{}, c02{}, c03{}, c10{}, c11{}, c12{}, c13{};
  const double *a = p.a, *b = p.b;
  for (std::size_t k = 0; k < p.depth; ++k, a += p.stride, b += p.stride) {
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
  double* to = p.out;
  const auto put = [&](Two high, Two low) {
    store_two(to, take ? load_two(to) - high : high);
    store_two(to + 2, take ? load_two(to + 2) - low : low);
    to += p.out_stride;
  };
  put(c00, c10);
  put(c01, c11);
  put(c02, c12);
  put(c03, c13);
}

template <bool take>
void eight_by_four(Pieces p) {
  four_by_four<take>(p);
  p.a += 4;
  p.out += 4;
  four_by_four<take>(p);
}

#if defined(__x86_64__)
// The same sums in the same order, four numbers at once: the bits are the same.
using Four __attribute__((vector_size(32))) = double;

template <bool take>
__attribute__((target("avx"))) void eight_by_four_wide(Pieces p) {
  Four c00{}, c01{}, c02{}, c03{}, c10{}, c11{}, c12{}, c13{};
  for (std::size_t k = 0; k < p.depth; ++k, p.a += p.stride, p.b += p.stride) {
    Four high, low;
    std::memcpy(&high, p.a, sizeof(high));
    std::memcpy(&low, p.a + 4, sizeof(low));
    c00 += high * p.b[0];
    c10 += low * p.b[0];
    c01 += high * p.b[1];
    c11 += low * p.b[1];
    c02 += high * p.b[2];
    c12 += low * p.b[2];
    c03 += high * p.b[3];
    c13 += low * p.b[3];
  }
  for (std::size_t j = 0; j < 4; ++j, p.out += p.out_stride) {
    Four high = j == 0 ? c00 : j == 1 ? c01 : j == 2 ? c02 : c03;
    Four low = j == 0 ? c10 : j == 1 ? c11 : j == 2 ? c12 : c13;
    if (take) {
      Four now;
      std::memcpy(&now, p.out, sizeof(now));
      high = now - high;
      std::memcpy(&now, p.out + 4, sizeof(now));
      low = now - low;
    }
    std::memcpy(p.out, &high, sizeof(high));
    std::memcpy(p.out + 4, &low, sizeof(low));
  }
}
bool machine_is_wide() { return __builtin_cpu_supports("avx") != 0; }
#else
template <bool take>
void eight_by_four_wide(const Pieces& p) {
  eight_by_four<take>(p);
}
bool machine_is_wide() { return false; }
#endif

// The products of `rows` of a with four of b, rows a multiple of four.
template <bool take>
void products(Pieces p, std::size_t rows, bool wide) {
  for (; rows >= 8; rows -= 8, p.a += 8, p.out += 8)
    wide ? eight_by_four_wide<take>(p) : eight_by_four<take>(p);
  if (rows > 0) four_by_four<take>(p);
}

// `width` columns among themselves, from the diagonal on, `rows` long: first the square on the diagonal, then all rows in
// one pass. False where a pivot is not positive.
template <std::size_t width>
bool factor_columns(double* x, std::size_t stride, std::size_t rows) {
  std::array<std::array<double, width>, width> l{};  // below the diagonal
  std::array<double, width> inverse{};               // of the diagonal
  for (std::size_t m = 0; m < width; ++m) {
    double pivot = x[m * stride + m];
    for (std::size_t k = 0; k < m; ++k) {
      double sum = x[k * stride + m];
      for (std::size_t i = 0; i < k; ++i) sum -= l[m][i] * l[k][i];
      l[m][k] = sum * inverse[k];
      pivot -= l[m][k] * l[m][k];
    }
    if (!(pivot > 0.0)) return false;
    inverse[m] = 1.0 / std::sqrt(pivot);
  }
  for (std::size_t i = 0; i < rows; i += 2) {
    std::array<Two, width> row{};
    for (std::size_t m = 0; m < width; ++m) {
      row[m] = load_two(x + m * stride + i);
      for (std::size_t k = 0; k < m; ++k) row[m] -= row[k] * l[m][k];
      row[m] *= inverse[m];
      store_two(x + m * stride + i, row[m]);
    }
  }
  return true;
}

}  // namespace

std::uint32_t BlockPattern::slot(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t column = std::min(place[a], place[b]), wanted = std::max(place[a], place[b]);
  for (std::uint32_t at = first[column]; at < first[column + 1]; ++at) {
    if (row[at] == wanted) return at;
  }
  throw Bug("two stitches are coupled that share no face");
}

BlockPattern make_block_pattern(Pairs coupled, std::span<const glm::dvec3> positions, const Heard& heard) {
  BlockPattern pattern;
  pattern.place = places_of(coupled, positions, part_of(heard, 0.0, 0.6));
  hear(heard, 0.6);
  const Rows columns = columns_of(pattern.place, coupled);
  hear(heard, 0.7);
  pattern.first.push_back(0);
  for (const auto& column : columns) {
    pattern.row.insert(pattern.row.end(), column.begin(), column.end());
    pattern.first.push_back(static_cast<std::uint32_t>(pattern.row.size()));
  }
  add_panels(filled(columns), pattern);
  return pattern;
}

void BlockSolver::refer_to(const BlockPattern& pattern, const Heard& heard) {
  pattern_ = &pattern;
  wide_ = machine_is_wide();
  panels_.clear();
  done_by_.clear();
  panel_of_.resize(pattern.size());
  local_.resize(pattern.size());
  solved_.resize(2 * pattern.size());
  std::size_t numbers = 0, room = 0;
  double products = 0.0;
  for (std::uint32_t s = 0; s + 1 < pattern.panel.size(); ++s) {
    const std::size_t columns = pattern.panel[s + 1] - pattern.panel[s];
    const std::size_t stride = up_to_four(2 * (columns + rows_below(s).size()));
    panels_.push_back({numbers, stride, 2 * columns});
    done_by_.push_back(products);
    numbers += stride * 2 * columns;
    // Behind a panel four numbers may be read, and two columns written that mean nothing; panels after it are loaded later.
    room = std::max(room, numbers + 2 * stride + 4);
    products += static_cast<double>(stride) * static_cast<double>(stride) * static_cast<double>(columns);
    for (std::uint32_t column = pattern.panel[s]; column < pattern.panel[s + 1]; ++column)
      panel_of_[column] = s;
  }
  for (double& done : done_by_) done /= products;
  numbers_.clear();
  numbers_.reserve(room);
  while (numbers_.size() < room) {  // new memory is slow to come
    if (heard) heard(0.0);
    numbers_.resize(std::min(room, numbers_.size() + (std::size_t{1} << 20U)));
  }
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
  make_room(stride * up_to_four(columns));
  for (std::size_t j = 0; j < columns; j += 4) {
    products<false>({a + j, a + j, from.stride, from.columns, &product_[j * stride + j], stride}, stride - j,
                    wide_);
  }
  for (std::uint32_t column = begin; column < own; ++column) {
    const double* c = &product_[2 * (column - begin) * stride];
    double* at = &numbers_[to.begin + 2 * local_[p.panel_row[column]] * to.stride];
    for (std::uint32_t row = column; row < end; ++row) {
      double* x = at + 2 * local_[p.panel_row[row]];
      const double* y = c + 2 * (row - begin);
      store_two(x, load_two(x) - load_two(y));
      store_two(x + to.stride, load_two(x + to.stride) - load_two(y + stride));
    }
  }
  hang_on(before, own);
}

void BlockSolver::make_room(std::size_t numbers) {
  if (product_.size() < numbers) product_.resize(numbers);
}

// Four columns at a time: first what the columns before take, then the four among themselves.
bool BlockSolver::factor_panel(const Panel& panel) {
  double* const x = &numbers_[panel.begin];
  const std::size_t stride = panel.stride;
  for (std::size_t j = 0; j < panel.columns; j += 4) {
    if (j > 0) products<true>({x + j, x + j, stride, j, x + j * stride + j, stride}, stride - j, wide_);
    double* const own = x + j * stride + j;
    const bool positive = panel.columns - j >= 4 ? factor_columns<4>(own, stride, stride - j)
                                                 : factor_columns<2>(own, stride, stride - j);
    if (!positive) return false;
  }
  return true;
}

bool BlockSolver::factor(const BlockSystem& system, double shift, const Heard& heard) {
  std::fill(head_.begin(), head_.end(), none);
  for (std::uint32_t panel = 0; panel < panels_.size(); ++panel) {
    if (heard) heard(done_by_[panel]);
    load(system, shift, panel);
    for (std::uint32_t before = head_[panel]; before != none;) {
      const std::uint32_t next = next_[before];
      take_from(before, panel);
      before = next;
    }
    if (!factor_panel(panels_[panel])) return false;
    substitute(rows_below(panel), panels_[panel], pattern_->panel[panel]);  // while its numbers are at hand
    hang_on(panel, pattern_->panel_first[panel]);
  }
  return true;
}

// Two columns at once: a panel has an even number of them, and a stitch's two numbers lie side by side.
void BlockSolver::substitute(std::span<const std::uint32_t> rows_below, const Panel& panel,
                             std::uint32_t first_column) {
  double* const own = &solved_[2 * std::size_t{first_column}];
  for (std::size_t k = 0; k < panel.columns; k += 2) {
    const double* const one = &numbers_[panel.begin + k * panel.stride];
    const double* const two = one + panel.stride;
    own[k] /= one[k];
    own[k + 1] = (own[k + 1] - one[k + 1] * own[k]) / two[k + 1];
    const double x = own[k], y = own[k + 1];
    const auto take = [&](double* from, std::size_t at) {
      store_two(from, load_two(from) - load_two(one + at) * x - load_two(two + at) * y);
    };
    for (std::size_t i = k + 2; i < panel.columns; i += 2) take(own + i, i);
    std::size_t at = panel.columns;
    for (const std::uint32_t row : rows_below) {
      take(&solved_[2 * std::size_t{row}], at);
      at += 2;
    }
  }
}

void BlockSolver::substitute_back(std::span<const std::uint32_t> rows_below, const Panel& panel,
                                  std::uint32_t first_column) {
  double* const own = &solved_[2 * std::size_t{first_column}];
  for (std::size_t k = panel.columns; k > 0;) {
    k -= 2;
    const double* const one = &numbers_[panel.begin + k * panel.stride];
    const double* const two = one + panel.stride;
    Two x{}, y{};
    const auto add = [&](const double* solved, std::size_t at) {
      x += load_two(one + at) * load_two(solved);
      y += load_two(two + at) * load_two(solved);
    };
    for (std::size_t i = k + 2; i < panel.columns; i += 2) add(own + i, i);
    std::size_t at = panel.columns;
    for (const std::uint32_t row : rows_below) {
      add(&solved_[2 * std::size_t{row}], at);
      at += 2;
    }
    own[k + 1] = (own[k + 1] - (y[0] + y[1])) / two[k + 1];
    own[k] = (own[k] - (x[0] + x[1]) - one[k + 1] * own[k + 1]) / one[k];
  }
}

bool BlockSolver::solve(const BlockSystem& system, double shift, std::vector<glm::dvec2>& solution,
                        const Heard& heard) {
  const BlockPattern& p = *pattern_;
  for (std::size_t i = 0; i < p.size(); ++i) {
    solved_[2 * i] = system.right[i].x;
    solved_[2 * i + 1] = system.right[i].y;
  }
  if (!factor(system, shift, heard)) return false;
  for (auto panel = static_cast<std::uint32_t>(panels_.size()); panel-- > 0;)
    substitute_back(rows_below(panel), panels_[panel], p.panel[panel]);
  solution.clear();
  for (const std::uint32_t at : p.place)
    solution.emplace_back(solved_[2 * std::size_t{at}], solved_[2 * std::size_t{at} + 1]);
  return true;
}

}  // namespace knit
