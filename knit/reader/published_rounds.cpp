// Rounds of a published pattern: work, and between it holders filled and emptied and edges.
#include <algorithm>
#include <utility>

#include "knit/reader/published_work.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

constexpr std::int64_t most_rounds_told = 10'000;
constexpr std::int64_t most_published_work = 4'000'000;  // stitches in all; a round costs some by itself
constexpr std::int64_t work_of_a_published_round = 16;

std::string rounds_named(std::int64_t first, std::int64_t last) {
  if (first == last) return "Rnd " + std::to_string(first);
  return "Rnds " + std::to_string(first) + "-" + std::to_string(last);
}

bool is_all_work(const std::vector<PublishedPart>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const PublishedPart& part) {
    return part.use == PublishedUse::work || part.use == PublishedUse::none;
  });
}

// Done when the round is: it takes all that is there.
bool is_of_the_end(const PublishedPart& part) {
  return part.use == PublishedUse::join_ends || (part.use == PublishedUse::close && part.all);
}

bool refers_back(const Tokens& tokens) {
  return std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.is("again") || token.is("them") || token.is("those");
  });
}

// "Purl." is of all stitches, as "Knit." is.
Tokens with_bare_purl_as_knit(Tokens words) {
  const bool purls = !words.empty() && (words.front().is("purl") || words.front().is("p"));
  const bool bare = words.size() == 1 || (words.size() > 1 && words[1].kind == Token::Kind::mark);
  if (purls && bare) words.front() = tokens_of("knit").front();
  return words;
}

}  // namespace

void PublishedWorker::round(const RoundLabel& label, const Tokens& tokens) {
  const std::int64_t first = label.first.value_or(next_), last = label.first ? label.last : next_;
  name_ = label.first ? rounds_named(first, last) : "the round";
  if (!label.mistake.empty()) blame(name_ + label.mistake);
  const bool may_begin_anew = fresh_ || rounds_here_ == 0 || next_ == 0 || std::exchange(any_number_, false);
  if (label.first && first != next_ && !may_begin_anew) {
    blame(name_ + (first == last ? " stands" : " stand") + " here, and Rnd " + std::to_string(next_) +
          " comes next.");
    needle_.known = false;
    any_number_ = true;
    too_many_ = 1;
  }
  if (last - first >= most_rounds_told || last < first) {
    if (last >= first) blame(name_ + " are more than can be read.");
    needle_.known = false;
    return;
  }
  next_ = last + 1;
  any_number_ = any_number_ || !label.first;
  const Tokens words(tokens.begin() + static_cast<std::ptrdiff_t>(label.tokens), tokens.end());
  if (const auto repeated = repeated_rounds(words)) {
    const auto stated = stated_in(words);
    if (!repeat(*repeated, last - first + 1)) go_on_with(std::nullopt);
    if (is_needle_known() && stated && *stated != needle_.count())
      blame(name_ + " makes " + stitches_text(needle_.count()) + ", the line says " +
            std::to_string(*stated) + ".");
    if (stated) go_on_with(stated);
    return;
  }
  for (std::int64_t number = first; number <= last && !is_too_long_; ++number) {
    told_.push_back({number, words});
    work(words, number == last);
    told_.back().is_bad = line_is_bad_;
    if (line_is_bad_ && number < last) {
      go_on_with(stated_in(words));
      break;
    }
  }
  fresh_ = false;
}

// Whether it could be told what is repeated; the needle is as after it.
bool PublishedWorker::repeat(const RepeatedRounds& repeated, std::int64_t rounds) {
  constexpr std::int64_t most_times = 1000;
  std::vector<Told> again;
  if (repeated.first) {
    for (std::int64_t number = *repeated.first;
         number <= std::min(repeated.last, *repeated.first + most_times); ++number) {
      const auto found =
          std::find_if(told_.rbegin(), told_.rend(), [&](const Told& told) { return told.number == number; });
      if (found == told_.rend()) return false;
      again.push_back(*found);
    }
  } else if (repeated.count > 0 && static_cast<std::size_t>(repeated.count) <= told_.size()) {
    again.assign(told_.end() - static_cast<std::ptrdiff_t>(repeated.count), told_.end());
  }
  if (again.empty() || !repeated.understood || !is_needle_known()) return false;
  const auto size = static_cast<std::int64_t>(again.size());
  std::int64_t total = rounds > 0 ? rounds : std::min(repeated.times, most_times) * size;
  if (repeated.until && rounds == 0) total = most_times;
  const std::string name = name_;
  for (std::int64_t i = 0; i < total && !line_is_bad_; ++i) {
    if (repeated.until && rounds == 0 && i % size == 0 && needle_.count() == *repeated.until) break;
    const Told& told = again[static_cast<std::size_t>(i % size)];
    if (told.is_bad) return false;
    name_ = told.number > 0 ? "Rnd " + std::to_string(told.number) + ", repeated" : "the round, repeated";
    work(told.words, false);
  }
  name_ = name;
  if (repeated.until && rounds == 0 && !line_is_bad_ && needle_.count() != *repeated.until)
    blame("the repeat never comes to " + stitches_text(*repeated.until) + ".");
  return !line_is_bad_;
}

