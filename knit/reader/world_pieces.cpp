// Between rounds: pieces begin and end, markers are placed and removed.
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_told.h"
#include "knit/reader/world_worker.h"

namespace knit {

namespace {

// How many stitches are cast on by the words from `from` on; `behind` gets the place behind the number.
std::optional<std::int64_t> cast_on_count(const Atoms& part, std::size_t from, std::size_t& behind) {
  for (std::size_t j = from; j < std::min(part.size(), from + 6); ++j) {
    if (!part[j].is_number() && !part[j].is_word()) break;
    if (j > from && (part[j].is("co") || part[j].is("cast"))) break;
    if (!part[j].is_number()) continue;
    if (j + 1 < part.size() && is_any(part[j + 1], {"mm", "cm", "inch", "inches", "in", "."})) break;
    behind = j + 1;
    return part[j].value;
  }
  return std::nullopt;
}

// "CO 20 sts": where "CO" stands, and what is behind the number.
struct CastOnWords {
  std::int64_t stitches = 0;
  std::size_t at = 0, behind = 0;
};

std::optional<CastOnWords> cast_on_words(const Atoms& part) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    const bool on = part[i].is("co") ||
                    (is_any(part[i], {"cast", "casting"}) && i + 1 < part.size() && part[i + 1].is("on"));
    if (!on) continue;
    CastOnWords told{0, i, i + (part[i].is("co") ? 1 : 2)};
    if (const auto count = cast_on_count(part, told.behind, told.behind)) {
      told.stitches = *count;
      return told;
    }
  }
  return std::nullopt;
}

// "K9, CO 2 sts, k9" is a round.
bool stands_in_round(const Atoms& part, const CastOnWords& told) {
  return holds_any(std::span(part).first(told.at), {"k", "p", "knit", "purl", "place"}) ||
         holds_any(rest_of(part, told.behind), {"k", "knit", "p", "purl"});
}

// "... counts as rnd 1", "first round"
bool tells_first_round(const Atoms& line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (is_rounds(line[i]) && line[i + 1].is_number() && line[i + 1].value == 1) return true;
    if (line[i].is("first") && is_rounds(line[i + 1])) return true;
  }
  return false;
}

// "BO all 16 sts", "draw yarn through remaining 6 sts": where it stands.
struct CloseWords {
  std::size_t at = 0;
  bool drawn = false;  // the yarn, through what is left
};

std::optional<CloseWords> close_words(const Atoms& part) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (is_any(part[i], {"thread", "draw", "pull", "run", "pass", "weave"}) &&
        holds_any(std::span(part).subspan(i), {"through", "thru"}))
      return CloseWords{i, true};
    if (part[i].is("bo") ||
        (is_any(part[i], {"bind", "cast"}) && i + 1 < part.size() && part[i + 1].is("off")))
      return CloseWords{i, false};
  }
  return std::nullopt;
}

// "K4, BO 4 sts, k to end", "BO 4 sts, k to end": a row.
bool closes_in_row(const Atoms& part, std::size_t at) {
  if (at + 1 < part.size() && holds_any(std::span(part).first(at), {"k", "p", "knit", "purl"})) return true;
  for (std::size_t i = at + 1; i < part.size(); ++i) {
    if (is_any(part[i], {"k", "p"}) || (is_any(part[i], {"knit", "purl", "work"}) && i + 1 < part.size() &&
                                        is_any(part[i + 1], {"to", "across"})))
      return true;
  }
  return false;
}

// "16 sts", "BO 16", "remaining 6"
std::optional<std::int64_t> closed_stitches(const Atoms& tail) {
  std::optional<std::int64_t> number = stitches_in(tail);
  if (number) return number;
  for (std::size_t i = 1; i < tail.size(); ++i) {
    if (tail[i].is_number() && is_any(tail[i - 1], {"bo", "off", "all", "remaining", "rem"}))
      number = tail[i].value;
  }
  return number;
}

}  // namespace

