// What stands between rounds: sections, holders filled and emptied, ends.
#include "knit/reader/published_work.h"

#include <algorithm>
#include <array>
#include <utility>

#include "knit/reader/reader_cursor.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

bool any_of_words(const Tokens& tokens, WordList words) {
  return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) {
    return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return token.is(w); });
  });
}

// "CO: cast on"
bool is_meaning(const Tokens& tokens) {
  return tokens.size() > 1 && (tokens[0].is("co") || tokens[0].is("bo")) &&
         (tokens[1].is(":") || tokens[1].is("=") || tokens[1].is("-") || tokens[1].is("cast") ||
          tokens[1].is("bind"));
}

bool is_soundly_read(const PublishedPart& part) {
  return part.use != PublishedUse::work || part.floats || round_words(part.tokens).mistake.empty();
}

// A round without a label: work, and beside it a holder, an edge or a count that can be proved.
bool is_bare_round(const std::vector<PublishedPart>& parts, bool stated) {
  bool works = false, moves = false;
  for (const PublishedPart& part : parts) {
    if (!is_soundly_read(part)) return false;
    works = works || part.use == PublishedUse::work;
    moves = moves || part.use == PublishedUse::hold || part.use == PublishedUse::add ||
            part.use == PublishedUse::insert || (part.use == PublishedUse::take && !part.maybe);
  }
  const bool begins = !parts.empty() &&
                      (parts.front().use == PublishedUse::work || parts.front().use == PublishedUse::insert);
  return works && (moves || (stated && begins));
}

}  // namespace

Tokens without_counts(const Tokens& tokens) {
  Tokens left;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool open =
        (tokens[i].is("(") || tokens[i].is("[")) && i + 2 < tokens.size() && tokens[i + 1].is_number();
    std::size_t end = i + 2;
    while (open && end < tokens.size() && !tokens[end].is(")") && !tokens[end].is("]") &&
           !tokens[end].is(","))
      ++end;
    const bool count = open && end < tokens.size() && !tokens[end].is(",") &&
                       (is_stitches_word(tokens[i + 2]) || end == i + 2);
    if (count)
      i = end;
    else
      left.push_back(tokens[i]);
  }
  return left;
}

void PublishedWorker::blame(const std::string& sentence) {
  if (line_is_bad_) return;
  line_is_bad_ = true;
  read_.mistakes.push_back({line_, "line " + std::to_string(line_) + ": " + sentence});
}

PublishedStitch PublishedWorker::here() const { return {static_cast<std::int32_t>(line_), section_number_}; }

void PublishedWorker::go_on_with(std::optional<std::int64_t> stated) {
  holders_.doubt(line_is_bad_ ? line_ : 0);
  if (!has_needle_) return;
  needle_.doubtful = line_is_bad_;
  needle_.known = stated && *stated >= 0 && *stated <= most_stitches;
  needle_.resize(needle_.known ? *stated : 0, here());
}

bool PublishedWorker::line(std::size_t number, std::string_view text) {
  if (number != line_) line_is_bad_ = false;
  line_ = number;
  const Tokens tokens = tokens_of(text);
  if (tokens.empty() || is_meaning(tokens)) return true;
  if (const auto label = published_label(tokens)) {
    tells_ = false;
    round(*label, tokens);
    return !is_too_long_;
  }
  if (const auto title = title_in(tokens)) {
    begin_section(*title);
    return true;
  }
  // "First leg: CO 7 sts."
  const auto colon = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is(":"); });
  if (colon != tokens.end()) {
    if (const auto title = title_in(Tokens(tokens.begin(), colon))) {
      if (title->tells) return true;
      begin_section(*title);
      prose(Tokens(colon + 1, tokens.end()));
      return !is_too_long_;
    }
  }
  if (!tells_) prose(tokens);
  return !is_too_long_;
}

