// Between rounds: cast on, holders filled and emptied, edges picked up, ends.
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_worker.h"
#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

bool same_world_name(const std::string& told, const std::string& known) {
  if (told.empty() || known.empty()) return true;
  if (told.find(known) != std::string::npos || known.find(told) != std::string::npos) return true;
  const auto stem = [](std::string name) {
    if (name.size() > 3 && name.back() == 's') name.pop_back();
    return name;
  };
  return stem(told).find(stem(known)) != std::string::npos ||
         stem(known).find(stem(told)) != std::string::npos;
}

std::optional<std::int64_t> stitches_in(const Atoms& part) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (!part[i].is_number()) continue;
    for (std::size_t j = i + 1; j < std::min(part.size(), i + 5); ++j) {
      if (is_stitches(part[j])) return part[i].value;
      if (!part[j].is_word()) break;
    }
  }
  return std::nullopt;
}

bool names_holder(const Atoms& part) {
  if (holds_any(part, {"holder", "holders", "hold", "pin"})) return true;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) {
    if (is_any(part[i], {"waste", "scrap", "spare", "contrasting"}) &&
        is_any(part[i + 1], {"yarn", "needle", "needles", "dpn", "dpns", "thread", "circular", "double"}))
      return true;
  }
  return false;
}

std::string name_behind(const Atoms& part, AtomWords words) {
  for (std::size_t i = part.size(); i-- > 0;) {
    if (!is_any(part[i], words)) continue;
    std::size_t end = i + 1;
    while (end < part.size() && part[end].is_word() &&
           !is_any(part[end], {"on", "onto", "to", "and", "then"}))
      ++end;
    return world_name(std::span(part).subspan(i + 1, end - i - 1));
  }
  return "";
}

// "the 12 held left leg sts": the name before the first stitches told.
std::string name_before_stitches(const Atoms& part) {
  for (std::size_t i = 1; i < part.size(); ++i) {
    if (!is_stitches(part[i])) continue;
    std::size_t begin = i;
    while (begin > 1 && part[begin - 1].is_word() &&
           !is_any(part[begin - 1], {"held", "next", "remaining", "live", "all", "slip", "place", "put",
                                     "return", "transfer"}))
      --begin;
    return world_name(std::span(part).subspan(begin, i - begin));
  }
  return "";
}

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

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one form of words after the other
bool WorldWorker::cast_on(const Atoms& part, const Atoms& line) {
  if (holds_any(part, {"held", "holder"})) return false;
  std::size_t at = part.size(), behind = 0;
  std::optional<std::int64_t> count;
  for (std::size_t i = 0; i < part.size() && !count; ++i) {
    const bool on = part[i].is("co") ||
                    (is_any(part[i], {"cast", "casting"}) && i + 1 < part.size() && part[i + 1].is("on"));
    if (!on) continue;
    at = i;
    behind = at + (part[at].is("co") ? 1 : 2);
    count = cast_on_count(part, behind, behind);
  }
  if (!count) return false;
  // "K9, CO 2 sts, k9" is a round.
  if (has_needle_ && at > 0 &&
      std::any_of(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(at), [](const Atom& a) {
        return is_any(a, {"k", "p", "knit", "purl", "place"});
      }))
    return false;
  if (has_needle_ &&
      std::any_of(part.begin() + static_cast<std::ptrdiff_t>(behind), part.end(), [](const Atom& a) {
        return is_any(a, {"k", "knit", "p", "purl"});
      }))
    return false;
  if (*count < 1 || *count > most_value) {
    wrong("no stitches are cast on.");
    return true;
  }
  run_pending(true);
  Atoms words = line;
  const WorldCount stated = take_count(words, lexicon_);
  // "RIGHT LEG / Cast on 2 sts. (22 sts)" beside the 20 that are there
  const bool beside = has_needle_ && known_ && stated.total && *stated.total > needle_.count();
  const bool adds = has_needle_ && (!fresh_ || beside);
  if (has_needle_ && fresh_ && history_.empty() && known_ && needle_.count() != *count && section_.empty() &&
      made_.empty()) {
    wrong("casts on " + stitches_text(*count) + ", and " + std::to_string(needle_.count()) +
          " are cast on already.");
    return true;
  }
  if (adds && !section_.empty() && !made_.empty() && made_.back().name == section_) return false;
  if (adds) {
    needle_.right.back() = 0;
    if (known_) needle_.set(needle_.count() + *count);
    worked();
  } else {
    if (has_needle_ && !history_.empty()) {
      leave_behind();
      end_piece(false);
    }
    begin_piece(*count);
    next_ = 1;
    any_number_ = false;
    gap_ok_ = true;
    history_.clear();
    by_number_.clear();
    pending_.clear();
    rule_.reset();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      if (is_rounds(line[i]) && line[i + 1].is_number() && line[i + 1].value == 1) next_ = 2;
      if (line[i].is("first") && is_rounds(line[i + 1])) next_ = 2;
    }
    if (next_ == 2) gap_ok_ = false;
    worked();
  }
  fresh_ = false;
  Atoms copy = line;
  const WorldCount told = take_count(copy, lexicon_);
  if (told.total && told.all.size() == 1) check_after(told);
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

