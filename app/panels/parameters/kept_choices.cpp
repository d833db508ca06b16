#include "app/panels/parameters/kept_choices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/base/text.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr std::array kept_settings{knit::KeptBeside::none, knit::KeptBeside::one, knit::KeptBeside::two};

void forget_choice(knit::Parameters& parameters) {
  parameters.short_rows.rows = knit::ShortRows::automatic;
  parameters.short_rows.kept = knit::KeptBeside::by_itself;
}

// Equal for runs that differ in nothing but the choice.
RunKey key_without_choice(const knit::Timeline& timeline) {
  RunKey key = run_key(timeline);
  forget_choice(key.base);
  for (knit::Edit& edit : key.edits) forget_choice(edit.parameters);
  return key;
}

// What is in force; none: a choice that is still to be made.
std::optional<std::int32_t> taken(const knit::Timeline& timeline) {
  const knit::ShortRowSettings& settings = timeline.parameters().short_rows;
  if (settings.rows == knit::ShortRows::off) return knit::no_short_rows;
  const auto kept = std::find(kept_settings.begin(), kept_settings.end(), settings.kept);
  if (kept != kept_settings.end()) return static_cast<std::int32_t>(kept - kept_settings.begin());
  return timeline.furthest().short_rows.kept;
}

void take(std::int32_t kept, knit::Parameters& parameters) {
  parameters.short_rows.rows =
      kept == knit::no_short_rows ? knit::ShortRows::off : knit::ShortRows::automatic;
  if (kept != knit::no_short_rows)
    parameters.short_rows.kept = kept_settings.at(static_cast<std::size_t>(kept));
}

// A piece of one tube has no events: there is with or without.
std::string name_of(std::int32_t kept, bool events) {
  if (kept == knit::no_short_rows) return "none";
  return events ? std::to_string(kept) + " kept" : "pairs";
}

std::string help_of(const knit::KeptTry& way, bool events) {
  if (!std::isfinite(way.sum)) return "The run stops this way.";
  std::string words = way.kept == knit::no_short_rows ? "No short rows"
                      : events ? "Short rows, and " + knit::plural(way.kept, "row", "rows") +
                                     " of each tube kept where loops part or meet"
                               : "Short rows";
  words += ": " + knit::stitch_count_text(way.stitches) + ". Click: knit it so.";
  return words;
}

void draw_way(PanelFrame& frame, const knit::KeptTry& way, bool events, bool in_force,
              knit::Parameters& parameters) {
  const bool finite = std::isfinite(way.sum);
  const std::string name = "kept/" + std::string(way.kept < 0 ? "none" : std::to_string(way.kept));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (ImGui::Selectable((name_of(way.kept, events) + "##" + name).c_str(), in_force,
                        ImGuiSelectableFlags_SpanAllColumns) &&
      !in_force)
    take(way.kept, parameters);
  frame.mark(name);
  tooltip(frame, help_of(way, events));
  const std::array cells{std::to_string(way.pairs),
                         finite ? fixed_text(1000.0 * static_cast<double>(way.sum), 1) : "-",
                         finite ? fixed_text(static_cast<double>(way.wale_cv), 3) : "-",
                         finite ? fixed_text(static_cast<double>(way.longest_wale), 2) : "-"};
  for (const std::string& cell : cells) {
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(cell.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
    ImGui::TextUnformatted(cell.c_str());
  }
}

void draw_heads(PanelFrame& frame) {
  constexpr std::array<std::array<const char*, 2>, 5> heads{
      {{"Way", "None, or how many rows each tube keeps as they are where loops part or meet."},
       {"Pairs", "Pairs of short rows that are worked."},
       {"Left",
        "What is left of wrong lengths when all has settled, in thousandths a stitch: the least is taken, of "
        "ways whose wales are as even as without short rows and none longer."},
       {"Wale CV", "How uneven the wales are then: standard deviation / mean."},
       {"Longest", "The longest wale then, in stitch heights."}}};
  ImGui::TableNextRow();
  for (std::size_t i = 0; i < heads.size(); ++i) {
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(heads[i][0]).x;
    if (i > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
    faint_text(heads[i][0]);
    tooltip(frame, heads[i][1]);
  }
}

}  // namespace

void KeptChoices::refresh(const knit::Timeline& timeline) {
  const auto& found = timeline.furthest().short_rows.tries;
  const bool chosen = timeline.furthest().short_rows.kept.has_value();
  RunKey now = key_without_choice(timeline);
  if (!found.empty() && chosen) {
    key_ = std::move(now);
    tries_ = found;
  } else if (!(key_ == now)) {
    tries_.clear();
  }
}

bool is_short_rows_knob(const knit::ParameterInfo& info) {
  const auto* choice = std::get_if<knit::Choice>(&info.kind);
  if (choice == nullptr) return false;
  knit::Parameters off, on;
  off.short_rows.rows = knit::ShortRows::off;
  on.short_rows.rows = knit::ShortRows::automatic;
  return choice->get(off) != choice->get(on);
}

void draw_kept_choices(PanelFrame& frame, knit::Parameters& parameters) {
  const knit::Timeline& timeline = *frame.timeline();
  KeptChoices& choices = frame.own<KeptChoices>();
  choices.refresh(timeline);
  const auto kept = taken(timeline);
  const bool on = parameters.short_rows.rows == knit::ShortRows::automatic;
  if (choices.tries().empty()) {
    const bool by_itself = on && parameters.short_rows.kept == knit::KeptBeside::by_itself;
    if (!by_itself) return;
    wrapped_text(kept ? "No pair would gain more than its turns cost: no short rows."
                      : "What each way would come to is shown once all of them have settled.",
                 theme().faint_text);
    frame.mark("kept/untold");
    return;
  }
  const bool events = choices.tries().size() > 2;
  push_font(frame.fonts.small);
  if (ImGui::BeginTable(
          "ways of short rows", 5,
          ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter | ImGuiTableFlags_SizingStretchSame)) {
    draw_heads(frame);
    for (const knit::KeptTry& way : choices.tries())
      draw_way(frame, way, events, kept && *kept == way.kept, parameters);
    ImGui::EndTable();
  }
  pop_font();
}

}  // namespace app
