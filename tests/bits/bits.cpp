// Six runs and the hash of all states that each comes to: the same wherever the program runs, if the bits are.
// bits ASSETS [ROUNDS] prints a line a run. `tools/web.sh bits` holds a page's lines against a native build's. With ROUNDS
// it prints milliseconds instead, the least of so many: `tools/web.sh times`.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "app/files/load.h"
#include "knit/model/hash.h"
#include "knit/model/stitch_size.h"
#include "knit/run/timeline.h"

namespace {

struct Setting {
  const char *key, *value;
};
struct Run {
  const char* example;
  std::array<Setting, 4> settings;  // those with a key
};

constexpr std::array<Run, 6> runs{
    {{"thesis-sphere", {{{"timing", "linear"}, {"rows", "rings"}, {}, {}}}},
     {"sphere", {{{"timing", "arc-length"}, {"rows", "contours"}, {}, {}}}},
     {"egg", {{{"timing", "harmonic"}, {"rows", "contours"}, {"settle", "on"}, {}}}},
     {"vase", {{{"timing", "geodesic"}, {"rows", "contours"}, {"placement", "nearest"}, {"relax", "on"}}}},
     {"y", {{{"timing", "geodesic"}, {"rows", "contours"}, {"settle", "on"}, {}}}},
     {"heel", {{{"short-rows", "auto"}, {"settle", "on"}, {}, {}}}}}};

using Clock = std::chrono::steady_clock;

double since_ms(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Ready {
  app::Loaded opened;
  knit::Parameters parameters;
  std::string about;
};

// Or a sentence.
std::variant<Ready, std::string> make_ready(const Run& run, const std::string& assets) {
  auto loaded = app::load_example(assets, run.example);
  if (const auto* error = std::get_if<std::string>(&loaded)) return *error;
  app::Loaded& opened = std::get<app::Loaded>(loaded);
  knit::Parameters parameters = opened.parameters;
  std::string about = run.example;
  for (const Setting& setting : run.settings) {
    if (setting.key == nullptr) continue;
    const knit::ParameterInfo* info = knit::find_parameter(setting.key);
    if (info == nullptr) return std::string(setting.key) + " is no parameter.";
    if (const auto fault = knit::set_value(*info, parameters, setting.value)) return *fault;
    about += std::string(" ") + setting.key + "=" + setting.value;
  }
  const auto resolved = knit::resolved(parameters, *opened.input);
  return Ready{std::move(opened), resolved, std::move(about)};
}

void print_bits(const Ready& ready) {
  knit::Timeline timeline(ready.opened.input, ready.parameters);
  knit::Hasher all;
  timeline.extend_to_end();
  for (std::size_t step = 0; step <= timeline.known(); step += 1 + timeline.known() / 64) {
    timeline.seek(step);
    all.add(knit::hash_of(timeline.state()));
  }
  timeline.seek(timeline.known());
  all.add(knit::hash_of(timeline.state()));
  std::printf("%s: %zu steps, %016llx\n", ready.about.c_str(), timeline.known(),
              static_cast<unsigned long long>(all.value()));
}

void print_times(const Run& run, const std::string& assets, int rounds) {
  double reading_ms = std::numeric_limits<double>::infinity();
  double run_ms = reading_ms;
  std::string about;
  for (int i = 0; i < rounds; ++i) {
    const auto start = Clock::now();
    const auto made = make_ready(run, assets);
    reading_ms = std::min(reading_ms, since_ms(start));
    const auto& ready = std::get<Ready>(made);
    const auto begun = Clock::now();
    knit::Timeline timeline(ready.opened.input, ready.parameters);
    timeline.extend_to_end();
    run_ms = std::min(run_ms, since_ms(begun));
    about = ready.about;
  }
  std::printf("%s: read in %.1f ms, run in %.1f ms\n", about.c_str(), reading_ms, run_ms);
}

}  // namespace

int main(int count, char** words) {
  const int rounds = count == 3 ? std::atoi(words[2]) : 0;
  if (count < 2 || count > 3 || (count == 3 && rounds < 1)) {
    std::fputs("bits ASSETS [ROUNDS]\n", stderr);
    return 2;
  }
  for (const Run& run : runs) {
    const auto made = make_ready(run, words[1]);
    if (const auto* fault = std::get_if<std::string>(&made)) {
      std::fprintf(stderr, "bits: %s\n", fault->c_str());
      return 1;
    }
    if (rounds > 0) {
      print_times(run, words[1], rounds);
    } else {
      print_bits(std::get<Ready>(made));
    }
  }
  return 0;
}
