// The lesson in its strip below the view: what it says on the left, what it asks for on the right.
#include <algorithm>
#include <string>

#include "app/lessons/lesson.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/dialogs/menu_parts.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/lesson_marks.h"
#include "app/panels/kit/widgets.h"
#include "app/session/learning.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

float button_width(const char* words) {
  return ImGui::CalcTextSize(words).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

// --- the head: where one is, and ways on -------------------------------------------------------------------

void draw_ways(PanelFrame& frame, const LessonRun& run) {
  const bool open = run.outcome() == PageOutcome::open;
  const char* on = open ? "Skip page" : "Next";
  const ImVec2 square(ImGui::GetFrameHeight(), ImGui::GetFrameHeight());
  if (!run.at_end()) {
    if (icon_button("again", Icon::reset, square)) frame.wish(TurnLesson{0});
    frame.mark("lesson/again");
    tooltip(frame, "Set this page up again, as it was when it opened.");
    ImGui::SameLine();
  }
  ImGui::BeginDisabled(run.page == 0);
  if (ImGui::Button("Back")) frame.wish(TurnLesson{-1});
  ImGui::EndDisabled();
  frame.mark("lesson/back");
  ImGui::SameLine();
  if (!run.at_end()) {
    if (lit_button(on, !open)) frame.wish(open ? Action(AnswerLesson{"skip"}) : Action(TurnLesson{1}));
    frame.mark(open ? "lesson/skip" : "lesson/next");
    tooltip(frame,
            open ? "Go on without it; a question then does not count as answered." : "To the next page.");
    ImGui::SameLine();
  }
  if (icon_button("worksheet", Icon::copy, square)) ask_to_save(frame, "worksheet");
  frame.mark("lesson/worksheet");
  tooltip(frame,
          "Save this lesson as a worksheet to print, with its pictures and questions; answers on a page of "
          "their own.");
  ImGui::SameLine();
  if (icon_button("leave", Icon::cross, square)) frame.wish(LeaveLesson{});
  frame.mark("lesson/leave");
  tooltip(frame, "Leave the lesson; everything is put back as it was before it.");
}

std::string where_of(const LessonRun& run) {
  if (run.shown() == nullptr) return "is done";
  return std::to_string(run.page + 1) + " of " + std::to_string(run.lesson->pages.size()) + ", " +
         run.lesson->title;
}

// Beside the view, while presenting: a line each.
void draw_tall_head(PanelFrame& frame, const LessonRun& run) {
  push_font(frame.fonts.strong);
  const LessonPage* page = run.shown();
  wrapped_text(page != nullptr ? page->title : run.lesson->title);
  pop_font();
  frame.mark("lesson/title");
  wrapped_text(where_of(run), theme().faint_text);
  draw_ways(frame, run);
}

void draw_head(PanelFrame& frame, const LessonRun& run) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float left = ImGui::GetCursorPosX();
  const float side = ImGui::GetFrameHeight();
  const char* on = run.outcome() == PageOutcome::open ? "Skip page" : "Next";
  const float middle = run.at_end() ? 0.0f : side + gap + button_width(on) + gap;
  const float ways = middle + button_width("Back") + 2.0f * (gap + side);
  const float right = left + ImGui::GetContentRegionAvail().x - ways;
  ImGui::AlignTextToFramePadding();
  const LessonPage* page = run.shown();
  const std::string& lesson = run.lesson->title;
  const std::string title = page != nullptr ? page->title : lesson;
  std::string where = where_of(run);
  push_font(frame.fonts.strong);
  text(cut_to_width(title, right - left - gap));
  pop_font();
  frame.mark("lesson/title");
  ImGui::SameLine(0.0f, frame.units(10.0f));
  // The page's number alone where the lesson's name would be cut.
  const float room = right - ImGui::GetCursorPosX() - gap;
  if (ImGui::CalcTextSize(where.c_str()).x > room) where.resize(std::min(where.find(','), where.size()));
  if (ImGui::CalcTextSize(where.c_str()).x <= room) {
    faint_text(where);
    frame.mark("lesson/where");
    tooltip(frame, where_of(run));
  }
  ImGui::SameLine(right);
  draw_ways(frame, run);
}

// --- answers -----------------------------------------------------------------------------------------------

void draw_choices(PanelFrame& frame, const Question& question) {
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const AnswerChoice& choice : question.choices) {
    if (!first) {
      ImGui::SameLine(0.0f, frame.units(6.0f));
      if (ImGui::GetCursorPosX() + button_width(choice.words.c_str()) > end) ImGui::NewLine();
    }
    first = false;
    if (ImGui::Button(choice.words.c_str())) frame.wish(AnswerLesson{choice.key});
    frame.mark("lesson/choice/" + choice.key);
  }
}

