// autoknit's constraint files, made byte by byte.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace test_support {

struct ConsChain {
  std::vector<glm::dvec3> points;
  float value = 0.0F, radius = 0.0F;
};

inline void put_word(std::string& bytes, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xFFU);
}

inline void put_float(std::string& bytes, double value) {
  put_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

inline std::string cons_bytes(const std::vector<ConsChain>& chains) {
  std::string points;
  std::string heads;
  std::uint32_t count = 0;
  for (const ConsChain& chain : chains) {
    for (const glm::dvec3& p : chain.points)
      for (const double number : {p.x, p.y, p.z}) put_float(points, number);
    count += static_cast<std::uint32_t>(chain.points.size());
    put_word(heads, static_cast<std::uint32_t>(chain.points.size()));
    put_float(heads, chain.value);
    put_float(heads, chain.radius);
  }
  std::string bytes;
  put_word(bytes, count);
  bytes += points;
  put_word(bytes, static_cast<std::uint32_t>(chains.size()));
  return bytes + heads;
}

}  // namespace test_support
