// The command line as others script against it: words in, actions or an answer out.
#include "app/script/command_line.h"
#include "app/actions/navigate.h"
#include "app/session/document.h"
#include "app/session/program.h"

#include <algorithm>
#include <map>

#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/samples.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;
using test_support::is_one_sentence;

namespace {

using Words = std::vector<std::string>;

const std::string appendix_list = "6,12,17,22,26,32,32,43,43,43,44,62,65";

std::string mirror_list() {
  std::string list = appendix_list;
  for (int i = 0; i < 38; ++i) list += ",65";
  return list + ",62,44,43,43,43,32,32,26,22,17,12,6,5";
}

auto parse(const Words& words) { return parse_command_line(words, KNIT_ASSETS_DIR); }

CommandLine understood(const Words& words) {
  auto parsed = parse(words);
  if (const auto* answer = std::get_if<Answer>(&parsed)) FAIL("refused: " << answer->error << answer->out);
  return std::get<CommandLine>(std::move(parsed));
}

Answer answered(const Words& words) {
  auto parsed = parse(words);
  REQUIRE(std::holds_alternative<Answer>(parsed));
  return std::get<Answer>(std::move(parsed));
}

// The value an option set, as text; "" where it set none.
std::string value_of(const CommandLine& line, const std::string& key) {
  for (const auto& [info, text] : line.settings) {
    if (info->key == key) return text;
  }
  return "";
}

using LabelRows = std::map<int, std::vector<int>>;

// "3: [6, 1, 0]" and its like.
LabelRows parse_rows(const std::string& text) {
  LabelRows rows;
  for (const std::string& line : test_support::lines_of(text)) {
    const std::size_t colon = line.find(": [");
    REQUIRE(colon != std::string::npos);
    REQUIRE(line.back() == ']');
    std::istringstream numbers(line.substr(colon + 3));
    std::vector<int>& row = rows[std::stoi(line.substr(0, colon))];
    char separator = ' ';
    for (int label = 0; numbers >> label; numbers >> separator) row.push_back(label);
  }
  return rows;
}

int count_of(const std::vector<int>& row, int a, int b) {
  return static_cast<int>(std::count(row.begin(), row.end(), a) + std::count(row.begin(), row.end(), b));
}

}  // namespace

TEST_CASE("parse_at takes the end, a number of steps, a stage, a row and an item") {
  CHECK(std::holds_alternative<AtEnd>(parse_at("end").value()));
  CHECK(std::get<std::size_t>(parse_at("0").value()) == 0);
  CHECK(std::get<std::size_t>(parse_at("12345").value()) == 12345);
  for (const knit::Stage stage : knit::machine_stages) {
    const std::string name(knit::name_of(stage));
    CHECK(std::get<AtStage>(parse_at(name).value()).stage == stage);
    CHECK(std::get<knit::Place>(parse_at(name + ":4").value()) == knit::Place{stage, 4, 0});
    CHECK(std::get<knit::Place>(parse_at(name + ":4:17").value()) == knit::Place{stage, 4, 16});
    CHECK(text_of(knit::Place{stage, 4, 16}) == name + ":4:17");
  }
}

TEST_CASE("the end of a row is written so that it is read back") {
  const std::string text = text_of(knit::Place{knit::Stage::rows, 4, INT32_MAX});
  CHECK(text == "rows:4:2147483647");
  CHECK(std::get<knit::Place>(parse_at(text).value()).item > 1000000);
}

TEST_CASE("parse_at refuses everything else") {
  const std::string text =
      GENERATE(as<std::string>(), "", "End", "-1", "1.5", "12a", " 12", "rows:", "rows:-1",
               "rows:1:", "rows:1:-2", "rows:1:0", "rows:1:2:3", "rows:one", "rows 3", ":3", "import", "done",
               "import:1", "99999999999999999999999", "rows:99999999999");
  CAPTURE(text);
  CHECK_FALSE(parse_at(text));
}

