#include "app/actions/looking.h"

#include <algorithm>

#include "app/session/shown.h"
#include "app/session/view.h"
#include "knit/yarn/eased_yarn.h"

namespace app {

namespace {

// What stands for the piece as a mesh of stitches.
constexpr std::array layers_of_stitches{Layer::stitches, Layer::row_edges, Layer::column_edges, Layer::faces};

}  // namespace

Looking looking_of(const Session& session) {
  const View& view = *session.view;
  if (view.shows(Layer::yarn)) return Looking::yarn;
  const bool stitches = std::any_of(layers_of_stitches.begin(), layers_of_stitches.end(),
                                    [&](Layer layer) { return view.shows(layer); });
  if (!stitches) return Looking::mesh;
  return positions_shown(session) == Positions::relaxed ? Looking::relaxed : Looking::stitches;
}

void show_as(Session& session, Looking looking) {
  View& view = *session.view;
  const auto set = [&](Layer layer, bool on) { view.layers[static_cast<std::size_t>(layer)] = on; };
  for (const Layer layer : layers_of_stitches) set(layer, looking != Looking::mesh);
  set(Layer::yarn, looking == Looking::yarn);
  if (looking == Looking::mesh) set(Layer::surface, true);
  const bool air = looking == Looking::relaxed || looking == Looking::yarn;
  if (air) {
    view.positions = Positions::relaxed;
  } else if (view.positions == Positions::relaxed) {
    view.positions = Positions::settled;
  }
}

YarnLook within_limits(const YarnLook& look) {
  YarnLook within = look;
  within.stripe_rounds = std::clamp(look.stripe_rounds, 0, most_stripe_rounds);
  within.easing = std::clamp(look.easing, 0, knit::most_yarn_easing);
  // Not above 0 stands for the usual one, and so does what is no number.
  within.radius = look.radius > 0.0 ? std::clamp(look.radius, least_yarn_radius, most_yarn_radius) : 0.0;
  within.wool = opaque(look.wool);
  within.second = opaque(look.second);
  return within;
}

}  // namespace app
