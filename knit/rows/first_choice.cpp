#include "knit/rows/first_choice.h"

#include "knit/model/stitch_size.h"

namespace knit {

Parameters first_parameters(const Input& input) {
  Parameters parameters = default_parameters(input.bounds);
  parameters.timing.kind = TimingKind::by_itself;
  parameters.rows.source = RowSource::by_itself;
  parameters.stitches.placement = PlacementPolicy::by_itself;
  parameters.settle.settling = Settling::by_itself;
  return resolved(parameters, input);
}

}  // namespace knit
