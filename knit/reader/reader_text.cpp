#include "knit/reader/reader_text.h"

#include <algorithm>
#include <array>

#include "knit/reader/reader_words.h"
#include "knit/trade/characters.h"

namespace knit {

namespace {

constexpr std::size_t wrapped_width = 60;  // a shorter line was not wrapped, it ended
constexpr std::size_t full_width = 85;
constexpr std::size_t longest_line = 20000;

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
  constexpr std::string_view bullet = "\xE2\x80\xA2";
  if (rest.starts_with(bullet))
    begin = std::min(text.size(), text.find_first_not_of(" \t", begin + bullet.size()));
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
  const Tokens end = tokens_of(text.substr(text.size() - std::min<std::size_t>(text.size(), 24)));
  const std::size_t n = end.size();
  // "= 30 sts", "- 30 (34: 38) sts"
  const auto may_stand_in_count = [](const Token& token) {
    return token.is_number() || token.is("(") || token.is(")") || token.is("[") || token.is("]") ||
           token.is(",") || token.is(":") || token.is("/");
  };
  std::size_t first = n == 0 ? 0 : n - 1;
  while (first > 0 && may_stand_in_count(end[first - 1])) --first;
  const bool count = first > 0 && first + 1 < n && is_stitches_word(end[n - 1]) && end[first].is_number() &&
                     (end[first - 1].is("-") || end[first - 1].is("=") || end[first - 1].is("."));
  return {last == ',' || last == ';',
          count || last == '.' || last == ')' || last == ']' || last == '!' || last == ':'};
}

bool is_count(const Tokens& tokens) {
  return tokens.size() > 2 && (tokens[0].is("(") || tokens[0].is("[")) && tokens[1].is_number() &&
         is_stitches_word(tokens[2]);
}

// "5th round: ...", "Next rnd: ...", "7. K4", "R8: ..." is a line of its own.
bool begins_anew(const Tokens& tokens) {
  constexpr std::size_t most_words = 6;
  if (tokens[0].is("*") || tokens[0].is("-")) return true;
  if (tokens.size() > 1 && (tokens[1].is(":") || tokens[1].is("="))) return true;
  if (tokens.size() > 2 && tokens[0].is("cast") && tokens[1].is("on") && tokens[2].is_number()) return true;
  if (is_round_word(tokens[0]) && tokens.size() > 2 && (tokens[1].is_number() || tokens[1].is(".")))
    return true;
  const bool numbered =
      tokens.size() > 1 && (tokens[0].is_number() || (tokens[0].text.size() > 1 && tokens[0].text[0] == 'r' &&
                                                      tokens[0].text[1] >= '0' && tokens[0].text[1] <= '9'));
  if (numbered && (tokens[1].is(":") || tokens[1].is(".") || tokens[1].is("th") || tokens[1].is("nd") ||
                   tokens[1].is("rd") ||
                   (tokens.size() > 3 && tokens[1].is("-") && tokens[2].is_number() &&
                    (tokens[3].is(".") || tokens[3].is(":")))))
    return true;
  if (tokens.size() > 2 && tokens[0].is_number() && tokens[1].is("st") && is_round_word(tokens[2]))
    return true;
  for (std::size_t i = 1; i + 1 < std::min(tokens.size(), most_words); ++i) {
    if (is_round_word(tokens[i]) && (tokens[i + 1].is(":") || tokens[i + 1].is("-") || tokens[i + 1].is("(")))
      return true;
    if (tokens[i].kind != Token::Kind::word && !tokens[i].is("-") && !tokens[i].is_number()) break;
  }
  return false;
}

// `width`: of the last line that was joined to it. Whether `next` goes on with the words of `line`.
bool goes_on(std::string_view line, std::size_t width, std::string_view next) {
  if (line.empty() || next.empty() || line.size() + next.size() > longest_line || label_at(next, 0))
    return false;
  const Tokens tokens = tokens_of(next.substr(0, 64));
  if (tokens.empty()) return false;
  if (begins_anew(tokens)) return false;
  const Ending ending = ending_of(line);
  if (!label_at(line, 0)) {
    // Words that go on: small letters, a bracket that is open, a comma, or a line as wide as only wrapped ones are.
    const bool small = (next.front() >= 'a' && next.front() <= 'z') || is_digit(next.front());
    const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
    const bool more = small || ending.comma || count('(') > count(')') || width >= full_width;
    return !ending.finished && width >= wrapped_width && more;
  }
  if (ending.finished) return is_count(tokens);
  // "Slip the first 8 sts to a holder" is a sentence of its own.
  const bool moves = tokens.front().is("slip") || tokens.front().is("place");
  // "Knit 2 rnds." behind a short line is one of its own, too.
  const bool begins = width < full_width && next.front() >= 'A' && next.front() <= 'Z';
  return ending.comma || (begins_work(tokens.front()) && !moves && !begins);
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
  std::size_t width = 0;
  for (const TextLine& line : html ? lines_of_html(text) : lines_of_plain(text)) {
    const std::string clean = html ? line.text : without_markdown(line.text);
    const std::string_view words = trimmed(clean);
    if (open && !html && goes_on(joined.back().text, width, words)) {
      joined.back().text += ' ';
      joined.back().text += words;
    } else if (!words.empty()) {
      joined.push_back({line.number, std::string(words)});
    }
    open = !words.empty();
    width = words.size();
  }
  std::vector<TextLine> lines;
  for (const TextLine& line : joined) add_parted(lines, line);
  return lines;
}

namespace {

bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), lower);
  return out;
}

