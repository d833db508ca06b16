// Just enough of XML to tell whether a text could be read as such.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace test_support {

inline std::size_t occurrences(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size()))
    ++count;
  return count;
}

// Of the text between tags, or in an attribute.
inline bool is_xml_text(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '<') return false;
    if (text[at] != '&') continue;
    const std::size_t end = text.find(';', at);
    if (end == std::string_view::npos || end == at + 1) return false;
    for (std::size_t i = at + 1; i < end; ++i) {
      if (std::isalnum(static_cast<unsigned char>(text[i])) == 0 && text[i] != '#') return false;
    }
  }
  return true;
}

// The inside of a tag after its name: name="text" and white space only.
inline bool are_attributes(std::string_view text) {
  std::size_t at = 0;
  for (;;) {
    const std::size_t name = text.find_first_not_of(" \n", at);
    if (name == std::string_view::npos) return true;
    const std::size_t open = text.find("=\"", name);
    if (open == std::string_view::npos || name == at) return false;
    for (const char c : text.substr(name, open - name)) {
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != ':') return false;
    }
    const std::size_t close = text.find('"', open + 2);
    if (close == std::string_view::npos || !is_xml_text(text.substr(open + 2, close - open - 2)))
      return false;
    at = close + 1;
  }
}

// Empty when every tag is closed in order and all else is text; else what is wrong.
inline std::string xml_fault(std::string_view xml) {
  std::vector<std::string> open;
  std::size_t at = 0, roots = 0;
  while (at < xml.size()) {
    const std::size_t tag = xml.find('<', at);
    const std::string_view between = xml.substr(at, tag == std::string_view::npos ? tag : tag - at);
    if (!is_xml_text(between)) return "text: " + std::string(between);
    if (open.empty() && between.find_first_not_of(" \n") != std::string_view::npos) return "text outside";
    if (tag == std::string_view::npos) break;
    const std::size_t end = xml.find('>', tag);
    if (end == std::string_view::npos) return "a tag without end";
    std::string_view inside = xml.substr(tag + 1, end - tag - 1);
    at = end + 1;
    if (!inside.empty() && inside.front() == '/') {
      if (open.empty() || open.back() != inside.substr(1)) return "closes " + std::string(inside);
      open.pop_back();
      continue;
    }
    const bool closed = !inside.empty() && inside.back() == '/';
    if (closed) inside.remove_suffix(1);
    const std::size_t name = std::min(inside.find_first_of(" \n"), inside.size());
    if (name == 0 || !are_attributes(inside.substr(name))) return "tag: " + std::string(inside);
    if (open.empty()) ++roots;
    if (!closed) open.emplace_back(inside.substr(0, name));
  }
  if (!open.empty()) return "not closed: " + open.back();
  return roots == 1 ? "" : "not one root";
}

}  // namespace test_support