TEST_CASE("without words the thesis sphere is opened, in a window, at the start") {
  const CommandLine line = understood({});
  CHECK(line.open.get<OpenExample>().name == "thesis-sphere");
  CHECK_FALSE(line.headless);
  CHECK_FALSE(line.at);
  CHECK(line.settings.empty());
  CHECK(line.saves.empty());
}

TEST_CASE("a mesh or an example is opened, spaces and all") {
  CHECK(understood({"a mesh.obj"}).open.get<OpenFile>().path == "a mesh.obj");
  CHECK(understood({"--headless", "x.obj"}).open.get<OpenFile>().path == "x.obj");
  CHECK(understood({"--example", "egg"}).open.get<OpenExample>().name == "egg");
  CHECK(understood({"--example=egg"}).open.get<OpenExample>().name == "egg");
}

TEST_CASE("every parameter has its option") {
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string key(info.key);
    CAPTURE(key);
    const std::string sample = test_support::sample_of(info);
    const CommandLine line = understood({"--" + key, sample});
    CHECK(line.settings.size() == 1);
    CHECK(value_of(line, key) == sample);
    CHECK(value_of(understood({"--" + key + "=" + sample}), key) == sample);
  }
}

TEST_CASE("what to do: headless, where to stop, what to save, how large") {
  const CommandLine line = understood({"--headless", "--at", "rows:7", "--save-mesh", "m.obj", "--save-map",
                                       "m.txt", "--save-report", "-", "--save-steps", "s.jsonl",
                                       "--screenshot", "p.png", "--size", "640x480"});
  CHECK(line.headless);
  REQUIRE(line.at);
  CHECK(std::get<knit::Place>(*line.at) == knit::Place{knit::Stage::rows, 7, 0});
  REQUIRE(line.saves.size() == 5);
  const auto path_of = [&](std::string_view key) {
    const auto found = std::find_if(line.saves.begin(), line.saves.end(),
                                    [&](const Export& save) { return save.what == key; });
    return found == line.saves.end() ? std::filesystem::path() : found->path;
  };
  CHECK(path_of("mesh") == "m.obj");
  CHECK(path_of("map") == "m.txt");
  CHECK(path_of("report") == "-");
  CHECK(path_of("steps") == "s.jsonl");
  CHECK(path_of("screenshot") == "p.png");
  CHECK(line.width == 640);
  CHECK(line.height == 480);
}

TEST_CASE("bad usage ends with 2, nothing on standard output and one line that says what to do") {
  struct Case {
    Words words;
    std::string says;
  };
  const Case c = GENERATE(
      Case{{"--bogus"}, "--help"}, Case{{"--epsilon"}, "--help"}, Case{{"a.obj", "b.obj"}, "--help"},
      Case{{"a.obj", "--example", "egg"}, "not both"}, Case{{"--epsilon", "0"}, "a number above 0"},
      Case{{"--epsilon", "nan"}, "a number above 0"}, Case{{"--stitch-width", "wide"}, "a number above 0"},
      Case{{"--cast-on", "2"}, "from 3 to 1000"}, Case{{"--cast-on", "6.5"}, "whole number"},
      Case{{"--axis", "w"}, "x, y, z"}, Case{{"--axis", "0,0,0"}, "0,0,0"}, Case{{"--start", "-1"}, "auto"},
      Case{{"--close", "round"}, "none, thesis or arc"}, Case{{"--on-stall", "go"}, "continue or stop"},
      Case{{"--placement", "odd"}, "thesis, even, nearest or auto"}, Case{{"--weld", "yes"}, "off or on"},
      Case{{"--at", "purl"}, "STAGE[:ROW[:ITEM]]"}, Case{{"--size", "0x10"}, "WIDTHxHEIGHT"},
      Case{{"--size", "640"}, "WIDTHxHEIGHT"}, Case{{"--headless", "--size", "99999x99999"}, "16384"},
      Case{{"index"}, "--help"}, Case{{"index", "6,twelve"}, "twelve"}, Case{{"index", "6,,12"}, "row size"},
      Case{{"index", "6,13"}, "double or halve"},
      Case{{"index", "6,12", "--placement", "odd"}, "thesis or even"},
      Case{{"index", "6,12", "--placement", "nearest"}, "where stitches stand"},
      Case{{"index", "0"}, "row size"}, Case{{"index", "-6"}, "row size"});
  CAPTURE(c.words);
  const Answer answer = answered(c.words);
  CHECK(answer.exit_code == 2);
  CHECK(answer.out.empty());
  CAPTURE(answer.error);
  CHECK(is_one_sentence(answer.error));
  CHECK(contains(answer.error, c.says));
}

