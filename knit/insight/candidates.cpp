#include "knit/insight/candidates.h"

#include "knit/insight/why.h"

namespace knit {

namespace {

NoCandidates why_none(const State& run, std::int32_t row) {
  const bool in_making = run.stage() <= Stage::rows && row == run.fabric.next_row();
  if (!run.fabric.has_row(row) && !in_making) return NoCandidates::no_row;
  const Row* first = run.fabric.find_row(1);
  const bool by_cuts = first != nullptr ? first->ring->ordered_by == OrderedBy::cut
                                        : std::holds_alternative<ContourWork>(run.work);
  if (by_cuts) return NoCandidates::cut;
  return row == 1 ? NoCandidates::cast_on : NoCandidates::not_yet;
}

CandidateVerdict verdict_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::too_near:
      return CandidateVerdict::too_near;
    case Verdict::accepted:
      return CandidateVerdict::accepted;
    case Verdict::too_far:
      break;
  }
  return CandidateVerdict::too_far;
}

// Enters what one step of the row says; `anchor`: the order of the anchor before the step.
void enter(const Step& step, std::size_t index, std::int32_t anchor, std::vector<Candidate>& candidates) {
  if (const auto* s = get_if<CandidateMeasured>(step)) {
    Candidate& candidate = candidates[static_cast<std::size_t>(s->candidate_order)];
    const bool itself = s->candidate_order == 0 && s->anchor_order == 0;
    candidate.anchor_order = s->anchor_order;
    candidate.stitch = s->stitch;
    candidate.distance = s->distance;
    candidate.verdict = itself ? CandidateVerdict::first : verdict_of(s->verdict);
    candidate.step = index;
  } else if (const auto* missed = get_if<BandMissed>(step)) {
    Candidate& candidate = candidates[static_cast<std::size_t>(missed->taken_order)];
    candidate.anchor_order = anchor;
    candidate.stitch = missed->stitch;
    candidate.distance = missed->distance;
    candidate.verdict = CandidateVerdict::taken;
    candidate.step = index;
  }
}

}  // namespace

std::string_view name_of(CandidateVerdict verdict) {
  switch (verdict) {
    case CandidateVerdict::first:
      return "first";
    case CandidateVerdict::accepted:
      return "accepted";
    case CandidateVerdict::taken:
      return "taken";
    case CandidateVerdict::too_near:
      return "too near";
    case CandidateVerdict::too_far:
      return "too far";
    case CandidateVerdict::never_reached:
      break;
  }
  return "never reached";
}

CandidateTable candidates_of(const Timeline& timeline, std::int32_t row) {
  CandidateTable table;
  table.row = row;
  const auto ring = ring_of_row(timeline.furthest(), row);
  table.none = ring ? NoCandidates::has_some : why_none(timeline.furthest(), row);
  if (!ring) return table;
  table.candidates.resize(ring->vertices.size());
  for (std::size_t i = 0; i < table.candidates.size(); ++i) {
    table.candidates[i].order = static_cast<std::int32_t>(i);
    table.candidates[i].vertex = ring->vertices[i];
  }
  const StepRange steps = steps_of_row(timeline, Stage::rows, row);
  if (steps.begin == steps.end) return table;
  std::int32_t anchor = 0;
  for (std::size_t i = steps.begin; i < steps.end; ++i) {
    const Step& step = timeline.step(i);
    enter(step, i, anchor, table.candidates);
    if (const auto* s = get_if<CandidateMeasured>(step)) {
      anchor = s->verdict == Verdict::accepted ? s->candidate_order : s->anchor_order;
    } else if (const auto* missed = get_if<BandMissed>(step)) {
      anchor = missed->taken_order;
    }
  }
  const Parameters& parameters = timeline.parameters_of_step(steps.end - 1);
  table.band = band_of(parameters.rows, parameters.stitch);
  table.stitch_width = parameters.stitch.width;
  return table;
}

}  // namespace knit
