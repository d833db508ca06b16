#include "knit/reader/pattern_reader.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "knit/import/quoting.h"
#include "knit/pattern/passes.h"
#include "knit/reader/limbs_reader.h"
#include "knit/reader/named_rounds.h"
#include "knit/reader/reader_text.h"
#include "knit/reader/reader_work.h"
#include "knit/reader/short_needles.h"

namespace knit {

namespace {

constexpr std::int64_t most_work = 4'000'000;  // stitches in all; a round costs some by itself
constexpr std::int64_t work_of_a_round = 16;

std::string name_of_round(std::int64_t first, std::int64_t last) {
  if (first == last) return "Rnd " + std::to_string(first);
  return "Rnds " + std::to_string(first) + "-" + std::to_string(last);
}

// The counts that may be on the needles: one as long as all holds; after a mistake the stated and the made one,
// whichever the next round works out with; none where nobody can tell.
using Counts = std::vector<std::int64_t>;

class Reader {
 public:
  ReadPattern run(std::string_view text) {
    for (const TextLine& line : pattern_lines(text)) {
      line_ = line.number;
      const Tokens tokens = tokens_of(line.text);
      // Rows to and fro have a "Next row (RS)" too.
      const auto row = short_row_line(tokens);
      if (row && (needles_ || row->kind != ShortRowLine::Kind::next_row))
        short_row(*row);
      else if (const auto label = label_of(tokens))
        round_line(*label, std::span(tokens).subspan(label->tokens));
      else
        prose(tokens);
      if (stopped_) break;
    }
    if (needles_ && !needles_failed_) blame("the text ends, and the round after the short rows is missing.");
    return std::move(read_);
  }

 private:
  void blame(const std::string& sentence) {
    read_.mistakes.push_back({line_, "line " + std::to_string(line_) + ": " + sentence});
    sound_ = false;
  }

  // --- Lines without a label -----------------------------------------------------------------------------------

  // "CO: cast on", "BO bind off" tell what a word means.
  static bool is_glossary(const Tokens& tokens) {
    if (tokens.size() < 2 || !(tokens[0].is("co") || tokens[0].is("bo"))) return false;
    const Token& next = tokens[1];
    return next.is(":") || next.is("=") || next.is("-") || next.is("/") || next.is("|") || next.is("cast") ||
           next.is("bind");
  }

  void prose(const Tokens& tokens) {
    if (is_glossary(tokens)) return;
    if (const auto named = named_words_in(tokens)) return name_round(*named);
    if (const auto number = cast_on_in(tokens)) {
      if (read_.rounds_read > 0)
        second_piece();
      else
        cast_on(*number, tokens, says_round_one(tokens));
      place_markers(tokens);
      return;
    }
    place_markers(tokens);
    if ((read_.rounds_read == 0 && !needles_) || closed_) return;
    if (const auto closing = closing_in(tokens)) close(*closing);
  }

  void name_round(const NamedWords& named) {
    if (!named.words.mistake.empty()) blame("the " + named.name + named.words.mistake);
    if (!named_.try_emplace(named.name, named.words).second)
      blame("the " + named.name + " is told twice; give each way to shape a name of its own.");
  }

  // Of halves that are shaped apart.
  void place_named_markers(const NamedMarkers& placed) {
    const bool rise = std::adjacent_find(placed.after.begin(), placed.after.end(), std::greater_equal<>()) ==
                      placed.after.end();
    if (!rise || placed.after.front() < 1 || placed.after.back() >= counts_.front()) {
      blame("the markers do not stand one after the other among " + stitches_text(counts_.front()) + ".");
      return;
    }
    sections_ = 0;
    markers_ = placed.after;
    markers_.push_back(counts_.front());
    marker_names_ = placed.names;
  }

  void place_markers(std::span<const Token> tokens) {
    const auto named = counts_.size() == 1 ? named_markers_in(tokens) : std::nullopt;
    if (named) return place_named_markers(*named);
    const auto placed = markers_placed_in(tokens);
    if (!placed || counts_.size() != 1) return;
    if (placed->markers < 1 || placed->every < 1 || placed->markers * placed->every != counts_.front()) {
      blame("a marker after every " + stitches_text(placed->every) + " and " +
            std::to_string(placed->markers) + " markers do not go round " + stitches_text(counts_.front()) +
            ".");
      return;
    }
    sections_ = placed->markers;
    markers_ = equal_sections(counts_.front());
  }

