#include "knit/stitches/links.h"

namespace knit {

namespace {

bool follows_main(Label label) { return label == Label::m1r || label == Label::ssk; }

// Partners within one section: its main, then the cells up to the next main.
void pair_section(Join& t, std::size_t main, std::size_t end) {
  std::size_t shaping = 0;
  for (std::size_t cell = main; cell < end; ++cell) shaping += is_shaping(t.labels[cell]) ? 1U : 0U;
  if (shaping == 0) return;
  const bool room = end - main - 1 - shaping >= shaping;
  for (std::size_t cell = main + 1; cell < end; ++cell) {
    if (!is_shaping(t.labels[cell])) continue;
    const bool away_ahead = room && follows_main(t.labels[cell]) && cell + 1 < end;
    t.partner[cell] = static_cast<std::int32_t>(away_ahead ? cell + 1 : cell - 1);
  }
}

}  // namespace

void link_cells(Join& join) {
  const std::size_t cells = join.labels.size();
  join.partner.resize(cells);
  for (std::size_t cell = 0; cell < cells; ++cell) join.partner[cell] = static_cast<std::int32_t>(cell);

  std::size_t main = 0;
  for (std::size_t cell = 1; cell <= cells; ++cell) {
    if (cell < cells && join.labels[cell] != Label::main) continue;
    pair_section(join, main, cell);
    main = cell;
  }
  link_by_partners(join);
}

void link_by_partners(Join& join) {
  join.link.resize(join.labels.size());
  std::int32_t stitch = 0;
  for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
    if (is_shaping(join.labels[cell])) continue;
    join.link[cell] = stitch++;
  }
  for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
    if (is_shaping(join.labels[cell]))
      join.link[cell] = join.link[static_cast<std::size_t>(join.partner[cell])];
  }
}

}  // namespace knit
