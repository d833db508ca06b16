// Counts of a tube's rows of which no change is undone within eight rounds, where the shape allows that.
//
// The count of a row by itself is the one nearest to what it holds. So the widest rounds of a ball go 82, 83, 83, 83, 82: an
// increase that is undone three rounds later, for nothing that could be seen. Here an increase and a decrease, in either
// order, have eight rounds without a change between them, where that is possible with counts that are at most 3.5 % off
// (or the nearest, where a stitch is more than that). A top that is shorter is so knitted with one count, the one that
// suits its nine rounds best; where a shape swells and narrows faster, it wins, and its change is undone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace knit {

inline constexpr std::int32_t lasting_rounds = 8;  // after a change, without one the other way
inline constexpr double lasting_tolerance = 0.035;

// At least three, and nearest to `ideal` (L / w): as wide stitches are further off than narrow ones, by their squared shares.
std::int32_t nearest_count(double ideal);
// What a count costs: over its stitches, the squared share by which they come out too wide or too narrow.
double misfit_of(double ideal, std::int32_t count);
// Whether that row of a tube, from 0, changes the count of the one before it, and the other way within eight rounds.
bool is_undone(std::span<const std::int32_t> counts, std::size_t level);
// One for each row of a tube. Of all that are near enough those with the fewest changes undone, and of these the nearest.
std::vector<std::int32_t> lasting_counts(std::span<const double> ideals);

}  // namespace knit
