// Rounds worked again, "Repeat rnds 3 and 4 five times more", and plain ones, "Knit 3 rounds".
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "knit/reader/reader_work.h"
#include "knit/reader/world_worker.h"
#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

// "3", "3 - 6", "3 to 6": first and last.
std::optional<std::pair<std::int64_t, std::int64_t>> number_range(PhraseCursor& here) {
  if (!here.peek().is_number()) return std::nullopt;
  const std::int64_t first = here.peek().value;
  std::int64_t last = first;
  here.skip();
  if (here.sees({"-", "to", "through"}) && here.peek(1).is_number()) {
    last = here.peek(1).value;
    here.skip(2);
  }
  if (last < first || last - first > 10'000) return std::nullopt;
  return std::pair(first, last);
}

// The "and" of "rnds 3 and 4", not that of "rnd 3, 4 times".
bool take_and_before_number(PhraseCursor& here) {
  if (!here.sees({",", "and", "&"}) || !here.peek(1).is_number()) return false;
  if (here.sees({"times", "time", "more", "x"}, 2)) return false;
  here.skip();
  return true;
}

using Ranges = std::vector<std::pair<std::int64_t, std::int64_t>>;

// Nothing where one of them is not there.
std::optional<std::vector<std::size_t>> rounds_numbered(const std::map<std::int64_t, std::size_t>& rounds,
                                                        const Ranges& ranges) {
  std::vector<std::size_t> found;
  for (const auto& [first, last] : ranges) {
    for (std::int64_t number = first; number <= last; ++number) {
      const auto known = rounds.find(number);
      if (known == rounds.end()) return std::nullopt;
      found.push_back(known->second);
    }
  }
  return found;
}

// "first leg", up to the words that say how often; taken.
std::string piece_name(PhraseCursor& here) {
  Atoms words;
  while (!here.done() && here.peek().is_word() &&
         !here.sees({"again", "once", "twice", "until", "but", "with", "using", "and", "then", "x", "times",
                     "more"})) {
    words.push_back(here.peek());
    here.skip();
  }
  return world_name(words);
}

// Whether `name` has all words of `part`, in their order.
bool has_words(const std::string& name, const std::string& part) {
  return !part.empty() && (" " + name + " ").find(" " + part + " ") != std::string::npos;
}

// "dec rnd", "second inc round" as "second inc rnd"; empty where no round is named within four words.
std::string round_name(PhraseCursor& here) {
  std::string name;
  for (std::size_t words = 0; words < 4 && !here.done() && here.peek().is_word(); ++words) {
    const bool round = is_rounds(here.peek());
    name += (name.empty() ? "" : " ") + (round ? std::string("rnd") : here.peek().text);
    here.skip();
    if (round) return name;
  }
  return {};
}

// A text may define a "Decrease round" and work a "dec rnd", or the reverse.
std::string other_name(const std::string& name) {
  if (name.starts_with("decrease")) return "dec rnd";
  if (name.starts_with("increase")) return "inc rnd";
  if (name == "dec rnd") return "decrease rnd";
  if (name == "inc rnd") return "increase rnd";
  return name;
}

// Behind "every": "other rnd", "4th rnd", "following 6th row"; plain rounds lie between.
bool read_every(PhraseCursor& here, WorldRepeat& repeat) {
  std::int64_t step = 1;
  if (here.take({"other", "alternate", "alt"})) step = 2;
  here.take({"following", "foll"});
  if (here.peek().is_number()) {
    step = here.peek().value;
    here.skip();
    here.take({"st", "nd", "rd", "th"});
  }
  here.take({"following", "foll"});
  if (!is_rounds(here.peek()) || step < 1 || step > 10'000) return false;
  here.skip();
  repeat.between = step - 1;
  return true;
}

// Behind "until": "you have 12 sts left", "12 remain", "piece measures 10 cm".
bool read_until(PhraseCursor& here, WorldRepeat& repeat) {
  here.take({"you", "there"});
  here.take({"have", "are"});
  here.take({"only"});
  if (here.peek().is_number() && (is_stitches(here.peek(1)) || here.sees({"remain", "rem"}, 1))) {
    repeat.until = here.peek().value;
    here.skip(2);
    if (here.sees({"between"})) {
      here.skip();
      repeat.inner = here.take({"m", "marker", "markers", "mkrs"});
      return repeat.inner;
    }
    while (here.take({"remain", "rem", "left", "are", "on", "needle", "needles", "in", "total", "remaining",
                      "have", "been", "reached"})) {
    }
    return true;
  }
  repeat.free =
      here.sees({"piece", "work", "it", "length", "body", "sleeve", "leg", "hat", "cuff", "measures"});
  return repeat.free;
}

// "once more", "5 times", "another 3 times", "3 more times". `again`: told as a repeat, so that "6 times in all" is
// five more.
bool read_times(PhraseCursor& here, bool again, WorldRepeat& repeat) {
  if (here.take({"once"})) {
    repeat.times = 1;
    here.take({"more", "again"});
    return true;
  }
  const auto words = here.repeat_words();
  if (words && words->until == WorldNode::Until::times) {
    repeat.times = words->times - (words->in_all && again ? 1 : 0);
    return true;
  }
  if (here.sees({"another"}) && here.peek(1).is_number()) {
    here.skip();
    return true;
  }
  if (here.peek().is_number() && here.sees({"more"}, 1)) {
    repeat.times = here.peek().value;
    here.skip(2);
    here.take({"times", "time"});
    return true;
  }
  return here.take({"again", "more"});
}

// Whether the next words of a repeat, behind its rounds, are understood.
bool read_clause(PhraseCursor& here, bool again, WorldRepeat& repeat) {
  if (here.take({",", ".", "as", "and", "then", "on", "this", "these", "evenly", "set", "established"}))
    return true;
  if (here.take({"every"})) return read_every(here, repeat);
  if (here.take({"until", "to"})) return read_until(here, repeat);
  return read_times(here, again, repeat);
}

// Each round leaves as many stitches as it found, whatever their number.
bool keeps_count(const std::vector<WorldNode>& nodes) {
  const bool one =
      nodes.size() == 1 && nodes[0].takes == nodes[0].makes && nodes[0].kind == WorldNode::Kind::stitch;
  const auto fixed = fixed_work(nodes);
  return one || (fixed && fixed->takes == fixed->makes);
}

// `rounds`: how many are to be worked in all; 0: as often as the repeat says.
std::int64_t passes_of(const WorldRepeat& repeat, std::int64_t rounds) {
  const auto each = static_cast<std::int64_t>(repeat.recipes.size());
  if (rounds > 0) return (rounds + each - 1) / each;
  return repeat.free ? 1 : repeat.times;
}

// What "Knit 3 rounds", "Work 1 rnd, decreasing 8 sts evenly" or "Work in rib for 5 cm" tells.
struct PlainWords {
  std::optional<std::int64_t> rounds;
  std::optional<std::size_t> shape_at;  // where "decreasing" stands
  bool length = false;                  // worked to a length
  bool strange = false;                 // more than plain rounds
};

// One word, with those that belong to it but for the last.
void read_plain_word(PhraseCursor& here, PlainWords& told) {
  const bool number = here.peek().is_number();
  if (number && is_rounds(here.peek(1))) {
    told.rounds = here.peek().value;
    here.skip();
  } else if (number && here.sees({"more", "plain", "further", "complete"}, 1) && is_rounds(here.peek(2))) {
    told.rounds = here.peek().value;
    here.skip(2);
  } else if (here.sees({"dec", "decreasing", "inc", "increasing", "decrease", "increase"})) {
    told.shape_at = here.at();
  } else if (here.sees({"until", "inches", "cm", "inch", "\""}) || (here.sees({"in"}) && here.at() > 1)) {
    told.length = told.length || here.sees({"until", "inches", "cm", "inch"});
  } else if (here.sees({"every", "all"}) && is_rounds(here.peek(1))) {
    told.length = true;
    here.skip();
  } else if (number && here.sees({"cm", "inches", "in", "inch", "/", ".", "mm"}, 1)) {
    told.length = true;
  } else if (here.sees({"sts", "times", "m1", "kfb", "marker", "to", "rep", "repeat", "yo"}) &&
             !told.length) {
    told.strange = true;
  }
}

// Nothing: it is not plain rounds that the line tells of.
std::optional<PlainWords> plain_words(PhraseCursor& here) {
  PlainWords told;
  for (; !here.done() && !told.shape_at; here.skip()) {
    if (here.sees({"until"}) && here.peek(1).is_number()) return std::nullopt;
    read_plain_word(here, told);
  }
  if (told.strange) return std::nullopt;
  if (told.rounds) return *told.rounds < 1 ? std::nullopt : std::optional(told);
  if (!told.length || told.shape_at) return std::nullopt;
  return told;
}

bool holds_rounds(std::span<const Atom> atoms) {
  return std::any_of(atoms.begin(), atoms.end(), [](const Atom& atom) { return is_rounds(atom); });
}

}  // namespace

// "last 2 rnds", "these 2 rounds": behind the first word.
std::optional<std::vector<WorldWorker::Index>> WorldWorker::last_recipes(PhraseCursor& here) const {
  std::int64_t count = 1;
  if (here.peek().is_number()) count = here.peek().value, here.skip();
  here.take({"previous"});
  const bool many = here.sees({"rnds", "rounds", "rows"});
  if (!is_rounds(here.peek()) || (many && count == 1)) return std::nullopt;
  here.skip();
  if (count < 1 || count > static_cast<std::int64_t>(history_.size())) return std::nullopt;
  return std::vector<Index>(history_.end() - static_cast<std::ptrdiff_t>(count), history_.end());
}

// The rounds of an earlier piece whose name stands here: the one of just this name, else the only one that has these
// words, or some of them. Null: there is none, or more than one.
const WorldWorker::Numbered* WorldWorker::rounds_of_piece(PhraseCursor& here) const {
  const std::string told = piece_name(here);
  if (told.empty()) return nullptr;
  if (const auto same = by_piece_.find(told); same != by_piece_.end()) return &same->second;
  const Numbered* found = nullptr;
  for (const auto& [name, rounds] : by_piece_) {
    if (!has_words(name, told) && !has_words(told, name)) continue;
    if (found != nullptr) return nullptr;
    found = &rounds;
  }
  return found;
}

// "3 and 4", "1 - 6", "1-10 of first leg": behind "rnds".
std::optional<std::vector<WorldWorker::Index>> WorldWorker::numbered_recipes(PhraseCursor& here) const {
  Ranges ranges;
  do {
    const auto range = number_range(here);
    if (!range) return std::nullopt;
    ranges.push_back(*range);
  } while (take_and_before_number(here));
  const Numbered* rounds = &by_number_;
  if (here.take({"of", "from"})) rounds = rounds_of_piece(here);
  if (rounds == nullptr) return std::nullopt;
  return rounds_numbered(*rounds, ranges);
}

// "Rnds 1-10: as first leg": its rounds of these numbers.
std::optional<std::vector<WorldWorker::Index>> WorldWorker::recipes_like_piece(const WorldLabel& label,
                                                                               PhraseCursor& here) const {
  if (label.numbers.empty()) return std::nullopt;
  const std::size_t at = here.at();
  if (const Numbered* rounds = rounds_of_piece(here)) {
    if (auto found = rounds_numbered(*rounds, label.numbers)) return found;
  }
  here.back_to(at);
  return std::nullopt;
}

// "dec rnd", "rnd a"
std::optional<std::vector<WorldWorker::Index>> WorldWorker::named_recipe(PhraseCursor& here) const {
  std::string name = round_name(here);
  if (name.empty()) return std::nullopt;
  if (here.peek().is_word() && here.peek().length == 1 &&
      by_name_.count(name + " " + here.peek().text) != 0) {
    name += " " + here.peek().text;
    here.skip();
  }
  auto known = by_name_.find(name);
  if (known == by_name_.end()) known = by_name_.find(other_name(name));
  if (known == by_name_.end()) return std::nullopt;
  return std::vector<Index>{known->second};
}

// "rnds 3 and 4", "last 2 rnds", "these 2 rounds", "dec rnd", "rnd 3".
std::optional<std::vector<WorldWorker::Index>> WorldWorker::recipes_in(const Atoms& line, std::size_t& at) {
  PhraseCursor here(line, lexicon_);
  here.back_to(at);
  std::optional<std::vector<Index>> found;
  if (here.take({"last", "these", "previous", "those", "preceding"})) {
    found = last_recipes(here);
  } else if (is_rounds(here.peek()) || (here.sees({"r"}) && here.peek(1).is_number())) {
    here.skip();
    found = numbered_recipes(here);
  } else {
    found = named_recipe(here);
  }
  if (found) at = here.at();
  return found;
}

// Nothing and `trouble`: it repeats rounds, and which or how often is not clear.
std::optional<WorldRepeat> WorldWorker::repeat_in(const Atoms& line, bool& trouble) {
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
  WorldRepeat repeat;
  repeat.recipes = *recipes;
  bool clear = true;
  while (clear && !here.done() && !repeat.free) clear = read_clause(here, says, repeat);
  if (clear && repeat.free) return repeat;
  if (!clear || repeat.times < 0 || repeat.times > most_passes) {
    trouble = true;
    return std::nullopt;
  }
  return repeat;
}

// Once through the rounds, of which `left` are still to be worked (below 0: all). Whether it may go on.
bool WorldWorker::work_pass(const WorldRepeat& repeat, std::int64_t& left) {
  rounds_ += static_cast<std::size_t>(std::clamp<std::int64_t>(repeat.between, 0, most_passes));
  for (const Index index : repeat.recipes) {
    if (left == 0) return true;
    if (left > 0) --left;
    const bool sound = work_recipe(index, "the repeat", nullptr, 0);
    ++rounds_;
    if (!sound || !known_) return false;
    if (repeat.until == measured(repeat)) return true;  // the last pass may stop after its shaping
  }
  return true;
}

// The stitches that "until" counts: all, or those between the only two markers.
std::int64_t WorldWorker::measured(const WorldRepeat& repeat) const {
  if (!repeat.inner) return needle_.count();
  return needle_.left.size() == 3 ? needle_.left[1] : 0;
}

// Whether the needle, begun with `start`, will never have `until` after a pass that found `before`; said where so.
bool WorldWorker::misses(const WorldRepeat& repeat, std::int64_t start, std::int64_t before) {
  const std::int64_t now = measured(repeat), until = *repeat.until;
  if (now == before) {
    wrong("the repeat leaves " + stitches_text(before) + ", and never comes to " + std::to_string(until) +
          ".");
    return true;
  }
  if (!(start < until && now > until) && !(start > until && now < until)) return false;
  wrong("the repeat goes from " + stitches_text(before) + " to " + std::to_string(now) + ", and never has " +
        std::to_string(until) + ".");
  return true;
}

void WorldWorker::work_passes(const WorldRepeat& repeat, std::int64_t start, std::int64_t rounds) {
  const std::optional<std::int64_t> until = repeat.until;
  std::int64_t left = rounds > 0 ? rounds : -1;
  const std::int64_t most = until ? most_passes : passes_of(repeat, rounds);
  for (std::int64_t pass = 0; pass < most; ++pass) {
    const std::int64_t before = measured(repeat);
    if (until == before || !work_pass(repeat, left)) return;
    if (until && misses(repeat, start, before)) return;
  }
}

void WorldWorker::do_repeat(const WorldRepeat& repeat, const WorldCount& count, std::int64_t rounds) {
  traces_ = traces_ && known_;
  const bool free_shaped =
      repeat.free && std::any_of(repeat.recipes.begin(), repeat.recipes.end(),
                                 [&](Index i) { return !keeps_count(recipes_[i].first.nodes); });
  if (!known_ && repeat.until) {
    say(LineVerdict::not_claimed, "");
    WorldCount told;
    if (!repeat.inner) told.total = repeat.until;
    return after_trouble(told);
  }
  if (repeat.inner && needle_.left.size() != 3) {
    not_understood("the stitches between two markers are told, and where these stand is not known.");
    return after_trouble(count);
  }
  const std::int64_t start = known_ ? measured(repeat) : 0;
  const bool was_wrong = line_is_wrong();
  work_passes(repeat, start, rounds);
  history_.insert(history_.end(), repeat.recipes.begin(), repeat.recipes.end());
  if (free_shaped && measured(repeat) != start) {
    not_understood("how often it is repeated is told as a length, and the rounds change the stitches.");
    return after_trouble(count);
  }
  if (line_is_wrong() && !was_wrong) {
    WorldCount told = count;
    if (!told.total && !repeat.inner) told.total = repeat.until;
    return after_trouble(told);
  }
  if (!known_) {
    say(LineVerdict::not_claimed, "");
    return after_trouble(count);
  }
  worked();
  if (!count.total || needle_.count() == *count.total) return;
  wrong_but_told("the repeat makes " + stitches_text(needle_.count()), *count.total);
}

// `made`: what the needle has, in words. It goes on with what the line says.
void WorldWorker::wrong_but_told(const std::string& made, std::int64_t told) {
  wrong(made + ", the line says " + std::to_string(told) + ".");
  tell_made(needle_.count());
  alternative_ = needle_.count();
  needle_.set(told);
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
  const auto told = plain_words(here);
  if (!told) return false;
  if (!told->rounds) {
    if (!holds_rounds(part) &&
        !holds_any(part, {"pattern", "patt", "rib", "ribbing", "stockinette", "st", "garter", "even",
                          "straight", "measures", "cm", "inches", "inch"}))
      return false;
    if (count.total && known_ && needle_.count() != *count.total) {
      wrong_but_told(stitches_text(needle_.count()) + " are on the needle", *count.total);
      return true;
    }
  }
  any_number_ = true;
  run_pending(true);
  std::string how = told->shape_at ? "" : "knit";
  for (const Atom& atom : rest_of(part, told->shape_at.value_or(part.size())))
    how += (how.empty() ? "" : " ") + atom.text;
  work_plain(told->rounds.value_or(1), how, count);
  return true;
}

}  // namespace knit
