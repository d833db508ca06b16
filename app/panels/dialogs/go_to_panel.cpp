// Where to go: type a name, see what is there, Enter goes. Over the head of the view, as the list of all actions.
#include <algorithm>
#include <string>
#include <utility>

#include "app/panels/dialogs/destination_field.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/dialogs/top_popup.h"
#include "app/panels/kit/commands.h"
#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "app/session/view.h"

namespace app {

const DestinationLookup::Found& DestinationLookup::find(const Session& session, const std::string& typed) {
  const knit::Timeline& timeline = session.document->timeline;
  RunKey run = run_key(timeline);
  const bool same = looked_ && typed == typed_ && timeline.position() == position_ &&
                    timeline.complete() == complete_ && run == run_;
  if (same) return found_;
  typed_ = typed;
  run_ = std::move(run);
  position_ = timeline.position();
  complete_ = timeline.complete();
  looked_ = true;
  found_ = destination_of(session, typed);
  completions_ = completions_of(session, typed);
  return found_;
}

namespace {

constexpr const char* go_to_popup = "Go to";
constexpr int most_completions = 13;  // lines

void fill_go_to(GoToState& state, const std::string& words) {
  state.field.fill('\0');
  std::copy_n(words.begin(), std::min(words.size(), state.field.size() - 1), state.field.begin());
  ++state.field_number;
  state.refocus = true;
  state.chosen = -1;
}

void close_go_to(PanelFrame& frame) {
  frame.own<GoToState>().shown = false;
  frame.wish(ShowGoTo{false});
  ImGui::CloseCurrentPopup();
}

void draw_go_to_field(GoToState& state) {
  ImGui::PushID(state.field_number);
  if (state.refocus && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive()) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
    state.refocus = false;
  }
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##go-to", "Go to row 7, stitch 20:5, widest round...", state.field.data(),
                           state.field.size());
  ImGui::PopID();
}

void draw_what_is_there(PanelFrame& frame, const DestinationLookup::Found& found, bool typed) {
  if (const auto* there = std::get_if<Destination>(&found)) {
    wrapped_text(there->words);
    frame.mark("go-to/there");
    return;
  }
  const auto& none = std::get<NoDestination>(found);
  const bool unfinished =
      !typed || (!none.understood && !frame.own<GoToState>().lookup.completions().empty());
  if (unfinished) {
    faint_text("Tab completes, Enter goes, Esc closes.");
  } else {
    wrapped_text(none.why, theme().problem);
  }
  frame.mark(unfinished ? "go-to/foot" : "go-to/trouble");
}

// Up and Down choose, Tab takes the one chosen, else the first; a click takes any.
void draw_completions(PanelFrame& frame, const std::vector<std::string>& texts) {
  GoToState& state = frame.own<GoToState>();
  const int count = std::min(static_cast<int>(texts.size()), most_completions);
  const int by = (key_pressed(Key::Down, true) ? 1 : 0) - (key_pressed(Key::Up, true) ? 1 : 0);
  state.chosen = std::clamp(state.chosen + by, -1, count - 1);
  int taken = key_pressed(Key::Tab) && count > 0 ? std::max(state.chosen, 0) : -1;
  // In a child: a click there leaves what stands over the window open.
  const float height = static_cast<float>(count) * ImGui::GetTextLineHeightWithSpacing();
  if (count > 0) ImGui::BeginChild("forms", ImVec2(0.0f, height), false);
  for (int i = 0; i < count; ++i) {
    const std::string& words = texts[static_cast<std::size_t>(i)];
    if (ImGui::Selectable(words.c_str(), i == state.chosen)) taken = i;
    frame.mark("go-to/form/" + std::to_string(i + 1));
  }
  if (count > 0) ImGui::EndChild();
  if (taken >= 0) fill_go_to(state, texts[static_cast<std::size_t>(taken)]);
}

void draw_go_to_inside(PanelFrame& frame) {
  GoToState& state = frame.own<GoToState>();
  const bool again = key_mods().ctrl && key_pressed(Key::G);
  if (again || key_pressed(Key::Escape) || !frame.session.document) return close_go_to(frame);
  draw_go_to_field(state);
  frame.mark("go-to/field");
  const std::string typed = state.field.data();
  const bool enter = key_pressed(Key::Enter) || key_pressed(Key::KeypadEnter);
  const DestinationLookup::Found found = state.lookup.find(frame.session, typed);
  draw_what_is_there(frame, found, !typed.empty());
  draw_completions(frame, state.lookup.completions());
  if (!enter) return;
  if (std::holds_alternative<Destination>(found)) {
    close_go_to(frame);
    return frame.wish(GoTo{typed});
  }
  const auto& texts = state.lookup.completions();
  const bool chosen = state.chosen >= 0 && state.chosen < static_cast<int>(texts.size());
  if (chosen) fill_go_to(state, texts[static_cast<std::size_t>(state.chosen)]);
  state.refocus = true;
}

}  // namespace

void draw_go_to(PanelFrame& frame) {
  GoToState& state = frame.own<GoToState>();
  const bool wanted = frame.session.view->dialogs.go_to_open;
  if (!wanted && !state.shown) return;
  if (wanted && !state.shown) {
    state.shown = true;
    fill_go_to(state, "");
    ImGui::OpenPopup(go_to_popup);
  }
  if (!begin_top_popup(frame, go_to_popup, 560.0f)) {  // a click beside it
    state.shown = false;
    if (wanted) frame.wish(ShowGoTo{false});
    return;
  }
  if (!wanted) {  // closed by another hand
    state.shown = false;
    ImGui::CloseCurrentPopup();
  } else {
    draw_go_to_inside(frame);
  }
  ImGui::EndPopup();
}

}  // namespace app
