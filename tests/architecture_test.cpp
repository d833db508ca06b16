// The arrows of the house, read off the #include lines: third_party -> knit -> app/core -> panels, render -> window.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>

#include "tests/support/catch.h"
#include "tests/support/session.h"

namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

struct Source {
  std::string folder;  // "app/core"
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

// What a folder may include: our own folders, and outside headers beside the standard library.
struct Arrow {
  std::string folder;
  Strings ours, outside;
};

const std::array<Arrow, 6> arrows{
    Arrow{"knit", {"knit/"}, {"glm/", "Eigen/", "tiny_obj_loader.h"}},
    Arrow{"app/core", {"knit/", "app/core/"}, {"glm/", "nlohmann/json.hpp", "CLI/CLI.hpp", "unistd.h"}},
    Arrow{"app/panels", {"knit/", "app/core/", "app/panels/"}, {"glm/", "imgui.h", "imgui_internal.h"}},
    Arrow{"app/render",
          {"knit/", "app/core/", "app/render/", "shaders_embedded.h"},
          {"glm/", "glad/", "EGL/", "imgui", "stb_image_write.h", "gif_lib.h", "dlfcn.h", "malloc.h",
           "unistd.h"}},
    Arrow{"app/window",
          {"knit/", "app/core/", "app/panels/", "app/render/", "app/window/"},
          {"glm/", "glad/", "GLFW/"}},
    Arrow{"app", {"knit/", "app/core/", "app/window/"}, {}}};

Strings wrong_arrows(const Source& source, const Arrow& arrow) {
  Strings wrong;
  for (const Include& include : includes_of(source)) {
    const bool right = include.ours
                           ? begins_with_any(include.path, arrow.ours)
                           : is_standard(include.path) || begins_with_any(include.path, arrow.outside);
    if (!right) wrong.push_back(source.name() + " includes " + include.path);
  }
  return wrong;
}

// --- knit's own rules ---------------------------------------------------------------------------------------

const std::set<std::string> stage_files{"timing",       "critical", "heights",      "levels", "fields",
                                        "intrinsic",    "spokes",   "dissection",   "ring",   "cast_on",
                                        "contour",      "rows",     "contour_rows", "links",  "nearest",
                                        "stitch_index", "faces",    "pattern"};
// Geometry and parts that a stage shares.
const std::set<std::pair<std::string, std::string>> allowed_between_stages{
    {"cast_on", "ring"},         {"rows", "ring"},
    {"stitch_index", "links"},   {"levels", "critical"},
    {"contour_rows", "contour"}, {"contour_rows", "critical"},
    {"contour_rows", "heights"}, {"fields", "intrinsic"},
    {"fields", "spokes"},        {"fields", "dissection"},
    {"spokes", "intrinsic"},     {"dissection", "spokes"}};
// Below all stages: meshes, what stages hand on, and how it is kept.
const std::set<std::string> below_stages{"bug",
                                         "check",
                                         "check_topology",
                                         "edge_table",
                                         "frame",
                                         "growing",
                                         "hash",
                                         "mend",
                                         "mend_holes",
                                         "mend_parts",
                                         "mend_plan",
                                         "mesh",
                                         "obj",
                                         "obj_scan",
                                         "parameter_table",
                                         "parameters",
                                         "polygon",
                                         "products",
                                         "progress",
                                         "quoting",
                                         "shapes",
                                         "shared",
                                         "stage",
                                         "step",
                                         "surface_distance",
                                         "surface_patch",
                                         "surface_windows",
                                         "triangle_tree",
                                         "union_find"};
const std::set<std::string> above_stages{
    "machine",       "timeline",      "state",          "measures",      "narrate",
    "step_fields",   "gauge",         "rounds",         "fold",          "written_pattern",
    "pattern_words", "pattern_sizes", "pattern_text",   "yarn",          "chart",
    "wales",         "wale_columns",  "pattern_reader", "reader_cursor", "reader_grammar",
    "reader_html",   "reader_lines",  "reader_text",    "reader_words",  "reader_work",
    "why",           "breaks",        "quality",        "mirror",        "closeness",
    "problems",      "chart_text",    "why_touches",    "why_vertex",    "candidates"};

Strings wrong_in_knit(const Source& source) {
  Strings wrong;
  const auto blame = [&](const std::string& what) { wrong.push_back(source.name() + " " + what); };
  const bool stage = stage_files.count(source.stem) > 0;
  for (const Include& include : includes_of(source)) {
    if (include.path.rfind("Eigen/", 0) == 0 && source.header) blame("shows Eigen to others");
    if (include.path == "tiny_obj_loader.h" && (source.header || source.stem.rfind("obj", 0) != 0)) {
      blame("includes tinyobjloader");
    }
    if (begins_with_any(include.path,
                        {"iostream", "chrono", "ctime", "thread", "random", "print", "syncstream"})) {
      blame("includes " + include.path);
    }
    if (include.path.rfind("knit/", 0) != 0) continue;
    const std::string stem = fs::path(include.path).stem().string();
    const bool theirs = stem != source.stem && stage_files.count(stem) > 0;
    if (stage && theirs && allowed_between_stages.count({source.stem, stem}) == 0)
      blame("includes stage " + stem);
    if (stage && above_stages.count(stem) > 0) blame("is a stage and includes " + stem);
    const bool climbs = theirs || above_stages.count(stem) > 0;
    if (below_stages.count(source.stem) > 0 && climbs) blame("lies below the stages and includes " + stem);
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

TEST_CASE("each folder includes only what lies before it in the house") {
  std::size_t files = 0;
  for (const Arrow& arrow : arrows) {
    CAPTURE(arrow.folder);
    files += read_sources(arrow.folder).size();
    CHECK(collect(arrow.folder, [&](const Source& source) { return wrong_arrows(source, arrow); }) == none);
  }
  CHECK(files > 100);
}

TEST_CASE("no folder of sources is left out of the arrows") {
  std::set<std::string> known;
  for (const Arrow& arrow : arrows) known.insert(arrow.folder);
  for (const char* top : {"knit", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KNIT_SOURCE_DIR) / top)) {
      if (!entry.is_directory()) continue;
      CHECK(known.count(fs::relative(entry.path(), KNIT_SOURCE_DIR).generic_string()) == 1);
    }
  }
}

TEST_CASE("in knit a stage knows products, never another stage, and no one below it knows a stage") {
  CHECK(collect("knit", wrong_in_knit) == none);
}

TEST_CASE("the stages are the files that the rules name") {
  std::set<std::string> stems;
  for (const Source& source : read_sources("knit")) stems.insert(source.stem);
  for (const auto* names : {&stage_files, &below_stages, &above_stages}) {
    for (const std::string& name : *names) {
      CAPTURE(name);
      CHECK(stems.count(name) == 1);
    }
  }
  for (const std::string& stem : stems) {
    CAPTURE(stem);
    const bool machine_part = stem.rfind("machine_", 0) == 0;
    CHECK(stage_files.count(stem) + below_stages.count(stem) + above_stages.count(stem) +
              (machine_part ? 1U : 0U) ==
          1);
  }
}

TEST_CASE("knit prints nothing") { CHECK(collect("knit", prints_in) == none); }

TEST_CASE("no source file is longer than 500 lines") {
  Strings long_files;
  for (const Arrow& arrow : arrows) {
    for (const Source& source : read_sources(arrow.folder)) {
      const std::size_t lines = test_support::lines_of(source.text).size();
      if (lines > 500) long_files.push_back(source.name() + ": " + std::to_string(lines));
    }
  }
  CHECK(long_files == none);
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
  CHECK(crossed("knit", "#include \"app/core/session.h\"\n") == 1);
  CHECK(crossed("knit", "  #  include <GL/gl.h> // gl\n") == 1);
  CHECK(crossed("knit", "#include <imgui.h>\n#include <vector>\n#include <glm/vec3.hpp>\n") == 1);
  CHECK(crossed("app/core", "#include <glad/gl.h>\n#include <imgui.h>\n#include <GLFW/glfw3.h>\n") == 3);
  CHECK(crossed("app/core", "#include \"app/panels/ui.h\"\n") == 1);
  CHECK(crossed("app/panels", "#include <glad/gl.h>\n#include \"app/render/target.h\"\n") == 2);
  CHECK(crossed("app/panels", "#include <imgui.h>\n#include <imgui_impl_opengl3.h>\n") == 1);
  CHECK(crossed("app/render", "#include <GLFW/glfw3.h>\n#include \"app/panels/ui.h\"\n") == 2);
  CHECK(crossed("app/window", "#include <CLI/CLI.hpp>\n") == 1);
  CHECK(crossed("app", "#include \"app/render/target.h\"\n") == 1);

  const auto in_knit = [&](const std::string& stem, bool header, const std::string& text) {
    return wrong_in_knit(source("knit", stem, header, text)).size();
  };
  CHECK(in_knit("rows", false, "#include \"knit/timing.h\"\n") == 1);
  CHECK(in_knit("faces", false, "#include \"knit/links.h\"\n#include \"knit/products.h\"\n") == 1);
  CHECK(in_knit("rows", false, "#include \"knit/rows.h\"\n#include \"knit/ring.h\"\n") == 0);
  CHECK(in_knit("rows", true, "#include \"knit/state.h\"\n") == 1);
  CHECK(in_knit("mesh", false, "#include \"knit/rows.h\"\n") == 1);
  CHECK(in_knit("products", true, "#include <Eigen/Dense>\n") == 1);
  CHECK(in_knit("ring", false, "#include <Eigen/Dense>\n") == 0);
  CHECK(in_knit("mesh", false, "#include <tiny_obj_loader.h>\n") == 1);
  CHECK(in_knit("timing", false, "#include <iostream>\n#include <chrono>\n") == 2);
  CHECK(
      prints_in(source("knit", "x", false, "std::printf(\"a\"); std::cout << 1; std::snprintf(b, 1, \"\");"))
          .size() == 2);
  CHECK(prints_in(source("knit", "x", false, "// printf(1)\n/* puts */ const char* a = \"cout\";")).empty());
}
