// A list of types, each with its number.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace app {

template <class... Kinds>
struct KindList {
  static constexpr std::size_t size = sizeof...(Kinds);

  template <std::size_t index>
  using at = std::tuple_element_t<index, std::tuple<Kinds...>>;

  template <class Kind>
  static constexpr bool has = (std::is_same_v<Kind, Kinds> || ...);

  // Requires has<Kind>.
  template <class Kind>
  static constexpr std::size_t index_of = [] {
    constexpr std::array<bool, size> same{std::is_same_v<Kind, Kinds>...};
    std::size_t index = 0;
    while (!same[index]) ++index;
    return index;
  }();

  // Calls `visitor` with what `one` is; for a class with index() and get<Kind>().
  template <class Visitor, class One>
  static void visit(Visitor&& visitor, const One& one) {
    using Call = void (*)(Visitor&, const One&);
    constexpr std::array<Call, size> calls{[](Visitor& v, const One& o) { v(o.template get<Kinds>()); }...};
    calls[one.index()](visitor, one);
  }
};

}  // namespace app
