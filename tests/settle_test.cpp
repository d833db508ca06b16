// Settling: its parts against figures worked out elsewhere, and what it may and may not do to a knitted shape.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include "knit/mesh/closest_point.h"
#include "knit/mesh/triangle_tree.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/coverage.h"
#include "knit/quality/measures.h"
#include "knit/run/timeline.h"
#include "knit/settle/settle.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/rough_sphere.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using namespace knit;

namespace {

struct Knitted {
  std::shared_ptr<const Input> input;
  StitchSize stitch;
  State state;
};

Knitted knitted(Mesh mesh, double share_of_diagonal, TimingKind timing = TimingKind::linear) {
  Knitted made{make_input(std::move(mesh)), {}, {}};
  Parameters parameters = default_parameters(made.input->bounds);
  give_width(parameters, share_of_diagonal * made.input->bounds.diagonal());
  parameters.timing.kind = timing;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  parameters = resolved(parameters, *made.input);
  Timeline timeline(made.input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  made.stitch = parameters.stitch;
  made.state = timeline.furthest();
  return made;
}

SettleWork begun(const Knitted& made, const SettleSettings& settings = {}) {
  SettleWork work;
  begin_settling(*made.input, made.state.fabric, made.stitch, settings, work);
  return work;
}

SettleWork settled(const Knitted& made, const SettleSettings& settings = {}) {
  SettleWork work = begun(made, settings);
  while (!work.done) advance_settling(*made.input, settings, work);
  return work;
}

std::vector<glm::dvec3> normals_of(const Input& input, const SettleWork& work) {
  std::vector<glm::dvec3> normals;
  for (std::size_t i = 0; i < work.at->positions.size(); ++i)
    normals.push_back(
        normal_at(input, work.plan->normals, work.at->triangles[i], work.at->positions[i], {0.0, 1.0, 0.0}));
  return normals;
}

LengthFigures figures(const std::vector<std::array<std::uint32_t, 2>>& edges,
                      const std::vector<glm::dvec3>& at, double wanted) {
  std::vector<double> lengths;
  for (const auto& [a, b] : edges) lengths.push_back(glm::distance(at[a], at[b]) / wanted);
  return figures_of(lengths);
}
LengthFigures wales(const SettleWork& work, const Settled& at) {
  return figures(work.plan->terms.graph.wales, at.positions, work.plan->terms.height);
}
LengthFigures courses(const SettleWork& work, const Settled& at) {
  return figures(work.plan->terms.graph.courses, at.positions, work.plan->terms.width);
}

double mean_corner_off(const SettleWork& work, const Settled& at) {
  double sum = 0.0;
  for (const auto& quad : work.plan->terms.graph.quads) {
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3 a = at.positions[quad[(i + 3) % 4]] - at.positions[quad[i]];
      const glm::dvec3 b = at.positions[quad[(i + 1) % 4]] - at.positions[quad[i]];
      sum += std::abs(std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b))) - std::numbers::pi / 2);
    }
  }
  return sum / (4.0 * static_cast<double>(work.plan->terms.graph.quads.size())) * 180.0 / std::numbers::pi;
}

// Corners that have turned over.
std::size_t turned_corners(const Input& input, const SettleWork& work) {
  const std::vector<glm::dvec3> normals = normals_of(input, work);
  const auto& p = work.at->positions;
  return static_cast<std::size_t>(std::count_if(
      work.plan->terms.graph.corners.begin(), work.plan->terms.graph.corners.end(), [&](const auto& corner) {
        const glm::dvec3 area = glm::cross(p[corner[1]] - p[corner[0]], p[corner[2]] - p[corner[0]]);
        return glm::dot(area, normals[corner[0]]) * work.plan->terms.facing < 0.0;
      }));
}

// How far rims have gone from where they were, in w.
double farthest_rim(const SettleWork& work) {
  double farthest = 0.0;
  for (std::size_t rim = 0; rim < work.plan->terms.graph.rims.size(); ++rim) {
    const std::vector<glm::dvec3>& polygon = work.plan->terms.rim_polygons[rim];
    for (const std::uint32_t stitch : work.plan->terms.graph.rims[rim]) {
      double nearest = 1e300;
      for (const auto& [from, to] : Edges(polygon.size(), true)) {
        const glm::dvec3 place =
            closest_on_triangle(work.at->positions[stitch], {polygon[from], polygon[to], polygon[to]});
        nearest = std::min(nearest, glm::distance(place, work.at->positions[stitch]));
      }
      farthest = std::max(farthest, nearest / work.plan->terms.width);
    }
  }
  return farthest;
}

