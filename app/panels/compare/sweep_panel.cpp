// A side of the right column: many values of a parameter, and what the run makes of each.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "app/base/text.h"
#include "app/panels/compare/sweep_plot.h"
#include "app/panels/kit/number_field.h"
#include "app/panels/kit/sides.h"
#include "app/panels/kit/sweep_cache.h"
#include "app/panels/kit/widgets.h"
#include "app/session/document.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr int line_values = 200, grid_values = 24;  // to begin with

bool is_offered(const knit::ParameterInfo& info, const knit::Parameters& parameters) {
  return can_be_swept(info) && knit::is_read(info, parameters);
}

const knit::ParameterInfo& first_offered(const knit::Parameters& parameters, std::string_view but) {
  const auto table = knit::parameter_table();
  for (const std::string_view key : {knit::keys::epsilon, knit::keys::stitch_width}) {
    const knit::ParameterInfo* info = knit::find_parameter(key);
    if (key != but && is_offered(*info, parameters)) return *info;
  }
  const auto found = std::find_if(table.begin(), table.end(), [&](const knit::ParameterInfo& info) {
    return info.key != but && is_offered(info, parameters);
  });
  return *found;
}

// An axis of a parameter that is not read now would sweep nothing.
void refresh_form(PanelFrame& frame) {
  SweepForm& form = frame.own<SweepForm>();
  const knit::Parameters& parameters = frame.timeline()->parameters();
  const auto input = frame.timeline()->input_pointer();
  bool other_mesh = form.input != input;
  form.input = input;
  const auto& sweep = frame.session.document->sweep;
  if (sweep && form.shown.lock() != sweep->work) {
    form.shown = sweep->work;
    form.axis = sweep->plan.axis;
    form.grid = sweep->plan.second.has_value();
    if (form.grid) form.second = *sweep->plan.second;
    other_mesh = false;
  }
  const auto refresh = [&](SweepAxis& axis, std::string_view other) {
    const knit::ParameterInfo* info = knit::find_parameter(axis.key);
    if (!other_mesh && info != nullptr && axis.key != other && is_offered(*info, parameters)) return;
    axis = usual_axis(first_offered(parameters, other), parameters, form.grid ? grid_values : line_values);
  };
  refresh(form.axis, "");
  refresh(form.second, form.axis.key);
}

// The newly chosen parameter, or null.
const knit::ParameterInfo* draw_choice(PanelFrame& frame, const char* id, const std::string& shown,
                                       std::string_view but, float width) {
  const knit::ParameterInfo* chosen = nullptr;
  ImGui::SetNextItemWidth(width);
  const bool open = begin_list(frame, id, shown);
  if (!open) return nullptr;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (!is_offered(info, frame.timeline()->parameters()) || info.key == but) continue;
    const std::string label(info.label);
    if (ImGui::Selectable(label.c_str(), label == shown)) chosen = &info;
    frame.mark("sweep/offer/" + std::string(info.key));
    tooltip(frame, info.help);
  }
  ImGui::EndCombo();
  return chosen;
}

// From, to and how many, in one line.
void draw_range(PanelFrame& frame, SweepAxis& axis, const std::string& mark) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float whole = ImGui::GetContentRegionAvail().x;
  const float third = std::floor((whole - 2.0f * gap) / 3.0f);
  const knit::ParameterInfo& info = *knit::find_parameter(axis.key);
  const auto* of_number = std::get_if<knit::Number>(&info.kind);
  const auto* of_count = std::get_if<knit::Count>(&info.kind);
  const double low = of_number != nullptr ? of_number->low : static_cast<double>(of_count->low);
  const double high = of_number != nullptr ? of_number->high : static_cast<double>(of_count->high);
  const auto number = [&](const char* name, const char* words, double& value) {
    const std::string full = knit::number_text(value);
    const std::string shown = std::string(words) + " " + shown_number(value);
    const bool open_ended = high >= knit::no_limit;
    const NumberShape shape{shown, full, value, low, high, open_ended ? DragPace::ratio : DragPace::linear};
    edit_number(frame, ("##" + mark + name).c_str(), value, shape, third);
    frame.mark(mark + "/" + name);
    tooltip(frame, "Drag to change it, click to type." + exact_words(shown_number(value), full));
    ImGui::SameLine(0.0f, gap);
  };
  number("from", "from", axis.from);
  number("to", "to", axis.to);
  edit_number(frame, ("##" + mark + "count").c_str(), axis.count, least_sweep_values, most_sweep_values,
              " values", third);
  frame.mark(mark + "/count");
  tooltip(frame, "How many values, both ends in. Drag to change it, click to type.");
}

