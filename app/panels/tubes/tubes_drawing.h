// The tubes of a shape as the panel draws them: where each stands on the screen, what of it is knitted, what waits.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/kit/frame.h"
#include "app/panels/tubes/tubes_layout.h"
#include "app/panels/tubes/tubes_words.h"
#include "knit/fabric/row.h"
#include "knit/run/timeline.h"

namespace app {

// Made anew only when the plan is another one, or the run has got further.
struct TubesSeen {
  std::uint64_t plan = 0, graph = 0;  // by content: replayed steps make new pointers
  TubesLayout layout;
  std::vector<std::string> words;
  std::vector<TubeCount> counts;
  std::shared_ptr<const knit::Row> last_counted;  // the highest row; null: none
};

// The state's plan, or what the whole run comes to.
const knit::State& state_with_plan(const knit::Timeline& timeline);
const TubesSeen& seen_now(const PanelFrame& frame);

struct ShownTube {
  knit::TubeId id = 0;
  float x = 0.0f, bottom = 0.0f, top = 0.0f;  // of its band, on the screen
  float half = 0.0f;                          // the half width of its widest row
  Colour colour;
  std::int32_t knitted = 0;  // rows
  bool begun = false, done = false, held = false;
};

struct TubesDrawing {
  const knit::TubePlan& plan;
  const TubesSeen& seen;
  ImDrawList& list;
  Box ground;
  std::vector<ShownTube> tubes;
  std::vector<std::uint8_t> dealt;         // of each event
  std::vector<std::uint8_t> waits;         // of each tube
  std::int32_t dealing = -1;               // the event whose loops are dealt now
  knit::RowId row = 0;                     // the current one
  knit::TubeId current = -1, chosen = -1;  // of the current row, of what is selected
  std::vector<knit::TubeId> meant;         // of the rounds under the pointer in another panel
  [[nodiscard]] float x_of(double x) const { return ground.x + static_cast<float>(x) * ground.width; }
  [[nodiscard]] float y_of(double y) const { return ground.bottom() - static_cast<float>(y) * ground.height; }
  [[nodiscard]] const TubePlace& place(knit::TubeId id) const {
    return seen.layout.tubes[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] const knit::Tube& tube(knit::TubeId id) const { return plan.tube(id); }
};

// Needs a plan of tubes; `ground` is where the drawing stands on the screen.
TubesDrawing drawing_of(const PanelFrame& frame, const Box& ground);
// Tubes that are alike get the same rounds; it alone where none is.
std::vector<knit::TubeId> twins_of(const TubesDrawing& drawing, knit::TubeId id);
ImVec2 event_at(const TubesDrawing& drawing, std::size_t event);
// Bands, ways, rows, events and words; `pointed`: the tube under the pointer.
void draw_tubes(const PanelFrame& frame, const TubesDrawing& drawing, std::optional<knit::TubeId> pointed);

}  // namespace app