void PublishedWorker::take_implied() {
  for (PublishedHolder* const held : holders_.called(section_)) {
    const bool own = !section_.empty() && !held->name.empty() && same_name(section_, held->name);
    if (!held->implied && !own) continue;
    needle_ = held->loop;
    held->emptied = line_;
    has_needle_ = true;
    needle_of_ = section_;
    return;
  }
}

// "Knit across the 12 sts of the second leg, knit across the 12 held sts of the first leg": those of the second are live.
void PublishedWorker::is_live_already(std::vector<PublishedPart>& parts) const {
  const bool works = std::any_of(parts.begin(), parts.end(), [](const PublishedPart& part) {
    return part.use == PublishedUse::work || part.use == PublishedUse::hold;
  });
  if (works || !is_needle_known() || needle_.count() == 0) return;
  for (PublishedPart& part : parts) {
    if (part.use != PublishedUse::take || part.held || part.count != needle_.count()) continue;
    part.use = PublishedUse::work;
    part.tokens = tokens_of("k" + std::to_string(*part.count));
    return;
  }
}

void PublishedWorker::work(const Tokens& told, bool stated_here) {
  const Tokens words = with_bare_purl_as_knit(told);
  const auto stated = stated_in(words);
  std::vector<PublishedPart> parts = parts_of(without_counts(words), true);
  const bool only_adds = !parts.empty() && parts.front().use == PublishedUse::add &&
                         !parts.front().picks_up &&
                         std::all_of(parts.begin() + 1, parts.end(),
                                     [](const PublishedPart& p) { return p.use == PublishedUse::none; });
  if (only_adds && (!has_needle_ || (fresh_ && needle_of_ != section_))) {
    add(parts.front(), false);
    if (stated && *stated != *parts.front().count)
      blame(name_ + " makes " + stitches_text(*parts.front().count) + ", the line says " +
            std::to_string(*stated) + ".");
    if (line_is_bad_) go_on_with(stated);
    return;
  }
  const auto has = [&](PublishedUse use) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const PublishedPart& part) { return part.use == use; });
  };
  const bool brings = has(PublishedUse::take) || (has(PublishedUse::add) && !has(PublishedUse::work));
  if (!has_needle_ && !has(PublishedUse::take)) take_implied();
  if (!has_needle_ && !brings) {
    blame(name_ + " begins, and there are no stitches on the needle.");
    holders_.excuse(std::nullopt);
    needle_ = {{}, false};
  }
  if (!has_needle_) has_needle_ = true;
  if (is_all_work(parts)) {
    const RoundWords read = round_words(words);
    if (read.mistake.empty()) {
      PublishedPart whole;
      whole.use = PublishedUse::work;
      whole.tokens = without_counts(words);
      parts = {whole};
    } else if (std::none_of(parts.begin(), parts.end(), [](const PublishedPart& p) { return p.floats; }) &&
               std::any_of(parts.begin(), parts.end(), [](const PublishedPart& p) {
                 return p.use == PublishedUse::work && !round_words(p.tokens).mistake.empty();
               })) {
      blame(name_ + read.mistake);
    }
  }
  work_parts(parts, stated_here ? stated : std::nullopt);
}

std::vector<PublishedWorker::WorkPart> PublishedWorker::read_parts(const std::vector<PublishedPart>& parts,
                                                                   Hand& hand) {
  std::vector<WorkPart> works(parts.size());
  bool all_fixed = true;
  std::int64_t inserted = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PublishedPart& part = parts[i];
    if (part.use == PublishedUse::work) {
      works[i].words = round_words(
          inserted > 0 && refers_back(part.tokens) ? tokens_of("k" + std::to_string(inserted)) : part.tokens);
      const auto& nodes = works[i].words.nodes;
      if (works[i].words.mistake.empty()) works[i].takes = fixed_takes(nodes);
      if (!works[i].takes && !nodes.empty() && nodes.back().open && nodes.back().tail > 0)
        works[i].tail = nodes.back().tail;
      hand.behind += works[i].takes.value_or(0);
      all_fixed = all_fixed && works[i].takes;
    } else if (part.use == PublishedUse::hold || part.use == PublishedUse::insert) {
      hand.behind += part.count.value_or(0);
      all_fixed = all_fixed && part.count;
      if (part.use == PublishedUse::insert) inserted = *part.count;
    } else if (part.use == PublishedUse::slip_back) {
      hand.behind -= part.count.value_or(inserted);
    } else if (part.use == PublishedUse::close && !part.all) {
      hand.behind += part.count.value_or(0);
    }
  }
  bool open = false;
  for (std::size_t i = parts.size(); i-- > 0;) {
    works[i].open_behind = open;
    open = open || (parts[i].use == PublishedUse::work && works[i].words.mistake.empty() && !works[i].takes);
  }
  if (!hand.known && all_fixed) {
    hand.known = true;
    hand.left = hand.behind;
  }
  return works;
}