Mesh flattened(Mesh mesh, double share) {
  for (glm::dvec3& p : mesh.positions) p.z *= share;
  return mesh;
}

// A tube about y whose upper part is bent by 69 degrees in the plane z = 0.
Mesh elbow() {
  std::vector<ProfilePoint> profile{{0.0, -1.6}};
  for (unsigned j = 0; j <= 64; ++j) profile.push_back({0.4, -1.6 + 3.2 * j / 64.0});
  profile.push_back({0.0, 1.6});
  Mesh mesh = revolve("elbow", profile, 32, false);
  for (glm::dvec3& p : mesh.positions) {
    const double turn = std::clamp(p.y, -0.2, 1.0), rest = p.y - turn, bend = 1.0;
    const double angle = turn / bend;
    p = {bend - (bend - p.x) * std::cos(angle) + rest * std::sin(angle),
         (bend - p.x) * std::sin(angle) + rest * std::cos(angle), p.z};
  }
  return mesh;
}

// A ball with a thin horn on its side, in the middle of the rows: no row ends on it.
Mesh horned() {
  Mesh mesh = sphere(160, 121);
  for (glm::dvec3& p : mesh.positions) {
    const double aside = (p.y * p.y + p.z * p.z) / 0.06;
    if (p.x > 0.0 && aside < 1.0) p.x += 1.2 * (1.0 - aside);
  }
  return mesh;
}

}  // namespace

TEST_CASE("settle: the nearest place of a surface and its triangle are those that trying all finds") {
  const Mesh mesh = test_support::arch();
  const TriangleTree tree(mesh.positions, mesh.triangles);
  test_support::Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 point{dice.between(-2, 2), dice.between(-1, 2), dice.between(-1, 1)};
    const SurfacePlace found = tree.nearest(point);
    double least = 1e300;
    for (const auto& [a, b, c] : mesh.triangles) {
      const glm::dvec3 place =
          closest_on_triangle(point, {mesh.positions[a], mesh.positions[b], mesh.positions[c]});
      least = std::min(least, glm::distance(place, point));
    }
    CHECK(glm::distance(found.point, point) == Approx(least).margin(1e-12));
    const auto& [a, b, c] = mesh.triangles[found.triangle];
    CHECK(glm::distance(
              closest_on_triangle(found.point, {mesh.positions[a], mesh.positions[b], mesh.positions[c]}),
              found.point) < 1e-12);
  }
}

TEST_CASE("settle: a walk finds the nearest place, but not through a thin sheet") {
  const auto input = make_input(flattened(sphere(64, 33), 0.01));
  const VertexNormals normals = vertex_normals(*input);
  SurfaceWalk walk(*input, normals);
  const TriangleTree tree(input->mesh.positions, input->mesh.triangles);
  test_support::Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const SurfacePlace start = tree.nearest({dice.between(-0.5, 0.5), dice.between(-0.5, 0.5), 1.0});
    const OnSurface from{start.triangle, start.point,
                         normal_at(*input, normals, start.triangle, start.point, {0, 0, 1})};
    REQUIRE(from.normal.z > 0.9);
    // As deep as the other side: trying all would go there.
    const glm::dvec3 to = start.point + glm::dvec3{dice.between(-0.1, 0.1), dice.between(-0.1, 0.1), -0.03};
    CHECK(tree.nearest(to).point.z < 0.0);
    const OnSurface there = walk.nearest(from, to);
    CHECK(there.point.z > 0.0);
    CHECK(there.normal.z > 0.9);
    const auto& [a, b, c] = input->mesh.triangles[there.triangle];
    CHECK(glm::distance(closest_on_triangle(to, {input->mesh.positions[a], input->mesh.positions[b],
                                                 input->mesh.positions[c]}),
                        there.point) < 1e-12);
    CHECK(glm::distance(glm::dvec2(there.point), glm::dvec2(to)) < 0.01);
  }
}

