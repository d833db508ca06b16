#include "knit/settle/settle.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "knit/mesh/box_tree.h"
#include "knit/mesh/triangle_tree.h"

namespace knit {

namespace {

constexpr double least_shift = 1e-5;
constexpr std::int32_t most_tries = 4;
constexpr double longest_step = 1.0;   // of a stitch in one iteration, in w
constexpr double little_gain = 2e-4;   // of the sum
constexpr std::int32_t most_idle = 3;  // iterations in a row
// Held back are those around whom terms have grown by more than this share of the most, each time to this share of the way.
constexpr double held_from = 0.1, held_to = 0.5;
constexpr std::int32_t most_held = 8;     // times
constexpr std::size_t few_stitches = 64;  // triangles for each
constexpr std::size_t most_tried = 4;     // times each triangle

void find_normals(const Input& input, const SettlePlan& plan, const Settled& at,
                  std::vector<glm::dvec3>& normals) {
  normals.clear();
  for (std::size_t i = 0; i < at.positions.size(); ++i)
    normals.push_back(normal_at(input, plan.normals, at.triangles[i], at.positions[i], {0.0, 1.0, 0.0}));
}

// A tree of all triangles pays where stitches are many; for a few the mesh's own boxes do, unless its triangles come in no
// order: then no more is tried than the tree costs.
Settled onto_surface(const Input& input, const std::vector<glm::dvec3>& path, const Heard& heard) {
  const std::size_t triangles = input.mesh.triangles.size();
  std::optional<BoxTree> boxes;
  if (path.size() * few_stitches < triangles) boxes.emplace(input);
  std::optional<TriangleTree> tree;
  Settled start;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(path.size());
    if (i % 256 == 0) hear(heard, share);
    if (boxes && boxes->tried() > most_tried * triangles) boxes.reset();
    if (!boxes && !tree)
      tree.emplace(input.mesh.positions, input.mesh.triangles, part_of(heard, share, share));
    const SurfacePlace place = boxes ? boxes->nearest(path[i]) : tree->nearest(path[i]);
    start.positions.push_back(place.point);
    start.triangles.push_back(place.triangle);
  }
  return start;
}

}  // namespace

struct SettleMemory {
  SurfaceWalk walk;
  BlockSolver solver;
  BlockSystem system;
  std::vector<Frame> frames;
  std::vector<glm::dvec3> normals, to_normals;
  std::vector<glm::dvec2> moves;
  Settled to;
  std::vector<std::uint32_t> near;        // per place to be covered: the face found nearest last
  std::vector<double> grown;              // per stitch: by how much the terms that hang on it
  std::vector<double> share, share_then;  // per stitch: of its move
};

namespace {

// All that one iteration does.
class Iteration {
 public:
  Iteration(const Input& input, const SettleSettings& settings, const SettleWork& work, const Heard& heard,
            SettleMemory& memory)
      : settings_(settings), plan_(*work.plan), from_(*work.at), sum_(work.sum), heard_(heard), m_(memory) {
    m_.walk.refer_to(input, plan_.normals);
    if (m_.solver.pattern() != &plan_.pattern) m_.solver.refer_to(plan_.pattern, part_of(heard_, 0.0, 0.1));
    if (m_.near.size() != plan_.terms.places.size()) {
      m_.near.clear();
      for (const CoverPlace& place : plan_.terms.places) m_.near.push_back(place.near);
    }
    hear(heard_, 0.0);
    find_normals(input, plan_, from_, m_.normals);
    m_.frames.clear();
    for (const glm::dvec3& normal : m_.normals) m_.frames.push_back(frame_across(normal));
    hear(heard_, 0.0);
    linearise(plan_.terms, settings_, {from_.positions, m_.normals, m_.near}, m_.frames, plan_.pattern,
              m_.system);
  }

  // Whether the shift leads anywhere; where to is then to be seen. Of what is heard, each try is most of what is left.
  bool solve(double shift) {
    begun_ = until_;
    until_ += 0.75 * (1.0 - until_);
    return m_.solver.solve(m_.system, shift_of(shift), m_.moves, part_of(heard_, begun_, until_));
  }

  // What the terms would fall by if they were as straight as they were taken for.
  [[nodiscard]] double promised(double shift) const {
    double gain = 0.0;
    for (std::size_t i = 0; i < m_.moves.size(); ++i) {
      const glm::dvec2& right = m_.system.right[plan_.pattern.place[i]];
      gain += glm::dot(m_.moves[i], right) + shift_of(shift) * glm::dot(m_.moves[i], m_.moves[i]);
    }
    return gain;
  }

  // The sum after the moves, with as many held back as it takes.
  double go() {
    m_.share.assign(m_.moves.size(), 1.0);
    m_.share_then.assign(m_.moves.size(), 0.0);
    m_.to = from_;
    m_.to_normals = m_.normals;
    double after = walk_all();
    for (whole_ = after < sum_, held_ = 0; after >= sum_ && held_ < most_held; ++held_) {
      hold_back();
      after = walk_all();
    }
    return after;
  }
  // Whether nobody was held back.
  [[nodiscard]] bool whole() const { return whole_; }

  void tell_moves(SettleIteration& told) const {
    for (std::size_t i = 0; i < m_.to.positions.size(); ++i) {
      const double move = glm::distance(from_.positions[i], m_.to.positions[i]) / plan_.terms.width;
      told.greatest_move = std::max(told.greatest_move, move);
      told.mean_move += move;
    }
    told.mean_move /= static_cast<double>(m_.to.positions.size());
  }
  [[nodiscard]] const Settled& to() const { return m_.to; }

