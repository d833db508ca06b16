// A lesson on paper: one HTML file, nothing outside it is needed. A page with pictures, what there is to do, and questions
// with room to answer; the answers on a page of their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace app {

struct SheetQuestion {
  std::string ask;
  std::vector<std::string> choices;  // to tick; empty: a line to write on
  bool marked = false;               // the answer is a place in the picture
  std::string answer, reason;        // for the last page; both plain sentences or words
};

struct SheetPage {
  std::string title, text;
  std::string task;  // to be done at the screen; empty: none
  std::optional<SheetQuestion> question;
  std::vector<std::uint8_t> picture_png;  // empty: none
};

struct Worksheet {
  std::string title, about;
  std::vector<SheetPage> pages;
};

std::string worksheet_html(const Worksheet& sheet);

inline constexpr const char* worksheet_endings = ".html";
bool is_worksheet_name(const std::filesystem::path& path);
// Why there is none; nothing when it can be written.
std::optional<std::string> worksheet_missing(const Session& session);

}  // namespace app
