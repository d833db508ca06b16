#include "knit/mesh/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace knit {

namespace {

// high + low, not added up: about 106 bits.
struct Pair {
  double high = 0.0, low = 0.0;
  [[nodiscard]] constexpr double sum() const { return high + low; }
};

// Requires |a| >= |b|, or a = 0.
constexpr Pair quick_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

constexpr Pair exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

constexpr Pair exact_product(double a, double b) {
  constexpr auto halves = [](double x) {
    const double shifted = 134217729.0 * x;  // 2^27 + 1
    const double high = shifted - (shifted - x);
    return Pair{high, x - high};
  };
  const Pair x = halves(a);
  const Pair y = halves(b);
  const double product = a * b;
  return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

constexpr Pair operator-(const Pair& a) { return {-a.high, -a.low}; }

constexpr Pair operator+(const Pair& a, const Pair& b) {
  const Pair high = exact_sum(a.high, b.high);
  const Pair low = exact_sum(a.low, b.low);
  const Pair sum = quick_sum(high.high, high.low + low.high);
  return quick_sum(sum.high, sum.low + low.low);
}

constexpr Pair operator*(const Pair& a, const Pair& b) {
  const Pair product = exact_product(a.high, b.high);
  return quick_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr Pair operator/(const Pair& a, const Pair& b) {
  const double first = a.high / b.high;
  const Pair rest = a + -(b * Pair{first});
  const double second = rest.high / b.high;
  const Pair rest_again = rest + -(b * Pair{second});
  return quick_sum(first, second) + Pair{rest_again.high / b.high};
}

// 161 bits of a quarter turn.
constexpr std::array quarter{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110};

// Less the nearest number of quarter turns, which is written to `quarters`; in [-pi/4, pi/4].
Pair reduced(double angle, int& quarters) {
  quarters = static_cast<int>(std::lround(angle / quarter[0]));
  Pair rest{angle};
  for (const double part : quarter) rest = rest + -exact_product(quarters, part);
  return rest;
}

// 1 / n!
constexpr std::array<Pair, 29> shares = [] {
  std::array<Pair, 29> table{};
  table[0] = {1.0};
  for (std::size_t n = 1; n < table.size(); ++n) table[n] = table[n - 1] / Pair{static_cast<double>(n)};
  return table;
}();

// The sum of square^n / (2 n + odd)!, for |square| <= 1.
Pair every_second_share(const Pair& square, std::size_t odd) {
  Pair sum;
  for (std::size_t n = 14; n-- > 0;) sum = sum * square + shares[2 * n + odd];
  return sum;
}

double sine_after(double angle, int more_quarters) {
  int quarters = 0;
  const Pair x = reduced(angle, quarters);
  quarters += more_quarters;
  const Pair square = -(x * x);
  const Pair value = quarters % 2 == 0 ? x * every_second_share(square, 1) : every_second_share(square, 0);
  return (quarters & 2) == 0 ? value.sum() : -value.sum();
}

// Of a share up to 1/16: x - x^3/3 + x^5/5 ...
constexpr Pair arc_tangent_series(const Pair& x) {
  const Pair square = -(x * x);
  Pair power = x;
  Pair sum = x;
  for (int n = 3; n < 31; n += 2) {
    power = power * square;
    sum = sum + power / Pair{static_cast<double>(n)};
  }
  return sum;
}

constexpr int steps = 16;
using ArcTangents = std::array<Pair, steps + 1>;  // of 0, 1/16, 2/16 ... 1

// Each from the one before; `from` plus or minus that.
constexpr ArcTangents arc_tangents(const Pair& from, bool minus) {
  ArcTangents table{};
  Pair angle;
  for (int i = 0; i <= steps; ++i) {
    if (i > 0) angle = angle + arc_tangent_series(Pair{steps} / Pair{steps * steps + i * (i - 1.0)});
    table[static_cast<std::size_t>(i)] = from + (minus ? -angle : angle);
  }
  return table;
}

// By eighths of a turn, from the x axis on.
constexpr std::array eighths{arc_tangents({}, false), arc_tangents({quarter[0], quarter[1]}, true),
                             arc_tangents({quarter[0], quarter[1]}, false),
                             arc_tangents({2.0 * quarter[0], 2.0 * quarter[1]}, true)};

}  // namespace

double sine(double angle) { return sine_after(angle, 0); }

double cosine(double angle) { return sine_after(angle, 1); }

double exponential(double x) {
  // (e^(x / 2^k))^(2^k): a series of a small number, squared again.
  constexpr int halvings = 12;
  const Pair small{std::ldexp(x, -halvings)};
  Pair sum;
  for (std::size_t n = 20; n-- > 0;) sum = sum * small + shares[n];
  for (int i = 0; i < halvings; ++i) sum = sum * sum;
  return sum.sum();
}

// From the angle whose tangent is the nearest sixteenth it is not far: by the series of a share of at most 1/32, of
// which only the first term needs more than a double's digits.
double angle_to(double x, double y) {
  const double longer = std::max(std::abs(x), y);
  const double shorter = std::min(std::abs(x), y);
  if (longer == 0.0) return 0.0;
  if (longer > 0x1p900 || longer < 0x1p-900) {  // else a product might overflow or vanish
    const double scale = longer > 1.0 ? 0x1p-200 : 0x1p200;
    return angle_to(scale * x, scale * y);
  }
  const bool steep = y > std::abs(x);
  const std::size_t eighth = x < 0.0 ? (steep ? 2 : 3) : (steep ? 1 : 0);
  const double sixteenth = std::round(steps * (shorter / longer));
  const double t = sixteenth / steps;
  const Pair along = exact_product(longer, t);
  const Pair across = exact_product(shorter, t);
  const Pair over = exact_sum(shorter, -along.high);
  const Pair under = exact_sum(longer, across.high);
  const double share = over.high / under.high;
  const Pair taken = exact_product(share, under.high);
  const double left =
      (over.high - taken.high - taken.low + (over.low - along.low) - share * (under.low + across.low)) /
      under.high;
  const double square = share * share;
  const double tail =
      square * (-1.0 / 3 + square * (1.0 / 5 + square * (-1.0 / 7 + square * (1.0 / 9 - square / 11))));
  const double sign = eighth % 2 == 0 ? 1.0 : -1.0;
  const Pair& near = eighths[eighth][static_cast<std::size_t>(sixteenth)];
  const Pair angle = exact_sum(near.high, sign * share);
  return angle.high + (angle.low + (near.low + sign * (left + share * tail)));
}

double hypotenuse(double x, double y) {
  double longer = std::max(std::abs(x), std::abs(y));
  double shorter = std::min(std::abs(x), std::abs(y));
  if (shorter == 0.0) return longer;
  // Squares must neither overflow nor vanish.
  if (longer > 0x1p500) return 0x1p600 * hypotenuse(0x1p-600 * x, 0x1p-600 * y);
  if (shorter < 0x1p-450 && longer < 0x1p-400) return 0x1p-600 * hypotenuse(0x1p600 * x, 0x1p600 * y);
  const double length = std::sqrt(longer * longer + shorter * shorter);
  // A step of Newton's; the squares' difference is written so that nothing large cancels.
  double excess = 0.0;
  if (length <= 2.0 * shorter) {
    const double over = length - shorter;
    excess = longer * (2.0 * over - longer) + (over - 2.0 * (longer - shorter)) * over;
  } else {
    const double over = length - longer;
    excess = 2.0 * over * (longer - 2.0 * shorter) + ((4.0 * over - shorter) * shorter + over * over);
  }
  return length - excess / (2.0 * length);
}

double hypotenuse(double x, double y, double z) {
  const double longest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (longest == 0.0) return 0.0;
  const double a = x / longest;
  const double b = y / longest;
  const double c = z / longest;
  return longest * std::sqrt(a * a + b * b + c * c);
}

}  // namespace knit
