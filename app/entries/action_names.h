// What each action is called, and how a person comes by it. Every action is here: the compiler sees to it.
#pragma once

#include <array>
#include <string_view>

#include "app/session/action.h"

namespace app {

enum class Reach : std::uint8_t {
  control,  // a button, a field or a line of a menu: `where` is the name of its mark
  view,     // the mouse in the view, or another place that is pointed at: `where` says how
  machine,  // not a person's: `where` says why
};

struct ActionName {
  std::string_view words;  // "Go to a position"
  Reach reach;
  std::string_view where;
};

// By the index of the variant.
const std::array<ActionName, ActionKinds::size>& action_names();
const ActionName& name_of(const Action& action);

}  // namespace app
