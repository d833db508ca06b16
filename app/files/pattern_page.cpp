#include "app/files/pattern_page.h"

#include <string_view>
#include <utility>

#include "app/base/text.h"
#include "app/files/chart_svg.h"
#include "knit/pattern/written_parts.h"

namespace app {

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
@media screen { .chart { margin-top: 7mm; } }
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
.rounds .remark { break-inside: avoid; }
.step .item { display: block; padding-left: 4mm; }
.pieces { clear: both; }
.pieces tr { break-inside: avoid; }
.pieces td:nth-child(n+3):nth-child(-n+6) { white-space: nowrap; }
.pieces svg { display: block; break-inside: avoid; margin: 2mm auto; max-width: 100%; height: auto; }
.pieces table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
.pieces th { text-align: left; font-weight: 600; color: #666; }
.pieces th, .pieces td { padding: .5mm 2.5mm .5mm 0; vertical-align: top; border-bottom: .2mm solid #ddd; }
.pieces td:first-child { font-weight: 600; }
.sheet { text-align: center; }
.sheet:not(.wide) { break-before: auto; }
.sheet:not(.wide) h2 { margin-top: 5mm; }
.sheet svg { display: inline-block; margin: 0; max-width: 100%; break-inside: avoid; vertical-align: top; }
@media print {
  .rounds .piece { margin: 2mm 0 .6mm; }
  .pieces th, .pieces td { padding: .2mm 2mm .2mm 0; }
  .pieces svg { max-height: 88mm; margin: 1mm auto; }
}
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

// Of a long step each item is a line of its own.
std::string words_of(const Instruction& instruction) {
  if (instruction.round) return xml_text(instruction.round->text());
  if (!knit::is_told_by_items(instruction)) return xml_text(instruction.remark);
  const std::vector<std::string> items = knit::items_of_step(instruction.remark);
  std::string out = xml_text(items.front());
  for (std::size_t i = 1; i < items.size(); ++i)
    out += " <span class=\"item\">" + xml_text(items[i]) + "</span>";
  return out;
}

std::string instructions(const knit::WrittenPattern& pattern) {
  std::string out = "<section class=\"instructions\">\n" + heading("Instructions") + "<p class=\"start\">" +
                    xml_text(pattern.start) + "</p>\n";
  const bool is_long = pattern.instructions.size() > long_list;
  out += is_long ? "<ul class=\"rounds long\">\n" : "<ul class=\"rounds\">\n";
  for (std::size_t i = pattern.overview; i < pattern.instructions.size(); ++i) {
    const Instruction& instruction = pattern.instructions[i];
    out += "<li class=\"" + std::string(class_of(instruction)) + "\">" + words_of(instruction) + "</li>\n";
  }
  return out + "</ul>\n" + list("Finishing", "steps", pattern.finishing) + "</section>\n";
}

// The list of pieces and their picture.
std::string pieces_section(const knit::WrittenPattern& pattern, const std::string& picture_svg) {
  if (pattern.pieces.empty()) return {};
  std::string out =
      "<section class=\"pieces\">\n" + heading("Pieces, in working order") +
      "<table>\n<tr><th>Piece</th><th>Begins</th><th>Rnds</th><th>Sts at the end</th><th>Long</th>"
      "<th>Around</th><th>Ends</th></tr>\n";
  const auto cell = [](const std::string& words) { return "<td>" + xml_text(words) + "</td>"; };
  for (const knit::PieceFacts& facts : pattern.pieces) {
    const std::size_t made = facts.pieces.size();
    out += "<tr>" + cell(facts.name + (made > 1 ? " (make " + std::to_string(made) + ")" : "")) +
           cell(facts.begins) + cell(std::to_string(facts.rounds)) + cell(std::to_string(facts.last)) +
           cell(knit::length_text(facts.long_cm)) + cell(knit::length_text(facts.around_cm)) +
           cell(facts.ends) + "</tr>\n";
  }
  return out + "</table>\n" + picture_svg + "</section>\n";
}

std::string charts_section(const PiecesArt& art) {
  if (art.chart_svgs.empty()) return {};
  std::string out =
      std::string("<section class=\"chart sheet") + (art.wide ? " wide" : "") + "\">\n" + heading("Charts");
  for (const std::string& svg : art.chart_svgs) out += svg;
  return out + "</section>\n";
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

namespace {

std::string head_of_page(const knit::WrittenPattern& pattern) {
  const std::string title = xml_text(pattern.title);
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  out += "<title>" + title + "</title>\n<style>" + std::string(style) +
         (pattern.in_pieces ? std::string(style_of_pieces) : "") + "</style>\n</head>\n";
  out += pattern.instructions.size() <= roomy_list ? "<body class=\"roomy\">\n" : "<body>\n";
  out += "<header>\n<h1>" + title + "</h1>\n";
  if (!pattern.level.empty()) out += "<p class=\"level\">Level: " + xml_text(pattern.level) + "</p>\n";
  return out + "</header>\n";
}

// `pieces` stands before the instructions, `charts` at the end.
std::string whole_page(const knit::WrittenPattern& pattern, const std::string& pieces,
                       const std::string& charts, std::span<const std::uint8_t> picture_png) {
  std::string out = head_of_page(pattern);
  if (!picture_png.empty())
    out += "<img class=\"picture\" alt=\"The finished object\" src=\"data:image/png;base64," +
           base64(picture_png) + "\">\n";
  out += list("Finished size", "facts", pattern.size) + list("Materials", "facts", pattern.materials);
  if (!pattern.gauge.empty()) out += heading("Gauge") + "<p>" + xml_text(pattern.gauge) + "</p>\n";
  out += abbreviations(pattern) + list("Notes", "facts", pattern.notes) + pieces + instructions(pattern);
  return out + charts + "</body>\n</html>\n";
}

}  // namespace

std::string pattern_html(const knit::WrittenPattern& pattern, const knit::Chart& chart,
                         std::span<const std::uint8_t> picture_png) {
  return whole_page(pattern, pieces_section(pattern, {}), chart.rows.empty() ? "" : chart_section(chart),
                    picture_png);
}

std::string pattern_html(const knit::WrittenPattern& pattern, const PiecesArt& art,
                         std::span<const std::uint8_t> picture_png) {
  return whole_page(pattern, pieces_section(pattern, art.picture_svg), charts_section(art), picture_png);
}

}  // namespace app
