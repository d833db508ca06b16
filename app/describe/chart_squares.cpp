#include "app/describe/chart_squares.h"

#include "knit/model/words.h"

namespace app {

namespace {

using knit::Chart;
using knit::ChartSquare;
using knit::ChartSymbol;

std::string attribute(std::string_view name, std::size_t value) {
  return " " + std::string(name) + "=\"" + std::to_string(value) + "\"";
}

std::string rectangle(std::string_view look, std::size_t x, std::size_t y, std::size_t width,
                      std::size_t height) {
  return "<rect" + std::string(look) + attribute("x", x) + attribute("y", y) + attribute("width", width) +
         attribute("height", height) + "/>\n";
}

class Grid {
 public:
  explicit Grid(const Chart& chart)
      : chart_(chart), columns_(static_cast<std::size_t>(chart.columns)), rows_(chart.rows.size()) {}

  [[nodiscard]] std::string drawn(bool tint_mains) const {
    std::string out = rectangle(" fill=\"#fff\"", 0, 0, columns_, rows_);
    if (tint_mains) out += tints();
    return out + laid_rows() + greys() + lines() + symbols() + letters();
  }

 private:
  // From the top left.
  [[nodiscard]] const ChartSquare& at(std::size_t x, std::size_t y) const {
    return chart_.rows[rows_ - 1 - y].squares[columns_ - 1 - x];
  }

  [[nodiscard]] std::string tints() const {
    std::string out = "<g fill=\"" + std::string(chart_colour::main_tint) + "\">\n";
    for (std::size_t x = 0; x < columns_; ++x) {
      for (std::size_t y = 0, end = 0; y < rows_; y = end + 1) {
        for (end = y; end < rows_ && at(x, end).main;) ++end;
        if (end > y) out += rectangle(" class=\"main\"", x, y, 1, end - y);
      }
    }
    return out + "</g>\n";
  }

  // Rows that knit nothing.
  [[nodiscard]] std::string laid_rows() const {
    std::string out;
    for (std::size_t y = 0; y < rows_; ++y) {
      if (chart_.rows[rows_ - 1 - y].laid)
        out += rectangle(" class=\"laid\" fill=\"" + std::string(chart_colour::laid_tint) + "\"", 0, y,
                         columns_, 1);
    }
    return out;
  }

  [[nodiscard]] std::string letters() const {
    std::string out;
    for (std::size_t y = rows_; y-- > 0;) {
      for (std::size_t x = columns_; x-- > 0;) {
        const ChartSquare& square = at(x, y);
        if (square.symbol != ChartSymbol::held) continue;
        out += "<text x=\"" + std::to_string(x) + ".5\" y=\"" + std::to_string(y) +
               ".78\" font-size=\".74\" text-anchor=\"middle\">" + knit::tube_name(square.piece) +
               "</text>\n";
      }
    }
    return out;
  }

  [[nodiscard]] std::string greys() const {
    std::string out = "<g fill=\"" + std::string(chart_colour::grey) + "\">\n";
    for (std::size_t y = 0; y < rows_; ++y) {
      for (std::size_t x = 0, end = 0; x < columns_; x = end + 1) {
        for (end = x; end < columns_ && knit::has_no_stitch(at(end, y).symbol);) ++end;
        if (end > x) out += rectangle(" class=\"none\"", x, y, end - x, 1);
      }
    }
    return out + "</g>\n";
  }

  // Heavier after every ten columns from the right, and above every round with a number in tens.
  [[nodiscard]] std::string lines() const {
    std::string light, heavy;
    for (std::size_t x = 1; x < columns_; ++x) {
      std::string& path = (columns_ - x) % 10 == 0 ? heavy : light;
      path += "M" + std::to_string(x) + " 0V" + std::to_string(rows_);
    }
    for (std::size_t y = 1; y < rows_; ++y) {
      std::string& path = chart_.rows[rows_ - 1 - y].number % 10 == 0 ? heavy : light;
      path += "M0 " + std::to_string(y) + "H" + std::to_string(columns_);
    }
    heavy += "M0 0H" + std::to_string(columns_) + "V" + std::to_string(rows_) + "H0Z";
    return "<path d=\"" + light + "\" fill=\"none\" stroke=\"#8c8c8c\" stroke-width=\".035\"/>\n<path d=\"" +
           heavy + "\" fill=\"none\" stroke=\"#222\" stroke-width=\".085\"/>\n";
  }

  [[nodiscard]] std::string symbols() const {
    std::string out;
    for (std::size_t y = rows_; y-- > 0;) {
      for (std::size_t x = columns_; x-- > 0;) {
        const std::string_view id = shape_of(at(x, y).symbol).id;
        if (id.empty()) continue;
        out += "<use href=\"#" + std::string(id) + "\"" + attribute("x", x) + attribute("y", y) + "/>\n";
      }
    }
    return out;
  }

  const Chart& chart_;
  std::size_t columns_, rows_;
};

}  // namespace

std::string chart_squares(const Chart& chart, bool tint_mains) { return Grid(chart).drawn(tint_mains); }

}  // namespace app
