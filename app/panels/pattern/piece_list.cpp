#include "app/panels/pattern/piece_list.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/panels/kit/style.h"
#include "app/panels/kit/ways.h"
#include "app/session/view.h"
#include "knit/model/words.h"
#include "knit/pattern/limb_words.h"

namespace app {

namespace {

constexpr float row_height = 24.0f;      // plain units
constexpr float most_rows_seen = 10.5f;  // half a row says that there are more

// Where a row's parts stand, from the list's left edge, in window units.
struct PieceColumns {
  float width, name, rounds, stitches, twins, down, up;
};

PieceColumns columns_of(const PanelFrame& frame, float width) {
  const float side = frame.units(20.0f);
  PieceColumns columns{};
  columns.width = width;
  columns.up = width - side;
  columns.down = columns.up - side;
  columns.twins = columns.down - frame.units(8.0f);  // right edges of what is a number
  columns.stitches = columns.twins - frame.units(62.0f);
  columns.rounds = columns.stitches - frame.units(54.0f);
  columns.name = frame.units(34.0f);
  return columns;
}

void refresh_names(const ChartCache& cache, PieceList& list) {
  const knit::LimbPlan& plan = cache.pieces().plan;
  if (list.shown == cache.key() && list.names.size() == plan.pieces.size()) return;
  list.shown = cache.key();
  list.names.resize(plan.pieces.size());
  const knit::LimbNames names(plan, cache.pieces().options);
  for (std::int32_t i = 0; i < plan.count(); ++i) list.names[static_cast<std::size_t>(i)].set(names.word(i));
}

RoundSpan rows_of(const knit::LimbPiece& piece) { return {piece.rows.front(), piece.rows.back()}; }

// Twins that are called alike go on being called alike, so that they are still written once.
void name_piece(PanelFrame& frame, const PlannedPieces& pieces, std::int32_t piece,
                const std::string& typed) {
  const knit::LimbNames names(pieces.plan, pieces.options);
  const std::string word = with_capital(typed);
  std::string& trouble = frame.own<PieceList>().trouble;
  if (word == names.word(piece)) return trouble.clear();
  if (!word.empty() && !knit::is_piece_word(word)) {
    trouble = "A piece cannot be called \"" + typed + "\"; give one word of letters: Tail.";
    frame.own<PieceList>().shown = 0;
    return;
  }
  trouble.clear();
  SetPieceNames wish;
  for (const std::int32_t twin : pieces.plan.piece(piece).twins) {
    if (names.word(twin) == names.word(piece))
      wish.names[pieces.letters[static_cast<std::size_t>(twin)]] = word;
  }
  frame.own<PieceList>().shown = 0;
  frame.wish(wish);
}

void order_pieces(PanelFrame& frame, const PlannedPieces& pieces, const std::vector<std::string>& order) {
  if (order == pieces.letters) return;
  std::string& trouble = frame.own<PieceList>().trouble;
  trouble.clear();
  if (auto why = why_not_in_order(pieces, order))
    trouble = std::move(*why);
  else
    frame.wish(SetPieceOrder{order});
}

// Alt with an arrow, while the name has the keyboard, which goes along.
void move_by_key(PanelFrame& frame, const PlannedPieces& pieces, std::int32_t piece) {
  if (!ImGui::GetIO().KeyAlt) return;
  const bool up = ImGui::IsKeyPressed(ImGuiKey_UpArrow), down = ImGui::IsKeyPressed(ImGuiKey_DownArrow);
  if ((!up || piece == 0) && (!down || piece + 1 == pieces.plan.count())) return;
  order_pieces(frame, pieces, moved_piece(pieces, piece, up ? piece - 1 : piece + 2));
  if (frame.own<PieceList>().trouble.empty()) frame.own<PieceList>().focus = up ? piece - 1 : piece + 1;
}

// --- one row -----------------------------------------------------------------------------------------------------

// "make 2" at the first of those made together, "as B" at other twins.
std::string twin_words(const ChartCache& cache, std::int32_t piece) {
  for (const knit::PieceFacts& facts : cache.pattern().pieces) {
    if (facts.pieces.size() < 2 || std::count(facts.pieces.begin(), facts.pieces.end(), piece) == 0) continue;
    if (facts.pieces.front() == piece) return "make " + std::to_string(facts.pieces.size());
    return "as " + knit::tube_name(facts.pieces.front());
  }
  const std::int32_t first = cache.pieces().plan.piece(piece).twins.front();
  return first == piece ? "" : "as " + knit::tube_name(first);
}

void draw_row_ground(const PanelFrame& frame, const knit::LimbPiece& piece, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + width, at.y + frame.units(row_height));
  const RoundSpan rows = rows_of(piece);
  const std::vector<RoundSpan> all_meant = all_rounds_meant(frame.session);
  const bool is_meant = std::any_of(all_meant.begin(), all_meant.end(), [&](const RoundSpan& meant) {
    return meant.first <= rows.last && rows.first <= meant.last;
  });
  const auto& along = frame.session.view->gaze.knit_along;
  const bool at_hand = rows.holds(along ? *along : current_row(frame));
  if (is_meant) list.AddRectFilled(at, end, style::packed(theme().hovered), frame.units(4.0f));
  if (at_hand)
    list.AddRectFilled(at, ImVec2(at.x + frame.units(3.0f), end.y), style::packed(theme().anchor),
                       frame.units(1.5f));
}

// The letter is what the hand takes hold of.
void draw_handle(PanelFrame& frame, const PlannedPieces& pieces, std::int32_t piece, ImVec2 at) {
  const std::string letter = knit::tube_name(piece);
  const ImVec2 size(frame.units(26.0f), frame.units(row_height));
  ImGui::SetCursorScreenPos(ImVec2(at.x + frame.units(4.0f), at.y));
  ImGui::InvisibleButton("handle", size);
  frame.mark("piece/" + letter + "/handle");
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, frame.units(3.0f)))
    frame.own<PieceList>().dragged = piece;
  const bool hot = ImGui::IsItemHovered() || frame.own<PieceList>().dragged == piece;
  if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  tooltip(frame, "Drag " + pieces.name_of(piece) + " to another place in the order of working.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // Three short lines: it can be moved.
  const float middle = std::floor(at.y + 0.5f * size.y);
  for (const float line : {-3.0f, 0.0f, 3.0f}) {
    const float y = middle + frame.units(line);
    list.AddLine(ImVec2(at.x + frame.units(6.0f), y), ImVec2(at.x + frame.units(13.0f), y),
                 style::packed(hot ? theme().text : theme().outline), frame.units(1.0f));
  }
  push_font(frame.fonts.strong);
  text_at(ImVec2(at.x + frame.units(17.0f), at.y + frame.units(4.0f)), 0.0f, theme().text, letter);
  pop_font();
}

