// Where knitting begins and ends, given from outside: options, files, actions, sessions; undone, linked to, saved.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/actions/hosting.h"
#include "app/curves/curves_file.h"
#include "app/files/export.h"
#include "app/files/link.h"
#include "app/files/session_file.h"
#include "app/script/command_line.h"
#include "app/session/outbox.h"
#include "knit/mesh/shapes.h"
#include "tests/support/catch.h"
#include "tests/support/open_session.h"
#include "tests/support/session.h"

using namespace app;
using namespace test_support;

namespace {

using CurveLine = std::vector<std::string>;

std::variant<CommandLine, Answer> curve_line(const CurveLine& words) {
  return parse_command_line(words, KNIT_ASSETS_DIR);
}

std::string refused_line(const CurveLine& words) {
  const auto parsed = curve_line(words);
  const auto* answer = std::get_if<Answer>(&parsed);
  return answer == nullptr ? std::string() : answer->error;
}

// The fault of opening; nothing where it went well.
std::optional<std::string> open_line(Session& session, const CurveLine& words) {
  session.program->assets = KNIT_ASSETS_DIR;
  auto parsed = curve_line(words);
  if (const auto* answer = std::get_if<Answer>(&parsed)) return answer->error;
  return open_as_asked(session, std::get<CommandLine>(parsed));
}

Session opened_by(const CurveLine& words) {
  Session session;
  if (auto fault = open_line(session, words)) FAIL(*fault);
  return session;
}

// A ball about the origin, of radius 1, as a file.
std::filesystem::path ball_file(const Folder& folder, const std::string& name = "ball.obj",
                                const knit::Mesh& mesh = knit::icosphere(3)) {
  std::ofstream out(folder.path() / name);
  knit::write_obj(out, mesh, "");
  return folder.path() / name;
}

const std::string low_circle = "circle:0,-1,0,0.6";
const std::string high_circle = "circle:0,1,0,0.4";

std::uint64_t run_of(Session& session) {
  apply(session, ToLast{});
  return knit::hash_of(session.document->timeline.furthest());
}

bool warns(const Session& session, const std::string& words) {
  const auto& findings = session.document->findings;
  return std::any_of(findings.begin(), findings.end(), [&](const knit::Finding& finding) {
    return finding.severity == knit::Severity::warning && contains(finding.sentence, words);
  });
}

}  // namespace

TEST_CASE("curves options: start and end take a vertex or a curve", "[curves]") {
  const Folder folder;
  const std::string file = ball_file(folder).string();
  const auto with = [&](CurveLine words) {
    words.insert(words.begin(), file);
    return std::get<CommandLine>(curve_line(words));
  };
  const CommandLine plain = with({"--start", "3", "--end", "8"});
  CHECK(plain.settings.size() == 2);
  CHECK(plain.open.get<OpenFile>().curves.none());

  const CommandLine cut = with({"--start", low_circle, "--end", "8"});
  CHECK(cut.settings.empty());
  const auto& curves = cut.open.get<OpenFile>().curves.curves;
  REQUIRE(curves.size() == 2);
  CHECK(knit::cycle_text(curves[0]) == low_circle);
  CHECK(curves[1].kind == knit::CycleKind::vertex);
  CHECK(curves[1].vertex == 8);
  CHECK(with({"--end", "farthest", "--start", "boundary"}).open.get<OpenFile>().curves.curves.size() == 2);
  CHECK(with({"--start", low_circle, "--end", "auto"}).open.get<OpenFile>().curves.curves.size() == 1);

  CHECK(contains(refused_line({file, "--start", "ring:1,2,3"}), "--start: \"ring\" is no kind of curve."));
  CHECK(contains(refused_line({file, "--start", "circle"}), "--start: circle needs points"));
  CHECK(contains(refused_line({file, "--start", "-1"}), "auto"));
  CHECK(contains(refused_line({file, "--curves-scale", "auto"}), "give --curves too"));
  CHECK(contains(refused_line({file, "--curves", "a.json", "--curves-scale", "2"}), "give auto"));
}

TEST_CASE("curves options: a mesh is cut as it is opened, and what is left out is said", "[curves]") {
  const Folder folder;
  Session session =
      opened_by({ball_file(folder).string(), "--start", low_circle, "--end", high_circle, "--headless"});
  const knit::Input& input = session.document->timeline.input();
  REQUIRE(input.rims.size() == 2);
  CHECK(session.document->source.curves.size() == 2);
  CHECK(session.document->original->positions.size() == knit::icosphere(3).positions.size());
  CHECK(warns(session, "Left out: 8."));
  CHECK(warns(session, "% of the surface beyond the start."));
  run_of(session);
  REQUIRE(session.document->timeline.furthest().finished());
  // Stitches are as large as on the whole ball.
  CHECK(session.document->timeline.parameters().stitch.width ==
        Approx(0.03 * knit::bounds_of(knit::icosphere(3).positions).diagonal()));
}

