#include "knit/pattern/halves_form.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

#include "knit/pattern/fold.h"
#include "knit/pattern/pattern_words.h"

namespace knit {

namespace {

using Hands = std::vector<Hand>;
using Widths = std::array<std::int32_t, 4>;

// What is done after a quarter's main and before the next; knit: nothing.
struct Quarter {
  Hand after = Hand::knit, before = Hand::knit;
  friend bool operator==(const Quarter&, const Quarter&) = default;
};
using Way = std::array<Quarter, 4>;

// The work of each quarter, an increase at a marker before it. None: a stitch takes from both sides of one.
std::optional<std::array<Hands, 4>> quarters_of(const Round& round, const Widths& widths) {
  std::array<Hands, 4> quarters;
  std::size_t quarter = 0;
  std::int32_t taken = 0;
  for (const Operation& operation : round.operations) {
    const std::int32_t takes = consumed_by(operation.hand);
    if (takes > 0 && taken == widths[quarter]) {
      if (++quarter == 4) return std::nullopt;
      taken = 0;
    }
    taken += takes;
    if (taken > widths[quarter]) return std::nullopt;
    quarters[quarter].push_back(operation.hand);
  }
  if (quarter != 3 || taken != widths[3]) return std::nullopt;
  return quarters;
}

std::optional<Quarter> told_as(const Hands& hands) {
  Quarter quarter;
  auto begin = hands.begin(), end = hands.end();
  if (hands.size() > 1 && hands[0] == Hand::knit && (hands[1] == Hand::m1l || hands[1] == Hand::ssk)) {
    quarter.after = hands[1];
    begin += 2;
  }
  if (begin != end && (hands.back() == Hand::m1r || hands.back() == Hand::k2tog)) {
    quarter.before = hands.back();
    --end;
  }
  if (!std::all_of(begin, end, [](Hand hand) { return hand == Hand::knit; })) return std::nullopt;
  return quarter;
}

std::optional<Way> way_of(const std::array<Hands, 4>& quarters) {
  Way way;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto quarter = told_as(quarters[i]);
    if (!quarter) return std::nullopt;
    way[i] = *quarter;
  }
  return way;
}

std::string hand_words(Hand hand) {
  const std::array<Phrase, 1> once{Run{hand, 1, false}};
  return words_of(once);
}

std::string way_words(const Way& way) {
  constexpr std::array<const char*, 4> target{"side m", "front m", "side m", "end"};
  std::vector<std::string> parts;
  std::size_t reached = 4;  // the last marker that was named
  const auto go_to = [&](std::size_t i, std::int32_t kept) {
    if (i == 2 && reached == 0) parts.emplace_back("k to front m");
    if (kept > 0 && i == 3)
      parts.push_back("k to last " + stitches_text(kept));
    else
      parts.push_back("k to " + (kept > 0 ? stitches_text(kept) + " before " : std::string()) + target[i]);
    reached = i;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const Quarter& quarter = way[i];
    if (quarter.after != Hand::knit) {
      if (i > 0 && reached != i - 1) go_to(i - 1, 0);
      parts.emplace_back("K1");
      parts.push_back(hand_words(quarter.after));
    }
    if (quarter.before != Hand::knit) {
      go_to(i, consumed_by(quarter.before));
      parts.push_back(hand_words(quarter.before));
    }
  }
  if (reached != 3) go_to(3, 0);
  std::string words;
  for (const std::string& part : parts) words += (words.empty() ? "" : ", ") + part;
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

// The way of each round that has one. None: the quarters do not stay.
std::optional<std::vector<std::optional<Way>>> ways_of(const Rounds& rounds, Widths widths) {
  std::vector<std::optional<Way>> ways;
  for (const Round& round : rounds.rounds) {
    ways.emplace_back();
    if (knits_plain(round)) continue;
    const auto quarters = quarters_of(round, widths);
    if (!quarters) return std::nullopt;
    ways.back() = way_of(*quarters);
    for (std::size_t i = 0; i < 4; ++i) widths[i] = static_cast<std::int32_t>((*quarters)[i].size());
    if (widths[0] != widths[3] || widths[1] != widths[2]) return std::nullopt;
  }
  return ways;
}

}  // namespace

std::optional<HalvesForm> halves_form(const Rounds& rounds, std::int32_t back_quarter) {
  const std::int32_t half = rounds.cast_on / 2;
  const std::int32_t front_quarter = half - back_quarter;
  if (rounds.cast_on % 2 != 0 || back_quarter < 1 || front_quarter < 1) return std::nullopt;
  const auto ways = ways_of(rounds, {back_quarter, front_quarter, front_quarter, back_quarter});
  if (!ways) return std::nullopt;
  HalvesForm form;
  form.marks = {back_quarter, half, half + front_quarter};
  std::vector<Way> named;
  for (std::size_t i = 0; i < ways->size(); ++i) {
    const std::optional<Way>& way = (*ways)[i];
    form.of_round.push_back(knits_plain(rounds.rounds[i]) ? -2 : -1);
    if (!way || std::count(ways->begin(), ways->end(), way) < 2) continue;
    const auto known = std::find(named.begin(), named.end(), *way);
    form.of_round.back() = static_cast<std::int32_t>(known - named.begin());
    if (known != named.end()) continue;
    named.push_back(*way);
    form.named.push_back({"", way_words(*way), rounds.rounds[i].after - rounds.rounds[i].before});
  }
  const auto alike = [](const Way& way) { return way[0] == way[2] && way[1] == way[3]; };
  if (std::all_of(named.begin(), named.end(), alike)) return std::nullopt;
  give_names(form.named);
  return form;
}

}  // namespace knit
