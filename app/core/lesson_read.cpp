// Lessons from files: docs/lessons.md has the fields. What is wrong is one sentence with the page and the field.
#include <algorithm>
#include <fstream>
#include <functional>

#include "app/core/json_fields.h"
#include "app/core/lesson_judge.h"
#include "app/core/lesson_parts.h"
#include "app/core/why_words.h"

namespace app {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20U;
constexpr std::int64_t most_rows = 1000000;

// --- lights ------------------------------------------------------------------------------------------------

void read_lights(JsonFields& fields, LessonPage& page) {
  if (!fields.has("light")) return;
  const Json& list = fields.array("light");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string text = list[i].is_string() ? list[i].get<std::string>() : "";
    Light light;
    light.thing = thing_named(text);
    light.row = row_of_answer(text);
    if (text.rfind("control:", 0) == 0) light.control = text.substr(8);
    if (light.thing) light.row = 0;
    const bool known = light.thing || light.row > 0 || !light.control.empty();
    if (!known)
      fields.set_fault("light[" + std::to_string(i) + "]",
                       "must be stitch:ROW:ITEM, vertex:ID, row:N or control:NAME, in quotes.");
    page.lights.push_back(light);
  }
}

// --- questions ---------------------------------------------------------------------------------------------

void read_choices(JsonFields& fields, const JudgeInfo& info, Question& question) {
  const Json& list = need_array(fields, "choices");
  for (std::size_t i = 0; i < list.size(); ++i) {
    JsonFields entry = fields.entry("choices", i);
    AnswerChoice choice{need_text(entry, "is"), need_text(entry, "words")};
    const bool known = std::find(info.words.begin(), info.words.end(), choice.key) != info.words.end();
    if (!known) entry.set_fault("is", "must be one of " + joined(info.words) + ".");
    question.choices.push_back(std::move(choice));
  }
  if (list.size() < 2 || list.size() > 5) fields.set_fault("choices", "must be two to five answers.");
}

void read_word(JsonFields& fields, const JudgeInfo& info, JudgeCall& call) {
  call.word = need_text(fields, "of");
  if (std::find(info.words.begin(), info.words.end(), call.word) == info.words.end())
    fields.set_fault("of", "must be one of " + joined(info.words) + ".");
}

void read_call(JsonFields& fields, const JudgeInfo& info, JudgeCall& call) {
  const bool wants_row = info.needs == JudgeNeeds::row || info.needs == JudgeNeeds::row_and_word;
  if (wants_row) call.row = static_cast<std::int32_t>(need_whole(fields, "row", 1, most_rows));
  if (info.needs == JudgeNeeds::word || info.needs == JudgeNeeds::row_and_word) read_word(fields, info, call);
  if (info.name == "band-edge" && fields.has("with")) call.settings = read_settings(fields, "with");
  if (info.needs != JudgeNeeds::change) return;
  call.settings = read_settings(fields, "with");
  if (info.name != "what-if") return;
  constexpr std::array<std::string_view, 4> measures{"stitches", "row-size", "rows", "problems"};
  need(fields, "of");
  call.word = measures.at(fields.choice("of", measures));
  if (call.word == "row-size") call.row = static_cast<std::int32_t>(need_whole(fields, "row", 1, most_rows));
}

Question read_question(JsonFields fields) {
  Question question;
  question.ask = need_text(fields, "ask");
  if (fields.has("hint")) question.hint = fields.text("hint");
  if (fields.has("after")) question.after = fields.text("after");
  const auto table = judge_table();
  std::vector<std::string_view> names;
  for (const JudgeInfo& info : table) names.push_back(info.name);
  need(fields, "judge");
  question.judge.judge = fields.choice("judge", names);
  const JudgeInfo& info = table[question.judge.judge];
  need(fields, "answer");
  question.kind = static_cast<AnswerKind>(fields.choice("answer", answer_kinds));
  if (std::find(info.kinds.begin(), info.kinds.end(), question.kind) == info.kinds.end()) {
    fields.set_fault("answer",
                     "must be " + std::string(answer_kinds.at(static_cast<std::size_t>(info.kinds.front()))) +
                         " for the judge " + std::string(info.name) + ".");
  }
  read_call(fields, info, question.judge);
  if (question.kind == AnswerKind::choice) read_choices(fields, info, question);
  return question;
}

