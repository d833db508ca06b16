#include "app/panels/parameters/knob_notes.h"

#include <string_view>

#include "app/panels/kit/number_field.h"
#include "app/panels/parameters/rhythm_dial.h"
#include "knit/insight/as_asked.h"
#include "knit/model/words.h"

namespace app {

namespace {

// "w" of "Stitch width w"; else the whole label.
std::string short_label(const knit::ParameterInfo& info) {
  constexpr std::size_t longest_symbol = 2;  // bytes
  const std::size_t gap = info.label.rfind(' ');
  const std::string_view last = gap == std::string_view::npos ? info.label : info.label.substr(gap + 1);
  return std::string(last.size() <= longest_symbol ? last : info.label);
}

std::string shown_value(const knit::ParameterInfo& info, const knit::Parameters& parameters) {
  if (const auto* number = std::get_if<knit::Number>(&info.kind)) {
    const std::optional<double> value = knit::effective_value(*number, parameters);
    return value ? shown_number(*value) : knit::value_text(info, parameters);
  }
  if (const auto* gauge = std::get_if<knit::GaugeChoice>(&info.kind)) {
    const knit::Gauge now = gauge->get(parameters);
    return shown_number(now.stitches) + " x " + shown_number(now.rounds);
  }
  return knit::value_text(info, parameters);
}

void draw_follows(PanelFrame& frame, const knit::Parameters& parameters) {
  KnobFollow& follow = frame.own<KnobFollow>();
  if (!follow.before) return;
  const knit::ParameterInfo& info = *knit::find_parameter(follow.key);
  const std::string value = knit::value_text(info, parameters);
  if (value != follow.value_after) {
    if (value != follow.value_before) follow.before.reset();  // set by another door; else it is on its way
    return;
  }
  const std::string words = follow_words(info, *follow.before, parameters);
  if (words.empty()) return;
  push_font(frame.fonts.small);
  wrapped_text(words, theme().accent);
  pop_font();
  frame.mark("knob-follows/" + follow.key);
}

void draw_swatch(PanelFrame& frame, knit::Parameters& parameters) {
  if (!knit::is_read(*knit::find_parameter(knit::keys::gauge), parameters)) return;
  const knit::Gauge gauge = parameters.stitch.gauge;
  const auto usual = knit::rounds_that_go_with(gauge);
  if (!usual) return;
  push_font(frame.fonts.small);
  wrapped_text(knit::short_number(gauge.stitches) + " stitches and " + shown_number(gauge.rounds) +
                   " rounds are hardly one fabric: with " + knit::short_number(gauge.stitches) +
                   " stitches go about " + knit::short_number(*usual) + " rounds.",
               theme().warning);
  pop_font();
  frame.mark("knob-swatch");
  if (ImGui::SmallButton(("Take " + knit::short_number(*usual) + " rounds").c_str()))
    knit::set_value(*knit::find_parameter(knit::keys::gauge), parameters,
                    knit::number_text(gauge.stitches) + "," + knit::number_text(*usual));
  frame.mark("knob-swatch/take");
  tooltip(frame, "A stitch in stockinette is about 0.72 as high as it is wide. A measured swatch is better.");
}

}  // namespace

std::string follow_words(const knit::ParameterInfo& info, const knit::Parameters& before,
                         const knit::Parameters& now) {
  std::string words;
  for (const knit::ParameterInfo& other : knit::parameter_table()) {
    if (other.key == info.key || !knit::is_read(other, now)) continue;
    const std::string was = shown_value(other, before);
    const std::string is = shown_value(other, now);
    if (was == is) continue;
    words += words.empty() ? "Follows: " : ", ";
    words.append(short_label(other)).append(" ").append(was).append(" \xE2\x86\x92 ").append(is);
  }
  return words;
}

void note_change_of(PanelFrame& frame, const knit::ParameterInfo& info, const knit::Parameters& from,
                    const knit::Parameters& to) {
  KnobFollow& follow = frame.own<KnobFollow>();
  const std::string was = knit::value_text(info, from);
  const bool dragged_on = number_dragged(frame) && follow.before && follow.key == info.key;
  if (!dragged_on) follow.before = from;
  follow.key = std::string(info.key);
  follow.value_before = was;
  follow.value_after = knit::value_text(info, to);
}

float height_of_knob_notes(PanelFrame& frame) { return frame.own<KnobFollow>().notes_height; }

void draw_knob_notes(PanelFrame& frame, knit::Parameters& parameters) {
  const float top = ImGui::GetCursorPosY();
  draw_follows(frame, parameters);
  draw_swatch(frame, parameters);
  frame.own<KnobFollow>().notes_height = ImGui::GetCursorPosY() - top;
}

}  // namespace app