// "BO all 16 sts", "thread through remaining 6 sts", "fasten off"
// NOLINTNEXTLINE(readability-function-cognitive-complexity): one form of words after the other
bool WorldWorker::close(const Atoms& part) {
  if (part.empty()) return false;
  const std::size_t none = part.size();
  std::size_t at = none;
  bool drawn = false;
  for (std::size_t i = 0; i < part.size() && at == none; ++i) {
    if (part[i].is("bo") ||
        (is_any(part[i], {"bind", "cast"}) && i + 1 < part.size() && part[i + 1].is("off")))
      at = i;
    if (is_any(part[i], {"thread", "draw", "pull", "run", "pass", "weave"}) &&
        holds_any(std::span(part).subspan(i), {"through", "thru"}))
      at = i, drawn = true;
  }
  if (at == none) return false;
  if (!drawn && at > 0 && has_needle_ &&
      std::any_of(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(at),
                  [](const Atom& a) {
                    return is_any(a, {"k", "p", "knit", "purl"});
                  }) &&
      at + 1 < part.size()) {
    return false;
  }
  if (!drawn && has_needle_) {  // "BO 4 sts, k to end": a row
    for (std::size_t i = at + 1; i < part.size(); ++i) {
      if (is_any(part[i], {"k", "p"}) || (is_any(part[i], {"knit", "purl", "work"}) && i + 1 < part.size() &&
                                          is_any(part[i + 1], {"to", "across"})))
        return false;
    }
  }
  run_pending(true);
  if (!has_needle_) {
    if (closed_) say(LineVerdict::no_instruction, "");
    return true;
  }
  Atoms tail(part.begin() + static_cast<std::ptrdiff_t>(at), part.end());
  std::optional<std::int64_t> number = stitches_in(tail);
  if (!number) {
    for (std::size_t i = 0; i < tail.size(); ++i) {
      if (tail[i].is_number() && i > 0 && is_any(tail[i - 1], {"bo", "off", "all", "remaining", "rem"}))
        number = tail[i].value;
    }
  }
  worked();
  if (number && known_ && !may_have(*number)) {
    const bool some = holds_any(part, {"at", "next", "beginning", "each"}) && *number < needle_.count() &&
                      !holds_any(part, {"all", "remaining"});
    if (some) {
      if (holds_any(part, {"each"})) {
        not_understood("how many are bound off in all is not clear.");
        known_ = false;
      } else {
        needle_.set(needle_.count() - *number);
        worked();
      }
      return true;
    }
    wrong("closes " + stitches_text(*number) + ", and " + std::to_string(needle_.count()) +
          (needle_.count() == 1 ? " is" : " are") + " on the needles.");
  }
  if (line_ > 0 && out_.lines[line_ - 1].verdict == LineVerdict::holds) out_.lines[line_ - 1].stitches = 0;
  end_piece(false);
  closed_ = closed_once_ = true;
  closed_line_ = line_;
  fresh_ = false;
  return true;
}

// --- holders -------------------------------------------------------------------------------------------------

