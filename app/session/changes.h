// Undo and redo of parameters, of what was in force for the whole run and of the edits on the way; of the curves that the
// mesh is cut along; and of what a person says about pieces.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "app/session/pattern_pieces.h"
#include "knit/curves/cycle.h"
#include "knit/run/timeline.h"

namespace app {

struct Knobs {
  knit::Parameters base;
  std::vector<knit::Edit> edits;
  friend bool operator==(const Knobs&, const Knobs&) = default;
};

// What one entry goes back to.
struct Change {
  Knobs knobs;
  PatternPieces pieces;
  std::vector<knit::Cycle> curves{};  // that the mesh is cut along
  friend bool operator==(const Change&, const Change&) = default;
};

// Of parameters, from the table: views of names that live as long as the program.
using ParameterKeys = std::set<std::string_view>;

struct Changes {
  static constexpr std::size_t most = 300;  // older ones are forgotten

  std::vector<Change> undo, redo;  // the nearest last
  bool open = false;               // the hand has not let go: what changes now joins the last entry
  ParameterKeys open_keys;         // what it is changing
  std::optional<Knobs> before;     // while an action is done that may change something
};

// As wished, where the run is still waited for.
Knobs knobs_of(const knit::Timeline& timeline);

// As the knobs are on this mesh.
Knobs resolved(const Knobs& knobs, const knit::Input& input);
// As tuning from `now` to `wanted` leaves them: what is wished counts in the edits too.
Knobs tuned(const Knobs& knobs, const knit::Parameters& now, const knit::Parameters& wanted,
            const knit::Input& input);

// What has another value anywhere in the run.
ParameterKeys changed_keys(const Knobs& a, const Knobs& b);

// Takes `before` into the list if `now` has other knobs. `held`: by a hand that has not let go; while it goes on
// changing the same parameters, that is one entry.
void note_change(Changes& changes, const Change& now, bool held);
// Of pieces or of curves: `now` is what they were.
void note_other_change(Changes& changes, Change now);

}  // namespace app
