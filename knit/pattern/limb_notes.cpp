#include "knit/pattern/limb_notes.h"

#include <algorithm>

#include "knit/model/words.h"
#include "knit/pattern/limb_groups.h"
#include "knit/pattern/limb_needle.h"
#include "knit/pattern/limb_overview.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/yarn.h"

namespace knit {

namespace {

bool has_deal(const LimbPlan& plan, LimbDealKind kind) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [&](const LimbPiece& piece) {
    return std::any_of(piece.deals.begin(), piece.deals.end(),
                       [&](const LimbDeal& deal) { return deal.kind == kind; });
  });
}

// The most stitches that wait on one thread.
std::int32_t longest_wait(const LimbPlan& plan) {
  std::int32_t most = 0;
  for (const LimbPiece& piece : plan.pieces) {
    if (piece.end.kind == LimbEndKind::held) most = std::max(most, piece.last_count());
    for (const LimbDeal& deal : piece.deals) {
      most = std::max(most, deal.held);
      const bool all = deal.kind == LimbDealKind::provisional || deal.kind == LimbDealKind::set_aside;
      if (all) most = std::max(most, deal.after);
    }
  }
  return most;
}

// Stitches that wait on a thread take about their own width of it, and an end to tie.
std::string waste_yarn_line(const LimbPlan& plan, const PatternSizes& sizes, std::int32_t holders) {
  constexpr double gauge_cm = 10.0, end_cm = 20.0, cm_in_m = 100.0;
  const bool provisional = has_deal(plan, LimbDealKind::provisional);
  const double wide_cm = longest_wait(plan) * gauge_cm / sizes.gauge.stitches;
  const double metres = (holders + (provisional ? 1 : 0)) * (wide_cm + end_cm) / cm_in_m;
  std::string line = "Waste yarn, smooth and in another colour, about " +
                     std::to_string(static_cast<int>(metres) + 1) + " m";
  if (provisional && holders == 0) return line + ": for the provisional cast on.";
  line += ": a length of it with a tapestry needle does instead of a holder";
  return line + (provisional ? ", and it is needed for the provisional cast on." : ".");
}

std::string count_words(std::size_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

void add_holder_lines(const LimbPlan& plan, const PatternSizes& sizes, std::vector<std::string>& lines) {
  const std::int32_t holders = holders_needed(plan);
  if (holders > 0)
    lines.push_back("Stitch holders: " + std::to_string(holders) + "; as many are in use at once.");
  if (holders > 0 || has_deal(plan, LimbDealKind::provisional))
    lines.push_back(waste_yarn_line(plan, sizes, holders));
}

void add_marker_lines(const LimbPlan& plan, const Used& used, std::vector<std::string>& lines) {
  lines.push_back(marker_line(used));
  const std::size_t late = second_markers(plan).size();
  const std::int32_t holders = holders_needed(plan);
  if (holders > 0)
    lines.push_back("Removable markers: " + std::to_string(holders) + ", one for each holder" +
                    (late > 0 ? ", and one in another colour: a second marker is asked for " +
                                    (late == 1 ? "once" : std::to_string(late) + " times") + "."
                              : "."));
  if (!plan.gaps.empty())
    lines.push_back("Short threads to mark " + count_words(plan.gaps.size(), "gap", "gaps") + ".");
}

}  // namespace

bool is_stuffed(const LimbPlan& plan) {
  return std::all_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    const bool closed = piece.end.kind != LimbEndKind::closed || is_drawn_in(piece.last_count());
    const bool begun = piece.deals.front().kind != LimbDealKind::cast_on || is_drawn_in(piece.first_count());
    return closed && begun && !piece.inner;
  });
}

namespace {

bool is_grafted(const LimbPiece& piece) {
  return piece.end.kind == LimbEndKind::grafted && !piece.end.three_needle;
}

// Whether an inner tube closes a space between itself and the outside.
bool has_lining(const LimbPlan& plan) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [&](const LimbPiece& piece) {
    return piece.end.kind == LimbEndKind::grafted && (piece.inner || plan.piece(piece.end.piece).inner);
  });
}

}  // namespace

std::string worked_in(const LimbPlan& plan) {
  return plural(plan.count(), "piece", "pieces") + ", one after the other, from A to " +
         tube_name(plan.count() - 1);
}