TEST_CASE("an option without a value, as from an empty variable of a script, is bad usage, not ignored") {
  const std::string option = GENERATE(as<std::string>(), "--example", "--epsilon", "--axis", "--at", "--size",
                                      "--save-report", "--screenshot");
  CAPTURE(option);
  for (const Words& words : {Words{option, ""}, Words{option + "="}}) {
    const Answer answer = answered(words);
    CHECK(answer.exit_code == 2);
    CAPTURE(answer.error);
    CHECK(is_one_sentence(answer.error));
  }
  CHECK(answered({""}).exit_code == 2);
  CHECK(answered({"index", ""}).exit_code == 2);
}

TEST_CASE("an axis may begin with a minus") {
  CHECK(value_of(understood({"--axis", "-1,0,0"}), "axis") == "-1,0,0");
  CHECK(value_of(understood({"--axis=-1,0,0"}), "axis") == "-1,0,0");
}

TEST_CASE("help, version and lists are answered on standard output") {
  const Answer help = answered({"--help"});
  CHECK(help.exit_code == 0);
  CHECK(help.error.empty());
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    CHECK(contains(help.out, "--" + std::string(info.key)));
  }
  for (const char* word : {"--headless", "--at", "--save-mesh", "--save-map", "--save-report", "--save-steps",
                           "--screenshot", "--list-examples", "--list-parameters", "--version", "index"}) {
    CAPTURE(word);
    CHECK(contains(help.out, word));
  }

  const Answer version = answered({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.out.substr(0, 10) == "knit-mesh ");
  CHECK(version.out.back() == '\n');

  CHECK(answered({"--list-examples"}).out ==
        "thesis-sphere\nsphere\nstretched-sphere\negg\ncapsule\ncone\nvase\ntorus\n"
        "heel\ntrousers\ny\nstarfish\noctopus\nmug\ncup\ndouble-torus\nchain-of-three\n");

  const std::vector<std::string> parameters = test_support::lines_of(answered({"--list-parameters"}).out);
  REQUIRE(parameters.size() == knit::parameter_table().size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    CHECK(contains(parameters[i], "--" + std::string(knit::parameter_table()[i].key)));
    CHECK(contains(parameters[i], "default"));
  }
}

TEST_CASE("index prints rows 1, 2, 3, 4, 8 and 12 of Appendix A to the letter") {
  const Answer answer = answered({"index", appendix_list});
  CHECK(answer.exit_code == 0);
  CHECK(answer.error.empty());
  CHECK(answer.out.back() == '\n');
  const std::vector<std::string> lines = test_support::lines_of(answer.out);
  REQUIRE(lines.size() == 13);
  CHECK(lines[0] == "1: [5, 5, 5, 5, 5, 5]");
  CHECK(lines[1] == "2: [6, 1, 6, 2, 6, 1, 6, 2, 6, 1, 6, 2]");
  CHECK(lines[2] == "3: [6, 1, 0, 0, 2, 6, 1, 0, 0, 0, 6, 1, 0, 0, 0, 6, 1]");
  CHECK(lines[3] == "4: [6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 6, 1, 0, 0, 0, 0, 0, 0, 2]");
  CHECK(lines[7] ==
        "8: [6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 2, 6, 1, 0, 0, "
        "0, "
        "0, 0, 0, 0, 6, 1, 0, 0, 0, 2]");
  CHECK(lines[11] ==
        "12: [6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2, 6, "
        "1, 0, "
        "0, 0, 2, 6, 1, 0, 0, 0, 2, 6, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 6, 1, 0, 0, 0, 2]");
}

