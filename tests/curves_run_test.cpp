// Pieces between cycles, knitted from one to the other, as evenly as was worked out apart from this program
// (as rows come from their levels, before anything settles); and that such a piece never parts.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "knit/curves/between.h"
#include "knit/curves/cons_file.h"
#include "knit/curves/embed.h"
#include "knit/import/obj.h"
#include "knit/mesh/union_find.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/quality.h"
#include "knit/rows/first_choice.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/cons_bytes.h"
#include "tests/support/cycles.h"

using namespace knit;
using namespace test_support;

namespace {

Parameters level_rows_of(const Input& input, double width) {
  Parameters p = first_parameters(input);
  give_width(p, width);
  give_height(p, width);
  p.settle.settling = Settling::off;
  p.short_rows.rows = ShortRows::off;
  return resolved(p, input);
}

struct Knitted {
  bool finished = false;
  int stitches = 0;
  Quality quality;
};

Knitted knit_between(const Mesh& mesh, const std::vector<Cycle>& cycles, double width) {
  const auto input = input_of(between(mesh, cycles, width));
  Timeline run(input, level_rows_of(*input, width));
  run.extend_to_end();
  Knitted knitted{.finished = run.furthest().finished(), .stitches = 0, .quality = {}};
  if (!knitted.finished) return knitted;
  for (const auto& row : run.furthest().fabric.rows()) knitted.stitches += size_of(*row);
  knitted.quality = measure_quality(*input, run.furthest(), width, width);
  return knitted;
}

// Within 10 %, and of an evenness near 0 within a hundredth.
void check_evenness(const Knitted& knitted, int stitches, double wale_cv) {
  INFO(knitted.stitches << " stitches, wale cv " << knitted.quality.wale.cv << ", high "
                        << knitted.quality.wale.high << ", course cv " << knitted.quality.course.cv);
  REQUIRE(knitted.finished);
  CHECK(knitted.stitches == Approx(stitches).epsilon(0.1));
  CHECK(knitted.quality.wale.cv == Approx(wale_cv).margin(std::max(0.1 * wale_cv, 0.01)));
  CHECK(knitted.quality.course.cv < 0.04);
}

double usual_width(const Mesh& mesh) { return 0.03 * bounds_of(mesh.positions).diagonal(); }

Cycle farthest_end() {
  Cycle end{.as = CycleEnd::end};
  end.kind = CycleKind::farthest;
  return end;
}

std::optional<Mesh> mesh_by_others([[maybe_unused]] const std::string& name) {
#ifdef KNIT_SHARED_MESHES
  const std::filesystem::path path = std::filesystem::path(KNIT_SHARED_MESHES) / name;
  if (std::filesystem::exists(path)) {
    auto read = read_obj_file(path);
    REQUIRE(std::holds_alternative<Mesh>(read));
    return std::get<Mesh>(std::move(read));
  }
#endif
  WARN("skipped: " << name << " is not there");
  return std::nullopt;
}

// How many closed lines a field has at a level: triangles that it crosses, hanging together by crossed edges.
std::size_t loops_at(const Input& input, const std::vector<double>& field, double level) {
  std::map<EdgeKey, std::uint32_t> first;
  std::vector<std::uint32_t> crossed;
  for (std::uint32_t t = 0; t < input.mesh.triangles.size(); ++t) {
    const Triangle& triangle = input.mesh.triangles[t];
    const auto above =
        std::count_if(triangle.begin(), triangle.end(), [&](VertexId v) { return field[v] >= level; });
    if (above > 0 && above < 3) crossed.push_back(t);
  }
  UnionFind sets(crossed.size());
  for (std::uint32_t i = 0; i < crossed.size(); ++i) {
    const Triangle& triangle = input.mesh.triangles[crossed[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = triangle[k];
      const VertexId b = triangle[(k + 1) % 3];
      if ((field[a] >= level) == (field[b] >= level)) continue;
      const auto [entry, fresh] = first.try_emplace(edge_key(a, b), i);
      if (!fresh) sets.join(entry->second, i);
    }
  }
  std::size_t loops = 0;
  for (std::uint32_t i = 0; i < crossed.size(); ++i)
    if (sets.find(i) == i) ++loops;
  return loops;
}

// A closed surface without handles: a sphere with dents and bumps in five directions.
Mesh bumpy_ball(Dice& dice) {
  Mesh ball = icosphere(3);
  std::vector<glm::dvec3> waves;
  std::vector<double> phases;
  for (int i = 0; i < 5; ++i) {
    waves.emplace_back(dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2));
    phases.push_back(dice.between(0.0, 6.28));
  }
  for (glm::dvec3& p : ball.positions) {
    double sum = 0.0;
    for (std::size_t i = 0; i < waves.size(); ++i) sum += std::sin(2.5 * glm::dot(p, waves[i]) + phases[i]);
    p *= 1.0 + 0.35 * sum / 5.0;
  }
  return ball;
}

}  // namespace

