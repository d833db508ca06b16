#include "app/script/opening_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "app/base/text.h"
#include "app/curves/curves_file.h"
#include "app/script/pieces.h"
#include "knit/curves/cycle.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

std::string repair_list() {
  std::string text;
  for (const std::string_view key : knit::repair_keys) text += (text.empty() ? "" : ", ") + std::string(key);
  return text;
}

// Commas between; the order does not matter, for there is but one that is safe.
std::optional<std::string> read_repairs(const OpeningWords& words, CommandLine& line) {
  if (words.repair.empty()) return std::nullopt;
  if (words.mesh.empty() || !line.session.empty())
    return "--repair needs a mesh's file; examples are whole, and a session has its own repairs.";
  knit::RepairWish wish{words.repair == "all", {}};
  for (const std::string_view key : wish.all ? std::vector<std::string_view>() : split(words.repair, ',')) {
    const auto kind = knit::repair_named(key);
    if (!kind)
      return "--repair cannot be \"" + words.repair + "\"; give all, or some of " + repair_list() +
             ", with commas between.";
    if (std::find(wish.kinds.begin(), wish.kinds.end(), *kind) == wish.kinds.end())
      wish.kinds.push_back(*kind);
  }
  line.open = OpenFile{words.mesh, std::move(wish)};
  return std::nullopt;
}

// After the repairs: the piece is one of them, and goes before the largest.
std::optional<std::string> read_piece(const OpeningWords& words, bool headless, CommandLine& line) {
  if (words.piece.empty()) return std::nullopt;
  if (words.mesh.empty() || !line.session.empty())
    return "--piece needs a mesh's file; examples are of one piece, and a session has its own.";
  if (words.piece == "all") {
    if (!headless) return "--piece all knits one piece after the other, which needs --headless.";
    line.every_piece = true;
    return std::nullopt;
  }
  const auto number = whole_number<std::int32_t>(words.piece);
  if (!number || *number < 1 || static_cast<std::size_t>(*number) > knit::most_pieces)
    return "--piece cannot be \"" + words.piece + "\"; give a number from 1, or all.";
  line.open = of_piece(line.open.get<OpenFile>(), static_cast<std::size_t>(*number));
  return std::nullopt;
}

// A kind of curve by its word, alone or before a colon; what is none is a vertex, or a mistake that the table speaks of.
bool is_curve(std::string_view text) {
  const std::size_t colon = text.find(':');
  return colon != std::string_view::npos || knit::cycle_kind(text).has_value();
}

std::string& setting_of(std::vector<std::string>& settings, std::string_view key) {
  const auto table = knit::parameter_table();
  const auto info = std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.key == key; });
  return settings.at(static_cast<std::size_t>(info - table.begin()));
}

}  // namespace

void declare_opening_words(CLI::App& app, OpeningWords& words) {
  app.add_option("--repair,--mend", words.repair,
                 "repair the mesh before it is opened: all, or some of " + repair_list());
  app.add_option(
      "--piece", words.piece,
      "of a mesh in several pieces open this one: 1 is that of most triangles; all: each by itself, with "
      "--headless");
  app.add_option(
      "--curves", words.curves,
      "cut the mesh along the curves of a file, where knitting begins and ends; --start and --end take a "
      "curve too, as in --start circle:X,Y,Z,R");
  app.add_option("--curves-scale", words.curves_scale,
                 "auto: make the file's curves fit a mesh that was scaled since they were drawn");
}

std::optional<std::string> read_curve_words(const OpeningWords& words, std::vector<std::string>& settings,
                                            CommandLine& line) {
  line.curves.file = words.curves;
  line.curves.scale = !words.curves_scale.empty();
  if (line.curves.scale && words.curves_scale != "auto")
    return "--curves-scale cannot be \"" + words.curves_scale + "\"; give auto, or leave it out.";
  if (line.curves.scale && words.curves.empty())
    return "--curves-scale is of a file of curves; give --curves too.";
  std::string& start = setting_of(settings, knit::keys::start);
  std::string& end = setting_of(settings, "end");
  if (!is_curve(start) && !is_curve(end)) return std::nullopt;
  for (const auto& [text, as] :
       {std::pair{&start, knit::CycleEnd::start}, std::pair{&end, knit::CycleEnd::end}}) {
    const std::string given = std::exchange(*text, "");
    if (given.empty() || given == "auto") continue;
    auto curve = knit::parse_cycle(given, as);
    if (const auto* fault = std::get_if<std::string>(&curve)) return "--" + *fault;
    line.curves.curves.push_back(std::get<knit::Cycle>(std::move(curve)));
  }
  return std::nullopt;
}

std::optional<std::string> read_opening_words(const OpeningWords& words, bool headless, CommandLine& line) {
  if (auto trouble = read_repairs(words, line)) return trouble;
  if (auto trouble = read_piece(words, headless, line)) return trouble;
  const auto* file = line.open.get_if<OpenFile>();
  if (file == nullptr || !line.session.empty()) return std::nullopt;
  OpenFile with_curves = *file;
  with_curves.curves = std::exchange(line.curves, {});
  line.open = std::move(with_curves);
  return std::nullopt;
}

}  // namespace app
