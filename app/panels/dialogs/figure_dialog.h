// The dialog that asks how large a picture or an animation shall be, and of what: what it remembers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace app {

struct FigureDialog {
  enum class Kind : std::uint8_t { picture, animation };
  enum class Of : std::uint8_t { run, stage, row, loop };
  std::optional<Kind> wanted;  // open for this
  bool shown = false;
  std::array<char, 4096> path{};
  std::size_t size = 0;          // of the sizes offered; the last is one's own
  std::array<int, 2> own{0, 0};  // pixels; 0: not yet chosen
  bool panels = false, transparent = false;
  Of of = Of::run;
  int frames = 120;
  double rate = 20.0;
};

}  // namespace app