WorldHolder* WorldWorker::find_holder(const std::string& name, std::optional<std::int64_t> count) {
  WorldHolder* best = nullptr;
  int best_fit = -1;
  for (std::size_t i = holders_.size(); i-- > 0;) {
    WorldHolder& held = holders_[i];
    if (held.taken || !same_world_name(name, held.name)) continue;
    int fit = 0;
    if (count && held.count && *held.count == *count) fit += 4;
    if (!name.empty() && !held.name.empty()) fit += 2;
    if (name.empty() && !section_.empty() && !held.name.empty() && same_world_name(section_, held.name))
      fit += 2;
    if (fit > best_fit) best = &held, best_fit = fit;
  }
  return best;
}

// "there are no held stitches of the thumb; held are 7 of the first leg (line 4)."
std::string WorldWorker::none_held(const std::string& name) const {
  std::string sentence = "there are no held stitches" + (name.empty() ? "" : " of the " + name);
  std::string there;
  for (const WorldHolder& holder : holders_) {
    if (holder.taken || !holder.count) continue;
    there += (there.empty() ? "; held are " : ", ") + std::to_string(*holder.count) +
             (holder.name.empty() ? "" : " of the " + holder.name) + " (line " + std::to_string(holder.line) +
             ")";
    if (there.size() > 200) break;
  }
  return sentence + there + ".";
}

// Whether a holder has just what is missing: what is said of it; empty: none has.
std::string WorldWorker::forgotten(std::int64_t missing) {
  for (WorldHolder& holder : holders_) {
    if (holder.taken || holder.waste || holder.line == line_ || holder.count != missing) continue;
    holder.implied = true;
    return "; " + std::to_string(missing) + (holder.name.empty() ? "" : " of the " + holder.name) +
           (missing == 1 ? " is" : " are") + " still held (line " + std::to_string(holder.line) + ")";
  }
  return "";
}

// Where one that is told is not there, the others are not blamed as left over.
void WorldWorker::excuse_holders() {
  for (WorldHolder& holder : holders_) holder.implied = true;
}

// After a count that does not hold, the made one is as good as the stated one.
bool WorldWorker::may_have(std::int64_t stitches) const {
  return needle_.count() == stitches || alternative_ == stitches;
}

WorldHands WorldWorker::hands() {
  WorldHands hands;
  hands.hold = [this](const WorldNode& node, std::int64_t count) -> std::string {
    WorldHolder holder;
    holder.name = node.name;
    holder.count = node.kind == WorldNode::Kind::insert ? 2 * count : count;
    holder.waste = node.kind == WorldNode::Kind::insert;
    holder.line = line_;
    holders_.push_back(holder);
    return "";
  };
  hands.take = [this](const WorldNode& node, std::string& complaint) -> std::optional<std::int64_t> {
    const std::optional<std::int64_t> told = node.times > 0 ? std::optional(node.times) : std::nullopt;
    WorldHolder* holder = find_holder(node.name, told);
    if (holder == nullptr) {
      if (broken_) return told;
      complaint = none_held(node.name);
      excuse_holders();
      return std::nullopt;
    }
    holder->taken = true;
    if (told && holder->count && *told != *holder->count) {
      complaint = "the holder" + (holder->name.empty() ? std::string() : " of the " + holder->name) +
                  " has " + stitches_text(*holder->count) + ", the line says " + std::to_string(*told) + ".";
      return std::nullopt;
    }
    return holder->count ? holder->count : told;
  };
  return hands;
}

