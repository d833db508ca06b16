// The piece as it comes off the needles and is stuffed [knit/relax], whether the run has that stage or not.
//
// What the stage relax made, where it ran; else worked out anew by each call, from the positions that are shown: some tenths
// of a second for three thousand stitches. Require that the piece is finished.
#pragma once

#include "app/session/session.h"
#include "knit/fabric/fabric.h"
#include "knit/model/shared.h"
#include "knit/relax/knitted.h"

namespace app {

knit::Shared<knit::KnittedPiece> relaxed_piece(const Session& session);

// With its stitches where they come to lie.
knit::Fabric relaxed_fabric(const Session& session);

}  // namespace app
