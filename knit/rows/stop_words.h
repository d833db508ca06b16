// Why a row cannot be made, in a sentence that says what a person may do.
#pragma once

#include <string>

#include "knit/model/event.h"

namespace knit {

std::string rows_stop_sentence(const Stopped& s, const Telling& at);

std::string band_text(const Parameters& parameters);  // "[0.15, 0.45]"

}  // namespace knit