// --- pages -------------------------------------------------------------------------------------------------

LessonPage read_page(JsonFields& fields) {
  LessonPage page;
  page.title = need_text(fields, "title");
  page.text = need_text(fields, "text");
  if (fields.has("do")) page.deeds = read_deeds(fields);
  read_lights(fields, page);
  if (fields.has("wait")) page.wait = read_wait(fields.object("wait"));
  if (fields.has("question")) page.question = read_question(fields.object("question"));
  if (page.wait && page.question)
    fields.set_fault("wait", "cannot stand beside a question; make two pages of them.");
  return page;
}

std::string fault_of_version(const Json& json) {
  const std::string mark(lesson_mark);
  if (!json.is_object() || !json.contains(mark))
    return "it is no lesson: \"" + mark + "\" is missing; begin it with \"" + mark + "\": 1.";
  const Json& version = json[mark];
  if (version.is_number_integer() && version == lesson_version) return "";
  return "it is of version " + version.dump() + ", and this program reads version " +
         std::to_string(lesson_version) + "; change \"" + mark + "\" or take a newer knit-mesh.";
}

std::vector<fs::path> lesson_files(const fs::path& assets) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(assets / "lessons", error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::int32_t Lesson::questions() const {
  return static_cast<std::int32_t>(std::count_if(
      pages.begin(), pages.end(), [](const LessonPage& page) { return page.question.has_value(); }));
}

std::variant<Lesson, std::string> read_lesson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::string("it is no JSON; look for a missing comma, quote or bracket.");
  if (auto fault = fault_of_version(json); !fault.empty()) return fault;
  JsonFields fields(json);
  Lesson lesson;
  lesson.key = need_text(fields, "key");
  lesson.title = need_text(fields, "title");
  lesson.about = need_text(fields, "about");
  const Json& pages = need_array(fields, "pages");
  if (pages.empty()) fields.set_fault("pages", "must have at least one page.");
  if (!fields.fault().empty()) return fields.fault();
  for (std::size_t i = 0; i < pages.size(); ++i) {
    JsonFields page(pages[i], "page " + std::to_string(i + 1));
    lesson.pages.push_back(read_page(page));
    if (!page.fault().empty()) return page.fault();
  }
  return lesson;
}

std::variant<Lesson, std::string> load_lesson(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error))
    return path.string() + " is no file; give a lesson's file, or a key of --list-lessons.";
  if (fs::file_size(path, error) > most_bytes)
    return path.string() + " is larger than 1 MB, so it is no lesson; give a lesson's file.";
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) return path.string() + " cannot be read; see to its permissions.";
  auto lesson = read_lesson(text);
  if (const auto* fault = std::get_if<std::string>(&lesson)) return path.string() + ": " + *fault;
  return lesson;
}

std::variant<Lesson, std::string> find_lesson(const fs::path& assets, const std::string& key) {
  if (fs::path(key).extension() == ".json") return load_lesson(key);
  std::string keys;
  for (const fs::path& file : lesson_files(assets)) {
    auto lesson = load_lesson(file);
    const auto* read = std::get_if<Lesson>(&lesson);
    if (read == nullptr) continue;
    if (read->key == key) return lesson;
    keys += (keys.empty() ? "" : ", ") + read->key;
  }
  return "there is no lesson \"" + key + "\"; give " +
         (keys.empty() ? std::string("a file that ends in .json.")
                       : keys + ", or a file that ends in .json.");
}

std::vector<LessonEntry> list_lessons(const fs::path& assets) {
  std::vector<LessonEntry> entries;
  for (const fs::path& file : lesson_files(assets)) {
    auto lesson = load_lesson(file);
    if (auto* read = std::get_if<Lesson>(&lesson)) {
      entries.push_back({std::move(read->key), std::move(read->title), std::move(read->about)});
    } else {
      entries.push_back({"", file.stem().string(), std::get<std::string>(lesson)});
    }
  }
  return entries;
}

}  // namespace app
