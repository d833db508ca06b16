#include "app/panels/timeline/tube_band.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "app/panels/kit/tube_marks.h"
#include "app/panels/kit/widgets.h"
#include "knit/insight/why.h"
#include "knit/model/words.h"

namespace app {

namespace {

// Plain units.
constexpr float band_height = 5.0f;
constexpr float mark_size = 3.5f;  // half of it
constexpr float mark_reach = 6.0f;
constexpr std::uint8_t worked = 240, ahead = 125;

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();

struct TubeRows {
  knit::TubeId tube;
  knit::RowId first, last;
};

// That follow each other.
std::vector<TubeRows> rows_by_tube(const knit::Fabric& fabric) {
  std::vector<TubeRows> parts;
  for (const auto& row : fabric.rows()) {
    if (parts.empty() || parts.back().tube != row->tube) parts.push_back({row->tube, row->id, row->id});
    parts.back().last = row->id;
  }
  return parts;
}

const knit::TubePlan* plan_of(const PanelFrame& frame) {
  const knit::State& run = frame.timeline()->furthest();
  return run.tubes ? &*run.tubes : nullptr;
}

// Of capitals: nothing of them hangs below their line.
float letters_height(const PanelFrame& frame) {
  push_font(frame.fonts.small);
  const float height = 0.85f * ImGui::GetTextLineHeight();
  pop_font();
  return height;
}

float y_of_marks(const BandPlace& place) { return 0.5f * (place.letters + place.band); }

// The names where there is room beside the marks at both ends.
void draw_letter(const PanelFrame& frame, const TubeBand::Stretch& stretch, const Track& track,
                 const BandPlace& place) {
  const float x0 = track.x_of(stretch.begin), x1 = track.x_of(stretch.end);
  const std::string name = knit::tube_name(stretch.tube);
  const float width = ImGui::CalcTextSize(name.c_str()).x;
  const float beside = stretch.is_making ? mark_size + 1.0f : 1.0f;
  if (x1 - x0 < width + 2.0f * frame.units(beside)) return;
  text_at(ImVec2(0.5f * (x0 + x1), place.letters - frame.units(1.0f)), 0.5f, theme().text, name);
}

void draw_stretch(const PanelFrame& frame, const TubeBand& band, const TubeBand::Stretch& stretch,
                  const Track& track, const BandPlace& place) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float now = track.x_of(frame.timeline()->position());
  const float x0 = track.x_of(stretch.begin);
  const float x1 = std::max(track.x_of(stretch.end), x0 + 1.0f);
  const Colour colour = yarn_colour(band.yarn(stretch.tube));
  list.AddRectFilled(ImVec2(x0, place.band), ImVec2(x1, track.bottom), style::packed(theme().panel));
  list.AddRectFilled(ImVec2(x0, place.band), ImVec2(x1, track.bottom), style::packed(colour, ahead));
  if (now > x0)
    list.AddRectFilled(ImVec2(x0, place.band), ImVec2(std::min(now, x1), track.bottom),
                       style::packed(colour, worked));
  if (x1 - x0 > frame.units(4.0f))
    list.AddLine(ImVec2(x0, place.band), ImVec2(x0, track.bottom), style::packed(theme().panel),
                 frame.units(1.0f));
}

// Those that would stand on another are left out.
void draw_marks(PanelFrame& frame, const TubeBand& band, const Track& track, const BandPlace& place) {
  const knit::TubePlan& plan = *plan_of(frame);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = frame.units(mark_size);
  float last = -1e9f;
  for (const TubeBand::Mark& mark : band.marks()) {
    const float x = track.x_of(mark.at), y = y_of_marks(place);
    frame.memory.controls.insert_or_assign("track/event/" + std::to_string(mark.event),
                                           Box{x - r, y - r, 2.0f * r, 2.0f * r});
    if (x - last < 2.0f * r) continue;
    last = x;
    const bool dealt = frame.timeline()->position() >= mark.at;
    list.AddCircleFilled(ImVec2(x, y), 1.6f * r, style::packed(theme().panel));
    draw_event_symbol(list, plan.event(mark.event).kind, ImVec2(x, y), r,
                      style::packed(dealt ? theme().text : theme().faint_text), style::packed(theme().panel));
  }
}

}  // namespace

