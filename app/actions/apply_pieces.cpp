// Pieces of the pattern: their names, their order, and whose chart is shown.
#include <algorithm>
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

// Whether there is such a piece only a run that is known to its end can tell.
std::optional<std::string> fault_of_chart(const Session& session, const std::string& letters) {
  if (letters.empty()) return std::nullopt;
  if (!is_piece_letter(letters)) return "\"" + letters + "\" is no piece's letter; give a capital one: A.";
  if (!session.document || !session.document->timeline.complete()) return std::nullopt;
  const knit::State& state = session.document->timeline.furthest();
  if (!knit::has_limbs(state)) return "This pattern is of one piece, with one chart.";
  if (!knit::limbs_are_known(state)) return std::nullopt;
  const PlannedPieces planned = planned_pieces(state, session.document->pieces, session.view->pattern);
  if (std::count(planned.letters.begin(), planned.letters.end(), letters) > 0) return std::nullopt;
  return "There is no piece " + letters + "; the last of them is " +
         *std::max_element(
             planned.letters.begin(), planned.letters.end(),
             [](const auto& a, const auto& b) { return std::pair(a.size(), a) < std::pair(b.size(), b); }) +
         ".";
}

void change_pieces(Session& session, PatternPieces pieces) {
  Document& document = *session.document;
  if (document.pieces == pieces) return;
  note_other_change(document.changes, change_of(document));
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

void take(Session& session, const ShowCentre& action) {
  session.view->centre = action.centre;
  if (!action.piece) return;
  if (auto fault = fault_of_chart(session, *action.piece))
    return notify(session, Notice::Kind::error, std::move(*fault));
  session.view->gaze.chart_piece = *action.piece;
}

}  // namespace app
