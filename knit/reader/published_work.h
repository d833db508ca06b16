// Works a published pattern line by line on a needle and named holders; for published_reader.cpp alone.
//
// A line with a mistake is named once, and the reading goes on: with the count that the line states, or without a known one.
// Holders that a wrong line fills or empties count as filled or emptied.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knit/reader/pattern_reader.h"
#include "knit/reader/published_needle.h"
#include "knit/reader/published_words.h"

namespace knit {

// Without "(30 sts)" and the like.
Tokens without_counts(const Tokens& tokens);

class PublishedWorker {
 public:
  // False: it is longer than can be read.
  bool line(std::size_t number, std::string_view text);
  ReadPattern finish();

 private:
  // What a section came to, for "work as for".
  struct Section {
    std::string name;
    std::optional<std::int64_t> count;
    std::size_t rounds = 0;
    bool held = false, live = false;
    HolderWanted took = {};  // what it began with, off a holder; without a count: nothing
  };
  // A round as it was told, to be repeated.
  struct Told {
    std::int64_t number = 0;
    Tokens words;
    bool is_bad = false;
  };
  // A round at work: what of the needle is not worked yet, what parts behind will take, what is made.
  struct Hand {
    std::int64_t left = 0, behind = 0;
    bool known = true;       // how many are left
    bool made_known = true;  // how many are made
    PublishedLoop made;
    std::int64_t inserted = 0;  // with waste yarn, last
  };
  struct WorkPart {
    RoundWords words;
    std::optional<std::int64_t> takes, tail;  // tail: of "to last 3 sts"
    bool open_behind = false;                 // another part takes what is left
  };

  void blame(const std::string& sentence);
  [[nodiscard]] PublishedStitch here() const;
  [[nodiscard]] bool is_needle_known() const { return has_needle_ && needle_.known && !needle_.doubtful; }
  void go_on_with(std::optional<std::int64_t> stated);

  // Lines that are no rounds.
  void begin_section(const SectionTitle& title);
  void prose(const Tokens& tokens);
  bool sentence_of(const Tokens& sentence, std::optional<std::int64_t> stated);
  bool prose_part(const PublishedPart& part, bool takes_too, std::optional<std::int64_t> stated);
  bool repeat(const RepeatedRounds& repeated, std::int64_t rounds_named);
  bool close(const PublishedPart& part);
  void end_section(bool held);
  bool hold_all(const PublishedPart& part);
  bool add(const PublishedPart& part, bool goes_on);
  void leave_behind(const std::string& what);
  bool as_before(const PublishedPart& part);
  bool take_all(const PublishedPart& part);
  bool join_ends(const PublishedPart& part);
  bool join_held(const PublishedPart& part);
  bool spread(const PublishedPart& part);
  void check_gap(const PublishedPart& part);
  // The stitches off a holder; nothing where there are none. Not known where nobody can tell.
  std::optional<PublishedLoop> taken(const PublishedPart& part);

  // Rounds.
  void round(const RoundLabel& label, const Tokens& tokens);
  void work(const Tokens& told, bool stated_here);
  void take_implied();
  void is_live_already(std::vector<PublishedPart>& parts) const;
  void work_parts(const std::vector<PublishedPart>& told, std::optional<std::int64_t> stated);
  void work_in_order(std::vector<PublishedPart> parts, std::optional<std::int64_t> stated);
  std::vector<WorkPart> read_parts(const std::vector<PublishedPart>& parts, Hand& hand);
  void round_part(const PublishedPart& part, const WorkPart& work, Hand& hand);
  void work_part(const PublishedPart& part, const WorkPart& work, Hand& hand);
  void hold_part(const PublishedPart& part, Hand& hand);
  void insert_part(const PublishedPart& part, Hand& hand);
  void close_part(const PublishedPart& part, Hand& hand);
  void settle(Hand hand, std::optional<std::int64_t> stated);

  ReadPattern read_;
  std::size_t line_ = 0, rounds_here_ = 0;
  bool line_is_bad_ = false, is_too_long_ = false;
  bool fresh_ = true, any_number_ = false, tells_ = false, loosely_closed_ = false, stays_live_ = false;
  std::optional<std::int64_t> also_right_;  // a count that the line may state as well: of a holder filled
  std::string section_, name_;
  std::int32_t section_number_ = 0;
  std::int64_t too_many_ = 0;  // more than the last wrong line states
  std::int64_t needle_copies_ = 1, copies_ = 1, next_ = 1, work_ = 0, cast_on_ = 0;
  bool has_needle_ = false;
  PublishedLoop needle_;
  HolderWanted took_;      // by this section, last
  std::string needle_of_;  // the section that they belong to
  PublishedHolders holders_;
  std::vector<Section> made_;
  std::vector<Told> told_;
};

}  // namespace knit
