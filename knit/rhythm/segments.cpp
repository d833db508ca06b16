#include "knit/rhythm/segments.h"

#include <algorithm>

namespace knit {

namespace {

RhythmSegment turned_round(RhythmSegment segment) {
  segment.change = -segment.change;
  segment.front = -segment.front;
  if (segment.kind == SegmentKind::plain || segment.rows == 1) return segment;
  segment.kind = segment.kind == SegmentKind::pre ? SegmentKind::post : SegmentKind::pre;
  return segment;
}

bool changes_at(const RhythmSegment& segment, std::int32_t row_of_turn) {
  if (segment.kind == SegmentKind::plain) return false;
  return row_of_turn == (segment.kind == SegmentKind::pre ? segment.rows - 1 : 0);
}

std::vector<std::int32_t> summed(std::int32_t first, std::span<const RhythmSegment> segments,
                                 std::int32_t RhythmSegment::*change) {
  std::vector<std::int32_t> counts{first};
  for (const RhythmSegment& segment : segments) {
    for (std::int32_t i = 0; i < segment.length(); ++i)
      counts.push_back(counts.back() + (changes_at(segment, i % segment.rows) ? segment.*change : 0));
  }
  return counts;
}

}  // namespace

std::vector<std::int32_t> counts_of(std::int32_t first, std::span<const RhythmSegment> segments) {
  return summed(first, segments, &RhythmSegment::change);
}

std::vector<std::int32_t> fronts_of(std::int32_t first, std::span<const RhythmSegment> segments) {
  return summed(first, segments, &RhythmSegment::front);
}

std::vector<RowRole> roles_of(std::span<const RhythmSegment> segments) {
  std::vector<RowRole> roles{RowRole::first};
  for (const RhythmSegment& segment : segments) {
    const RowRole still = segment.kind == SegmentKind::plain ? RowRole::plain : RowRole::rest;
    for (std::int32_t i = 0; i < segment.length(); ++i)
      roles.push_back(changes_at(segment, i % segment.rows) ? RowRole::change : still);
  }
  return roles;
}

std::vector<RhythmSegment> with_mirror(std::vector<RhythmSegment> opening, std::int32_t rows) {
  if (!opening.empty() && opening.back().kind == SegmentKind::plain) opening.pop_back();
  std::int32_t used = 0;
  for (const RhythmSegment& segment : opening) used += segment.length();
  std::vector<RhythmSegment> all = opening;
  if (const std::int32_t between = rows - 1 - 2 * used; between > 0)
    all.push_back({SegmentKind::plain, between});
  std::reverse(opening.begin(), opening.end());
  for (const RhythmSegment& segment : opening) all.push_back(turned_round(segment));
  return all;
}

std::string segments_text(std::span<const RhythmSegment> segments) {
  std::string text;
  for (const RhythmSegment& segment : segments) {
    if (!text.empty()) text += "; ";
    if (segment.kind == SegmentKind::plain) {
      text += "knit " + std::to_string(segment.rows);
      continue;
    }
    text += (segment.change > 0 ? "+" : "") + std::to_string(segment.change) + "/" +
            std::to_string(segment.rows) + "x" + std::to_string(segment.times);
    if (segment.kind == SegmentKind::post) text += "'";
  }
  return text;
}

}  // namespace knit
