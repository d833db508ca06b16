#include "tests/support/world_text.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "tests/support/world_model.h"

namespace world {

const Said& ways() {
  static const Said said{
      .times = {"[{u}] {n} times", "({u}) {n} times", "({u}) x {n}", "({u}) \xc3\x97 {n}", "{n} x ({u})",
                "[{u}] {w} times", "*{u}* {n} times", "({u}) repeat {n} times", "[{u}] {n}x", "({u})*{n}"},
      .times_at_end = {"*{u}; rep from * {m} more times", "*{u}; rep from * a total of {n} times",
                       "*{u}; repeat from * {m} times more", "[{u}; rep] {n}x"},
      .to_end = {"*{u}; rep from * to end", "*{u}; rep from * around", "*{u}, repeat from *", "*{u}* around",
                 "*{u}* to end", "*{u}*; repeat from * to * to the end", "[{u}] to end", "({u}) to end",
                 "({u}), repeat around", "*{u}, rep from * to end of round", "[{u}] around",
                 "*{u}*, repeat between stars to end", "*{u}; repeat from * to end of rnd"},
      .to_end_alone = {"{u} around", "{u} to end", "{u}; repeat to end",
                       "*{u}. Repeat from * to end of round", "\\*{u}\\* around", "*({u}), rep * around"},
      .lone_stitch = {"{u} around", "{u} in every stitch around", "{u} in each st", "{u} all stitches",
                      "[{u}] to end", "*{u}; rep from * to end"},
      .to_last = {"*{u}; rep from * to last {r}", "[{u}] to last {r}", "*{u}; rep from * until {r} rem",
                  "({u}) to last {r}", "*{u}* to last {r}", "*{u}, repeat from * to last {r}"},
      .knit_to_end = {"k to end", "knit to end", "k to end of rnd", "knit to end of round", "k to the end"},
      .knit_to_last = {"k to last {r}", "knit to last {r}", "knit to the last {r}", "k until {r} remain"},
      .knit_to_marker = {"k to marker", "knit to marker", "k to m", "k to next marker",
                         "knit to next marker"},
      .knit_to_before = {"k to {r} before marker", "knit to {r} before next marker", "k to {r} before m"},
      .knit_some = {"k{n}", "k{n}", "k {n}", "knit {n}", "knit {n} sts"},
      .place_marker = {"pm", "place marker"},
      .slip_marker = {"sm", "sl m", "slip marker"},
      .evenly = {"{x} {n} sts evenly around", "knit, {x} {n} sts evenly", "{x} {n} sts evenly",
                 "knit, {x}reasing {n} sts evenly", "{x}rease {n} sts evenly"},
      .hold = {"place next {n} sts on waste yarn for {x}", "slip next {n} sts to a stitch holder for the {x}",
               "place the next {n} sts on a holder for the {x}"},
      .gap = {"CO {n} sts over the gap", "cast on {n} sts over the gap", "CO {n} sts"},
      .from_holder = {"k across held {n} sts of {x}", "knit the {n} held sts of the {x}"},
      .label = {"Rnd {a}:", "Round {a}:", "R{a}:", "{a}.", "{a}:", "{o} rnd:", "Rnd {a} -",
                "Rnd {a} \xe2\x80\x93", "Rnd {a}.", "**Rnd {a}:**",
                "Round {w}:", "RND {a}:", "Rnd {a} ({x}):", "{o} round:", "Rnd. {a}:", "Rd {a}:"},
      .label_range = {"Rnds {a}-{b}:", "Rounds {a}-{b}:", "Rnds {a} to {b}:", "Rnds {a}\xe2\x80\x93{b}:",
                      "R{a}-{b}:", "{a}-{b}.", "**Rnds {a}-{b}:**"},
      .label_two = {"Rnds {a} and {b}:", "Rnds {a} & {b}:"},
      .label_list = {"Rnds {l} and {b}:", "Rounds {l} & {b}:", "Rnds {l}, {b}:"},
      .label_alternate = {"All even rounds:", "Rnd {a} and all even rnds:",
                          "Rnd {a} and every alternate rnd:", "Rnd {a} (and every even rnd):",
                          "Rnd {a} and every foll alt rnd:", "Rnd {a} and all other even-numbered rnds:"},
      .label_none = {"Next rnd:", "Next round:", "Next rnd ({xl}):", "{X} rnd:", "{X} round:", "{XL} round:",
                     "Set-up rnd:", ""},
      .label_row = {"Row {a} ({s}):", "Row {a}:", "{o} row ({s}):", "Row {a} ({s}) \xe2\x80\x93",
                    "Row {a} [{s}]:", "{o} row:"},
      .label_row_range = {"Rows {a}-{b}:", "Rows {a} to {b}:"},
      .knit_round = {"knit", "knit", "k all sts", "knit all stitches", "knit to end of round", "k to end",
                     "knit around", "work even"},
      .purl_round = {"purl", "purl", "p all sts", "p to end", "purl to end", "p"},
      .as_round = {"work as rnd {a}", "as rnd {a}", "work as for round {a}", "same as rnd {a}",
                   "rep rnd {a}"},
      .even = {"Work even for {n} {rnds}.", "Knit {n} rounds.", "Work {n} {rnds} even.",
               "Work {n} rounds without shaping.", "K {n} rnds.", "Knit {w} rounds."},
      .even_one = {"Knit 1 rnd.", "Knit one round.", "Work 1 rnd even.", "Purl 1 rnd."},
      .again = {"Repeat rnds {a} and {b} {w} times more.", "Rep Rnds {a}-{b} {n} times.",
                "Rep Rnds {a} and {b} {n} more times.", "Repeat rounds {a} to {b} another {n} times."},
      .again_one = {"Repeat rnd {a} {w} times more.", "Rep Rnd {a} {n} more times."},
      .again_many = {"Repeat rnds {a}-{b} {w} times more.", "Rep Rnds {a}-{b} {n} times.",
                     "Repeat rounds {a} to {b} another {n} times."},
      .again_last = {"Repeat the last {b} rnds {n} more times.", "Rep last {b} rnds {n} times.",
                     "Repeat these {b} rounds {n} times more."},
      .again_range = {"Rnds {c}-{d}: Rep Rnds {a} and {b}.", "Rnds {c}-{d}: Repeat rnds {a}-{b}."},
      .again_until = {"Repeat rnds {a} and {b} until {n} sts remain.",
                      "Rep Rnds {a}-{b} until there are {n} sts.", "Repeat rnds {a} and {b} until {n} sts."},
      .again_until_last = {"Repeat these {b} rounds until {n} sts remain.",
                           "Rep the last {b} rnds until you have {n} sts."},
      .close = {"BO {n} sts.", "Bind off {n} sts.", "Cast off {n} sts.", "BO all {n} sts.",
                "Break yarn, thread through remaining {n} sts and pull tightly.",
                "Cut yarn and draw through remaining {n} sts."},
      .close_all = {"BO all sts.", "Bind off all sts loosely.", "Cast off all sts.", "Cast off.", "Bind off.",
                    "Cut yarn, thread through remaining sts and fasten off."},
      .put_aside = {"Break yarn, place sts on a holder.", "Cut yarn and place all sts on a stitch holder.",
                    "Break yarn, leave sts on a spare needle."},
      .take_back = {"Place the held {n} sts of the {x} on the needles. Rejoin yarn, pick up and knit {m}.",
                    "Place the {n} held sts of the {x} on needles. Pick up and knit {m} in the gap.",
                    "Slip the {n} {x} sts onto dpns. Rejoin yarn, pick up and knit {m} in the gap."},
      .cast_on = {"CO {n} sts.", "CO {n}.", "Cast on {n} stitches.", "cast on {n} sts",
                  "Cast on {n} sts. Join in the round, being careful not to twist.",
                  "Using a provisional cast on, CO {n} sts.",
                  "Loosely CO {n} sts. Divide evenly between 3 needles.",
                  "Using dpns, CO {n} sts. Join to work in the round. Place marker.",
                  "Using the long-tail method, cast on {n} sts", "Using 3 mm needles CO {n} sts.",
                  "With size US 6 needles cast on {n} stitches.",
                  "With MC, CO {n} sts and join in the round.", "Using Judy's Magic Cast On, CO {n} sts."},
      .cast_on_rows = {"CO {n} sts.", "Cast on {n} stitches.", "Using 4 mm needles, cast on {n} sts.",
                       "With straight needles CO {n} sts."},
      .count = {" ({n} sts)", " ({n} sts)", " [{n} sts]", ". {n} sts.", " \xe2\x80\x93 {n} sts", " = {n} sts",
                " ({n})", " ({n} stitches)", " - {n} sts.", ". {n} stitches", " ({n} sts.)"},
      .count_of_sizes = {". {n} sts.", " \xe2\x80\x93 {n} sts", " [{n} sts]", " = {n} sts",
                         ". {n} stitches."},
  };
  return said;
}

namespace {

constexpr std::array number_words{"zero",  "one",   "two",  "three", "four",   "five",  "six",
                                  "seven", "eight", "nine", "ten",   "eleven", "twelve"};

std::string in_words(int value) {
  const bool is_small = value >= 0 && value < static_cast<int>(number_words.size());
  return is_small ? number_words[static_cast<std::size_t>(value)] : std::to_string(value);
}
std::string ordinal(int value) {
  const int tens = value / 10 % 10, ones = value % 10;
  const char* end = tens == 1 ? "th" : ones == 1 ? "st" : ones == 2 ? "nd" : ones == 3 ? "rd" : "th";
  return std::to_string(value) + end;
}

using Places = std::map<std::string, std::string>;

std::string put(const char* way, const Places& places) {
  std::string text;
  for (const char* at = way; *at != '\0'; ++at) {
    if (*at != '{') {
      text += *at;
      continue;
    }
    std::string name;
    while (*++at != '}') name += *at;
    text += places.at(name);
  }
  return text;
}

class Speaker {
 public:
  explicit Speaker(const Pattern& pattern) : pattern_(pattern) {}

