// The pattern for other programs: knitspeak, and JSON with the graph of stitches; see docs/pattern.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session.h"
#include "knit/limbs/limb_plan.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"

namespace app {

// "CO 6 sts (Rnd 1)." and then "Round 2: *k1, M1L, repeat from *. (12 sts)", "Rounds 3-5: knit. (12 sts)".
std::string pattern_knitspeak(const knit::Rounds& rounds);

// Operations run-length encoded, a round a line; the graph a row a line.
std::string pattern_json(const knit::Rounds& rounds);
// Version 2: a piece a line, with what it begins on, its rounds and its end.
std::string pattern_json(const knit::LimbPlan& plan, const knit::PatternOptions& options = {});

// The written pattern as one page to print: no other file is needed.

// The parts in the order of the written pattern, then the chart, if it has rows. Each round line is one <li class="round">,
// its text exactly RoundLine::text(). `picture_png`: of the finished object; may be empty.
std::string pattern_html(const knit::WrittenPattern& pattern, const knit::Chart& chart,
                         std::span<const std::uint8_t> picture_png = {});

// The pattern in the format that a file's name asks for, and the chart as a drawing.

enum class PatternFormat : std::uint8_t { text, markdown, html, json, knitspeak };

// By the ending: .txt, .md, .html, .json, .ks; "-" is plain text. None for any other.
std::optional<PatternFormat> pattern_format_of(const std::filesystem::path& path);
inline constexpr const char* pattern_endings = ".txt, .md, .html, .json or .ks";

// What a needle may measure, as text: nothing where that is no number from 0.5 to 50.
std::optional<double> needle_mm_of(std::string_view text);
inline constexpr const char* needle_range = "a number from 0.5 to 50";

// Why there is no pattern yet; nothing when it can be written.
std::optional<std::string> pattern_missing(const Session& session);

// Why there is no chart, or no pattern in this format: also because it is in pieces.
std::optional<std::string> chart_missing(const Session& session);
std::optional<std::string> format_missing(const Session& session, PatternFormat format);

// How to begin, the rounds and the remarks between them, as on the written page; empty while there is no pattern.
std::vector<std::string> pattern_instructions(const Session& session);

// Both require that nothing is missing. `picture_png`: of the finished object, for HTML; may be empty.
std::string pattern_file_text(const Session& session, PatternFormat format,
                              std::span<const std::uint8_t> picture_png = {});
std::string chart_file_text(const Session& session);

}  // namespace app
