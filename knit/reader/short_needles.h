// Short rows as a knitter works them from a written line, on needles in the round.
//
// Understood are "Short row 1 (RS): DS, k5, turn. (5 sts after BOR)", "Next row (RS): DS, k3 to BOR." and "Rnd 8 (cont.): ...".
// The needles are a ring of loops with a cursor between two of them and the side that faces: k moves the cursor forward on the
// right side, p back on the wrong side, a turn changes the side, a DS gives back the stitch worked last. Nothing is known of
// pairs or of an order in which they come: when the round is whole, the stitch on top of each loop is the round's, and what lies
// below is short rows. Sentences say what does not add up. O(1) a stitch, an increase or decrease O(stitches of the round).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knit/pattern/rounds.h"
#include "knit/reader/reader_words.h"

namespace knit {

struct ShortRowLine {
  enum class Kind : std::uint8_t { short_row, next_row, round };
  struct Step {
    enum class Kind : std::uint8_t { double_stitch, marker, turn, wrap, stitches, to_end };
    Kind kind = Kind::stitches;
    Hand hand = Hand::knit;
    bool purled = false;
    std::int64_t count = 1;
    std::string word;  // for messages
  };
  Kind kind = Kind::short_row;
  std::int64_t number = 0;  // of the short row or the round
  bool wrong_side = false;
  std::vector<Step> steps;
  bool to_beginning = false;           // "to BOR"
  std::optional<std::int64_t> place;   // where the work is turned: stitches after the BOR, before it negative
  std::optional<std::int64_t> stated;  // "(35 sts)"
  std::string mistake;                 // empty, or what cannot be read
};
// Nothing where the line is none of these. Case and blanks do not matter.
std::optional<ShortRowLine> short_row_line(std::span<const Token> tokens);

class ShortNeedles {
 public:
  // `live` loops, at most most_stitches, with the cursor at the BOR and the right side facing.
  explicit ShortNeedles(std::int64_t live);
  // Empty, or why the line cannot be worked: then nothing more is to be worked here.
  std::string work(const ShortRowLine& line);
  // Empty where an ordinary round may begin: at the BOR, on the right side, with nothing of the round worked.
  [[nodiscard]] std::string keeps_from_round() const;

  struct Worked {
    std::vector<Operation> operations;      // of the round; none where it is still to come
    std::int64_t made = 0;                  // stitches on the needles
    std::vector<ShortRowPair> pairs;        // in working order
    std::vector<GraphShortRow> short_rows;  // `row` is 0
    bool told = true;                       // Rounds can hold it
  };
  [[nodiscard]] Worked worked() const;

 private:
  static constexpr std::int32_t none = -1;
  struct Loop {
    std::int32_t column = none;  // of the round below; none: made since
    std::int32_t top = none;     // the stitch worked last; none: still the round below's
  };
  struct Stitch {
    Hand hand = Hand::knit;
    bool wrong_side = false;
    std::int32_t place = none;  // column of the round below, before the BOR negative
    bool has_column = true;
    std::int32_t under = none;
    std::int32_t line = 0;
  };
  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(loops_.size()); }
  [[nodiscard]] std::size_t ahead() const;
  std::string step(const ShortRowLine& line, const ShortRowLine::Step& step);
  std::string double_stitch();
  std::string marker() const;
  std::string stitches(const ShortRowLine::Step& step);
  std::string one(Hand hand);
  void shape(Hand hand);
  [[nodiscard]] std::string end_of(const ShortRowLine& line) const;
  [[nodiscard]] std::string turned_at(const ShortRowLine& line) const;
  void add_short_rows(const std::vector<bool>& of_round, Worked& worked) const;

  std::int32_t columns_;
  std::vector<Loop> loops_;
  std::vector<Stitch> stitches_;
  std::int64_t cursor_ = 0;
  std::int32_t line_ = 0;
  std::int64_t short_rows_ = 0;  // read, for their numbers
  std::vector<bool> turns_;      // of each line, whether it ends with one
  bool wrong_side_ = false, after_turn_ = false;
};

}  // namespace knit
