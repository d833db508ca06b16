#include "app/panels/pattern/chart_bands.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern.h"
#include "app/panels/pattern/pattern_parts.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>

#include "app/describe/chart_strokes.h"
#include "app/panels/kit/style.h"
#include "app/panels/kit/widgets.h"
#include "app/session/chart_twins.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/limb_chart.h"

namespace app {

namespace {

knit::Label label_of(knit::ChartSymbol symbol) {
  switch (symbol) {
    case knit::ChartSymbol::m1r:
      return knit::Label::m1r;
    case knit::ChartSymbol::m1l:
      return knit::Label::m1l;
    case knit::ChartSymbol::k2tog:
      return knit::Label::k2tog;
    case knit::ChartSymbol::ssk:
      return knit::Label::ssk;
    case knit::ChartSymbol::cast_on:
    case knit::ChartSymbol::bind_off:
      return knit::Label::cast;
    case knit::ChartSymbol::no_stitch:
    case knit::ChartSymbol::knit:
    case knit::ChartSymbol::kept:
    case knit::ChartSymbol::held:
    case knit::ChartSymbol::picked_up:
    case knit::ChartSymbol::on_holder:
    case knit::ChartSymbol::grafted:
    case knit::ChartSymbol::marked:
    case knit::ChartSymbol::turn_left:
    case knit::ChartSymbol::turn_right:
      break;
  }
  return knit::Label::knit;
}

Colour ground_of(const knit::ChartSquare& square, bool lit) {
  if (knit::has_no_stitch(square.symbol)) return theme().hovered;
  if (lit) return theme().lit_paper;
  return square.main ? theme().main_paper : theme().paper;
}

// Strokes that go on one from another are one line.
void draw_symbol(ImDrawList& list, ImVec2 low, float side, ImU32 colour, knit::ChartSymbol symbol) {
  const auto at = [&](const ChartPoint& point) {
    return ImVec2(low.x + static_cast<float>(point.x) * side, low.y + static_cast<float>(point.y) * side);
  };
  const std::span<const ChartStroke> strokes = shape_of(symbol).strokes;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const ChartStroke& stroke = strokes[i];
    if (i == 0 || strokes[i - 1].to != stroke.from) list.PathLineTo(at(stroke.from));
    if (stroke.bend) {
      list.PathBezierQuadraticCurveTo(at(*stroke.bend), at(stroke.to));
    } else {
      list.PathLineTo(at(stroke.to));
    }
    if (i + 1 == strokes.size() || strokes[i + 1].from != stroke.to)
      list.PathStroke(colour, ImDrawFlags_None, 0.1f * side + 0.6f);
  }
}

// Of the holder that a stitch is on.
void draw_letter(ImDrawList& list, ImVec2 low, float side, std::int32_t piece) {
  const std::string letter = knit::tube_name(piece);
  const float size = std::min(0.8f * side, ImGui::GetFontSize());
  const ImVec2 words = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0.0f, letter.c_str());
  list.AddText(ImGui::GetFont(), size,
               ImVec2(low.x + 0.5f * (side - words.x), low.y + 0.5f * (side - words.y)),
               style::packed(theme().ink_of(knit::Label::knit)), letter.c_str());
}

}  // namespace

void draw_square(ImDrawList& list, ImVec2 low, const knit::ChartSquare& square, const SquareLook& look) {
  const float gap = look.side >= 5.0f ? 1.0f : 0.0f;
  const ImVec2 high(low.x + look.side - gap, low.y + look.side - gap);
  // The lines between squares: the ground alone would not part pale squares in the light theme.
  if (gap > 0.0f)
    list.AddRectFilled(low, ImVec2(low.x + look.side, low.y + look.side), style::packed(theme().outline));
  list.AddRectFilled(low, high, style::packed(ground_of(square, look.lit)));
  if (look.side >= 5.0f) {
    const Colour ink = theme().ink_of(label_of(square.symbol));
    draw_symbol(list, low, look.side - gap, style::packed(ink), square.symbol);
    if (square.symbol == knit::ChartSymbol::held) draw_letter(list, low, look.side - gap, square.piece);
  } else if (label_of(square.symbol) != knit::Label::knit) {
    list.AddRectFilled(low, high, style::packed(theme().of(label_of(square.symbol))));
  }
  if (look.hovered) list.AddRect(low, high, style::packed(theme().accent), 0.0f, 0, 2.0f);
}

