// The needle, holders, waste yarn and gaps of somebody who works the JSON of a pattern in pieces, for pattern_json_reader.h
// alone. Beside that every stitch on a needle is held against what the file says lies there (`live`), every round against the
// file's graph.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/base/json_fields.h"
#include "app/reader/pattern_json_rounds.h"
#include "knit/reader/limbs_reader.h"

namespace app {

class PiecesJsonReader {
 public:
  explicit PiecesJsonReader(const nlohmann::json& document) : document_(document) {}
  knit::ReadLimbs run();

 private:
  using Loop = std::vector<std::int32_t>;
  // From which held stitch on a holder is taken from, and how many so far.
  struct Taking {
    std::string holder;
    std::int64_t first = 0, taken = 0;
  };
  struct Laying {
    std::size_t kept = 0;
    Loop loop;
    std::vector<Taking> taking;  // in the order of the items
  };
  struct Gap {
    Loop stitches;
    std::vector<bool> picked;
    std::string place;  // where it is cast on
  };

  bool fail(const std::string& place, const std::string& sentence);
  // Moves a fault of the fields to the mistakes.
  bool fails();
  bool list_pieces();
  bool make(std::size_t piece);
  bool end_all();

  std::optional<std::size_t> piece_in(JsonFields& fields, const char* key);
  std::optional<std::string> holder_in(JsonFields& fields, bool must_hold);
  std::int32_t count_in(JsonFields& fields, const char* key, std::int32_t least);
  bool expect(const std::string& place, JsonFields& fields);  // `after`
  bool needs_yarn(const std::string& place);
  bool needs_no_stitches(const std::string& place);
  void take_needle(Loop loop);
  void drop_needle();
  std::int32_t add(const knit::ReadStitch& stitch);
  std::optional<Loop> cast_on(const std::string& place, std::int32_t count);
  bool hold(const std::string& place, const std::string& holder, Loop loop);

  bool deal(std::size_t number);
  bool cast_on_piece(const std::string& place, std::size_t number, JsonFields& fields, bool provisional);
  bool loops(const std::string& place, JsonFields& fields);
  bool set_aside(const std::string& place, JsonFields& fields);
  bool move(const std::string& place, JsonFields& fields);
  bool divide(const std::string& place, JsonFields& fields);
  bool lay(const std::string& place, JsonFields& fields, bool rejoins);
  bool lay_item(const std::string& place, JsonFields item, bool rejoins, Laying& laying);
  bool lay_kept(const std::string& place, JsonFields& item, Laying& laying);
  bool lay_held(const std::string& place, JsonFields& item, Laying& laying);
  bool lay_across(const std::string& place, JsonFields& item, Laying& laying);
  bool lay_along(const std::string& place, JsonFields& item, Laying& laying);
  bool empty_holders(const std::string& place, const Laying& laying);
  std::optional<Loop> across(const std::string& place, std::int32_t gap, std::int32_t count);

  bool check_live();
  std::optional<Loop> live_run(const std::string& place, const nlohmann::json& run);
  bool rounds();
  bool work(std::size_t index, JsonFields fields);
  bool check_rows();
  bool end();
  bool graft(const std::string& place, JsonFields& fields);
  bool check_pairs(const std::string& place, JsonFields& fields, std::size_t first_graft, const Loop& held);

  JsonFields document_;
  knit::ReadLimbs read_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> by_name_;
  std::size_t now_ = 0;
  std::string piece_;  // "pieces[2]"
  std::optional<JsonFields> fields_;
  Loop needle_;
  bool has_needle_ = false, begun_ = false, is_cast_on_ = false, of_loops_ = false;
  std::optional<std::size_t> goes_on_;  // the piece that the yarn goes on with
  std::map<std::string, Loop> holders_;
  std::map<std::size_t, Loop> waste_;
  std::map<std::int32_t, Gap> gaps_;
  std::int64_t yarns_ = 0, held_ = 0, held_most_ = 0;
  std::map<std::int64_t, std::string> rows_;  // of the fabric, with the place that tells them
};

}  // namespace app