std::string size_of_limbs(const PatternSizes& sizes, std::optional<double> height_cm) {
  const std::string around = length_text(sizes.around_cm) + " around at the widest rnd";
  const std::string high = height_cm ? "About " + length_text(*height_cm) + " high as it stands; " : "About ";
  return high + around + "." + std::string(where_sizes_stand);
}

std::vector<std::string> materials_of_limbs(const LimbPlan& plan, const PatternSizes& sizes,
                                            const PatternOptions& options, const Used& used) {
  std::vector<std::string> lines{yarn_line(sizes, options)};
  lines.push_back("Needles: " + needle_text(needle_of(sizes.gauge, options)) +
                  ", or the size that gives the gauge: a set of five double-pointed" +
                  (needs_circular(sizes) ? " and, for the wide parts, a 40 cm (16 in) circular." : "."));
  if (std::any_of(plan.pieces.begin(), plan.pieces.end(),
                  [](const LimbPiece& piece) { return piece.end.three_needle; }))
    lines.emplace_back("A third needle of that size, for the three-needle bind off.");
  add_holder_lines(plan, sizes, lines);
  if (is_stuffed(plan))
    lines.emplace_back("Stuffing.");
  else if (has_lining(plan))
    lines.emplace_back("Stuffing, if the space between inside and outside shall be filled.");
  add_marker_lines(plan, used, lines);
  lines.emplace_back("Tapestry needle.");
  return lines;
}

namespace {

// A span in brackets stands where a holder is entered elsewhere than at its first stitch.
const LimbItem* entered_late(const LimbPlan& plan) {
  for (const LimbPiece& piece : plan.pieces) {
    for (const LimbDeal& deal : piece.deals) {
      for (const LimbItem& item : deal.items) {
        if (item.kind == LimbItemKind::take && item.first > 0 && item.count == item.held) return &item;
      }
    }
  }
  return nullptr;
}

// The first that takes fewer stitches than are held; null: none does.
const LimbItem* takes_a_portion(const LimbPlan& plan) {
  for (const LimbPiece& piece : plan.pieces) {
    for (const LimbDeal& deal : piece.deals) {
      for (const LimbItem& item : deal.items) {
        if (item.kind == LimbItemKind::take && item.count < item.held) return &item;
      }
    }
  }
  return nullptr;
}

bool any_slip(const LimbPlan& plan) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return std::any_of(piece.rounds.begin(), piece.rounds.end(),
                       [](const LimbRound& r) { return r.slips_back; }) ||
           piece.end.slips_back > 0;
  });
}

void add_marker_notes(const LimbPlan& plan, const LimbNames& names, std::vector<std::string>& notes) {
  if (holders_needed(plan) > 0)
    notes.emplace_back(
        "\"On a holder\": slip the sts, unworked, on to a stitch holder or a length of waste yarn; they wait "
        "there. "
        "Hang a removable marker before the first of them: the first st of the rnd or, where a needle is "
        "divided, the "
        "first that is placed. Held sts are counted from there.");
  if (const LimbItem* late = entered_late(plan)) {
    const std::string first = std::to_string(late->first + 1), last = std::to_string(late->first);
    notes.push_back("\"" + stitches_text(late->count) + " of " + names(late->piece) + " (" + first + " to " +
                    last + ")\": begin at the second marker, which hangs before held st " + first +
                    ", and go round to st " + last + ", so that all of them are worked.");
  }
  if (const LimbItem* portion = takes_a_portion(plan)) {
    const std::string first = std::to_string(portion->first + 1),
                      last = std::to_string((portion->first + portion->count - 1) % portion->held + 1);
    notes.push_back("Fewer held sts than all, as of " + names(portion->piece) + " (" + first +
                    (portion->count > 1 ? " to " + last : "") +
                    "): those by number, counted from its marker.");
  }
  if (any_slip(plan))
    notes.emplace_back(
        "\"Slip last st back\": put the last st of the rnd before back on the left needle; the marker moves "
        "with it.");
}

// Whether stitches are put on a holder that were cast on over a gap just before.
bool gap_goes_on_holder(const LimbPlan& plan) {
  const std::vector<PieceNeedle> needles = needles_of(plan);
  return std::any_of(needles.begin(), needles.end(), [](const PieceNeedle& needle) {
    return std::any_of(needle.begin.begin(), needle.begin.end(), [](const NeedleStitch& stitch) {
      return stitch.use == NeedleUse::taken && stitch.gap > 0;
    });
  });
}

