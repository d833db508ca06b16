// One parameter's control, drawn from its line in knit::parameter_table().
#pragma once

#include "app/panels/panels.h"
#include "knit/parameters.h"

namespace app {

// Changes `parameters` when a person did; what the table refuses is left out.
void draw_knob(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters);

}  // namespace app
