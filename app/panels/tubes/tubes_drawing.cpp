#include "app/panels/tubes/tubes_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

#include "app/panels/kit/plots.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/tubes/tube_names.h"
#include "knit/insight/waiting.h"
#include "knit/insight/why.h"
#include "knit/model/words.h"

namespace app {

namespace {

using plot_parts::whole;

// --- what is kept between frames -------------------------------------------------------------------------------

void count_rows(const knit::Fabric& fabric, std::size_t tubes, TubesSeen& seen) {
  const knit::RowId counted = seen.last_counted ? seen.last_counted->id : 0;
  const bool goes_on =
      counted == 0 || (fabric.has_row(counted) && fabric.shared_row(counted).pointer() == seen.last_counted);
  if (!goes_on || seen.counts.size() != tubes) {
    seen.counts.assign(tubes, {});
    seen.last_counted = nullptr;
  }
  for (knit::RowId id = seen.last_counted ? counted + 1 : 1; fabric.has_row(id); ++id) {
    const auto tube = static_cast<std::size_t>(fabric.row(id).tube);
    seen.last_counted = fabric.shared_row(id).pointer();
    if (tube >= tubes) continue;
    ++seen.counts[tube].rows;
    seen.counts[tube].stitches += knit::size_of(fabric.row(id));
  }
}

}  // namespace

const knit::State& state_with_plan(const knit::Timeline& timeline) {
  return timeline.state().tubes ? timeline.state() : timeline.furthest();
}

const TubesSeen& seen_now(const PanelFrame& frame) {
  const knit::State& state = state_with_plan(*frame.timeline());
  auto& seen = frame.own<TubesSeen>();
  if (seen.plan != state.tubes.content_hash() || seen.graph != state.graph.content_hash()) {
    seen = TubesSeen{};
    seen.plan = state.tubes.content_hash();
    seen.graph = state.graph.content_hash();
    seen.layout = lay_out(*state.tubes);
    seen.words = plan_words(*state.tubes, seen.layout, state.graph.pointer().get());
  }
  count_rows(frame.timeline()->furthest().fabric, state.tubes->tubes.size(), seen);
  return seen;
}

namespace {

// --- a tube in this frame --------------------------------------------------------------------------------------

constexpr std::uint8_t bright = 235, faint = 70;
constexpr float symbol_room = 5.0f;  // plain units: half of what an event's symbol needs

// Girths differ by far more than places on the screen do.
float half_width(const PanelFrame& frame, const TubesDrawing& drawing, double length) {
  const double longest = drawing.seen.layout.longest;
  const double share = longest > 0.0 ? std::sqrt(std::clamp(length / longest, 0.0, 1.0)) : 0.0;
  const double room = 0.38 * drawing.seen.layout.column * static_cast<double>(drawing.ground.width);
  const float widest = std::min(static_cast<float>(room), frame.units(52.0f));
  return std::max(frame.units(1.5f), static_cast<float>(share) * widest);
}

bool is_dealt(const TubesDrawing& drawing, std::int32_t event) {
  return drawing.dealt[static_cast<std::size_t>(event)] != 0;
}

ShownTube shown_tube(const PanelFrame& frame, const TubesDrawing& drawing, knit::TubeId id) {
  const knit::State& state = frame.timeline()->state();
  const knit::Tube& tube = drawing.tube(id);
  const TubePlace& place = drawing.place(id);
  ShownTube shown;
  shown.id = id;
  shown.x = drawing.x_of(place.x);
  const float low = drawing.y_of(place.low);
  const float high = drawing.y_of(place.high);
  const float inset = std::min(frame.units(11.0f), 0.28f * (low - high));
  shown.bottom = low - inset;
  shown.top = high + inset;
  const auto longest = std::max_element(tube.lengths.begin(), tube.lengths.end());
  shown.half = half_width(frame, drawing, longest != tube.lengths.end() ? *longest : 0.0);
  shown.colour = yarn_colour(place.yarn);
  if (!state.tubes) return shown;
  const bool ends = drawing.plan.event(tube.top).kind == knit::EventKind::bind_off;
  if (tube.rows() > 0) {
    shown.knitted = std::clamp(state.fabric.row_count() + 1 - place.first_row, 0, tube.rows());
    shown.done = shown.knitted == tube.rows();
  } else {
    shown.done = is_dealt(drawing, ends ? tube.bottom : tube.top);
  }
  shown.held = drawing.waits[static_cast<std::size_t>(id)] != 0;
  shown.begun = shown.knitted > 0 || shown.done;
  return shown;
}

knit::RowId row_of_selected(const PanelFrame& frame) {
  const auto& selected = frame.session.document->travel.selected;
  if (!selected) return 0;
  return std::visit(
      [](const auto& thing) -> knit::RowId {
        if constexpr (requires { thing.row; }) return thing.row;
        return 0;
      },
      *selected);
}

}  // namespace

TubesDrawing drawing_of(const PanelFrame& frame, const Box& ground) {
  const knit::TubePlan& plan = *state_with_plan(*frame.timeline()).tubes;
  const knit::State& state = frame.timeline()->state();
  TubesDrawing drawing{plan, seen_now(frame), *ImGui::GetWindowDrawList(), ground, {}, {}, {}};
  drawing.waits.assign(plan.tubes.size(), 0);
  for (const knit::LiveLoop& loop : knit::waiting_loops(state))
    drawing.waits[static_cast<std::size_t>(loop.tube)] = 1;
  drawing.dealt.assign(plan.events.size(), 0);
  for (const auto& deal : state.fabric.deals()) {
    const auto event = static_cast<std::size_t>(deal->event);
    if (event < drawing.dealt.size()) drawing.dealt[event] = 1;
  }
  const auto* work = std::get_if<knit::ContourWork>(&state.work);
  if (work != nullptr && work->deal) drawing.dealing = work->deal->event;
  drawing.row = current_row(frame);
  // The steps of a deal count towards a row that is not begun.
  if (drawing.dealing < 0) drawing.current = tube_of_row(plan, drawing.seen.layout, drawing.row);
  drawing.chosen = tube_of_row(plan, drawing.seen.layout, row_of_selected(frame));
  if (frame.session.view->gaze.hovered_rounds) {
    for (const RoundSpan& rounds : all_rounds_meant(frame.session))
      drawing.meant.push_back(tube_of_row(plan, drawing.seen.layout, rounds.first));
  }
  for (std::size_t i = 0; i < plan.tubes.size(); ++i)
    drawing.tubes.push_back(shown_tube(frame, drawing, static_cast<knit::TubeId>(i)));
  return drawing;
}

std::vector<knit::TubeId> twins_of(const TubesDrawing& drawing, knit::TubeId id) {
  const std::vector<knit::TubeId>& twins = drawing.tube(id).twins;
  return twins.empty() ? std::vector{id} : twins;
}

ImVec2 event_at(const TubesDrawing& drawing, std::size_t event) {
  const EventPlace& place = drawing.seen.layout.events[event];
  return {drawing.x_of(place.x), drawing.y_of(place.y)};
}

namespace {

// --- its lines -------------------------------------------------------------------------------------------------

float y_of_row(const ShownTube& shown, const knit::Tube& tube, double row) {
  const auto share = static_cast<float>(row / std::max(1, tube.rows()));
  return shown.bottom - share * (shown.bottom - shown.top);
}

// A bar a row, as wide as the row is long; of more rows than places on the screen every so many.
void draw_band(const PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown) {
  const knit::Tube& tube = drawing.tube(shown.id);
  const int rows = tube.rows();
  if (rows == 0) {
    drawing.list.AddLine(ImVec2(shown.x, shown.bottom), ImVec2(shown.x, shown.top),
                         style::packed(shown.colour, shown.done ? bright : faint), frame.units(2.0f));
    return;
  }
  const float high = (shown.bottom - shown.top) / static_cast<float>(rows);
  const float gap = high >= frame.units(4.0f) ? frame.units(1.0f) : 0.0f;
  const int stride = std::max(1, static_cast<int>(std::ceil(1.0f / std::max(high, 1e-3f))));
  for (int row = 0; row < rows; row += stride) {
    const float y0 = whole(y_of_row(shown, tube, row));
    const float y1 = whole(y_of_row(shown, tube, std::min(row + stride, rows)));
    const float half = half_width(frame, drawing, tube.lengths[static_cast<std::size_t>(row)]);
    drawing.list.AddRectFilled(ImVec2(shown.x - half, std::min(y1 + gap, y0)), ImVec2(shown.x + half, y0),
                               style::packed(shown.colour, row < shown.knitted ? bright : faint));
  }
}

// From an event to the end of a tube that it has: a curve's four points.
std::array<ImVec2, 4> way_of(const TubesDrawing& drawing, const ShownTube& shown, bool at_bottom) {
  const knit::Tube& tube = drawing.tube(shown.id);
  const ImVec2 from = event_at(drawing, static_cast<std::size_t>(at_bottom ? tube.bottom : tube.top));
  const ImVec2 to(shown.x, at_bottom ? shown.bottom : shown.top);
  const float bend = 0.6f * (to.y - from.y);
  return {from, ImVec2(to.x, from.y), ImVec2(to.x, to.y - bend), to};
}

void draw_way(const PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown, bool at_bottom) {
  const auto [from, first, second, to] = way_of(drawing, shown, at_bottom);
  const bool lit = at_bottom ? shown.begun || shown.held : shown.done;
  drawing.list.AddBezierCubic(from, first, second, to, style::packed(shown.colour, lit ? bright : faint),
                              frame.units(2.0f));
}

// Across a tube on a holder, where its knitting waits.
Box bar_of_holder(const PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown) {
  const float y = whole(y_of_row(shown, drawing.tube(shown.id), shown.knitted));
  const float half = shown.half + frame.units(8.0f);
  const float thick = std::max(2.0f, whole(frame.units(2.0f)));
  return {shown.x - half, y - 0.5f * thick, 2.0f * half, thick};
}

void dashed_across(const PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown) {
  const Box bar = bar_of_holder(frame, drawing, shown);
  const float dash = whole(frame.units(4.0f));
  for (float x = bar.x; x < bar.right(); x += 1.75f * dash) {
    drawing.list.AddRectFilled(ImVec2(x, bar.y), ImVec2(std::min(x + dash, bar.right()), bar.bottom()),
                               style::packed(theme().warning));
  }
}

// Requires a current tube.
Box bar_of_current_row(const PanelFrame& frame, const TubesDrawing& drawing) {
  const ShownTube& shown = drawing.tubes[static_cast<std::size_t>(drawing.current)];
  const double row = drawing.row - drawing.place(drawing.current).first_row + 0.5;
  const float y = whole(y_of_row(shown, drawing.tube(drawing.current), row));
  const float half = shown.half + frame.units(6.0f);
  const float thick = std::max(2.0f, whole(frame.units(2.0f)));
  return {shown.x - half, y - 0.5f * thick, 2.0f * half, thick};
}

void draw_current_row(const PanelFrame& frame, const TubesDrawing& drawing) {
  if (drawing.current < 0) return;
  const Box bar = bar_of_current_row(frame, drawing);
  drawing.list.AddRectFilled(ImVec2(bar.x, bar.y), ImVec2(bar.right(), bar.bottom()),
                             style::packed(theme().anchor));
}

// Rows that are meant elsewhere: by a line of the pattern, a stitch, a place on the timeline.
void draw_meant_rows(const PanelFrame& frame, const TubesDrawing& drawing, const RoundSpan& meant) {
  for (const ShownTube& shown : drawing.tubes) {
    const knit::RowId first = drawing.place(shown.id).first_row;
    const knit::Tube& tube = drawing.tube(shown.id);
    const int low = std::max(0, meant.first - first);
    const int high = std::min(tube.rows(), meant.last - first + 1);
    if (first <= 0 || low >= high) continue;
    const float half = shown.half + frame.units(3.0f);
    const ImVec2 upper(shown.x - half, whole(y_of_row(shown, tube, high)) - frame.units(1.0f));
    const ImVec2 lower(shown.x + half, whole(y_of_row(shown, tube, low)) + frame.units(1.0f));
    drawing.list.AddRect(upper, lower, style::packed(theme().accepted), frame.units(2.0f), 0,
                         frame.units(2.0f));
  }
}

void draw_outline(const PanelFrame& frame, const TubesDrawing& drawing, knit::TubeId id, Colour colour) {
  if (id < 0) return;
  const ShownTube& shown = drawing.tubes[static_cast<std::size_t>(id)];
  const float half = shown.half + frame.units(3.0f);
  const float air = frame.units(2.0f);
  drawing.list.AddRect(ImVec2(shown.x - half, shown.top - air), ImVec2(shown.x + half, shown.bottom + air),
                       style::packed(colour), frame.units(3.0f), ImDrawFlags_None, frame.units(1.5f));
}

// --- its words -------------------------------------------------------------------------------------------------

struct LabelLine {
  std::string words;
  ImFont* font;
};

ImVec2 size_of_label(const std::vector<LabelLine>& lines) {
  ImVec2 size(0.0f, 0.0f);
  for (const LabelLine& line : lines) {
    push_font(line.font);
    const ImVec2 one = ImGui::CalcTextSize(line.words.c_str());
    pop_font();
    size = ImVec2(std::max(size.x, one.x), size.y + one.y);
  }
  return size;
}

// The name, and how many rounds and stitches: in words, short, or not at all, as there is room.
std::vector<LabelLine> label_of(const PanelFrame& frame, const TubesDrawing& drawing,
                                const ShownTube& shown) {
  const knit::Tube& tube = drawing.tube(shown.id);
  const std::string name = knit::tube_name(shown.id);
  const TubeCount& count = drawing.seen.counts[static_cast<std::size_t>(shown.id)];
  const std::string rounds = std::to_string(tube.rows());
  std::vector<std::vector<LabelLine>> ways;
  if (tube.rows() > 0) {
    ways.push_back({{name, frame.fonts.strong},
                    {knit::plural(tube.rows(), "round", "rounds"), frame.fonts.small},
                    {stitches_of_tube(drawing.plan, shown.id, count, " stitches"), frame.fonts.small}});
    ways.push_back({{name, frame.fonts.strong},
                    {rounds + " r", frame.fonts.small},
                    {stitches_of_tube(drawing.plan, shown.id, count, " st"), frame.fonts.small}});
    ways.push_back({{name + " " + rounds, frame.fonts.small}});
  } else {
    ways.push_back({{name, frame.fonts.strong}});
  }
  ways.push_back({{name, frame.fonts.small}});
  const float room_across = static_cast<float>(drawing.seen.layout.column) * drawing.ground.width;
  const float room_up = shown.bottom - shown.top;
  for (std::vector<LabelLine>& lines : ways) {
    const ImVec2 size = size_of_label(lines);
    if (size.x + frame.units(6.0f) <= room_across && size.y <= room_up) return std::move(lines);
  }
  return {};
}

void draw_tube_label(const PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown,
                     const std::vector<LabelLine>& lines, const ImVec2& size) {
  const float edge = frame.units(3.0f);
  ImVec2 at(shown.x, whole(0.5f * (shown.bottom + shown.top - size.y)));
  drawing.list.AddRectFilled(ImVec2(at.x - 0.5f * size.x - edge, at.y),
                             ImVec2(at.x + 0.5f * size.x + edge, at.y + size.y),
                             style::packed(theme().background), frame.units(3.0f));
  for (const LabelLine& line : lines) {
    push_font(line.font);
    text_at(at, 0.5f, shown.begun ? theme().text : theme().faint_text, line.words);
    at.y += ImGui::GetTextLineHeight();
    pop_font();
  }
}

// Beside its band, from the middle outward, and over or under its ends.
std::vector<Box> places_of_name(const PanelFrame& frame, const TubesDrawing& drawing, const ShownTube& shown,
                                const ImVec2& size) {
  const float half = drawing.tube(shown.id).rows() > 0 ? shown.half : 0.0f, air = frame.units(3.0f);
  const float high = shown.bottom - shown.top, middle = 0.5f * (shown.bottom + shown.top - size.y);
  std::vector<Box> places;
  for (const float off : {0.0f, -0.3f, 0.3f}) {
    for (const float x : {shown.x + half + air, shown.x - half - air - size.x})
      places.push_back({x, whole(middle + off * high), size.x, size.y});
  }
  const float past = frame.units(symbol_room);
  const float over = drawing.y_of(drawing.place(shown.id).high) - past - size.y;
  const float under = drawing.y_of(drawing.place(shown.id).low) + past;
  for (const float y : {over, under}) places.push_back({shown.x - 0.5f * size.x, whole(y), size.x, size.y});
  return places;
}

// Where no name is to stand: symbols, bands, the bars of the current row and of holders, and the ways between them.
std::vector<Box> taken_by_lines(const PanelFrame& frame, const TubesDrawing& drawing) {
  const float r = frame.units(symbol_room), thick = frame.units(1.5f);
  std::vector<Box> taken;
  const auto around = [&](const ImVec2& at, float half) {
    taken.push_back({at.x - half, at.y - half, 2.0f * half, 2.0f * half});
  };
  for (std::size_t i = 0; i < drawing.plan.events.size(); ++i) around(event_at(drawing, i), r);
  if (drawing.current >= 0) taken.push_back(bar_of_current_row(frame, drawing));
  for (const ShownTube& shown : drawing.tubes) {
    const float half = drawing.tube(shown.id).rows() > 0 ? shown.half : thick;
    taken.push_back({shown.x - half, shown.top, 2.0f * half, shown.bottom - shown.top});
    if (shown.held) taken.push_back(bar_of_holder(frame, drawing, shown));
    for (const bool at_bottom : {true, false}) {
      const auto [p0, p1, p2, p3] = way_of(drawing, shown, at_bottom);
      constexpr int parts = 16;
      for (int i = 1; i < parts; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(parts), u = 1.0f - t;
        const float a = u * u * u, b = 3.0f * u * u * t, c = 3.0f * u * t * t, d = t * t * t;
        around(ImVec2(a * p0.x + b * p1.x + c * p2.x + d * p3.x, a * p0.y + b * p1.y + c * p2.y + d * p3.y),
               thick);
      }
    }
  }
  return taken;
}

std::vector<knit::TubeId> largest_first(const TubesDrawing& drawing) {
  std::vector<double> sizes;
  std::vector<knit::TubeId> tubes;
  for (const ShownTube& shown : drawing.tubes) {
    const std::vector<double>& lengths = drawing.tube(shown.id).lengths;
    sizes.push_back(std::accumulate(lengths.begin(), lengths.end(), 0.0));
    tubes.push_back(shown.id);
  }
  std::stable_sort(tubes.begin(), tubes.end(), [&](knit::TubeId a, knit::TubeId b) {
    return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
  });
  return tubes;
}

// In their bands where there is room; else names alone, beside them, as many as find a place. All are in the list.
void draw_words(const PanelFrame& frame, const TubesDrawing& drawing) {
  std::vector<Box> taken = taken_by_lines(frame, drawing);
  std::vector<knit::TubeId> outside;
  std::vector<std::vector<Box>> names;
  for (const knit::TubeId id : largest_first(drawing)) {
    const ShownTube& shown = drawing.tubes[static_cast<std::size_t>(id)];
    if (const std::vector<LabelLine> lines = label_of(frame, drawing, shown); !lines.empty()) {
      const ImVec2 size = size_of_label(lines);
      draw_tube_label(frame, drawing, shown, lines, size);
      taken.push_back({shown.x - 0.5f * size.x, 0.5f * (shown.bottom + shown.top - size.y), size.x, size.y});
      continue;
    }
    outside.push_back(id);
    names.push_back(
        places_of_name(frame, drawing, shown, size_of_label({{knit::tube_name(id), frame.fonts.small}})));
  }
  const float edge = frame.units(12.0f);  // that is left round the tubes
  const Box ground{drawing.ground.x, drawing.ground.y - edge, drawing.ground.width,
                   drawing.ground.height + 2.0f * edge};
  const std::vector<std::optional<Box>> placed = place_names(names, std::move(taken), ground);
  push_font(frame.fonts.small);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const ShownTube& shown = drawing.tubes[static_cast<std::size_t>(outside[i])];
    if (placed[i])
      text_at(ImVec2(placed[i]->x, placed[i]->y), 0.0f, shown.begun ? theme().text : theme().faint_text,
              knit::tube_name(shown.id));
  }
  pop_font();
}

// --- events ----------------------------------------------------------------------------------------------------

bool event_is_past(const TubesDrawing& drawing, std::size_t event) {
  const knit::TubeEvent& of = drawing.plan.events[event];
  const auto shown = [&](knit::TubeId id) -> const ShownTube& {
    return drawing.tubes[static_cast<std::size_t>(id)];
  };
  if (of.kind == knit::EventKind::cast_on) return shown(of.above.front()).begun;
  if (of.kind == knit::EventKind::bind_off) return shown(of.below.front()).done;
  return drawing.dealt[event] != 0;
}

void draw_events(const PanelFrame& frame, const TubesDrawing& drawing) {
  for (std::size_t i = 0; i < drawing.plan.events.size(); ++i) {
    const bool now = drawing.dealing == static_cast<std::int32_t>(i);
    const Colour colour = now                         ? theme().anchor
                          : event_is_past(drawing, i) ? theme().text
                                                      : theme().faint_text;
    const ImVec2 at = event_at(drawing, i);
    const float r = frame.units(now ? 5.5f : 4.0f);
    drawing.list.AddCircleFilled(at, 1.25f * r, style::packed(theme().background));
    draw_event_symbol(drawing.list, drawing.plan.events[i].kind, at, r, style::packed(colour),
                      style::packed(theme().background));
  }
}

}  // namespace

void draw_tubes(const PanelFrame& frame, const TubesDrawing& drawing, std::optional<knit::TubeId> pointed) {
  for (const ShownTube& shown : drawing.tubes) {
    draw_way(frame, drawing, shown, true);
    draw_way(frame, drawing, shown, false);
  }
  for (const ShownTube& shown : drawing.tubes) draw_band(frame, drawing, shown);
  draw_current_row(frame, drawing);
  for (const RoundSpan& meant : all_rounds_meant(frame.session)) draw_meant_rows(frame, drawing, meant);
  draw_outline(frame, drawing, drawing.current, theme().anchor);
  draw_outline(frame, drawing, drawing.chosen, theme().selected);
  for (const knit::TubeId tube : pointed ? twins_of(drawing, *pointed) : drawing.meant)
    draw_outline(frame, drawing, tube, theme().text);
  draw_events(frame, drawing);
  // Words last: a narrow tube's are wider than it is, and a name stands close to an event.
  draw_words(frame, drawing);
  for (const ShownTube& shown : drawing.tubes) {
    if (shown.held) dashed_across(frame, drawing, shown);
  }
}

}  // namespace app
