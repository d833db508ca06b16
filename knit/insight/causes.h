// What decided, in plain words with the numbers: why a row has its number of stitches, why a label stands where it stands,
// which vertices were refused just before a stitch. A step's own sentence says what was done; a cause says what had it be so.
//
// Texts of one to four sentences, for people; empty where nothing is decided so far. Stitches, cells and vertices of a row
// count from 1. Cost: the steps of the row and of a few rows beside it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "knit/insight/why.h"

namespace knit {

// "Row 7 has 33 stitches: ..."
std::string why_count(const Timeline& timeline, std::int32_t row);

// Which rule placed it, and which neighbour decided.
std::string why_label(const Timeline& timeline, const LabelElement& label);

// Steps that measured a vertex between the stitch before and this one, and did not take it; rising.
std::vector<std::size_t> refused_before(const Timeline& timeline, const StitchElement& stitch);
// "Just before it vertex 790 was refused: ..."
std::string why_refused_before(const Timeline& timeline, const StitchElement& stitch);

// Of a step: its label's, and its row's count where it decides that or is the row's last in its stage.
std::string cause_of(const Timeline& timeline, std::size_t step);

}  // namespace knit
