#include "knit/pattern/chart.h"

#include <algorithm>
#include <utility>

#include "knit/model/words.h"
#include "knit/pattern/passes.h"
#include "knit/pattern/wales.h"

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
  ChartMaker(const Rounds& rounds, const std::vector<std::uint8_t>& slips_back)
      : rounds_(rounds), wales_(wales_of(rounds, slips_back)), columns_(columns_of(wales_)) {
    for (const Round& round : rounds.rounds) made_by_.push_back(&round);
  }

  [[nodiscard]] Chart make() {
    marked_.assign(columns_.of.size(), 0);
    Chart chart{columns_.width, {cast_on()}};
    for (std::size_t row = 1; row < wales_.rows.size(); ++row) add_round(row, chart);
    chart.rows.push_back(bind_off());
    return chart;
  }

 private:
  // A mark stays on its wale until that is worked: in a later short row, in the round, or in the next one.
  void add_round(std::size_t row, Chart& chart) {
    ChartRow round = worked(row);
    const Round& worked_round = *made_by_[row];
    if (worked_round.pairs.empty()) {
      for (std::size_t i = 0; i < wales_.rows[row].size(); ++i) work_mark(row, i, round);
    } else {
      std::int32_t number = 0;
      std::size_t made = 0;
      std::vector<std::int32_t> heights(stitches_below(row).size(), 0);
      for (const Pass& pass : passes_of(worked_round)) {
        ChartRow short_row = blank(row, number + 1, pass.wrong_side());
        bool any = false;
        for (const PassStitch& stitch : pass.stitches) {
          if (!stitch.in_short_row) {
            work_mark(row, made++, round);
            continue;
          }
          any = true;
          ChartSquare& square = square_of(row, stitch.column, short_row);
          square.symbol = take_mark(wale_below(row, stitch.column)) ? ChartSymbol::marked : ChartSymbol::knit;
          square.stitch = stitch.column + (stitch.column < 0 ? worked_round.before : 0);
          square.height = heights[static_cast<std::size_t>(square.stitch)]++;
        }
        if (pass.turns()) turn(row, pass, short_row);
        if (!any) continue;
        if (pass.turns()) {
          ++number;
        } else {
          short_row.home = true;
          short_row.short_row = number;
        }
        chart.rows.push_back(std::move(short_row));
      }
    }
    chart.rows.push_back(std::move(round));
  }

  [[nodiscard]] const std::vector<Wale>& stitches_below(std::size_t made) const {
    return wales_.rows[made - 1];
  }
  [[nodiscard]] std::size_t wale_below(std::size_t row, std::int32_t column) const {
    const std::vector<Wale>& below = stitches_below(row);
    const auto count = static_cast<std::int32_t>(below.size());
    return static_cast<std::size_t>(below[static_cast<std::size_t>((column + count) % count)]);
  }
  [[nodiscard]] ChartSquare& square_of(std::size_t row, std::int32_t column, ChartRow& short_row) const {
    return short_row.squares[static_cast<std::size_t>(columns_.of[wale_below(row, column)])];
  }
  [[nodiscard]] ChartRow blank(std::size_t row, std::int32_t number, bool wrong_side) const {
    ChartRow made{made_by_[row]->number, static_cast<std::int32_t>(stitches_below(row).size()), {}};
    made.squares.resize(static_cast<std::size_t>(columns_.width));
    made.short_row = number;
    made.wrong_side = wrong_side;
    return made;
  }
  bool take_mark(std::size_t wale) { return std::exchange(marked_[wale], std::uint8_t{0}) != 0; }
  void work_mark(std::size_t row, std::size_t stitch, ChartRow& round) {
    const auto wale = static_cast<std::size_t>(wales_.rows[row][stitch]);
    ChartSquare& square = round.squares[static_cast<std::size_t>(columns_.of[wale])];
    if (take_mark(wale) && square.symbol == ChartSymbol::knit) square.symbol = ChartSymbol::marked;
  }
  // The stitch beyond the row is marked; there stands the hook.
  void turn(std::size_t row, const Pass& pass, ChartRow& short_row) {
    const std::int32_t beyond = pass.stitches.back().column + (pass.wrong_side() ? -1 : 1);
    marked_[wale_below(row, beyond)] = 1;
    square_of(row, beyond, short_row).symbol =
        pass.wrong_side() ? ChartSymbol::turn_right : ChartSymbol::turn_left;
  }

  // One of these for every stitch of a row; mains as in the round that makes row `mains_of`.
  [[nodiscard]] ChartRow all_alike(std::size_t row, ChartSymbol symbol, std::size_t mains_of) const {
    const std::vector<std::uint8_t> main = main_wales(mains_of);
    ChartRow made{1, static_cast<std::int32_t>(wales_.rows[row].size()), {}};
    made.squares.resize(static_cast<std::size_t>(columns_.width));
    std::int32_t stitch = 0;
    for (const Wale wale : wales_.rows[row]) {
      const auto w = static_cast<std::size_t>(wale);
      made.squares[static_cast<std::size_t>(columns_.of[w])] = {symbol, main[w] != 0, stitch++, -1};
    }
    return made;
  }

  [[nodiscard]] std::vector<std::uint8_t> main_wales(std::size_t row) const {
    std::vector<std::uint8_t> main(columns_.of.size(), 0);
    const Round* round = row < made_by_.size() ? made_by_[row] : nullptr;
    if (round == nullptr) return main;
    const std::vector<Operation>& operations = round->operations;
    for (std::size_t i = 0; i < operations.size(); ++i)
      main[static_cast<std::size_t>(wales_.rows[row][i])] = operations[i].at_main ? 1 : 0;
    return main;
  }

  [[nodiscard]] ChartRow worked(std::size_t row) const {
    const Round& round = *made_by_[row];
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
  std::vector<std::uint8_t> marked_;            // per wale
  std::vector<const Round*> made_by_{nullptr};  // each row; the cast on by none
};

}  // namespace

