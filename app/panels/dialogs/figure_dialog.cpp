// Saving pictures and animations: the menu's items, the dialog, and how far an animation has come.
#include "app/panels/dialogs/figure_dialog.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/dialogs/menu_parts.h"
#include "app/panels/kit/run_cache.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "app/actions/navigate.h"
#include "app/base/text.h"
#include "app/files/figures.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

using Kind = FigureDialog::Kind;
using Of = FigureDialog::Of;

struct Size {
  int width = 0, height = 0;
};
constexpr std::array<Size, 2> usual_sizes{{{1920, 1080}, {3840, 2160}}};
constexpr std::array<std::string_view, 4> size_names{"As shown", "1920 x 1080", "3840 x 2160", "Own"};
constexpr std::size_t as_shown = 0, own_size = size_names.size() - 1;

std::string path_of(const FigureDialog& dialog) { return {dialog.path.data()}; }

void set_path(FigureDialog& dialog, const std::string& path) {
  dialog.path.fill('\0');
  std::copy_n(path.begin(), std::min(path.size(), dialog.path.size() - 1), dialog.path.begin());
}

// Of the view or of the whole window, as the screen has it.
Size size_shown(const PanelFrame& frame) {
  const Box& box = frame.own<FigureDialog>().panels ? frame.layout.window : frame.layout.view;
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  const auto side = [](float length) {
    return std::clamp(static_cast<int>(std::lround(length)), smallest_side, largest_side);
  };
  return {side(box.width * pixels.x), side(box.height * pixels.y)};
}

Size size_of(const PanelFrame& frame) {
  const FigureDialog& dialog = frame.own<FigureDialog>();
  if (dialog.size == as_shown) return size_shown(frame);
  if (dialog.size == own_size) return {dialog.own[0], dialog.own[1]};
  return usual_sizes[dialog.size - 1];
}

Stretch stage_at_hand(const PanelFrame& frame) {
  const std::size_t last = std::max<std::size_t>(frame.timeline()->position(), 1) - 1;
  for (const RunCache::Stretch& stage : frame.own<RunCache>().stages()) {
    if (stage.begin <= last && last < stage.end) return {stage.begin, stage.end};
  }
  return {0, frame.timeline()->known()};
}

Stretch stretch_of(const PanelFrame& frame) {
  const Stretch whole{0, frame.timeline()->known()};
  switch (frame.own<FigureDialog>().of) {
    case Of::run:
      return whole;
    case Of::stage:
      return stage_at_hand(frame);
    case Of::row:
      return stretch_of_row(frame.session).value_or(whole);
    case Of::loop:
      return frame.session.document->travel.loop.value_or(whole);
  }
  return whole;
}

SavePicture picture_wished(const PanelFrame& frame) {
  const FigureDialog& dialog = frame.own<FigureDialog>();
  const Size size = size_of(frame);
  return {path_of(dialog), size.width, size.height, dialog.panels, dialog.transparent && !dialog.panels};
}

SaveAnimation animation_wished(const PanelFrame& frame) {
  const FigureDialog& dialog = frame.own<FigureDialog>();
  const Size size = size_of(frame);
  return {path_of(dialog), stretch_of(frame), dialog.frames, dialog.rate,
          size.width,      size.height,       dialog.panels};
}

// --- the parts of the dialog -------------------------------------------------------------------------------

void label(PanelFrame& frame, const std::string& words) {
  const float longest = ImGui::CalcTextSize("Background").x;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  faint_text(words);
  if (!words.empty()) frame.mark("figure/label/" + words);
  ImGui::SameLine(left + std::max(frame.units(72.0f), longest + frame.units(10.0f)));
}

void draw_path(PanelFrame& frame, bool begins) {
  FigureDialog& dialog = frame.own<FigureDialog>();
  if (begins) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputText("##path", dialog.path.data(), dialog.path.size());
  frame.mark("figure/path");
}

void draw_stretch(PanelFrame& frame) {
  FigureDialog& dialog = frame.own<FigureDialog>();
  std::vector<std::string_view> names{"Whole run", "This stage", "This row"};
  if (frame.session.document->travel.loop) names.emplace_back("The loop");
  if (dialog.of == Of::loop && !frame.session.document->travel.loop) dialog.of = Of::run;
  label(frame, "Of");
  const int clicked = segmented("of", names, static_cast<int>(dialog.of), 0.0f);
  if (clicked >= 0) dialog.of = static_cast<Of>(clicked);
  frame.mark("figure/of");
}

