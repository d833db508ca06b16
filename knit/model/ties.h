// Ties are broken by rule, not by last bits.
//
// On a symmetric shape two places are often equally near, and which of two sums comes out smaller is then a matter of
// rounding: a mesh moved by a ten-billionth of a hair would be knitted another way. So lengths that differ by less than
// a billionth of what is measured count as equal, and among equals a rule decides that every caller states (the lower
// number, the stitch that comes first). Positions that differ by rounding alone (some 1e-15 of the mesh's size) then
// give the same stitches; positions_test.cpp moves meshes by 1e-13.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace knit {

// Of `scale`: a length, a square or a sum of them, as what is compared.
inline constexpr double tie = 1e-9;

// Whether a is less than b by more than rounding may have done.
inline bool clearly_less(double a, double b, double scale) { return b - a > tie * scale; }

// To the nearest whole number; a half goes up, and so does what rounding alone keeps from being one.
inline double rounded(double x) { return std::round(x + tie); }

// Sorts by what `key` gives, rising; runs of equals stay in the order in which they came.
template <class Item, class Key>
void sort_by_rule(std::vector<Item>& items, Key key, double scale) {
  struct Ranked {
    double key;
    std::size_t number;
  };
  std::vector<Ranked> ranked;
  ranked.reserve(items.size());
  for (const Item& item : items) ranked.push_back({key(item), ranked.size()});
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return a.key != b.key ? a.key < b.key : a.number < b.number;
  });
  const auto by_number = [](const Ranked& a, const Ranked& b) { return a.number < b.number; };
  for (auto first = ranked.begin(), next = first; next != ranked.end(); first = next) {
    ++next;
    while (next != ranked.end() && !clearly_less((next - 1)->key, next->key, scale)) ++next;
    std::sort(first, next, by_number);
  }
  std::vector<Item> sorted;
  sorted.reserve(items.size());
  for (const Ranked& rank : ranked) sorted.push_back(std::move(items[rank.number]));
  items = std::move(sorted);
}

}  // namespace knit
