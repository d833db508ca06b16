// What lies on the needle: stitches kept, taken off holders, cast on across gaps and picked up along them; and grafts.
#include <algorithm>
#include <utility>

#include "knit/reader/limbs_work.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

std::string count_text(std::int64_t count) { return std::to_string(count) + (count == 1 ? " st" : " sts"); }
std::string gap_text(std::int32_t gap) { return "gap " + std::to_string(gap); }

// "…; … . (12 sts)": what stands before the count.
std::optional<std::pair<std::string_view, std::int32_t>> with_count(std::string_view words) {
  const std::size_t end = words.rfind(". (");
  if (end == std::string_view::npos) return std::nullopt;
  LimbScan at(words.substr(end + 1));
  const auto count = at.count_at_end();
  if (!count) return std::nullopt;
  return std::pair(words.substr(0, end), *count);
}

std::vector<std::string_view> items_in(std::string_view words) {
  std::vector<std::string_view> items;
  while (!words.empty()) {
    const std::size_t comma = std::min(words.find(", "), words.size());
    items.push_back(words.substr(0, comma));
    words.remove_prefix(std::min(comma + 2, words.size()));
  }
  return items;
}

}  // namespace

bool LimbWorker::rejoin(LimbScan at) {
  const auto told = with_count(at.rest());
  if (!told) return not_understood(at.rest());
  if (!needs_no_stitches() || !needs_fresh_piece()) return false;
  Laying laying;
  laying.rejoins = true;
  if (!lay(told->first, laying)) return false;
  if (laying.order.size() != 1) return fail("yarn is rejoined at one holder.");
  const std::size_t from = laying.order.front();
  if (!empty_holders(laying) || !expect(static_cast<std::int32_t>(laying.loop.size()), told->second))
    return false;
  needle_ = std::move(laying.loop);
  has_needle_ = yarn_ = true;
  whose_ = name_of(from);
  begun_ = from % pieces_.size() == now_;
  return true;
}

bool LimbWorker::loops(LimbScan at) {
  const std::string_view words = at.rest();
  const auto name = at.name();
  if (!name || !at.take(", place its ")) return not_understood(words);
  const auto count = at.number();
  if (!count ||
      !at.take(" loops on the needle; they run the other way. Rejoin yarn at the beginning of the rnd."))
    return not_understood(words);
  const auto stated = at.count_at_end();
  if (!stated) return not_understood(words);
  const auto piece = piece_of(*name);
  if (!piece || !needs_no_stitches() || !needs_fresh_piece()) return false;
  const auto found = waste_.find(*piece);
  if (found == waste_.end()) return fail(name->text() + " has no waste yarn.");
  const auto there = static_cast<std::int32_t>(found->second.size());
  if (!expect(there, *count) || !expect(there, *stated)) return false;
  needle_ = std::move(found->second);
  std::reverse(needle_.begin(), needle_.end());
  waste_.erase(found);
  has_needle_ = yarn_ = begun_ = true;
  return true;
}

namespace {

// "keep 3 sts, place next 7 sts on a holder for Limb B, CO 1 st over gap 1, keep 2 sts. (6 sts; Limb B 7 sts)"
struct Divided {
  std::int32_t before = 0, held = 0, bridge = 0, gap = 0, rest = 0;
  LimbName name, again;
  std::int32_t after = 0, on_holder = 0;
};

// "keep 3 sts"
bool take_kept(LimbScan& at, std::int32_t& kept) {
  const auto count = at.stitches();
  kept = count.value_or(0);
  return kept > 0;
}

bool take_across(LimbScan& at, Divided& told) {
  if (at.take("draw the gap close")) return true;
  if (!at.take("CO ") || !take_kept(at, told.bridge) || !at.take(" over gap ")) return false;
  told.gap = at.number().value_or(0);
  return told.gap > 0;
}

bool take_bracket(LimbScan& at, Divided& told) {
  const auto after = at.take(". (") ? at.stitches() : std::nullopt;
  const auto again = after && at.take("; ") ? at.holder() : std::nullopt;
  const auto held = again && at.take(" ") ? at.stitches() : std::nullopt;
  if (!held || !at.take(")") || !at.done()) return false;
  told.after = *after;
  told.again = *again;
  told.on_holder = *held;
  return true;
}

std::optional<Divided> divided_of(LimbScan at) {
  Divided told;
  if (at.take("keep ") && (!take_kept(at, told.before) || !at.take(", "))) return std::nullopt;
  if (!at.take("place next ") || !take_kept(at, told.held) || !at.take(" on a holder for "))
    return std::nullopt;
  const auto name = at.holder();
  if (!name || !at.take(", ")) return std::nullopt;
  told.name = *name;
  if (!take_across(at, told)) return std::nullopt;
  if (at.take(", keep ") && !take_kept(at, told.rest)) return std::nullopt;
  return take_bracket(at, told) ? std::optional(told) : std::nullopt;
}

}  // namespace

