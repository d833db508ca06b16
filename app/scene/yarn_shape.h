// The yarn of a piece as a renderer draws it: control points of curves, and the pieces of them that loops are.
//
// Curves are uniform Catmull-Rom ones [knit/yarn/yarn_curve.h]. A piece is `spans` spans from point `first` on, and one point
// before them and one after are there too. Of a point the fourth number is the twist of the plies there, in turns. Mesh units.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "app/scene/colour.h"

namespace app {

struct YarnShape {
  struct Piece {
    std::uint32_t first = 0, spans = 0;
    Colour colour;
    glm::vec3 centre{0.0f};
    glm::vec3 from_out{0.0f}, to_out{0.0f};  // outwards of the piece where it begins and ends, of length 1
  };
  std::vector<glm::vec4> points;
  std::vector<Piece> pieces;
  float radius = 0.0f;
  float width = 0.0f;   // of a stitch
  bool closed = false;  // nobody sees its inner side from outside
};

// How finely pieces are drawn, by how wide a stitch is on the screen.
struct YarnDetail {
  int parts = 3;   // straight ones a piece
  int across = 2;  // vertices: 3 have a raised middle, so that crossings are right where they are seen to be
  bool plies = false;
  friend bool operator==(const YarnDetail&, const YarnDetail&) = default;
};
constexpr YarnDetail yarn_detail(double stitch_px) {
  if (stitch_px < 4.0) return {};
  if (stitch_px < 8.0) return {4, 2, false};
  if (stitch_px < 14.0) return {6, 2, false};
  if (stitch_px < 30.0) return {8, 2, false};
  if (stitch_px < 56.0) return {10, 3, true};
  if (stitch_px < 90.0) return {20, 3, true};
  return {40, 3, true};
}

// Of what looks away: it is seen through openings only.
constexpr YarnDetail yarn_detail_behind(const YarnDetail& detail) {
  return {detail.parts > 20 ? 20 : detail.parts > 8 ? 6 : 3, 2, false};
}

}  // namespace app
