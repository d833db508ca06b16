#include <algorithm>
#include <utility>

#include "app/actions/apply_parts.h"
#include "app/actions/hosting.h"
#include "app/lessons/lesson_judge.h"
#include "app/lessons/predict.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "knit/insight/narrate.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

void change(Session& session, LessonRun run) {
  session.learning->lesson = std::make_shared<const LessonRun>(std::move(run));
}

bool opens_afresh(const LessonPage& page) {
  return std::any_of(page.deeds.begin(), page.deeds.end(),
                     [](const Deed& deed) { return std::holds_alternative<OpenAsItComes>(deed); });
}

void note_score(Session& session) {
  const LessonRun& run = *session.learning->lesson;
  const LessonScore score = run.score();
  const auto best = session.program->preferences.lessons.find(run.lesson->key);
  const bool known = best != session.program->preferences.lessons.end();
  const bool better = known ? score.right > best->second.right || score.of != best->second.of
                            : score.right > 0 || run.at_end();
  if (better) session.program->preferences.lessons.insert_or_assign(run.lesson->key, score);
}

// Null: nothing is open.
std::shared_ptr<const knit::Mesh> open_mesh(const Session& session) {
  return session.document ? session.document->original : nullptr;
}

void name_next(const Session& session, LessonRun& run) {
  const auto entries = list_lessons(session.program->assets);
  const auto now = std::find_if(entries.begin(), entries.end(),
                                [&](const LessonEntry& entry) { return entry.key == run.lesson->key; });
  if (now == entries.end() || std::next(now) == entries.end()) return;
  run.next_key = std::next(now)->key;
  run.next_title = std::next(now)->title;
}

// The page has its deeds done; `first`: those of pages before it are done again, from this one on.
void open_page(Session& session, std::size_t page, std::size_t first) {
  LessonRun run = *session.learning->lesson;
  run.page = page;
  run.progress = {};
  run.progress.opening = true;
  change(session, run);
  session.view->playback.playing = false;
  apply(session, Select{});
  for (std::size_t i = first; i <= page && i < run.lesson->pages.size(); ++i) {
    for (const Deed& deed : run.lesson->pages[i].deeds) do_deed(session, deed);
  }
  const LessonPage* shown = run.shown();
  if (shown != nullptr) {
    for (const Light& light : shown->lights) {
      if (light.thing) apply(session, Select{light.thing});
    }
    const bool rests = !shown->wait && !shown->question;
    if (rests && run.outcomes[page] == PageOutcome::open) run.outcomes[page] = PageOutcome::done;
    if (shown->wait && shown->wait->parameter != nullptr && session.document)
      run.progress.value = knit::value_text(*shown->wait->parameter, session.document->timeline.parameters());
  }
  if (run.at_end()) name_next(session, run);
  if (session.document) session.document->changes = {};  // undoing ends where the page began
  run.progress.opening = false;
  run.mesh = open_mesh(session);
  change(session, std::move(run));
  note_score(session);
}

// What the page stands on: the last one up to it that opens an example afresh.
std::size_t ground_of(const Lesson& lesson, std::size_t page) {
  std::size_t first = std::min(page, lesson.pages.size() - 1);
  while (first > 0 && !opens_afresh(lesson.pages[first])) --first;
  return first;
}

void skip(Session& session) {
  LessonRun run = *session.learning->lesson;
  const LessonPage* page = run.shown();
  if (page == nullptr || run.outcome() != PageOutcome::open) return;
  run.outcomes[run.page] = PageOutcome::skipped;
  if (page->question)
    run.progress.judgement = Judgement{Said::unclear, truth_of(session, *page->question).reason};
  change(session, std::move(run));
}

}  // namespace

LessonScore LessonRun::score() const {
  LessonScore score;
  score.of = lesson->questions();
  score.right =
      static_cast<std::int32_t>(std::count(outcomes.begin(), outcomes.end(), PageOutcome::first_try));
  return score;
}

const Question* open_question(const Session& session) {
  if (!session.learning->lesson) return nullptr;
  const LessonPage* page = session.learning->lesson->shown();
  const bool open =
      page != nullptr && page->question && session.learning->lesson->outcome() == PageOutcome::open;
  return open ? &*page->question : nullptr;
}

std::optional<std::string> go_to_lesson_page(Session& session, std::int32_t number) {
  if (!session.learning->lesson) return "no lesson is open; give --lesson too.";
  const Lesson& lesson = *session.learning->lesson->lesson;
  const auto page = static_cast<std::size_t>(std::max(0, number)) - 1;
  if (number < 1 || page >= lesson.pages.size()) {
    return "the lesson " + lesson.key + " has no page " + std::to_string(number) + "; give 1 to " +
           std::to_string(lesson.pages.size()) + ".";
  }
  open_page(session, page, ground_of(lesson, page));
  return std::nullopt;
}

void take(Session& session, const StartLesson& action) {
  auto found = find_lesson(session.program->assets, action.key);
  if (auto* error = std::get_if<std::string>(&found)) {
    notify(session, Notice::Kind::error, std::move(*error));
    return;
  }
  LessonRun run;
  // From one lesson into the next, leaving still goes back to before the first.
  run.before =
      session.learning->lesson ? session.learning->lesson->before : std::make_shared<const Session>(session);
  run.lesson = std::make_shared<const Lesson>(std::move(std::get<Lesson>(found)));
  run.outcomes.assign(run.lesson->pages.size(), PageOutcome::open);
  change(session, std::move(run));
  session.view->following = true;  // until a person says otherwise
  open_page(session, 0, 0);
}