TEST_CASE("settle: a walk goes round the edge of a box") {
  Mesh box = test_support::cylinder(48, 1.0, 1.0, 8);  // a right angle between side and lid
  const auto input = make_input(std::move(box));
  const VertexNormals normals = vertex_normals(*input);
  SurfaceWalk walk(*input, normals);
  const SurfacePlace start =
      TriangleTree(input->mesh.positions, input->mesh.triangles).nearest({1.0, 0.95, 0.0});
  const OnSurface from{start.triangle, start.point,
                       normal_at(*input, normals, start.triangle, start.point, {1, 0, 0})};
  const OnSurface there = walk.nearest(from, {0.85, 1.01, 0.0});
  CHECK(there.point.y == Approx(1.0));
  CHECK(there.point.x == Approx(0.85).margin(1e-9));
}

TEST_CASE("settle: the graph of a tube has its edges, corners and rims") {
  test_support::HandTube tube;
  tube.sizes = {16, 16, 18};
  const State state = test_support::tube_state(tube);
  const SettleGraph graph = make_settle_graph(state.fabric);
  CHECK(graph.stitches == 50);
  CHECK(graph.wales.size() == 34);
  CHECK(graph.courses.size() == 50);
  CHECK(graph.quads.size() == 32);
  CHECK(graph.corners.size() == 4 * 32 + 2);
  CHECK(graph.beside.size() == 34 + 50 + 2 * 32);
  REQUIRE(graph.rims.size() == 2);
  CHECK(graph.rims[0].size() + graph.rims[1].size() == 34);
  CHECK(std::set<std::uint32_t>(graph.rims[0].begin(), graph.rims[0].end()).size() == graph.rims[0].size());
}

TEST_CASE("settle: stitches that were shaken on a cylinder go back to where they fit") {
  const double height = 0.14, width = 2.0 * std::sin(std::numbers::pi / 32.0);
  test_support::HandTube tube;
  tube.sizes = std::vector<int>(12, 32);
  tube.row_height = height;
  Mesh cylinder = test_support::cylinder(128, 1.0, 13 * height, 64);
  for (glm::dvec3& p : cylinder.positions) p.y -= height;  // lids away from the rims
  const auto input = make_input(std::move(cylinder));
  test_support::Dice dice(11);
  const double shake = GENERATE(0.0, 0.3);
  Fabric shaken;
  const State state = test_support::tube_state(tube);
  for (const auto& row : state.fabric.rows()) {
    Row moved = *row;
    for (Stitch& stitch : moved.stitches)
      stitch.position +=
          shake * width * glm::dvec3(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1));
    shaken.add(moved);
  }
  for (const auto& strip : state.fabric.strips()) shaken.add(strip);
  SettleWork work;
  const SettleSettings settings;
  StitchSize stitch;
  stitch.width = width;
  stitch.height = height;
  begin_settling(*input, shaken, stitch, settings, work);
  const double before = work.sum;
  while (!work.done) advance_settling(*input, settings, work);
  CHECK(work.sum <= before);
  CHECK(work.sum / 384.0 < (shake > 0.0 ? 2e-2 : 1e-5));
  CHECK(wales(work, *work.at).cv < (shake > 0.0 ? 0.03 : 1e-3));
}

