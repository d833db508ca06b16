#include "knit/pattern/pattern_words.h"

#include <algorithm>
#include <iterator>

#include "knit/pattern/short_row_words.h"

namespace knit {

namespace {

void add_word(std::string& text, const std::string& word) {
  if (!text.empty()) text += ", ";
  text += word;
}

void add_run(std::string& text, const Run& run) {
  if (run.marker) add_word(text, "sm");
  if (run.hand == Hand::knit) {
    add_word(text, "K" + std::to_string(run.count));
  } else {
    for (std::int32_t i = 0; i < run.count; ++i) add_word(text, std::string(word_of(run.hand)));
  }
}

std::string block_text(const Repeat& repeat) {
  std::string text;
  for (const Run& run : repeat.runs) add_run(text, run);
  return text;
}

std::string words_of(const Round& round, const PatternOptions& options) {
  const bool plain = std::all_of(round.operations.begin(), round.operations.end(),
                                 [](const Operation& o) { return o.hand == Hand::knit; });
  if (plain) return "Knit";
  return words_of(fold(round.operations, {options.markers}), {options.stars});
}

}  // namespace

std::string_view word_of(Hand hand) {
  switch (hand) {
    case Hand::m1r:
      return "m1r";
    case Hand::m1l:
      return "m1l";
    case Hand::k2tog:
      return "k2tog";
    case Hand::ssk:
      return "ssk";
    case Hand::knit:
      break;
  }
  return "k";
}

std::string words_of(std::span<const Phrase> phrases, const WordsOptions& options) {
  if (options.stars && phrases.size() == 1) {
    if (const auto* repeat = std::get_if<Repeat>(&phrases.front()))
      return "*" + block_text(*repeat) + "; rep from * to end";
  }
  std::string text;
  for (const Phrase& phrase : phrases) {
    if (const auto* run = std::get_if<Run>(&phrase)) {
      add_run(text, *run);
    } else {
      const auto& repeat = std::get<Repeat>(phrase);
      add_word(text, "[" + block_text(repeat) + "] " + std::to_string(repeat.times) + " times");
    }
  }
  return text;
}

std::string stitches_text(std::int32_t count) {
  return std::to_string(count) + (count == 1 ? " st" : " sts");
}

std::string RoundLine::text() const {
  if (!label.empty()) return label + ": " + words + "." + (place.empty() ? "" : " (" + place + ")");
  const std::string name = first == last ? "Rnd " + std::to_string(first)
                                         : "Rnds " + std::to_string(first) + "-" + std::to_string(last);
  const std::string moved = moves_marker ? ", marker moved back 1 st" : "";
  std::string after;
  for (std::size_t i = 0; i + 1 < counts.size(); ++i) after += std::to_string(counts[i]) + ", ";
  return name + ": " + words + ". (" + after + stitches_text(stitches) + moved + ")";
}

std::vector<RoundLine> round_lines(const Rounds& rounds, const PatternOptions& options) {
  std::vector<RoundLine> lines;
  bool joins = false;  // a line that takes in more rounds; none does where short rows come before it
  for (const Round& round : rounds.rounds) {
    if (!round.pairs.empty()) {
      ShortRowLines told = short_row_lines(round, options.turns);
      std::move(told.lines.begin(), told.lines.end(), std::back_inserter(lines));
      joins = false;
      if (told.rest_is_told) continue;
    }
    std::string words = words_of(round, options);
    // The count tells apart rounds in the stars' style, whose words fit any count.
    const bool same =
        joins && !lines.empty() && lines.back().words == words && lines.back().stitches == round.after;
    if (same)
      lines.back().last = round.number;
    else
      lines.push_back({round.number, round.number, std::move(words), round.after, 0, {}, false});
    joins = round.pairs.empty();
  }
  return lines;
}

}  // namespace knit
