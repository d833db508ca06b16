#include "app/files/chart_svg.h"

#include <algorithm>
#include <cmath>
#include <list>
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

template <class Holds>
bool any_row(const Chart& chart, const Holds& holds) {
  return std::any_of(chart.rows.begin(), chart.rows.end(), holds);
}
bool any_laid(const Chart& chart) {
  return any_row(chart, [](const knit::ChartRow& row) { return row.laid; });
}
bool any_slips(const Chart& chart) {
  return any_row(chart, [](const knit::ChartRow& row) { return row.slips_back; });
}

constexpr std::string_view slip_sign = "<";  // beside a round's number

struct KeyEntry {
  const ChartShape* shape = nullptr;  // null: a tinted square, or a sign
  std::string_view meaning;
  std::string_view fill = chart_colour::main_tint;
  std::string_view sign = {};
};

std::string svg_opening(double width, double height) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + hundredths(width) + "mm\" height=\"" +
         hundredths(height) + "mm\" viewBox=\"0 0 " + hundredths(width) + " " + hundredths(height) +
         "\" font-family=\"Inter, Helvetica, Arial, sans-serif\" fill=\"#222\">\n";
}

class Drawing {
 public:
  Drawing(const Chart& chart, const ChartLook& look)
      : chart_(chart),
        look_(look),
        all_(look.all.empty() ? std::vector<const Chart*>{&chart} : look.all),
        entries_(look.key ? used() : std::vector<KeyEntry>()) {
    const auto columns = static_cast<double>(chart.columns), rows = static_cast<double>(chart.rows.size());
    const double room_below = look.fit_height_mm - above_grid() - key_height_for(look.fit_width_mm) - 3.0;
    const double fitting = std::min((look.fit_width_mm - 2.0 * edge_) / columns, room_below / rows);
    square_ = std::min(look.largest_square_mm, std::max(look.smallest_square_mm, fitting));
    label_ = std::clamp(0.6 * square_, 1.8, 2.8);
    width_ = std::max(columns * square_ + 2.0 * edge_, look.key ? 2.0 * entry_width() : 0.0);
    if (look.small_title)
      width_ =
          std::max(width_, character * 1.15 * small_title_ * static_cast<double>(look.title.size()) + 2.0);
    if (chart.rows.empty()) width_ = look.fit_width_mm;
    left_ = (width_ - columns * square_) / 2.0;
    top_ = above_grid();
    grid_width_ = columns * square_;
    grid_height_ = rows * square_;
    height_ = top_ + grid_height_ + 3.0 + key_height_for(width_);
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  [[nodiscard]] std::string document() const {
    return svg_opening(width_, height_) + "<title>" + xml_text(look_.title.empty() ? "Chart" : look_.title) +
           "</title>\n" + (look_.borrows ? "" : definitions()) +
           "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + body() + "</svg>\n";
  }

  // Without what it defines.
  [[nodiscard]] std::string body() const {
    std::string out;
    if (!look_.title.empty())
      out += text_at(width_ / 2.0, look_.small_title ? 3.6 : 5.0,
                     " font-size=\"" + std::string(look_.small_title ? "3.2" : "4.4") +
                         "\" font-weight=\"600\" text-anchor=\"middle\"",
                     look_.title);
    if (!chart_.rows.empty())
      out += scaled(left_, top_, square_, chart_squares(chart_, look_.tint_mains)) + labels();
    return out + key();
  }

  [[nodiscard]] std::string definitions() const {
    std::string out = "<defs fill=\"none\">\n";
    for (const ChartShape& shape : chart_shapes) {
      if (shape.id.empty() || !has(shape.symbol)) continue;
      out += "<path id=\"" + std::string(shape.id) + "\" d=\"" + svg_path(shape.strokes) +
             "\" fill=\"none\" stroke=\"#111\" stroke-width=\".115\" stroke-linecap=\"round\" "
             "stroke-linejoin=\"round\"/>\n";
    }
    return out + "</defs>\n";
  }

 private:
  [[nodiscard]] double above_grid() const {
    if (chart_.rows.empty()) return 0.0;
    if (look_.small_title) return 8.4;
    return look_.title.empty() ? 5.0 : 12.0;
  }

  template <class Holds>
  [[nodiscard]] bool any_chart(const Holds& holds) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Chart* chart) { return holds(*chart); });
  }
  [[nodiscard]] bool has(ChartSymbol symbol) const {
    return any_chart([&](const Chart& chart) { return knit::has_symbol(chart, symbol); });
  }

  [[nodiscard]] std::vector<KeyEntry> used() const {
    std::vector<KeyEntry> entries;
    for (const ChartShape& shape : chart_shapes) {
      if (has(shape.symbol)) entries.push_back({&shape, knit::sign_of(shape.symbol).meaning});
    }
    if (look_.tint_mains && any_chart(any_main)) entries.push_back({nullptr, "main line"});
    if (any_chart(any_laid))
      entries.push_back({nullptr, "a row that knits nothing", chart_colour::laid_tint});
    if (any_chart(knit::has_short_rows))
      entries.push_back({nullptr, "a short row, from its number\'s side", "none", "s1"});
    if (any_chart(knit::has_way_home))
      entries.push_back({nullptr, "on to the beginning of the round", "none", "next"});
    if (any_chart(any_slips)) entries.push_back({nullptr, "slip the last st back first", "none", slip_sign});
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
    if (!look_.counts) out.clear();
    out += text_at(right, top_ - 1.5, size + " fill=\"#666\"", "rnd");
    const std::int32_t step = label_step();
    std::int32_t count = 0;
    for (std::size_t row = 0; row < chart_.rows.size(); ++row) {
      const knit::ChartRow& r = look_.whole != nullptr ? look_.whole->rows[row] : chart_.rows[row];
      const bool first = row == 0, last = row + 1 == chart_.rows.size();
      // Where there is no room for all, those beside the two rows with words stay away.
      const bool crowded = step > 1 && (row < static_cast<std::size_t>(step) ||
                                        row + static_cast<std::size_t>(step) >= chart_.rows.size());
      if (!first && !last && (r.number % step != 0 || crowded)) continue;
      if (r.short_row > 0 && step > 1) continue;
      const double y = top_ + grid_height_ - (static_cast<double>(row) + 0.5) * square_ + 0.36 * label_;
      if (r.short_row > 0) {
        out += text_at(r.wrong_side ? left : right, y, r.wrong_side ? at_left : size, knit::name_of(r));
        continue;
      }
      if (!r.laid) out += text_at(right, y, size, word_of(r));
      if (look_.counts && (r.laid ? first : is_worked(r) || first))
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
    if (is_worked(row)) return knit::name_of(row);
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
                         look_.broken ? "Start at the bottom; read every round from right to left, through "
                                        "all columns of the chart."
                                      : "Start at the bottom; read every round from right to left.");
  }
  static std::string swatch(const KeyEntry& entry) {
    const bool none = entry.shape != nullptr && knit::has_no_stitch(entry.shape->symbol);
    const std::string_view fill = entry.shape == nullptr ? entry.fill : none ? chart_colour::grey : "#fff";
    std::string out = "<rect class=\"key\" width=\"1\" height=\"1\" fill=\"" + std::string(fill) +
                      "\" stroke=\"#555\" stroke-width=\".05\"/>\n";
    if (entry.shape != nullptr && !entry.shape->id.empty())
      out += "<use href=\"#" + std::string(entry.shape->id) + "\"/>\n";
    const bool held = entry.shape != nullptr && entry.shape->symbol == ChartSymbol::held;
    if (held || !entry.sign.empty())
      out += std::string("<text x=\".5\" ") +
             (entry.sign.size() > 2 ? "y=\".63\" font-size=\".42\"" : "y=\".78\" font-size=\".74\"") +
             " text-anchor=\"middle\">" + xml_text(held ? std::string_view("A") : entry.sign) + "</text>\n";
    return out;
  }

  static constexpr double edge_ = 9.0;    // left and right of the grid, for numbers
  static constexpr double swatch_ = 4.0;  // a square of the key
  static constexpr double line_ = 6.0;    // of the key
  static constexpr double small_title_ = 3.2;
  const Chart& chart_;
  const ChartLook& look_;
  std::vector<const Chart*> all_;
  std::vector<KeyEntry> entries_;
  double square_ = 5.0, label_ = 2.5, width_ = 0.0, height_ = 0.0;
  double left_ = 0.0, top_ = 0.0, grid_width_ = 0.0, grid_height_ = 0.0;  // of the grid
};

}  // namespace

