// Why a label stands where it stands: the rule that placed it, and the neighbour that decided. Part of causes. Cells and
// stitches count from 1 here, from 0 in a join.
#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "knit/insight/cause_parts.h"
#include "knit/insight/causes.h"

namespace knit {

namespace {

std::string cell_text(std::int32_t cell) { return "cell " + whole_text(cell + 1); }

// A label of a join, and what stands about it.
struct LabelAt {
  const Fabric& fabric;
  const Join& join;
  std::int32_t cell;

  [[nodiscard]] Label label(std::int32_t at) const { return join.labels[static_cast<std::size_t>(at)]; }
  [[nodiscard]] Label label() const { return label(cell); }
  [[nodiscard]] std::int32_t cells() const { return static_cast<std::int32_t>(join.labels.size()); }
  [[nodiscard]] std::int32_t shaping() const { return std::abs(join.change()); }
  // By sections; each brings two at most.
  [[nodiscard]] std::int32_t mains_wanted() const { return (shaping() + 1) / 2; }
  [[nodiscard]] std::int32_t wrapped(std::int32_t at) const { return (at % cells() + cells()) % cells(); }
  [[nodiscard]] LabelAt from(std::int32_t other) const { return {fabric, join, other}; }
  [[nodiscard]] std::ptrdiff_t number_of_mains() const {
    return std::count(join.labels.begin(), join.labels.end(), Label::main);
  }
  // How many cells away the nearest main is, forwards (1) or backwards (-1), from `least` on; 0: there is none.
  [[nodiscard]] std::int32_t to_main(std::int32_t way, std::int32_t least = 1) const {
    for (std::int32_t away = least; away < cells(); ++away) {
      if (label(wrapped(cell + way * away)) == Label::main) return away;
    }
    return 0;
  }
  // Mains of the row below; none known where it is worked on more than one.
  [[nodiscard]] std::vector<std::int32_t> mains_below() const {
    const Row* below = fabric.row_below(join.to);
    const Join* made = below != nullptr ? fabric.join_into(below->id) : nullptr;
    return made != nullptr ? made->mains : std::vector<std::int32_t>{};
  }
  // Whether the stitch below was cast on, so that no main stands there.
  [[nodiscard]] bool on_cast_on() const {
    const StitchRef ref = join.from.at(ends_of(join, cell).below);
    return ref.row > 0 && fabric.join_into(ref.row) == nullptr;
  }
  // The place among the mains of the join, from 0.
  [[nodiscard]] std::int32_t number_of_main() const {
    return static_cast<std::int32_t>(
        std::count(join.labels.begin(), join.labels.begin() + cell, Label::main));
  }
  [[nodiscard]] std::string stitch_below_text(std::int32_t at) const {
    const StitchRef ref = join.from.at(at);
    if (ref.row < 0)
      return "stitch " + whole_text(ref.stitch + 1) + " of the bridge of deal " + whole_text(-ref.row);
    return "stitch " + whole_text(ref.stitch + 1) + " of row " + whole_text(ref.row);
  }
};

std::string change_text(const LabelAt& at) {
  return at.join.change() > 0 ? plural(at.shaping(), "increase", "increases")
                              : plural(at.shaping(), "decrease", "decreases");
}

std::string fallen_back_text(const LabelAt& at) {
  if (!at.join.tried) return "";
  return " The rule " + std::string(name_of(*at.join.tried)) + " was tried first and left too little room.";
}

// By the rule follow: the main of the row below that goes on here.
std::string followed_text(const LabelAt& at) {
  const std::vector<std::int32_t> below = at.mains_below();
  const auto from = static_cast<std::size_t>(at.number_of_main() * at.join.spacing);
  const std::string every =
      at.join.spacing == 1 ? "each main" : "every " + nth_text(at.join.spacing) + " main";
  const std::string head = "Rule R3: " + every + " of the row below goes on, as " +
                           whole_text(at.mains_wanted()) + " are wanted for " + change_text(at);
  if (from >= below.size()) return head + ".";
  const std::int32_t moved = at.cell - below[from];
  const std::string where = "; this one stands on stitch " + whole_text(below[from] + 1) + " there";
  return head + where + (moved > 0 ? ", moved on by the " + whole_text(moved) + " made before it." : ".");
}

std::string main_text(const LabelAt& at) {
  const Join& join = at.join;
  const std::int32_t wanted = at.mains_wanted();
  const std::string are_wanted = whole_text(wanted) +
                                 (wanted == 1 ? " main is wanted for " : " mains are wanted for ") +
                                 change_text(at);
  const std::string had = whole_text(static_cast<std::int64_t>(at.mains_below().size()));
  switch (join.rule) {
    case Rule::from_cast_on:
      return "Rule R0: on the cast on each of its " + whole_text(join.below) +
             " stitches gets a main, and the increases are spread between them.";
    case Rule::plain:
      return "Rule R1: the row has as many stitches as the one below, so its mains stay where they are.";
    case Rule::equal:
      return "Rule R2: " + are_wanted + ", the row below has " + had + ", a multiple; so a main every " +
             plural(join.spacing, "cell", "cells") + " from the first.";
    case Rule::follow:
      return followed_text(at);
    case Rule::remainder_last:
      return "Rule R4: " + are_wanted + ", the row below has " + had + "; so a main every " +
             plural(join.spacing, "cell", "cells") + " from the first" +
             (join.remainder > 0
                  ? ", and what is left over, " + whole_text(join.remainder) + ", on the last spacing."
                  : ".");
    case Rule::dense:
      return "A section had no room for two cells a label, so each stitch of the smaller row gets a main.";
    case Rule::even:
      return are_wanted + ", with sections of the smaller row as even as can be: a main every " +
             plural(join.spacing, "stitch", "stitches") + ".";
    case Rule::repeat:
      return "A rhythm has mains at equal sections, a main every " + plural(join.spacing, "cell", "cells") +
             "; each begins a section, and all sections are worked alike.";
    case Rule::nearest:
      if (at.on_cast_on())
        return "Mains are wales; they are spread evenly over the round that they begin on.";
      return "Mains are wales: it goes on from the one below it, " +
             at.stitch_below_text(ends_of(join, at.cell).below) + ", along its link.";
  }
  return "";
}

// By sections: a main brings a label after it and one before it.
std::string beside_main_text(const LabelAt& at) {
  const bool after = at.label() == Label::m1r || at.label() == Label::ssk;
  const std::int32_t away = at.to_main(after ? -1 : 1);
  const std::string name(name_of(at.label()));
  const std::string head = "The row has " + change_text(at);
  if (away == 0) return head + ".";
  const std::string main = cell_text(at.wrapped(at.cell + (after ? -away : away)));
  if (at.join.rule == Rule::dense || at.join.rule == Rule::from_cast_on)
    return head + ", spread between the mains and leaning in turn; this one comes after the main in " +
           cell_text(at.wrapped(at.cell - at.to_main(-1))) + ".";
  return head + "; " + (after ? "after" : "before") + " a main it is " + name + ": the main in " + main +
         " decided, placed by the rule " + std::string(name_of(at.join.rule)) + ".";
}

// By place: the main nearer to the pair decides; of equally near ones that beside the cell nearer to the shared stitch.
std::string leaning_text(const LabelAt& at, std::int32_t first, std::int32_t second) {
  const std::int32_t behind = at.from(first).to_main(-1, 0), ahead = at.from(second).to_main(1, 0);
  if (at.number_of_mains() == 0) return "";
  const bool leans_back = at.label() == Label::m1r || at.label() == Label::ssk;
  const std::string it = " It is " + std::string(name_of(at.label())) + " because ";
  const std::string b =
      behind == 0 ? cell_text(first) + " itself" : plural(behind, "cell", "cells") + " behind";
  const std::string a =
      ahead == 0 ? cell_text(second) + " itself" : plural(ahead, "cell", "cells") + " ahead";
  if (behind == ahead)
    return it + "of the mains " + a + " and behind, equally near, that on the side of " +
           cell_text(leans_back ? first : second) + " decides, which is nearer to the stitch they share.";
  return it + "the nearer main decides, " + (leans_back ? b + ", not that " + a : a + ", not that " + b) +
         ".";
}

// By place: the stitch that two cells share, and which main is nearer.
std::string shared_text(const LabelAt& at) {
  const Join& join = at.join;
  const auto cell = static_cast<std::size_t>(at.cell);
  const std::int32_t first = std::min(at.cell, join.partner[cell]);
  const std::int32_t second = std::max(at.cell, join.partner[cell]);
  const LiveStitches small = at.fabric.smaller(join), big = at.fabric.larger(join);
  const StitchRef shared = small.at(join.link[cell]);
  const auto away = [&](std::int32_t of) {
    return short_number(glm::distance(at.fabric.position(shared), at.fabric.position(big.at(of))));
  };
  const bool grows = cells_above(join);
  const std::string text = "The stitches of " + std::string(grows ? "this row" : "the row below") +
                           " in cells " + whole_text(first + 1) + " and " + whole_text(second + 1) +
                           " share stitch " + whole_text(shared.stitch + 1) +
                           (grows ? " below" : " of this row") + ", " + away(first) + " and " + away(second) +
                           " away: so the wales are shortest all around (least sum of squares).";
  return text + leaning_text(at, first, second);
}

// In a rhythm: one repeat in every section.
std::string repeated_text(const LabelAt& at) {
  const auto sections = static_cast<std::int32_t>(at.number_of_mains());
  const std::string each = at.shaping() == sections ? "one" : "a pair";
  return "The rhythm has " + change_text(at) + " in this row, " + each + " in each of its " +
         plural(sections, "section", "sections") + ", at the same place in all of them; this one is " +
         std::string(name_of(at.label())) + ".";
}

std::string words_of_label(const LabelAt& at) {
  const bool by_place = at.join.rule == Rule::nearest;
  if (at.label() == Label::main) return main_text(at) + fallen_back_text(at);
  if (is_shaping(at.label()))
    return (by_place                       ? shared_text(at)
            : at.join.rule == Rule::repeat ? repeated_text(at)
                                           : beside_main_text(at)) +
           fallen_back_text(at);
  if (at.join.change() == 0) return "The row has as many stitches as the one below, and no main stands here.";
  for (std::int32_t other = 0; other < at.cells(); ++other) {
    if (other != at.cell && is_shaping(at.label(other)) &&
        at.join.partner[static_cast<std::size_t>(other)] == at.cell)
      return "It works together with the " + std::string(name_of(at.label(other))) + " in " +
             cell_text(other) + "; the label stands there.";
  }
  return "Neither a main nor one of the row's " + change_text(at) + " falls here.";
}

}  // namespace

std::string why_label(const Timeline& timeline, const LabelElement& label) {
  const State& run = timeline.furthest();
  const Join* join = planned_join(run, label.row);
  if (join == nullptr || label.cell < 0 || label.cell >= static_cast<std::int32_t>(join->labels.size()) ||
      join->link.size() != join->labels.size() || join->partner.size() != join->labels.size() ||
      !run.fabric.has_row(label.row))
    return "";
  // Matched where they were placed.
  const Fabric fabric = run.placed ? placed_fabric(run) : run.fabric;
  return words_of_label({fabric, *join, label.cell});
}

}  // namespace knit
