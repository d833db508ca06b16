// Rounds that are told by others: "[Knit 1 rnd, inc rnd] 6 times", "as rnd 1, with k5 for k4".
#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_worker.h"
#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

// "[Knit 1 rnd, inc rnd] …", not "[k2, p2] …".
bool begins_with_rounds(const Atoms& body) {
  if (body.empty() || !is_any(body.front(), {"[", "("})) return false;
  const auto close = std::find_if(body.begin(), body.end(), [](const Atom& atom) {
    return is_any(atom, {")", "]"});
  });
  return std::any_of(body.begin(), close, [](const Atom& atom) { return is_rounds(atom); });
}

// `model` with `to` for each `old`; nothing where `old` does not stand there.
std::optional<Atoms> exchanged(const Atoms& model, std::span<const Atom> old, std::span<const Atom> to) {
  const auto stands_at = [&](std::size_t at) {
    return !old.empty() && at + old.size() <= model.size() &&
           std::equal(old.begin(), old.end(), model.begin() + static_cast<std::ptrdiff_t>(at),
                      [](const Atom& said, const Atom& worked) { return worked.is(said.text); });
  };
  Atoms changed;
  bool found = false;
  for (std::size_t i = 0; i < model.size(); ++i) {
    if (!stands_at(i)) {
      changed.push_back(model[i]);
      continue;
    }
    changed.insert(changed.end(), to.begin(), to.end());
    i += old.size() - 1;
    found = true;
  }
  if (!found) return std::nullopt;
  return changed;
}

}  // namespace

// What stands in the brackets. Nothing: `here` stands at what is not understood.
std::optional<WorldWorker::ToldRounds> WorldWorker::rounds_in_brackets(PhraseCursor& here,
                                                                       const Atoms& body) {
  ToldRounds told;
  while (!here.done() && !here.sees({"]", ")"})) {
    if (here.take({",", "and", "then"})) continue;
    if (here.sees({"knit", "k", "work"}) && here.peek(1).is_number() && is_rounds(here.peek(2))) {
      told.parts.push_back({std::nullopt, here.peek(1).value});
      told.once += std::min<std::int64_t>(here.peek(1).value, 1'000'000);
      here.skip(3);
      here.take({"even", "plain"});
      continue;
    }
    here.take({"work"});
    std::size_t at = here.at();
    const auto recipe = recipes_in(body, at);
    if (!recipe || recipe->size() != 1) return std::nullopt;
    here.back_to(at);
    told.parts.push_back({recipe->front(), 1});
    ++told.once;
    ++told.named;
  }
  here.skip();
  return told;
}

// `counts`: what each round with a name leaves, in their order; empty: not told. Whether all could be worked.
bool WorldWorker::work_told(const ToldRounds& told, Index plain, std::span<const std::int64_t> counts,
                            const std::string& name) {
  std::size_t nth = 0;
  const auto work_part = [&](const ToldRounds::Part& part) {
    WorldCount one;
    if (part.named) {
      one.change = recipes_[*part.named].first.count.change;
      if (nth < counts.size()) one.total = counts[nth], one.all = {counts[nth]};
      ++nth;
    }
    bool sound = true;
    for (std::int64_t i = 0; sound && i < part.rounds; ++i, ++rounds_)
      sound = work_recipe(part.named.value_or(plain), name, part.named ? &one : nullptr, 0);
    return sound;
  };
  for (std::int64_t time = 0; time < told.times; ++time)
    if (!std::all_of(told.parts.begin(), told.parts.end(), work_part)) return false;
  return true;
}

