#include "app/window/worksheet.h"

#include <variant>
#include <vector>

#include "app/actions/worksheet_pages.h"
#include "app/base/files.h"
#include "app/files/worksheet.h"
#include "app/render/gl_handle.h"
#include "app/render/headless_gl.h"
#include "app/session/program.h"

namespace app {

namespace {

constexpr int sheet_picture_px = 880;  // wide

std::vector<std::uint8_t> sheet_picture(Session& session, FrameDrawer& drawer) {
  FigureShape shape;
  shape.width = sheet_picture_px;
  shape.height = static_cast<int>(sheet_picture_px / sheet_picture_aspect);
  return png_bytes(drawer.figure(session, shape));
}

}  // namespace

std::optional<std::string> save_worksheet(const Session& session, const std::filesystem::path& path,
                                          FrameDrawer& drawer) {
  if (auto missing = worksheet_missing(session)) return missing;
  const auto take_picture = [&](Session& page) { return sheet_picture(page, drawer); };
  return write_file(path, worksheet_html(worksheet_of(session, take_picture)));
}

std::optional<std::string> save_worksheet_headless(const Session& session, const std::filesystem::path& path,
                                                   std::string& note) {
  if (auto missing = worksheet_missing(session)) return missing;
  const auto without = [&](const std::string& why) {
    note = why + " The worksheet is written without pictures.";
    const auto no_picture = [](Session& /*page*/) { return std::vector<std::uint8_t>(); };
    return write_file(path, worksheet_html(worksheet_of(session, no_picture)));
  };
  auto opened = HeadlessGl::open();
  if (const auto* error = std::get_if<std::string>(&opened)) return without(*error);
  try {
    FrameDrawer drawer(session.program->assets);
    return save_worksheet(session, path, drawer);
  } catch (const GlError& error) {
    return without(error.what());
  }
}

}  // namespace app
