#include "app/session/presets.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr std::array thesis_settings{
    PresetSetting{"timing", "linear"},    PresetSetting{"sizes", "mesh"},
    PresetSetting{"rows", "rings"},       PresetSetting{"start-direction", "auto"},
    PresetSetting{"cast-on", "6"},        PresetSetting{"metric", "euclidean"},
    PresetSetting{"last-anchor", "keep"}, PresetSetting{"close", "thesis"},
    PresetSetting{"placement", "thesis"}, PresetSetting{"settle", "off"},
    PresetSetting{"short-rows", "off"},
};
constexpr std::array best_settings{
    PresetSetting{"timing", "arc-length"},  PresetSetting{"sizes", "mesh"},
    PresetSetting{"stitch-height", "auto"}, PresetSetting{"rows", "contours"},
    PresetSetting{"cast-on", "auto"},       PresetSetting{"counts", "whole"},
    PresetSetting{"short-rows", "auto"},    PresetSetting{"placement", "nearest"},
    PresetSetting{"stacking-penalty", "0"}, PresetSetting{"follow-mains", "off"},
    PresetSetting{"settle", "auto"},
};
constexpr std::array gauge_settings{
    PresetSetting{"timing", "arc-length"}, PresetSetting{"sizes", "gauge"},
    PresetSetting{"gauge", "22,32"},       PresetSetting{"height-cm", "12"},
    PresetSetting{"rows", "contours"},     PresetSetting{"cast-on", "auto"},
    PresetSetting{"counts", "whole"},      PresetSetting{"short-rows", "off"},
    PresetSetting{"placement", "nearest"}, PresetSetting{"stacking-penalty", "0"},
    PresetSetting{"follow-mains", "off"},  PresetSetting{"settle", "auto"},
};
constexpr std::array hand_settings{
    PresetSetting{"timing", "arc-length"},   PresetSetting{"sizes", "gauge"},
    PresetSetting{"gauge", "22,32"},         PresetSetting{"height-cm", "12"},
    PresetSetting{"rows", "contours"},       PresetSetting{"cast-on", "auto"},
    PresetSetting{"counts", "rhythm"},       PresetSetting{"rhythm-tolerance", "3.5"},
    PresetSetting{"rhythm-changes", "auto"}, PresetSetting{"rhythm-style", "pairs"},
    PresetSetting{"short-rows", "auto"},     PresetSetting{"placement", "nearest"},
    PresetSetting{"stacking-penalty", "0"},  PresetSetting{"follow-mains", "off"},
    PresetSetting{"settle", "auto"},
};

constexpr std::array table{
    Preset{
        "thesis", "As in the thesis",
        "Rows from the mesh's rings by straight distances, the closing gap shifted, shaping by rules R0-R4.",
        thesis_settings},
    Preset{"best-rows", "Best rows",
           "Contours equally high on the surface, short rows where a tube bends, stitches at equal arcs, "
           "each hung "
           "on the nearest below; then all settle until they are at ease.",
           best_settings},
    Preset{"knitters-gauge", "Knitter's gauge",
           "As best rows without short rows, sized by a gauge of 22 stitches and 32 rounds in 10 cm and a "
           "height of 12 cm.",
           gauge_settings},
    Preset{"hand", "For taking home",
           "As knitter's gauge, with short rows where a tube bends and counts in a rhythm: few and regular "
           "repeats, "
           "shaped in pairs beside mains.",
           hand_settings},
};

}  // namespace

std::span<const Preset> presets() { return table; }

const Preset* find_preset(std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Preset& p) { return p.key == key; });
  return found == table.end() ? nullptr : &*found;
}

std::string preset_keys() {
  std::string keys;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (i > 0) keys += i + 1 == table.size() ? " or " : ", ";
    keys += table[i].key;
  }
  return keys;
}

namespace {

bool chooses_all(const Preset& preset, const knit::Parameters& parameters) {
  return std::all_of(preset.settings.begin(), preset.settings.end(), [&](const PresetSetting& setting) {
    const knit::ParameterInfo* info = knit::find_parameter(setting.key);
    return info == nullptr || !std::holds_alternative<knit::Choice>(info->kind) ||
           knit::value_text(*info, parameters) == setting.value;
  });
}

}  // namespace

const Preset* chosen_preset(const knit::Parameters& now, const knit::Parameters& at_opening) {
  for (const Preset& preset : table)
    if (chooses_all(preset, now) && !chooses_all(preset, at_opening)) return &preset;
  return nullptr;
}

knit::Parameters carried_over(const Preset& preset, const knit::Parameters& now, knit::Parameters onto) {
  std::vector<knit::Setting> settings;
  for (const PresetSetting& setting : preset.settings) {
    if (const knit::ParameterInfo* info = knit::find_parameter(setting.key))
      settings.emplace_back(info, knit::value_text(*info, now));
  }
  knit::set_values(settings, onto);
  return onto;
}

knit::Parameters with_preset(const Preset& preset, knit::Parameters parameters) {
  std::vector<knit::Setting> settings;
  for (const PresetSetting& setting : preset.settings) {
    if (const knit::ParameterInfo* info = knit::find_parameter(setting.key))
      settings.emplace_back(info, setting.value);
  }
  knit::set_values(settings, parameters);
  return parameters;
}

}  // namespace app