// Emptied when the page turns.
struct LessonField {
  TextBuffer text;
  std::string page;
};

void draw_typed(PanelFrame& frame, const Question& question, const LessonRun& run) {
  LessonField& field = frame.own<LessonField>();
  const std::string page = run.lesson->key + " " + std::to_string(run.page);
  if (field.page != page) {
    field.page = page;
    field.text.set("");
  }
  ImGui::SetNextItemWidth(frame.units(84.0f));
  const bool entered = ImGui::InputText("##answer", field.text.bytes.data(), field.text.bytes.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue);
  frame.mark("lesson/field");
  ImGui::SameLine(0.0f, frame.units(6.0f));
  const bool clicked = ImGui::Button("Answer");
  frame.mark("lesson/answer");
  if (!entered && !clicked) return;
  const std::string typed = field.text.text();
  frame.wish(AnswerLesson{question.kind == AnswerKind::row ? "row:" + typed : typed});
}

void draw_answering(PanelFrame& frame, const Question& question, const LessonRun& run) {
  if (question.kind == AnswerKind::choice) return draw_choices(frame, question);
  if (!is_clicked(question.kind)) return draw_typed(frame, question, run);
  if (question.kind != AnswerKind::row) return faint_text("Click it in the view.");
  ImGui::AlignTextToFramePadding();
  faint_text("Click it, or type:");
  ImGui::SameLine(0.0f, frame.units(6.0f));
  draw_typed(frame, question, run);
}

// --- what is asked for -------------------------------------------------------------------------------------

void strong_words(const PanelFrame& frame, const char* words, Colour colour) {
  push_font(frame.fonts.strong);
  wrapped_text(words, colour);
  pop_font();
}

const char* head_of(PageOutcome outcome) {
  switch (outcome) {
    case PageOutcome::first_try:
      return "Right.";
    case PageOutcome::later_try:
      return "Right, though not at once.";
    case PageOutcome::skipped:
      return "Skipped.";
    case PageOutcome::done:
    case PageOutcome::open:
      break;
  }
  return "Done.";
}

void draw_question(PanelFrame& frame, const Question& question, const LessonRun& run) {
  const auto& said = run.progress.judgement;
  if (run.outcome() != PageOutcome::open) {
    const bool skipped = run.outcome() == PageOutcome::skipped;
    strong_words(frame, head_of(run.outcome()), skipped ? theme().faint_text : theme().selected);
    if (said) wrapped_text(said->words);
    if (!question.after.empty()) wrapped_text(question.after);
    frame.mark("lesson/reason");
    return;
  }
  wrapped_text(question.ask);
  draw_answering(frame, question, run);
  if (!said) return;
  wrapped_text(said->words, said->said == Said::wrong ? theme().problem : theme().faint_text);
  frame.mark("lesson/verdict");
}

void draw_wait(PanelFrame& frame, const Wait& wait, const LessonRun& run) {
  const bool open = run.outcome() == PageOutcome::open;
  const bool skipped = run.outcome() == PageOutcome::skipped;
  const char* head = open ? "Your turn" : head_of(run.outcome());
  strong_words(frame, head, open ? theme().accent : skipped ? theme().faint_text : theme().selected);
  wrapped_text(wait.ask, open ? theme().text : theme().faint_text);
  frame.mark("lesson/wait");
}

// What a page says, and what it asks for: beside each other below the view, below each other beside it.
struct PageParts {
  ImVec2 words, task;
};

PageParts parts_of(const PanelFrame& frame, const LessonPage& page, bool asks) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = frame.units(12.0f);
  if (frame.session.view->presenting) {
    constexpr float most_words = 0.6f;
    const float needed = ImGui::CalcTextSize(page.text.c_str(), nullptr, false, room.x).y + gap;
    const float words = asks ? std::min(needed, most_words * room.y) : room.y;
    return {ImVec2(room.x, words), ImVec2(room.x, room.y - words - ImGui::GetStyle().ItemSpacing.y)};
  }
  const float task = asks ? std::clamp(0.5f * room.x, frame.units(200.0f), frame.units(460.0f)) : 0.0f;
  const float words = std::min(asks ? room.x - task - gap : room.x, frame.units(680.0f));
  return {ImVec2(words, room.y), ImVec2(task, room.y)};
}

