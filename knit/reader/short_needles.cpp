#include "knit/reader/short_needles.h"

#include <algorithm>

#include "knit/import/quoting.h"
#include "knit/reader/reader_cursor.h"
#include "knit/reader/reader_grammar.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

using Step = ShortRowLine::Step;

// "DS", "k5", "k2tog", "w&t", "knit to end", "sm"
std::optional<Step> step_of(TokenCursor& at) {
  const Token first = at.peek();
  const auto plain = [&](Step::Kind kind) {
    at.skip();
    return Step{kind, Hand::knit, false, 1, first.text};
  };
  if (at.sees({"ds"})) return plain(Step::Kind::double_stitch);
  if (at.sees({"sm"})) return plain(Step::Kind::marker);
  if (at.sees({"turn"})) return plain(Step::Kind::turn);
  if (at.sees({"w"}) && at.sees({"&"}, 1) && at.sees({"t"}, 2)) {
    at.skip(3);
    return Step{Step::Kind::wrap, Hand::knit, false, 1, "w&t"};
  }
  const bool knits = at.sees({"k", "knit"});
  if (knits && at.sees({"to"}, 1) && at.sees({"end"}, 2)) {
    at.skip(3);
    return Step{Step::Kind::to_end, Hand::knit, false, 1, "k"};
  }
  const auto stitch = stitch_named(first);
  if (!stitch || stitch->kind.takes > 2 || stitch->kind.makes != 1 || stitch->kind.operations != 1)
    return std::nullopt;
  const std::string_view word = stitch->kind.word;
  if (word == "sl" || word == "slip" || word == "yo" || word == "p2tog" || word == "ssp") return std::nullopt;
  at.skip();
  const bool purled = word == "p" || word == "purl";
  return Step{Step::Kind::stitches, stitch->kind.hands[0], purled, stitch->count.value_or(1),
              std::string(word)};
}

// "(5 sts after BOR)", "(at BOR)", "(35 sts)"
bool read_bracket(TokenCursor& at, ShortRowLine& line) {
  if (!at.take({"("})) return true;
  if (at.take({"at"})) {
    line.place = 0;
    return at.take({"bor"}) && at.take({")"});
  }
  if (!at.peek().is_number() || !is_stitches_word(at.peek(1))) return false;
  const std::int64_t number = at.peek().value;
  at.skip(2);
  if (at.take({")"})) {
    line.stated = number;
    return true;
  }
  const bool before = at.sees({"before"});
  line.place = before ? -number : number;
  return at.take({"before", "after"}) && at.take({"bor"}) && at.take({")"});
}

void read_steps(TokenCursor& at, ShortRowLine& line) {
  const auto not_understood = [&] { line.mistake = "not understood: " + quoted(at.peek().text) + "."; };
  while (true) {
    const auto step = step_of(at);
    if (!step) return not_understood();
    line.steps.push_back(*step);
    if (line.kind == ShortRowLine::Kind::next_row && at.sees({"to"}) && at.sees({"bor"}, 1)) {
      at.skip(2);
      line.to_beginning = true;
      break;
    }
    if (!at.take({","})) break;
  }
  at.take({"."});
  if (!read_bracket(at, line)) return not_understood();
  at.take({"."});
  if (!at.done()) not_understood();
}

bool take_side(TokenCursor& at, ShortRowLine& line) {
  if (!at.take({"("}) || !at.sees({"rs", "ws"})) return false;
  line.wrong_side = at.sees({"ws"});
  at.skip();
  return at.take({")"}) && at.take({":"});
}

}  // namespace

std::optional<ShortRowLine> short_row_line(std::span<const Token> tokens) {
  TokenCursor at(tokens);
  ShortRowLine line;
  if (at.sees({"short"}) && at.sees({"row"}, 1) && at.peek(2).is_number()) {
    line.number = at.peek(2).value;
    at.skip(3);
    if (!take_side(at, line)) return std::nullopt;
  } else if (at.sees({"next"}) && at.sees({"row"}, 1) && at.sees({"("}, 2)) {
    line.kind = ShortRowLine::Kind::next_row;
    at.skip(2);
    if (!take_side(at, line)) return std::nullopt;
  } else {
    if (!is_round_word(at.peek()) || !at.peek(1).is_number()) return std::nullopt;
    line.kind = ShortRowLine::Kind::round;
    line.number = at.peek(1).value;
    at.skip(2);
    if (!at.take({"("}) || !at.take({"cont"})) return std::nullopt;
    at.take({"."});
    if (!at.take({")"}) || !at.take({":"})) return std::nullopt;
  }
  read_steps(at, line);
  return line;
}

