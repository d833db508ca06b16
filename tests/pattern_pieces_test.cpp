// Patterns in pieces: what is told, and how files, the tab and exports show it. Whether it can be knitted: limbs_*_test.cpp.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/files/pattern_export.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern_lines.h"
#include "app/panels/pattern/pattern_parts.h"
#include "knit/limbs/limb_plan.h"
#include "knit/mesh/branching_shapes.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/written_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

// --- shapes ---

Parameters parameters_for(const Input& input, double width_share) {
  Parameters parameters = default_parameters(input.bounds);
  give_width(parameters, width_share * input.bounds.diagonal());
  parameters = resolved(parameters, input);
  parameters.timing.axis.kind = AxisKind::y;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  return parameters;
}

State run_of(const Mesh& mesh, double width_share) {
  const auto input = make_input(mesh);
  Timeline run(input, parameters_for(*input, width_share));
  run.extend_to_end();
  REQUIRE(run.complete());
  return run.furthest();
}

Mesh turned_down(Mesh mesh) {
  for (glm::dvec3& p : mesh.positions) p = {p.x, -p.y, -p.z};
  return mesh;
}

Mesh standing_torus() {
  Mesh mesh = torus(32, 16, 1.0, 0.4);
  for (glm::dvec3& p : mesh.positions) p = {p.x, -p.z, p.y};
  return mesh;
}

WrittenPattern words_for(const State& state, const PatternOptions& options = {}) {
  return write_pattern(plan_limbs(state), {22.0, 32.0}, options, "shape");
}

std::string told(const WrittenPattern& pattern) {
  std::string text;
  for (const auto& line : pattern.instructions)
    text += (line.round ? line.round->text() : line.remark) + "\n";
  return text;
}

