#include "app/files/session_json.h"

#include <cstdio>
#include <limits>

#include "app/base/json_fields.h"
#include "app/curves/curves_file.h"
#include "app/files/report.h"
#include "app/scene/colour_text.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/hash.h"
#include "knit/model/settings_table.h"
#include "knit/pattern/limb_words.h"
#include "knit/yarn/eased_yarn.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

Json place_json(const knit::Place& place) {
  return {{"stage", knit::name_of(place.stage)}, {"row", place.row}, {"item", place.item}};
}

void add_knobs(Json& json, const Knobs& knobs) {
  json["parameters"] = to_json(knobs.base);
  json["edits"] = Json::array();
  for (const knit::Edit& edit : knobs.edits)
    json["edits"].push_back({{"at", place_json(edit.at)}, {"parameters", to_json(edit.parameters)}});
}

Json source_json(const SavedSession& saved) {
  Json json = Json::object();
  if (saved.source.file.empty()) {
    json["example"] = saved.source.example;
  } else {
    json["file"] = saved.source.file.generic_string();
  }
  for (const knit::RepairKind kind : saved.source.repairs) json["mends"].push_back(knit::key_of(kind));
  if (!saved.source.curves.empty()) json["curves"] = curves_json(saved.source.curves);
  if (!saved.mesh_hash.empty()) json["hash"] = saved.mesh_hash;
  return json;
}

Json camera_json(const Camera& camera) {
  return {{"target", {camera.target.x, camera.target.y, camera.target.z}},
          {"distance", camera.distance},
          {"yaw", camera.yaw},
          {"pitch", camera.pitch},
          {"field-of-view", camera.field_of_view}};
}

Json pattern_json(const knit::PatternOptions& pattern, const PatternPieces& pieces) {
  Json json = {{"title", pattern.title},
               {"yarn", pattern.yarn},
               {"colour", pattern.colour},
               {"markers", pattern.markers},
               {"stars", pattern.stars}};
  if (pattern.form != knit::PatternForm::by_itself)
    json["form"] = pattern.form == knit::PatternForm::short_form ? "short" : "full";
  if (pattern.turns != knit::ShortRowTurns::usual)
    json["turns"] = pattern.turns == knit::ShortRowTurns::wrap ? "wrap" : "german";
  if (pattern.needle_mm) json["needle-mm"] = *pattern.needle_mm;
  if (!pieces.names.empty()) json["piece-names"] = pieces.names;
  if (!pieces.order.empty()) json["piece-order"] = pieces.order;
  return json;
}

}  // namespace

std::string hash_text(const knit::Mesh& mesh) {
  knit::Hasher hasher;
  knit::hash_into(hasher, mesh.positions);
  knit::hash_into(hasher, mesh.triangles);
  std::array<char, 24> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%016llx", static_cast<unsigned long long>(hasher.value()));
  return buffer.data();
}

SavedSession saved_of(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  SavedSession saved;
  saved.source = session.document->source;
  saved.knobs = knobs_of(timeline);
  // While a run is on its way to a place, that is where the session is.
  if (timeline.sought()) {
    saved.at = timeline.sought();
  } else if (timeline.position() > 0) {
    saved.at = timeline.place();
  }
  saved.camera = session.view->gaze.camera;
  saved.layers = session.view->layers;
  saved.side = session.view->side;
  saved.list = session.view->list;
  saved.centre = session.view->centre;
  saved.chart_piece = session.view->gaze.chart_piece;
  saved.positions = session.view->positions;
  saved.yarn = session.view->yarn;
  saved.steps_per_second = session.view->playback.steps_per_second;
  saved.slow_motion = session.view->slow_motion;
  saved.loop = session.document->travel.loop;
  saved.breaks = session.view->breaks;
  // A run of another mesh cannot be had again from this one.
  const bool same_mesh =
      session.document->pinned && session.document->pinned->input->mesh.name == timeline.input().mesh.name;
  if (same_mesh) saved.pinned = session.document->pinned->knobs;
  saved.knitting_along = session.view->gaze.knit_along.has_value();
  saved.round = session.view->gaze.knit_along.value_or(session.view->gaze.knit_along_round);
  saved.deal = session.view->gaze.knit_along_deal;
  saved.pattern = session.view->pattern;
  saved.pieces = session.document->pieces;
  return saved;
}

