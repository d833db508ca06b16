// The rules of the house, read off the sources: which folder may include which, and how large files and folders get.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/folder_table.h"
#include "tests/support/session.h"

namespace {

namespace fs = std::filesystem;
using test_support::app_core;
using test_support::Arrow;
using test_support::arrows;
using Strings = std::vector<std::string>;

struct Source {
  std::string folder;  // "app/session"
  std::string stem;    // "describe"
  bool header = false;
  std::string text;
  [[nodiscard]] std::string name() const { return folder + "/" + stem + (header ? ".h" : ".cpp"); }
};

std::vector<Source> read_sources(const std::string& folder) {
  std::vector<Source> sources;
  for (const auto& entry : fs::directory_iterator(fs::path(KNIT_SOURCE_DIR) / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    sources.push_back(
        {folder, entry.path().stem().string(), extension == ".h", test_support::read_text(entry.path())});
  }
  return sources;
}

struct Include {
  bool ours = false;  // in quotes
  std::string path;
};

std::vector<Include> includes_of(const Source& source) {
  std::vector<Include> includes;
  for (const std::string& line : test_support::lines_of(source.text)) {
    std::istringstream words(line);
    char hash = ' ';
    if (!(words >> hash) || hash != '#') continue;
    std::string rest;
    std::getline(words >> std::ws, rest);
    const std::size_t open = rest.find_first_of("<\"");
    if (rest.rfind("include", 0) != 0 || open == std::string::npos) continue;
    const bool ours = rest[open] == '"';
    const std::size_t close = rest.find(ours ? '"' : '>', open + 1);
    includes.push_back({ours, rest.substr(open + 1, close - open - 1)});
  }
  return includes;
}

bool begins_with_any(const std::string& text, const Strings& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.rfind(beginning, 0) == 0; });
}

// The C++ standard library's headers have neither folder nor ending.
bool is_standard(const std::string& path) { return path.find_first_of("/.") == std::string::npos; }

bool may_include(const Arrow& arrow, const std::string& folder) {
  const auto names = [&](const std::string& ours) {
    if (ours == "knit/") return folder.rfind(ours, 0) == 0;
    if (ours == "app/") return app_core.count(folder) > 0;
    return folder == ours;
  };
  return folder == arrow.folder || std::any_of(arrow.ours.begin(), arrow.ours.end(), names);
}

Strings wrong_arrows(const Source& source, const Arrow& arrow) {
  Strings wrong;
  for (const Include& include : includes_of(source)) {
    const bool embedded = include.path == "shaders_embedded.h";
    const std::string folder =
        embedded ? include.path : fs::path(include.path).parent_path().generic_string();
    const bool right = include.ours
                           ? may_include(arrow, folder)
                           : is_standard(include.path) || begins_with_any(include.path, arrow.outside);
    if (!right) wrong.push_back(source.name() + " includes " + include.path);
  }
  return wrong;
}

// --- knit's own rules ---------------------------------------------------------------------------------------

Strings wrong_in_knit(const Source& source) {
  Strings wrong;
  const auto blame = [&](const std::string& what) { wrong.push_back(source.name() + " " + what); };
  for (const Include& include : includes_of(source)) {
    if (include.path.rfind("Eigen/", 0) == 0 && source.header) blame("shows Eigen to others");
    if (include.path == "tiny_obj_loader.h" && source.header) blame("shows tinyobjloader to others");
    if (begins_with_any(include.path,
                        {"iostream", "chrono", "ctime", "thread", "random", "print", "syncstream"})) {
      blame("includes " + include.path);
    }
  }
  return wrong;
}

// Comments and texts in quotes may say anything.
std::string code_of(const std::string& text) {
  std::string code;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (text.compare(i, 2, "//") == 0) {
      end = text.find('\n', i);
    } else if (text.compare(i, 2, "/*") == 0) {
      end = text.find("*/", i + 2);
    } else if (text[i] == '"') {
      while (end < text.size() && text[end] != '"' && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
      ++end;
    } else {
      code += text[i];
    }
    i = std::min(end, text.size());
  }
  return code;
}

