// Yarn and needles for a gauge: weight class, usual needle, metres and grams.
//
// A stitch of plain knitting takes l = sqrt(K / (stitches per cm * rounds per cm)) centimetres of yarn,
// whatever the fibre and the thickness: the stitches in a square centimetre times l squared stay the same.
// D. L. Munden, "The geometry and dimensional properties of plain-knit fabrics", Journal of the Textile
// Institute 50 (1959), T448: K = 19.0 dry relaxed, 21.6 wet relaxed. We take 21.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "knit/model/settings.h"

namespace knit {

// Craft Yarn Council, 0 Lace to 7 Jumbo. The council gives stitches and needles; lengths are those usual for
// yarns sold under each name, and needles lie within its ranges.
struct WeightClass {
  int number = 3;
  std::string_view name;
  double fewest_stitches = 0.0;  // in 10 cm of stockinette
  double metres_in_100_g = 0.0;
  double needle_mm = 0.0;
};
// By stitches alone, as the council's table is; where two classes overlap or leave a gap, the middle parts
// them.
WeightClass weight_class_of(const Gauge& gauge);

double stitch_length_cm(const Gauge& gauge);  // yarn in one stitch

// More than worked out, for the cast on, the ends and a looser hand.
inline constexpr double yarn_spare = 0.15;

struct YarnNeeded {
  double metres = 0.0;
  double metres_with_spare = 0.0;
  double grams = 0.0;  // with spare, of the weight class
};
YarnNeeded yarn_needed(std::int64_t stitches, const Gauge& gauge);

// "3.25 mm (US 3)"; without the US size where none is near.
std::string needle_text(double millimetres);

}  // namespace knit
