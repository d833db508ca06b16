// Reads the JSON of a pattern (its fields are in docs/pattern.md) as a knitter would: works the rounds on a needle and on
// holders, proves every number by another, and rebuilds the graph. Knows nothing of how it is written here. Nothing is
// repaired: the first mistake ends the reading, and its sentence begins with the place in the file, counted from 0 as JSON's
// lists are: "pieces[2].rounds[5]: works 11 of 12 stitches." O(stitches).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "knit/reader/limbs_reader.h"
#include "knit/reader/pattern_reader.h"

namespace app {

// Whether a text is meant as JSON: it begins with a bracket of an object.
bool begins_like_json(std::string_view text);

// Why the text is no pattern at all, after "it": "it is no JSON from line 3 on: ..."
using NoPattern = std::string;
// Of one piece, or of pieces. Mistakes have no line.
using JsonPattern = std::variant<NoPattern, knit::ReadPattern, knit::ReadLimbs>;
JsonPattern read_pattern_json(std::string_view text);

// Version 2: pieces, holders, gaps.
knit::ReadLimbs read_pieces_json(const nlohmann::json& document);

}  // namespace app
