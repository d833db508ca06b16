// How the piece comes off the needles and is stuffed [knit/relax], as figures for the report and as OBJ.
//
// What the stage relax made, where it ran; else worked out anew by each call, from the positions that are shown: some tenths
// of a second for three thousand stitches.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/session/session.h"

namespace app {

// Null before the piece is finished.
nlohmann::ordered_json knitted_json(const Session& session);

// OBJ, as the knit mesh; or a stitch mesh [app/yarn/stitch_mesh.h]. Require that nothing is missing.
std::string relaxed_text(const Session& session);
std::string relaxed_smobj(const Session& session);
std::optional<std::string> relaxed_missing(const Session& session);

}  // namespace app
