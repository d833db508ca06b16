// Works a text of the world's patterns: one needle, holders with names, rounds by number and by name, one size at a
// time. After a line that is not understood the stitches are unknown until a line states them; what lies between is
// not claimed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knit/reader/checked_pattern.h"
#include "knit/reader/reader_text.h"
#include "knit/trade/world_lines.h"
#include "knit/trade/world_needle.h"

namespace knit {

// What one line says to work in a round, kept for repeats.
struct WorldRecipe {
  Atoms atoms;
  WorldRound first, other;
  std::size_t line = 0;
  std::string name;
  bool flat = false;
};

struct WorldHolder {
  std::string name;
  std::optional<std::int64_t> count;
  std::size_t line = 0;
  bool taken = false, waste = false, implied = false;
};

// Rounds that are worked again: which, and how often.
struct WorldRepeat {
  std::vector<std::size_t> recipes;
  std::int64_t times = 1;
  std::optional<std::int64_t> until;
  bool inner = false;        // `until` counts those between two markers
  bool free = false;         // until a length is reached
  std::int64_t between = 0;  // plain rounds before each
};

inline constexpr std::int64_t most_passes = 100'000;  // through rounds that are repeated

class PhraseCursor;

class WorldWorker {
 public:
  // `size`: which number of "80 (88, 96)" is taken, of `sizes`.
  WorldWorker(const Lexicon& lexicon, std::size_t size, std::size_t sizes)
      : lexicon_(lexicon), size_(size), sizes_(sizes) {}

  // `lines`: in atoms, as they are read; `last_line`: of the text.
  // `physical`: the text's lines, in which places are told. `start`: stitches that a text without a cast on begins with.
  CheckedSize run(const std::vector<TextLine>& lines, const std::vector<Atoms>& atoms,
                  const std::vector<std::string_view>& physical, std::int64_t start);
  [[nodiscard]] std::size_t rounds() const { return rounds_; }
  [[nodiscard]] std::optional<std::int64_t> stitches_left() const { return last_count_; }
  [[nodiscard]] bool ends() const { return closed_once_; }
  // What stays on the needles where another piece begins, and at the end, in sentences; empty: nothing that is known.
  [[nodiscard]] std::string left_over() const;
  // Ends at the first line that does not hold: for a start that is only tried.
  void stop_at_trouble() { only_tried_ = true; }
  // Of a text that was worked without a start: whether its first rounds, one after the other, could be worked on `start`
  // stitches, as far as they hang on nothing else; where that is the whole text, they come out as they began.
  // `budget` is what may still be worked.
  [[nodiscard]] bool may_start_with(std::int64_t start, std::int64_t& budget) const;

 private:
  using Index = std::size_t;
  // "[Knit 1 rnd, inc rnd] 6 times"
  struct ToldRounds {
    struct Part {
      std::optional<Index> named;  // nothing: plain
      std::int64_t rounds = 1;
    };
    std::vector<Part> parts;
    std::int64_t once = 0, named = 0;  // rounds of one time; those among them that have a name
    std::int64_t times = 1;
  };

  // Where a round begins, to be gone back to; holders only where it may change them.
  struct Standing {
    WorldNeedle needle;
    std::optional<std::vector<WorldHolder>> holders;
  };
  // What a line says of a round that is worked: `nth`: which of its counts, 0: the last.
  struct RoundSaid {
    const std::string& name;
    const WorldCount& count;
    std::size_t nth = 0;
    bool flat = false;
  };
  struct Tried {
    WorldOutcome outcome;
    std::string why;  // what is wrong with its count
    bool done = false;
  };

  // verdicts
  void say(LineVerdict verdict, std::string sentence, std::size_t at = 0, std::size_t length = 0);
  void say_at(std::size_t line, LineVerdict verdict, std::string sentence, std::size_t at,
              std::size_t length);
  void wrong(const std::string& sentence, std::size_t at = 0, std::size_t length = 0);
  void tell_made(std::int64_t stitches);  // what the line at hand has on the needles
  void not_understood(const std::string& sentence, std::size_t at = 0, std::size_t length = 0);
  void worked();

