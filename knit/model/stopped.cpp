#include "knit/model/stopped.h"

namespace knit {

std::string_view name_of(StopReason reason) {
  switch (reason) {
    case StopReason::no_extent:
      return "no extent";
    case StopReason::no_row_levels:
      return "no row levels";
    case StopReason::not_a_ring:
      return "not a ring";
    case StopReason::splits:
      return "splits";
    case StopReason::stall:
      return "stall";
    case StopReason::changes_too_much:
      return "changes too much";
    case StopReason::too_many_tubes:
      return "too many tubes";
    case StopReason::too_fine:
      return "too fine";
    case StopReason::open_edge:
      return "open edge";
  }
  return "";
}

}  // namespace knit