bool LimbWorker::divide(LimbScan at) {
  const auto told = divided_of(at);
  if (!told) return not_understood(at.rest());
  const auto piece = holder_of(told->name);
  if (!piece || !needs_yarn() || !needs_fresh_piece()) return false;
  if (told->again.text() != told->name.text())
    return fail("the sts are held for " + told->name.text() + ", the bracket says " + told->again.text() +
                ".");
  if (told->held != told->on_holder)
    return fail(count_text(told->held) + (told->held == 1 ? " is" : " are") + " held, the bracket says " +
                std::to_string(told->on_holder) + ".");
  if (pieces_[*piece % pieces_.size()].made) return fail(told->name.text() + " is made already.");
  const std::int64_t dealt = std::int64_t{told->before} + told->held + told->rest;
  if (dealt != on_needle())
    return fail(count_text(dealt) + (dealt == 1 ? " is" : " are") + " dealt, " + std::to_string(on_needle()) +
                (on_needle() == 1 ? " is" : " are") + " on the needle.");
  std::optional<Loop> across = Loop{};
  if (told->gap > 0) across = cast_on_gap(told->bridge, told->gap);
  if (!across) return false;
  const auto begin = needle_.begin() + told->before, end = begin + told->held;
  Holder holder;
  for (auto stitch = begin; stitch != end; ++stitch) holder.push_back({*stitch, 0});
  for (std::size_t i = across->size(); i-- > 0;) holder.push_back({(*across)[i], told->gap});
  Loop kept(needle_.begin(), begin);
  kept.insert(kept.end(), across->begin(), across->end());
  kept.insert(kept.end(), end, needle_.end());
  needle_ = std::move(kept);
  begun_ = true;
  whose_ = name_of(now_);
  return hold(*piece, std::move(holder)) && expect(on_needle(), told->after);
}

bool LimbWorker::join(LimbScan at) {
  const std::string_view words = at.rest();
  const auto names = limb_list(at);
  if (!names || !at.take(": ")) return not_understood(words);
  const auto told = with_count(at.rest());
  if (!told) return not_understood(words);
  if (!needs_yarn() || !needs_fresh_piece()) return false;
  std::string wanted, found;
  for (const LimbName& name : *names) {
    const auto piece = holder_of(name);
    if (!piece) return false;
    if (holders_.count(*piece) == 0) return fail("there are no held sts of " + name.text() + ".");
    wanted += (wanted.empty() ? "" : ", ") + name.text();
  }
  Laying laying;
  if (!lay(told->first, laying)) return false;
  for (const std::size_t piece : laying.order) found += (found.empty() ? "" : ", ") + name_of(piece);
  if (found != wanted)
    return fail("the pieces come in the order " + found + ", the line says " + wanted + ".");
  if (laying.kept != needle_.size())
    return fail(std::to_string(laying.kept) + " of " + count_text(on_needle()) + " on the needle are used.");
  if (!empty_holders(laying) || !expect(static_cast<std::int32_t>(laying.loop.size()), told->second))
    return false;
  needle_ = std::move(laying.loop);
  begun_ = true;
  whose_ = name_of(now_);
  return true;
}

bool LimbWorker::empty_holders(const Laying& laying) {
  for (const std::size_t piece : laying.order) {
    const std::size_t there = holders_.at(piece).size(), taken = laying.taking.at(piece).taken;
    if (taken != there)
      return fail("not all of " + name_of(piece) + " is worked: " + std::to_string(taken) + " of " +
                  std::to_string(there) + ".");
  }
  for (const std::size_t piece : laying.order) holders_.erase(piece);
  return true;
}

