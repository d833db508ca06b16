// The rhythms of a piece: its first count and a list of segments that say how the count goes on, row by row.
//
//   plain(L)        L rows of the same count
//   pre(p, d, q)    q times: p - 1 plain rows, then a row that changes by d
//   post(p, d, q)   q times: a row that changes by d, then p - 1 plain rows
// Read from the other end a pre is a post of -d, so a piece that mirrors is said in the same words both ways.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace knit {

enum class SegmentKind : std::uint8_t { plain, pre, post };

struct RhythmSegment {
  SegmentKind kind = SegmentKind::plain;
  std::int32_t rows = 1;    // of one turn: p, or L
  std::int32_t change = 0;  // stitches, with its sign; plain: 0
  std::int32_t times = 1;
  std::int32_t front = 0;  // of the change, what the front half takes, where the halves are shaped apart
  [[nodiscard]] std::int32_t length() const { return rows * times; }
  [[nodiscard]] auto fields() const { return std::tie(kind, rows, change, times, front); }
  friend bool operator==(const RhythmSegment&, const RhythmSegment&) = default;
};

// What a row is within its segment.
enum class RowRole : std::uint8_t { first, plain, change, rest };

// The counts of all rows, `first` among them.
std::vector<std::int32_t> counts_of(std::int32_t first, std::span<const RhythmSegment> segments);
// The same of the front half.
std::vector<std::int32_t> fronts_of(std::int32_t first, std::span<const RhythmSegment> segments);
std::vector<RowRole> roles_of(std::span<const RhythmSegment> segments);

// The closing half of a piece of `rows` rows whose opening half, its last plain stretch left out, is `opening`: both, with
// what is left between them plain.
std::vector<RhythmSegment> with_mirror(std::vector<RhythmSegment> opening, std::int32_t rows);

// "+8/2x6; +8/3x3; knit 16; -8/3x3'": change / every how many rows x times, ' when the change comes first.
std::string segments_text(std::span<const RhythmSegment> segments);

}  // namespace knit