  [[nodiscard]] Markers equal_sections(std::int64_t live) const {
    Markers markers;
    for (std::int64_t i = 1; i <= sections_; ++i) markers.push_back(live / sections_ * i);
    return markers;
  }

  // Where they stand among so many stitches. After a mistake they are taken to stand in equal sections again.
  [[nodiscard]] Markers markers_among(std::int64_t live) const {
    if (!markers_.empty() && markers_.back() == live) return markers_;
    return sections_ > 0 && !sound_ && live % sections_ == 0 ? equal_sections(live) : Markers{};
  }

  void second_piece() {
    blame("another cast on stands here, and one piece is read; put each piece into a text of its own.");
    stopped_ = true;
  }

  static bool says_round_one(const Tokens& tokens) {
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      if (is_round_word(tokens[i]) && tokens[i + 1].is_number() && tokens[i + 1].value == 1) return true;
      if (tokens[i].is("first") && is_round_word(tokens[i + 1])) return true;
    }
    return false;
  }

  void cast_on(std::int64_t number, std::span<const Token> words, bool is_round_one) {
    if (has_cast_on_) {
      if (number != cast_on_)
        blame("casts on " + stitches_text(number) + ", and " + std::to_string(cast_on_) +
              " are cast on already.");
      return;
    }
    has_cast_on_ = true;
    cast_on_ = number;
    if (is_round_one) next_ = 2;
    if (number < 1 || number > most_stitches) {
      blame("casts on " + stitches_text(number) + "; give a number from 1 to " +
            std::to_string(most_stitches) + ".");
      return;
    }
    counts_ = {number};
    read_.rounds.cast_on = static_cast<std::int32_t>(number);
    read_.stitches += number;
    const auto stated = stated_in(words);
    if (!stated || *stated == number) return;
    blame("the cast on makes " + stitches_text(number) + ", the line says " + std::to_string(*stated) + ".");
    counts_.push_back(*stated);
  }

  void close(const ClosingWords& closing) {
    closed_ = true;
    closed_line_ = line_;
    if (needles_ && !needles_failed_)
      blame("the stitches are closed, and the round after the short rows is missing.");
    needles_.reset();
    const std::int64_t there = counts_.empty() ? closing.number.value_or(0) : counts_.front();
    const std::int64_t number = closing.number.value_or(there);
    read_.closed_with = static_cast<std::int32_t>(std::min(number, most_number));
    if (counts_.empty() || std::find(counts_.begin(), counts_.end(), number) != counts_.end()) return;
    blame("closes " + stitches_text(number) + ", and " + std::to_string(there) +
          (there == 1 ? " is" : " are") + " on the needles.");
  }

  // --- Short rows ----------------------------------------------------------------------------------------------

  void short_row(const ShortRowLine& row) {
    const bool is_round = row.kind == ShortRowLine::Kind::round;
    const std::string name = name_of_round(row.number, row.number);
    if (closed_) {
      blame((is_round ? name : "a short row") + " comes after the stitches were closed in line " +
            std::to_string(closed_line_) + ".");
      stopped_ = true;
      return;
    }
    if (!has_cast_on_ && read_.mistakes.empty())
      blame("short rows begin and no stitches are cast on; say \"CO 6 sts\" before it.");
    const std::size_t mistakes_before = read_.mistakes.size();
    if (is_round) {
      number_in_turn(true, row.number, row.number);
      ++read_.rounds_read;
    }
    if (!needles_ && counts_.size() == 1) {
      needles_.emplace(counts_.front());
      needles_failed_ = false;
    }
    const bool known = needles_ && !needles_failed_ && !counts_.empty();
    if (known || !row.mistake.empty()) work_short_row(row, known, mistakes_before);
    if (is_round) end_short_rows(row, mistakes_before);
  }

  void work_short_row(const ShortRowLine& row, bool known, std::size_t mistakes_before) {
    spend(counts_.empty() ? 0 : counts_.front());
    const std::string mistake = row.mistake.empty() && known ? needles_->work(row) : row.mistake;
    if (mistake.empty()) return;
    if (read_.mistakes.size() == mistakes_before) blame(mistake);
    needles_failed_ = true;
  }

