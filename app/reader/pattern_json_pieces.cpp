#include "app/reader/pattern_json_pieces.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/reader/pattern_json_reader.h"
#include "knit/import/quoting.h"
#include "knit/reader/limbs_scan.h"
#include "knit/reader/reader_work.h"

namespace app {

namespace {

using PiecesDocument = nlohmann::json;

constexpr std::size_t most_stitches_in_all = 4'000'000;
constexpr std::int64_t most_rows_told = 1'000'000'000;

std::string listed_at(const std::string& place, const char* list, std::size_t index) {
  return place + "." + list + "[" + std::to_string(index) + "]";
}

// "A", "Z", "AA": pieces are lettered as they are worked.
std::string letters_told(std::size_t piece) {
  std::string letters;
  for (std::size_t left = piece + 1; left > 0; left = (left - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
  return letters;
}

enum class EndTold : std::uint8_t { held, goes_on, closed, grafted };
constexpr std::array<std::string_view, 4> ends_told{"held", "goes on", "closed", "grafted"};
constexpr std::array<std::string_view, 2> grafts_told{"kitchener", "three-needle"};

// A whole number that a list of numbers holds, or -1.
std::int64_t whole_in(const PiecesDocument& value) {
  if (!value.is_number_integer()) return -1;
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > most_rows_told) return -1;
  const auto number = value.get<std::int64_t>();
  return number >= 0 && number <= most_rows_told ? number : -1;
}

}  // namespace

knit::ReadLimbs read_pieces_json(const nlohmann::json& document) { return PiecesJsonReader(document).run(); }

bool PiecesJsonReader::fail(const std::string& place, const std::string& sentence) {
  if (read_.mistakes.empty())
    read_.mistakes.push_back({0, place.empty() ? sentence : place + ": " + sentence});
  return false;
}

bool PiecesJsonReader::fails() {
  if (!document_.fault().empty()) fail("", document_.fault());
  return !read_.mistakes.empty();
}

std::int32_t PiecesJsonReader::add(const knit::ReadStitch& stitch) {
  read_.stitches.push_back(stitch);
  return static_cast<std::int32_t>(read_.stitches.size()) - 1;
}

std::optional<PiecesJsonReader::Loop> PiecesJsonReader::cast_on(const std::string& place,
                                                                std::int32_t count) {
  if (read_.stitches.size() + static_cast<std::size_t>(count) > most_stitches_in_all) {
    fail(place, "the pattern is longer than can be read.");
    return std::nullopt;
  }
  Loop loop;
  for (std::int32_t i = 0; i < count; ++i) loop.push_back(add({}));
  return loop;
}

// --- names, the needle -------------------------------------------------------------------------------------------

bool PiecesJsonReader::list_pieces() {
  only_fields(document_, {"format", "version", "yarns", "holders", "holders_needed", "gaps", "pieces"});
  const std::size_t count = document_.array("pieces").size();
  document_.array("gaps");
  if (fails()) return false;
  if (count == 0) return fail("pieces", "there is none.");
  for (std::size_t i = 0; i < count; ++i) {
    JsonFields piece = document_.entry("pieces", i);
    std::string name = piece.text("name");
    if (fails()) return false;
    knit::LimbScan scan(name);
    const auto told = scan.name();
    if (!told || !scan.done() || told->letters != letters_told(i))
      return fail(
          "pieces[" + std::to_string(i) + "].name",
          "must be a capitalised word and the piece's letter, like \"Limb " + letters_told(i) + "\".");
    by_name_.emplace(name, i);
    names_.push_back(std::move(name));
  }
  return true;
}

std::optional<std::size_t> PiecesJsonReader::piece_in(JsonFields& fields, const char* key) {
  const std::string name = fields.text(key);
  if (fails()) return std::nullopt;
  const auto found = by_name_.find(name);
  if (found != by_name_.end()) return found->second;
  fail(fields.name_of(key), "there is no piece " + knit::quoted(name) + ".");
  return std::nullopt;
}

// Of a piece, or a further one that goes by it: "Limb B (holder 2)".
std::optional<std::string> PiecesJsonReader::holder_in(JsonFields& fields, bool must_hold) {
  std::string name = fields.text("holder");
  if (fails()) return std::nullopt;
  knit::LimbScan scan(name);
  const auto told = scan.holder();
  const auto found = told && scan.done() ? by_name_.find(told->word + " " + told->letters) : by_name_.end();
  const std::string place = fields.name_of("holder");
  if (found == by_name_.end()) {
    fail(place, "there is no piece " + knit::quoted(name) + ".");
  } else if (must_hold && holders_.count(name) == 0) {
    fail(place, "there are no held stitches of " + name + ".");
  } else if (!must_hold && found->second < now_) {
    fail(place, name + " is made already.");
  } else {
    return name;
  }
  return std::nullopt;
}

std::int32_t PiecesJsonReader::count_in(JsonFields& fields, const char* key, std::int32_t least) {
  return static_cast<std::int32_t>(fields.whole(key, least, knit::most_stitches));
}

bool PiecesJsonReader::expect(const std::string& place, JsonFields& fields) {
  const std::int32_t after = count_in(fields, "after", 0);
  if (fails()) return false;
  const std::int64_t there = std::ssize(needle_);
  if (there == after) return true;
  return fail(place, knit::stitches_text(there) + (there == 1 ? " is" : " are") +
                         " on the needle, \"after\" says " + std::to_string(after) + ".");
}

bool PiecesJsonReader::needs_yarn(const std::string& place) {
  return has_needle_ || fail(place, "there are no stitches on the needle.");
}

bool PiecesJsonReader::needs_no_stitches(const std::string& place) {
  if (!has_needle_) return true;
  return fail(place, knit::stitches_text(std::ssize(needle_)) +
                         " are still on the needle: hold them or close them first.");
}

void PiecesJsonReader::take_needle(Loop loop) {
  needle_ = std::move(loop);
  has_needle_ = true;
}

void PiecesJsonReader::drop_needle() {
  needle_.clear();
  has_needle_ = false;
}

bool PiecesJsonReader::hold(const std::string& place, const std::string& holder, Loop loop) {
  if (!holders_.emplace(holder, std::move(loop)).second)
    return fail(place, "the holder of " + holder + " is not empty.");
  held_most_ = std::max<std::int64_t>(held_most_, std::ssize(holders_));
  return true;
}

// --- pieces ------------------------------------------------------------------------------------------------------

knit::ReadLimbs PiecesJsonReader::run() {
  if (list_pieces()) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!make(i)) break;
    }
  }
  if (read_.mistakes.empty()) end_all();
  return std::move(read_);
}

