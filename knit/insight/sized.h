// Edges and corners by their size, as the report card's plots count them: from a bar to the things that it counts.
//
// Course edges in stitch widths w, wale edges in stitch heights h, a face's corners in degrees (knit/quality/quality.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knit/insight/why.h"

namespace knit {

enum class Measured : std::uint8_t { course, wale, corner };
// By index: what scripts call them.
inline constexpr std::array<std::string_view, 3> measured_keys{"course", "wale", "corner"};

struct SizeRange {
  Measured of = Measured::wale;
  double from = 0.0, to = std::numeric_limits<double>::infinity();  // from <= size < to
  [[nodiscard]] bool holds(double size) const { return from <= size && size < to; }
  friend bool operator==(const SizeRange&, const SizeRange&) = default;
};

struct SizedThing {
  Element thing;
  std::array<glm::dvec3, 4> points{};  // the ends of an edge, the corners of a face
  std::size_t count = 2;               // of points
  [[nodiscard]] std::span<const glm::dvec3> outline() const { return std::span(points).first(count); }
};

// In knitting order; a face that has several such corners once. Looks at every edge once.
std::vector<SizedThing> things_of_size(const State& state, const StitchSize& stitch, const SizeRange& range);

// "wale edges of 1.5 h and more"
std::string words_of(const SizeRange& range);
// "wale:1.5" and "wale:1.5:2": for scripts. Nothing where it cannot be read.
std::optional<SizeRange> size_range_named(std::string_view text);

}  // namespace knit
