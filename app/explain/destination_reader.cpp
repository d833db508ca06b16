#include "app/explain/destination_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/text.h"
#include "app/session/at.h"

namespace app {

namespace {

using TypedNumber = std::optional<std::int64_t>;

// The words of what is typed, in small letters, taken one after the other. Arrows stand for "to".
class TypedWords {
 public:
  explicit TypedWords(const std::string& typed) {
    std::string text;
    for (std::size_t i = 0; i < typed.size(); ++i) {
      if (const std::size_t arrow = arrow_at(typed, i)) {
        text += " to ";
        i += arrow - 1;
      } else {
        const char c = typed[i];
        const bool gap = c == ' ' || c == '\t' || c == ',' || c == '?';
        text += gap ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      }
    }
    for (const std::string_view word : split(text, ' '))
      if (!word.empty() && word != "the") words_.emplace_back(word);
  }

  [[nodiscard]] bool done() const { return next_ == words_.size(); }
  [[nodiscard]] const std::string& front() const { return words_[next_]; }
  bool take(std::initializer_list<std::string_view> any) {
    if (done() || std::find(any.begin(), any.end(), front()) == any.end()) return false;
    ++next_;
    return true;
  }
  TypedNumber take_number() {
    const auto number = done() ? TypedNumber() : whole_number<std::int64_t>(front());
    if (number) ++next_;
    return number;
  }
  // "20:5"
  std::optional<std::pair<std::int64_t, std::int64_t>> take_pair() {
    if (done()) return std::nullopt;
    const auto parts = split(front(), ':');
    if (parts.size() != 2) return std::nullopt;
    const auto first = whole_number<std::int64_t>(parts[0]);
    const auto second = whole_number<std::int64_t>(parts[1]);
    if (!first || !second) return std::nullopt;
    ++next_;
    return std::pair(*first, *second);
  }
  void back(std::size_t to) { next_ = to; }
  [[nodiscard]] std::size_t here() const { return next_; }
  std::string take_rest() {
    std::string rest;
    for (; !done(); ++next_) rest += (rest.empty() ? "" : " ") + front();
    return rest;
  }