std::optional<LimbWorker::Loop> LimbWorker::cast_on_gap(std::int32_t count, std::int32_t gap) {
  if (gaps_.count(gap) > 0) {
    fail(gap_text(gap) + " is cast on twice.");
    return std::nullopt;
  }
  if (count > most_stitches) {
    fail("cast on from 1 to " + std::to_string(most_stitches) + " sts.");
    return std::nullopt;
  }
  Loop stitches;
  for (std::int32_t i = 0; i < count; ++i) stitches.push_back(new_stitch({}));
  gaps_[gap] = {stitches, count};
  if (!is_short_enough()) return std::nullopt;
  return stitches;
}

bool LimbWorker::lay(std::string_view items, Laying& laying) {
  const std::vector<std::string_view> all = items_in(items);
  for (std::size_t i = 0; i < all.size(); ++i) {
    laying.ahead.assign(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end());
    if (!lay_item(LimbScan(all[i]), laying)) return false;
  }
  if (laying.open.empty()) return true;
  return fail(gap_text(laying.open.back().first) + " is cast on, not picked up on the way back.");
}

bool LimbWorker::lay_kept(std::int32_t count, Laying& laying) {
  const auto more = static_cast<std::size_t>(count);
  if (laying.kept + more > needle_.size())
    return fail("only " + count_text(on_needle()) + (on_needle() == 1 ? " is" : " are") +
                " on the needle to keep.");
  const auto begin = needle_.begin() + static_cast<std::ptrdiff_t>(laying.kept);
  laying.loop.insert(laying.loop.end(), begin, begin + count);
  laying.kept += more;
  laying.now.reset();
  return true;
}

bool LimbWorker::lay_across(std::int32_t count, std::int32_t gap, Laying& laying) {
  auto stitches = cast_on_gap(count, gap);
  if (!stitches) return false;
  laying.loop.insert(laying.loop.end(), stitches->begin(), stitches->end());
  laying.open.emplace_back(gap, std::move(*stitches));
  laying.before.push_back({laying.kept, laying.loop.size(), laying.taking});
  return true;
}

// A bridge is knit on the way to other loops and on the way back: between, each of these is worked all round, and nothing of
// the loop that it leads from.
bool LimbWorker::parts_no_loop(const Laying& laying, std::int32_t gap) {
  const Laying::Before& before = laying.before.back();
  if (laying.kept != before.kept)
    return fail("sts are kept between the cast on and the pick up of " + gap_text(gap) + ".");
  for (const auto& [piece, taking] : laying.taking) {
    const auto then = before.taking.find(piece);
    const std::size_t all = holders_.at(piece).size(),
                      between = taking.taken - (then == before.taking.end() ? 0 : then->second.taken);
    if (between != 0 && between != all)
      return fail(std::to_string(between) + " of the " + count_text(static_cast<std::int64_t>(all)) + " of " +
                  name_of(piece) + " stand between the cast on and the pick up of " + gap_text(gap) +
                  ": all or none can.");
  }
  return true;
}

bool LimbWorker::lay_item(LimbScan at, Laying& laying) {
  const std::string_view words = at.rest();
  std::int32_t count = 0;
  if (!laying.rejoins && at.take("keep "))
    return take_kept(at, count) && at.done() ? lay_kept(count, laying) : not_understood(words);
  const bool casts_on = !laying.rejoins && at.take("CO ");
  if (casts_on || at.take("pick up ")) {
    const bool told = take_kept(at, count) && at.take(casts_on ? " over gap " : " along gap ");
    const std::int32_t gap = told ? at.number().value_or(0) : 0;
    if (gap < 1 || !at.done()) return not_understood(words);
    return casts_on ? lay_across(count, gap, laying) : lay_gap(count, gap, laying);
  }
  bool told = false;
  if (laying.rejoins) {
    count = at.take("place ") ? at.number().value_or(0) : 0;
    told = count > 0 && at.take(count == 1 ? " held st of " : " held sts of ");
  } else {
    told = take_kept(at, count) && at.take(" of ");
  }
  const auto name = told ? at.holder() : std::nullopt;
  return name ? lay_held(count, *name, at, laying) : not_understood(words);
}

