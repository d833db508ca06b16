#include "knit/settle/settle.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "knit/mesh/triangle_tree.h"

namespace knit {

namespace {

constexpr double least_shift = 1e-5;
constexpr std::int32_t most_tries = 6;
constexpr double longest_step = 1.0;   // of a stitch in one iteration, in w
constexpr double little_gain = 2e-4;   // of the sum
constexpr std::int32_t most_idle = 3;  // iterations in a row

std::vector<glm::dvec3> normals_of(const Input& input, const SettlePlan& plan, const Settled& at) {
  std::vector<glm::dvec3> normals;
  normals.reserve(at.positions.size());
  for (std::size_t i = 0; i < at.positions.size(); ++i) {
    normals.push_back(normal_at(input, plan.normals, at.triangles[i], at.positions[i], {0.0, 1.0, 0.0}));
  }
  return normals;
}

Settled onto_surface(const Input& input, const std::vector<glm::dvec3>& path) {
  const TriangleTree tree(input.mesh.positions, input.mesh.triangles);
  Settled start;
  for (const glm::dvec3& position : path) {
    const SurfacePlace place = tree.nearest(position);
    start.positions.push_back(place.point);
    start.triangles.push_back(place.triangle);
  }
  return start;
}

// All that one iteration works with.
class Iteration {
 public:
  Iteration(const Input& input, const SettleSettings& settings, const SettleWork& work)
      : settings_(settings),
        plan_(*work.plan),
        from_(*work.at),
        normals_(normals_of(input, plan_, from_)),
        walk_(input, plan_.normals),
        solver_(plan_.pattern) {
    frames_.reserve(normals_.size());
    for (const glm::dvec3& normal : normals_) frames_.push_back(frame_across(normal));
    linearise(plan_.terms, settings_, {from_.positions, normals_}, frames_, plan_.pattern, system_);
  }

  // Whether the shift leads anywhere; where to is then to be seen.
  bool solve(double shift) {
    const double width = plan_.terms.width;
    return solver_.solve(system_, shift / (width * width) + tiny, moves_);
  }

  // What the terms would fall by if they were as straight as they were taken for.
  [[nodiscard]] double promised(double shift) const {
    const double width = plan_.terms.width;
    double gain = 0.0;
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      const glm::dvec2& right = system_.right[plan_.pattern.place[i]];
      gain += glm::dot(moves_[i], right) + shift / (width * width) * glm::dot(moves_[i], moves_[i]);
    }
    return gain;
  }

  // The sum after the moves.
  double go() {
    to_ = from_;
    to_normals_ = normals_;
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      glm::dvec3 move = moves_[i].x * frames_[i].u + moves_[i].y * frames_[i].v;
      const double length = glm::length(move), most = longest_step * plan_.terms.width;
      if (length > most) move *= most / length;
      const OnSurface place =
          walk_.nearest({from_.triangles[i], from_.positions[i], normals_[i]}, from_.positions[i] + move);
      to_.positions[i] = place.point;
      to_.triangles[i] = place.triangle;
      to_normals_[i] = place.normal;
    }
    return sum_of_terms(plan_.terms, settings_, {to_.positions, to_normals_});
  }

  void tell_moves(SettleIteration& told) const {
    for (std::size_t i = 0; i < to_.positions.size(); ++i) {
      const double move = glm::distance(from_.positions[i], to_.positions[i]) / plan_.terms.width;
      told.greatest_move = std::max(told.greatest_move, move);
      told.mean_move += move;
    }
    told.mean_move /= static_cast<double>(to_.positions.size());
  }
  Settled take() { return std::move(to_); }

 private:
  static constexpr double tiny = 1e-12;

  const SettleSettings& settings_;
  const SettlePlan& plan_;
  const Settled& from_;
  std::vector<glm::dvec3> normals_;
  SurfaceWalk walk_;
  BlockSolver solver_;
  std::vector<Frame> frames_;
  BlockSystem system_;
  std::vector<glm::dvec2> moves_;
  Settled to_;
  std::vector<glm::dvec3> to_normals_;
};

}  // namespace

void begin_settling(const Input& input, const Fabric& fabric, const StitchSize& stitch,
                    const SettleSettings& settings, SettleWork& work) {
  SettlePlan plan;
  plan.terms.graph = make_settle_graph(fabric);
  plan.terms.width = stitch.width;
  plan.terms.height = stitch.height;
  plan.normals = vertex_normals(input);
  plan.start = onto_surface(input, knitting_path(fabric));
  for (const auto& rim : plan.terms.graph.rims) {
    std::vector<glm::dvec3>& polygon = plan.terms.rim_polygons.emplace_back();
    for (const std::uint32_t stitch_of_rim : rim) polygon.push_back(plan.start.positions[stitch_of_rim]);
  }
  plan.pattern = make_block_pattern(plan.terms.graph.beside, plan.start.positions);
  const std::vector<glm::dvec3> normals = normals_of(input, plan, plan.start);
  const Placed placed{plan.start.positions, normals};
  plan.terms.facing = facing_of(plan.terms.graph, placed);
  plan.terms.tips = tips_of(plan.terms.graph, placed, stitch.width);
  work = SettleWork{};
  work.sum = sum_of_terms(plan.terms, settings, placed);
  work.at = Shared(plan.start);
  work.plan = Shared(std::move(plan));
}

SettleIteration advance_settling(const Input& input, const SettleSettings& settings, SettleWork& work) {
  Iteration iteration(input, settings, work);
  SettleIteration told{work.iteration + 1, 0, work.sum, work.sum};
  double shift = work.shift, growth = 4.0;
  for (bool promising = true; promising && !told.taken && told.tries < most_tries; growth *= 2.0) {
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
  work.shift = told.tries == 1 ? std::max(shift / 3.0, least_shift) : shift;
  if (!told.taken) {
    work.done = true;
    return told;
  }
  iteration.tell_moves(told);
  work.at = Shared(iteration.take());
  ++work.iteration;
  work.idle = told.before - told.after < little_gain * told.before ? work.idle + 1 : 0;
  work.sum = told.after;
  work.done = work.idle >= most_idle || work.iteration >= settings.most_iterations;
  return told;
}

}  // namespace knit
