// Whether there are short rows, and how many rows tubes keep beside events: each way is run ahead until it has settled.
//
// Cost: a whole run a way that has pairs, and one without; what a run costs is rows, joins and settling. Ways without a pair are
// as no short rows. Charts of all tubes are made ahead to know.
#pragma once

#include "knit/mesh/mesh.h"
#include "knit/model/heard.h"
#include "knit/model/settings.h"
#include "knit/run/state.h"

namespace knit {

// What the graph's tubes were found in, by the mesh's vertices.
std::vector<double> field_of(const Input& input, const TubeGraph& graph);

// One way, or the choice at last. Requires that the choice is due.
ShortRowEvent advance_kept_choice(const Input& input, const Parameters& parameters, State& state,
                                  const Heard& heard = {});

}  // namespace knit