ReadPattern PublishedWorker::finish() {
  std::string left = holders_.left_over();
  if (is_needle_known() && needle_.count() > 0 && read_.rounds_read > 0 && !loosely_closed_)
    left += (left.empty() ? "" : " ") + stitches_are(needle_.count()) + " on the needle" +
            of_the_name(needle_of_) +
            " at the end: bind them off, draw the yarn through them or put them on a holder.";
  if (left.empty()) return std::move(read_);
  if (line_is_bad_)
    read_.mistakes.back().sentence += " " + left;
  else
    blame(left);
  return std::move(read_);
}

// --- sections and sentences ----------------------------------------------------------------------------------

void PublishedWorker::begin_section(const SectionTitle& title) {
  tells_ = title.tells;
  if (tells_) return;
  if (has_needle_ && rounds_here_ > 0)
    made_.push_back({section_, is_needle_known() ? std::optional(needle_.count()) : std::nullopt,
                     rounds_here_, false, true, took_});
  section_ = title.name;
  ++section_number_;
  copies_ = title.made;
  rounds_here_ = 0;
  fresh_ = true;
  took_ = {};
}

void PublishedWorker::prose(const Tokens& tokens) {
  const bool was_bad = line_is_bad_;
  const auto stated = stated_in(tokens);
  also_right_.reset();
  if (const auto repeated = repeated_rounds(tokens)) {
    if (!has_needle_ || !repeat(*repeated, 0)) go_on_with(stated);
    any_number_ = true;
    if (is_needle_known() && stated && *stated != needle_.count()) {
      blame("the repeat makes " + stitches_text(needle_.count()) + ", the line says " +
            std::to_string(*stated) + ".");
      go_on_with(stated);
    }
    if (!is_needle_known()) go_on_with(stated);
    return;
  }
  bool counted = false;
  Tokens sentence;
  const auto flush = [&] {
    if (!sentence.empty()) counted = sentence_of(std::exchange(sentence, {}), stated) || counted;
  };
  for (const Token& token : without_counts(tokens)) {
    if (token.is("."))
      flush();
    else
      sentence.push_back(token);
  }
  flush();
  any_number_ = any_number_ ||
                std::any_of(tokens.begin(), tokens.end(), [](const Token& t) { return is_round_word(t); });
  loosely_closed_ = loosely_closed_ || any_of_words(tokens, {"fasten", "gather", "cinch", "tighten", "close",
                                                             "closed", "pull", "draw"});
  if (!has_needle_) return;
  const bool worked =
      any_of_words(tokens, {"k", "knit", "work", "inc", "dec", "increase", "decrease", "continue"});
  const bool newly_bad = line_is_bad_ && !was_bad;
  if (newly_bad || (stated && !is_needle_known())) return go_on_with(stated);
  if (!stated || *stated == needle_.count() || stated == also_right_) return;
  if (counted) too_many_ = needle_.count() - *stated;
  if (counted)
    blame(stitches_are(needle_.count()) + " on the needle, the line says " + std::to_string(*stated) +
          holders_.forgotten(*stated - needle_.count(), line_) + ".");
  if (counted || worked) go_on_with(stated);
}

// Whether it changes what is on the needle, in a way that its count proves.
bool PublishedWorker::sentence_of(const Tokens& sentence, std::optional<std::int64_t> stated) {
  stays_live_ = any_of_words(sentence, {"not", "don't", "but", "except", "omit", "omitting"}) ||
                (any_of_words(sentence, {"leave", "leaving", "keep", "keeping"}) &&
                 any_of_words(sentence, {"needle", "needles", "dpns"}));
  const std::vector<PublishedPart> parts = parts_of(sentence, false);
  if (has_needle_ && is_bare_round(parts_of(sentence, true), stated.has_value()) &&
      is_bare_round(parts, stated.has_value())) {
    name_ = "the round";
    told_.push_back({-1, sentence});
    work_parts(parts_of(sentence, true), stated);
    any_number_ = true;
    return false;  // its count is proved already
  }
  const bool takes_too = std::any_of(parts.begin(), parts.end(),
                                     [](const PublishedPart& p) { return p.use == PublishedUse::take; });
  bool counted = false;
  for (const PublishedPart& part : parts) counted = prose_part(part, takes_too, stated) || counted;
  return counted;
}