  // lines
  bool sized(Atoms& line);
  void whole_line(Atoms line);
  void one_line(const Atoms& line);
  void labelled(const WorldLabel& label, Atoms line);
  void unlabelled(const Atoms& line);
  void sentence(Atoms part, const Atoms& line);
  bool title(const Atoms& line);
  void find_definitions(const std::vector<Atoms>& lines);

  // rounds
  Index keep(Atoms atoms, const std::string& name, bool flat);
  void number_rounds(const WorldLabel& label, const Atoms& body);
  void await_turn(const WorldLabel& label, Index index);
  void begin_numbers(const WorldLabel& label, const std::string& name);
  void fill_gap(const WorldLabel& label, const std::string& name);
  void come_to(const WorldLabel& label, const std::string& name);
  void run_pending(bool all);
  [[nodiscard]] bool works_flat(const WorldLabel& label) const {
    return (rows_ || label.sided) && !in_round_;
  }
  [[nodiscard]] bool in_rule(std::int64_t number) const;
  void named_round(const WorldLabel& label, const Atoms& body);
  void tell_rule(const WorldLabel& label, const Atoms& body);
  bool work_recipe(Index index, const std::string& name, const WorldCount* count, std::size_t nth);
  [[nodiscard]] Standing standing(bool moves) const;
  void go_back(const Standing& then);
  bool work_unread(const WorldRecipe& recipe, const std::string& name, const WorldCount& said);
  void begin_with_held(const WorldRound& round);
  bool has_stitches_for(const WorldRecipe& recipe, const std::string& name, const WorldCount* count);
  Tried try_round(const WorldRound& round, const Standing& from, const RoundSaid& said);
  bool means_two_things(const WorldRecipe& recipe, const Standing& before, const RoundSaid& said);
  void tell_failure(const WorldRound& round, const Tried& first, std::size_t held_before,
                    const RoundSaid& said);
  bool work_known(Index index, const RoundSaid& said);
  bool on_unknown(const WorldRecipe& recipe, const std::string& name, const WorldCount* count);
  bool settle_count(const std::string& name, std::int64_t before, const WorldCount& count, std::size_t nth,
                    std::string& why) const;
  void after_trouble(const WorldCount& count);
  void keep_alternative(Index index, const WorldCount& said);
  void doubt_holders();
  void finished_round(Index index, std::int64_t number);
  void know_number(std::int64_t number, Index index);
  using Numbered = std::map<std::int64_t, Index>;
  [[nodiscard]] const Numbered* rounds_of_piece(PhraseCursor& here) const;
  std::optional<WorldRepeat> repeat_in(const Atoms& line, bool& trouble);
  std::optional<std::vector<Index>> recipes_in(const Atoms& line, std::size_t& at);
  std::optional<std::vector<Index>> last_recipes(PhraseCursor& here) const;
  std::optional<std::vector<Index>> numbered_recipes(PhraseCursor& here) const;
  std::optional<std::vector<Index>> recipes_like_piece(const WorldLabel& label, PhraseCursor& here) const;
  std::optional<std::vector<Index>> named_recipe(PhraseCursor& here) const;
  void do_repeat(const WorldRepeat& repeat, const WorldCount& count, std::int64_t rounds);
  void work_passes(const WorldRepeat& repeat, std::int64_t start, std::int64_t rounds);
  bool work_pass(const WorldRepeat& repeat, std::int64_t& left);
  bool misses(const WorldRepeat& repeat, std::int64_t start, std::int64_t before);
  [[nodiscard]] std::int64_t measured(const WorldRepeat& repeat) const;
  void hold_unreached(const WorldRound& round, std::size_t held_before);
  [[nodiscard]] WorldRound with_live_ones(const WorldRound& round) const;
  [[nodiscard]] bool line_is_wrong() const {
    return line_ > 0 && out_.lines[line_ - 1].verdict == LineVerdict::does_not_add_up;
  }
  void wrong_but_told(const std::string& made, std::int64_t told);
  bool told_rounds(const Atoms& body, const WorldCount& count, std::int64_t rounds, const std::string& name);
  std::optional<ToldRounds> rounds_in_brackets(PhraseCursor& here, const Atoms& body);
  bool work_told(const ToldRounds& told, Index plain, std::span<const std::int64_t> counts,
                 const std::string& name);
  bool unclear(const std::string& sentence, const WorldCount& count, std::size_t at = 0,
               std::size_t length = 0);
  bool like_another(const WorldLabel& label, const Atoms& body, const WorldCount& count);
  bool like_but(Index model, const WorldLabel& label, std::span<const Atom> words, const WorldCount& count);
  void repeat_labelled(const WorldLabel& label, const std::vector<Index>& recipes, const WorldCount& count);
  bool plain_rounds(const Atoms& part, const WorldCount& count);
  void work_plain(std::int64_t rounds, const std::string& how, const WorldCount& count);

