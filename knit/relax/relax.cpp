#include "knit/relax/relax.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "knit/model/bug.h"
#include "knit/timing/dissection.h"
#include "knit/timing/elimination.h"

namespace knit {

namespace {

constexpr double over = 1.2;     // L's stiffness, of the springs'
constexpr double little = 1e-6;  // on L's diagonal
constexpr double most_momentum = 0.9;
constexpr double contact_near = 1.8, contact_rest = 1.0;      // in w
constexpr int contact_apart = 5;                              // steps of fabric
constexpr double next_to_nothing = 1e-3;                      // moved in an iteration, in w
constexpr std::int32_t still_enough = 5, unsettled_for = 10;  // iterations

double contact_stiffness(const RelaxPlan& plan) { return course_stiffness * plan.height / plan.width; }

// Who L couples, how stiffly.
struct Coupling {
  std::uint32_t a, b;
  double stiffness;
};

std::vector<Coupling> couplings_of(const RelaxPlan& plan, const std::vector<StitchPair>& touching) {
  std::vector<Coupling> couplings;
  couplings.reserve(plan.net.springs.size() + touching.size());
  for (const Spring& spring : plan.net.springs) {
    if (spring.kind != SpringKind::shear) couplings.push_back({spring.a, spring.b, over * spring.stiffness});
  }
  for (const auto& [a, b] : touching) couplings.push_back({a, b, over * contact_stiffness(plan)});
  return couplings;
}

// Per stitch its place in the order of elimination.
std::vector<std::uint32_t> places_of(const std::vector<Coupling>& couplings,
                                     std::span<const glm::dvec3> positions, const Heard& heard) {
  Spokes spokes;
  spokes.first.assign(positions.size() + 1, 0);
  for (const Coupling& each : couplings) {
    ++spokes.first[each.a + 1];
    ++spokes.first[each.b + 1];
  }
  for (std::size_t i = 0; i < positions.size(); ++i) spokes.first[i + 1] += spokes.first[i];
  std::vector<std::uint32_t> next(spokes.first.begin(), spokes.first.end() - 1);
  spokes.spokes.resize(2 * couplings.size());
  for (const Coupling& each : couplings) {
    spokes.spokes[next[each.a]++] = {each.b, 0.0};
    spokes.spokes[next[each.b]++] = {each.a, 0.0};
  }
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> place(positions.size(), none);
  std::uint32_t count = 0;
  for (const VertexId stitch : order_by_dissection(spokes, positions, heard)) place[stitch] = count++;
  for (std::uint32_t& at : place) {
    if (at == none) at = count++;  // coupled with nothing
  }
  return place;
}

Elimination factor_of(const std::vector<Coupling>& couplings, const std::vector<std::uint32_t>& place,
                      const Heard& heard) {
  struct Entry {
    std::uint32_t column, row;
    double value;
  };
  std::vector<Entry> entries;
  entries.reserve(3 * couplings.size() + place.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) entries.push_back({i, i, little});
  for (const Coupling& each : couplings) {
    const auto [low, high] = std::minmax(place[each.a], place[each.b]);
    entries.push_back({low, low, each.stiffness});
    entries.push_back({high, high, each.stiffness});
    entries.push_back({low, high, -each.stiffness});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.column != b.column ? a.column < b.column : a.row < b.row;
  });
  std::vector<int> first{0}, row;
  std::vector<double> value;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool same =
        i > 0 && entries[i].column == entries[i - 1].column && entries[i].row == entries[i - 1].row;
    if (same) {
      value.back() += entries[i].value;
      continue;
    }
    if (i > 0 && entries[i].column != entries[i - 1].column) first.push_back(static_cast<int>(row.size()));
    row.push_back(static_cast<int>(entries[i].row));
    value.push_back(entries[i].value);
  }
  first.push_back(static_cast<int>(row.size()));
  return Elimination({first, row, value}, heard);
}

}  // namespace

