#include <algorithm>
#include <cctype>
#include <sstream>

#include "knit/pattern/written_pattern.h"

namespace knit {

namespace {

constexpr std::size_t columns = 100;

// A broken line must not begin like a round, for whoever reads the file by machine.
bool reads_as_round(const std::string& word) {
  std::string letters;
  for (const char c : word) letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters.starts_with("rnd") || letters.starts_with("(rnd") || letters.starts_with("round");
}

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// Broken into lines, all but the first set in by `indent`.
std::string wrapped(const std::string& text, std::size_t indent = 0) {
  std::string result;
  std::size_t length = 0;
  for (const std::string& word : words_in(text)) {
    if (length > 0 && length + 1 + word.size() > columns && !reads_as_round(word)) {
      result += "\n" + std::string(indent, ' ') + word;
      length = indent + word.size();
    } else {
      if (length > 0) result += " ";
      result += word;
      length += word.size() + (length > 0 ? 1 : 0);
    }
  }
  return result + "\n";
}

std::string instruction_text(const WrittenPattern::Instruction& instruction) {
  return instruction.round ? instruction.round->text() : instruction.remark;
}

bool is_heading(const WrittenPattern::Instruction& instruction) {
  return !instruction.round && instruction.kind == WrittenPattern::Instruction::Kind::heading;
}

// Its head as a line, then an item a line behind `bullet`.
std::string item_by_item(const std::string& step, std::string_view bullet) {
  const std::vector<std::string> items = items_of_step(step);
  std::string text = items.front() + "\n" + (bullet.starts_with("-") ? "\n" : "");
  for (std::size_t i = 1; i < items.size(); ++i) text += std::string(bullet) + items[i] + "\n";
  return text;
}

// A step of a piece is one line, like a round.
std::string step_or_remark(const WrittenPattern::Instruction& instruction) {
  if (is_told_by_items(instruction)) return item_by_item(instruction.remark, "  ");
  const bool step = instruction.kind == WrittenPattern::Instruction::Kind::step && instruction.row == 0;
  return step ? instruction.remark + "\n" : wrapped(instruction.remark);
}

std::string explained(const std::pair<std::string, std::string>& abbreviation) {
  return abbreviation.first + ": " + abbreviation.second;
}

// What a person gave may hold signs that mean something in Markdown; a backslash takes the meaning away. Rounds
// need none: a bracket is plain without a link's target, and of two stars one stands between spaces.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '*' || c == '_' || c == '[' || c == ']' || c == '\\' || c == '`' || c == '<' || c == '#')
      result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

bool is_told_by_items(const WrittenPattern::Instruction& instruction) {
  // A named round is one line, like a round.
  const std::size_t colon = instruction.remark.find(':');
  if (instruction.remark.substr(0, colon).find(" rnd") != std::string::npos) return false;
  return !instruction.round && instruction.kind == WrittenPattern::Instruction::Kind::step &&
         instruction.remark.size() > columns && instruction.remark.find(": ") != std::string::npos;
}

std::vector<std::string> items_of_step(const std::string& step) {
  std::size_t begin = step.find(": ") + 2;
  std::vector<std::string> items{step.substr(0, begin - 1)};
  while (begin < step.size()) {
    const std::size_t comma = std::min(step.find(", ", begin), step.size() - 1);
    items.push_back(step.substr(begin, comma + 1 - begin));
    begin = comma + 2;
  }
  return items;
}

std::string pattern_as_text(const WrittenPattern& pattern) {
  std::string text = pattern.title + "\n" + std::string(pattern.title.size(), '=') + "\n\n";
  const auto heading = [&](const std::string& words) { text += "\n" + words + "\n"; };
  text += "Project level: " + pattern.level + "\n";
  heading("FINISHED SIZE");
  for (const std::string& line : pattern.size) text += wrapped(line);
  heading("MATERIALS");
  for (const std::string& line : pattern.materials) text += wrapped("- " + line, 2);
  heading("GAUGE");
  text += wrapped(pattern.gauge);
  heading("ABBREVIATIONS");
  for (const auto& abbreviation : pattern.abbreviations) text += wrapped(explained(abbreviation), 4);
  heading("NOTES");
  for (const std::string& line : pattern.notes) text += wrapped("- " + line, 2);
  heading("INSTRUCTIONS");
  text += wrapped(pattern.start);
  for (const auto& instruction : pattern.instructions) {
    if (is_heading(instruction)) text += "\n";
    if (instruction.round)
      text += instruction_text(instruction) + "\n";
    else
      text += step_or_remark(instruction);
  }
  heading("FINISHING");
  for (const std::string& line : pattern.finishing) text += wrapped(line);
  return text;
}

// Every round is a paragraph of its own.
std::string pattern_as_markdown(const WrittenPattern& pattern) {
  std::string text = "# " + escaped(pattern.title) + "\n\nProject level: " + pattern.level + "\n";
  const auto heading = [&](const std::string& words) { text += "\n## " + words + "\n\n"; };
  heading("Finished size");
  for (const std::string& line : pattern.size) text += line + "\n";
  heading("Materials");
  for (const std::string& line : pattern.materials) text += "- " + escaped(line) + "\n";
  heading("Gauge");
  text += pattern.gauge + "\n";
  heading("Abbreviations");
  for (const auto& [word, meaning] : pattern.abbreviations)
    text.append("- **").append(word).append("**: ").append(meaning).append("\n");
  heading("Notes");
  for (const std::string& line : pattern.notes) text += "- " + line + "\n";
  heading("Instructions");
  text += pattern.start + "\n\n";
  for (const auto& instruction : pattern.instructions) {
    if (is_heading(instruction)) text += "### ";
    if (is_told_by_items(instruction))
      text += item_by_item(instruction.remark, "- ") + "\n";
    else
      text += instruction_text(instruction) + "\n\n";
  }
  text.pop_back();
  heading("Finishing");
  for (const std::string& line : pattern.finishing) text += line + "\n";
  return text;
}

}  // namespace knit
