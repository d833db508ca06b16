#include "knit/pattern/yarn.h"

#include <array>
#include <cmath>

#include "knit/model/settings_table.h"

namespace knit {

namespace {

constexpr double munden = 21.0;

constexpr std::array<WeightClass, 8> weight_classes{{{7, "Jumbo", 0.0, 40.0, 15.0},
                                                     {6, "Super Bulky", 6.5, 80.0, 10.0},
                                                     {5, "Bulky", 11.5, 120.0, 6.5},
                                                     {4, "Medium", 15.5, 190.0, 5.0},
                                                     {3, "Light", 20.5, 240.0, 4.0},
                                                     {2, "Fine", 23.5, 310.0, 3.5},
                                                     {1, "Super Fine", 26.5, 400.0, 2.75},
                                                     {0, "Lace", 32.5, 800.0, 2.0}}};

struct NeedleSize {
  double millimetres = 0.0;
  std::string_view us;
};
constexpr std::array<NeedleSize, 22> needle_sizes{
    {{1.25, "0000"}, {1.5, "000"},  {1.75, "00"}, {2.0, "0"},    {2.25, "1"}, {2.75, "2"},
     {3.0, "2.5"},   {3.25, "3"},   {3.5, "4"},   {3.75, "5"},   {4.0, "6"},  {4.5, "7"},
     {5.0, "8"},     {5.5, "9"},    {6.0, "10"},  {6.5, "10.5"}, {8.0, "11"}, {9.0, "13"},
     {10.0, "15"},   {12.75, "17"}, {15.0, "19"}, {19.0, "35"}}};

}  // namespace

WeightClass weight_class_of(const Gauge& gauge) {
  WeightClass best = weight_classes.front();
  for (const WeightClass& weight : weight_classes) {
    if (gauge.stitches >= weight.fewest_stitches) best = weight;
  }
  return best;
}

double stitch_length_cm(const Gauge& gauge) {
  constexpr double swatch_cm = 10.0;
  return std::sqrt(munden / ((gauge.stitches / swatch_cm) * (gauge.rounds / swatch_cm)));
}

YarnNeeded yarn_needed(std::int64_t stitches, const Gauge& gauge) {
  YarnNeeded yarn;
  yarn.metres = static_cast<double>(stitches) * stitch_length_cm(gauge) / 100.0;
  yarn.metres_with_spare = yarn.metres * (1.0 + yarn_spare);
  yarn.grams = yarn.metres_with_spare / weight_class_of(gauge).metres_in_100_g * 100.0;
  return yarn;
}

std::string needle_text(double millimetres) {
  std::string text = number_text(millimetres) + " mm";
  for (const NeedleSize& size : needle_sizes) {
    if (std::abs(size.millimetres - millimetres) <= 0.02 * size.millimetres)
      return text + " (US " + std::string(size.us) + ")";
  }
  return text;
}

}  // namespace knit