  Text say() {
    for (const Line& each : pattern_.lines) {
      const std::string text = each.flat ? in_rows(line(each)) : line(each);
      if (!said_.text.empty()) said_.text += each.joined ? " " : "\n";
      said_.text += pattern_.capitals && each.kind != LineKind::note ? capitals(text) : text;
    }
    said_.text += "\n";
    if (pattern_.sizes > 1)
      used("sizes", pattern_.size_look == 0 ? "n (n, n)" : pattern_.size_look == 1 ? "n[n, n]" : "n (n:n)");
    if (pattern_.capitals) used("text", "capitals");
    std::sort(said_.forms.begin(), said_.forms.end());
    said_.forms.erase(std::unique(said_.forms.begin(), said_.forms.end()), said_.forms.end());
    return said_;
  }

 private:
  void used(const std::string& kind, const std::string& way) { said_.forms.push_back(kind + ": " + way); }

  const char* choose(const char* kind, const Ways& list, int look) {
    const char* way = list[static_cast<std::size_t>(look) % list.size()];
    used(kind, way);
    return way;
  }

  static std::string capitals(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  }
  static void begin_large(std::string& text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }

  [[nodiscard]] bool is_same(const Num& number) const {
    for (std::size_t size = 1; size < pattern_.sizes; ++size) {
      if (number.of[size] != number.of[0]) return false;
    }
    return true;
  }
  [[nodiscard]] std::string num(const Num& number) const {
    std::string text = std::to_string(number.of[0]);
    if (is_same(number)) return text;
    const bool square = pattern_.size_look == 1;
    text += square ? "[" : " (";
    for (std::size_t size = 1; size < pattern_.sizes; ++size) {
      if (size > 1) text += pattern_.size_look == 2 ? ":" : ", ";
      text += std::to_string(number.of[size]);
    }
    return text + (square ? "]" : ")");
  }
  [[nodiscard]] std::string sts(const Num& number) const {
    return num(number) + (is_same(number) && number.of[0] == 1 ? " st" : " sts");
  }
  [[nodiscard]] std::string word(const Num& number) const {
    return is_same(number) ? in_words(number.of[0]) : num(number);
  }
  static Num less_one(Num number) {
    for (int& each : number.of) --each;
    return number;
  }

