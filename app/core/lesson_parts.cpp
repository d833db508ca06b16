#include "app/core/lesson_parts.h"

#include <array>

#include "app/core/presets.h"
#include "app/core/why_words.h"
#include "knit/breaks.h"

namespace app {

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
                                  DeedReader{"pin", read_pin},         DeedReader{"break", read_breaks}};

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

}  // namespace app