void draw_name(PanelFrame& frame, const PlannedPieces& pieces, std::int32_t piece, ImVec2 at,
               const PieceColumns& columns) {
  const std::string letter = knit::tube_name(piece);
  ImGui::SetCursorScreenPos(ImVec2(at.x + columns.name, at.y + frame.units(1.0f)));
  ImGui::SetNextItemWidth(std::max(frame.units(40.0f), columns.rounds - columns.name - frame.units(52.0f)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(frame.units(4.0f), frame.units(3.0f)));
  PieceList& list = frame.own<PieceList>();
  if (list.focus == piece) {
    ImGui::SetKeyboardFocusHere();
    list.focus = -1;
  }
  TextBuffer& buffer = list.names[static_cast<std::size_t>(piece)];
  ImGui::InputText("##name", buffer.bytes.data(), 25, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
  frame.mark("piece/" + letter + "/name");
  if (ImGui::IsItemDeactivatedAfterEdit()) name_piece(frame, pieces, piece, buffer.text());
  if (ImGui::IsItemActive()) move_by_key(frame, pieces, piece);
  tooltip(frame,
          "What it is called in the pattern: one word; empty, as the program calls it. Alt with an arrow "
          "moves it up or "
          "down.");
}

void draw_piece_numbers(const PanelFrame& frame, const ChartCache& cache, std::int32_t piece, ImVec2 at,
                        const PieceColumns& columns) {
  const float y = at.y + frame.units(4.0f);
  const knit::LimbPiece& own = cache.pieces().plan.piece(piece);
  text_at(ImVec2(at.x + columns.rounds, y), 1.0f, theme().faint_text,
          knit::plural(own.round_count(), "rnd", "rnds"));
  text_at(ImVec2(at.x + columns.stitches, y), 1.0f, theme().faint_text,
          knit::plural(own.last_count(), "st", "sts"));
  text_at(ImVec2(at.x + columns.twins, y), 1.0f, theme().faint_text, twin_words(cache, piece));
}

void draw_arrow(PanelFrame& frame, const PlannedPieces& pieces, std::int32_t piece, bool up, ImVec2 at) {
  const std::int32_t to = up ? piece - 1 : piece + 2;
  const bool there = up ? piece > 0 : piece + 1 < pieces.plan.count();
  if (!there) return;
  const std::vector<std::string> order = moved_piece(pieces, piece, to);
  const auto why = why_not_in_order(pieces, order);
  const float side = frame.units(20.0f);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + frame.units(2.0f)));
  if (ImGui::InvisibleButton(up ? "up" : "down", ImVec2(side, side))) order_pieces(frame, pieces, order);
  frame.mark("piece/" + knit::tube_name(piece) + (up ? "/up" : "/down"));
  const bool hot = ImGui::IsItemHovered() && !why;
  tooltip(frame, why ? *why : up ? "Work it earlier." : "Work it later.");
  const float tip = frame.units(up ? -3.0f : 3.0f);
  const ImVec2 middle(at.x + 0.5f * side, at.y + 0.5f * frame.units(row_height));
  const float half = frame.units(4.0f);
  const ImU32 colour = style::packed(why ? theme().outline : hot ? theme().accent : theme().faint_text);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PathLineTo(ImVec2(middle.x - half, middle.y - tip * 0.7f));
  list.PathLineTo(ImVec2(middle.x, middle.y + tip));
  list.PathLineTo(ImVec2(middle.x + half, middle.y - tip * 0.7f));
  list.PathStroke(colour, ImDrawFlags_None, frame.units(1.5f));
}

