// What is to be handed over or said: the loop takes it after the next frame, and the panels show the notices.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

struct Notice {
  enum class Kind : std::uint8_t { info, warning, error } kind = Kind::info;
  bool of_values = false;   // refuses parameters: it goes when some are taken
  std::uint16_t times = 1;  // that it was said
  std::string text;

  Notice() = default;
  Notice(Kind of_kind, std::string words) : kind(of_kind), text(std::move(words)) {}
  friend bool operator==(const Notice&, const Notice&) = default;
};

// A picture that the loop takes (figures.h).
struct FigureWish {
  std::filesystem::path path;
  int width = 0, height = 0;
  bool panels = false, transparent = false;
  friend bool operator==(const FigureWish&, const FigureWish&) = default;
};

struct Outbox {
  std::vector<FigureWish> pictures;
  std::vector<std::filesystem::path> pages;        // patterns with a picture
  std::vector<std::filesystem::path> worksheets;   // of the lesson
  std::vector<std::filesystem::path> screenshots;  // of the whole window
  std::optional<std::string> clipboard;
  std::vector<Notice> notices;  // newest last
  bool quit = false;
  friend bool operator==(const Outbox&, const Outbox&) = default;
};

}  // namespace app