bool PublishedWorker::prose_part(const PublishedPart& part, bool takes_too,
                                 std::optional<std::int64_t> stated) {
  switch (part.use) {
    case PublishedUse::hold:
      return has_needle_ && hold_all(part);
    case PublishedUse::take:
      return take_all(part);
    case PublishedUse::add:
      return add(part,
                 takes_too || (stated && is_needle_known() && *stated == needle_.count() + *part.count));
    case PublishedUse::as_before:
      return as_before(part);
    case PublishedUse::join_ends:
      return join_ends(part);
    case PublishedUse::close:
      return has_needle_ && close(part);
    case PublishedUse::spread:
      return has_needle_ && spread(part);
    case PublishedUse::work:
    case PublishedUse::insert:
    case PublishedUse::slip_back:
    case PublishedUse::none:
      break;
  }
  return false;
}

void PublishedWorker::end_section(bool held) {
  made_.push_back({section_, is_needle_known() ? std::optional(needle_.count()) : std::nullopt, rounds_here_,
                   held, false, took_});
  has_needle_ = false;
  needle_ = {};
}

bool PublishedWorker::close(const PublishedPart& part) {
  if (part.count && is_needle_known() && *part.count != needle_.count()) {
    const bool some = any_of_words(part.tokens, {"at", "for", "over", "next", "beginning", "each"});
    if (*part.count < needle_.count() && !part.all && some) {
      needle_.resize(needle_.count() - *part.count, here());
      return true;
    }
    blame("closes " + stitches_text(*part.count) + ", and " + stitches_are(needle_.count()) +
          " on the needle.");
  }
  read_.closed_with += static_cast<std::int32_t>(std::min<std::int64_t>(needle_.count(), most_stitches));
  end_section(false);
  return true;
}

bool PublishedWorker::spread(const PublishedPart& part) {
  if (!needle_.known) return false;
  needle_.resize(needle_.count() + *part.count, here());
  return true;
}

// --- holders -------------------------------------------------------------------------------------------------

bool PublishedWorker::hold_all(const PublishedPart& part) {
  PublishedHolder holder;
  holder.name = part.name.empty() ? section_ : part.name;
  holder.line = line_;
  const bool all = !part.count || (needle_.known && *part.count == needle_.count());
  if (!all && is_needle_known() && *part.count > needle_.count()) {
    blame(stitches_text(*part.count) + " are to go on a holder, and " + stitches_are(needle_.count()) +
          " on the needle.");
    holder.loop.known = false;
  } else if (all) {
    holder.loop = needle_;
    holder.loop.known = is_needle_known() || (needle_.known && part.count);
  } else {
    holder.loop.add(*part.count, here());
    holder.divided = needle_.known;
    needle_.resize(needle_.count() - *part.count, here());
    also_right_ = part.count;
  }
  for (std::int64_t copy = 0; copy < copies_; ++copy) holders_.put(holder);
  copies_ = 1;
  if (all) end_section(true);
  return true;
}

// Of another section are on the needle, and nothing said where they go.
void PublishedWorker::leave_behind(const std::string& what) {
  if (is_needle_known())
    blame(stitches_are(needle_.count()) + " still on the needle" + of_the_name(needle_of_) + ", and " + what +
          ": bind them off or put them on a holder first.");
  PublishedHolder holder;
  holder.name = needle_of_;
  holder.loop = needle_;
  holder.loop.known = false;  // a copy of it may be missing, or some of it
  holder.line = line_;
  holder.excused = holder.implied = true;
  for (std::int64_t copy = 0; copy < needle_copies_; ++copy) holders_.put(holder);
  has_needle_ = false;
  needle_ = {};
}

