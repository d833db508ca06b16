// A step's numbers by name, in reading order: the one list behind step logs and the window's table.
#pragma once

#include "knit/run/step.h"

namespace knit {

StepFields fields_of(const Step& step);

}  // namespace knit
