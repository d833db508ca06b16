#include "app/core/action.h"
#include "app/core/queries.h"
#include "app/core/sweep_work.h"

namespace app {

namespace {

std::variant<SweepPlan, std::string> plan_of(const std::vector<std::string>& axes) {
  if (axes.size() > 2) return "--sweep can be given once or twice; more than two parameters make no table.";
  SweepPlan plan;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    auto axis = parse_sweep_axis(axes[i]);
    if (auto* fault = std::get_if<std::string>(&axis)) return *fault;
    if (i == 0) plan.axis = std::get<SweepAxis>(axis);
    if (i == 1) plan.second = std::get<SweepAxis>(axis);
  }
  if (auto fault = fault_of(plan)) return *fault;
  return plan;
}

// In quotes where a comma or a quote would end the cell.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string cv_cell(const knit::LengthFigures& figures) {
  return figures.count > 0 ? knit::number_text(figures.cv) : "";
}

std::string line_of(const SweepRun& run) {
  std::string line;
  for (const double value : run.values) line += knit::number_text(value) + ",";
  if (!run.refused.empty()) return line + "refused,,,,,,,,,," + cell(run.refused) + "\n";
  const RunFigures& f = run.figures;
  line += f.finished ? "finished" : "stopped";
  for (const std::size_t count : {f.steps, f.rows, f.stitches}) line += "," + std::to_string(count);
  for (const std::int32_t count : {f.increases, f.decreases, f.most_in_a_row})
    line += "," + std::to_string(count);
  return line + "," + std::to_string(f.problems) + "," + cv_cell(f.course) + "," + cv_cell(f.wale) + "," +
         cell(f.stop) + "\n";
}

}  // namespace

std::optional<std::string> fault_of_sweep(const std::vector<std::string>& axes) {
  if (axes.empty()) return std::nullopt;
  const auto plan = plan_of(axes);
  const auto* fault = std::get_if<std::string>(&plan);
  return fault != nullptr ? std::optional(*fault) : std::nullopt;
}

Answer sweep_answer(Session& session, const std::vector<std::string>& axes) {
  const auto plan = plan_of(axes);
  if (const auto* fault = std::get_if<std::string>(&plan)) return {exit_usage, "", *fault};
  app::apply(session, StartSweep{std::get<SweepPlan>(plan)});
  if (session.beside) return {};
  const SweepWork& work = *session.sweep->work;
  std::string text = work.plan().axis.key + ",";
  if (work.plan().second) text += work.plan().second->key + ",";
  text += "outcome,steps,rows,stitches,increases,decreases,most_in_a_row,problems,course_cv,wale_cv,why\n";
  for (std::size_t i = 0; i < work.total(); ++i) text += line_of(*work.run(i));
  return {exit_done, text, ""};
}

}  // namespace app
