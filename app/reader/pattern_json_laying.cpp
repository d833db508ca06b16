// Deals of the JSON of a pattern: what goes on holders, what is taken off them, cast on across gaps and picked up along them.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/reader/pattern_json_pieces.h"
#include "knit/import/quoting.h"
#include "knit/reader/reader_work.h"

namespace app {

namespace {

std::string said(std::int64_t count) { return knit::stitches_text(count); }
std::string said_are(std::int64_t count) { return said(count) + (count == 1 ? " is" : " are"); }
std::string gap_of(std::int32_t gap) { return "gap " + std::to_string(gap); }

enum class DealTold : std::uint8_t { cast_on, provisional, loops, rejoin, aside, move, divide, join };
constexpr std::array<std::string_view, 8> deals_told{"cast on", "provisional", "loops",  "rejoin",
                                                     "aside",   "move",        "divide", "join"};
enum class UseTold : std::uint8_t { keep, take, cast_on, pick_up };
constexpr std::array<std::string_view, 4> uses_told{"keep", "take", "cast on", "pick up"};

}  // namespace

bool PiecesJsonReader::deal(std::size_t number) {
  const std::string place = piece_ + ".begin[" + std::to_string(number) + "]";
  JsonFields fields = fields_->entry("begin", number);
  const auto kind = static_cast<DealTold>(fields.choice("kind", deals_told));
  if (fails()) return false;
  if (is_cast_on_) return fail(place, names_[now_] + " is begun already.");
  switch (kind) {
    case DealTold::cast_on:
    case DealTold::provisional:
      return cast_on_piece(place, number, fields, kind == DealTold::provisional);
    case DealTold::loops:
      return loops(place, fields);
    case DealTold::aside:
      return set_aside(place, fields);
    case DealTold::move:
      return move(place, fields);
    case DealTold::divide:
      return divide(place, fields);
    case DealTold::rejoin:
    case DealTold::join:
      return lay(place, fields, kind == DealTold::rejoin);
  }
  return false;
}

bool PiecesJsonReader::cast_on_piece(const std::string& place, std::size_t number, JsonFields& fields,
                                     bool provisional) {
  only_fields(fields, {"kind", "after"});
  const std::int32_t count = count_in(fields, "after", 1);
  if (fails() || !needs_no_stitches(place)) return false;
  if (number > 0) return fail(place, names_[now_] + " is begun already.");
  auto loop = cast_on(place, count);
  if (!loop) return false;
  if (provisional) waste_[now_] = *loop;
  read_.cast_on += count;
  read_.limbs.back().rows.push_back(*loop);
  take_needle(std::move(*loop));
  begun_ = is_cast_on_ = true;
  ++yarns_;
  return true;
}

bool PiecesJsonReader::loops(const std::string& place, JsonFields& fields) {
  only_fields(fields, {"kind", "after", "piece"});
  const auto piece = piece_in(fields, "piece");
  if (!piece || !needs_no_stitches(place)) return false;
  const auto found = waste_.find(*piece);
  if (found == waste_.end()) return fail(place, names_[*piece] + " has no waste yarn.");
  Loop loop = std::move(found->second);
  waste_.erase(found);
  std::reverse(loop.begin(), loop.end());
  take_needle(std::move(loop));
  begun_ = of_loops_ = true;
  ++yarns_;
  return expect(place, fields);
}

bool PiecesJsonReader::set_aside(const std::string& place, JsonFields& fields) {
  only_fields(fields, {"kind", "after", "holder"});
  const auto holder = holder_in(fields, false);
  if (!holder || !needs_yarn(place)) return false;
  Loop loop = std::move(needle_);
  drop_needle();
  begun_ = false;
  return hold(place, *holder, std::move(loop)) && expect(place, fields);
}

bool PiecesJsonReader::move(const std::string& place, JsonFields& fields) {
  only_fields(fields, {"kind", "after", "slip"});
  const std::int32_t slipped = count_in(fields, "slip", 1);
  if (fails() || !needs_yarn(place)) return false;
  const auto there = static_cast<std::int32_t>(needle_.size());
  if (slipped >= there)
    return fail(place, said(slipped) + " cannot be slipped: " + said_are(there) + " on the needle.");
  std::rotate(needle_.begin(), needle_.begin() + slipped, needle_.end());
  ++yarns_;
  return expect(place, fields);
}

bool PiecesJsonReader::divide(const std::string& place, JsonFields& fields) {
  only_fields(fields, {"kind", "after", "holder", "keep", "held", "gap", "bridge", "rest"});
  const std::int32_t before = count_in(fields, "keep", 0), held = count_in(fields, "held", 1),
                     gap = count_in(fields, "gap", 0), bridge = count_in(fields, "bridge", 0),
                     rest = count_in(fields, "rest", 0);
  const auto holder = holder_in(fields, false);
  if (!holder || !needs_yarn(place)) return false;
  const std::int64_t dealt = std::int64_t{before} + held + rest, there = std::ssize(needle_);
  if (dealt != there)
    return fail(place, said_are(dealt) + " dealt, " + std::to_string(there) + (there == 1 ? " is" : " are") +
                           " on the needle.");
  if ((gap == 0) != (bridge == 0))
    return fail(place, gap == 0 ? said_are(bridge) + " cast on across no gap."
                                : gap_of(gap) + " has no stitches to cast on.");
  std::optional<Loop> bridged = Loop{};
  if (gap > 0) bridged = across(place, gap, bridge);
  if (!bridged) return false;
  const auto begin = needle_.begin() + before, end = begin + held;
  Loop aside(begin, end), kept(needle_.begin(), begin);
  kept.insert(kept.end(), bridged->begin(), bridged->end());
  kept.insert(kept.end(), end, needle_.end());
  take_needle(std::move(kept));
  begun_ = true;
  return hold(place, *holder, std::move(aside)) && expect(place, fields);
}

// --- joins and rejoins -------------------------------------------------------------------------------------------

bool PiecesJsonReader::lay(const std::string& place, JsonFields& fields, bool rejoins) {
  only_fields(fields, {"kind", "after", "items"});
  const std::size_t items = fields.array("items").size();
  if (fails() || !(rejoins ? needs_no_stitches(place) : needs_yarn(place))) return false;
  Laying laying;
  for (std::size_t i = 0; i < items; ++i) {
    if (!lay_item(place + ".items[" + std::to_string(i) + "]", fields.entry("items", i), rejoins, laying))
      return false;
  }
  if (rejoins && laying.taking.size() != 1) return fail(place, "yarn is rejoined at one holder.");
  if (laying.taking.empty()) return fail(place, "nothing is taken off a holder.");
  if (laying.kept != needle_.size())
    return fail(
        place, std::to_string(laying.kept) + " of " + said(std::ssize(needle_)) + " on the needle are used.");
  if (!empty_holders(place, laying)) return false;
  // A divided loop's holder goes by the piece worked first from it; any other must be dealt on.
  begun_ = !rejoins || laying.taking.front().holder == names_[now_] ||
           laying.taking.front().holder.starts_with(names_[now_] + " (");
  take_needle(std::move(laying.loop));
  if (rejoins) ++yarns_;
  return expect(place, fields);
}

bool PiecesJsonReader::lay_item(const std::string& place, JsonFields item, bool rejoins, Laying& laying) {
  const auto use = static_cast<UseTold>(item.choice("use", uses_told));
  if (fails()) return false;
  if (rejoins && (use == UseTold::keep || use == UseTold::cast_on))
    return fail(place, "where yarn is rejoined, stitches are taken off a holder or picked up.");
  switch (use) {
    case UseTold::keep:
      return lay_kept(place, item, laying);
    case UseTold::take:
      return lay_held(place, item, laying);
    case UseTold::cast_on:
      return lay_across(place, item, laying);
    case UseTold::pick_up:
      return lay_along(place, item, laying);
  }
  return false;
}

bool PiecesJsonReader::lay_kept(const std::string& place, JsonFields& item, Laying& laying) {
  only_fields(item, {"use", "count"});
  const std::int32_t count = count_in(item, "count", 1);
  if (fails()) return false;
  if (laying.kept + static_cast<std::size_t>(count) > needle_.size())
    return fail(place, "only " + said_are(std::ssize(needle_)) + " on the needle to keep.");
  const auto begin = needle_.begin() + static_cast<std::ptrdiff_t>(laying.kept);
  laying.loop.insert(laying.loop.end(), begin, begin + count);
  laying.kept += static_cast<std::size_t>(count);
  return true;
}

bool PiecesJsonReader::lay_held(const std::string& place, JsonFields& item, Laying& laying) {
  only_fields(item, {"use", "count", "holder", "first", "held"});
  const std::int32_t count = count_in(item, "count", 1), first = count_in(item, "first", 0),
                     held = count_in(item, "held", 1);
  const auto name = holder_in(item, true);
  if (!name) return false;
  const Loop& loop = holders_.at(*name);
  const auto there = static_cast<std::int32_t>(std::ssize(loop));
  if (held != there)
    return fail(place, said_are(there) + " on the holder of " + *name + ", \"held\" says " +
                           std::to_string(held) + ".");
  auto taking = std::find_if(laying.taking.begin(), laying.taking.end(),
                             [&](const Taking& one) { return one.holder == *name; });
  if (taking == laying.taking.end()) taking = laying.taking.insert(taking, {*name, first, 0});
  const std::int64_t next = (taking->first + taking->taken) % there;
  if (first >= there || next != first)
    return fail(place, "stitch " + std::to_string(first >= there ? first % there : next) + " of " + *name +
                           " is next, \"first\" says " + std::to_string(first) + ".");
  if (taking->taken + count > there)
    return fail(place, *name + " has no more than " + said(there) + " on its holder.");
  for (std::int32_t i = 0; i < count; ++i)
    laying.loop.push_back(loop[static_cast<std::size_t>((first + i) % there)]);
  taking->taken += count;
  return true;
}

bool PiecesJsonReader::lay_across(const std::string& place, JsonFields& item, Laying& laying) {
  only_fields(item, {"use", "count", "gap"});
  const std::int32_t count = count_in(item, "count", 1), gap = count_in(item, "gap", 1);
  if (fails()) return false;
  const auto stitches = across(place, gap, count);
  if (!stitches) return false;
  laying.loop.insert(laying.loop.end(), stitches->begin(), stitches->end());
  return true;
}

bool PiecesJsonReader::lay_along(const std::string& place, JsonFields& item, Laying& laying) {
  only_fields(item, {"use", "count", "gap", "first"});
  const std::int32_t count = count_in(item, "count", 1), gap = count_in(item, "gap", 1),
                     first = count_in(item, "first", 0);
  if (fails()) return false;
  const auto found = gaps_.find(gap);
  if (found == gaps_.end()) return fail(place, gap_of(gap) + " was not cast on.");
  Gap& along = found->second;
  const std::int64_t size = std::ssize(along.stitches);
  if (first >= size || count > first + 1)
    return fail(place, said(count) + " from stitch " + std::to_string(first) + " backwards are not in " +
                           gap_of(gap) + " of " + said(size) + ".");
  for (std::int32_t i = first; i > first - count; --i) {
    const auto at = static_cast<std::size_t>(i);
    if (along.picked[at])
      return fail(place, "stitch " + std::to_string(i) + " of " + gap_of(gap) + " is picked up twice.");
    along.picked[at] = true;
    laying.loop.push_back(along.stitches[at]);
  }
  return true;
}

bool PiecesJsonReader::empty_holders(const std::string& place, const Laying& laying) {
  for (const Taking& taking : laying.taking) {
    const std::int64_t there = std::ssize(holders_.at(taking.holder));
    if (taking.taken != there)
      return fail(place, "not all of " + taking.holder + " is taken: " + std::to_string(taking.taken) +
                             " of " + said(there) + ".");
  }
  for (const Taking& taking : laying.taking) holders_.erase(taking.holder);
  return true;
}

std::optional<PiecesJsonReader::Loop> PiecesJsonReader::across(const std::string& place, std::int32_t gap,
                                                               std::int32_t count) {
  if (gaps_.count(gap) > 0) {
    fail(place, gap_of(gap) + " is cast on twice.");
    return std::nullopt;
  }
  const nlohmann::json& sizes = document_.array("gaps");
  const auto index = static_cast<std::size_t>(gap) - 1;
  if (index >= sizes.size() || sizes[index] != count) {
    fail(place, said_are(count) + " cast on across " + gap_of(gap) + ", \"gaps[" + std::to_string(index) +
                    "]\" says " +
                    (index < sizes.size() ? knit::printable_start(sizes[index].dump(), 20) : "nothing") +
                    ".");
    return std::nullopt;
  }
  auto stitches = cast_on(place, count);
  if (stitches) gaps_[gap] = {*stitches, std::vector<bool>(static_cast<std::size_t>(count), false), place};
  return stitches;
}

}  // namespace app