// As it was before the lesson, but for what is the program's own.
void take(Session& session, const LeaveLesson& /*action*/) {
  if (!session.learning->lesson) return;
  const std::shared_ptr<const Session> before = session.learning->lesson->before;
  if (before == nullptr) return session.learning->lesson.reset();
  go_back_to(session, *before);
  session.learning = before->learning;
  session.view->playback.playing = false;
}

void take(Session& session, const TurnLesson& action) {
  if (!session.learning->lesson) return;
  const LessonRun run = *session.learning->lesson;
  if (action.direction == 0) return open_page(session, run.page, ground_of(*run.lesson, run.page));
  if (action.direction < 0) {
    if (run.page == 0) return;
    return open_page(session, run.page - 1, ground_of(*run.lesson, run.page - 1));
  }
  if (run.at_end() || run.outcome() == PageOutcome::open) return;
  open_page(session, run.page + 1, run.page + 1);
}

void take(Session& session, const AnswerLesson& action) {
  if (!session.learning->lesson) return;
  if (action.answer == "skip") return skip(session);
  const Question* question = open_question(session);
  if (question == nullptr) return;
  // Without a window nothing works the run out by itself.
  if (session.document && !session.jobs->beside) session.document->timeline.extend_to_end();
  LessonRun run = *session.learning->lesson;
  run.progress.judgement = judge(session, *question, action.answer);
  if (run.progress.judgement->said == Said::wrong) ++run.progress.tries;
  if (run.progress.judgement->said == Said::right)
    run.outcomes[run.page] = run.progress.tries == 0 ? PageOutcome::first_try : PageOutcome::later_try;
  change(session, std::move(run));
  note_score(session);
}

void tend_lesson(Session& session, const Action& action) {
  tend_prediction(session);
  if (!session.learning->lesson || session.learning->lesson->progress.opening) return;
  const LessonRun& now = *session.learning->lesson;
  if (open_mesh(session) != now.mesh) {
    tell(session, "The lesson is over, because another mesh was opened; the menu Learn begins it again.");
    session.learning->lesson.reset();
    return;
  }
  const LessonPage* page = now.shown();
  if (page == nullptr) return;
  PageProgress progress = now.progress;
  if (!progress.from && session.document && !session.document->timeline.sought())
    progress.from = session.document->timeline.position();
  const bool waits = page->wait && now.outcome() == PageOutcome::open;
  const bool done = waits && holds(*page->wait, session, action, progress);
  if (!done && progress == now.progress) return;
  LessonRun run = now;
  run.progress = std::move(progress);
  if (done) run.outcomes[run.page] = PageOutcome::done;
  change(session, std::move(run));
}

namespace {

const knit::CandidateMeasured* measured_at(const knit::Timeline& timeline, std::size_t index) {
  return index < timeline.known() ? knit::get_if<knit::CandidateMeasured>(timeline.step(index)) : nullptr;
}

}  // namespace

std::optional<AskedVertex> asked_vertex(const Session& session) {
  if (!session.learning->prediction || !session.document || session.document->timeline.sought())
    return std::nullopt;
  const auto* next = measured_at(session.document->timeline, session.document->timeline.position());
  return next != nullptr ? std::optional(AskedVertex{next->anchor, next->candidate}) : std::nullopt;
}

std::optional<std::size_t> verdict_ahead(const Session& session, std::size_t end) {
  if (!session.learning->prediction) return std::nullopt;
  for (std::size_t position = session.document->timeline.position(); position <= end; ++position) {
    if (measured_at(session.document->timeline, position) != nullptr) return position;
  }
  return std::nullopt;
}

void wait_for_guess(Session& session) {
  Prediction prediction = *session.learning->prediction;
  prediction.playing_from = session.document->timeline.position();
  session.learning->prediction = std::make_shared<const Prediction>(std::move(prediction));
}

void take(Session& session, const SetPredicting& action) {
  if (action.on == (session.learning->prediction != nullptr)) return;
  session.learning->prediction = action.on ? std::make_shared<const Prediction>() : nullptr;
}

void take(Session& session, const Guess& action) {
  if (!asked_vertex(session)) return;
  knit::Timeline& timeline = session.document->timeline;
  const std::size_t index = timeline.position();
  const knit::Verdict verdict = measured_at(timeline, index)->verdict;
  const std::string words = knit::narrate(timeline.step(index), timeline.parameters_of_step(index));
  Prediction prediction = *session.learning->prediction;
  const bool right = action.verdict == verdict;
  ++prediction.guessed;
  prediction.right += right ? 1 : 0;
  prediction.streak = right ? prediction.streak + 1 : 0;
  const bool plays_on = prediction.playing_from == index;
  prediction.playing_from.reset();
  prediction.told = Prediction::Told{index + 1, right, words};
  std::int32_t& longest = session.program->preferences.longest_streak;
  longest = std::max(longest, prediction.streak);
  session.learning->prediction = std::make_shared<const Prediction>(std::move(prediction));
  timeline.seek(index + 1);
  session.view->playback.playing = plays_on;
  session.view->playback.direction = 1;
}

void tend_prediction(Session& session) {
  if (!session.learning->prediction || !session.document) return;
  knit::Timeline& timeline = session.document->timeline;
  // Whether a verdict comes next can be said only once its step is there; taking it later is another matter.
  if (timeline.position() == timeline.known() && !timeline.complete() && !timeline.sought())
    session.jobs->beside ? timeline.extend_briefly(1) : timeline.extend(1);
  const auto& told = session.learning->prediction->told;
  if (!told || told->position == timeline.position()) return;
  Prediction prediction = *session.learning->prediction;
  prediction.told.reset();
  session.learning->prediction = std::make_shared<const Prediction>(std::move(prediction));
}

}  // namespace app
