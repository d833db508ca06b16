// The needle, holders, waste yarn and gaps of somebody who knits a pattern with limbs, sentence by sentence.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "knit/reader/limbs_lines.h"
#include "knit/reader/limbs_reader.h"
#include "knit/reader/short_needles.h"

namespace knit {

class LimbWorker {
 public:
  LimbWorker(std::vector<LimbSection> sections, std::size_t last_line);
  ReadLimbs run();

 private:
  // A place on a holder: a held stitch, or a stitch of a gap's edge that lies between.
  struct Place {
    std::int32_t stitch = 0;
    std::int32_t gap = 0;  // 0: held
  };
  using Loop = std::vector<std::int32_t>;
  using Holder = std::vector<Place>;
  struct Gap {
    Loop stitches;
    std::int32_t left = 0;  // to pick up
  };
  // A round as it was worked, for "work as for".
  struct Worked {
    bool cast_on = false, provisional = false, slips = false;
    std::vector<Operation> operations;
    std::int32_t after = 0;
    std::vector<GraphShortRow> short_rows = {};  // before it or within it; `row` is 0
  };
  struct Piece {
    std::string name;
    std::string together;  // the word of pieces made together
    bool made = false;
    std::vector<Worked> rounds;
  };
  // What is taken off a holder within one line.
  struct Taking {
    std::size_t at = 0, taken = 0;
  };
  struct Laying {
    bool rejoins = false;
    std::size_t kept = 0;
    Loop loop;
    std::vector<std::size_t> order;  // holders, as they are first taken from
    std::map<std::size_t, Taking> taking;
    std::optional<std::size_t> now;                   // the holder taken from last
    std::vector<std::string_view> ahead;              // items that follow
    std::vector<std::pair<std::int32_t, Loop>> open;  // gaps cast on in this line, not yet picked up
    struct Before {
      std::size_t kept = 0, laid = 0;  // laid: the gap's own stitches too
      std::map<std::size_t, Taking> taking;
    };
    std::vector<Before> before;  // of each open gap: what was laid before it
  };

  bool fail(const std::string& sentence);
  [[nodiscard]] bool failed() const { return !read_.mistakes.empty(); }
  bool not_understood(std::string_view words) {
    return fail("not understood: \"" + std::string(words) + "\".");
  }
  // The piece of that name; blames its line where there is none.
  std::optional<std::size_t> piece_of(const LimbName& name);
  [[nodiscard]] std::optional<std::size_t> known(const LimbName& name) const;
  // A holder's number: that of its piece, or further on for a second one.
  std::optional<std::size_t> holder_of(const LimbName& name);
  [[nodiscard]] std::string name_of(std::size_t holder) const;
  [[nodiscard]] std::int32_t on_needle() const { return static_cast<std::int32_t>(needle_.size()); }
  bool is_short_enough();
  std::int32_t new_stitch(const ReadStitch& stitch);

  bool list_names();
  bool make(const LimbSection& section, std::size_t piece);
  bool end_all();
  bool line(std::string_view words);
  bool break_yarn(LimbScan at);
  bool expect(std::int32_t comes_out, std::int32_t says);
  bool needs_yarn();
  bool needs_no_stitches();
  bool needs_fresh_piece();
  bool finish_piece();
  bool hold(std::size_t piece, Holder holder);

  bool round(std::string_view words);
  bool cast_on(std::int32_t first, std::int32_t last, LimbScan at, bool provisional);
  bool work_as(std::int32_t first, std::int32_t last, std::string_view words);
  bool begin_round(std::int32_t number);
  bool work(std::int32_t number, const Worked& round);
  bool short_row(const ShortRowLine& row);
  bool end_short_rows(const ShortRowLine& row);
  // Those that stand alone before an ordinary round; they are the first round's.
  bool take_short_rows(std::int32_t number, Worked& round);
  bool work_words(std::int32_t first, std::int32_t last, std::string_view words);
  std::optional<Loop> slipped_back(bool slips) const;

  bool rejoin(LimbScan at);
  bool loops(LimbScan at);
  bool divide(LimbScan at);
  bool join(LimbScan at);
  bool move(LimbScan at);
  bool set_aside(LimbScan at);
  bool graft(LimbScan at, bool three_needle);
  bool graft_words(std::string_view words, const Loop& other, std::int32_t slips, bool three_needle);
  bool lay(std::string_view items, Laying& laying);
  bool lay_kept(std::int32_t count, Laying& laying);
  bool lay_across(std::int32_t count, std::int32_t gap, Laying& laying);
  bool lay_item(LimbScan at, Laying& laying);
  bool lay_gap(std::int32_t count, std::int32_t gap, Laying& laying);
  std::optional<std::size_t> edge_of(std::int32_t count, std::int32_t gap, Laying& laying);
  bool lay_held(std::int32_t count, const LimbName& name, LimbScan at, Laying& laying);
  bool take_held(std::int32_t count, std::size_t piece, std::int32_t first, Laying& laying);
  std::optional<Loop> cast_on_gap(std::int32_t count, std::int32_t gap);
  bool parts_no_loop(const Laying& laying, std::int32_t gap);
  bool empty_holders(const Laying& laying);

  std::vector<LimbSection> sections_;
  std::vector<std::vector<std::size_t>> of_section_;
  std::size_t last_line_ = 0, line_ = 0;
  std::vector<Piece> pieces_;
  std::map<std::string, std::size_t> by_letters_;
  std::size_t now_ = 0;
  ReadLimbs read_;
  Loop needle_;
  bool has_needle_ = false, yarn_ = false, ended_ = false, begun_ = false;
  std::optional<std::size_t> goes_on_;   // the piece that the yarn goes on with
  std::optional<ShortNeedles> needles_;  // while short rows are worked: the needle's stitches
  std::string whose_;                    // the piece whose stitches are on the needle
  const LimbHeading* heading_ = nullptr;
  std::map<std::size_t, Holder> holders_;
  std::map<std::size_t, Loop> waste_;
  std::map<std::int32_t, Gap> gaps_;
};

}  // namespace knit
