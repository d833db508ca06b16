// The ways of saying a thing in a written pattern, as published ones have them. A way is a line of text with places: {n} a number,
// {m} one less, {w} a number as a word, {u} the repeated part, {r} the stitches that are left over, {a} and {b} numbers of
// rounds, {x} a name.
#pragma once

#include <string>
#include <vector>

namespace world {

using Ways = std::vector<const char*>;

struct Said {
  Ways times, times_at_end, to_end, to_end_alone, lone_stitch, to_last;  // repeats
  Ways knit_to_end, knit_to_last, knit_to_marker, knit_to_before, knit_some;
  Ways place_marker, slip_marker, evenly, hold, gap, from_holder;
  Ways label, label_range, label_two, label_list, label_alternate, label_none, label_row, label_row_range;
  Ways knit_round, purl_round, as_round, even, even_one;
  Ways again, again_one, again_many, again_last, again_range, again_until, again_until_last;
  Ways close, close_all, put_aside, take_back, cast_on, cast_on_rows, count, count_of_sizes;
};
const Said& ways();

}  // namespace world