bool PiecesJsonReader::make(std::size_t piece) {
  now_ = piece;
  piece_ = "pieces[" + std::to_string(piece) + "]";
  fields_ = document_.entry("pieces", piece);
  only_fields(*fields_, {"name", "twin_of", "inner", "begin", "live", "rounds", "graph", "short_rows", "rows",
                         "starts", "end"});
  if (fields_->has("inner")) fields_->flag("inner");
  if (fails()) return false;
  if (goes_on_ && *goes_on_ != piece)
    return fail(piece_, "the yarn goes on with " + names_[*goes_on_] + ", not with " + names_[piece] + ".");
  if (fields_->has("twin_of")) {
    const auto twin = piece_in(*fields_, "twin_of");
    if (!twin) return false;
    if (*twin >= piece) return fail(piece_ + ".twin_of", names_[*twin] + " is not made yet.");
  }
  goes_on_.reset();
  begun_ = is_cast_on_ = of_loops_ = false;
  read_.limbs.push_back({names_[piece], {}, {}});
  const std::size_t deals = fields_->array("begin").size();
  for (std::size_t i = 0; i < deals; ++i) {
    if (!deal(i)) return false;
  }
  if (fails()) return false;
  if (!begun_) return fail(piece_ + ".begin", "nothing says how " + names_[piece] + " begins.");
  held_ = std::max<std::int64_t>(held_, std::ssize(holders_));
  return check_live() && rounds() && check_rows() && end();
}

bool PiecesJsonReader::check_live() {
  if (is_cast_on_) return true;
  read_.limbs.back().live = needle_;
  const PiecesDocument& runs = fields_->array("live");
  if (fails()) return false;
  std::size_t at = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string place = listed_at(piece_, "live", i);
    const auto run = live_run(place, runs[i]);
    if (!run) return false;
    for (const std::int32_t stitch : *run) {
      if (at < needle_.size() && needle_[at] == stitch) {
        ++at;
        continue;
      }
      return fail(place, "another stitch lies there after the deals: the " + std::to_string(at + 1) +
                             ". from the marker.");
    }
  }
  if (at == needle_.size()) return true;
  return fail(piece_ + ".live", knit::stitches_text(static_cast<std::int64_t>(at)) + " are told, " +
                                    std::to_string(needle_.size()) + " lie on the needle.");
}

