// Numbers as the bytes of binary files: the least first, whatever the machine.
#pragma once

#include <cstdint>
#include <string>

#include "knit/base/bits.h"

namespace app {

inline void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<unsigned char>((value >> shift) & 0xffU));
}
inline void append_u64(std::string& bytes, std::uint64_t value) {
  append_u32(bytes, static_cast<std::uint32_t>(value & 0xffffffffU));
  append_u32(bytes, static_cast<std::uint32_t>(value >> 32U));
}
inline void append_f32(std::string& bytes, float value) {
  append_u32(bytes, knit::bits_as<std::uint32_t>(value));
}

}  // namespace app