std::string utf8(unsigned long code) {
  const auto byte = [](unsigned long value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x20 || code > 0x10FFFF) return " ";
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | (code >> 6)), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000)
    return {byte(0xE0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3F)), byte(0x80 | (code & 0x3F))};
  return {byte(0xF0 | (code >> 18)), byte(0x80 | ((code >> 12) & 0x3F)), byte(0x80 | ((code >> 6) & 0x3F)),
          byte(0x80 | (code & 0x3F))};
}

struct Entity {
  std::string_view name, text;
};
constexpr std::array entities{
    Entity{"amp", "&"},    Entity{"lt", "<"},    Entity{"gt", ">"},     Entity{"quot", "\""},
    Entity{"apos", "'"},   Entity{"nbsp", " "},  Entity{"times", "x"},  Entity{"ndash", "-"},
    Entity{"mdash", "-"},  Entity{"minus", "-"}, Entity{"ast", "*"},    Entity{"lowast", "*"},
    Entity{"lsqb", "["},   Entity{"rsqb", "]"},  Entity{"lpar", "("},   Entity{"rpar", ")"},
    Entity{"comma", ","},  Entity{"semi", ";"},  Entity{"colon", ":"},  Entity{"period", "."},
    Entity{"thinsp", " "}, Entity{"shy", ""},    Entity{"hyphen", "-"}, Entity{"num", "#"},
};

// The text of "&name;", without the ampersand and the semicolon; itself where it is not known.
std::string unescaped(std::string_view name) {
  for (const Entity& entity : entities) {
    if (entity.name == name) return std::string(entity.text);
  }
  std::string as_is = "&" + std::string(name) + ";";
  if (name.size() < 2 || name[0] != '#') return as_is;
  const bool hex = lower(name[1]) == 'x';
  unsigned long code = 0;
  for (const char c : name.substr(hex ? 2 : 1)) {
    const char d = lower(c);
    const bool digit = d >= '0' && d <= '9';
    if (!digit && !(hex && d >= 'a' && d <= 'f')) return as_is;
    code = std::min(code * (hex ? 16UL : 10UL) + static_cast<unsigned long>(digit ? d - '0' : d - 'a' + 10),
                    0x110000UL);
  }
  return utf8(code);
}

// These stand within a line; any other element begins and ends one.
constexpr std::array<std::string_view, 22> inline_elements{
    "a",     "abbr", "b", "bdi", "big",   "cite", "code",   "em",  "font", "i",    "kbd",
    "label", "mark", "q", "s",   "small", "span", "strong", "sub", "sup",  "time", "u"};
constexpr std::array<std::string_view, 8> skipped_elements{"script", "style",  "svg",      "head",
                                                           "title",  "canvas", "template", "math"};