// ["Limb A", first, count, step]: stitches of that piece's last round, or of its cast on, or of a gap.
std::optional<PiecesJsonReader::Loop> PiecesJsonReader::live_run(const std::string& place,
                                                                 const nlohmann::json& run) {
  const bool is_run = run.is_array() && run.size() == 4 && run[0].is_string() && whole_in(run[1]) >= 0 &&
                      whole_in(run[2]) >= 1 && (run[3] == 1 || run[3] == -1);
  if (!is_run) {
    fail(place, "must be a name, the first stitch, their count, and 1 or -1.");
    return std::nullopt;
  }
  const auto whose = run[0].get<std::string>();
  const Loop* from = nullptr;
  if (whose.starts_with("gap ")) {
    for (const auto& [number, gap] : gaps_) {
      if (whose == "gap " + std::to_string(number)) from = &gap.stitches;
    }
  } else if (const auto found = by_name_.find(whose); found != by_name_.end() && found->second < now_) {
    const auto& rows = read_.limbs[found->second].rows;
    from = of_loops_ ? &rows.front() : &rows.back();
  }
  if (from == nullptr) {
    fail(place, "there are no stitches of " + knit::quoted(whose) + " yet.");
    return std::nullopt;
  }
  const std::int64_t first = whole_in(run[1]), count = whole_in(run[2]), step = run[3].get<std::int64_t>(),
                     last = first + step * (count - 1), size = std::ssize(*from);
  if (first >= size || last < 0 || last >= size) {
    fail(place, whose + " has only " + knit::stitches_text(size) + ".");
    return std::nullopt;
  }
  Loop loop;
  for (std::int64_t i = 0; i < count; ++i)
    loop.push_back((*from)[static_cast<std::size_t>(first + step * i)]);
  return loop;
}

// --- rounds ------------------------------------------------------------------------------------------------------

bool PiecesJsonReader::rounds() {
  const std::size_t count = fields_->array("rounds").size(), rows = fields_->array("graph").size(),
                    made = count + (is_cast_on_ ? 1 : 0);
  if (fails()) return false;
  if (made == 0) return fail(piece_ + ".rounds", "there is none.");
  if (rows != made)
    return fail(piece_ + ".graph", std::to_string(rows) + (rows == 1 ? " row is" : " rows are") + " told, " +
                                       std::to_string(made) + (made == 1 ? " is made." : " are made."));
  if (is_cast_on_) {
    if (const auto fault = cast_on_fault(fields_->array("graph")[0], std::ssize(needle_)); !fault.empty())
      return fail("", listed_at(piece_, "graph", 0) + fault);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!work(i, fields_->entry("rounds", i))) return false;
  }
  if (const auto fault = short_rows_fault(fields_->json(), read_.limbs.back().short_rows); !fault.empty())
    return fail("", piece_ + ".short_rows" + fault);
  return true;
}

bool PiecesJsonReader::work(std::size_t index, JsonFields fields) {
  const JsonRound round = json_round(fields);
  if (fails()) return false;
  const std::size_t row = index + (is_cast_on_ ? 1 : 0);
  const std::string place = listed_at(piece_, "rounds", index);
  if (const auto fault = round_fault(round, static_cast<std::int32_t>(row) + 1, std::ssize(needle_));
      !fault.empty())
    return fail(place, fault);
  if (read_.stitches.size() + round.operations.size() > most_stitches_in_all)
    return fail(place, "the pattern is longer than can be read.");
  if (const auto fault = row_fault(fields_->array("graph")[row], round); !fault.empty())
    return fail("", listed_at(piece_, "graph", row) + fault);
  const std::int32_t below = static_cast<std::int32_t>(index) - (is_cast_on_ ? 0 : 1);
  for (const knit::GraphShortRow& short_row : short_rows_of(round, below))
    read_.limbs.back().short_rows.push_back(short_row);
  const std::size_t n = needle_.size();
  if (round.slips_back) std::rotate(needle_.begin(), needle_.end() - 1, needle_.end());
  Loop made;
  std::size_t done = 0;
  for (const knit::Operation& operation : round.operations) {
    const auto taken = static_cast<std::size_t>(knit::consumed_by(operation.hand));
    knit::ReadStitch stitch{operation.hand, -1, -1};
    stitch.first = taken > 0 ? needle_[done] : needle_[(done + n - 1) % n];
    if (taken != 1) stitch.second = needle_[(taken > 0 ? done + 1 : done) % n];
    made.push_back(add(stitch));
    done += taken;
  }
  needle_ = made;
  read_.limbs.back().rows.push_back(std::move(made));
  ++read_.rounds_read;
  return true;
}

