#include "tests/stress/random_run.h"

#include <algorithm>
#include <array>

#include "knit/import/check.h"
#include "knit/model/bug.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "tests/stress/cubes.h"
#include "tests/support/bodies.h"

namespace stress {

namespace {

using knit::Mesh;
using knit::Parameters;
using test_support::CubeGrid;
using test_support::Dice;

glm::dvec3 vector_in(Dice& dice, double reach) {
  const double x = dice.between(-reach, reach), y = dice.between(-reach, reach),
               z = dice.between(-reach, reach);
  return {x, y, z};
}

int between(Dice& dice, int low, int high) {
  return low + static_cast<int>(dice.below(static_cast<std::size_t>(high - low + 1)));
}

// Limbs that grow from the middle, a cube at a time: each walks straight on or turns.
void grow(Dice& dice, CubeGrid& grid) {
  const CubeGrid::Cell& size = grid.size();
  const CubeGrid::Cell middle{size[0] / 2, size[1] / 2, size[2] / 2};
  grid.fill(middle);
  for (int limbs = between(dice, 1, 8); limbs > 0; --limbs) {
    CubeGrid::Cell at = middle;
    std::size_t axis = dice.below(3);
    int way = dice.below(2) == 0 ? 1 : -1;
    for (int steps = between(dice, 1, 6); steps > 0; --steps) {
      if (dice.below(3) == 0) {
        axis = dice.below(3);
        way = dice.below(2) == 0 ? 1 : -1;
      }
      at.at(axis) = std::clamp(at.at(axis) + way, 0, size.at(axis) - 1);
      grid.fill(at);
    }
  }
}

void scatter(Dice& dice, CubeGrid& grid) {
  const CubeGrid::Cell& size = grid.size();
  grid.fill({0, 0, 0});
  const double share = dice.between(0.15, 0.45);
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z)
        if (dice.between(0.0, 1.0) < share) grid.fill({x, y, z});
}

Mesh body_of_cubes(Dice& dice) {
  const bool grown = dice.below(2) == 0;
  const int most = grown ? 9 : 5;
  const int x = between(dice, 2, most), y = between(dice, 2, most), z = between(dice, 2, most);
  CubeGrid grid({x, y, z});
  grown ? grow(dice, grid) : scatter(dice, grid);
  grid.make_solid();
  const int refine = between(dice, 1, 4);
  Mesh mesh = grid.surface(refine);
  mesh.name = grown ? "grown cubes" : "scattered cubes";
  test_support::round_off(mesh, between(dice, 0, 2 * refine));
  if (dice.below(2) == 0)
    for (glm::dvec3& p : mesh.positions) p += vector_in(dice, 0.08 / refine);
  return mesh;
}

Mesh body(Dice& dice) {
  Mesh mesh;
  switch (dice.below(8)) {
    case 0: {
      const double tube = dice.between(0.1, 0.5);
      mesh = knit::torus(8 + static_cast<unsigned>(dice.below(40)), 6 + static_cast<unsigned>(dice.below(20)),
                         1.0, tube);
      break;
    }
    case 1:
      mesh = test_support::arch();
      break;
    default:
      mesh = body_of_cubes(dice);
  }
  if (dice.below(3) == 0) return mesh;
  const std::array<glm::dvec3, 3> column{vector_in(dice, 0.3), vector_in(dice, 0.3), vector_in(dice, 0.3)};
  for (glm::dvec3& p : mesh.positions) p += p.x * column[0] + p.y * column[1] + p.z * column[2];
  return mesh;
}

knit::Axis random_axis(Dice& dice) {
  const auto kind = static_cast<knit::AxisKind>(dice.below(6));
  if (kind < knit::AxisKind::custom) return {kind, {0.0, 1.0, 0.0}};
  const auto seed = static_cast<unsigned>(dice.below(100000));
  return {knit::AxisKind::custom, test_support::random_axes(1, seed).front()};
}

// In two of three runs; its weights in one of three of those, some of them none at all.
void draw_settling(Dice& dice, knit::SettleSettings& settle) {
  settle.settling = dice.below(3) == 0 ? knit::Settling::off : knit::Settling::on;
  if (settle.settling == knit::Settling::off || dice.below(3) != 0) return;
  for (double* weight :
       {&settle.wale, &settle.course, &settle.shear, &settle.rim, &settle.fold, &settle.cover}) {
    if (dice.below(2) == 0) *weight = dice.below(4) == 0 ? 0.0 : dice.between(0.0, 4.0);
  }
  settle.most_iterations = between(dice, 1, 60);
}

// In one of three runs, drawn last, so that the others are what they were.
void draw_rhythm(Dice& dice, knit::RhythmSettings& rhythm) {
  if (dice.below(3) != 0) return;
  rhythm.counts = knit::CountPlanning::rhythm;
  rhythm.style = static_cast<knit::RhythmStyle>(dice.below(knit::rhythm_style_names.size()));
  if (dice.below(3) == 0) rhythm.changes = between(dice, 2, 16);
  if (dice.below(2) == 0) rhythm.tolerance = dice.between(0.5, 12.0);
  if (dice.below(3) == 0) rhythm.dial = dice.between(0.02, 4.0);
  if (dice.below(3) == 0) rhythm.halves = knit::RhythmHalves::off;
}

Parameters random_parameters(Dice& dice, const knit::Input& input) {
  Parameters p = knit::default_parameters(input.bounds);
  p.rows.source = knit::RowSource::contours;
  p.stitches.placement = knit::PlacementPolicy::nearest;
  knit::give_width(p, input.bounds.diagonal() * dice.between(0.02, 0.12));
  if (dice.below(4) == 0) knit::give_height(p, p.stitch.width * dice.between(0.4, 1.4));
  p.timing.axis = random_axis(dice);
  constexpr std::array kinds{knit::TimingKind::linear, knit::TimingKind::geodesic,
                             knit::TimingKind::harmonic};
  p.timing.kind = kinds.at(dice.below(kinds.size()));
  p.tubes.smoothing = static_cast<knit::Smoothing>(dice.below(3));
  if (dice.below(4) == 0) p.tubes.smoothing_length = dice.between(0.25, 3.0);
  p.tubes.smallest_limb = between(dice, 1, 3);
  p.rows.round_start = static_cast<knit::RoundStart>(dice.below(2));
  if (dice.below(6) == 0) p.rows.cast_on = between(dice, 3, 20);
  if (dice.below(6) == 0) p.stitches.stacking_penalty = dice.between(0.0, 8.0);
  draw_settling(dice, p.settle);
  draw_rhythm(dice, p.rhythm);
  return knit::resolved(p, input);
}

}  // namespace

RandomRun random_run(std::uint32_t seed, std::uint32_t number, const Meshes& meshes) {
  Dice dice(seed * 2654435761U + number);
  RandomRun run;
  run.dice = static_cast<std::uint32_t>(dice.below(1000000));
  if (!meshes.empty() && dice.below(3) != 0) {
    run.input = meshes[dice.below(meshes.size())];
  } else {
    Mesh mesh = body(dice);
    if (!knit::check(mesh).fit()) throw knit::Bug("a body made in code is not fit: " + mesh.name);
    run.input = knit::make_input(std::move(mesh));
  }
  run.parameters = random_parameters(dice, *run.input);
  return run;
}

std::string options_of(const RandomRun& run) {
  const Parameters usual = knit::default_parameters(run.input->bounds);
  std::string text;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (knit::same_value(info, run.parameters, usual) || knit::only_follows(info, usual, run.parameters))
      continue;
    text +=
        (text.empty() ? "--" : " --") + std::string(info.key) + " " + knit::value_text(info, run.parameters);
  }
  return text;
}

}  // namespace stress