void draw_page(PanelFrame& frame, const LessonPage& page, const LessonRun& run) {
  const bool asks = page.wait || page.question;
  const PageParts parts = parts_of(frame, page, asks);
  // A number that changes with the page, so that each begins at its top.
  ImGui::PushID(static_cast<int>(run.page));
  ImGui::BeginChild("words", parts.words, false);
  wrapped_text(page.text);
  ImGui::EndChild();
  frame.mark("lesson/text");
  if (asks) {
    if (!frame.session.view->presenting) ImGui::SameLine(0.0f, frame.units(12.0f));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, style::vector(theme().raised));
    ImGui::PushStyleColor(ImGuiCol_Button, style::vector(theme().pressed));
    ImGui::PushStyleColor(ImGuiCol_FrameBg, style::vector(theme().panel));
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, frame.units(6.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.units(10.0f), frame.units(5.0f)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(ImGui::GetStyle().ItemSpacing.x, frame.units(2.0f)));
    ImGui::BeginChild("task", parts.task, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    if (page.wait) draw_wait(frame, *page.wait, run);
    if (page.question) draw_question(frame, *page.question, run);
    ImGui::EndChild();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor(3);
    frame.mark("lesson/task");
  }
  ImGui::PopID();
}

void draw_end(PanelFrame& frame, const LessonRun& run) {
  const LessonScore score = run.score();
  const auto best = frame.session.program->preferences.lessons.find(run.lesson->key);
  std::string words = "You answered " + std::to_string(score.right) + " of " +
                      knit::plural(static_cast<std::int64_t>(score.of), "question", "questions") +
                      " at the first try.";
  if (best != frame.session.program->preferences.lessons.end() && best->second.right > score.right)
    words += " Your best so far is " + std::to_string(best->second.right) + ".";
  wrapped_text(words);
  frame.mark("lesson/score");
  ImGui::Dummy(ImVec2(0.0f, frame.units(4.0f)));
  if (!run.next_key.empty()) {
    if (lit_button(("Next lesson: " + run.next_title).c_str(), true)) frame.wish(StartLesson{run.next_key});
    frame.mark("lesson/next-lesson");
    ImGui::SameLine();
  }
  if (ImGui::Button("Once more")) frame.wish(StartLesson{run.lesson->key});
  frame.mark("lesson/once-more");
  ImGui::SameLine();
  if (ImGui::Button("Leave")) frame.wish(LeaveLesson{});
  frame.mark("lesson/done");
}

}  // namespace

void draw_lesson(PanelFrame& frame) {
  const LessonRun& run = *frame.session.learning->lesson;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.units(14.0f), frame.units(6.0f)));
  begin_panel("Lesson", frame.layout.lesson, ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  if (frame.session.view->presenting) {
    draw_tall_head(frame, run);
  } else {
    draw_head(frame, run);
  }
  if (const LessonPage* page = run.shown()) {
    draw_page(frame, *page, run);
  } else {
    draw_end(frame, run);
  }
  ImGui::End();
  draw_lit_controls(frame);
}

void draw_lesson_menu(PanelFrame& frame) {
  const bool open = ImGui::BeginMenu("Learn");
  if (!open) return frame.mark("menu/learn");
  if (key_pressed(Key::Escape)) ImGui::CloseCurrentPopup();
  const auto& scores = frame.session.program->preferences.lessons;
  for (const LessonEntry& entry : list_lessons(frame.session.program->assets)) {
    const auto score = scores.find(entry.key);
    const std::string best = score == scores.end() ? ""
                                                   : std::to_string(score->second.right) + " of " +
                                                         std::to_string(score->second.of) + " right";
    const bool now =
        frame.session.learning->lesson && frame.session.learning->lesson->lesson->key == entry.key;
    if (ImGui::MenuItem(entry.title.c_str(), best.c_str(), now, !entry.key.empty()))
      frame.wish(StartLesson{entry.key});
    frame.mark("menu/lesson/" + (entry.key.empty() ? entry.title : entry.key));
    tooltip(frame, entry.about);
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Leave the lesson", nullptr, false, frame.session.learning->lesson != nullptr))
    frame.wish(LeaveLesson{});
  frame.mark("menu/Leave the lesson");
  const CommandInfo& predict = info_of(Command::predict);
  if (ImGui::MenuItem(words_of(predict).c_str(), keys_of(predict).c_str(),
                      frame.session.learning->prediction != nullptr, frame.timeline() != nullptr))
    frame.wish(SetPredicting{frame.session.learning->prediction == nullptr});
  frame.mark("menu/predict");
  ImGui::EndMenu();
}

}  // namespace app
