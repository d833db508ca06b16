#include "knit/curves/cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "knit/base/number_text.h"
#include "knit/curves/refused.h"

namespace knit {
namespace {

constexpr std::array<std::pair<CycleKind, std::string_view>, 7> kind_words{{
    {CycleKind::boundary, "boundary"},
    {CycleKind::circle, "circle"},
    {CycleKind::band, "band"},
    {CycleKind::plane, "plane"},
    {CycleKind::path, "path"},
    {CycleKind::farthest, "farthest"},
    {CycleKind::vertex, "vertex"},
}};

std::vector<std::string_view> parts_of(std::string_view text, char between) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(between);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

double cycle_number(std::string_view text, std::string_view as) {
  double value = 0.0;
  const auto [end, error] = number_from(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw CurveRefused(std::string(as) + ": \"" + std::string(text) + "\" is no number.");
  return value;
}

std::vector<double> cycle_numbers(std::string_view text, std::string_view as) {
  std::vector<double> numbers;
  for (const std::string_view part : parts_of(text, ',')) numbers.push_back(cycle_number(part, as));
  return numbers;
}

glm::dvec3 cycle_point(std::string_view text, std::string_view as) {
  const std::vector<double> numbers = cycle_numbers(text, as);
  if (numbers.size() != 3)
    throw CurveRefused(std::string(as) + ": a point has 3 numbers, \"" + std::string(text) + "\" has " +
                       std::to_string(numbers.size()) + ".");
  return {numbers[0], numbers[1], numbers[2]};
}

[[noreturn]] void refuse_form(std::string_view as, std::string_view text, std::string_view form) {
  throw CurveRefused(std::string(as) + ": \"" + std::string(text) + "\" should read " + std::string(form) +
                     ".");
}

void read_circle(Cycle& cycle, std::string_view text, std::string_view rest, std::string_view as) {
  if (rest.ends_with(",auto")) rest.remove_suffix(5);
  const std::vector<double> numbers = cycle_numbers(rest, as);
  if (numbers.size() != 3 && numbers.size() != 4)
    refuse_form(as, text, "circle:X,Y,Z,R, a point and a radius");
  cycle.points.emplace_back(numbers[0], numbers[1], numbers[2]);
  if (numbers.size() == 4) cycle.radius = numbers[3];
}

void read_points(Cycle& cycle, std::string_view text, std::string_view rest, std::string_view as) {
  std::vector<std::string_view> parts = parts_of(rest, ';');
  if (cycle.kind == CycleKind::band) {
    if (parts.size() < 2) refuse_form(as, text, "band:R;X,Y,Z;..., a radius and points");
    cycle.radius = cycle_number(parts.front(), as);
    parts.erase(parts.begin());
  }
  if (cycle.kind == CycleKind::plane && parts.size() == 1) {
    const std::vector<double> numbers = cycle_numbers(rest, as);
    if (numbers.size() != 6) refuse_form(as, text, "plane:X,Y,Z,NX,NY,NZ, a point and a normal, or 3 points");
    cycle.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    cycle.normal = glm::dvec3(numbers[3], numbers[4], numbers[5]);
    return;
  }
  for (const std::string_view part : parts) cycle.points.push_back(cycle_point(part, as));
  if (cycle.kind == CycleKind::plane && cycle.points.size() != 3)
    refuse_form(as, text, "plane:X,Y,Z;X,Y,Z;X,Y,Z, 3 points, or a point and a normal");
}

Cycle read_cycle(std::string_view text, CycleEnd end) {
  const std::string_view as = word_of(end);
  Cycle cycle{.as = end};
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  if (digits) {
    cycle.kind = CycleKind::vertex;
    const auto [last, error] = number_from(text.data(), text.data() + text.size(), cycle.vertex);
    if (error != std::errc{} || cycle.vertex == no_vertex)
      throw CurveRefused(std::string(as) + ": no mesh has a vertex " + std::string(text) + ".");
    return cycle;
  }
  const std::size_t colon = text.find(':');
  const std::string_view word = text.substr(0, colon);
  const std::optional<CycleKind> kind = cycle_kind(word);
  if (!kind || *kind == CycleKind::vertex)
    throw CurveRefused(std::string(as) + ": \"" + std::string(word) +
                       "\" is no kind of curve. There are boundary, circle, band, plane, path and farthest, "
                       "or the number of a vertex.");
  cycle.kind = *kind;
  if (colon == std::string_view::npos) {
    if (cycle.kind != CycleKind::boundary && cycle.kind != CycleKind::farthest)
      throw CurveRefused(std::string(as) + ": " + std::string(word) + " needs points, as in " +
                         std::string(word) + ":X,Y,Z.");
    return cycle;
  }
  const std::string_view rest = text.substr(colon + 1);
  switch (cycle.kind) {
    case CycleKind::farthest:
      throw CurveRefused(std::string(as) + ": farthest takes no points.");
    case CycleKind::boundary:
      cycle.points.push_back(cycle_point(rest, as));
      break;
    case CycleKind::circle:
      read_circle(cycle, text, rest, as);
      break;
    default:
      read_points(cycle, text, rest, as);
  }
  return cycle;
}

std::string digits_of(double value, int digits) {
  std::array<char, 40> text{};
  char* const last = text.data() + text.size();
  const auto end =
      digits == 0 ? number_into(text.data(), last, value) : number_into(text.data(), last, value, digits);
  return {text.data(), end.ptr};
}

std::string comma_text(const glm::dvec3& at) {
  return digits_of(at.x, 0) + "," + digits_of(at.y, 0) + "," + digits_of(at.z, 0);
}

}  // namespace

std::string three_digits(double value) { return digits_of(value, 3); }

std::string place_text(const glm::dvec3& at) {
  return "(" + three_digits(at.x) + ", " + three_digits(at.y) + ", " + three_digits(at.z) + ")";
}

std::string_view word_of(CycleEnd as) { return as == CycleEnd::start ? "start" : "end"; }

std::string_view word_of(CycleKind kind) {
  for (const auto& [one, word] : kind_words)
    if (one == kind) return word;
  return {};
}

std::optional<CycleKind> cycle_kind(std::string_view word) {
  for (const auto& [kind, one] : kind_words)
    if (one == word) return kind;
  return std::nullopt;
}

std::string called(const Cycle& cycle) {
  return cycle.name.empty() ? std::string(word_of(cycle.as)) : cycle.name;
}

double time_of(const Cycle& cycle) { return cycle.value.value_or(cycle.as == CycleEnd::start ? 0.0 : 1.0); }

std::variant<Cycle, std::string> parse_cycle(std::string_view text, CycleEnd as) {
  try {
    return read_cycle(text, as);
  } catch (const CurveRefused& refused) {
    return std::string(refused.what());
  }
}

std::string cycle_text(const Cycle& cycle) {
  if (cycle.kind == CycleKind::vertex) return std::to_string(cycle.vertex);
  std::string text{word_of(cycle.kind)};
  if (cycle.kind == CycleKind::band) text += ":" + digits_of(cycle.radius.value_or(0.0), 0);
  char between = cycle.kind == CycleKind::band ? ';' : ':';
  for (const glm::dvec3& point : cycle.points) {
    text += between + comma_text(point);
    between = ';';
  }
  if (cycle.kind == CycleKind::circle && cycle.radius) text += "," + digits_of(*cycle.radius, 0);
  if (cycle.kind == CycleKind::plane && cycle.normal) text += "," + comma_text(*cycle.normal);
  return text;
}

}  // namespace knit
