#include "app/scene/yarn_look.h"

#include "knit/base/number_text.h"

namespace app {

std::optional<double> read_yarn_radius(std::string_view text) {
  if (text == "auto") return 0.0;
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = knit::number_from(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  if (!(value >= least_yarn_radius && value <= most_yarn_radius)) return std::nullopt;
  return value;
}

}  // namespace app
