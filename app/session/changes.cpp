#include "app/session/changes.h"

#include <algorithm>
#include <utility>

#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"

namespace app {

namespace {

const knit::Parameters& in_force_at(const Knobs& knobs, const knit::Place& place) {
  const knit::Parameters* in_force = &knobs.base;
  for (const knit::Edit& edit : knobs.edits) {
    if (edit.at <= place) in_force = &edit.parameters;
  }
  return *in_force;
}

void add_changed_keys(ParameterKeys& keys, const knit::Parameters& a, const knit::Parameters& b) {
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (!knit::same_value(info, a, b) && !knit::only_follows(info, a, b)) keys.insert(info.key);
  }
}

// A size takes others along, and not always the same ones.
bool is_the_same_hand(const ParameterKeys& a, const ParameterKeys& b) {
  return std::includes(a.begin(), a.end(), b.begin(), b.end()) ||
         std::includes(b.begin(), b.end(), a.begin(), a.end());
}

void forget_oldest(Changes& changes) {
  if (changes.undo.size() > Changes::most) changes.undo.erase(changes.undo.begin());
}

}  // namespace

Knobs knobs_of(const knit::Timeline& timeline) {
  return {timeline.wished_parameters(), timeline.wished_edits()};
}

Knobs resolved(const Knobs& knobs, const knit::Input& input) {
  Knobs result{knit::resolved(knobs.base, input), knobs.edits};
  for (knit::Edit& edit : result.edits) edit.parameters = knit::resolved(edit.parameters, input);
  return result;
}

Knobs tuned(const Knobs& knobs, const knit::Parameters& now, const knit::Parameters& wanted,
            const knit::Input& input) {
  Knobs result{knit::with_change(knobs.base, now, wanted), knobs.edits};
  for (knit::Edit& edit : result.edits) edit.parameters = knit::with_change(edit.parameters, now, wanted);
  return resolved(result, input);
}

ParameterKeys changed_keys(const Knobs& a, const Knobs& b) {
  ParameterKeys keys;
  add_changed_keys(keys, a.base, b.base);
  for (const Knobs* knobs : {&a, &b}) {
    for (const knit::Edit& edit : knobs->edits)
      add_changed_keys(keys, in_force_at(a, edit.at), in_force_at(b, edit.at));
  }
  return keys;
}

void note_change(Changes& changes, const Change& now, bool held) {
  const auto before = std::exchange(changes.before, std::nullopt);
  if (!before || *before == now.knobs) return;
  changes.redo.clear();
  ParameterKeys keys = changed_keys(*before, now.knobs);
  const bool joins =
      held && changes.open && !changes.undo.empty() && is_the_same_hand(keys, changes.open_keys);
  if (!joins) {
    changes.undo.push_back({*before, now.pieces, now.curves});
    changes.open_keys = std::move(keys);
  } else if (changes.undo.back() == now) {
    changes.undo.pop_back();  // dragged back to where it was: nothing has changed
    held = false;
  }
  changes.open = held;
  forget_oldest(changes);
}

void note_other_change(Changes& changes, Change now) {
  changes.redo.clear();
  changes.undo.push_back(std::move(now));
  changes.open = false;
  forget_oldest(changes);
}

}  // namespace app
