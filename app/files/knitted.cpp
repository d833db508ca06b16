#include "app/files/knitted.h"

#include "app/files/export.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "app/yarn/relaxed_piece.h"
#include "app/yarn/stitch_mesh.h"
#include "knit/insight/knitted_remarks.h"
#include "knit/model/stitch_size.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json knitted_json(const Session& session) {
  if (relaxed_missing(session)) return nullptr;
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Parameters& parameters = timeline.parameters();
  const auto piece = relaxed_piece(session);
  const knit::KnittedFigures& made = piece->figures;
  const double cm = parameters.stitch.centimetres_per_unit;
  Json json;
  json["height_cm"] = made.knitted.height * cm;
  json["width_cm"] = made.knitted.width * cm;
  json["asked_height_cm"] = made.placed.height * cm;
  json["asked_width_cm"] = made.placed.width * cm;
  json["sunk_cm"] = {made.sunk[0] * cm, made.sunk[1] * cm};
  json["out_of_round"] = made.out_of_round ? Json(made.out_of_round->share) : Json(nullptr);
  json["stretch"] = {{"min", made.least.share}, {"max", made.greatest.share}};
  json["iterations"] = piece->relaxed.iterations;
  json["problems"] = Json::array();
  for (const knit::Remark& remark : knit::remarks_on(timeline.state().fabric, *piece, parameters))
    json["problems"].push_back({{"row", remark.at ? remark.at->row : 0}, {"what", remark.words}});
  return json;
}

std::string relaxed_text(const Session& session) {
  return mesh_text_of(relaxed_fabric(session), "# Stitches where they come to lie in the air, stuffed.\n");
}

std::string relaxed_smobj(const Session& session) { return smobj_text(relaxed_fabric(session)); }

std::optional<std::string> relaxed_missing(const Session& session) {
  if (session.document->timeline.state().finished()) return std::nullopt;
  return "how the piece comes off the needles is known when it is finished; run to the end first.";
}

}  // namespace app
