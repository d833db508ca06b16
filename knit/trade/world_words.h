// The stitch words of the trade as one table: how each is written, what it takes from the left needle and makes on the
// right one, and who says so. docs/pattern.md prints it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knit/trade/world_atoms.h"

namespace knit {

struct TradeWord {
  std::string_view forms;  // parted by "|", as atoms part them: "k2tog|knit 2 together"
  std::int32_t takes = 1, makes = 1;
  bool counts = false;  // a number may follow: k4, slip 2
  std::string_view meaning, source;
};
std::span<const TradeWord> trade_words();
// The table as docs/pattern.md has it, in Markdown.
std::string trade_words_table();

struct MatchedWord {
  std::int64_t takes = 1, makes = 1;
  bool counts = false;
  bool plain = false;  // knit or purl
  bool vague = false;  // "inc": into a stitch or between two
  std::size_t atoms = 0;
};

// The table made ready for search; one for a text.
class Lexicon {
 public:
  Lexicon();
  // The longest word that begins at `at`, with what may follow it ("tbl", "purlwise").
  [[nodiscard]] std::optional<MatchedWord> match(std::span<const Atom> atoms, std::size_t at) const;

 private:
  struct Form {
    Atoms atoms;
    std::size_t word = 0;
  };
  std::map<std::string, std::vector<Form>, std::less<>> by_first_;
};

}  // namespace knit