// Where the count is in doubt, what works out with the stated one is taken for right; else it is not known.
void PublishedWorker::work_parts(const std::vector<PublishedPart>& told, std::optional<std::int64_t> stated) {
  std::vector<PublishedPart> parts = told;
  for (PublishedPart& part : parts) {
    // "K across 40 front sts": no holder is called so.
    if (part.use != PublishedUse::take || !part.maybe) continue;
    const PublishedHolder* const holder = holders_.find({part.name, section_, part.count});
    if (holder != nullptr && !part.name.empty() && !holder->name.empty()) continue;
    part.use = PublishedUse::work;
    part.floats = !part.count;
    part.tokens = tokens_of(part.count ? "k" + std::to_string(*part.count) : "k");
  }
  is_live_already(parts);
  if (!needle_.known || !needle_.doubtful || line_is_bad_) return work_in_order(std::move(parts), stated);
  const PublishedHolders holders = holders_;
  const ReadPattern read = read_;
  const auto rounds_here = rounds_here_;
  work_ += holders_.count();
  const bool stays_doubtful = !stated;
  work_in_order(parts, stated);
  if (!line_is_bad_) {
    needle_.doubtful = stays_doubtful && needle_.known;
    return;
  }
  holders_ = holders;
  read_ = read;
  rounds_here_ = rounds_here;
  line_is_bad_ = false;
  has_needle_ = true;
  needle_ = {{}, false};
  work_in_order(std::move(parts), stated);
}

void PublishedWorker::work_in_order(std::vector<PublishedPart> parts, std::optional<std::int64_t> stated) {
  std::vector<PublishedPart> after;
  const auto end = std::stable_partition(parts.begin(), parts.end(),
                                         [](const PublishedPart& p) { return !is_of_the_end(p); });
  after.assign(end, parts.end());
  parts.erase(end, parts.end());
  const bool idle = std::all_of(parts.begin(), parts.end(),
                                [](const PublishedPart& p) { return p.use == PublishedUse::none; });
  if (!idle || after.empty()) {
    Hand hand;
    hand.left = needle_.count();
    hand.known = needle_.known;
    const std::vector<WorkPart> works = read_parts(parts, hand);
    for (std::size_t i = 0; i < parts.size(); ++i) round_part(parts[i], works[i], hand);
    if (hand.known && hand.left > 0)
      blame(name_ + " leaves " + stitches_text(hand.left) + " of the round before unworked.");
    settle(std::move(hand), stated);
  }
  for (const PublishedPart& part : after) prose_part(part, false, std::nullopt);
}

void PublishedWorker::round_part(const PublishedPart& part, const WorkPart& work, Hand& hand) {
  switch (part.use) {
    case PublishedUse::work:
      return work_part(part, work, hand);
    case PublishedUse::hold:
      return hold_part(part, hand);
    case PublishedUse::take: {
      const auto loop = taken(part);
      hand.made_known = hand.made_known && loop && loop->known;
      if (loop)
        hand.made.stitches.insert(hand.made.stitches.end(), loop->stitches.begin(), loop->stitches.end());
      return;
    }
    case PublishedUse::add:
      check_gap(part);
      return hand.made.add(*part.count, here());
    case PublishedUse::insert:
      return insert_part(part, hand);
    case PublishedUse::slip_back: {
      if (part.count && hand.inserted > 0 && *part.count != hand.inserted)
        blame(name_ + ": " + stitches_text(hand.inserted) + (hand.inserted == 1 ? " is" : " are") +
              " worked with waste yarn, and " + std::to_string(*part.count) + " slipped back.");
      const std::int64_t back = std::min(part.count.value_or(hand.inserted), hand.made.count());
      hand.left += back;
      hand.behind += back;
      hand.made.resize(hand.made.count() - back, here());
      return;
    }
    case PublishedUse::spread:
      return hand.made.resize(hand.made.count() + *part.count, here());
    case PublishedUse::close:
      return close_part(part, hand);
    case PublishedUse::as_before:
    case PublishedUse::join_ends:
    case PublishedUse::none:
      break;
  }
}

