// The strip of a lesson and the card that asks for a guess: what is clicked becomes answers.
#include "app/actions/navigate.h"
#include "app/lessons/predict.h"
#include "app/panels/dialogs/file_dialogs.h"
#include "app/panels/kit/widgets.h"
#include "app/scene/scene.h"
#include "app/session/document.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/desk.h"
#include "tests/support/lesson.h"
#include "tests/support/session.h"

using namespace desk;
using test_support::contains;
using test_support::lesson_of;

namespace {

// A page of a lesson on the desk, the run worked out, with the strip laid out.
void lay_out(Desk& desk, const std::string& key, std::int32_t page) {
  desk.session.program->assets = KNIT_ASSETS_DIR;
  apply(desk.session, StartLesson{key});
  REQUIRE(desk.session.learning->lesson);
  REQUIRE(!go_to_lesson_page(desk.session, page));
  desk.session.document->timeline.extend_to_end();
  desk.layout = layout_of(1280, 720, 1, layout_wish(desk.session));
  desk.session.view->aspect = desk.layout.view_aspect();
  go_to_lesson_page(desk.session, page);
  desk.settle();
}

// The place of a vertex in the view, as part of it.
MouseMove over_vertex(const Desk& desk, knit::VertexId vertex) {
  const Session& session = desk.session;
  const Sight view = session.view->gaze.camera.view(session.view->aspect);
  const glm::vec4 at = view.projection * view.view *
                       glm::vec4(glm::vec3(session.document->timeline.input().mesh.positions[vertex]), 1.0f);
  const Box& box = desk.layout.view;
  return {box.x + (0.5f + 0.5f * at.x / at.w) * box.width, box.y + (0.5f - 0.5f * at.y / at.w) * box.height};
}

// A click in the view counts once it can be no double click.
Actions click_at(Desk& desk, const MouseMove& place) {
  Actions all =
      desk.frames({place, MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}});
  for (int i = 0; i < 40; ++i) {
    for (Action& wish : desk.frame()) all.push_back(std::move(wish));
  }
  return all;
}

template <class T>
std::vector<T> all_of_kind(const Actions& actions) {
  std::vector<T> found;
  for (const Action& action : actions) {
    if (const auto* one = action.template get_if<T>()) found.push_back(*one);
  }
  return found;
}

}  // namespace

TEST_CASE("a lesson has a strip of its own below the view, and its ways on") {
  Desk desk(1280, 720);
  lay_out(desk, "what-it-does", 1);
  CHECK(desk.layout.lesson.height == 150.0f);
  CHECK(desk.ui.controls.count("lesson/task") == 1);
  const auto& task = desk.ui.controls.at("lesson/task");
  CHECK(task.right() <= desk.layout.lesson.right());
  CHECK(task.bottom() <= desk.layout.lesson.bottom());
  CHECK(only<AnswerLesson>(desk.click("lesson/skip")).answer == "skip");
  apply(desk.session, Orbit{0.1, 0.0});
  desk.settle();
  CHECK(desk.ui.controls.count("lesson/skip") == 0);
  CHECK(only<TurnLesson>(desk.click("lesson/next")).direction == 1);
  CHECK(only<TurnLesson>(desk.click("lesson/again")).direction == 0);
  CHECK(desk.click("lesson/back").empty());  // the first page
  CHECK(desk.click("lesson/leave").size() == 1);
}

TEST_CASE("the head of a lesson says its page and cuts no word") {
  Desk desk(1280, 720, 1, KNIT_ASSETS_DIR "/fonts");
  lay_out(desk, "picking-a-row", 2);
  REQUIRE(desk.ui.controls.count("lesson/where") == 1);
  const Box where = desk.ui.controls.at("lesson/where");
  CHECK(where.x >= desk.ui.controls.at("lesson/title").right());
  CHECK(where.right() <= desk.ui.controls.at("lesson/again").x);
  CHECK(where.width < 60.0f);  // the page's number alone
  lay_out(desk, "what-it-does", 4);
  CHECK(desk.ui.controls.at("lesson/where").width > 100.0f);
}

TEST_CASE("choices and typed numbers become answers") {
  Desk desk(1280, 720);
  lay_out(desk, "what-it-does", 7);
  CHECK(only<AnswerLesson>(desk.click("lesson/choice/fewer")).answer == "fewer");
  lay_out(desk, "what-it-does", 6);
  CHECK(desk.click("lesson/field").empty());
  desk.type("0.05");
  CHECK(only<AnswerLesson>(desk.frames({KeyPress{Key::Enter, true, {}}})).answer == "0.05");
}

TEST_CASE("while a question waits for a vertex, a click in the view answers it") {
  Desk desk(1280, 720);
  lay_out(desk, "what-it-does", 4);
  const auto truth = truth_of(desk.session, *open_question(desk.session));
  REQUIRE(truth.answers.size() == 1);
  const auto vertex = static_cast<knit::VertexId>(std::stoul(truth.answers[0].substr(7)));
  const Actions wishes = click_at(desk, over_vertex(desk, vertex));
  const auto answers = all_of_kind<AnswerLesson>(wishes);
  REQUIRE(answers.size() == 1);
  CHECK(answers[0].answer == truth.answers[0]);
  CHECK(count_of<ShowWhy>(wishes) == 0);
  desk.act({answers[0]});
  CHECK(lesson_of(desk.session).outcome() == PageOutcome::first_try);
  // Answered, a click asks why again.
  desk.settle();
  CHECK(count_of<AnswerLesson>(click_at(desk, over_vertex(desk, vertex))) == 0);
}

