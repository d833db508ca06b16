#include "app/files/knitted.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/files/export.h"
#include "app/session/document.h"
#include "app/session/shown.h"
#include "knit/model/stitch_size.h"
#include "knit/relax/knitted.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

struct InTheAir {
  knit::Relaxed relaxed;
  knit::KnittedFigures figures;
};

InTheAir in_the_air(const Session& session, const knit::Fabric& fabric) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Parameters& parameters = timeline.parameters();
  const knit::RelaxSettings settings;
  knit::RelaxWork work;
  knit::begin_relaxing(fabric, parameters.stitch, settings, work);
  knit::RelaxIteration told;
  while (!work.done) told = knit::advance_relaxing(settings, work);
  InTheAir air{knit::finish_relaxing(work, told), {}};
  air.figures = knit::knitted_figures(fabric, *work.plan, air.relaxed,
                                      knit::knitting_direction(parameters.timing, timeline.input().mesh));
  return air;
}

std::string decimals(double number, int places) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", places, number);
  return text.data();
}
std::string percent(double share) { return decimals(100.0 * share, 0) + " %"; }

// What the maker must be told, each with the row to look at; 0: all of it.
Json problems_of(const knit::Fabric& fabric, const InTheAir& air, const knit::StitchSize& stitch) {
  constexpr double far_off = 0.05, much_round = 1.2, much_longer = 1.4, swollen = 1.25, lost_bend = 10.0;
  const knit::KnittedFigures& made = air.figures;
  const double cm = stitch.centimetres_per_unit;
  Json all = Json::array();
  const auto add = [&](knit::RowId row, const std::string& what) {
    all.push_back({{"row", row}, {"what", what}});
  };
  if (std::abs(made.knitted.height - made.placed.height) > far_off * made.placed.height ||
      std::abs(made.knitted.width - made.placed.width) > far_off * made.placed.width)
    add(0, "Knitted and stuffed, this comes out " + decimals(made.knitted.height * cm, 1) + " cm high and " +
               decimals(made.knitted.width * cm, 1) + " cm wide; the mesh asks for " +
               decimals(made.placed.height * cm, 1) + " cm and " + decimals(made.placed.width * cm, 1) +
               " cm.");
  for (std::size_t end = 0; end < made.sunk.size(); ++end) {
    if (made.sunk[end] > 0.5 * stitch.height)
      add(end == 0 ? 1 : fabric.row_count(), std::string(end == 0 ? "The first" : "The last") +
                                                 " row sinks in by " +
                                                 decimals(made.sunk[end] * cm * 10.0, 0) +
                                                 " mm: the rows beside it grow faster than a flat disc.");
  }
  if (made.out_of_round && made.out_of_round->share > much_round)
    add(made.out_of_round->row, "Row " + std::to_string(made.out_of_round->row) + " is out of round by " +
                                    percent(made.out_of_round->share - 1.0) +
                                    ": shaping stands in the same wales, or it lies on a bend.");
  if (made.greatest.share > much_longer)
    add(made.greatest.row, "Stitches of row " + std::to_string(made.greatest.row) + " are stretched by " +
                               percent(made.greatest.share - 1.0) + ".");
  if (made.bend_placed - made.bend_knitted > lost_bend)
    add(1, "The bend is lost: knitted in rounds this comes out straighter (" + decimals(made.bend_placed, 0) +
               " degrees become " + decimals(made.bend_knitted, 0) + "); short rows keep it.");
  for (const knit::TurnedTube& tube : made.turned)
    add(tube.row, "The tube that begins with row " + std::to_string(tube.row) + " turns by " +
                      decimals(tube.degrees, 0) + " degrees: knitted, it stands otherwise than the mesh.");
  if (made.volume_share > swollen)
    add(0, "Stuffed, it swells: it holds " + percent(made.volume_share - 1.0) + " more than the mesh.");
  for (const auto& [low, high] : made.touching)
    add(low, "Rows " + std::to_string(low) + " and " + std::to_string(high) + " touch.");
  if (!air.relaxed.settled)
    add(0, "After " + std::to_string(air.relaxed.iterations) + " iterations stitches still move by " +
               decimals(100.0 * air.relaxed.last_move, 1) + " % of their width.");
  return all;
}

}  // namespace

Json knitted_json(const Session& session) {
  if (relaxed_missing(session)) return nullptr;
  const knit::Fabric fabric = shown_fabric(session);
  const InTheAir air = in_the_air(session, fabric);
  const knit::KnittedFigures& made = air.figures;
  const knit::StitchSize& stitch = session.document->timeline.parameters().stitch;
  const double cm = stitch.centimetres_per_unit;
  Json json;
  json["height_cm"] = made.knitted.height * cm;
  json["width_cm"] = made.knitted.width * cm;
  json["asked_height_cm"] = made.placed.height * cm;
  json["asked_width_cm"] = made.placed.width * cm;
  json["sunk_cm"] = {made.sunk[0] * cm, made.sunk[1] * cm};
  json["out_of_round"] = made.out_of_round ? Json(made.out_of_round->share) : Json(nullptr);
  json["stretch"] = {{"min", made.least.share}, {"max", made.greatest.share}};
  json["iterations"] = air.relaxed.iterations;
  json["problems"] = problems_of(fabric, air, stitch);
  return json;
}

std::string relaxed_text(const Session& session) {
  const knit::Fabric fabric = shown_fabric(session);
  return mesh_text_of(fabric.moved_to(in_the_air(session, fabric).relaxed.positions),
                      "# Stitches where they come to lie in the air, stuffed.\n");
}

std::optional<std::string> relaxed_missing(const Session& session) {
  if (session.document->timeline.state().finished()) return std::nullopt;
  return "how the piece comes off the needles is known when it is finished; run to the end first.";
}

}  // namespace app