  // pieces
  bool cast_on(const Atoms& part, const Atoms& line);
  void add_stitches(std::int64_t stitches);
  void begin_cast_on(std::int64_t stitches, const Atoms& line);
  bool close(const Atoms& part);
  bool bind_off_some(const Atoms& part, std::int64_t stitches);
  bool hold_all(const Atoms& part, const WorldCount& count);
  bool take_all(const Atoms& part, const WorldCount& count);
  bool take_none(const std::string& name, std::optional<std::int64_t> told, bool held,
                 const WorldCount& count);
  bool pick_up(const Atoms& part, const WorldCount& count);
  bool join_ends(const Atoms& part);
  bool as_before(const Atoms& part);
  bool place_markers(const Atoms& part);
  bool remove_markers(const Atoms& part);
  void begin_piece(std::int64_t stitches);
  void end_piece(bool held);
  void leave_behind();
  void check_after(const WorldCount& count);
  WorldHolder* find_holder(const std::string& name, std::optional<std::int64_t> count);
  [[nodiscard]] std::string none_held(const std::string& name) const;
  void excuse_holders();
  std::string forgotten(std::int64_t missing);
  [[nodiscard]] bool may_have(std::int64_t stitches) const;
  WorldHands hands();
  void finish();
  void trace(Index index, const WorldCount& said, std::size_t nth);
  void give_first_line();

  const Lexicon& lexicon_;
  std::size_t size_, sizes_;
  CheckedSize out_;
  std::vector<std::string_view> physical_, texts_;  // by line: of the file, and as it is read
  std::size_t line_ = 0, rounds_ = 0;
  std::int64_t budget_ = 40'000'000;

  WorldNeedle needle_;
  bool has_needle_ = false, known_ = false, ever_cast_on_ = false, tells_ = false, in_round_ = false,
       rows_ = false;
  bool closed_ = false, broken_ = false, closed_once_ = false;
  std::string left_behind_;  // on the needles when another piece began
  std::optional<std::int64_t> last_count_;
  std::size_t closed_line_ = 0;
  std::optional<std::int64_t> alternative_;
  std::vector<WorldHolder> holders_;
  std::string section_;
  std::int64_t copies_ = 1;
  bool fresh_ = true;
  struct Made {
    std::string name;
    std::optional<std::int64_t> count;
    bool held = false;
    std::vector<CheckedRound> rounds;
  };
  std::vector<Made> made_;

  // The rounds in the order they were worked, for `may_start_with`; open: nothing else has changed the needle so far.
  struct Traced {
    Index recipe = 0;
    std::optional<std::int64_t> total, change;
  };
  std::vector<Traced> trace_;
  bool traces_ = true, only_tried_ = false, markers_lost_ = false;

  std::vector<WorldRecipe> recipes_;
  std::vector<Index> history_;
  Numbered by_number_;                        // of the piece at hand
  std::map<std::string, Numbered> by_piece_;  // of each piece that has a name, the last that was so numbered
  std::map<std::string, Index> by_name_;
  std::set<std::string> definitions_;
  std::map<std::int64_t, std::pair<Index, bool>> pending_;  // by number; whether it is the last of its line
  struct Rule {
    std::int64_t from = 2, step = 2;
    Index recipe = 0;
    std::size_t told_after = 0;  // rounds that were worked before it was told
  };
  std::optional<Rule> rule_;
  std::int64_t next_ = 1;
  bool any_number_ = true, gap_ok_ = true, last_was_note_ = true;
};

}  // namespace knit
