#include "app/compare/tube_figures.h"

#include <algorithm>
#include <cmath>

#include "knit/model/ring.h"
#include "knit/model/words.h"
#include "knit/quality/coverage.h"

namespace app {

namespace {

using knit::plural;

struct TubeAt {
  glm::dvec3 from{0.0}, to{0.0};  // of its two events
  glm::dvec3 middle{0.0};         // the centre of its middle row
  double height = 0.0;
};

std::vector<TubeAt> places_of(const knit::TubePlan& plan) {
  std::vector<TubeAt> places;
  for (const knit::Tube& tube : plan.tubes) {
    TubeAt at{plan.event(tube.bottom).position, plan.event(tube.top).position, {}, tube.height};
    at.middle =
        tube.curves.empty() ? 0.5 * (at.from + at.to) : knit::centre_of(*tube.curves[tube.curves.size() / 2]);
    places.push_back(at);
  }
  return places;
}

double distance_of(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

struct TubesAlike {
  std::size_t a = 0, b = 0;
  double apart = 0.0;
};

// All that lie near enough, nearest first, then by their numbers.
std::vector<TubesAlike> alike_by_place(const knit::TubePlan& a, const knit::TubePlan& b) {
  const std::vector<TubeAt> in_a = places_of(a), in_b = places_of(b);
  std::vector<TubesAlike> all;
  for (std::size_t j = 0; j < in_b.size(); ++j) {
    for (std::size_t i = 0; i < in_a.size(); ++i) {
      const double low = distance_of(in_a[i].from, in_b[j].from);
      const double high = distance_of(in_a[i].to, in_b[j].to);
      const double middle = distance_of(in_a[i].middle, in_b[j].middle);
      if (std::max({low, high, middle}) <= std::max(in_a[i].height, in_b[j].height))
        all.push_back({i, j, low + high + middle});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const TubesAlike& one, const TubesAlike& two) { return one.apart < two.apart; });
  return all;
}

// Of each tube of b, the one of a; npos: none.
constexpr std::size_t npos = static_cast<std::size_t>(-1);
std::vector<std::size_t> partners(const knit::TubePlan& a, const knit::TubePlan& b, bool same_mesh) {
  std::vector<std::size_t> of_b(b.tubes.size(), npos);
  if (!same_mesh) {
    for (std::size_t j = 0; j < std::min(a.tubes.size(), b.tubes.size()); ++j) of_b[j] = j;
    return of_b;
  }
  std::vector<bool> taken(a.tubes.size(), false);
  for (const TubesAlike& pair : alike_by_place(a, b)) {
    if (of_b[pair.b] != npos || taken[pair.a]) continue;
    of_b[pair.b] = pair.a;
    taken[pair.a] = true;
  }
  return of_b;
}

struct TubeMade {
  std::int32_t rounds = 0;
  std::int64_t stitches = 0;
};
std::vector<TubeMade> made_in(const knit::State& state) {
  std::vector<TubeMade> made(state.tubes->tubes.size());
  for (const auto& row : state.fabric.rows()) {
    TubeMade& tube = made.at(static_cast<std::size_t>(row->tube));
    ++tube.rounds;
    tube.stitches += knit::size_of(*row);
  }
  return made;
}

std::string name_at(std::size_t tube) { return knit::tube_name(static_cast<std::int32_t>(tube)); }

std::string sizes_text(std::int32_t rounds, std::int64_t stitches) {
  if (rounds == 0) return "without a round";
  return plural(rounds, "round", "rounds") + " and " + knit::stitch_count_text(stitches);
}

}  // namespace

TubeFigures tube_figures_of(const knit::State& state) {
  TubeFigures figures;
  if (!state.tubes) {
    figures.tubes = figures.yarns = state.fabric.empty() ? 0 : 1;
    return figures;
  }
  const knit::TubePlan& plan = *state.tubes;
  figures.tubes = static_cast<std::int32_t>(plan.tubes.size());
  for (const knit::TubeEvent& event : plan.events) {
    if (event.above.size() == 2) ++figures.splits;
    if (event.below.size() == 2) ++figures.joins;
  }
  figures.genus = knit::genus_of(plan);
  figures.yarns = plan.yarns;
  figures.holders = plan.held_most;
  figures.left_out = static_cast<std::int32_t>(plan.left_out.size());
  return figures;
}

std::optional<double> uncovered_share(const knit::Input& input, const knit::State& state,
                                      const knit::StitchSize& stitch) {
  if (!state.finished() || !(stitch.width > 0.0) || !(stitch.height > 0.0)) return std::nullopt;
  return knit::measure_uncovered(input, state, stitch.width, stitch.height).share;
}

std::vector<TubeLine> tube_lines(const knit::State& a, const knit::State& b, bool same_mesh) {
  std::vector<TubeLine> lines;
  if (!a.tubes || !b.tubes || std::max(a.tubes->tubes.size(), b.tubes->tubes.size()) < 2) return lines;
  const std::vector<std::size_t> of_b = partners(*a.tubes, *b.tubes, same_mesh);
  const std::vector<TubeMade> made_a = made_in(a), made_b = made_in(b);
  for (std::size_t j = 0; j < of_b.size(); ++j) {
    TubeLine line{"", name_at(j), 0, made_b[j].rounds, 0, made_b[j].stitches};
    if (const std::size_t i = of_b[j]; i != npos) {
      line.name_a = name_at(i);
      line.rounds_a = made_a[i].rounds;
      line.stitches_a = made_a[i].stitches;
    }
    lines.push_back(std::move(line));
  }
  for (std::size_t i = 0; i < made_a.size(); ++i) {
    if (std::find(of_b.begin(), of_b.end(), i) != of_b.end()) continue;
    lines.push_back({name_at(i), "", made_a[i].rounds, 0, made_a[i].stitches, 0});
  }
  return lines;
}

std::string words_of(const TubeLine& line, const RunNames& names) {
  if (line.name_a.empty())
    return "Tube " + line.name_b + ", " + sizes_text(line.rounds_b, line.stitches_b) + ", is in " +
           std::string(names.b) + " only.";
  if (line.name_b.empty())
    return "Tube " + line.name_a + ", " + sizes_text(line.rounds_a, line.stitches_a) + ", is in " +
           std::string(names.a) + " only.";
  std::string words = "Tube " + line.name_b;
  if (line.name_a != line.name_b) words += ", " + line.name_a + " before,";
  const bool rounds = line.rounds_a != line.rounds_b;
  const bool stitches = line.stitches_a != line.stitches_b;
  if (rounds)
    words +=
        " has " + plural(line.rounds_b, "round", "rounds") + ", " + std::to_string(line.rounds_a) + " before";
  if (rounds && stitches) words += ", and";
  if (stitches)
    words += (rounds ? " " : " has ") + knit::stitch_count_text(line.stitches_b) + ", " +
             std::to_string(line.stitches_a) + " before";
  return words + ".";
}

}  // namespace app