void WorldWorker::begin_piece(std::int64_t stitches) {
  needle_.set(stitches);
  has_needle_ = known_ = ever_cast_on_ = true;
  closed_ = markers_lost_ = false;
  alternative_.reset();
  in_round_ = rows_ = false;
  CheckedPiece& piece = out_.pieces.emplace_back();
  piece.name = section_;
  piece.made = copies_;
  piece.rounds.push_back({line_, stitches});
}

void WorldWorker::leave_behind() {
  if (!known_ || needle_.count() < 1) return;
  left_behind_ += stitches_text(needle_.count()) + (needle_.count() == 1 ? " is" : " are") +
                  " on the needles where line " + std::to_string(line_) + " casts on. ";
}

std::string WorldWorker::left_over() const {
  std::string left = left_behind_;
  if (known_ && has_needle_ && needle_.count() > 0)
    left += stitches_text(needle_.count()) + (needle_.count() == 1 ? " is" : " are") +
            " on the needles at the end. ";
  if (!left.empty()) left.pop_back();
  return left;
}

void WorldWorker::end_piece(bool held) {
  traces_ = false;
  Made made;
  made.name = section_;
  if (known_) made.count = needle_.count();
  made.held = held;
  made_.push_back(std::move(made));
  if (!out_.pieces.empty()) out_.pieces.back().flat = rows_ && !in_round_;
  has_needle_ = false;
  known_ = false;
  any_number_ = true;
}

// Cast on beside those that are there.
void WorldWorker::add_stitches(std::int64_t stitches) {
  needle_.right.back() = 0;
  if (known_) needle_.set(needle_.count() + stitches);
}

// A piece begins, and its rounds are numbered anew; "CO 6 sts. This is rnd 1."
void WorldWorker::begin_cast_on(std::int64_t stitches, const Atoms& line) {
  if (has_needle_ && !history_.empty()) {
    leave_behind();
    end_piece(false);
  }
  begin_piece(stitches);
  any_number_ = false;
  history_.clear();
  by_number_.clear();
  pending_.clear();
  rule_.reset();
  const bool is_round = tells_first_round(line);
  next_ = is_round ? 2 : 1;
  gap_ok_ = !is_round;
}

bool WorldWorker::cast_on(const Atoms& part, const Atoms& line) {
  if (holds_any(part, {"held", "holder"})) return false;
  const auto told = cast_on_words(part);
  if (!told || (has_needle_ && stands_in_round(part, *told))) return false;
  const std::int64_t stitches = told->stitches;
  if (stitches < 1 || stitches > most_value) {
    wrong("no stitches are cast on.");
    return true;
  }
  run_pending(true);
  Atoms words = line;
  const WorldCount stated = take_count(words, lexicon_);
  // "RIGHT LEG / Cast on 2 sts. (22 sts)" beside the 20 that are there
  const bool beside = has_needle_ && known_ && stated.total && *stated.total > needle_.count();
  const bool adds = has_needle_ && (!fresh_ || beside);
  if (has_needle_ && fresh_ && history_.empty() && known_ && needle_.count() != stitches &&
      section_.empty() && made_.empty()) {
    wrong("casts on " + stitches_text(stitches) + ", and " + std::to_string(needle_.count()) +
          " are cast on already.");
    return true;
  }
  if (adds && !section_.empty() && !made_.empty() && made_.back().name == section_) return false;
  if (adds)
    add_stitches(stitches);
  else
    begin_cast_on(stitches, line);
  worked();
  fresh_ = false;
  if (stated.total && stated.all.size() == 1) check_after(stated);
  in_round_ = in_round_ ||
              (holds_any(line, {"join"}) && holds_any(line, {"round", "rnd", "joining", "twist", "circle"}));
  return true;
}

