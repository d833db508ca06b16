#include "knit/curves/cons_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "knit/base/bits.h"
#include "knit/curves/refused.h"

namespace knit {
namespace {

std::uint32_t word_at(std::string_view bytes, std::uint64_t at) {
  std::uint32_t word = 0;
  for (unsigned i = 0; i < 4; ++i)
    word |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return word;
}

double float_at(std::string_view bytes, std::uint64_t at) {
  const double value = bits_as<float>(word_at(bytes, at));
  if (!std::isfinite(value)) throw CurveRefused("The constraint file has a number that is not finite.");
  return value;
}

struct Chain {
  std::vector<glm::dvec3> points;
  double value = 0.0, radius = 0.0;
};

constexpr std::uint64_t chain_bytes = 12;

std::vector<Chain> read_chains(std::string_view bytes) {
  if (bytes.size() < 4)
    throw CurveRefused("Not a constraint file of autoknit: " + std::to_string(bytes.size()) +
                       " bytes, 8 expected at least.");
  const std::uint64_t points = word_at(bytes, 0);
  const std::uint64_t head = 4 + 12 * points;
  if (head + 4 > bytes.size()) throw CurveRefused("The constraint file ends within its points.");
  const std::uint64_t chains = word_at(bytes, head);
  const std::uint64_t expected = head + 4 + chain_bytes * chains;
  if (bytes.size() != expected)
    throw CurveRefused("Not a constraint file of autoknit: " + std::to_string(bytes.size()) + " bytes, " +
                       std::to_string(expected) + " expected.");
  std::vector<Chain> out;
  std::uint64_t next = 0;
  for (std::uint64_t c = 0; c < chains; ++c) {
    const std::uint64_t at = head + 4 + chain_bytes * c;
    Chain chain{.points = {}, .value = float_at(bytes, at + 4), .radius = float_at(bytes, at + 8)};
    const std::uint64_t count = word_at(bytes, at);
    if (count > points - next)
      throw CurveRefused("The constraint file's chains have more points than it holds.");
    for (const std::uint64_t end = next + count; next < end; ++next) {
      const std::uint64_t from = 4 + 12 * next;
      chain.points.emplace_back(float_at(bytes, from), float_at(bytes, from + 4), float_at(bytes, from + 8));
    }
    out.push_back(std::move(chain));
  }
  if (next != points)
    throw CurveRefused("The constraint file's chains use " + std::to_string(next) + " of its " +
                       std::to_string(points) + " points.");
  return out;
}

// As far as float32 tells.
bool same_place(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(a - b) <= 1e-6 * (glm::length(a) + glm::length(b));
}

Cycle cycle_of(Chain chain, std::size_t number) {
  Cycle cycle;
  const std::size_t count = chain.points.size();
  const bool closed = count > 2 && same_place(chain.points.front(), chain.points.back());
  if (chain.radius > 0.0) {
    cycle.kind = count == 1 ? CycleKind::circle : CycleKind::band;
    cycle.radius = chain.radius;
  } else if (closed) {
    cycle.kind = CycleKind::path;
    chain.points.pop_back();
  } else {
    throw CurveRefused("Chain " + std::to_string(number) +
                       " of the constraint file is open and has no radius, so it goes round nothing.");
  }
  if (count == 0)
    throw CurveRefused("Chain " + std::to_string(number) + " of the constraint file has no points.");
  cycle.points = std::move(chain.points);
  return cycle;
}

std::vector<Cycle> cycles_of(std::vector<Chain> chains) {
  const auto less = [](const Chain& a, const Chain& b) { return a.value < b.value; };
  std::vector<Cycle> cycles;
  if (chains.empty()) return cycles;
  const auto [low, high] = std::minmax_element(chains.begin(), chains.end(), less);
  const double from = low->value;
  const double span = high->value - from;
  for (Chain& chain : chains) {
    const double value = chain.value;
    Cycle cycle = cycle_of(std::move(chain), cycles.size() + 1);
    cycle.as = value == from ? CycleEnd::start : CycleEnd::end;
    cycle.value = span > 0.0 ? (value - from) / span : 0.0;
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

}  // namespace

std::variant<std::vector<Cycle>, std::string> read_cons(std::string_view bytes) {
  try {
    return cycles_of(read_chains(bytes));
  } catch (const CurveRefused& refused) {
    return std::string(refused.what());
  }
}

}  // namespace knit
