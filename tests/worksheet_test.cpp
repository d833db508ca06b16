// A lesson on paper: every page with its picture, room to answer, and the answers apart.
#include "app/files/worksheet.h"

#include <algorithm>
#include <string>

#include "app/actions/navigate.h"
#include "app/actions/worksheet_pages.h"
#include "app/files/export.h"
#include "app/lessons/lesson.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

std::size_t count_in(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

Worksheet small_sheet() {
  Worksheet sheet{"Rows & rings", "What a row is.", {}};
  sheet.pages.push_back({"Look", "A <ring>.", "Take one step.", std::nullopt, {1, 2, 3}});
  sheet.pages.push_back(
      {"Guess", "Now.", "", SheetQuestion{"Which?", {"more", "fewer"}, false, "more", "It grows."}, {}});
  sheet.pages.push_back(
      {"Mark", "Here.", "", SheetQuestion{"Where?", {}, true, "vertex 7", "It is nearest."}, {4}});
  return sheet;
}

}  // namespace

TEST_CASE("a worksheet has a picture and room on each page, and its answers only on the last") {
  const std::string html = worksheet_html(small_sheet());
  CHECK(html.find("<h1>Rows &amp; rings</h1>") != std::string::npos);
  CHECK(html.find("A &lt;ring&gt;.") != std::string::npos);
  CHECK(count_in(html, "data:image/png;base64,") == 2);
  CHECK(html.find("base64,AQID\"") != std::string::npos);
  CHECK(count_in(html, "<li>") == 2);
  CHECK(count_in(html, "class=\"line\"") == 2 + 1 + 1);  // the task, why a choice, beside the mark
  const std::size_t answers = html.find("class=\"answers\"");
  REQUIRE(answers != std::string::npos);
  CHECK(html.find("It grows.") > answers);
  CHECK(html.find("vertex 7") > answers);
  CHECK(html.rfind("Which?") < answers);
}

TEST_CASE("a lesson's worksheet has all of its pages, with what is right in each one's own run") {
  Session session = test_support::small_session();
  CHECK(worksheet_missing(session));
  apply(session, StartLesson{"picking-a-row"});
  REQUIRE(session.learning->lesson);
  CHECK_FALSE(worksheet_missing(session));
  const std::size_t position = session.document->timeline.position();
  std::vector<double> aspects;
  const Worksheet sheet = worksheet_of(session, [&](Session& page) {
    aspects.push_back(page.view->aspect);
    CHECK(page.program->preferences.theme == ThemeKind::light);
    return std::vector<std::uint8_t>{static_cast<std::uint8_t>(aspects.size())};
  });
  const Lesson& lesson = *session.learning->lesson->lesson;
  REQUIRE(sheet.pages.size() == lesson.pages.size());
  CHECK(aspects.size() == lesson.pages.size());
  for (const SheetPage& page : sheet.pages) {
    INFO(page.title);
    CHECK_FALSE(page.picture_png.empty());
    if (!page.question) continue;
    CHECK_FALSE(page.question->answer.empty());
    CHECK_FALSE(page.question->reason.empty());
    const auto& choices = page.question->choices;
    if (!choices.empty())
      CHECK(std::find(choices.begin(), choices.end(), page.question->answer) != choices.end());
  }
  // Row 30 of the thesis's sphere.
  CHECK(sheet.pages[3].question->answer == "65");
  CHECK(session.learning->lesson->page == 0);
  CHECK(session.document->timeline.position() == position);
}

TEST_CASE("in a window a worksheet waits for its pictures and without a lesson there is none") {
  Session session = test_support::small_session();
  apply(session, OpenExample{"sphere"});
  apply(session, Export{"worksheet", "sheet.html"});
  CHECK(session.outbox->worksheets.size() == 1);
  CHECK(export_to_file(session, {"worksheet", "sheet.html"}).value_or("").find("no lesson is open") !=
        std::string::npos);
  CHECK(export_to_file(session, {"worksheet", "sheet.pdf"}).value_or("").find(".html") != std::string::npos);
}
