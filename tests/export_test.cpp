// What can be taken home: mesh, map, report and steps, and how files get written.
#include "app/files/export.h"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/base/files.h"
#include "app/files/card.h"
#include "app/script/command_line.h"
#include "app/script/subcommands.h"
#include "app/session/document.h"
#include "knit/import/obj.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/reader/pattern_reader.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/session.h"

using namespace app;
using Json = nlohmann::json;
using test_support::contains;
using test_support::example_session;
using test_support::Folder;
using test_support::is_one_sentence;
using test_support::lines_of;
using test_support::read_text;
using test_support::write_text;

namespace {

Session finished_example(const std::string& name) {
  Session session = example_session(name);
  apply(session, ToLast{});
  return session;
}

std::vector<int> golden_rows() {
  std::vector<int> rows{6, 12, 17, 22, 26, 33, 33, 43, 43, 43, 43};
  rows.insert(rows.end(), 42, 65);
  for (const int size : {43, 43, 43, 43, 33, 33, 26, 22, 17, 12, 6}) rows.push_back(size);
  return rows;
}

// An OBJ file as it stands: vertices, and the polygons of each group.
struct Obj {
  std::vector<glm::dvec3> vertices;
  std::vector<std::string> groups;
  std::map<std::string, std::vector<std::vector<std::size_t>>> faces, lines;  // from 0
};

Obj parse_obj(const std::string& text) {
  Obj obj;
  for (const std::string& line : lines_of(text)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::dvec3& v = obj.vertices.emplace_back();
      REQUIRE((words >> v.x >> v.y >> v.z));
    } else if (kind == "g") {
      REQUIRE((words >> obj.groups.emplace_back()));
    } else if (kind == "f" || kind == "l") {
      REQUIRE_FALSE(obj.groups.empty());
      auto& list = (kind == "f" ? obj.faces : obj.lines)[obj.groups.back()];
      list.emplace_back();
      for (std::size_t corner = 0; words >> corner;) list.back().push_back(corner - 1);
    } else {
      CHECK(kind.substr(0, 1) == "#");
    }
  }
  return obj;
}

using Edge = std::pair<std::size_t, std::size_t>;

// Directed edges without their opposite, as next[from] = to; checks that no directed edge comes twice.
std::map<std::size_t, std::size_t> boundary_of(const Obj& obj) {
  std::set<Edge> edges;
  std::size_t twice = 0;
  for (const auto& [group, faces] : obj.faces) {
    for (const auto& face : faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        twice += edges.insert({face[i], face[(i + 1) % face.size()]}).second ? 0U : 1U;
      }
    }
  }
  CHECK(twice == 0);
  std::map<std::size_t, std::size_t> next;
  for (const Edge& edge : edges) {
    if (edges.count({edge.second, edge.first}) == 0) CHECK(next.insert(edge).second);
  }
  return next;
}

std::vector<std::size_t> loop_sizes(std::map<std::size_t, std::size_t> next) {
  std::vector<std::size_t> sizes;
  while (!next.empty()) {
    std::size_t size = 0;
    for (auto at = next.begin(); at != next.end(); ++size) {
      const std::size_t to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    sizes.push_back(size);
  }
  return sizes;
}

// Files may not grow beyond a few bytes while this lives: a full disk.
class FullDisk {
 public:
  FullDisk() : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit tight = before_;
    tight.rlim_cur = 64;
    ::setrlimit(RLIMIT_FSIZE, &tight);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*signal_)(int);
  rlimit before_{};
};

}  // namespace

TEST_CASE("thesis sphere: the mesh has a vertex a stitch along the knitting path, and a group a row") {
  const Session session = finished_example("thesis-sphere");
  const Obj obj = parse_obj(mesh_text(session));
  std::vector<glm::dvec3> path;
  for (const auto& row : session.document->timeline.state().fabric.rows()) {
    for (const knit::Stitch& stitch : row->stitches) path.push_back(stitch.position);
  }
  CHECK(path.size() == 3372);
  CHECK((obj.vertices == path));  // to the bit

  const std::vector<int> rows = golden_rows();
  REQUIRE(obj.groups.size() == rows.size() - 1);
  std::size_t first = 0;
  for (std::size_t i = 0; i < obj.groups.size(); ++i) {
    const std::string number = std::to_string(i + 2);
    CHECK(obj.groups[i] == "row_" + std::string(3 - number.size(), '0') + number);
    const std::size_t beyond = first + static_cast<std::size_t>(rows[i] + rows[i + 1]);
    std::size_t outside = 0;
    for (const auto& face : obj.faces.at(obj.groups[i])) {
      for (const std::size_t corner : face) outside += corner >= first && corner < beyond ? 0U : 1U;
    }
    CHECK(outside == 0);  // between this row and the one before
    first += static_cast<std::size_t>(rows[i]);
  }
}