TEST_CASE("a control that a page lights is scrolled into its panel's sight") {
  Desk desk(1280, 720);
  lay_out(desk, "what-it-does", 8);
  REQUIRE(desk.ui.controls.count("knob/epsilon") == 1);
  const Box& knob = desk.ui.controls.at("knob/epsilon");
  CHECK(knob.y >= desk.layout.parameters.y);
  CHECK(knob.bottom() <= desk.layout.parameters.bottom());
}

TEST_CASE("the end of a lesson offers the next one") {
  Desk desk(1280, 720);
  lay_out(desk, "what-it-does", 11);
  apply(desk.session, ToLast{});
  apply(desk.session, TurnLesson{1});
  REQUIRE(lesson_of(desk.session).at_end());
  desk.settle();
  CHECK(desk.ui.controls.count("lesson/score") == 1);
  CHECK(only<StartLesson>(desk.click("lesson/next-lesson")).key == "timing-and-axis");
  CHECK(only<StartLesson>(desk.click("lesson/once-more")).key == "what-it-does");
}

TEST_CASE("the menu Learn lists the lessons") {
  Desk desk(1280, 720);
  desk.session.program->assets = KNIT_ASSETS_DIR;
  desk.open();
  CHECK(desk.click("menu/learn").empty());
  desk.settle();
  CHECK(only<StartLesson>(desk.click("menu/lesson/closing-a-row")).key == "closing-a-row");
}

TEST_CASE("the card that asks for a guess covers nothing of the view, whatever else stands there") {
  for (const float scale : {1.0f, 2.0f}) {
    for (const bool lesson : {false, true}) {
      Desk desk(1280, 720, scale);
      desk.session.program->assets = KNIT_ASSETS_DIR;
      desk.open();
      if (lesson) apply(desk.session, StartLesson{"picking-a-row"});
      apply(desk.session, SetPredicting{true});
      apply(desk.session, SeekPlace{{knit::Stage::rows, 2, 1}});
      desk.layout = layout_of(1280, 720, scale, layout_wish(desk.session));
      desk.settle();
      const Box& card = desk.layout.guess;
      CHECK(card.y == desk.layout.view.bottom());
      CHECK(card.bottom() == (lesson ? desk.layout.lesson.y : desk.layout.timeline.y));
      CHECK(desk.layout.view.height >= 720.0f / 3.0f);
      const Box& question = desk.ui.controls.at("predict/question");
      CHECK(question.y >= card.y);
      CHECK(question.bottom() <= card.bottom());
    }
  }
}

TEST_CASE("the card below the view asks for a guess") {
  Desk desk(1280, 720);
  desk.open();
  CHECK(desk.ui.controls.count("predict/question") == 0);
  apply(desk.session, SetPredicting{true});
  apply(desk.session, SeekPlace{{knit::Stage::rows, 2, 1}});
  REQUIRE(asked_vertex(desk.session));
  desk.layout = layout_of(1280, 720, 1, layout_wish(desk.session));
  desk.settle();
  CHECK(only<Guess>(desk.click("predict/near")).verdict == knit::Verdict::too_near);
  CHECK(only<Guess>(desk.click("predict/accepted")).verdict == knit::Verdict::accepted);
  CHECK(only<Guess>(desk.click("predict/far")).verdict == knit::Verdict::too_far);
  CHECK(only<StepBy>(desk.click("predict/skip")).direction == 1);
  CHECK(only<Guess>(desk.press({Key::W, {}, 0})).verdict == knit::Verdict::accepted);
  CHECK(!only<SetPredicting>(desk.click("predict/close")).on);
  CHECK(!only<SetPredicting>(desk.press({Key::G, {}, 0})).on);
  apply(desk.session, Guess{knit::Verdict::too_near});
  desk.settle();
  CHECK(desk.ui.controls.count("predict/told") == 1);
}

TEST_CASE("a worksheet is saved under its own lesson's number and name") {
  Desk desk;
  for (const auto& [key, name] : {std::pair("what-it-does", "lesson-1-what-it-does.html"),
                                  {"picking-a-row", "lesson-3-picking-a-row.html"}}) {
    lay_out(desk, key, 1);
    desk.click("lesson/worksheet");
    desk.settle();
    CHECK(desk.ui.own<SaveDialog>().path.text() == name);
    desk.act(desk.press(Chord{Key::Escape, {}, 0}));
    desk.settle();
  }
}

TEST_CASE("presented beside the view the text of every lesson has 20 to 40 letters a line") {
  for (const auto& [width, height] : {std::pair{1280.0f, 720.0f}, {1920.0f, 1080.0f}, {3840.0f, 2160.0f}}) {
    const float scale = presenting_scale(width, height, 1.0f);
    Desk desk(width, height, scale, KNIT_ASSETS_DIR "/fonts");
    desk.session.program->assets = KNIT_ASSETS_DIR;
    apply(desk.session, StartLesson{"what-it-does"});
    apply(desk.session, Present{});
    desk.layout = layout_of(width, height, scale, layout_wish(desk.session));
    desk.settle();
    const float room = desk.ui.controls.at("lesson/text").width;
    std::size_t longest = 0;
    for (const LessonPage& page : desk.session.learning->lesson->lesson->pages) {
      for (const std::string& line : test_support::lines_of(wrapped_at_blanks(page.text, room)))
        longest = std::max(longest, line.size());
    }
    INFO(width << ": " << longest);
    CHECK(longest >= 20);
    CHECK(longest <= 40 + 2);  // bytes: a dash has three
  }
}
