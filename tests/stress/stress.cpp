// Random runs over shapes that branch, every promise held against each: a line for each that fails, and what all came to.
//
//   build/asan/stress RUNS [--seed N] [MESH.obj...]            exit code 1 when a run fails
//   build/asan/stress --only NUMBER [--seed N] [MESH.obj...]   that run once more: the same files in the same order
//            ... --write FILE.obj                             and writes its mesh, for knit-mesh with the options shown
//
// Bodies are made in code; two of three runs are on the files, where there are any. A file that is not fit is said and left
// out. A run that stops is no failure where it says why: stitches too large for a shape make no tube.
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "knit/import/check.h"
#include "knit/import/obj.h"
#include "knit/mesh/shapes.h"
#include "tests/stress/check_run.h"

namespace {

namespace fs = std::filesystem;

struct Wish {
  std::uint32_t runs = 0, seed = 1;
  std::optional<std::uint32_t> only;
  fs::path write;
  std::vector<fs::path> files;
};

int say(const std::string& error) {
  std::fprintf(stderr, "stress: %s\n", error.c_str());
  return 2;
}

std::optional<std::uint32_t> number_in(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Takes the words that belong together; what is wrong is a sentence.
std::string take_word(Wish& wish, const std::vector<std::string>& words, std::size_t& i) {
  const std::string& word = words[i];
  if (word == "--write" && i + 1 < words.size()) {
    wish.write = words[++i];
    return {};
  }
  if (word == "--seed" || word == "--only") {
    const auto number = i + 1 < words.size() ? number_in(words[++i]) : std::nullopt;
    if (!number) return word + " needs a whole number.";
    if (word == "--seed") wish.seed = *number;
    if (word == "--only") wish.only = number;
    return {};
  }
  if (word.starts_with("--")) return "there is no option " + word + ".";
  const auto number = number_in(word);
  if (number && wish.runs == 0 && !fs::exists(word))
    wish.runs = *number;
  else
    wish.files.emplace_back(word);
  return {};
}

stress::Meshes read_all(const std::vector<fs::path>& files) {
  stress::Meshes meshes;
  for (const fs::path& file : files) {
    auto read = knit::read_obj_file(file);
    if (const auto* error = std::get_if<knit::ObjError>(&read)) {
      std::printf("left out %s: %s\n", file.c_str(), error->sentence.c_str());
      continue;
    }
    auto mesh = std::get<knit::Mesh>(std::move(read));
    const knit::CheckResult result = knit::check(mesh);
    if (result.fit())
      meshes.push_back(knit::make_input(std::move(mesh)));
    else
      std::printf("left out %s: %s\n", file.c_str(), result.findings.front().sentence.c_str());
  }
  return meshes;
}

struct Sums {
  std::uint32_t runs = 0, stopped = 0, broken = 0, branching = 0, settled = 0;
  std::size_t steps = 0, tubes = 0, deals = 0, stitches = 0, left_out = 0, handles_left_out = 0;
  double milliseconds = 0.0, slowest_ms = 0.0;
  std::uint32_t slowest = 0;
  std::map<std::string, std::uint32_t> stops;  // by their words

  void add(std::uint32_t number, const stress::Outcome& outcome) {
    ++runs;
    stopped += outcome.verdict == stress::Verdict::stopped ? 1 : 0;
    broken += outcome.verdict == stress::Verdict::broken ? 1 : 0;
    settled += outcome.settled > 0 ? 1 : 0;
    branching += outcome.tubes > 1 ? 1 : 0;
    if (outcome.verdict == stress::Verdict::stopped) ++stops[outcome.words];
    steps += outcome.steps;
    tubes += outcome.tubes;
    deals += outcome.deals;
    stitches += outcome.stitches;
    left_out += outcome.left_out;
    handles_left_out += outcome.handles_left_out;
    milliseconds += outcome.milliseconds;
    if (outcome.milliseconds > slowest_ms) {
      slowest_ms = outcome.milliseconds;
      slowest = number;
    }
  }
  void print() const {
    for (const auto& [words, count] : stops) std::printf("stopped %u: %s\n", count, words.c_str());
    std::printf("%u runs: %u sound, %u stopped, %u broken; %u with more than one tube, %u settled\n", runs,
                runs - stopped - broken, stopped, broken, branching, settled);
    std::printf(
        "%zu tubes, %zu splits, joins and rings, %zu stitches, %zu steps, %zu left out, %zu of them "
        "handles\n",
        tubes, deals, stitches, steps, left_out, handles_left_out);
    std::printf("%.1f s in all runs, the slowest %.0f ms (number %u)\n", 1e-3 * milliseconds, slowest_ms,
                slowest);
  }
};

void print_run(std::uint32_t seed, std::uint32_t number, const stress::RandomRun& run,
               const stress::Outcome& outcome) {
  constexpr std::array<const char*, 3> verdicts{"sound", "stopped", "BROKEN"};
  std::printf("%s --seed %u --only %u: %s (%zu triangles, %zu tubes) %s\n    %s\n",
              verdicts.at(static_cast<std::size_t>(outcome.verdict)), seed, number,
              run.input->mesh.name.c_str(), run.input->mesh.triangles.size(), outcome.tubes,
              outcome.words.c_str(), stress::options_of(run).c_str());
}

int run(const Wish& wish) {
  const stress::Meshes meshes = read_all(wish.files);
  const std::uint32_t first = wish.only.value_or(0);
  const std::uint32_t last = wish.only ? first + 1 : wish.runs;
  Sums sums;
  for (std::uint32_t number = first; number < last; ++number) {
    const stress::RandomRun drawn = stress::random_run(wish.seed, number, meshes);
    if (!wish.write.empty()) {
      std::ofstream out(wish.write, std::ios::binary);
      knit::write_obj(out, drawn.input->mesh, "");
    }
    const stress::Outcome outcome = stress::check_run(drawn);
    sums.add(number, outcome);
    if (wish.only || outcome.verdict == stress::Verdict::broken) print_run(wish.seed, number, drawn, outcome);
    std::fflush(stdout);
  }
  sums.print();
  return sums.broken == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  Wish wish;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (const std::string error = take_word(wish, words, i); !error.empty()) return say(error);
  }
  if (wish.runs == 0 && !wish.only) return say("say how many runs, or --only and a run's number.");
  try {
    return run(wish);
  } catch (const std::exception& error) {
    return say(error.what());
  }
}
