#include "knit/pattern/short_form.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "knit/pattern/fold.h"
#include "knit/pattern/halves_form.h"
#include "knit/pattern/pattern_words.h"

namespace knit {

namespace {

using Hands = std::vector<Hand>;

std::string capitalised_words(std::string words) {
  const std::size_t at = words.starts_with('[') ? 1 : 0;
  if (at < words.size()) words[at] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[at])));
  return words;
}

// --- Sections ----------------------------------------------------------------------------------------------------

// What is done in each of the sections; nothing where they differ, or one begins with an increase: nobody could tell on
// which side of the marker it is made.
std::optional<Hands> section_of(const Round& round, std::int32_t sections) {
  const std::size_t all = round.operations.size();
  const auto count = static_cast<std::size_t>(sections);
  if (all % count != 0 || round.before % sections != 0) return std::nullopt;
  const std::size_t each = all / count;
  for (std::size_t i = each; i < all; ++i) {
    if (round.operations[i].hand != round.operations[i - each].hand) return std::nullopt;
  }
  Hands section;
  for (std::size_t i = 0; i < each; ++i) section.push_back(round.operations[i].hand);
  std::int32_t taken = 0;
  for (const Hand hand : section) taken += consumed_by(hand);
  if (taken * sections != round.before || consumed_by(section.front()) == 0) return std::nullopt;
  return section;
}

// A way to shape: what is done before and behind the stitches that are knit up to the next marker.
struct Shape {
  Hands before, behind;
  friend bool operator==(const Shape&, const Shape&) = default;
  friend bool operator<(const Shape& a, const Shape& b) {
    return std::tie(a.before, a.behind) < std::tie(b.before, b.behind);
  }
};

// All ways to see a section as a shape: one for each of its runs of knit stitches.
std::vector<Shape> shapes_of(const Hands& section) {
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < section.size();) {
    std::size_t end = i;
    while (end < section.size() && section[end] == Hand::knit) ++end;
    if (end == i) {
      ++i;
      continue;
    }
    const auto at = [&](std::size_t place) { return section.begin() + static_cast<std::ptrdiff_t>(place); };
    shapes.push_back({{section.begin(), at(i)}, {at(end), section.end()}});
    i = end;
  }
  return shapes;
}

std::string shape_words(const Shape& shape, std::int32_t sections) {
  std::vector<Operation> before;
  std::vector<Operation> behind;
  std::int32_t kept = 0;
  for (const Hand hand : shape.before) before.push_back({hand, false});
  for (const Hand hand : shape.behind) {
    behind.push_back({hand, false});
    kept += consumed_by(hand);
  }
  const auto written = [](const std::vector<Operation>& operations) {
    std::vector<Phrase> runs;
    for (const Operation& operation : operations) {
      Run* const last = runs.empty() ? nullptr : std::get_if<Run>(&runs.back());
      if (last != nullptr && last->hand == Hand::knit && operation.hand == Hand::knit)
        ++last->count;
      else
        runs.emplace_back(Run{operation.hand, 1, false});
    }
    return words_of(runs);
  };
  std::string words = written(before);
  if (!words.empty()) words += ", ";
  words += kept == 0 ? "k to next m" : "k to " + stitches_text(kept) + " before next m";
  if (!behind.empty()) words += ", " + written(behind);
  return capitalised_words("[" + words + "] " + std::to_string(sections) + " times");
}

std::int32_t change_of(const Shape& shape, std::int32_t sections) {
  std::int32_t change = 0;
  for (const Hands* hands : {&shape.before, &shape.behind}) {
    for (const Hand hand : *hands) change += 1 - consumed_by(hand);
  }
  return change * sections;
}

// --- Names -------------------------------------------------------------------------------------------------------

// Each shaping round's shape by its number in `shapes`, -1 where none that comes twice fits.
struct Naming {
  std::vector<Shape> shapes;
  std::vector<std::int32_t> of_round;  // -2: a plain round
};

// The shape that fits most rounds is named first, then that of most of the others. Ties: the one that comes first.
std::optional<Naming> name_shapes(const Rounds& rounds, std::int32_t sections) {
  Naming naming;
  std::vector<std::vector<Shape>> fitting;
  for (const Round& round : rounds.rounds) {
    const bool plain = knits_plain(round);
    naming.of_round.push_back(plain ? -2 : -1);
    fitting.emplace_back();
    if (plain) continue;
    const auto section = section_of(round, sections);
    if (!section) return std::nullopt;
    fitting.back() = shapes_of(*section);
  }
  while (true) {
    std::map<Shape, std::pair<std::int32_t, std::int32_t>>
        uses;  // how often, and less the round of the first
    for (std::size_t i = 0; i < fitting.size(); ++i) {
      if (naming.of_round[i] != -1) continue;
      for (const Shape& shape : fitting[i])
        ++uses.try_emplace(shape, 0, -static_cast<std::int32_t>(i)).first->second.first;
    }
    const auto most = std::max_element(uses.begin(), uses.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == uses.end() || most->second.first < 2) break;
    for (std::size_t i = 0; i < fitting.size(); ++i) {
      const bool fits = std::find(fitting[i].begin(), fitting[i].end(), most->first) != fitting[i].end();
      if (naming.of_round[i] == -1 && fits)
        naming.of_round[i] = static_cast<std::int32_t>(naming.shapes.size());
    }
    naming.shapes.push_back(most->first);
  }
  if (naming.shapes.empty()) return std::nullopt;
  return naming;
}

