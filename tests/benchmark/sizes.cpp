#include "tests/benchmark/sizes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <sstream>

#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/run/machine.h"
#include "tests/benchmark/pipeline.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Size {
  unsigned segments, stacks;  // about 2 * segments * (stacks - 1) triangles
  int turns;
};
constexpr std::array sizes{Size{71, 72, 15}, Size{224, 224, 9}, Size{708, 707, 3}};

struct Case {
  const char* name;
  knit::TimingKind timing;
  bool whole;  // the run to its end, rows from contours; else the stage timing alone
};
constexpr std::array cases{Case{"linear_with_contour_rows", knit::TimingKind::linear, true},
                           Case{"arc_length_with_contour_rows", knit::TimingKind::arc_length, true},
                           Case{"linear", knit::TimingKind::linear, false},
                           Case{"arc_length", knit::TimingKind::arc_length, false},
                           Case{"geodesic", knit::TimingKind::geodesic, false},
                           Case{"harmonic", knit::TimingKind::harmonic, false}};

double run_once(const knit::Input& input, const Case& what) {
  knit::Parameters parameters = knit::default_parameters(input.bounds);
  parameters.timing.kind = what.timing;
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  knit::State state;
  const auto start = Clock::now();
  while (!state.finished() && (what.whole || state.stage() == knit::Stage::timing)) {
    if (knit::is_stop(knit::advance(input, parameters, state))) break;
  }
  return milliseconds_since(start);
}

Json measure(const Size& size) {
  const knit::Mesh mesh = knit::sphere(size.segments, size.stacks, false);
  std::ostringstream text;
  knit::write_obj(text, mesh, "");
  const auto input = knit::make_input(mesh);
  std::vector<double> parse;
  std::array<std::vector<double>, cases.size()> runs;
  for (int turn = 0; turn < size.turns; ++turn) {
    parse.push_back(parse_once(text.str()));
    for (std::size_t i = 0; i < cases.size(); ++i) runs[i].push_back(run_once(*input, cases[i]));
  }
  Json json;
  json["triangles"] = mesh.triangles.size();
  json["parse_ms"] = median(parse);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    json["over_parse"][cases[i].name] = median(runs[i]) / median(parse);
  }
  return json;
}

}  // namespace

Json measure_sizes() {
  Json all = Json::array();
  for (const Size& size : sizes) all.push_back(measure(size));
  return all;
}

}  // namespace benchmark
