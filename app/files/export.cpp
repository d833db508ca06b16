#include "app/files/export.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/base/files.h"
#include "app/curves/curves_file.h"
#include "app/describe/thing_places.h"
#include "app/files/card.h"
#include "app/files/gltf.h"
#include "app/files/knitted.h"
#include "app/files/pattern_export.h"
#include "app/files/plots.h"
#include "app/files/report.h"
#include "app/files/session_file.h"
#include "app/files/worksheet.h"
#include "app/session/document.h"
#include "app/session/row_table.h"
#include "app/session/shown.h"
#include "app/session/view.h"
#include "app/yarn/yarn_files.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"
#include "knit/stitches/appendix.h"

namespace app {

namespace {

std::string row_name(std::int32_t row) {
  std::array<char, 16> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "row_%03d", row);
  return buffer.data();
}

void append_vertex(std::string& text, const glm::dvec3& p) {
  text += "v " + knit::number_text(p.x) + " " + knit::number_text(p.y) + " " + knit::number_text(p.z) + "\n";
}

void append_face(std::string& text, const knit::Face& face) {
  text += "f";
  for (std::int32_t i = 0; i < face.corner_count; ++i) {
    text += " " + std::to_string(face.corners[static_cast<std::size_t>(i)] + 1);
  }
  text += "\n";
}

// Its faces once strips come to it; before there are any, the edges that it adds.
std::string deal_group(const knit::Fabric& fabric, const knit::Deal& deal, std::size_t number) {
  const std::string name = "g deal-" + std::to_string(number) + "\n";
  std::string text;
  if (is_sewn(fabric, deal)) {
    for (const knit::Face& face : deal.faces) append_face(text, face);
  } else if (fabric.strips().empty()) {
    for (const auto& edge : edges_added(deal)) {
      text += "l";
      for (const knit::StitchRef& end : edge) text += " " + std::to_string(fabric.path_index(end) + 1);
      text += "\n";
    }
  }
  return text.empty() ? text : name + text;
}

}  // namespace

std::string mesh_text_of(const knit::Fabric& fabric, std::string_view remark) {
  std::string text =
      "# knit-mesh: stitches row by row in knitting order, a group for each row with the faces below it.\n";
  text += "# A stack of closed rounds, not a helix: each round begins beside the end of the one before.\n";
  if (!fabric.deals().empty())
    text +=
        "# Where loops part or meet: the bridge's stitches after the row before, a group for each deal.\n";
  text += remark;
  for (const glm::dvec3& place : knit::knitting_path(fabric)) append_vertex(text, place);
  for (const auto& row : fabric.rows()) {
    if (const knit::Strip* strip = fabric.strip_into(row->id)) {
      text += "g " + row_name(row->id) + "\n";
      for (const knit::Face& face : strip->faces) append_face(text, face);
    } else if (fabric.strips().empty()) {
      const std::size_t first = std::size_t{fabric.first_on_path(row->id)} + 1;
      text += "g " + row_name(row->id) + "\nl " + std::to_string(first);
      for (const auto& edge : knit::edges_of(*row)) text += " " + std::to_string(first + edge.to);
      text += "\n";
    }
  }
  for (std::size_t i = 0; i < fabric.deals().size(); ++i)
    text += deal_group(fabric, *fabric.deals()[i], i + 1);
  return text;
}

std::string mesh_text(const Session& session) {
  std::string_view remark;
  if (positions_shown(session) == Positions::relaxed)
    remark = "# Stitches where they come to lie in the air.\n";
  else if (has_settled(session))
    remark = session.view->positions == Positions::placed ? "# Stitches as they were placed.\n"
                                                          : "# Stitches where they settled.\n";
  return mesh_text_of(shown_fabric(session), remark);
}

namespace {

// The deals after a row, a line each; in the map they are remarks.
std::string deal_lines(const knit::Fabric& fabric, knit::RowId after) {
  constexpr std::array<const char*, 4> words{"split", "join", "ring cast on", "graft"};
  std::string text;
  for (const auto& deal : fabric.deals()) {
    if (deal->after != after) continue;
    text += std::string("# ") + words.at(static_cast<std::size_t>(deal->kind)) + ":";
    for (const knit::TubeId tube : deal->from) text += " " + knit::tube_name(tube);
    text += " >";
    for (const knit::TubeId tube : deal->to) text += " " + knit::tube_name(tube);
    text += ", arcs " + std::to_string(deal->arcs[0]) + " and " + std::to_string(deal->arcs[1]) +
            ", bridge " + std::to_string(deal->bridge.size()) + "\n";
  }
  return text;
}

}  // namespace