std::string label_of(const std::string& key) { return std::string(knit::find_parameter(key)->label); }

void draw_form(PanelFrame& frame) {
  SweepForm& form = frame.own<SweepForm>();
  const knit::Parameters& parameters = frame.timeline()->parameters();
  const float wide = ImGui::GetContentRegionAvail().x;
  if (const auto* info = draw_choice(frame, "##axis", label_of(form.axis.key),
                                     form.grid ? form.second.key : std::string(), wide))
    form.axis = usual_axis(*info, parameters, form.axis.count);
  frame.mark("sweep/parameter");
  draw_range(frame, form.axis, "sweep/first");
  bool grid = form.grid;
  ImGui::Checkbox("Against a second one", &grid);
  frame.mark("sweep/grid");
  tooltip(frame, "Every value of the one with every value of the other: a map instead of lines.");
  if (grid != form.grid) {
    form.grid = grid;
    form.axis.count = form.second.count = grid ? grid_values : line_values;
    if (grid && form.second.key == form.axis.key)
      form.second = usual_axis(first_offered(parameters, form.axis.key), parameters, grid_values);
  }
  if (!form.grid) return;
  ImGui::SameLine();
  if (const auto* info = draw_choice(frame, "##second", label_of(form.second.key), form.axis.key,
                                     ImGui::GetContentRegionAvail().x))
    form.second = usual_axis(*info, parameters, form.second.count);
  frame.mark("sweep/second-parameter");
  draw_range(frame, form.second, "sweep/second");
}

SweepPlan plan_of(const SweepForm& form) {
  return {form.axis, form.grid ? std::optional(form.second) : std::nullopt};
}

void draw_progress(PanelFrame& frame, const SweepWork& work, float width) {
  const auto share = static_cast<float>(work.done()) / static_cast<float>(work.total());
  const std::string words = std::to_string(work.done()) + " of " + std::to_string(work.total());
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, style::vector(theme().accent));
  ImGui::ProgressBar(share, ImVec2(width, ImGui::GetFrameHeight()), words.c_str());
  ImGui::PopStyleColor();
  frame.mark("sweep/progress");
}

void draw_start(PanelFrame& frame) {
  const SweepPlan plan = plan_of(frame.own<SweepForm>());
  const auto& sweep = frame.session.document->sweep;
  const bool running = sweep && sweep->work->running();
  const float button = frame.units(84.0f);
  if (running) {
    if (ImGui::Button("Cancel", ImVec2(button, 0.0f))) frame.wish(CancelSweep{});
    frame.mark("sweep/cancel");
    ImGui::SameLine();
    draw_progress(frame, *sweep->work, ImGui::GetContentRegionAvail().x);
    return;
  }
  const auto fault = fault_of(plan);
  ImGui::BeginDisabled(fault.has_value());
  if (ImGui::Button("Start", ImVec2(button, 0.0f))) frame.wish(StartSweep{plan});
  ImGui::EndDisabled();
  frame.mark("sweep/start");
  tooltip(frame, fault ? *fault : "Runs the whole pipeline for each value, in the background.");
  if (fault) return wrapped_text(*fault, theme().problem);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (!sweep) {
    const std::size_t runs = static_cast<std::size_t>(std::max(0, plan.axis.count)) *
                             static_cast<std::size_t>(plan.second ? std::max(0, plan.second->count) : 1);
    return faint_text(with_commas(runs, "run", "runs"));
  }
  std::string words = with_commas(sweep->work->done(), "run", "runs");
  if (frame.own<SweepCache>().stopped() > 0)
    words += ", " + with_commas(frame.own<SweepCache>().stopped()) + " stopped";
  if (frame.own<SweepCache>().refused() > 0)
    words += ", " + with_commas(frame.own<SweepCache>().refused()) + " refused";
  if (swept_otherwise(*sweep->work, *frame.timeline())) words += ", of other settings than now";
  if (sweep->work->cancelled() && sweep->work->done() < sweep->work->total()) words += ", cancelled";
  faint_text(words);
}