Strings prints_in(const Source& source) {
  static const std::set<std::string> printing{"printf", "fprintf", "puts", "fputs", "putchar",
                                              "fwrite", "cout",    "cerr", "clog",  "perror"};
  Strings found;
  std::string word;
  for (const char c : code_of(source.text) + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else {
      if (printing.count(word) > 0) found.push_back(source.name() + " uses " + word);
      word.clear();
    }
  }
  return found;
}

// What a row hangs on, and whether it is closed, is asked of the fabric: nobody else reckons with rows' numbers or
// goes round a row's stitches.
Strings reckoned_rows(const Source& source) {
  static const Strings sums{"row-1",           "row)-1",  "row-2",    "row)-2",    "id-1",
                            "id)-1",           "rows()[", "joins()[", "strips()[", "->stitches[(i+1)%",
                            ".stitches[(i+1)%"};
  Strings found;
  std::string code = code_of(source.text);
  code.erase(std::remove_if(code.begin(), code.end(), [](unsigned char c) { return std::isspace(c) != 0; }),
             code.end());
  for (const std::string& sum : sums) {
    for (std::size_t at = code.find(sum); at != std::string::npos; at = code.find(sum, at + 1)) {
      const bool within_word = at > 0 && std::isalnum(static_cast<unsigned char>(sum[0])) != 0 &&
                               std::isalnum(static_cast<unsigned char>(code[at - 1])) != 0;
      if (!within_word) found.push_back(source.name() + " has " + sum);
    }
  }
  return found;
}

// What gives other bits with another C library, or another order with another standard library, and where it may stand
// all the same: there the order does not matter, or values that are all different settle it.
struct Uneven {
  Strings names;       // after std:: or glm::
  std::string source;  // without ending; empty: nowhere in knit
};

const std::vector<Uneven> uneven{
    {{"sin",  "cos",   "tan",   "asin",   "acos", "atan",         "atan2",     "sinh",         "cosh",
      "tanh", "exp",   "exp2",  "expm1",  "log",  "log2",         "log10",     "log1p",        "pow",
      "cbrt", "hypot", "angle", "rotate", "fma",  "partial_sort", "partition", "unordered_set"},
     ""},
    {{"nth_element"}, "knit/mesh/ranking"},
    {{"push_heap", "pop_heap", "make_heap"}, "knit/mesh/surface_windows"},  // events are numbered
    {{"priority_queue"}, "knit/timing/intrinsic"},                          // vertices are numbered
    {{"unordered_map"}, "knit/import/repair_holes"}};                       // looked up, never walked

Strings uneven_in(const Source& source) {
  Strings found;
  const std::string code = code_of(source.text);
  for (const char* space : {"std::", "glm::"}) {
    for (std::size_t at = code.find(space); at != std::string::npos; at = code.find(space, at + 1)) {
      std::string word;
      for (std::size_t i = at + 5; i < code.size(); ++i) {
        if (std::isalnum(static_cast<unsigned char>(code[i])) == 0 && code[i] != '_') break;
        word += code[i];
      }
      for (const Uneven& rule : uneven) {
        const bool of_a_range = word == "rotate" && std::string_view(space) == "std::";
        const bool named = !of_a_range && std::count(rule.names.begin(), rule.names.end(), word) > 0;
        if (named && rule.source != source.folder + "/" + source.stem)
          found.push_back(source.name() + " uses " + word);
      }
    }
  }
  return found;
}

// --- who changes a session ---------------------------------------------------------------------------------