void draw_rate(PanelFrame& frame) {
  FigureDialog& dialog = frame.own<FigureDialog>();
  label(frame, "Frames");
  edit_number(frame, "##frames", dialog.frames, 1, most_frames, "", frame.units(64.0f));
  frame.mark("figure/frames");
  tooltip(frame, "At most so many, spread evenly; the last one shows the end.");
  ImGui::SameLine();
  faint_text("at");
  ImGui::SameLine();
  const NumberShape rate{
      shown_number(dialog.rate), knit::number_text(dialog.rate), dialog.rate, slowest_rate, fastest_rate,
      DragPace::linear};
  edit_number(frame, "##rate", dialog.rate, rate, frame.units(52.0f));
  frame.mark("figure/rate");
  ImGui::SameLine();
  std::string words = "a second";
  if (dialog.frames > 0 && dialog.rate > 0.0) {
    const auto frames = static_cast<double>(frames_in(stretch_of(frame), dialog.frames));
    words += ": " + fixed_text(frames / dialog.rate, 1) + " s";
  }
  faint_text(words);
}

void draw_size(PanelFrame& frame) {
  FigureDialog& dialog = frame.own<FigureDialog>();
  label(frame, "Size");
  const Size before = size_of(frame);
  const int clicked = segmented("size", size_names, static_cast<int>(dialog.size), 0.0f);
  frame.mark("figure/size");
  if (clicked >= 0) dialog.size = static_cast<std::size_t>(clicked);
  // One's own begins as what was chosen before.
  if (dialog.size == own_size && dialog.own[0] == 0) dialog.own = {before.width, before.height};
  label(frame, "");
  if (dialog.size == own_size) {
    edit_number(frame, "##width", dialog.own[0], smallest_side, largest_side, "", frame.units(64.0f));
    frame.mark("figure/own");
    ImGui::SameLine();
    faint_text("x");
    ImGui::SameLine();
    edit_number(frame, "##height", dialog.own[1], smallest_side, largest_side, "", frame.units(64.0f));
    frame.mark("figure/own-height");
    ImGui::SameLine();
    faint_text("pixels");
  } else {
    ImGui::AlignTextToFramePadding();
    const Size size = size_of(frame);
    faint_text(std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels");
  }
}

void draw_look(PanelFrame& frame) {
  constexpr std::array<std::string_view, 2> names{"The view alone", "With panels"};
  FigureDialog& dialog = frame.own<FigureDialog>();
  label(frame, "Shows");
  const int clicked = segmented("look", names, dialog.panels ? 1 : 0, 0.0f);
  if (clicked >= 0) dialog.panels = clicked == 1;
  frame.mark("figure/look");
  if (dialog.wanted != Kind::picture) return;
  label(frame, "Background");
  ImGui::BeginDisabled(dialog.panels);
  bool on = dialog.transparent && !dialog.panels;
  if (ImGui::Checkbox("Transparent", &on)) dialog.transparent = on;
  frame.mark("figure/transparent");
  ImGui::EndDisabled();
  if (dialog.panels) tooltip(frame, "Panels have a background of their own.");
}

// What will be written, when it can be.
std::string words_for(const PanelFrame& frame, bool exists) {
  if (exists) return "A file of that name exists; saving replaces it.";
  const FigureDialog& dialog = frame.own<FigureDialog>();
  if (dialog.wanted == Kind::picture) return "A name without a folder lies where the program was started.";
  switch (animation_kind_of(path_of(dialog)).value_or(AnimationKind::gif)) {
    case AnimationKind::gif:
      return "An animated GIF. With .png it is lossless; without an ending, a folder.";
    case AnimationKind::apng:
      return "An animated PNG, lossless; .gif is shown everywhere.";
    case AnimationKind::folder:
      break;
  }
  return "A folder of pictures, frame_0001.png and so on; other files in it stay.";
}

void close_figure_dialog(PanelFrame& frame) {
  frame.own<FigureDialog>().wanted.reset();
  frame.own<FigureDialog>().shown = false;
  ImGui::CloseCurrentPopup();
}

// `keys`: whether Enter and Escape are the dialog's.
void draw_figure_buttons(PanelFrame& frame, bool keys) {
  const bool entered = keys && (key_pressed(Key::Enter) || key_pressed(Key::KeypadEnter));
  const bool picture = frame.own<FigureDialog>().wanted == Kind::picture;
  const std::string path = path_of(frame.own<FigureDialog>());
  const auto fault = picture ? fault_of(picture_wished(frame)) : fault_of(animation_wished(frame));
  std::error_code error;
  const bool exists = std::filesystem::is_regular_file(path, error);
  if (path.empty()) {
    faint_text("Give a name.");
  } else if (fault) {
    wrapped_text(with_capital(*fault), theme().warning);
  } else {
    wrapped_text(words_for(frame, exists), exists ? theme().warning : theme().faint_text);
  }
  const bool usable = !path.empty() && !fault;
  ImGui::BeginDisabled(!usable);
  const bool clicked = ImGui::Button(exists ? "Replace" : "Save", ImVec2(frame.units(90.0f), 0.0f));
  frame.mark("figure/save");
  ImGui::EndDisabled();
  if (usable && (clicked || entered)) {
    frame.wish(picture ? Action(picture_wished(frame)) : Action(animation_wished(frame)));
    close_figure_dialog(frame);
    return;
  }
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel", ImVec2(frame.units(90.0f), 0.0f));
  frame.mark("figure/cancel");
  if (cancelled || (keys && key_pressed(Key::Escape))) close_figure_dialog(frame);
}

void draw_figure_inside(PanelFrame& frame, bool begins) {
  const bool animation = frame.own<FigureDialog>().wanted == Kind::animation;
  const bool typing = number_field_open(frame.memory);  // Enter takes a number then, Escape restores it
  draw_path(frame, begins);
  if (animation) {
    draw_stretch(frame);
    draw_rate(frame);
  }
  draw_size(frame);
  draw_look(frame);
  if (animation && !frame.timeline()->complete())
    faint_text("The run is still being worked out; what is there so far is saved.");
  ImGui::Dummy(ImVec2(0.0f, frame.units(2.0f)));
  draw_figure_buttons(frame, !begins && !typing);
}

void begin(PanelFrame& frame) {
  FigureDialog& dialog = frame.own<FigureDialog>();
  dialog.shown = true;
  const std::string name = frame.timeline()->input().mesh.name;
  const char* const ending = dialog.wanted == Kind::picture ? ".png" : ".gif";
  set_path(dialog, (name.empty() ? "mesh" : name) + ending);
}

}  // namespace

