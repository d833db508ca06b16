// What the fuzz targets share: a promise that ends the program when it is broken, and values drawn from bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

namespace fuzz {

// What libFuzzer reports as a crash, with its input.
inline void promise(bool kept, std::string_view what) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) { return {data, data + size}; }

// What is owed to whoever gave bad input.
inline void promise_sentence(const std::string& sentence) {
  const bool ends = !sentence.empty() && (sentence.back() == '.' || sentence.back() == '?');
  promise(ends && sentence.find(' ') != std::string::npos, "an error is a sentence: " + sentence);
  promise(sentence.find('\n') == std::string::npos, "an error is one line: " + sentence);
}

// Reads values off the front; zeros once the bytes are used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  [[nodiscard]] bool empty() const { return left_.empty(); }
  unsigned byte() {
    if (left_.empty()) return 0;
    const unsigned value = left_.front();
    left_ = left_.subspan(1);
    return value;
  }
  unsigned below(unsigned count) { return byte() % count; }
  // One of 256 numbers from low to high, the ends among them.
  double between(double low, double high) { return low + (high - low) * byte() / 255.0; }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace fuzz