// The chart in the centre: zoomed, moved, and linked with the view and the timeline.

namespace {

// Where squares stand on the screen. Column 0 is the right edge, the first row the lowest of each band.
struct Sheet {
  const knit::Chart& chart;
  const knit::PieceChart* piece;        // null: the whole pattern is one chart
  const knit::LimbPlan* plan;           // of which the piece is
  const knit::ChartStitches* stitches;  // of the whole pattern
  ChartBands bands;
  ImVec2 low;  // of all bands

  // The fabric's row that a row of the chart is; 0: none's, it knits nothing.
  [[nodiscard]] std::int32_t round_of(std::size_t row) const {
    if (piece != nullptr) return piece->rows[row];
    return row + 1 < chart.rows.size() ? stitches->row(row) : 0;
  }
  // The stitch of the fabric; nothing where there is none.
  [[nodiscard]] std::optional<StitchAt> stitch_at(std::size_t row, const knit::ChartSquare& square) const {
    if (square.stitch < 0 || round_of(row) == 0) return std::nullopt;
    if (piece == nullptr) {
      const auto found = stitches->stitch(row, square);
      return found ? std::optional(StitchAt{found->row, found->stitch}) : std::nullopt;
    }
    if (chart.rows[row].short_row != 0) {
      const knit::ShortRowPlace over =
          knit::place_of(plan->piece(piece->pieces.front()), chart.rows[row], square);
      return over.row == 0 ? std::nullopt : std::optional(StitchAt{over.row, over.stitch});
    }
    const knit::PiecePlace place = piece->place(row, square.stitch);
    return StitchAt{place.row, place.stitch};
  }

  // Of twins that are made together the chart has the first's rows.
  [[nodiscard]] std::int32_t own_row(std::int32_t row) const {
    return piece != nullptr ? row_in_first(*plan, piece->pieces, row) : row;
  }
  [[nodiscard]] std::vector<StitchAt> in_each(const StitchAt& at) const {
    return piece != nullptr ? stitch_in_each(*plan, piece->pieces, at) : std::vector<StitchAt>{};
  }

  [[nodiscard]] ImVec2 at(std::size_t row, std::size_t column) const {
    const ChartBands::Place place = bands.at(row, column);
    return {low.x + place.x, low.y + place.y};
  }
  [[nodiscard]] float side() const { return bands.side; }
  // The columns that a band begins and ends with.
  [[nodiscard]] std::size_t first_of(std::size_t band) const { return band * bands.each; }
  [[nodiscard]] std::size_t last_of(std::size_t band) const {
    return first_of(band) + bands.columns_in(band) - 1;
  }
};

struct SquarePlace {
  std::size_t row = 0, column = 0;
};

std::optional<SquarePlace> square_under(const Sheet& sheet, ImVec2 pointer) {
  for (std::size_t band = 0; band < sheet.bands.count; ++band) {
    const ImVec2 low = sheet.at(sheet.bands.rows - 1, sheet.last_of(band));
    const float x = (pointer.x - low.x) / sheet.side(), y = (pointer.y - low.y) / sheet.side();
    const auto columns = static_cast<float>(sheet.bands.columns_in(band));
    const auto rows = static_cast<float>(sheet.bands.rows);
    if (x < 0.0f || y < 0.0f || x >= columns || y >= rows) continue;
    return SquarePlace{static_cast<std::size_t>(rows - 1.0f - std::floor(y)),
                       sheet.last_of(band) - static_cast<std::size_t>(std::floor(x))};
  }
  return std::nullopt;
}

// Wide charts of pieces are broken, as on paper; that of a shape without limbs is seen as a whole.
ChartBands bands_of(const PanelFrame& frame, const knit::Chart& chart, bool piece, const Box& box) {
  ChartRoom room;
  room.width = box.width - frame.units(110.0f);
  room.height = box.height - frame.units(40.0f);
  room.gap = ImGui::GetTextLineHeight() + frame.units(12.0f);
  room.legible = piece ? frame.units(9.0f) : 0.0f;
  room.largest = frame.units(28.0f);
  return bands_for(static_cast<std::size_t>(std::max(1, chart.columns)), chart.rows.size(), room);
}

void handle_zoom_and_drag(PanelFrame& frame, const Box& box) {
  ChartView& view = frame.own<ChartView>();
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    view.move.x += io.MouseDelta.x;
    view.move.y += io.MouseDelta.y;
  }
  if (!ImGui::IsItemHovered()) return;
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) view = {};
  if (io.MouseWheel == 0.0f) return;
  const float factor = std::clamp(view.zoom * std::pow(1.15f, io.MouseWheel), 0.2f, 30.0f) / view.zoom;
  const ImVec2 middle(box.x + 0.5f * box.width, box.y + 0.5f * box.height);
  // What is under the pointer stays there.
  view.move.x = (1.0f - factor) * (io.MousePos.x - middle.x) + factor * view.move.x;
  view.move.y = (1.0f - factor) * (io.MousePos.y - middle.y) + factor * view.move.y;
  view.zoom *= factor;
}

