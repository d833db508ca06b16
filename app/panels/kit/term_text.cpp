#include "app/panels/kit/term_text.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/explain/window_words.h"
#include "app/panels/kit/widgets.h"

namespace app {

namespace {

constexpr std::size_t most_texts_kept = 512;

const std::vector<TermAt>& terms_of(TermCache& cache, std::string_view words) {
  const auto known = cache.texts.find(words);
  if (known != cache.texts.end()) return known->second;
  // Sentences come and go as one steps; old ones are not missed.
  if (cache.texts.size() >= most_texts_kept) cache.texts.clear();
  return cache.texts.emplace(std::string(words), terms_in(words)).first->second;
}

float width_of(std::string_view words) {
  return ImGui::GetFont()
      ->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0f, words.data(), words.data() + words.size())
      .x;
}

void show_meaning(PanelFrame& frame, const Term& term, const Box& item) {
  constexpr std::string_view click = "Click: the glossary";
  const auto size_of = [](std::string_view words) {
    return ImGui::CalcTextSize(words.data(), words.data() + words.size());
  };
  const std::string word = with_capital(std::string(term.word));
  const std::string lines = wrapped_at_blanks(term.meaning, tip_width(frame));
  push_font(frame.fonts.strong);
  const ImVec2 head = size_of(word);
  pop_font();
  const ImVec2 meaning = size_of(lines), foot = size_of(click);
  begin_tip(frame, item,
            ImVec2(std::max({head.x, meaning.x, foot.x}),
                   head.y + meaning.y + foot.y + 2.0f * ImGui::GetStyle().ItemSpacing.y));
  push_font(frame.fonts.strong);
  text(word);
  pop_font();
  text(lines);
  faint_text(click);
  ImGui::EndTooltip();
}

// Where a line of a wrapped text ends, and where the next one begins.
struct LineBreak {
  std::size_t end = 0, next = 0;
};

// At blanks and line feeds; a word wider than the line has one for itself.
LineBreak break_line(std::string_view words, std::size_t begin, float width) {
  LineBreak found{begin, begin};
  for (std::size_t at = begin; at <= words.size(); ++at) {
    const bool last = at == words.size() || words[at] == '\n';
    if (!last && !may_break(words, at)) continue;
    const bool fits = width_of(words.substr(begin, at - begin)) <= width;
    if (!fits && found.end > begin) return found;
    found = {at, at < words.size() ? at + 1 : at};
    if (last || !fits) return found;
  }
  return found;
}

// A part of a term that stands on one line.
struct Piece {
  const Term* term;
  ImVec2 low, high;
};

void draw_piece(PanelFrame& frame, const Piece& piece) {
  const std::string name = "term/" + std::string(piece.term->word);
  const Box box{piece.low.x, piece.low.y, piece.high.x - piece.low.x, piece.high.y - piece.low.y};
  if (ImGui::IsRectVisible(piece.low, piece.high)) frame.memory.controls.insert_or_assign(name, box);
  const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(piece.low, piece.high);
  const float y = std::floor(piece.high.y) - 1.0f;
  const float thick = std::max(1.0f, std::floor(frame.units(1.0f)));
  const Colour colour = hovered ? theme().accent : theme().faint_text;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(piece.low.x, y), ImVec2(piece.high.x, y + thick),
                                            style::packed(colour, hovered ? 255 : 110));
  if (!hovered) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) show_meaning(frame, *piece.term, box);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
    frame.wish(ShowGlossary{true, std::string(piece.term->word)});
}

// Draws one line and adds what of the terms stands on it.
void draw_line(std::string_view words, std::size_t begin, std::size_t end, const std::vector<TermAt>& terms,
               std::vector<Piece>& pieces) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  text(words.substr(begin, end - begin));
  for (const TermAt& term : terms) {
    const std::size_t low = std::max(begin, term.begin);
    const std::size_t high = std::min(end, term.end);
    if (low >= high) continue;
    const float left = at.x + width_of(words.substr(begin, low - begin));
    const float right = at.x + width_of(words.substr(begin, high - begin));
    pieces.push_back({term.term, ImVec2(left, at.y), ImVec2(right, at.y + ImGui::GetTextLineHeight())});
  }
}

}  // namespace

void glossary_wrapped_text(PanelFrame& frame, std::string_view words) {
  glossary_wrapped_text(frame, words, theme().text);
}

void glossary_wrapped_text(PanelFrame& frame, std::string_view words, Colour colour) {
  const std::string shown = in_window_words(words);
  const std::vector<TermAt>& terms = terms_of(frame.own<TermCache>(), shown);
  const float width = ImGui::GetContentRegionAvail().x;
  std::vector<Piece> pieces;
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, style::vector(colour));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, 0.0f));
  for (std::size_t begin = 0; begin < shown.size();) {
    const LineBreak line = break_line(shown, begin, width);
    draw_line(shown, begin, line.end, terms, pieces);
    begin = line.next;
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::EndGroup();
  for (const Piece& piece : pieces) draw_piece(frame, piece);
}

void explains(PanelFrame& frame, std::string_view word) {
  const Term* term = find_term(word);
  if (term == nullptr || !ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) show_meaning(frame, *term, tipped_item(frame));
  if (ImGui::IsItemClicked()) frame.wish(ShowGlossary{true, std::string(term->word)});
}

void explained_tooltip(PanelFrame& frame, const std::string& help, std::string_view words, float free_below) {
  Box item = tipped_item(frame);
  item.height += free_below;
  const std::vector<TermAt>& terms = terms_of(frame.own<TermCache>(), words);
  const std::string word(terms.empty() ? "" : terms.front().term->word);
  if (wants_tooltip())
    tooltip_about(frame, item, word.empty() ? help : help + "\n\nClick: " + word + " in the glossary.");
  if (word.empty()) return;
  if (ImGui::IsItemClicked()) frame.wish(ShowGlossary{true, word});
}

}  // namespace app