template <std::size_t N>
bool one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class HtmlReader {
 public:
  explicit HtmlReader(std::string_view html) : html_(html), folded_(lower_case(html)) {}

  std::vector<TextLine> run() {
    while (at_ < html_.size()) {
      const char c = html_[at_];
      if (c == '<' && at_ + 1 < html_.size() && begins_tag(html_[at_ + 1])) {
        tag();
      } else if (c == '&') {
        entity();
      } else {
        add(std::string_view(&html_[at_], 1));
        pass(at_ + 1);
      }
    }
    end_line();
    return std::move(lines_);
  }

 private:
  static bool begins_tag(char c) { return is_name(lower(c)) || c == '/' || c == '!' || c == '?'; }

  // Goes on at `to`, counting lines.
  void pass(std::size_t to) {
    to = std::min(to, html_.size());
    line_ += static_cast<std::size_t>(std::count(html_.begin() + static_cast<std::ptrdiff_t>(at_),
                                                 html_.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
    at_ = to;
  }
  // Behind the next `mark`, or the end.
  [[nodiscard]] std::size_t behind(std::string_view mark) const {
    const std::size_t found = folded_.find(mark, at_);
    return found == std::string::npos ? html_.size() : found + mark.size();
  }

  void add(std::string_view text) {
    for (const char c : text) {
      if (is_blank(c)) {
        if (preformatted_ && c == '\n') end_line();
        if (!current_.text.empty() && current_.text.back() != ' ') current_.text += ' ';
        continue;
      }
      // A cell that begins a round begins a line; else the cells of a row are read as one.
      if (current_.text.empty()) current_.number = line_;
      current_.text += c;
    }
  }

  void end_line() {
    if (!current_.text.empty()) lines_.push_back(std::move(current_));
    current_ = {};
  }

  void entity() {
    constexpr std::size_t longest = 10;
    const std::size_t end = html_.substr(at_, longest + 2).find(';');
    if (end == std::string_view::npos) {
      add("&");
      pass(at_ + 1);
      return;
    }
    add(unescaped(html_.substr(at_ + 1, end - 1)));
    pass(at_ + end + 1);
  }

  void tag() {
    if (html_.substr(at_, 4) == "<!--") return pass(behind("-->"));
    const bool closing = html_[at_ + 1] == '/';
    const std::size_t begin = at_ + (closing ? 2 : 1);
    std::size_t end = begin;
    while (end < folded_.size() && is_name(folded_[end])) ++end;
    const std::string name = folded_.substr(begin, end - begin);
    pass(behind(">"));
    const bool empty = at_ >= 2 && html_[at_ - 2] == '/';
    if (!closing && !empty && one_of(name, skipped_elements)) {
      pass(behind("</" + name));
      return pass(behind(">"));
    }
    if (name == "pre") preformatted_ = !closing;
    if (name == "td" || name == "th") return cell(closing);
    if (!name.empty() && !one_of(name, inline_elements)) end_line();
  }

  // Cells of a row are read as one line, unless the next begins a round itself.
  void cell(bool closing) {
    if (closing) return;
    constexpr std::size_t farthest = 400;
    std::size_t text = at_;
    while (text < html_.size() && text < at_ + farthest && (is_blank(html_[text]) || html_[text] == '<'))
      text = html_[text] == '<' ? std::min(folded_.find('>', text), html_.size() - 1) + 1 : text + 1;
    if (label_at(html_, text)) return end_line();
    add(" ");
  }

  std::string_view html_;
  std::string folded_;  // in lower case, to find names in
  std::size_t at_ = 0, line_ = 1;
  bool preformatted_ = false;
  TextLine current_;
  std::vector<TextLine> lines_;
};

}  // namespace

bool looks_like_html(std::string_view text) {
  const std::string folded = lower_case(text);
  constexpr std::array<std::string_view, 9> signs{"<!doctype html", "<html",  "<body", "</p>",  "</li>",
                                                  "</td>",          "</div>", "<br>",  "<br />"};
  return std::any_of(signs.begin(), signs.end(),
                     [&](std::string_view sign) { return folded.find(sign) != std::string::npos; });
}

std::vector<TextLine> lines_of_html(std::string_view html) { return HtmlReader(html).run(); }

}  // namespace knit
