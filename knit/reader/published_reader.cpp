#include "knit/reader/published_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knit/reader/published_words.h"
#include "knit/reader/reader_cursor.h"
#include "knit/reader/reader_grammar.h"
#include "knit/reader/reader_text.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

constexpr std::int64_t most_rounds_told = 10'000;
constexpr std::int64_t most_published_work = 4'000'000;  // stitches in all; a round costs some by itself
constexpr std::int64_t work_of_a_published_round = 16;

std::string are_there(std::int64_t count) { return stitches_text(count) + (count == 1 ? " is" : " are"); }

std::string of_the(const std::string& name) { return name.empty() ? "" : " of the " + name; }

// "THUMB", "First leg:", "Legs (make 2)": few words, no number but that, and nothing to work.
struct SectionTitle {
  std::string name;
  std::int64_t made = 1;
};
std::optional<SectionTitle> title_in(const Tokens& tokens) {
  constexpr std::size_t most_words = 5;
  SectionTitle title;
  Tokens words;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.is(":") && i + 1 == tokens.size()) break;
    if (token.is("(") && i + 4 == tokens.size() && tokens[i + 1].is("make")) {
      const auto made = number_of(tokens[i + 2]);
      if (!made || *made < 1 || *made > 20 || !tokens[i + 3].is(")")) return std::nullopt;
      title.made = *made;
      break;
    }
    if (token.kind != Token::Kind::word || stitch_named(token)) return std::nullopt;
    words.push_back(token);
  }
  if (words.empty() || words.size() > most_words) return std::nullopt;
  title.name = holder_name(words);
  return title.name.empty() ? std::nullopt : std::optional(title);
}

// "(14 sts)" at the end, and the words before it.
Tokens without_count(const Tokens& tokens) {
  for (std::size_t i = tokens.size(); i-- > 0;) {
    const bool open = tokens[i].is("(") || tokens[i].is("[");
    if (open && i + 2 < tokens.size() && tokens[i + 1].is_number() && is_stitches_word(tokens[i + 2]))
      return {tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(i)};
  }
  return tokens;
}

class PublishedReader {
 public:
  ReadPattern run(std::string_view text) {
    std::size_t last = 0;
    for (const TextLine& line : pattern_lines(text)) {
      line_ = last = line.number;
      line_of(line.text);
      if (!read_.mistakes.empty()) return std::move(read_);
    }
    line_ = last;
    for (const PublishedHolder& held : held_)
      fail(are_there(held.count) + " left on the holder" + of_the(held.name) + ".");
    return std::move(read_);
  }

 private:
  struct PublishedHolder {
    std::string name;
    std::int64_t count = 0;
  };
  // What a section came to, for "work as for".
  struct PublishedSection {
    std::string name;
    std::int64_t count = 0;
    std::size_t rounds = 0;
  };

  bool fail(const std::string& sentence) {
    if (read_.mistakes.empty())
      read_.mistakes.push_back({line_, "line " + std::to_string(line_) + ": " + sentence});
    return false;
  }

