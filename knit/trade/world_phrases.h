// What is told in more than a word: how often, up to where, and what is done with holders, markers and edges. For the
// grammar's files alone.
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "knit/trade/world_grammar.h"

namespace knit {

// "6 times", "twice more", "a total of 5 times", "to end", "to last 2 sts", "in each st", "to 2 sts before next marker"
struct RepeatWords {
  WorldNode::Until until = WorldNode::Until::times;
  std::int64_t times = 1;
  std::optional<std::int64_t> tail;
  bool more = false, in_all = false, each = false, next = false;
};

// A place in a line of atoms. Beyond the end stands an empty atom.
class PhraseCursor {
 public:
  PhraseCursor(std::span<const Atom> line, const Lexicon& lexicon) : line_(line), lexicon_(lexicon) {}
  [[nodiscard]] const Atom& peek(std::size_t ahead = 0) const {
    return at_ + ahead < line_.size() ? line_[at_ + ahead] : nothing_;
  }
  [[nodiscard]] bool done() const { return at_ >= line_.size(); }
  [[nodiscard]] bool sees(AtomWords words, std::size_t ahead = 0) const { return is_any(peek(ahead), words); }
  bool take(AtomWords words) {
    if (done() || !sees(words)) return false;
    ++at_;
    return true;
  }
  void skip(std::size_t count = 1) { at_ = std::min(line_.size(), at_ + count); }
  [[nodiscard]] std::size_t at() const { return at_; }
  void back_to(std::size_t at) { at_ = at; }
  // The byte behind the last atom taken.
  [[nodiscard]] std::size_t behind() const {
    return at_ == 0 ? 0 : line_[at_ - 1].at + line_[at_ - 1].length;
  }
  [[nodiscard]] std::optional<MatchedWord> match() const { return lexicon_.match(line_, at_); }
  [[nodiscard]] std::optional<MatchedWord> match(std::size_t ahead) const {
    return lexicon_.match(line_, at_ + ahead);
  }
  // Up to the next comma, full stop or end.
  [[nodiscard]] std::span<const Atom> part() const;

  std::optional<RepeatWords> repeat_words();
  std::optional<std::int64_t> times_only();
  bool star_words();  // "from *", "between *s", "from * to *", "*": behind "rep"
  void suffix();      // "tbl", "purlwise"
  bool one_stitch();  // "in next st", "into the same stitch"
  bool remark();      // "with MC", "being careful not to twist", "(dec)": changes nothing

 private:
  std::optional<RepeatWords> numbered_times();
  std::optional<RepeatWords> end_words();
  std::optional<RepeatWords> each_words();
  bool of_the_round();
  bool remark_words();
  [[nodiscard]] bool works_behind_first() const;
  bool colour_words();
  bool remark_in_brackets();
  [[nodiscard]] std::size_t note_end() const;

  std::span<const Atom> line_;
  const Lexicon& lexicon_;
  std::size_t at_ = 0;
  Atom nothing_{};
};

// Markers, holders, edges, turns, "decreasing 8 sts evenly", "work in pattern"; nothing where none stands there.
std::optional<WorldNode> phrase_here(PhraseCursor& at);

}  // namespace knit
