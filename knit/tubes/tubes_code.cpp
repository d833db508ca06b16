#include "knit/tubes/tubes_code.h"

#include <array>

#include "knit/tubes/tubes_events.h"
#include "knit/tubes/tubes_variables.h"

namespace knit {

namespace {

constexpr std::array tubes_lines{
    CodeLine{"sweep up by rank: level curves make tubes",
             {},
             &var::tubes,
             "Vertices are ordered by time and number, so that no two are equal; between two critical "
             "vertices each level "
             "curve sweeps out a tube.",
             "docs/algorithm.md, The graph of tubes",
             lit_or<lit_by<GraphFound>, lit_by_stop<StopReason::too_many_tubes>>},
    CodeLine{"if more than one: smooth over {}",
             {&var::smoothing},
             &var::smoothing,
             "What is smaller than a stitch shall make no tube of its own.",
             "docs/algorithm.md, The graph of tubes",
             lit_by<FieldSmoothed>},
    CodeLine{"for each critical vertex {}",
             {&var::node},
             &var::node_kind,
             "A minimum opens a tube, a split closes one and opens two, a join closes two and opens one, a "
             "maximum closes "
             "one.",
             "docs/algorithm.md, The graph of tubes",
             lit_by<NodeFound>,
             true},
    CodeLine{"while a leaf or handle is under a round:",
             {},
             nullptr,
             "The smallest goes first; what it hung on becomes one tube again.",
             "docs/algorithm.md, What is knitted",
             never,
             true},
    CodeLine{"  leave it out",
             {},
             &var::leaf_rows,
             "It is said with its size and place, and which stitch would keep it.",
             "docs/algorithm.md, What is knitted",
             lit_by<TubeLeftOut>},
    CodeLine{"give rows to tubes; order them",
             {},
             &var::planned_rows,
             "Each tube gets rows at equal heights of its own, twins the same. Then all rows are worked once "
             "unseen, and of the orders tried the one is taken that costs a knitter least: its yarns, "
             "holders and markers.",
             "docs/algorithm.md, Order",
             lit_or<lit_by<TubesPlanned>, lit_by_stop<StopReason::no_row_levels, StopReason::too_fine>>}};

constexpr std::array tubes_aside{
    &var::together,    &var::left_share, &var::raw_tubes, &var::nodes,      &var::graph_loops, &var::unfolded,
    &var::field_value, &var::closed,     &var::opened,    &var::leaf_girth, &var::keeps,       &var::events,
    &var::held,        &var::yarns,      &var::exact,     &var::handle,     &var::orders_tried};

bool with_contours(const Parameters& parameters) { return parameters.rows.source == RowSource::contours; }

}  // namespace

const PseudoCode tubes_code{
    {Stage::tubes, Stage::tubes}, with_contours, "The graph of tubes", tubes_lines, tubes_aside};

}  // namespace knit
