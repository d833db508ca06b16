#include "app/files/pattern_export.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/base/text.h"
#include "app/files/chart_svg.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/pattern/chart.h"
#include "knit/pattern/fold.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using knit::Hand;

// --- knitspeak -----------------------------------------------------------------------------------

// Increases are capitals there.
std::string_view speak_word(Hand hand) {
  if (hand == Hand::m1r) return "M1R";
  return hand == Hand::m1l ? "M1L" : knit::word_of(hand);
}

std::string speak(const knit::Run& run) {
  const std::string word(speak_word(run.hand));
  if (run.hand == Hand::knit) return word + std::to_string(run.count);
  return run.count == 1 ? word : "[" + word + "] " + std::to_string(run.count) + " times";
}

std::string speak(const std::vector<knit::Run>& runs) {
  std::string out;
  for (const knit::Run& run : runs) out += (out.empty() ? "" : ", ") + speak(run);
  return out;
}

std::string speak(const knit::Phrase& phrase) {
  if (const auto* run = std::get_if<knit::Run>(&phrase)) return speak(*run);
  const auto& repeat = std::get<knit::Repeat>(phrase);
  return "[" + speak(repeat.runs) + "] " + std::to_string(repeat.times) + " times";
}

std::string speak(const std::vector<knit::Phrase>& phrases) {
  if (phrases.size() == 1) {
    if (const auto* repeat = std::get_if<knit::Repeat>(&phrases.front()))
      return "*" + speak(repeat->runs) + ", repeat from *";
    const auto& run = std::get<knit::Run>(phrases.front());
    if (run.hand == Hand::knit) return "knit";
    if (run.count > 1) return "*" + std::string(speak_word(run.hand)) + ", repeat from *";
  }
  std::string out;
  for (const knit::Phrase& phrase : phrases) out += (out.empty() ? "" : ", ") + speak(phrase);
  return out;
}

bool same_work(const knit::Round& a, const knit::Round& b) {
  return a.operations == b.operations && a.after == b.after;
}

// --- JSON ----------------------------------------------------------------------------------------

std::string_view json_word(Hand hand) { return hand == Hand::knit ? "knit" : knit::word_of(hand); }

Json operations_json(const std::vector<knit::Operation>& operations) {
  Json all = Json::array();
  for (std::size_t i = 0, end = 0; i < operations.size(); i = end) {
    for (end = i; end < operations.size() && operations[end] == operations[i];) ++end;
    Json run{{"hand", json_word(operations[i].hand)}, {"count", end - i}};
    if (operations[i].at_main) run["main"] = true;
    all.push_back(std::move(run));
  }
  return all;
}

Json round_json(const knit::Round& round) {
  return {{"number", round.number},
          {"before", round.before},
          {"after", round.after},
          {"operations", operations_json(round.operations)}};
}

Json stitch_json(const knit::GraphStitch& stitch, bool cast_on) {
  if (cast_on) return {{"hand", "cast on"}, {"below", Json::array()}};
  Json json{{"hand", json_word(stitch.hand)}, {"below", Json::array()}};
  for (std::int32_t i = 0; i < stitch.count; ++i) json["below"].push_back(stitch.first + i);
  if (stitch.count == 0) json["bar_after"] = stitch.first;
  return json;
}

