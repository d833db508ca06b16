#include "knit/stitches/faces_stage.h"

#include "knit/stitches/faces.h"

namespace knit {

Advanced<FacesEvent> advance_faces(const StripAt& at, FacesWork& work, Shared<Strip>& strip) {
  if (!work.plan) {
    work.plan = Shared(build_strip(at.fabric, at.join));
  }
  const Strip& plan = *work.plan;
  const Face& face = plan.faces[static_cast<std::size_t>(work.made)];
  const FaceMade step{work.made + 1, static_cast<std::int32_t>(plan.faces.size()), face.label,
                      face.corner_count};
  ++work.made;
  if (step.index < step.of) return step;
  strip = work.plan;
  work = FacesWork{};
  return {step, at.last ? Ended::stage : Ended::row};
}

}  // namespace knit
