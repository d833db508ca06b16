#include "knit/relax/relax_stage.h"

namespace knit {

namespace {

constexpr std::int32_t keyframe_every = 16;

RelaxDone told_of(const KnittedPiece& piece) {
  const KnittedFigures& made = piece.figures;
  return {piece.relaxed.iterations,
          piece.relaxed.settled,
          static_cast<float>(made.knitted.height),
          static_cast<float>(made.knitted.width),
          static_cast<float>(made.placed.height),
          static_cast<float>(made.placed.width),
          static_cast<float>(made.sunk[0]),
          static_cast<float>(made.sunk[1])};
}

}  // namespace

Advanced<RelaxEvent> advance_relax(const RelaxAt& at, const RelaxSettings& settings, RelaxWork& work,
                                   std::optional<KnittedPiece>& piece, const Heard& heard) {
  if (!work.plan) {
    begin_relaxing(at.fabric, at.stitch, settings, work, heard);
    const RelaxPlan& plan = *work.plan;
    return RelaxPlanned{static_cast<std::int32_t>(plan.net.stitches),
                        static_cast<std::int32_t>(plan.net.springs.size()),
                        static_cast<std::int32_t>(plan.lidded.size()),
                        static_cast<float>(settings.stuffing),
                        plan.pressure,
                        plan.radius};
  }
  if (!work.done) {
    const RelaxIteration told = advance_relaxing(settings, work, heard);
    return StitchesRelaxed{
        told.iteration, told.touching, told.restarted, work.done, static_cast<float>(told.greatest_move),
        told.volume};
  }
  KnittedPiece made{finish_relaxing(work), {}};
  made.figures = knitted_figures(at.fabric, *work.plan, made.relaxed, at.along);
  const RelaxDone told = told_of(made);
  piece = std::move(made);
  return {told, Ended::stage};
}

bool swelled_without_bound(std::int32_t iterations, bool came_to_rest, const RelaxSettings& settings) {
  return !came_to_rest && iterations < settings.most_iterations;
}

bool relaxing_sweeps(const RelaxWork& work) {
  return !work.plan || work.done || work.iteration % keyframe_every == keyframe_every - 1;
}

bool next_factors(const RelaxWork& work) {
  return !work.plan || (!work.done && finds_touching(work.iteration + 1));
}

}  // namespace knit
