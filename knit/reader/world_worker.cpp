// Lines and sentences: what each is, and who works it.
#include "knit/reader/world_worker.h"

#include <algorithm>
#include <utility>

#include "knit/reader/reader_work.h"
#include "knit/trade/world_phrases.h"

namespace knit {

namespace {

int severity(LineVerdict verdict) {
  switch (verdict) {
    case LineVerdict::no_instruction:
      return 0;
    case LineVerdict::holds:
      return 1;
    case LineVerdict::not_claimed:
      return 2;
    case LineVerdict::not_understood:
      return 3;
    case LineVerdict::does_not_add_up:
      return 4;
  }
  return 0;
}

std::vector<Atoms> sentences_of(const Atoms& line) {
  std::vector<Atoms> parts(1);
  int depth = 0;
  for (const Atom& atom : line) {
    if (is_any(atom, {"(", "["})) ++depth;
    if (is_any(atom, {")", "]"})) --depth;
    if (depth <= 0 && (is_any(atom, {".", "!"}))) {
      if (!parts.back().empty()) parts.emplace_back();
      continue;
    }
    parts.back().push_back(atom);
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

}  // namespace

void WorldWorker::say_at(std::size_t line, LineVerdict verdict, std::string sentence, std::size_t at,
                         std::size_t length) {
  if (line == 0 || line > out_.lines.size()) return;
  CheckedLine& told = out_.lines[line - 1];
  if (severity(verdict) <= severity(told.verdict)) return;
  told.verdict = verdict;
  if (sentence.empty()) return;
  told.sentence = "line " + std::to_string(line) + ": " + std::move(sentence);
  told.word_at = told.word_length = 0;
  if (length == 0 || at >= texts_[line - 1].size()) return;
  const std::string_view word = texts_[line - 1].substr(at, length);
  const std::size_t found = physical_[line - 1].find(word);
  if (found == std::string_view::npos) return;
  told.word_at = found;
  told.word_length = word.size();
}
void WorldWorker::say(LineVerdict verdict, std::string sentence, std::size_t at, std::size_t length) {
  say_at(line_, verdict, std::move(sentence), at, length);
}
void WorldWorker::wrong(const std::string& sentence, std::size_t at, std::size_t length) {
  say(LineVerdict::does_not_add_up, sentence, at, length);
}
void WorldWorker::not_understood(const std::string& sentence, std::size_t at, std::size_t length) {
  say(LineVerdict::not_understood, sentence, at, length);
  broken_ = true;
}
void WorldWorker::tell_made(std::int64_t stitches) {
  if (line_ > 0) out_.lines[line_ - 1].stitches = stitches;
}
void WorldWorker::worked() {
  say(known_ || !has_needle_ ? LineVerdict::holds : LineVerdict::not_claimed, "");
  if (known_ && has_needle_ && !line_is_wrong()) tell_made(needle_.count());
}

CheckedSize WorldWorker::run(const std::vector<TextLine>& lines, const std::vector<Atoms>& atoms,
                             const std::vector<std::string_view>& physical, std::int64_t start) {
  out_.lines.resize(physical.size());
  physical_ = physical;
  texts_.resize(physical.size());
  for (std::size_t i = 0; i < physical.size(); ++i) out_.lines[i].number = i + 1;
  if (start > 0) {
    begin_piece(start);
    fresh_ = false;
  }
  find_definitions(atoms);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    line_ = lines[i].number;
    if (line_ == 0 || line_ > physical.size()) continue;
    texts_[line_ - 1] = lines[i].text;
    whole_line(atoms[i]);
    if (only_tried_ && severity(out_.lines[line_ - 1].verdict) > severity(LineVerdict::holds)) break;
  }
  finish();
  if (known_ && has_needle_) last_count_ = needle_.count();
  give_first_line();
  for (const CheckedLine& line : out_.lines) {
    if (line.verdict == LineVerdict::does_not_add_up)
      out_.verdict = PatternVerdict::does_not_add_up;
    else if (severity(line.verdict) >= 2 && out_.verdict == PatternVerdict::holds)
      out_.verdict = PatternVerdict::not_understood;
  }
  return std::move(out_);
}

// Stitches that no line casts on stand where the work begins.
void WorldWorker::give_first_line() {
  std::size_t first = 0;
  while (first + 1 < out_.lines.size() && out_.lines[first].verdict == LineVerdict::no_instruction) ++first;
  if (out_.lines[first].verdict == LineVerdict::no_instruction) first = 0;
  for (CheckedPiece& piece : out_.pieces) {
    for (CheckedRound& round : piece.rounds) {
      if (round.line == 0) round.line = first + 1;
    }
  }
}

void WorldWorker::trace(Index index, const WorldCount& said, std::size_t nth) {
  constexpr std::size_t most_traced = 40;
  if (!traces_ || only_tried_) return;
  if (trace_.size() == most_traced || recipes_[index].first.choice) {
    traces_ = false;
    return;
  }
  Traced traced{index, said.total, said.change};
  if (said.total && nth > 0 && nth <= said.all.size()) traced.total = said.all[nth - 1];
  trace_.push_back(traced);
}

bool WorldWorker::may_start_with(std::int64_t start, std::int64_t& budget) const {
  WorldNeedle needle;
  needle.set(start);
  for (const Traced& traced : trace_) {
    const WorldRecipe& recipe = recipes_[traced.recipe];
    const std::int64_t before = needle.count();
    if (budget <= 0 || !work_on(needle, recipe.first.nodes, recipe.flat, {}, budget).sound()) return false;
    const std::int64_t made = needle.count();
    if ((traced.total && made != *traced.total) || (traced.change && made - before != *traced.change))
      return false;
  }
  return !traces_ || needle.count() == start;
}

// "Inc rnd: ..." that other lines name in brackets is told there and worked where it is named.
void WorldWorker::find_definitions(const std::vector<Atoms>& lines) {
  for (const Atoms& line : lines) {
    bool inside = false;
    std::string name;
    for (const Atom& atom : line) {
      if (is_any(atom, {"(", "[", ","}) || atom.is_number()) {
        inside = inside || is_any(atom, {"[", "("});
        name.clear();
      } else if (is_any(atom, {")", "]"})) {
        inside = false;
      } else if (inside && atom.is_word()) {
        name += (name.empty() ? "" : " ") + atom.text;
        if (name.ends_with(" rnd") || name.ends_with(" round") || name.ends_with(" row"))
          definitions_.insert(name.substr(0, name.rfind(' ')) + " rnd");
        const std::size_t rounds = name.find(" rnd ");
        if (rounds != std::string::npos) definitions_.insert(name);
      }
    }
  }
}

// "80 (88, 96)", "106[112]", "20 (24:28)": the number of the size at hand. False where the numbers are too many or too few.
bool WorldWorker::sized(Atoms& line) {
  if (sizes_ < 2) return true;
  Atoms out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    out.push_back(line[i]);
    if (!line[i].is_number() || i + 2 >= line.size() || !is_any(line[i + 1], {"(", "["}) ||
        !line[i + 2].is_number())
      continue;
    std::vector<std::int64_t> numbers{line[i].value};
    std::size_t j = i + 2;
    while (j < line.size() && line[j].is_number()) {
      numbers.push_back(line[j].value);
      ++j;
      if (j < line.size() && is_any(line[j], {",", ":", ";", "/", "-", "."}) && j + 1 < line.size() &&
          line[j + 1].is_number())
        ++j;
      while (numbers.size() < sizes_ && j + 1 < line.size() && is_any(line[j], {")", "]"}) &&
             is_any(line[j + 1], {"(", "["}) && j + 2 < line.size() && line[j + 2].is_number())
        j += 2;
    }
    if (j >= line.size() || !is_any(line[j], {")", "]"})) continue;
    if (numbers.size() != sizes_) {
      not_understood(std::to_string(sizes_) + " sizes are told, and " + std::to_string(numbers.size()) +
                         " numbers stand here.",
                     line[i].at, line[j].at + line[j].length - line[i].at);
      return false;
    }
    out.back().value = numbers[size_];
    out.back().text = std::to_string(numbers[size_]);
    i = j;
  }
  line = std::move(out);
  return true;
}

// Several rounds in one paragraph are parted at their labels.
void WorldWorker::whole_line(Atoms line) {
  while (!line.empty() && is_any(line.front(), {"-", "|", "+", "#", "_", ">"})) line.erase(line.begin());
  if (line.empty()) return;
  if (!sized(line)) {
    known_ = false;
    return;
  }
  // A star before a line of work that has no other is a bullet.
  if (line.front().is("*")) {
    const std::span<const Atom> rest = std::span(line).subspan(1);
    const bool label = world_label(rest, lexicon_).has_value();
    if (label || (!holds_any(rest, {"*", "rep", "repeat"}))) line.erase(line.begin());
  }
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (is_any(line[i], {"(", "["})) ++depth;
    if (is_any(line[i], {")", "]"})) --depth;
    if (depth > 0 || !is_any(line[i - 1], {".", ")", "]", ";"}) || i - begin < 2) continue;
    const bool may = line[i].is_word() || (line[i].is_number() && i + 1 < line.size() &&
                                           is_any(line[i + 1], {"st", "nd", "rd", "th"}));
    if (!may || lexicon_.match(line, i)) continue;
    const auto label = world_label(std::span(line).subspan(i), lexicon_);
    if (!label || !is_any(line[i + label->atoms - 1], {":", "-"}) ||
        world_label(std::span(line).subspan(begin, 2), lexicon_).has_value())
      continue;
    if (i + label->atoms >= line.size()) continue;
    one_line(Atoms(line.begin() + static_cast<std::ptrdiff_t>(begin),
                   line.begin() + static_cast<std::ptrdiff_t>(i)));
    begin = i;
  }
  one_line(Atoms(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end()));
}

