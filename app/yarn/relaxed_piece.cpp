#include "app/yarn/relaxed_piece.h"

#include "app/session/document.h"
#include "app/session/shown.h"
#include "knit/model/stitch_size.h"

namespace app {

knit::Shared<knit::KnittedPiece> relaxed_piece(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  if (timeline.state().relaxed) return timeline.state().relaxed;
  const knit::Parameters& parameters = timeline.parameters();
  const knit::Fabric fabric = shown_fabric(session);
  knit::RelaxWork work;
  knit::begin_relaxing(fabric, parameters.stitch, parameters.relax, work);
  while (!work.done) knit::advance_relaxing(parameters.relax, work);
  knit::KnittedPiece piece{knit::finish_relaxing(work), {}};
  piece.figures = knit::knitted_figures(fabric, *work.plan, piece.relaxed,
                                        knit::knitting_direction(parameters.timing, timeline.input().mesh));
  return knit::Shared(std::move(piece));
}

knit::Fabric relaxed_fabric(const Session& session) {
  return session.document->timeline.state().fabric.moved_to(relaxed_piece(session)->relaxed.positions);
}

}  // namespace app