bool PublishedWorker::add(const PublishedPart& part, bool goes_on) {
  const std::int64_t count = *part.count;
  if (count < 1 || count > most_stitches) {
    blame("give a number of stitches from 1 to " + std::to_string(most_stitches) + ".");
    return false;
  }
  check_gap(part);
  const bool begins = !part.picks_up && fresh_ && rounds_here_ == 0;
  if (begins && has_needle_ && section_ != needle_of_ && !goes_on && !part.goes_on)
    leave_behind(std::to_string(count) + (count == 1 ? " is cast on" : " are cast on"));
  if (!has_needle_) {
    needle_ = {};
    cast_on_ = std::min(cast_on_ + count, most_number);
    read_.rounds.cast_on = static_cast<std::int32_t>(cast_on_);
  }
  needle_of_ = section_;
  needle_copies_ = copies_;
  needle_.add(count, here());
  has_needle_ = true;
  read_.stitches += count;
  fresh_ = false;
  return true;
}

void PublishedWorker::check_gap(const PublishedPart& part) {
  if (part.at_gap && !holders_.any_divided() && too_many_ < 1)
    blame("there is no gap to pick up along: no stitches were put on a holder beside others before.");
}

bool PublishedWorker::as_before(const PublishedPart& part) {
  const auto found = std::find_if(made_.rbegin(), made_.rend(), [&](const Section& made) {
    return part.name.empty() ? part.again : same_name(part.name, made.name);
  });
  if (found == made_.rend()) return false;
  const Section made = *found;
  if (has_needle_ && needle_of_ != section_) leave_behind(section_ + " is worked as for " + made.name);
  needle_ = {};
  needle_.add(made.count.value_or(0), here());
  needle_.known = made.count && !any_of_words(part.tokens, {"until", "through", "except"});
  rounds_here_ = made.rounds;
  read_.rounds_read += made.rounds;
  has_needle_ = true;
  needle_of_ = section_;
  next_ = 0;
  any_number_ = true;
  fresh_ = false;
  if (made.took.count) {  // it begins with held stitches, as the other one did
    PublishedHolder* held = holders_.find({part.again ? made.took.name : section_, "", made.took.count});
    if (held != nullptr && held->loop.known && held->loop.count() == *made.took.count) held->emptied = line_;
  }
  if (stays_live_ || made.live) return true;
  if (made.held) {
    PublishedHolder holder;
    holder.name = section_;
    holder.loop = needle_;
    holder.line = line_;
    holder.implied = true;
    for (std::int64_t copy = 0; copy < copies_; ++copy) holders_.put(holder);
    copies_ = 1;
  }
  end_section(made.held);
  return false;
}

std::optional<PublishedLoop> PublishedWorker::taken(const PublishedPart& part) {
  const HolderWanted wanted{part.name, section_, part.count};
  PublishedHolder* const holder = holders_.find(wanted);
  if (holder == nullptr) {
    if (part.maybe && has_needle_) return std::nullopt;
    const std::int64_t missing =
        std::exchange(too_many_, 0);  // a line that holds them may be what is missing
    if (missing < 1 || (part.count && *part.count < missing)) {
      blame(holders_.why_not(wanted));
      holders_.excuse(part.count);
    }
    return PublishedLoop{{}, false};
  }
  took_ = {holder->name, "", holder->loop.known ? std::optional(holder->loop.count()) : std::nullopt};
  if (part.maybe && has_needle_ && (part.name.empty() || holder->name.empty())) return std::nullopt;
  PublishedLoop loop = holder->loop;
  const std::int64_t there = loop.count();
  if (holder->waste && loop.known) loop.resize(2 * there, here());
  const bool fits = part.count && (*part.count == loop.count() || !loop.known ||
                                   (holder->waste && std::abs(*part.count - 2 * there) <= 1));
  if (fits) {
    loop.resize(*part.count, here());
    loop.known = true;
  } else if (part.count && part.some && *part.count > 0 && *part.count < there) {
    auto& rest = holder->loop.stitches;
    loop.resize(*part.count, here());
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(*part.count));
    return loop;
  } else if (part.count) {
    blame("the " + std::string(holder->waste ? "waste yarn" : "holder") + of_the_name(holder->name) +
          " has " + stitches_text(loop.count()) + ", the line says " + std::to_string(*part.count) + ".");
    loop.known = false;
  }
  holder->emptied = line_;
  return loop;
}