ShortNeedles::ShortNeedles(std::int64_t live) : columns_(static_cast<std::int32_t>(live)) {
  for (std::int32_t column = 0; column < live; ++column) loops_.push_back({column, none});
}

// The loop that is worked next.
std::size_t ShortNeedles::ahead() const {
  const std::int64_t at = wrong_side_ ? cursor_ - 1 : cursor_;
  return static_cast<std::size_t>(at < 0 ? at + size() : at);
}

std::string ShortNeedles::work(const ShortRowLine& line) {
  ++line_;
  turns_.push_back(false);
  if (line.wrong_side != wrong_side_)
    return std::string("the needles show the ") + (wrong_side_ ? "WS" : "RS") + " here, the line says " +
           (line.wrong_side ? "WS." : "RS.");
  if (line.kind == ShortRowLine::Kind::short_row && line.number != ++short_rows_)
    return "Short row " + std::to_string(line.number) + " stands here, and Short row " +
           std::to_string(short_rows_) + " comes next.";
  if (line.kind != ShortRowLine::Kind::short_row && short_rows_ == 0)
    return "no short row was worked before it.";
  for (const Step& next : line.steps) {
    if (turns_.back()) return "nothing is worked after the turn.";
    std::string mistake = step(line, next);
    if (!mistake.empty()) return mistake;
  }
  return end_of(line);
}

std::string ShortNeedles::step(const ShortRowLine& line, const Step& step) {
  if (step.kind == Step::Kind::double_stitch) return double_stitch();
  if (after_turn_) return "after a turn the first stitch must be a DS.";
  switch (step.kind) {
    case Step::Kind::marker:
      return marker();
    case Step::Kind::turn:
    case Step::Kind::wrap:
      if (line.kind != ShortRowLine::Kind::short_row) return "a turn stands in a line that is no short row.";
      wrong_side_ = !wrong_side_;
      turns_.back() = true;
      after_turn_ = step.kind == Step::Kind::turn;
      return {};
    default:
      return stitches(step);
  }
}

std::string ShortNeedles::double_stitch() {
  if (!after_turn_) return "DS without a turn before it.";
  after_turn_ = false;
  std::string not_last = "DS is not made from the stitch that was worked last.";
  const std::int64_t at = wrong_side_ ? cursor_ - 1 : cursor_;
  if (at >= size()) return not_last;
  Loop& loop = loops_[ahead()];
  if (stitches_.empty() || loop.top != static_cast<std::int32_t>(stitches_.size()) - 1) return not_last;
  const Stitch& last = stitches_.back();
  if (last.hand != Hand::knit) return "a DS is made from a stitch that is knitted or purled alone.";
  loop.top = last.under;
  stitches_.pop_back();
  cursor_ += wrong_side_ ? -1 : 1;
  return {};
}

std::string ShortNeedles::marker() const {
  if (cursor_ == 0 || cursor_ == size()) return {};
  const std::int64_t away = std::min(std::abs(cursor_), std::abs(size() - cursor_));
  return "the marker is not here: " + stitches_text(away) + " away.";
}

std::string ShortNeedles::stitches(const Step& step) {
  if (step.purled != wrong_side_ || (wrong_side_ && step.hand != Hand::knit))
    return step.word + " on the " + (wrong_side_ ? "WS" : "RS") + " of stockinette.";
  const bool to_end = step.kind == Step::Kind::to_end;
  std::int64_t count = to_end ? size() - cursor_ : step.count;
  if (to_end && count <= 0) return "the round has no more stitches.";
  for (; count > 0; --count) {
    std::string mistake = one(step.hand);
    if (!mistake.empty()) return mistake;
  }
  return {};
}

std::string ShortNeedles::one(Hand hand) {
  if (hand != Hand::knit) {
    if (cursor_ < 0) return std::string("no stitch is shaped before the beginning of the round.");
    if (cursor_ + consumed_by(hand) > size()) return "the round has no more stitches.";
    if (size() >= most_stitches && consumed_by(hand) == 0)
      return "it makes more than " + stitches_text(most_stitches) + ".";
    shape(hand);
    return {};
  }
  if (!wrong_side_ && cursor_ >= size()) return "the round has no more stitches.";
  if (wrong_side_ && cursor_ <= -size()) return "the round has no more stitches.";
  Loop& loop = loops_[ahead()];
  const bool before_beginning = (wrong_side_ ? cursor_ - 1 : cursor_) < 0;
  const std::int32_t place = before_beginning ? loop.column - columns_ : loop.column;
  stitches_.push_back({hand, wrong_side_, place, loop.column != none, loop.top, line_});
  loop.top = static_cast<std::int32_t>(stitches_.size()) - 1;
  cursor_ += wrong_side_ ? -1 : 1;
  return {};
}

