#include "knit/reader_text.h"

#include <algorithm>

#include "knit/reader_words.h"

namespace knit {

namespace {

constexpr std::size_t wrapped_width = 60;  // a shorter line was not wrapped, it ended
constexpr std::size_t longest_line = 20000;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<TextLine> lines_of_plain(std::string_view text) {
  std::vector<TextLine> lines;
  std::size_t number = 1;
  for (std::size_t begin = 0; begin <= text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back({number, std::string(text.substr(begin, end - begin))});
    begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return lines;
}

// Headings, quotes, bullets, bold and escaped signs. A star is taken for a bullet only before a round, since it
// may begin a repeat.
std::string without_markdown(std::string_view line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string_view pair = line.substr(i, 2);
    const bool escapes = pair.size() == 2 && pair[0] == '\\' && !is_letter(pair[1]) && !is_digit(pair[1]);
    if (pair == "**" || pair == "__") {
      ++i;
    } else if (line[i] != '`' && !escapes) {
      text += line[i];
    }
    if (escapes) text += line[++i];
  }
  std::size_t begin = text.find_first_not_of(" \t#>");
  if (begin == std::string::npos) return "";
  const std::string_view rest = std::string_view(text).substr(begin);
  if (rest.starts_with("- ") || rest.starts_with("+ ")) begin += 2;
  const std::size_t behind = text.find_first_not_of(" \t*.)0123456789", begin);
  if (behind != std::string::npos && behind > begin && label_at(text, behind)) begin = behind;
  return text.substr(begin);
}

// The part of `text` from the label at `at` on begins a line of its own.
bool parts_line(std::string_view text, std::size_t at) {
  const std::size_t before = text.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
  if (at == 0 || before == std::string_view::npos || before + 1 == at) return false;
  const bool ended = text[before] == '.' || text[before] == ')' || text[before] == ']';
  return ended && label_at(text, at);
}

void add_parted(std::vector<TextLine>& lines, const TextLine& line) {
  std::size_t begin = 0;
  for (std::size_t at = 1; at < line.text.size(); ++at) {
    if ((line.text[at] != 'R' && line.text[at] != 'r') || !parts_line(line.text, at)) continue;
    lines.push_back({line.number, line.text.substr(begin, at - begin)});
    begin = at;
  }
  lines.push_back({line.number, line.text.substr(begin)});
}

struct Ending {
  bool comma = false, finished = false;
};
Ending ending_of(std::string_view text) {
  const char last = text.empty() ? '.' : text.back();
  return {last == ',' || last == ';',
          last == '.' || last == ')' || last == ']' || last == '!' || last == ':'};
}

bool is_count(const Tokens& tokens) {
  return tokens.size() > 2 && (tokens[0].is("(") || tokens[0].is("[")) && tokens[1].is_number() &&
         is_stitches_word(tokens[2]);
}

// Whether `next` goes on with the words of `line`.
bool goes_on(std::string_view line, std::string_view next) {
  if (line.empty() || next.empty() || line.size() + next.size() > longest_line || label_at(next, 0))
    return false;
  const Tokens tokens = tokens_of(next.substr(0, 64));
  if (tokens.empty()) return false;
  const Ending ending = ending_of(line);
  if (!label_at(line, 0)) return !ending.finished && line.size() >= wrapped_width;
  if (ending.finished) return is_count(tokens);
  return ending.comma || begins_work(tokens.front());
}

}  // namespace

bool label_at(std::string_view text, std::size_t at) {
  if (at >= text.size() || (at > 0 && is_letter(text[at - 1]))) return false;
  const Tokens tokens = tokens_of(text.substr(at, 48));
  return tokens.size() >= 2 && is_round_word(tokens[0]) && tokens[1].is_number();
}

std::vector<TextLine> pattern_lines(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const bool html = looks_like_html(text);
  std::vector<TextLine> joined;
  bool open = false;  // the last line may go on
  for (const TextLine& line : html ? lines_of_html(text) : lines_of_plain(text)) {
    const std::string clean = html ? line.text : without_markdown(line.text);
    const std::string_view words = trimmed(clean);
    if (open && !html && goes_on(joined.back().text, words)) {
      joined.back().text += ' ';
      joined.back().text += words;
    } else if (!words.empty()) {
      joined.push_back({line.number, std::string(words)});
    }
    open = !words.empty();
  }
  std::vector<TextLine> lines;
  for (const TextLine& line : joined) add_parted(lines, line);
  return lines;
}

}  // namespace knit