void WorldWorker::one_line(const Atoms& line) {
  const auto label = world_label(line, lexicon_);
  if (label && !(label->bare_number && tells_ && !looks_like_work(line, lexicon_))) {
    const Atoms body(line.begin() + static_cast<std::ptrdiff_t>(label->atoms), line.end());
    labelled(*label, body);
    tells_ = false;
    last_was_note_ = false;
    return;
  }
  if (title(line)) {
    last_was_note_ = true;
    return;
  }
  unlabelled(line);
}

bool WorldWorker::title(const Atoms& line) {
  std::size_t colon = 0;
  while (colon < line.size() && !line[colon].is(":")) ++colon;
  const auto told = world_title(std::span(line).first(colon), lexicon_);
  if (!told) return false;
  const bool alone = colon + 1 >= line.size();
  if (!alone && told->tells) {
    const Atoms rest(line.begin() + static_cast<std::ptrdiff_t>(colon) + 1, line.end());
    Atoms copy = rest;
    const WorldCount count = take_count(copy, lexicon_);
    return !count.total || !looks_like_work(rest, lexicon_);
  }
  if (!alone && is_word_list(line, lexicon_)) return true;
  tells_ = told->tells;
  if (tells_) return true;
  run_pending(true);
  section_ = told->name;
  copies_ = told->made;
  fresh_ = true;
  any_number_ = true;
  gap_ok_ = true;
  if (!alone) unlabelled(Atoms(line.begin() + static_cast<std::ptrdiff_t>(colon) + 1, line.end()));
  return true;
}

