// The choice of short rows as alternatives: none, or with 0, 1, 2 rows kept at events; pairs, what is left when all has
// settled, and how even the wales are then. The one that is taken is marked; a click takes another.
#pragma once

#include <cstdint>
#include <vector>

#include "app/panels/kit/widgets.h"
#include "app/session/run_key.h"
#include "knit/model/settings_table.h"
#include "knit/short_rows/kept_choice.h"

namespace app {

// What a run that chose by itself found; it stays while nothing but the choice is changed.
class KeptChoices {
 public:
  void refresh(const knit::Timeline& timeline);
  [[nodiscard]] const std::vector<knit::KeptTry>& tries() const { return tries_; }

 private:
  RunKey key_;
  std::vector<knit::KeptTry> tries_;
};

// The knob that they stand below.
bool is_short_rows_knob(const knit::ParameterInfo& info);
// At the cursor, as wide as the panel; nothing where short rows are off and nothing was tried.
void draw_kept_choices(PanelFrame& frame, knit::Parameters& parameters);

}  // namespace app
