// Rounds: by number and by name, ahead of their turn, and worked.
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_worker.h"

namespace knit {

namespace {

std::string rnd(std::int64_t number) { return "Rnd " + std::to_string(number); }

}  // namespace

WorldWorker::Index WorldWorker::keep(Atoms atoms, const std::string& name, bool flat) {
  WorldRecipe recipe;
  recipe.line = line_;
  recipe.name = name;
  recipe.flat = flat;
  const WorldCount count = take_count(atoms, lexicon_);
  recipe.first = world_round(atoms, lexicon_, false);
  recipe.first.count = count;
  if (recipe.first.choice) recipe.other = world_round(atoms, lexicon_, true);
  recipe.atoms = std::move(atoms);
  recipes_.push_back(std::move(recipe));
  return recipes_.size() - 1;
}

bool WorldWorker::in_rule(std::int64_t number) const {
  return rule_ && number >= rule_->from && (number - rule_->from) % rule_->step == 0;
}

// Rounds whose turn has come; `all`: the ones told ahead too, where the piece ends.
void WorldWorker::run_pending(bool all) {
  const std::size_t line = line_;
  while (!pending_.empty()) {
    const auto first = pending_.begin();
    if (first->first != next_) {
      const bool rule = first->first > next_ && in_rule(next_);
      if (!rule) break;
      work_recipe(rule_->recipe, rnd(next_), nullptr, 0);
      finished_round(rule_->recipe, next_);
      ++next_;
      continue;
    }
    const auto [number, told] = *first;
    const WorldRecipe& recipe = recipes_[told.first];
    line_ = recipe.line;
    const WorldCount count = recipe.first.count;
    const bool said = count.change || told.second;
    pending_.erase(first);
    work_recipe(told.first, rnd(number), said ? &count : nullptr, count.all.size());
    finished_round(told.first, number);
    ++next_;
  }
  if (all && !pending_.empty()) {
    for (const auto& [number, told] : pending_)
      say_at(recipes_[told.first].line, LineVerdict::not_understood,
             "the rounds before " + rnd(number) + " are not told, so it has no turn.", 0, 0);
    broken_ = true;
    pending_.clear();
  }
  if (all) rule_.reset();
  line_ = line;
}

void WorldWorker::finished_round(Index index, std::int64_t number) {
  ++rounds_;
  history_.push_back(index);
  if (number > 0) by_number_[number] = index;
  fresh_ = false;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one form of words after the other
void WorldWorker::number_rounds(const WorldLabel& label, const Atoms& body) {
  const std::int64_t first = label.numbers.front().first;
  std::int64_t rounds = 0;
  for (const auto& [from, to] : label.numbers) rounds += to - from + 1;
  if (rounds > most_rounds_in_line) {
    not_understood("these are more than " + std::to_string(most_rounds_in_line) + " rounds in one line.");
    known_ = false;
    return;
  }
  const std::string name =
      label.numbers.size() == 1 && first != label.numbers.front().second
          ? "Rnds " + std::to_string(first) + "-" + std::to_string(label.numbers.front().second)
          : rnd(first);
  run_pending(false);
  if (any_number_ && !pending_.empty() && pending_.begin()->first > next_) {
    next_ = std::min(first, pending_.begin()->first);  // "Rnds 18, 20:" waited for this line
    any_number_ = false;
  }
  const bool waits =
      (label.numbers.size() > 1 || label.every_from) && any_number_ && !history_.empty() && first > next_;
  if (waits) {
    const Index index = keep(body, name, (rows_ || label.sided) && !in_round_);
    for (const auto& [from, to] : label.numbers) {
      for (std::int64_t number = from; number <= to; ++number)
        pending_[number] = {index, number == label.numbers.back().second};
    }
    if (label.every_from) rule_ = Rule{*label.every_from, label.every_step, index, history_.size()};
    return;
  }
  const bool begins_again = first < next_ && (any_number_ || last_was_note_ || closed_ || fresh_);
  const bool restart = begins_again || (gap_ok_ && history_.empty());
  if (begins_again && first == 1) by_number_.clear();  // of what was worked before
  if (restart || (any_number_ && first != next_)) {
    const std::optional<Rule> rule = rule_;
    const bool is_new = rule && rule->told_after == history_.size();
    run_pending(true);
    if (is_new) rule_ = rule;
    const bool ahead = (label.every_from || label.numbers.size() > 1) && first > 1 && history_.empty();
    const bool skipped = !ahead && gap_ok_ && history_.empty() && first > 1 && ever_cast_on_;
    if (skipped) wrong(name + " first, and Rnd 1 is missing; if the cast on is Rnd 1, its line must say so.");
    if (!ahead) next_ = first;
  } else if (first > next_) {
    // rounds told ahead, or by a rule, fill the gap
    std::int64_t hole = next_;
    while (hole < first && (in_rule(hole) || pending_.count(hole) != 0)) ++hole;
    const bool later = label.numbers.size() > 1 || label.every_from;
    if (hole < first && !later) {
      wrong(name + " stands here, and " + rnd(hole) +
            (first - 1 > hole ? " to " + std::to_string(first - 1) + " are" : " is") + " missing.");
      run_pending(true);
      next_ = first;
    }
  } else if (first < next_) {
    wrong(name + " stands here, and " + rnd(next_ - 1) + " was read already; " + rnd(next_) + " comes next.");
    next_ = first;
  }
  any_number_ = false;
  gap_ok_ = false;

  Atoms copy = body;
  const WorldCount count = take_count(copy, lexicon_);
  if (label.numbers.size() == 1) {
    while (next_ < first && in_rule(next_)) {
      work_recipe(rule_->recipe, rnd(next_), nullptr, 0);
      finished_round(rule_->recipe, next_);
      ++next_;
    }
    if (told_rounds(copy, count, rounds, name) || like_another(label, copy, count)) {
      next_ = label.numbers.back().second + 1;
      return;
    }
  }
  const bool flat = (rows_ || label.sided) && !in_round_;
  const Index index = keep(body, name, flat);
  for (const auto& [from, to] : label.numbers) {
    for (std::int64_t number = from; number <= to; ++number)
      pending_[number] = {index, number == label.numbers.back().second};
  }
  if (label.every_from) rule_ = Rule{*label.every_from, label.every_step, index, history_.size()};
  run_pending(false);
  if (!recipes_[index].first.trouble.empty())
    not_understood(recipes_[index].first.trouble, recipes_[index].first.at, recipes_[index].first.length);
}

// "All even rounds: knit"
void WorldWorker::tell_rule(const WorldLabel& label, const Atoms& body) {
  const Index index = keep(body, "the even rounds", rows_ && !in_round_);
  rule_ = Rule{*label.every_from, label.every_step, index, history_.size()};
  const WorldRound& round = recipes_[index].first;
  if (!round.trouble.empty()) return not_understood(round.trouble, round.at, round.length);
  say(LineVerdict::holds, "");
}

void WorldWorker::named_round(const WorldLabel& label, const Atoms& body) {
  if (label.every_from) return tell_rule(label, body);
  run_pending(true);
  Atoms copy = body;
  const WorldCount count = take_count(copy, lexicon_);
  const std::string name = "the " + label.name;
  const bool flat = (rows_ || label.sided) && !in_round_;
  const bool definition = definitions_.count(label.name) != 0;
  any_number_ = any_number_ || !definition;
  if (!definition) {
    bool trouble = false;
    if (auto repeat = repeat_in(copy, trouble)) return do_repeat(*repeat, count, 0);
    if (told_rounds(copy, count, 0, name)) return;
    if (like_another(label, copy, count)) return;
  }
  const Index index = keep(body, name, flat);
  if (label.name != "round" && label.name != "rnd") by_name_[label.name] = index;
  const WorldRound& round = recipes_[index].first;
  if (definition) {
    if (!round.trouble.empty()) return not_understood(round.trouble, round.at, round.length);
    return say(LineVerdict::holds, "");
  }
  for (std::int64_t i = 0; i < std::min(label.rounds, most_rounds_in_line); ++i) {
    const bool last = i + 1 == label.rounds;
    work_recipe(index, name, last || count.change ? &count : nullptr, count.all.size());
    finished_round(index, 0);
  }
}

namespace {

constexpr std::int64_t steps_of_round = 50;  // what a round costs by itself, beside its stitches

bool works_to_marker(const std::vector<WorldNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](const WorldNode& node) {
    return node.until == WorldNode::Until::marker || works_to_marker(node.inside);
  });
}

bool moves_held(const std::vector<WorldNode>& nodes) {
  using Kind = WorldNode::Kind;
  return std::any_of(nodes.begin(), nodes.end(), [](const WorldNode& node) {
    return node.kind == Kind::hold || node.kind == Kind::take || node.kind == Kind::insert ||
           moves_held(node.inside);
  });
}

}  // namespace

