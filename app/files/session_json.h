// What a session file says, and its words: JSON with a version. docs/sessions.md has the fields.
//
// Nothing is opened here: the mesh is only named.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/session/document.h"
#include "app/session/session.h"
#include "app/session/view.h"

namespace app {

inline constexpr std::int64_t session_version = 1;
inline constexpr std::string_view session_mark = "knit-mesh-session";  // the first field: the version

inline constexpr std::array<std::string_view, 2> centre_keys{"view", "chart"};

struct SavedSession {
  Source source;          // a file as it is written: absolute, or as seen from the session file's folder
  std::string mesh_hash;  // empty: not known
  Knobs knobs;
  std::optional<knit::Place> at;  // none: the start of the run
  Camera camera;
  std::array<bool, layer_count> layers{};
  SidePanel side = SidePanel::step;
  RunList list = RunList::rows;
  CentrePanel centre = CentrePanel::view;
  std::string chart_piece;  // its letters; empty: the chart of the round at hand
  Positions positions = Positions::settled;
  double steps_per_second = 300.0;
  bool slow_motion = false;
  std::optional<Stretch> loop;
  std::vector<knit::BreakCondition> breaks;
  std::optional<Knobs> pinned;
  bool knitting_along = false;
  std::int32_t round = 1;
  std::int16_t deal = 0;
  knit::PatternOptions pattern;
  PatternPieces pieces;
  YarnLook yarn;
};

// Of the mesh as read: what a changed file is noticed by.
std::string hash_text(const knit::Mesh& mesh);

// Requires something open. The source as the session has it; the hash is left empty.
SavedSession saved_of(const Session& session);

nlohmann::ordered_json to_json(const SavedSession& saved);

// The error is one sentence, without the file's name.
std::variant<SavedSession, std::string> read_saved(const std::string& text);

}  // namespace app
