// Placed and settled positions beside each other: in what is written, in figures, in words and in what is kept.
#include <nlohmann/json.hpp>

#include "app/entries/action_entries.h"
#include "app/explain/why_words.h"
#include "app/files/card.h"
#include "app/files/export.h"
#include "app/files/gltf.h"
#include "app/files/link.h"
#include "app/files/report.h"
#include "app/files/session_json.h"
#include "app/panels/report/card_cache.h"
#include "app/script/command_line.h"
#include "app/script/queries.h"
#include "app/session/presets.h"
#include "app/session/shown.h"
#include "knit/insight/why.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace app;
using Json = nlohmann::json;
using test_support::contains;
using test_support::example_session;

namespace {

// Forks, and is knitted from contours.
Session forked(knit::Settling settling) {
  Session session = example_session("y");
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::give_width(parameters, 0.2);
  parameters.settle.settling = settling;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  REQUIRE(session.document->timeline.state().finished());
  return session;
}

// Without its first lines, which say what it is of.
std::string vertices_of(const Session& session) {
  std::string text;
  for (const std::string& line : test_support::lines_of(mesh_text(session)))
    if (line.rfind("v ", 0) == 0) text += line + "\n";
  return text;
}

std::string all_but_vertices(const Session& session) {
  std::string text;
  for (const std::string& line : test_support::lines_of(mesh_text(session)))
    if (line.rfind("v ", 0) != 0 && line.front() != '#') text += line + "\n";
  return text;
}

Json report_of(const Session& session) { return Json::parse(report_text(session)); }

CommandLine line_of(const std::vector<std::string>& arguments) {
  auto parsed = parse_command_line(arguments, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  return std::get<CommandLine>(std::move(parsed));
}

}  // namespace

TEST_CASE("positions: what is written has stitches where they are wished, and all else the same") {
  Session session = forked(knit::Settling::by_itself);
  const Session stays = forked(knit::Settling::off);
  REQUIRE(has_settled(session));
  CHECK_FALSE(has_settled(stays));
  const std::string settled = vertices_of(session), rest = all_but_vertices(session);
  const std::string settled_gltf = gltf_file(session, GltfFormat::text);
  CHECK(contains(mesh_text(session), "# Stitches where they settled.\n"));
  apply(session, SetPositions{Positions::placed});
  CHECK(contains(mesh_text(session), "# Stitches as they were placed.\n"));
  CHECK(vertices_of(session) != settled);
  CHECK(vertices_of(session) == vertices_of(stays));
  CHECK(all_but_vertices(session) == rest);
  CHECK(gltf_file(session, GltfFormat::text) != settled_gltf);
  CHECK(gltf_file(session, GltfFormat::text) == gltf_file(stays, GltfFormat::text));
  CHECK(map_text(session) == map_text(stays));
  // Where nothing has settled, both are the same.
  Session other = stays;
  apply(other, SetPositions{Positions::placed});
  CHECK(mesh_text(other) == mesh_text(stays));
}

TEST_CASE("positions: the report has both figures, and its card those that are wished") {
  Session session = forked(knit::Settling::on);
  const Session stays = forked(knit::Settling::off);
  const Json settled = report_of(session), plain = report_of(stays);
  CHECK(plain["settled"].is_null());
  CHECK(plain["positions"] == "settled");
  const Json& both = settled["settled"];
  CHECK(both["iterations"].get<int>() > 3);
  CHECK(both["moved"]["mean"].get<double>() > 0.0);
  CHECK(both["moved"]["max"].get<double>() >= both["moved"]["mean"].get<double>());
  for (const char* key : {"wale_cv", "wale_max", "course_cv", "corner_off", "corner_off_p95", "turned",
                          "uncovered", "knit_to_mesh", "mesh_to_knit"}) {
    INFO(key);
    CHECK(both["placed"][key].is_number());
    CHECK(both["settled"][key].is_number());
  }
  CHECK(both["settled"]["wale_cv"].get<double>() < both["placed"]["wale_cv"].get<double>());
  CHECK(both["settled"]["wale_cv"] == settled["quality"]["wale"]["cv"]);
  CHECK(both["placed"]["wale_cv"] == plain["quality"]["wale"]["cv"]);
  CHECK(both["placed"]["mesh_to_knit"] == plain["quality"]["distance"]["mesh_to_knit"]["max_share"]);
  apply(session, SetPositions{Positions::placed});
  const Json placed = report_of(session);
  CHECK(placed["positions"] == "placed");
  CHECK(placed["settled"] == both);
  CHECK(placed["quality"] == plain["quality"]);
  CHECK(placed["uncovered"] == plain["uncovered"]);
  CHECK(placed["stretched"] == plain["stretched"]);
  CHECK(placed["wale"] == plain["wale"]);
  CHECK(placed["pattern"] == settled["pattern"]);
}

TEST_CASE("positions: the card has both side by side, and names the one that it is of") {
  Session session = forked(knit::Settling::on);
  const std::string card = card_text(session);
  for (const char* words :
       {"placed", "settled", "Longest wale / h", "Corners off square", "Faces turned over", "Moved / w"}) {
    INFO(words);
    CHECK(contains(card, words));
  }
  CHECK_FALSE(contains(card, "as placed"));
  apply(session, SetPositions{Positions::placed});
  CHECK(contains(card_text(session), "Report card of y as placed: "));
  CHECK_FALSE(contains(card_text(forked(knit::Settling::off)), "settled"));
}

TEST_CASE("positions: the card's figures have words of their own, and measure both once") {
  Session session = forked(knit::Settling::on);
  CardCache cache;
  cache.refresh(session.document->timeline);
  cache.refresh(session.document->timeline);
  CHECK(cache.times_measured() == 1);
  REQUIRE(cache.both() != nullptr);
  CHECK(cache.both()->settled.wale.cv == cache.quality()->wale.cv);
  CHECK(cache.both()->placed.wale.cv > cache.quality()->wale.cv);
  const auto closeness = closeness_now(*session.document);
  const CardFigures known{cache.quality(), closeness.get(), cache.both()};
  const auto groups = card_groups(known);
  CHECK(groups.size() == 3);
  std::set<std::string> names, helps;
  for (const CardGroup& group : groups) {
    for (const CardLine& line : group.lines) {
      CHECK((line.missing.empty() || line.name == "mirror"));  // what forks has no mirror plane
      for (const auto& figure : line.figures) {
        if (!figure) continue;
        INFO(figure->name);
        CHECK(names.insert(figure->name).second);
        CHECK(figure->help.back() == '.');
        helps.insert(figure->help);
      }
    }
  }
  CHECK(helps.size() == names.size());
  CHECK(names.count("figure/settled/turned") == 1);
  session.document->timeline.seek(session.document->timeline.position_of({knit::Stage::faces, 3, 0}));
  for (int i = 0; i < 2; ++i) cache.refresh(session.document->timeline);
  CHECK(cache.both() == nullptr);
}

TEST_CASE("positions: the panel has a switch once stitches have settled") {
  desk::Desk desk(1440, 900);
  desk.open();
  desk.session.view->side = SidePanel::report;
  desk.settle();
  CHECK(desk.ui.controls.count("positions") == 0);
  desk.session.document = forked(knit::Settling::on).document;
  desk.settle();
  CHECK(desk.ui.controls.count("figure/settled/wale-cv") == 1);
  const Actions wishes = desk.click("positions", 0.75f);
  CHECK(desk::only<SetPositions>(wishes).positions == Positions::placed);
  desk.act(wishes);
  CHECK(desk.frame().empty());
  CHECK(desk::only<SetPositions>(desk.click("positions", 0.25f)).positions == Positions::settled);
}

TEST_CASE("positions: why a stitch is there says where it was placed and where it went") {
  Session session = forked(knit::Settling::on);
  knit::Timeline& timeline = session.document->timeline;
  const knit::StitchElement stitch{5, 3};
  const std::string words = why_words(timeline, stitch);
  CHECK(contains(words, " Placed at ("));
  CHECK(contains(words, "; moved "));
  CHECK(contains(words, " w while settling, to ("));
  CHECK_FALSE(contains(why_words(forked(knit::Settling::off).document->timeline, stitch), "Placed at"));
  const auto settled = knit::settled_by(timeline);
  REQUIRE(settled);
  CHECK(knit::touches(timeline, stitch, *settled));
  CHECK_FALSE(knit::touches(timeline, stitch, *settled - 1));
  CHECK(knit::touch_before(timeline, stitch, timeline.known()) == settled);
  CHECK(knit::touch_from(timeline, stitch, *settled) == settled);
  CHECK(contains(why_answer(session, "stitch:5:3").out, "\nsettled\tstep "));
}

TEST_CASE("positions: a script chooses, a session keeps, and a link says them") {
  CHECK_FALSE(line_of({}).positions);
  const CommandLine line = line_of({"--example", "y", "--positions", "placed", "--at", "10"});
  CHECK(line.positions == Positions::placed);
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  CHECK_FALSE(open_as_asked(session, line));
  CHECK(session.view->positions == Positions::placed);
  CHECK(contains(*link_by_options(session), "--positions placed"));
  const auto saved = read_saved(to_json(saved_of(session)).dump());
  CHECK(std::get<SavedSession>(saved).positions == Positions::placed);
  // Of a program that did not know them.
  auto old = to_json(saved_of(session));
  old.erase("positions");
  CHECK(std::get<SavedSession>(read_saved(old.dump())).positions == Positions::settled);
  const auto wrong = parse_command_line({"--positions", "both"}, KNIT_ASSETS_DIR);
  CHECK(std::get<Answer>(wrong).error == "--positions cannot be \"both\"; give settled, placed or relaxed.");
}

TEST_CASE("positions: presets of contours settle, the thesis's and its sphere do not") {
  Session session = example_session("thesis-sphere");
  CHECK(session.document->timeline.parameters().settle.settling == knit::Settling::off);
  const auto settles = [&](const char* preset) {
    apply(session, ApplyPreset{preset});
    apply(session, ToLast{});
    return has_settled(session);
  };
  CHECK(settles("best-rows"));
  CHECK_FALSE(settles("thesis"));
  CHECK(settles("knitters-gauge"));
}