// Holders that a wrong line would have filled behind the place where it went wrong: nobody can tell with how many.
void WorldWorker::hold_unreached(const WorldRound& round, std::size_t held_before) {
  std::size_t reached = holders_.size() - held_before;
  for (const WorldNode& node : round.nodes) {
    if (node.kind != WorldNode::Kind::hold) continue;
    if (reached > 0) {
      --reached;
      continue;
    }
    WorldHolder holder;
    holder.name = node.name;
    holder.line = line_;
    holders_.push_back(holder);
  }
}

// "Knit across the 12 sts of the second leg, knit across the 12 held sts of the first leg": those of the second are on
// the needle.
WorldRound WorldWorker::with_live_ones(const WorldRound& round) const {
  using Kind = WorldNode::Kind;
  WorldRound live = round;
  const bool works = std::any_of(live.nodes.begin(), live.nodes.end(), [](const WorldNode& node) {
    return node.kind != Kind::take && node.kind != Kind::add;
  });
  if (works || !has_needle_ || !known_ || needle_.count() < 1) return live;
  const auto first = std::find_if(live.nodes.begin(), live.nodes.end(), [&](const WorldNode& node) {
    return node.kind == Kind::take && node.live && node.times == needle_.count();
  });
  if (first == live.nodes.end()) return live;
  first->kind = Kind::stitch;
  first->takes = first->makes = 1;
  return live;
}

