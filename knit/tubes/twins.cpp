#include "knit/tubes/twins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "knit/model/ties.h"

namespace knit {

namespace {

constexpr double twins_height_off = 0.05;  // shares of the greater
constexpr double twins_girth_off = 0.1;

// At nine shares of the height.
using Girths = std::array<double, 9>;

double girth_at(const TubeProfile& profile, double height) {
  const auto above = std::lower_bound(profile.heights.begin(), profile.heights.end(), height);
  const auto step = std::max<std::ptrdiff_t>(above - profile.heights.begin() - 1, 0);
  return profile.lengths[std::min(static_cast<std::size_t>(step), profile.lengths.size() - 1)];
}

Girths girths_of(const TubeChain& chain, std::span<const TubeProfile> profiles) {
  Girths girths{};
  for (std::size_t i = 0; i < girths.size(); ++i) {
    const double share = static_cast<double>(i + 1) / 10.0;
    const ChainPlace place = place_in(chain, profiles, share * chain.height);
    girths[i] = girth_at(profiles[static_cast<std::size_t>(place.part)], place.height);
  }
  return girths;
}

bool have_like_girths(const Girths& a, const Girths& b) {
  const double longest =
      std::max(*std::max_element(a.begin(), a.end()), *std::max_element(b.begin(), b.end()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (clearly_less(twins_girth_off * longest, std::abs(a[i] - b[i]), longest)) return false;
  }
  return true;
}

bool have_like_ends(const SimpleGraph& graph, const TubeChain& a, const TubeChain& b) {
  const auto kind = [&](std::int32_t node) { return graph.node(node).kind(); };
  const auto rim = [&](std::int32_t node) { return graph.node(node).rim; };
  return kind(a.bottom) == kind(b.bottom) && kind(a.top) == kind(b.top) && rim(a.bottom) == rim(b.bottom) &&
         rim(a.top) == rim(b.top);
}

bool have_like_heights(const TubeChain& a, const TubeChain& b) {
  const double higher = std::max(a.height, b.height);
  return !clearly_less(twins_height_off * higher, std::abs(a.height - b.height), higher);
}

// Of each chain the number of its group: the lowest of its twins.
std::vector<TubeId> group_twins(const SimpleGraph& graph, std::span<const TubeProfile> profiles) {
  const std::size_t count = graph.chains.size();
  std::vector<Girths> girths;
  std::vector<TubeId> group;
  for (const TubeChain& chain : graph.chains) {
    girths.push_back(girths_of(chain, profiles));
    group.push_back(static_cast<TubeId>(group.size()));
  }
  std::vector<std::uint8_t> taken(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const TubeChain& a = graph.chains[i];
      const TubeChain& b = graph.chains[j];
      if (a.rows == 0 || b.rows == 0 || taken[j] != 0 || !have_like_ends(graph, a, b) ||
          !have_like_heights(a, b) || !have_like_girths(girths[i], girths[j]))
        continue;
      group[j] = group[i];
      taken[i] = taken[j] = 1;
    }
  }
  return group;
}

}  // namespace

ChainPlace place_in(const TubeChain& chain, std::span<const TubeProfile> profiles, double height) {
  for (const std::int32_t part : chain.parts) {
    const double whole = profiles[static_cast<std::size_t>(part)].height();
    if (height <= whole || part == chain.parts.back()) return {part, height};
    height -= whole;
  }
  return {};
}

std::vector<std::vector<TubeId>> match_twins(SimpleGraph& graph, std::span<const TubeProfile> profiles,
                                             double stitch_height) {
  const std::vector<TubeId> group = group_twins(graph, profiles);
  std::vector<std::vector<TubeId>> members(graph.chains.size());
  for (std::size_t i = 0; i < group.size(); ++i)
    members[static_cast<std::size_t>(group[i])].push_back(static_cast<TubeId>(i));
  std::vector<std::vector<TubeId>> twins;
  twins.reserve(group.size());
  for (const TubeId first : group) twins.push_back(members[static_cast<std::size_t>(first)]);
  for (const std::vector<TubeId>& alike : members) {
    if (alike.size() < 2) continue;
    double height = 0.0;
    for (const TubeId id : alike) height += graph.chain(id).height / static_cast<double>(alike.size());
    const TubeChain& first = graph.chain(alike.front());
    const RowOffsets offsets = row_offsets(graph.node(first.bottom), graph.node(first.top));
    const std::int32_t rows = std::max(rows_that_fit(height, offsets, stitch_height), 1);
    for (const TubeId id : alike) graph.chains[static_cast<std::size_t>(id)].rows = rows;
  }
  return twins;
}

}  // namespace knit