// Work that goes "to end" takes what the parts behind it leave; of several to a marker the last one does.
void PublishedWorker::work_part(const PublishedPart& part, const WorkPart& work, Hand& hand) {
  if (!work.words.mistake.empty()) {
    blame(name_ + work.words.mistake);
    hand.known = hand.made_known = false;
    return;
  }
  std::int64_t takes = 0;
  if (work.takes) {
    takes = *work.takes;
    hand.behind -= takes;
  } else if (!hand.known) {
    hand.made_known = false;
    return;
  } else if (!part.floats || !work.open_behind) {
    takes = work.tail ? hand.left - *work.tail : hand.left - hand.behind;
  }
  if (hand.known && (takes > hand.left || takes < 0)) {
    blame(name_ + ": " + stitches_text(std::max<std::int64_t>(takes, 0)) + " are to be worked, and " +
          stitches_are(hand.left) + " left.");
    hand.known = hand.made_known = false;
    return;
  }
  std::vector<WorkNode> nodes = work.words.nodes;
  if (work.tail) nodes.back().tail = 0;
  if (!work.takes && takes == 0) return;
  const WorkedRound worked = work_round(nodes, takes);
  if (!worked.mistake.empty()) {
    blame(name_ + worked.mistake);
    hand.known = hand.made_known = false;
    return;
  }
  hand.made.add(worked.made, here());
  if (hand.known) hand.left -= takes;
}

void PublishedWorker::hold_part(const PublishedPart& part, Hand& hand) {
  PublishedHolder holder;
  holder.name = part.name;
  holder.line = line_;
  holder.divided = true;
  const std::int64_t count = part.count.value_or(hand.left - hand.behind);
  if (hand.known && (count > hand.left || count < 1)) {
    blame(name_ + ": " + stitches_text(std::max<std::int64_t>(count, 0)) + " are to go on a holder, and " +
          stitches_are(hand.left) + " left.");
    hand.known = hand.made_known = holder.loop.known = false;
  } else if (!hand.known && !part.count) {
    holder.loop.known = false;
  } else {
    holder.loop.add(count, here());
  }
  for (std::int64_t copy = 0; copy < copies_; ++copy) {
    holder.excused = copy > 0;  // it may be told once for all
    holders_.put(holder);
  }
  if (hand.known) hand.left -= count;
  hand.behind -= part.count.value_or(0);
}

void PublishedWorker::insert_part(const PublishedPart& part, Hand& hand) {
  const std::int64_t count = *part.count;
  PublishedHolder holder;
  holder.name = part.name.empty() ? section_ : part.name;
  holder.line = line_;
  holder.waste = true;
  holder.loop.add(count, here());
  holders_.put(std::move(holder));
  hand.behind -= count;
  hand.inserted = count;
  if (!hand.known) return;
  if (count > hand.left || count < 1) {
    blame(name_ + ": " + stitches_text(count) + " are to be worked with waste yarn, and " +
          stitches_are(hand.left) + " left.");
    hand.known = hand.made_known = false;
    return;
  }
  hand.left -= count;
  hand.made.add(count, here());
}

void PublishedWorker::close_part(const PublishedPart& part, Hand& hand) {
  const std::int64_t count = *part.count;
  hand.behind -= count;
  if (!hand.known) return;
  if (count > hand.left) {
    blame(name_ + ": closes " + stitches_text(count) + ", and " + stitches_are(hand.left) + " left.");
    hand.known = hand.made_known = false;
    return;
  }
  hand.left -= count;
}

void PublishedWorker::settle(Hand hand, std::optional<std::int64_t> stated) {
  const std::int64_t made = hand.made.count();
  ++read_.rounds_read;
  ++rounds_here_;
  read_.stitches += made;
  work_ += made + work_of_a_published_round;
  needle_of_ = section_;
  loosely_closed_ = fresh_ = false;
  if (made >= most_stitches || work_ > most_published_work) {
    blame("the pattern is longer than can be read.");
    is_too_long_ = true;
    return;
  }
  const bool sure = hand.made_known && hand.known;
  if (sure && stated && *stated != made) {
    too_many_ = made - *stated;
    blame(name_ + " makes " + stitches_text(made) + ", the line says " + std::to_string(*stated) +
          holders_.forgotten(*stated - made, line_) + ".");
    return go_on_with(stated);
  }
  if (line_is_bad_ || !sure) return go_on_with(stated);
  needle_ = std::move(hand.made);
}

}  // namespace knit
