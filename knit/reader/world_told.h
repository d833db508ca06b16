// What a part of a line between rounds tells: how many stitches, and of which holder. For the world_* files alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "knit/trade/world_atoms.h"

namespace knit {

// One is called like the other, but for more words or an s; no name is any.
bool same_world_name(const std::string& told, const std::string& known);
// "12 sts", "the 12 held sts"
std::optional<std::int64_t> stitches_in(const Atoms& part);
// A holder, a pin, waste yarn, a spare needle.
bool names_holder(const Atoms& part);
// "of the left sleeve", behind the last of the words.
std::string name_behind(const Atoms& part, AtomWords words);
// "the 12 held left leg sts": the name before the first stitches told.
std::string name_before_stitches(const Atoms& part);

}  // namespace knit