// It and those that are made together with it.
void mean_piece(PanelFrame& frame, const ChartCache& cache, std::int32_t piece) {
  const knit::LimbPlan& plan = cache.pieces().plan;
  frame.rounds_under = rows_of(plan.piece(piece));
  for (const knit::PieceFacts& facts : cache.pattern().pieces) {
    if (std::count(facts.pieces.begin(), facts.pieces.end(), piece) == 0) continue;
    for (const std::int32_t twin : facts.pieces) {
      if (twin != piece) frame.twins_under.push_back(rows_of(plan.piece(twin)));
    }
  }
}

void draw_piece(PanelFrame& frame, const ChartCache& cache, std::int32_t piece, const PieceColumns& columns) {
  const PlannedPieces& pieces = cache.pieces();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + columns.width, at.y + frame.units(row_height));
  ImGui::PushID(piece);
  draw_row_ground(frame, pieces.plan.piece(piece), at, columns.width);
  draw_handle(frame, pieces, piece, at);
  draw_name(frame, pieces, piece, at, columns);
  draw_piece_numbers(frame, cache, piece, at, columns);
  draw_arrow(frame, pieces, piece, true, ImVec2(at.x + columns.up, at.y));
  draw_arrow(frame, pieces, piece, false, ImVec2(at.x + columns.down, at.y));
  if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
      ImGui::IsMouseHoveringRect(at, end))
    mean_piece(frame, cache, piece);
  ImGui::PopID();
  ImGui::SetCursorScreenPos(ImVec2(at.x, end.y));
}

// --- all rows ----------------------------------------------------------------------------------------------------

