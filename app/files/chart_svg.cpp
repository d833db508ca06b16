#include "app/files/chart_svg.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/base/text.h"
#include "app/describe/chart_squares.h"
#include "app/session/document.h"

namespace app {

namespace {

using knit::Chart;
using knit::ChartSquare;
using knit::ChartSymbol;

constexpr double text_mm = 2.9;
constexpr double character = 0.53;  // of the text's height: what a letter takes on average

std::string hundredths(double value) { return trimmed_text(value, 2); }

std::string text_at(double x, double y, std::string_view look, std::string_view text) {
  return "<text" + attribute("x", x, 2) + attribute("y", y, 2) + std::string(look) + ">" + xml_text(text) +
         "</text>\n";
}

bool any_main(const Chart& chart) {
  return std::any_of(chart.rows.begin(), chart.rows.end(), [](const knit::ChartRow& row) {
    return std::any_of(row.squares.begin(), row.squares.end(), [](const ChartSquare& s) { return s.main; });
  });
}

bool has(const Chart& chart, ChartSymbol symbol) {
  return std::any_of(chart.rows.begin(), chart.rows.end(), [&](const knit::ChartRow& row) {
    return std::any_of(row.squares.begin(), row.squares.end(),
                       [&](const ChartSquare& s) { return s.symbol == symbol; });
  });
}

struct KeyEntry {
  const ChartShape* shape = nullptr;  // null: a tinted square
  std::string_view meaning;
};

class Drawing {
 public:
  Drawing(const Chart& chart, const ChartLook& look)
      : chart_(chart), look_(look), entries_(look.key ? used() : std::vector<KeyEntry>()) {
    const auto columns = static_cast<double>(chart.columns), rows = static_cast<double>(chart.rows.size());
    const double room_below = look.fit_height_mm - above_grid() - key_height_for(look.fit_width_mm) - 3.0;
    const double fitting = std::min((look.fit_width_mm - 2.0 * edge_) / columns, room_below / rows);
    square_ = std::min(look.largest_square_mm, std::max(look.smallest_square_mm, fitting));
    label_ = std::clamp(0.6 * square_, 1.8, 2.8);
    width_ = std::max(columns * square_ + 2.0 * edge_, look.key ? 2.0 * entry_width() : 0.0);
    left_ = (width_ - columns * square_) / 2.0;
    top_ = above_grid();
    grid_width_ = columns * square_;
    grid_height_ = rows * square_;
    height_ = top_ + grid_height_ + 3.0 + key_height_for(width_);
  }

  [[nodiscard]] std::string document() const {
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + hundredths(width_) +
                      "mm\" height=\"" + hundredths(height_) + "mm\" viewBox=\"0 0 " + hundredths(width_) +
                      " " + hundredths(height_) +
                      "\" font-family=\"Inter, Helvetica, Arial, sans-serif\" fill=\"#222\">\n";
    out += "<title>" + xml_text(look_.title.empty() ? "Chart" : look_.title) + "</title>\n" + definitions();
    out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    if (!look_.title.empty())
      out += text_at(width_ / 2.0, 5.0, " font-size=\"4.4\" font-weight=\"600\" text-anchor=\"middle\"",
                     look_.title);
    out += scaled(left_, top_, square_, chart_squares(chart_, look_.tint_mains));
    return out + labels() + key() + "</svg>\n";
  }

 private:
  [[nodiscard]] double above_grid() const { return look_.title.empty() ? 5.0 : 12.0; }

  [[nodiscard]] std::vector<KeyEntry> used() const {
    std::vector<KeyEntry> entries;
    for (const ChartShape& shape : chart_shapes) {
      if (has(chart_, shape.symbol)) entries.push_back({&shape, knit::sign_of(shape.symbol).meaning});
    }
    if (look_.tint_mains && any_main(chart_)) entries.push_back({nullptr, "main line"});
    return entries;
  }

  [[nodiscard]] double entry_width() const {
    std::size_t longest = 0;
    for (const KeyEntry& entry : entries_) longest = std::max(longest, entry.meaning.size());
    return swatch_ + 2.0 + character * text_mm * static_cast<double>(longest) + 5.0;
  }
  [[nodiscard]] std::size_t key_columns(double width) const {
    const auto fitting = static_cast<std::size_t>(std::max(1.0, std::floor(width / entry_width())));
    // As many lines as needed, filled evenly.
    const std::size_t lines = (entries_.size() + fitting - 1) / fitting;
    return lines == 0 ? 1 : (entries_.size() + lines - 1) / lines;
  }
  [[nodiscard]] double key_height_for(double width) const {
    if (entries_.empty()) return 0.0;
    const std::size_t columns = key_columns(width);
    const std::size_t lines = (entries_.size() + columns - 1) / columns;
    return static_cast<double>(lines) * line_ + 9.0;
  }

  [[nodiscard]] static std::string scaled(double x, double y, double by, const std::string& inside) {
    return "<g transform=\"translate(" + hundredths(x) + " " + hundredths(y) + ") scale(" +
           fixed_text(by, 4) + ")\">\n" + inside + "</g>\n";
  }