Chart chart_of(const Rounds& rounds, const std::vector<std::uint8_t>& slips_back) {
  Chart chart = ChartMaker(rounds, slips_back).make();
  std::size_t row = 0;
  for (const std::uint8_t slips : slips_back) {
    do ++row;
    while (chart.rows[row].short_row != 0);
    chart.rows[row].slips_back = slips != 0;
  }
  return chart;
}

std::string name_of(const ChartRow& row) {
  if (row.home) return "next";
  if (row.short_row > 0) return "s" + std::to_string(row.short_row);
  return std::to_string(row.number) + (row.slips_back ? " <" : "");
}

namespace {

constexpr const char* how_to_read =
    "Read from the bottom up, every round from right to left. At the right stands the round's\n"
    "number, at the left how many stitches there are after it.\n";

constexpr const char* how_short_rows_read =
    "     s1    a short row before the round above it, worked from the side\n"
    "           where its number stands: on the WS from left to right\n";

constexpr const char* how_ways_home_read = "     next  on from the last turn to the beginning of the round\n";

std::string right_aligned(const std::string& words, std::size_t width) {
  return std::string(width - std::min(width, words.size()), ' ') + words;
}

// The squares of a row as they lie on paper: the first worked at the right.
std::string squares_of(const ChartRow& row) {
  std::string text;
  for (std::size_t column = row.squares.size(); column-- > 0;) {
    const ChartSquare& square = row.squares[column];
    text += square.symbol == ChartSymbol::held ? tube_name(square.piece).back() : sign_of(square.symbol).sign;
  }
  return text;
}

// The number of every tenth column, counted from the right as rounds are worked.
std::string ruler_of(const Chart& chart) {
  std::string line(static_cast<std::size_t>(chart.columns), ' ');
  for (std::int32_t column = 10; column <= chart.columns; column += 10) {
    const std::string number = std::to_string(column);
    const auto at = static_cast<std::size_t>(chart.columns - column);
    for (std::size_t i = 0; i < number.size() && at + i < line.size(); ++i) line[at + i] = number[i];
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string too_wide(const Chart& chart) {
  return "The chart is " + std::to_string(chart.columns) +
         " squares wide, too wide for text. Save it as a drawing: in the menu\n"
         "File, Save the chart, or on the command line --save-chart chart.svg.\n";
}

}  // namespace

const ChartSign& sign_of(ChartSymbol symbol) {
  return *std::find_if(chart_signs.begin(), chart_signs.end(),
                       [&](const ChartSign& sign) { return sign.symbol == symbol; });
}

std::string chart_grid(const Chart& chart) {
  std::size_t counts = 0;
  for (const ChartRow& row : chart.rows) {
    counts = std::max(counts, std::to_string(row.stitches).size());
    if (row.wrong_side) counts = std::max(counts, name_of(row).size());
  }
  std::string text;
  for (std::size_t i = chart.rows.size(); i-- > 0;) {
    const ChartRow& row = chart.rows[i];
    const bool ends = row.stitches == 0;  // the bind off: no round, and nothing is left
    std::string left = ends ? "" : std::to_string(row.stitches);
    if (row.short_row > 0) left = row.wrong_side ? name_of(row) : "";
    const bool numbered = !ends && !row.laid && !(row.short_row > 0 && row.wrong_side);
    text += right_aligned(left, counts) + " |" + squares_of(row) + "|" +
            (numbered ? " " + name_of(row) : "") + (!numbered && row.slips_back ? " <" : "") + "\n";
  }
  const std::string ruler = ruler_of(chart);
  return ruler.empty() ? text : text + std::string(counts + 2, ' ') + ruler + "\n";
}

bool has_short_rows(const Chart& chart) {
  return std::any_of(chart.rows.begin(), chart.rows.end(),
                     [](const ChartRow& row) { return row.short_row > 0; });
}

bool has_way_home(const Chart& chart) {
  return std::any_of(chart.rows.begin(), chart.rows.end(), [](const ChartRow& row) { return row.home; });
}

bool has_symbol(const Chart& chart, ChartSymbol symbol) {
  return std::any_of(chart.rows.begin(), chart.rows.end(), [&](const ChartRow& row) {
    return std::any_of(row.squares.begin(), row.squares.end(),
                       [&](const ChartSquare& square) { return square.symbol == symbol; });
  });
}

// Each on a line too short to be joined with the next by whoever reads the file by machine.
std::string chart_key(const std::vector<const Chart*>& charts) {
  std::string text;
  for (const ChartSign& sign : chart_signs) {
    const bool there = std::any_of(charts.begin(), charts.end(),
                                   [&](const Chart* chart) { return has_symbol(*chart, sign.symbol); });
    if (!there) continue;
    text += sign.sign == ' ' ? "  (blank)  " : std::string("     ") + sign.sign + "     ";
    text.append(sign.meaning).append("\n");
  }
  if (std::any_of(charts.begin(), charts.end(), [](const Chart* chart) { return has_short_rows(*chart); }))
    text += how_short_rows_read;
  if (std::any_of(charts.begin(), charts.end(), [](const Chart* chart) { return has_way_home(*chart); }))
    text += how_ways_home_read;
  return text;
}

std::string chart_as_text(const Chart& chart) {
  if (chart.rows.empty()) return "";
  if (chart.columns > widest_text_chart) return "\nCHART\n" + too_wide(chart);
  return "\nCHART\n" + std::string(how_to_read) + "\n" + chart_key({&chart}) + "\n" + chart_grid(chart);
}

std::string chart_as_markdown(const Chart& chart) {
  if (chart.rows.empty()) return "";
  if (chart.columns > widest_text_chart) return "\n## Chart\n\n" + too_wide(chart);
  return "\n## Chart\n\n" + std::string(how_to_read) + "\n```text\n" + chart_key({&chart}) + "\n" +
         chart_grid(chart) + "```\n";
}

}  // namespace knit