std::string map_text(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  if (state.fabric.rows().empty()) return "";
  std::string text;
  const bool branches = !state.fabric.deals().empty();
  knit::RowId last = 0;
  for (const TubeLabels& tube : label_rows(state)) {
    if (branches) {
      text += deal_lines(state.fabric, last);
      text += "# tube " + knit::tube_name(tube.tube) + "\n";
    }
    for (const knit::LabelRow& row : tube.rows) text += knit::text_of(row) + "\n";
    last = tube.last;
  }
  return text + (branches ? deal_lines(state.fabric, last) : "");
}

std::string steps_text(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  std::string text;
  for (std::size_t i = 0; i < timeline.position(); ++i) {
    text += to_json(timeline.step(i), i + 1, timeline.parameters_of_step(i)).dump() + "\n";
  }
  if (const knit::Step* stop = stop_shown(session)) {
    text += to_json(*stop, timeline.position() + 1, timeline.parameters()).dump() + "\n";
  }
  return text;
}

std::string report_text(const Session& session) {
  // A file's name need not be valid UTF-8; JSON must be.
  return report_json(session).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

namespace {

using Png = std::span<const std::uint8_t>;

template <std::string (*text)(const Session&)>
std::optional<std::string> as_text(const Session& session, const std::filesystem::path& path,
                                   Png /*picture*/) {
  return write_file(path, text(session));
}

std::optional<std::string> write_session(const Session& session, const std::filesystem::path& path,
                                         Png /*picture*/) {
  return save_session(session, path);
}

std::optional<std::string> curves_missing(const Session& session) {
  if (!session.document->source.curves.empty()) return std::nullopt;
  return "The mesh is cut along no curves; give some first, as in --start circle:X,Y,Z,R.";
}

std::optional<std::string> write_curves(const Session& session, const std::filesystem::path& path,
                                        Png /*picture*/) {
  return write_file(path, curves_text(session.document->source.curves, *session.document->original));
}

std::optional<std::string> write_pattern(const Session& session, const std::filesystem::path& path,
                                         Png picture) {
  const PatternFormat format = *pattern_format_of(path);
  if (auto missing = format_missing(session, format)) return missing;
  return write_file(path, pattern_file_text(session, format, picture));
}

std::optional<std::string> write_gltf(const Session& session, const std::filesystem::path& path,
                                      Png /*picture*/) {
  return write_file(path, gltf_file(session, *gltf_format_of(path)));
}

std::optional<std::string> write_plots(const Session& session, const std::filesystem::path& path,
                                       Png /*picture*/) {
  return write_file(path, plots_file_text(session, *plots_format_of(path)));
}

std::optional<std::string> no_worksheet(const Session& /*session*/, const std::filesystem::path& path,
                                        Png /*picture*/) {
  return path.string() + " was not written: a worksheet is drawn where pictures are.";
}

std::optional<std::string> write_yarn(const Session& session, const std::filesystem::path& path,
                                      Png /*picture*/) {
  return write_file(path, yarn_file(session, *yarn_format_of(path)));
}

// By the ending: a stitch mesh, else OBJ.
std::optional<std::string> write_relaxed(const Session& session, const std::filesystem::path& path,
                                         Png /*picture*/) {
  return write_file(path, path.extension() == ".smobj" ? relaxed_smobj(session) : relaxed_text(session));
}

template <auto format_of>
bool has_format(const std::filesystem::path& path) {
  return format_of(path).has_value();
}

using About = ExportAbout;

const std::array export_table{
    ExportInfo{"session", "session", "-session.json", About::session, "write the session, to open it again",
               write_session, nullptr, ExportEndings{}, true},
    ExportInfo{"curves", "curves", ".curves.json", About::session,
               "write the curves where knitting begins and ends, for --curves", write_curves, curves_missing},
    ExportInfo{"mesh", "knit mesh", "-knit.obj", About::piece,
               "write the knit mesh as OBJ (\"-\": standard output)", as_text<mesh_text>},
    ExportInfo{"relaxed", "stuffed shape", "-relaxed.obj", About::piece,
               "write the knit mesh as it will come off the needles and be stuffed, as OBJ, or as a stitch "
               "mesh where the name ends in .smobj",
               write_relaxed, relaxed_missing},
    ExportInfo{"yarn", "yarn", "-yarn.glb", About::piece,
               "write the piece as yarn, as it will come off the needles and be stuffed", write_yarn,
               yarn_missing, ExportEndings{"yarn", yarn_endings, has_format<yarn_format_of>}},
    ExportInfo{"map", "stitch map", "-map.txt", About::figures, "write the label arrays, a row a line",
               as_text<map_text>},
    ExportInfo{"report", "report", "-report.json", About::figures, "write the report as JSON",
               as_text<report_text>},
    ExportInfo{"card", "report card", "-card.txt", About::figures, "write the report card as text",
               as_text<card_text>},
    ExportInfo{"pattern", "pattern", "-pattern.html", About::pattern, "write the knitting pattern",
               write_pattern, pattern_missing,
               ExportEndings{"a pattern", pattern_endings, has_format<pattern_format_of>}},
    ExportInfo{"chart", "chart", "-chart.svg", About::pattern, "write the chart as SVG",
               as_text<chart_file_text>, chart_missing},
    ExportInfo{"piece-chart", "chart of one piece", "-chart.svg", About::pattern,
               "write the chart of the piece that --centre chart:B chooses as SVG",
               as_text<piece_chart_file_text>, pieces_missing},
    ExportInfo{"pieces", "picture of the pieces", "-pieces.svg", About::pattern,
               "write a picture of the pieces as SVG", as_text<pieces_file_text>, pieces_missing},
    ExportInfo{"steps", "log of steps", "-steps.jsonl", About::run, "write every step as JSON, one a line",
               as_text<steps_text>},
    ExportInfo{"gltf", "knit mesh as glTF", "-knit.glb", About::piece, "write the knit mesh as glTF",
               write_gltf, gltf_missing, ExportEndings{"glTF", gltf_endings, has_format<gltf_format_of>}},
    ExportInfo{"plots", "plots", "-plots.svg", About::run, "write the report's plots", write_plots,
               plots_missing, ExportEndings{"plots", plots_endings, has_format<plots_format_of>}},
    ExportInfo{"rows", "list of rows", "-rows.csv", About::run, "write the list of rows as CSV",
               as_text<rows_csv>},
    ExportInfo{"worksheet", "worksheet of the lesson", "-worksheet.html", About::session,
               "write the lesson that --lesson opens as a page to print, with pictures and answers",
               no_worksheet, worksheet_missing,
               ExportEndings{"a worksheet", worksheet_endings, is_worksheet_name}},
    // Of the window; one of any size has a dialog of its own.
    ExportInfo{"screenshot", "", ".png", About::session, "write a picture as PNG"},
};

}  // namespace

std::span<const ExportInfo> exports() { return export_table; }

std::vector<const ExportInfo*> exports_of_menu() {
  std::vector<const ExportInfo*> listed;
  for (const ExportInfo& info : export_table) {
    if (!info.words.empty()) listed.push_back(&info);
  }
  std::stable_sort(listed.begin(), listed.end(),
                   [](const ExportInfo* a, const ExportInfo* b) { return a->about < b->about; });
  return listed;
}

const ExportInfo* find_export(std::string_view key) {
  const auto found = std::find_if(export_table.begin(), export_table.end(),
                                  [&](const ExportInfo& info) { return info.key == key; });
  return found == export_table.end() ? nullptr : &*found;
}

std::string option_of(const ExportInfo& info) {
  return (info.write != nullptr ? "--save-" : "--") + std::string(info.key);
}

std::optional<std::string> fault_of_ending(const ExportInfo& info, const std::filesystem::path& path,
                                           const std::string& blamed) {
  if (info.endings.fit == nullptr || info.endings.fit(path)) return std::nullopt;
  return blamed + "; give a name that ends in " + std::string(info.endings.words) + ".";
}

bool wants_picture(const Export& wish) {
  return wish.what == "pattern" && pattern_format_of(wish.path) == PatternFormat::html;
}

std::optional<std::string> export_to_file(const Session& session, const Export& wish,
                                          std::span<const std::uint8_t> picture_png) {
  const ExportInfo* info = find_export(wish.what);
  if (info == nullptr) return "there is nothing to save that is called \"" + wish.what + "\".";
  const std::string path = wish.path.string();
  if (!session.document) return "nothing is open, so " + path + " was not written; open a mesh first.";
  if (info->write == nullptr) return "a picture is taken by the window, not written here.";
  const std::string blamed = std::string(info->endings.what) + " cannot be written as " + path;
  if (auto fault = fault_of_ending(*info, wish.path, blamed)) return fault;
  if (info->missing != nullptr) {
    if (auto missing = info->missing(session)) return missing;
  }
  return info->write(session, wish.path, picture_png);
}

}  // namespace app