void ShortNeedles::shape(Hand hand) {
  const auto at = static_cast<std::size_t>(cursor_);
  const auto next = static_cast<std::int32_t>(stitches_.size());
  if (consumed_by(hand) == 0) {
    stitches_.push_back({hand, false, none, false, none, line_});
    loops_.insert(loops_.begin() + cursor_, Loop{none, next});
  } else {
    stitches_.push_back({hand, false, loops_[at].column, loops_[at].column != none, loops_[at].top, line_});
    loops_[at].top = next;
    loops_.erase(loops_.begin() + cursor_ + 1);
  }
  ++cursor_;
}

std::string ShortNeedles::end_of(const ShortRowLine& line) const {
  if (line.kind == ShortRowLine::Kind::short_row)
    return turns_.back() ? turned_at(line) : "a short row must end with a turn.";
  if (line.kind == ShortRowLine::Kind::next_row) {
    if (!line.to_beginning) return "say how far the row goes: to BOR.";
    return cursor_ == 0 ? std::string{} : "BOR is " + stitches_text(std::abs(cursor_)) + " away.";
  }
  const std::string name = "Rnd " + std::to_string(line.number);
  if (cursor_ != size())
    return name + " works " + std::to_string(cursor_) + " of " + stitches_text(size()) + ".";
  if (!line.stated) return name + " has no count of stitches at its end.";
  if (*line.stated == size()) return {};
  return name + " makes " + stitches_text(size()) + ", the line says " + std::to_string(*line.stated) + ".";
}

std::string ShortNeedles::turned_at(const ShortRowLine& line) const {
  const auto words = [](std::int64_t place, const std::string& stitches) {
    if (place == 0) return std::string("at BOR");
    return stitches + (place > 0 ? " after BOR" : " before BOR");
  };
  if (!line.place)
    return "say where the short row turns: (" + words(cursor_, stitches_text(std::abs(cursor_))) + ").";
  if ((cursor_ - *line.place) % size() == 0) return {};
  return "the turn is " + words(cursor_, stitches_text(std::abs(cursor_))) + ", the line says " +
         words(*line.place, std::to_string(std::abs(*line.place))) + ".";
}

std::string ShortNeedles::keeps_from_round() const {
  if (wrong_side_) return "begins while the needles show the WS.";
  if (after_turn_ || cursor_ != 0)
    return "begins " + stitches_text(std::abs(cursor_)) + (cursor_ < 0 ? " before" : " after") +
           " the BOR; go on to the BOR first, or say (cont.).";
  return {};
}

// Runs of one line that are no round's. Pairs as they are turned: the last stitches of an RS run and of the WS run after it.
void ShortNeedles::add_short_rows(const std::vector<bool>& of_round, Worked& worked) const {
  std::int32_t made = 0, last = 0;
  std::optional<std::int32_t> out;  // where the RS row turned
  for (std::size_t i = 0; i < stitches_.size(); ++i) {
    const Stitch& stitch = stitches_[i];
    if (of_round[i]) {
      ++made;
      continue;
    }
    if (!stitch.has_column || stitch.hand != Hand::knit) worked.told = false;
    if (stitch.line == last) {
      GraphShortRow& row = worked.short_rows.back();
      const std::int32_t next = row.first + (row.wrong_side ? -row.stitches : row.stitches);
      if (stitch.place != next || row.worked != made) worked.told = false;
      ++row.stitches;
    } else {
      worked.short_rows.push_back({0, stitch.place, 1, stitch.wrong_side, made});
    }
    last = stitch.line;
    const bool ends = i + 1 == stitches_.size() || stitches_[i + 1].line != last;
    if (!ends || !turns_[static_cast<std::size_t>(last) - 1]) continue;
    if (stitch.wrong_side && out) worked.pairs.push_back({stitch.place, *out});
    out = stitch.wrong_side ? std::nullopt : std::optional(stitch.place);
  }
}

ShortNeedles::Worked ShortNeedles::worked() const {
  Worked worked;
  worked.made = size();
  std::vector<bool> of_round(stitches_.size(), false);
  const bool whole = cursor_ == size();
  std::int32_t last = none;
  for (const Loop& loop : loops_) {
    if (!whole) break;
    if (loop.top <= last) worked.told = false;  // not worked from the beginning of the round on
    last = loop.top;
    if (loop.top == none) continue;
    of_round[static_cast<std::size_t>(loop.top)] = true;
    worked.operations.push_back({stitches_[static_cast<std::size_t>(loop.top)].hand, false});
  }
  add_short_rows(of_round, worked);
  return worked;
}

}  // namespace knit