TEST_CASE("thesis sphere: faces look outward, and the mesh is a tube with two ends") {
  const Obj obj = parse_obj(mesh_text(finished_example("thesis-sphere")));
  std::size_t quads = 0;
  std::size_t triangles = 0;
  std::size_t inward = 0;
  for (const auto& [group, faces] : obj.faces) {
    for (const auto& face : faces) {
      ++(face.size() == 4 ? quads : triangles);
      REQUIRE((face.size() == 3 || face.size() == 4));
      const auto at = [&](std::size_t i) { return obj.vertices[face[i % face.size()]]; };
      const glm::dvec3 normal = glm::cross(at(2) - at(0), face.size() == 4 ? at(3) - at(1) : at(2) - at(1));
      inward += glm::dot(normal, at(0) + at(1) + at(2)) > 0.0 ? 0U : 1U;  // the sphere's centre is the origin
    }
  }
  CHECK(quads == 3307);
  CHECK(triangles == 118);
  CHECK(inward == 0);
  CHECK(loop_sizes(boundary_of(obj)) == std::vector<std::size_t>{6, 6});
}

TEST_CASE("every example that finishes gives a tube with two ends, and its mesh can be read again") {
  std::size_t number = 0;
  for (const char* name : {"sphere", "stretched-sphere", "egg", "capsule", "cone", "vase"}) {
    if (!test_support::is_tried(number++)) continue;
    CAPTURE(name);
    const Session session = finished_example(name);
    REQUIRE(session.document->timeline.state().finished());
    const std::string text = mesh_text(session);
    const auto& rows = session.document->timeline.state().fabric.rows();
    auto loops = loop_sizes(boundary_of(parse_obj(text)));
    CHECK(loops == std::vector<std::size_t>{rows.front()->stitches.size(), rows.back()->stitches.size()});

    std::istringstream in(text);
    const auto read = knit::read_obj(in, name);
    REQUIRE(std::holds_alternative<knit::Mesh>(read));
    const Json report = Json::parse(report_text(session));
    CHECK(report["labels"].size() == rows.size());  // one array a row, even where rows grow and shrink again
    for (std::size_t i = 0; i < rows.size(); ++i) CHECK(report["labels"][i].size() == report["rows"][i]);
    const auto& mesh = std::get<knit::Mesh>(read);
    const std::vector<glm::dvec3> written = parse_obj(text).vertices;
    REQUIRE(mesh.positions.size() == written.size());
    double furthest = 0.0;
    for (std::size_t i = 0; i < written.size(); ++i) {
      furthest = std::max(furthest, glm::distance(mesh.positions[i], written[i]));
    }
    CHECK(furthest < 1e-12);
    CHECK(mesh.triangles.size() ==
          2 * report["faces"]["quads"].get<std::size_t>() + report["faces"]["triangles"].get<std::size_t>());
  }
}

TEST_CASE("before faces are made, rows are closed lines") {
  Session session = test_support::small_session();
  apply(session, SeekPlace{{knit::Stage::rows, 5, 0}});
  const auto& rows = session.document->timeline.state().fabric.rows();
  REQUIRE(rows.size() == 4);
  const Obj obj = parse_obj(mesh_text(session));
  CHECK(obj.faces.empty());
  CHECK(obj.groups == std::vector<std::string>{"row_001", "row_002", "row_003", "row_004"});
  std::size_t first = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& line = obj.lines.at(obj.groups[i]).at(0);
    REQUIRE(line.size() == rows[i]->stitches.size() + 1);
    CHECK(line.front() == first);
    CHECK(line.back() == first);
    first += rows[i]->stitches.size();
  }
  CHECK(obj.vertices.size() == first);
}

TEST_CASE("the map is Appendix A's form, the same as index gives for the row sizes") {
  const Session session = finished_example("thesis-sphere");
  const std::string map = map_text(session);
  CHECK(lines_of(map).size() == 64);
  CHECK(lines_of(map)[0] == "1: [5, 5, 5, 5, 5, 5]");
  std::string sizes;
  for (const int size : golden_rows()) sizes += (sizes.empty() ? "" : ",") + std::to_string(size);
  CHECK(map == index_answer(sizes, "thesis").out);
}

