// All panels in one call.
//
// How a frame goes; the session is the same all through it, so picture, captions and panels agree:
//   glue.begin_frame(size, window.input().take_frame());
//   const Layout layout = layout_of(size.width, size.height, scale, layout_wish(session));
//   apply(session, SetAspect{layout.view_aspect()});
//   const Scene scene = describer.describe(session);
//   const Actions wishes = draw_ui(session, memory, scene, layout, fonts);
//   glue.end_frame();
//   ... draw the scene into pixels_of(layout.view, layout.window, size.pixels_per_x, size.pixels_per_y),
//   ... then ImGui's own triangles over all of the window; the view's rectangle has no background of theirs
//   for (const Action& wish : wishes) apply(session, wish);
// Wishes show in the next frame, so one is due whenever there were any. Popups, tooltips and notices find
// their size in two frames: draw three after the last event before going to sleep.
//
// Before the first frame, and whenever the scale changes: fonts = glue.load_fonts(folder, scale,
// style::text_size), style::apply(scale), ImGuiDraw::forget_fonts().
#pragma once

#include "app/panels/kit/frame.h"

namespace app {

// Of the strip below the view, plain units.
inline constexpr float lesson_height = 150.0f;
inline constexpr float guess_height = 116.0f;

// As the preferences have it, with room for a lesson and for guesses while they go on.
LayoutWish layout_wish(const Session& session);

// Of panels and fonts: `scale` times what the preferences have; larger while presenting.
float ui_scale(const Session& session, float width, float height, float scale);

// Needs a frame of ImGui's. What a person wished in it, in order. `other`: of the pinned run, where both are seen.
Actions draw_ui(const Session& session, PanelMemory& memory, const Scene& scene, const Layout& layout,
                const Fonts& fonts, const Scene* other = nullptr);
// What stands in the view beside the scene, as a frame's only window.
void draw_captions_alone(const Session& session, PanelMemory& memory, const Scene& scene,
                         const Layout& layout, const Fonts& fonts);

// A click waits to see whether it becomes a double click: a frame is due without an event.
bool click_waits(PanelMemory& memory);
// A worker of the panels is at it: a frame is due when it has done something.
bool panels_are_working(PanelMemory& memory);
// But for what is known of the run.
void forget_what_was_seen(PanelMemory& memory);

}  // namespace app