TEST_CASE("index on the mirror-completed sizes: decreases where the study says, and every row adds up") {
  const std::string placement = GENERATE(as<std::string>(), "thesis", "even");
  const LabelRows rows = parse_rows(answered({"index", mirror_list(), "--placement", placement}).out);
  REQUIRE(rows.size() == 64);
  std::vector<int> decreasing;
  for (const auto& [row, labels] : rows) {
    CAPTURE(row);
    const int size = static_cast<int>(labels.size());
    const int increases = count_of(labels, 1, 2);
    const int decreases = count_of(labels, 3, 4);
    if (decreases > 0) decreasing.push_back(row);
    // A cell that is no increase consumes a stitch of the row before; what no decrease takes away goes on.
    if (row > 1 && increases > 0) CHECK(size - increases == static_cast<int>(rows.at(row - 1).size()));
    if (row < 64 && decreases > 0) CHECK(size - decreases == static_cast<int>(rows.at(row + 1).size()));
    CHECK((increases == 0 || decreases == 0));
    if (row > 1 && size > static_cast<int>(rows.at(row - 1).size())) CHECK(increases > 0);
    if (row < 64 && size > static_cast<int>(rows.at(row + 1).size())) CHECK(decreases > 0);
  }
  CHECK(decreasing == std::vector<int>{51, 52, 53, 56, 58, 59, 60, 61, 62, 63});
  CHECK(rows.at(1) == std::vector<int>(6, 5));
  CHECK(rows.at(64) == std::vector<int>(5, 5));
}

TEST_CASE("an opened example has its parameters, and the command line's over them") {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  REQUIRE_FALSE(open_as_asked(session, understood({"--cast-on", "8", "--close", "none"})));
  REQUIRE(session.document);
  CHECK(session.document->source.example == "thesis-sphere");
  const knit::Parameters& parameters = session.document->timeline.parameters();
  CHECK(parameters.rows.cast_on == 8);
  CHECK(parameters.rows.close == knit::Closing::none);
  CHECK(parameters.stitch.width == 0.1);
  CHECK(parameters.epsilon() == 0.05);
  CHECK(session.document->timeline.position() == 0);
  CHECK(session.document->defaults.rows.cast_on == 0);
}

TEST_CASE("a stitch width alone takes epsilon along, an epsilon given stays") {
  const auto epsilon_after = [](const Words& words) {
    Session session;
    session.program->assets = KNIT_ASSETS_DIR;
    REQUIRE_FALSE(open_as_asked(session, understood(words)));
    return session.document->timeline.parameters().epsilon();
  };
  CHECK(epsilon_after({"--stitch-width", "0.2"}) == Approx(0.1));
  CHECK(epsilon_after({"--stitch-width", "0.2", "--epsilon", "0.03"}) == 0.03);
  CHECK(epsilon_after({"--epsilon", "0.03", "--stitch-width", "0.2"}) == 0.03);
}

TEST_CASE("welding by the command line opens the welded mesh") {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  REQUIRE_FALSE(open_as_asked(session, understood({"--weld", "on"})));
  CHECK(session.document->timeline.input().mesh.positions.size() <
        session.document->original->positions.size());
}

