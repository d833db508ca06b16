#include "app/actions/parameters_text.h"

#include <set>

#include "app/base/text.h"
#include "knit/import/quoting.h"

namespace app {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\f\v";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

// Somebody else's text may be anything and of any length.
std::string quoted(std::string_view text) { return "\"" + knit::printable_start(text, 40) + "\""; }

// Reads line by line; nothing is set before all lines are right.
struct Reading {
  knit::Parameters parameters;
  std::set<std::string_view> seen;
  std::vector<knit::Setting> settings;

  std::optional<std::string> fault_in(std::string_view line) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return std::nullopt;
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos)
      return quoted(line) + " is not \"key = value\"; give one parameter a line.";
    const std::string_view key = trimmed(line.substr(0, equals));
    const std::string_view value = trimmed(line.substr(equals + 1));
    const knit::ParameterInfo* info = knit::find_parameter(key);
    if (info == nullptr)
      return "there is no parameter " + quoted(key) +
             "; remove the line, or see knit-mesh --list-parameters.";
    if (!seen.insert(info->key).second)
      return std::string(info->key) + " is given a second time; keep one of the two lines.";
    if (knit::Parameters scratch; knit::set_value(*info, scratch, value)) {
      return std::string(info->key) + " cannot be " + quoted(value) + "; give " + knit::range_text(*info) +
             ".";
    }
    settings.emplace_back(info, value);
    return std::nullopt;
  }

  // Sizes of one view alone make that view the given one; of both, only `sizes` can say which counts.
  std::optional<std::string> fault_at_end() {
    if (knit::clash_of_views(settings))
      return "the gauge and a stitch size are both given; add a line \"sizes = mesh\" or \"sizes = gauge\".";
    knit::set_values(settings, parameters);
    return std::nullopt;
  }
};

}  // namespace

std::string parameters_text(const knit::Parameters& parameters) {
  std::string text;
  for (const knit::ParameterInfo& info : knit::parameter_table())
    text += std::string(info.key) + " = " + knit::value_text(info, parameters) + "\n";
  return text;
}

std::variant<knit::Parameters, std::string> read_parameters_text(std::string_view text,
                                                                 const knit::Parameters& base) {
  Reading reading{base, {}, {}};
  std::size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    if (const auto fault = reading.fault_in(line)) return "line " + std::to_string(number) + ": " + *fault;
  }
  if (reading.seen.empty()) return std::string("no parameter is in it; give \"key = value\", one a line.");
  if (const auto fault = reading.fault_at_end()) return "line " + std::to_string(number) + ": " + *fault;
  return reading.parameters;
}

}  // namespace app