void WorldWorker::doubt_holders() {
  for (std::size_t i = holders_.size(); i-- > 0 && holders_[i].line == line_;) holders_[i].count.reset();
}

// Where markers stood is lost with the stitches, and how many a wrong line put on holders nobody can tell.
void WorldWorker::after_trouble(const WorldCount& count) {
  doubt_holders();
  markers_lost_ = markers_lost_ || needle_.marked;
  alternative_.reset();
  known_ = count.total && *count.total >= 0 && *count.total <= most_value;
  if (known_) needle_.set(*count.total);
}

// Whether the round's count is the stated one. `why` gets what is wrong.
bool WorldWorker::settle_count(const std::string& name, std::int64_t before, const WorldCount& count,
                               std::size_t nth, bool quiet, std::string& why) {
  (void)quiet;
  const std::int64_t made = needle_.count();
  if (count.total) {
    const std::int64_t stated = nth > 0 && nth <= count.all.size() ? count.all[nth - 1] : *count.total;
    if (made != stated) {
      why = name + " makes " + stitches_text(made) + ", the line says " + std::to_string(stated) + ".";
      return false;
    }
  }
  if (count.change && made - before != *count.change) {
    why = name + " changes the stitches by " + std::to_string(made - before) + ", the line says " +
          std::to_string(*count.change) + ".";
    return false;
  }
  return true;
}

// Where nobody knows how many stitches there are.
bool WorldWorker::on_unknown(const WorldRecipe& recipe, const std::string& name, const WorldCount* count) {
  const WorldRound& round = recipe.first;
  FixedWork fixed;
  if (!round.choice) fixed = fixed_work(round.nodes).value_or(FixedWork{});
  const std::int64_t stated = count != nullptr ? count->total.value_or(-1) : -1;
  if (fixed.takes > 0 || stated >= 0) {
    known_ = has_needle_ = true;
    needle_.set(stated >= 0 ? stated : fixed.makes);
  }
  if (fixed.takes > 0 && stated >= 0 && stated != fixed.makes) {
    wrong(name + " makes " + stitches_text(fixed.makes) + ", the line says " + std::to_string(stated) + ".");
    return false;
  }
  say(LineVerdict::not_claimed, "");
  if (known_) out_.lines[line_ - 1].stitches = needle_.count();
  return true;
}

