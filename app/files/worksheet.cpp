#include "app/files/worksheet.h"

#include <algorithm>
#include <string_view>

#include "app/base/text.h"
#include "app/session/learning.h"

namespace app {

namespace {

constexpr std::string_view sheet_style = R"css(
@page { size: A4 portrait; margin: 14mm 15mm; }
* { box-sizing: border-box; }
html { background: #e9e7e3; }
body { font: 10.5pt/1.45 Inter, "Helvetica Neue", Helvetica, Arial, sans-serif; color: #1d1d1f;
  background: #fff; max-width: 210mm; margin: 8mm auto; padding: 16mm 15mm; box-shadow: 0 1mm 4mm #0003;
  -webkit-print-color-adjust: exact; print-color-adjust: exact; }
header { border-bottom: .6mm solid #1d1d1f; padding-bottom: 3mm; margin-bottom: 5mm; }
h1 { font: 600 20pt/1.15 Georgia, "Times New Roman", serif; margin: 0; overflow-wrap: anywhere; }
.about { margin: 1.5mm 0 0; color: #555; }
.who { display: flex; gap: 8mm; margin-top: 4mm; color: #555; }
.who span { flex: 2; border-bottom: .2mm solid #777; padding-bottom: .5mm; }
.who span + span { flex: 1; }
section { break-inside: avoid; display: grid; grid-template-columns: 1fr 78mm; gap: 0 6mm; margin: 0 0 7mm; }
section.plain { display: block; }
h2 { font-size: 11.5pt; line-height: 1.3; margin: 0 0 1mm; }
.number { color: #8a3d6d; margin-right: 2mm; }
p { margin: 0 0 1.5mm; }
img { width: 78mm; border: .2mm solid #bbb; }
.task { border-left: .8mm solid #8a3d6d; padding-left: 2.5mm; }
.ask { font-weight: 600; }
ul { list-style: none; margin: 0 0 1.5mm; padding: 0; }
li { margin: 0 0 .8mm; padding-left: 6mm; position: relative; }
.choices li::before { content: ""; position: absolute; left: 0; top: .25em; width: .8em; height: .8em;
  border: .25mm solid #555; border-radius: .5mm; }
.line { border-bottom: .2mm solid #777; height: 8mm; }
.answers { break-before: page; display: block; }
.answers h1 { margin-bottom: 5mm; }
.answers dt { font-weight: 600; margin-top: 3mm; break-after: avoid; }
.answers dd { margin: .5mm 0 0; break-inside: avoid; }
.answers dd p { margin: 0; color: #444; }
@media print {
  html { background: none; }
  body { margin: 0; padding: 0; max-width: none; box-shadow: none; font-size: 9.5pt; }
}
)css";

constexpr int task_lines = 2, answer_lines = 2;

std::string tagged(std::string_view tag, std::string_view look, std::string_view words) {
  const std::string name(tag);
  const std::string opening = look.empty() ? name : name + attribute("class", look);
  return "<" + opening + ">" + xml_text(words) + "</" + name + ">\n";
}

std::string lines_to_write_on(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += "<div class=\"line\"></div>\n";
  return out;
}

std::string question_part(const SheetQuestion& question) {
  std::string out = tagged("p", "ask", question.ask);
  if (question.marked) out += tagged("p", "", "Mark it in the picture.");
  if (question.choices.empty()) return out + lines_to_write_on(question.marked ? 1 : answer_lines);
  out += "<ul class=\"choices\">\n";
  for (const std::string& choice : question.choices) out += tagged("li", "", choice);
  return out + "</ul>\n" + tagged("p", "", "Because:") + lines_to_write_on(1);
}

std::string heading_of(const SheetPage& page, std::size_t number) {
  return "<span class=\"number\">" + std::to_string(number) + "</span>" + xml_text(page.title);
}

std::string page_part(const SheetPage& page, std::size_t number) {
  const bool plain = page.picture_png.empty();
  std::string out = plain ? "<section class=\"plain\">\n<div>\n" : "<section>\n<div>\n";
  out += "<h2>" + heading_of(page, number) + "</h2>\n" + tagged("p", "", page.text);
  if (!page.task.empty()) out += tagged("p", "task", page.task) + lines_to_write_on(task_lines);
  if (page.question) out += question_part(*page.question);
  out += "</div>\n";
  if (!plain)
    out += "<img alt=\"" + xml_text(page.title) + "\" src=\"data:image/png;base64," +
           base64(page.picture_png) + "\">\n";
  return out + "</section>\n";
}

std::string answers_part(const Worksheet& sheet) {
  std::string list;
  for (std::size_t i = 0; i < sheet.pages.size(); ++i) {
    const SheetPage& page = sheet.pages[i];
    if (!page.question) continue;
    list += "<dt>" + heading_of(page, i + 1) + "</dt>\n<dd>" + xml_text(page.question->answer) +
            tagged("p", "", page.question->reason) + "</dd>\n";
  }
  if (list.empty()) return list;
  return "<section class=\"answers\">\n" + tagged("h1", "", "Answers: " + sheet.title) + "<dl>\n" + list +
         "</dl>\n</section>\n";
}

}  // namespace

std::string worksheet_html(const Worksheet& sheet) {
  const std::string title = xml_text(sheet.title);
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      title + "</title>\n<style>" + std::string(sheet_style) + "</style>\n</head>\n<body>\n<header>\n<h1>" +
      title + "</h1>\n";
  if (!sheet.about.empty()) out += tagged("p", "about", sheet.about);
  out += "<div class=\"who\"><span>Name</span><span>Date</span></div>\n</header>\n";
  for (std::size_t i = 0; i < sheet.pages.size(); ++i) out += page_part(sheet.pages[i], i + 1);
  return out + answers_part(sheet) + "</body>\n</html>\n";
}

bool is_worksheet_name(const std::filesystem::path& path) { return path.extension() == ".html"; }

std::optional<std::string> worksheet_missing(const Session& session) {
  if (session.learning->lesson) return std::nullopt;
  return "there is no worksheet, because no lesson is open; begin one with the menu Learn or --lesson.";
}

}  // namespace app