TEST_CASE("settle: slopes are those of the sum, and the step's right side is half of them") {
  const Knitted made = knitted(test_support::arch(), 0.06);
  SettleWork work = begun(made);
  const SettleSettings settings;
  std::vector<glm::dvec3> positions = work.at->positions;
  const std::vector<glm::dvec3> normals = normals_of(*made.input, work);
  test_support::Dice dice(13);  // shaken so that corners turn over and rims are off
  for (glm::dvec3& p : positions)
    p += 0.4 * made.stitch.width * glm::dvec3(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1));
  SettleTerms terms = work.plan->terms;
  terms.places.clear();  // some that the fabric leaves
  for (std::size_t i = 0; i < positions.size(); i += 7)
    terms.places.push_back({work.plan->start.positions[i] + made.stitch.width * normals[i],
                            made.stitch.width * made.stitch.height, 0.5 * made.stitch.height});
  // Places are found wherever they were found last.
  SettleSettings no_cover = settings;
  no_cover.cover = 0.0;
  std::vector<std::uint32_t> near(terms.places.size(), 0);
  const double sum = sum_of_terms(terms, settings, {positions, normals});
  CHECK(sum > 1.1 * sum_of_terms(terms, no_cover, {positions, normals}));
  for (int time = 0; time < 2; ++time)
    CHECK(sum_of_terms(terms, settings, {positions, normals, near}) == sum);
  const std::vector<glm::dvec3> slopes = slopes_of(terms, settings, {positions, normals});
  const double tiny = 1e-6 * made.stitch.width;
  double largest = 0.0;
  for (const glm::dvec3& slope : slopes) largest = std::max(largest, glm::length(slope));
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<glm::dvec3> moved = positions;
      moved[i][axis] += tiny;
      const double up = sum_of_terms(terms, settings, {moved, normals});
      moved[i][axis] -= 2 * tiny;
      const double down = sum_of_terms(terms, settings, {moved, normals});
      CHECK((up - down) / (2 * tiny) == Approx(slopes[i][axis]).margin(1e-5 * largest));
    }
  }
  std::vector<Frame> frames;
  for (const glm::dvec3& normal : normals) frames.push_back(frame_across(normal));
  BlockSystem system;
  linearise(terms, settings, {positions, normals}, frames, work.plan->pattern, system);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec2& right = system.right[work.plan->pattern.place[i]];
    CHECK(right.x == Approx(-0.5 * glm::dot(slopes[i], frames[i].u)).margin(1e-9 * largest));
    CHECK(right.y == Approx(-0.5 * glm::dot(slopes[i], frames[i].v)).margin(1e-9 * largest));
    CHECK(glm::dot(frames[i].u, normals[i]) == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("settle: a sphere's wales come out even, and its rims stay") {
  for (const TimingKind timing : {TimingKind::linear, TimingKind::geodesic}) {
    const Knitted made = knitted(sphere(64, 33), 0.04, timing);
    const SettleWork work = settled(made);
    CHECK(wales(work, *work.at).cv <= 0.034);
    CHECK(wales(work, *work.at).high <= 1.3);
    CHECK(courses(work, *work.at).cv <= 0.07);
    CHECK(mean_corner_off(work, *work.at) <= 8.5);
    CHECK(mean_corner_off(work, *work.at) < mean_corner_off(work, work.plan->start));
    CHECK(turned_corners(*made.input, work) == 0);
    CHECK(farthest_rim(work) <= 0.5);
  }
}

TEST_CASE("settle: an elbow's long wales are gone") {
  const Knitted made = knitted(elbow(), 0.035);
  const SettleWork work = settled(made);
  const LengthFigures placed = wales(work, work.plan->start), now = wales(work, *work.at);
  CHECK(placed.cv > 0.2);
  CHECK(now.cv <= 0.085);
  CHECK(now.high <= 2.0);
  CHECK(courses(work, *work.at).cv <= 0.16);
  CHECK(turned_corners(*made.input, work) == 0);
  CHECK(farthest_rim(work) <= 1.5);
}

TEST_CASE("settle: each iteration lowers the sum, moves nobody far, and is the same every time") {
  const Knitted made = knitted(test_support::arch(), 0.05);
  const SettleSettings settings;
  SettleWork work = begun(made), again = begun(made);
  CHECK(work == again);
  CHECK(content_hash_of(work) == content_hash_of(again));
  std::vector<SettleWork> states{work};
  while (!work.done) {
    const SettleIteration told = advance_settling(*made.input, settings, work);
    CHECK(told.before == states.back().sum);
    if (told.taken) {
      CHECK(told.after < told.before);
      CHECK(told.iteration == work.iteration);
      CHECK(told.greatest_move <= 1.6);
      CHECK(told.mean_move <= told.greatest_move);
    }
    states.push_back(work);
  }
  CHECK(work.iteration >= 3);
  CHECK(work.iteration <= settings.most_iterations);
  // From the middle, as after a rewind.
  for (std::size_t from : {std::size_t{0}, states.size() / 2}) {
    SettleWork copy = states[from];
    for (std::size_t i = from + 1; i < states.size(); ++i) {
      advance_settling(*made.input, settings, copy);
      CHECK(copy == states[i]);
      CHECK(content_hash_of(copy) == content_hash_of(states[i]));
    }
  }
  CHECK(content_hash_of(states.front()) != content_hash_of(states.back()));
}

TEST_CASE("settle: an iteration is the same with memory that is kept, shared, or new") {
  const Knitted made = knitted(test_support::arch(), 0.05);
  const SettleSettings settings;
  SettleWork stepped = begun(made);
  while (!stepped.done) {
    SettleWork shares = stepped, new_one = stepped;
    new_one.memory = {};
    advance_settling(*made.input, settings, shares);
    advance_settling(*made.input, settings, stepped);
    advance_settling(*made.input, settings, new_one);
    CHECK(shares == stepped);
    CHECK(new_one == stepped);
    CHECK(content_hash_of(new_one) == content_hash_of(stepped));
  }
}

TEST_CASE("settle: an iteration says how far it has come, and is broken off without a trace") {
  struct BrokenOff {};
  const Knitted made = knitted(test_support::arch(), 0.03);
  const SettleSettings settings;
  std::vector<double> heard;
  SettleWork work;
  begin_settling(*made.input, made.state.fabric, made.stitch, settings, work,
                 [&](double share) { heard.push_back(share); });
  CHECK(heard.size() >= 5);
  CHECK(work == begun(made));

  heard.clear();
  SettleWork whole = work;
  whole.memory = {};
  advance_settling(*made.input, settings, whole, [&](double share) { heard.push_back(share); });
  CHECK(std::is_sorted(heard.begin(), heard.end()));
  CHECK(heard.front() >= 0.0);
  CHECK(heard.back() <= 1.0);
  CHECK(heard.size() + 1 >= work.plan->pattern.panel.size());  // at each panel of the factorisation
  for (std::size_t i = 1; i < heard.size(); ++i) CHECK(heard[i] - heard[i - 1] < 0.35);

  for (const std::size_t stop_at : {std::size_t{1}, heard.size() / 2, heard.size()}) {
    SettleWork broken = work;
    broken.memory = {};  // as before: all of it is to be made
    std::size_t calls = 0;
    const Heard stopping = [&](double /*share*/) {
      if (++calls == stop_at) throw BrokenOff{};
    };
    CHECK_THROWS_AS(advance_settling(*made.input, settings, broken, stopping), BrokenOff);
    CHECK(broken == work);
    advance_settling(*made.input, settings, broken);
    CHECK(broken == whole);
  }
}

TEST_CASE("settle: a few stitches at a sharp edge hold up nobody but those beside them") {
  // Round its edge the surface is not what a stitch's plane promises: each step that goes there would fail as a whole.
  const Knitted made = knitted(flattened(sphere(96, 65), 0.1), 0.03);
  const SettleSettings settings;
  SettleWork work = begun(made);
  std::int32_t tries = 0;
  while (!work.done) tries += advance_settling(*made.input, settings, work).tries;
  CHECK(work.iteration >= 5);
  CHECK(tries <= work.iteration + 3);
}

TEST_CASE("settle: a limb that no row ends on stays covered") {
  Knitted made = knitted(horned(), 0.04);
  const auto uncovered = [&](const Settled& at) {
    State state = made.state;
    state.fabric = state.fabric.moved_to(at.positions);
    return measure_uncovered(*made.input, state, made.stitch.width, made.stitch.height).share;
  };
  SettleSettings without;
  without.cover = 0.0;
  const SettleWork slid = settled(made, without), held = settled(made);
  const double placed = uncovered(held.plan->start);
  CHECK(uncovered(*slid.at) > placed + 0.03);
  CHECK(uncovered(*held.at) < placed + 0.0015);
  // Only there is anything asked for, and a horn's end is its farthest place.
  double farthest = 0.0;
  REQUIRE(!held.plan->terms.places.empty());
  for (const CoverPlace& place : held.plan->terms.places) {
    CHECK(place.at.x > 0.9);
    farthest = std::max(farthest, place.at.x);
  }
  CHECK(farthest > 2.15);
  CHECK(begun(knitted(sphere(64, 33), 0.04)).plan->terms.places.empty());
}

TEST_CASE("settle: it ends after as many iterations as are allowed") {
  const Knitted made = knitted(test_support::arch(), 0.05);
  SettleSettings settings;
  settings.most_iterations = 2;
  CHECK(settled(made, settings).iteration == 2);
}

TEST_CASE("settle: every stitch is on the surface, on the triangle that it names") {
  const Knitted made = knitted(test_support::arch(), 0.04);
  const SettleWork work = settled(made);
  for (std::size_t i = 0; i < work.at->positions.size(); ++i) {
    const auto& [a, b, c] = made.input->mesh.triangles[work.at->triangles[i]];
    const auto& p = made.input->mesh.positions;
    CHECK(glm::distance(closest_on_triangle(work.at->positions[i], {p[a], p[b], p[c]}),
                        work.at->positions[i]) < 1e-9);
  }
}

TEST_CASE("settle: on a pancake nobody changes sides") {
  // Thinner than a stitch, standing on its edge: rounds go over both sides.
  const Knitted made = knitted(flattened(sphere(96, 65), 0.02), 0.04);
  const SettleWork work = settled(made);
  const std::vector<glm::dvec3>& start = work.plan->start.positions;
  std::size_t changed = 0, near_the_edge = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (start[i].z * work.at->positions[i].z >= 0.0) continue;
    ++changed;
    if (glm::length(glm::dvec2(work.at->positions[i])) > 0.8) ++near_the_edge;
  }
  CHECK(changed == near_the_edge);  // round the edge, as a stitch may slide, not through
  CHECK(wales(work, *work.at).cv < wales(work, work.plan->start).cv);
}