// Only actions change a session's parts: everywhere else nothing is assigned to one, nothing is called on one that
// changes it, and no name is given to one by which it could be changed.
Strings changes_of_session(const Source& source) {
  static const std::string part =
      R"(\w+(\.|->)((program|document|learning|outbox|jobs)\b|view->\w+)((\.|->)\w+|\[[^\]]*\])*)";
  static const std::vector<std::regex> forms{
      std::regex(part + R"(\s*([-+*/|&]?=(?!=)|\+\+|--))"),
      std::regex(
          part +
          R"((\.|->)(push_back|pop_back|emplace|emplace_back|insert|insert_or_assign|assign|erase|clear|)"
          R"(reset|resize|fill|swap|frame|orbit|pan|zoom|seek|await|accept|extend|extend_briefly|)"
          R"(extend_to_end|tune|edit_from_here|remove_edit|set_knobs|change_input|refresh)\()"),
      std::regex(R"(std::(exchange|swap|move)\()" + part), std::regex(R"((\+\+|--))" + part)};
  static const std::regex name(
      R"((const )?(knit::)?\b(Timeline|Program|Document|View|Learning|Outbox|Jobs)& \w+ = )");
  Strings found;
  const auto has = [](const std::string& line, const char* word) {
    return line.find(word) != std::string::npos;
  };
  for (const std::string& line : test_support::lines_of(code_of(source.text))) {
    // Matching costs most of these tests' time: only where a form's word stands at all.
    const bool of_a_part = has(line, "program") || has(line, "document") || has(line, "learning") ||
                           has(line, "outbox") || has(line, "jobs") || has(line, "view->");
    if (!of_a_part && !has(line, "& ")) continue;
    std::smatch named;
    const bool may_change = std::regex_search(line, named, name) && !named[1].matched;
    if (may_change || std::any_of(forms.begin(), forms.end(),
                                  [&](const std::regex& form) { return std::regex_search(line, form); }))
      found.push_back(source.name() + " changes a session: " + line);
  }
  return found;
}

// A stage takes its own settings and those before it, so nothing can depend on what is read later. What its events say
// in words, and which listing tells of it, may speak of all that was in force.
Strings takes_all_settings(const Source& source) {
  Strings wrong;
  if (source.stem.ends_with("_events") || source.stem.ends_with("_words") || source.stem.ends_with("_code"))
    return wrong;
  for (const std::string& line : test_support::lines_of(code_of(source.text))) {
    for (const std::string& all : {std::string("Settings&"), std::string("Parameters&")}) {
      for (std::size_t at = line.find(all); at != std::string::npos; at = line.find(all, at + 1)) {
        const bool of_a_group = at > 0 && std::isalpha(static_cast<unsigned char>(line[at - 1])) != 0;
        if (!of_a_group) wrong.push_back(source.name() + " takes " + all);
      }
    }
  }
  return wrong;
}

// Of keys that are no words otherwise: "epsilon" is also a term, "rows" a stage.
Strings keys_in(const Source& source) {
  Strings found;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string quoted = "\"" + std::string(info.key) + "\"";
    const bool plain = info.key.find('-') == std::string_view::npos || knit::stage_named(info.key);
    const Strings uses =
        plain ? Strings{"find_parameter(" + quoted, "key == " + quoted, "key != " + quoted} : Strings{quoted};
    for (const std::string& use : uses)
      if (source.text.find(use) != std::string::npos) found.push_back(source.name() + " says " + use);
  }
  return found;
}