bool PiecesJsonReader::check_rows() {
  const PiecesDocument &rows = fields_->array("rows"), &starts = fields_->array("starts");
  if (fails()) return false;
  const std::vector<Loop>& made = read_.limbs.back().rows;
  for (const auto& [list, name] : {std::pair(&rows, "rows"), std::pair(&starts, "starts")}) {
    if (list->size() != made.size())
      return fail(piece_ + "." + name,
                  std::to_string(list->size()) + " are told of " + std::to_string(made.size()) + " rounds.");
  }
  for (std::size_t i = 0; i < made.size(); ++i) {
    const std::string place = listed_at(piece_, "rows", i);
    const std::int64_t row = whole_in(rows[i]);
    if (row < 1) return fail(place, "must be a row of the fabric, from 1.");
    const auto [told, is_new] = rows_.emplace(row, place);
    if (!is_new)
      return fail(place, "row " + std::to_string(row) + " is told already, in " + told->second + ".");
    const std::int64_t start = whole_in(starts[i]);
    if (start < 0 || start >= std::ssize(made[i]))
      return fail(listed_at(piece_, "starts", i),
                  "must be one of the round's " + knit::stitches_text(std::ssize(made[i])) + ", from 0.");
  }
  return true;
}

// --- ends --------------------------------------------------------------------------------------------------------

bool PiecesJsonReader::end() {
  JsonFields fields = fields_->object("end");
  const std::string place = piece_ + ".end";
  const auto kind = static_cast<EndTold>(fields.choice("kind", ends_told));
  if (fails()) return false;
  if (kind == EndTold::grafted) return graft(place, fields);
  if (kind == EndTold::goes_on) {
    only_fields(fields, {"kind", "piece"});
    goes_on_ = piece_in(fields, "piece");
    if (!goes_on_) return false;
    return *goes_on_ == now_ + 1 ||
           fail(place, "the yarn goes on with the piece that follows, not with " + names_[*goes_on_] + ".");
  }
  only_fields(fields, {"kind"});
  if (fails()) return false;
  Loop loop = std::move(needle_);
  drop_needle();
  if (kind == EndTold::held) return hold(place, names_[now_], std::move(loop));
  read_.closed.push_back(std::move(loop));
  return true;
}

bool PiecesJsonReader::graft(const std::string& place, JsonFields& fields) {
  only_fields(fields, {"kind", "piece", "by", "slips_back", "others_first", "grafts", "pairs"});
  const bool three_needle = fields.choice("by", grafts_told) == 1;
  const auto piece = piece_in(fields, "piece");
  const std::int32_t slips = count_in(fields, "slips_back", 0), first = count_in(fields, "others_first", 0);
  const PiecesDocument& grafts = fields.array("grafts");
  if (!piece || fails()) return false;
  const auto holder = holders_.find(names_[*piece]);
  if (holder == holders_.end()) return fail(place, "there are no held stitches of " + names_[*piece] + ".");
  const Loop held = holder->second;
  const std::int64_t own = std::ssize(needle_), others = std::ssize(held);
  if (slips >= own) return fail(place, "all stitches are slipped back.");
  if (first >= others)
    return fail(place, names_[*piece] + " has " + knit::stitches_text(others) +
                           " held, \"others_first\" says " + std::to_string(first) + ".");
  const std::size_t before = read_.grafts.size();
  std::int64_t i = 0, k = 0;
  for (std::size_t g = 0; g < grafts.size(); ++g) {
    const PiecesDocument& told = grafts[g];
    const bool is_pair = told.is_array() && told.size() == 2;
    const std::int64_t a = is_pair ? whole_in(told[0]) : 0, b = is_pair ? whole_in(told[1]) : 0;
    if (a < 1 || b < 1 || (a > 1 && b > 1))
      return fail(place + ".grafts[" + std::to_string(g) + "]",
                  "must be two numbers, of which one is 1: own stitches and the other's.");
    if (three_needle && a != b)
      return fail(place + ".grafts[" + std::to_string(g) + "]",
                  "three needles bind off one stitch with one; these are " + std::to_string(a) + " and " +
                      std::to_string(b) + ".");
    if (a > own - i || b > others - k) return fail(place, "more is grafted than there is.");
    for (std::int64_t x = 0; x < a; ++x) {
      for (std::int64_t y = 0; y < b; ++y)
        read_.grafts.push_back({needle_[static_cast<std::size_t>((i + x - slips + own) % own)],
                                held[static_cast<std::size_t>((first - k - y + 2 * others) % others)]});
    }
    i += a;
    k += b;
  }
  if (i != own || k != others)
    return fail(place, std::to_string(i) + " of " + knit::stitches_text(own) +
                           " on the needle are grafted, " + std::to_string(k) + " of " +
                           std::to_string(others) + " held.");
  if (!check_pairs(place, fields, before, held)) return false;
  holders_.erase(names_[*piece]);
  drop_needle();
  return true;
}