TEST_CASE("curves options: what cannot be cut is not opened", "[curves]") {
  const Folder folder;
  const std::string file = ball_file(folder).string();
  Session session;
  const auto fault = open_line(session, {file, "--start", "circle:0,-1.5,0,0.6", "--headless"});
  REQUIRE(fault);
  CHECK(contains(*fault, "start: point 1 is 0.5 away from the surface"));
  CHECK_FALSE(session.document);
}

TEST_CASE("curves options: a hole in what is left out is none", "[curves]") {
  const Folder folder;
  knit::Mesh holed = knit::icosphere(4);
  const auto height = [&](const knit::Triangle& t) {
    return holed.positions[t[0]].y + holed.positions[t[1]].y + holed.positions[t[2]].y;
  };
  holed.triangles.erase(
      std::min_element(holed.triangles.begin(), holed.triangles.end(),
                       [&](const auto& a, const auto& b) { return height(a) < height(b); }));
  const std::string file = ball_file(folder, "holed.obj", holed).string();
  Session whole;
  CHECK(open_line(whole, {file, "--headless"}));
  // Curves that cannot be are no reason to mend it.
  Session faulty;
  const auto fault = open_line(faulty, {file, "--start", "circle:0,3,0,1", "--headless"});
  REQUIRE(fault);
  CHECK(contains(*fault, "point 1 is 2 away from the surface"));
  CHECK_FALSE(contains(*fault, "--repair"));
  Session session = opened_by({file, "--start", "plane:0.8,-0.6,0,0,1,0", "--headless"});
  CHECK(session.document->timeline.input().rims.size() == 2);
  run_of(session);
  CHECK(session.document->timeline.furthest().finished());
}

TEST_CASE("curves options: three curves on one piece are one too many", "[curves]") {
  const Folder folder;
  std::vector<knit::Cycle> curves;
  for (const char* text : {"circle:0,-1,0,0.6", "circle:0,1,0,0.4", "circle:1,0,0,0.3"})
    curves.push_back(std::get<knit::Cycle>(
        knit::parse_cycle(text, curves.empty() ? knit::CycleEnd::start : knit::CycleEnd::end)));
  write_text(folder.path() / "three.curves.json", curves_text(curves, knit::icosphere(3)));
  Session session;
  const auto fault = open_line(session, {ball_file(folder).string(), "--curves",
                                         (folder.path() / "three.curves.json").string(), "--headless"});
  REQUIRE(fault);
  CHECK(contains(*fault, "has 3 of them on its border"));
}

TEST_CASE("curves options: examples are cut too", "[curves]") {
  Session session = opened_by({"--example", "sphere", "--start", "plane:0,-0.6,0.8,0,1,0", "--headless"});
  REQUIRE(session.document->source.curves.size() == 1);
  CHECK(session.document->timeline.input().rims.size() == 2);
  CHECK(warns(session, "End: the point farthest from the other"));
  Session none;
  const auto fault = open_line(none, {"--example", "sphere", "--start", "circle:9,9,9,1", "--headless"});
  REQUIRE(fault);
  CHECK(contains(*fault, "away from the surface"));
}

TEST_CASE("curves options: a session keeps them", "[curves]") {
  const Folder folder;
  Session session =
      opened_by({ball_file(folder).string(), "--start", low_circle, "--end", "farthest", "--headless"});
  const std::uint64_t run = run_of(session);
  const auto path = folder.path() / "ball-session.json";
  REQUIRE_FALSE(save_session(session, path));
  CHECK(contains(read_text(path), "\"curves\""));
  Session again;
  again.program->assets = KNIT_ASSETS_DIR;
  if (auto fault = open_session(again, path)) FAIL(*fault);
  CHECK(again.document->source == session.document->source);
  CHECK(run_of(again) == run);
  // Options go over what it says.
  Session other = opened_by({"--session", path.string(), "--end", high_circle, "--headless"});
  REQUIRE(other.document->source.curves.size() == 2);
  CHECK(other.document->source.curves[0] == session.document->source.curves[0]);
  CHECK(knit::cycle_text(other.document->source.curves[1]) == high_circle);
  CHECK(run_of(other) != run);
  // A session with a curve that is none is refused.
  std::string text = read_text(path);
  text.replace(text.find("\"circle\""), 8, "\"cheese\"");
  write_text(path, text);
  Session broken;
  broken.program->assets = KNIT_ASSETS_DIR;
  const auto fault = open_session(broken, path);
  REQUIRE(fault);
  CHECK(contains(*fault, "must be one of boundary, circle"));
}

