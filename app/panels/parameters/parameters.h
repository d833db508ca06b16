// The left panel: every knob of the pipeline in its order, and the edits made on the way.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "app/panels/kit/widgets.h"

namespace app {

void draw_parameters(PanelFrame& frame);

struct ChangeMode {
  bool from_here = false;  // a changed parameter counts from here on, not from the start
};

// Why what was typed into a knob is refused; it goes when the knob has another value or is typed into again.
struct KnobTrouble {
  std::string value;  // of the knob, as text
  std::string words;
  bool fresh = true;  // nobody has seen it yet
};
using KnobTroubles = std::map<std::string, KnobTrouble, std::less<>>;  // by parameter key

}  // namespace app
