// Sentences name settings as the command line takes them; in the window they go by their labels.
#include "app/explain/window_words.h"

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "app/compare/ways_on.h"
#include "knit/insight/narrate.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;

namespace {

// Pieces of text in quotes that name an option, where sentences for the window are made.
std::vector<std::string> literals_with_options() {
  namespace fs = std::filesystem;
  const std::regex quoted(R"re("((?:[^"\\\n]|\\.)*--[a-z](?:[^"\\\n]|\\.)*)")re");
  std::vector<std::string> found;
  for (const char* top : {"knit", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KNIT_SOURCE_DIR) / top)) {
      const std::string path = fs::relative(entry.path(), KNIT_SOURCE_DIR).generic_string();
      // Command lines themselves, what a terminal shows, and help of options.
      const bool other = path.starts_with("app/script/") || path.starts_with("app/window/") ||
                         path == "app/main.cpp" || path == "app/files/link.cpp" ||
                         path == "app/files/export.cpp" || path == "app/compare/sweep_plan.cpp";
      if (entry.path().extension() != ".cpp" || other) continue;
      const std::string text =
          std::regex_replace(test_support::read_text(entry.path()), std::regex("//[^\n]*"), "");
      for (std::sregex_iterator at(text.begin(), text.end(), quoted), end; at != end; ++at)
        found.push_back((*at)[1].str());
    }
  }
  return found;
}

}  // namespace

TEST_CASE("in the window an option goes by its label, with its value in quotes") {
  CHECK(in_window_words("take rows from contours (--rows contours, or --preset best-rows), which knit") ==
        "take rows from contours (\"Rows from: contours\", or the preset \"Best rows\"), which knit");
  CHECK(in_window_words("Sets --timing geodesic --rows contours and begins anew.") ==
        "Sets \"Timing: geodesic\", \"Rows from: contours\" and begins anew.");
  CHECK(in_window_words("--epsilon cannot be \"x\"; give a number.") ==
        "Epsilon \xCE\xB5 cannot be \"x\"; give a number.");
  CHECK(in_window_words("it is no JSON; give a file that --save-session wrote.") ==
        "it is no JSON; give a file that \"Save the session\" wrote.");
}

TEST_CASE("a lid for an edge goes by its button") {
  CHECK(in_window_words("An edge that is a hole: close it with --mend openings.") ==
        "An edge that is a hole: close it with \"Repair: close openings flat\".");
}

TEST_CASE("what is about the command line alone falls away in the window") {
  CHECK(in_window_words(
            "Join them, or keep only one: --piece 1 opens that of most, --piece 2 the next; --piece "
            "all knits each, without a window.") == "Join them, or keep only one.");
  CHECK(in_window_words("\"x\" is no parameter; remove the line, or see knit-mesh --list-parameters.") ==
        "\"x\" is no parameter; remove the line.");
  CHECK(in_window_words("One thing is wrong. Run with --headless where there is no display.") ==
        "One thing is wrong.");
  CHECK(in_window_words("begin one with the menu Learn or --lesson.") == "begin one with the menu Learn.");
}

TEST_CASE("what names no option stays as it is") {
  for (const char* text : {"", "no option", "a -- b", "x--epsilon", "--nothing-known 3", "/tmp/--", "--"})
    CHECK(in_window_words(text) == text);
}

TEST_CASE("no sentence of the program names an option in the window") {
  const std::regex option("(^|[ (])--[a-z]");
  const auto literals = literals_with_options();
  CHECK(literals.size() >= 10);
  for (const std::string& literal : literals) {
    if (literal == "--preset ") continue;  // its key follows
    INFO(literal);
    CHECK_FALSE(std::regex_search(in_window_words(literal), option));
  }
  app::Session torus = test_support::torus_from_rings();
  knit::Timeline& timeline = torus.document->timeline;
  timeline.extend_to_end();
  REQUIRE(timeline.stop() != nullptr);
  for (const WayOn& way : ways_to_try(timeline.input(), timeline.parameters_of_stop(), *timeline.stop())) {
    INFO(way.options);
    CHECK_FALSE(std::regex_search(in_window_words(way.options), option));
  }
  const std::string stop = in_window_words(knit::narrate(*timeline.stop(), timeline.parameters_of_stop()));
  CHECK_FALSE(std::regex_search(stop, option));
  // A ring is not sent to another axis.
  CHECK(contains(stop, "A shape without a handle may have rings along another axis"));
}
