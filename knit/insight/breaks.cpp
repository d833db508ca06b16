#include "knit/insight/breaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "knit/base/number_text.h"
#include "knit/model/words.h"

namespace knit {

namespace {

// How a kind is written: its word, what stands after it, and what follows.
struct Form {
  BreakKind kind;
  std::string_view word;
  char sign;  // 0: the word alone
};
constexpr std::array forms{
    Form{BreakKind::stage, "stage", '='},     Form{BreakKind::row, "row", '='},
    Form{BreakKind::label, "label", '='},     Form{BreakKind::grows, "grows", '>'},
    Form{BreakKind::shrinks, "shrinks", '>'}, Form{BreakKind::gap, "gap", '\0'},
    Form{BreakKind::stall, "stall", '\0'},    Form{BreakKind::over_double, "over-double", '\0'},
    Form{BreakKind::wider, "wider", '>'},     Form{BreakKind::narrower, "narrower", '<'},
    Form{BreakKind::split, "split", '\0'},    Form{BreakKind::join, "join", '\0'},
    Form{BreakKind::hold, "hold", '\0'}};
constexpr std::string_view all_forms =
    "stage=rows, row=14, label=m1l, grows>4, shrinks>4, gap, stall, over-double, wider>1.3, narrower<0.7, "
    "split, join or hold";

struct NamedLabel {
  Label label;
  std::string_view name;
};
// Those that a step of their own gives to a stitch.
constexpr std::array labels{NamedLabel{Label::m1r, "m1r"},       NamedLabel{Label::m1l, "m1l"},
                            NamedLabel{Label::k2tog, "k2tog"},   NamedLabel{Label::ssk, "ssk"},
                            NamedLabel{Label::cast, "cast"},     NamedLabel{Label::main, "main"},
                            NamedLabel{Label::turn_left, "turn"}};

const Form& form_of(BreakKind kind) {
  return *std::find_if(forms.begin(), forms.end(), [&](const Form& form) { return form.kind == kind; });
}

// Lower case, without blanks.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
    result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto result = number_from(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

using Parsed = std::variant<BreakCondition, std::string>;

std::string cannot_be(const Form& form, std::string_view value, const std::string& give) {
  return "the break condition " + std::string(form.word) + form.sign + " cannot have \"" +
         std::string(value) + "\"; give " + give + ".";
}

Parsed with_stage(const Form& form, std::string_view value) {
  BreakCondition condition{.kind = form.kind};
  const auto stage = stage_named(value);
  const bool has_steps =
      stage && std::find(machine_stages.begin(), machine_stages.end(), *stage) != machine_stages.end();
  if (!has_steps) return cannot_be(form, value, "timing, tubes, cast-on, rows, stitches, faces or pattern");
  condition.stage = *stage;
  return condition;
}

Parsed with_label(const Form& form, std::string_view value) {
  BreakCondition condition{.kind = form.kind};
  for (const NamedLabel& label : labels) {
    if (label.name != value) continue;
    condition.label = label.label;
    return condition;
  }
  return cannot_be(form, value, "m1r, m1l, k2tog, ssk, main or cast");
}

Parsed with_count(const Form& form, std::string_view value) {
  BreakCondition condition{.kind = form.kind};
  const std::int32_t lowest = form.kind == BreakKind::row ? 1 : 0;
  const auto count = number_in<std::int32_t>(value);
  if (!count || *count < lowest)
    return cannot_be(form, value, "a whole number from " + std::to_string(lowest));
  condition.count = *count;
  return condition;
}

Parsed with_bound(const Form& form, std::string_view value) {
  BreakCondition condition{.kind = form.kind};
  const auto bound = number_in<double>(value);
  if (!bound || !std::isfinite(*bound) || *bound <= 0.0)
    return cannot_be(form, value, "how many stitch widths, above 0");
  condition.bound = *bound;
  return condition;
}

Parsed with_value(const Form& form, std::string_view value) {
  switch (form.kind) {
    case BreakKind::stage:
      return with_stage(form, value);
    case BreakKind::label:
      return with_label(form, value);
    case BreakKind::wider:
    case BreakKind::narrower:
      return with_bound(form, value);
    default:
      return with_count(form, value);
  }
}

// The label that a step gives to a stitch. `casts_on`: the row in the making is worked on none.
std::optional<Label> label_given(const Step& step, bool casts_on) {
  if (const auto* shaping = get_if<ShapingPlaced>(step)) return shaping->label;
  if (is<MainPlaced>(step)) return Label::main;
  if (is<ShortRowWorked>(step)) return Label::turn_left;
  if (const auto* turn = get_if<TurnPlaced>(step))
    return turn->label == Label::marked ? Label::marked : Label::turn_left;
  const bool cast = is<StitchCastOn>(step) || is<BridgeCastOn>(step) || (is<StitchPlaced>(step) && casts_on);
  return cast ? std::optional(Label::cast) : std::nullopt;
}

// Most steps of a run are of a kind at which only the beginning of a row or stage can be a hit.
bool is_common(const Step& step) {
  return is<CandidateMeasured>(step) || is<VertexTimed>(step) || is<FaceMade>(step);
}

bool wants_over_double(const Step& step) {
  if (const auto* resampled = get_if<RowResampled>(step))
    return resampled->reason == ResampleReason::more_than_double;
  const auto* chosen = get_if<CountChosen>(step);
  return chosen != nullptr && chosen->reason == CountReason::at_most_double;
}

// Of a finished row, in stitch widths.
struct Widths {
  double low = no_limit, high = 0.0;
};

Widths widths_of(const Row& row, double stitch_width) {
  Widths widths;
  for (const auto& [from, to] : edges_of(row)) {
    const double width = glm::distance(row.stitches[from].position, row.stitches[to].position) / stitch_width;
    widths = {std::min(widths.low, width), std::max(widths.high, width)};
  }
  return widths;
}

// What a condition may ask of a step beside the step itself.
struct Sight {
  bool begins_stage = false, begins_row = false, casts_on = false, begins_to_wait = false;
  std::int32_t growth = 0;  // of the row that the step finishes
  Widths widths;            // its own; as here where no condition asks for them
};

bool holds(const BreakCondition& condition, const Step& step, const Sight& sight) {
  const auto* closed = get_if<RowClosed>(step);
  const auto* gaps = get_if<GapsFound>(step);
  switch (condition.kind) {
    case BreakKind::stage:
      return sight.begins_stage && step.place.stage == condition.stage;
    case BreakKind::row:
      return sight.begins_row && step.place.row == condition.count;
    case BreakKind::label:
      return label_given(step, sight.casts_on) == condition.label;
    case BreakKind::grows:
      return sight.growth > condition.count;
    case BreakKind::shrinks:
      return -sight.growth > condition.count;
    case BreakKind::gap:
      return closed != nullptr && !closed->in_band;
    case BreakKind::stall:
      return is<BandMissed>(step);
    case BreakKind::over_double:
      return wants_over_double(step);
    case BreakKind::wider:
      return sight.widths.high > condition.bound;
    case BreakKind::narrower:
      return sight.widths.low < condition.bound;
    case BreakKind::split:
      return gaps != nullptr && gaps->deal == DealKind::split;
    case BreakKind::join:
      return gaps != nullptr && gaps->deal == DealKind::join;
    case BreakKind::hold:
      return sight.begins_to_wait;
  }
  return false;
}

}  // namespace

std::variant<BreakCondition, std::string> parse_break(std::string_view text) {
  const std::string given = plain(text);
  for (const Form& form : forms) {
    if (given.rfind(form.word, 0) != 0) continue;
    const std::string_view rest = std::string_view(given).substr(form.word.size());
    if (form.sign == '\0' && rest.empty()) return BreakCondition{.kind = form.kind};
    if (form.sign != '\0' && !rest.empty() && rest.front() == form.sign)
      return with_value(form, rest.substr(1));
  }
  return "\"" + std::string(text) + "\" is no break condition; give " + std::string(all_forms) + ".";
}

std::string text_of(const BreakCondition& condition) {
  const Form& form = form_of(condition.kind);
  std::string text(form.word);
  if (form.sign == '\0') return text;
  text += form.sign;
  switch (condition.kind) {
    case BreakKind::stage:
      return text + std::string(name_of(condition.stage));
    case BreakKind::label:
      for (const NamedLabel& label : labels) {
        if (label.label == condition.label) text += label.name;
      }
      return text;
    case BreakKind::wider:
    case BreakKind::narrower:
      return text + number_text(condition.bound);
    default:
      return text + std::to_string(condition.count);
  }
}

std::string words_of(const BreakCondition& condition) {
  const std::string count = std::to_string(condition.count);
  const std::string by = " by more than " + count + (condition.count == 1 ? " stitch" : " stitches");
  const std::string widths = number_text(condition.bound) + (condition.bound == 1.0 ? " width" : " widths");
  switch (condition.kind) {
    case BreakKind::stage:
      return "the stage " + std::string(name_of(condition.stage)) + " begins";
    case BreakKind::row:
      return "row " + count + " begins";
    case BreakKind::label:
      return "a stitch becomes " + std::string(name_of(condition.label));
    case BreakKind::grows:
      return "a row grows" + by;
    case BreakKind::shrinks:
      return "a row shrinks" + by;
    case BreakKind::gap:
      return "a row closes outside the band";
    case BreakKind::stall:
      return "nothing lies in the band";
    case BreakKind::over_double:
      return "a row would more than double";
    case BreakKind::wider:
      return "a stitch wider than " + widths;
    case BreakKind::narrower:
      return "a stitch narrower than " + widths;
    case BreakKind::split:
      return "a loop is cut in two";
    case BreakKind::join:
      return "two loops become one";
    case BreakKind::hold:
      return "a loop begins to wait on a holder";
  }
  return {};
}

std::optional<std::int32_t> finished_row_size(const Step& step) {
  if (const auto* shared = get_if<GapShared>(step)) return shared->stitches;
  if (const auto* placed = get_if<StitchPlaced>(step); placed != nullptr)
    return placed->stitch == placed->of ? std::optional(placed->of) : std::nullopt;
  if (const auto* cast = get_if<StitchCastOn>(step); cast != nullptr)
    return cast->stitch == cast->of ? std::optional(cast->of) : std::nullopt;
  return std::nullopt;
}

BreakScanner::BreakScanner(std::vector<BreakCondition> conditions)
    : conditions_(std::move(conditions)), counts_(conditions_.size(), 0) {
  measures_ = std::any_of(conditions_.begin(), conditions_.end(), [](const BreakCondition& condition) {
    return condition.kind == BreakKind::wider || condition.kind == BreakKind::narrower;
  });
}

void BreakScanner::hit(std::size_t condition) {
  hits_.push_back({taken_, condition});
  ++counts_[condition];
}

bool BreakScanner::begins_to_wait(const Step& step) {
  const auto* taken = get_if<TubeTaken>(step);
  const auto* dealt = get_if<LoopsDealt>(step);
  if (taken == nullptr && dealt == nullptr) return false;
  const std::int32_t held = taken != nullptr ? taken->held : dealt->held;
  const bool more = held > held_;
  held_ = held;
  // Where one begins and another is taken up again there are as many as before.
  return more || (taken != nullptr && taken->aside >= 0);
}

void BreakScanner::take(const Step& step, const Parameters& parameters, const Fabric& fabric) {
  Sight sight;
  sight.begins_stage = !last_ || last_->stage != step.place.stage;
  sight.begins_row = sight.begins_stage || last_->row != step.place.row;
  last_ = step.place;
  if (const auto* taken = get_if<TubeTaken>(step)) casts_on_ = taken->live == 0;
  sight.casts_on = casts_on_;
  sight.begins_to_wait = begins_to_wait(step);
  if (is<StitchPlaced>(step) && finished_row_size(step)) casts_on_ = false;
  if (sight.begins_row || !is_common(step)) {
    const auto size = finished_row_size(step);
    const Row* row = fabric.find_row(step.place.row);
    if (size && row != nullptr && !row->on.empty()) sight.growth = *size - row->on.size();
    if (size && measures_ && row != nullptr) sight.widths = widths_of(*row, parameters.stitch.width);
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
      if (holds(conditions_[i], step, sight)) hit(i);
    }
  }
  ++taken_;
}

void BreakScanner::take_stop(const Step& stop) {
  const auto* stopped = get_if<Stopped>(stop);
  if (stopped == nullptr) return;
  // Of a change that is too much, `count` is the row's size and `other` that of the row before.
  const bool over_double =
      stopped->reason == StopReason::changes_too_much && stopped->count > 2 * stopped->other;
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    const bool stall = conditions_[i].kind == BreakKind::stall && stopped->reason == StopReason::stall;
    if (stall || (conditions_[i].kind == BreakKind::over_double && over_double)) hit(i);
  }
}

}  // namespace knit
