#include "app/yarn/yarn_files.h"

#include <array>
#include <cctype>
#include <cstdio>
#include <string_view>

#include "app/base/little_endian.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "app/yarn/relaxed_piece.h"
#include "app/yarn/yarn_shape.h"

namespace app {

namespace {

void append_place(std::string& bytes, const glm::dvec3& place) {
  for (int axis = 0; axis < 3; ++axis) append_f32(bytes, static_cast<float>(place[axis]));
}
void append_chunk(std::string& bytes, std::string_view name, const std::string& data) {
  bytes += name;
  append_u32(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += data;
}

// A quadratic B-spline comes to (a + 6 b + c) / 8 where its point b rules; so b is as much beyond the curve.
glm::dvec3 spline_point(const std::vector<glm::dvec3>& places, std::size_t i) {
  if (i == 0 || i + 1 == places.size()) return places[i];
  return places[i] - (places[i - 1] - 2.0 * places[i] + places[i + 1]) / 8.0;
}

std::string place_line(const glm::dvec3& place) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "v %.7g %.7g %.7g\n", place.x, place.y, place.z);
  return text.data();
}

std::string group_name(knit::RowId row, knit::YarnPart part) {
  switch (part) {
    case knit::YarnPart::bind_off:
      return "bind_off";
    case knit::YarnPart::drawn:
      return "drawn_through";
    case knit::YarnPart::graft:
      return "graft";
    case knit::YarnPart::loop:
    case knit::YarnPart::bar:
      break;
  }
  if (row < 0) return "bridge-" + std::to_string(-row);
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "row_%03d", row);
  return text.data();
}

// What each control point's line goes by: a bar, which is lifted for a stitch above, by the row that it lies in.
std::vector<std::string> groups_of(const knit::KnittingPath& path, const knit::YarnCurve& curve) {
  std::vector<std::string> groups;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const bool bar = curve.parts[i] == knit::YarnPart::bar && i > 0;
    groups.push_back(bar ? groups.back() : group_name(path.at(curve.stitches[i]).row, curve.parts[i]));
  }
  return groups;
}

}  // namespace

std::optional<YarnFormat> yarn_format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".obj") return YarnFormat::obj;
  if (ending == ".bcc") return YarnFormat::bcc;
  if (ending == ".yarns") return YarnFormat::yarns;
  if (ending == ".glb") return YarnFormat::gltf_binary;
  if (ending == ".gltf") return YarnFormat::gltf_text;
  return std::nullopt;
}

std::optional<std::string> yarn_missing(const Session& session) {
  if (session.document->timeline.state().finished()) return std::nullopt;
  return "the piece as yarn is known when it is finished; run to the end first.";
}

std::string yarn_obj(const knit::Fabric& fabric, const knit::Yarn& yarn) {
  std::string text = "# knit-mesh: the yarn as polylines in knitting order, one a row.\n";
  if (!yarn.curves.empty()) {
    std::array<char, 64> radius{};
    std::snprintf(radius.data(), radius.size(), "# Radius of the yarn: %.7g\n", yarn.curves.front().radius);
    text += radius.data();
  }
  const knit::KnittingPath path(fabric);
  std::size_t first = 1;
  for (const knit::YarnCurve& curve : yarn.curves) {
    const std::vector<glm::dvec3> places = knit::sampled(curve, yarn_places_a_point);
    for (const glm::dvec3& place : places) text += place_line(place);
    const std::vector<std::string> groups = groups_of(path, curve);
    for (std::size_t i = 0, end = 0; i + 1 < curve.points.size(); i = end) {
      for (end = i + 1; end + 1 < curve.points.size() && groups[end] == groups[i];) ++end;
      text += "g " + groups[i] + "\nl";
      for (std::size_t k = i * yarn_places_a_point; k <= end * yarn_places_a_point; ++k)
        text += " " + std::to_string(first + k);
      text += "\n";
    }
    first += places.size();
  }
  return text;
}

std::string yarn_bcc(const knit::Yarn& yarn) {
  std::size_t points = 0;
  for (const knit::YarnCurve& curve : yarn.curves) points += curve.points.size();
  std::string bytes = "BCC";
  bytes += '\x44';  // four bytes a number, of both kinds
  bytes += "C0";    // uniform Catmull-Rom
  bytes += '\x03';  // dimensions
  bytes += '\x01';  // y is up
  append_u64(bytes, yarn.curves.size());
  append_u64(bytes, points);
  std::string about = "knit-mesh, the yarn of a knitted piece";
  about.resize(40, '\0');
  bytes += about;
  for (const knit::YarnCurve& curve : yarn.curves) {
    append_u32(bytes, static_cast<std::uint32_t>(curve.points.size()));
    for (const glm::dvec3& point : curve.points) append_place(bytes, point);
  }
  return bytes;
}

std::string yarn_yarns(const knit::Yarn& yarn) {
  std::string points, sources, infos;
  std::uint32_t count = 0;
  for (const knit::YarnCurve& curve : yarn.curves) {
    const std::uint32_t begin = count;
    const std::vector<glm::dvec3> places = knit::sampled(curve, yarn_places_a_point);
    for (std::size_t i = 0; i < places.size(); ++i) {
      append_place(points, spline_point(places, i));
      append_u32(sources, 0);  // no line of a file
      ++count;
    }
    append_u32(infos, begin);
    append_u32(infos, count);
    append_f32(infos, static_cast<float>(curve.radius));
    infos += "\xd8\xc8\xa8\xff";  // red, green, blue, opaque
  }
  std::string bytes;
  append_chunk(bytes, "f3..", points);
  append_chunk(bytes, "src.", sources);
  append_chunk(bytes, "yarn", infos);
  for (const std::string_view empty : {"strs", "unit", "chk."}) append_chunk(bytes, empty, "");
  return bytes;
}

std::string yarn_file(const Session& session, YarnFormat format) {
  const knit::Fabric fabric = relaxed_fabric(session);
  const knit::StitchSize& stitch = session.document->timeline.parameters().stitch;
  const knit::Yarn yarn = yarn_as_looked(fabric, knit::knitting_path(fabric), stitch, session.view->yarn);
  switch (format) {
    case YarnFormat::obj:
      return yarn_obj(fabric, yarn);
    case YarnFormat::bcc:
      return yarn_bcc(yarn);
    case YarnFormat::yarns:
      return yarn_yarns(yarn);
    case YarnFormat::gltf_binary:
    case YarnFormat::gltf_text:
      break;
  }
  return yarn_gltf(yarn, stitch.centimetres_per_unit / 100.0, format == YarnFormat::gltf_binary);
}

}  // namespace app
