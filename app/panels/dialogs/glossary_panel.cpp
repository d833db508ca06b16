// The glossary: words at the left, what one means at the right. It stays open beside whatever is done meanwhile.
#include <algorithm>
#include <array>
#include <string>

#include "app/panels/dialogs/dialogs.h"
#include "app/panels/kit/term_text.h"
#include "app/panels/kit/widgets.h"
#include "app/session/view.h"

namespace app {

namespace {

struct GlossaryState {
  bool shown = false;
  std::array<char, 128> search{};
  std::string followed;  // the term that the list was last scrolled to
};

void go_to(PanelFrame& frame, const Term& term) { frame.wish(ShowGlossary{true, std::string(term.word)}); }

void draw_search(PanelFrame& frame) {
  GlossaryState& state = frame.own<GlossaryState>();
  // Opened at a word one reads on; opened as a whole one looks something up.
  if (!state.shown && frame.session.view->dialogs.glossary_term.empty()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", "Look up", state.search.data(), state.search.size());
  frame.mark("glossary/search");
}

void draw_words(PanelFrame& frame, const std::vector<const Term*>& found, const Term* shown) {
  GlossaryState& state = frame.own<GlossaryState>();
  ImGui::BeginChild("words", ImVec2(0.0f, 0.0f), true);
  for (const Term* term : found) {
    const std::string word(term->word);
    const bool lit = term == shown;
    if (ImGui::Selectable(with_capital(word).c_str(), lit) && !lit) go_to(frame, *term);
    frame.mark("glossary/" + word);
    if (lit && state.followed != word) {
      ImGui::SetScrollHereY();
      state.followed = word;
    }
  }
  if (found.empty()) wrapped_text("No word here is or says that.", theme().faint_text);
  ImGui::EndChild();
}

// Buttons in lines, as many as fit.
void draw_see_also(PanelFrame& frame, const Term& term) {
  const auto others = seen_from(term);
  if (others.empty()) return;
  ImGui::Dummy(ImVec2(0.0f, frame.units(6.0f)));
  heading(frame, "See also");
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float gap = frame.units(4.0f);
  for (const Term* other : others) {
    const std::string word(other->word);
    const float width = ImGui::CalcTextSize(word.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    if (other != others.front() && ImGui::GetItemRectMax().x + gap + width <= right)
      ImGui::SameLine(0.0f, gap);
    if (ImGui::Button(word.c_str())) go_to(frame, *other);
    frame.mark("glossary/see/" + word);
  }
}

void draw_term(PanelFrame& frame, const Term& term) {
  push_font(frame.fonts.heading);
  text(with_capital(std::string(term.word)));
  pop_font();
  if (!term.forms.empty()) wrapped_text("also: " + std::string(term.forms), theme().faint_text);
  ImGui::Dummy(ImVec2(0.0f, frame.units(4.0f)));
  glossary_wrapped_text(frame, term.meaning);
  frame.mark("glossary/meaning");
  draw_see_also(frame, term);
  if (term.where.empty()) return;
  ImGui::Dummy(ImVec2(0.0f, frame.units(6.0f)));
  heading(frame, "More about it");
  wrapped_text(term.where, theme().faint_text);
}

// The one asked for, unless something else is searched for.
const Term* term_shown(const PanelFrame& frame, const std::vector<const Term*>& found) {
  const Term* asked = find_term(frame.session.view->dialogs.glossary_term);
  if (asked != nullptr && std::find(found.begin(), found.end(), asked) != found.end()) return asked;
  return found.empty() ? asked : found.front();
}

// While the search has the keyboard, the table of commands has not.
void take_keys(PanelFrame& frame, const std::vector<const Term*>& found, const Term* shown) {
  if (!ImGui::GetIO().WantTextInput || !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows)) return;
  if (key_pressed(Key::Escape) || key_pressed(Key::F2)) return frame.wish(ShowGlossary{false, {}});
  const int by = (key_pressed(Key::Down, true) ? 1 : 0) - (key_pressed(Key::Up, true) ? 1 : 0);
  const auto at = std::find(found.begin(), found.end(), shown) - found.begin();
  const auto next = at + by;
  if (by != 0 && next >= 0 && next < static_cast<std::ptrdiff_t>(found.size()))
    go_to(frame, *found[static_cast<std::size_t>(next)]);
}

void draw_glossary_inside(PanelFrame& frame) {
  const float wide = ImGui::GetContentRegionAvail().x;
  ImGui::BeginChild("left", ImVec2(std::min(frame.units(210.0f), 0.4f * wide), 0.0f));
  draw_search(frame);
  const auto found = search_glossary(frame.own<GlossaryState>().search.data());
  const Term* shown = term_shown(frame, found);
  draw_words(frame, found, shown);
  ImGui::EndChild();
  ImGui::SameLine(0.0f, frame.units(14.0f));
  ImGui::BeginChild("right");
  if (shown != nullptr) draw_term(frame, *shown);
  ImGui::EndChild();
  take_keys(frame, found, shown);
}

}  // namespace

void draw_glossary(PanelFrame& frame) {
  GlossaryState& state = frame.own<GlossaryState>();
  if (!frame.session.view->dialogs.glossary_open) {
    state = GlossaryState{};
    return;
  }
  const Box& window = frame.layout.window;
  const Box& view = frame.layout.view;
  const float width = std::min(frame.units(600.0f), 0.96f * window.width);
  const float height = std::min(frame.units(380.0f), 0.9f * window.height);
  // It can be moved out of the way; a word that is clicked shows it where it was.
  const ImVec2 low(0.5f * (window.width - width), view.y + frame.units(40.0f));
  ImGui::SetNextWindowPos(low, state.shown ? ImGuiCond_Appearing : ImGuiCond_Always);
  ImGui::SetNextWindowSize(ImVec2(width, height));
  if (!state.shown) ImGui::SetNextWindowFocus();
  push_raised_look(frame);
  bool open = true;
  ImGui::Begin("Glossary", &open,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  pop_raised_look();
  const ImVec2 at = ImGui::GetWindowPos();
  frame.memory.controls.insert_or_assign("glossary", Box{at.x, at.y, width, height});
  draw_glossary_inside(frame);
  ImGui::End();
  state.shown = true;
  if (!open) frame.wish(ShowGlossary{false, {}});
}

}  // namespace app
