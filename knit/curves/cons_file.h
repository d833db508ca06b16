// autoknit's constraint files (.cons), read: little endian; uint32 n; n points of 3 float32; uint32 m; m chains of
// (uint32 count of points, float32 value, float32 radius); nothing after. They are never written.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "knit/curves/cycle.h"

namespace knit {

// In the order of the file. A closed chain (its first point is its last) becomes a path, one point with a radius a
// circle, an open chain with a radius a band. The lowest value is the start, the others are ends; times are the
// values, set between 0 and 1. The error is one sentence.
std::variant<std::vector<Cycle>, std::string> read_cons(std::string_view bytes);

}  // namespace knit
