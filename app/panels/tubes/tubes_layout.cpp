#include "app/panels/tubes/tubes_layout.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/panels/kit/tube_marks.h"

namespace app {

namespace {

using TubeLine = std::vector<knit::TubeId>;  // from left to right

std::size_t index_of(std::int32_t id) { return static_cast<std::size_t>(id); }

// --- the order from left to right ------------------------------------------------------------------------------

// All tubes in one line, each put into it where it begins; of those that cross one height it is their order.
struct Arrangement {
  TubeLine line;
  std::set<std::pair<knit::TubeId, knit::TubeId>> beside;  // neighbours at some height, the left one first
  std::int64_t crossings = 0;
};

class Arranger {
 public:
  explicit Arranger(const knit::TubePlan& plan) : plan_(plan), choices_(plan.events.size(), 0) {
    std::size_t open = 0;
    for (const knit::TubeEvent& event : plan.events) {
      const bool divides = event.below.size() == 2 || event.above.size() == 2;
      ways_.push_back(event.below.empty() ? open + 1 : divides ? 2 : 1);
      open += event.above.size();
      open -= std::min(open, event.below.size());
    }
    const std::size_t cost = plan.tubes.size() * plan.tubes.size() + 1;
    tries_left_ = std::max<std::size_t>(64, 20'000'000 / cost);
  }

  Arrangement best() {
    crossings_ = arranged(false).crossings;
    bool better = true;
    while (better && crossings_ > 0 && tries_left_ > 0) better = better_by_one() || better_by_two();
    return arranged(true);
  }

 private:
  // `tried`: the choice to be there instead; gives whether it is kept.
  bool keep_if_better(std::size_t event, std::size_t tried) {
    if (tries_left_ == 0) return false;
    --tries_left_;
    const std::size_t before = std::exchange(choices_[event], tried);
    const std::int64_t crossings = arranged(false).crossings;
    if (crossings < crossings_) {
      crossings_ = crossings;
      return true;
    }
    choices_[event] = before;
    return false;
  }

  bool better_by_one() {
    bool better = false;
    for (std::size_t event = 0; event < choices_.size(); ++event) {
      for (std::size_t tried = 0; tried < ways_[event]; ++tried)
        better = (tried != choices_[event] && keep_if_better(event, tried)) || better;
    }
    return better;
  }

  bool better_by_two() {
    for (std::size_t event = 0; event < choices_.size(); ++event) {
      const std::size_t before = choices_[event];
      for (std::size_t first = 0; first < ways_[event]; ++first) {
        if (first == before) continue;
        choices_[event] = first;
        for (std::size_t other = event + 1; other < choices_.size(); ++other) {
          for (std::size_t tried = 0; tried < ways_[other]; ++tried) {
            if (tried != choices_[other] && keep_if_better(other, tried)) return true;
          }
        }
      }
      choices_[event] = before;
    }
    return false;
  }

  [[nodiscard]] Arrangement arranged(bool with_neighbours) const {
    Arrangement made;
    std::vector<std::uint8_t> open(plan_.tubes.size(), 0);
    for (std::size_t i = 0; i < plan_.events.size(); ++i) {
      const knit::TubeEvent& event = plan_.events[i];
      for (const knit::TubeId id : event.below) open[index_of(id)] = 0;
      const auto place = event.below.empty() ? place_among(made.line, open, choices_[i])
                                             : place_on(made, open, event.below, choices_[i]);
      TubeLine above = event.above;
      if (event.below.size() < 2 && choices_[i] == 1) std::reverse(above.begin(), above.end());
      made.line.insert(made.line.begin() + place, above.begin(), above.end());
      for (const knit::TubeId id : above) open[index_of(id)] = 1;
      if (with_neighbours) note_neighbours(open, made);
    }
    return made;
  }

  // Of what is cast on: so many open ones stand right of it.
  static std::ptrdiff_t place_among(const TubeLine& line, const std::vector<std::uint8_t>& open,
                                    std::size_t right) {
    auto place = static_cast<std::ptrdiff_t>(line.size());
    while (right > 0 && place > 0) {
      --place;
      if (open[index_of(line[index_of(static_cast<std::int32_t>(place))])] != 0) --right;
    }
    return place;
  }

