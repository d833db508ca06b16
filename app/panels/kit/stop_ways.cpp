#include "app/panels/kit/stop_ways.h"

#include <vector>

#include "app/panels/kit/widgets.h"
#include "app/session/jobs.h"
#include "knit/model/stopped.h"
#include "knit/run/step.h"

namespace app {

void StopWays::refresh(const knit::Timeline& timeline) {
  if (!timeline.complete() || timeline.stop() == nullptr) {
    work_.reset();
    return;
  }
  RunKey key = run_key(timeline);
  if (work_ && key == key_) return;
  key_ = std::move(key);
  work_ = std::make_shared<WaysOnWork>(timeline);
}

namespace {

// By hand: where the axis gives no ends, a person may.
void draw_pick_ends(PanelFrame& frame, const std::string& mark) {
  const auto* stopped = knit::get_if<knit::Stopped>(*frame.timeline()->stop());
  if (stopped == nullptr || stopped->reason != knit::StopReason::no_extent) return;
  if (ImGui::Button("Pick the start in the view")) frame.wish(SetPicking{Picking::start});
  frame.mark(mark + "pick-start");
  tooltip(frame, "Then click a vertex: there the piece is cast on.");
  ImGui::SameLine();
  if (ImGui::Button("Pick the end")) frame.wish(SetPicking{Picking::end});
  frame.mark(mark + "pick-end");
  tooltip(frame, "Then click a vertex: there the piece is bound off.");
}

}  // namespace

namespace {

// Null: the run did not stop.
const WaysOnWork* ways_of(PanelFrame& frame) {
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr) return nullptr;
  auto& ways = frame.own<StopWays>();
  ways.refresh(*timeline);
  if (ways.work() != nullptr && !frame.session.jobs->beside)
    ways.work()->wait();  // a picture without a window shows them all
  return ways.work();
}

void draw_way(PanelFrame& frame, const std::string& mark, const FoundWay& found) {
  const std::string label = found.way.words + ": " + found.result() + "##" + mark + found.way.key;
  if (ImGui::Button(label.c_str())) frame.wish(Tune{with_way(found.way, frame.timeline()->parameters())});
  frame.mark(mark + found.way.key);
  tooltip(frame, with_commas(found.stitches) + " stitches. Sets " + found.way.options +
                     " and begins again. Undo brings this run back.");
}

}  // namespace

std::size_t draw_stop_ways(PanelFrame& frame, const std::string& mark) {
  const WaysOnWork* work = ways_of(frame);
  if (work == nullptr) return 0;
  draw_pick_ends(frame, mark);
  wrapped_text(words_of(*work), theme().faint_text);
  frame.mark(mark + "words");
  const std::vector<FoundWay> found = work->found();
  for (const FoundWay& way : found) draw_way(frame, mark, way);
  return found.size();
}

void draw_tried_ways(PanelFrame& frame, const std::string& mark) {
  const WaysOnWork* work = ways_of(frame);
  if (work == nullptr) return;
  if (!work->running()) {
    draw_stop_ways(frame, mark);
    return;
  }
  draw_pick_ends(frame, mark);
  wrapped_text(words_of(*work), theme().faint_text);
  frame.mark(mark + "words");
}

bool StopWays::was_at_it() {
  constexpr int after_the_end = 2;
  if (work_ != nullptr && work_->running()) {
    frames_due_ = after_the_end;
    return true;
  }
  if (frames_due_ == 0) return false;
  --frames_due_;
  return true;
}

bool ways_are_tried(PanelMemory& memory) { return memory.own<StopWays>().was_at_it(); }

}  // namespace app
