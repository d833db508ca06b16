// Lessons that somebody wrote by hand: what is wrong is one sentence with the page and the field.
#include <fstream>
#include <iterator>

#include "tests/support/lesson.h"

using namespace app;
using namespace test_support;

namespace {

std::string lesson_with(const std::string& page) {
  return R"({"knit-mesh-lesson": 1, "key": "k", "title": "T", "about": "A",
             "pages": [{"title": "One", "text": "First."}, )" +
         page + "]}";
}

std::string page_with(const std::string& rest) {
  return lesson_with(R"({"title": "Two", "text": "Second.", )" + rest + "}");
}

std::string fault_of(const std::string& text) {
  const auto read = read_lesson(text);
  const auto* fault = std::get_if<std::string>(&read);
  return fault != nullptr ? *fault : "";
}

void check_fault(const std::string& text, const std::vector<std::string>& parts) {
  const std::string fault = fault_of(text);
  INFO(fault);
  CHECK(is_one_sentence(fault));
  for (const std::string& part : parts) CHECK(contains(fault, part));
}

}  // namespace

TEST_CASE("every judge stands in the page about lessons") {
  std::ifstream file(std::string(KNIT_SOURCE_DIR) + "/docs/lessons.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const JudgeInfo& judge : judge_table()) {
    CAPTURE(judge.name);
    CHECK(contains(page, "`" + std::string(judge.name) + "`"));
  }
}

TEST_CASE("a lesson is read with all it may have") {
  const auto read =
      read_lesson(page_with(R"("do": [{"open": "torus"}, {"set": {"epsilon": 0.02, "axis": "x"}},
      {"seek": "rows:3:4"}, {"look": {"yaw": 90, "pitch": -10, "near": 2, "at": 7}}, {"layer": {"times": false}},
      {"side": "report"}, {"list": "problems"}, {"centre": "chart"}, {"play": 50}, {"select": "stitch:3:1"},
      {"predict": true}, {"pin": true}, {"break": "stall"}, {"slow-motion": true}, {"preset": "best-rows"}],
      "light": ["vertex:3", "row:4", "control:play"],
      "question": {"ask": "How many?", "answer": "number", "judge": "row-size", "row": 5, "hint": "H", "after": "B"})"));
  INFO(fault_of(page_with("\"x\": 1")));
  REQUIRE(std::holds_alternative<Lesson>(read));
  const Lesson& lesson = std::get<Lesson>(read);
  REQUIRE(lesson.pages.size() == 2);
  CHECK(lesson.questions() == 1);
  CHECK(lesson.pages[1].deeds.size() == 16);  // playing is a speed and a start
  CHECK(lesson.pages[1].lights.size() == 3);
  CHECK(lesson.pages[1].question->judge.row == 5);
}

TEST_CASE("a lesson that is none says so") {
  check_fault("{", {"no JSON"});
  check_fault("[]", {"knit-mesh-lesson"});
  check_fault(R"({"key": "k"})", {"knit-mesh-lesson", "missing"});
  check_fault(R"({"knit-mesh-lesson": 2, "key": "k"})", {"version 2", "version 1"});
  check_fault(R"({"knit-mesh-lesson": 1})", {"\"key\"", "missing"});
  check_fault(R"({"knit-mesh-lesson": 1, "key": "k", "title": "T", "about": "A", "pages": []})", {"pages"});
  check_fault(R"({"knit-mesh-lesson": 1, "key": "k", "title": "T", "about": "A", "pages": {}})", {"pages"});
}

