// A closed curve that a person gives: where knitting begins or ends. What was clicked is kept, not the way found from
// it, so that the same curve can be laid on a finer export of the mesh. Its text form is what the options take:
//   boundary            the only edge of the mesh, or the lowest        boundary:X,Y,Z      the edge nearest to a point
//   circle:X,Y,Z,R      all at the distance R on the surface            circle:X,Y,Z        R as for a cast on of 6 stitches
//   band:R;X,Y,Z;...    all at the distance R from an open path
//   plane:X,Y,Z;X,Y,Z;X,Y,Z, or a point and a normal, plane:X,Y,Z,NX,NY,NZ
//   path:X,Y,Z;X,Y,Z;...  shortest ways from point to point, closed
//   farthest            a circle about the vertex farthest from the start
//   17                  a circle about vertex 17
// Mesh units. Errors are one sentence.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

enum class CycleEnd : std::uint8_t { start, end };
enum class CycleKind : std::uint8_t { boundary, circle, band, plane, path, farthest, vertex };

struct Cycle {
  CycleEnd as = CycleEnd::start;
  std::string name;  // for people; empty: "start" or "end"
  CycleKind kind = CycleKind::boundary;
  std::vector<glm::dvec3> points;    // as clicked; near the surface
  std::optional<double> radius;      // of circle, band and vertex; none: of a cast on of 6 stitches
  std::optional<glm::dvec3> normal;  // of a plane with one point
  VertexId vertex = no_vertex;       // of kind vertex
  std::optional<double> value;       // its time in [0, 1]; none: 0 at a start, 1 at an end
  friend bool operator==(const Cycle&, const Cycle&) = default;
};

std::string_view word_of(CycleEnd as);     // "start"
std::string_view word_of(CycleKind kind);  // "circle"
std::optional<CycleKind> cycle_kind(std::string_view word);
std::string called(const Cycle& cycle);  // its name, or else "start" or "end"
double time_of(const Cycle& cycle);

std::variant<Cycle, std::string> parse_cycle(std::string_view text, CycleEnd as);
// What parse_cycle reads as the same curve; its name and value are not part of it.
std::string cycle_text(const Cycle& cycle);

}  // namespace knit