// A gap of this line is picked up from its far end, the last opened first; one cast on before only where its edge lies.
bool LimbWorker::lay_gap(std::int32_t count, std::int32_t gap, Laying& laying) {
  const auto open =
      std::find_if(laying.open.begin(), laying.open.end(), [&](const auto& o) { return o.first == gap; });
  if (open != laying.open.end()) {
    if (open + 1 != laying.open.end())
      return fail(gap_text(gap) + " is picked up before " + gap_text(laying.open.back().first) + ".");
    if (laying.loop.size() == laying.before.back().laid)
      return fail("nothing stands between the cast on and the pick up of " + gap_text(gap) + ".");
    Loop& left = open->second;
    if (count > static_cast<std::int32_t>(left.size()))
      return fail(gap_text(gap) + " has " + count_text(static_cast<std::int64_t>(left.size())) +
                  " to pick up, the line says " + std::to_string(count) + ".");
    laying.loop.insert(laying.loop.end(), left.rbegin(), left.rbegin() + count);
    left.resize(left.size() - static_cast<std::size_t>(count));
    gaps_.at(gap).left -= count;
    if (!left.empty()) return true;
    if (!parts_no_loop(laying, gap)) return false;
    laying.open.pop_back();
    laying.before.pop_back();
    return true;
  }
  if (gaps_.count(gap) == 0) return fail(gap_text(gap) + " was not cast on.");
  const auto piece = edge_of(count, gap, laying);
  if (!piece) return fail(gap_text(gap) + " does not lie here.");
  laying.now = piece;
  const Holder& holder = holders_.at(*piece);
  Taking& taking = laying.taking.at(*piece);
  for (std::int32_t i = 0; i < count; ++i) {
    const Place& place = holder[taking.at];
    if (taking.taken >= holder.size() || place.gap != gap)
      return fail(gap_text(gap) + " does not go on here: " + count_text(count) +
                  (count == 1 ? " was" : " were") + " asked for.");
    laying.loop.push_back(place.stitch);
    taking.at = (taking.at + 1) % holder.size();
    ++taking.taken;
    --gaps_.at(gap).left;
  }
  return true;
}

// The holder on which a gap's edge comes next: one that is taken from already, or one that is entered within that edge, so
// that its held stitches follow when all of the edge that is told before them is picked up; of several the one named next.
std::optional<std::size_t> LimbWorker::edge_of(std::int32_t count, std::int32_t gap, Laying& laying) {
  const auto is_next = [&](std::size_t piece) {
    const Taking& taking = laying.taking.at(piece);
    const Holder& holder = holders_.at(piece);
    return taking.taken < holder.size() && holder[taking.at].gap == gap;
  };
  if (laying.now && is_next(*laying.now)) return laying.now;
  for (const auto& [piece, taking] : laying.taking) {
    if (is_next(piece)) return piece;
  }
  std::size_t edge = static_cast<std::size_t>(count);  // told so far
  const std::string along = " along " + gap_text(gap);
  for (const std::string_view item : laying.ahead) {
    if (item.starts_with("pick up ") && item.ends_with(along))
      edge += static_cast<std::size_t>(LimbScan(item.substr(8)).number().value_or(0));
    const std::size_t of = item.find(" of ");
    const auto name = of == std::string_view::npos ? std::nullopt : LimbScan(item.substr(of + 4)).holder();
    const auto piece = name && known(*name) ? holder_of(*name) : std::nullopt;
    if (!piece || holders_.count(*piece) == 0 || laying.taking.count(*piece) > 0) continue;
    const Holder& holder = holders_.at(*piece);
    const std::size_t n = holder.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (holder[i].gap != gap || holder[(i + 1) % n].gap == gap) continue;
      laying.taking[*piece] = {(i + 1 + n - edge % n) % n, 0};
      return piece;
    }
  }
  return std::nullopt;
}