std::string chart_svg(const Chart& chart, const ChartLook& look) { return Drawing(chart, look).document(); }

namespace {

// Columns of each part of a chart of which so many fit: whole tens, so that the heavy lines go on, where these fit too.
std::vector<std::int32_t> parts_of(std::int32_t columns, std::int32_t most) {
  const std::int32_t parts = (columns + most - 1) / most, even = (columns + parts - 1) / parts;
  const std::int32_t tens = (even + 9) / 10 * 10, each = tens <= most ? tens : even;
  std::vector<std::int32_t> all;
  for (std::int32_t done = 0; done < columns; done += each) all.push_back(std::min(each, columns - done));
  return all;
}

Chart part_of(const Chart& chart, std::int32_t first, std::int32_t columns) {
  Chart part = chart;
  part.columns = columns;
  for (knit::ChartRow& row : part.rows) {
    const auto begin = row.squares.begin() + first;
    row.squares = std::vector<ChartSquare>(begin, begin + columns);
  }
  return part;
}

// Charts from left to right, and line by line.
class Sheet {
 public:
  Sheet(const std::vector<NamedChart>& charts, const SheetLook& look) : look_(look) {
    for (const NamedChart& named : charts) all_.push_back(named.chart);
    for (const double square : squares()) {
      lay(charts, square, false);
      if (fits()) break;
    }
    if (!is_legible()) break_charts(charts);
  }
  // Less, and a wide chart is rather broken.
  [[nodiscard]] bool is_legible() const { return square_ >= 2.6; }
  [[nodiscard]] double square() const { return square_; }
  [[nodiscard]] bool breaks() const { return !parts_.empty(); }

