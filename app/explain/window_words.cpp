#include "app/explain/window_words.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "app/session/presets.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

// Of the command line alone: what is said with them says nothing to a person in the window.
constexpr std::array<std::string_view, 10> script_options{
    "headless",        "help",   "lesson", "list-lessons", "piece",
    "list-parameters", "repair", "centre", "curves-scale", "version"};

bool is_of_key(char c) { return c == '-' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

// The option that begins at `at`, without its dashes; empty: none does.
std::string_view option_at(std::string_view text, std::size_t at) {
  const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == '(' || text[at - 1] == '\n';
  if (!begins || text.substr(at, 2) != "--") return {};
  std::size_t end = at + 2;
  while (end < text.size() && is_of_key(text[end])) ++end;
  return text.substr(at + 2, end - at - 2);
}

// What stands after it as its value: up to a blank or a mark of the sentence.
std::string_view value_after(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != ' ') return {};
  std::size_t end = std::min(text.find_first_of(" ;:)\n\"", at + 1), text.size());
  while (end > at + 1 && (text[end - 1] == ',' || text[end - 1] == '.')) --end;
  return text.substr(at + 1, end - at - 1);
}

bool is_value_of(const knit::ParameterInfo& info, std::string_view value) {
  if (value.empty()) return false;
  if (std::isdigit(static_cast<unsigned char>(value.front())) != 0 || value == "auto") return true;
  const auto* choice = std::get_if<knit::Choice>(&info.kind);
  if (choice != nullptr)
    return std::find(choice->names.begin(), choice->names.end(), value) != choice->names.end();
  return std::holds_alternative<knit::AxisChoice>(info.kind) && value.size() == 1 && value != "a";
}

// What an option is in the window, and how much of the text it stands for; nothing where it is not known.
struct Said {
  std::string words;
  std::size_t length = 0;
};
Said said_for(std::string_view text, std::size_t at, std::string_view key) {
  const std::size_t end = at + 2 + key.size();
  const std::string_view value = value_after(text, end);
  const std::size_t with_value = end + 1 + value.size() - at;
  if (const knit::ParameterInfo* info = knit::find_parameter(key)) {
    const std::string label(info->label);
    if (!is_value_of(*info, value)) return {label, end - at};
    return {"\"" + label + ": " + std::string(value) + "\"", with_value};
  }
  if (const Preset* preset = key == "preset" ? find_preset(value) : nullptr)
    return {"the preset \"" + std::string(preset->title) + "\"", with_value};
  // As the button says (repair_buttons.cpp).
  if (text.substr(at, end - at) == "--mend")
    return {"\"Repair: close openings flat\"", value == "openings" ? with_value : end - at};
  if (key.substr(0, 5) != "save-") return {};
  std::string what(key.substr(5));
  std::replace(what.begin(), what.end(), '-', ' ');
  return {"\"Save the " + what + "\"", end - at};
}

bool is_of_scripts(std::string_view text, std::size_t at, std::string_view key) {
  constexpr std::string_view place = "on the command line ";
  const bool named = at >= place.size() && text.substr(at - place.size(), place.size()) == place;
  return named || std::find(script_options.begin(), script_options.end(), key) != script_options.end();
}

// Where the part of the sentence begins that ends at `said`'s end: after the last mark, or with its "or".
std::size_t begin_of_part(std::string_view said) {
  std::size_t begin = 0;
  for (const std::string_view mark : {". ", "; ", ": ", " or ", "\n"}) {
    const std::size_t at = said.rfind(mark);
    if (at == std::string_view::npos) continue;
    const bool sentence = mark == ". ";
    const bool comma = mark == " or " && at > 0 && said[at - 1] == ',';
    begin = std::max(begin, sentence ? at + 1 : comma ? at - 1 : at);
  }
  return begin;
}

std::size_t end_of_part(std::string_view text, std::size_t at) {
  for (; at < text.size(); ++at) {
    const bool ends = at + 1 == text.size() || text[at + 1] == ' ' || text[at + 1] == '\n';
    if (text[at] == ';' || text[at] == '\n' || (text[at] == '.' && ends)) return at;
  }
  return at;
}

}  // namespace

std::string in_window_words(std::string_view text) {
  std::string words;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t dashes = std::min(text.find("--", at), text.size());
    words += text.substr(at, dashes - at);
    at = dashes;
    if (at == text.size()) break;
    const std::string_view key = option_at(text, at);
    if (!key.empty() && is_of_scripts(text, at, key)) {
      const std::size_t begin = begin_of_part(words);
      words.resize(begin);
      at = end_of_part(text, at);
      // The whole sentence was about it.
      if ((begin == 0 || words.back() == '.') && at < text.size() && text[at] == '.') ++at;
      continue;
    }
    const Said said = key.empty() ? Said{} : said_for(text, at, key);
    if (said.length == 0) {
      words += text.substr(at, 2);
      at += 2;
      continue;
    }
    if (words.ends_with("\" ") && said.words.front() == '"') words.insert(words.size() - 1, ",");
    words += said.words;
    at += said.length;
  }
  return words;
}

}  // namespace app
