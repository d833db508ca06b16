// Knit along: one round at a time, large, over the foot of the centre; its line, its row of the chart, and forward
// and back. The view and the chart light the same round. Through pieces: limb by limb, with the deals between them, what
// waits on which holder and what comes next.
#include <algorithm>
#include <string>

#include "app/panels/kit/commands.h"
#include "app/panels/kit/ways.h"
#include "app/panels/kit/widgets.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern.h"
#include "app/panels/pattern/pattern_parts.h"
#include "app/panels/pattern/piece_stops.h"
#include "app/session/view.h"
#include "knit/pattern/pattern_words.h"

namespace app {

namespace {

// A row of buttons, words, and at the right the cross.
class TurningBar {
 public:
  explicit TurningBar(PanelFrame& frame) : frame_(frame), side_(frame.units(34.0f)) {}

  void turn(const char* id, Icon icon, const KnitAlong& to, const char* help) {
    if (icon_button(id, icon, ImVec2(side_, side_))) frame_.wish(to);
    frame_.mark("knit-along/" + std::string(id));
    tooltip(frame_, help);
    ImGui::SameLine();
  }
  // By its button, or by the keys of a step.
  void turn(const char* id, Icon icon, Command keys, const KnitAlong& to, const std::string& help) {
    if (is_pressed(keys)) frame_.wish(to);
    turn(id, icon, to, (help + " (" + keys_of(info_of(keys)) + ")").c_str());
  }
  void end(const std::string& place) {
    const float top = ImGui::GetCursorPosY();
    // Beside a button words stand lower by its padding anyway.
    ImGui::SetCursorPosY(top + 0.5f * (side_ - ImGui::GetTextLineHeight()) -
                         ImGui::GetStyle().FramePadding.y);
    faint_text(place);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - side_);
    ImGui::SetCursorPosY(top);
    if (icon_button("close", Icon::cross, ImVec2(side_, side_))) frame_.wish(KnitAlong{std::nullopt});
    frame_.mark("knit-along/close");
    tooltip(frame_, "Stop knitting along; the round is remembered.");
  }

 private:
  PanelFrame& frame_;
  float side_;
};

// A short row is a stop of its own.
void draw_turning(PanelFrame& frame, const ChartCache& cache, std::int32_t row) {
  const std::int32_t last = cache.last_row();
  const knit::WrittenRow at = cache.written(row);
  TurningBar bar(frame);
  const auto to = [&](std::int32_t number) { return KnitAlong{std::clamp(number, 1, last)}; };
  const auto by = [&](std::int32_t stops) { return to(row + stops); };
  bar.turn("first", Icon::first, to(1), "To the cast on.");
  bar.turn("back", Icon::back, Command::back_item, by(-1), "One round back");
  bar.turn("forward", Icon::forward, Command::forward_item, by(1), "This round is knitted: the next one");
  const std::string round = std::to_string(at.round) + " of " + std::to_string(cache.written(last).round);
  bar.end(at.short_row > 0 ? "Short row " + std::to_string(at.short_row) + " before round " + round
                           : "Round " + round);
}

// The round's squares in working order, from right to left as on the chart.
void draw_strip(const PanelFrame& frame, const knit::ChartRow& row) {
  const float width = ImGui::GetContentRegionAvail().x;
  const auto count = static_cast<float>(std::max<std::size_t>(1, row.squares.size()));
  const float side = std::min(frame.units(22.0f), width / count);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t column = 0; column < row.squares.size(); ++column) {
    const ImVec2 at(low.x + width - side * static_cast<float>(column + 1), low.y);
    draw_square(list, at, row.squares[column], {side, false, false});
  }
  ImGui::Dummy(ImVec2(width, side));
}

void draw_round_line(PanelFrame& frame, const std::string& words) {
  constexpr std::size_t is_long = 300;  // a join of many limbs
  push_font(words.size() < is_long ? frame.fonts.heading : frame.fonts.text);
  wrapped_text(words);
  pop_font();
  frame.mark("knit-along/line");
}

// A label in a column of its own, and words beside it.
void draw_labelled(PanelFrame& frame, const char* label, const std::string& words, const char* mark) {
  const float left = ImGui::GetCursorPosX();
  faint_text(label);
  ImGui::SameLine(left + frame.units(78.0f));
  wrapped_text(words);
  frame.mark(mark);
}

// Where the round stands in its rhythm, and the line of the short form that it is of.
void draw_rhythm(PanelFrame& frame, const ChartCache& cache, std::int32_t round) {
  const std::string place = cache.rhythm_of(round);
  if (!place.empty()) draw_labelled(frame, "Rhythm", place, "knit-along/rhythm");
  const std::string line = cache.short_line_of(round);
  if (!line.empty()) draw_labelled(frame, "Of", line, "knit-along/short-line");
}

// --- through pieces ----------------------------------------------------------------------------------------------