  std::string parts(const std::vector<Part>& list, bool is_line) {
    std::string text;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0) text += ", ";
      text += part(list[i], is_line && i + 1 == list.size(), is_line && list.size() == 1);
    }
    return text;
  }

  std::string part(const Part& part, bool is_last, bool is_alone) {
    const Said& said = ways();
    const Places places{{"n", num(part.times)}, {"x", part.name}};
    switch (part.kind) {
      case Kind::stitch:
        return stitch(part);
      case Kind::group:
        return group(part, is_last, is_alone);
      case Kind::place_marker:
        return choose("marker", said.place_marker, part.look);
      case Kind::slip_marker:
        return choose("marker", said.slip_marker, part.look);
      case Kind::evenly:
        return put(choose("evenly", said.evenly, part.look),
                   {{"n", num(part.times)}, {"x", part.fewer ? "dec" : "inc"}});
      case Kind::hold:
        return put(choose("holder", said.hold, part.look), places);
      case Kind::gap:
        return put(choose("holder", said.gap, part.look), places);
      case Kind::from_holder:
        return put(choose("holder", said.from_holder, part.look), places);
    }
    return {};
  }

  std::string stitch(const Part& part) {
    const Said& said = ways();
    const Word& word = words()[part.word];
    if (part.word != knit_word && part.word != purl_word) {
      used("word", word.names.front());
      return word.names.front();
    }
    const Places places{{"n", num(part.times)}, {"r", sts(part.reserve)}};
    std::string text;
    switch (part.fill) {
      case Fill::times:
        text = put(choose("some", said.knit_some, part.look), places);
        break;
      case Fill::to_end:
        text = choose("to end", said.knit_to_end, part.look);
        break;
      case Fill::to_last:
        text = put(choose("to last", said.knit_to_last, part.look), places);
        break;
      case Fill::to_marker:
        text = choose("to marker", said.knit_to_marker, part.look);
        break;
      case Fill::to_before_marker:
        text = put(choose("to marker", said.knit_to_before, part.look), places);
        break;
    }
    if (part.fill == Fill::times && part.times == Num(1) && text.size() > 4 &&
        text.substr(text.size() - 4) == " sts")
      text.pop_back();
    if (part.word == purl_word)
      text = (text.rfind("knit", 0) == 0 ? "purl" : "p") + text.substr(text.rfind("knit", 0) == 0 ? 4 : 1);
    return text;
  }