  [[nodiscard]] std::vector<std::string> documents() const {
    std::vector<std::string> all;
    for (const Placed& placed : placed_) all.push_back(Drawing(*placed.chart, placed.look).document());
    all.push_back(Drawing(Chart{}, key()).document());
    return all;
  }

  [[nodiscard]] std::string document() const {
    const double above = look_.title.empty() ? 2.0 : 11.0, width = std::max(width_, look_.width_mm);
    const ChartLook key_look = key();
    const Chart none;
    const Drawing key_drawing(none, key_look);
    const double height = above + height_;
    std::string out = svg_opening(width, height) + "<title>" +
                      xml_text(look_.title.empty() ? "Charts" : look_.title) + "</title>\n" +
                      key_drawing.definitions() + "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    if (!look_.title.empty())
      out += text_at(width / 2.0, 6.0, " font-size=\"4.8\" font-weight=\"600\" text-anchor=\"middle\"",
                     look_.title);
    for (const Placed& placed : placed_)
      out += moved(placed.x, above + placed.y, Drawing(*placed.chart, placed.look).body());
    out += moved((width - look_.width_mm) / 2.0, height - key_drawing.height(), key_drawing.body());
    return out + "</svg>\n";
  }

 private:
  struct Placed {
    const Chart* chart = nullptr;
    ChartLook look;
    double x = 0.0, y = 0.0;
  };

  static std::string moved(double x, double y, const std::string& inside) {
    return "<g transform=\"translate(" + hundredths(x) + " " + hundredths(y) + ")\">\n" + inside + "</g>\n";
  }

  [[nodiscard]] ChartLook key() const {
    ChartLook look;
    look.all = all_;
    look.broken = breaks();
    look.fit_width_mm = look_.width_mm;
    return look;
  }

  [[nodiscard]] std::vector<double> squares() const {
    std::vector<double> all;
    for (const double square :
         {look_.largest_square_mm, 3.5, 3.0, 2.7, 2.4, 2.2, 2.0, 1.8, 1.65, look_.smallest_square_mm}) {
      if (square <= look_.largest_square_mm && square >= look_.smallest_square_mm) all.push_back(square);
    }
    return all;
  }
  [[nodiscard]] bool fits() const { return width_ <= look_.width_mm && height_ <= look_.height_mm; }

