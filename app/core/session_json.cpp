#include "app/core/session_json.h"

#include <cstdio>

#include "app/core/step_json.h"
#include "knit/hash.h"

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
  for (const knit::MendKind kind : saved.source.mends) json["mends"].push_back(knit::key_of(kind));
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

Json pattern_json(const knit::PatternOptions& pattern) {
  Json json = {{"title", pattern.title},
               {"yarn", pattern.yarn},
               {"colour", pattern.colour},
               {"markers", pattern.markers},
               {"stars", pattern.stars}};
  if (pattern.needle_mm) json["needle-mm"] = *pattern.needle_mm;
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
  const knit::Timeline& timeline = *session.timeline;
  SavedSession saved;
  saved.source = session.source;
  saved.knobs = knobs_of(timeline);
  // While a run is on its way to a place, that is where the session is.
  if (timeline.sought()) {
    saved.at = timeline.sought();
  } else if (timeline.position() > 0) {
    saved.at = timeline.place();
  }
  saved.camera = session.camera;
  saved.layers = session.layers;
  saved.side = session.side;
  saved.list = session.list;
  saved.centre = session.centre;
  saved.steps_per_second = session.playback.steps_per_second;
  saved.slow_motion = session.travel.slow_motion;
  saved.loop = session.travel.loop;
  saved.breaks = session.travel.breaks;
  // A run of another mesh cannot be had again from this one.
  const bool same_mesh = session.pinned && session.pinned->input->mesh.name == timeline.input().mesh.name;
  if (same_mesh) saved.pinned = session.pinned->knobs;
  saved.knitting_along = session.knit_along.has_value();
  saved.round = session.knit_along.value_or(session.knit_along_round);
  saved.pattern = session.pattern;
  return saved;
}

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
  json["pattern"] = pattern_json(saved.pattern);
  return json;
}

}  // namespace app