namespace {

Json yarn_json(const YarnLook& look) {
  return {{"colours", yarn_colours_keys.at(static_cast<std::size_t>(look.by))},
          {"wool", hex_text(look.wool)},
          {"second", hex_text(look.second)},
          {"stripe-rounds", look.stripe_rounds},
          {"radius", look.radius},
          {"easing", look.easing}};
}

}  // namespace

Json to_json(const SavedSession& saved) {
  Json json;
  json[std::string(session_mark)] = session_version;
  json["source"] = source_json(saved);
  add_knobs(json, saved.knobs);
  json["at"] = saved.at ? place_json(*saved.at) : Json("start");
  json["camera"] = camera_json(saved.camera);
  json["layers"] = Json::object();
  for (std::size_t i = 0; i < layer_count; ++i)
    json["layers"][std::string(key_of(static_cast<Layer>(i)))] = saved.layers[i];
  json["side"] = side_keys[static_cast<std::size_t>(saved.side)];
  json["list"] = list_keys[static_cast<std::size_t>(saved.list)];
  json["centre"] = centre_keys[static_cast<std::size_t>(saved.centre)];
  if (!saved.chart_piece.empty()) json["chart-piece"] = saved.chart_piece;
  json["positions"] = positions_keys.at(static_cast<std::size_t>(saved.positions));
  json["yarn"] = yarn_json(saved.yarn);
  json["playback"] = {{"steps-per-second", saved.steps_per_second}, {"slow-motion", saved.slow_motion}};
  if (saved.loop) json["playback"]["loop"] = {{"begin", saved.loop->begin}, {"end", saved.loop->end}};
  json["breaks"] = Json::array();
  for (const knit::BreakCondition& condition : saved.breaks)
    json["breaks"].push_back(knit::text_of(condition));
  if (saved.pinned) {
    json["pinned"] = Json::object();
    add_knobs(json["pinned"], *saved.pinned);
  }
  json["knit-along"] = {{"on", saved.knitting_along}, {"round", saved.round}};
  if (saved.deal > 0) json["knit-along"]["deal"] = saved.deal;
  json["pattern"] = pattern_json(saved.pattern, saved.pieces);
  return json;
}

// Reading what session_json.cpp writes. Fields that are not known are left alone: a later program may have more.

