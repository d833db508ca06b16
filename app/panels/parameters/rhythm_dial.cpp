#include "app/panels/parameters/rhythm_dial.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/base/text.h"
#include "app/explain/fit_size.h"
#include "app/explain/rhythm_figures.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/plots.h"
#include "app/panels/kit/ways.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/hash.h"
#include "knit/model/words.h"
#include "knit/pattern/pattern_words.h"
#include "knit/pattern/short_form.h"
#include "knit/rhythm/rhythm_plan.h"

namespace app {

namespace {

std::uint64_t pattern_key(const knit::State& state) {
  knit::Hasher hasher;
  for (const auto& join : state.fabric.joins()) hasher.add(join.content_hash());
  hasher.add(state.fabric.rows().size());
  hasher.add(state.rhythms.empty() ? 0 : state.rhythms.back().content_hash());
  return hasher.value();
}

// The cast on, what is named, and the lines.
std::optional<PatternLength> length_of(const knit::State& state) {
  const auto& rows = state.fabric.rows();
  if (state.rhythms.empty() || rows.empty() || state.fabric.joins().size() + 1 != rows.size()) return {};
  if (knit::has_limbs(state)) return {};
  const std::size_t planned =
      static_cast<std::size_t>(state.rhythms.back()->from) + state.rhythms.back()->plan.counts.size();
  if (rows.size() < planned) return {};
  const knit::Rounds rounds = knit::rounds_of(state);
  const auto form = knit::short_form(rounds, knit::stuffed_after(rounds));
  if (!form) return {};
  PatternLength length{1 + form->named.size() + form->lines.size(), 0};
  for (const knit::NamedRound& named : form->named) length.characters += named.text().size();
  for (const knit::RoundLine& line : form->lines) length.characters += line.text().size();
  return length;
}

// Three digits, as a hand can tell them apart.
double few_digits(double dial) {
  const double power = std::pow(10.0, std::floor(std::log10(dial)) - 2.0);
  return std::round(dial / power) * power;
}

bool draw_slider(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters) {
  const double now = rhythm_dial_in_force(frame);
  const auto dials = knit::rhythm_dials();
  const double lowest = dials.back(), highest = dials.front();
  // By its logarithm: each rhythm more costs about as much of the way.
  auto share = static_cast<float>(std::clamp(std::log(now / lowest) / std::log(highest / lowest), 0.0, 1.0));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool moved = ImGui::SliderFloat("##dial", &share, 0.0f, 1.0f, "", ImGuiSliderFlags_NoInput);
  const bool held = ImGui::IsItemActive();
  if (frame.session.document->changes.open && ImGui::IsItemDeactivated()) frame.wish(Settle{});
  frame.mark("rhythm/dial");
  tooltip(
      frame,
      "Drag: to the right fewer rhythms and a shorter pattern, to the left nearer to the shape. The plan, "
      "the view and the pattern follow at once.");
  if (!moved) return held;
  const double dial = few_digits(lowest * std::pow(highest / lowest, static_cast<double>(share)));
  knit::Parameters changed = parameters;
  if (!knit::set_value(info, changed, shown_number(dial))) parameters = changed;
  return held;
}

void draw_ends(PanelFrame& frame) {
  push_font(frame.fonts.small);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  text_at(at, 0.0f, theme().faint_text, "true shape");
  text_at(ImVec2(at.x + width, at.y), 1.0f, theme().faint_text, "few rhythms");
  ImGui::Dummy(ImVec2(width, ImGui::GetTextLineHeight()));
  pop_font();
}

std::string length_words(const PanelFrame& frame, const knit::RhythmPlan& plan) {
  if (const auto& length = frame.own<RhythmCache>().length())
    return knit::plural(static_cast<std::int64_t>(length->lines), "line", "lines") + " of pattern, " +
           with_commas(length->characters) + " characters, in the short form";
  const auto shapes = [](const knit::RhythmSegment& segment) { return segment.change != 0; };
  return knit::plural(std::count_if(plan.segments.begin(), plan.segments.end(), shapes), "rhythm", "rhythms");
}

void draw_figures(PanelFrame& frame, const RhythmFigures& figures, double tolerance) {
  const knit::RhythmPlan& plan = figures.rhythm->plan;
  wrapped_text(length_words(frame, plan) + ".");
  frame.mark("rhythm/length");
  tooltip(
      frame,
      "Of the pattern with named rounds and rhythms told once: Short form in the tab Pattern. Cast on and "
      "definitions are counted.");
  const std::string off = fixed_text(plan.seen.worst(), 1) + " % " +
                          (plan.seen.too_small ? "too narrow" : "too wide") + " at most, at row " +
                          std::to_string(figures.first_row + plan.seen.row) + ".";
  wrapped_text(off + (plan.within ? "" : " No rhythm stays within " + knit::short_number(tolerance) + " %."),
               plan.within ? theme().text : theme().warning);
  frame.mark("rhythm/deviation");
  tooltip(frame,
          "By how much the circumference is seen to be off: the mean over six rows of planned against ideal "
          "stitches, against the row's own or the widest.");
}

void draw_plan(PanelFrame& frame, const RhythmFigures& figures) {
  RowPlot plot;
  plot.name = "plot/rhythm";
  plot.title = "Stitches";
  plot.help =
      "Stitches of each row as the rhythm plans them (steps), and as many as its length holds (line). What "
      "lies "
      "between is filled.";
  plot.value_words = "planned";
  plot.ideal_words = "ideal";
  plot.values = figures.planned;
  plot.ideals = figures.ideal;
  plot.first = static_cast<std::size_t>(figures.first_row);
  plot.gaps = true;
  plot.words = [&](std::size_t i) {
    return deviation_words(figures, figures.first_row + static_cast<std::int32_t>(i));
  };
  const std::int32_t row = current_row(frame);
  if (figures.has(row)) plot.current = static_cast<std::size_t>(row - figures.first_row);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, frame.units(132.0f));
  if (const auto clicked = draw_row_plot(frame, plot, size))
    wish_row(frame, figures.first_row + static_cast<std::int32_t>(*clicked));
}

// A row's deviation in % as the tolerance judges it, with its sign: of itself, or of the widest row where it is
// narrow; none: nobody sees it.
std::optional<double> seen_percent(const RhythmFigures& figures, std::size_t i) {
  constexpr double judged_alone = 24.0;
  constexpr double judged = 12.0;
  const double belt = *std::max_element(figures.ideal.begin(), figures.ideal.end());
  const double ideal = figures.ideal[i];
  if (ideal >= judged_alone) return 100.0 * figures.seen[i] / ideal;
  if (ideal >= std::min(judged, 0.5 * belt)) return 100.0 * figures.seen[i] / belt;
  return std::nullopt;
}

// Bars up and down from 0, row by row, between dashes at the tolerance.
void draw_seen_bars(PanelFrame& frame, const plot_parts::Stand& stand, const RhythmFigures& figures,
                    double tolerance) {
  using namespace plot_parts;
  const Box& ground = stand.ground;
  const double most = 1.25 * std::max(tolerance, figures.rhythm->plan.seen.worst());
  const float middle = ground.y + 0.5f * ground.height;
  const auto y_of = [&](double percent) {
    return middle - 0.5f * ground.height * static_cast<float>(most > 0.0 ? percent / most : 0.0);
  };
  const float column = ground.width / static_cast<float>(figures.seen.size());
  const std::int32_t current = current_row(frame);
  if (figures.has(current)) {
    const float x = ground.x + column * static_cast<float>(current - figures.first_row);
    fill(stand, whole(x), ground.y, whole(x + column), ground.bottom(), style::packed(theme().text, 60));
  }
  for (std::size_t i = 0; i < figures.seen.size(); ++i) {
    const auto percent = seen_percent(figures, i);
    if (!percent) continue;
    const float x = ground.x + column * static_cast<float>(i);
    const float y = y_of(*percent);
    const Colour colour = std::abs(*percent) > tolerance ? theme().warning : bar();
    fill(stand, whole(x), std::min(y, middle), std::max(whole(x) + stand.line, whole(x + column)),
         std::max(y, middle), style::packed(colour));
  }
  fill(stand, ground.x, middle, ground.right(), middle + stand.line, style::packed(theme().faint_text));
  for (const double edge : {-tolerance, tolerance}) {
    const float y = whole(y_of(edge));
    for (float x = ground.x; x < ground.right(); x += frame.units(6.0f))
      fill(stand, x, y, std::min(x + frame.units(3.0f), ground.right()), y + stand.line,
           style::packed(theme().faint_text));
  }
}

void draw_seen(PanelFrame& frame, const RhythmFigures& figures, double tolerance) {
  using namespace plot_parts;
  const std::string title = "Seen off";
  const float gutter = ImGui::CalcTextSize("50").x + frame.units(6.0f);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, frame.units(84.0f));
  const Stand stand = begin_stand(frame, "plot/rhythm-seen", title, size, gutter);
  draw_seen_bars(frame, stand, figures, tolerance);
  draw_key(frame, stand, title, stand.ground.right(),
           {"dashed: " + knit::short_number(tolerance) + " %", theme().faint_text, false});
  if (!stand.inside) {
    if (stand.hovered)
      tooltip(frame,
              "By how much the circumference is seen to be off, row by row: above the line too wide, below "
              "it too "
              "narrow. Dashed: the tolerance.");
    return;
  }
  const float share = (ImGui::GetIO().MousePos.x - stand.ground.x) / stand.ground.width;
  const auto rows = static_cast<std::int32_t>(figures.seen.size());
  const std::int32_t row =
      figures.first_row +
      std::clamp(static_cast<std::int32_t>(share * static_cast<float>(rows)), 0, rows - 1);
  frame.rounds_under = RoundSpan{row, row};
  if (stand.hovered) tooltip(frame, deviation_words(figures, row));
  if (stand.clicked) wish_row(frame, row);
}