  std::string group(const Part& part, bool is_last, bool is_alone) {
    const Said& said = ways();
    const std::string unit = parts(part.parts, false);
    const Places places{{"u", unit},
                        {"n", num(part.times)},
                        {"m", num(less_one(part.times))},
                        {"w", word(part.times)},
                        {"r", sts(part.reserve)}};
    const bool is_spread = unit.find(',') != std::string::npos && part.parts.size() == 1;
    if (part.fill == Fill::to_last) return put(choose("repeat to last", said.to_last, part.look), places);
    if (part.fill == Fill::to_end) {
      if (part.parts.size() == 1 && !is_spread && is_alone && part.parts[0].word != knit_word)
        return put(choose("every stitch", said.lone_stitch, part.look), places);
      if (is_alone && !is_spread && part.look % 3 == 0)
        return put(choose("repeat to end", said.to_end_alone, part.look / 3), places);
      return put(choose("repeat to end", said.to_end, part.look), places);
    }
    if (part.times == Num(2) && part.look % 4 == 0) {
      used("repeat times", "({u}) twice");
      return "(" + unit + ") twice";
    }
    const bool has_more = less_one(part.times).of[0] > 1;
    if (is_last && has_more && part.look % 3 == 0)
      return put(choose("repeat times", said.times_at_end, part.look / 3), places);
    return put(choose("repeat times", said.times, part.look), places);
  }