template <class Check>
Strings collect(const std::string& folder, Check check) {
  Strings all;
  for (const Source& source : read_sources(folder)) {
    const Strings found = check(source);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

const Strings none;

}  // namespace

TEST_CASE("each folder includes only what the table of folders says") {
  std::size_t files = 0;
  for (const Arrow& arrow : arrows) {
    CAPTURE(arrow.folder);
    files += read_sources(arrow.folder).size();
    CHECK(collect(arrow.folder, [&](const Source& source) { return wrong_arrows(source, arrow); }) == none);
  }
  CHECK(files > 100);
}

TEST_CASE("the table of folders has no circle: each stands after what it may include") {
  std::set<std::string> before;
  for (const Arrow& arrow : arrows) {
    for (const std::string& ours : arrow.ours) {
      CAPTURE(arrow.folder, ours);
      const bool known =
          before.count(ours) == 1 || ours == "knit/" || ours == "app/" || ours == "shaders_embedded.h";
      CHECK(known);
    }
    before.insert(arrow.folder);
  }
}

TEST_CASE("every folder of sources stands in the table, and has no more than 40 files") {
  std::set<std::string> known;
  for (const Arrow& arrow : arrows) known.insert(arrow.folder);
  for (const char* top : {"knit", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KNIT_SOURCE_DIR) / top)) {
      if (!entry.is_directory()) continue;
      const std::string folder = fs::relative(entry.path(), KNIT_SOURCE_DIR).generic_string();
      CAPTURE(folder);
      const std::size_t files = read_sources(folder).size();
      if (files > 0) CHECK(known.count(folder) == 1);
      CHECK(files <= 40);
    }
  }
}

TEST_CASE("knit shows no package to others, and reads no clock") {
  for (const Arrow& arrow : arrows) {
    if (arrow.folder.rfind("knit/", 0) == 0) CHECK(collect(arrow.folder, wrong_in_knit) == none);
  }
}

TEST_CASE("knit prints nothing") {
  for (const Arrow& arrow : arrows) {
    if (arrow.folder.rfind("knit/", 0) == 0) CHECK(collect(arrow.folder, prints_in) == none);
  }
}

TEST_CASE("only the fabric and the run reckon with the numbers of rows") {
  for (const Arrow& arrow : arrows) {
    if (arrow.folder != "knit/fabric" && arrow.folder != "knit/run")
      CHECK(collect(arrow.folder, reckoned_rows) == none);
  }
}

TEST_CASE("knit gives the same bits with every library") {
  for (const Arrow& arrow : arrows) {
    if (arrow.folder.rfind("knit/", 0) == 0) CHECK(collect(arrow.folder, uneven_in) == none);
  }
}

TEST_CASE("only actions change a session's parts") {
  for (const Arrow& arrow : arrows) {
    if (arrow.folder != "app/actions") CHECK(collect(arrow.folder, changes_of_session) == none);
  }
}

// Everything includes it: what its parts are made of stays behind their names.
TEST_CASE("the session's header is light") {
  const std::set<std::string> light{"app/session/part.h", "memory", "string", "utility"};
  for (const Source& source : read_sources("app/session")) {
    if (source.name() != "app/session/session.h" && source.name() != "app/session/part.h") continue;
    for (const Include& include : includes_of(source)) {
      CAPTURE(source.name(), include.path);
      CHECK(light.count(include.path) == 1);
    }
  }
}

TEST_CASE("no stage takes all settings") {
  for (const char* folder : {"knit/mesh", "knit/import", "knit/timing", "knit/rows", "knit/stitches"})
    CHECK(collect(folder, takes_all_settings) == none);
}

TEST_CASE("a parameter's key stands in the table and the presets only") {
  for (const Arrow& arrow : arrows) {
    if (arrow.folder == "knit/model") continue;
    CHECK(collect(arrow.folder, [](const Source& source) {
            return source.name() == "app/session/presets.cpp" ? none : keys_in(source);
          }) == none);
  }
}

TEST_CASE("no source file is longer than 600 lines") {
  Strings long_files;
  for (const Arrow& arrow : arrows) {
    for (const Source& source : read_sources(arrow.folder)) {
      const std::size_t lines = test_support::lines_of(source.text).size();
      if (lines > 600) long_files.push_back(source.name() + ": " + std::to_string(lines));
    }
  }
  CHECK(long_files == none);
}

