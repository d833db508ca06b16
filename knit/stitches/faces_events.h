// What the smallest steps of the stage faces do.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"
#include "knit/model/label.h"
#include "knit/model/products.h"

namespace knit {

struct FaceMade {
  static constexpr std::string_view kind = "face-made";
  std::int32_t index, of;  // in its strip
  Label label;
  std::int32_t corner_count;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const FaceMade&, const FaceMade&) = default;
};

using FacesEvent = std::variant<FaceMade>;

}  // namespace knit