// The graph of a graft: [own stitch, the other's], each in its last round from its marker.
bool PiecesJsonReader::check_pairs(const std::string& place, JsonFields& fields, std::size_t first_graft,
                                   const Loop& held) {
  const PiecesDocument& pairs = fields.array("pairs");
  if (fails()) return false;
  const std::size_t count = read_.grafts.size() - first_graft;
  if (pairs.size() != count)
    return fail(place + ".pairs",
                std::to_string(pairs.size()) + " are told, " + std::to_string(count) + " are grafted.");
  for (std::size_t i = 0; i < count; ++i) {
    const auto [own, other] = read_.grafts[first_graft + i];
    const PiecesDocument& told = pairs[i];
    const std::int64_t a = told.is_array() && told.size() == 2 ? whole_in(told[0]) : -1,
                       b = a >= 0 ? whole_in(told[1]) : -1;
    const bool same = a >= 0 && a < std::ssize(needle_) && needle_[static_cast<std::size_t>(a)] == own &&
                      b >= 0 && b < std::ssize(held) && held[static_cast<std::size_t>(b)] == other;
    if (!same)
      return fail(place + ".pairs[" + std::to_string(i) + "]", "other stitches are grafted to each other.");
  }
  return true;
}

bool PiecesJsonReader::end_all() {
  if (goes_on_) return fail("pieces", names_[*goes_on_] + " is never worked.");
  if (has_needle_)
    return fail("pieces", knit::stitches_text(std::ssize(needle_)) + " are left on the needle.");
  for (const auto& [name, loop] : holders_)
    return fail("pieces", knit::stitches_text(std::ssize(loop)) + (loop.size() == 1 ? " is" : " are") +
                              " left on the holder of " + name + ".");
  for (const auto& [piece, loop] : waste_)
    return fail("pieces[" + std::to_string(piece) + "].begin[0]", "the waste yarn is never removed.");
  std::int32_t next = 1;
  for (const auto& [number, gap] : gaps_) {
    if (std::find(gap.picked.begin(), gap.picked.end(), false) != gap.picked.end())
      return fail(gap.place, "gap " + std::to_string(number) + " is never picked up whole.");
    if (number != next) break;
    ++next;
    read_.gaps.push_back(gap.stitches);
  }
  if (const std::size_t told = document_.array("gaps").size(); told != gaps_.size())
    return fail("gaps",
                std::to_string(told) + " are told, " + std::to_string(gaps_.size()) + " are cast on.");
  if (read_.gaps.size() != gaps_.size())
    return fail("gaps", "gap " + std::to_string(next) + " is missing; gaps are numbered from 1.");
  if (rows_.rbegin()->first != std::ssize(rows_))
    return fail(rows_.rbegin()->second, "row " + std::to_string(rows_.rbegin()->first) +
                                            " is told, and there are " + std::to_string(rows_.size()) +
                                            " rows in all.");
  for (const auto& [key, there] :
       {std::pair("yarns", yarns_), std::pair("holders", held_), std::pair("holders_needed", held_most_)}) {
    const std::int64_t told = document_.whole(key, 0, most_rows_told);
    if (!fails() && told != there)
      fail(key, std::to_string(there) + (there == 1 ? " is" : " are") + " used, " + std::to_string(told) +
                    (told == 1 ? " is" : " are") + " told.");
    if (fails()) return false;
  }
  return true;
}

}  // namespace app