// Paths of sources that a page names and that are not there; what goes on with a star or a <word> stands for several.
Strings missing_paths(const std::string& page) {
  static const std::regex path(R"((^|[^\w/.])((knit|app|tests|tools|cmake|shaders|assets)/[\w./-]*\w)(.?))");
  Strings missing;
  for (std::sregex_iterator at(page.begin(), page.end(), path), end; at != end; ++at) {
    const fs::path named = fs::path(KNIT_SOURCE_DIR) / (*at)[2].str();
    const std::string next = (*at)[4];
    const bool there =
        fs::exists(named) || fs::exists(named.string() + ".h") || fs::exists(named.string() + ".cpp");
    if (!there && next != "*" && next != "<") missing.push_back((*at)[2]);
  }
  return missing;
}

TEST_CASE("every path that the pages name exists") {
  CHECK(missing_paths(test_support::read_text(fs::path(KNIT_SOURCE_DIR) / "README.md")) == none);
  for (const auto& entry : fs::directory_iterator(fs::path(KNIT_SOURCE_DIR) / "docs")) {
    if (entry.path().extension() != ".md") continue;
    CAPTURE(entry.path().filename().string());
    CHECK(missing_paths(test_support::read_text(entry.path())) == none);
  }
  CHECK(missing_paths("`knit/run/machine.cpp` [knit/rows] knit/none.h, tests/lesson*_test.cpp") ==
        Strings{"knit/none.h"});
}

