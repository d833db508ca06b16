#include "app/session/row_table.h"

#include <glm/geometric.hpp>

#include "app/session/document.h"
#include "app/session/pins.h"
#include "knit/model/words.h"

namespace app {

RowFacts facts_of_row(const knit::Row& row, double stitch_width) {
  RowFacts facts;
  facts.stitches = knit::size_of(row);
  if (!row.on.empty()) facts.change = facts.stitches - row.on.size();
  facts.tube = knit::tube_name(row.tube);
  const knit::Edges edges = knit::edges_of(row);
  if (stitch_width <= 0.0 || edges.size() == 0) return facts;
  double length = 0.0;
  for (const auto& [from, to] : edges)
    length += glm::distance(row.stitches[from].position, row.stitches[to].position);
  facts.course = length / (static_cast<double>(edges.size()) * stitch_width);
  const knit::Ring* const ring = row.ring.pointer().get();  // the row keeps it
  facts.holds = (ring != nullptr ? ring->length : length) / stitch_width;
  return facts;
}

std::size_t stitches_so_far(const knit::State& state) {
  if (const auto* work = std::get_if<knit::RowWork>(&state.work)) {
    if (!work->closed.stitches.empty()) return work->closed.stitches.size();
    const bool begun = work->phase != knit::RowPhase::gather && work->phase != knit::RowPhase::order;
    return begun ? work->walk.kept.size() + 1 : 0;
  }
  if (const auto* work = std::get_if<knit::CastOnWork>(&state.work)) return work->stitches.size();
  const auto* work = std::get_if<knit::ContourWork>(&state.work);
  return work != nullptr ? work->stitches.size() : 0;
}

std::optional<std::int32_t> pinned_stitches(const Session& session, std::int32_t row) {
  if (!session.document || !session.document->pinned) return std::nullopt;
  const Pin& pin = *session.document->pinned;
  const knit::Row* found = pin.known ? pin.end.fabric.find_row(row) : nullptr;
  if (found == nullptr) return std::nullopt;
  return knit::size_of(*found);
}

std::string rows_csv(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const bool pinned = session.document->pinned.has_value();
  std::string text = std::string("row,tube,stitches,change,holds,course") + (pinned ? ",pinned" : "") + "\n";
  for (const auto& row : timeline.furthest().fabric.rows()) {
    const RowFacts facts = facts_of_row(*row, timeline.parameters().stitch.width);
    text += std::to_string(row->id) + "," + facts.tube + "," + std::to_string(facts.stitches) + "," +
            (facts.change ? std::to_string(*facts.change) : "") + "," + knit::number_text(facts.holds) + "," +
            knit::number_text(facts.course);
    if (pinned) {
      const auto beside = pinned_stitches(session, row->id);
      text += "," + (beside ? std::to_string(*beside) : "");
    }
    text += "\n";
  }
  return text;
}

}  // namespace app
