// Settings for a purpose, by name: for the menu, the command line (--preset) and scripts.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "knit/model/settings_table.h"

namespace app {

struct PresetSetting {
  std::string_view key, value;  // as the command line takes them
};

struct Preset {
  std::string_view key;    // "best-rows"
  std::string_view title;  // "Best rows"
  std::string_view about;  // one sentence
  std::span<const PresetSetting> settings;
};

std::span<const Preset> presets();
const Preset* find_preset(std::string_view key);
std::string preset_keys();  // "thesis, best-rows, knitters-gauge or hand"

// The parameters with the preset's settings; what it does not name stays.
knit::Parameters with_preset(const Preset& preset, knit::Parameters parameters);

// The preset that was chosen for a mesh: all that it chooses is in force, and was not so when the mesh was opened. A number
// of it may have been changed since: a gauge is still a gauge. Null: none.
const Preset* chosen_preset(const knit::Parameters& now, const knit::Parameters& at_opening);
// What it names, as it is in force now, for another mesh.
knit::Parameters carried_over(const Preset& preset, const knit::Parameters& now, knit::Parameters onto);

}  // namespace app
