#include <algorithm>
#include <sstream>

#include "knit/pattern/written_pattern.h"

namespace knit {

namespace {

constexpr std::size_t columns = 100;

// A broken line must not begin like a round, for whoever reads the file by machine.
bool reads_as_round(const std::string& word) {
  return word.rfind("Rnd", 0) == 0 || word.rfind("(Rnd", 0) == 0 || word.rfind("Round", 0) == 0;
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

// A step too long for a line is told one item a line.
bool is_list(const WrittenPattern::Instruction& instruction) {
  return instruction.kind == WrittenPattern::Instruction::Kind::step && instruction.remark.size() > columns &&
         instruction.remark.find(": ") != std::string::npos;
}

std::string item_by_item(const std::string& step) {
  std::size_t begin = step.find(": ") + 1;
  std::string text = step.substr(0, begin) + "\n";
  while (begin < step.size()) {
    const std::size_t comma = std::min(step.find(", ", begin), step.size() - 1);
    text += " " + step.substr(begin, comma + 1 - begin) + "\n";
    begin = comma + 1;
  }
  return text;
}

// A step of a piece is one line, like a round.
std::string step_or_remark(const WrittenPattern::Instruction& instruction) {
  if (is_list(instruction)) return item_by_item(instruction.remark);
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
    text += instruction_text(instruction) + "\n\n";
  }
  text.pop_back();
  heading("Finishing");
  for (const std::string& line : pattern.finishing) text += line + "\n";
  return text;
}

}  // namespace knit
