// Undo and redo of parameters: what was in force for the whole run, and the edits on the way.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "knit/run/timeline.h"

namespace app {

struct Knobs {
  knit::Parameters base;
  std::vector<knit::Edit> edits;
  friend bool operator==(const Knobs&, const Knobs&) = default;
};

// Of parameters, from the table: views of names that live as long as the program.
using ParameterKeys = std::set<std::string_view>;

struct Changes {
  static constexpr std::size_t most = 300;  // older ones are forgotten

  std::vector<Knobs> undo, redo;  // the nearest last
  bool open = false;              // the hand has not let go: what changes now joins the last entry
  ParameterKeys open_keys;        // what it is changing
  std::optional<Knobs> before;    // while an action is done that may change something
};

Knobs knobs_of(const knit::Timeline& timeline);

// As the knobs are on this mesh.
Knobs resolved(const Knobs& knobs, const knit::Input& input);
// As tuning from `now` to `wanted` leaves them: what is wished counts in the edits too.
Knobs tuned(const Knobs& knobs, const knit::Parameters& now, const knit::Parameters& wanted,
            const knit::Input& input);

// What has another value anywhere in the run.
ParameterKeys changed_keys(const Knobs& a, const Knobs& b);

// Takes `before` into the list if `now` is another. `held`: by a hand that has not let go; while it goes on
// changing the same parameters, that is one entry.
void note_change(Changes& changes, const Knobs& now, bool held);

}  // namespace app
