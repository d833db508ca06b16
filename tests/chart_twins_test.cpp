// Pieces that are made together by the same words light together; whose chart is shown, by a button or by a script.
#include "app/session/chart_twins.h"

#include <algorithm>

#include "app/describe/describe.h"
#include "app/files/link.h"
#include "app/files/pattern_export.h"
#include "app/files/session_json.h"
#include "app/panels/kit/ways.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/script/command_line.h"
#include "knit/pattern/limb_words.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace app;
using namespace desk;

namespace {

// Two legs, A and B, made together, that join in body C.
Session trousers_at_end() {
  Session session = test_support::example_session("trousers");
  apply(session, ToLast{});
  return session;
}

void open_trousers(Desk& desk) {
  desk.session.document = trousers_at_end().document;
  desk.act({ToLast{}, ShowSide{SidePanel::pattern}});
  desk.settle();
}

RoundSpan rows_of_piece(const PlannedPieces& planned, std::int32_t piece) {
  return {planned.plan.piece(piece).rows.front(), planned.plan.piece(piece).rows.back()};
}

const HoverRounds& hover_in(const Actions& actions) {
  REQUIRE(count_of<HoverRounds>(actions) == 1);
  return std::find_if(actions.begin(), actions.end(), [](const Action& a) { return a.is<HoverRounds>(); })
      ->get<HoverRounds>();
}

std::size_t stitches_in(const Session& session, const RoundSpan& rounds) {
  std::size_t stitches = 0;
  for (std::int32_t row = rounds.first; row <= rounds.last; ++row)
    stitches +=
        session.document->timeline.state().fabric.rows()[static_cast<std::size_t>(row) - 1]->stitches.size();
  return stitches;
}

}  // namespace

TEST_CASE("chart twins: a stitch of one leg is the same stitch of the other, from the marker") {
  const Session session = trousers_at_end();
  const PlannedPieces planned = planned_pieces(session);
  const knit::LimbPiece &first = planned.plan.piece(0), &second = planned.plan.piece(1);
  REQUIRE(first.twins == std::vector<std::int32_t>{0, 1});
  for (std::size_t round = 0; round < first.rows.size(); ++round) {
    const StitchAt marker{second.rows[round], second.starts[round]};
    const std::vector<StitchAt> each = stitch_in_each(planned.plan, {0, 1}, marker);
    CHECK(each == std::vector<StitchAt>{{first.rows[round], first.starts[round]}, marker});
    CHECK(row_in_first(planned.plan, {0, 1}, second.rows[round]) == first.rows[round]);
  }
  const std::int32_t in_body = planned.plan.piece(2).rows.front();
  CHECK(stitch_in_each(planned.plan, {0, 1}, {in_body, 0}).empty());
  CHECK(row_in_first(planned.plan, {0, 1}, in_body) == in_body);
}

TEST_CASE("chart twins: words for two legs light both, in the view, on the timeline and in the graph") {
  Desk desk;
  open_trousers(desk);
  const PlannedPieces planned = planned_pieces(desk.session);
  const RoundSpan a = rows_of_piece(planned, 0), b = rows_of_piece(planned, 1);
  Describer describer;
  const std::size_t before = describer.describe(desk.session).lines.size();
  const std::string heading = "pattern/piece/" + std::to_string(a.first);
  // The text follows the last round: from its top down to the heading.
  desk.frames({desk.over("pattern/text"), Wheel{0, 1000}});
  for (int i = 0; i < 100 && desk.ui.controls.count(heading) == 0; ++i) desk.frames({Wheel{0, -1}});
  desk.frames({Wheel{0, -1}, MouseLeave{}});
  REQUIRE(desk.ui.controls.count(heading) == 1);
  const Actions hovered = desk.frames({desk.over(heading)});
  CHECK(hover_in(hovered).rounds == a);
  CHECK(hover_in(hovered).twins == std::vector{b});
  desk.act(hovered);
  CHECK(all_rounds_meant(desk.session) == std::vector{a, b});
  CHECK(describer.describe(desk.session).lines.size() ==
        before + stitches_in(desk.session, a) + stitches_in(desk.session, b));
  desk.act(desk.frames({MouseLeave{}}));
  CHECK(all_rounds_meant(desk.session).empty());
  CHECK(describer.describe(desk.session).lines.size() == before);
}