// "Place a marker (m) after every 2 sts: 4 markers", "Place markers (m) after sts 2, 5, 8, 10"
bool WorldWorker::place_markers(const Atoms& part) {
  if (part.empty() || !is_any(part.front(), {"place", "pm"}) || !holds_any(part, {"marker", "markers"}) ||
      !holds_any(part, {"after"}))
    return false;
  std::vector<std::int64_t> numbers;
  bool every = holds_any(part, {"every"});
  for (const Atom& atom : part) {
    if (atom.is_number()) numbers.push_back(atom.value);
  }
  traces_ = false;
  if (numbers.empty() || !known_) return false;
  const std::int64_t there = needle_.count();
  Segments segments;
  if (every) {
    const std::int64_t step = numbers[0];
    if (step < 1 || there / std::max<std::int64_t>(1, step) > 10'000 ||
        (numbers.size() > 1 && step * numbers[1] != there) || there % step != 0) {
      wrong("a marker after every " + stitches_text(step) +
            (numbers.size() > 1 ? " and " + std::to_string(numbers[1]) + " markers do" : " does") +
            " not go round " + stitches_text(there) + ".");
      return true;
    }
    segments.assign(static_cast<std::size_t>(there / step), step);
  } else {
    std::int64_t before = 0;
    for (const std::int64_t number : numbers) {
      if (number < before || number > there) {
        wrong("a marker after stitch " + std::to_string(number) + " has no place among " +
              stitches_text(there) + ".");
        return true;
      }
      segments.push_back(number - before);
      before = number;
    }
    if (before < there)
      segments.push_back(there - before);
    else
      segments.push_back(0);
  }
  if (every) segments.push_back(0);
  needle_.left = segments;
  needle_.right = {0};
  needle_.marked = true;
  worked();
  return true;
}

// "Remove marker.", "Remove all markers.": those that stand between stitches; of several, nobody can tell which one.
bool WorldWorker::remove_markers(const Atoms& part) {
  if (part.empty() || !is_any(part.front(), {"remove", "removing", "rm"}) || part.size() > 4 || !has_needle_)
    return false;
  const bool all = holds_any(part, {"markers", "all", "both", "mkrs"});
  if ((!all && !part.front().is("rm") && !holds_any(part, {"marker", "m", "mkr"})) ||
      holds_any(part, {"beg", "beginning", "bor", "round", "rnd", "end"}))
    return false;
  run_pending(true);
  traces_ = false;
  const std::size_t markers = needle_.left.size() + needle_.right.size() - 2;
  markers_lost_ = markers_lost_ || (markers > 1 && !all);
  if (known_) needle_.set(needle_.count());
  return true;
}

// "BO 4 sts at the beginning of the next row": the others stay. False: all were to be closed.
bool WorldWorker::bind_off_some(const Atoms& part, std::int64_t stitches) {
  if (!holds_any(part, {"at", "next", "beginning", "each"}) || stitches >= needle_.count() ||
      holds_any(part, {"all", "remaining"}))
    return false;
  if (holds_any(part, {"each"})) {
    not_understood("how many are bound off in all is not clear.");
    known_ = false;
  } else {
    needle_.set(needle_.count() - stitches);
    worked();
  }
  return true;
}

// "BO all 16 sts", "thread through remaining 6 sts", "fasten off"
bool WorldWorker::close(const Atoms& part) {
  const auto words = close_words(part);
  if (!words || (!words->drawn && has_needle_ && closes_in_row(part, words->at))) return false;
  run_pending(true);
  if (!has_needle_) {
    if (closed_) say(LineVerdict::no_instruction, "");
    return true;
  }
  const std::span<const Atom> tail = rest_of(part, words->at);
  const auto stitches = closed_stitches(Atoms(tail.begin(), tail.end()));
  worked();
  if (stitches && known_ && !may_have(*stitches)) {
    if (bind_off_some(part, *stitches)) return true;
    wrong("closes " + stitches_text(*stitches) + ", and " + std::to_string(needle_.count()) +
          (needle_.count() == 1 ? " is" : " are") + " on the needles.");
  }
  if (line_ > 0 && out_.lines[line_ - 1].verdict == LineVerdict::holds) out_.lines[line_ - 1].stitches = 0;
  end_piece(false);
  closed_ = closed_once_ = true;
  closed_line_ = line_;
  fresh_ = false;
  return true;
}

}  // namespace knit
