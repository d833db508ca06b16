// Rounds of a rhythm, made without the program's planner: every shaping round one repeat, its sections alike.
#pragma once

#include <cstdint>
#include <vector>

#include "knit/pattern/rounds.h"

namespace test_support {

enum class SectionStyle { lines, pairs };

// Of `stitches` in a section: one or two more, or one or two fewer, beside the marker.
inline std::vector<knit::Hand> shaped_section(std::int32_t stitches, bool grows, SectionStyle style) {
  using knit::Hand;
  std::vector<Hand> section;
  const auto knit = [&](std::int32_t count) {
    section.insert(section.end(), static_cast<std::size_t>(count), Hand::knit);
  };
  const bool pairs = style == SectionStyle::pairs;
  if (grows) {
    knit(pairs ? 1 : stitches);
    section.push_back(Hand::m1l);
    if (pairs) {
      knit(stitches - 1);
      section.push_back(Hand::m1r);
    }
    return section;
  }
  if (pairs && stitches == 4) return {Hand::ssk, Hand::k2tog};
  if (pairs) {
    knit(1);
    section.push_back(Hand::ssk);
  }
  knit(stitches - (pairs ? 5 : 2));
  section.push_back(Hand::k2tog);
  return section;
}

class RhythmRounds {
 public:
  RhythmRounds(std::int32_t sections, std::int32_t cast_on, SectionStyle style)
      : sections_(sections), style_(style) {
    rounds_.cast_on = cast_on;
  }
  RhythmRounds& plain(int rounds) {
    for (int i = 0; i < rounds; ++i)
      add(std::vector<knit::Hand>(static_cast<std::size_t>(rounds_.last_count() / sections_),
                                  knit::Hand::knit));
    return *this;
  }
  RhythmRounds& shape(bool grows) {
    add(shaped_section(rounds_.last_count() / sections_, grows, style_));
    return *this;
  }
  // `rest` plain rounds and then a change, or the change first, so many times.
  RhythmRounds& grow(int rest, int times) {
    for (int i = 0; i < times; ++i) plain(rest).shape(true);
    return *this;
  }
  RhythmRounds& shrink(int rest, int times) {
    for (int i = 0; i < times; ++i) shape(false).plain(rest);
    return *this;
  }
  [[nodiscard]] const knit::Rounds& rounds() const { return rounds_; }

 private:
  void add(const std::vector<knit::Hand>& section) {
    knit::Round round;
    round.number = static_cast<std::int32_t>(rounds_.rounds.size()) + 2;
    round.before = rounds_.last_count();
    for (std::int32_t i = 0; i < sections_; ++i) {
      for (const knit::Hand hand : section) round.operations.push_back({hand, false});
    }
    round.after = static_cast<std::int32_t>(round.operations.size());
    rounds_.rounds.push_back(std::move(round));
  }

  knit::Rounds rounds_;
  std::int32_t sections_;
  SectionStyle style_;
};

}  // namespace test_support