void TubeBand::refresh(const knit::Timeline& timeline) {
  RunKey key = run_key(timeline);
  if (key == key_ && timeline.known() == known_) return;
  *this = TubeBand();
  key_ = std::move(key);
  known_ = timeline.known();
  const knit::State& run = timeline.furthest();
  if (!run.tubes || run.tubes->tubes.size() < 2) return;
  yarns_ = yarns_of(*run.tubes);
  find_stretches(timeline);
  find_marks(timeline);
}

void TubeBand::find_stretches(const knit::Timeline& timeline) {
  using knit::Stage;
  const std::vector<TubeRows> parts = rows_by_tube(timeline.furthest().fabric);
  const auto add = [&](const TubeRows& part, Stage from, Stage to) {
    const std::size_t begin = timeline.position_of({from, part.first, lowest});
    const std::size_t end = timeline.position_of({to, part.last, highest});
    const bool is_making = to <= Stage::rows;
    if (begin < end) stretches_.push_back({part.tube, part.first, part.last, begin, end, is_making});
  };
  for (const TubeRows& part : parts) add(part, knit::stage_of_row(part.first), knit::stage_of_row(part.last));
  for (const Stage stage : {Stage::stitches, Stage::faces, Stage::pattern}) {
    for (const TubeRows& part : parts) add(part, stage, stage);
  }
}

void TubeBand::find_marks(const knit::Timeline& timeline) {
  const auto& deals = timeline.furthest().fabric.deals();
  for (std::size_t i = 0; i < deals.size(); ++i) {
    const knit::StepRange steps = knit::steps_of_deal(timeline, static_cast<std::int32_t>(i) + 1);
    if (steps.begin < steps.end) marks_.push_back({deals[i]->event, steps.begin + 1});
  }
}

const TubeBand::Stretch* TubeBand::at(std::size_t position) const {
  const auto after = std::partition_point(stretches_.begin(), stretches_.end(),
                                          [&](const Stretch& stretch) { return stretch.begin < position; });
  if (after == stretches_.begin() || std::prev(after)->end < position) return nullptr;
  return &*std::prev(after);
}

BandPlace place_of_band(const PanelFrame& frame, const Track& track) {
  auto& band = frame.own<TubeBand>();
  band.refresh(*frame.timeline());
  if (band.stretches().empty()) return {track.bottom, track.bottom};
  const float foot = track.bottom - frame.units(band_height);
  const float letters = foot - letters_height(frame);
  const bool fits = letters - track.top >= 0.9f * ImGui::GetTextLineHeight();
  return {fits ? letters : foot - frame.units(2.0f * mark_size), foot};
}

void draw_tube_band(PanelFrame& frame, const Track& track) {
  const BandPlace place = place_of_band(frame, track);
  const auto& band = frame.own<TubeBand>();
  if (band.stretches().empty()) return;
  const bool lettered = place.band - place.letters >= letters_height(frame) - 0.5f;
  push_font(frame.fonts.small);
  for (const TubeBand::Stretch& stretch : band.stretches()) {
    draw_stretch(frame, band, stretch, track, place);
    if (lettered) draw_letter(frame, stretch, track, place);
  }
  pop_font();
  draw_marks(frame, band, track, place);
}

std::optional<TubeBand::Mark> mark_under(const PanelFrame& frame, const Track& track) {
  const BandPlace place = place_of_band(frame, track);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (mouse.y < place.letters || mouse.y > track.bottom) return std::nullopt;
  std::optional<TubeBand::Mark> nearest;
  float least = frame.units(mark_reach);
  for (const TubeBand::Mark& mark : frame.own<TubeBand>().marks()) {
    const float away = std::abs(track.x_of(mark.at) - mouse.x);
    if (away >= least) continue;
    least = away;
    nearest = mark;
  }
  return nearest;
}

std::string tube_words_at(const PanelFrame& frame, std::size_t position) {
  const TubeBand::Stretch* stretch = frame.own<TubeBand>().at(position);
  if (stretch == nullptr || position == 0) return "";
  const knit::RowId row = frame.timeline()->step(position - 1).place.row;
  const std::string rounds = std::to_string(stretch->last - stretch->first + 1);
  return "Tube " + knit::tube_name(stretch->tube) + ", round " + std::to_string(row - stretch->first + 1) +
         " of " + rounds + ".";
}

}  // namespace app
