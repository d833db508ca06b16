#include <algorithm>
#include <array>
#include <cmath>

#include "app/base/text.h"
#include "app/session/sweep.h"
#include "knit/base/number_text.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto result = knit::number_from(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

bool is_count(const knit::ParameterInfo& info) { return std::holds_alternative<knit::Count>(info.kind); }

std::string swept_keys() {
  std::string keys;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (can_be_swept(info)) keys += (keys.empty() ? "" : ", ") + std::string(info.key);
  }
  return keys;
}

std::string value_words(const knit::ParameterInfo& info, double value) {
  return is_count(info) ? knit::number_text(std::round(value)) : knit::number_text(value);
}

std::optional<std::string> fault_of_axis(const SweepAxis& axis) {
  const knit::ParameterInfo* info = knit::find_parameter(axis.key);
  if (info == nullptr)
    return "there is no parameter \"" + axis.key + "\" to sweep; give one of " + swept_keys() + ".";
  if (!can_be_swept(*info))
    return "\"" + axis.key + "\" is not a number, so it has no range to sweep; give one of " + swept_keys() +
           ".";
  if (axis.count < least_sweep_values || axis.count > most_sweep_values)
    return "a sweep of " + knit::plural(axis.count, "value", "values") + " cannot be; give from " +
           std::to_string(least_sweep_values) + " to " + std::to_string(most_sweep_values) + " of them.";
  if (!(axis.from < axis.to))
    return "a sweep of " + axis.key + " from " + knit::number_text(axis.from) + " to " +
           knit::number_text(axis.to) + " has no extent; give a lower value first and a higher one then.";
  for (const double end : {axis.from, axis.to}) {
    knit::Parameters scratch;
    if (knit::set_value(*info, scratch, value_words(*info, end)))
      return "a sweep of " + axis.key + " cannot go to " + knit::number_text(end) + "; it takes " +
             knit::range_text(*info) + ".";
  }
  return std::nullopt;
}

}  // namespace

bool can_be_swept(const knit::ParameterInfo& info) {
  return std::holds_alternative<knit::Number>(info.kind) || is_count(info);
}

double tidied(double value, int digits) {
  std::array<char, 64> text{};
  const auto end = knit::number_into(text.data(), text.data() + text.size(), value, digits).ptr;
  return number_of({text.data(), static_cast<std::size_t>(end - text.data())}).value_or(value);
}

std::variant<SweepAxis, std::string> parse_sweep_axis(const std::string& text) {
  const auto blame = [&] {
    return "--sweep cannot be \"" + text + "\"; give PARAM=FROM:TO:N, as epsilon=0.02:0.08:100.";
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return blame();
  const auto parts = split(std::string_view(text).substr(equals + 1), ':');
  if (parts.size() != 3) return blame();
  const auto from = number_of(parts[0]);
  const auto to = number_of(parts[1]);
  const auto count = whole_number<int>(parts[2]);
  if (!from || !to || !count) return blame();
  return SweepAxis{text.substr(0, equals), *from, *to, *count};
}

std::optional<std::string> fault_of(const SweepPlan& plan) {
  if (auto fault = fault_of_axis(plan.axis)) return fault;
  if (!plan.second) return std::nullopt;
  if (auto fault = fault_of_axis(*plan.second)) return fault;
  if (plan.second->key == plan.axis.key)
    return "both sweeps are of " + plan.axis.key + "; a grid needs two different parameters.";
  const auto runs = static_cast<std::size_t>(plan.axis.count) * static_cast<std::size_t>(plan.second->count);
  if (runs > most_sweep_runs)
    return "a grid of " + std::to_string(runs) + " runs is too large; give at most " +
           std::to_string(most_sweep_runs) + ".";
  return std::nullopt;
}

std::vector<double> values_of(const SweepAxis& axis) {
  const bool whole = is_count(*knit::find_parameter(axis.key));
  std::vector<double> values;
  for (int i = 0; i < axis.count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(axis.count - 1);
    double value = i + 1 == axis.count ? axis.to : tidied(axis.from + share * (axis.to - axis.from), 12);
    if (i == 0) value = axis.from;
    if (whole) value = std::round(value);
    // Also where so many values are closer than a number tells apart.
    if (values.empty() || value > values.back()) values.push_back(value);
  }
  return values;
}

SweepBase sweep_base_of(const knit::Timeline& timeline) {
  return {timeline.input_pointer(), knobs_of(timeline), timeline.parameters()};
}

knit::Parameters with_values(const knit::Parameters& current, const SweepPlan& plan,
                             const std::vector<double>& values) {
  knit::Parameters wanted = current;
  const auto set = [&](const std::string& key, double value) {
    const knit::ParameterInfo& info = *knit::find_parameter(key);
    knit::set_value(info, wanted, value_words(info, value));
  };
  set(plan.axis.key, values.at(0));
  if (plan.second) set(plan.second->key, values.at(1));
  return wanted;
}

std::variant<Knobs, std::string> swept_knobs(const SweepBase& base, const SweepPlan& plan,
                                             const std::vector<double>& values) {
  const knit::Parameters wanted = with_values(base.current, plan, values);
  if (auto fault = knit::fault_of(wanted, *base.input)) return *fault;
  return tuned(base.knobs, base.current, wanted, *base.input);
}

knit::Stage first_reader_of(const SweepPlan& plan, const Knobs& knobs) {
  const auto reader = [&](const SweepAxis& axis) {
    const knit::ParameterInfo& info = *knit::find_parameter(axis.key);
    // No stage reads it itself, but stitch sizes may follow it.
    if (info.first_reader == knit::Stage::done) return knit::Stage::tubes;
    knit::Stage first = knit::first_stage_to_read(info, knobs.base);
    for (const knit::Edit& edit : knobs.edits)
      first = std::min(first, knit::first_stage_to_read(info, edit.parameters));
    return first;
  };
  const knit::Stage first = reader(plan.axis);
  return plan.second ? std::min(first, reader(*plan.second)) : first;
}

}  // namespace app