// Beside every band, as on paper; the counts beside the last.
// At the side where it begins, where there is room for a line.
void draw_short_row_number(const PanelFrame& frame, const Sheet& sheet, std::size_t row, float height) {
  if (sheet.side() < height) return;
  const knit::ChartRow& round = sheet.chart.rows[row];
  const std::string words = knit::name_of(round);
  const float down = 0.5f * (sheet.side() - height), gap = frame.units(6.0f);
  const ImVec2 right = sheet.at(row, 0), left = sheet.at(row, sheet.bands.columns - 1);
  const float x =
      round.wrong_side ? left.x - ImGui::CalcTextSize(words.c_str()).x - gap : right.x + sheet.side() + gap;
  ImGui::GetWindowDrawList()->AddText(ImVec2(x, (round.wrong_side ? left.y : right.y) + down),
                                      style::packed(theme().faint_text), words.c_str());
}

void draw_numbers(const PanelFrame& frame, const Sheet& sheet, std::size_t row) {
  const float needed = ImGui::GetTextLineHeight();
  const auto every = static_cast<std::size_t>(std::max(1.0f, std::ceil(needed / sheet.side())));
  const knit::ChartRow& round = sheet.chart.rows[row];
  if (sheet.piece != nullptr && sheet.round_of(row) == 0 && round.short_row == 0) return;
  if (round.short_row > 0) return draw_short_row_number(frame, sheet, row, needed);
  const std::int32_t hand = current_round(frame);
  const std::int32_t number = sheet.round_of(row) > 0 ? sheet.round_of(row) : round.number;
  const bool current = number == hand;
  // The current round is always numbered; its neighbours give way.
  const bool crowded = std::abs(number - hand) < static_cast<std::int32_t>(every);
  if (!current && (row % every != 0 || crowded)) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = style::packed(current ? theme().anchor : theme().faint_text);
  const std::string words = knit::name_of(round);
  const float down = 0.5f * (sheet.side() - needed);
  for (std::size_t band = 0; band < sheet.bands.count; ++band) {
    const ImVec2 right = sheet.at(row, sheet.first_of(band));
    list.AddText(ImVec2(right.x + sheet.side() + frame.units(6.0f), right.y + down), colour, words.c_str());
  }
  const std::string count = std::to_string(round.stitches);
  const float width = ImGui::CalcTextSize(count.c_str()).x;
  const ImVec2 left = sheet.at(row, sheet.bands.columns - 1);
  list.AddText(ImVec2(left.x - width - frame.units(6.0f), left.y + down), colour, count.c_str());
}

// Over the numbers: of what they are.
void draw_heads(const PanelFrame& frame, const Sheet& sheet) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = style::packed(theme().faint_text);
  const std::size_t top = sheet.bands.rows - 1;
  const float up = ImGui::GetTextLineHeight() + frame.units(3.0f);
  for (std::size_t band = 0; band < sheet.bands.count; ++band) {
    const ImVec2 right = sheet.at(top, sheet.first_of(band));
    list.AddText(ImVec2(right.x + sheet.side() + frame.units(6.0f), right.y - up), colour, "Rnd");
  }
  const char* counts = "Sts";
  const float width = ImGui::CalcTextSize(counts).x;
  const ImVec2 left = sheet.at(top, sheet.bands.columns - 1);
  list.AddText(ImVec2(left.x - width - frame.units(6.0f), left.y - up), colour, counts);
}