// "[Knit 1 rnd, inc rnd] 6 times. (16, 24, 32, 40, 48, 56 sts)"
bool WorldWorker::told_rounds(const Atoms& body, const WorldCount& count, std::int64_t rounds,
                              const std::string& name) {
  if (!begins_with_rounds(body)) return false;
  PhraseCursor here(body, lexicon_);
  here.skip();
  auto told = rounds_in_brackets(here, body);
  if (!told)
    return unclear(name + ": no line before tells what this round is.", count, here.peek().at,
                   here.peek().length);
  const auto words = here.repeat_words();
  while (here.take({".", ","})) {
  }
  if (!words || words->until != WorldNode::Until::times || !here.done() || words->times < 1 ||
      words->times > most_passes || told->once > 10'000)
    return unclear(name + ": how often these rounds are worked is not clear.", count);
  told->times = words->times;
  const auto refuse = [&](const std::string& why) {
    wrong(name + ": " + why);
    after_trouble(count);
    return true;
  };
  const std::int64_t all = told->once * told->times, shaped = told->named * told->times;
  if (rounds > 0 && all != rounds)
    return refuse("its words are " + std::to_string(all) + " rounds, the label names " +
                  std::to_string(rounds) + ".");
  const bool list = count.all.size() > 1 || shaped == 1;
  if (list && count.total && static_cast<std::int64_t>(count.all.size()) != shaped)
    return refuse("it is shaped in " + std::to_string(shaped) + " rounds, and " +
                  std::to_string(count.all.size()) + " counts are told.");
  traces_ = traces_ && known_;
  const Index plain = keep(atoms_of("knit"), "the round", rows_ && !in_round_);
  if (!work_told(*told, plain, list ? std::span(count.all) : std::span<const std::int64_t>(), name)) {
    after_trouble(count);
    return true;
  }
  if (!list && known_ && count.total && needle_.count() != *count.total)
    return refuse("it makes " + stitches_text(needle_.count()) + ", the line says " +
                  std::to_string(*count.total) + ".");
  history_.push_back(plain);
  return true;
}

// A line that works rounds again, in words that are not understood: it is dealt with.
bool WorldWorker::unclear(const std::string& sentence, const WorldCount& count, std::size_t at,
                          std::size_t length) {
  not_understood(sentence, at, length);
  after_trouble(count);
  return true;
}

// Behind the round it is like: "with k5 for k4", "but k5 instead of k4". False: nothing is exchanged that stands there.
bool WorldWorker::like_but(Index model, const WorldLabel& label, std::span<const Atom> words,
                           const WorldCount& count) {
  const auto middle = std::find_if(words.begin(), words.end(), [](const Atom& atom) {
    return is_any(atom, {"for", "instead"});
  });
  const std::span<const Atom> to(words.begin(), middle);
  std::span<const Atom> old(middle, words.end());
  if (!old.empty()) old = old.subspan(1);
  if (!old.empty() && old.front().is("of")) old = old.subspan(1);
  const auto changed = exchanged(recipes_[model].atoms, old, to);
  if (!changed) return false;
  const std::int64_t number = label.numbers.empty() ? 0 : label.numbers.front().first;
  const Index index = keep(*changed, "the round", recipes_[model].flat);
  work_recipe(index, label.numbers.empty() ? "the round" : "Rnd " + std::to_string(number), &count,
              count.all.size());
  finished_round(index, number);
  return true;
}

// "Rep rnds 3 and 4", "as rnd 1", "as round 1, with k5 for k4", "as rnds 1-10 of first leg", "Rnds 1-10: as first leg"
bool WorldWorker::like_another(const WorldLabel& label, const Atoms& body, const WorldCount& count) {
  PhraseCursor here(body, lexicon_);
  here.take({"work", "knit"});
  const bool as = here.take({"as", "like", "same"});
  if (!as && !here.take({"rep", "repeat"})) return false;
  here.take({"as"});
  here.take({"for", "given"});
  if (here.sees({"from", "*", "around", "between"})) return false;
  std::size_t at = here.at();
  auto recipes = recipes_in(body, at);
  if (recipes)
    here.back_to(at);
  else
    recipes = recipes_like_piece(label, here);
  if (!recipes)
    return unclear("it is not clear which round is meant.", count, here.peek().at, here.peek().length);
  while (here.take({",", "."})) {
  }
  if (here.done()) {
    repeat_labelled(label, *recipes, count);
    return true;
  }
  if (recipes->size() == 1 && here.take({"with", "but", "working", "using"})) {
    here.take({"work", "working"});
    if (like_but(recipes->front(), label, rest_of(body, here.at()), count)) return true;
  } else {
    bool trouble = false;
    if (const auto repeat = repeat_in(body, trouble)) {
      do_repeat(*repeat, count, 0);
      return true;
    }
  }
  return unclear("what is different from that round is not clear.", count, here.peek().at,
                 here.peek().length);
}

// As many rounds as the label names; without numbers, each once.
void WorldWorker::repeat_labelled(const WorldLabel& label, const std::vector<Index>& recipes,
                                  const WorldCount& count) {
  std::int64_t rounds = 0;
  for (const auto& [first, last] : label.numbers) rounds += last - first + 1;
  WorldRepeat repeat;
  repeat.recipes = recipes;
  do_repeat(repeat, count, label.numbers.empty() ? static_cast<std::int64_t>(recipes.size()) : rounds);
  for (std::int64_t i = 0; i < rounds; ++i)
    know_number(label.numbers.front().first + i, recipes[static_cast<std::size_t>(i) % recipes.size()]);
}

}  // namespace knit