TEST_CASE(
    "a row that is grown into and shrunk out of has two lists in the map, and one in the report's labels") {
  Session session = test_support::small_session();
  knit::Parameters parameters = test_support::small_parameters();
  knit::give_width(parameters, 0.25);
  knit::give_epsilon(parameters, 0.125);
  parameters.rows.cast_on = 12;
  session.document->timeline = knit::Timeline(knit::make_input(knit::sphere(40, 4)), parameters);
  apply(session, ToLast{});
  const Json report = Json::parse(report_text(session));
  const std::vector<int> rows = report["rows"];
  REQUIRE(rows == std::vector<int>{12, 24, 20});
  const std::vector<std::string> map = lines_of(map_text(session));
  REQUIRE(map.size() == 4);
  CHECK(map[1].substr(0, 4) == "2: [");
  CHECK(map[2].substr(0, 8) == "2 > 3: [");
  REQUIRE(report["labels"].size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(report["labels"][i].size() == report["rows"][i]);
  CHECK(report["transitions"].size() == 2);
}

TEST_CASE("thesis sphere: the report's every field") {
  Session session = example_session("thesis-sphere");
  apply(session, ToLast{});
  const Json report = Json::parse(report_text(session));
  const auto number = [&](const char* section, const char* field) {
    return report.at(section).at(field).get<double>();
  };
  CHECK(report["mesh"]["vertices"] == 8258);
  CHECK(report["mesh"]["triangles"] == 16384);
  CHECK(report["mesh"]["name"] == "thesis-sphere");

  const Json& parameters = report["parameters"];
  CHECK(parameters.size() == knit::parameter_table().size());
  for (const knit::ParameterInfo& info : knit::parameter_table()) CHECK(parameters.contains(info.key));
  CHECK(parameters["stitch-width"] == 0.1);
  CHECK(parameters["epsilon"] == 0.05);
  CHECK(parameters["cast-on"] == "auto");
  CHECK(parameters["axis"] == "y");
  CHECK(parameters["close"] == "thesis");
  CHECK(parameters["start"] == "auto");

  CHECK(report["steps"] == session.document->timeline.known());
  CHECK(report["rows"] == Json(golden_rows()));
  CHECK(report["faces"] == Json({{"quads", 3307}, {"triangles", 118}}));
  CHECK(report["euler"] == 0);
  CHECK(report["problems"] == Json::array());
  CHECK(report["shaping"] == Json({{"increases", 59}, {"decreases", 59}, {"max_in_a_row", 22}}));
  CHECK(number("course", "mean") == Approx(0.0770).margin(0.00005));
  CHECK(number("course", "cv") == Approx(0.202).margin(0.0005));
  CHECK(number("course", "min") == Approx(0.0415).margin(0.00005));
  CHECK(number("course", "max") == Approx(0.0987).margin(0.00005));
  for (const char* field : {"mean", "cv", "min", "max"}) CHECK(number("wale", field) > 0.0);
  CHECK(number("wale", "min") <= number("wale", "mean"));
  CHECK(number("wale", "mean") <= number("wale", "max"));
  CHECK(number("milliseconds", "load") > 0.0);
  CHECK(number("milliseconds", "run") > 0.0);

  REQUIRE(report["labels"].size() == 64);
  for (std::size_t i = 0; i < 64; ++i) CHECK(report["labels"][i].size() == report["rows"][i]);
  CHECK(report["labels"][0] == Json(std::vector<int>(6, 5)));
  CHECK(report["labels"][1] == Json({6, 1, 6, 2, 6, 1, 6, 2, 6, 1, 6, 2}));
}

TEST_CASE("the report's pattern is the page's: read back, it makes the report's rows") {
  Session session = example_session("thesis-sphere");
  apply(session, SeekPlace{{knit::Stage::stitches, 5, 0}});
  CHECK(Json::parse(report_text(session))["pattern"] == Json::array());
  apply(session, ToLast{});
  const Json report = Json::parse(report_text(session));
  std::string text;
  for (const Json& line : report["pattern"]) text += line.get<std::string>() + "\n";
  CHECK(contains(text, "\nRnd 2: [K1, m1r, K1, m1l] 3 times. (12 sts)\n"));
  const knit::ReadPattern read = knit::read_pattern(text);
  CHECK(read.mistakes.empty());
  std::vector<std::int32_t> rows{read.rounds.cast_on};
  for (const knit::Round& round : read.rounds.rounds) rows.push_back(round.after);
  CHECK(Json(rows) == report["rows"]);
}

TEST_CASE("a torus from side to side: its tubes and events in the report, the map tube by tube") {
  Session session = example_session("torus");
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.source = knit::RowSource::contours;
  parameters.timing.axis.kind = knit::AxisKind::x;
  knit::give_width(parameters, 0.15);
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  const Json report = Json::parse(report_text(session));
  REQUIRE(report["tubes"].size() == 4);
  std::size_t rounds = 0;
  for (const Json& tube : report["tubes"]) rounds += tube["rounds"].get<std::size_t>();
  CHECK(rounds == report["rows"].size());
  CHECK(report["tubes"][0]["name"] == "A");
  CHECK(report["tubes"][0]["from"] == "cast-on");
  CHECK(report["tubes"][3]["to"] == "bind-off");
  CHECK(report["tubes"][1]["twin_of"] == Json({"C"}));
  std::vector<std::string> kinds;
  for (const Json& event : report["events"]) kinds.push_back(event["kind"]);
  CHECK(kinds == std::vector<std::string>{"cast-on", "split", "join", "bind-off"});
  CHECK(report["events"][1]["arcs"][0].get<int>() + report["events"][1]["arcs"][1].get<int>() ==
        report["rows"][report["events"][1]["after_row"].get<std::size_t>() - 1]);
  CHECK(report["genus"] == 1);
  CHECK(report["openings"] == 2);
  CHECK(report["euler"] == -2);
  CHECK(report["yarns"] == 2);
  CHECK(report["graph"]["loops"] == 1);
  REQUIRE(report["labels"].size() == report["rows"].size());
  for (std::size_t i = 0; i < report["rows"].size(); ++i)
    CHECK(report["labels"][i].size() == report["rows"][i]);

  std::size_t tubes = 0, splits = 0;
  for (const std::string& line : lines_of(map_text(session))) {
    tubes += line.rfind("# tube ", 0) == 0 ? 1 : 0;
    splits += line.rfind("# split: A > C B, arcs ", 0) == 0 ? 1 : 0;
  }
  CHECK(tubes == 4);
  CHECK(splits == 1);
}

TEST_CASE("a report shows the position, at the start too") {
  Session session = test_support::small_session();
  const Json start = Json::parse(report_text(session));
  CHECK(start["steps"] == 0);
  CHECK(start["rows"] == Json::array());
  CHECK(start["labels"] == Json::array());
  CHECK(map_text(session).empty());
  CHECK(steps_text(session).empty());
  CHECK(parse_obj(mesh_text(session)).vertices.empty());

  apply(session, SeekPlace{{knit::Stage::rows, 5, 0}});
  const Json middle = Json::parse(report_text(session));
  CHECK(middle["steps"] == session.document->timeline.position());
  CHECK(middle["rows"].size() == 4);
  CHECK(middle["faces"]["quads"] == 0);
}

TEST_CASE("a stop is the last problem, and the last line of the steps") {
  Session torus = test_support::torus_from_rings();
  apply(torus, ToLast{});
  const Json report = Json::parse(report_text(torus));
  REQUIRE(report["problems"].size() == 1);
  const Json& problem = report["problems"][0];
  CHECK(problem["step"] == torus.document->timeline.known() + 1);
  for (const char* field : {"stage", "row", "item"}) CHECK(problem.contains(field));
  CHECK(contains(problem["what"], "split"));
  const Json last = Json::parse(lines_of(steps_text(torus)).back());
  CHECK(last["kind"] == "stopped");
  CHECK(last["what"] == problem["what"]);
}

TEST_CASE("a repaired stall is a problem with its place") {
  Session session = test_support::small_session();
  knit::Parameters parameters = session.document->timeline.parameters();
  knit::give_epsilon(parameters, 0.01);
  parameters.rows.resample = knit::Resample::on;
  apply(session, Tune{parameters});
  apply(session, ToLast{});
  const Json report = Json::parse(report_text(session));
  REQUIRE_FALSE(report["problems"].empty());
  for (const Json& problem : report["problems"]) {
    const std::size_t step = problem["step"];
    const knit::Place& place = session.document->timeline.step(step - 1).place;
    CHECK(problem["stage"] == std::string(knit::name_of(place.stage)));
    CHECK(problem["row"] == place.row);
    CHECK(problem["item"] == place.item);
    CHECK(is_one_sentence(problem["what"]));
  }
}

TEST_CASE("the steps are one JSON object a line, as many as steps were taken") {
  Session session = test_support::finished_small_session();
  std::set<std::string> stages;
  const std::vector<std::string> lines = lines_of(steps_text(session));
  REQUIRE(lines.size() == session.document->timeline.known());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Json step = Json::parse(lines[i]);
    CHECK(step["step"] == i + 1);
    const std::string what = step["what"];
    CHECK(is_one_sentence(what));
    stages.insert(step["stage"].get<std::string>());
    if (step["kind"] == "candidate-measured") CHECK(step["distance"].is_number());
  }
  CHECK(stages.size() + 3 == knit::machine_stages.size());  // rings make no tubes and stay on the mesh
  apply(session, SeekTo{700});
  CHECK(lines_of(steps_text(session)).size() == 700);
}

