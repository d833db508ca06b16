// What a finished run did not do as asked, for the list of problems, the report, the card and the pattern: one source.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/planned_pieces.h"
#include "app/session/session.h"
#include "knit/insight/as_asked.h"
#include "knit/pattern/written_pattern.h"
#include "knit/rhythm/tube_rhythm.h"
#include "knit/run/timeline.h"

namespace app {

// As the pattern's counts make it, of a finished run.
knit::PieceSize size_knitted(const knit::State& state, const knit::Gauge& gauge);

// Size and swatch first, then what comes off the needles, where the stage relax ran, then what `coverage` shows; null: not measured. Empty before the run has finished.
std::vector<knit::Remark> remarks_of(const knit::Timeline& timeline, const knit::Coverage* coverage);

// What the list of problems tells besides them, in its order: what was repaired in the mesh, findings on it, and remarks on the
// piece once it is measured.
struct ListedRemark {
  std::string words;                   // "Mesh: ...", "Piece: ..."
  std::optional<knit::Element> thing;  // where it is
};
std::optional<knit::Element> thing_of(const knit::Remark& remark);
// Requires something open.
std::vector<ListedRemark> listed_remarks(const Session& session);

// For the pattern's notes: the first of each kind.
std::vector<std::string> notes_of(const std::vector<knit::Remark>& remarks);
// All that the pattern's notes say of how the run came out: its rhythm, then what is not as asked. Of a pattern in pieces
// (`pieces`) each rhythm in one sentence, with all pieces that have it: "Rhythm of Limb A and Limb B: ..."
std::vector<std::string> pattern_notes(const knit::Timeline& timeline, const knit::Coverage* coverage,
                                       const PlannedPieces* pieces = nullptr);
// Writes these into the pattern. Where the stage relax ran, the piece's size is the one that it gives, and no other.
void say_how_it_came_out(knit::WrittenPattern& pattern, const knit::Timeline& timeline,
                         const knit::Coverage* coverage, const PlannedPieces* pieces = nullptr);

// The rhythm that the rows of the one tube have from its `from` on; null: none was planned, it was given up on the way, or there are
// several tubes.
const knit::TubeRhythm* rhythm_of_run(const knit::State& state);
// That of each tube, in their order, where its rows are as planned; one may have none, and say why.
std::vector<const knit::TubeRhythm*> rhythms_of_run(const knit::State& state);
// In sentences (knit/rhythm/rhythm_words.h), at the gauge.
std::vector<std::string> rhythm_sentences_of(const knit::State& state, const knit::TubeRhythm& rhythm,
                                             const knit::Gauge& gauge);
std::vector<std::string> rhythm_sentences_of(const knit::State& state, const knit::Gauge& gauge);
// The options with the form decided: short where the rounds are in a rhythm and nobody said otherwise.
knit::PatternOptions in_form(knit::PatternOptions options, const knit::State& state);

}  // namespace app