TEST_CASE("curves run: a sphere between two circles", "[curves]") {
  const Mesh ball = icosphere(5);
  check_evenness(knit_between(ball,
                              {circle_at(on_ball(2.4, 0.5), 0.6, CycleEnd::start),
                               circle_at(on_ball(0.9, 2.0), 0.2, CycleEnd::end)},
                              usual_width(ball)),
                 1052, 0.340);
}

TEST_CASE("curves run: a sphere from a plane of three clicks to its farthest point", "[curves]") {
  const Mesh ball = icosphere(5);
  check_evenness(
      knit_between(ball,
                   {through(CycleKind::plane, {on_ball(2.2, 0.0), on_ball(2.5, 2.0), on_ball(2.0, 4.0)},
                            CycleEnd::start),
                    farthest_end()},
                   usual_width(ball)),
      936, 0.039);
}

TEST_CASE("curves run: a sphere from a path of four clicks to its farthest point", "[curves]") {
  const Mesh ball = icosphere(5);
  check_evenness(
      knit_between(ball,
                   {through(CycleKind::path,
                            {on_ball(2.2, 0.3), on_ball(2.6, 2.0), on_ball(2.1, 3.6), on_ball(2.3, 5.0)},
                            CycleEnd::start),
                    farthest_end()},
                   usual_width(ball)),
      1031, 0.080);
}

TEST_CASE("curves run: a cylinder from rim to rim", "[curves]") {
  const Mesh box = cylinder(32, 1.0, 2.0, 8);
  std::vector<Cycle> cycles;
  for (const CycleEnd as : {CycleEnd::start, CycleEnd::end}) {
    std::vector<glm::dvec3> clicks;
    for (unsigned i = 0; i < 4; ++i) {
      const TurnPoint at = turn_point(i, 4);
      clicks.emplace_back(at.sine, as == CycleEnd::start ? 0.0 : 2.0, -at.cosine);
    }
    cycles.push_back(through(CycleKind::path, clicks, as));
  }
  check_evenness(knit_between(box, cycles, usual_width(box)), 1200, 0.0);
}

TEST_CASE("curves run: the cylinder by others, four clicks a rim", "[curves][shared]") {
  const auto mesh = mesh_by_others("simple-cylinder.obj");
  if (!mesh) return;
  std::vector<Cycle> cycles;
  for (const CycleEnd as : {CycleEnd::start, CycleEnd::end}) {
    const double z = as == CycleEnd::start ? -1.0 : 1.0;
    cycles.push_back(through(CycleKind::path, {{1, 0, z}, {0, 1, z}, {-1, 0, z}, {0, -1, z}}, as));
  }
  const Between piece = between(*mesh, cycles, usual_width(*mesh));
  REQUIRE(piece.caps.size() == 2);
  for (const CutCap& cap : piece.caps) CHECK(cap.share == Approx(0.166).margin(0.002));
  for (const CutRim& rim : piece.rims) CHECK(rim.vertices.size() == 32);
  check_evenness(knit_between(*mesh, cycles, usual_width(*mesh)), 1200, 0.0);
}

