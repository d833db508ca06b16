#include "app/core/plots_file.h"

#include <algorithm>
#include <cctype>

#include "app/core/plots_svg.h"
#include "app/core/run_figures.h"
#include "knit/quality.h"

namespace app {

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

PlotFigures figures_of(const Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  const knit::Parameters& parameters = timeline.parameters();
  const knit::Quality quality = knit::measure_quality(
      timeline.input(), timeline.state(), parameters.stitch_width, knit::stitch_height_of(parameters));
  const RowFigures rows = row_figures_of(timeline.state(), parameters.stitch_width);
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
  figures.rows = {std::move(stitches), std::move(course)};
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
      text += csv_line(plot.key, "made", plot.rows[i], plot.rows[i], plot.made[i]);
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
  if (!session.timeline->state().rows.empty()) return std::nullopt;
  return "there are no rows yet to plot; go on until the cast on is done.";
}

std::string plots_file_text(const Session& session, PlotsFormat format) {
  const PlotFigures figures = figures_of(session);
  return format == PlotsFormat::svg ? plots_svg(figures) : csv_text(figures);
}

}  // namespace app
