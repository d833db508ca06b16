#include "knit/stitches/index_events.h"

#include "knit/model/words.h"
#include "knit/rows/row_variables.h"
#include "knit/stitches/stitch_variables.h"

namespace knit {

std::string JoinCounted::sentence(const Telling& at) const {
  std::string text = at.row() + ": from " + std::to_string(below) + " to " + stitch_count_text(above) + ", ";
  if (change == 0) return text + "nothing to shape.";
  const std::string what = change > 0 ? plural(change, "increase", "increases")
                                      : plural(-std::int64_t{change}, "decrease", "decreases");
  return text + what + " around " + plural(mains_wanted, "main stitch", "main stitches") +
         "; the row before has " + plural(mains_before, "main", "mains") + ".";
}
StepFields JoinCounted::numbers() const {
  return {{var::below, below},
          {var::above, above},
          {var::change, change},
          {"mains_wanted", &var::wanted, mains_wanted},
          {"mains_before", &var::mains, mains_before}};
}

std::string SpacingChosen::sentence(const Telling& at) const {
  std::string text =
      at.row() + ": " + plural(mains, "main", "mains") + ", spaced by the rule " + std::string(name_of(rule));
  if (spacing > 0)
    text += ", step " + std::to_string(spacing) +
            (remainder > 0 ? ", remainder " + std::to_string(remainder) : "");
  if (fell_back) text += "; " + std::string(name_of(tried)) + " left too little room";
  return text + ".";
}
StepFields SpacingChosen::numbers() const {
  StepFields fields{{var::rule, name_of(rule)},
                    {"mains", &var::mains_set, mains},
                    {var::spacing, spacing},
                    {var::remainder, remainder}};
  if (fell_back) fields.emplace_back(var::tried, name_of(tried));
  return fields;
}

std::string RowsMatched::sentence(const Telling& at) const {
  return at.row() + ": " + plural(links, "link", "links") +
         " join the two rows with the least sum of squares, " + short_number(sum_of_squares) + "; " +
         stitch_count_text(doubled) + (doubled == 1 ? " has" : " have") + " two, and the longest link is " +
         short_number(longest) + ".";
}
StepFields RowsMatched::numbers() const {
  return {{var::links, links},
          {var::doubled, doubled},
          {"sum_of_squares", &var::sum, sum_of_squares},
          {var::longest, longest}};
}

std::string MainPlaced::sentence(const Telling& at) const {
  return at.row() + ": main stitch " + std::to_string(of_mains) + " goes to cell " +
         std::to_string(cell + 1) + ".";
}
StepFields MainPlaced::numbers() const { return {{var::cell, cell}, {var::main, of_mains}}; }

std::string ShapingPlaced::sentence(const Telling& at) const {
  return at.row() + ": " + std::string(name_of(label)) + " goes to cell " + std::to_string(cell + 1) +
         ", working with cell " + std::to_string(partner + 1) + " (" + std::to_string(count) + " placed).";
}
StepFields ShapingPlaced::numbers() const {
  return {{var::label, name_of(label)}, {var::cell, cell}, {var::partner, partner}, {var::placed, count}};
}

std::string TurnPlaced::sentence(const Telling& at) const {
  const std::string where = "cell " + std::to_string(cell + 1);
  if (label == Label::marked)
    return at.row() + ": " + where + " is worked as one with the double stitch or the wrap of a turn.";
  const bool right_side = label == Label::turn_left;
  return at.row() + ": the short row ends on the " + (right_side ? "right" : "wrong") + " side with " +
         where + "; the work is turned there.";
}
StepFields TurnPlaced::numbers() const { return {{var::label, name_of(label)}, {var::cell, cell}}; }

}  // namespace knit