TEST_CASE("chart twins: either leg in the list of pieces, or in the graph of tubes, lights both") {
  Desk desk;
  open_trousers(desk);
  const PlannedPieces planned = planned_pieces(desk.session);
  const RoundSpan a = rows_of_piece(planned, 0), b = rows_of_piece(planned, 1);
  for (const auto& [letter, own, other] : {std::tuple("A", a, b), std::tuple("B", b, a)}) {
    const Actions hovered = desk.frames({desk.over("piece/" + std::string(letter) + "/handle")});
    CHECK(hover_in(hovered).rounds == own);
    CHECK(hover_in(hovered).twins == std::vector{other});
    desk.act(desk.frames({MouseLeave{}}));
  }
  desk.act({ShowSide{SidePanel::tubes}});
  desk.settle();
  const Actions hovered = desk.frames({desk.over("tube/A")});
  CHECK(hover_in(hovered).twins.size() == 1);
}

TEST_CASE("chart twins: a square of the chart lights the stitch of each leg") {
  Desk desk;
  open_trousers(desk);
  desk.act({ShowCentre{CentrePanel::chart, "B"}});
  desk.settle();
  const Box sheet = desk.ui.controls.at("chart");
  for (float y = 0.1f; y < 1.0f && !desk.session.view->gaze.hovered_stitch; y += 0.05f)
    desk.act(desk.frames({MouseMove{sheet.x + 0.5f * sheet.width, sheet.y + y * sheet.height}}));
  const Gaze& gaze = desk.session.view->gaze;
  REQUIRE(gaze.hovered_stitch);
  REQUIRE(gaze.hovered_twin_stitches.size() == 1);
  const PlannedPieces planned = planned_pieces(desk.session);
  CHECK(stitch_in_each(planned.plan, {0, 1}, *gaze.hovered_stitch) ==
        std::vector<StitchAt>{*gaze.hovered_stitch, gaze.hovered_twin_stitches[0]});
}

TEST_CASE("chart twins: a button chooses the chart until another round comes to hand") {
  Desk desk;
  open_trousers(desk);
  desk.act({ShowCentre{CentrePanel::chart}});
  desk.settle();
  desk.act(desk.click("chart/piece/C"));
  CHECK(desk.session.view->gaze.chart_piece == "C");
  desk.settle();
  CHECK(desk.session.view->gaze.chart_piece == "C");
  desk.act({SeekPlace{{knit::Stage::rows, 2, INT32_MAX}}});
  desk.act(desk.frame());
  CHECK(desk.session.view->gaze.chart_piece.empty());
}

TEST_CASE("chart twins: a script chooses the chart and links and sessions keep it") {
  Session session = trousers_at_end();
  apply(session, ShowCentre{CentrePanel::chart, "C"});
  CHECK(session.view->gaze.chart_piece == "C");
  CHECK(link_by_options(session).value().find(" --centre chart:C") != std::string::npos);
  const auto saved = read_saved(to_json(saved_of(session)).dump());
  REQUIRE(std::holds_alternative<SavedSession>(saved));
  CHECK(std::get<SavedSession>(saved).chart_piece == "C");
  const auto parsed =
      parse_command_line({"--example", "trousers", "--headless", "--centre", "chart:C"}, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  Session opened;
  opened.program->assets = KNIT_ASSETS_DIR;
  CHECK_FALSE(open_as_asked(opened, std::get<CommandLine>(parsed)));
  CHECK(opened.view->gaze.chart_piece == "C");
  auto wrong = std::get<CommandLine>(parsed);
  wrong.chart_piece = "D";
  CHECK(open_as_asked(opened, wrong) == "--centre: There is no piece D; the last of them is C.");
  CHECK(opened.view->gaze.chart_piece.empty());
  for (const char* bad : {"chart:", "chart:c", "chart:ABC", "view:A"})
    CHECK(std::holds_alternative<Answer>(
        parse_command_line({"--example", "trousers", "--centre", bad}, KNIT_ASSETS_DIR)));
  apply(session, ShowCentre{CentrePanel::view});
  CHECK(session.view->gaze.chart_piece == "C");  // as it was
  apply(session, ShowCentre{CentrePanel::chart, ""});
  CHECK(session.view->gaze.chart_piece.empty());
}

TEST_CASE("chart twins: the chart of one piece is a file of its own") {
  Session session = trousers_at_end();
  apply(session, ShowCentre{CentrePanel::chart, "C"});
  const std::string body = piece_chart_file_text(session);
  CHECK(body.find(": Body C</title>") != std::string::npos);
  CHECK(body.find("Limb") == std::string::npos);
  apply(session, ShowCentre{CentrePanel::chart, "B"});
  CHECK(piece_chart_file_text(session).find(": Limbs A and B</title>") != std::string::npos);
}