void draw_turning_of_pieces(PanelFrame& frame, const ChartCache& cache, const std::vector<PieceStop>& stops,
                            std::size_t at) {
  TurningBar bar(frame);
  const auto to = [&](std::size_t stop) { return KnitAlong{stops[stop].row, stops[stop].deal}; };
  bar.turn("first", Icon::first, to(stop_a_piece_on(stops, at, -1)),
           "To the beginning of this piece, or of the one before.");
  bar.turn("back", Icon::back, Command::back_item, to(at > 0 ? at - 1 : 0), "One round back");
  bar.turn("forward", Icon::forward, Command::forward_item, to(std::min(at + 1, stops.size() - 1)),
           "This is knitted, or dealt: what comes next");
  bar.turn("next-piece", Icon::last, to(stop_a_piece_on(stops, at, 1)), "To the next piece.");
  bar.end(place_words(cache.pieces(), stops[at]) + "; piece " + std::to_string(stops[at].piece + 1) + " of " +
          std::to_string(cache.pieces().plan.count()));
}

std::string holders_text(const Holding& holding) {
  if (holding.holders.empty()) return "none in use";
  std::string words;
  for (const HeldPiece& held : holding.holders) {
    words += words.empty() ? "" : ", ";
    words += knit::stitches_text(held.stitches) + " of " + held.name;
  }
  return words;
}

const knit::ChartRow* chart_row_of(const ChartCache& cache, const PieceStop& stop) {
  if (stop.deal != 0) return nullptr;
  const knit::LimbPiece& piece = cache.pieces().plan.piece(stop.piece);
  for (const knit::PieceChart& chart : cache.piece_charts()) {
    if (std::find(chart.pieces.begin(), chart.pieces.end(), stop.piece) == chart.pieces.end()) continue;
    // Of pieces made together the first stands for all.
    const knit::LimbPiece& drawn = cache.pieces().plan.piece(chart.pieces.front());
    const std::int32_t row = chart.row_of(drawn.rows.front() + stop.row - piece.rows.front());
    return row < 0 ? nullptr : &chart.chart.rows[static_cast<std::size_t>(row)];
  }
  return nullptr;
}

void draw_pieces_along(PanelFrame& frame, const ChartCache& cache, std::int32_t row) {
  const PlannedPieces& pieces = cache.pieces();
  const std::vector<PieceStop> stops = stops_of(pieces.plan);
  const std::size_t at = stop_at(stops, row, frame.session.view->gaze.knit_along_deal);
  const PieceStop& stop = stops[at];
  draw_turning_of_pieces(frame, cache, stops, at);
  draw_round_line(frame, words_of(pieces, stop));
  if (const knit::ChartRow* squares = chart_row_of(cache, stop)) draw_strip(frame, *squares);
  const std::string rhythm = stop.deal == 0 && stop.short_row == 0 ? cache.rhythm_of(stop.row) : "";
  if (!rhythm.empty()) draw_labelled(frame, "Rhythm", rhythm, "knit-along/rhythm");
  const std::string end = end_words(pieces, stop);
  if (!end.empty()) draw_labelled(frame, "Then", end, "knit-along/end");
  const std::string seam = seam_words(pieces, stop);
  if (!seam.empty()) draw_labelled(frame, "How", seam, "knit-along/seam");
  const Holding holding = holding_after(pieces, stop);
  draw_labelled(frame, "Needle",
                knit::stitches_text(holding.needle) + " of " + pieces.name_of(stop.piece) +
                    (stop.deal == 0 && stop.short_row == 0 ? ", after this round" : ", after this"),
                "knit-along/needle");
  draw_labelled(frame, "Holders", holders_text(holding), "knit-along/holders");
  if (at + 1 == stops.size()) return;
  const PieceStop& next = stops[at + 1];
  const std::string whose = next.piece == stop.piece ? "" : pieces.name_of(next.piece) + ": ";
  const float room = ImGui::GetContentRegionAvail().x - frame.units(86.0f);
  draw_labelled(frame, "Next", cut_to_width(whose + words_of(pieces, next), room), "knit-along/next");
}

}  // namespace

std::int32_t current_round(const PanelFrame& frame) {
  if (frame.session.view->gaze.knit_along) return *frame.session.view->gaze.knit_along;
  return current_row(frame);
}

void wish_round(PanelFrame& frame, std::int32_t number, std::int16_t deal) {
  wish_row(frame, number);
  if (frame.session.view->gaze.knit_along) frame.wish(KnitAlong{number, deal});
}

void draw_knit_along(PanelFrame& frame) {
  const auto& along = frame.session.view->gaze.knit_along;
  if (!along || frame.timeline() == nullptr) return;
  ChartCache& cache = frame.own<ChartCache>();
  cache.refresh(frame.session);
  const std::int32_t last = cache.last_row();
  const Box& view = frame.layout.view;
  const float margin = frame.units(14.0f);
  ImGui::SetNextWindowPos(ImVec2(view.x + margin, view.bottom() - margin), ImGuiCond_Always,
                          ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSize(ImVec2(view.width - 2.0f * margin, 0.0f));
  push_raised_look(frame);
  ImGui::Begin("KnitAlong", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  if (cache.in_pieces() && cache.has_pattern()) {
    draw_pieces_along(frame, cache, *along);
  } else if (last == 0) {
    faint_text(cache.in_pieces() ? "Pieces are knitted along once the run is worked out to its end."
                                 : "There is nothing to knit yet: the stitches have no labels.");
  } else {
    const std::int32_t round = std::clamp(*along, 1, last);
    draw_turning(frame, cache, round);
    draw_round_line(frame, cache.line_of(round));
    draw_strip(frame, cache.chart().rows[cache.stitches().chart_row_of(round)]);
    draw_rhythm(frame, cache, round);
  }
  ImGui::End();
}

}  // namespace app