// In the order of use; of several that grow, or shrink, A is the one that changes most.
std::vector<NamedRound> named_rounds(Naming& naming, std::int32_t sections) {
  std::vector<std::int32_t> order;
  for (const std::int32_t shape : naming.of_round) {
    if (shape >= 0 && std::find(order.begin(), order.end(), shape) == order.end()) order.push_back(shape);
  }
  std::vector<NamedRound> named;
  std::vector<std::int32_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Shape& shape = naming.shapes[static_cast<std::size_t>(order[i])];
    named.push_back({"", shape_words(shape, sections), change_of(shape, sections)});
    place[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
  }
  for (std::int32_t& shape : naming.of_round) {
    if (shape >= 0) shape = place[static_cast<std::size_t>(shape)];
  }
  give_names(named);
  return named;
}

// --- Lines -------------------------------------------------------------------------------------------------------

constexpr std::int32_t price_of_a_line = 40;  // in characters
constexpr std::size_t most_parts =
    4;  // of what a line repeats: "inc rnd A, knit 1 rnd, inc rnd B, knit 1 rnd"

// The lines with the fewest characters, a line counted as 40 more:
//   best(i) = min over lines from i to j of characters + 40 + best(j);   best(R) = 0.   Ties: the longer line.
class Lines {
 public:
  Lines(const Rounds& rounds, const std::vector<std::int32_t>& kinds, const std::vector<NamedRound>& named,
        std::span<const std::int32_t> breaks)
      : rounds_(rounds), kinds_(kinds), named_(named), breaks_(breaks) {}

  std::vector<RoundLine> run() {
    const std::size_t all = kinds_.size();
    std::vector<std::int64_t> best(all + 1, 0);
    std::vector<RoundLine> line(all);
    for (std::size_t i = all; i-- > 0;) {
      best[i] = -1;
      const auto offer = [&](RoundLine candidate, std::size_t end) {
        const auto length = static_cast<std::int64_t>(candidate.text().size());
        const std::int64_t cost = length + price_of_a_line + best[end];
        if (best[i] >= 0 && cost > best[i]) return;
        best[i] = cost;
        line[i] = std::move(candidate);
      };
      alone(i, offer);
      repeated(i, offer);
    }
    std::vector<RoundLine> lines;
    for (std::size_t i = 0; i < all; i = end_of(lines.back())) lines.push_back(line[i]);
    return lines;
  }

 private:
  static std::size_t end_of(const RoundLine& line) { return static_cast<std::size_t>(line.last) - 1; }
  [[nodiscard]] std::int32_t number(std::size_t i) const { return rounds_.rounds[i].number; }
  [[nodiscard]] bool ends_here(std::size_t i) const {
    return std::find(breaks_.begin(), breaks_.end(), number(i)) != breaks_.end();
  }
  // Up to where a line from `i` may go.
  [[nodiscard]] std::size_t farthest(std::size_t i) const {
    while (i < kinds_.size() && kinds_[i] != -1) {
      if (ends_here(i)) return i + 1;
      ++i;
    }
    return i;
  }

  // Rounds that are knit, or one that is written out.
  template <class Offer>
  void alone(std::size_t i, const Offer& offer) const {
    const Round& round = rounds_.rounds[i];
    if (kinds_[i] == -1) {
      RoundLine line{round.number, round.number, words_of(fold(round.operations)), round.after, 0, {}, false};
      return offer(std::move(line), i + 1);
    }
    if (kinds_[i] != -2) return;
    const std::size_t end = farthest(i);
    for (std::size_t j = i; j < end && kinds_[j] == -2; ++j)
      offer(RoundLine{round.number, number(j), "Knit", round.after, 0, {}, false}, j + 1);
  }

  // The parts of the rounds from `begin` to `end`: "knit 2 rnds", "inc rnd".
  [[nodiscard]] std::vector<std::string> parts(std::size_t begin, std::size_t end) const {
    std::vector<std::string> parts;
    for (std::size_t i = begin; i < end && parts.size() <= most_parts;) {
      if (kinds_[i] >= 0) {
        parts.push_back(named_[static_cast<std::size_t>(kinds_[i])].name);
        ++i;
        continue;
      }
      std::size_t to = i;
      while (to < end && kinds_[to] == -2) ++to;
      parts.push_back("knit " + std::to_string(to - i) + (to - i == 1 ? " rnd" : " rnds"));
      i = to;
    }
    return parts;
  }

