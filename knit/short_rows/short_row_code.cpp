#include "knit/short_rows/short_row_code.h"

#include <array>

#include "knit/short_rows/short_row_events.h"
#include "knit/short_rows/short_row_variables.h"

namespace knit {

namespace {

constexpr std::string_view source = "docs/algorithm.md, Short rows";

// Only its own steps show it.
bool never_chosen(const Parameters& /*parameters*/) { return false; }

constexpr std::array lines{
    CodeLine{"for {} = none, 0, 1, 2: settled, {}",
             {&var::rows_kept, &var::settled_sum},
             &var::settled_sum,
             "The piece is worked and settled without short rows, and with so many rows kept beside events.",
             source,
             lit_by<KeptTried>},
    CodeLine{"take the {} of least {}",
             {&var::rows_kept, &var::settled_sum},
             &var::sum_without,
             "Of equal ones no short rows, then the fewest rows kept.",
             source,
             lit_by<KeptChosen>},
    CodeLine{"for each tube: a chart, rounds {} apart",
             {&var::near_spacing},
             &var::full_rounds,
             "Time and angle are harmonic; the next round stands where the nearest columns have risen by h.",
             source,
             lit_by<TubeCharted>},
    CodeLine{"  for each gap {}",
             {&var::short_gap},
             &var::short_gap,
             "Between a full round and the next, from the beginning.",
             source,
             lit_by<GapMeasured>},
    CodeLine{"    {} \xE2\x86\x90 height / h \xE2\x88\x92 rows so far",
             {&var::lag},
             &var::lag,
             "Of each column: how many rows are missing there. A pair of short rows adds two.",
             source,
             lit_by<GapMeasured>},
    CodeLine{"    arc [{}, {}] of most {} less {}",
             {&var::arc_from, &var::arc_to, &var::gain, &var::price},
             &var::gain,
             "Of all arcs the one whose pair makes the squared lag least, less what its turns cost.",
             source,
             lit_by<ArcTried>},
    CodeLine{"    if it pays: a pair, and look again",
             {},
             &var::arc_taken,
             "As long as the best arc gains more than its two turns cost.",
             source,
             lit_by<ArcTried>},
    CodeLine{"  {} \xE2\x86\x90 all pairs; begin in their middle",
             {&var::pairs},
             &var::pairs,
             "So that most pairs run as far to one side of the beginning of the round as to the other.",
             source,
             lit_by<PairsChosen>},
    CodeLine{
        "before each round: for each pair over it",
        {},
        nullptr,
        "Those over the beginning of the round first, the widest last; then the others in working order.",
        source,
        never,
        true},
    CodeLine{"  stitches {}..{} with plain ones beside",
             {&var::first_stitch, &var::last_stitch},
             &var::turn_moved,
             "A turn stands where the round works one stitch on one; it is moved by three stitches at most.",
             source,
             lit_by<PairPlaced>},
    CodeLine{"  else leave it out",
             {},
             &var::drop_reason,
             "There is no plain stitch to turn at.",
             source,
             lit_by<PairDropped>},
    CodeLine{"  knit {}..{}, turn; purl back, turn",
             {&var::first_stitch, &var::last_stitch},
             &var::short_stitches,
             "One stitch on one, out on the right side and back on the wrong side.",
             source,
             lit_by<ShortRowWorked>}};

constexpr std::array aside{&var::residual, &var::no_chart,   &var::lag_column,  &var::least_lag,
                           &var::lag_left, &var::wrong_side, &var::chart_levels};

}  // namespace

const PseudoCode short_rows_code{{Stage::cast_on, Stage::rows}, never_chosen, "Short rows", lines, aside};

}  // namespace knit
