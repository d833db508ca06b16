// Small parts that several panels share.
#pragma once

#include <imgui.h>

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "app/panels/kit/frame.h"
#include "app/panels/kit/style.h"

namespace app {

// A list that hangs open from a field, as of the last frame.
struct HangingList {
  bool open = false;
  bool to_close = false;  // a key was meant for something else
};
// ImGui::BeginCombo; ImGui::EndCombo is due where it gives true. Esc closes it, and so does a key with Ctrl, which is heard.
bool begin_list(PanelFrame& frame, const char* id, const std::string& shown);
// Of a popup that hangs open likewise: once after it began.
void keep_list(PanelFrame& frame);

// A buffer that a text field writes into.
struct TextBuffer {
  std::array<char, 4096> bytes{};
  void set(const std::string& text);
  [[nodiscard]] std::string text() const { return {bytes.data()}; }
};

inline constexpr ImGuiWindowFlags fixed_panel =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
    ImGuiWindowFlags_NoNavInputs;

// ImGui::Begin at a fixed place; ImGui::End is due in any case.
void begin_panel(const char* name, const Box& box, ImGuiWindowFlags more = 0);

// Rounded and outlined, for what stands over the panels.
void push_raised_look(const PanelFrame& frame);
void pop_raised_look();

// A section's title with a thin line.
void heading(const PanelFrame& frame, const char* words);
// One that folds its section away; true when it was clicked.
bool folding_heading(const PanelFrame& frame, const char* words, bool open);

enum class Icon : std::uint8_t {
  first,
  back,
  play,
  pause,
  forward,
  last,
  cross,
  reset,
  slow,
  loop,
  undo,
  redo,
  copy,
  paste
};
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);
bool icon_button(const char* id, Icon icon, ImVec2 size, bool lit = false);

// Buttons side by side of which one is chosen; gives the newly chosen one, or -1. Width 0: as wide as needed.
int segmented(const char* id, std::span<const std::string_view> names, int chosen, float width);

// Whether a line may end at a place: at a blank, but not beside an "=" nor between a number and its unit, so that "t = 0" and
// "15 %" stay together.
bool may_break(std::string_view words, std::size_t at);

// In the words of the window, with line feeds where lines end, at blanks only: Dear ImGui itself breaks "0.05" after its
// point.
std::string wrapped_at_blanks(std::string_view words, float width);

// In a table that scrolls below one line of heads: a line, from 0, comes to the middle, and none is cut under the heads.
void scroll_to_line(std::size_t line);

// A button of equal height whether it is lit or not.
bool lit_button(const char* words, bool lit);

// Tips stand below what they are about, else above or beside it: inside the window, and never on it.

// Where one of this size stands. `gap`: between them.
Box tip_box(const Box& item, const Box& window, ImVec2 size, float gap);
// ImGui::EndTooltip is due. `content`: what will stand in it.
void begin_tip(const PanelFrame& frame, const Box& item, ImVec2 content);
// As wide as a wrapped tip is at most.
float tip_width(const PanelFrame& frame);
// The last item; of a tall one the pointer's surroundings.
Box tipped_item(const PanelFrame& frame);
Box around_pointer(const PanelFrame& frame);
// In any case, about this.
void tooltip_about(const PanelFrame& frame, const Box& item, std::string_view words);
// For the last item, wrapped.
void tooltip(const PanelFrame& frame, std::string_view words);
// Whether the last item is long enough under the pointer for a tooltip.
bool wants_tooltip();

void text(std::string_view words);
void faint_text(std::string_view words);
void wrapped_text(std::string_view words);
void wrapped_text(std::string_view words, Colour colour);

// One line drawn at a place, without an item; `align` is its part left of it: 0, 0.5 or 1.
void text_at(ImVec2 at, float align, Colour colour, const std::string& words);

// One line in the words of the window, cut to a width with an ellipsis.
std::string cut_to_width(std::string_view words, float width);

std::string with_commas(std::size_t number);
std::string with_commas(std::size_t count, std::string_view one, std::string_view many);  // "1,200 stitches"
// "3 rounds", "1 round": a number with a unit that is given in the plural.
std::string with_unit(std::string_view number, std::string_view unit);
std::string capitalised(std::string_view name);  // "cast-on": "Cast on"
std::string with_capital(std::string words);     // what begins a sentence
std::string words_of(const knit::Place& place);  // "Rows, row 5, item 23"

// Readable over whatever is in the picture: in this colour, or as near to it as can be read. `at`: the text's top left, on
// the screen.
void boxed_text(const PanelFrame& frame, ImVec2 at, const std::string& words, Colour colour);

}  // namespace app
