// Stage 5, faces, one smallest step at a time.
#pragma once

#include <cstdint>
#include <tuple>

#include "knit/fabric/fabric.h"
#include "knit/model/event.h"
#include "knit/model/products.h"
#include "knit/stitches/faces_events.h"

namespace knit {

struct FacesWork {
  Shared<Strip> plan;
  std::int32_t made = 0;  // of plan->faces
  [[nodiscard]] auto fields() const { return std::tie(plan, made); }
  friend bool operator==(const FacesWork&, const FacesWork&) = default;
};

// Where faces are made.
struct StripAt {
  const Fabric& fabric;
  const Join& join;
  bool last;  // no strip follows
};
// `strip`: the product, once it has ended; then `work` is that of the next one.
Advanced<FacesEvent> advance_faces(const StripAt& at, FacesWork& work, Shared<Strip>& strip);

}  // namespace knit
