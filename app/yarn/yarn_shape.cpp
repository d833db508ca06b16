#include "app/yarn/yarn_shape.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/scene/stretch_colour.h"
#include "knit/yarn/eased_yarn.h"
#include "knit/yarn/worked_from.h"

namespace app {

namespace {

// Plies twist once round in so many radii.
constexpr float radii_a_turn = 5.0F;

knit::Label label_of(knit::LoopKind kind) {
  switch (kind) {
    case knit::LoopKind::cast_on:
    case knit::LoopKind::bridge:
      return knit::Label::cast;
    case knit::LoopKind::k2tog:
      return knit::Label::k2tog;
    case knit::LoopKind::ssk:
      return knit::Label::ssk;
    case knit::LoopKind::m1l:
      return knit::Label::m1l;
    case knit::LoopKind::m1r:
      return knit::Label::m1r;
    case knit::LoopKind::picked_up:
    case knit::LoopKind::knit:
      break;
  }
  return knit::Label::knit;
}

bool is_of_loop(knit::YarnPart part) { return part == knit::YarnPart::loop || part == knit::YarnPart::bar; }

glm::vec3 unit(const glm::vec3& way) {
  const float length = glm::length(way);
  return length > 0.0F ? way / length : glm::vec3(0.0F, 0.0F, 1.0F);
}

// Appends one curve: all its points with one more at either end, and the pieces of it that are made.
class CurveShape {
 public:
  CurveShape(const knit::YarnCurve& curve, const YarnUpTo& until, std::span<const glm::vec3> out,
             std::span<const Colour> colours, YarnShape& shape)
      : curve_(curve), until_(until), out_(out), colours_(colours), shape_(shape) {}

  void add() {
    if (curve_.points.size() < 2) return;
    base_ = static_cast<std::uint32_t>(shape_.points.size()) + 1;
    add_points();
    std::size_t begin = 0;
    std::uint32_t loop = curve_.stitches[0];  // the last one that the yarn came by
    for (std::size_t i = 1; i < curve_.points.size(); ++i) {
      // A span belongs to what its first point is of, so that loops begin where they come out of the fabric. Before a lifted
      // strand a loop has one span more.
      const bool goes_on = curve_.stitches[i] == curve_.stitches[begin] &&
                           curve_.parts[i] == curve_.parts[begin] && i - begin <= knit::points_a_stitch;
      if (goes_on && i + 1 < curve_.points.size()) continue;
      if (curve_.parts[begin] == knit::YarnPart::loop) loop = curve_.stitches[begin];
      add_piece(begin, i, loop);
      begin = i;
    }
    join_ways();
  }

 private:
  void add_points() {
    const auto& at = curve_.points;
    const float a_turn = radii_a_turn * static_cast<float>(curve_.radius);
    float along = 0.0F;
    const auto put = [&](const glm::dvec3& place) { shape_.points.emplace_back(glm::vec3(place), along); };
    put(2.0 * at[0] - at[1]);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (i > 0) along += static_cast<float>(glm::distance(at[i - 1], at[i])) / a_turn;
      put(at[i]);
    }
    put(2.0 * at.back() - at[at.size() - 2]);
  }

  // A strand lifted for a stitch above lies between two loops of its own row, and is there with them.
  void add_piece(std::size_t begin, std::size_t end, std::uint32_t loop) {
    const knit::YarnPart part = curve_.parts[begin];
    const std::uint32_t stitch = curve_.stitches[begin];
    const std::uint32_t with = part == knit::YarnPart::bar ? loop : stitch;
    if (!until_.whole && (!is_of_loop(part) || with >= until_.stitches)) return;
    glm::vec3 centre(0.0F);
    for (std::size_t i = begin; i <= end; ++i) centre += glm::vec3(curve_.points[i]);
    centre /= static_cast<float>(end - begin + 1);
    const glm::vec3 out = out_[with];
    shape_.pieces.push_back({base_ + static_cast<std::uint32_t>(begin),
                             static_cast<std::uint32_t>(end - begin), colours_[with], centre, out, out});
  }

  // Where two pieces meet, half way between both.
  void join_ways() {
    for (std::size_t i = 1; i < shape_.pieces.size(); ++i) {
      YarnShape::Piece& a = shape_.pieces[i - 1];
      YarnShape::Piece& b = shape_.pieces[i];
      if (b.first < base_ || a.first + a.spans != b.first) continue;
      a.to_out = b.from_out = unit(a.to_out + b.from_out);
    }
  }

  const knit::YarnCurve& curve_;
  const YarnUpTo& until_;
  std::span<const glm::vec3> out_;
  std::span<const Colour> colours_;
  YarnShape& shape_;
  std::uint32_t base_ = 0;
};

}  // namespace