  template <class Offer>
  void repeated(std::size_t i, const Offer& offer) const {
    const std::size_t limit = farthest(i);
    for (std::size_t period = 1; i + period <= limit; ++period) {
      const std::vector<std::string> body = parts(i, i + period);
      if (body.size() > most_parts) break;
      if (body.size() > 1 && kinds_[i] == -2 && kinds_[i + period - 1] == -2)
        continue;  // knit, inc rnd, knit
      const auto first = kinds_.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::all_of(first, first + static_cast<std::ptrdiff_t>(period), [](auto k) { return k < 0; }))
        continue;
      std::size_t times = 1;
      while (i + (times + 1) * period <= limit && again(i, period, times)) ++times;
      if (body.size() <= 2) offer(line_of(body, i, period, 1), i + period);
      for (std::size_t t = 2; t <= times; ++t) offer(line_of(body, i, period, t), i + t * period);
    }
  }
  [[nodiscard]] bool again(std::size_t i, std::size_t period, std::size_t times) const {
    for (std::size_t k = 0; k < period; ++k) {
      if (kinds_[i + times * period + k] != kinds_[i + k]) return false;
    }
    return true;
  }

  [[nodiscard]] RoundLine line_of(const std::vector<std::string>& body, std::size_t begin, std::size_t period,
                                  std::size_t times) const {
    std::string words;
    for (const std::string& part : body) words += (words.empty() ? "" : ", ") + part;
    if (times > 1) words = "[" + words + "] " + std::to_string(times) + " times";
    const std::size_t end = begin + period * times;
    RoundLine line{
        number(begin), number(end - 1), capitalised_words(words), rounds_.rounds[end - 1].after, 0, {},
        false};
    for (std::size_t i = begin; i < end; ++i) {
      if (kinds_[i] >= 0) line.counts.push_back(rounds_.rounds[i].after);
    }
    return line;
  }

  const Rounds& rounds_;
  const std::vector<std::int32_t>& kinds_;
  const std::vector<NamedRound>& named_;
  std::span<const std::int32_t> breaks_;
};

std::optional<ShortForm> with_sections(const Rounds& rounds, std::int32_t sections,
                                       std::span<const std::int32_t> breaks) {
  auto naming = name_shapes(rounds, sections);
  if (!naming) return std::nullopt;
  ShortForm form;
  form.sections = sections;
  form.stitches_each = rounds.cast_on / sections;
  form.named = named_rounds(*naming, sections);
  form.lines = Lines(rounds, naming->of_round, form.named, breaks).run();
  return form;
}

std::optional<ShortForm> with_halves(const Rounds& rounds, std::int32_t quarter,
                                     std::span<const std::int32_t> breaks) {
  auto halves = halves_form(rounds, quarter);
  if (!halves) return std::nullopt;
  ShortForm form;
  form.sections = 4;
  form.marks.assign(halves->marks.begin(), halves->marks.end());
  form.named = std::move(halves->named);
  form.lines = Lines(rounds, halves->of_round, form.named, breaks).run();
  return form;
}

std::size_t length_of(const ShortForm& form) {
  std::size_t length = 0;
  for (const NamedRound& round : form.named) length += round.text().size() + price_of_a_line;
  for (const RoundLine& line : form.lines) length += line.text().size() + price_of_a_line;
  return length;
}

}  // namespace

std::string NamedRound::text() const {
  const std::string sign = change > 0 ? "+" : change < 0 ? "-" : "";
  return capitalised_words(name) + ": " + words + ". (" + sign + stitches_text(std::abs(change)) + ")";
}

void give_names(std::vector<NamedRound>& named) {
  const auto name_all = [&](auto belongs, const std::string& name) {
    std::vector<NamedRound*> same;
    for (NamedRound& round : named) {
      if (belongs(round.change)) same.push_back(&round);
    }
    std::stable_sort(same.begin(), same.end(), [](const NamedRound* a, const NamedRound* b) {
      return std::abs(a->change) > std::abs(b->change);
    });
    for (std::size_t i = 0; i < same.size(); ++i)
      same[i]->name = same.size() == 1 ? name : name + " " + static_cast<char>('A' + i);
  };
  name_all([](std::int32_t change) { return change > 0; }, "inc rnd");
  name_all([](std::int32_t change) { return change < 0; }, "dec rnd");
  name_all([](std::int32_t change) { return change == 0; }, "shift rnd");
}

std::optional<ShortForm> short_form(const Rounds& rounds, std::span<const std::int32_t> breaks) {
  std::optional<ShortForm> best, halves;
  for (std::int32_t sections = 2; sections <= rounds.cast_on; ++sections) {
    if (rounds.cast_on % sections != 0) continue;
    auto form = with_sections(rounds, sections, breaks);
    if (form && (!best || length_of(*form) < length_of(*best))) best = std::move(form);
  }
  for (std::int32_t quarter = 1; !best && 2 * quarter < rounds.cast_on; ++quarter) {
    auto form = with_halves(rounds, quarter, breaks);
    if (form && (!halves || length_of(*form) < length_of(*halves))) halves = std::move(form);
  }
  return best ? best : halves;
}

}  // namespace knit