TEST_CASE("curves options: one action each, undone and redone", "[curves]") {
  const Folder folder;
  Session session = opened_by({ball_file(folder).string(), "--headless"});
  const std::uint64_t whole = run_of(session);
  const auto curve = [](const std::string& text, knit::CycleEnd as) {
    return std::get<knit::Cycle>(knit::parse_cycle(text, as));
  };
  apply(session, AddCurve{curve(low_circle, knit::CycleEnd::start)});
  CHECK(session.document->timeline.input().rims.size() == 2);
  const std::uint64_t from_circle = run_of(session);
  CHECK(from_circle != whole);
  apply(session, AddCurve{curve(high_circle, knit::CycleEnd::end)});
  CHECK(session.document->source.curves.size() == 2);
  const std::uint64_t between_two = run_of(session);
  apply(session, SwapCurves{});
  CHECK(session.document->source.curves[0].as == knit::CycleEnd::end);
  CHECK(run_of(session) != between_two);
  apply(session, Undo{});
  CHECK(run_of(session) == between_two);
  apply(session, Undo{});
  CHECK(run_of(session) == from_circle);
  apply(session, Undo{});
  CHECK(session.document->source.curves.empty());
  CHECK(session.document->timeline.input().rims.empty());
  CHECK(run_of(session) == whole);
  for (int i = 0; i < 2; ++i) apply(session, Redo{});
  CHECK(run_of(session) == between_two);
  apply(session, RemoveCurve{2});
  CHECK(run_of(session) == from_circle);
  // In place of the other start.
  apply(session, AddCurve{curve("circle:0,-1,0,0.5", knit::CycleEnd::start)});
  CHECK(session.document->source.curves.size() == 1);
  apply(session, RemoveCurve{7});
  CHECK(contains(session.outbox->notices.back().text, "There is no curve 7"));
}

TEST_CASE("curves options: what is refused changes nothing", "[curves]") {
  const Folder folder;
  Session session = opened_by({ball_file(folder).string(), "--start", low_circle, "--headless"});
  const std::uint64_t before = run_of(session);
  const std::size_t undo = session.document->changes.undo.size();
  apply(session,
        AddCurve{std::get<knit::Cycle>(knit::parse_cycle("circle:0.6,-0.8,0,0.4", knit::CycleEnd::end))});
  CHECK(session.outbox->notices.back().kind == Notice::Kind::error);
  CHECK(contains(session.outbox->notices.back().text, "cross each other. Move one of them away."));
  CHECK(session.document->source.curves.size() == 1);
  CHECK(session.document->changes.undo.size() == undo);
  CHECK(run_of(session) == before);
}

TEST_CASE("curves options: a circle as long as a cast on follows the stitch", "[curves]") {
  const Folder folder;
  Session session = opened_by({ball_file(folder).string(), "--start", "circle:0,-1,0", "--headless"});
  const auto length = [&] { return session.document->timeline.input().rims[0].length; };
  const double before = length();
  const double width = session.document->timeline.parameters().stitch.width;
  CHECK(before == Approx(6.0 * width).epsilon(0.06));
  const std::uint64_t run = run_of(session);
  knit::Parameters wider = session.document->timeline.parameters();
  knit::give_width(wider, 2.0 * width);
  apply(session, Tune{wider});
  CHECK(length() == Approx(12.0 * width).epsilon(0.06));
  apply(session, Undo{});
  CHECK(length() == before);
  CHECK(run_of(session) == run);
}

TEST_CASE("curves options: files of curves, and a mesh that was scaled", "[curves]") {
  const Folder folder;
  Session session =
      opened_by({ball_file(folder).string(), "--start", low_circle, "--end", high_circle, "--headless"});
  const auto path = folder.path() / "ball.curves.json";
  CHECK_FALSE(export_to_file(session, {"curves", path}));
  Session again = opened_by({ball_file(folder).string(), "--curves", path.string(), "--headless"});
  CHECK(again.document->source.curves == session.document->source.curves);
  CHECK(run_of(again) == run_of(session));

  knit::Mesh large = knit::icosphere(3);
  for (glm::dvec3& p : large.positions) p *= 10.0;
  const std::string file = ball_file(folder, "large.obj", large).string();
  Session refused;
  const auto fault = open_line(refused, {file, "--curves", path.string(), "--headless"});
  REQUIRE(fault);
  CHECK(contains(*fault, "the mesh is 10 times the size it was when the curves were drawn"));
  Session scaled = opened_by({file, "--curves", path.string(), "--curves-scale", "auto", "--headless"});
  CHECK(*scaled.document->source.curves[0].radius == Approx(6.0));
  CHECK(scaled.document->timeline.input().rims.size() == 2);

  Session whole = opened_by({ball_file(folder).string(), "--headless"});
  const auto missing = export_to_file(whole, {"curves", folder.path() / "none.curves.json"});
  REQUIRE(missing);
  CHECK(contains(*missing, "cut along no curves"));
  apply(whole, OpenCurves{{path, false, {}}});
  CHECK(whole.document->source.curves == session.document->source.curves);
}

TEST_CASE("curves options: the command line that opens the same", "[curves]") {
  const Folder folder;
  Session session = opened_by(
      {ball_file(folder).string(), "--start", low_circle, "--end", "plane:0,0.6,0.8,0,1,0.1", "--headless"});
  const auto link = link_by_options(session);
  REQUIRE(link);
  CHECK(contains(*link, "--start circle:0,-1,0,0.6"));
  CHECK(contains(*link, "--end plane:0,0.6,0.8,0,1,0.1"));
  Session named = opened_by({ball_file(folder).string(), "--headless"});
  knit::Cycle curve = std::get<knit::Cycle>(knit::parse_cycle(low_circle, knit::CycleEnd::start));
  curve.name = "brim";
  apply(named, SetCurves{{curve}});
  CHECK_FALSE(link_by_options(named));
}
