#include "knit/relax/relax_code.h"

#include <array>

#include "knit/relax/relax_events.h"
#include "knit/relax/relax_variables.h"

namespace knit {

namespace {

constexpr std::string_view source = "docs/algorithm.md, Relaxing";

constexpr std::array lines{
    CodeLine{"{} \xE2\x86\x90 all stitches, on {}",
             {&var::hung, &var::springs},
             &var::hung,
             "A spring for each course, wale and diagonal, as long as the stitch is asked to be.",
             source,
             lit_by<RelaxPlanned>},
    CodeLine{"{} \xE2\x86\x90 {} \xC2\xB7 stiffness / {}",
             {&var::pressure, &var::stuffing, &var::ball_radius},
             &var::pressure,
             "What stretches a ball of this fabric by about that share.",
             source,
             lit_by<RelaxPlanned>},
    CodeLine{"repeat until nothing moves by 1/1000 w",
             {},
             nullptr,
             "In five iterations in a row.",
             source,
             never,
             true},
    CodeLine{"  y \xE2\x86\x90 {} and some of its last move",
             {&var::hung},
             nullptr,
             "Momentum: what moved goes on moving.",
             source,
             lit_by<StitchesRelaxed>},
    CodeLine{"  f \xE2\x86\x90 springs, bends, {} \xC2\xB7 growth of {}",
             {&var::pressure, &var::volume},
             &var::volume,
             "What pulls and pushes each stitch; pairs that touch push each other apart.",
             source,
             lit_by<StitchesRelaxed>},
    CodeLine{"  {} \xE2\x86\x90 y + L\xE2\x81\xBB\xC2\xB9 f",
             {&var::hung},
             &var::relax_move,
             "L is the springs' own matrix, factored once: so long waves move as fast as short ones.",
             source,
             lit_by<StitchesRelaxed>},
    CodeLine{"  if it went uphill: no momentum",
             {},
             &var::restarted,
             "It starts again from where it is.",
             source,
             [](const AnyEvent& event) {
               const auto* relaxed = event.get_if<StitchesRelaxed>();
               return relaxed != nullptr && relaxed->restarted;
             }},
    CodeLine{"measure {} and {}",
             {&var::knitted_height, &var::knitted_width},
             &var::knitted_height,
             "Laid back onto the mesh as well as can be, it is compared with what was asked.",
             source,
             lit_by<RelaxDone>}};

constexpr std::array aside{&var::relax_iteration, &var::touching,   &var::lidded,    &var::asked_height,
                           &var::asked_width,     &var::sunk_first, &var::sunk_last, &var::came_to_rest};

}  // namespace

const PseudoCode relax_code{{Stage::relax, Stage::relax}, always, "Relaxing in the air", lines, aside};

}  // namespace knit