 private:
  static constexpr double tiny = 1e-12;

  [[nodiscard]] double shift_of(double shift) const {
    return shift / (plan_.terms.width * plan_.terms.width) + tiny;
  }

  // Those whose share has changed. The sum then.
  double walk_all() {
    for (std::size_t i = 0; i < m_.moves.size(); ++i) {
      if (i % 256 == 0) hear(heard_, until_);
      if (m_.share[i] != m_.share_then[i]) walk(i);
    }
    m_.share_then = m_.share;
    return sum_of_terms(plan_.terms, settings_, {m_.to.positions, m_.to_normals, m_.near});
  }
  void walk(std::size_t i) {
    glm::dvec3 move = m_.moves[i].x * m_.frames[i].u + m_.moves[i].y * m_.frames[i].v;
    const double length = glm::length(move), most = longest_step * plan_.terms.width;
    if (length > most) move *= most / length;
    const glm::dvec3& start = from_.positions[i];
    const OnSurface place =
        m_.walk.nearest({from_.triangles[i], start, m_.normals[i]}, start + m_.share[i] * move);
    m_.to.positions[i] = place.point;
    m_.to.triangles[i] = place.triangle;
    m_.to_normals[i] = place.normal;
  }

  void hold_back() {
    m_.grown.assign(m_.moves.size(), 0.0);
    add_terms(plan_.terms, settings_, {m_.to.positions, m_.to_normals, m_.near}, 1.0, m_.grown);
    add_terms(plan_.terms, settings_, {from_.positions, m_.normals, m_.near}, -1.0, m_.grown);
    const double most = *std::max_element(m_.grown.begin(), m_.grown.end());
    for (std::size_t i = 0; i < m_.grown.size(); ++i) {
      if (m_.grown[i] > held_from * most) m_.share[i] *= held_to;
    }
    // Nobody goes much farther than those beside: the bound is passed on from stitch to stitch.
    for (const auto& [a, b] : plan_.terms.graph.beside) {
      m_.share[a] = std::min(m_.share[a], m_.share[b] / held_to);
      m_.share[b] = std::min(m_.share[b], m_.share[a] / held_to);
    }
  }

  const SettleSettings& settings_;
  const SettlePlan& plan_;
  const Settled& from_;
  double sum_;
  const Heard& heard_;
  SettleMemory& m_;
  double begun_ = 0.0, until_ = 0.0;
  bool whole_ = true;
  std::int32_t held_ = 0;
};

}  // namespace

void begin_settling(const Input& input, const Fabric& fabric, const StitchSize& stitch,
                    const SettleSettings& settings, SettleWork& work, const Heard& heard) {
  SettlePlan plan;
  plan.terms.graph = make_settle_graph(fabric);
  plan.terms.width = stitch.width;
  plan.terms.height = stitch.height;
  hear(heard, 0.1);
  plan.normals = vertex_normals(input, part_of(heard, 0.1, 0.2));
  plan.start = onto_surface(input, knitting_path(fabric), part_of(heard, 0.2, 0.5));
  for (const auto& rim : plan.terms.graph.rims) {
    std::vector<glm::dvec3>& polygon = plan.terms.rim_polygons.emplace_back();
    for (const std::uint32_t stitch_of_rim : rim) polygon.push_back(plan.start.positions[stitch_of_rim]);
  }
  plan.pattern = make_block_pattern(plan.terms.graph.beside, plan.start.positions, part_of(heard, 0.5, 0.8));
  std::vector<glm::dvec3> normals;
  find_normals(input, plan, plan.start, normals);
  const Placed placed{plan.start.positions, normals};
  plan.terms.facing = facing_of(plan.terms.graph, placed);
  plan.terms.places = places_to_cover(
      input, {plan.terms.graph, placed.positions, placed.normals, stitch.width, stitch.height},
      part_of(heard, 0.8, 1.0));
  work = SettleWork{};
  work.memory = KeptMemory<SettleMemory>::made();
  work.sum = sum_of_terms(plan.terms, settings, placed);
  work.at = Shared(plan.start);
  work.plan = Shared(std::move(plan));
}

SettleIteration advance_settling(const Input& input, const SettleSettings& settings, SettleWork& work,
                                 const Heard& heard) {
  std::unique_ptr<SettleMemory> memory = work.memory.take();
  Iteration iteration(input, settings, work, heard, *memory);
  SettleIteration told{work.iteration + 1, 0, work.sum, work.sum};
  double shift = work.shift, growth = 16.0;
  for (bool promising = true; promising && !told.taken && told.tries < most_tries; growth *= 4.0) {
    ++told.tries;
    told.shift = shift;
    const bool solved = iteration.solve(shift);
    const double after = solved ? iteration.go() : work.sum;
    told.taken = after < work.sum;
    if (told.taken) {
      told.after = after;
    } else {
      promising = !solved || iteration.promised(shift) >= little_gain * work.sum;
      shift *= growth;
    }
  }
  const bool easy = told.tries == 1 && iteration.whole();
  work.shift = easy ? std::max(shift / 3.0, least_shift) : shift;
  if (!told.taken) {
    work.done = true;
    return told;
  }
  iteration.tell_moves(told);
  work.at = Shared(iteration.to());
  ++work.iteration;
  work.idle = told.before - told.after < little_gain * told.before ? work.idle + 1 : 0;
  work.sum = told.after;
  work.done = work.idle >= most_idle || work.iteration >= settings.most_iterations;
  if (!work.done) work.memory.give_back(std::move(memory));
  return told;
}

}  // namespace knit
