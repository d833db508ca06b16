// How often a case repeats itself over seeds or axes. The ordinary build goes over all of them. Under the sanitizers, where
// each is ten times as dear and asked only whether memory is misused, a tenth goes through the same code; with
// KNIT_WHOLE set all of them there too (tools/thorough.sh).
#pragma once

#include <cstddef>
#include <cstdlib>

namespace test_support {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

// What is counted over the repetitions is held to its bounds only then.
inline bool whole() { return !sanitized || std::getenv("KNIT_WHOLE") != nullptr; }

// Of `all` repetitions those of this build.
template <class Number>
Number repeated(Number all) {
  return whole() ? all : (all + 9) / 10;
}

// Likewise of thousands that are alike: a tenth in every build, all of them with KNIT_WHOLE.
template <class Number>
Number repeated_deep(Number all) {
  return std::getenv("KNIT_WHOLE") != nullptr ? all : (all + 9) / 10;
}

// Whether this build tries number `i` of a list of real shapes, which are dear: the sanitizers every fourth.
inline bool is_tried(std::size_t i) { return whole() || i % 4 == 0; }

}  // namespace test_support