void WorldWorker::labelled(const WorldLabel& label, Atoms line) {
  rows_ = rows_ || (label.rows && !in_round_);
  // what follows the round in sentences of its own
  Atoms words = line;
  take_count(words, lexicon_);
  const Atoms stated(line.begin() + static_cast<std::ptrdiff_t>(words.size()), line.end());
  std::vector<Atoms> parts = sentences_of(words);
  Atoms body;
  std::vector<Atoms> behind;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool again = is_any(parts[i].front(), {"rep", "repeat"});
    Atoms copy = parts[i];
    copy.insert(copy.begin(), {Atom::Kind::mark, ".", 0, parts[i].front().at, 0, false});
    const bool note =
        i > 0 && !again && !looks_like_work(parts[i], lexicon_) && !take_count(copy, lexicon_).total;
    const bool ends =
        i > 0 &&
        is_any(parts[i].front(), {"break", "cut", "bo", "bind", "cast", "thread", "draw", "fasten", "place",
                                  "put", "graft", "leave", "pull", "slip"}) &&
        (holds_any(parts[i], {"off", "bo", "through", "thru", "holder", "yarn", "graft", "marker", "markers",
                              "needle"}));
    if (note || ends || !behind.empty()) {
      behind.push_back(parts[i]);
      continue;
    }
    if (!body.empty()) body.push_back({Atom::Kind::mark, ".", 0, parts[i].front().at, 0, false});
    body.insert(body.end(), parts[i].begin(), parts[i].end());
  }
  if (!body.empty()) body.insert(body.end(), stated.begin(), stated.end());
  if (!label.trouble.empty()) {
    wrong((label.name.empty() ? "the line" : label.name) + label.trouble);
  } else if (holds_any(body, {"co", "cast"}) && (!has_needle_ || fresh_) && cast_on(body, body)) {
    if (!label.numbers.empty()) next_ = label.numbers.back().second + 1;
    any_number_ = gap_ok_ = false;
    worked();
  } else if (!label.numbers.empty()) {
    number_rounds(label, body);
  } else {
    named_round(label, body);
  }
  for (const Atoms& part : behind) sentence(part, part);
}