TEST_CASE("a mesh whose name is no valid text still gives a report") {
  Session session = test_support::small_session();
  knit::Mesh mesh = *session.document->original;
  mesh.name = "caf\xE9";  // a file name in Latin-1
  session.document->timeline = knit::Timeline(knit::make_input(mesh), test_support::small_parameters());
  const Json report = Json::parse(report_text(session));
  CHECK(report["mesh"]["name"].get<std::string>().substr(0, 3) == "caf");
}

TEST_CASE("files are written whole, and nothing else is left in the folder") {
  const Folder folder;
  const Session session = test_support::finished_small_session();
  CHECK_FALSE(export_to_file(session, {"mesh", folder.path() / "mesh.obj"}));
  CHECK_FALSE(export_to_file(session, {"map", folder.path() / "map.txt"}));
  CHECK_FALSE(export_to_file(session, {"report", folder.path() / "report.json"}));
  CHECK_FALSE(export_to_file(session, {"card", folder.path() / "card.txt"}));
  CHECK_FALSE(export_to_file(session, {"steps", folder.path() / "steps.jsonl"}));
  CHECK(folder.files() == 5);
  CHECK(read_text(folder.path() / "card.txt") == card_text(session));
  CHECK(read_text(folder.path() / "mesh.obj") == mesh_text(session));
  CHECK(read_text(folder.path() / "map.txt") == map_text(session));
  CHECK(read_text(folder.path() / "report.json") == report_text(session));
  CHECK(read_text(folder.path() / "steps.jsonl") == steps_text(session));
}

