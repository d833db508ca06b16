#include "knit/timing/timing_events.h"

#include "knit/model/words.h"
#include "knit/timing/timing_variables.h"

namespace knit {

namespace {

std::string_view word_of(FieldStep step) {
  switch (step) {
    case FieldStep::net:
      return "net";
    case FieldStep::heat:
      return "heat";
    case FieldStep::slopes:
      return "slopes";
    case FieldStep::distance:
      return "distance";
    case FieldStep::harmonic:
      return "harmonic";
  }
  return "";
}

}  // namespace

std::string EndsFound::sentence(const Telling& /*at*/) const {
  return "The time runs from " + vertex_text(start) + " (t = 0) to " + vertex_text(end) +
         " (t = 1), over a length of " + short_number(length) + ".";
}
StepFields EndsFound::numbers() const {
  return {{var::start, start}, {var::end, end}, {"length", &var::mag, length}};
}

std::string TimingChosen::sentence(const Telling& /*at*/) const {
  const std::string lies = percent_text(flat) + " of the surface lies flat across the axis";
  const std::string varies = "the distance between rows varies by " + percent_text(unevenness);
  if (timing == TimingKind::linear)
    return "Timing by itself: linear, along the axis, as only " + lies + ", and " + varies + ".";
  const std::string geodesic = "Timing by itself: geodesic, along the surface, because ";
  if (for_flat)
    return geodesic + lies + ", as at " + vertex_text(vertex) + ", where linear timing has no rows.";
  return geodesic + "along the axis " + varies + ", most at " + vertex_text(vertex) + ".";
}
StepFields TimingChosen::numbers() const {
  return {{var::timing_kind, timing == TimingKind::linear ? "linear" : "geodesic"},
          {var::flat, flat},
          {var::unevenness, unevenness},
          {var::worst, vertex}};
}

std::string FieldSolved::sentence(const Telling& /*at*/) const {
  switch (which) {
    case FieldStep::net:
      return "The surface is laid out as a net of " + plural(count, "triangle", "triangles") +
             " by edge lengths, its edges flipped until all are Delaunay.";
    case FieldStep::heat:
      return "Heat put in at " + vertex_text(vertex) + " spreads over the surface for a short while.";
    case FieldStep::slopes:
      return "In each of " + plural(count, "triangle", "triangles") +
             " the slope of the heat is turned round and made 1: it points away from the start.";
    case FieldStep::distance:
      return "The distance along the surface is the function with these slopes; farthest is " +
             vertex_text(vertex) + ", " + short_number(high) + " away.";
    case FieldStep::harmonic:
      return "The harmonic field is solved for: 0 at the start, 1 at the end, and at each other vertex the "
             "weighted mean of its neighbours.";
  }
  return "";
}
StepFields FieldSolved::numbers() const {
  const bool distance = which == FieldStep::distance;
  const CodeVariable* counted = which == FieldStep::net      ? &var::net
                                : which == FieldStep::slopes ? &var::slopes
                                                             : &var::unknowns;
  return {{"part", nullptr, word_of(which)},
          {"vertex", distance ? &var::end : nullptr, vertex},
          {"count", counted, count},
          {"high", distance ? &var::far : nullptr, high}};
}

std::string HeightsMeasured::sentence(const Telling& /*at*/) const {
  return "From start to end the surface is " + short_number(height) +
         " high; equal steps of time shall be equally high on it.";
}
StepFields HeightsMeasured::numbers() const { return {{var::height, height}, {var::bands, bands}}; }

std::string VertexTimed::sentence(const Telling& /*at*/) const {
  const std::string text = "Vertex " + std::to_string(vertex) + " gets the time t = " + short_number(time);
  return clamped ? text + ", clamped: it lies beyond the chosen start or end." : text + ".";
}
StepFields VertexTimed::numbers() const {
  return {{var::vertex, vertex}, {var::time, time}, {var::clamped, clamped}};
}

std::string CriticalsFound::sentence(const Telling& /*at*/) const {
  return "The time has " + plural(minima, "minimum", "minima") + ", " + plural(saddles, "saddle", "saddles") +
         " and " + plural(maxima, "maximum", "maxima") + ": " + std::to_string(minima) + " - " +
         std::to_string(saddles) + " + " + std::to_string(maxima) + " = " +
         std::to_string(std::int64_t{minima} - saddles + maxima) +
         (minima - saddles + maxima == euler ? ", the" : ", but not the") + " Euler characteristic " +
         std::to_string(euler) + ".";
}
StepFields CriticalsFound::numbers() const {
  return {{var::minima, minima}, {var::saddles, saddles}, {var::maxima, maxima}, {var::euler, euler}};
}

std::string LevelsGrouped::sentence(const Telling& /*at*/) const {
  std::string text = "The vertices fall into " + plural(levels, "level", "levels") + " of equal time";
  if (split_level >= 0) {
    return text + "; from level " + std::to_string(split_level) + " on, a level set has " +
           std::to_string(split_loops) + " loops.";
  }
  return text + "; every level set is a single loop.";
}
StepFields LevelsGrouped::numbers() const {
  return {{var::levels, levels},
          {var::tolerance, tolerance},
          {var::outside, outside},
          {var::split_level, split_level},
          {var::split_loops, split_loops}};
}

std::string timing_stop_sentence(const Stopped& stop) {
  if (stop.reason == StopReason::open_edge && stop.count > 2)
    return "Timing: the mesh has " + std::to_string(stop.count) + " open edges, the first at " +
           vertex_text(stop.vertex) +
           ", and a piece begins at one and ends at one other: close all others (--mend openings closes "
           "all).";
  if (stop.reason == StopReason::open_edge)
    return "Timing: the mesh has " + plural(stop.count, "open edge", "open edges") + ", the first at " +
           vertex_text(stop.vertex) +
           ", and only harmonic timing runs from edge to edge, with rows from contours: take --timing auto "
           "or "
           "harmonic and --rows auto or contours, or close the mesh (--mend openings).";
  return "Timing: start and end lie at the same time along this axis; choose another axis or other end "
         "vertices.";
}

}  // namespace knit