TEST_CASE("these rules can be broken") {
  const auto source = [](const std::string& folder, const std::string& stem, bool header,
                         const std::string& text) {
    return Source{folder, stem, header, text};
  };
  const auto crossed = [&](const std::string& folder, const std::string& text) {
    const auto arrow =
        std::find_if(arrows.begin(), arrows.end(), [&](const Arrow& a) { return a.folder == folder; });
    return wrong_arrows(source(folder, "x", false, text), *arrow).size();
  };
  CHECK(crossed("knit/mesh", "#include \"app/session/session.h\"\n") == 1);
  CHECK(crossed("knit/rows", "#include \"knit/run/state.h\"\n#include \"knit/stitches/links.h\"\n") == 2);
  CHECK(crossed("knit/rows", "#include \"knit/rows/ring.h\"\n#include \"knit/model/step.h\"\n") == 0);
  CHECK(crossed("knit/mesh", "  #  include <GL/gl.h> // gl\n") == 1);
  CHECK(crossed("knit/mesh", "#include <imgui.h>\n#include <vector>\n#include <glm/vec3.hpp>\n") == 1);
  CHECK(crossed("knit/mesh", "#include <tiny_obj_loader.h>\n") == 1);
  CHECK(crossed("app/session", "#include <glad/gl.h>\n#include <imgui.h>\n#include <GLFW/glfw3.h>\n") == 3);
  CHECK(crossed("app/session", "#include \"app/panels/ui.h\"\n#include \"app/actions/opening.h\"\n") == 2);
  CHECK(crossed("app/panels/view", "#include <glad/gl.h>\n#include \"app/render/target.h\"\n") == 2);
  CHECK(crossed("app/panels/view", "#include <imgui.h>\n#include <imgui_impl_opengl3.h>\n") == 1);
  CHECK(crossed("app/render", "#include <GLFW/glfw3.h>\n#include \"app/panels/ui.h\"\n") == 2);
  CHECK(crossed("app/window", "#include <CLI/CLI.hpp>\n#include \"app/script/queries.h\"\n") == 1);
  CHECK(crossed("app", "#include \"app/render/target.h\"\n") == 1);

  const auto changed = [&](const std::string& text) {
    return changes_of_session(source("app/window", "x", false, text)).size();
  };
  CHECK(changed("session.document = Document(run);\n") == 1);
  CHECK(changed("  session.view->gaze.picking = Picking::nothing;\nsession.view->layers[3] = true;\n") == 2);
  CHECK(changed("desk.session.outbox->notices.push_back({});\nsession.document.reset();\n") == 2);
  CHECK(changed("session.document->timeline.seek(3); // back\n") == 1);
  CHECK(changed("run(std::exchange(session.outbox->pages, {}));\n++session.document->closeness_run;\n") == 2);
  CHECK(changed("knit::Timeline& timeline = session.document->timeline;\n  View& view = *session.view;\n") ==
        2);
  CHECK(changed("const View& view = *session.view;\nif (session.view->side == SidePanel::step) return;\n") ==
        0);
  CHECK(changed("scene.view = session.view->gaze.camera.view(1.0);\nx = session.document->run_ms;\n") == 0);

  const auto takes_all = [&](const std::string& text) {
    return takes_all_settings(source("knit/rows", "x", false, text)).size();
  };
  CHECK(takes_all("void f(const Settings& s);\nvoid g(const Parameters& p, const knit::Settings& s);\n") ==
        3);
  CHECK(takes_all("void f(const RowsSettings& rows, const StitchSize& stitch);  // Settings&\n") == 0);
  const auto keys = [&](const std::string& text) {
    return keys_in(source("app/x", "x", false, text)).size();
  };
  CHECK(keys("a == \"stitch-width\"; find_parameter(\"rows\"); info.key == \"epsilon\";") == 3);
  CHECK(keys("Term{\"epsilon\"}; stage == \"rows\"; \"cast-on\"") == 0);

  const auto in_knit = [&](bool header, const std::string& text) {
    return wrong_in_knit(source("knit/rows", "x", header, text)).size();
  };
  CHECK(in_knit(true, "#include <Eigen/Dense>\n") == 1);
  CHECK(in_knit(false, "#include <Eigen/Dense>\n") == 0);
  CHECK(in_knit(true, "#include <tiny_obj_loader.h>\n") == 1);
  CHECK(in_knit(false, "#include <iostream>\n#include <chrono>\n") == 2);
  const auto reckoned = [&](const std::string& text) {
    return reckoned_rows(source("app/describe", "x", false, text)).size();
  };
  CHECK(reckoned("const auto below = static_cast<std::size_t>(row) - 1;") == 1);
  CHECK(reckoned("at(place.row - 1); f(strip->row-2); fabric.rows() [i]; joins()[i - 1]; row.id - 1;") == 5);
  CHECK(reckoned("row->stitches[(i + 1) % n]; borrow - 1; rows() ; chart.rows[i]; // row - 1") == 1);
  CHECK(prints_in(
            source("knit/rows", "x", false, "std::printf(\"a\"); std::cout << 1; std::snprintf(b, 1, \"\");"))
            .size() == 2);
  CHECK(prints_in(source("knit/rows", "x", false, "// printf(1)\n/* puts */ const char* a = \"cout\";"))
            .empty());
  CHECK(uneven_in(
            source("knit/rows", "x", false, "std::hypot(a, b); glm::pow(a, b); my::sin(c); std::sinus(d);"))
            .size() == 2);
  CHECK(uneven_in(source("knit/mesh", "ranking", true, "std::nth_element(a, b, c);")) == none);
  CHECK(uneven_in(source("knit/mesh", "mesh", false, "// std::sin(a)\nstd::nth_element(a, b, c);")).size() ==
        1);
}

// Two types of one name in two headers are one to the linker, whatever they hold.
TEST_CASE("a name stands for one type") {
  const std::regex named(R"(^(?:struct|class|enum class|using) (\w+)(?: final| :| =| \{))");
  std::map<std::string, std::string> at;
  for (const Arrow& arrow : arrows) {
    const std::string space = arrow.folder.substr(0, arrow.folder.find('/')) + "::";
    for (const Source& source : read_sources(arrow.folder)) {
      if (!source.header) continue;
      for (const std::string& line : test_support::lines_of(source.text)) {
        std::smatch found;
        if (!std::regex_search(line, found, named)) continue;
        const std::string name = space + found[1].str();
        const auto [before, fresh] = at.emplace(name, source.name());
        INFO(name << " in " << before->second << " and " << source.name());
        CHECK(fresh);
      }
    }
  }
  CHECK(at.size() > 300);
}
