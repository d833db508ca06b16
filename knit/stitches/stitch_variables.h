// The variables of the pseudo-code that are first met in the stages stitch index, faces and pattern: what they are called, their symbols (as in
// the thesis where it has one) and their meaning.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

// stitch index
inline constexpr CodeVariable above{"above", "n", "How many stitches the row has."};
inline constexpr CodeVariable change{"change", "id", "Stitches to increase, or below 0 to decrease."};
inline constexpr CodeVariable wanted{"wanted", "k", "How many main stitches the change needs."};
inline constexpr CodeVariable mains{"mains", "P", "How many main stitches the row below has."};
inline constexpr CodeVariable rule{"rule", "rule", "The rule by which mains were spaced."};
inline constexpr CodeVariable tried{"tried", "tried",
                                    "The rule that would have come first, had there been room."};
inline constexpr CodeVariable spacing{"spacing", "s",
                                      "From one main to the next: in cells, or in mains of the row below."};
inline constexpr CodeVariable remainder{"remainder", "left over", "What equal spacing leaves over."};
inline constexpr CodeVariable mains_set{"mains_set", "mains", "How many mains are set."};
inline constexpr CodeVariable main{"main", "main", "The number of the main that is set, from 1."};
inline constexpr CodeVariable cell{"cell", "cell",
                                   "The place in the larger row that gets the label, from 1."};
inline constexpr CodeVariable label{"label", "label", "What is knitted there."};
inline constexpr CodeVariable partner{"partner", "partner",
                                      "The cell that an increase or decrease works with."};
inline constexpr CodeVariable placed{"placed", "placed", "How many increases or decreases have been placed."};
inline constexpr CodeVariable links{"links", "links", "How many links join the two rows."};
inline constexpr CodeVariable doubled{"doubled", "doubled", "How many stitches have two links."};
inline constexpr CodeVariable sum{"sum", "sum", "The sum of the squared lengths of the wale edges."};
inline constexpr CodeVariable longest{"longest", "longest", "The longest wale edge."};

// faces, pattern
inline constexpr CodeVariable face{"face", "face", "The number of the face between the two rows, from 1."};
inline constexpr CodeVariable of{"of", "of", "How many faces there are between the two rows."};
inline constexpr CodeVariable corners{"corners", "corners", "4: a quad; 3: a triangle."};
inline constexpr CodeVariable row{"row", "row", "The row whose line is written."};
inline constexpr CodeVariable consumed{"consumed", "consumed",
                                       "How many stitches of the row before the line works into."};
inline constexpr CodeVariable produced{"produced", "made", "How many stitches there are after it."};

}  // namespace knit::var