bool PublishedWorker::take_all(const PublishedPart& part) {
  if (const PublishedHolder* const holder = holders_.find({part.name, section_, part.count});
      holder != nullptr && !part.maybe && has_needle_ && needle_of_ != section_ && !holder->name.empty() &&
      !section_.empty() && same_name(section_, holder->name))
    leave_behind("the held stitches of the " + holder->name + " are put on it");
  const auto loop = taken(part);
  if (!loop) return false;
  if (!has_needle_) needle_ = {};
  needle_.stitches.insert(needle_.stitches.end(), loop->stitches.begin(), loop->stitches.end());
  needle_.known = needle_.known && loop->known;
  has_needle_ = true;
  fresh_ = false;
  needle_of_ = section_;
  return true;
}

// --- two live ends -------------------------------------------------------------------------------------------

bool PublishedWorker::join_ends(const PublishedPart& part) {
  if (!has_needle_) return join_held(part);
  const std::vector<PublishedHolder*> there = holders_.called(part.name);
  PublishedHolder* other = nullptr;
  for (PublishedHolder* const held : there) {
    const bool named = !part.name.empty() && same_name(part.name, held->name) && !held->name.empty();
    if (named || (!part.own && !held->divided && !held->waste)) other = held;
  }
  if (other == nullptr) {  // both ends are on the needle
    if (part.count && is_needle_known() && *part.count != needle_.count() &&
        *part.count * 2 != needle_.count())
      blame(stitches_text(*part.count) + " are to be joined, and " + stitches_are(needle_.count()) +
            " on the needle.");
    end_section(false);
    return true;
  }
  other->emptied = line_;
  if (is_needle_known() && other->loop.known && other->loop.count() != needle_.count())
    blame("two live ends are joined, and they have " + std::to_string(needle_.count()) + " and " +
          stitches_text(other->loop.count()) + ".");
  else if (part.count && is_needle_known() && *part.count > needle_.count() &&
           *part.count != 2 * needle_.count())
    blame(stitches_text(needle_.count()) + " pair with as many, the line says " +
          std::to_string(*part.count) + ".");
  end_section(false);
  return true;
}

// Holders with holders: all of that name, or the two filled last.
bool PublishedWorker::join_held(const PublishedPart& part) {
  std::vector<PublishedHolder*> there = holders_.called(part.name);
  if (there.size() < 2) return false;
  if (!part.all && part.name.empty()) there.erase(there.begin(), there.end() - 2);
  std::vector<std::int64_t> counts;
  for (PublishedHolder* const held : there) {
    held->emptied = line_;
    if (held->loop.known) counts.push_back(held->loop.count());
  }
  if (counts.size() < there.size()) return true;
  std::sort(counts.begin(), counts.end());
  for (std::size_t i = 0; i < counts.size(); i += 2) {
    if (i + 1 < counts.size() && counts[i] == counts[i + 1]) continue;
    blame(i + 1 < counts.size() ? "two live ends are joined, and they have " + std::to_string(counts[i + 1]) +
                                      " and " + stitches_text(counts[i]) + "."
                                : stitches_are(counts[i]) + " held, and no others to join them to.");
  }
  if (part.count && std::none_of(counts.begin(), counts.end(), [&](std::int64_t count) {
        return count == *part.count || 2 * count == *part.count;
      }))
    blame(stitches_text(counts.front()) + " pair with as many, the line says " + std::to_string(*part.count) +
          ".");
  return true;
}

}  // namespace knit