  void line_of(const std::string& text) {
    const Tokens tokens = tokens_of(text);
    if (tokens.empty()) return;
    if (const auto label = label_of(tokens)) return round(*label, tokens);
    if (const auto title = title_in(tokens)) return begin_section(*title);
    // "First leg: CO 7 sts."
    const auto colon = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is(":"); });
    const Tokens before(tokens.begin(), colon);
    if (colon != tokens.end() && !is_meaning(tokens)) {
      if (const auto title = title_in(before)) {
        begin_section(*title);
        return prose(Tokens(colon + 1, tokens.end()));
      }
    }
    if (!is_meaning(tokens)) prose(tokens);
  }

  // "CO: cast on"
  static bool is_meaning(const Tokens& tokens) {
    return tokens.size() > 1 && (tokens[0].is("co") || tokens[0].is("bo")) &&
           (tokens[1].is(":") || tokens[1].is("=") || tokens[1].is("-") || tokens[1].is("cast") ||
            tokens[1].is("bind"));
  }

  void begin_section(const SectionTitle& title) {
    section_ = title.name;
    copies_ = title.made;
    rounds_here_ = 0;
    fresh_ = true;
  }

  // --- what is no round ---

  void prose(const Tokens& tokens) {
    const auto stated = stated_in(tokens);
    bool counted = false;
    Tokens sentence;
    const auto flush = [&] {
      for (const PublishedPart& part : parts_of(std::exchange(sentence, {}), false)) {
        if (read_.mistakes.empty()) counted = prose_part(part) || counted;
      }
    };
    for (const Token& token : without_count(tokens)) {
      if (token.is("."))
        flush();
      else
        sentence.push_back(token);
    }
    flush();
    if (!read_.mistakes.empty() || !counted || !stated || !has_needle_) return;
    if (*stated != needle_)
      fail(are_there(needle_) + " on the needle, the line says " + std::to_string(*stated) + ".");
  }

  // Whether it changes what is on the needle.
  bool prose_part(const PublishedPart& part) {
    switch (part.use) {
      case PublishedUse::hold:
        return has_needle_ && hold_all(part);
      case PublishedUse::take:
        return take(part, nullptr);
      case PublishedUse::add:
        return add(part);
      case PublishedUse::as_before:
        return as_before(part.name);
      case PublishedUse::join_ends:
        return join_ends(part);
      case PublishedUse::work:
      case PublishedUse::none:
        break;
    }
    const auto closing = closing_in(part.tokens);
    if (!closing || !has_needle_) return false;
    if (closing->number && *closing->number != needle_)
      return fail("closes " + stitches_text(*closing->number) + ", and " + are_there(needle_) +
                  " on the needle.");
    read_.closed_with += static_cast<std::int32_t>(std::min<std::int64_t>(needle_, most_stitches));
    end_section();
    return true;
  }

  void end_section() {
    made_.push_back({section_, needle_, rounds_here_});
    has_needle_ = false;
    needle_ = 0;
  }

  bool hold_all(const PublishedPart& part) {
    const std::int64_t count = part.count.value_or(needle_);
    if (count > needle_)
      return fail(stitches_text(count) + " are to go on a holder, and " + are_there(needle_) +
                  " on the needle.");
    for (std::int64_t copy = 0; copy < copies_; ++copy)
      held_.push_back({part.name.empty() ? section_ : part.name, count});
    if (count == needle_) {
      end_section();
    } else {
      needle_ -= count;
    }
    copies_ = 1;
    return true;
  }

  bool add(const PublishedPart& part) {
    const std::int64_t count = *part.count;
    if (count < 1 || count > most_stitches)
      return fail("give a number of stitches from 1 to " + std::to_string(most_stitches) + ".");
    const bool begins = cast_on_in(part.tokens).has_value() && fresh_ && rounds_here_ == 0;
    if (begins && has_needle_ && section_ != needle_of_ && !joined_)
      return fail(are_there(needle_) + " still on the needle, and " + std::to_string(count) +
                  " are cast on.");
    if (!has_needle_) {
      cast_on_ = std::min(cast_on_ + count, most_number);
      read_.rounds.cast_on = static_cast<std::int32_t>(cast_on_);
      needle_of_ = section_;
    }
    needle_ += count;
    has_needle_ = true;
    read_.stitches += count;
    fresh_ = false;
    return true;
  }

  bool as_before(const std::string& name) {
    const auto found = std::find_if(made_.rbegin(), made_.rend(),
                                    [&](const PublishedSection& made) { return same_name(name, made.name); });
    if (found == made_.rend() || name.empty()) return false;
    if (has_needle_)
      return fail(are_there(needle_) + " still on the needle before it is worked as for " + name + ".");
    needle_ = found->count;
    rounds_here_ = found->rounds;
    read_.rounds_read += found->rounds;
    has_needle_ = true;
    needle_of_ = section_;
    next_ = 0;
    return true;
  }

  // The holder that is meant: of that name, or the one filled last.
  std::vector<PublishedHolder>::iterator holder(const std::string& name) {
    for (auto held = held_.end(); held != held_.begin();) {
      --held;
      if (name.empty() || same_name(name, held->name) || same_name(held->name, name)) return held;
    }
    return held_.end();
  }

  // Onto the needle; `worked` of them into the round at hand.
  bool take(const PublishedPart& part, std::int64_t* worked) {
    const auto found = holder(part.name);
    if (found == held_.end()) return fail("there are no held stitches" + of_the(part.name) + ".");
    const std::int64_t count = part.count.value_or(found->count);
    if (count != found->count)
      return fail("the holder" + of_the(found->name) + " has " + stitches_text(found->count) +
                  ", the line says " + std::to_string(count) + ".");
    held_.erase(found);
    if (worked != nullptr) {
      *worked += count;
      return true;
    }
    needle_ += count;
    has_needle_ = joined_ = true;
    fresh_ = false;
    needle_of_ = section_;
    return true;
  }

  bool join_ends(const PublishedPart& part) {
    if (!has_needle_ && held_.size() > 1) {
      needle_ = held_.back().count;
      held_.pop_back();
      has_needle_ = true;
    }
    if (!has_needle_ || held_.empty()) return false;
    const PublishedHolder other = held_.back();
    if (other.count != needle_)
      return fail("two live ends are joined, and they have " + std::to_string(needle_) + " and " +
                  stitches_text(other.count) + ".");
    if (part.count && *part.count != needle_ && *part.count != 2 * needle_)
      return fail(stitches_text(needle_) + " pair with as many, the line says " +
                  std::to_string(*part.count) + ".");
    held_.pop_back();
    end_section();
    return true;
  }

  // --- rounds ---

  void round(const RoundLabel& label, const Tokens& tokens) {
    const std::int64_t first = label.first.value_or(next_), last = label.first ? label.last : next_;
    name_ = first == last ? "Rnd " + std::to_string(first)
                          : "Rnds " + std::to_string(first) + "-" + std::to_string(last);
    if (!label.mistake.empty()) {
      fail(name_ + label.mistake);
      return;
    }
    const bool may_begin_anew = fresh_ || rounds_here_ == 0 || next_ == 0;
    if (label.first && first != next_ && !may_begin_anew) {
      fail(name_ + (first == last ? " stands" : " stand") + " here, and Rnd " + std::to_string(next_) +
           " comes next.");
      return;
    }
    if (last - first >= most_rounds_told) {
      fail(name_ + " are more than can be read.");
      return;
    }
    next_ = last + 1;
    const Tokens words(tokens.begin() + static_cast<std::ptrdiff_t>(label.tokens), tokens.end());
    for (std::int64_t number = first; number <= last && read_.mistakes.empty(); ++number)
      work(words, number == last);
    fresh_ = false;
  }

  void work(const Tokens& words, bool stated_here) {
    const auto stated = stated_in(words);
    std::vector<PublishedPart> parts = parts_of(without_count(words), true);
    if (std::none_of(parts.begin(), parts.end(),
                     [](const PublishedPart& p) { return p.use != PublishedUse::work; }))
      return plain(words, stated_here);
    std::int64_t made = 0;
    if (!parted(parts, made)) return;
    settle(made, stated_here ? stated : std::nullopt);
  }

  void settle(std::int64_t made, std::optional<std::int64_t> stated) {
    ++read_.rounds_read;
    ++rounds_here_;
    read_.stitches += made;
    work_ += made + work_of_a_published_round;
    if (made > most_stitches || work_ > most_published_work) {
      fail("the pattern is longer than can be read.");
      return;
    }
    if (stated && *stated != made) {
      fail(name_ + " makes " + stitches_text(made) + ", the line says " + std::to_string(*stated) + ".");
      return;
    }
    needle_ = made;
    has_needle_ = true;
  }

  void plain(const Tokens& words, bool stated_here) {
    if (const auto count = cast_on_in(words); count && !has_needle_) {
      PublishedPart part;
      part.tokens = words;
      part.count = count;
      add(part);
      return;
    }
    if (!has_needle_) {
      fail(name_ + " begins, and there are no stitches on the needle.");
      return;
    }
    const RoundWords read = round_words(words);
    if (!read.mistake.empty()) {
      fail(name_ + read.mistake);
      return;
    }
    const WorkedRound worked = work_round(read.nodes, needle_);
    if (!worked.mistake.empty()) {
      fail(name_ + worked.mistake);
      return;
    }
    settle(worked.made, stated_here ? read.stated : std::nullopt);
  }

  struct WorkPart {
    RoundWords words;
    std::optional<std::int64_t> takes;
  };
  bool read_work(const PublishedPart& part, WorkPart& work) {
    work.words = round_words(part.tokens);
    if (!work.words.mistake.empty()) return fail(name_ + work.words.mistake);
    work.takes = fixed_takes(work.words.nodes);
    return true;
  }

  // Work that goes "to end" takes what the parts behind it leave.
  bool parted(const std::vector<PublishedPart>& parts, std::int64_t& made) {
    std::vector<WorkPart> works(parts.size());
    std::int64_t behind = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].use == PublishedUse::work && !read_work(parts[i], works[i])) return false;
      if (parts[i].use == PublishedUse::work) behind += works[i].takes.value_or(0);
      if (parts[i].use == PublishedUse::hold) behind += parts[i].count.value_or(0);
    }
    std::int64_t left = needle_;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PublishedPart& part = parts[i];
      if (part.use == PublishedUse::work) {
        if (!work_part(works[i], left, behind, made)) return false;
      } else if (part.use == PublishedUse::hold) {
        if (!hold_part(part, left, behind)) return false;
      } else if (part.use == PublishedUse::take) {
        if (!take(part, &made)) return false;
      } else if (part.use == PublishedUse::add) {
        made += *part.count;
      }
    }
    return left == 0 || fail(name_ + " leaves " + stitches_text(left) + " of the round before unworked.");
  }

  bool work_part(const WorkPart& work, std::int64_t& left, std::int64_t& behind, std::int64_t& made) {
    const std::int64_t takes = work.takes.value_or(left - behind);
    if (takes > left || takes < 0)
      return fail(name_ + ": " + stitches_text(takes) + " are to be worked, and " + are_there(left) +
                  " left.");
    const WorkedRound worked = work_round(work.words.nodes, takes);
    if (!worked.mistake.empty()) return fail(name_ + worked.mistake);
    made += worked.made;
    left -= takes;
    behind -= work.takes.value_or(0);
    return true;
  }

  bool hold_part(const PublishedPart& part, std::int64_t& left, std::int64_t& behind) {
    const std::int64_t count = part.count.value_or(left - behind);
    if (count > left || count < 1)
      return fail(name_ + ": " + stitches_text(count) + " are to go on a holder, and " + are_there(left) +
                  " left.");
    held_.push_back({part.name, count});
    left -= count;
    behind -= part.count.value_or(0);
    return true;
  }

  ReadPattern read_;
  std::size_t line_ = 0, rounds_here_ = 0;
  std::string section_, needle_of_, name_;
  std::int64_t copies_ = 1, needle_ = 0, next_ = 1, work_ = 0, cast_on_ = 0;
  bool has_needle_ = false, fresh_ = true, joined_ = false;
  std::vector<PublishedHolder> held_;
  std::vector<PublishedSection> made_;
};

}  // namespace

bool has_held_stitches(std::string_view text) {
  bool put = false, taken = false;
  for (const TextLine& line : pattern_lines(text)) {
    const Tokens tokens = tokens_of(line.text);
    for (const PublishedPart& part : parts_of(tokens, label_of(tokens).has_value())) {
      put = put || part.use == PublishedUse::hold;
      taken = taken || (put && (part.use == PublishedUse::take || part.use == PublishedUse::join_ends));
    }
  }
  return put && taken;
}

ReadPattern read_published(std::string_view text) { return PublishedReader().run(text); }

}  // namespace knit