  // "Rnd 8 (cont.)" was worked, or a mistake before it leaves what it says.
  void end_short_rows(const ShortRowLine& row, std::size_t mistakes_before) {
    const bool sound =
        needles_ && !needles_failed_ && !counts_.empty() && read_.mistakes.size() == mistakes_before;
    if (!sound) {
      needles_.reset();
      return go_on_with(row.stated);
    }
    const std::int64_t live = counts_.front();
    ShortNeedles::Worked worked = needles_->worked();
    needles_.reset();
    read_.stitches += worked.made;
    counts_ = {worked.made};
    markers_.clear();
    WorkedRound round;
    round.told = worked.told;
    round.made = worked.made;
    round.operations = std::move(worked.operations);
    pending_ = std::move(worked);
    keep(std::move(round), live);
  }

  // An ordinary round after short rows that stand alone.
  void round_after_short_rows(const std::string& name) {
    if (!needles_) return;
    if (!needles_failed_) {
      const std::string why = needles_->keeps_from_round();
      if (!why.empty()) blame(name + " " + why);
      pending_ = needles_->worked();
    }
    needles_.reset();
  }

  // --- Rounds --------------------------------------------------------------------------------------------------

  void round_line(const RoundLabel& label, std::span<const Token> words) {
    const std::size_t mistakes_before = read_.mistakes.size();
    const std::int64_t first = label.first.value_or(next_);
    const std::int64_t last = label.first ? label.last : next_;
    const std::string name = name_of_round(first, last);
    if (closed_) {
      blame(name + " comes after the stitches were closed in line " + std::to_string(closed_line_) + ".");
      stopped_ = true;
      return;
    }
    round_after_short_rows(name);
    if (!label.mistake.empty()) blame((label.first ? name : "the round") + label.mistake);
    if (const auto number = cast_on_in(words)) return labelled_cast_on(*number, first, words);
    if (!has_cast_on_ && read_.rounds_read == 0 && read_.mistakes.empty())
      blame(name + " begins and no stitches are cast on; say \"CO 6 sts\" before it.");
    if (label.first)
      number_in_turn(label.mistake.empty(), first, last);
    else
      ++next_;
    if (last - first >= most_rounds_in_line) {
      blame(name + " are more than " + std::to_string(most_rounds_in_line) + " rounds in one line.");
      counts_.clear();
      return;
    }
    const auto closing = closing_in(words);
    if (closing) words = words.first(closing->at);
    const bool only_closes = closing && std::all_of(words.begin(), words.end(), [](const Token& t) {
                               return t.kind == Token::Kind::mark;
                             });
    if (!only_closes) work(first, last, words, mistakes_before);
    if (closing) close(*closing);
  }

  void labelled_cast_on(std::int64_t number, std::int64_t first, std::span<const Token> words) {
    if (has_cast_on_ || read_.rounds_read > 0) return second_piece();
    if (first > 1) blame(name_of_round(first, first) + " casts on; the cast on is Rnd 1.");
    for (const Token& token : words) {
      if (!stitch_named(token) || token.is("slip")) continue;
      blame(name_of_round(first, first) + " casts on and works " + quoted(token.text) +
            "; give what is worked a round of its own.");
      break;
    }
    cast_on(number, words, false);
    next_ = first + 1;
    also_next_.clear();
  }

  // A gap or a repetition; the lines after it may go on from either number.
  void number_in_turn(bool label_is_sound, std::int64_t first, std::int64_t last) {
    const std::int64_t span = last - first + 1;
    const bool in_turn =
        first == next_ || std::find(also_next_.begin(), also_next_.end(), first) != also_next_.end();
    also_next_.clear();
    if (!in_turn) {
      if (label_is_sound) blame(out_of_turn(first, last));
      also_next_ = {next_, next_ + span};
      counts_.clear();
    }
    next_ = last + 1;
  }

  [[nodiscard]] std::string out_of_turn(std::int64_t first, std::int64_t last) const {
    const std::string name = name_of_round(first, last) + (first == last ? " stands" : " stand");
    const std::string wanted = name_of_round(next_, next_);
    if (first < next_ && read_.rounds_read > 0)
      return name + " here, and " + name_of_round(next_ - 1, next_ - 1) + " was read already; " + wanted +
             " comes next.";
    if (first < next_) return name + " here, and the cast on is Rnd 1 already; " + wanted + " comes next.";
    const std::string missing =
        name_of_round(next_, first - 1) + (next_ == first - 1 ? " is" : " are") + " missing";
    if (read_.rounds_read > 0 || next_ != 1 || first != 2) return name + " here, and " + missing + ".";
    return name + " first, and " + missing + "; if the cast on is Rnd 1, its line must say so.";
  }

