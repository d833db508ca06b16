// Parts of reading lessons: deeds, what is waited for, settings. lesson_read.cpp puts them together.
#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "app/base/json_fields.h"
#include "app/base/text.h"
#include "app/explain/why_words.h"
#include "app/lessons/lesson.h"
#include "app/lessons/lesson_judge.h"
#include "app/session/presets.h"
#include "app/session/view.h"
#include "knit/insight/breaks.h"
#include "knit/model/settings_table.h"

namespace app {

// What is missing is said in a lesson author's words.
void need(JsonFields& fields, const std::string& key);
std::string need_text(JsonFields& fields, const std::string& key);  // not empty either
std::int64_t need_whole(JsonFields& fields, const std::string& key, std::int64_t low, std::int64_t high);
const nlohmann::json& need_array(JsonFields& fields, const std::string& key);
std::string joined(std::span<const std::string_view> words);  // "a, b, c"

Settings read_settings(JsonFields& fields, const std::string& key);
std::vector<Deed> read_deeds(JsonFields& page);  // its "do"
Wait read_wait(JsonFields fields);

using Json = nlohmann::json;

namespace {

constexpr double most = 1e12;
constexpr std::int64_t most_counted = 1000000000;

// --- deeds: each an object with one field -------------------------------------------------------------------

using Deeds = std::vector<Deed>;

void read_open(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(OpenAsItComes{need_text(fields, "open")});
}

void read_set(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(SetParameters{read_settings(fields, "set")});
}

void read_preset(JsonFields& fields, Deeds& deeds) {
  const std::string key = need_text(fields, "preset");
  if (find_preset(key) == nullptr) fields.set_fault("preset", "must be " + preset_keys() + ".");
  deeds.emplace_back(Action(ApplyPreset{key}));
}

void read_seek(JsonFields& fields, Deeds& deeds) {
  const std::string text = need_text(fields, "seek");
  const auto at = text == "start" ? std::optional<At>(At(std::size_t{0})) : parse_at(text);
  const bool known = at && !std::holds_alternative<AtStage>(*at);
  if (!known)
    return fields.set_fault("seek", "must be start, end, a number of steps or STAGE:ROW[:ITEM], in quotes.");
  deeds.emplace_back(SeekAt{*at});
}

void read_look(JsonFields& fields, Deeds& deeds) {
  JsonFields look = fields.object("look");
  LookFrom from;
  if (look.has("yaw")) from.yaw = look.number("yaw", -720.0, 720.0);
  if (look.has("pitch")) from.pitch = look.number("pitch", -89.0, 89.0);
  if (look.has("near")) from.near = look.number("near", 0.1, 100.0);
  if (look.has("at"))
    from.at = static_cast<knit::VertexId>(look.whole("at", 0, std::int64_t{knit::no_vertex} - 1));
  deeds.emplace_back(from);
}

void read_layers(JsonFields& fields, Deeds& deeds) {
  JsonFields layers = fields.object("layer");
  if (!layers.json().is_object()) return;
  std::string known;
  for (std::size_t i = 0; i < layer_count; ++i) {
    const std::string key(key_of(static_cast<Layer>(i)));
    known += (known.empty() ? "" : ", ") + key;
    if (layers.has(key)) deeds.emplace_back(Action(SetLayer{static_cast<Layer>(i), layers.flag(key)}));
  }
  for (const auto& [key, value] : layers.json().items()) {
    const bool is_layer = std::any_of(deeds.begin(), deeds.end(), [name = key](const Deed& deed) {
      const auto* action = std::get_if<Action>(&deed);
      const auto* layer = action != nullptr ? action->get_if<SetLayer>() : nullptr;
      return layer != nullptr && key_of(layer->layer) == name;
    });
    if (!is_layer) layers.set_fault(key, "is no layer; give " + known + ".");
  }
}

void read_side(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(Action(ShowSide{static_cast<SidePanel>(fields.choice("side", side_keys))}));
}
void read_list(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(Action(ShowList{static_cast<RunList>(fields.choice("list", list_keys))}));
}
void read_centre(JsonFields& fields, Deeds& deeds) {
  constexpr std::array<std::string_view, 2> centres{"view", "chart"};
  deeds.emplace_back(Action(ShowCentre{static_cast<CentrePanel>(fields.choice("centre", centres))}));
}

void read_show_as(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(Action(ShowAs{static_cast<Looking>(fields.choice("show-as", looking_keys))}));
}

// Steps a second; 0: pause.
void read_play(JsonFields& fields, Deeds& deeds) {
  const double speed = fields.number("play", 0.0, fastest_steps_per_second);
  if (speed > 0.0) deeds.emplace_back(Action(SetSpeed{speed}));
  deeds.emplace_back(Action(SetPlaying{speed > 0.0}));
}
void read_speed(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(
      Action(SetSpeed{fields.number("speed", slowest_steps_per_second, fastest_steps_per_second)}));
}

void read_select(JsonFields& fields, Deeds& deeds) {
  const auto thing = thing_named(need_text(fields, "select"));
  if (!thing) return fields.set_fault("select", "must be stitch:ROW:ITEM, face:ROW:ITEM or vertex:ID.");
  deeds.emplace_back(Action(Select{thing}));
}

void read_predict(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(Action(SetPredicting{fields.flag("predict")}));
}
void read_slow(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(Action(SetSlowMotion{fields.flag("slow-motion")}));
}
void read_pin(JsonFields& fields, Deeds& deeds) {
  deeds.emplace_back(fields.flag("pin") ? Action(PinRun{}) : Action(Unpin{}));
}

void read_breaks(JsonFields& fields, Deeds& deeds) {
  auto condition = knit::parse_break(need_text(fields, "break"));
  if (const auto* fault = std::get_if<std::string>(&condition))
    return fields.set_fault("break", "is wrong: " + *fault);
  deeds.emplace_back(Action(SetBreaks{{std::get<knit::BreakCondition>(condition)}}));
}

struct DeedReader {
  std::string_view key;
  void (*read)(JsonFields&, Deeds&);
};
constexpr std::array deed_readers{DeedReader{"open", read_open},       DeedReader{"set", read_set},
                                  DeedReader{"preset", read_preset},   DeedReader{"seek", read_seek},
                                  DeedReader{"look", read_look},       DeedReader{"layer", read_layers},
                                  DeedReader{"side", read_side},       DeedReader{"list", read_list},
                                  DeedReader{"centre", read_centre},   DeedReader{"play", read_play},
                                  DeedReader{"speed", read_speed},     DeedReader{"select", read_select},
                                  DeedReader{"predict", read_predict}, DeedReader{"slow-motion", read_slow},
                                  DeedReader{"show-as", read_show_as}, DeedReader{"pin", read_pin},
                                  DeedReader{"break", read_breaks}};

// --- waits: an "ask" and one field -------------------------------------------------------------------------

const knit::ParameterInfo* need_parameter(JsonFields& fields, const std::string& key) {
  const knit::ParameterInfo* info = knit::find_parameter(need_text(fields, key));
  if (info == nullptr) fields.set_fault(key, "is no parameter; see knit-mesh --list-parameters.");
  return info;
}

void read_counted(JsonFields& fields, const std::string& key, Wait& wait) {
  wait.count = fields.whole(key, key == "problems" ? 0 : 1, most_counted);
}

void read_range(JsonFields& fields, const std::string& /*key*/, Wait& wait) {
  wait.parameter = need_parameter(fields, "parameter");
  if (fields.has("is")) {
    wait.kind = WaitKind::value;
    wait.word = fields.text("is");
    knit::Parameters scratch;
    if (wait.parameter != nullptr && knit::set_value(*wait.parameter, scratch, wait.word))
      fields.set_fault("is", "must be " + knit::range_text(*wait.parameter) + ".");
    return;
  }
  wait.low = fields.has("from") ? fields.number("from", -most, most) : -most;
  wait.high = fields.has("to") ? fields.number("to", -most, most) : most;
  const bool is_number =
      wait.parameter == nullptr || std::holds_alternative<knit::Number>(wait.parameter->kind);
  if (!is_number) fields.set_fault("parameter", "is no number; wait for a value by \"is\".");
}

void read_changed(JsonFields& fields, const std::string& key, Wait& wait) {
  wait.parameter = need_parameter(fields, key);
}

void read_reach(JsonFields& fields, const std::string& key, Wait& wait) {
  const auto at = parse_at(need_text(fields, key));
  const auto* place = at ? std::get_if<knit::Place>(&*at) : nullptr;
  const auto* stage = at ? std::get_if<AtStage>(&*at) : nullptr;
  if (place != nullptr) wait.place = *place;
  if (stage != nullptr) wait.place = {stage->stage, 0, 0};
  if (place == nullptr && stage == nullptr) fields.set_fault(key, "must be STAGE[:ROW[:ITEM]], in quotes.");
}

void read_did(JsonFields& fields, const std::string& key, Wait& wait) {
  wait.word = need_text(fields, key);
  if (!is_deed_name(wait.word)) fields.set_fault(key, "must be one of " + deed_names() + ".");
}

void read_flag(JsonFields& fields, const std::string& key, Wait& wait) { wait.flag = fields.flag(key); }

void read_row_size(JsonFields& fields, const std::string& key, Wait& wait) {
  wait.row = static_cast<std::int32_t>(fields.whole(key, 1, most_counted));
  wait.low = fields.has("from") ? fields.number("from", 0.0, most) : 0.0;
  wait.high = fields.has("to") ? fields.number("to", 0.0, most) : most;
}

struct WaitReader {
  const char* key;
  WaitKind kind;
  void (*read)(JsonFields&, const std::string& key, Wait&);
};
constexpr std::array wait_readers{WaitReader{"steps", WaitKind::steps, read_counted},
                                  WaitReader{"reach", WaitKind::reach, read_reach},
                                  WaitReader{"parameter", WaitKind::range, read_range},
                                  WaitReader{"changed", WaitKind::changed, read_changed},
                                  WaitReader{"did", WaitKind::did, read_did},
                                  WaitReader{"problems", WaitKind::problems, read_counted},
                                  WaitReader{"stopped", WaitKind::stopped, read_flag},
                                  WaitReader{"row-size", WaitKind::row_size, read_row_size},
                                  WaitReader{"guesses", WaitKind::guesses, read_counted},
                                  WaitReader{"at-end", WaitKind::at_end, read_flag}};

}  // namespace

void need(JsonFields& fields, const std::string& key) {
  if (!fields.has(key)) fields.set_fault(key, "is missing; add it.");
}

std::string need_text(JsonFields& fields, const std::string& key) {
  need(fields, key);
  std::string text = fields.text(key);
  if (text.empty()) fields.set_fault(key, "is empty; give its words.");
  return text;
}

std::int64_t need_whole(JsonFields& fields, const std::string& key, std::int64_t low, std::int64_t high) {
  need(fields, key);
  return fields.whole(key, low, high);
}

const Json& need_array(JsonFields& fields, const std::string& key) {
  need(fields, key);
  return fields.array(key);
}

std::string joined(std::span<const std::string_view> words) {
  std::string all;
  for (const std::string_view word : words) all.append(all.empty() ? "" : ", ").append(word);
  return all;
}

Settings read_settings(JsonFields& fields, const std::string& key) {
  need(fields, key);
  JsonFields object = fields.object(key);
  Settings settings;
  if (!object.json().is_object()) return settings;
  for (const auto& [name, value] : object.json().items()) {
    const knit::ParameterInfo* info = knit::find_parameter(name);
    if (info == nullptr) {
      object.set_fault(name, "is no parameter; see knit-mesh --list-parameters.");
      continue;
    }
    const std::string text = value.is_string()   ? value.get<std::string>()
                             : value.is_number() ? value.dump()
                                                 : "";
    knit::Parameters scratch;
    if (text.empty() || knit::set_value(*info, scratch, text))
      object.set_fault(name, "must be " + knit::range_text(*info) + ".");
    settings.emplace_back(info, text);
  }
  return settings;
}

std::vector<Deed> read_deeds(JsonFields& page) {
  Deeds deeds;
  const std::size_t count = page.array("do").size();
  for (std::size_t i = 0; i < count; ++i) {
    JsonFields entry = page.entry("do", i);
    const std::string key =
        entry.json().is_object() && entry.json().size() == 1 ? entry.json().begin().key() : "";
    const auto* reader = std::find_if(deed_readers.begin(), deed_readers.end(),
                                      [&](const DeedReader& one) { return one.key == key; });
    if (reader != deed_readers.end()) {
      reader->read(entry, deeds);
      continue;
    }
    std::string known;
    for (const DeedReader& one : deed_readers) known += (known.empty() ? "" : ", ") + std::string(one.key);
    page.set_fault("do[" + std::to_string(i) + "]", "must be an object with one of " + known + ".");
  }
  return deeds;
}

Wait read_wait(JsonFields fields) {
  Wait wait;
  wait.ask = need_text(fields, "ask");
  std::string known;
  for (const WaitReader& reader : wait_readers) {
    known += (known.empty() ? "" : ", ") + std::string(reader.key);
    if (!fields.has(reader.key)) continue;
    wait.kind = reader.kind;
    reader.read(fields, reader.key, wait);
    return wait;
  }
  fields.set_fault("ask", "stands alone; add what is waited for, one of " + known + ".");
  return wait;
}

// Lessons from files: docs/lessons.md has the fields. What is wrong is one sentence with the page and the field.

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

// "A", "B", ..., "AA", ...
std::string read_tube(JsonFields& fields) {
  std::string tube = need_text(fields, "tube");
  const bool letters =
      tube.size() <= 3 && std::all_of(tube.begin(), tube.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  if (!letters) fields.set_fault("tube", "must be a tube's letter, such as B.");
  return tube;
}

void read_call(JsonFields& fields, const JudgeInfo& info, JudgeCall& call) {
  const bool wants_row = info.needs == JudgeNeeds::row || info.needs == JudgeNeeds::row_and_word;
  if (wants_row) call.row = static_cast<std::int32_t>(need_whole(fields, "row", 1, most_rows));
  if (info.needs == JudgeNeeds::word || info.needs == JudgeNeeds::row_and_word) read_word(fields, info, call);
  if (info.needs == JudgeNeeds::tube) call.word = read_tube(fields);
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

// "10-..." comes after "9-...".
std::size_t number_before(const fs::path& file) {
  const std::string name = file.filename().string();
  return whole_number<std::size_t>(name.substr(0, name.find('-'))).value_or(0);
}

std::vector<fs::path> lesson_files(const fs::path& assets) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(assets / "lessons", error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(number_before(a), a) < std::pair(number_before(b), b);
  });
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
