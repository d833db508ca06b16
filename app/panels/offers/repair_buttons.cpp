#include "app/panels/offers/repair_buttons.h"

#include <optional>
#include <utility>

#include "app/panels/kit/widgets.h"
#include "app/session/document.h"

namespace app {

namespace {

// What would repair a finding that is no more than a warning; none: nothing that is sure to.
std::optional<knit::RepairKind> repair_of(knit::FindingKind what) {
  switch (what) {
    case knit::FindingKind::flipped_faces:
    case knit::FindingKind::inside_out:
      return knit::RepairKind::reorient;
    case knit::FindingKind::unreferenced:
      return knit::RepairKind::unreferenced;
    case knit::FindingKind::open_edges:
      return knit::RepairKind::openings;
    default:
      return std::nullopt;
  }
}

std::string name_of(knit::RepairKind kind) {
  if (kind == knit::RepairKind::reorient) return "Repair: turn faces round";
  return kind == knit::RepairKind::openings ? "Repair: close openings flat" : "Repair: drop stray vertices";
}

}  // namespace

bool draw_repair_buttons(PanelFrame& frame, const std::string& mark) {
  if (!frame.session.document || frame.session.document->source.file.empty()) return false;
  const Source& source = frame.session.document->source;
  bool any = false;
  for (const knit::Finding& warned : frame.session.document->findings) {
    const auto kind = repair_of(warned.kind);
    if (!kind) continue;
    any = true;
    const std::string button = name_of(*kind) + "##" + mark;
    if (ImGui::SmallButton(button.c_str())) {
      knit::RepairWish wish{false, source.repairs};
      wish.kinds.push_back(*kind);
      frame.wish(OpenFile{source.file, std::move(wish), {{}, false, source.curves}});
    }
    frame.mark(mark + knit::key_of(*kind));
    tooltip(frame,
            warned.sentence + "\n\nOpens the mesh again, repaired, with its own parameters; can be undone.");
  }
  return any;
}

}  // namespace app
