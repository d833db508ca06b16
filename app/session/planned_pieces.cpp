#include "app/session/planned_pieces.h"

#include <algorithm>
#include <cstdlib>

#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/order/limb_runs.h"
#include "knit/order/limb_tubes.h"
#include "knit/pattern/limb_words.h"

namespace app {

namespace {

std::vector<knit::TubeId> tubes_of(const knit::LimbPlan& plan) {
  std::vector<knit::TubeId> tubes;
  for (const knit::LimbPiece& piece : plan.pieces) tubes.push_back(piece.tube);
  return tubes;
}

std::optional<std::size_t> place_of(const std::vector<std::string>& letters, const std::string& wanted) {
  const auto at = std::find(letters.begin(), letters.end(), wanted);
  if (at == letters.end()) return std::nullopt;
  return static_cast<std::size_t>(at - letters.begin());
}

// Empty where the letters are not those of the pieces, each once.
std::vector<knit::TubeId> tubes_in_order(const PlannedPieces& planned,
                                         const std::vector<std::string>& order) {
  std::vector<knit::TubeId> tubes;
  if (fault_of_order(order) || order.size() != planned.letters.size()) return tubes;
  for (const std::string& letters : order) {
    const auto piece = place_of(planned.letters, letters);
    if (!piece) return {};
    tubes.push_back(planned.plan.pieces[*piece].tube);
  }
  return tubes;
}

void find_what_stands_on_what(const knit::State& state, PlannedPieces& planned) {
  const knit::LimbTubes tubes(state.fabric, state.tubes.pointer().get());
  const std::vector<knit::TubeId> ids = tubes_of(planned.plan);
  const auto piece_of = [&](std::int32_t tube) {
    return static_cast<std::int32_t>(std::find(ids.begin(), ids.end(), tubes.tube(tube).id) - ids.begin());
  };
  planned.stands_on.assign(ids.size(), {});
  for (std::int32_t tube = 0; tube < tubes.count(); ++tube) {
    if (!tubes.tube(tube).has_rows()) continue;
    for (const std::int32_t below : knit::tubes_below(tubes, tube))
      planned.stands_on[static_cast<std::size_t>(piece_of(tube))].push_back(piece_of(below));
  }
}

std::string more_or_fewer(std::int32_t difference, const char* one, const char* many) {
  return knit::plural(std::abs(difference), one, many) + (difference > 0 ? " more" : " fewer");
}

}  // namespace

std::string PlannedPieces::name_of(std::int32_t piece) const { return knit::LimbNames(plan, options)(piece); }

void name_pieces(PlannedPieces& planned, const PatternPieces& pieces, const knit::PatternOptions& options) {
  planned.options = options;
  planned.options.piece_names.clear();
  for (std::size_t i = 0; i < planned.letters.size(); ++i) {
    const auto given = pieces.names.find(planned.letters[i]);
    if (given != pieces.names.end())
      planned.options.piece_names[knit::tube_name(static_cast<std::int32_t>(i))] = given->second;
  }
}

PlannedPieces planned_pieces(const knit::State& state, const PatternPieces& pieces,
                             const knit::PatternOptions& options, knit::GraftBy graft) {
  const bool three_needle = graft == knit::GraftBy::three_needle;
  PlannedPieces planned;
  planned.plan = knit::plan_limbs(state, {true, {}, three_needle});
  planned.cheapest_yarns = planned.plan.yarns;
  planned.cheapest_held = planned.plan.held_most;
  for (std::int32_t i = 0; i < planned.plan.count(); ++i) planned.letters.push_back(knit::tube_name(i));
  find_what_stands_on_what(state, planned);
  name_pieces(planned, pieces, options);
  if (pieces.order.empty() || pieces.order == planned.letters) return planned;
  if (auto why = why_not_in_order(state, planned, pieces.order)) {
    planned.refused = std::move(*why);
    return planned;
  }
  planned.plan = knit::plan_limbs(state, {true, tubes_in_order(planned, pieces.order), three_needle});
  planned.letters = pieces.order;
  planned.chosen = true;
  find_what_stands_on_what(state, planned);
  name_pieces(planned, pieces, options);
  return planned;
}

PlannedPieces planned_pieces(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  return planned_pieces(timeline.state(), session.document->pieces, session.view->pattern,
                        timeline.parameters().pattern.graft);
}

std::optional<std::string> why_not_in_order(const PlannedPieces& planned,
                                            const std::vector<std::string>& order) {
  if (auto fault = fault_of_order(order)) return fault;
  if (tubes_in_order(planned, order).empty()) {
    return "The order must name each of the " + knit::plural(planned.plan.count(), "piece", "pieces") +
           " A to " + knit::tube_name(planned.plan.count() - 1) + " once.";
  }
  for (std::size_t i = 0; i < planned.letters.size(); ++i) {
    for (const std::int32_t below : planned.stands_on[i]) {
      if (*place_of(order, planned.letters[i]) >
          *place_of(order, planned.letters[static_cast<std::size_t>(below)]))
        continue;
      return planned.name_of(static_cast<std::int32_t>(i)) + " is worked on the stitches of " +
             planned.name_of(below) + ", so that one must come first.";
    }
  }
  return std::nullopt;
}

std::optional<std::string> why_not_in_order(const knit::State& state, const PlannedPieces& planned,
                                            const std::vector<std::string>& order) {
  if (auto why = why_not_in_order(planned, order)) return why;
  if (knit::cost_of_order(state, tubes_in_order(planned, order))) return std::nullopt;
  return "In this order a stretch that is to be held would lie about the beginning of a round; choose "
         "another.";
}

std::string order_price(const PlannedPieces& planned) {
  const std::int32_t yarns = planned.plan.yarns - planned.cheapest_yarns;
  const std::int32_t holders = planned.plan.held_most - planned.cheapest_held;
  if (yarns == 0 && holders == 0) return "As many yarns and holders as the cheapest order.";
  std::string words;
  if (yarns > 0 && holders > 0) {
    words = knit::plural(yarns, "yarn", "yarns") + " and " + more_or_fewer(holders, "holder", "holders");
  } else {
    if (yarns != 0) words = more_or_fewer(yarns, "yarn", "yarns");
    if (holders != 0) words += (words.empty() ? "" : " and ") + more_or_fewer(holders, "holder", "holders");
  }
  return words + " than the cheapest order.";
}

}  // namespace app
