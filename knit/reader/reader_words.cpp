#include "knit/reader/reader_words.h"

#include <algorithm>

#include "knit/trade/characters.h"

namespace knit {

namespace {

constexpr std::array stitch_kinds{
    StitchKind{"k", 1, 1, {Hand::knit}, 1, true},
    StitchKind{"knit", 1, 1, {Hand::knit}, 1, true},
    StitchKind{"p", 1, 1, {Hand::knit}, 1, true},
    StitchKind{"purl", 1, 1, {Hand::knit}, 1, true},
    StitchKind{"sl", 1, 1, {Hand::knit}, 1, true},
    StitchKind{"slip", 1, 1, {Hand::knit}, 1, true},
    StitchKind{"m1", 0, 1, {Hand::m1l}},
    StitchKind{"m1l", 0, 1, {Hand::m1l}},
    StitchKind{"m1r", 0, 1, {Hand::m1r}},
    StitchKind{"yo", 0, 1, {Hand::m1l}},
    StitchKind{"kfb", 1, 2, {Hand::knit, Hand::m1l}, 2},
    StitchKind{"pfb", 1, 2, {Hand::knit, Hand::m1l}, 2},
    StitchKind{"k2tog", 2, 1, {Hand::k2tog}},
    StitchKind{"p2tog", 2, 1, {Hand::k2tog}},
    StitchKind{"ssk", 2, 1, {Hand::ssk}},
    StitchKind{"ssp", 2, 1, {Hand::ssk}},
    StitchKind{"skp", 2, 1, {Hand::ssk}},
    StitchKind{"k3tog", 3, 1, {}, 0},
    StitchKind{"sssk", 3, 1, {}, 0},
    StitchKind{"sk2p", 3, 1, {}, 0},
    StitchKind{"s2kp", 3, 1, {}, 0},
    StitchKind{"cdd", 3, 1, {}, 0},
};

std::int64_t value_of(std::string_view digits) {
  std::int64_t value = 0;
  for (const char c : digits) value = std::min(most_number, value * 10 + (c - '0'));
  return value;
}

// Signs beyond ASCII that stand for one of ours.
struct Sign {
  std::string_view bytes;
  Token::Kind kind;
  std::string_view text;  // empty: a blank
};
constexpr std::array signs{
    Sign{"\xC3\x97", Token::Kind::word, "x"},     Sign{"\xC2\xA0", Token::Kind::mark, ""},
    Sign{"\xE2\x80\x89", Token::Kind::mark, ""},  Sign{"\xE2\x80\xAF", Token::Kind::mark, ""},
    Sign{"\xE2\x80\x91", Token::Kind::mark, "-"}, Sign{"\xE2\x80\x93", Token::Kind::mark, "-"},
    Sign{"\xE2\x80\x94", Token::Kind::mark, "-"}, Sign{"\xE2\x88\x92", Token::Kind::mark, "-"},
    Sign{"\xE2\x88\x97", Token::Kind::mark, "*"}, Sign{"\xE2\x9C\xB1", Token::Kind::mark, "*"},
};

class Lexer {
 public:
  explicit Lexer(std::string_view line) : text_(line) {}

  Tokens run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_blank(c)) {
        ++at_;
      } else if (is_digit(c)) {
        const std::string_view digits = take([](char d) { return is_digit(d); });
        tokens_.push_back({Token::Kind::number, std::string(digits), value_of(digits)});
      } else if (is_letter(c)) {
        word();
      } else if (!sign()) {
        other();
      }
    }
    return std::move(tokens_);
  }

 private:
  template <class Belongs>
  std::string_view take(Belongs belongs) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && belongs(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void word() {
    std::string text(take([](char c) { return is_letter(c) || is_digit(c) || c == '\''; }));
    std::transform(text.begin(), text.end(), text.begin(), lower);
    tokens_.push_back({Token::Kind::word, std::move(text)});
  }

  bool sign() {
    for (const Sign& sign : signs) {
      if (text_.substr(at_, sign.bytes.size()) != sign.bytes) continue;
      if (!sign.text.empty()) tokens_.push_back({sign.kind, std::string(sign.text)});
      at_ += sign.bytes.size();
      return true;
    }
    return false;
  }

  void other() {
    const char c = text_[at_];
    constexpr std::string_view marks = ",;.:[](){}*-=/&+|";
    if (marks.find(c) != std::string_view::npos) {
      tokens_.push_back({Token::Kind::mark, std::string(1, c)});
      ++at_;
      return;
    }
    const auto strange = [&](char s) {
      return !is_blank(s) && !is_digit(s) && !is_letter(s) && marks.find(s) == std::string_view::npos;
    };
    tokens_.push_back({Token::Kind::strange, std::string(take(strange))});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Tokens tokens_;
};

template <std::size_t N>
bool one_of(const Token& token, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), token.text) != words.end();
}

}  // namespace

Tokens tokens_of(std::string_view line) { return Lexer(line).run(); }

std::optional<NamedStitch> stitch_named(const Token& token) {
  if (token.kind != Token::Kind::word) return std::nullopt;
  const auto find = [](std::string_view word) {
    return std::find_if(stitch_kinds.begin(), stitch_kinds.end(),
                        [&](const StitchKind& kind) { return kind.word == word; });
  };
  if (const auto* const whole = find(token.text); whole != stitch_kinds.end())
    return NamedStitch{*whole, std::nullopt};
  const std::size_t digits = token.text.find_first_of("0123456789");
  if (digits == std::string::npos) return std::nullopt;
  const std::string_view number = std::string_view(token.text).substr(digits);
  const auto* const kind = find(std::string_view(token.text).substr(0, digits));
  if (kind == stitch_kinds.end() || !kind->counts || !std::all_of(number.begin(), number.end(), is_digit))
    return std::nullopt;
  return NamedStitch{*kind, value_of(number)};
}

bool is_stitches_word(const Token& token) {
  return one_of<5>(token, {"st", "sts", "stitch", "stitches", "loops"});
}

bool is_round_word(const Token& token) {
  return one_of<8>(token, {"rnd", "rnds", "round", "rounds", "row", "rows", "rd", "rds"});
}

bool begins_work(const Token& token) {
  return token.is_number() || stitch_named(token) || is_stitches_word(token) ||
         one_of<22>(token,
                    {"[",      "(", "{",  "*",    "]",   ")",    "}",  "times", "time",  "more",   "rep",
                     "repeat", "x", "to", "last", "end", "from", "pm", "sm",    "place", "around", "across"});
}

}  // namespace knit
