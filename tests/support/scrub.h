// What proves the rewind contract: hashes of a run's states, gone through in every way.
#pragma once

#include <random>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/run.h"

namespace test_support {

inline std::vector<std::uint64_t> hashes_forward(knit::Timeline& timeline) {
  timeline.seek(0);
  std::vector<std::uint64_t> hashes{knit::hash_of(timeline.state())};
  while (timeline.forward()) hashes.push_back(knit::hash_of(timeline.state()));
  return hashes;
}

inline void check_backward(knit::Timeline& timeline, const std::vector<std::uint64_t>& hashes) {
  timeline.seek(timeline.known());
  REQUIRE(timeline.position() + 1 == hashes.size());
  std::size_t wrong = knit::hash_of(timeline.state()) == hashes.back() ? 0 : 1;
  while (timeline.back()) wrong += knit::hash_of(timeline.state()) == hashes[timeline.position()] ? 0U : 1U;
  CHECK(timeline.position() == 0);
  CHECK(wrong == 0);
}

inline void check_at_random(knit::Timeline& timeline, const std::vector<std::uint64_t>& hashes, int visits) {
  std::mt19937 random(20260101);
  std::size_t wrong = 0;
  for (int i = 0; i < visits; ++i) {
    const std::size_t position = random() % hashes.size();
    timeline.seek(position);
    wrong += timeline.position() == position && knit::hash_of(timeline.state()) == hashes[position] ? 0U : 1U;
  }
  CHECK(wrong == 0);
}

// A tuned run must be a fresh one: same steps, same states everywhere.
inline void check_equals_fresh(knit::Timeline& tuned, const knit::Parameters& parameters) {
  knit::Timeline fresh(tuned.input_pointer(), parameters);
  fresh.extend_to_end();
  tuned.extend_to_end();
  REQUIRE(tuned.known() == fresh.known());
  CHECK(tuned.steps() == fresh.steps());
  CHECK((tuned.stop() == nullptr) == (fresh.stop() == nullptr));
  CHECK(hashes_forward(tuned) == hashes_forward(fresh));
}

}  // namespace test_support
