#include "app/core/pattern_file.h"

#include <charconv>

#include "app/core/chart_svg.h"
#include "app/core/pattern_export.h"
#include "app/core/pattern_html.h"
#include "knit/chart_text.h"

namespace app {

namespace {

knit::WrittenPattern written(const Session& session, const knit::Rounds& rounds) {
  const knit::Timeline& timeline = *session.timeline;
  return knit::write_pattern(rounds, timeline.parameters().gauge, session.pattern,
                             timeline.input().mesh.name);
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
  const auto result = std::from_chars(text.data(), end, needle);
  if (result.ec != std::errc() || result.ptr != end || !(needle >= 0.5 && needle <= 50.0))
    return std::nullopt;
  return needle;
}

std::optional<std::string> pattern_missing(const Session& session) {
  if (!session.timeline) return "nothing is open; open a mesh to write its pattern.";
  if (session.timeline->state().stage() > knit::Stage::stitches) return std::nullopt;
  return "the pattern is not there yet: not all stitches have their labels. Let the run go on to the faces.";
}

std::string pattern_file_text(const Session& session, PatternFormat format,
                              std::span<const std::uint8_t> picture_png) {
  const knit::Rounds rounds = knit::rounds_of(session.timeline->state());
  switch (format) {
    case PatternFormat::text:
      return knit::pattern_as_text(written(session, rounds)) + knit::chart_as_text(knit::chart_of(rounds));
    case PatternFormat::markdown:
      return knit::pattern_as_markdown(written(session, rounds)) +
             knit::chart_as_markdown(knit::chart_of(rounds));
    case PatternFormat::html:
      return pattern_html(written(session, rounds), knit::chart_of(rounds), picture_png);
    case PatternFormat::json:
      return pattern_json(rounds);
    case PatternFormat::knitspeak:
      break;
  }
  return pattern_knitspeak(rounds);
}

std::string chart_file_text(const Session& session) {
  const knit::Rounds rounds = knit::rounds_of(session.timeline->state());
  ChartLook look;
  look.title = session.pattern.title.empty() ? session.timeline->input().mesh.name : session.pattern.title;
  return chart_svg(knit::chart_of(rounds), look) + "\n";
}

}  // namespace app
