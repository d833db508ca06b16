// Small words that sentences are made of.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "knit/model/label.h"
#include "knit/model/products.h"

namespace knit {

std::string_view name_of(Label label);  // "M1R"
std::string_view name_of(Rule rule);    // "remainder last (R4)"

// Three significant digits are enough for a sentence: "0.0483".
std::string short_number(double value);
std::string fixed_number(double value, int decimals);  // "14.4"

std::string plural(std::int64_t count, std::string_view one, std::string_view many);  // "3 stitches"
std::string percent_text(double share);                                               // "18 %", "0.4 %"
std::string stitch_count_text(std::int64_t count);
std::string tube_name(std::int32_t tube);  // "A", "Z", "AA", counted from 0
std::string vertex_text(VertexId vertex);  // "vertex 12"

}  // namespace knit
