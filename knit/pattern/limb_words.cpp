#include "knit/pattern/limb_words.h"

#include <algorithm>

#include "knit/model/words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/written_parts.h"

namespace knit {

namespace {

std::string_view word_of(LimbRole role) {
  switch (role) {
    case LimbRole::limb:
      return "Limb";
    case LimbRole::body:
      return "Body";
    case LimbRole::branch:
      return "Branch";
    case LimbRole::lining:
      return "Lining";
    case LimbRole::part:
      break;
  }
  return "Part";
}

bool is_small(char c) { return c >= 'a' && c <= 'z'; }

// "A, B and C"
std::string with_and(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

std::string with_commas(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string number(std::int32_t value) { return std::to_string(value); }

// " (11 to 10)": the first and the last held stitch; " (3)" of one; nothing where it is all of them, from the first on.
std::string span_text(const LimbItem& item) {
  if (item.first == 0 && item.count == item.held) return "";
  if (item.count == 1) return " (" + number(item.first + 1) + ")";
  return " (" + number(item.first + 1) + " to " + number((item.first + item.count - 1) % item.held + 1) + ")";
}

std::string across(std::int32_t count, std::int32_t gap) {
  return "CO " + stitches_text(count) + " over gap " + number(gap);
}

std::string item_text(const LimbNames& names, const LimbItem& item, bool rejoins) {
  switch (item.kind) {
    case LimbItemKind::keep:
      return "keep " + stitches_text(item.count);
    case LimbItemKind::cast_on:
      return across(item.count, item.gap);
    case LimbItemKind::pick_up:
      return "pick up " + stitches_text(item.count) + " along gap " + number(item.gap);
    case LimbItemKind::take:
      break;
  }
  const std::string whose = " of " + names.holder(item.piece, item.holder) + span_text(item);
  if (!rejoins) return stitches_text(item.count) + whose;
  return "place " + number(item.count) + " held " + (item.count == 1 ? "st" : "sts") + whose +
         " on the needle";
}

std::string items_text(const LimbNames& names, const LimbDeal& deal) {
  std::vector<std::string> words;
  for (const LimbItem& item : deal.items)
    words.push_back(item_text(names, item, deal.kind == LimbDealKind::rejoin));
  return with_commas(words);
}

std::string divided_text(const LimbNames& names, const LimbDeal& deal) {
  std::vector<std::string> words;
  const std::string holder = names.holder(deal.piece, deal.holder);
  if (deal.before > 0) words.push_back("keep " + stitches_text(deal.before));
  words.push_back("place next " + stitches_text(deal.held) + " on a holder for " + holder);
  words.push_back(deal.gap > 0 ? across(deal.bridge, deal.gap) : "draw the gap close");
  if (deal.rest > 0) words.push_back("keep " + stitches_text(deal.rest));
  return "Divide: " + with_commas(words) + ". (" + stitches_text(deal.after) + "; " + holder + " " +
         stitches_text(deal.held) + ")";
}

std::string counted(const std::string& words, std::int32_t count) {
  return words + " (" + stitches_text(count) + ")";
}

// Equal ones that follow each other are one: "graft 5", "graft 1 to 2".
std::vector<std::string> graft_runs(const std::vector<LimbGraft>& grafts) {
  std::vector<std::string> runs;
  for (std::size_t i = 0, end = 0; i < grafts.size(); i = end) {
    end = i + 1;
    if (grafts[i] == LimbGraft{}) {
      while (end < grafts.size() && grafts[end] == grafts[i]) ++end;
      runs.push_back("graft " + std::to_string(end - i));
    } else {
      runs.push_back("graft " + number(grafts[i].own) + " to " + number(grafts[i].others));
    }
  }
  return runs;
}

// How often the `period` words from `first` on come there one after the other.
std::size_t often_there(const std::vector<std::string>& words, std::size_t first, std::size_t period) {
  std::size_t end = first + period;
  while (end < words.size() && words[end] == words[end - period]) ++end;
  return (end - first) / period;
}

// What comes again at once is told once: of the periods up to four the one that covers most.
std::string graft_words(const std::vector<LimbGraft>& grafts) {
  constexpr std::size_t longest = 4;
  const std::vector<std::string> runs = graft_runs(grafts);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t period = 1, times = 1;
    for (std::size_t tried = 1; tried <= longest && i + tried <= runs.size(); ++tried) {
      const std::size_t found = often_there(runs, i, tried);
      if (found > 1 && found * tried > period * times) period = tried, times = found;
    }
    const auto begin = runs.begin() + static_cast<std::ptrdiff_t>(i);
    const std::string block = with_commas({begin, begin + static_cast<std::ptrdiff_t>(period)});
    words.push_back(times == 1 ? block : "[" + block + "] " + std::to_string(times) + " times");
    i += period * times;
  }
  return with_commas(words);
}

std::string graft_sentence(const LimbPlan& plan, const LimbNames& names, const LimbEnd& end) {
  const std::int32_t held = plan.piece(end.piece).last_count();
  const std::int32_t first = end.other_first + 1;
  std::string back;
  if (end.slips_back == 1) back = "slip last st back, ";
  if (end.slips_back > 1) back = "slip last " + stitches_text(end.slips_back) + " back, ";
  const auto pairs = static_cast<std::int32_t>(end.grafts.size());
  return (end.three_needle ? "Three-needle bind off with " : "Graft to ") + names(end.piece) + " (" +
         stitches_text(held) + "), wrong sides together, its sts backwards from st " + number(first) +
         " to st " + number(first % held + 1) + ": " + back +
         (end.three_needle ? "bind off " + plural(pairs, "pair", "pairs") : graft_words(end.grafts)) +
         ". (0 sts)";
}

}  // namespace

bool is_piece_word(std::string_view word) {
  return word.size() >= 2 && word.size() <= 24 && word.front() >= 'A' && word.front() <= 'Z' &&
         std::all_of(word.begin() + 1, word.end(), is_small) && word != "Rnd" && word != "Rnds";
}

LimbNames::LimbNames(const LimbPlan& plan, const PatternOptions& options) {
  for (std::int32_t i = 0; i < plan.count(); ++i) {
    const auto given = options.piece_names.find(tube_name(i));
    const bool known = given != options.piece_names.end() && is_piece_word(given->second);
    words_.push_back(known ? given->second : std::string(word_of(plan.piece(i).role)));
  }
}

std::string LimbNames::operator()(std::int32_t piece) const { return word(piece) + " " + tube_name(piece); }

std::string LimbNames::holder(std::int32_t piece, std::int32_t number) const {
  return (*this)(piece) + (number > 0 ? " (holder " + std::to_string(number + 1) + ")" : "");
}

std::string LimbNames::together(const std::vector<std::int32_t>& pieces) const {
  if (pieces.size() == 1) return (*this)(pieces.front());
  std::vector<std::string> letters;
  letters.reserve(pieces.size());
  for (const std::int32_t piece : pieces) letters.push_back(tube_name(piece));
  return plural_of(word(pieces.front())) + " " + with_and(letters);
}

std::string LimbNames::listed(const std::vector<std::int32_t>& pieces) const {
  std::vector<std::string> names;
  names.reserve(pieces.size());
  for (const std::int32_t piece : pieces) names.push_back((*this)(piece));
  return with_and(names);
}

std::string plural_of(const std::string& word) {
  const auto ends = [&](std::string_view end) { return word.ends_with(end); };
  constexpr std::string_view vowels = "aeiou";
  if (word == "Foot") return "Feet";
  if (ends("y") && word.size() > 1 && vowels.find(word[word.size() - 2]) == std::string_view::npos)
    return word.substr(0, word.size() - 1) + "ies";
  return word + (ends("s") || ends("x") || ends("ch") || ends("sh") ? "es" : "s");
}

std::string holders_joined(const LimbNames& names, const LimbDeal& deal) {
  std::vector<std::string> holders;
  for (const LimbItem& item : deal.items) {
    if (item.kind != LimbItemKind::take) continue;
    std::string holder = names.holder(item.piece, item.holder);
    if (std::find(holders.begin(), holders.end(), holder) == holders.end())
      holders.push_back(std::move(holder));
  }
  return with_and(holders);
}

std::string cast_on_words(const LimbDeal& deal) {
  const std::string begins =
      deal.kind == LimbDealKind::provisional ? "With waste yarn, provisionally CO " : "CO ";
  return begins + stitches_text(deal.after) + ". Join in the round, place marker";
}

std::string deal_sentence(const LimbPlan& plan, const LimbNames& names, const LimbDeal& deal) {
  switch (deal.kind) {
    case LimbDealKind::loops:
      return counted(
          "Remove the waste yarn of " + names(deal.piece) + ", place its " + number(deal.after) +
              " loops on the needle; they run the other way. Rejoin yarn at the beginning of the rnd.",
          plan.piece(deal.piece).first_count());
    case LimbDealKind::rejoin:
      return counted("Rejoin yarn: " + items_text(names, deal) + ".", deal.after);
    case LimbDealKind::set_aside:
      return "Break yarn, place all " + stitches_text(deal.before) + " on a holder for " +
             names.holder(deal.piece, deal.holder) + ". (0 sts; " + names.holder(deal.piece, deal.holder) +
             " " + stitches_text(deal.before) + ")";
    case LimbDealKind::move:
      return counted("Break yarn, slip next " + stitches_text(deal.before) +
                         ", rejoin yarn before the other " + number(deal.rest) +
                         ": this is the new beginning of the rnd.",
                     deal.after);
    case LimbDealKind::divide:
      return divided_text(names, deal);
    case LimbDealKind::join:
      return counted("Join with " + holders_joined(names, deal) + ": " + items_text(names, deal) + ".",
                     deal.after);
    case LimbDealKind::cast_on:
    case LimbDealKind::provisional:
      break;
  }
  return cast_on_words(deal) + ".";
}

std::string end_sentence(const LimbPlan& plan, const LimbNames& names, const LimbPiece& piece) {
  const std::int32_t count = piece.last_count();
  switch (piece.end.kind) {
    case LimbEndKind::held:
      return "Break yarn. Place " + stitches_text(count) + " on a holder.";
    case LimbEndKind::goes_on:
      return "Do not break yarn. Go on with " + names(piece.end.piece) + ".";
    case LimbEndKind::grafted:
      return graft_sentence(plan, names, piece.end);
    case LimbEndKind::closed:
      break;
  }
  return closing_sentence(count, is_drawn_in(count)) + (is_drawn_in(count) ? "" : " Fasten off.");
}

}  // namespace knit