  // Only for larger squares than whole charts have. What fits no sheet takes several.
  void break_charts(const std::vector<NamedChart>& charts) {
    const double whole = fits() ? square_ : 0.0;
    for (const double square : squares()) {
      if (square <= whole) break;
      lay(charts, square, true);
      if (fits()) return;
    }
    lay(charts, whole > 0.0 ? whole : std::clamp(1.8, look_.smallest_square_mm, look_.largest_square_mm),
        whole == 0.0);
  }

  // The chart, or its parts.
  std::vector<Placed> drawings_of(const NamedChart& named, double square, bool broken) {
    Placed placed{named.chart, {}, 0.0, 0.0};
    placed.look.title = named.name;
    placed.look.small_title = placed.look.borrows = true;
    placed.look.key = false;
    placed.look.largest_square_mm = placed.look.smallest_square_mm = square;
    const std::int32_t columns = named.chart->columns,
                       most = std::max(1, static_cast<std::int32_t>((look_.width_mm - 18.0) / square));
    if (!broken || columns <= most) return {placed};
    std::vector<Placed> all;
    std::int32_t first = 0;
    const std::vector<std::int32_t> parts = parts_of(columns, most);
    for (const std::int32_t count : parts) {
      placed.chart = &parts_.emplace_back(part_of(*named.chart, first, count));
      placed.look.whole = named.chart;
      placed.look.title = named.name + ": columns " + std::to_string(first + 1) + " to " +
                          std::to_string(first + count) + " of " + std::to_string(columns);
      first += count;
      placed.look.counts = first == columns;
      all.push_back(placed);
    }
    return all;
  }

  void lay(const std::vector<NamedChart>& charts, double square, bool broken) {
    std::vector<Placed> drawings;
    placed_.clear();
    parts_.clear();
    for (const NamedChart& named : charts) {
      for (Placed& placed : drawings_of(named, square, broken)) drawings.push_back(std::move(placed));
    }
    double x = 0.0, y = 0.0, line = 0.0;
    width_ = 0.0;
    square_ = square;
    for (Placed& placed : drawings) {
      const Drawing drawing(*placed.chart, placed.look);
      if (x > 0.0 && x + drawing.width() > look_.width_mm) x = 0.0, y += line, line = 0.0;
      placed.x = x;
      placed.y = y;
      x += drawing.width();
      width_ = std::max(width_, x);
      line = std::max(line, drawing.height());
      placed_.push_back(std::move(placed));
    }
    const ChartLook key_look = key();
    height_ = y + line + Drawing(Chart{}, key_look).height();
  }

  const SheetLook& look_;
  std::vector<const Chart*> all_;
  std::list<Chart> parts_;
  std::vector<Placed> placed_;
  double width_ = 0.0, height_ = 0.0, square_ = 0.0;
};

}  // namespace

namespace {

SheetLook sideways() {
  SheetLook look;
  look.width_mm = 266.0;
  look.height_mm = 168.0;
  return look;
}

}  // namespace

bool is_wide(const std::vector<NamedChart>& charts) {
  const SheetLook upright_look, sideways_look = sideways();
  const Sheet upright(charts, upright_look), wide(charts, sideways_look);
  if (upright.breaks() != wide.breaks()) {
    const Sheet& whole = upright.breaks() ? wide : upright;
    if (whole.is_legible()) return &whole == &wide;
  }
  return wide.square() > upright.square();
}

SheetLook sheet_for(const std::vector<NamedChart>& charts) {
  return is_wide(charts) ? sideways() : SheetLook();
}

std::string charts_svg(const std::vector<NamedChart>& charts, const SheetLook& look) {
  return Sheet(charts, look).document();
}

std::vector<std::string> charts_svgs(const std::vector<NamedChart>& charts, const SheetLook& look) {
  return Sheet(charts, look).documents();
}

bool is_wide(const Chart& chart) {
  // Where a sheet put sideways gives larger squares, margins, numbers and key taken off.
  return 5 * static_cast<std::size_t>(chart.columns) > 6 * chart.rows.size();
}

}  // namespace app
