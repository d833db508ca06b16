#include "app/files/pattern_export.h"

#include <string_view>

#include "app/files/chart_svg.h"
#include "app/files/pieces_svg.h"
#include "app/session/chart_twins.h"
#include "app/session/document.h"
#include "app/session/planned_pieces.h"
#include "app/session/remarks.h"
#include "app/session/view.h"
#include "knit/base/number_text.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/limb_chart.h"
#include "knit/pattern/limb_words.h"

namespace app {

namespace {

const knit::State& state_of(const Session& session) { return session.document->timeline.state(); }
const std::string& mesh_name(const Session& session) { return session.document->timeline.input().mesh.name; }

knit::WrittenPattern written(const Session& session, const knit::Rounds& rounds) {
  return knit::write_pattern(rounds, session.document->timeline.parameters().stitch.gauge,
                             in_form(session.view->pattern, state_of(session)), mesh_name(session));
}

knit::WrittenPattern written(const Session& session, const PlannedPieces& pieces) {
  const knit::Parameters& parameters = session.document->timeline.parameters();
  return knit::write_pattern(pieces.plan, parameters.stitch.gauge, pieces.options, mesh_name(session),
                             parameters.size.height_cm);
}

// The notes say what is not as asked. Measured here where nobody has measured it yet.
knit::WrittenPattern noted(const Session& session, knit::WrittenPattern pattern,
                           const PlannedPieces* pieces = nullptr) {
  const knit::Timeline& timeline = session.document->timeline;
  if (!timeline.state().finished()) return pattern;
  const auto& closeness = session.document->closeness;
  std::optional<knit::Coverage> coverage = closeness ? closeness->coverage : std::nullopt;
  const knit::StitchSize& stitch = timeline.parameters().stitch;
  if (!coverage)
    coverage = knit::measure_coverage(timeline.input(), timeline.state(), stitch.width, stitch.height);
  say_how_it_came_out(pattern, timeline, coverage ? &*coverage : nullptr, pieces);
  return pattern;
}

knit::WrittenPattern written(const Session& session) {
  const knit::State& state = state_of(session);
  return knit::has_limbs(state) ? written(session, planned_pieces(session))
                                : written(session, knit::rounds_of(state));
}

std::string title_of(const Session& session) {
  return session.view->pattern.title.empty() ? mesh_name(session) : session.view->pattern.title;
}

// The charts of pieces with their names; `charts` holds them.
std::vector<NamedChart> named(const std::vector<knit::PieceChart>& charts, const knit::LimbNames& names) {
  std::vector<NamedChart> all;
  all.reserve(charts.size());
  for (const knit::PieceChart& piece : charts) all.push_back({names.together(piece.pieces), &piece.chart});
  return all;
}

PiecesArt art_of(const knit::LimbPlan& plan, const knit::LimbNames& names,
                 const std::vector<knit::PieceChart>& charts) {
  const std::vector<NamedChart> all = named(charts, names);
  return {pieces_svg(plan, names), charts_svgs(all, sheet_for(all)), is_wide(all)};
}

std::string file_in_pieces(const Session& session, PatternFormat format, std::span<const std::uint8_t> png) {
  const PlannedPieces pieces = planned_pieces(session);
  const knit::LimbNames names(pieces.plan, pieces.options);
  const std::vector<knit::PieceChart> charts = knit::piece_charts(pieces.plan, names);
  switch (format) {
    case PatternFormat::text:
      return knit::pattern_as_text(noted(session, written(session, pieces), &pieces)) +
             knit::charts_as_text(charts, names);
    case PatternFormat::markdown:
      return knit::pattern_as_markdown(noted(session, written(session, pieces), &pieces)) +
             knit::charts_as_markdown(charts, names);
    case PatternFormat::html:
      return pattern_html(noted(session, written(session, pieces), &pieces),
                          art_of(pieces.plan, names, charts), png);
    case PatternFormat::json:
      return pattern_json(pieces.plan, pieces.options);
    case PatternFormat::knitspeak:
      break;
  }
  return pattern_knitspeak(pieces.plan, pieces.options);
}

}  // namespace

std::optional<PatternFormat> pattern_format_of(const std::filesystem::path& path) {
  if (path == "-") return PatternFormat::text;
  const std::string ending = path.extension().string();
  if (ending == ".txt") return PatternFormat::text;
  if (ending == ".md") return PatternFormat::markdown;
  if (ending == ".html" || ending == ".htm") return PatternFormat::html;
  if (ending == ".json") return PatternFormat::json;
  if (ending == ".ks") return PatternFormat::knitspeak;
  return std::nullopt;
}

std::optional<double> needle_mm_of(std::string_view text) {
  double needle = 0.0;
  const char* end = text.data() + text.size();
  const auto result = knit::number_from(text.data(), end, needle);
  if (result.ec != std::errc() || result.ptr != end || !(needle >= 0.5 && needle <= 50.0))
    return std::nullopt;
  return needle;
}

std::optional<std::string> pattern_missing(const Session& session) {
  if (!session.document) return "nothing is open; open a mesh to write its pattern.";
  if (session.document->timeline.state().stage() > knit::Stage::stitches) return std::nullopt;
  if (stop_shown(session) != nullptr) return "the run stopped, so there is no pattern to write.";
  return "the pattern is not there yet: not all stitches have their labels. Let the run go on to the faces.";
}

std::optional<std::string> chart_missing(const Session& session) { return pattern_missing(session); }

std::optional<std::string> pieces_missing(const Session& session) {
  if (auto missing = pattern_missing(session)) return missing;
  if (knit::has_limbs(state_of(session))) return std::nullopt;
  return "this pattern is one piece: there is no picture of pieces.";
}

std::optional<std::string> format_missing(const Session& session, PatternFormat /*format*/) {
  return pattern_missing(session);
}

std::vector<std::string> pattern_instructions(const Session& session) {
  if (pattern_missing(session)) return {};
  const knit::WrittenPattern pattern = written(session);
  std::vector<std::string> lines{pattern.start};
  for (const auto& step : pattern.instructions)
    lines.push_back(step.round ? step.round->text() : step.remark);
  return lines;
}

std::string pattern_file_text(const Session& session, PatternFormat format,
                              std::span<const std::uint8_t> picture_png) {
  if (knit::has_limbs(state_of(session))) return file_in_pieces(session, format, picture_png);
  const knit::Rounds rounds = knit::rounds_of(state_of(session));
  switch (format) {
    case PatternFormat::text:
      return knit::pattern_as_text(noted(session, written(session, rounds))) +
             knit::chart_as_text(knit::chart_of(rounds));
    case PatternFormat::markdown:
      return knit::pattern_as_markdown(noted(session, written(session, rounds))) +
             knit::chart_as_markdown(knit::chart_of(rounds));
    case PatternFormat::html:
      return pattern_html(noted(session, written(session, rounds)), knit::chart_of(rounds), picture_png);
    case PatternFormat::json:
      return pattern_json(rounds);
    case PatternFormat::knitspeak:
      break;
  }
  return pattern_knitspeak(rounds, session.view->pattern.turns);
}

std::string chart_file_text(const Session& session) {
  if (knit::has_limbs(state_of(session))) {
    const PlannedPieces pieces = planned_pieces(session);
    const knit::LimbNames names(pieces.plan, pieces.options);
    const std::vector<knit::PieceChart> charts = knit::piece_charts(pieces.plan, names);
    SheetLook look;
    look.title = title_of(session);
    return charts_svg(named(charts, names), look) + "\n";
  }
  const knit::Rounds rounds = knit::rounds_of(state_of(session));
  ChartLook look;
  look.title = title_of(session);
  return chart_svg(knit::chart_of(rounds), look) + "\n";
}

std::string piece_chart_file_text(const Session& session) {
  const PlannedPieces pieces = planned_pieces(session);
  const knit::LimbNames names(pieces.plan, pieces.options);
  const std::vector<knit::PieceChart> charts = knit::piece_charts(pieces.plan, names);
  const Gaze& gaze = session.view->gaze;
  const knit::Step* step = last_step(session);
  auto chosen = chart_of_piece(charts, pieces, gaze.chart_piece);
  if (!chosen)
    chosen =
        chart_with_row(charts, pieces.plan, gaze.knit_along.value_or(step != nullptr ? step->place.row : 0));
  const knit::PieceChart& chart = charts[chosen.value_or(0)];
  ChartLook look;
  look.title = title_of(session) + ": " + names.together(chart.pieces);
  return chart_svg(chart.chart, look) + "\n";
}

std::string pieces_file_text(const Session& session) {
  const PlannedPieces pieces = planned_pieces(session);
  return pieces_svg(pieces.plan, knit::LimbNames(pieces.plan, pieces.options), title_of(session)) + "\n";
}

}  // namespace app