std::string listed(std::string_view name, const std::vector<Json>& lines) {
  std::string out = "  \"" + std::string(name) + "\": [";
  for (std::size_t i = 0; i < lines.size(); ++i) out += (i == 0 ? "\n    " : ",\n    ") + lines[i].dump();
  return out + (lines.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string pattern_knitspeak(const knit::Rounds& rounds) {
  std::string out = "CO " + std::to_string(rounds.cast_on) + " sts (Rnd 1).\n";
  for (std::size_t i = 0, end = 0; i < rounds.rounds.size(); i = end) {
    const knit::Round& round = rounds.rounds[i];
    for (end = i + 1; end < rounds.rounds.size() && same_work(round, rounds.rounds[end]);) ++end;
    const std::string first = std::to_string(round.number);
    const std::string numbers = end - i == 1
                                    ? "Round " + first
                                    : "Rounds " + first + "-" + std::to_string(rounds.rounds[end - 1].number);
    out += numbers + ": " + speak(knit::fold(round.operations)) + ". (" + std::to_string(round.after) +
           " sts)\n";
  }
  return out;
}

std::string pattern_json(const knit::Rounds& rounds) {
  std::vector<Json> worked, graph;
  for (const knit::Round& round : rounds.rounds) worked.push_back(round_json(round));
  for (const std::vector<knit::GraphStitch>& row : knit::graph_of(rounds).rows) {
    Json stitches = Json::array();
    for (const knit::GraphStitch& stitch : row) stitches.push_back(stitch_json(stitch, graph.empty()));
    graph.push_back(std::move(stitches));
  }
  return "{\n  \"format\": \"knit-mesh pattern\",\n  \"version\": 1,\n  \"cast_on\": " +
         std::to_string(rounds.cast_on) + ",\n" + listed("rounds", worked) + ",\n" + listed("graph", graph) +
         "\n}\n";
}

namespace {

std::string_view json_word(knit::LimbDealKind kind) {
  constexpr std::array<std::string_view, 8> words{"cast on", "provisional", "loops",  "rejoin",
                                                  "aside",   "move",        "divide", "join"};
  return words.at(static_cast<std::size_t>(kind));
}
std::string_view json_word(knit::LimbItemKind kind) {
  constexpr std::array<std::string_view, 4> words{"keep", "take", "cast on", "pick up"};
  return words.at(static_cast<std::size_t>(kind));
}
std::string_view json_word(knit::LimbEndKind kind) {
  constexpr std::array<std::string_view, 4> words{"held", "goes on", "closed", "grafted"};
  return words.at(static_cast<std::size_t>(kind));
}

Json item_json(const knit::LimbNames& names, const knit::LimbItem& item) {
  Json json{{"use", json_word(item.kind)}, {"count", item.count}};
  if (item.kind == knit::LimbItemKind::take) {
    json["holder"] = names.holder(item.piece, item.holder);
    json["first"] = item.first;
    json["held"] = item.held;
  }
  if (item.gap > 0) json["gap"] = item.gap;
  if (item.kind == knit::LimbItemKind::pick_up) json["first"] = item.first;
  return json;
}

Json deal_json(const knit::LimbNames& names, const knit::LimbDeal& deal) {
  Json json{{"kind", json_word(deal.kind)}, {"after", deal.after}};
  if (deal.kind == knit::LimbDealKind::loops) json["piece"] = names(deal.piece);
  if (deal.kind == knit::LimbDealKind::divide || deal.kind == knit::LimbDealKind::set_aside)
    json["holder"] = names.holder(deal.piece, deal.holder);
  if (deal.kind == knit::LimbDealKind::divide) {
    json["keep"] = deal.before;
    json["held"] = deal.held;
    json["gap"] = deal.gap;
    json["bridge"] = deal.bridge;
    json["rest"] = deal.rest;
  }
  if (deal.kind == knit::LimbDealKind::move) json["slip"] = deal.before;
  if (deal.items.empty()) return json;
  json["items"] = Json::array();
  for (const knit::LimbItem& item : deal.items) json["items"].push_back(item_json(names, item));
  return json;
}

Json end_json(const knit::LimbNames& names, const knit::LimbEnd& end) {
  Json json{{"kind", json_word(end.kind)}};
  if (end.piece >= 0) json["piece"] = names(end.piece);
  if (end.kind != knit::LimbEndKind::grafted) return json;
  json["slips_back"] = end.slips_back;
  json["others_first"] = end.other_first;
  json["grafts"] = Json::array();
  for (const knit::LimbGraft& graft : end.grafts) json["grafts"].push_back({graft.own, graft.others});
  return json;
}

Json piece_json(const knit::LimbNames& names, const knit::LimbPlan& plan, std::int32_t number) {
  const knit::LimbPiece& piece = plan.piece(number);
  Json json{{"name", names(number)}, {"begin", Json::array()}, {"rounds", Json::array()}};
  if (piece.twins.front() != number) json["twin_of"] = names(piece.twins.front());
  if (piece.inner) json["inner"] = true;
  for (const knit::LimbDeal& deal : piece.deals) json["begin"].push_back(deal_json(names, deal));
  std::int32_t next = piece.is_cast_on() ? 2 : 1;
  for (const knit::LimbRound& round : piece.rounds) {
    Json line = round_json({next++, round.operations, round.before, round.after});
    if (round.slips_back) line["slips_back"] = true;
    json["rounds"].push_back(std::move(line));
  }
  json["rows"] = piece.rows;
  json["starts"] = piece.starts;
  json["end"] = end_json(names, piece.end);
  return json;
}

}  // namespace

std::string pattern_json(const knit::LimbPlan& plan, const knit::PatternOptions& options) {
  const knit::LimbNames names(plan, options);
  std::vector<Json> lines;
  lines.reserve(static_cast<std::size_t>(plan.count()));
  for (std::int32_t i = 0; i < plan.count(); ++i) lines.push_back(piece_json(names, plan, i));
  return "{\n  \"format\": \"knit-mesh pattern\",\n  \"version\": 2,\n  \"yarns\": " +
         std::to_string(plan.yarns) + ",\n  \"holders\": " + std::to_string(plan.held_most) +
         ",\n  \"gaps\": " + Json(plan.gaps).dump() + ",\n" + listed("pieces", lines) + "\n}\n";
}

namespace {

constexpr std::string_view style = R"css(
@page { size: A4 portrait; margin: 12mm 14mm; }
@page wide { size: A4 landscape; margin: 14mm 15mm; }
* { box-sizing: border-box; }
html { background: #e9e7e3; }
body { font: 10.5pt/1.45 Inter, "Helvetica Neue", Helvetica, Arial, sans-serif; color: #1d1d1f;
  background: #fff; max-width: 210mm; margin: 8mm auto; padding: 16mm 15mm; box-shadow: 0 1mm 4mm #0003;
  -webkit-print-color-adjust: exact; print-color-adjust: exact; }
header { border-bottom: .6mm solid #1d1d1f; padding-bottom: 4mm; margin-bottom: 5mm; }
h1 { font: 600 24pt/1.15 Georgia, "Times New Roman", serif; margin: 0; overflow-wrap: anywhere; }
.level { margin: 1.5mm 0 0; color: #666; }
h2 { font-size: 8.5pt; font-weight: 700; letter-spacing: .09em; text-transform: uppercase; color: #8a3d6d;
  margin: 5.5mm 0 1.5mm; break-after: avoid; }
p { margin: 0 0 1.5mm; }
ul { list-style: none; margin: 0; padding: 0; }
.picture { float: right; width: 72mm; max-height: 92mm; object-fit: contain; margin: 0 0 4mm 8mm; }
.facts li, .steps li { margin: 0 0 .8mm; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .6mm 5mm; margin: 0; overflow: hidden; }
dt { font-weight: 600; }
dd { margin: 0; }
.instructions { clear: both; }
.start { margin-bottom: 2.5mm; }
.rounds { font-variant-numeric: tabular-nums; }
.rounds.long { columns: 2; column-gap: 9mm; column-rule: .2mm solid #ccc; }
.rounds li { break-inside: avoid; margin: 0 0 1.1mm; padding-left: 5.5mm;
  text-wrap: pretty; }
.round { position: relative; }
.round::before { content: ""; position: absolute; left: 0; top: .22em; width: .75em; height: .75em;
  border: .25mm solid #999; border-radius: .5mm; }
.rounds .remark { margin: 2mm 0 2.2mm; padding: 1.2mm 2.5mm; background: #f4eef2;
  border-left: .8mm solid #8a3d6d;
  font-style: italic; }
.chart { break-before: page; }
.chart h2 { margin-top: 0; }
.chart.wide { page: wide; }
.chart svg { display: block; margin: 0 auto; max-width: 100%; height: auto; }
@media print {
  html { background: none; }
  body { margin: 0; padding: 0; max-width: none; box-shadow: none; font-size: 8pt; line-height: 1.26; }
  header { padding-bottom: 2mm; margin-bottom: 2mm; }
  h1 { font-size: 18pt; }
  h2 { margin: 2.1mm 0 .6mm; }
  .rounds .remark { margin: 1mm 0; padding: .8mm 2mm; }
  p { margin: 0 0 .6mm; }
  dl { grid-template-columns: max-content 1fr max-content 1fr; gap: .3mm 3mm; }
  .picture { width: 42mm; max-height: 42mm; }
  .facts li, .steps li { margin: 0 0 .3mm; }
  .rounds li { margin: 0 0 .25mm; padding-left: 4mm; }
  .rounds.long { column-gap: 6mm; }
  body.roomy { font-size: 9.2pt; line-height: 1.32; }
  .roomy .picture { width: 50mm; max-height: 50mm; }
  .roomy .rounds li { margin: 0 0 .5mm; }
}
)css";

constexpr std::string_view style_of_pieces = R"css(.rounds .piece { margin: 4mm 0 1.2mm; padding-left: 0;
  font-weight: 700; break-after: avoid; }
@media print { .rounds .piece { margin: 2mm 0 .6mm; } }
)css";

// More lines than this are set in two columns.
constexpr std::size_t long_list = 16;
// Up to so many leave the sheet room for larger print.
constexpr std::size_t roomy_list = 24;

std::string heading(std::string_view text) { return "<h2>" + xml_text(text) + "</h2>\n"; }

// Nothing at all where there is nothing to list.
std::string list(std::string_view title, std::string_view look, const std::vector<std::string>& items) {
  if (items.empty()) return {};
  std::string out = heading(title) + "<ul class=\"" + std::string(look) + "\">\n";
  for (const std::string& item : items) out += "<li>" + xml_text(item) + "</li>\n";
  return out + "</ul>\n";
}

std::string abbreviations(const knit::WrittenPattern& pattern) {
  if (pattern.abbreviations.empty()) return {};
  std::string out = heading("Abbreviations") + "<dl>\n";
  for (const auto& [word, meaning] : pattern.abbreviations)
    out += "<dt>" + xml_text(word) + "</dt><dd>" + xml_text(meaning) + "</dd>\n";
  return out + "</dl>\n";
}

using Instruction = knit::WrittenPattern::Instruction;

// A step is ticked off as a round is.
std::string_view class_of(const Instruction& instruction) {
  if (instruction.round) return "round";
  if (instruction.kind == Instruction::Kind::heading) return "piece";
  return instruction.kind == Instruction::Kind::step ? "round step" : "remark";
}

std::string instructions(const knit::WrittenPattern& pattern) {
  std::string out = "<section class=\"instructions\">\n" + heading("Instructions") + "<p class=\"start\">" +
                    xml_text(pattern.start) + "</p>\n";
  const bool is_long = pattern.instructions.size() > long_list;
  out += is_long ? "<ul class=\"rounds long\">\n" : "<ul class=\"rounds\">\n";
  for (const auto& instruction : pattern.instructions) {
    out += "<li class=\"" + std::string(class_of(instruction)) + "\">";
    out += xml_text(instruction.round ? instruction.round->text() : instruction.remark) + "</li>\n";
  }
  return out + "</ul>\n" + list("Finishing", "steps", pattern.finishing) + "</section>\n";
}

std::string chart_section(const knit::Chart& chart) {
  ChartLook look;
  const bool wide = is_wide(chart);
  look.fit_width_mm = wide ? 266.0 : 180.0;
  look.fit_height_mm = wide ? 168.0 : 246.0;
  return std::string("<section class=\"chart") + (wide ? " wide" : "") + "\">\n" + heading("Chart") +
         chart_svg(chart, look) + "</section>\n";
}

}  // namespace

std::string pattern_html(const knit::WrittenPattern& pattern, const knit::Chart& chart,
                         std::span<const std::uint8_t> picture_png) {
  const std::string title = xml_text(pattern.title);
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  out += "<title>" + title + "</title>\n<style>" + std::string(style) +
         (pattern.in_pieces ? std::string(style_of_pieces) : "") + "</style>\n</head>\n";
  out += pattern.instructions.size() <= roomy_list ? "<body class=\"roomy\">\n" : "<body>\n";
  out += "<header>\n<h1>" + title + "</h1>\n";
  if (!pattern.level.empty()) out += "<p class=\"level\">Level: " + xml_text(pattern.level) + "</p>\n";
  out += "</header>\n";
  if (!picture_png.empty())
    out += "<img class=\"picture\" alt=\"The finished object\" src=\"data:image/png;base64," +
           base64(picture_png) + "\">\n";
  out += list("Finished size", "facts", pattern.size) + list("Materials", "facts", pattern.materials);
  if (!pattern.gauge.empty()) out += heading("Gauge") + "<p>" + xml_text(pattern.gauge) + "</p>\n";
  out += abbreviations(pattern) + list("Notes", "facts", pattern.notes) + instructions(pattern);
  if (!chart.rows.empty()) out += chart_section(chart);
  return out + "</body>\n</html>\n";
}

namespace {

const knit::State& state_of(const Session& session) { return session.document->timeline.state(); }

template <class Work>
knit::WrittenPattern written(const Session& session, const Work& work) {
  const knit::Timeline& timeline = session.document->timeline;
  return knit::write_pattern(work, timeline.parameters().stitch.gauge, session.view->pattern,
                             timeline.input().mesh.name);
}

knit::WrittenPattern written(const Session& session) {
  const knit::State& state = state_of(session);
  return knit::has_limbs(state) ? written(session, knit::plan_limbs(state))
                                : written(session, knit::rounds_of(state));
}

constexpr const char* no_chart_of_pieces =
    "there is no chart for a pattern in pieces yet; save the pattern as text or as a page.";
constexpr const char* no_knitspeak_of_pieces =
    "knitspeak has no words for a pattern in pieces; save it as .txt, .md, .html or .json.";

std::string file_in_pieces(const Session& session, PatternFormat format, std::span<const std::uint8_t> png) {
  switch (format) {
    case PatternFormat::text:
      return knit::pattern_as_text(written(session));
    case PatternFormat::markdown:
      return knit::pattern_as_markdown(written(session));
    case PatternFormat::html:
      return pattern_html(written(session), {}, png);
    case PatternFormat::json:
      return pattern_json(knit::plan_limbs(state_of(session)), session.view->pattern);
    case PatternFormat::knitspeak:
      break;
  }
  return std::string(no_knitspeak_of_pieces) + "\n";
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
  if (!session.document) return "nothing is open; open a mesh to write its pattern.";
  if (session.document->timeline.state().stage() > knit::Stage::stitches) return std::nullopt;
  if (stop_shown(session) != nullptr) return "the run stopped, so there is no pattern to write.";
  return "the pattern is not there yet: not all stitches have their labels. Let the run go on to the faces.";
}

std::optional<std::string> chart_missing(const Session& session) {
  if (auto missing = pattern_missing(session)) return missing;
  if (knit::has_limbs(state_of(session))) return no_chart_of_pieces;
  return std::nullopt;
}

std::optional<std::string> format_missing(const Session& session, PatternFormat format) {
  if (auto missing = pattern_missing(session)) return missing;
  if (format == PatternFormat::knitspeak && knit::has_limbs(state_of(session))) return no_knitspeak_of_pieces;
  return std::nullopt;
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
  if (knit::has_limbs(state_of(session))) return std::string(no_chart_of_pieces) + "\n";
  const knit::Rounds rounds = knit::rounds_of(state_of(session));
  ChartLook look;
  look.title = session.view->pattern.title.empty() ? session.document->timeline.input().mesh.name
                                                   : session.view->pattern.title;
  return chart_svg(knit::chart_of(rounds), look) + "\n";
}

}  // namespace app