TEST_CASE("a page's fault names the page and the field") {
  check_fault(lesson_with(R"({"title": "Two"})"), {"page 2.text", "missing"});
  check_fault(lesson_with(R"({"text": "x"})"), {"page 2.title", "missing"});
  check_fault(lesson_with("7"), {"page 2", "object"});
  check_fault(page_with(R"("do": [{"opne": "torus"}])"), {"page 2.do[0]", "open"});
  check_fault(page_with(R"("do": [{"open": "torus", "seek": "end"}])"), {"page 2.do[0]"});
  check_fault(page_with(R"("do": [{"seek": "nowhere"}])"), {"page 2.do[0].seek"});
  check_fault(page_with(R"("do": [{"set": {"epsilom": 1}}])"), {"page 2.do[0].set.epsilom", "no parameter"});
  check_fault(page_with(R"("do": [{"set": {"epsilon": -1}}])"), {"page 2.do[0].set.epsilon"});
  check_fault(page_with(R"("do": [{"layer": {"hat": true}}])"), {"page 2.do[0].layer.hat"});
  check_fault(page_with(R"("light": ["lamp"])"), {"page 2.light[0]", "vertex:ID"});
}

TEST_CASE("what is waited for must be said and known") {
  check_fault(page_with(R"("wait": {"steps": 3})"), {"page 2.wait.ask", "missing"});
  check_fault(page_with(R"("wait": {"ask": "Do it."})"), {"page 2.wait", "steps"});
  check_fault(page_with(R"("wait": {"ask": "Do it.", "did": "fly"})"), {"page 2.wait.did", "orbit"});
  check_fault(page_with(R"("wait": {"ask": "Do it.", "parameter": "axis", "from": 1})"), {"parameter", "is"});
  check_fault(page_with(R"("wait": {"ask": "Do it.", "parameter": "axis", "is": "q"})"), {"page 2.wait.is"});
  check_fault(page_with(R"("wait": {"ask": "Do it.", "reach": "moon"})"), {"page 2.wait.reach"});
}

TEST_CASE("a question must have a judge that fits") {
  check_fault(page_with(R"("question": {"ask": "?", "answer": "number", "judge": "my-aunt"})"),
              {"page 2.question.judge", "row-size"});
  check_fault(page_with(R"("question": {"ask": "?", "answer": "choice", "judge": "row-size", "row": 3})"),
              {"page 2.question.answer", "number"});
  check_fault(page_with(R"("question": {"ask": "?", "answer": "number", "judge": "row-size"})"),
              {"page 2.question.row", "missing"});
  check_fault(page_with(R"("question": {"ask": "?", "answer": "number", "judge": "row-size", "row": 0})"),
              {"page 2.question.row"});
  check_fault(page_with(R"("question": {"ask": "?", "answer": "choice", "judge": "verdict", "choices": [
                {"is": "too-near", "words": "a"}, {"is": "green", "words": "b"}]})"),
              {"page 2.question.choices[1].is", "accepted"});
  check_fault(page_with(R"("question": {"ask": "?", "answer": "choice", "judge": "what-if", "of": "rows"})"),
              {"page 2.question.with", "missing"});
  check_fault(page_with(R"("wait": {"ask": "Do it.", "steps": 1},
                "question": {"ask": "?", "answer": "number", "judge": "row-size", "row": 3})"),
              {"page 2.wait", "two pages"});
}

TEST_CASE("a lesson's file is named in its fault, and a key that is not there lists those that are") {
  const Folder folder;
  write_text(folder.path() / "mine.json", page_with(R"("light": ["lamp"])"));
  const auto broken = find_lesson(KNIT_ASSETS_DIR, (folder.path() / "mine.json").string());
  REQUIRE(std::holds_alternative<std::string>(broken));
  CHECK(contains(std::get<std::string>(broken), "mine.json: \"page 2.light[0]\""));
  const auto missing = find_lesson(KNIT_ASSETS_DIR, (folder.path() / "no.json").string());
  CHECK(contains(std::get<std::string>(missing), "no.json"));
  const auto unknown = std::get<std::string>(find_lesson(KNIT_ASSETS_DIR, "cooking"));
  CHECK(contains(unknown, "cooking"));
  CHECK(contains(unknown, "what-it-does"));
  CHECK(is_one_sentence(unknown));
}