// What came of the last wish for another size; it stands while the plan is the one it was asked of, or the one it made.
struct SizeAnswer {
  std::uint64_t key = 0;
  bool taken = false;
  std::string words;
};

void draw_fit_size(PanelFrame& frame, std::uint64_t key) {
  SizeAnswer& answer = frame.own<SizeAnswer>();
  if (ImGui::Button("Fit the size")) {
    auto fitted = fitted_size(*frame.timeline());
    if (auto* fit = std::get_if<FittedSize>(&fitted)) {
      answer = {key, true, std::move(fit->words)};
      frame.wish(Tune{fit->parameters});
    } else {
      answer = {key, false, std::move(std::get<std::string>(fitted))};
    }
  }
  frame.mark("rhythm/fit-size");
  tooltip(
      frame,
      "Make the piece up to 4 % larger or smaller where the rhythm reads better then: the widest row holds "
      "a whole number of sections. The gauge stays, the finished height moves.");
  if (answer.taken && answer.key != key) answer.key = key, answer.taken = false;
  if (answer.key == key && !answer.words.empty()) wrapped_text(answer.words, theme().faint_text);
}

}  // namespace

void RhythmCache::refresh(const knit::State& state) {
  const std::uint64_t key = pattern_key(state);
  if (key == key_) return;
  key_ = key;
  figures_ = rhythm_figures_of(state);
  length_ = length_of(state);
}