TEST_CASE("what cannot be opened as asked is one sentence") {
  const test_support::Folder folder;
  test_support::write_text(folder.path() / "text.obj", "this is no mesh\n");
  test_support::write_text(folder.path() / "flat.obj",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  const std::string in = folder.path().string() + "/";
  struct Case {
    Words words;
    std::string says;
  };
  const std::vector<Case> cases{{{in + "missing.obj"}, "does not exist"},
                                {{in}, "folder"},
                                {{in + "text.obj"}, "text.obj"},
                                {{in + "flat.obj"}, "plane"},
                                {{"--example", "teapot"}, "choose one of thesis-sphere"},
                                {{"--epsilon", "0.2"}, "must be smaller than the stitch width"},
                                {{"--start", "100000"}, "--start"},
                                {{"--start", "5", "--end", "5"}, "two different"}};
  for (const Case& c : cases) {
    CAPTURE(c.words);
    Session session;
    session.program->assets = KNIT_ASSETS_DIR;
    const auto error = open_as_asked(session, understood(c.words));
    REQUIRE(error);
    CAPTURE(*error);
    CHECK(is_one_sentence(*error));
    CHECK(contains(*error, c.says));
  }
}

TEST_CASE("go_to reaches the end, a number of steps, a stage's first step and a place") {
  Session session = test_support::small_session();
  CHECK_FALSE(go_to(session, AtEnd{}));
  CHECK(session.document->timeline.state().finished());
  const std::size_t all = session.document->timeline.position();

  for (const std::size_t steps : {std::size_t{0}, std::size_t{1}, std::size_t{777}, all}) {
    Session fresh = test_support::small_session();
    CHECK_FALSE(go_to(fresh, steps));
    CHECK(fresh.document->timeline.position() == steps);
  }
  for (const knit::Stage stage : knit::machine_stages) {
    if (stage == knit::Stage::tubes || stage == knit::Stage::settle || stage == knit::Stage::relax)
      continue;  // rings make none, and stay
    Session fresh = test_support::small_session();
    CHECK_FALSE(go_to(fresh, AtStage{stage}));
    CHECK(fresh.document->timeline.place().stage == stage);
    CHECK(fresh.document->timeline.place().item == 0);
    if (stage == knit::Stage::timing) continue;
    CHECK(fresh.document->timeline.step(fresh.document->timeline.position() - 2).place.stage < stage);
  }
  Session fresh = test_support::small_session();
  CHECK_FALSE(go_to(fresh, knit::Place{knit::Stage::rows, 5, 3}));
  CHECK(fresh.document->timeline.place() == knit::Place{knit::Stage::rows, 5, 3});
}

TEST_CASE("go_to says when the run has no such place, and shows the nearest before it") {
  Session session = test_support::small_session();
  const auto too_far = go_to(session, std::size_t{1000000});
  REQUIRE(too_far);
  CHECK(is_one_sentence(*too_far));
  CHECK(contains(*too_far, std::to_string(session.document->timeline.known())));
  CHECK(session.document->timeline.position() == session.document->timeline.known());

  const auto no_row = go_to(session, knit::Place{knit::Stage::rows, 500, 0});
  REQUIRE(no_row);
  CHECK(is_one_sentence(*no_row));
  CHECK(contains(*no_row, "rows:500:1"));
  CHECK(session.document->timeline.place().stage == knit::Stage::rows);

  Session torus = test_support::torus_from_rings();
  const auto not_reached = go_to(torus, AtStage{knit::Stage::faces});
  REQUIRE(not_reached);
  CHECK(is_one_sentence(*not_reached));
  CHECK(contains(*not_reached, "faces"));
  CHECK(stop_shown(torus) != nullptr);
}

namespace {

knit::Parameters opened_with(const Words& words) {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  const auto error = open_as_asked(session, understood(words));
  CAPTURE(words);
  CHECK(error.value_or("") == "");
  REQUIRE(session.document);
  return session.document->timeline.parameters();
}

}  // namespace

TEST_CASE("a preset comes first, settings over it, wherever they stand") {
  CHECK(understood({"--preset", "best-rows"}).preset == "best-rows");
  CHECK(understood({}).preset.empty());
  const knit::Parameters best = opened_with({"--example", "egg", "--preset", "best-rows"});
  CHECK(best.rows.source == knit::RowSource::contours);
  CHECK(best.timing.kind == knit::TimingKind::arc_length);
  CHECK(best.stitches.placement == knit::PlacementPolicy::nearest);
  CHECK(best.stitch.width == 0.1);
  CHECK(best.epsilon() == 0.025);
  for (const Words& words : {Words{"--preset", "best-rows", "--placement", "even"},
                             Words{"--placement", "even", "--preset", "best-rows"}}) {
    const knit::Parameters p = opened_with(words);
    CHECK(p.rows.source == knit::RowSource::contours);
    CHECK(p.stitches.placement == knit::PlacementPolicy::even);
  }
  const Answer bad = answered({"--preset", "fluffy"});
  CHECK(bad.exit_code == 2);
  CHECK(bad.out.empty());
  CHECK(bad.error == "--preset cannot be \"fluffy\"; give thesis, best-rows, knitters-gauge or hand.");
  CHECK(answered({"--preset", ""}).exit_code == 2);
}

TEST_CASE("a gauge given is the given view of the stitch size, epsilon comes along") {
  const knit::Parameters p = opened_with({"--gauge", "20,28", "--height-cm", "16"});  // 8 cm a unit
  CHECK(p.size.from() == knit::SizesFrom::gauge);
  CHECK(p.stitch.width == Approx(10.0 / 20.0 / 8.0));
  CHECK(p.stitch.height == Approx(10.0 / 28.0 / 8.0));
  CHECK(p.epsilon() == Approx(0.5 * p.stitch.width));
  const knit::Parameters tall = opened_with({"--height-cm", "16"});  // a height alone changes no stitch
  CHECK(tall.size.from() == knit::SizesFrom::mesh);
  CHECK(tall.stitch.width == 0.1);
  CHECK(tall.stitch.gauge.stitches == Approx(10.0 / (0.1 * 8.0)));
  const knit::Parameters back = opened_with({"--preset", "knitters-gauge", "--stitch-width", "0.2"});
  CHECK(back.size.from() == knit::SizesFrom::mesh);
  CHECK(back.stitch.width == 0.2);
}

TEST_CASE("a gauge and a size in mesh units are refused together, unless one is said to count") {
  for (const std::string key : {"--stitch-width", "--stitch-height"}) {
    const Answer answer = answered({"--gauge", "20,28", key, "0.2"});
    CHECK(answer.exit_code == 2);
    CHECK(is_one_sentence(answer.error));
    CHECK(contains(answer.error, "--gauge and " + key));
  }
  const Words both{"--gauge", "20,28", "--height-cm", "16", "--stitch-width", "0.2", "--sizes"};
  const auto counted = [&](const char* sizes) {
    Words words = both;
    words.emplace_back(sizes);
    return opened_with(words);
  };
  CHECK(counted("mesh").stitch.width == 0.2);
  CHECK(counted("mesh").stitch.gauge.stitches == Approx(10.0 / (0.2 * 8.0)));
  CHECK(counted("gauge").stitch.width == Approx(10.0 / 20.0 / 8.0));
  CHECK(counted("gauge").stitch.gauge == knit::Gauge{20.0, 28.0});
}

TEST_CASE("a stitch height left to itself, and where rounds begin") {
  CHECK(opened_with({"--stitch-height", "0.05"}).stitch.height == 0.05);
  CHECK(opened_with({"--preset", "knitters-gauge", "--stitch-height", "auto"}).stitch.height_follows);
  CHECK(opened_with({"--start-direction", "-1,0,0"}).rows.start_direction == glm::dvec3(-1.0, 0.0, 0.0));
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  const auto error = open_as_asked(session, understood({"--start-direction", "0,1,0"}));
  REQUIRE(error);
  CHECK(contains(*error, "give one across it"));
}

TEST_CASE("two picked vertices that the mesh does not have are refused, however far out they are") {
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  const auto error = open_as_asked(session, understood({"--start", "4000000000", "--end", "5"}));
  REQUIRE(error);
  CHECK(contains(*error, "--start 4000000000 is not a vertex"));
}

TEST_CASE("the columns of the list of rows are given by name") {
  const CommandLine line = understood({"--row-columns", "stitches,course"});
  REQUIRE(line.row_columns);
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  REQUIRE_FALSE(open_as_asked(session, line));
  for (std::size_t i = 0; i < row_column_keys.size(); ++i) {
    const bool named = row_column_keys[i] == "stitches" || row_column_keys[i] == "course";
    CHECK(session.program->preferences.shows(static_cast<RowColumn>(i)) == named);
  }
  CHECK(understood({"--row-columns", "none"}).row_columns == decltype(Preferences::row_columns){});
  CHECK_FALSE(understood({}).row_columns);
  CHECK(answered({"--row-columns", "stitches,colour"})
            .error.find("--row-columns cannot be \"colour\"; give stitches, change") != std::string::npos);
}
