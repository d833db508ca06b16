#include "app/panels/step/candidate_list.h"

#include <algorithm>
#include <numeric>

namespace app {

bool CandidateList::refresh(const knit::Timeline& timeline, std::int32_t row) {
  const knit::StepRange steps = knit::steps_of_row(timeline, knit::stage_of_row(row), row);
  Key key{knit::ring_of_row(timeline.furthest(), row), row, steps.begin, steps.end,
          steps.begin < steps.end ? timeline.parameters_of_step(steps.end - 1) : knit::Parameters{}};
  if (key == key_) return false;
  key_ = std::move(key);
  table_ = knit::candidates_of(timeline, row);
  stitches_.assign(table_.candidates.size(), 0);
  std::int32_t kept = 0;
  for (const knit::Candidate& candidate : table_.candidates) {
    if (candidate.verdict <= knit::CandidateVerdict::taken)
      stitches_.at(static_cast<std::size_t>(candidate.order)) = ++kept;
  }
  sort();
  return true;
}

void CandidateList::sort_by(CandidateColumn column, bool falling) {
  if (column == column_ && falling == falling_) return;
  column_ = column;
  falling_ = falling;
  sort();
}

void CandidateList::sort() {
  lines_.resize(table_.candidates.size());
  std::iota(lines_.begin(), lines_.end(), std::size_t{0});
  const auto before = [&](std::size_t a, std::size_t b) {
    const knit::Candidate& x = table_.candidates[falling_ ? b : a];
    const knit::Candidate& y = table_.candidates[falling_ ? a : b];
    switch (column_) {
      case CandidateColumn::order:
        return x.order < y.order;
      case CandidateColumn::vertex:
        return x.vertex < y.vertex;
      case CandidateColumn::distance:
        return x.distance < y.distance;
      case CandidateColumn::stitch:
        return stitch_of(x.order) < stitch_of(y.order);
      case CandidateColumn::verdict:
        break;
    }
    return x.verdict < y.verdict;
  };
  std::stable_sort(lines_.begin(), lines_.end(), before);
}

std::size_t CandidateList::line_of(std::int32_t order) const {
  const auto at = std::find(lines_.begin(), lines_.end(), static_cast<std::size_t>(order));
  return static_cast<std::size_t>(at - lines_.begin());
}

std::optional<std::int32_t> CandidateList::order_of(const knit::Timeline& timeline,
                                                    const knit::Element& thing) const {
  knit::VertexId vertex = knit::no_vertex;
  if (const auto* v = std::get_if<knit::VertexElement>(&thing)) vertex = v->vertex;
  const auto* stitch = std::get_if<knit::StitchElement>(&thing);
  if (stitch != nullptr && stitch->row != table_.row) return std::nullopt;
  std::int32_t chosen = 0;
  const auto& twin = timeline.input().twin;
  for (const knit::Candidate& candidate : table_.candidates) {
    const bool kept = candidate.verdict <= knit::CandidateVerdict::taken;
    if (stitch != nullptr && kept && chosen++ == stitch->stitch) return candidate.order;
    if (vertex < twin.size() && twin[candidate.vertex] == twin[vertex]) return candidate.order;
  }
  return std::nullopt;
}

}  // namespace app