void WorldWorker::unlabelled(const Atoms& line) {
  if (is_word_list(line, lexicon_)) return;
  Atoms copy = line;
  const WorldCount count = take_count(copy, lexicon_);
  if (tells_) {
    // what tells does not work, unless it plainly does
    const WorldRound round = world_round(copy, lexicon_, false);
    const bool work = count.total && round.trouble.empty() && has_needle_;
    bool starts = false;
    for (std::size_t i = 0; i + 1 < line.size() && !has_needle_; ++i) {
      const bool casts = line[i].is("co") || (line[i].is("cast") && line[i + 1].is("on"));
      for (std::size_t j = i + 1; casts && j < std::min(line.size(), i + 6); ++j)
        starts = starts || line[j].is_number();
    }
    if (!work && !starts) return;
    tells_ = false;
  }
  std::vector<Atoms> parts;
  for (const Atoms& part : sentences_of(line)) {
    if (!parts.empty() && is_any(part.front(), {"rep", "repeat"}) && part.size() > 1 &&
        is_any(part[1], {"from", "*", "between"})) {
      parts.back().push_back({Atom::Kind::mark, ".", 0, part.front().at, 0, false});
      parts.back().insert(parts.back().end(), part.begin(), part.end());
    } else {
      parts.push_back(part);
    }
  }
  for (const Atoms& part : parts) sentence(part, line);
}

