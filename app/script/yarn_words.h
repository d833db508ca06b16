// What the command line says of the view: which layers, mesh or yarn, and the yarn's colours.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "app/session/view.h"

namespace CLI {
class App;
}

namespace app {

struct YarnWords {
  std::string layers, show_as, colour, second, stripes, shows, radius, easing;
};

// None: as it is.
struct YarnWish {
  std::optional<std::array<bool, layer_count>> layers;
  std::optional<Looking> looking;
  std::optional<Colour> wool, second;
  std::optional<int> stripe_rounds, easing;
  std::optional<double> radius;
  std::optional<YarnColours> by;
};

void declare_yarn(CLI::App& app, YarnWords& words);
// A sentence where a word cannot be.
std::optional<std::string> read_yarn_words(const YarnWords& words, YarnWish& wish);

void apply_yarn_wish(Session& session, const YarnWish& wish);

}  // namespace app