 private:
  static std::size_t arrow_at(const std::string& text, std::size_t i) {
    for (const std::string_view arrow : {"\xE2\x86\x92", "->"})
      if (text.compare(i, arrow.size(), arrow) == 0) return arrow.size();
    return 0;
  }

  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

constexpr std::array<std::string_view, 10> ordinals{"first", "second",  "third",  "fourth", "fifth",
                                                    "sixth", "seventh", "eighth", "ninth",  "tenth"};

// "third", "3rd", "last", "next"
std::optional<WhichOne> take_which(TypedWords& words) {
  using Kind = WhichOne::Kind;
  if (words.take({"last"})) return WhichOne{Kind::last, 1};
  if (words.take({"next"})) return WhichOne{Kind::next, 1};
  if (words.take({"previous"})) return WhichOne{Kind::previous, 1};
  if (words.take({"worst"})) return WhichOne{Kind::worst, 1};
  if (words.done()) return std::nullopt;
  const std::string word = words.front();
  const auto named = std::find(ordinals.begin(), ordinals.end(), word);
  if (named != ordinals.end() && words.take({word}))
    return WhichOne{Kind::nth, static_cast<std::int32_t>(named - ordinals.begin()) + 1};
  const std::size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
  const std::string_view ending = std::string_view(word).substr(digits);
  const auto count = whole_number<std::int32_t>(std::string_view(word).substr(0, digits));
  const bool ends = ending == "st" || ending == "nd" || ending == "rd" || ending == "th";
  if (!count || !ends || *count < 1 || !words.take({word})) return std::nullopt;
  return WhichOne{Kind::nth, *count};
}

bool take_row_word(TypedWords& words, PlaceWish& wish) {
  if (words.take({"round", "rnd"})) {
    wish.rounds = true;
    return true;
  }
  return words.take({"row"});
}

std::optional<Shaping> take_shaping(TypedWords& words) {
  if (words.take({"k2tog", "k2togs"})) return Shaping::k2tog;
  if (words.take({"ssk", "ssks"})) return Shaping::ssk;
  if (words.take({"m1l"})) return Shaping::m1l;
  if (words.take({"m1r"})) return Shaping::m1r;
  if (words.take({"increase", "inc"})) return Shaping::increase;
  if (words.take({"decrease", "dec"})) return Shaping::decrease;
  return std::nullopt;
}

// "of Leg A": the rest.
bool read_piece(TypedWords& words, PlaceWish& wish) {
  if (words.done()) return true;
  if (!words.take({"of", "in"})) return false;
  wish.piece = words.take_rest();
  return !wish.piece.empty();
}

// "7", "12 of Leg A"; without a number the one that is meant by `which`, or the one shown.
bool read_row(TypedWords& words, PlaceWish& wish) {
  wish.goal = wish.rounds ? Goal::round : Goal::row;
  wish.number = words.take_number();
  return read_piece(words, wish);
}

// "20:5", "5 of row 20"; nothing: the one selected.
bool read_stitch(TypedWords& words, PlaceWish& wish) {
  wish.goal = Goal::stitch;
  if (words.done()) return wish.why;
  if (const auto pair = words.take_pair()) {
    wish.row = pair->first;
    wish.number = pair->second;
    return words.done();
  }
  wish.number = words.take_number();
  if (!wish.number || !words.take({"of", "in"}) || !take_row_word(words, wish)) return false;
  wish.row = words.take_number();
  return wish.row && read_piece(words, wish);
}

// "decreasing half", "upper half": which of the two that the widest row parts.
bool read_half(TypedWords& words, PlaceWish& wish) {
  const bool rising = words.take({"increasing", "first", "lower", "bottom", "growing"});
  if (!rising && !words.take({"decreasing", "second", "last", "upper", "top", "shrinking"})) return false;
  (rising ? wish.until_widest : wish.after_widest) = true;
  return words.take({"half", "part"}) && words.done();
}

// "of round 24", "after row 24", "after the widest round", "of the decreasing half", or nothing more.
bool read_operation(TypedWords& words, PlaceWish& wish) {
  wish.goal = Goal::operation;
  if (const auto count = words.take_number()) {
    if (*count < 1 || *count > 1000000) return false;
    wish.which = {WhichOne::Kind::nth, static_cast<std::int32_t>(*count)};
  }
  if (words.done()) return true;
  const bool after = words.take({"after"});
  if (!after && !words.take({"of", "in"})) return false;
  if (after && words.take({"widest"})) {
    wish.after_widest = true;
    return words.done() || (take_row_word(words, wish) && words.done());
  }
  const std::size_t half = words.here();
  if (!after && read_half(words, wish)) return true;
  words.back(half);
  if (!take_row_word(words, wish)) return false;
  (after ? wish.after : wish.row) = words.take_number();
  return (after ? wish.after : wish.row) && read_piece(words, wish);
}

bool read_superlative(TypedWords& words, PlaceWish& wish) {
  const bool wide = words.take({"widest", "largest"});
  if (wide || words.take({"narrowest", "smallest"})) {
    wish.goal = wide ? Goal::widest : Goal::narrowest;
    return take_row_word(words, wish) && words.done();
  }
  const bool longest = words.take({"longest"});
  if (!longest && !words.take({"shortest"})) return false;
  wish.goal = longest ? Goal::longest_wale : Goal::shortest_wale;
  return words.take({"wale", "column"}) && words.done();
}

// "43 to 65"
bool read_change(TypedWords& words, PlaceWish& wish) {
  wish.goal = Goal::change;
  wish.number = words.take_number();
  if (!wish.number || !words.take({"to"})) return false;
  wish.second = words.take_number();
  if (words.take({"stitches"})) return wish.second && words.done();
  return wish.second && words.done();
}

bool read_counted(TypedWords& words, PlaceWish& wish, bool which) {
  if (words.take({"problem"})) {
    wish.goal = Goal::problem;
    if (const auto count = which ? TypedNumber() : words.take_number()) {
      if (*count < 1 || *count > 1000000) return false;
      wish.which = {WhichOne::Kind::nth, static_cast<std::int32_t>(*count)};
    } else if (!which) {
      return false;
    }
    return words.done();
  }
  if (const auto shaping = take_shaping(words)) {
    wish.shaping = *shaping;
    return read_operation(words, wish);
  }
  return false;
}

bool read_single(TypedWords& words, PlaceWish& wish) {
  if (words.take({"stitch", "st"})) return read_stitch(words, wish);
  if (words.take({"vertex"})) {
    wish.goal = Goal::vertex;
    wish.number = words.take_number();
    return (wish.number || wish.why) && words.done();
  }
  if (words.take({"step"})) {
    wish.goal = Goal::step;
    wish.number = words.take_number();
    return wish.number && words.done();
  }
  return false;
}

// A row by its number; in "why row" it may be the one shown.
bool read_row_named(TypedWords& words, PlaceWish& wish, bool which) {
  if (!take_row_word(words, wish) || !read_row(words, wish)) return false;
  const bool by_rank = wish.which.kind != WhichOne::Kind::worst;
  return which ? !wish.number && by_rank : wish.number || wish.why;
}

using PlaceForm = bool (*)(TypedWords&, PlaceWish&, bool);
constexpr std::array place_forms{PlaceForm{read_row_named}, PlaceForm{read_counted},
                                 PlaceForm{[](TypedWords& words, PlaceWish& wish, bool which) {
                                   return !which && read_single(words, wish);
                                 }},
                                 PlaceForm{[](TypedWords& words, PlaceWish& wish, bool which) {
                                   return !which && read_superlative(words, wish);
                                 }},
                                 PlaceForm{[](TypedWords& words, PlaceWish& wish, bool which) {
                                   return !which && read_change(words, wish);
                                 }}};

std::optional<PlaceWish> read_as_place(const std::string& typed) {
  std::string text;
  for (const char c : typed)
    if (c != ' ') text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  PlaceWish wish;
  wish.goal = Goal::at;
  wish.at = text == "start" ? "0" : text;
  const auto at = parse_at(wish.at);
  // A number alone could be a row, a stitch or a step.
  if (!at || (text != "start" && std::holds_alternative<std::size_t>(*at))) return std::nullopt;
  return wish;
}

void skip_small_words(TypedWords& words) {
  while (words.take({"is", "was", "are", "has", "have", "does", "did", "not", "it", "this", "run", "that"})) {
  }
}

}  // namespace

std::optional<PlaceWish> read_place_wish(const std::string& typed) {
  TypedWords words(typed);
  PlaceWish begun;
  if (words.take({"go"}) || words.take({"to"})) words.take({"to"});
  begun.why = words.take({"why"});
  if (begun.why) skip_small_words(words);
  if (words.done()) return std::nullopt;
  if (begun.why && words.take({"stop", "stopped", "end"})) {
    begun.goal = Goal::stop;
    return words.done() ? std::optional(begun) : std::nullopt;
  }
  const std::size_t start = words.here();
  const auto which = take_which(words);
  if (which) begun.which = *which;
  const std::size_t from = words.here();
  for (const PlaceForm form : place_forms) {
    PlaceWish wish = begun;
    words.back(from);
    if (form(words, wish, which.has_value())) return wish;
  }
  words.back(start);
  return begun.why ? std::nullopt : read_as_place(typed);
}

}  // namespace app