bool is_rhythm_dial(const knit::ParameterInfo& info) {
  const auto* number = std::get_if<knit::Number>(&info.kind);
  if (number == nullptr || number->zero != knit::Zero::chosen) return false;
  constexpr double telling = 1.5;
  knit::Parameters dialled;
  dialled.rhythm.dial = telling;
  return number->get(dialled) == telling && number->get({}) != telling;
}

double rhythm_dial_in_force(PanelFrame& frame) {
  const double given = frame.timeline()->parameters().rhythm.dial;
  if (given > 0.0) return given;
  RhythmCache& cache = frame.own<RhythmCache>();
  cache.refresh(frame.timeline()->furthest());
  const RhythmFigures* figures = figures_at(cache.figures(), current_row(frame));
  return figures != nullptr ? figures->rhythm->plan.dial : 1.0;
}

bool draw_rhythm_dial(PanelFrame& frame, const knit::ParameterInfo& info, knit::Parameters& parameters) {
  const knit::State& state = frame.timeline()->furthest();
  RhythmCache& cache = frame.own<RhythmCache>();
  cache.refresh(state);
  const RhythmFigures* figures = figures_at(cache.figures(), current_row(frame));
  const double tolerance = parameters.rhythm.tolerance;
  const bool held = draw_slider(frame, info, parameters);
  draw_ends(frame);
  if (figures == nullptr) {
    const bool planned = !state.rhythms.empty();
    wrapped_text(planned ? "There is no rhythm here: its rows have as many stitches as their lengths hold."
                         : "What a rhythm costs is shown once the rows are planned.",
                 theme().faint_text);
    frame.mark("rhythm/none");
    return held;
  }
  draw_figures(frame, *figures, tolerance);
  draw_fit_size(frame, state.rhythms.back().content_hash());
  draw_plan(frame, *figures);
  draw_seen(frame, *figures, tolerance);
  return held;
}

}  // namespace app
