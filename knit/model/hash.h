// Content hashes of plain values: what the scrub tests compare. Not cryptographic; the same bits on every
// run.
//
// A struct takes part by offering `auto fields() const { return std::tie(...); }`.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "knit/base/bits.h"

namespace knit {

class Hasher {
 public:
  void add(std::uint64_t word) {
    state_ ^= word;
    state_ *= 0x9fb21c651e98df25ULL;
    state_ ^= state_ >> 32;
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x6b6e69746d657368ULL;
};

template <class T>
concept HasFields = requires(const T& value) {
  value.fields();
};
template <class T>
concept HasContentHash = requires(const T& value) {
  value.content_hash();
};

template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
void hash_into(Hasher& hasher, T value);
template <HasFields T>
void hash_into(Hasher& hasher, const T& value);
template <HasContentHash T>
void hash_into(Hasher& hasher, const T& value);
inline void hash_into(Hasher& hasher, const glm::dvec3& value);
inline void hash_into(Hasher& hasher, std::string_view text);
template <class T>
void hash_into(Hasher& hasher, const std::vector<T>& values);
template <class T, std::size_t N>
void hash_into(Hasher& hasher, const std::array<T, N>& values);
template <class T>
void hash_into(Hasher& hasher, const std::optional<T>& value);
template <class... T>
void hash_into(Hasher& hasher, const std::variant<T...>& value);

template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
void hash_into(Hasher& hasher, T value) {
  if constexpr (std::is_floating_point_v<T>) {
    hasher.add(bits_as<std::uint64_t>(static_cast<double>(value)));
  } else {
    hasher.add(static_cast<std::uint64_t>(value));
  }
}

template <HasFields T>
void hash_into(Hasher& hasher, const T& value) {
  std::apply([&](const auto&... field) { (hash_into(hasher, field), ...); }, value.fields());
}

template <HasContentHash T>
void hash_into(Hasher& hasher, const T& value) {
  hasher.add(value.content_hash());
}

inline void hash_into(Hasher& hasher, const glm::dvec3& value) {
  hash_into(hasher, value.x);
  hash_into(hasher, value.y);
  hash_into(hasher, value.z);
}

inline void hash_into(Hasher& hasher, std::string_view text) {
  hasher.add(text.size());
  for (const char c : text) hasher.add(static_cast<unsigned char>(c));
}

// In four lanes, which a processor goes through side by side: a lane waits for its own last word at each.
template <class T>
void hash_into(Hasher& hasher, const std::vector<T>& values) {
  constexpr std::size_t lanes = 4, few = 4 * lanes;
  hasher.add(values.size());
  std::size_t i = 0;
  if (values.size() >= few) {
    std::array<Hasher, lanes> lane;
    for (; i + lanes <= values.size(); i += lanes) {
      hash_into(lane[0], values[i]);
      hash_into(lane[1], values[i + 1]);
      hash_into(lane[2], values[i + 2]);
      hash_into(lane[3], values[i + 3]);
    }
    for (const Hasher& each : lane) hasher.add(each.value());
  }
  for (; i < values.size(); ++i) hash_into(hasher, values[i]);
}

template <class T, std::size_t N>
void hash_into(Hasher& hasher, const std::array<T, N>& values) {
  for (const auto& value : values) hash_into(hasher, value);
}

template <class T>
void hash_into(Hasher& hasher, const std::optional<T>& value) {
  hasher.add(value.has_value() ? 1 : 0);
  if (value) hash_into(hasher, *value);
}

template <class... T>
void hash_into(Hasher& hasher, const std::variant<T...>& value) {
  hasher.add(value.index());
  std::visit([&](const auto& held) { hash_into(hasher, held); }, value);
}

template <class T>
std::uint64_t content_hash_of(const T& value) {
  Hasher hasher;
  hash_into(hasher, value);
  return hasher.value();
}

}  // namespace knit