TEST_CASE("where nothing can be written, nothing is left, and a sentence says so") {
  const Folder folder;
  write_text(folder.path() / "file", "x");
  std::filesystem::create_directory(folder.path() / "a folder");
  for (const char* name : {"no/such/folder.txt", "file/below.txt", "a folder"}) {
    CAPTURE(name);
    const auto error = write_file(folder.path() / name, "content");
    REQUIRE(error);
    CAPTURE(*error);
    CHECK(is_one_sentence(*error));
    CHECK(contains(*error, name));
    CHECK(folder.files() == 2);
  }
  if (::geteuid() == 0) return;  // who may do everything can write anywhere
  std::filesystem::permissions(folder.path(),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const auto error = write_file(folder.path() / "new.txt", "content");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  REQUIRE(error);
  CHECK(is_one_sentence(*error));
  CHECK(folder.files() == 2);
}

TEST_CASE("a file that is there stays intact when writing fails half way") {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "report.json";
  write_text(path, "the old one");
  std::optional<std::string> error;
  {
    const FullDisk full;
    error = write_file(path, std::string(100000, 'x'));
  }
  REQUIRE(error);
  CHECK(is_one_sentence(*error));
  CHECK(read_text(path) == "the old one");
  CHECK(folder.files() == 1);
  CHECK_FALSE(write_file(path, "the new one"));
  CHECK(read_text(path) == "the new one");
}

TEST_CASE("a link stays a link, and a device stays a device") {
  const Folder folder;
  write_text(folder.path() / "target", "old");
  std::filesystem::create_symlink("target", folder.path() / "link");
  CHECK_FALSE(write_file(folder.path() / "link", "new"));
  CHECK(std::filesystem::is_symlink(folder.path() / "link"));
  CHECK(read_text(folder.path() / "target") == "new");

  // Through a link of our own, so that no fault here can harm the device.
  std::filesystem::create_symlink("/dev/null", folder.path() / "null");
  CHECK_FALSE(write_file(folder.path() / "null", "gone"));
  CHECK(std::filesystem::is_symlink(folder.path() / "null"));
  CHECK(std::filesystem::is_character_file(folder.path() / "null"));
  std::filesystem::create_symlink("/dev/full", folder.path() / "full");
  const auto error = write_file(folder.path() / "full", std::string(100000, 'x'));
  REQUIRE(error);
  CHECK(is_one_sentence(*error));
  CHECK(folder.files() == 4);
}
