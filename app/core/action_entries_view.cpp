// Entries about what is seen: from which side, which panels and lists, in which theme and size.
#include <array>
#include <cmath>
#include <numbers>

#include "app/core/action_entries_parts.h"
#include "app/core/words.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

constexpr const char* view = "The view";
constexpr const char* panels = "Panels";
constexpr const char* program = "The program";

struct Side {
  const char* words;
  double yaw, pitch;  // of the camera; a turn of 1 is a right angle
};

void add_sides(EntryList& list) {
  constexpr std::array sides{Side{"Look from the front", 0.0, 0.0}, Side{"Look from the right", 1.0, 0.0},
                             Side{"Look from the back", 2.0, 0.0},  Side{"Look from the left", 3.0, 0.0},
                             Side{"Look from above", 0.0, 0.9},     Side{"Look from below", 0.0, -0.9}};
  constexpr double right_angle = 0.5 * std::numbers::pi;
  const Camera& camera = list.session.camera;
  for (const Side& side : sides) {
    // The shorter way round.
    const double turn = std::remainder(side.yaw * right_angle - camera.yaw, 4.0 * right_angle);
    list.add({side.words, view, "", Orbit{turn, side.pitch * right_angle - camera.pitch}, list.unless_open(),
              "", true});
  }
}

void add_moves(EntryList& list) {
  constexpr double by = 0.25;  // of half the view
  list.add({"Zoom in", view, "", Zoom{0.8, {0.0, 0.0}}, list.unless_open(), "", true});
  list.add({"Zoom out", view, "", Zoom{1.25, {0.0, 0.0}}, list.unless_open(), "", true});
  list.add({"Move the view left", view, "", Pan{{-by, 0.0}}, list.unless_open(), "", true});
  list.add({"Move the view right", view, "", Pan{{by, 0.0}}, list.unless_open(), "", true});
  list.add({"Move the view up", view, "", Pan{{0.0, by}}, list.unless_open(), "", true});
  list.add({"Move the view down", view, "", Pan{{0.0, -by}}, list.unless_open(), "", true});
}

void add_shown(EntryList& list) {
  const Session& session = list.session;
  for (std::size_t i = 0; i < side_keys.size(); ++i) {
    const auto side = static_cast<SidePanel>(i);
    list.add({"Show the side panel: " + std::string(side_keys[i]), panels, "", ShowSide{side},
              session.side == side ? "It is shown." : ""});
  }
  for (std::size_t i = 0; i < list_keys.size(); ++i) {
    const auto shown = static_cast<RunList>(i);
    list.add({"Show the list: " + std::string(list_keys[i]), panels, "Below the step.", ShowList{shown},
              session.list == shown ? "It is shown." : ""});
  }
  for (std::size_t i = 0; i < panel_keys.size(); ++i) {
    const auto panel = static_cast<Panel>(i);
    list.add({"Open or close the panel: " + std::string(panel_keys[i]), panels, "",
              ShowPanel{panel, !session.preferences.shows(panel)}});
  }
}

// In units of a plain screen.
ActionPrompt ask_split(Split split) {
  return {"Size, or 0 for as there is room", "300",
          [split](const Session& /*session*/, const std::string& typed) -> Read {
            const auto size = whole_number<int>(typed);
            if (size && *size >= 0 && *size <= 10000) return SetSplit{split, static_cast<double>(*size)};
            return "A size is a whole number from 0 to 10000, not \"" + typed + "\".";
          }};
}

void add_layout(EntryList& list) {
  list.add({"Set the width of the left panel to...", panels, "", ask_split(Split::left), "", "", true});
  list.add({"Set the width of the right panel to...", panels, "", ask_split(Split::right), "", "", true});
  list.add({"Set the height of the timeline to...", panels, "", ask_split(Split::bottom), "", "", true});
  list.add({"Put the panels back as they were at first", panels, "Reset the layout.", ResetLayout{}});
}

Read read_scale(const Session& /*session*/, const std::string& typed) {
  const auto percent = whole_number<int>(typed);
  const double scale = percent ? static_cast<double>(*percent) / 100.0 : 0.0;
  if (scale >= smallest_scale && scale <= largest_scale) return SetScale{scale};
  return "The size is from 75 to 250 per cent, not \"" + typed + "\".";
}

void add_look(EntryList& list) {
  const Preferences& now = list.session.preferences;
  for (std::size_t i = 0; i < theme_keys.size(); ++i) {
    const auto theme = static_cast<ThemeKind>(i);
    list.add({"Use the " + std::string(theme_keys[i]) + " theme", program, "", SetTheme{theme},
              now.theme == theme ? "It is in use." : ""});
  }
  list.add({"Words and lines in their usual size", program, "", SetScale{1.0}});
  list.add({"Words and lines large, for a projector", program, "", SetScale{projector_scale}});
  list.add(
      {"Set the size of words and lines to...", program, "", ActionPrompt{"Per cent", "125", read_scale}});
  list.add({"Allow or stop short movements", program, "", SetMotion{!now.motion}});
}

}  // namespace

void add_view_entries(EntryList& list) {
  add_shown(list);
  add_layout(list);
  add_sides(list);
  add_moves(list);
  add_look(list);
}

}  // namespace app
