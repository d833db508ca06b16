// Why a tube has no rhythm.
#pragma once

#include <cstdint>

namespace knit {

enum class NoRhythm : std::uint8_t {
  no,         // it has one
  branches,   // the piece has other tubes
  fits_none,  // no number of sections goes with the stitches that are there
};

}  // namespace knit
