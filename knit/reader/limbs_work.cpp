#include "knit/reader/limbs_work.h"

#include <algorithm>
#include <utility>

#include "knit/reader/limbs_lines.h"
#include "knit/reader/limbs_reader.h"
#include "knit/reader/reader_grammar.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

constexpr std::size_t most_letters_in_line = 20000;

std::string sts(std::int64_t count) { return std::to_string(count) + (count == 1 ? " st" : " sts"); }
std::string is_are(std::int64_t count) { return sts(count) + (count == 1 ? " is" : " are"); }

// "A", "Z", "AA": pieces are lettered as they are worked.
std::string letters_of_piece(std::size_t piece) {
  std::string letters;
  for (std::size_t left = piece + 1; left > 0; left = (left - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
  return letters;
}

}  // namespace

LimbWorker::LimbWorker(std::vector<LimbSection> sections, std::size_t last_line)
    : sections_(std::move(sections)), last_line_(last_line) {}

bool LimbWorker::fail(const std::string& sentence) {
  if (!failed()) read_.mistakes.push_back({line_, "line " + std::to_string(line_) + ": " + sentence});
  return false;
}

bool LimbWorker::is_short_enough() {
  constexpr std::size_t most_stitches_in_all = 4'000'000;
  return read_.stitches.size() <= most_stitches_in_all || fail("the pattern is longer than can be read.");
}

std::int32_t LimbWorker::new_stitch(const ReadStitch& stitch) {
  read_.stitches.push_back(stitch);
  return static_cast<std::int32_t>(read_.stitches.size()) - 1;
}

// --- names -------------------------------------------------------------------------------------------------------

bool LimbWorker::list_names() {
  for (const LimbSection& section : sections_) {
    line_ = section.line;
    const LimbHeading& heading = section.heading;
    const auto count = static_cast<std::int32_t>(heading.names.size());
    if (count != heading.made)
      return fail(std::to_string(count) + (count == 1 ? " name, but make " : " names, but make ") +
                  std::to_string(heading.made) + ".");
    std::vector<std::size_t>& own = of_section_.emplace_back();
    for (const LimbName& name : heading.names) {
      if (!by_letters_.emplace(name.letters, pieces_.size()).second)
        return fail(name.text() + " is made twice.");
      const std::string next = letters_of_piece(pieces_.size());
      if (name.letters != next)
        return fail("piece " + next + " is next, the heading says " + name.letters + ".");
      own.push_back(pieces_.size());
      const LimbName one{count > 1 ? one_of_several(name.word) : name.word, name.letters, 1};
      pieces_.push_back({one.text(), count > 1 ? name.word : "", false, {}});
    }
  }
  return true;
}

std::optional<std::size_t> LimbWorker::known(const LimbName& name) const {
  const auto found = by_letters_.find(name.letters);
  if (found == by_letters_.end()) return std::nullopt;
  const Piece& piece = pieces_[found->second];
  const bool same = piece.together.empty() ? piece.name == name.word + " " + name.letters
                                           : piece.together == several(name.word);
  return same ? std::optional(found->second) : std::nullopt;
}

std::optional<std::size_t> LimbWorker::piece_of(const LimbName& name) {
  const auto piece = known(name);
  if (!piece) fail("there is no piece " + name.text() + ".");
  // Once one of several is named, it goes by that name.
  if (piece) pieces_[*piece].name = name.text();
  return piece;
}

std::optional<std::size_t> LimbWorker::holder_of(const LimbName& name) {
  LimbName whose = name;
  whose.holder = 1;
  const auto piece = piece_of(whose);
  if (!piece) return piece;
  return *piece + pieces_.size() * static_cast<std::size_t>(name.holder - 1);
}

std::string LimbWorker::name_of(std::size_t holder) const {
  const std::string& name = pieces_[holder % pieces_.size()].name;
  return holder < pieces_.size() ? name
                                 : name + " (holder " + std::to_string(holder / pieces_.size() + 1) + ")";
}

// --- pieces ------------------------------------------------------------------------------------------------------

ReadLimbs LimbWorker::run() {
  if (list_names()) {
    for (std::size_t s = 0; s < sections_.size() && !failed(); ++s) {
      for (const std::size_t piece : of_section_[s]) {
        if (!make(sections_[s], piece)) break;
      }
    }
  }
  if (!failed()) end_all();
  return std::move(read_);
}

bool LimbWorker::make(const LimbSection& section, std::size_t piece) {
  line_ = section.line;
  if (goes_on_ && *goes_on_ != piece)
    return fail("the yarn goes on with " + name_of(*goes_on_) + ", not with " + name_of(piece) + ".");
  goes_on_.reset();
  now_ = piece;
  heading_ = &section.heading;
  ended_ = begun_ = false;
  read_.limbs.push_back({name_of(piece), {}, {}});
  for (const TextLine& text : section.lines) {
    line_ = text.number;
    std::string_view words = text.text;
    if (const auto label = limb_label_of(words)) {
      bool mine = false;
      for (const LimbName& name : label->names) {
        LimbName one = name;
        // In a list the word is that of several.
        const auto found = by_letters_.find(name.letters);
        const bool here = found != by_letters_.end() &&
                          std::any_of(section.heading.names.begin(), section.heading.names.end(),
                                      [&](const LimbName& made) {
                                        const std::string word =
                                            label->names.size() > 1 ? one.word : several(one.word);
                                        return made.letters == name.letters && made.word == word;
                                      });
        if (!here || section.heading.names.size() < 2) return fail(name.text() + " is not made here.");
        mine = mine || found->second == piece;
      }
      if (!mine) continue;
      words = label->words;
    }
    if (ended_) return fail(name_of(piece) + " is finished already.");
    if (!line(words)) return false;
  }
  if (!ended_)
    return fail(name_of(piece) + " has no end: its sts are neither held, bound off, grafted nor worked on.");
  pieces_[piece].made = true;
  return true;
}

bool LimbWorker::end_all() {
  line_ = last_line_;
  if (has_needle_) return fail(is_are(on_needle()) + " left on the needle.");
  for (const auto& [piece, holder] : holders_) {
    const auto held =
        std::count_if(holder.begin(), holder.end(), [](const Place& place) { return place.gap == 0; });
    return fail(is_are(held) + " left on the holder of " + name_of(piece) + ".");
  }
  for (const auto& [piece, loop] : waste_)
    return fail("the waste yarn of " + name_of(piece) + " is never removed.");
  for (const auto& [number, gap] : gaps_) {
    if (gap.left > 0) return fail("gap " + std::to_string(number) + " is never picked up.");
  }
  if (goes_on_) return fail(name_of(*goes_on_) + " is never worked.");
  std::int32_t next = 1;
  for (const auto& [number, gap] : gaps_) {
    if (number != next++)
      return fail("gap " + std::to_string(next - 1) + " is missing; gaps are numbered from 1.");
    read_.gaps.push_back(gap.stitches);
  }
  return true;
}

bool LimbWorker::expect(std::int32_t comes_out, std::int32_t says) {
  if (comes_out == says) return true;
  return fail(sts(comes_out) + (comes_out == 1 ? " comes" : " come") + " out, the line says " +
              std::to_string(says) + ".");
}

bool LimbWorker::needs_yarn() {
  if (!has_needle_) return fail("there are no sts on the needle.");
  return yarn_ || fail("no yarn hangs at the needle.");
}

bool LimbWorker::needs_no_stitches() {
  if (!has_needle_) return true;
  return fail(sts(on_needle()) + " of " + whose_ + (on_needle() == 1 ? " is" : " are") +
              " still on the needle: hold them or bind them off first.");
}

bool LimbWorker::needs_fresh_piece() {
  return read_.limbs.back().rows.empty() || fail("what lies on the needle is told before Rnd 1.");
}

bool LimbWorker::finish_piece() {
  const auto rounds = static_cast<std::int32_t>(read_.limbs.back().rows.size());
  if (rounds != heading_->rounds)
    return fail(name_of(now_) + " has " + std::to_string(rounds) + (rounds == 1 ? " rnd" : " rnds") +
                ", its heading says " + std::to_string(heading_->rounds) + ".");
  if (on_needle() != heading_->stitches)
    return fail(name_of(now_) + " ends with " + sts(on_needle()) + ", its heading says " +
                std::to_string(heading_->stitches) + ".");
  ended_ = true;
  return true;
}

bool LimbWorker::hold(std::size_t piece, Holder holder) {
  if (holders_.count(piece) > 0) return fail("the holder of " + name_of(piece) + " is not empty.");
  holders_.emplace(piece, std::move(holder));
  return true;
}

// --- sentences ---------------------------------------------------------------------------------------------------

bool LimbWorker::line(std::string_view words) {
  if (words.size() > most_letters_in_line) return fail("the line is longer than can be read.");
  if (const auto row = short_row_line(tokens_of(words))) return short_row(*row);
  if (label_at(words, 0)) return round(words);
  if (needles_) return fail("the round after the short rows is missing.");
  LimbScan at(words);
  if (at.take("Rejoin yarn: ")) return rejoin(at);
  if (at.take("Remove the waste yarn of ")) return loops(at);
  if (at.take("Divide: ")) return divide(at);
  if (at.take("Join with ")) return join(at);
  if (at.take("Graft to ")) return graft(at, false);
  if (at.take("Three-needle bind off with ")) return graft(at, true);
  if (at.take("Break yarn")) return break_yarn(at);
  if (at.take("Do not break yarn. Go on with ")) {
    const auto name = at.name();
    if (!name || !at.take(".") || !at.done()) return not_understood(words);
    const auto piece = piece_of(*name);
    if (!piece || !needs_yarn() || !finish_piece()) return false;
    if (pieces_[*piece].made || *piece == now_) return fail(name_of(*piece) + " is made already.");
    goes_on_ = piece;
    return true;
  }
  const bool all = at.take("BO all ");
  if (all || at.take("Bind off ")) {
    const auto count = at.stitches();
    if (!count || !at.take(". Fasten off.") || !at.done()) return not_understood(words);
    if (!needs_yarn() || !expect(on_needle(), *count) || !finish_piece()) return false;
    read_.closed.push_back(std::exchange(needle_, {}));
    has_needle_ = yarn_ = false;
    return true;
  }
  return not_understood(words);
}

bool LimbWorker::break_yarn(LimbScan at) {
  const std::string_view words = at.rest();
  if (at.take(". Place ")) {
    const auto count = at.stitches();
    if (!count || !at.take(" on a holder.") || !at.done()) return not_understood(words);
    if (!needs_yarn() || !expect(on_needle(), *count) || !finish_piece()) return false;
    Holder holder;
    for (const std::int32_t stitch : needle_) holder.push_back({stitch, 0});
    needle_.clear();
    has_needle_ = yarn_ = false;
    return hold(now_, std::move(holder));
  }
  if (at.take(", thread through remaining ")) {
    const auto count = at.stitches();
    if (!count || !at.take(" and pull tightly. Fasten off.") || !at.done()) return not_understood(words);
    if (!needs_yarn() || !expect(on_needle(), *count) || !finish_piece()) return false;
    read_.closed.push_back(std::exchange(needle_, {}));
    has_needle_ = yarn_ = false;
    return true;
  }
  if (at.take(", slip next ")) return move(at);
  if (at.take(", place all ")) return set_aside(at);
  return not_understood("Break yarn" + std::string(words));
}

bool LimbWorker::move(LimbScan at) {
  const std::string_view words = at.rest();
  const auto slipped = at.stitches();
  if (!slipped || !at.take(", rejoin yarn before the other ")) return not_understood(words);
  const auto rest = at.number();
  if (!rest || !at.take(": this is the new beginning of the rnd.")) return not_understood(words);
  const auto count = at.count_at_end();
  if (!count) return not_understood(words);
  if (!needs_yarn() || !needs_fresh_piece() || !expect(on_needle(), *count)) return false;
  if (*slipped + *rest != *count)
    return fail(std::to_string(*slipped) + " and the other " + std::to_string(*rest) + " are not " +
                sts(*count) + ".");
  if (*slipped < 1 || *rest < 1)
    return fail(std::to_string(*slipped) + " of " + sts(*count) + " cannot be slipped.");
  std::rotate(needle_.begin(), needle_.begin() + *slipped, needle_.end());
  return true;
}

bool LimbWorker::set_aside(LimbScan at) {
  const std::string_view words = at.rest();
  const auto count = at.stitches();
  if (!count || !at.take(" on a holder for ")) return not_understood(words);
  const auto name = at.holder();
  if (!name || !at.take(". (0 sts; ")) return not_understood(words);
  const auto again = at.holder();
  if (!again || !at.take(" ")) return not_understood(words);
  const auto held = at.stitches();
  if (!held || !at.take(")") || !at.done()) return not_understood(words);
  if (again->text() != name->text())
    return fail("the sts are held for " + name->text() + ", the bracket says " + again->text() + ".");
  const auto holder_number = holder_of(*name);
  if (!holder_number || !needs_yarn() || !needs_fresh_piece() || !expect(on_needle(), *count) ||
      !expect(*count, *held))
    return false;
  if (pieces_[*holder_number % pieces_.size()].made) return fail(name->text() + " is made already.");
  Holder holder;
  for (const std::int32_t stitch : needle_) holder.push_back({stitch, 0});
  needle_.clear();
  has_needle_ = yarn_ = begun_ = false;
  return hold(*holder_number, std::move(holder));
}

// --- rounds ------------------------------------------------------------------------------------------------------

bool LimbWorker::round(std::string_view words) {
  const Tokens tokens = tokens_of(words);
  const auto label = label_of(tokens);
  const std::size_t colon = words.find(": ");
  if (!label || !label->first || colon == std::string_view::npos) return not_understood(words);
  if (!label->mistake.empty()) return fail("the rnd" + label->mistake);
  if (label->last > most_number / 2) return fail("there are no so many rnds.");
  const auto first = static_cast<std::int32_t>(*label->first), last = static_cast<std::int32_t>(label->last);
  const auto next = static_cast<std::int32_t>(read_.limbs.back().rows.size()) + 1;
  if (first != next)
    return fail("Rnd " + std::to_string(next) + " is next, the line says " + std::to_string(first) + ".");
  const bool names_several = words.starts_with("Rnds") || words.starts_with("Rounds");
  if (names_several == (first == last))
    return fail(std::to_string(first) + "-" + std::to_string(last) + " is no range of rnds.");
  if (last > heading_->rounds)
    return fail("Rnd " + std::to_string(last) + " is told, and the heading says " +
                std::to_string(heading_->rounds) + (heading_->rounds == 1 ? " rnd." : " rnds."));
  LimbScan at(words.substr(colon + 2));
  if (at.take("CO ")) return cast_on(first, last, at, false);
  if (at.take("With waste yarn, provisionally CO ")) return cast_on(first, last, at, true);
  if (at.take("Work as for ")) return work_as(first, last, at.rest());
  return work_words(first, last, at.rest());
}

bool LimbWorker::cast_on(std::int32_t first, std::int32_t last, LimbScan at, bool provisional) {
  const auto count = at.stitches();
  if (!count || !at.take(". Join in the round, place marker.")) return not_understood(at.rest());
  const auto stated = at.count_at_end();
  if (!stated) return not_understood(at.rest());
  if (first != 1 || last != 1) return fail("a cast on is Rnd 1.");
  if (!needs_no_stitches()) return false;
  if (begun_) return fail(name_of(now_) + " is begun already.");
  if (*count < 1 || *count > most_stitches)
    return fail("cast on from 1 to " + std::to_string(most_stitches) + " sts.");
  if (!expect(*count, *stated)) return false;
  return work(1, {true, provisional, false, {}, *count});
}

bool LimbWorker::work_as(std::int32_t first, std::int32_t last, std::string_view words) {
  LimbScan at(words);
  const auto name = at.name();
  if (!name || !at.take(".")) return not_understood(words);
  const auto stated = at.count_at_end();
  if (!stated) return not_understood(words);
  const auto piece = piece_of(*name);
  if (!piece) return false;
  if (*piece == now_ || pieces_[*piece].rounds.empty()) return fail(name->text() + " is not made yet.");
  const std::vector<Worked>& rounds = pieces_[*piece].rounds;
  if (last > static_cast<std::int32_t>(rounds.size()))
    return fail(name->text() + " has no rnds " + std::to_string(first) + "-" + std::to_string(last) +
                " of its own.");
  for (std::int32_t number = first; number <= last; ++number) {
    const Worked round = rounds[static_cast<std::size_t>(number) - 1];
    if (round.cast_on && (!needs_no_stitches() || begun_)) return fail(name_of(now_) + " is begun already.");
    if (needles_) return fail("the round after the short rows is missing.");
    if (!round.cast_on && !begin_round(number)) return false;
    if (!work(number, round)) return false;
  }
  return expect(on_needle(), *stated);
}

bool LimbWorker::begin_round(std::int32_t number) {
  if (!needs_yarn()) return false;
  if (!begun_)
    return fail("the sts on the needle belong to " + whose_ + ": nothing says how " + name_of(now_) +
                " begins.");
  if (number == 1) read_.limbs.back().live = needle_;
  whose_ = name_of(now_);
  return true;
}

std::optional<LimbWorker::Loop> LimbWorker::slipped_back(bool slips) const {
  Loop live = needle_;
  if (slips && live.empty()) return std::nullopt;
  if (slips) std::rotate(live.begin(), live.end() - 1, live.end());
  return live;
}

// Requires operations that take all that is there, from the last stitch on where it is slipped back.
bool LimbWorker::work(std::int32_t number, const Worked& round) {
  Loop made;
  if (round.cast_on) {
    for (std::int32_t i = 0; i < round.after; ++i) made.push_back(new_stitch({}));
    if (round.provisional) waste_[now_] = made;
    read_.cast_on += round.after;
    has_needle_ = yarn_ = begun_ = true;
    whose_ = name_of(now_);
  } else {
    const auto live = slipped_back(round.slips);
    const std::size_t there = live ? live->size() : 0;
    std::int64_t takes = 0;
    for (const Operation& operation : round.operations) takes += consumed_by(operation.hand);
    if (there == 0) return fail("there are no sts on the needle.");
    if (takes != static_cast<std::int64_t>(there))
      return fail("Rnd " + std::to_string(number) + " works " + std::to_string(takes) + " of " +
                  sts(static_cast<std::int64_t>(there)) + ".");
    std::size_t done = 0;
    for (const Operation& operation : round.operations) {
      const auto taken = static_cast<std::size_t>(consumed_by(operation.hand));
      ReadStitch stitch{operation.hand, -1, -1};
      stitch.first = taken > 0 ? (*live)[done] : (*live)[(done + there - 1) % there];
      if (taken != 1) stitch.second = (*live)[(taken > 0 ? done + 1 : done) % there];
      made.push_back(new_stitch(stitch));
      done += taken;
    }
  }
  if (!is_short_enough()) return false;
  needle_ = made;
  for (GraphShortRow short_row : round.short_rows) {
    short_row.row = static_cast<std::int32_t>(read_.limbs.back().rows.size()) - 1;
    read_.limbs.back().short_rows.push_back(short_row);
  }
  read_.limbs.back().rows.push_back(std::move(made));
  pieces_[now_].rounds.push_back(round);
  if (!round.cast_on) ++read_.rounds_read;
  return true;
}

bool LimbWorker::work_words(std::int32_t first, std::int32_t last, std::string_view words) {
  constexpr std::string_view moved = ", marker moved back 1 st", slip = "lip last st back, ";
  std::string plain(words);
  const std::size_t bracket = plain.rfind(moved);
  const bool says_moved = bracket != std::string::npos;
  if (says_moved) plain.erase(bracket, moved.size());
  Worked worked;
  worked.slips = plain.size() > slip.size() && (plain[0] == 'S' || plain[0] == 's') &&
                 std::string_view(plain).substr(1).starts_with(slip);
  if (worked.slips) plain.erase(0, slip.size() + 1);
  if (worked.slips != says_moved)
    return fail(worked.slips ? "the last st is slipped back, the bracket says nothing of it."
                             : "the last st is not slipped back, the bracket says the marker moves.");
  const std::string range = first == last ? "Rnd " + std::to_string(first)
                                          : "Rnds " + std::to_string(first) + "-" + std::to_string(last);
  const Tokens tokens = tokens_of(plain);
  const RoundWords read = round_words(tokens);
  if (!read.mistake.empty()) return fail(range + read.mistake);
  if (!read.stated) return fail(range + " has no count of sts at its end.");
  for (std::int32_t number = first; number <= last; ++number) {
    if (!begin_round(number) || !take_short_rows(number, worked)) return false;
    WorkedRound round = work_round(read.nodes, on_needle());
    const std::string name = "Rnd " + std::to_string(number);
    if (!round.mistake.empty()) return fail(name + round.mistake);
    if (!round.told) return fail(name + " takes three sts together, which this checker cannot hold.");
    if (round.made != *read.stated)
      return fail(name + " makes " + sts(round.made) + ", the line says " + std::to_string(*read.stated) +
                  ".");
    worked.operations = std::move(round.operations);
    worked.after = static_cast<std::int32_t>(round.made);
    if (!work(number, worked)) return false;
  }
  return true;
}

bool has_limb_headings(std::string_view text) {
  const std::vector<TextLine> lines = pattern_lines(text);
  return std::any_of(lines.begin(), lines.end(),
                     [](const TextLine& line) { return limb_heading_of(line.text).has_value(); });
}

ReadLimbs read_limbs(std::string_view text) {
  LimbSections sections = limb_sections_of(text);
  if (sections.stray) {
    ReadLimbs read;
    const std::string line = std::to_string(sections.stray->number);
    read.mistakes.push_back({sections.stray->number, "line " + line + ": \"" + sections.stray->text +
                                                         "\" stands before the first piece."});
    return read;
  }
  return LimbWorker(std::move(sections.sections), sections.last_line).run();
}

}  // namespace knit
