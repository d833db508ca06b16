#include <algorithm>
#include <array>

#include "knit/reader_text.h"

namespace knit {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }
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