void WorldWorker::sentence(Atoms part, const Atoms& line) {
  while (!part.empty() && is_any(part.front(), {"-", ",", ";", ":", "="})) part.erase(part.begin());
  if (part.empty()) return;
  Atoms copy = part;
  WorldCount count = take_count(copy, lexicon_);
  if (count.total && copy.empty()) return check_after(count);
  if (!count.total && !count.change) {
    // the count may stand in a sentence of its own: "K10, k2tog. 11 sts."
    Atoms whole = line;
    count = take_count(whole, lexicon_);
    Atoms alone = part;
    alone.insert(alone.begin(), {Atom::Kind::mark, ".", 0, part.front().at, 0, false});
    if (take_count(alone, lexicon_).total && alone.empty()) return check_after(count);
  }
  if (cast_on(copy, line) || place_markers(copy) || remove_markers(copy) || join_ends(copy) || close(copy) ||
      as_before(copy) || hold_all(copy, count) || take_all(copy, count) || pick_up(copy, count)) {
    last_was_note_ = false;
    return;
  }
  bool trouble = false;
  if (auto repeat = repeat_in(copy, trouble)) {
    run_pending(true);
    do_repeat(*repeat, count, 0);
    any_number_ = true;
    last_was_note_ = false;
    return;
  }
  if (trouble) {
    not_understood("it is not clear which rounds are repeated.", part.front().at, part.front().length);
    after_trouble(count);
    any_number_ = true;
    return;
  }
  if (plain_rounds(copy, count)) {
    last_was_note_ = false;
    return;
  }
  const WorldRound tried = world_round(copy, lexicon_, false);
  const bool reads = has_needle_ && tried.trouble.empty() &&
                     std::any_of(tried.nodes.begin(), tried.nodes.end(), [](const WorldNode& node) {
                       return node.kind == WorldNode::Kind::stitch || node.kind == WorldNode::Kind::repeat ||
                              node.kind == WorldNode::Kind::rest || node.kind == WorldNode::Kind::shape;
                     });
  if (!reads && !looks_like_work(part, lexicon_) && !(count.total && looks_like_work(copy, lexicon_))) {
    if (count.total && has_needle_ && holds_any(part, {"sts", "stitches"})) {
      not_understood("it states stitches, and what makes them is not understood.", part.front().at,
                     part.front().length);
      after_trouble(count);
      return;
    }
    in_round_ =
        in_round_ ||
        (holds_any(part, {"join"}) && holds_any(part, {"round", "rnd", "joining", "twist", "circle"})) ||
        (holds_any(part, {"join"}) && part.size() < 3);
    last_was_note_ = true;
    return;
  }
  if (!has_needle_ && !ever_cast_on_) {
    const WorldRound round = world_round(copy, lexicon_, false);
    if (!round.trouble.empty()) return;
  }
  WorldLabel label;
  label.name = "round";
  Atoms body = copy;
  if (count.total || count.change) body = part;
  if (!take_count(copy = body, lexicon_).total && count.total) {
    body.push_back({Atom::Kind::mark, "(", 0, 0, 0, false});
    body.push_back({Atom::Kind::number, std::to_string(*count.total), *count.total, 0, 0, false});
    body.push_back({Atom::Kind::word, "sts", 0, 0, 0, false});
    body.push_back({Atom::Kind::mark, ")", 0, 0, 0, false});
  }
  named_round(label, body);
  last_was_note_ = false;
}

void WorldWorker::check_after(const WorldCount& count) {
  if (!count.total || !has_needle_) return;
  if (!known_) {
    needle_.set(*count.total);
    known_ = true;
    worked();
    return;
  }
  if (may_have(*count.total)) {
    if (needle_.count() != *count.total) needle_.set(*count.total);
    return worked();
  }
  doubt_holders();
  wrong(stitches_text(needle_.count()) + (needle_.count() == 1 ? " is" : " are") +
        " on the needle, the line says " + std::to_string(*count.total) +
        forgotten(*count.total - needle_.count()) + ".");
  tell_made(needle_.count());
  alternative_ = needle_.count();
  needle_.set(*count.total);
}

void WorldWorker::finish() {
  run_pending(true);
  if (broken_) return;
  for (const WorldHolder& holder : holders_) {
    if (holder.taken || holder.waste || holder.implied || !holder.count) continue;
    say_at(holder.line, LineVerdict::does_not_add_up,
           stitches_text(*holder.count) + (*holder.count == 1 ? " is" : " are") + " left on the holder" +
               (holder.name.empty() ? "" : " of the " + holder.name) + ", and no line takes them off.",
           0, 0);
  }
}

}  // namespace knit
