// `--rows auto`: rings where the mesh has them all the way and is one tube, as in the thesis; else contours, which knit any
// shape. Chosen when the levels are known, in a step of its own.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/event.h"
#include "knit/model/products.h"

namespace knit {

// Why no rings; `rings`: there are.
enum class RowsReason : std::uint8_t { rings, field, parts, no_ring, few };

struct RowsChosen {
  static constexpr std::string_view kind = "rows-chosen";
  RowSource source;
  RowsReason reason;
  std::int32_t level;  // parts, no_ring: the first such; else how many rings there are between the ends
  std::int32_t count;  // parts: loops; no_ring: vertices
  VertexId vertex;     // parts: the saddle; no_ring: the level's first
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const RowsChosen&, const RowsChosen&) = default;
};

// Every level but the first and the last, which may be a point, is to be a ring, and three of them at least. Only times that
// run along the axis have rings. Larger meshes than `most_ringed_triangles` are not looked at and have none.
inline constexpr std::size_t most_ringed_triangles = 200000;
RowsChosen choose_rows(const Input& input, const Timing& timing);

using ChoiceEvent = std::variant<RowsChosen>;

}  // namespace knit
