// While presenting: below the view what the step says, in letters that the last row of a class can read, row and
// count, and a thin timeline; a soft ring round the pointer.
#include "app/panels/timeline/present.h"

#include <algorithm>
#include <array>
#include <string>

#include "app/actions/playing.h"
#include "app/panels/kit/large_lines.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/timeline/track.h"
#include "app/session/document.h"
#include "app/session/row_table.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr float caption_share = 1.0f / 15.0f;  // of the window's height: a letter's
constexpr float margin_share = 0.04f;          // of the caption's width

std::string stitch_words(std::size_t count) {
  return knit::plural(static_cast<std::int64_t>(count), "stitch", "stitches");
}

void draw_words(ImFont* font, const LargeWords& large, ImVec2 at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const std::string& line : large.lines) {
    list.AddText(font, large.size, at, style::packed(theme().text), line.c_str());
    at.y += large_line_height * large.size;
  }
}

void draw_stretches(const PanelFrame& frame, const Track& track) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float now = track.x_of(frame.timeline()->position());
  for (const RunCache::Stretch& stretch : frame.own<RunCache>().stages()) {
    const float from = track.x_of(stretch.begin);
    const float to = std::max(track.x_of(stretch.end), from + 1.0f);
    const Colour colour = theme().of(stretch.stage);
    list.AddRectFilled(ImVec2(from, track.top), ImVec2(to, track.bottom),
                       style::packed(colour, theme().stage_ahead));
    if (now > from)
      list.AddRectFilled(ImVec2(from, track.top), ImVec2(std::min(now, to), track.bottom),
                         style::packed(colour, theme().stage_done));
  }
  list.AddCircleFilled(ImVec2(now, 0.5f * (track.top + track.bottom)), frame.units(5.0f),
                       style::packed(theme().text));
}

}  // namespace

std::string row_and_count(const knit::Timeline& timeline) {
  const knit::State& state = timeline.state();
  const knit::Place place = timeline.position() > 0 ? timeline.place() : state.next;
  if (place.row < 1) return capitalised(knit::name_of(place.stage));
  std::string words = "Row " + std::to_string(place.row);
  if (timeline.complete() && timeline.furthest().fabric.row_count() >= place.row)
    words += " of " + std::to_string(timeline.furthest().fabric.row_count());
  if (const knit::Row* row = state.fabric.find_row(place.row))
    return words + ": " + stitch_words(row->stitches.size());
  const std::size_t made = stitches_so_far(state);
  return made > 0 ? words + ": " + stitch_words(made) + " so far" : words;
}

void draw_large_caption(PanelFrame& frame) {
  const Box& box = frame.layout.caption;
  begin_panel("Caption", box, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const float margin = std::max(margin_share * box.width, frame.units(12.0f));
  const float gap = frame.units(6.0f);
  const float width = box.width - 2.0f * margin;
  float top = box.y + gap;
  if (frame.timeline() != nullptr) {
    const std::string words = row_and_count(*frame.timeline());
    push_font(frame.fonts.strong);
    text_at(ImVec2(box.x + margin, top), 0.0f, theme().accent, cut_to_width(words, width));
    top += ImGui::GetTextLineHeight() + gap;
    pop_font();
  }
  const float wanted = std::max(caption_share * frame.layout.window.height, frame.units(style::text_size));
  const LargeWords large =
      large_words(frame.fonts.heading, sentence(frame.session), wanted, width, box.bottom() - gap - top);
  draw_words(frame.fonts.heading, large, ImVec2(box.x + margin, top));
  ImGui::Dummy(ImVec2(1.0f, 1.0f));
  ImGui::End();
  frame.memory.controls.insert_or_assign("caption", box);
}

void draw_thin_timeline(PanelFrame& frame) {
  const Box& box = frame.layout.timeline;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  begin_panel("Timeline", box, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (const knit::Timeline* timeline = frame.timeline()) {
    const float margin = frame.units(8.0f);
    const float middle = box.y + 0.5f * box.height;
    const float half = frame.units(2.5f);
    const Prelude prelude = prelude_of(*timeline);
    const Track track{box.x + margin,
                      box.right() - margin,
                      middle - half,
                      middle + half,
                      timeline->known(),
                      prelude.steps,
                      prelude.share(timeline->known())};
    ImGui::InvisibleButton("track", ImVec2(box.width, box.height));
    frame.mark("track");
    if (ImGui::IsItemActive()) {
      const std::size_t wanted = track.position_at(ImGui::GetIO().MousePos.x);
      if (wanted != timeline->position()) frame.wish(SeekTo{wanted});
    }
    draw_stretches(frame, track);
  }
  ImGui::End();
}

void draw_ring(const PanelFrame& frame) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (!frame.session.view->ring || !ImGui::IsMousePosValid(&at)) return;
  struct Circle {
    float radius, width;  // plain units
    std::uint8_t alpha;
  };
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  for (const Circle& circle : {Circle{20.0f, 12.0f, 50}, Circle{20.0f, 7.0f, 70}, Circle{20.0f, 2.5f, 220}})
    list.AddCircle(at, frame.units(circle.radius), style::packed(theme().warning, circle.alpha), 0,
                   frame.units(circle.width));
}

}  // namespace app
