// Numbers for tables and plots.
#pragma once

#include <string>

namespace app {

// With this many decimals; never "-0.00".
std::string fixed_text(double value, int decimals);

}  // namespace app
