// The plots as files: the numbers are the run's, and the drawing can be read.
#include "app/files/plots.h"

#include <map>

#include "app/base/text.h"
#include "app/files/export.h"
#include "app/session/document.h"
#include "knit/quality/quality.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"
#include "tests/support/xml_check.h"

using namespace app;

namespace {

struct Value {
  double from = 0.0, to = 0.0, value = 0.0;
};
using Series = std::map<std::string, std::vector<Value>>;  // by "plot/series"

Series read_csv(const std::string& text) {
  const auto lines = test_support::lines_of(text);
  REQUIRE(!lines.empty());
  CHECK(lines[0] == "plot,series,from,to,value");
  Series series;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = split(lines[i], ',');
    REQUIRE(cells.size() == 5);
    const auto number = [&](std::size_t cell) { return std::stod(std::string(cells[cell])); };
    series[std::string(cells[0]) + "/" + std::string(cells[1])].push_back({number(2), number(3), number(4)});
  }
  return series;
}

double sum_of(const std::vector<Value>& values) {
  double sum = 0.0;
  for (const Value& value : values) sum += value.value;
  return sum;
}

}  // namespace

TEST_CASE("the plots as CSV hold the run's numbers") {
  const Session session = test_support::finished_small_session();
  const knit::State& state = session.document->timeline.state();
  Series series = read_csv(plots_file_text(session, PlotsFormat::csv));
  const std::vector<int> sizes = test_support::row_sizes(state);
  const auto& made = series["stitches/made"];
  REQUIRE(made.size() == sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    CHECK(made[i].from == static_cast<double>(i + 1));
    CHECK(made[i].to == made[i].from);
    CHECK(made[i].value == sizes[i]);
  }
  CHECK(series["stitches/ideal"].size() == sizes.size());
  CHECK(series["course-length/made"].size() == sizes.size());
  const knit::Parameters& parameters = session.document->timeline.parameters();
  const knit::Quality quality = knit::measure_quality(session.document->timeline.input(), state,
                                                      parameters.stitch.width, parameters.stitch.height);
  CHECK(sum_of(series["course/count"]) == static_cast<double>(quality.course.count));
  CHECK(sum_of(series["wale/count"]) == static_cast<double>(quality.wale.count));
  CHECK(sum_of(series["corner/count"]) == static_cast<double>(quality.corner.count));
  const auto& course = series["course/count"];
  CHECK(course.front().from == Approx(quality.course.histogram.low).margin(1e-12));
  CHECK(course.back().to == Approx(quality.course.histogram.high));
  for (std::size_t i = 1; i < course.size(); ++i) CHECK(course[i].from == Approx(course[i - 1].to));
}

TEST_CASE("the plots as SVG can be read as XML, with a bar for each bin that counts something") {
  const Session session = test_support::finished_small_session();
  const std::string svg = plots_file_text(session, PlotsFormat::svg);
  CHECK(test_support::xml_fault(svg) == "");
  CHECK(svg == plots_file_text(session, PlotsFormat::svg));
  for (const char* part : {"class=\"stitches\"", "class=\"course-length\"", "class=\"course\"",
                           "class=\"wale\"", "class=\"corner\"", "Stitches a row", ">row<", "180mm"}) {
    CAPTURE(part);
    CHECK(test_support::contains(svg, part));
  }
  std::size_t bars = 0;
  const Series series = read_csv(plots_file_text(session, PlotsFormat::csv));
  for (const char* plot : {"course/count", "wale/count", "corner/count"}) {
    for (const Value& bin : series.at(plot)) bars += bin.value > 0.0 ? 1U : 0U;
  }
  CHECK(test_support::occurrences(svg, "class=\"bar\"") == bars);
  CHECK_FALSE(test_support::contains(svg, "nan"));
  CHECK_FALSE(test_support::contains(svg, "inf"));
}

TEST_CASE("plots of an unfinished run show what there is") {
  Session session = test_support::small_session();
  CHECK(plots_missing(session).has_value());
  apply(session, SeekPlace{{knit::Stage::cast_on, 1, 1000}});
  apply(session, StepBy{});
  REQUIRE(session.document->timeline.state().fabric.rows().size() == 1);
  CHECK_FALSE(plots_missing(session).has_value());
  const std::string svg = plots_file_text(session, PlotsFormat::svg);
  CHECK(test_support::xml_fault(svg) == "");
  CHECK(test_support::occurrences(svg, "after the faces") == 2);
  CHECK_FALSE(test_support::contains(svg, "nan"));
  const Series series = read_csv(plots_file_text(session, PlotsFormat::csv));
  CHECK(series.count("wale/count") == 0);
}

TEST_CASE("a wrong ending and a missing run are said in a sentence") {
  Session session = test_support::small_session();
  const test_support::Folder folder;
  for (const char* name : {"p.svg", "p.pdf"}) {
    const auto error = export_to_file(session, {"plots", folder.path() / name});
    REQUIRE(error.has_value());
    CHECK(test_support::is_one_sentence(*error));
  }
  apply(session, ToLast{});
  CHECK_FALSE(export_to_file(session, {"plots", folder.path() / "p.svg"}).has_value());
  CHECK_FALSE(export_to_file(session, {"plots", folder.path() / "p.CSV"}).has_value());
  CHECK(folder.files() == 2);
}

TEST_CASE("a rhythm's plan against its ideals is a plot of its own") {
  CHECK(read_csv(plots_file_text(test_support::finished_small_session(), PlotsFormat::csv))
            .count("rhythm/planned") == 0);
  Session session = test_support::finished_small_session();
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.timing.kind = knit::TimingKind::arc_length;
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  parameters.rhythm.counts = knit::CountPlanning::rhythm;
  session.document->timeline =
      knit::Timeline(knit::make_input(session.document->timeline.input().mesh), parameters);
  session.document->timeline.extend_to_end();
  session.document->timeline.seek(session.document->timeline.known());
  const auto& state = session.document->timeline.furthest();
  REQUIRE(state.rhythms.size() == 1);
  Series series = read_csv(plots_file_text(session, PlotsFormat::csv));
  const auto& planned = series["rhythm/planned"];
  const auto& counts = state.rhythms.front()->plan.counts;
  REQUIRE(planned.size() == counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) CHECK(planned[i].value == counts[i]);
  CHECK(series["rhythm/ideal"].size() == counts.size());
  const std::string svg = plots_file_text(session, PlotsFormat::svg);
  CHECK(svg.find("class=\"rhythm\"") != std::string::npos);
  CHECK(svg.find("as the rhythm has them, at most ") != std::string::npos);
  CHECK(test_support::xml_fault(svg).empty());
}