void draw_figure_menu(PanelFrame& frame) {
  const auto item = [&](const char* words, Kind kind, const char* control) {
    if (ImGui::MenuItem(words, nullptr, false, frame.timeline() != nullptr))
      frame.own<FigureDialog>().wanted = kind;
    frame.mark(control);
  };
  item("Save a picture...", Kind::picture, "menu/Save a picture...");
  item("Save an animation...", Kind::animation, "menu/Save an animation...");
}

void draw_figure_dialog(PanelFrame& frame) {
  FigureDialog& dialog = frame.own<FigureDialog>();
  if (!dialog.wanted || frame.timeline() == nullptr) return;
  const char* const title =
      dialog.wanted == Kind::picture ? "Save a picture###figure" : "Save an animation###figure";
  const bool begins = !dialog.shown;
  if (begins) {
    begin(frame);
    ImGui::OpenPopup(title);
  }
  const Box& window = frame.layout.window;
  ImGui::SetNextWindowPos(ImVec2(0.5f * window.width, 0.4f * window.height), ImGuiCond_Always,
                          ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(frame.units(520.0f), 0.9f * window.width), 0.0f));
  push_raised_look(frame);
  const bool open =
      ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  pop_raised_look();
  if (!open) {
    dialog.wanted.reset();
    dialog.shown = false;
    return;
  }
  draw_figure_inside(frame, begins);
  ImGui::EndPopup();
}

void draw_animation_progress(PanelFrame& frame) {
  const auto& run = frame.session.jobs->animation;
  if (!run) return;
  const Box& view = frame.layout.view;
  // Who knits along has the foot of the view for that.
  const float bottom =
      frame.session.view->gaze.knit_along ? view.y + 0.5f * view.height : view.bottom() - frame.units(52.0f);
  ImGui::SetNextWindowPos(ImVec2(view.right() - frame.units(12.0f), bottom), ImGuiCond_Always,
                          ImVec2(1.0f, 1.0f));
  push_raised_look(frame);
  ImGui::Begin("Animation", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  pop_raised_look();
  const float width = frame.units(220.0f);
  text(cut_to_width("Saving " + run->wish.path.filename().string(), width));
  const float share =
      static_cast<float>(run->done) / static_cast<float>(std::max<std::size_t>(1, run->frames));
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, style::vector(theme().accent));
  ImGui::ProgressBar(share, ImVec2(width, frame.units(6.0f)), "");
  ImGui::PopStyleColor();
  ImGui::AlignTextToFramePadding();
  faint_text(with_commas(run->done) + " of " + with_commas(run->frames, "frame", "frames"));
  ImGui::SameLine(ImGui::GetCursorPosX() + width - frame.units(72.0f));
  if (ImGui::Button("Cancel", ImVec2(frame.units(72.0f), 0.0f))) frame.wish(CancelAnimation{});
  frame.mark("animation/cancel");
  ImGui::End();
}

}  // namespace app
