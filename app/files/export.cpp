#include "app/files/export.h"

#include <array>
#include <cstdio>

#include "app/base/files.h"
#include "app/files/card.h"
#include "app/files/gltf.h"
#include "app/files/pattern_export.h"
#include "app/files/plots.h"
#include "app/files/report.h"
#include "app/files/session_file.h"
#include "app/session/document.h"
#include "knit/model/settings_table.h"
#include "knit/stitches/pattern.h"

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

std::string wrong_ending(const char* what, const std::filesystem::path& path, const char* endings) {
  return std::string(what) + " cannot be written as " + path.string() + "; give a name that ends in " +
         endings + ".";
}

std::optional<std::string> export_gltf(const Session& session, const std::filesystem::path& path) {
  const auto format = gltf_format_of(path);
  if (!format) return wrong_ending("glTF", path, gltf_endings);
  if (auto missing = gltf_missing(session)) return missing;
  return write_file(path, gltf_file(session, *format));
}

std::optional<std::string> export_plots(const Session& session, const std::filesystem::path& path) {
  const auto format = plots_format_of(path);
  if (!format) return wrong_ending("plots", path, plots_endings);
  if (auto missing = plots_missing(session)) return missing;
  return write_file(path, plots_file_text(session, *format));
}

}  // namespace

std::string mesh_text(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  std::string text =
      "# knit-mesh: stitches row by row in knitting order, a group for each row with the faces below it.\n";
  text += "# A stack of closed rounds, not a helix: each round begins beside the end of the one before.\n";
  for (const auto& row : state.fabric.rows()) {
    for (const knit::Stitch& stitch : row->stitches) append_vertex(text, stitch.position);
  }
  std::size_t first = 1;
  for (const auto& row : state.fabric.rows()) {
    if (const knit::Strip* strip = state.fabric.strip_into(row->id)) {
      text += "g " + row_name(row->id) + "\n";
      for (const knit::Face& face : strip->faces) append_face(text, face);
    } else if (state.fabric.strips().empty()) {
      text += "g " + row_name(row->id) + "\nl " + std::to_string(first);
      for (const auto& edge : knit::edges_of(*row)) text += " " + std::to_string(first + edge.to);
      text += "\n";
    }
    first += row->stitches.size();
  }
  return text;
}

std::string map_text(const Session& session) {
  const knit::State& state = session.document->timeline.state();
  if (state.fabric.rows().empty()) return "";
  std::string text;
  for (const knit::LabelRow& row : label_rows(state)) text += knit::text_of(row) + "\n";
  return text;
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

std::optional<std::string> export_pattern(const Session& session, const std::filesystem::path& path,
                                          std::span<const std::uint8_t> picture_png) {
  const auto format = pattern_format_of(path);
  if (!format) {
    return "a pattern cannot be written as " + path.string() + "; give a name that ends in " +
           pattern_endings + ".";
  }
  if (auto missing = pattern_missing(session)) return missing;
  return write_file(path, pattern_file_text(session, *format, picture_png));
}

std::optional<std::string> export_to_file(const Session& session, ExportKind kind,
                                          const std::filesystem::path& path) {
  if (!session.document)
    return "nothing is open, so " + path.string() + " was not written; open a mesh first.";
  switch (kind) {
    case ExportKind::mesh:
      return write_file(path, mesh_text(session));
    case ExportKind::map:
      return write_file(path, map_text(session));
    case ExportKind::report:
      return write_file(path, report_text(session));
    case ExportKind::card:
      return write_file(path, card_text(session));
    case ExportKind::pattern:
      return export_pattern(session, path);
    case ExportKind::chart:
      if (auto missing = pattern_missing(session)) return missing;
      return write_file(path, chart_file_text(session));
    case ExportKind::steps:
      return write_file(path, steps_text(session));
    case ExportKind::session:
      return save_session(session, path);
    case ExportKind::gltf:
      return export_gltf(session, path);
    case ExportKind::plots:
      return export_plots(session, path);
    case ExportKind::picture:
      break;
  }
  return "a picture is taken by the window, not written here.";
}

}  // namespace app