TEST_CASE("settle: twins stay alike") {
  const Knitted made = knitted(test_support::arch(), 0.04);
  const SettleWork work = settled(made);
  // The legs are twins, one each side of the plane x = 0: as many stitches, as even.
  std::array<std::vector<double>, 2> lengths;
  for (const auto& [a, b] : work.plan->terms.graph.wales) {
    const glm::dvec3 &p = work.at->positions[a], &q = work.at->positions[b];
    if (std::abs(p.x + q.x) < 0.8) continue;
    lengths[p.x + q.x < 0.0 ? 0 : 1].push_back(glm::distance(p, q) / work.plan->terms.height);
  }
  const LengthFigures left = figures_of(lengths[0]), right = figures_of(lengths[1]);
  REQUIRE(left.count > 100);
  CHECK(static_cast<double>(left.count) == Approx(static_cast<double>(right.count)).epsilon(0.03));
  CHECK(left.mean == Approx(right.mean).margin(0.01));
  CHECK(left.cv == Approx(right.cv).margin(0.01));
}

TEST_CASE("settle: rows from the mesh's own rings settle as well") {
  const auto input = test_support::small_sphere();
  const Parameters parameters = resolved(test_support::small_parameters(), *input);
  Timeline timeline(input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.furthest().finished());
  SettleWork work;
  begin_settling(*input, timeline.furthest().fabric, parameters.stitch, {}, work);
  while (!work.done) advance_settling(*input, {}, work);
  CHECK(work.plan->terms.graph.rims.size() == 2);
  CHECK(wales(work, *work.at).cv < 0.6 * wales(work, work.plan->start).cv);
  CHECK(turned_corners(*input, work) == 0);
}