// Where the dragged piece would go: a line between two rows. Let go there, it does, or it is said why not.
void drag_piece(PanelFrame& frame, const PlannedPieces& pieces, ImVec2 top, float width) {
  PieceList& list = frame.own<PieceList>();
  if (list.dragged < 0) return;
  const float height = frame.units(row_height);
  const float over = (ImGui::GetIO().MousePos.y - top.y) / height;
  const auto to = static_cast<std::int32_t>(
      std::clamp(std::floor(over + 0.5f), 0.0f, static_cast<float>(pieces.plan.count())));
  const std::vector<std::string> order = moved_piece(pieces, list.dragged, to);
  const auto why = why_not_in_order(pieces, order);
  list.trouble = why.value_or("");
  const float y = top.y + height * static_cast<float>(to);
  ImGui::GetWindowDrawList()->AddLine(ImVec2(top.x, y), ImVec2(top.x + width, y),
                                      style::packed(why ? theme().problem : theme().accent),
                                      frame.units(2.0f));
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  list.dragged = -1;
  order_pieces(frame, pieces, order);
}

void draw_pieces(PanelFrame& frame, const ChartCache& cache) {
  const PlannedPieces& pieces = cache.pieces();
  const std::int32_t count = pieces.plan.count();
  const float height = frame.units(row_height) * std::min(static_cast<float>(count), most_rows_seen);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("piece rows", ImVec2(0.0f, height + frame.units(2.0f)), false);
  ImGui::PopStyleVar();
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const PieceColumns columns = columns_of(frame, ImGui::GetContentRegionAvail().x);
  for (std::int32_t piece = 0; piece < count; ++piece) draw_piece(frame, cache, piece, columns);
  drag_piece(frame, pieces, top, columns.width);
  ImGui::EndChild();
  frame.mark("pieces/rows");
}

// What the order takes, and the way back to the cheapest.
void draw_order(PanelFrame& frame, const PlannedPieces& pieces) {
  const PieceList& list = frame.own<PieceList>();
  if (!list.trouble.empty()) wrapped_text(list.trouble, theme().problem);
  if (!pieces.refused.empty() && list.trouble.empty())
    wrapped_text("The order that was asked for cannot be worked. " + pieces.refused, theme().problem);
  if (!pieces.chosen && pieces.refused.empty()) return;
  if (pieces.chosen) wrapped_text(order_price(pieces));
  if (ImGui::Button("Cheapest order")) frame.wish(SetPieceOrder{});
  frame.mark("pieces/cheapest");
  tooltip(frame, "Back to the order that takes the fewest yarns and holders.");
}

std::string summary_of(const knit::LimbPlan& plan) {
  return knit::plural(plan.yarns, "yarn", "yarns") + ", " + knit::plural(plan.held_most, "holder", "holders");
}

}  // namespace

std::vector<std::string> moved_piece(const PlannedPieces& pieces, std::int32_t from, std::int32_t to) {
  std::vector<std::string> order = pieces.letters;
  const auto at = order.begin() + from;
  const auto place = order.begin() + to;
  if (to > from)
    std::rotate(at, at + 1, place);
  else
    std::rotate(place, at, at + 1);
  return order;
}

void draw_piece_list(PanelFrame& frame, const ChartCache& cache) {
  PieceList& list = frame.own<PieceList>();
  const PlannedPieces& pieces = cache.pieces();
  refresh_names(cache, list);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemOpen(list.open);
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(theme().faint_text));
  push_font(frame.fonts.strong);
  list.open = ImGui::TreeNodeEx("Pieces, in working order",
                                ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_FramePadding);
  pop_font();
  ImGui::PopStyleColor();
  frame.mark("pieces");
  const float y = ImGui::GetItemRectMin().y + ImGui::GetStyle().FramePadding.y;
  text_at(ImVec2(right, y), 1.0f, theme().faint_text, summary_of(pieces.plan));
  if (!list.open) return;
  draw_pieces(frame, cache);
  draw_order(frame, pieces);
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
}

}  // namespace app