bool WorldWorker::hold_all(const Atoms& part, const WorldCount& count) {
  const bool moves = holds_any(
      part, {"place", "slip", "put", "leave", "leaving", "transfer", "move", "thread", "keep", "placing"});
  if (!moves || !names_holder(part) || holds_any(part, {"from", "off", "held", "with", "knit", "k"}) ||
      !has_needle_)
    return false;
  if (std::any_of(part.begin(), part.end(), [](const Atom& a) { return is_any(a, {"co", "cast"}); }))
    return false;
  run_pending(true);
  traces_ = false;
  const auto told = stitches_in(part);
  const bool all = !told || (known_ && *told == needle_.count());
  WorldHolder holder;
  holder.name = name_behind(part, {"for"});
  if (holder.name.empty()) holder.name = section_;
  holder.line = line_;
  if (!all && known_ && *told > needle_.count()) {
    wrong(stitches_text(*told) + " are to go on a holder, and " + stitches_text(needle_.count()) +
          " are on the needle.");
    known_ = false;
    return true;
  }
  if (!all && !known_) {
    holder.count = told;
  } else if (all) {
    if (known_) holder.count = needle_.count();
  } else {
    holder.count = told;
    needle_.set(needle_.count() - *told);
  }
  worked();
  for (std::int64_t copy = 0; copy < std::min<std::int64_t>(copies_, 1000); ++copy)
    holders_.push_back(holder);
  copies_ = 1;
  if (all) {
    end_piece(true);
    if (line_ > 0 && out_.lines[line_ - 1].verdict == LineVerdict::holds) out_.lines[line_ - 1].stitches = 0;
  } else if (count.total) {
    check_after(count);
  }
  return true;
}

// Where no holder fits the stitches that are to be taken up.
bool WorldWorker::take_none(const std::string& name, std::optional<std::int64_t> told, bool held,
                            const WorldCount& count) {
  // At the top of a text its stitches may have been put aside in another; below a piece they have not.
  if (holders_.empty() && told && out_.pieces.empty()) {
    begin_piece(*told);
    fresh_ = false;
    worked();
    return true;
  }
  if (!held && has_needle_) return false;
  if (broken_) {
    not_understood("whether these stitches are held is not known.");
    has_needle_ = true;
    known_ = false;
    return true;
  }
  wrong(none_held(name));
  excuse_holders();
  if (!has_needle_) begin_piece(0);
  after_trouble(count);
  return true;
}

bool WorldWorker::take_all(const Atoms& part, const WorldCount& count) {
  if (part.empty()) return false;
  const bool places = is_any(part.front(), {"place", "slip", "put", "return", "transfer", "move", "replace",
                                            "sl", "remove", "with"});
  const bool onto = holds_any(part, {"needle", "needles", "dpns", "dpn"});
  const bool held = holds_any(part, {"held", "waiting", "resting"}) ||
                    (holds_any(part, {"from", "off"}) && names_holder(part));
  if (!places || !(onto || held) || holds_any(part, {"marker", "markers"})) return false;
  if (names_holder(part) && !held && !part.front().is("remove")) return false;
  const auto told = stitches_in(part);
  if (!told && !holds_any(part, {"sts", "stitches", "st"})) return false;
  std::string name = name_behind(part, {"of"});
  if (name.empty()) name = name_before_stitches(part);
  run_pending(true);
  traces_ = false;
  WorldHolder* holder = find_holder(name, told);
  if (holder == nullptr) return take_none(name, told, held, count);
  holder->taken = true;
  const std::optional<std::int64_t> there = holder->count;
  if (told && there && *told != *there && !(holder->waste && std::abs(*told - *there) <= 1)) {
    wrong("the holder" + (holder->name.empty() ? "" : " of the " + holder->name) + " has " +
          stitches_text(*there) + ", the line says " + std::to_string(*told) + ".");
    if (!has_needle_) begin_piece(0);
    after_trouble(count);
    return true;
  }
  const std::optional<std::int64_t> came = told ? told : there;
  if (!has_needle_) {
    begin_piece(came.value_or(0));
    known_ = came.has_value();
  } else if (came && known_) {
    needle_.set(needle_.count() + *came);
  } else {
    known_ = false;
  }
  fresh_ = false;
  any_number_ = true;
  worked();
  std::size_t comma = 0;
  while (comma < part.size() && !part[comma].is(",")) ++comma;
  const Atoms rest(part.begin() + static_cast<std::ptrdiff_t>(std::min(comma, part.size())), part.end());
  if (holds_any(rest, {"held"})) {  // ", cast on 3 sts, k across the held sts of the other leg": behind them
    needle_.right = needle_.left;
    needle_.left = {0};
  }
  if (!rest.empty()) sentence(rest, rest);
  return true;
}

