// Rounds: by number and by name, ahead of their turn, and worked.
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_worker.h"

namespace knit {

namespace {

std::string rnd(std::int64_t number) { return "Rnd " + std::to_string(number); }

std::int64_t rounds_named(const WorldLabel& label) {
  std::int64_t rounds = 0;
  for (const auto& [from, to] : label.numbers) rounds += to - from + 1;
  return rounds;
}

// "Rnds 3-6"; of several groups the first round.
std::string name_of_numbers(const WorldLabel& label) {
  const auto [first, last] = label.numbers.front();
  if (label.numbers.size() > 1 || first == last) return rnd(first);
  return "Rnds " + std::to_string(first) + "-" + std::to_string(last);
}

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
  if (number > 0) know_number(number, index);
  fresh_ = false;
}

void WorldWorker::know_number(std::int64_t number, Index index) {
  by_number_[number] = index;
  if (!section_.empty()) by_piece_[section_][number] = index;
}

// Its rounds wait for their turn, each with what the line says.
void WorldWorker::await_turn(const WorldLabel& label, Index index) {
  for (const auto& [from, to] : label.numbers) {
    for (std::int64_t number = from; number <= to; ++number)
      pending_[number] = {index, number == label.numbers.back().second};
  }
  if (label.every_from) rule_ = Rule{*label.every_from, label.every_step, index, history_.size()};
}

// The numbers begin anew with this line: what was told ahead is worked, and a first piece begins with Rnd 1.
void WorldWorker::begin_numbers(const WorldLabel& label, const std::string& name) {
  const std::int64_t first = label.numbers.front().first;
  const std::optional<Rule> rule = rule_;
  const bool is_new = rule && rule->told_after == history_.size();
  run_pending(true);
  if (is_new) rule_ = rule;
  const bool ahead = (label.every_from || label.numbers.size() > 1) && first > 1 && history_.empty();
  const bool skipped = !ahead && gap_ok_ && history_.empty() && first > 1 && ever_cast_on_;
  if (skipped) wrong(name + " first, and Rnd 1 is missing; if the cast on is Rnd 1, its line must say so.");
  if (!ahead) next_ = first;
}

// Rounds told ahead, or by a rule, fill the gap before this line; what then still lacks is said.
void WorldWorker::fill_gap(const WorldLabel& label, const std::string& name) {
  const std::int64_t first = label.numbers.front().first;
  std::int64_t hole = next_;
  while (hole < first && (in_rule(hole) || pending_.count(hole) != 0)) ++hole;
  const bool later = label.numbers.size() > 1 || label.every_from;
  if (hole == first || later) return;
  wrong(name + " stands here, and " + rnd(hole) +
        (first - 1 > hole ? " to " + std::to_string(first - 1) + " are" : " is") + " missing.");
  run_pending(true);
  next_ = first;
}

// Brings `next_` to the first number of the line, in order, anew, or with a complaint.
void WorldWorker::come_to(const WorldLabel& label, const std::string& name) {
  const std::int64_t first = label.numbers.front().first;
  const bool begins_again = first < next_ && (any_number_ || last_was_note_ || closed_ || fresh_);
  if (begins_again && first == 1) by_number_.clear();  // of what was worked before
  if (begins_again || (gap_ok_ && history_.empty()) || (any_number_ && first != next_)) {
    begin_numbers(label, name);
  } else if (first > next_) {
    fill_gap(label, name);
  } else if (first < next_) {
    wrong(name + " stands here, and " + rnd(next_ - 1) + " was read already; " + rnd(next_) + " comes next.");
    next_ = first;
  }
  any_number_ = false;
  gap_ok_ = false;
}

void WorldWorker::number_rounds(const WorldLabel& label, const Atoms& body) {
  const std::int64_t first = label.numbers.front().first;
  const std::int64_t rounds = rounds_named(label);
  if (rounds > most_rounds_in_line) {
    not_understood("these are more than " + std::to_string(most_rounds_in_line) + " rounds in one line.");
    known_ = false;
    return;
  }
  const std::string name = name_of_numbers(label);
  run_pending(false);
  if (any_number_ && !pending_.empty() && pending_.begin()->first > next_) {
    next_ = std::min(first, pending_.begin()->first);  // "Rnds 18, 20:" waited for this line
    any_number_ = false;
  }
  const bool waits =
      (label.numbers.size() > 1 || label.every_from) && any_number_ && !history_.empty() && first > next_;
  if (waits) return await_turn(label, keep(body, name, works_flat(label)));
  come_to(label, name);
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
  const Index index = keep(body, name, works_flat(label));
  await_turn(label, index);
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
  const bool definition = definitions_.count(label.name) != 0;
  any_number_ = any_number_ || !definition;
  if (!definition) {
    bool trouble = false;
    if (auto repeat = repeat_in(copy, trouble)) return do_repeat(*repeat, count, 0);
    if (told_rounds(copy, count, 0, name)) return;
    if (like_another(label, copy, count)) return;
  }
  const Index index = keep(body, name, works_flat(label));
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

// What a round costs beside its stitches: by itself, and for each segment between markers.
constexpr std::int64_t steps_of_round = 50, steps_of_segment = 8;

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
                               std::size_t nth, std::string& why) const {
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
    tell_made(fixed.makes);
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

WorldWorker::Standing WorldWorker::standing(bool moves) const {
  Standing now{needle_, std::nullopt};
  if (moves) now.holders = holders_;
  return now;
}

void WorldWorker::go_back(const Standing& then) {
  needle_ = then.needle;
  if (then.holders) holders_ = *then.holders;
}

// A round whose words are not understood: said on its own line, and what it leaves is known only if it is told.
bool WorldWorker::work_unread(const WorldRecipe& recipe, const std::string& name, const WorldCount& said) {
  const WorldRound& round = recipe.first;
  if (recipe.line == line_)
    not_understood(name + ": " + round.trouble, round.at, round.length);
  else
    say(LineVerdict::not_claimed, "");
  broken_ = true;
  after_trouble(said);
  return false;
}

// "Knit across the 12 held sts": the round begins on an empty needle.
void WorldWorker::begin_with_held(const WorldRound& round) {
  if (has_needle_ || out_.pieces.empty() || holders_.empty()) return;
  const bool takes = std::any_of(round.nodes.begin(), round.nodes.end(),
                                 [](const WorldNode& node) { return node.kind == WorldNode::Kind::take; });
  if (!takes) return;
  begin_piece(0);
  out_.pieces.back().rounds.clear();
}

// Whether there is something to work on, known or not; else it is said.
bool WorldWorker::has_stitches_for(const WorldRecipe& recipe, const std::string& name,
                                   const WorldCount* count) {
  if (closed_ && !has_needle_) {
    // another part may begin with stitches that no line tells of
    if (fresh_ || section_.empty()) known_ = false;
    if (!fresh_) {
      wrong(name + " comes after the stitches were closed in line " + std::to_string(closed_line_) + ".");
      return false;
    }
  }
  if (has_needle_ || ever_cast_on_ || !out_.pieces.empty()) return true;
  wrong(name + " begins and no stitches are cast on; say \"CO 6 sts\" before it.");
  begin_piece(0);
  known_ = false;
  on_unknown(recipe, name, count);
  return false;
}

// One way to read the round, worked from where it stood; the needle and the holders are left as they came out.
WorldWorker::Tried WorldWorker::try_round(const WorldRound& round, const Standing& from,
                                          const RoundSaid& said) {
  go_back(from);
  const std::int64_t there = needle_.count();
  Tried tried;
  tried.outcome = work_on(needle_, round.nodes, said.flat, hands(), budget_);
  if (!tried.outcome.sound()) return tried;
  if (needle_.count() > most_value / 2) tried.outcome.unknown = "more stitches than can be worked.";
  tried.done = tried.outcome.sound() && settle_count(said.name, there, said.count, said.nth, tried.why);
  return tried;
}

// Where both ways work out on different counts, and nothing says which: the stitches are not known.
bool WorldWorker::means_two_things(const WorldRecipe& recipe, const Standing& before, const RoundSaid& said) {
  if (!recipe.first.choice || said.count.total || said.count.change) return false;
  const Standing kept = standing(before.holders.has_value());
  const bool both = try_round(recipe.other, before, said).done && needle_.count() != kept.needle.count();
  go_back(kept);
  if (!both) return false;
  not_understood(said.name + ": it can be meant in two ways, and no count says which.");
  known_ = false;
  return true;
}

// No way of reading it came out. `first` is what the first one said, on the needle it left.
void WorldWorker::tell_failure(const WorldRound& round, const Tried& first, std::size_t held_before,
                               const RoundSaid& said) {
  const WorldOutcome& outcome = first.outcome;
  if (!outcome.unknown.empty()) {
    not_understood(said.name + ": " + outcome.unknown, outcome.at, outcome.length);
    return after_trouble(said.count);
  }
  if (!outcome.wrong.empty()) {
    const bool bare = outcome.wrong.starts_with("leaves ");
    wrong(said.name + (bare ? " " : ": ") + outcome.wrong, outcome.at, outcome.length);
    if (moves_held(round.nodes)) hold_unreached(round, held_before);
    return after_trouble(said.count);
  }
  wrong(first.why);
  tell_made(needle_.count());
  doubt_holders();
  if (!said.count.total) return;
  alternative_ = needle_.count();
  needle_.set(*said.count.total);
  if (needle_.count() != *alternative_) needle_.marked = false;
}

// The round on the needle as it is known: as it is read first, else in its other sense, else on the count that may
// still be the right one. Each is worked from where the round began.
bool WorldWorker::work_known(Index index, const RoundSaid& said) {
  const WorldRecipe& recipe = recipes_[index];
  // Holders are copied only where a round may change them: there may be as many as lines.
  const bool moves = moves_held(recipe.first.nodes) || moves_held(recipe.other.nodes);
  const Standing before = standing(moves);
  const WorldRound live = moves ? with_live_ones(recipe.first) : WorldRound{};
  const Tried first = try_round(moves ? live : recipe.first, before, said);
  const Standing made = standing(moves);
  bool done = first.done;
  if (!done && recipe.first.choice) done = try_round(recipe.other, before, said).done;
  if (!done && alternative_) {
    Standing from = before;
    from.needle = WorldNeedle();
    from.needle.set(*alternative_);
    done = try_round(recipe.first, from, said).done;
  }
  if (done) {
    if (means_two_things(recipe, before, said)) return false;
    keep_alternative(index, said.count);
    worked();
    if (!out_.pieces.empty()) out_.pieces.back().rounds.push_back({line_, needle_.count()});
    return true;
  }
  go_back(made);
  tell_failure(recipe.first, first, before.holders ? before.holders->size() : 0, said);
  return false;
}

// `count`: what is said of the stitches behind it, or null; `nth`: which of its counts, 0: the last. Whether it came out,
// as far as anything is known.
bool WorldWorker::work_recipe(Index index, const std::string& name, const WorldCount* count,
                              std::size_t nth) {
  const WorldCount none;
  const WorldCount& said = count != nullptr ? *count : none;
  trace(index, said, nth);
  // All segments between markers are walked through, and nobody has thousands.
  budget_ -= steps_of_round +
             steps_of_segment * static_cast<std::int64_t>(needle_.left.size() + needle_.right.size());
  const WorldRecipe& recipe = recipes_[index];
  if (!recipe.first.trouble.empty()) return work_unread(recipe, name, said);
  begin_with_held(recipe.first);
  if (!has_stitches_for(recipe, name, count)) return false;
  if (!known_) return on_unknown(recipe, name, count);
  if (markers_lost_ && !needle_.marked && works_to_marker(recipe.first.nodes)) {
    say(LineVerdict::not_claimed, "");
    broken_ = true;
    after_trouble(said);
    return true;
  }
  return work_known(index, {name, said, nth, recipe.flat});
}

}  // namespace knit
