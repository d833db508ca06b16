#include "knit/pattern/short_row_words.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "knit/pattern/passes.h"
#include "knit/pattern/pattern_words.h"

namespace knit {

namespace {

// Words one after the other; knit and purl stitches are counted.
class WordList {
 public:
  void add(std::string_view word) {
    const bool counted = word == "k" || word == "p";
    if (counted && !words_.empty() && words_.back().first == word)
      ++words_.back().second;
    else
      words_.emplace_back(word, counted ? 1 : 0);
  }

  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& [word, count] : words_)
      text += (text.empty() ? "" : ", ") + word + (count > 0 ? std::to_string(count) : "");
    if (!text.empty())
      text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
  }

 private:
  std::vector<std::pair<std::string, std::int32_t>> words_;
};

class LineWriter {
 public:
  LineWriter(const Round& round, ShortRowTurns turns)
      : round_(round), german_(turns != ShortRowTurns::wrap) {}

  ShortRowLines run() {
    ShortRowLines told;
    for (const Pass& pass : passes_of(round_)) {
      told.rest_is_told = pass.end == Pass::End::round && turned_;
      if (pass.end != Pass::End::round || turned_) told.lines.push_back(line_of(pass));
      turned_ = pass.turns();
    }
    return told;
  }

 private:
  RoundLine line_of(const Pass& pass) {
    WordList words;
    if (turned_ && german_) words.add("DS");
    const bool all_knit = std::all_of(pass.stitches.begin(), pass.stitches.end(), [](const PassStitch& s) {
      return !s.in_short_row && s.operation.hand == Hand::knit;
    });
    const bool rest = pass.end == Pass::End::round;
    if (rest && all_knit)
      words.add("knit to end");
    else
      add_stitches(pass, words);
    RoundLine line{round_.number, round_.number, {}, round_.after};
    if (rest) {
      line.label = "Rnd " + std::to_string(round_.number) + " (cont.)";
      line.place = stitches_text(round_.after);
    } else if (pass.end == Pass::End::home) {
      line.label = "Next row (RS)";
    } else {
      turn(pass, words);
      line.label = "Short row " + std::to_string(++number_) + (pass.wrong_side() ? " (WS)" : " (RS)");
      line.place = place_after(pass);
    }
    line.words = words.text() + (pass.end == Pass::End::home ? " to BOR" : "");
    line.short_row = !rest;
    return line;
  }

  // The marker of the round is slipped where a row crosses it.
  void add_stitches(const Pass& pass, WordList& words) const {
    const bool wrong_side = pass.wrong_side();
    for (std::size_t i = 0; i < pass.stitches.size(); ++i) {
      const PassStitch& stitch = pass.stitches[i];
      if (i > 0 && !wrong_side && stitch.column == 0 && pass.stitches[i - 1].column == -1) words.add("sm");
      if (i > 0 && wrong_side && stitch.column == -1) words.add("sm");
      words.add(!stitch.in_short_row ? word_of(stitch.operation.hand) : wrong_side ? "p" : "k");
    }
  }

  void turn(const Pass& pass, WordList& words) const {
    if (!german_) return words.add("w&t");
    words.add(pass.wrong_side() ? "p" : "k");
    words.add("turn");
  }

  // Between which stitches the needles part.
  [[nodiscard]] std::string place_after(const Pass& pass) const {
    const std::int32_t beyond = german_ ? 1 : 0;
    const std::int32_t column = pass.stitches.back().column;
    std::int32_t place = pass.wrong_side() ? column - beyond : column + 1 + beyond;
    if (place < 0) return stitches_text(-place) + " before BOR";
    place += pass.change;
    if (place == 0 || place == round_.before + pass.change) return "at BOR";
    return stitches_text(place) + " after BOR";
  }

  const Round& round_;
  bool german_;
  bool turned_ = false;
  std::int32_t number_ = 0;
};

}  // namespace

ShortRowLines short_row_lines(const Round& round, ShortRowTurns turns) {
  return LineWriter(round, turns).run();
}

}  // namespace knit
