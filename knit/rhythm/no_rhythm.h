// Why a tube has no rhythm.
#pragma once

#include <cstdint>

namespace knit {

enum class NoRhythm : std::uint8_t {
  no,         // it has one
  few_rows,   // it is worked on live stitches and soon ends
  fits_none,  // no number of sections goes with the stitches that are there
};

}  // namespace knit