TEST_CASE("settle: a shape turned inside out in its fabric is settled as well") {
  // Faces clockwise seen from outside: the corner's sign is told by most of them.
  test_support::HandTube tube;
  tube.sizes = std::vector<int>(8, 24);
  tube.row_height = 0.19;
  State state = test_support::tube_state(tube);
  SettleGraph graph = make_settle_graph(state.fabric);
  const std::vector<glm::dvec3> path = knitting_path(state.fabric);
  std::vector<glm::dvec3> outside, inside;
  for (const glm::dvec3& p : path) {
    outside.push_back(glm::normalize(glm::dvec3(p.x, 0.0, p.z)));
    inside.push_back(-outside.back());
  }
  CHECK(facing_of(graph, {path, outside}) == -facing_of(graph, {path, inside}));
  SettleTerms terms{graph, {}, {}, 1.0, 2.0 * std::sin(std::numbers::pi / 24.0), 0.19};
  for (const auto& rim : graph.rims) {
    std::vector<glm::dvec3>& polygon = terms.rim_polygons.emplace_back();
    for (const std::uint32_t stitch : rim) polygon.push_back(path[stitch]);
  }
  terms.facing = facing_of(graph, {path, inside});
  CHECK(sum_of_terms(terms, {}, {path, inside}) == Approx(0.0).margin(1e-12));
  CHECK(sum_of_terms(terms, {}, {path, outside}) > 100.0);
}