namespace {

constexpr std::int64_t most_rows = std::numeric_limits<std::int32_t>::max() - 1;
constexpr double farthest = 1e12;
constexpr std::size_t most_edits = 10000;

knit::Place read_place(JsonFields fields) {
  knit::Place place;
  const std::string name = fields.text("stage");
  if (const auto stage = knit::stage_named(name)) {
    place.stage = *stage;
  } else if (name == knit::name_of(knit::Stage::done)) {
    place.stage = knit::Stage::done;  // a run on its way to its end
  } else {
    fields.set_fault("stage", "must be one of timing, tubes, cast-on, rows, stitches, faces, pattern, done.");
  }
  place.row = static_cast<std::int32_t>(fields.whole("row", 0, most_rows));
  place.item = static_cast<std::int32_t>(fields.whole("item", 0, most_rows));
  return place;
}

// Parameters that are not there keep their value in a new program.
knit::Parameters read_parameters(JsonFields fields) {
  knit::Parameters parameters;
  std::vector<knit::Setting> settings;
  if (!fields.json().is_object()) return parameters;
  for (const auto& [key, value] : fields.json().items()) {
    const knit::ParameterInfo* info = knit::find_parameter(key);
    if (info == nullptr) {
      fields.set_fault(key, "is no parameter; remove it, or see knit-mesh --list-parameters.");
      continue;
    }
    const bool is_value = value.is_string() || value.is_number();
    const std::string text = value.is_string() ? value.get<std::string>() : is_value ? value.dump() : "";
    knit::Parameters scratch;
    if (!is_value || knit::set_value(*info, scratch, text)) {
      fields.set_fault(key, "must be " + knit::range_text(*info) + ".");
    } else {
      settings.emplace_back(info, text);
    }
  }
  knit::set_values(settings, parameters);
  return parameters;
}

Knobs read_knobs(JsonFields fields) {
  Knobs knobs;
  knobs.base = read_parameters(fields.object("parameters"));
  const std::size_t count = fields.array("edits").size();
  if (count > most_edits) fields.set_fault("edits", "are more than 10000; remove some.");
  for (std::size_t i = 0; i < count && fields.fault().empty(); ++i) {
    JsonFields edit = fields.entry("edits", i);
    const knit::Place at = read_place(edit.object("at"));
    knobs.edits.push_back({at, read_parameters(edit.object("parameters"))});
    if (i > 0 && !(knobs.edits[i - 1].at < at))
      edit.set_fault("at", "does not come after the edit before it; bring the edits into their order.");
  }
  return knobs;
}

void read_repairs(JsonFields& fields, std::vector<knit::RepairKind>& repairs) {
  for (const nlohmann::json& key : fields.array("mends")) {
    const auto kind = key.is_string() ? knit::repair_named(key.get<std::string>()) : std::nullopt;
    if (!kind)
      return fields.set_fault("mends", "has one that is not known; see --repair in knit-mesh --help.");
    repairs.push_back(*kind);
  }
}

void read_source(JsonFields fields, SavedSession& saved) {
  if (fields.has("file")) {
    saved.source.file = fields.text("file");
    if (saved.source.file.empty()) fields.set_fault("file", "is empty; name the mesh's file.");
  } else if (fields.has("example")) {
    saved.source.example = fields.text("example");
  } else {
    fields.set_fault("file", "is missing; name the mesh's \"file\", or an \"example\".");
  }
  if (fields.has("mends")) read_repairs(fields, saved.source.repairs);
  if (fields.has("curves")) saved.source.curves = read_curve_list(fields, "curves");
  if (fields.has("hash")) saved.mesh_hash = fields.text("hash");
}

Camera read_camera(JsonFields fields) {
  Camera camera;
  const nlohmann::json& target = fields.array("target");
  for (std::size_t i = 0; i < 3; ++i) {
    if (target.size() == 3 && target[i].is_number()) {
      camera.target[static_cast<int>(i)] = target[i].get<double>();
    } else {
      fields.set_fault("target", "must be three numbers, [x, y, z].");
    }
  }
  camera.distance = fields.number("distance", 1e-12, farthest);
  camera.yaw = fields.number("yaw", -1e6, 1e6);
  camera.pitch = fields.number("pitch", -1.57, 1.57);
  camera.field_of_view = fields.number("field-of-view", 0.01, 3.0);
  return camera;
}

void read_playback(JsonFields fields, SavedSession& saved) {
  saved.steps_per_second =
      fields.number("steps-per-second", slowest_steps_per_second, fastest_steps_per_second);
  saved.slow_motion = fields.flag("slow-motion");
  if (!fields.has("loop")) return;
  JsonFields loop = fields.object("loop");
  constexpr std::int64_t most_steps = std::int64_t{1} << 40;
  saved.loop = Stretch{static_cast<std::size_t>(loop.whole("begin", 0, most_steps)),
                       static_cast<std::size_t>(loop.whole("end", 0, most_steps))};
  if (saved.loop->begin >= saved.loop->end) loop.set_fault("end", "must come after the loop's begin.");
}

void read_pattern(JsonFields fields, knit::PatternOptions& pattern) {
  pattern.title = fields.text("title");
  pattern.yarn = fields.text("yarn");
  pattern.colour = fields.text("colour");
  pattern.markers = fields.flag("markers");
  pattern.stars = fields.flag("stars");
  constexpr std::array<std::string_view, 2> forms{"full", "short"};
  if (fields.has("form"))
    pattern.form =
        fields.choice("form", forms) == 1 ? knit::PatternForm::short_form : knit::PatternForm::full;
  constexpr std::array<std::string_view, 2> turns{"german", "wrap"};
  if (fields.has("turns"))
    pattern.turns =
        fields.choice("turns", turns) == 1 ? knit::ShortRowTurns::wrap : knit::ShortRowTurns::german;
  if (fields.has("needle-mm")) pattern.needle_mm = fields.number("needle-mm", 0.5, 50.0);
}

void read_piece_names(JsonFields& pattern, PatternPieces& pieces) {
  if (!pattern.has("piece-names")) return;
  JsonFields names = pattern.object("piece-names");
  for (const auto& [letters, word] : names.json().items()) {
    std::string text = names.text(letters);
    if (knit::is_piece_word(text))
      pieces.names[letters] = std::move(text);
    else
      names.set_fault(letters, "must be one capitalised word.");
  }
}

void read_pieces(JsonFields pattern, PatternPieces& pieces) {
  read_piece_names(pattern, pieces);
  if (!pattern.has("piece-order")) return;
  for (const nlohmann::json& letters : pattern.array("piece-order")) {
    if (!letters.is_string())
      return pattern.set_fault("piece-order", "must be pieces' letters, each in quotes.");
    pieces.order.push_back(letters.get<std::string>());
  }
  if (fault_of_order(pieces.order))
    pattern.set_fault("piece-order", "must be pieces' letters, each once: [\"B\", \"A\"].");
}

void read_breaks(JsonFields& fields, SavedSession& saved) {
  const nlohmann::json& list = fields.array("breaks");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string name = "breaks[" + std::to_string(i) + "]";
    if (!list[i].is_string()) {
      fields.set_fault(name, "must be text in quotes.");
      return;
    }
    auto condition = knit::parse_break(list[i].get<std::string>());
    if (const auto* fault = std::get_if<std::string>(&condition))
      return fields.set_fault(name, "is wrong: " + *fault);
    saved.breaks.push_back(std::get<knit::BreakCondition>(std::move(condition)));
  }
}

