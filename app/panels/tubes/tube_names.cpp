#include "app/panels/tubes/tube_names.h"

#include <algorithm>

namespace app {

namespace {

bool meet(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool lies_within(const Box& box, const Box& ground) {
  return box.x >= ground.x && box.right() <= ground.right() && box.y >= ground.y &&
         box.bottom() <= ground.bottom();
}

}  // namespace

std::vector<std::optional<Box>> place_names(const std::vector<std::vector<Box>>& names,
                                            std::vector<Box> taken, const Box& ground) {
  std::vector<std::optional<Box>> placed;
  placed.reserve(names.size());
  for (const std::vector<Box>& places : names) {
    const auto free = std::find_if(places.begin(), places.end(), [&](const Box& place) {
      return lies_within(place, ground) &&
             std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return meet(place, other); });
    });
    placed.push_back(free == places.end() ? std::nullopt : std::optional(*free));
    if (placed.back()) taken.push_back(*placed.back());
  }
  return placed;
}

}  // namespace app
