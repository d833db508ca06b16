// Plots as a drawing for paper: black on white, with axes; its unit is a millimetre.
#include "app/files/plots.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/text.h"
#include "app/explain/rhythm_figures.h"
#include "app/session/document.h"
#include "app/session/run_figures.h"
#include "app/session/shown.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"
#include "knit/quality/quality.h"

namespace app {

struct TubeStart {
  std::int32_t row = 1;  // its first
  std::string name;
};

// Values a row: as they are, and as they should be. All three are equally long.
struct RowsFigure {
  std::string key;  // the class of its group, and its name in CSV
  std::string title;
  std::string value;  // the axis's title
  std::vector<std::int32_t> rows;
  std::vector<double> made, ideal;
  std::vector<TubeStart> tubes;     // where there are several
  std::string made_words = "made";  // what the values are
  [[nodiscard]] bool begins_tube(std::int32_t row) const {
    return std::any_of(tubes.begin(), tubes.end(), [&](const TubeStart& tube) { return tube.row == row; });
  }
};

// How often values fall into equal bins; no bins: nothing to count yet.
struct HistogramFigure {
  std::string key, title;
  std::string unit;  // the title of the axis along
  int decimals = 2;  // of the mean
  double low = 0.0, high = 1.0;
  std::vector<std::size_t> bins;
  double reference = 1.0;  // the right value
  std::optional<double> mean;
  bool open_above = false;  // the last bin also holds what is higher
};

struct PlotFigures {
  std::string title;
  std::vector<RowsFigure> rows;             // one below the other
  std::vector<HistogramFigure> histograms;  // side by side below
};

// A document of its own. Without an XML declaration; text is UTF-8.
std::string plots_svg(const PlotFigures& figures);

namespace {

constexpr double page_width = 180.0, rows_height = 62.0, histogram_height = 58.0, head = 12.0;
constexpr double plot_text_mm = 2.7;
constexpr std::string_view made_colour = "#2f6fae", ideal_colour = "#c25e00", grey = "#666";

std::string millimetres(double value) { return trimmed_text(value, 3); }

std::string words_at(double x, double y, std::string_view anchor, std::string_view words,
                     const std::string& more = "") {
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", anchor) + more + ">" +
         xml_text(words) + "</text>\n";
}

std::string line_from(double x0, double y0, double x1, double y1, const std::string& look) {
  return "<line" + attribute("x1", x0) + attribute("y1", y0) + attribute("x2", x1) + attribute("y2", y1) +
         look + "/>\n";
}

// 1, 2 or 5 times a power of ten, so that at most `most` fit in.
double nice_step(double range, int most) {
  const double least = range / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

// Where one plot stands, and from values to the page.
struct Ground {
  double left, top, right, bottom;
  double low = 0.0, high = 1.0;  // of the axis along
  double most = 1.0;             // of the axis up, from 0
  [[nodiscard]] double x(double value) const {
    const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return left + (right - left) * share;
  }
  [[nodiscard]] double y(double value) const {
    return bottom - (bottom - top) * std::clamp(value / most, 0.0, 1.0);
  }
};

std::string heading(const Ground& ground, const std::string& title) {
  return words_at(ground.left, ground.top - 4.0, "start", title,
                  " font-weight=\"600\"" + attribute("font-size", 3.2));
}

// Both axes with marks up the left one; `title` stands along it.
std::string axes(const Ground& ground, const std::string& title, bool whole) {
  const std::string thin = " stroke=\"#ddd\" stroke-width=\".15\"";
  const std::string full = " stroke=\"#222\" stroke-width=\".25\"";
  double step = nice_step(ground.most, 5);
  if (whole) step = std::max(step, 1.0);
  std::string out;
  for (int i = 0; i * step <= ground.most * (1.0 + 1e-9); ++i) {
    const double y = ground.y(i * step);
    if (i > 0) out += line_from(ground.left, y, ground.right, y, thin);
    out += line_from(ground.left - 1.0, y, ground.left, y, full);
    out += words_at(ground.left - 1.6, y + 0.36 * plot_text_mm, "end", millimetres(i * step));
  }
  out += line_from(ground.left, ground.top, ground.left, ground.bottom, full);
  out += line_from(ground.left, ground.bottom, ground.right, ground.bottom, full);
  const double x = ground.left - 11.0, y = 0.5 * (ground.top + ground.bottom);
  const std::string turned = " transform=\"rotate(-90 " + millimetres(x) + " " + millimetres(y) + ")\"";
  return out + words_at(x, y, "middle", title, turned + attribute("fill", grey));
}

std::string mark_below(const Ground& ground, double value, const std::string& words) {
  const double x = ground.x(value);
  return line_from(x, ground.bottom, x, ground.bottom + 1.0, " stroke=\"#222\" stroke-width=\".25\"") +
         words_at(x, ground.bottom + 1.6 + plot_text_mm, "middle", words);
}

std::string key_entry(double x, double y, std::string_view colour, const std::string& words) {
  return line_from(x, y - 0.36 * plot_text_mm, x + 5.0, y - 0.36 * plot_text_mm,
                   attribute("stroke", colour) + " stroke-width=\".5\"") +
         words_at(x + 6.2, y, "start", words);
}

// --- rows --------------------------------------------------------------------------------------------------

// Steps: a value holds for the whole of its row.
std::string steps_path(const Ground& ground, const RowsFigure& plot) {
  std::string path;
  for (std::size_t i = 0; i < plot.rows.size(); ++i) {
    const double y = ground.y(plot.made[i]);
    path += (i == 0 ? "M" : "L") + millimetres(ground.x(plot.rows[i] - 0.5)) + " " + millimetres(y) + "H" +
            millimetres(ground.x(plot.rows[i] + 0.5));
  }
  return path;
}

// From one tube to the next nothing is followed.
std::string ideal_path(const Ground& ground, const RowsFigure& plot) {
  std::string path;
  for (std::size_t i = 0; i < plot.rows.size(); ++i)
    path += (i == 0 || plot.begins_tube(plot.rows[i]) ? "M" : "L") + millimetres(ground.x(plot.rows[i])) +
            " " + millimetres(ground.y(plot.ideal[i]));
  return path;
}

// A line where each tube begins, with its letter above, as far as these have room.
std::string tube_marks(const Ground& ground, const RowsFigure& plot) {
  std::string out;
  double free_from = ground.left;
  for (const TubeStart& tube : plot.tubes) {
    const double x = ground.x(tube.row - 0.5);
    if (tube.row > plot.rows.front())
      out += line_from(x, ground.top, x, ground.bottom, " stroke=\"#999\" stroke-width=\".2\"");
    if (x < free_from) continue;
    out += words_at(x + 0.6, ground.top - 0.8, "start", tube.name, attribute("fill", grey));
    free_from = x + 0.8 * plot_text_mm * static_cast<double>(tube.name.size()) + 0.6;
  }
  return out.empty() ? out : "<g class=\"tubes\">\n" + out + "</g>\n";
}

std::string rows_svg(const RowsFigure& plot, double top) {
  Ground ground{17.0, top + 9.0, page_width - 4.0, top + rows_height - 13.0};
  double most = 0.0;
  for (const auto& values : {plot.made, plot.ideal}) {
    for (const double value : values) most = std::isfinite(value) ? std::max(most, value) : most;
  }
  ground.most = most > 0.0 ? 1.06 * most : 1.0;
  ground.low = plot.rows.front() - 0.5;
  ground.high = plot.rows.back() + 0.5;
  std::string out = "<g" + attribute("class", plot.key) + ">\n" + heading(ground, plot.title) +
                    axes(ground, plot.value, plot.value == "stitches") + tube_marks(ground, plot);
  const std::string floor = millimetres(ground.bottom);
  const std::string steps = steps_path(ground, plot);
  out += "<path d=\"" + steps + "V" + floor + "H" + millimetres(ground.left) + "Z\"" +
         attribute("fill", made_colour) + " fill-opacity=\".16\"/>\n";
  const std::string ideal = ideal_path(ground, plot);
  out += "<path d=\"" + steps + "\" fill=\"none\" stroke-width=\".45\"" + attribute("stroke", made_colour) +
         "/>\n<path d=\"" + ideal + "\" fill=\"none\" stroke-width=\".35\"" +
         attribute("stroke", ideal_colour) + "/>\n";
  const std::int32_t first = plot.rows.front(), last = plot.rows.back();
  const auto step = static_cast<std::int32_t>(std::max(1.0, nice_step(last - first + 1, 12)));
  out += mark_below(ground, first, std::to_string(first));
  for (std::int32_t row = (first / step + 1) * step; row <= last; row += step)
    out += mark_below(ground, row, std::to_string(row));
  out += words_at(0.5 * (ground.left + ground.right), ground.bottom + 9.0, "middle", "row",
                  attribute("fill", grey));
  const double key = ground.right - 25.0 - 1.5 * static_cast<double>(plot.made_words.size());
  out += key_entry(key, ground.top - 4.0, made_colour, plot.made_words);
  return out + key_entry(ground.right - 13.0, ground.top - 4.0, ideal_colour, "ideal") + "</g>\n";
}

// --- histograms --------------------------------------------------------------------------------------------

std::string bars(const Ground& ground, const HistogramFigure& plot) {
  std::string out;
  const double wide = (ground.right - ground.left) / static_cast<double>(plot.bins.size());
  for (std::size_t i = 0; i < plot.bins.size(); ++i) {
    if (plot.bins[i] == 0) continue;
    const double y = ground.y(static_cast<double>(plot.bins[i]));
    out += "<rect class=\"bar\"" + attribute("x", ground.left + static_cast<double>(i) * wide) +
           attribute("y", y) + attribute("width", 0.92 * wide) + attribute("height", ground.bottom - y) +
           attribute("fill", made_colour) + "/>\n";
  }
  return out;
}

std::string histogram_svg(const HistogramFigure& plot, double left, double width, double top) {
  Ground ground{left + 17.0, top + 9.0, left + width - 4.0, top + histogram_height - 13.0};
  std::string out = "<g" + attribute("class", plot.key) + ">\n" + heading(ground, plot.title);
  if (plot.bins.empty())
    return out +
           words_at(ground.left, 0.5 * (ground.top + ground.bottom), "start", "after the faces",
                    attribute("fill", grey)) +
           "</g>\n";
  ground.low = plot.low;
  ground.high = plot.high;
  ground.most = 1.08 * static_cast<double>(*std::max_element(plot.bins.begin(), plot.bins.end()));
  out += axes(ground, "count", true) + bars(ground, plot);
  const auto upright = [&](double value, const std::string& look) {
    return line_from(ground.x(value), ground.top, ground.x(value), ground.bottom, look);
  };
  out += upright(plot.reference, " stroke=\"#222\" stroke-width=\".25\" stroke-dasharray=\"1 .8\"");
  if (plot.mean) {
    out += upright(*plot.mean, attribute("stroke", ideal_colour) + " stroke-width=\".45\"");
    out += words_at(ground.right, ground.top - 4.0, "end", "mean " + fixed_text(*plot.mean, plot.decimals),
                    attribute("fill", ideal_colour));
  }
  for (const double value : {plot.low, plot.reference}) out += mark_below(ground, value, millimetres(value));
  out += mark_below(ground, plot.high, millimetres(plot.high) + (plot.open_above ? "+" : ""));
  return out +
         words_at(0.5 * (ground.left + ground.right), ground.bottom + 9.0, "middle", plot.unit,
                  attribute("fill", grey)) +
         "</g>\n";
}

}  // namespace

std::string plots_svg(const PlotFigures& figures) {
  const double height = head + rows_height * static_cast<double>(figures.rows.size()) +
                        (figures.histograms.empty() ? 0.0 : histogram_height);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + millimetres(page_width) +
                    "mm\" height=\"" + millimetres(height) + "mm\" viewBox=\"0 0 " + millimetres(page_width) +
                    " " + millimetres(height) + "\" font-family=\"Inter, Helvetica, Arial, sans-serif\"" +
                    attribute("font-size", plot_text_mm) + " fill=\"#222\">\n";
  out += "<title>" + xml_text("Plots of " + figures.title) + "</title>\n";
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  out += words_at(0.5 * page_width, 7.0, "middle", figures.title,
                  " font-weight=\"600\"" + attribute("font-size", 4.4));
  double top = head;
  for (const RowsFigure& plot : figures.rows) {
    out += rows_svg(plot, top);
    top += rows_height;
  }
  const double width = page_width / static_cast<double>(std::max<std::size_t>(1, figures.histograms.size()));
  for (std::size_t i = 0; i < figures.histograms.size(); ++i)
    out += histogram_svg(figures.histograms[i], width * static_cast<double>(i), width, top);
  return out + "</svg>\n";
}

namespace {

HistogramFigure histogram_of(std::string key, std::string title, std::string unit, double reference,
                             const knit::Spread& spread) {
  HistogramFigure figure{std::move(key), std::move(title), std::move(unit)};
  figure.reference = reference;
  if (spread.count == 0) return figure;
  figure.low = spread.histogram.low;
  figure.high = spread.histogram.high;
  figure.bins = spread.histogram.bins;
  figure.mean = spread.mean;
  figure.open_above = spread.high > figure.high;
  return figure;
}

std::vector<TubeStart> tube_starts(const knit::Fabric& fabric) {
  std::vector<TubeStart> starts;
  knit::TubeId last = -1;
  for (const auto& row : fabric.rows()) {
    if (row->tube != last) starts.push_back({row->id, knit::tube_name(row->tube)});
    last = row->tube;
  }
  return starts.size() > 1 ? starts : std::vector<TubeStart>();
}

// The counts of rhythms against what their rows hold; nothing where counts are planned row by row.
std::optional<RowsFigure> rhythm_figure(const knit::State& state) {
  const std::vector<RhythmFigures> all = rhythm_figures_of(state);
  if (all.empty()) return std::nullopt;
  double worst = 0.0;
  RowsFigure figure{"rhythm", {}, "stitches", {}, {}, {}};
  for (const RhythmFigures& rhythm : all) {
    worst = std::max(worst, rhythm.rhythm->plan.seen.worst());
    if (all.size() > 1) figure.tubes.push_back({rhythm.first_row, knit::tube_name(rhythm.rhythm->tube)});
    for (std::size_t i = 0; i < rhythm.planned.size(); ++i) {
      figure.rows.push_back(rhythm.first_row + static_cast<std::int32_t>(i));
      figure.made.push_back(rhythm.planned[i]);
      figure.ideal.push_back(rhythm.ideal[i]);
    }
  }
  figure.title = "Stitches a row as the rhythm has them, at most " + fixed_text(worst, 1) + " % off";
  figure.made_words = "planned";
  return figure;
}

PlotFigures figures_of(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Parameters& parameters = timeline.parameters();
  const knit::State state = shown_state(session);
  const knit::Quality quality =
      knit::measure_quality(timeline.input(), state, parameters.stitch.width, parameters.stitch.height);
  const RowFigures rows = row_figures_of(state, parameters.stitch.width);
  PlotFigures figures;
  figures.title = timeline.input().mesh.name;
  RowsFigure stitches{"stitches", "Stitches a row", "stitches", {}, {}, {}};
  for (const knit::RowFit& row : quality.rows) {
    stitches.rows.push_back(row.row);
    stitches.made.push_back(row.stitches);
    stitches.ideal.push_back(row.ideal);
  }
  RowsFigure course{
      "course-length", "Mean course length a row", "length / w", stitches.rows, rows.course, {}};
  course.ideal.assign(rows.course.size(), 1.0);
  stitches.tubes = course.tubes = tube_starts(timeline.state().fabric);
  figures.rows = {std::move(stitches), std::move(course)};
  if (auto rhythm = rhythm_figure(state)) figures.rows.push_back(std::move(*rhythm));
  figures.histograms = {histogram_of("course", "Course lengths", "length / w", 1.0, quality.course),
                        histogram_of("wale", "Wale lengths", "length / h", 1.0, quality.wale),
                        histogram_of("corner", "Corner angles", "degrees", 90.0, quality.corner)};
  figures.histograms.back().decimals = 1;
  return figures;
}

std::string csv_line(const std::string& plot, const std::string& series, double from, double to,
                     double value) {
  return plot + "," + series + "," + knit::number_text(from) + "," + knit::number_text(to) + "," +
         knit::number_text(value) + "\n";
}

std::string csv_text(const PlotFigures& figures) {
  std::string text = "plot,series,from,to,value\n";
  for (const RowsFigure& plot : figures.rows) {
    for (std::size_t i = 0; i < plot.rows.size(); ++i)
      text += csv_line(plot.key, plot.made_words, plot.rows[i], plot.rows[i], plot.made[i]);
    for (std::size_t i = 0; i < plot.rows.size(); ++i)
      text += csv_line(plot.key, "ideal", plot.rows[i], plot.rows[i], plot.ideal[i]);
  }
  for (const HistogramFigure& plot : figures.histograms) {
    const double wide =
        (plot.high - plot.low) / static_cast<double>(std::max<std::size_t>(1, plot.bins.size()));
    for (std::size_t i = 0; i < plot.bins.size(); ++i) {
      const double from = plot.low + wide * static_cast<double>(i);
      text += csv_line(plot.key, "count", from, plot.low + wide * static_cast<double>(i + 1),
                       static_cast<double>(plot.bins[i]));
    }
  }
  return text;
}

}  // namespace

std::optional<PlotsFormat> plots_format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".svg") return PlotsFormat::svg;
  if (ending == ".csv") return PlotsFormat::csv;
  return std::nullopt;
}

std::optional<std::string> plots_missing(const Session& session) {
  if (!session.document->timeline.state().fabric.empty()) return std::nullopt;
  if (stop_shown(session) != nullptr)
    return "the run stopped before the cast on, so there are no rows to plot.";
  return "there are no rows yet to plot; go on until the cast on is done.";
}

std::string plots_file_text(const Session& session, PlotsFormat format) {
  const PlotFigures figures = figures_of(session);
  return format == PlotsFormat::svg ? plots_svg(figures) : csv_text(figures);
}

}  // namespace app