// A round that states nothing may have been worked on the other count too, which then may still be the right one.
void WorldWorker::keep_alternative(Index index, const WorldCount& said) {
  const WorldRound& round = recipes_[index].first;
  if (!alternative_ || said.total || said.change || round.choice || moves_held(round.nodes)) {
    alternative_.reset();
    return;
  }
  WorldNeedle other;
  other.set(*alternative_);
  alternative_.reset();
  if (work_on(other, round.nodes, recipes_[index].flat, {}, budget_).sound()) alternative_ = other.count();
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one form of words after the other
bool WorldWorker::work_recipe(Index index, const std::string& name, const WorldCount* count,
                              std::size_t nth) {
  const WorldCount none;
  const WorldCount& said = count != nullptr ? *count : none;
  trace(index, said, nth);
  budget_ -= steps_of_round;
  if (!recipes_[index].first.trouble.empty()) {
    const WorldRound& round = recipes_[index].first;
    if (recipes_[index].line == line_)
      not_understood(name + ": " + round.trouble, round.at, round.length);
    else
      say(LineVerdict::not_claimed, "");
    broken_ = true;
    after_trouble(said);
    return false;
  }
  // "Knit across the 12 held sts": the round begins on an empty needle
  const bool taken = !has_needle_ && !out_.pieces.empty() && !holders_.empty() &&
                     std::any_of(recipes_[index].first.nodes.begin(), recipes_[index].first.nodes.end(),
                                 [](const WorldNode& node) { return node.kind == WorldNode::Kind::take; });
  if (taken) {
    begin_piece(0);
    out_.pieces.back().rounds.clear();
  }
  if (closed_ && !has_needle_) {
    if (fresh_ || section_.empty()) {
      // another part may begin with stitches that no line tells of
      known_ = false;
      const bool again = fresh_;
      if (!again) {
        wrong(name + " comes after the stitches were closed in line " + std::to_string(closed_line_) + ".");
        return false;
      }
    } else {
      wrong(name + " comes after the stitches were closed in line " + std::to_string(closed_line_) + ".");
      return false;
    }
  }
  if (!has_needle_ && !ever_cast_on_ && out_.pieces.empty()) {
    wrong(name + " begins and no stitches are cast on; say \"CO 6 sts\" before it.");
    ever_cast_on_ = true;
    known_ = false;
    has_needle_ = true;
    begin_piece(0);
    known_ = false;
    on_unknown(recipes_[index], name, count);
    return false;
  }
  if (!known_) return on_unknown(recipes_[index], name, count);
  if (markers_lost_ && !needle_.marked && works_to_marker(recipes_[index].first.nodes)) {
    say(LineVerdict::not_claimed, "");
    broken_ = true;
    after_trouble(said);
    return true;
  }
  // "Knit. (16 sts)" beside what was held: the needle as it is
  std::string why;
  WorldOutcome outcome;
  const WorldNeedle before = needle_;
  // Holders are copied only where a round may change them: there may be as many as lines.
  const bool moves = moves_held(recipes_[index].first.nodes) || moves_held(recipes_[index].other.nodes);
  const auto holders_now = [&] { return moves ? holders_ : std::vector<WorldHolder>{}; };
  const std::vector<WorldHolder> held = holders_now();
  const auto attempt = [&](const WorldRound& round, const WorldNeedle& from) {
    needle_ = from;
    if (moves) holders_ = held;
    const std::int64_t there = needle_.count();
    outcome = work_on(needle_, round.nodes, recipes_[index].flat, hands(), budget_);
    if (!outcome.sound()) return false;
    if (needle_.count() > most_value / 2) outcome.unknown = "more stitches than can be worked.";
    return outcome.sound() && settle_count(name, there, said, nth, false, why);
  };
  const WorldRound worked_round = moves ? with_live_ones(recipes_[index].first) : WorldRound{};
  bool done = attempt(moves ? worked_round : recipes_[index].first, before);
  std::string first_why = why;
  WorldOutcome first = outcome;
  const WorldNeedle made = needle_;
  const std::vector<WorldHolder> held_then = holders_now();
  if (!done && recipes_[index].first.choice) done = attempt(recipes_[index].other, before);
  if (!done && alternative_) {
    WorldNeedle from;
    from.set(*alternative_);
    done = attempt(recipes_[index].first, from);
  }
  if (done && recipes_[index].first.choice && !said.total && !said.change) {
    // both ways work out, and nothing says which: the stitches are not known
    const std::int64_t one = needle_.count();
    const WorldNeedle kept = needle_;
    const std::vector<WorldHolder> kept_held = holders_now();
    const bool both = attempt(recipes_[index].other, before) && needle_.count() != one;
    needle_ = kept;
    if (moves) holders_ = kept_held;
    if (both) {
      not_understood(name + ": it can be meant in two ways, and no count says which.");
      known_ = false;
      return false;
    }
  }
  if (done) {
    keep_alternative(index, said);
    worked();
    if (!out_.pieces.empty()) out_.pieces.back().rounds.push_back({line_, needle_.count()});
    return true;
  }
  needle_ = made;
  if (moves) holders_ = held_then;
  if (!first.unknown.empty()) {
    not_understood(name + ": " + first.unknown, first.at, first.length);
    after_trouble(said);
    return false;
  }
  if (!first.wrong.empty()) {
    const bool bare = first.wrong.starts_with("leaves ");
    wrong(name + (bare ? " " : ": ") + first.wrong, first.at, first.length);
    if (moves) hold_unreached(recipes_[index].first, held.size());
    after_trouble(said);
    return false;
  }
  wrong(first_why);
  doubt_holders();
  const std::int64_t came = made.count();
  if (said.total) needle_.set(*said.total);
  if (said.total) alternative_ = came;
  if (said.total && needle_.count() != came) needle_.marked = false;
  return false;
}

}  // namespace knit