Colour read_colour(JsonFields& fields, const std::string& key) {
  const auto colour = colour_of_hex(fields.text(key));
  if (!colour) fields.set_fault(key, "must be a colour like #d8b48c.");
  return colour.value_or(Colour{});
}

YarnLook read_yarn(JsonFields fields) {
  YarnLook look;
  look.by = static_cast<YarnColours>(fields.choice("colours", yarn_colours_keys));
  look.wool = read_colour(fields, "wool");
  look.second = read_colour(fields, "second");
  look.stripe_rounds = static_cast<int>(fields.whole("stripe-rounds", 0, most_stripe_rounds));
  if (fields.has("radius")) look.radius = fields.number("radius", 0.0, most_yarn_radius);
  if (fields.has("easing")) look.easing = static_cast<int>(fields.whole("easing", 0, knit::most_yarn_easing));
  return look;
}

void read_view(JsonFields& fields, SavedSession& saved) {
  saved.camera = read_camera(fields.object("camera"));
  JsonFields layers = fields.object("layers");
  saved.layers = View{}.layers;
  for (std::size_t i = 0; i < layer_count; ++i) {
    const std::string key(key_of(static_cast<Layer>(i)));
    if (layers.has(key)) saved.layers[i] = layers.flag(key);
  }
  saved.side = static_cast<SidePanel>(fields.choice("side", side_keys));
  saved.list = static_cast<RunList>(fields.choice("list", list_keys));
  saved.centre = static_cast<CentrePanel>(fields.choice("centre", centre_keys));
  if (fields.has("chart-piece")) {
    saved.chart_piece = fields.text("chart-piece");
    if (!is_piece_letter(saved.chart_piece)) fields.set_fault("chart-piece", "must be a piece's letter.");
  }
  if (fields.has("positions"))
    saved.positions = static_cast<Positions>(fields.choice("positions", positions_keys));
  if (fields.has("yarn")) saved.yarn = read_yarn(fields.object("yarn"));
}

std::string fault_of_version(const nlohmann::json& json) {
  const std::string mark(session_mark);
  if (!json.is_object() || !json.contains(mark))
    return "it is no session of knit-mesh: \"" + mark +
           "\" is missing; give a file that --save-session wrote.";
  const nlohmann::json& version = json[mark];
  if (version.is_number_integer() && version == session_version) return "";
  return "it is of version " + (version.is_number() ? version.dump() : std::string("unknown")) +
         ", and this program reads version " + std::to_string(session_version) +
         "; open it with the knit-mesh that wrote it.";
}

}  // namespace

std::variant<SavedSession, std::string> read_saved(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::string("it is no JSON; give a file that --save-session wrote.");
  if (auto fault = fault_of_version(json); !fault.empty()) return fault;
  JsonFields fields(json);
  SavedSession saved;
  read_source(fields.object("source"), saved);
  saved.knobs = read_knobs(fields);
  const bool at_start = fields.has("at") && json["at"] == "start";
  if (!at_start) saved.at = read_place(fields.object("at"));
  read_view(fields, saved);
  read_playback(fields.object("playback"), saved);
  read_breaks(fields, saved);
  if (fields.has("pinned")) saved.pinned = read_knobs(fields.object("pinned"));
  JsonFields along = fields.object("knit-along");
  saved.knitting_along = along.flag("on");
  saved.round = static_cast<std::int32_t>(along.whole("round", 1, most_rows));
  constexpr std::int64_t most_deals = 1000;
  if (along.has("deal")) saved.deal = static_cast<std::int16_t>(along.whole("deal", 0, most_deals));
  read_pattern(fields.object("pattern"), saved.pattern);
  read_pieces(fields.object("pattern"), saved.pieces);
  if (!fields.fault().empty()) return fields.fault();
  return saved;
}

}  // namespace app
