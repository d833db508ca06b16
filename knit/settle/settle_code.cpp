#include "knit/settle/settle_code.h"

#include <array>

#include "knit/settle/settle_events.h"
#include "knit/settle/settle_variables.h"

namespace knit {

namespace {

constexpr std::string_view source = "docs/algorithm.md, Settling";

constexpr std::array lines{
    CodeLine{"{} \xE2\x86\x90 all stitches, bridges too",
             {&var::moved},
             &var::moved,
             "Each may move on the surface: two numbers in the plane that touches it there.",
             source,
             lit_by<SettlingBegun>},
    CodeLine{"{} \xE2\x86\x90 squares of what wales, courses lack",
             {&var::settle_sum},
             &var::settle_sum,
             "Wales against h, courses against w, a quad's diagonals against each other; rims stay near, "
             "faces do not turn over.",
             source,
             lit_by<SettlingBegun>},
    CodeLine{"repeat while it gains more than 1/5000",
             {},
             nullptr,
             "Three iterations with less gain end it.",
             source,
             never,
             true},
    CodeLine{"  d \xE2\x86\x90 \xE2\x88\x92(A + {}/w\xC2\xB2)\xE2\x81\xBB\xC2\xB9 b",
             {&var::shift},
             &var::shift,
             "One linear system for all stitches at once, by sparse Cholesky.",
             source,
             lit_by<StitchesSettled>},
    CodeLine{"  {} \xE2\x86\x90 nearest places to {} + d",
             {&var::moved, &var::moved},
             &var::greatest_move,
             "At most one stitch width, then the nearest place of the surface that can be walked to.",
             source,
             lit_by<StitchesSettled>},
    CodeLine{"  if {} fell: take it, else larger {}",
             {&var::settle_sum, &var::shift},
             &var::settle_sum,
             "A step that makes it worse is tried again, more carefully.",
             source,
             lit_by<StitchesSettled>}};

constexpr std::array aside{&var::iteration, &var::tries,      &var::sum_before,  &var::taken,
                           &var::mean_move, &var::wale_edges, &var::course_edges};

}  // namespace

const PseudoCode settle_code{{Stage::settle, Stage::settle}, always, "Settling on the surface", lines, aside};

}  // namespace knit