bool has_words(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::string all_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE("pieces: one chain of rows is not in pieces") {
  CHECK_FALSE(has_limbs(run_of(sphere(24, 16), 0.08)));
  CHECK_FALSE(has_limbs(State{}));
}

TEST_CASE("pieces: a torus that stands is divided and joined") {
  for (const double width : {0.03, 0.04, 0.06}) {
    CAPTURE(width);
    const State state = run_of(standing_torus(), width);
    const LimbPlan plan = plan_limbs(state);
    REQUIRE(plan.count() == 4);
    CHECK(plan.yarns == state.tubes->yarns);
    CHECK(plan.held_most == state.tubes->held_most);
    const std::string text = told(words_for(state));
    CHECK(has_words(text, "Divide: "));
    CHECK(has_words(text, "Rejoin yarn: place "));
    CHECK(has_words(text, "Join with Branch "));
    CHECK(has_words(text, "Work as for Branch B."));
    CHECK(plan.piece(1).end.kind == LimbEndKind::held);
    CHECK(plan.piece(3).end.kind == LimbEndKind::closed);
  }
}

TEST_CASE("pieces: a torus that lies is cast on provisionally and grafted") {
  const State state = run_of(torus(48, 24, 1.0, 0.4), 0.04);
  const LimbPlan plan = plan_limbs(state);
  REQUIRE(plan.count() == 2);
  const std::string text = told(words_for(state));
  CHECK(has_words(text, "With waste yarn, provisionally CO "));
  CHECK(has_words(text, "Remove the waste yarn of "));
  CHECK(has_words(text, "Graft to "));
  CHECK(has_words(text, " to the inside, wrong sides together"));
  CHECK(plan.piece(0).inner != plan.piece(1).inner);
}

TEST_CASE("pieces: rims are bound off together where that is wished and their stitches pair one by one") {
  LimbOptions three;
  three.three_needle = true;
  std::size_t together = 0, apart = 0;
  for (const double width : {0.04, 0.05, 0.06}) {
    const State state = run_of(torus(48, 24, 1.0, 0.4), width);
    const LimbPlan plan = plan_limbs(state, three);
    const LimbEnd& end = plan.pieces.back().end;
    REQUIRE(end.kind == LimbEndKind::grafted);
    const bool one_by_one = std::all_of(end.grafts.begin(), end.grafts.end(),
                                        [](const LimbGraft& graft) { return graft == LimbGraft{}; });
    CHECK(end.three_needle == one_by_one);
    CHECK_FALSE(plan_limbs(state).pieces.back().end.three_needle);
    (one_by_one ? together : apart) += 1;
    const WrittenPattern pattern = write_pattern(plan, {22.0, 32.0}, {}, "ring");
    const std::string text = told(pattern);
    CHECK(has_words(text, "Three-needle bind off with ") == one_by_one);
    CHECK(has_words(text, "Graft to ") == !one_by_one);
    CHECK(has_words(text, "do not pair one by one") == !one_by_one);
    CHECK(has_words(all_of(pattern.materials), "A third needle of that size") == one_by_one);
    CHECK(read_pattern(pattern_as_text(pattern)).mistakes.empty());
    CHECK(read_pattern(pattern_as_markdown(pattern)).mistakes.empty());
  }
  CHECK(together + apart == 3);
  CHECK(apart > 0);
}

TEST_CASE("pieces: two feet are made together, two horns are divided") {
  const State feet = run_of(test_support::arch(), 0.05);
  const std::string text = told(words_for(feet));
  CHECK(has_words(text, "Limbs A and B (make 2): "));
  CHECK(has_words(text, "\nLimb A: Break yarn. Place "));
  CHECK(has_words(text, "\nLimb B: Do not break yarn. Go on with "));
  CHECK(plan_limbs(run_of(turned_down(test_support::arch()), 0.05)).yarns == 2);
}

TEST_CASE("pieces: a person's names stand before the letters") {
  const State feet = run_of(test_support::arch(), 0.05);
  PatternOptions options;
  options.piece_names = {{"A", "Foot"}, {"B", "Foot"}, {"C", "not a name"}};
  const std::string text = told(words_for(feet, options));
  CHECK(has_words(text, "Feet A and B (make 2): "));
  CHECK(has_words(text, "Join with Foot A: "));
  options.piece_names["B"] = "Heel";
  CHECK(has_words(told(words_for(feet, options)), "Work as for Foot A."));
  CHECK(is_piece_word("Tail"));
  for (const char* wrong : {"", "A", "tail", "TAIL", "Tail A", "Rnd", "T4il"})
    CHECK_FALSE(is_piece_word(wrong));
}

TEST_CASE("pieces: notes and materials tell holders, markers and gaps") {
  const WrittenPattern pattern = words_for(run_of(standing_torus(), 0.05));
  CHECK(has_words(all_of(pattern.materials), "Stitch holders: 2;"));
  CHECK(has_words(all_of(pattern.materials), "Removable markers"));
  CHECK(has_words(all_of(pattern.notes), "Each gap is cast on once and picked up once"));
  CHECK_FALSE(has_words(all_of(pattern.notes), "provisional"));
  CHECK(has_words(told(pattern), "(Order of work; 2 holders at once at most, the yarn is begun twice:)"));
  CHECK(has_words(pattern_as_text(pattern), "\n\nBranch B: "));
  CHECK(has_words(pattern_as_markdown(pattern), "\n\n### Branch B: "));
  CHECK(read_pattern(pattern_as_text(pattern)).mistakes.empty());
}

TEST_CASE("pieces: how a seam is grafted is told, with the pattern's own stitches") {
  const State state = run_of(cup(0.08), 0.06);
  const LimbPlan plan = plan_limbs(state);
  const LimbEnd& end = plan.pieces.back().end;
  REQUIRE(end.kind == LimbEndKind::grafted);
  const WrittenPattern pattern = words_for(state);
  const std::string notes = all_of(pattern.notes), first = std::to_string(end.other_first + 1);
  CHECK(has_words(notes,
                  "\"Backwards from st " + first + "\": the first st on the needle meets held st " + first));
  CHECK(has_words(notes, "\"Graft 1 to 2\": ") ==
        std::any_of(end.grafts.begin(), end.grafts.end(),
                    [](const LimbGraft& graft) { return graft != LimbGraft{}; }));
  CHECK(has_words(all_of(pattern.materials), "Stuffing, if the space between"));
  // The lining hangs together with nothing before it is grafted; a ring's inner half does, and turns as it is pushed through.
  CHECK(has_words(told(pattern), " inside out and put it inside, wrong sides together"));
  CHECK_FALSE(has_words(told(pattern), "Push "));
  const WrittenPattern ball = words_for(run_of(test_support::arch(), 0.05));
  CHECK_FALSE(has_words(all_of(ball.notes), "Graft"));
  CHECK(has_words(all_of(ball.materials), "Stuffing.\n"));
}

TEST_CASE(
    "pieces: what waits on a thread is as long as the most stitches that wait, and says so in numbers of its "
    "own") {
  const State state = run_of(standing_torus(), 0.03);
  const LimbPlan plan = plan_limbs(state);
  const WrittenPattern pattern = words_for(state);
  for (const LimbItem& item : plan.piece(2).deals.front().items) {
    if (item.kind != LimbItemKind::take || item.count == item.held) continue;
    CHECK(has_words(all_of(pattern.notes),
                    "Fewer held sts than all, as of Branch C (" + std::to_string(item.first + 1)));
    break;
  }
  // Two holders, an end of 20 cm each; a stitch of this gauge is 2 cm wide.
  const std::int32_t most = std::max(plan.piece(1).last_count(), plan.piece(1).deals.front().held);
  const std::string metres = std::to_string(2 * (2 * most + 20) / 100 + 1);
  CHECK(has_words(all_of(write_pattern(plan, {5.0, 7.0}, {}, "ring").materials),
                  "colour, about " + metres + " m"));
}

TEST_CASE("pieces: narrow limbs are pulled shut and stuffed lightly, wide ones before they are joined") {
  const std::string narrow = told(words_for(run_of(test_support::arch(), 0.07))),
                    wide = told(words_for(run_of(test_support::arch(), 0.03)));
  CHECK(has_words(
      narrow,
      "(Pull the cast-on hole shut with its tail. Stuff each lightly, or leave it empty: it is narrow.)"));
  CHECK(has_words(wide, "(Pull the cast-on hole shut with its tail. Stuff each before it is joined.)"));
}

TEST_CASE("pieces: yarn counts the stitches of all rounds, and of gaps once") {
  const State state = run_of(standing_torus(), 0.05);
  const Gauge gauge{22.0, 32.0};
  const PatternSizes sizes = sizes_of(plan_limbs(state), gauge);
  Rounds all;
  all.cast_on = static_cast<std::int32_t>(state.fabric.stitch_count());
  CHECK(sizes.yarn_m == sizes_of(all, gauge).yarn_m);
  CHECK(sizes.height_cm == 0.0);
}

namespace {

app::Document torus_document() {
  const auto input = make_input(standing_torus());
  const Parameters parameters = parameters_for(*input, 0.05);
  app::Document document(Timeline(input, parameters));
  document.original = std::make_shared<const Mesh>(input->mesh);
  document.defaults = parameters;
  document.timeline.extend_to_end();
  return document;
}

app::Session torus_session() {
  app::Session session;
  session.document = torus_document();
  app::apply(session, app::ToLast{});
  return session;
}

}  // namespace

TEST_CASE("pieces: text, Markdown and page have headings and a chart for each piece") {
  const app::Session session = torus_session();
  CHECK_FALSE(app::pattern_missing(session));
  const std::string text = pattern_file_text(session, app::PatternFormat::text);
  CHECK(has_words(text, "\n\nBranch C: "));
  CHECK(has_words(text, "\nCHARTS\n"));
  CHECK(has_words(text, "\nBranch C\n"));
  CHECK(has_words(pattern_file_text(session, app::PatternFormat::markdown), "\n### Branch C: "));
  const std::string page = pattern_file_text(session, app::PatternFormat::html);
  CHECK(has_words(page, "<li class=\"piece\">Branch C: "));
  CHECK(has_words(page, "<li class=\"round step\">Join with Branch "));
  CHECK(has_words(page, "<rect class=\"piece\""));
  CHECK(has_words(page, "<td>Branch C</td>"));
  CHECK(has_words(page, "\n.sheet:not(.wide) { break-before: auto; }"));  // charts begin where the words end
  CHECK_FALSE(has_words(page, "(Order of work; "));
  const std::vector<std::string> lines = pattern_instructions(session);
  CHECK(lines.front() == "(Worked in 4 pieces, one after the other, from A to D.)");
  CHECK(has_words(lines.at(1), "(Order of work; "));
}

TEST_CASE("pieces: no format is refused, and a ball has no picture of pieces") {
  const app::Session session = torus_session();
  CHECK_FALSE(app::chart_missing(session));
  CHECK_FALSE(app::pieces_missing(session));
  CHECK_FALSE(app::format_missing(session, app::PatternFormat::knitspeak));
  const std::string speak = pattern_file_text(session, app::PatternFormat::knitspeak);
  CHECK(has_words(speak, "other tools may not read them"));
  CHECK(has_words(speak, "\nRound 2: "));
  CHECK(read_pattern(speak).mistakes.empty());
  const app::Session ball = test_support::finished_small_session();
  CHECK_FALSE(app::chart_missing(ball));
  REQUIRE(app::pieces_missing(ball));
  CHECK(test_support::is_one_sentence(*app::pieces_missing(ball)));
}

TEST_CASE("pieces: JSON has a line for each, with what it is laid on") {
  const app::Session session = torus_session();
  const auto json = nlohmann::json::parse(pattern_file_text(session, app::PatternFormat::json));
  CHECK(json.at("version") == 2);
  CHECK(json.at("yarns") == 2);
  CHECK(json.at("gaps").size() == 2);
  REQUIRE(json.at("pieces").size() == 4);
  for (const auto& piece : json.at("pieces")) {
    const auto& last = piece.at("begin").back();
    CHECK(piece.at("rounds").front().at("before") == last.at("after"));
    if (!last.contains("items")) continue;
    int laid = 0;
    for (const auto& item : last.at("items")) laid += item.at("count").get<int>();
    CHECK(laid == last.at("after").get<int>());
  }
}

TEST_CASE("pieces: the tab has headings, and its lines say rows of the fabric") {
  const State state = run_of(standing_torus(), 0.05);
  const std::vector<app::PatternLine> lines = app::lines_of(words_for(state));
  std::int32_t pieces = 0;
  std::vector<std::int32_t> told(static_cast<std::size_t>(state.fabric.row_count()), 0);
  for (const app::PatternLine& line : lines) {
    pieces += line.kind == app::PatternLine::Kind::piece ? 1 : 0;
    if (!line.rounds) continue;
    for (std::int32_t row = line.rounds->first; row <= line.rounds->last; ++row)
      ++told.at(static_cast<std::size_t>(row) - 1);
  }
  CHECK(pieces == 4);
  CHECK(told == std::vector<std::int32_t>(told.size(), 1));
}

TEST_CASE("pieces: the chart of a piece is chosen by its letter") {
  desk::Desk desk;
  desk.session.document = torus_document();
  desk.act({app::ToLast{}, app::ShowSide{app::SidePanel::pattern}});
  desk.settle();
  CHECK(desk.ui.controls.count("pattern/text") == 1);
  const app::ChartCache& cache = desk.ui.own<app::ChartCache>();
  CHECK(cache.in_pieces());
  CHECK(cache.has_pattern());
  CHECK(cache.piece_charts().size() == 4);
  desk.act({app::ShowCentre{app::CentrePanel::chart}});
  desk.settle();
  CHECK(desk.ui.controls.count("chart") == 1);
  for (const char* letter : {"A", "B", "C", "D"})
    CHECK(desk.ui.controls.count("chart/piece/" + std::string(letter)) == 1);
}

TEST_CASE(
    "pieces: in a narrow room the chart goes on in bands, and squares of all of them are under the pointer") {
  desk::Desk desk(1280, 960, 2.5f);
  desk.session.document = torus_document();
  desk.act({app::ToLast{}, app::ShowCentre{app::CentrePanel::chart, "B"}});
  desk.settle();
  const app::ChartCache& cache = desk.ui.own<app::ChartCache>();
  const auto columns = static_cast<std::size_t>(cache.piece_charts().at(1).chart.columns);
  const app::Box room = desk.ui.controls.at("chart");
  std::vector<std::int32_t> rows;  // met on the way down
  for (float y = room.y + 2.0f; y < room.bottom(); y += 4.0f) {
    desk.act(desk.frames({app::MouseMove{room.x + 0.6f * room.width, y}}));
    const auto hovered = desk.session.view->gaze.hovered_stitch;
    if (hovered && (rows.empty() || rows.back() != hovered->row)) rows.push_back(hovered->row);
  }
  const auto up = std::adjacent_find(rows.begin(), rows.end(), [](auto a, auto b) { return b > a; });
  CAPTURE(columns, room.width, rows);
  CHECK(up != rows.end());
  CHECK(rows.size() > 4);
}