// Whether a gap is cast on and picked up in one line.
bool one_join_does_both(const LimbPlan& plan) {
  const auto both = [](const LimbDeal& deal) {
    return std::any_of(deal.items.begin(), deal.items.end(), [&](const LimbItem& cast) {
      return cast.kind == LimbItemKind::cast_on &&
             std::any_of(deal.items.begin(), deal.items.end(), [&](const LimbItem& picked) {
               return picked.kind == LimbItemKind::pick_up && picked.gap == cast.gap;
             });
    });
  };
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [&](const LimbPiece& piece) {
    return std::any_of(piece.deals.begin(), piece.deals.end(), both);
  });
}

void add_gap_notes(const LimbPlan& plan, std::vector<std::string>& notes) {
  if (plan.gaps.empty()) return;
  notes.emplace_back(
      "\"CO 2 sts over gap 1\": when Rnd 1 comes to the gap, cast the sts on to the left needle (knitted "
      "cast "
      "on) and knit on over them. Hang a thread in each gap to know it by." +
      std::string(gap_goes_on_holder(plan)
                      ? " If gap sts go on a holder before that, cast them on with a spare end of "
                        "yarn."
                      : ""));
  notes.emplace_back(
      "\"Pick up 2 sts along gap 1\": lift one loop of that cast-on edge onto the needle for each st, "
      "without knitting; the next rnd works them. Each gap is cast on once and picked up once, so it closes "
      "without a hole." +
      std::string(one_join_does_both(plan)
                      ? " Where one Join has both for the same gap, do each as Rnd 1 comes "
                        "to it."
                      : ""));
}

void add_graft_notes(const LimbPlan& plan, const LimbNames& names, std::vector<std::string>& notes) {
  const auto grafted = std::find_if(plan.pieces.begin(), plan.pieces.end(), is_grafted);
  if (grafted == plan.pieces.end()) return;
  const std::int32_t held = plan.piece(grafted->end.piece).last_count(), first = grafted->end.other_first;
  notes.push_back(
      "\"Graft\": break the yarn, leaving four times the length of the seam, and join the sts of the needle "
      "to the held ones with a tapestry needle (kitchener stitch), as if one more rnd were knit between "
      "them. \"Backwards from st " +
      std::to_string(first + 1) + "\": the first st on the needle meets held st " +
      std::to_string(first + 1) + " of " + names(grafted->end.piece) + ", the next one held st " +
      std::to_string((first + held - 1) % held + 1) + ", and so on round.");
  const bool uneven = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return is_grafted(piece) && !std::all_of(piece.end.grafts.begin(), piece.end.grafts.end(),
                                             [](const LimbGraft& graft) { return graft == LimbGraft{}; });
  });
  if (uneven)
    notes.emplace_back(
        "\"Graft 7\": 7 sts, each to one. \"Graft 1 to 2\": 1 st of the needle to 2 held ones, taken "
        "together as if they were one; \"graft 2 to 1\": 2 of the needle to 1 held one.");
}

void add_piece_notes(const LimbPlan& plan, std::vector<std::string>& notes) {
  if (has_deal(plan, LimbDealKind::provisional))
    notes.emplace_back(
        "A provisional cast on leaves live loops on waste yarn. The other piece of the ring begins on them.");
  const bool copies = [&] {
    for (std::int32_t i = 0; i < plan.count(); ++i) {
      if (model_of(plan, i).twin >= 0) return true;
    }
    return false;
  }();
  if (copies)
    notes.emplace_back(
        "\"Work as for\": the same rnds, with the same numbers, as of the piece that is named.");
  if (has_deal(plan, LimbDealKind::join))
    notes.emplace_back(
        "To join, lay the pieces side by side, untwisted, right sides out, and slip the held sts on to "
        "double-pointed needles in the order that is told, beginning at the marker; then knit Rnd 1 over all "
        "of them.");
  const bool tiny = std::any_of(plan.pieces.begin(), plan.pieces.end(),
                                [](const LimbPiece& piece) { return piece.round_count() <= 2; });
  if (tiny)
    notes.emplace_back(
        "A piece of one or two rnds is no mistake: two limbs begin or meet there, one right above the "
        "other.");
}

}  // namespace

