// A written pattern as its maker has it in mind, before it is words: what each line works, and how it chose to say so. It keeps
// a plain count of its own and shares no code with what reads or writes patterns, so that what it holds to be right or wrong is
// a second opinion. Counts are stitches; a pattern has one to three sizes, and every number one value for each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace world {

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  // From `low` to `high`, both possible.
  int roll(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  bool chance(int percent) { return roll(1, 100) <= percent; }
  template <class List>
  const auto& of(const List& list) {
    return list[static_cast<std::size_t>(roll(0, static_cast<int>(std::size(list)) - 1))];
  }

 private:
  std::mt19937 engine_;
};

constexpr std::size_t most_sizes = 3;

struct Num {
  std::array<int, most_sizes> of{};
  Num() = default;
  explicit Num(int all) { of.fill(all); }
  friend bool operator==(const Num&, const Num&) = default;
};

// A stitch of the trade under all its names. `spread` words, such as "sl 1, k1, psso", are several between commas.
struct Word {
  int takes, makes;
  std::vector<const char*> names;
};
const std::vector<Word>& words();
inline constexpr std::size_t knit_word = 0, purl_word = 1;

enum class Kind : std::uint8_t {
  stitch,  // times of one word
  group,   // parts, times or as far as they go
  place_marker,
  slip_marker,
  evenly,       // times stitches more or fewer, wherever
  hold,         // times stitches to a holder
  gap,          // times stitches cast on over a gap
  from_holder,  // times stitches knitted off a holder
};
enum class Fill : std::uint8_t { times, to_end, to_last, to_marker, to_before_marker };

struct Part {
  Kind kind = Kind::stitch;
  std::size_t word = knit_word;
  Num times{1};
  Fill fill = Fill::times;
  Num reserve{0};  // stitches that "to last" and "before marker" leave
  bool fewer = false;
  std::string name;  // of the holder
  std::vector<Part> parts;
  int look = 0;  // which way of saying it
};

enum class LineKind : std::uint8_t {
  note,       // says nothing of the count
  cast_on,    // count stitches
  round,      // parts, for each of its numbers
  even,       // count rounds, nothing changes
  again,      // rounds from..to, count times more, or until so many stitches
  close,      // count stitches, where it says how many
  put_aside,  // all to a holder
  take_back,  // count stitches from a holder, more picked up
};

struct Line {
  LineKind kind = LineKind::note;
  std::string text;  // a note; the words around a cast on
  Num count{0};
  bool says_count = true;    // "BO 12 sts" and not "BO all sts"
  int first = 0, last = 0;   // numbers of rounds; 0: none
  std::vector<int> numbers;  // "Rnds 2, 4 and 6"
  int from = 0, to = 0;      // rounds worked again
  int like = 0;              // "as rnd 3": the round that this one is like; 0: it says its own
  std::optional<Num> until;  // stitches
  Num picked_up{0};
  std::string name;  // of a holder or of a piece
  std::vector<Part> parts;
  std::optional<Num> stated;
  bool purl = false;   // all of a round
  bool whole = false;  // the round is one word: "Knit."
  bool flat = false, wrong_side = false;
  bool joined = false;  // goes on in the paragraph of the line above
  int look = 0, label = 0, count_look = 0, mark = 0;
};

struct Pattern {
  std::size_t sizes = 1;
  int size_look = 0;
  bool capitals = false;  // ALL OF IT
  int label = 0;          // the way that most lines are named
  std::vector<Line> lines;
};

enum class Truth : std::uint8_t { right, wrong, unclear };
struct Finding {
  Truth truth = Truth::right;
  std::size_t line = 0;  // of the model, from 0, where it is decided
};

// What a needle with a plain count says of it. Unclear: knitters would differ.
Finding work(const Pattern& pattern);

// One number, word or line changed; none where this pattern has nothing of the kind. `what` names it.
struct Changed {
  Pattern pattern;
  std::string what;
};
std::optional<Changed> change(const Pattern& pattern, Dice& dice);

// The text, and the names of the forms that it uses.
struct Text {
  std::string text;
  std::vector<std::string> forms;
};
Text say(const Pattern& pattern);

// A random pattern that adds up. The same seed gives the same one everywhere.
Pattern make(std::uint32_t seed);

// The forms that `make` may choose from; each comes up within a few thousand seeds.
std::vector<std::string> all_forms();

}  // namespace world
