#include "knit/rows/choice.h"

#include "knit/model/words.h"
#include "knit/rows/ring.h"
#include "knit/rows/row_variables.h"

namespace knit {

namespace {

constexpr std::int32_t fewest_rings = 3;

}  // namespace

RowsChosen choose_rows(const Input& input, const Timing& timing) {
  RowsChosen chosen{RowSource::contours, RowsReason::field, 0, 0, no_vertex};
  const bool along_axis = timing.kind == TimingKind::linear || timing.kind == TimingKind::arc_length;
  if (!along_axis || input.mesh.triangles.size() > most_ringed_triangles) return chosen;
  const Levels& levels = timing.levels;
  if (levels.split) {
    return {RowSource::contours, RowsReason::parts, levels.split->level, levels.split->loops,
            levels.split->vertex};
  }
  for (std::int32_t level = 1; level + 1 < levels.count(); ++level, ++chosen.level) {
    const auto vertices = levels.level(level);
    if (std::holds_alternative<Ring>(order_ring(input, timing.ends, vertices))) continue;
    return {RowSource::contours, RowsReason::no_ring, level, static_cast<std::int32_t>(vertices.size()),
            vertices.front()};
  }
  chosen.reason = chosen.level < fewest_rings ? RowsReason::few : RowsReason::rings;
  if (chosen.reason == RowsReason::rings) chosen.source = RowSource::rings;
  return chosen;
}

std::string RowsChosen::sentence(const Telling& /*at*/) const {
  const std::string contours = "Rows by themselves: from contours, because ";
  switch (reason) {
    case RowsReason::rings:
      return "Rows by themselves: from rings, because all " + std::to_string(level) +
             " levels between the ends are rings of the mesh, and none parts.";
    case RowsReason::field:
      return contours + "the mesh is not looked through for rings, which this time would hardly have.";
    case RowsReason::parts:
      return contours + "level " + std::to_string(level) + " has " + std::to_string(count) +
             " loops, and rings follow a single one (the saddle is " + vertex_text(vertex) + ").";
    case RowsReason::no_ring:
      return contours + "the " + plural(count, "vertex", "vertices") + " of level " + std::to_string(level) +
             " form no closed ring (" + vertex_text(vertex) + ").";
    case RowsReason::few:
      return contours + "the mesh has only " + plural(level, "ring", "rings") + " between its ends.";
  }
  return "";
}

StepFields RowsChosen::numbers() const {
  StepFields fields{{var::rows_from, source == RowSource::rings ? "rings" : "contours"},
                    {var::level, level},
                    {var::count, count}};
  if (vertex != no_vertex) fields.emplace_back(var::without_ring, vertex);
  return fields;
}

}  // namespace knit