TEST_CASE("curves run: the elbow from rim to rim", "[curves][shared]") {
  const auto mesh = mesh_by_others("simple-elbow.obj");
  if (!mesh) return;
  check_evenness(knit_between(*mesh,
                              {through(CycleKind::plane, {{1, 2, 0}, {0, 2, 1}, {-1, 2, 0}}, CycleEnd::start),
                               through(CycleKind::plane, {{1, 0, 2}, {0, 1, 2}, {-1, 0, 2}}, CycleEnd::end)},
                              usual_width(*mesh)),
                 800, 0.329);
}

TEST_CASE("curves run: the elbow between the slots of a constraint file", "[curves][shared]") {
  const auto mesh = mesh_by_others("simple-elbow.obj");
  if (!mesh) return;
  // Across both rounded ends, so long that 0.6 % of the surface is left out at each.
  constexpr double across = 0.7;
  const double up = 2.0 + std::sqrt(1.0 - across * across);
  auto read = read_cons(cons_bytes({{{{-across, up, 0}, {across, up, 0}}, -0.5F, 0.071F},
                                    {{{-across, 0, up}, {across, 0, up}}, 0.5F, 0.066F}}));
  REQUIRE(std::holds_alternative<std::vector<Cycle>>(read));
  const auto& cycles = std::get<std::vector<Cycle>>(read);
  for (const CutCap& cap : between(*mesh, cycles, 0.18).caps) CHECK(cap.share == Approx(0.006).margin(0.001));
  check_evenness(knit_between(*mesh, cycles, 0.18), 1158, 0.284);
}

TEST_CASE("curves run: the bunny from its base to its farthest point", "[curves][shared]") {
  const auto mesh = mesh_by_others("bunny.obj");
  if (!mesh) return;
  const Bounds bounds = bounds_of(mesh->positions);
  const double height = bounds.low.y + 0.06 * (bounds.high.y - bounds.low.y);
  VertexId near = 0;
  for (VertexId v = 0; v < mesh->positions.size(); ++v)
    if (std::abs(mesh->positions[v].y - height) < std::abs(mesh->positions[near].y - height)) near = v;
  Cycle plane = through(CycleKind::plane, {mesh->positions[near]}, CycleEnd::start);
  plane.normal = {0.0, 1.0, 0.0};
  const Between piece = between(*mesh, {plane, farthest_end()}, usual_width(*mesh));
  REQUIRE(piece.caps.size() == 2);
  CHECK(std::max(piece.caps[0].share, piece.caps[1].share) == Approx(0.034).margin(0.002));
  // How even it is depends on where exactly it begins; both ears in one tube it never is.
  const Knitted knitted = knit_between(*mesh, {plane, farthest_end()}, usual_width(*mesh));
  INFO(knitted.stitches << " stitches, wale cv " << knitted.quality.wale.cv);
  REQUIRE(knitted.finished);
  CHECK(knitted.stitches == Approx(948).epsilon(0.1));
  CHECK(knitted.quality.wale.high == Approx(4.58).epsilon(0.1));
}

TEST_CASE("curves run: one loop at every level between two circles", "[curves]") {
  Dice dice(31);
  int pieces = 0;
  while (pieces < 200) {
    const Mesh ball = bumpy_ball(dice);
    const glm::dvec3 from = ball.positions[dice.below(ball.positions.size())];
    const glm::dvec3 to = ball.positions[dice.below(ball.positions.size())];
    if (glm::length(from - to) < 0.7) continue;
    ++pieces;
    INFO("piece " << pieces);
    const auto input = input_of(
        between(ball, {circle_at(from, 0.2, CycleEnd::start), circle_at(to, 0.2, CycleEnd::end)}, 0.1));
    Timeline run(input, level_rows_of(*input, 0.1));
    while (!run.furthest().timing && !run.complete()) run.extend(1);
    REQUIRE(run.furthest().timing);
    const std::vector<double>& field = run.furthest().timing->cut_field();
    std::size_t most = 0;
    for (int i = 1; i < 61; ++i) most = std::max(most, loops_at(*input, field, i / 61.0));
    CHECK(most == 1);
  }
}
