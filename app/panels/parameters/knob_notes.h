// Below the knobs: what follows a change of it, and a gauge that is hardly that of knitted fabric.
#pragma once

#include <optional>
#include <string>

#include "app/panels/kit/widgets.h"
#include "knit/model/settings_table.h"

namespace app {

// The last change of a knob by hand: it stays told while the knob has this value.
struct KnobFollow {
  std::string key;
  std::string value_before, value_after;   // of the knob, as text
  std::optional<knit::Parameters> before;  // none: nothing was changed
  float notes_height = 0.0f;               // of what was said in the last frame
};

// "Follows: w 0.1 -> 0.07576, ε 0.05 -> 0.03788": what reads otherwise now though only `info` was set; empty: nothing.
std::string follow_words(const knit::ParameterInfo& info, const knit::Parameters& before,
                         const knit::Parameters& now);

// `from`: as it was; a drag goes on from where it began.
void note_change_of(PanelFrame& frame, const knit::ParameterInfo& info, const knit::Parameters& from,
                    const knit::Parameters& to);

// What they took in the last frame; 0: there were none.
float height_of_knob_notes(PanelFrame& frame);
// May change `parameters`: where a person takes the rounds that go with the stitches.
void draw_knob_notes(PanelFrame& frame, knit::Parameters& parameters);

}  // namespace app
