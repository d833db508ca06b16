#include "app/session/at.h"

#include <cstdint>
#include <limits>

#include "app/base/text.h"
#include "app/session/document.h"

namespace app {

std::optional<At> parse_at(const std::string& text) {
  if (text == "end") return AtEnd{};
  if (const auto steps = whole_number<std::size_t>(text)) return At(*steps);
  const auto parts = split(text, ':');
  const auto stage = knit::stage_named(parts[0]);
  if (!stage || parts.size() > 3) return std::nullopt;
  if (parts.size() == 1) return AtStage{*stage};
  knit::Place place{*stage, 0, 0};
  const auto row = whole_number<std::int32_t>(parts[1]);
  const auto item = parts.size() == 3 ? whole_number<std::int32_t>(parts[2]) : std::optional<std::int32_t>(1);
  if (!row || !item || *row < 0 || *item < 1) return std::nullopt;
  place.row = *row;
  place.item = *item - 1;
  return place;
}

std::string text_of(const knit::Place& place) {
  return std::string(knit::name_of(place.stage)) + ":" + std::to_string(place.row) + ":" +
         std::to_string(std::int64_t{place.item} +
                        (place.item < std::numeric_limits<std::int32_t>::max() ? 1 : 0));
}

}  // namespace app