std::vector<std::string> notes_of_limbs(const LimbPlan& plan, const LimbNames& names, const Used& used) {
  std::vector<std::string> notes{"Worked in the round, right side out, in " + worked_in(plan) +
                                     ". Every rnd begins at the marker, which stays where the yarn hangs; "
                                     "slip it as you come to it. Rnds are numbered "
                                     "from 1 in each piece; a cast on counts as a rnd.",
                                 "The number in parentheses at the end of a line is how many sts are on the "
                                 "needle after it. What stands in parentheses by "
                                 "itself is a remark."};
  notes.emplace_back(
      "Lines that begin with Divide, Join or Rejoin knit nothing. They list, from the marker on, the sts "
      "that "
      "Rnd 1 is then worked over; \"keep\" means that sts stay on the needle. Where a line says Rejoin yarn, "
      "a "
      "new yarn is joined before the first st of its list, and the marker goes there.");
  add_gap_notes(plan, notes);
  add_marker_notes(plan, names, notes);
  add_graft_notes(plan, names, notes);
  add_piece_notes(plan, notes);
  const bool tight = std::any_of(plan.pieces.begin(), plan.pieces.end(), [](const LimbPiece& piece) {
    return piece.is_cast_on() && !piece.rounds.empty() && piece.rounds.front().after > piece.first_count();
  });
  add_shaping_notes(used, tight, notes);
  add_short_row_notes(used, notes);
  return notes;
}

std::vector<std::string> finishing_of_limbs(const LimbPlan& plan, const LimbNames& names) {
  std::vector<std::int32_t> drawn, open;
  for (std::int32_t i = 0; i < plan.count(); ++i) {
    if (plan.piece(i).deals.front().kind == LimbDealKind::cast_on)
      (is_drawn_in(plan.piece(i).first_count()) ? drawn : open).push_back(i);
  }
  std::vector<std::string> lines;
  if (!drawn.empty())
    lines.push_back(
        names.listed(drawn) +
        ": if it is not done yet, thread the cast-on tail through the sts of the cast-on edge, pull the "
        "hole shut and fasten off.");
  if (!open.empty())
    lines.push_back(names.listed(open) + (open.size() > 1 ? ", each" : "") +
                    ": the cast-on edge stays open.");
  lines.emplace_back("Weave in all ends; close small holes beside the gaps with them.");
  return lines;
}

bool is_put_inside(const LimbPlan& plan, std::int32_t piece) {
  const auto meets = [&](const LimbPiece& other) {
    return other.end.kind == LimbEndKind::grafted &&
           (&other == &plan.piece(piece) || other.end.piece == piece);
  };
  return begins_alone(plan.piece(piece)) && std::any_of(plan.pieces.begin(), plan.pieces.end(), meets);
}

std::vector<std::string> seam_remarks(const LimbPlan& plan, const LimbNames& names, std::int32_t piece) {
  const LimbEnd& end = plan.piece(piece).end;
  if (end.kind != LimbEndKind::grafted) return {};
  std::vector<std::string> remarks;
  const std::int32_t inner = plan.piece(piece).inner ? piece : plan.piece(end.piece).inner ? end.piece : -1;
  if (inner >= 0)
    remarks.push_back(
        (is_put_inside(plan, inner) ? "Turn " + names(inner) + " inside out and put it inside"
                                    : "Push " + names(inner) + " to the inside") +
        ", wrong sides together; stuff the space between, if you like, before the last sts are " +
        (end.three_needle ? "bound off." : "grafted."));
  const bool one_by_one = std::all_of(end.grafts.begin(), end.grafts.end(),
                                      [](const LimbGraft& graft) { return graft == LimbGraft{}; });
  if (end.three_needle)
    remarks.emplace_back(
        "Hold both needles side by side. With a third needle knit the first st of the front one together "
        "with "
        "the first of the back one, then the next two, and pass the first new st over the second; so on to "
        "the end. The ridge stays outside.");
  else if (plan.three_needle)
    remarks.emplace_back(
        "Here the sts do not pair one by one, so they are grafted: a three-needle bind off would pucker.");
  else if (one_by_one)
    remarks.emplace_back(
        "The sts pair one by one: a three-needle bind off joins them too, in place of the graft; it leaves a "
        "ridge.");
  return remarks;
}

}  // namespace knit