  [[nodiscard]] std::string definitions() const {
    std::string out = "<defs fill=\"none\">\n";
    for (const ChartShape& shape : chart_shapes) {
      if (shape.id.empty() || !has(chart_, shape.symbol)) continue;
      out += "<path id=\"" + std::string(shape.id) + "\" d=\"" + svg_path(shape.strokes) +
             "\" fill=\"none\" stroke=\"#111\" stroke-width=\".115\" stroke-linecap=\"round\" "
             "stroke-linejoin=\"round\"/>\n";
    }
    return out + "</defs>\n";
  }

  // Every row where there is room, else every second, fifth or tenth; cast on and bind off always.
  [[nodiscard]] std::int32_t label_step() const {
    for (const std::int32_t step : {1, 2, 5, 10}) {
      if (step * square_ >= 1.1 * label_) return step;
    }
    return 20;
  }

  [[nodiscard]] std::string labels() const {
    const std::string size = attribute("font-size", label_, 2);
    const std::string at_left = size + " text-anchor=\"end\"";
    const double right = left_ + grid_width_ + 1.4, left = left_ - 1.4;
    std::string out = text_at(left, top_ - 1.5, at_left + " fill=\"#666\"", "sts");
    out += text_at(right, top_ - 1.5, size + " fill=\"#666\"", "rnd");
    const std::int32_t step = label_step();
    std::int32_t count = 0;
    for (std::size_t row = 0; row < chart_.rows.size(); ++row) {
      const knit::ChartRow& r = chart_.rows[row];
      const bool first = row == 0, last = row + 1 == chart_.rows.size();
      // Where there is no room for all, those beside the two rows with words stay away.
      const bool crowded = step > 1 && (row < static_cast<std::size_t>(step) ||
                                        row + static_cast<std::size_t>(step) >= chart_.rows.size());
      if (!first && !last && (r.number % step != 0 || crowded)) continue;
      const double y = top_ + grid_height_ - (static_cast<double>(row) + 0.5) * square_ + 0.36 * label_;
      out += text_at(right, y, size, word_of(r));
      if (is_worked(r) || first)
        out += text_at(left, y, at_left + (r.stitches == count ? " fill=\"#999\"" : ""),
                       std::to_string(r.stitches));
      count = r.stitches;
    }
    return out;
  }
  static ChartSymbol first_symbol(const knit::ChartRow& row) {
    const auto found = std::find_if(row.squares.begin(), row.squares.end(),
                                    [](const ChartSquare& square) { return square.stitch >= 0; });
    return found == row.squares.end() ? ChartSymbol::no_stitch : found->symbol;
  }
  static bool is_worked(const knit::ChartRow& row) {
    const ChartSymbol symbol = first_symbol(row);
    return symbol != ChartSymbol::cast_on && symbol != ChartSymbol::bind_off;
  }
  static std::string word_of(const knit::ChartRow& row) {
    if (is_worked(row)) return std::to_string(row.number);
    return first_symbol(row) == ChartSymbol::cast_on ? "CO" : "BO";
  }

  [[nodiscard]] std::string key() const {
    if (entries_.empty()) return {};
    const std::size_t columns = key_columns(width_);
    const double left = std::max(0.5, (width_ - static_cast<double>(columns) * entry_width() + 5.0) / 2.0);
    const double top = top_ + grid_height_ + 6.0;
    std::string out;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const std::size_t line = i / columns;
      const double x = left + static_cast<double>(i % columns) * entry_width();
      const double y = top + static_cast<double>(line) * line_;
      out += scaled(x, y, swatch_, swatch(entries_[i]));
      out += text_at(x + swatch_ + 2.0, y + 0.5 * swatch_ + 0.36 * text_mm,
                     attribute("font-size", text_mm, 2), entries_[i].meaning);
    }
    return out + text_at(width_ / 2.0, height_ - 1.2,
                         " font-size=\"2.5\" fill=\"#555\" text-anchor=\"middle\"",
                         "Start at the bottom; read every round from right to left.");
  }
  static std::string swatch(const KeyEntry& entry) {
    const bool none = entry.shape != nullptr && entry.shape->symbol == ChartSymbol::no_stitch;
    const std::string_view fill = entry.shape == nullptr ? chart_colour::main_tint
                                  : none                 ? chart_colour::grey
                                                         : "#fff";
    std::string out = "<rect class=\"key\" width=\"1\" height=\"1\" fill=\"" + std::string(fill) +
                      "\" stroke=\"#555\" stroke-width=\".05\"/>\n";
    if (entry.shape != nullptr && !entry.shape->id.empty())
      out += "<use href=\"#" + std::string(entry.shape->id) + "\"/>\n";
    return out;
  }

  static constexpr double edge_ = 9.0;    // left and right of the grid, for numbers
  static constexpr double swatch_ = 4.0;  // a square of the key
  static constexpr double line_ = 6.0;    // of the key
  const Chart& chart_;
  const ChartLook& look_;
  std::vector<KeyEntry> entries_;
  double square_ = 5.0, label_ = 2.5, width_ = 0.0, height_ = 0.0;
  double left_ = 0.0, top_ = 0.0, grid_width_ = 0.0, grid_height_ = 0.0;  // of the grid
};

}  // namespace

std::string chart_svg(const Chart& chart, const ChartLook& look) { return Drawing(chart, look).document(); }

bool is_wide(const Chart& chart) {
  // Where a sheet put sideways gives larger squares, margins, numbers and key taken off.
  return 5 * static_cast<std::size_t>(chart.columns) > 6 * chart.rows.size();
}

}  // namespace app