bool WorldWorker::pick_up(const Atoms& part, const WorldCount& count) {
  std::size_t at = 0;
  while (at < part.size() &&
         !(is_any(part[at], {"pick", "picking"}) && at + 1 < part.size() && part[at + 1].is("up")) &&
         !is_any(part[at], {"pu", "puk"}))
    ++at;
  if (at >= part.size()) return false;
  const Atoms tail(part.begin() + static_cast<std::ptrdiff_t>(at), part.end());
  std::optional<std::int64_t> told = stitches_in(tail);
  if (!told) {
    for (const Atom& atom : tail) {
      if (atom.is_number() && !told) told = atom.value;
    }
  }
  if (!told) {
    not_understood("how many stitches are picked up is not told.", part[at].at, part[at].length);
    after_trouble(count);
    has_needle_ = true;
    return true;
  }
  run_pending(true);
  traces_ = false;
  if (holds_any(tail, {"each", "either", "both"}) &&
      holds_any(tail, {"side", "sides", "end", "ends", "corner", "corners"}))
    *told *= 2;
  if (!has_needle_) {
    begin_piece(*told);
  } else if (known_) {
    needle_.set(needle_.count() + *told);
  }
  fresh_ = false;
  any_number_ = true;
  worked();
  if (count.total) check_after(count);
  return true;
}

bool WorldWorker::join_ends(const Atoms& part) {
  const bool three = holds_any(part, {"3", "three"}) && holds_any(part, {"needle"}) &&
                     holds_any(part, {"bind", "bo", "cast"});
  if (!three && !holds_any(part, {"kitchener", "graft"})) return false;
  run_pending(true);
  const auto told = stitches_in(part);
  if (!has_needle_) {
    for (WorldHolder& held : holders_) held.taken = true;
    return true;
  }
  worked();
  const std::string name = name_behind(part, {"to"});
  WorldHolder* other = nullptr;
  for (WorldHolder& held : holders_) {
    if (!held.taken && !held.waste) other = &held;
  }
  const bool own = holds_any(part, {"remaining", "rem"}) || other == nullptr;
  if (own) {
    if (told && known_ && !may_have(*told) && *told * 2 != needle_.count())
      wrong(stitches_text(*told) + " are to be joined, and " + stitches_text(needle_.count()) +
            " are on the needle.");
  } else {
    other->taken = true;
    if (known_ && other->count && *other->count != needle_.count())
      wrong("two live ends are joined, and they have " + std::to_string(needle_.count()) + " and " +
            stitches_text(*other->count) + ".");
  }
  end_piece(false);
  closed_ = closed_once_ = true;
  closed_line_ = line_;
  return true;
}

// "Work as for first leg but do not break yarn", "Work second sleeve the same"
bool WorldWorker::as_before(const Atoms& part) {
  if (!holds_any(part, {"work", "make", "knit"})) return false;
  std::string name;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) {
    if (part[i].is("as") && is_any(part[i + 1], {"for", "given", "first"})) {
      std::size_t end = i + 2;
      if (part[i + 1].is("first")) end = i + 1;
      std::size_t stop = end;
      while (stop < part.size() && part[stop].is_word() &&
             !is_any(part[stop], {"but", "until", "do", "except", "and"}))
        ++stop;
      name = world_name(std::span(part).subspan(end, stop - end));
    }
  }
  const bool again = holds_any(part, {"second", "other"}) && holds_any(part, {"same", "make"});
  if (name.empty() && !again) return false;
  const auto found = std::find_if(made_.rbegin(), made_.rend(), [&](const Made& made) {
    return name.empty() || same_world_name(name, made.name);
  });
  if (found == made_.rend()) return false;
  const Made made = *found;
  const bool stays = holds_any(part, {"but", "leave"}) &&
                     (holds_any(part, {"not", "don't"}) || holds_any(part, {"needle", "needles"}));
  if (stays) {
    begin_piece(made.count.value_or(0));
    known_ = made.count.has_value();
  } else if (made.held) {
    WorldHolder holder;
    holder.name = section_;
    holder.count = made.count;
    holder.line = line_;
    holder.implied = true;
    holders_.push_back(holder);
  } else if (WorldHolder* held = find_holder(section_, std::nullopt); held != nullptr) {
    held->taken = true;
  }
  any_number_ = true;
  say(LineVerdict::holds, "");
  return true;
}

}  // namespace knit
