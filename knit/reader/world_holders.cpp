// Between rounds: stitches put on holders and taken off them, picked up along edges, joined.
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_told.h"
#include "knit/reader/world_worker.h"

namespace knit {

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
    const bool of_rounds = i + 2 < part.size() && is_rounds(part[i + 2]);  // "as for rnds 1-10 of first leg"
    if (part[i].is("as") && is_any(part[i + 1], {"for", "given", "first"}) && !of_rounds) {
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
