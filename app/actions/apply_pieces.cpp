// Pieces of the pattern: their names and their order.
#include <optional>
#include <string>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/session/document.h"
#include "app/session/planned_pieces.h"
#include "app/session/view.h"
#include "knit/pattern/limb_words.h"

namespace app {

namespace {

std::optional<std::string> fault_of(const SetPieceNames& action) {
  for (const auto& [letters, word] : action.names) {
    if (!is_piece_letter(letters)) return "\"" + letters + "\" is no piece's letter; give a capital one: A.";
    if (!word.empty() && !knit::is_piece_word(word))
      return "A piece cannot be called \"" + word + "\"; give one capitalised word: Tail.";
  }
  return std::nullopt;
}

// Of a run that is not known to its end only what an order says by itself is known.
std::optional<std::string> fault_of(const Session& session, const SetPieceOrder& action) {
  if (action.order.empty()) return std::nullopt;
  if (auto fault = fault_of_order(action.order)) return fault;
  const knit::State& state = session.document->timeline.furthest();
  if (!session.document->timeline.complete() || !knit::limbs_are_known(state)) return std::nullopt;
  if (!knit::has_limbs(state)) return "This pattern is of one piece, so there is nothing to put in order.";
  const PlannedPieces cheapest =
      planned_pieces(state, {session.document->pieces.names, {}}, session.view->pattern);
  return why_not_in_order(state, cheapest, action.order);
}

void change_pieces(Session& session, PatternPieces pieces) {
  Document& document = *session.document;
  if (document.pieces == pieces) return;
  note_other_pieces(document.changes, change_of(document));
  document.pieces = std::move(pieces);
}

}  // namespace

void take(Session& session, const SetPieceNames& action) {
  if (!session.document) return;
  if (auto fault = fault_of(action)) return notify(session, Notice::Kind::error, std::move(*fault));
  PatternPieces pieces = session.document->pieces;
  for (const auto& [letters, word] : action.names) {
    if (word.empty())
      pieces.names.erase(letters);
    else
      pieces.names[letters] = word;
  }
  change_pieces(session, std::move(pieces));
}

void take(Session& session, const SetPieceOrder& action) {
  if (!session.document) return;
  if (auto fault = fault_of(session, action)) return notify(session, Notice::Kind::error, std::move(*fault));
  change_pieces(session, {session.document->pieces.names, action.order});
}

}  // namespace app
