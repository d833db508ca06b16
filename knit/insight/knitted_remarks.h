// What a maker must be told of a piece as it comes off the needles [knit/relax/knitted.h], each with the row to look at.
#pragma once

#include <string>
#include <vector>

#include "knit/insight/problems.h"
#include "knit/relax/knitted.h"

namespace knit {

// Where it swelled without bound; that is then all there is to tell.
bool is_without_size(const KnittedPiece& piece, const Parameters& parameters);

// "Knitted and stuffed, this comes out 14.4 cm high and 10.5 cm wide".
std::string comes_out_text(const KnittedFigures& figures, const Parameters& parameters);

// For a pattern: "Knitted and stuffed, about 14.5 cm high and 10.5 cm wide.", to half a centimetre, below 5 cm to a millimetre.
std::string about_size_text(const KnittedFigures& figures, const Parameters& parameters);

// Where size, ends, rounds, lengths, bends or limbs are off; sheets that touch; a piece that did not come to rest. All of it first.
std::vector<Remark> remarks_on(const Fabric& fabric, const KnittedPiece& piece, const Parameters& parameters);

}  // namespace knit