// "Columns 1 to 70 of 127", above each band; nothing where the chart is whole, or so small that it has no room. `more`: not all
// bands are in sight.
void draw_band_words(const Sheet& sheet, bool more) {
  if (sheet.bands.gap < ImGui::GetTextLineHeight()) return;
  for (std::size_t band = 0; band < sheet.bands.count; ++band) {
    std::string words = "Columns " + std::to_string(sheet.first_of(band) + 1) + " to " +
                        std::to_string(sheet.last_of(band) + 1) + " of " +
                        std::to_string(sheet.bands.columns);
    if (more && band == 0) words += "; drag the chart to see the others";
    const ImVec2 low = sheet.at(sheet.bands.rows - 1, sheet.last_of(band));
    const float free = sheet.bands.gap - ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddText(ImVec2(low.x, low.y - sheet.bands.gap + 0.6f * free),
                                        style::packed(theme().faint_text), words.c_str());
  }
}

void draw_squares(const PanelFrame& frame, const Sheet& sheet, const Box& box,
                  std::optional<StitchAt> hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::int32_t current = sheet.own_row(current_round(frame));
  if (hovered) {
    const std::vector<StitchAt> each = sheet.in_each(*hovered);
    if (!each.empty()) hovered = each.front();
  }
  for (std::size_t row = 0; row < sheet.chart.rows.size(); ++row) {
    const knit::ChartRow& round = sheet.chart.rows[row];
    const bool lit = sheet.round_of(row) == current && current > 0;
    for (std::size_t column = 0; column < round.squares.size(); ++column) {
      const ImVec2 low = sheet.at(row, column);
      if (low.y > box.bottom() || low.y + sheet.side() < box.y) continue;
      const knit::ChartSquare& square = round.squares[column];
      const bool here = hovered && hovered == sheet.stitch_at(row, square);
      draw_square(list, low, square, {sheet.side(), lit, here});
    }
    draw_numbers(frame, sheet, row);
  }
}

// Framed as one.
void draw_span(const PanelFrame& frame, const Sheet& sheet, const RoundSpan& span) {
  const RoundSpan rounds{sheet.own_row(span.first), sheet.own_row(span.last)};
  const auto in_span = [&](std::size_t row) {
    return sheet.round_of(row) > 0 && rounds.holds(sheet.round_of(row));
  };
  std::size_t first = 0;
  while (first < sheet.chart.rows.size() && !in_span(first)) ++first;
  if (first == sheet.chart.rows.size()) return;
  std::size_t last = first;
  while (last + 1 < sheet.chart.rows.size() && in_span(last + 1)) ++last;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t band = 0; band < sheet.bands.count; ++band) {
    const ImVec2 low = sheet.at(last, sheet.last_of(band)), high = sheet.at(first, sheet.first_of(band));
    const ImVec2 end(high.x + sheet.side(), high.y + sheet.side());
    list.AddRectFilled(low, end, style::packed(theme().accent, 50));
    list.AddRect(low, end, style::packed(theme().accent), frame.units(2.0f), 0, frame.units(2.0f));
  }
}

// The rounds of the text's line under the pointer. Of twins the chart has the first's rows.
void draw_hovered_rounds(const PanelFrame& frame, const Sheet& sheet) {
  const Gaze& gaze = frame.session.view->gaze;
  if (!gaze.hovered_rounds) return;
  draw_span(frame, sheet, *gaze.hovered_rounds);
  if (sheet.piece != nullptr) return;
  for (const RoundSpan& span : gaze.hovered_twins) draw_span(frame, sheet, span);
}

// What a square stands for: the label that shaped it, else its stitch.
knit::Element thing_of(const knit::Timeline& timeline, const StitchAt& at) {
  const knit::Join* join = timeline.furthest().fabric.join_into(at.row);
  const std::size_t cells = join != nullptr ? join->labels.size() : 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const auto cell = static_cast<std::int32_t>(i);
    if (knit::ends_of(*join, cell).above == at.stitch && join->labels[i] != knit::Label::knit)
      return knit::LabelElement{at.row, cell};
  }
  return knit::StitchElement{at.row, at.stitch};
}

