#include "knit/stitches/appendix.h"

#include <algorithm>

namespace knit {

std::vector<LabelRow> appendix_view(std::int32_t cast_on, std::span<const Join* const> joins, bool complete,
                                    std::int32_t first) {
  std::vector<LabelRow> view;
  const auto cast = [](std::int32_t size) {
    return std::vector<Label>(static_cast<std::size_t>(size), Label::cast);
  };
  view.push_back({first, std::nullopt, cast(cast_on)});
  for (std::size_t i = 0; i < joins.size(); ++i) {
    const Join& t = *joins[i];
    const bool last = complete && i + 1 == joins.size();
    if (t.change() < 0) {
      // Decreases are labelled in the row they start from: in its own list where that is plain.
      const bool plain_below = i > 0 && joins[i - 1]->change() <= 0;
      if (plain_below) {
        view.back().labels = t.labels;
      } else {
        view.push_back({view.back().row, t.to, t.labels});
      }
      std::vector<Label> carried(static_cast<std::size_t>(t.above), Label::knit);
      for (const std::int32_t main : t.mains) carried[static_cast<std::size_t>(main)] = Label::main;
      view.push_back({t.to, std::nullopt, last ? cast(t.above) : std::move(carried)});
    } else {
      view.push_back({t.to, std::nullopt, last && t.change() == 0 ? cast(t.above) : t.labels});
    }
  }
  std::erase_if(view, [](const LabelRow& row) { return row.row == 0 && !row.into; });
  return view;
}

namespace {

LabelRow labels_of_short(const Fabric& fabric, const Row& row, RowId on, std::int32_t number) {
  LabelRow made{on, std::nullopt, {}};
  if (const Join* join = fabric.join_into(row.id)) made.labels = join->labels;
  const std::int32_t all = size_of(fabric.row(on));
  const std::int32_t first = fabric.under_short_rows(row.on).at(0).stitch,
                     last = first + static_cast<std::int32_t>(row.stitches.size()) - 1;
  const std::int32_t begins = row.turned->back ? last : first;
  made.at = last < all ? begins : begins - all;
  if (row.turned->back) std::reverse(made.labels.begin(), made.labels.end());
  made.short_row = number;
  return made;
}

}  // namespace

void add_short_rows(const Fabric& fabric, TubeId tube, std::vector<LabelRow>& view) {
  std::vector<std::int32_t> numbers{0};  // of each row: less the short rows up to it
  std::int32_t shorts = 0, in_gap = 0;
  RowId on = 0;
  for (const auto& row : fabric.rows()) {
    shorts += is_short(*row) ? 1 : 0;
    numbers.push_back(row->id - shorts);
    if (row->tube != tube) continue;
    if (!is_short(*row)) {
      on = row->id;
      in_gap = 0;
      continue;
    }
    const auto behind =
        std::find_if(view.rbegin(), view.rend(), [&](const LabelRow& l) { return l.row == on; });
    // Labels come with the stage of the stitches.
    if (fabric.join_into(row->id) != nullptr && behind != view.rend())
      view.insert(behind.base(), labels_of_short(fabric, *row, on, ++in_gap));
  }
  for (LabelRow& row : view) {
    row.row = numbers[static_cast<std::size_t>(row.row)];
    if (row.into) row.into = numbers[static_cast<std::size_t>(*row.into)];
  }
}

std::string text_of(const LabelRow& row) {
  std::string text = row.row > 0 ? std::to_string(row.row) : "";
  if (row.into) text += (text.empty() ? "> " : " > ") + std::to_string(*row.into);
  if (row.short_row > 0) text += "." + std::to_string(row.short_row) + " @" + std::to_string(row.at);
  text += ": [";
  for (std::size_t i = 0; i < row.labels.size(); ++i) {
    if (i > 0) text += ", ";
    text += std::to_string(static_cast<int>(row.labels[i]));
  }
  return text + "]";
}

}  // namespace knit
