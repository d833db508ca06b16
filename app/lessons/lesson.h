// Lessons: guided steps with things to do and questions, written as files (docs/lessons.md), and the one under
// way.
//
// A page runs its deeds when it opens, then waits for a person to do something or to answer. Answers are judged from
// the current run, never from the file (lesson_judge.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/session/action.h"
#include "app/session/at.h"
#include "app/session/run_key.h"
#include "knit/model/settings_table.h"

namespace app {

inline constexpr std::int64_t lesson_version = 1;
inline constexpr std::string_view lesson_mark = "knit-mesh-lesson";  // the first field: the version

using Settings = std::vector<knit::Setting>;  // values as text, checked

// --- what a page does as it opens --------------------------------------------------------------------------

// An example as it comes: its own parameters, all layers and panels as at the program's start.
struct OpenAsItComes {
  std::string example;
};
struct SetParameters {
  Settings settings;
};
struct SeekAt {
  At at;  // a position of 0: the start
};
// In degrees, as seen from +z and from level; `near`: how many times nearer than the whole mesh needs.
struct LookFrom {
  double yaw = 209.0, pitch = -24.0, near = 1.0;
  std::optional<knit::VertexId> at;  // none: the mesh's middle
};
using Deed = std::variant<OpenAsItComes, SetParameters, SeekAt, LookFrom, Action>;

// --- what a page waits for ---------------------------------------------------------------------------------

enum class WaitKind : std::uint8_t {
  steps,     // so many steps forward since the page opened
  reach,     // this place, or a later one
  range,     // a parameter's number lies there
  value,     // a parameter has this value
  changed,   // a parameter has another value than when the page opened
  did,       // an action of this name was done
  problems,  // the whole run has no more than so many
  stopped,   // the whole run stopped early, or did not
  row_size,  // this row has that many stitches
  guesses,   // so many verdicts were guessed since the page opened
  at_end     // the run's last step is shown
};
struct Wait {
  WaitKind kind = WaitKind::steps;
  std::string ask;  // what to do, said to the person
  std::int64_t count = 0;
  std::int32_t row = 0;
  knit::Place place;
  const knit::ParameterInfo* parameter = nullptr;
  double low = 0.0, high = 0.0;
  std::string word;  // a value, or an action's name
  bool flag = false;
};
// Names of actions that can be waited for.
bool is_deed_name(const std::string& name);
std::string deed_names();

// --- questions ---------------------------------------------------------------------------------------------

enum class AnswerKind : std::uint8_t { choice, number, vertex, row, stitch };
inline constexpr std::array<std::string_view, 5> answer_kinds{"choice", "number", "vertex", "row", "stitch"};
inline bool is_clicked(AnswerKind kind) { return kind >= AnswerKind::vertex; }

struct AnswerChoice {
  std::string key;  // what the judge calls it
  std::string words;
};
// A judge by name, with what it needs to know.
struct JudgeCall {
  std::size_t judge = 0;  // in judge_table()
  std::int32_t row = 0;
  std::string word;  // "start", "m1r", "row-size"
  Settings settings;
};
struct Question {
  std::string ask;
  std::string hint;   // after a wrong answer
  std::string after;  // once it is answered
  AnswerKind kind = AnswerKind::choice;
  std::vector<AnswerChoice> choices;
  JudgeCall judge;
  // What is asked stands in the list of candidates.
  [[nodiscard]] bool hides_candidates() const;
};

// --- a lesson ----------------------------------------------------------------------------------------------

struct Light {
  std::optional<knit::Element> thing;  // selected in the view
  std::int32_t row = 0;                // or a whole row
  std::string control;                 // or a control, by its name in PanelMemory::controls
};
struct LessonPage {
  std::string title, text;
  std::vector<Deed> deeds;
  std::vector<Light> lights;
  std::optional<Wait> wait;
  std::optional<Question> question;  // never beside a wait
};
struct Lesson {
  std::string key, title, about;
  std::vector<LessonPage> pages;
  [[nodiscard]] std::int32_t questions() const;
};

// The error is one sentence that names the file, the page and the field.
std::variant<Lesson, std::string> read_lesson(const std::string& text);
std::variant<Lesson, std::string> load_lesson(const std::filesystem::path& path);
// By its key among the assets' lessons, or a file that ends in .json.
std::variant<Lesson, std::string> find_lesson(const std::filesystem::path& assets, const std::string& key);

// In the order of their files' names. One that cannot be read has its error as `about`, and no key.
struct LessonEntry {
  std::string key, title, about;
};
std::vector<LessonEntry> list_lessons(const std::filesystem::path& assets);

// --- the lesson under way ----------------------------------------------------------------------------------

enum class Said : std::uint8_t { right, wrong, unclear };  // unclear: no answer at all, not counted
struct Judgement {
  Said said = Said::unclear;
  std::string words;
  friend bool operator==(const Judgement&, const Judgement&) = default;
};

enum class PageOutcome : std::uint8_t { open, done, first_try, later_try, skipped };

struct PageProgress {
  bool opening = false;             // its deeds are being done
  std::optional<std::size_t> from;  // the position it began at, once the run has come there
  std::string value;                // of the parameter waited for, when the page opened
  std::int64_t guesses = 0;
  std::int32_t tries = 0;
  std::optional<Judgement> judgement;  // of the last answer
  // Problems of the run are counted once: for which run, known how far.
  std::optional<RunKey> counted_run;
  std::size_t counted_known = 0, problems = 0;
  friend bool operator==(const PageProgress&, const PageProgress&) = default;
};

struct LessonRun {
  std::shared_ptr<const Lesson> lesson;
  std::size_t page = 0;  // as many as there are pages: the end
  PageProgress progress;
  std::vector<PageOutcome> outcomes;       // by page
  std::shared_ptr<const Session> before;   // what leaving goes back to
  std::string next_key, next_title;        // at the end: of the lesson that follows; empty: none
  std::shared_ptr<const knit::Mesh> mesh;  // that the page is about; opening another ends the lesson

  [[nodiscard]] bool at_end() const { return page >= lesson->pages.size(); }
  // Null at the end.
  [[nodiscard]] const LessonPage* shown() const { return at_end() ? nullptr : &lesson->pages[page]; }
  [[nodiscard]] PageOutcome outcome() const { return at_end() ? PageOutcome::done : outcomes[page]; }
  [[nodiscard]] LessonScore score() const;
};

// The question that waits for an answer; null: none.
const Question* open_question(const Session& session);
// Whether an action has this name in a page's "did".
bool is_deed(const std::string& name, const Action& action);
// Whether what is waited for holds now. `action`: what was just done. Notes in `progress` what it counts.
bool holds(const Wait& wait, const Session& session, const Action& action, PageProgress& progress);

}  // namespace app