void wish_why(PanelFrame& frame, const StitchAt& at) {
  const knit::Timeline& timeline = *frame.timeline();
  const knit::Element thing = thing_of(timeline, at);
  frame.wish(Select{thing});
  const auto step = knit::made_by(timeline, thing);
  if (!step) return wish_round(frame, at.row);
  frame.wish(SeekPlace{timeline.step(*step).place});
}

// "Rnd 7, stitch 3 of 12: k2tog", or of a row that knits nothing what a square there means.
std::string words_for(const Sheet& sheet, const SquarePlace& place) {
  const knit::ChartRow& round = sheet.chart.rows[place.row];
  const knit::ChartSquare& square = round.squares[place.column];
  std::string words = "Rnd " + std::to_string(round.number);
  if (round.home)
    words = "On to the beginning of the round before " + words;
  else if (round.short_row > 0)
    words = "Short row " + std::to_string(round.short_row) + " before " + words;
  if (round.laid) words = place.row == 0 ? "Before Rnd 1" : "At the end";
  if (sheet.stitch_at(place.row, square))
    words += ", stitch " + std::to_string(square.stitch + 1) + " of " + std::to_string(round.stitches);
  words += ": ";
  if (square.symbol == knit::ChartSymbol::held)
    words += "on the holder of " + knit::tube_name(square.piece);
  else
    words += knit::sign_of(square.symbol).meaning;
  return words + (square.main ? ", main" : "");
}

// The square under the pointer is shown everywhere; a click goes to the step that made what it stands for.
void handle_pointer(PanelFrame& frame, const Sheet& sheet) {
  std::optional<StitchAt> under;
  if (ImGui::IsItemHovered()) {
    if (const auto place = square_under(sheet, ImGui::GetIO().MousePos)) {
      under = sheet.stitch_at(place->row, sheet.chart.rows[place->row].squares[place->column]);
      const ImVec2 low = sheet.at(place->row, place->column);
      std::string words = words_for(sheet, *place);
      const std::string rhythm = frame.own<ChartCache>().rhythm_of(sheet.round_of(place->row));
      if (!rhythm.empty()) words += ".\n" + rhythm;
      tooltip_about(frame, {low.x, low.y, sheet.side(), sheet.side()}, words);
      const ImVec2 dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
      const bool clicked = ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                           std::hypot(dragged.x, dragged.y) <= frame.units(4.0f);
      const std::int32_t round = sheet.round_of(place->row);
      if (clicked && under) wish_why(frame, *under);
      if (clicked && round > 0 && !under) wish_round(frame, round);
    }
  }
  if (under == frame.session.view->gaze.hovered_stitch) return;
  std::vector<StitchAt> twins = under ? sheet.in_each(*under) : std::vector<StitchAt>{};
  if (!twins.empty()) twins.erase(twins.begin());  // the square's own
  frame.wish(HoverStitch{under, std::move(twins)});
}

// Which of the charts of pieces is shown: the one chosen (Gaze::chart_piece), or that of the round that came to hand since.
struct ShownPieceChart {
  std::size_t chart = 0;
  std::optional<std::int32_t> followed;
};

std::string letters_of(const knit::PieceChart& chart) {
  std::string letters;
  for (const std::int32_t piece : chart.pieces)
    letters += (letters.empty() ? "" : ", ") + knit::tube_name(piece);
  return letters;
}

// Buttons with the letters of the pieces, over the chart.
const knit::PieceChart& chosen_piece(PanelFrame& frame, const Box& box) {
  const ChartCache& cache = frame.own<ChartCache>();
  const std::vector<knit::PieceChart>& charts = cache.piece_charts();
  ShownPieceChart& shown = frame.own<ShownPieceChart>();
  const std::int32_t current = current_round(frame);
  const std::string& chosen = frame.session.view->gaze.chart_piece;
  const auto show = [&](const std::string& letters) {
    frame.wish(ShowCentre{frame.session.view->centre, letters});
  };
  if (current != shown.followed) {
    shown.chart = chart_with_row(charts, cache.pieces().plan, current).value_or(shown.chart);
    if (shown.followed && !chosen.empty()) show("");
  }
  shown.followed = current;
  shown.chart = chart_of_piece(charts, cache.pieces(), chosen).value_or(shown.chart);
  shown.chart = std::min(shown.chart, charts.size() - 1);
  ImGui::SetCursorPos(ImVec2(frame.units(10.0f), frame.units(8.0f)));
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::string letters = letters_of(charts[i]);
    const float width = ImGui::CalcTextSize(letters.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    if (i > 0 && ImGui::GetItemRectMax().x + width + frame.units(16.0f) < box.right()) ImGui::SameLine();
    if (i > 0 && ImGui::GetCursorPosX() < frame.units(10.0f)) ImGui::SetCursorPosX(frame.units(10.0f));
    if (lit_button(letters.c_str(), i == shown.chart))
      show(cache.pieces().letters[static_cast<std::size_t>(charts[i].pieces.front())]);
    frame.mark("chart/piece/" + knit::tube_name(charts[i].pieces.front()));
    tooltip(frame, ("The chart of " + cache.pieces().name_of(charts[i].pieces.front()) + ".").c_str());
  }
  return charts[shown.chart];
}