  // Right behind the tube below, or one of the two; counts what stands between them.
  static std::ptrdiff_t place_on(Arrangement& made, const std::vector<std::uint8_t>& open,
                                 const std::vector<knit::TubeId>& below, std::size_t choice) {
    const auto at = [&](knit::TubeId id) { return std::find(made.line.begin(), made.line.end(), id); };
    auto left = at(below.front());
    auto right = at(below.back());
    if (right < left) std::swap(left, right);
    made.crossings += std::count_if(left, right, [&](knit::TubeId id) { return open[index_of(id)] != 0; });
    const bool on_right = below.size() > 1 && choice == 1;
    return (on_right ? right : left) - made.line.begin() + 1;
  }

  static void note_neighbours(const std::vector<std::uint8_t>& open, Arrangement& made) {
    knit::TubeId left = -1;
    for (const knit::TubeId id : made.line) {
      if (open[index_of(id)] == 0) continue;
      if (left >= 0) made.beside.insert({left, id});
      left = id;
    }
  }

  const knit::TubePlan& plan_;
  // Of each event: where what is cast on stands, which tube of a split is left, or which place a join takes.
  std::vector<std::size_t> choices_, ways_;
  std::int64_t crossings_ = 0;
  std::size_t tries_left_ = 0;
};

// --- places ----------------------------------------------------------------------------------------------------

class Columns {
 public:
  Columns(const knit::TubePlan& plan, const Arrangement& arrangement)
      : plan_(plan),
        line_(arrangement.line),
        x_(plan.tubes.size(), 0.0),
        left_of_(plan.tubes.size()),
        right_of_(plan.tubes.size()) {
    for (const auto& [left, right] : arrangement.beside) {
      left_of_[index_of(right)].push_back(left);
      right_of_[index_of(left)].push_back(right);
    }
  }

  // As far left as they go, then each as near to the tubes that it meets as those beside it let it come.
  std::vector<double> places() {
    double width = 0.0;
    for (const knit::TubeId id : line_) {
      x_[index_of(id)] = lowest(id);
      width = std::max(width, x_[index_of(id)]);
    }
    constexpr int sweeps = 24;
    for (int i = 0; i < sweeps; ++i) {
      for (std::size_t at = line_.size(); at > 0; --at) move(line_[at - 1], width);
      for (const knit::TubeId id : line_) move(id, width);
    }
    return x_;
  }

 private:
  [[nodiscard]] double lowest(knit::TubeId id) const {
    double low = 0.0;
    for (const knit::TubeId left : left_of_[index_of(id)]) low = std::max(low, x_[index_of(left)] + 1.0);
    return low;
  }

  void move(knit::TubeId id, double width) {
    double sum = 0.0;
    double count = 0.0;
    const knit::Tube& tube = plan_.tube(id);
    const auto add = [&](const std::vector<knit::TubeId>& met) {
      for (const knit::TubeId other : met) sum += x_[index_of(other)];
      count += static_cast<double>(met.size());
    };
    add(plan_.event(tube.bottom).below);
    add(plan_.event(tube.top).above);
    if (count == 0.0) return;
    double high = width;
    for (const knit::TubeId right : right_of_[index_of(id)]) high = std::min(high, x_[index_of(right)] - 1.0);
    x_[index_of(id)] = std::max(lowest(id), std::min(sum / count, high));
  }