  std::string label(const Line& line) {
    const Said& said = ways();
    const bool grows = line.name == "inc";
    Places places{{"a", std::to_string(line.first)},
                  {"b", std::to_string(line.last)},
                  {"o", ordinal(line.first)},
                  {"w", in_words(line.first)},
                  {"s", line.wrong_side ? "WS" : "RS"},
                  {"x", line.name},
                  {"X", grows ? "Inc" : "Dec"},
                  {"xl", grows ? "increase" : "decrease"},
                  {"XL", grows ? "Increase" : "Decrease"}};
    if (!line.numbers.empty()) {
      const std::vector<int>& all = line.numbers;
      std::string list;
      for (std::size_t i = 0; i + 1 < all.size(); ++i) list += (i > 0 ? ", " : "") + std::to_string(all[i]);
      places["l"] = list;
      places["a"] = std::to_string(all.front());
      places["b"] = std::to_string(all.back());
      return line.label < 100 ? put(choose("label", said.label_list, line.label), places)
                              : put(choose("label", said.label_alternate, line.label), places);
    }
    if (line.flat && line.last > line.first)
      return put(choose("label", said.label_row_range, line.label), places);
    if (line.flat) return put(choose("label", said.label_row, line.label), places);
    if (line.first == 0) {
      const bool plain = line.name.empty();
      const char* way =
          plain ? (line.label % 3 == 0 ? "" : said.label_none[static_cast<std::size_t>(line.label % 2)])
                : said.label_none[static_cast<std::size_t>(line.label) % said.label_none.size()];
      used("label", *way == '\0' ? "none" : way);
      return put(way, places);
    }
    if (line.last == line.first + 1 && line.label % 2 == 0)
      return put(choose("label", said.label_two, line.label / 2), places);
    if (line.last > line.first) return put(choose("label", said.label_range, line.label), places);
    const char* way = said.label[static_cast<std::size_t>(line.label) % said.label.size()];
    if (line.name.empty() && std::string(way).find("{x}") != std::string::npos) way = said.label[0];
    used("label", way);
    return put(way, places);
  }

  std::string count(const Line& line) {
    if (!line.stated) return line.count_look % 2 == 0 || line.joined ? "." : "";
    const bool sized = !is_same(*line.stated);
    const Ways& list = sized ? ways().count_of_sizes : ways().count;
    std::string text = put(choose("count", list, line.count_look), {{"n", num(*line.stated)}});
    if (text[0] == ' ' && (text[1] == '(' || text[1] == '[') && line.look % 2 == 0) text.insert(0, ".");
    return text;
  }

  // Rows are what rounds are in flat knitting.
  static std::string in_rows(std::string text) {
    const std::array<std::array<const char*, 2>, 7> pairs{{{"around", "across"},
                                                           {"rounds", "rows"},
                                                           {"round", "row"},
                                                           {"Rounds", "Rows"},
                                                           {"Rnd", "Row"},
                                                           {"rnd", "row"},
                                                           {"Round", "Row"}}};
    for (const auto& [from, to] : pairs) {
      const std::string was = from;
      for (std::size_t at = text.find(was); at != std::string::npos; at = text.find(was, at))
        text.replace(at, was.size(), to);
    }
    return text;
  }

  static std::string bullet(int mark) {
    return mark == 1 ? "- " : mark == 2 ? "* " : mark == 3 ? "\xe2\x80\xa2 " : "";
  }

  std::string line(const Line& line) {
    if (line.joined) used("text", "several rounds in a paragraph");
    switch (line.kind) {
      case LineKind::note:
        return line.text;
      case LineKind::cast_on: {
        used("cast on", line.text);
        return put(line.text.c_str(), {{"n", num(line.count)}});
      }
      case LineKind::round:
        return round(line);
      default:
        return other(line);
    }
  }

  std::string round(const Line& line) {
    const Said& said = ways();
    std::string body = line.whole ? (line.purl ? choose("whole round", said.purl_round, line.look)
                                               : choose("whole round", said.knit_round, line.look))
                                  : parts(line.parts, true);
    if (line.like > 0)
      body = put(choose("as round", said.as_round, line.look), {{"a", std::to_string(line.like)}});
    const std::string named = label(line);
    if (named.empty() || line.look % 5 != 0) begin_large(body);
    if (line.mark > 0 && !named.empty()) used("bullet", bullet(line.mark));
    return (named.empty() ? "" : bullet(line.mark) + named + " ") + body + count(line);
  }

  // "once more" and not "1 times more".
  static std::string with_once(std::string text) {
    const std::array<std::array<const char*, 2>, 6> pairs{{{" 1 times more", " once more"},
                                                           {" one times more", " one time more"},
                                                           {" 1 more times", " 1 more time"},
                                                           {" another 1 times", " once more"},
                                                           {" 1 times", " once"},
                                                           {" one times", " once"}}};
    for (const auto& [from, to] : pairs) {
      const std::size_t at = text.find(from);
      if (at != std::string::npos) text.replace(at, std::string(from).size(), to);
    }
    return text;
  }