struct RelaxMemory {
  // What it was made for; these keep it from being taken for that of others at the same address.
  std::shared_ptr<const RelaxPlan> plan;
  std::shared_ptr<const std::vector<StitchPair>> touching;
  std::vector<std::uint32_t> place;
  std::optional<Elimination> factor;
  std::optional<Joined> joined;
  std::vector<glm::dvec3> ahead, force, moves;
};

namespace {

// All that one iteration does.
class Iteration {
 public:
  Iteration(RelaxWork& work, const Heard& heard, RelaxMemory& memory)
      : work_(work), plan_(*work.plan), heard_(heard), m_(memory) {}

  RelaxIteration run() {
    if (m_.plan != work_.plan.pointer()) {
      m_ = RelaxMemory{};
      m_.plan = work_.plan.pointer();
      m_.joined.emplace(plan_.net);
    }
    ++work_.iteration;
    if (finds_touching(work_.iteration)) find_touching();
    if (!m_.factor || m_.touching != work_.touching.pointer()) make_factor();
    look_ahead();
    pull();
    return go();
  }

 private:
  void find_touching() {
    std::vector<StitchPair> pairs =
        pairs_near(*m_.joined, work_.places->at, contact_near * plan_.width, contact_apart);
    if (work_.touching && pairs == *work_.touching) return;
    work_.touching = Shared(std::move(pairs));
    work_.unsettled_at = work_.iteration;
  }
  void make_factor() {
    const std::vector<Coupling> couplings = couplings_of(plan_, *work_.touching);
    m_.place = places_of(couplings, plan_.start, part_of(heard_, 0.0, 0.3));
    m_.factor.emplace(factor_of(couplings, m_.place, part_of(heard_, 0.3, 0.9)));
    m_.touching = work_.touching.pointer();
    if (!m_.factor->factored()) throw Bug("springs hold a piece together: their matrix is positive definite");
  }
  void look_ahead() {
    const RelaxPlaces& x = *work_.places;
    m_.ahead.resize(x.at.size());
    for (std::size_t i = 0; i < x.at.size(); ++i)
      m_.ahead[i] = x.at[i] + work_.momentum * (x.at[i] - x.before[i]);
  }
  void pull() {
    m_.force.assign(m_.ahead.size(), glm::dvec3(0.0));
    if (plan_.pressure != 0.0) add_pressure(plan_.walls, m_.ahead, plan_.pressure, m_.force);
    add_pull(plan_.net, m_.ahead, m_.force);
    const double rest = contact_rest * plan_.width;
    for (const auto& [a, b] : *work_.touching) {
      const glm::dvec3 way = m_.ahead[a] - m_.ahead[b];
      const double length = std::sqrt(glm::dot(way, way));
      if (length >= rest || length < 1e-12 * rest) continue;
      const glm::dvec3 push = way * (contact_stiffness(plan_) * (rest / length - 1.0));
      m_.force[a] += push;
      m_.force[b] -= push;
    }
    m_.moves.resize(m_.force.size());
    for (std::size_t i = 0; i < m_.force.size(); ++i) m_.moves[m_.place[i]] = m_.force[i];
    m_.factor->solve(std::span<glm::dvec3>(m_.moves), part_of(heard_, 0.9, 1.0));
  }
  RelaxIteration go() {
    const RelaxPlaces& x = *work_.places;
    RelaxPlaces to;
    to.before = x.at;
    to.at.reserve(x.at.size());
    double against = 0.0, most = 0.0;
    for (std::size_t i = 0; i < x.at.size(); ++i) {
      const glm::dvec3 next = m_.ahead[i] + m_.moves[m_.place[i]], move = next - x.at[i];
      against += glm::dot(m_.ahead[i] - next, move);
      most = std::max(most, glm::dot(move, move));
      to.at.push_back(next);
    }
    RelaxIteration told{work_.iteration, std::sqrt(most) / plan_.width};
    const double t = (1.0 + std::sqrt(1.0 + 4.0 * work_.t * work_.t)) / 2.0;
    told.restarted = against > 0.0;
    work_.momentum = told.restarted ? 0.0 : std::min((work_.t - 1.0) / t, most_momentum);
    work_.t = told.restarted ? 1.0 : t;
    if (told.restarted) work_.unsettled_at = work_.iteration;
    const bool still =
        told.greatest_move < next_to_nothing && work_.iteration - work_.unsettled_at >= unsettled_for;
    work_.still = still ? work_.still + 1 : 0;
    told.touching = static_cast<std::int32_t>(work_.touching->size());
    told.volume = std::abs(volume_of(plan_.walls, to.at));
    work_.places = Shared(std::move(to));
    return told;
  }