// "\n3 tubes, 2 yarns, 1 holder at once; 2 parts left out, 0.4 % uncovered"; what one plain tube is goes without saying.
std::string tubes_line(const SweepRun& run) {
  const TubeFigures& t = run.tubes;
  std::string words;
  if (t.tubes > 1) {
    words = knit::plural(t.tubes, "tube", "tubes") + ", " + knit::plural(t.yarns, "yarn", "yarns");
    if (t.holders > 0) words += ", " + knit::plural(t.holders, "holder", "holders") + " at once";
  }
  const auto add = [&](const std::string& more) { words += (words.empty() ? "" : "; ") + more; };
  if (t.left_out > 0) add(knit::plural(t.left_out, "part", "parts") + " left out");
  if (run.uncovered && *run.uncovered > 0.0) add(knit::percent_text(*run.uncovered) + " uncovered");
  return words.empty() ? words : "\n" + words;
}

std::string run_words(const SweepPlan& plan, const SweepRun& run) {
  std::string words = label_of(plan.axis.key) + " " + knit::number_text(run.values[0]);
  if (plan.second) words += ", " + label_of(plan.second->key) + " " + knit::number_text(run.values[1]);
  if (!run.refused.empty()) return words + "\nRefused: " + run.refused;
  const RunFigures& f = run.figures;
  const std::string kinds = knit::words_of(f.problems);
  words += "\n" + with_commas(f.problems.total(), "problem", "problems") +
           (kinds.empty() ? "" : " (" + kinds + ")") + ", " + with_commas(f.stitches, "stitch", "stitches") +
           " in " + with_commas(f.rows, "row", "rows");
  words += "\nCourse CV " + fixed_text(f.course.cv, 3);
  if (f.wale.count > 0) words += ", wale CV " + fixed_text(f.wale.cv, 3);
  words += ", at most " + knit::plural(f.most_in_a_row, "shaping", "shapings") + " in a row";
  words += tubes_line(run);
  if (!f.finished) words += "\nStopped: " + f.stop;
  return words + "\nClick: take it.";
}

void tooltip_at_pointer(const PanelFrame& frame, const std::string& words) {
  tooltip_about(frame, around_pointer(frame), words);
}

// Of the figures to choose from: all; counts of problems, of every kind or one; the others.
enum class Offered : std::uint8_t { all, problems, others };

bool is_offered(SweepFigure figure, Offered offered) {
  return offered == Offered::all || counts_problems(figure) == (offered == Offered::problems);
}

// `mark`: "sweep/figure".
void draw_figure_choice(PanelFrame& frame, const std::string& mark, SweepFigure& chosen, Offered offered) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const std::string stem = mark + "/";
  if (begin_list(frame, ("##" + mark).c_str(), std::string(name_of(chosen)))) {
    for (std::size_t f = 0; f < sweep_figures; ++f) {
      const auto figure = static_cast<SweepFigure>(f);
      if (!is_offered(figure, offered)) continue;
      const std::string name(name_of(figure));
      if (ImGui::Selectable(name.c_str(), figure == chosen)) chosen = figure;
      frame.mark(stem + name);
    }
    ImGui::EndCombo();
  }
  frame.mark(mark);
}

