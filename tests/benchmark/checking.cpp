#include "tests/benchmark/checking.h"

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "app/checker/checker.h"
#include "app/session/action.h"
#include "app/session/view.h"
#include "knit/reader/checked_pattern.h"
#include "tests/benchmark/ball_file.h"
#include "tests/benchmark/cost.h"
#include "tests/benchmark/desk.h"
#include "tests/benchmark/pipeline.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t megabyte = 1'000'000;

// "80 (88, 96)"
std::string sizes_text(int first, int step, int sizes) {
  std::string text = std::to_string(first);
  for (int i = 1; i < sizes; ++i)
    text += (i == 1 ? " (" : ", ") + std::to_string(first + i * step) + (i + 1 == sizes ? ")" : "");
  return text;
}

// Rounds that go up and down again; until `bytes` or `lines` are reached. With sizes, counts are told now and then.
std::string pattern_text(std::size_t bytes, std::size_t lines, int sizes) {
  constexpr std::array<const char*, 5> rounds{"*K6, k2tog; rep from * to end.", "Knit.",
                                              "*K7, m1; rep from * to end.", "K2tog, k to last 2 sts, ssk.",
                                              "M1, k to end, m1."};
  std::string text = "CO " + sizes_text(80, 8, sizes) + " sts.\n";
  for (std::size_t i = 0; text.size() < bytes && i < lines; ++i) {
    text += "Rnd " + std::to_string(i + 1) + ": " + rounds.at(i % rounds.size());
    if (i % 50 == 0) text += " (" + sizes_text(70, 7, sizes) + " sts)";
    text += "\n";
  }
  return text;
}

std::string mesh_text(std::size_t bytes) {
  std::ostringstream out;
  knit::write_obj(out, ball(25'000), "");
  std::string text = out.str();
  // Faces come last, so what is cut off leaves all positions that the others name.
  if (text.size() > bytes) text.resize(text.rfind('\n', bytes) + 1);
  return text;
}

double checking_ms(const std::string& text) {
  return cost_of([&] { knit::check_pattern(text); }).thread_ms;
}

// A letter goes in and out again in the midst of the text, each as the window does it: the whole text is checked anew.
Json measure_key(const std::filesystem::path& assets) {
  constexpr std::size_t lines = 1000;
  Desk desk(assets);
  const std::string text = pattern_text(megabyte, lines, 1);
  std::string typed = text;
  typed.insert(text.find('\n', text.size() / 2), " x");
  desk.act(app::SetCheckedText{text, true});
  for (int i = 0; i < 3; ++i) desk.frame();
  std::vector<Cost> still, keys;
  for (int i = 0; i < 101; ++i) {
    still.push_back(cost_of([&] { desk.frame(); }));
    keys.push_back(cost_of([&] {
      desk.act(app::SetCheckedText{i % 2 == 0 ? typed : text, false});
      desk.frame();
    }));
  }
  const double still_ms = median_of(still, &Cost::thread_ms);
  return {{"lines", lines},
          {"bytes", text.size()},
          {"still_ms", still_ms},
          {"key_ms", summary_of(keys, &Cost::thread_ms)},
          {"key_over_still", median_of(keys, &Cost::thread_ms) / still_ms}};
}

}  // namespace

Json measure_checking(const std::filesystem::path& assets) {
  constexpr int sizes = 40;
  const std::string one = pattern_text(megabyte, megabyte, 1),
                    sized = pattern_text(megabyte, megabyte, sizes);
  const std::string mesh = mesh_text(megabyte);
  std::vector<double> check, check_sizes, parse, over_parse, over_one;
  for (int i = 0; i < 5; ++i) {
    parse.push_back(parse_once(mesh));
    check.push_back(checking_ms(one));
    check_sizes.push_back(checking_ms(sized));
    over_parse.push_back(check.back() / parse.back());
    over_one.push_back(check_sizes.back() / check.back());
  }
  return {{"bytes", one.size()},
          {"check_ms", quantile(check, 0.5)},
          {"over_parse", quantile(over_parse, 0.5)},
          {"sizes", sizes},
          {"sizes_ms", quantile(check_sizes, 0.5)},
          {"sizes_over_one", quantile(over_one, 0.5)},
          {"key", measure_key(assets)}};
}

}  // namespace benchmark
