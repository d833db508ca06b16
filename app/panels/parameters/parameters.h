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

// A vertex number that is typed.
struct VertexField {
  TextBuffer text;
  std::string shown;    // the value that `text` was made from
  std::string trouble;  // why what was typed is refused
};
using VertexFields = std::map<std::string, VertexField, std::less<>>;  // by parameter key

}  // namespace app
