#include "app/core/check_command.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

#include "knit/pattern_reader.h"

namespace app {

namespace {

std::string counted(std::size_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string summary_of(const knit::ReadPattern& read) {
  const auto cast_on = static_cast<std::size_t>(read.rounds.cast_on);
  return counted(read.rounds_read, "round", "rounds") + " read, " + counted(cast_on, "stitch", "stitches") +
         " cast on, " + counted(static_cast<std::size_t>(read.stitches), "stitch", "stitches") + " in all: " +
         (read.mistakes.empty() ? "every count holds."
                                : counted(read.mistakes.size(), "mistake.", "mistakes."));
}

Answer cannot_read(const std::string& name, const std::string& why) {
  return {exit_usage, "", "check: cannot read " + name + ": " + why + "."};
}

}  // namespace

Answer check_text(std::string_view text, const std::string& name) {
  const knit::ReadPattern read = knit::read_pattern(text);
  if (read.rounds_read == 0 && read.mistakes.empty()) {
    return {exit_usage, "",
            "check: " + name +
                " holds no pattern; rounds begin like \"Rnd 7:\", after a cast on like \"CO 6 sts\"."};
  }
  std::string out;
  for (const knit::PatternMistake& mistake : read.mistakes) out += mistake.sentence + "\n";
  return {read.mistakes.empty() ? exit_done : 1, out + summary_of(read) + "\n", ""};
}

Answer check_file(const std::filesystem::path& path) {
  if (path == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    return std::cin.bad() ? cannot_read("standard input", "it broke off")
                          : check_text(text, "standard input");
  }
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return cannot_read(path.string(), "it does not exist");
  if (std::filesystem::is_directory(path, ignored)) return cannot_read(path.string(), "it is a folder");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad())
    return cannot_read(path.string(), errno != 0 ? std::strerror(errno) : "it could not be read whole");
  return check_text(text, path.string());
}

}  // namespace app
