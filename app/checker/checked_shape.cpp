#include "app/checker/checked_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <numbers>

namespace app {

namespace {

constexpr double most_stitches = 1e5;
constexpr std::size_t most_drawn = 1500;  // rounds
constexpr double gap_share = 0.35;        // between pieces, of the widest

double half_of(const knit::CheckedRound& round, bool flat, double width) {
  const double length = std::clamp(static_cast<double>(round.stitches), 0.0, most_stitches) * width;
  return flat ? 0.5 * length : length / (2.0 * std::numbers::pi);
}

PlacedPiece placed(const knit::CheckedPiece& piece, double width, double height) {
  PlacedPiece made;
  made.flat = piece.flat;
  made.name = piece.name;
  if (piece.made > 1) made.name += (made.name.empty() ? "" : ", ") + std::to_string(piece.made) + " of them";
  made.rounds.reserve(piece.rounds.size());
  double at = 0.0;
  for (const knit::CheckedRound& round : piece.rounds) {
    const double half = half_of(round, piece.flat, width);
    if (!made.rounds.empty()) {
      const double slope = piece.flat ? 0.0 : half - made.rounds.back().half;
      at += std::sqrt(std::max(0.0, height * height - slope * slope));
    }
    made.rounds.push_back({round.line, round.stitches, half, at});
    made.half = std::max(made.half, half);
  }
  return made;
}

knit::Bounds bounds_of(const std::vector<PlacedPiece>& pieces) {
  knit::Bounds bounds;
  if (pieces.empty()) return {glm::dvec3(-1.0), glm::dvec3(1.0), 1.0};
  bounds.low = glm::dvec3(std::numeric_limits<double>::infinity());
  bounds.high = -bounds.low;
  for (const PlacedPiece& piece : pieces) {
    const double deep = piece.flat ? 0.0 : piece.half;
    bounds.low = glm::min(bounds.low, glm::dvec3(piece.middle - piece.half, 0.0, -deep));
    bounds.high =
        glm::max(bounds.high, glm::dvec3(piece.middle + piece.half, piece.rounds.back().height, deep));
  }
  bounds.radius = 0.5 * glm::length(bounds.high - bounds.low);
  return bounds;
}

struct Ray {
  glm::dvec3 origin, direction;
};

// Distance along the ray to a triangle, from either side (Moeller and Trumbore); none: infinity.
double distance_to(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return none;
  const glm::dvec3 from = ray.origin - a;
  const double u = glm::dot(from, p) / determinant;
  const glm::dvec3 q = glm::cross(from, ab);
  const double v = glm::dot(ray.direction, q) / determinant;
  const double along = glm::dot(ac, q) / determinant;
  constexpr double slack = 1e-9;  // no ray slips through between two triangles
  return u < -slack || v < -slack || u + v > 1.0 + slack || along <= 0.0 ? none : along;
}

// To the band between two rounds.
double distance_to_band(const Ray& ray, const std::vector<glm::dvec3>& low,
                        const std::vector<glm::dvec3>& high, bool flat) {
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t faces = flat ? 1 : low.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const std::size_t next = (i + 1) % low.size();
    nearest = std::min(nearest, distance_to(ray, low[i], low[next], high[next]));
    nearest = std::min(nearest, distance_to(ray, low[i], high[next], high[i]));
  }
  return nearest;
}

}  // namespace

CheckedShape shape_of(const knit::CheckedSize& size, const CheckedGauge& gauge) {
  constexpr double gauge_cm = 10.0;
  const double width = gauge_cm / std::clamp(gauge.stitches, least_gauge, most_gauge);
  const double height = gauge_cm / std::clamp(gauge.rows, least_gauge, most_gauge);
  CheckedShape shape;
  double widest = 0.0;
  for (const knit::CheckedPiece& piece : size.pieces) {
    if (piece.rounds.empty()) continue;
    PlacedPiece made = placed(piece, width, height);
    if (made.half <= 0.0) continue;
    widest = std::max(widest, made.half);
    shape.pieces.push_back(std::move(made));
  }
  double at = 0.0;
  for (PlacedPiece& piece : shape.pieces) {
    piece.middle = at + piece.half;
    at = piece.middle + piece.half + 2.0 * gap_share * widest;
    if (piece.name.empty() && shape.pieces.size() > 1)
      piece.name = "Piece " + std::to_string(1 + (&piece - shape.pieces.data()));
  }
  shape.bounds = bounds_of(shape.pieces);
  return shape;
}

std::vector<glm::dvec3> corners_of(const PlacedPiece& piece, const PlacedRound& round) {
  if (piece.flat)
    return {{piece.middle - round.half, round.height, 0.0}, {piece.middle + round.half, round.height, 0.0}};
  std::vector<glm::dvec3> corners;
  corners.reserve(ring_corners);
  for (std::size_t i = 0; i < ring_corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(ring_corners);
    corners.emplace_back(piece.middle + round.half * std::sin(angle), round.height,
                         round.half * std::cos(angle));
  }
  return corners;
}

std::size_t stride_of(const CheckedShape& shape) {
  std::size_t rounds = 0;
  for (const PlacedPiece& piece : shape.pieces) rounds += piece.rounds.size();
  return 1 + rounds / most_drawn;
}

std::optional<std::size_t> line_under(const CheckedShape& shape, const Sight& sight,
                                      const glm::dvec2& place) {
  const glm::dmat4 back = glm::inverse(glm::dmat4(sight.projection) * glm::dmat4(sight.view));
  const glm::dvec4 far = back * glm::dvec4(place.x, place.y, 1.0, 1.0);
  const glm::dvec3 eye(sight.eye);
  const Ray ray{eye, glm::normalize(glm::dvec3(far) / far.w - eye)};
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> line;
  for (const PlacedPiece& piece : shape.pieces) {
    std::vector<glm::dvec3> below = corners_of(piece, piece.rounds.front());
    for (std::size_t i = 1; i < piece.rounds.size(); ++i) {
      std::vector<glm::dvec3> above = corners_of(piece, piece.rounds[i]);
      const double distance = distance_to_band(ray, below, above, piece.flat);
      if (distance < nearest) {
        nearest = distance;
        line = piece.rounds[i].line;
      }
      below = std::move(above);
    }
  }
  return line;
}

}  // namespace app