  std::string other(const Line& line) {
    const Said& said = ways();
    Places places{{"n", num(line.count)},    {"w", word(line.count)},          {"x", line.name},
                  {"rnds", "rnds"},          {"a", std::to_string(line.from)}, {"b", std::to_string(line.to)},
                  {"m", sts(line.picked_up)}};
    std::string text;
    if (line.kind == LineKind::even && line.count == Num(1)) {
      text = put(choose("even", said.even_one, line.look), places);
    } else if (line.kind == LineKind::even) {
      text = put(choose("even", said.even, line.look), places);
    } else if (line.kind == LineKind::again) {
      text = with_once(again(line, places));
    } else if (line.kind == LineKind::close) {
      text = line.says_count ? put(choose("close", said.close, line.look), places)
                             : choose("close", said.close_all, line.look);
    } else if (line.kind == LineKind::put_aside) {
      text = choose("holder", said.put_aside, line.look);
    } else {
      text = put(choose("holder", said.take_back, line.look), places);
    }
    if (!line.stated) return text;
    if (text.back() == '.' && count(line)[0] == '.') text.pop_back();
    return text + count(line);
  }

  std::string again(const Line& line, Places& places) {
    const Said& said = ways();
    if (line.until) {
      places["n"] = num(*line.until);
      return line.from == 0 ? put(choose("again", said.again_until_last, line.look), places)
                            : put(choose("again", said.again_until, line.look), places);
    }
    if (line.from == 0) return put(choose("again", said.again_last, line.look), places);
    const int many = line.to - line.from + 1;
    if (line.first > 0 && many == 2 && is_same(line.count)) {
      places["c"] = std::to_string(line.first);
      places["d"] = std::to_string(line.first - 1 + many * line.count.of[0]);
      return put(choose("again", said.again_range, line.look), places);
    }
    const Ways& list = many == 1 ? said.again_one : many == 2 ? said.again : said.again_many;
    return put(choose("again", list, line.look), places);
  }

  const Pattern& pattern_;
  Text said_;
};

}  // namespace

Text say(const Pattern& pattern) { return Speaker(pattern).say(); }

std::vector<std::string> all_forms() {
  std::vector<std::string> all;
  const auto add = [&](const char* kind, const Ways& list) {
    for (const char* way : list) all.push_back(std::string(kind) + ": " + (*way == '\0' ? "none" : way));
  };
  const Said& said = ways();
  for (std::size_t i = purl_word + 1; i < words().size(); ++i) add("word", words()[i].names);
  for (const auto& [kind, list] : {std::pair<const char*, const Ways&>{"repeat times", said.times},
                                   {"repeat times", said.times_at_end},
                                   {"repeat to end", said.to_end},
                                   {"repeat to end", said.to_end_alone},
                                   {"every stitch", said.lone_stitch},
                                   {"repeat to last", said.to_last},
                                   {"to end", said.knit_to_end},
                                   {"to last", said.knit_to_last},
                                   {"to marker", said.knit_to_marker},
                                   {"to marker", said.knit_to_before},
                                   {"some", said.knit_some},
                                   {"marker", said.place_marker},
                                   {"marker", said.slip_marker},
                                   {"evenly", said.evenly},
                                   {"holder", said.hold},
                                   {"holder", said.gap},
                                   {"holder", said.from_holder},
                                   {"holder", said.put_aside},
                                   {"holder", said.take_back},
                                   {"label", said.label},
                                   {"label", said.label_range},
                                   {"label", said.label_two},
                                   {"label", said.label_list},
                                   {"label", said.label_alternate},
                                   {"label", said.label_none},
                                   {"label", said.label_row},
                                   {"label", said.label_row_range},
                                   {"whole round", said.knit_round},
                                   {"whole round", said.purl_round},
                                   {"as round", said.as_round},
                                   {"even", said.even},
                                   {"even", said.even_one},
                                   {"again", said.again},
                                   {"again", said.again_one},
                                   {"again", said.again_many},
                                   {"again", said.again_last},
                                   {"again", said.again_range},
                                   {"again", said.again_until},
                                   {"again", said.again_until_last},
                                   {"close", said.close},
                                   {"close", said.close_all},
                                   {"cast on", said.cast_on},
                                   {"cast on", said.cast_on_rows},
                                   {"count", said.count},
                                   {"count", said.count_of_sizes}})
    add(kind, list);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace world
