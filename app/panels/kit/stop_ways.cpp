#include "app/panels/kit/stop_ways.h"

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

void draw_stop_ways(PanelFrame& frame, const std::string& mark) {
  const knit::Timeline* timeline = frame.timeline();
  if (timeline == nullptr) return;
  auto& ways = frame.own<StopWays>();
  ways.refresh(*timeline);
  if (ways.work() == nullptr) return;
  if (!frame.session.jobs->beside) ways.work()->wait();  // a picture without a window shows them all
  wrapped_text(words_of(*ways.work()), theme().faint_text);
  frame.mark(mark + "words");
  for (const FoundWay& found : ways.work()->found()) {
    const std::string label = found.way.words + ": " + found.result() + "##" + mark + found.way.key;
    if (ImGui::Button(label.c_str())) frame.wish(Tune{with_way(found.way, timeline->parameters())});
    frame.mark(mark + found.way.key);
    tooltip(frame, with_commas(found.stitches) + " stitches. Sets " + found.way.options +
                       " and begins anew. Undo brings this run back.");
  }
  draw_pick_ends(frame, mark);
}

bool StopWays::was_at_it() {
  const bool before = at_it_;
  at_it_ = work_ != nullptr && work_->running();
  return before || at_it_;
}

bool ways_are_tried(PanelMemory& memory) { return memory.own<StopWays>().was_at_it(); }

}  // namespace app
