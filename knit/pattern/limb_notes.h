// What stands round the instructions of a pattern with limbs: size, materials, notes, finishing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knit/limbs/limb_plan.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/written_parts.h"

namespace knit {

// Nothing is left open but what is drawn in, and nothing is pushed inside.
bool is_stuffed(const LimbPlan& plan);

// Ends each size of a piece with limbs.
inline constexpr std::string_view where_sizes_stand =
    " Length and girth of each piece stand in the list of pieces.";
std::string size_of_limbs(const PatternSizes& sizes, std::optional<double> height_cm);
std::vector<std::string> materials_of_limbs(const LimbPlan& plan, const PatternSizes& sizes,
                                            const PatternOptions& options, const Used& used);
std::vector<std::string> notes_of_limbs(const LimbPlan& plan, const LimbNames& names, const Used& used);
std::vector<std::string> finishing_of_limbs(const LimbPlan& plan, const LimbNames& names);
// "9 pieces, one after the other, from A to I"
std::string worked_in(const LimbPlan& plan);

// Whether a lining hangs together with no other piece before it is grafted: it is turned inside out, else pushed through.
bool is_put_inside(const LimbPlan& plan, std::int32_t piece);
// Before a piece is grafted or bound off together with another: what else there is to do, and how; empty where it ends otherwise.
std::vector<std::string> seam_remarks(const LimbPlan& plan, const LimbNames& names, std::int32_t piece);

}  // namespace knit
