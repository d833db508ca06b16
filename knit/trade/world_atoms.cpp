#include "knit/trade/world_atoms.h"

#include <algorithm>
#include <array>

#include "knit/trade/characters.h"

namespace knit {

namespace {

constexpr std::array<std::string_view, 21> small_numbers{
    "zero",     "one",     "two",     "three",     "four",     "five",     "six",
    "seven",    "eight",   "nine",    "ten",       "eleven",   "twelve",   "thirteen",
    "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"};
constexpr std::array<std::string_view, 9> tens{"ten",   "twenty",  "thirty", "forty", "fifty",
                                               "sixty", "seventy", "eighty", "ninety"};

// Signs beyond ASCII that stand for one of ours; an empty text is a blank.
struct Sign {
  std::string_view bytes, text;
};
constexpr std::array signs{
    Sign{"\xC3\x97", "x"},      Sign{"\xC2\xA0", ""},      Sign{"\xE2\x80\x89", ""},
    Sign{"\xE2\x80\xAF", ""},   Sign{"\xE2\x80\x91", "-"}, Sign{"\xE2\x80\x93", "-"},
    Sign{"\xE2\x80\x94", "-"},  Sign{"\xE2\x88\x92", "-"}, Sign{"\xE2\x88\x97", "*"},
    Sign{"\xE2\x9C\xB1", "*"},  Sign{"\xE2\x80\x99", "'"}, Sign{"\xE2\x80\x98", "'"},
    Sign{"\xE2\x80\xA2", "-"},  Sign{"\xC2\xB7", "-"},     Sign{"\xE2\x80\x9C", "\""},
    Sign{"\xE2\x80\x9D", "\""},
};

class AtomReader {
 public:
  explicit AtomReader(std::string_view line) : line_(line) {}

  Atoms run() {
    while (at_ < line_.size()) {
      const char c = line_[at_];
      if (is_blank(c)) {
        ++at_;
        glued_ = false;
      } else if (is_digit(c)) {
        number();
      } else if (is_letter(c)) {
        word();
      } else {
        sign();
      }
    }
    return std::move(atoms_);
  }

 private:
  void put(Atom::Kind kind, std::string text, std::int64_t value, std::size_t begin) {
    atoms_.push_back({kind, std::move(text), value, begin, at_ - begin, glued_});
    glued_ = true;
  }

  void number() {
    const std::size_t begin = at_;
    std::int64_t value = 0;
    while (at_ < line_.size() && is_digit(line_[at_]))
      value = std::min(most_value, value * 10 + (line_[at_++] - '0'));
    put(Atom::Kind::number, std::string(line_.substr(begin, at_ - begin)), value, begin);
  }

  void word() {
    const std::size_t begin = at_;
    std::string text;
    while (at_ < line_.size() && (is_letter(line_[at_]) || (line_[at_] == '\'' && at_ + 1 < line_.size() &&
                                                            is_letter(line_[at_ + 1]))))
      text += lower(line_[at_++]);
    if (text == "the" || text == "a" || text == "an" || text == "your") {
      glued_ = false;
      return;
    }
    const auto* const small = std::find(small_numbers.begin(), small_numbers.end(), text);
    const auto* const ten = std::find(tens.begin(), tens.end(), text);
    std::int64_t value = -1;
    if (small != small_numbers.end())
      value = small - small_numbers.begin();
    else if (ten != tens.end())
      value = 10 * (ten - tens.begin() + 1);
    if (value < 0) return put(Atom::Kind::word, std::move(text), 0, begin);
    if (value >= 20 && value < 100 && at_ + 1 < line_.size() && (line_[at_] == '-' || line_[at_] == ' ')) {
      std::size_t end = at_ + 1;
      std::string unit;
      while (end < line_.size() && is_letter(line_[end])) unit += lower(line_[end++]);
      const auto* const found = std::find(small_numbers.begin() + 1, small_numbers.begin() + 10, unit);
      if (found != small_numbers.begin() + 10) {
        value += found - small_numbers.begin();
        at_ = end;
      }
    }
    put(Atom::Kind::number, std::move(text), value, begin);
  }

  void sign() {
    for (const Sign& sign : signs) {
      if (line_.substr(at_, sign.bytes.size()) != sign.bytes) continue;
      const std::size_t begin = at_;
      at_ += sign.bytes.size();
      if (sign.text.empty())
        glued_ = false;
      else
        put(sign.text == "x" ? Atom::Kind::word : Atom::Kind::mark, std::string(sign.text), 0, begin);
      return;
    }
    const std::size_t begin = at_++;
    if (static_cast<unsigned char>(line_[begin]) >= 0x80) {  // one sign of several bytes
      while (at_ < line_.size() && (static_cast<unsigned char>(line_[at_]) & 0xC0U) == 0x80U) ++at_;
    }
    std::string text(line_.substr(begin, at_ - begin));
    if (text == "{") text = "[";
    if (text == "}") text = "]";
    put(Atom::Kind::mark, std::move(text), 0, begin);
  }

  std::string_view line_;
  std::size_t at_ = 0;
  bool glued_ = false;
  Atoms atoms_;
};

}  // namespace

Atoms atoms_of(std::string_view line) { return AtomReader(line).run(); }

// Every question about a line ends here: most words differ in length or in their first letter.
bool is_any(const Atom& atom, AtomWords words) {
  const std::string_view text = atom.text;
  if (text.empty()) return false;
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return word.size() == text.size() && word.front() == text.front() && word == text;
  });
}

bool holds_any(std::span<const Atom> atoms, AtomWords words) {
  return std::any_of(atoms.begin(), atoms.end(), [&](const Atom& atom) { return is_any(atom, words); });
}

bool is_stitches(const Atom& atom) {
  return is_any(atom, {"st", "sts", "stitch", "stitches", "loops", "loop"});
}

bool is_rounds(const Atom& atom) {
  return is_any(atom, {"rnd", "rnds", "round", "rounds", "row", "rows", "rd", "rds"});
}

}  // namespace knit
