// Rounds worked again: "Repeat rnds 3 and 4 five times more", "Knit 3 rounds", "[Knit 1 rnd, inc rnd] 6 times".
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_worker.h"
#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

constexpr std::int64_t most_passes = 100'000;

std::span<const Atom> from(const Atoms& line, std::size_t at) {
  return std::span(line).subspan(std::min(at, line.size()));
}

}  // namespace

// "rnds 3 and 4", "last 2 rnds", "these 2 rounds", "dec rnd", "rnd 3".
std::optional<std::vector<WorldWorker::Index>> WorldWorker::recipes_in(const Atoms& line, std::size_t& at) {
  PhraseCursor here(line, lexicon_);
  here.back_to(at);
  std::vector<Index> found;
  const auto last = [&](std::int64_t count) {
    if (count < 1 || count > static_cast<std::int64_t>(history_.size())) return false;
    found.assign(history_.end() - static_cast<std::ptrdiff_t>(count), history_.end());
    return true;
  };
  const bool these = here.take({"last", "these", "previous", "those", "preceding"});
  if (these) {
    std::int64_t count = 1;
    if (here.peek().is_number()) count = here.peek().value, here.skip();
    here.take({"previous"});
    const bool many = here.sees({"rnds", "rounds", "rows"});
    if (!is_rounds(here.peek()) || (many && count == 1)) return std::nullopt;
    here.skip();
    if (!last(count)) return std::nullopt;
    at = here.at();
    return found;
  }
  if (is_rounds(here.peek()) || (here.sees({"r"}) && here.peek(1).is_number())) {
    here.skip();
    for (;;) {
      if (!here.peek().is_number()) return std::nullopt;
      const std::int64_t first = here.peek().value;
      std::int64_t until = first;
      here.skip();
      if (here.sees({"-", "to", "through"}) && here.peek(1).is_number()) {
        until = here.peek(1).value;
        here.skip(2);
      }
      if (until < first || until - first > 10'000) return std::nullopt;
      for (std::int64_t number = first; number <= until; ++number) {
        const auto known = by_number_.find(number);
        if (known == by_number_.end()) return std::nullopt;
        found.push_back(known->second);
      }
      if (here.sees({",", "and", "&"}) && here.peek(1).is_number() &&
          !here.sees({"times", "time", "more", "x"}, 2))
        here.skip();
      else
        break;
    }
    at = here.at();
    return found;
  }
  std::string name;
  for (std::size_t words = 0; words < 4 && !here.done() && here.peek().is_word(); ++words) {
    const bool round = is_rounds(here.peek());
    name += (name.empty() ? "" : " ") + (round ? std::string("rnd") : here.peek().text);
    here.skip();
    if (!round) continue;
    if (here.peek().is_word() && here.peek().length == 1 &&
        by_name_.count(name + " " + here.peek().text) != 0) {
      name += " " + here.peek().text;
      here.skip();
    }
    auto known = by_name_.find(name);
    if (known == by_name_.end() && name.starts_with("decrease")) known = by_name_.find("dec rnd");
    if (known == by_name_.end() && name.starts_with("increase")) known = by_name_.find("inc rnd");
    if (known == by_name_.end() && name == "dec rnd") known = by_name_.find("decrease rnd");
    if (known == by_name_.end() && name == "inc rnd") known = by_name_.find("increase rnd");
    if (known == by_name_.end()) return std::nullopt;
    at = here.at();
    return std::vector<Index>{known->second};
  }
  return std::nullopt;
}

// Nothing and `trouble`: it repeats rounds, and which or how often is not clear.
std::optional<WorldWorker::Repeat> WorldWorker::repeat_in(const Atoms& line, bool& trouble) {
  PhraseCursor here(line, lexicon_);
  here.take({"then", "now"});
  const bool says = here.take({"rep", "repeat", "repeating"});
  const bool work = !says && here.take({"work", "continue", "cont", "knit"});
  if (!says && !work) return std::nullopt;
  here.take({"to", "in", "repeat", "rep", "working"});
  if (says && here.sees({"from", "*", "around", "between"})) return std::nullopt;
  std::size_t at = here.at();
  const auto recipes = recipes_in(line, at);
  if (!recipes) {
    trouble = says;
    return std::nullopt;
  }
  here.back_to(at);
  Repeat repeat;
  repeat.recipes = *recipes;
  bool told = false;
  while (!here.done()) {
    if (here.take({",", ".", "as", "and", "then", "on", "this", "these", "evenly", "set", "established"}))
      continue;
    if (here.take({"every"})) {  // "every 4th rnd": plain rounds between
      std::int64_t step = 1;
      if (here.take({"other", "alternate", "alt"})) step = 2;
      here.take({"following", "foll"});
      if (here.peek().is_number()) {
        step = here.peek().value;
        here.skip();
        here.take({"st", "nd", "rd", "th"});
      }
      here.take({"following", "foll"});
      if (!is_rounds(here.peek()) || step < 1 || step > 10'000) {
        trouble = true;
        return std::nullopt;
      }
      here.skip();
      repeat.between = step - 1;
      continue;
    }
    const std::size_t before = here.at();
    if (here.take({"until", "to"})) {
      here.take({"you", "there"});
      here.take({"have", "are"});
      here.take({"only"});
      if (here.peek().is_number() && (is_stitches(here.peek(1)) || here.sees({"remain", "rem"}, 1))) {
        repeat.until = here.peek().value;
        here.skip(2);
        while (here.take({"remain", "rem", "left", "are", "on", "needle", "needles", "in", "total",
                          "remaining", "have", "been", "reached"})) {
        }
        told = true;
        continue;
      }
      if (here.sees({"piece", "work", "it", "length", "body", "sleeve", "leg", "hat", "cuff", "measures"})) {
        repeat.free = true;
        return repeat;
      }
      here.back_to(before);
      trouble = true;
      return std::nullopt;
    }
    if (here.take({"once"})) {
      repeat.times = 1;
      here.take({"more", "again"});
      told = true;
      continue;
    }
    const auto words = here.repeat_words();
    if (words && words->until == WorldNode::Until::times) {
      repeat.times = words->times - (words->in_all && says ? 1 : 0);
      told = true;
      continue;
    }
    if (here.sees({"another"}) && here.peek(1).is_number()) {
      here.skip();
      continue;
    }
    if (here.peek().is_number() && here.sees({"more"}, 1)) {
      repeat.times = here.peek().value;
      here.skip(2);
      here.take({"times", "time"});
      told = true;
      continue;
    }
    if (here.take({"again", "more"})) continue;
    trouble = true;
    return std::nullopt;
  }
  (void)told;
  if (repeat.times < 0 || repeat.times > most_passes) {
    trouble = true;
    return std::nullopt;
  }
  return repeat;
}

void WorldWorker::do_repeat(const Repeat& repeat, const WorldCount& count, std::int64_t rounds) {
  traces_ = traces_ && known_;
  const std::string name = "the repeat";
  std::int64_t passes = repeat.times;
  const bool shaped = std::any_of(repeat.recipes.begin(), repeat.recipes.end(), [&](Index i) {
    const auto fixed = fixed_work(recipes_[i].first.nodes);
    return !(recipes_[i].first.nodes.size() == 1 &&
             recipes_[i].first.nodes[0].takes == recipes_[i].first.nodes[0].makes &&
             recipes_[i].first.nodes[0].kind == WorldNode::Kind::stitch) &&
           !(fixed && fixed->takes == fixed->makes);
  });
  if (repeat.free) passes = 1;
  const std::optional<std::int64_t> until = repeat.until;
  if (!known_ && until) {
    say(LineVerdict::not_claimed, "");
    WorldCount told;
    told.total = until;
    return after_trouble(told);
  }
  const std::int64_t start = known_ ? needle_.count() : 0;
  if (rounds > 0)
    passes = (rounds + static_cast<std::int64_t>(repeat.recipes.size()) - 1) /
             static_cast<std::int64_t>(repeat.recipes.size());
  std::int64_t left = rounds > 0 ? rounds : -1;
  const auto mine = [&] {
    return line_ > 0 && out_.lines[line_ - 1].verdict == LineVerdict::does_not_add_up;
  };
  const bool was_wrong = mine();
  const std::int64_t most = until ? most_passes : passes;
  const std::vector<Index> recipes = repeat.recipes;
  bool stop = false;
  for (std::int64_t pass = 0; pass < most && !stop; ++pass) {
    if (until && needle_.count() == *until) break;
    const std::int64_t before = needle_.count();
    for (std::int64_t i = 0; i < std::min<std::int64_t>(repeat.between, most_passes); ++i) ++rounds_;
    for (const Index index : recipes) {
      if (left == 0) break;
      if (left > 0) --left;
      const bool sound = work_recipe(index, name, nullptr, 0);
      ++rounds_;
      if (!sound || !known_) stop = true;
      if (stop) break;
      if (until && needle_.count() == *until) break;  // the last pass may stop after its shaping
    }
    if (until && !stop && needle_.count() == before) {
      wrong(name + " leaves " + stitches_text(before) + ", and never comes to " + std::to_string(*until) +
            ".");
      stop = true;
    }
    const bool past =
        until && !stop &&
        ((start < *until && needle_.count() > *until) || (start > *until && needle_.count() < *until));
    if (past) {
      wrong(name + " goes from " + stitches_text(before) + " to " + std::to_string(needle_.count()) +
            ", and never has " + std::to_string(*until) + ".");
      stop = true;
    }
  }
  for (const Index index : recipes) history_.push_back(index);
  if (repeat.free && shaped) {
    if (needle_.count() != start) {
      not_understood("how often it is repeated is told as a length, and the rounds change the stitches.");
      return after_trouble(count);
    }
  }
  if (mine() && !was_wrong) {
    WorldCount told = count;
    if (!told.total) told.total = until;
    return after_trouble(told);
  }
  if (!known_) {
    say(LineVerdict::not_claimed, "");
    return after_trouble(count);
  }
  worked();
  if (count.total && needle_.count() != *count.total) {
    wrong("the repeat makes " + stitches_text(needle_.count()) + ", the line says " +
          std::to_string(*count.total) + ".");
    alternative_ = needle_.count();
    needle_.set(*count.total);
  }
}

void WorldWorker::work_plain(std::int64_t rounds, const std::string& how, const WorldCount& count) {
  Atoms words = atoms_of(how);
  const bool flat = rows_ && !in_round_;
  const Index plain = keep(atoms_of("knit"), "the round", flat);
  const Index last = how == "knit" ? plain : keep(std::move(words), "the round", flat);
  rounds = std::min<std::int64_t>(rounds, 10'000);
  for (std::int64_t i = 0; i < rounds; ++i) {
    const bool end = i + 1 == rounds;
    work_recipe(end ? last : plain, "the round", end ? &count : nullptr, count.all.size());
    finished_round(end ? last : plain, 0);
  }
}

// "Knit 3 rounds", "Work 3 rnds even", "Knit 1 rnd, decreasing 8 sts evenly", "Work in st st for 5 cm"
bool WorldWorker::plain_rounds(const Atoms& part, const WorldCount& count) {
  PhraseCursor here(part, lexicon_);
  here.take({"then", "now"});
  if (!here.take({"knit", "purl", "k", "p", "work", "continue", "cont"}) || !has_needle_) return false;
  std::optional<std::int64_t> rounds;
  bool shape = false, length = false, strange = false;
  std::size_t shape_at = 0;
  for (; !here.done(); here.skip()) {
    if (here.sees({"until"}) && here.peek(1).is_number()) return false;
    if (here.peek().is_number() && is_rounds(here.peek(1))) {
      rounds = here.peek().value;
      here.skip();
    } else if (here.peek().is_number() && here.sees({"more", "plain", "further", "complete"}, 1) &&
               is_rounds(here.peek(2))) {
      rounds = here.peek().value;
      here.skip(2);
    } else if (here.sees({"dec", "decreasing", "inc", "increasing", "decrease", "increase"})) {
      shape = true;
      shape_at = here.at();
      break;
    } else if (here.sees({"until", "inches", "cm", "in", "inch", "\""}) &&
               (!here.sees({"in"}) || here.at() > 1)) {
      length = length || here.sees({"until", "inches", "cm", "inch"});
    } else if (here.sees({"every", "all"}) && is_rounds(here.peek(1))) {
      length = true;
      here.skip();
    } else if (here.peek().is_number() && here.sees({"cm", "inches", "in", "inch", "/", ".", "mm"}, 1)) {
      length = true;
    } else if (here.sees({"sts", "times", "m1", "kfb", "marker", "to", "rep", "repeat", "yo"}) && !length) {
      strange = true;
    }
  }
  const bool has_rounds = std::any_of(part.begin(), part.end(), [](const Atom& a) { return is_rounds(a); });
  if (strange || (!rounds && !length)) return false;
  if (!rounds &&
      !(has_rounds || holds_any(part, {"pattern", "patt", "rib", "ribbing", "stockinette", "st", "garter",
                                       "even", "straight", "measures", "cm", "inches", "inch"})))
    return false;
  if (shape && !rounds) return false;
  if (rounds && *rounds < 1) return false;
  if (length && !rounds && count.total && known_ && needle_.count() != *count.total) {
    wrong(stitches_text(needle_.count()) + " are on the needle, the line says " +
          std::to_string(*count.total) + ".");
    alternative_ = needle_.count();
    needle_.set(*count.total);
    return true;
  }
  any_number_ = true;
  run_pending(true);
  std::string how = "knit";
  if (shape) {
    how.clear();
    for (const Atom& atom : from(part, shape_at)) how += (how.empty() ? "" : " ") + atom.text;
  }
  work_plain(rounds.value_or(1), how, count);
  return true;
}

// "[Knit 1 rnd, inc rnd] 6 times. (16, 24, 32, 40, 48, 56 sts)"
bool WorldWorker::told_rounds(const Atoms& body, const WorldCount& count, std::int64_t rounds,
                              const std::string& name) {
  if (body.empty() || !is_any(body.front(), {"[", "("}) ||
      !std::any_of(body.begin(),
                   std::find_if(body.begin(), body.end(),
                                [](const Atom& a) {
                                  return is_any(a, {")", "]"});
                                }),
                   [](const Atom& a) { return is_rounds(a); }))
    return false;
  PhraseCursor here(body, lexicon_);
  here.skip();
  struct Part {
    std::optional<Index> named;
    std::int64_t rounds = 1;
  };
  std::vector<Part> parts;
  std::int64_t once = 0, named = 0;
  while (!here.done() && !here.sees({"]", ")"})) {
    if (here.take({",", "and", "then"})) continue;
    const bool plain =
        here.sees({"knit", "k", "work"}) && here.peek(1).is_number() && is_rounds(here.peek(2));
    if (plain) {
      parts.push_back({std::nullopt, here.peek(1).value});
      once += std::min<std::int64_t>(here.peek(1).value, 1'000'000);
      here.skip(3);
      here.take({"even", "plain"});
      continue;
    }
    here.take({"work"});
    std::size_t at = here.at();
    const auto recipe = recipes_in(body, at);
    if (!recipe || recipe->size() != 1) {
      not_understood(name + ": no line before tells what this round is.", here.peek().at, here.peek().length);
      after_trouble(count);
      return true;
    }
    here.back_to(at);
    parts.push_back({recipe->front(), 1});
    ++once;
    ++named;
  }
  here.skip();
  const auto words = here.repeat_words();
  while (here.take({".", ","})) {
  }
  if (!words || words->until != WorldNode::Until::times || !here.done() || words->times < 1 ||
      words->times > most_passes || once > 10'000) {
    not_understood(name + ": how often these rounds are worked is not clear.");
    after_trouble(count);
    return true;
  }
  const auto refuse = [&](const std::string& why) {
    wrong(name + ": " + why);
    after_trouble(count);
    return true;
  };
  if (rounds > 0 && once * words->times != rounds)
    return refuse("its words are " + std::to_string(once * words->times) + " rounds, the label names " +
                  std::to_string(rounds) + ".");
  const bool list = count.all.size() > 1 || (words->times * named == 1);
  if (list && count.total && static_cast<std::int64_t>(count.all.size()) != named * words->times)
    return refuse("it is shaped in " + std::to_string(named * words->times) + " rounds, and " +
                  std::to_string(count.all.size()) + " counts are told.");
  traces_ = traces_ && known_;
  const Index plain = keep(atoms_of("knit"), "the round", rows_ && !in_round_);
  std::size_t nth = 0;
  for (std::int64_t time = 0; time < words->times; ++time) {
    for (const Part& part : parts) {
      for (std::int64_t i = 0; i < part.rounds; ++i) {
        WorldCount one;
        if (part.named) {
          ++nth;
          one.change = recipes_[*part.named].first.count.change;
          if (list && nth <= count.all.size()) one.total = count.all[nth - 1], one.all = {count.all[nth - 1]};
        }
        const bool sound = work_recipe(part.named.value_or(plain), name, part.named ? &one : nullptr, 0);
        ++rounds_;
        if (!sound) {
          after_trouble(count);
          return true;
        }
      }
    }
  }
  if (!list && known_ && count.total && needle_.count() != *count.total)
    return refuse("it makes " + stitches_text(needle_.count()) + ", the line says " +
                  std::to_string(*count.total) + ".");
  history_.push_back(plain);
  return true;
}

// "Rep rnds 3 and 4", "as rnd 1", "as round 1, with k5 for k4", "work dec rnd"
bool WorldWorker::like_another(const WorldLabel& label, const Atoms& body, const WorldCount& count) {
  PhraseCursor here(body, lexicon_);
  here.take({"work", "knit"});
  const bool as = here.take({"as", "like", "same"});
  if (!as && !here.take({"rep", "repeat"})) return false;
  here.take({"as"});
  here.take({"for", "given"});
  if (here.sees({"from", "*", "around", "between"})) return false;
  std::size_t at = here.at();
  const auto recipes = recipes_in(body, at);
  std::int64_t rounds = 0;
  for (const auto& [first, last] : label.numbers) rounds += last - first + 1;
  if (!recipes) {
    not_understood("it is not clear which round is meant.", here.peek().at, here.peek().length);
    after_trouble(count);
    return true;
  }
  here.back_to(at);
  while (here.take({",", "."})) {
  }
  if (!here.done()) {
    // "with k5 for k4", "but k5 instead of k4"
    if (recipes->size() != 1 || !here.take({"with", "but", "working", "using"})) {
      bool trouble = false;
      auto repeat = repeat_in(body, trouble);
      if (repeat) {
        do_repeat(*repeat, count, 0);
        return true;
      }
      not_understood("what is different from that round is not clear.", here.peek().at, here.peek().length);
      after_trouble(count);
      return true;
    }
    here.take({"work", "working"});
    const Atoms rest(body.begin() + static_cast<std::ptrdiff_t>(here.at()), body.end());
    std::size_t middle = 0;
    while (middle < rest.size() && !is_any(rest[middle], {"for", "instead"})) ++middle;
    std::size_t behind = middle + 1;
    if (behind < rest.size() && rest[behind].is("of")) ++behind;
    const std::span<const Atom> to = std::span(rest).first(std::min(middle, rest.size())),
                                old = from(rest, behind);
    Atoms changed;
    const Atoms& model = recipes_[recipes->front()].atoms;
    bool found = false;
    for (std::size_t i = 0; i < model.size(); ++i) {
      bool same = !old.empty() && i + old.size() <= model.size();
      for (std::size_t j = 0; same && j < old.size(); ++j) same = model[i + j].is(old[j].text);
      if (!same) {
        changed.push_back(model[i]);
        continue;
      }
      changed.insert(changed.end(), to.begin(), to.end());
      i += old.size() - 1;
      found = true;
    }
    if (!found) {
      not_understood("what is different from that round is not clear.", here.peek().at, here.peek().length);
      after_trouble(count);
      return true;
    }
    const Index index = keep(changed, "the round", recipes_[recipes->front()].flat);
    work_recipe(index,
                label.numbers.empty() ? "the round" : "Rnd " + std::to_string(label.numbers.front().first),
                &count, count.all.size());
    finished_round(index, label.numbers.empty() ? 0 : label.numbers.front().first);
    return true;
  }
  Repeat repeat;
  repeat.recipes = *recipes;
  const std::int64_t total = label.numbers.empty() ? static_cast<std::int64_t>(recipes->size()) : rounds;
  do_repeat(repeat, count, total);
  for (std::int64_t i = 0; i < rounds; ++i)
    by_number_[label.numbers.front().first + i] = (*recipes)[static_cast<std::size_t>(i) % recipes->size()];
  return true;
}

}  // namespace knit
