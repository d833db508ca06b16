// A finished piece beside what was asked for: its size, a plausible swatch, and where it is said.
#include "knit/insight/as_asked.h"

#include <algorithm>

#include "app/files/card.h"
#include "app/files/pattern_export.h"
#include "app/files/report.h"
#include "app/session/document.h"
#include "app/session/remarks.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

Parameters rings() {
  Parameters parameters;
  parameters.rows.source = RowSource::rings;
  return parameters;
}

Parameters with_gauge(Gauge gauge) {
  Parameters parameters;
  give_gauge(parameters, gauge);
  return parameters;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A small ball whose rings stand closer together than its stitches are high.
app::Session flat_ball() {
  app::Session session;
  Parameters parameters = rings();
  give_width(parameters, 0.3);
  give_height(parameters, 0.5);
  give_epsilon(parameters, 0.15);
  session.document = app::Document({make_input(sphere(24, 15, false)), parameters});
  Timeline& timeline = session.document->timeline;
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  return session;
}

}  // namespace

TEST_CASE("a size a tenth off is told with both sizes and a way on", "[problems]") {
  const PieceSize asked{12.0, 37.7};
  CHECK_FALSE(remark_on_size({12.5, 38.0}, asked, rings()));
  CHECK_FALSE(remark_on_size({10.9, 41.0}, asked, rings()));
  const auto high = remark_on_size({18.1, 39.0}, asked, rings());
  REQUIRE(high);
  CHECK(
      high->words ==
      "Knitted, it comes out about 18 cm high and 39 cm around; asked for was 12 cm high and 37.5 cm around. "
      "Rows from contours come out as asked.");
  CHECK(high->kind == RemarkKind::size);
  Parameters contours;
  contours.rows.source = RowSource::contours;
  const auto wide = remark_on_size({std::nullopt, 58.5}, asked, contours);
  REQUIRE(wide);
  CHECK(
      wide->words ==
      "Knitted, it comes out about 58.5 cm around at the widest; asked for was 37.5 cm around at the widest. "
      "Finer stitches come nearer.");
}

TEST_CASE("a swatch that is hardly knitted fabric is told, and usual ones are not", "[problems]") {
  for (const Gauge usual : {Gauge{22, 32}, Gauge{16, 22}, Gauge{28, 36}, Gauge{24, 24}, Gauge{18, 25}})
    CHECK_FALSE(remark_on_swatch(with_gauge(usual)));
  const auto flat = remark_on_swatch(with_gauge({18, 32}));
  REQUIRE(flat);
  CHECK(flat->words ==
        "A stitch 0.56 as high as it is wide is hardly knitted fabric: 18 stitches and 32 rounds in 10 cm, "
        "where "
        "stockinette has 0.65 to 0.77. 18 stitches go with about 25 rounds; measure a swatch.");
  CHECK(remark_on_swatch(with_gauge({32, 22})));
}

TEST_CASE("what is not as asked stands in report, card and pattern in the same words", "[problems]") {
  const app::Session session = flat_ball();
  const Timeline& timeline = session.document->timeline;
  REQUIRE(timeline.state().finished());
  const auto coverage = measure_coverage(timeline.input(), timeline.state(), 0.3, 0.5);
  REQUIRE(coverage);
  const auto remarks = app::remarks_of(timeline, &*coverage);
  REQUIRE(remarks.size() >= 2);
  CHECK(remarks[0].kind == RemarkKind::size);
  CHECK(remarks[1].kind == RemarkKind::swatch);  // 0.5 / 0.3: taller than wide
  const auto report = app::report_json(session);
  REQUIRE(report["remarks"].size() == remarks.size());
  for (std::size_t i = 0; i < remarks.size(); ++i) CHECK(report["remarks"][i]["what"] == remarks[i].words);
  CHECK(report["remarks"][0]["about"] == "size");
  CHECK(report["size"]["asked"]["height_cm"] == 12.0);
  CHECK(report["size"]["knitted"]["height_cm"].get<double>() > 13.2);
  const std::string card = app::card_text(session);
  const std::string text = app::pattern_file_text(session, app::PatternFormat::text, {});
  const std::string page = app::pattern_file_text(session, app::PatternFormat::html, {});
  CHECK(has(card, "Not as asked:\n- " + remarks[0].words));
  for (const std::string* out : {&text, &page}) CHECK(has(*out, "Not as asked: Knitted, it comes out about"));
  app::Session before = flat_ball();
  before.document->timeline.seek(100);
  CHECK(app::report_json(before)["remarks"].empty());
  CHECK_FALSE(has(app::card_text(before), "Not as asked"));
}

namespace {

// What is remarked of the kind stands everywhere, in the same words; how often it is.
std::size_t stands_everywhere(app::Session& session, RemarkKind kind) {
  Timeline& timeline = session.document->timeline;
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  session.document->closeness = app::closeness_now(*session.document);
  REQUIRE(session.document->closeness->coverage);
  const auto remarks = app::remarks_of(timeline, &*session.document->closeness->coverage);
  const auto listed = app::listed_remarks(session);
  const auto report = app::report_json(session)["remarks"];
  const std::string card = app::card_text(session);
  const std::string text = app::pattern_file_text(session, app::PatternFormat::markdown, {});
  const std::string page = app::pattern_file_text(session, app::PatternFormat::html, {});
  std::size_t count = 0;
  for (const Remark& remark : remarks) {
    if (remark.kind != kind) continue;
    INFO(remark.words);
    CHECK(std::any_of(listed.begin(), listed.end(), [&](const app::ListedRemark& one) {
      return one.words == "Piece: " + remark.words && one.thing.has_value();
    }));
    CHECK(std::any_of(report.begin(), report.end(),
                      [&](const auto& one) { return one["what"] == remark.words; }));
    CHECK(has(card, remark.words));
    if (count++ > 0) continue;  // the pattern says the first of each kind
    CHECK(has(text, "Not as asked: " + remark.words));
    CHECK(has(page, "Not as asked: " + remark.words));
  }
  return count;
}

}  // namespace

TEST_CASE("surface left out and a wale far too long stand in list and report and card and pattern",
          "[problems]") {
  // Times along the axis leave both flat ends out.
  app::Session session;
  Parameters parameters;
  parameters.rows.source = RowSource::contours;
  give_width(parameters, 0.3);
  session.document = app::Document({make_input(test_support::cylinder(24, 1.0, 2.0, 8)), parameters});
  CHECK(stands_everywhere(session, RemarkKind::uncovered) > 0);
  // Rings that grow from 22 to 43 stitches at once: one of its wales is 3.2 h long.
  app::Session sphere = test_support::example_session("thesis-sphere");
  CHECK(stands_everywhere(sphere, RemarkKind::stretched) > 0);
}
