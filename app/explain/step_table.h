// A step's numbers as words for people: what the window's table shows.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "knit/run/step.h"

namespace app {

// Name and value, in reading order.
std::vector<std::pair<std::string, std::string>> numbers_of(const knit::Step& step);

}  // namespace app
