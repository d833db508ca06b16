#include "app/script/subcommands.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "app/base/text.h"
#include "app/reader/pattern_json_reader.h"
#include "knit/model/words.h"
#include "knit/reader/checked_pattern.h"
#include "knit/reader/pattern_reader.h"
#include "knit/stitches/appendix.h"
#include "knit/stitches/placement.h"

namespace app {

namespace {

std::string counted(std::size_t number, std::string_view one, std::string_view many) {
  return knit::plural(static_cast<std::int64_t>(number), one, many);
}

std::string summary_of(const knit::ReadPattern& read) {
  const auto cast_on = static_cast<std::size_t>(read.rounds.cast_on);
  return counted(read.rounds_read, "round", "rounds") + " read, " + counted(cast_on, "stitch", "stitches") +
         " cast on, " + counted(static_cast<std::size_t>(read.stitches), "stitch", "stitches") + " in all: " +
         (read.mistakes.empty() ? "every count holds."
                                : counted(read.mistakes.size(), "mistake.", "mistakes."));
}

std::string whole_verdict(knit::PatternVerdict verdict) {
  switch (verdict) {
    case knit::PatternVerdict::holds:
      return "every count holds";
    case knit::PatternVerdict::does_not_add_up:
      return "it does not add up";
    case knit::PatternVerdict::not_understood:
      return "not understood";
  }
  return {};
}

std::string_view name_of(knit::PatternVerdict verdict) {
  constexpr std::array<std::string_view, 3> names{"holds", "does not add up", "not understood"};
  return names[static_cast<std::size_t>(verdict)];
}
std::string_view name_of(knit::LineVerdict verdict) {
  constexpr std::array<std::string_view, 5> names{"holds", "does not add up", "not understood", "not claimed",
                                                  "no instruction"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string summary_of(const knit::CheckedPattern& checked) {
  return counted(checked.rounds, "round", "rounds") + "; " + counted(checked.worked, "line", "lines") +
         " worked, " + std::to_string(checked.not_understood) + " not understood, " +
         std::to_string(checked.no_instructions) +
         " without instructions: " + whole_verdict(checked.verdict) + ".";
}

nlohmann::json json_of(const knit::CheckedSize& size) {
  nlohmann::json lines = nlohmann::json::array(), pieces = nlohmann::json::array();
  for (const knit::CheckedLine& line : size.lines) {
    nlohmann::json one{{"line", line.number}, {"verdict", name_of(line.verdict)}};
    if (line.stitches) one["stitches"] = *line.stitches;
    if (!line.sentence.empty()) one["sentence"] = line.sentence;
    if (line.word_length > 0) one["at"] = line.word_at, one["length"] = line.word_length;
    lines.push_back(std::move(one));
  }
  for (const knit::CheckedPiece& piece : size.pieces) {
    nlohmann::json rounds = nlohmann::json::array();
    for (const knit::CheckedRound& round : piece.rounds)
      rounds.push_back({{"line", round.line}, {"stitches", round.stitches}});
    pieces.push_back(
        {{"name", piece.name}, {"made", piece.made}, {"flat", piece.flat}, {"rounds", std::move(rounds)}});
  }
  return {{"name", size.name},
          {"verdict", name_of(size.verdict)},
          {"lines", std::move(lines)},
          {"pieces", std::move(pieces)}};
}

std::string json_text(const knit::CheckedPattern& checked) {
  nlohmann::json sizes = nlohmann::json::array();
  for (const knit::CheckedSize& size : checked.sizes) sizes.push_back(json_of(size));
  const nlohmann::json all{{"verdict", name_of(checked.verdict)},
                           {"worked", checked.worked},
                           {"not_understood", checked.not_understood},
                           {"no_instructions", checked.no_instructions},
                           {"rounds", checked.rounds},
                           {"remark", checked.remark},
                           {"sizes", std::move(sizes)}};
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

int exit_of(knit::PatternVerdict verdict) {
  if (verdict == knit::PatternVerdict::holds) return exit_done;
  return verdict == knit::PatternVerdict::does_not_add_up ? 1 : exit_not_understood;
}

Answer cannot_read(const std::string& name, const std::string& why) {
  return {exit_usage, "", "check: cannot read " + name + ": " + why + "."};
}

// Of this program's JSON, in the same shape: mistakes have places, which their sentences tell, and no lines.
std::string json_text(const knit::ReadPattern& read, std::string_view verdict) {
  nlohmann::json lines = nlohmann::json::array();
  for (const knit::PatternMistake& mistake : read.mistakes)
    lines.push_back({{"verdict", verdict}, {"sentence", mistake.sentence}});
  nlohmann::json size{
      {"name", ""}, {"verdict", verdict}, {"lines", std::move(lines)}, {"pieces", nlohmann::json::array()}};
  const nlohmann::json all{{"verdict", verdict},
                           {"worked", read.rounds_read},
                           {"not_understood", 0},
                           {"no_instructions", 0},
                           {"rounds", read.rounds_read},
                           {"remark", ""},
                           {"sizes", nlohmann::json::array({std::move(size)})}};
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Answer json_answer(const knit::ReadPattern& read, CheckForm form) {
  const auto verdict =
      read.mistakes.empty() ? knit::PatternVerdict::holds : knit::PatternVerdict::does_not_add_up;
  if (form == CheckForm::json) return {exit_of(verdict), json_text(read, name_of(verdict)), ""};
  std::string out;
  for (const knit::PatternMistake& mistake : read.mistakes) out += mistake.sentence + "\n";
  return {exit_of(verdict), out + summary_of(read) + "\n", ""};
}

}  // namespace

Answer check_text(std::string_view text, const std::string& name, CheckForm form) {
  if (begins_like_json(text)) {
    JsonPattern json = read_pattern_json(text);
    if (const auto* why = std::get_if<NoPattern>(&json))
      return {exit_usage, "", "check: " + name + " cannot be read: " + *why};
    auto* limbs = std::get_if<knit::ReadLimbs>(&json);
    const knit::ReadPattern read =
        limbs != nullptr ? knit::as_pattern(std::move(*limbs)) : std::get<knit::ReadPattern>(std::move(json));
    if (read.rounds_read > 0 || !read.mistakes.empty()) return json_answer(read, form);
  }
  const knit::CheckedPattern checked = knit::check_pattern(text);
  if (!checked.is_pattern) {
    return {exit_usage, "",
            "check: " + name +
                " holds no pattern; rounds begin like \"Rnd 7:\", after a cast on like \"CO 6 sts\"."};
  }
  if (form == CheckForm::json) return {exit_of(checked.verdict), json_text(checked), ""};
  std::string out;
  const bool many = checked.sizes.size() > 1;
  for (const knit::CheckedSize& size : checked.sizes) {
    if (many) out += "size " + size.name + ": " + whole_verdict(size.verdict) + ".\n";
    for (const knit::CheckedLine& line : size.lines) {
      if (!line.sentence.empty()) out += line.sentence + "\n";
    }
  }
  if (!checked.remark.empty()) out += checked.remark + "\n";
  return {exit_of(checked.verdict), out + summary_of(checked) + "\n", ""};
}

Answer check_file(const std::filesystem::path& path, CheckForm form) {
  if (path == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    return std::cin.bad() ? cannot_read("standard input", "it broke off")
                          : check_text(text, "standard input", form);
  }
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return cannot_read(path.string(), "it does not exist");
  if (std::filesystem::is_directory(path, ignored)) return cannot_read(path.string(), "it is a folder");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad())
    return cannot_read(path.string(), errno != 0 ? std::strerror(errno) : "it could not be read whole");
  return check_text(text, path.string(), form);
}

std::string placements_of_index() {
  std::vector<std::string_view> names;
  for (const knit::Placement& placement : knit::placements()) {
    if (!placement.by_place)
      names.push_back(knit::placement_names[static_cast<std::size_t>(placement.policy)]);
  }
  return one_of(names);
}

Answer index_answer(const std::string& sizes_text, const std::string& placement) {
  std::vector<std::int32_t> sizes;
  for (const std::string_view part : split(sizes_text, ',')) {
    const auto size = whole_number<std::int32_t>(part);
    if (!size || *size < 1 || *size > 100000) {
      return bad_usage("index: \"" + std::string(part) +
                       "\" is not a row size; give whole numbers from 1 to 100000, like 6,12,17.");
    }
    sizes.push_back(*size);
  }
  const auto name = std::find(knit::placement_names.begin(), knit::placement_names.end(), placement);
  const std::string may = placements_of_index();
  if (name == knit::placement_names.end() || name + 1 == knit::placement_names.end())
    return bad_usage("index: --placement cannot be \"" + placement + "\"; give " + may + ".");
  const auto policy = static_cast<knit::PlacementPolicy>(name - knit::placement_names.begin());
  if (knit::placement_of(policy).by_place) {
    return bad_usage("index: --placement " + placement +
                     " needs to know where stitches stand, and a list of sizes does not say; give " + may +
                     ".");
  }
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    if (sizes[i] <= 2 * sizes[i - 1] && 2 * sizes[i] >= sizes[i - 1]) continue;
    return bad_usage("index: row " + std::to_string(i + 1) + " cannot have " +
                     knit::stitch_count_text(sizes[i]) + " after " + std::to_string(sizes[i - 1]) +
                     "; a row may at most double or halve.");
  }
  const std::vector<knit::Join> joins = knit::plan_joins(sizes, policy);
  std::vector<const knit::Join*> view;
  view.reserve(joins.size());
  for (const knit::Join& join : joins) view.push_back(&join);
  std::string text;
  for (const knit::LabelRow& row : knit::appendix_view(sizes.front(), view))
    text += knit::text_of(row) + "\n";
  return {exit_done, text, ""};
}

}  // namespace app
