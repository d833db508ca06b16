// What can be set of settling.
#pragma once

#include <cstdint>

namespace knit {

enum class Settling : std::uint8_t { off, on };

// Weights of squares that a perfect fabric has at 0, each a share of the stitch's size.
struct SettleSettings {
  Settling settling = Settling::on;
  double wale = 2.0;    // of a wale's length, against h
  double course = 1.0;  // of a course's, against w
  double shear = 0.25;  // of a quad's two diagonals, which are to be alike
  double rim = 1.0;     // of the way from where the rim of an opening was
  double fold = 1.0;    // of a face's corner that is about to turn over
  double cover = 0.5;   // of the way in of a stitch that stood out, as at the end of a limb
  std::int32_t most_iterations = 60;
  friend bool operator==(const SettleSettings&, const SettleSettings&) = default;
};

}  // namespace knit