  void work(std::int64_t first, std::int64_t last, std::span<const Token> tokens,
            std::size_t mistakes_before) {
    if (const auto told = told_rounds_in(tokens)) return work_told(first, last, *told, mistakes_before);
    const RoundWords words = round_words(tokens, sections_ > 0 ? MarkerWords::known : MarkerWords::unknown);
    read_.rounds_read += static_cast<std::size_t>(last - first + 1);
    if (!words.mistake.empty()) {
      // One sentence a line: a label that is wrong has been said.
      if (read_.mistakes.size() == mistakes_before) blame(name_of_round(first, last) + words.mistake);
      go_on_with(words.stated);
      return;
    }
    const bool quiet = read_.mistakes.size() > mistakes_before;
    for (std::int64_t number = first; number <= last && !stopped_; ++number) {
      const bool stated_here = number == last;
      if (!work_one(number, words, stated_here, quiet)) return go_on_with(words.stated);
    }
  }

  // "[Knit 1 rnd, inc rnd] 6 times. (16, 24, 32, 40, 48, 56 sts)"
  void work_told(std::int64_t first, std::int64_t last, const ToldRounds& told, std::size_t mistakes_before) {
    read_.rounds_read += static_cast<std::size_t>(last - first + 1);
    std::optional<std::int64_t> stated;
    if (!told.counts.empty()) stated = told.counts.back();
    const std::string name = name_of_round(first, last);
    const bool quiet = read_.mistakes.size() > mistakes_before;
    const std::string wrong = wrong_with(told, last - first + 1);
    if (!wrong.empty()) {
      if (!quiet) blame(name + wrong);
      return go_on_with(stated);
    }
    const RoundWords knit = round_words(tokens_of("knit"));
    std::int64_t number = first;
    std::size_t count = 0;
    for (std::int64_t time = 0; time < told.times; ++time) {
      for (const ToldRounds::Part& part : told.parts) {
        RoundWords words = part.name.empty() ? knit : named_.at(part.name);
        if (!words.mistake.empty()) return go_on_with(stated);  // its own line is blamed
        if (!part.name.empty()) words.stated = told.counts[count++];
        for (std::int64_t i = 0; i < part.rounds && !stopped_; ++i, ++number) {
          if (!work_one(number, words, words.stated.has_value(), quiet)) return go_on_with(stated);
        }
      }
    }
  }

  [[nodiscard]] std::string wrong_with(const ToldRounds& told, std::int64_t rounds) const {
    if (!told.mistake.empty()) return told.mistake;
    for (const ToldRounds::Part& part : told.parts) {
      if (!part.name.empty() && named_.count(part.name) == 0)
        return ": no line before tells what the " + part.name + " is.";
    }
    if (told.rounds() != rounds)
      return ": its words are " + std::to_string(told.rounds()) +
             (told.rounds() == 1 ? " round" : " rounds") + ", the label names " + std::to_string(rounds) +
             ".";
    if (static_cast<std::int64_t>(told.counts.size()) != told.named_ones())
      return ": it is shaped in " + std::to_string(told.named_ones()) +
             (told.named_ones() == 1 ? " round" : " rounds") + ", and " + std::to_string(told.counts.size()) +
             (told.counts.size() == 1 ? " count is" : " counts are") + " told.";
    return {};
  }

  void go_on_with(std::optional<std::int64_t> stated) {
    markers_.clear();
    counts_.clear();
    if (stated && *stated >= 1 && *stated <= most_stitches) counts_ = {*stated};
  }