// All problems or one kind, and where there is none.
void draw_problem_choice(PanelFrame& frame, const SweepPlot& plot) {
  SweepFigure& chosen = frame.own<SweepForm>().first;
  draw_figure_choice(frame, "sweep/problem-figure", chosen, Offered::problems);
  tooltip(frame, "What the first plot counts: all problems, or one kind of them.");
  const auto quiet = quiet_stretch(plot.work, plot.cache, chosen);
  faint_text(quiet ? words_of(*quiet, chosen) : "");
  frame.mark("sweep/quiet");
}

SweepPointed draw_lines(PanelFrame& frame, SweepPlot plot) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  const float lines = 2.0f * ImGui::GetFrameHeight() + ImGui::GetTextLineHeight();
  const float third = (room.y - 6.0f * gap - lines) / 3.0f;
  const float height = std::floor(std::clamp(third, frame.units(84.0f), frame.units(230.0f)));
  SweepPointed pointed;
  const auto line_of = [&](SweepFigure figure) {
    plot.name = "sweep/" + std::string(key_of(figure));
    plot.figure = figure;
    const SweepPointed here = draw_sweep_line(frame, plot, ImVec2(room.x, height));
    if (here.run) pointed = here;
  };
  draw_problem_choice(frame, plot);
  line_of(frame.own<SweepForm>().first);
  line_of(SweepFigure::stitches);
  draw_figure_choice(frame, "sweep/figure", frame.own<SweepForm>().third, Offered::others);
  line_of(frame.own<SweepForm>().third);
  return pointed;
}

SweepPointed draw_map(PanelFrame& frame, SweepPlot plot) {
  draw_figure_choice(frame, "sweep/figure", frame.own<SweepForm>().figure, Offered::all);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  plot.name = "sweep/map";
  plot.figure = frame.own<SweepForm>().figure;
  return draw_sweep_map(
      frame, plot, ImVec2(room.x, std::max(frame.units(160.0f), room.y - ImGui::GetStyle().ItemSpacing.y)));
}

void draw_results(PanelFrame& frame) {
  const SweepWork& work = *frame.session.document->sweep->work;
  const SweepPlan& plan = work.plan();
  const knit::Parameters& now = frame.timeline()->parameters();
  SweepPlot plot{"", SweepFigure::problems,         work, frame.own<SweepCache>(), {},
                 {}, frame.own<SweepForm>().hovered};
  plot.present = present_value(*knit::find_parameter(plan.axis.key), now);
  if (plan.second) plot.second_present = present_value(*knit::find_parameter(plan.second->key), now);
  const SweepPointed pointed = plan.second ? draw_map(frame, plot) : draw_lines(frame, plot);
  frame.own<SweepForm>().hovered = pointed.run;
  const SweepRun* run = pointed.run ? work.run(*pointed.run) : nullptr;
  if (run == nullptr) return;
  tooltip_at_pointer(frame, run_words(plan, *run));
  if (pointed.clicked && run->refused.empty()) frame.wish(TakeSweepValue{*pointed.run});
}

}  // namespace

template <>
void draw_side<SidePanel::sweep>(PanelFrame& frame) {
  if (frame.timeline() == nullptr) return faint_text("Open a mesh first.");
  refresh_form(frame);
  draw_form(frame);
  const auto& sweep = frame.session.document->sweep;
  frame.own<SweepCache>().refresh(sweep ? sweep->work : nullptr);
  draw_start(frame);
  if (sweep) return draw_results(frame);
  wrapped_text(
      "The whole run for each of many values of a parameter: how many problems it meets, how many stitches "
      "it "
      "makes, how even they are. A click on a value takes it.",
      theme().faint_text);
}

}  // namespace app