bool LimbWorker::lay_held(std::int32_t count, const LimbName& name, LimbScan at, Laying& laying) {
  const std::string_view words = at.rest();
  const auto piece = holder_of(name);
  if (!piece) return false;
  const auto holder = holders_.find(*piece);
  if (holder == holders_.end()) return fail("there are no held sts of " + name.text() + ".");
  const auto held = static_cast<std::int32_t>(std::count_if(
      holder->second.begin(), holder->second.end(), [](const Place& place) { return place.gap == 0; }));
  std::int32_t first = 1, last = held;
  if (at.take(" (")) {
    const auto from = at.number();
    const auto to = from && at.take(" to ") ? at.number() : from;
    if (!to || !at.take(")")) return not_understood(words);
    first = *from;
    last = *to;
  }
  if (!(laying.rejoins ? at.take(" on the needle") : true) || !at.done()) return not_understood(words);
  if (first < 1 || first > held || last < 1 || last > held)
    return fail(name.text() + " has " + count_text(held) + " on its holder.");
  if ((last - first + held) % held + 1 != count)
    return fail(std::to_string(first) + " to " + std::to_string(last) + " of " + count_text(held) +
                " are not " + count_text(count) + ".");
  return take_held(count, *piece, first, laying);
}

bool LimbWorker::take_held(std::int32_t count, std::size_t piece, std::int32_t first, Laying& laying) {
  const Holder& holder = holders_.at(piece);
  std::size_t wanted = 0;
  for (std::int32_t before = 0; wanted < holder.size(); ++wanted) {
    if (holder[wanted].gap == 0 && ++before == first) break;
  }
  const auto found = laying.taking.try_emplace(piece, Taking{wanted, 0}).first;
  if (std::find(laying.order.begin(), laying.order.end(), piece) == laying.order.end())
    laying.order.push_back(piece);
  Taking& taking = found->second;
  laying.now = piece;
  if (taking.taken < holder.size() && holder[taking.at].gap > 0)
    return fail("the edge of " + gap_text(holder[taking.at].gap) + " comes first: pick it up.");
  if (taking.at != wanted)
    return fail("st " + std::to_string(first) + " of " + name_of(piece) + " is not next.");
  for (std::int32_t i = 0; i < count; ++i) {
    if (taking.taken >= holder.size()) return fail(name_of(piece) + " has no more sts on its holder.");
    const Place& place = holder[taking.at];
    if (place.gap > 0) return fail("the edge of " + gap_text(place.gap) + " comes first: pick it up.");
    laying.loop.push_back(place.stitch);
    taking.at = (taking.at + 1) % holder.size();
    ++taking.taken;
  }
  return true;
}

// --- grafting ----------------------------------------------------------------------------------------------------

bool LimbWorker::graft(LimbScan at, bool three_needle) {
  const std::string_view words = at.rest();
  const auto name = at.name();
  if (!name || !at.take(" (")) return not_understood(words);
  const auto count = at.stitches();
  if (!count || !at.take("), wrong sides together, its sts backwards from st ")) return not_understood(words);
  const auto first = at.number();
  if (!first || !at.take(" to st ")) return not_understood(words);
  const auto last = at.number();
  if (!last || !at.take(": ")) return not_understood(words);
  std::int32_t slips = 0;
  if (at.take("slip last st back, ")) slips = 1;
  if (slips == 0 && at.take("slip last ")) {
    const auto back = at.stitches();
    if (!back || *back < 2 || !at.take(" back, ")) return not_understood(words);
    slips = *back;
  }
  const std::size_t end = at.rest().rfind(". (0 sts)");
  if (end == std::string_view::npos || end + 9 != at.rest().size()) return not_understood(words);
  const auto piece = piece_of(*name);
  if (!piece || !needs_yarn()) return false;
  const auto holder = holders_.find(*piece);
  if (holder == holders_.end()) return fail("there are no held sts of " + name->text() + ".");
  const auto held = static_cast<std::int32_t>(holder->second.size());
  if (std::any_of(holder->second.begin(), holder->second.end(),
                  [](const Place& place) { return place.gap > 0; }))
    return fail(name->text() + " has the edge of a gap on its holder, which cannot be grafted.");
  if (held != *count)
    return fail(name->text() + " has " + count_text(held) + " held, the line says " + std::to_string(*count) +
                ".");
  if (*first < 1 || *first > held || *last != *first % held + 1)
    return fail("backwards from st " + std::to_string(*first) + " ends at st " +
                std::to_string(*first % held + 1) + ", the line says " + std::to_string(*last) + ".");
  Loop other;
  for (std::int32_t i = 0; i < held; ++i)
    other.push_back(holder->second[static_cast<std::size_t>((*first - 1 - i + held) % held)].stitch);
  if (!finish_piece() || !graft_words(at.rest().substr(0, end), other, slips, three_needle)) return false;
  holders_.erase(holder);
  needle_.clear();
  has_needle_ = yarn_ = false;
  return true;
}

