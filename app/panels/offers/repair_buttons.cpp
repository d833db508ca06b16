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
    default:
      return std::nullopt;
  }
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
    const bool faces = kind == knit::RepairKind::reorient;
    std::string button = faces ? "Repair: turn faces round##" : "Repair: drop stray vertices##";
    button += mark;
    if (ImGui::SmallButton(button.c_str())) {
      knit::RepairWish wish{false, source.repairs};
      wish.kinds.push_back(*kind);
      frame.wish(OpenFile{source.file, std::move(wish)});
    }
    frame.mark(mark + knit::key_of(*kind));
    tooltip(frame,
            warned.sentence + "\n\nOpens the mesh again, repaired, with its own parameters; can be undone.");
  }
  return any;
}

}  // namespace app