  // Whether the round could be worked on what may be there. With `quiet` its line is blamed already.
  bool work_one(std::int64_t number, const RoundWords& words, bool stated_here, bool quiet) {
    const std::string name = name_of_round(number, number);
    if (counts_.empty()) {
      const auto takes = fixed_takes(words.nodes);
      if (!takes || *takes > most_stitches) return false;
      counts_ = {*takes};
    }
    Counts after;
    Markers markers;
    std::string why;
    for (const std::int64_t live : counts_) {
      WorkedRound round = work_round(words.nodes, live, markers_among(live), marker_names_);
      spend(round.made);
      if (!round.mistake.empty()) {
        if (why.empty()) why = round.mistake;
      } else if (stated_here && words.stated && round.made != *words.stated) {
        if (why.empty() || after.empty())
          why = " makes " + stitches_text(round.made) + ", the line says " + std::to_string(*words.stated) +
                ".";
        wrong_made_.push_back(round.made);
      } else {
        if (after.empty()) read_.stitches += round.made;
        if (after.empty()) markers = round.markers;
        after.push_back(round.made);
        keep(std::move(round), live);
      }
    }
    markers_ = std::move(markers);
    return settle(std::move(after), name, why, words.stated, quiet);
  }

  bool settle(Counts after, const std::string& name, const std::string& why,
              std::optional<std::int64_t> stated, bool quiet) {
    const Counts wrong_made = std::exchange(wrong_made_, {});
    if (!after.empty()) {
      if (after.size() == 2 && after[0] == after[1]) after.pop_back();
      counts_ = std::move(after);
      return true;
    }
    if (!quiet) blame(name + why);
    if (wrong_made.empty()) return false;
    read_.stitches += wrong_made.front();
    go_on_with(stated);
    counts_.push_back(wrong_made.front());
    return true;
  }

  void keep(WorkedRound round, std::int64_t live) {
    if (!sound_) return;
    if (!round.told) {
      sound_ = false;  // no mistake, but Rounds cannot say it
      return;
    }
    const auto row = static_cast<std::int32_t>(read_.rounds.rounds.size() + 2);
    Round kept{row,
               std::move(round.operations),
               static_cast<std::int32_t>(live),
               static_cast<std::int32_t>(round.made),
               {}};
    if (pending_ && !add_short_rows(kept)) {
      sound_ = false;
      return;
    }
    pending_.reset();
    read_.rounds.rounds.push_back(std::move(kept));
  }

  // Whether pairs are all that is to be said of them: those of other orders are no mistake.
  bool add_short_rows(Round& round) {
    round.pairs = std::move(pending_->pairs);
    if (!pending_->told || !can_be_worked(round)) return false;
    const Rounds alone{round.before, {round}};
    if (graph_of(alone).short_rows != pending_->short_rows) return false;
    for (GraphShortRow short_row : pending_->short_rows) {
      short_row.row = round.number - 2;
      read_.short_rows.push_back(short_row);
    }
    return true;
  }

  void spend(std::int64_t stitches) {
    work_ += stitches + work_of_a_round;
    if (work_ <= most_work || stopped_) return;
    blame("the pattern is longer than can be read: more than " + stitches_text(most_work) + ".");
    stopped_ = true;
  }

  ReadPattern read_;
  std::size_t line_ = 0, closed_line_ = 0;
  bool has_cast_on_ = false, closed_ = false, stopped_ = false;
  bool sound_ = true;  // nothing so far that Rounds could not hold
  std::int64_t cast_on_ = 0, next_ = 1, work_ = 0;
  Counts also_next_;  // round numbers that would do as well, after one out of turn
  Counts counts_, wrong_made_;
  std::map<std::string, RoundWords> named_;
  std::optional<ShortNeedles> needles_;          // since the last whole round
  std::optional<ShortNeedles::Worked> pending_;  // of the round that is kept next
  bool needles_failed_ = false;
  std::int64_t sections_ = 0;  // that markers part the round into; 0: none is placed
  MarkerNames marker_names_;   // where they have names
  Markers markers_;            // among the stitches of the first of `counts_`; empty: not known
};

}  // namespace

ReadPattern as_pattern(ReadLimbs limbs) {
  ReadPattern read;
  read.rounds.cast_on = static_cast<std::int32_t>(limbs.cast_on);
  read.mistakes = std::move(limbs.mistakes);
  read.rounds_read = limbs.rounds_read;
  read.stitches = static_cast<std::int64_t>(limbs.stitches.size());
  for (const auto& loop : limbs.closed) read.closed_with += static_cast<std::int32_t>(loop.size());
  return read;
}

ReadPattern read_pattern(std::string_view text) {
  if (has_limb_headings(text)) return as_pattern(read_limbs(text));
  return Reader().run(text);
}

}  // namespace knit
