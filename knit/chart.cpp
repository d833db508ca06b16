#include "knit/chart.h"

#include "knit/wales.h"

namespace knit {

namespace {

ChartSymbol symbol_of(Hand hand) {
  switch (hand) {
    case Hand::m1r:
      return ChartSymbol::m1r;
    case Hand::m1l:
      return ChartSymbol::m1l;
    case Hand::k2tog:
      return ChartSymbol::k2tog;
    case Hand::ssk:
      return ChartSymbol::ssk;
    case Hand::knit:
      break;
  }
  return ChartSymbol::knit;
}

class ChartMaker {
 public:
  explicit ChartMaker(const Rounds& rounds)
      : rounds_(rounds), wales_(wales_of(rounds)), columns_(columns_of(wales_)) {}

  [[nodiscard]] Chart make() const {
    Chart chart{columns_.width, {cast_on()}};
    for (std::size_t row = 1; row < wales_.rows.size(); ++row) chart.rows.push_back(worked(row));
    chart.rows.push_back(bind_off());
    return chart;
  }

 private:
  // One of these for every stitch of a row; mains as in the round that makes row `mains_of`.
  [[nodiscard]] ChartRow all_alike(std::size_t row, ChartSymbol symbol, std::size_t mains_of) const {
    const std::vector<std::uint8_t> main = main_wales(mains_of);
    ChartRow made{1, static_cast<std::int32_t>(wales_.rows[row].size()), {}};
    made.squares.resize(static_cast<std::size_t>(columns_.width));
    std::int32_t stitch = 0;
    for (const Wale wale : wales_.rows[row]) {
      const auto w = static_cast<std::size_t>(wale);
      made.squares[static_cast<std::size_t>(columns_.of[w])] = {symbol, main[w] != 0, stitch++};
    }
    return made;
  }

  [[nodiscard]] std::vector<std::uint8_t> main_wales(std::size_t row) const {
    std::vector<std::uint8_t> main(columns_.of.size(), 0);
    if (row == 0 || row >= wales_.rows.size()) return main;
    const std::vector<Operation>& operations = rounds_.rounds[row - 1].operations;
    for (std::size_t i = 0; i < operations.size(); ++i)
      main[static_cast<std::size_t>(wales_.rows[row][i])] = operations[i].at_main ? 1 : 0;
    return main;
  }

  [[nodiscard]] ChartRow worked(std::size_t row) const {
    const Round& round = rounds_.rounds[row - 1];
    ChartRow made = all_alike(row, ChartSymbol::knit, row);
    made.number = round.number;
    for (ChartSquare& square : made.squares) {
      if (square.stitch >= 0)
        square.symbol = symbol_of(round.operations[static_cast<std::size_t>(square.stitch)].hand);
    }
    return made;
  }

  // The cast on has no mains yet, so the first round's are shown.
  [[nodiscard]] ChartRow cast_on() const { return all_alike(0, ChartSymbol::cast_on, 1); }
  [[nodiscard]] ChartRow bind_off() const {
    const std::size_t last = wales_.rows.size() - 1;
    ChartRow made = all_alike(last, ChartSymbol::bind_off, last);
    made.number = rounds_.rounds.empty() ? 2 : rounds_.rounds.back().number + 1;
    made.stitches = 0;
    return made;
  }

  const Rounds& rounds_;
  Wales wales_;
  WaleColumns columns_;
};

}  // namespace

Chart chart_of(const Rounds& rounds) { return ChartMaker(rounds).make(); }

}  // namespace knit