// Bands that are higher than the room begin at its top, or so much higher that the current round of the first is seen.
float lowered_by(const PanelFrame& frame, const Sheet& sheet, const Box& room) {
  const float margin = frame.units(20.0f), over = sheet.bands.height() + 2.0f * margin - room.height;
  if (over <= 0.0f || sheet.bands.count == 1) return 0.0f;
  float up = 0.0f;
  const std::int32_t current = sheet.own_row(current_round(frame));
  for (std::size_t row = 0; row < sheet.bands.rows; ++row) {
    if (current == 0 || sheet.round_of(row) != current) continue;
    const float bottom = margin + sheet.bands.at(row, 0).y + sheet.side() + margin;
    up = std::max(0.0f, bottom - room.height);
  }
  return 0.5f * over - up;
}

// Below what stands in the panel already.
void draw_sheet(PanelFrame& frame, const knit::Chart& chart, const knit::PieceChart* piece, const Box& box) {
  Box room = box;
  if (piece != nullptr) {
    const float taken = ImGui::GetItemRectMax().y + frame.units(6.0f) - box.y;
    room.y += taken;
    room.height = std::max(1.0f, room.height - taken);
    ImGui::SetCursorPos(ImVec2(0.0f, taken));
  }
  ImGui::InvisibleButton("chart", ImVec2(room.width, room.height));
  frame.mark("chart");
  handle_zoom_and_drag(frame, room);
  const ChartView& view = frame.own<ChartView>();
  const knit::LimbPlan* plan = piece != nullptr ? &frame.own<ChartCache>().pieces().plan : nullptr;
  const ChartBands bands = bands_of(frame, chart, piece != nullptr, room);
  Sheet sheet{chart, piece, plan, &frame.own<ChartCache>().stitches(), bands, {}};
  const float lower = view.zoom * lowered_by(frame, sheet, room);
  sheet.bands = bands.scaled(view.zoom);
  sheet.low = ImVec2(std::floor(room.x + 0.5f * (room.width - sheet.bands.width()) + view.move.x),
                     std::floor(room.y + 0.5f * (room.height - sheet.bands.height()) + lower + view.move.y));
  draw_squares(frame, sheet, room, frame.session.view->gaze.hovered_stitch);
  draw_heads(frame, sheet);
  draw_band_words(sheet, sheet.bands.height() > room.height);
  draw_hovered_rounds(frame, sheet);
  handle_pointer(frame, sheet);
}

}  // namespace

void draw_chart(PanelFrame& frame) {
  const Box& box = frame.layout.view;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  begin_panel("Chart", box, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  ChartCache& cache = frame.own<ChartCache>();
  if (frame.timeline() != nullptr) cache.refresh(frame.session);
  const bool pieces = frame.timeline() != nullptr && !cache.piece_charts().empty();
  if (frame.timeline() == nullptr || (!pieces && cache.chart().rows.empty())) {
    ImGui::SetCursorPos(ImVec2(frame.units(14.0f), frame.units(12.0f)));
    faint_text("The chart appears once the stitches have their labels.");
    ImGui::End();
    return;
  }
  const knit::PieceChart* piece = pieces ? &chosen_piece(frame, box) : nullptr;
  draw_sheet(frame, piece != nullptr ? piece->chart : cache.chart(), piece, box);
  ImGui::End();
}

}  // namespace app
