// The finished size fitted to the rhythm, for whoever asks: the window's button and --fit-size.
#pragma once

#include <string>
#include <variant>

#include "knit/rhythm/fit_size.h"
#include "knit/run/timeline.h"

namespace app {

struct FittedSize {
  knit::Parameters parameters;  // those in force, at the size that is taken
  std::string words;            // what was asked for and what is taken, or that it stays as it is
};
// Of a run whose tubes are planned, with what is set from its start; else why there is none, in one sentence.
std::variant<FittedSize, std::string> fitted_size(const knit::Timeline& timeline);

}  // namespace app