namespace {

struct GraftStep {
  std::int32_t own = 1, others = 1;
};

// "graft 5", "graft 2 to 1", "[graft 1 to 2, graft 3] 4 times"; nothing where it is not understood.
std::optional<std::vector<GraftStep>> graft_steps(std::string_view words) {
  std::vector<GraftStep> steps;
  bool in_block = false;
  std::size_t block = 0;
  LimbScan at(words);
  while (!at.done()) {
    if (!in_block && at.take("[")) {
      in_block = true;
      block = steps.size();
    }
    if (!at.take("graft ")) return std::nullopt;
    const auto count = at.number();
    if (!count || *count < 1 || *count > most_stitches) return std::nullopt;
    if (at.take(" to ")) {
      const auto others = at.number();
      if (!others || *others < 1 || *others > most_stitches) return std::nullopt;
      steps.push_back({*count, *others});
    } else {
      steps.insert(steps.end(), static_cast<std::size_t>(*count), GraftStep{});
    }
    if (in_block && at.take("] ")) {
      const auto times = at.number();
      if (!times || *times < 2 || *times > most_stitches || !at.take(" times")) return std::nullopt;
      const std::vector<GraftStep> again(steps.begin() + static_cast<std::ptrdiff_t>(block), steps.end());
      if (again.size() * static_cast<std::size_t>(*times) > most_stitches) return std::nullopt;
      for (std::int32_t i = 1; i < *times; ++i) steps.insert(steps.end(), again.begin(), again.end());
      in_block = false;
    }
    if (steps.size() > most_stitches || (!at.done() && !at.take(", "))) return std::nullopt;
  }
  if (in_block) return std::nullopt;
  return steps;
}

// "bind off 39 pairs"
std::optional<std::vector<GraftStep>> pair_steps(std::string_view words) {
  LimbScan at(words);
  if (!at.take("bind off ")) return std::nullopt;
  const auto count = at.number();
  if (!count || *count < 1 || *count > most_stitches) return std::nullopt;
  if (!at.take(*count == 1 ? " pair" : " pairs") || !at.done()) return std::nullopt;
  return std::vector<GraftStep>(static_cast<std::size_t>(*count));
}

}  // namespace

bool LimbWorker::graft_words(std::string_view words, const Loop& other, std::int32_t slips,
                             bool three_needle) {
  const auto steps = three_needle ? pair_steps(words) : graft_steps(words);
  const std::string done = three_needle ? " bound off." : " grafted.";
  if (!steps) return not_understood(words);
  if (slips >= on_needle()) return fail("all sts are slipped back.");
  Loop own = needle_;
  std::rotate(own.begin(), own.end() - slips, own.end());
  std::size_t i = 0, k = 0;
  for (const GraftStep& step : *steps) {
    if (step.own > 1 && step.others > 1) return fail("several sts are grafted to several.");
    if (i + static_cast<std::size_t>(step.own) > own.size() ||
        k + static_cast<std::size_t>(step.others) > other.size())
      return fail(three_needle ? "more is bound off than there is." : "more is grafted than there is.");
    for (std::int32_t a = 0; a < step.own; ++a) {
      for (std::int32_t b = 0; b < step.others; ++b)
        read_.grafts.push_back(
            {own[i + static_cast<std::size_t>(a)], other[k + static_cast<std::size_t>(b)]});
    }
    i += static_cast<std::size_t>(step.own);
    k += static_cast<std::size_t>(step.others);
  }
  if (i != own.size())
    return fail(std::to_string(i) + " of " + count_text(on_needle()) + " on the needle are" + done);
  if (k == other.size()) return true;
  return fail(std::to_string(k) + " of the " + count_text(static_cast<std::int64_t>(other.size())) +
              " held are" + done);
}

}  // namespace knit
