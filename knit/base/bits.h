// A value's bits as a value of another type of the same size: std::bit_cast, which libc++ 13 (the page's) lacks.
#pragma once

#include <cstring>
#include <type_traits>

namespace knit {

template <class To, class From>
  requires(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
           std::is_trivially_copyable_v<From>)
To bits_as(const From& from) {
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

}  // namespace knit
