#include "knit/model/measured.h"
#include "knit/model/words.h"
#include "knit/tubes/tubes_events.h"
#include "knit/tubes/tubes_variables.h"

namespace knit {

namespace {

std::string_view word_of(NodeKind kind) {
  switch (kind) {
    case NodeKind::minimum:
      return "minimum";
    case NodeKind::split:
      return "split";
    case NodeKind::join:
      return "join";
    case NodeKind::maximum:
      return "maximum";
  }
  return "";
}

std::string_view does(NodeKind kind) {
  switch (kind) {
    case NodeKind::minimum:
      return "a tube begins at a lowest point";
    case NodeKind::split:
      return "one tube parts into two";
    case NodeKind::join:
      return "two tubes meet and go on as one";
    case NodeKind::maximum:
      return "a tube ends at a highest point";
  }
  return "";
}

std::string together_sentence(const TubeLeftOut& left, const std::string& size) {
  const std::string of = "at most " + short_number(0.01 * left.at_most) + " % of the surface";
  if (left.together == 1)
    return "A limb at " + vertex_text(left.vertex) + ", " + size + ", is left out; it is " + of + ".";
  return std::to_string(left.together) + " limbs lower than a twentieth of a round are left out, together " +
         of + "; the highest, at " + vertex_text(left.vertex) + ", is " + size + ".";
}

// What is counted is told by knit/order/limb_order.h.
std::string decided_by(std::int32_t tried) {
  if (tried == 0) return "";
  if (tried == 1) return "; there is no other order";
  return "; of " + plural(tried, "order", "orders") +
         " tried it costs a knitter least: in yarns above all, in holders, in twins that are torn apart "
         "and in stitches slipped for the marker";
}

}  // namespace

std::string FieldSmoothed::sentence(const Telling& /*at*/) const {
  return "The time's level sets fall into " + plural(tubes, "tube", "tubes") + "; it is smoothed over " +
         short_number(length) + ", so that what is smaller than a stitch makes none.";
}
StepFields FieldSmoothed::numbers() const { return {{var::raw_tubes, tubes}, {var::smoothing, length}}; }

std::string GraphFound::sentence(const Telling& /*at*/) const {
  std::string text = "From end to end the level sets form " + plural(tubes, "tube", "tubes") + " between " +
                     plural(nodes, "critical vertex", "critical vertices");
  if (loops > 0) text += ", with " + plural(loops, "loop", "loops") + ": so many handles the surface has";
  return text + ".";
}
StepFields GraphFound::numbers() const {
  return {{var::tubes, tubes}, {var::nodes, nodes}, {var::graph_loops, loops}, {var::unfolded, unfolded}};
}

std::string NodeFound::sentence(const Telling& /*at*/) const {
  return "At " + vertex_text(vertex) + ", t = " + short_number(value) + ", " + std::string(does(node)) + ".";
}
StepFields NodeFound::numbers() const {
  return {{"vertex", &var::node, vertex},
          {var::node_kind, word_of(node)},
          {"value", &var::field_value, value},
          {var::closed, closed},
          {var::opened, opened}};
}

std::string TubeLeftOut::sentence(const Telling& /*at*/) const {
  const std::string size = measured(static_cast<double>(rows), "round", "rounds") + " high and " +
                           measured(static_cast<double>(stitches), "stitch", "stitches") + " round";
  if (together > 0) return together_sentence(*this, size);
  const std::string instead =
      keeps > 0.0F ? "; a stitch " + short_number(static_cast<double>(keeps)) + " wide would keep it." : ".";
  if (handle)
    return "A hole at " + vertex_text(vertex) + ", its thinner side " + size +
           ", is too small for this stitch and is left out" + instead;
  return "A limb at " + vertex_text(vertex) + ", " + size + ", is smaller than a round and is left out" +
         instead;
}
StepFields TubeLeftOut::numbers() const {
  return {{var::handle, handle},
          {"vertex", &var::node, vertex},
          {"rows", &var::leaf_rows, static_cast<double>(rows)},
          {"stitches", &var::leaf_girth, static_cast<double>(stitches)},
          {var::keeps, static_cast<double>(keeps)},
          {"together", &var::together, together},
          {"share", &var::left_share, 1e-4 * at_most}};
}

std::string TubesPlanned::sentence(const Telling& /*at*/) const {
  if (tubes == 1) return "One tube from end to end: " + plural(rows, "round", "rounds") + ".";
  return plural(tubes, "tube", "tubes") + " with " + plural(rows, "round", "rounds") +
         " in all, worked with " + plural(yarns, "yarn", "yarns") + " and " +
         (held == 0 ? "no holder" : plural(held, "holder at once", "holders at once")) + decided_by(tried) +
         ".";
}
StepFields TubesPlanned::numbers() const {
  StepFields fields{{var::tubes, tubes},   {"rows", &var::planned_rows, rows},
                    {var::events, events}, {var::held, held},
                    {var::yarns, yarns},   {var::exact, exact}};
  if (tried > 0) fields.emplace_back(var::orders_tried, tried);
  return fields;
}

std::string tubes_stop_sentence(const Stopped& stop) {
  switch (stop.reason) {
    case StopReason::too_many_tubes:
      return "Tubes: along this time the surface falls into " + plural(stop.count, "tube", "tubes") +
             ", which is noise; smooth the time over a longer length, or choose another timing.";
    case StopReason::no_row_levels:
      return "Tubes: the shape holds " +
             (stop.level == 0 ? "no round" : plural(stop.level, "round", "rounds")) +
             " of these stitches, which makes no tube; make them narrower than " + short_number(stop.value) +
             ".";
    default:
      return "Tubes: stitches as small as these make " +
             (stop.value > 0.0 ? short_number(stop.value) + " stitches" : plural(stop.count, "row", "rows")) +
             ", more than the " + std::to_string(stop.other) +
             " that can be worked; make them wider or higher.";
  }
}

}  // namespace knit