  RelaxWork& work_;
  const RelaxPlan& plan_;
  const Heard& heard_;
  RelaxMemory& m_;
};

// Pressure pulls with the area, springs with the length: past some stuffing nothing holds, and places would run to infinity.
bool is_past_holding(const RelaxPlan& plan, double volume) {
  constexpr double bound = 1000.0;  // balls that its unstretched stitches would be
  return !(volume <= bound * 4.0 / 3.0 * std::numbers::pi * plan.radius * plan.radius * plan.radius);
}

}  // namespace

void begin_relaxing(const Fabric& fabric, const StitchSize& stitch, const RelaxSettings& settings,
                    RelaxWork& work, const Heard& heard) {
  RelaxPlan plan;
  plan.start = knitting_path(fabric);
  hear(heard, 0.1);
  plan.net = make_spring_net(fabric, stitch);
  hear(heard, 0.5);
  const Enclosure all = enclosure_of(fabric);
  plan.lidded = inner_rows(fabric, all, plan.start);
  plan.walls = without_rows(fabric, all, plan.lidded);
  plan.width = stitch.width;
  plan.height = stitch.height;
  const double faces = static_cast<double>(all.quads.size() + all.triangles.size());
  plan.radius = std::sqrt(faces * stitch.width * stitch.height / (4.0 * std::numbers::pi));
  const double outwards = volume_of(plan.walls, plan.start) < 0.0 ? -1.0 : 1.0;
  plan.pressure = outwards * settings.stuffing * (course_stiffness + wale_stiffness) / plan.radius;
  hear(heard, 1.0);
  work = RelaxWork{};
  work.memory = KeptMemory<RelaxMemory>::made();
  work.places = Shared(RelaxPlaces{plan.start, plan.start});
  work.plan = Shared(std::move(plan));
}

RelaxIteration advance_relaxing(const RelaxSettings& settings, RelaxWork& work, const Heard& heard) {
  std::unique_ptr<RelaxMemory> memory = work.memory.take();
  RelaxWork next = work;
  const RelaxIteration told = Iteration(next, heard, *memory).run();
  next.last_move = told.greatest_move;
  next.done = next.still >= still_enough || next.iteration >= settings.most_iterations ||
              is_past_holding(*next.plan, told.volume);
  work = std::move(next);
  if (!work.done) work.memory.give_back(std::move(memory));
  return told;
}

Relaxed finish_relaxing(const RelaxWork& work) {
  const RelaxPlan& plan = *work.plan;
  Relaxed made;
  made.positions = laid_onto(work.places->at, plan.start);
  made.iterations = work.iteration;
  made.last_move = work.last_move;
  made.settled = work.still >= still_enough;
  for (const auto& [a, b] : *work.touching) {
    const glm::dvec3 way = work.places->at[a] - work.places->at[b];
    if (glm::dot(way, way) < contact_rest * contact_rest * plan.width * plan.width)
      made.touching.push_back({a, b});
  }
  return made;
}

Relaxed relax(const Fabric& fabric, const StitchSize& stitch, const RelaxSettings& settings,
              const Heard& heard) {
  RelaxWork work;
  begin_relaxing(fabric, stitch, settings, work, part_of(heard, 0.0, 0.1));
  while (!work.done) {
    hear(heard, 0.1 + 0.9 * static_cast<double>(work.iteration) / settings.most_iterations);
    advance_relaxing(settings, work);
  }
  return finish_relaxing(work);
}

}  // namespace knit
