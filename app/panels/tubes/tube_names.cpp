#include "app/panels/tubes/tube_names.h"

#include <algorithm>

#include "knit/model/words.h"

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

std::string short_names(std::vector<knit::TubeId> tubes) {
  std::sort(tubes.begin(), tubes.end());
  std::string words;
  for (std::size_t first = 0, end = 0; first < tubes.size(); first = end) {
    for (end = first + 1; end < tubes.size() && tubes[end] == tubes[end - 1] + 1;) ++end;
    const bool is_pair = end - first == 2;
    if (is_pair) end = first + 1;
    words += (words.empty() ? "" : ", ") + knit::tube_name(tubes[first]);
    if (end - first > 1) words += " to " + knit::tube_name(tubes[end - 1]);
  }
  return words;
}

}  // namespace app
