// A field for one number, the same in every panel: dragged sideways, or typed after a click.
//
// A click that does not move opens it, with all of its text selected. What is typed is taken on Enter, on Tab
// (which opens the next field of the window, Shift+Tab the one before) and on leaving; Escape restores. A drag
// goes 1 % of the range every few units, a tenth of that with Shift, and never leaves the range. While nobody
// types it shows at most five significant digits; the tip and what is typed on have all of them.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/panels/kit/widgets.h"

namespace app {

enum class DragPace : std::uint8_t {
  none,    // typed only
  linear,  // 1 % of the range
  whole,   // the same, in whole numbers
  ratio,   // 1 % of the value: ranges without end or over decades
};

struct NumberShape {
  std::string shown;  // while nobody types
  std::string full;   // what typing begins with: reads back as exactly this value
  double value = 0.0, low = 0.0, high = 0.0;
  DragPace pace = DragPace::linear;
  std::function<void()> behind = {};  // draws into the last item, below the number
};

struct NumberChange {
  std::optional<double> dragged;
  std::optional<std::string> typed;  // another text than the field began with
  bool let_go = false;               // a drag is over
};

// What the fields remember. Only one is open at a time.
struct NumberFields {
  struct Place {
    ImGuiID field = 0;
    const void* window = nullptr;  // its draw list: the same for all of a window's fields
  };
  ImGuiID open = 0;  // is typed into, or will be in its next frame
  bool fresh = false;
  bool active = false;  // has had the keyboard
  int waited = 0;       // frames in which it had not, or was not drawn
  TextBuffer text;
  std::string began_with;

  ImGuiID held = 0;  // under the button
  bool dragging = false;
  float start_x = 0.0f, last_x = 0.0f;
  double exact = 0.0;  // of the drag, before it is rounded

  std::vector<Place> order, order_before;  // as drawn in this frame and in the last
  int frame = -1;

  struct Trouble {
    ImGuiID field = 0;
    std::string words;
  } trouble;  // why what was typed last was refused
};

// One item of this width at the cursor.
NumberChange number_field(PanelFrame& frame, const char* name, const NumberShape& shape, float width);
// The same for a panel's own number: true when it has changed. What cannot be read or is out of range is refused, and
// the field says why.
bool edit_number(PanelFrame& frame, const char* name, double& value, const NumberShape& shape, float width);
bool edit_number(PanelFrame& frame, const char* name, int& value, int low, int high, const std::string& after,
                 float width);

// Keys are text for a field that is open or about to be.
bool number_field_open(PanelMemory& memory);
// A drag of some number goes on.
bool number_dragged(const PanelFrame& frame);
// At most five significant digits.
std::string shown_number(double value);
// For the tip of a field: all digits, where it does not show them.
std::string exact_words(const std::string& shown, const std::string& full);

}  // namespace app