  const knit::TubePlan& plan_;
  const TubeLine& line_;
  std::vector<double> x_;  // in columns
  std::vector<TubeLine> left_of_, right_of_;
};

void place_across(const knit::TubePlan& plan, TubesLayout& layout) {
  const Arrangement arrangement = Arranger(plan).best();
  layout.crossings = arrangement.crossings;
  const std::vector<double> x = Columns(plan, arrangement).places();
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double columns = *high - *low + 1.0;
  layout.column = 1.0 / columns;
  for (std::size_t i = 0; i < x.size(); ++i) layout.tubes[i].x = (x[i] - *low + 0.5) / columns;
  // An event stands where the one tube is that it has on a side.
  for (std::size_t i = 0; i < plan.events.size(); ++i) {
    const knit::TubeEvent& event = plan.events[i];
    const auto& alone = event.below.size() == 1 ? event.below : event.above;
    layout.events[i].x = layout.tubes[index_of(alone.front())].x;
  }
}

// Half by rank, so that none lie on each other, half by how high they are.
void place_upward(const knit::TubePlan& plan, TubesLayout& layout) {
  const double last = static_cast<double>(plan.events.size()) - 1.0;
  const double from = plan.events.front().value;
  const double range = plan.events.back().value - from;
  for (std::size_t i = 0; i < plan.events.size(); ++i) {
    const double rank = static_cast<double>(i) / std::max(1.0, last);
    layout.events[i].y = range > 0.0 ? 0.5 * rank + 0.5 * (plan.events[i].value - from) / range : rank;
  }
  for (std::size_t i = 0; i < plan.tubes.size(); ++i) {
    layout.tubes[i].low = layout.events[index_of(plan.tubes[i].bottom)].y;
    layout.tubes[i].high = layout.events[index_of(plan.tubes[i].top)].y;
  }
}

// --- yarns and rows --------------------------------------------------------------------------------------------

void give_yarns(const knit::TubePlan& plan, TubesLayout& layout) {
  const std::vector<std::int32_t> yarns = yarns_of(plan);
  for (std::size_t i = 0; i < yarns.size(); ++i) {
    layout.tubes[i].yarn = yarns[i];
    layout.yarns = std::max(layout.yarns, yarns[i] + 1);
  }
}

void number_rows(const knit::TubePlan& plan, TubesLayout& layout) {
  for (const knit::TubeId id : plan.order) {
    const knit::Tube& tube = plan.tube(id);
    if (tube.rows() > 0) layout.tubes[index_of(id)].first_row = layout.rounds + 1;
    layout.rounds += tube.rows();
    for (const double length : tube.lengths) layout.longest = std::max(layout.longest, length);
  }
}

// --- a machine's view ------------------------------------------------------------------------------------------

// Whether a graph falls to nothing when vertices of at most two neighbours are taken out, the two then being joined: it is
// planar then.
bool falls_to_nothing(std::vector<std::set<std::size_t>> neighbours) {
  std::vector<std::size_t> waiting(neighbours.size());
  for (std::size_t i = 0; i < waiting.size(); ++i) waiting[i] = i;
  std::vector<std::uint8_t> out(neighbours.size(), 0);
  std::size_t left = neighbours.size();
  while (!waiting.empty()) {
    const std::size_t vertex = waiting.back();
    waiting.pop_back();
    if (out[vertex] != 0 || neighbours[vertex].size() > 2) continue;
    out[vertex] = 1;
    --left;
    const std::vector<std::size_t> met(neighbours[vertex].begin(), neighbours[vertex].end());
    for (const std::size_t other : met) neighbours[other].erase(vertex);
    if (met.size() == 2) {
      neighbours[met[0]].insert(met[1]);
      neighbours[met[1]].insert(met[0]);
    }
    waiting.insert(waiting.end(), met.begin(), met.end());
  }
  return left == 0;
}

bool is_series_parallel(const knit::TubePlan& plan) {
  const std::size_t source = plan.events.size();
  const std::size_t sink = source + 1;
  std::vector<std::set<std::size_t>> neighbours(sink + 1);
  const auto join = [&](std::size_t a, std::size_t b) {
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  };
  join(source, sink);
  for (std::size_t i = 0; i < plan.events.size(); ++i) {
    if (plan.events[i].below.empty()) join(source, i);
    if (plan.events[i].above.empty()) join(i, sink);
  }
  for (const knit::Tube& tube : plan.tubes) join(index_of(tube.bottom), index_of(tube.top));
  return falls_to_nothing(std::move(neighbours));
}

}  // namespace

TubesLayout lay_out(const knit::TubePlan& plan) {
  TubesLayout layout;
  if (plan.tubes.empty()) return layout;
  layout.tubes.resize(plan.tubes.size());
  layout.events.resize(plan.events.size());
  place_across(plan, layout);
  place_upward(plan, layout);
  give_yarns(plan, layout);
  number_rows(plan, layout);
  return layout;
}

knit::TubeId tube_of_row(const knit::TubePlan& plan, const TubesLayout& layout, knit::RowId row) {
  for (std::size_t i = 0; i < layout.tubes.size(); ++i) {
    const knit::RowId first = layout.tubes[i].first_row;
    if (first > 0 && row >= first && row < first + plan.tubes[i].rows()) return static_cast<knit::TubeId>(i);
  }
  return -1;
}

std::int32_t loops_of(const knit::TubePlan& plan) {
  return static_cast<std::int32_t>(plan.tubes.size()) - static_cast<std::int32_t>(plan.events.size()) + 1;
}

MachineVerdict machine_verdict(const knit::TubePlan& plan, const TubesLayout& layout) {
  if (loops_of(plan) == 0) return MachineVerdict::tree;
  if (layout.crossings == 0) return MachineVerdict::drawn;
  return is_series_parallel(plan) ? MachineVerdict::series_parallel : MachineVerdict::not_known;
}

}  // namespace app