knit::Yarn yarn_as_looked(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                          const knit::StitchSize& stitch, const YarnLook& look) {
  return knit::eased_yarn(knit::make_yarn(fabric, positions, stitch, look.radius * stitch.width),
                          stitch.width, look.easing);
}

std::vector<glm::vec3> outwards(const knit::Fabric& fabric, std::span<const glm::dvec3> positions) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (const auto& strip : fabric.strips()) {
    for (const knit::Face& face : strip->faces) {
      const auto corner = [&](std::size_t i) { return positions[face.corners[i]]; };
      glm::dvec3 area = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
      if (face.corner_count == 4) area += glm::cross(corner(2) - corner(0), corner(3) - corner(0));
      for (std::int32_t i = 0; i < face.corner_count; ++i)
        sums[face.corners[static_cast<std::size_t>(i)]] += area;
    }
  }
  std::vector<glm::vec3> out;
  out.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    out.emplace_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0F));
  }
  return out;
}

std::vector<std::int32_t> rounds_of_stitches(const knit::Fabric& fabric) {
  std::vector<std::int32_t> rounds(fabric.stitch_count(), 0);
  std::vector<std::int32_t> done;  // of each tube
  for (const auto& row : fabric.rows()) {
    const auto tube = static_cast<std::size_t>(row->tube);
    if (done.size() <= tube) done.resize(tube + 1, 0);
    for (const std::uint32_t stitch : fabric.path_indices(knit::all_of(*row))) rounds[stitch] = done[tube];
    if (!knit::is_short(*row)) ++done[tube];
  }
  return rounds;
}

std::vector<double> stretch_of_stitches(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                                        const knit::StitchSize& stitch) {
  struct Sum {
    double all = 0.0;
    int count = 0;
    void add(double stretch) {
      all += stretch;
      ++count;
    }
  };
  std::vector<Sum> sums(positions.size());
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    return glm::distance(positions[a], positions[b]);
  };
  for (const auto& row : fabric.rows()) {
    const std::vector<std::uint32_t> numbers = fabric.path_indices(knit::all_of(*row));
    for (std::size_t i = 1; i < numbers.size(); ++i)
      sums[numbers[i]].add(between(numbers[i - 1], numbers[i]) / stitch.width);
  }
  for (const auto& strip : fabric.strips()) {
    for (const auto& [below, above] : strip->column_edges)
      sums[above].add(between(below, above) / stitch.height);
  }
  std::vector<double> stretches;
  stretches.reserve(sums.size());
  for (const Sum& sum : sums) stretches.push_back(sum.count > 0 ? sum.all / sum.count : 1.0);
  return stretches;
}

std::vector<Colour> yarn_colours(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                                 const knit::StitchSize& stitch, const YarnLook& look, const Theme& theme) {
  std::vector<Colour> colours(fabric.stitch_count(), look.wool);
  switch (look.by) {
    case YarnColours::label: {
      const auto worked = knit::worked_from(fabric);
      for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = theme.of(label_of(worked[i].kind));
      break;
    }
    case YarnColours::stretch: {
      const auto stretches = stretch_of_stitches(fabric, positions, stitch);
      for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i] = stretch_colour(theme, stretches[i], full_in_the_air);
      break;
    }
    case YarnColours::wool: {
      if (look.stripe_rounds < 1) break;
      const auto rounds = rounds_of_stitches(fabric);
      for (std::size_t i = 0; i < colours.size(); ++i)
        if (rounds[i] / look.stripe_rounds % 2 == 1) colours[i] = look.second;
      break;
    }
  }
  return colours;
}

YarnShape yarn_shape(const knit::Yarn& yarn, const YarnUpTo& until, std::span<const glm::vec3> out,
                     std::span<const Colour> colours) {
  YarnShape shape;
  for (const knit::YarnCurve& curve : yarn.curves) CurveShape(curve, until, out, colours, shape).add();
  if (!yarn.curves.empty()) shape.radius = static_cast<float>(yarn.curves[0].radius);
  return shape;
}

FaceShape yarn_ground(const knit::Fabric& fabric, std::span<const glm::dvec3> positions,
                      const YarnUpTo& until, std::span<const glm::vec3> out, float by, Colour colour) {
  FaceShape ground;
  for (const auto& strip : fabric.strips()) {
    for (const knit::Face& face : strip->faces) {
      FaceShape::Face moved{{}, glm::vec3(0.0F), colour};
      bool made = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const bool is_corner = static_cast<std::int32_t>(i) < face.corner_count;
        const std::uint32_t stitch = face.corners[is_corner ? i : 2];
        made = made && (until.whole || stitch < until.stitches);
        moved.corners.at(i) = glm::vec3(positions[stitch]) - by * out[stitch];
      }
      if (!made) continue;
      moved.normal =
          unit(glm::cross(moved.corners[1] - moved.corners[0], moved.corners[2] - moved.corners[0]));
      ground.faces.push_back(moved);
    }
  }
  return ground;
}

}  // namespace app
