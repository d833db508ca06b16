#include "knit/import/obj.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <stdexcept>
#include <streambuf>
#include <system_error>
#include <utility>

#ifndef TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_USE_DOUBLE
#endif
#include <tiny_obj_loader.h>

#include "knit/import/obj_scan.h"
#include "knit/import/quoting.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/polygon.h"

namespace knit {

namespace {

// A larger file would take the memory of a small computer several times over; five million triangles with all that
// can be said about them take half of this.
constexpr std::uintmax_t most_bytes = 1'000'000'000;

std::string gigabytes(std::uintmax_t bytes) {
  const std::uintmax_t tenths = (bytes + 50'000'000) / 100'000'000;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}
// Of reading a large file, about: what is done after its text is there, looked through, and understood.
constexpr double share_read = 0.1, share_scanned = 0.25, share_parsed = 0.85;

// A stream over text that is already in memory, without a copy.
class TextBuffer : public std::streambuf {
 public:
  TextBuffer(char* begin, char* end) { setg(begin, begin, end); }
};

// The file's faces as they stand, zero-based. Filled by tinyobjloader's callbacks: unlike its arrays, they
// keep polygons of any size whole and drop nothing.
struct Polygons {
  std::vector<glm::dvec3> positions;
  std::vector<VertexId> corners;
  std::vector<std::uint32_t> first{0};  // polygon i has corners [first[i], first[i + 1])
  PartProgress progress;
  std::size_t expected = 0;  // positions and corners, all together
  void tell() { progress.at(positions.size() + corners.size(), expected); }
};

void take_vertex(void* polygons, double x, double y, double z, double /*w*/) {
  auto& known = *static_cast<Polygons*>(polygons);
  known.positions.emplace_back(x, y, z);
  known.tell();
}

// The scan has seen to it that every index is in range and a face has three corners.
void take_face(void* user, tinyobj::index_t* indices, int count) {
  Polygons& polygons = *static_cast<Polygons*>(user);
  const auto known = static_cast<int>(polygons.positions.size());
  for (int i = 0; i < count; ++i) {
    const int index = indices[i].vertex_index;
    polygons.corners.push_back(static_cast<VertexId>(index < 0 ? known + index : index - 1));
  }
  polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  polygons.tell();
}

Mesh mesh_of(Polygons polygons, const std::string& name, PartProgress progress) {
  Mesh mesh;
  mesh.name = name;
  mesh.positions = std::move(polygons.positions);
  const std::span<const VertexId> corners(polygons.corners);
  mesh.triangles.reserve(corners.size() - 2 * (polygons.first.size() - 1));
  std::vector<std::array<VertexId, 2>> edges;
  edges.reserve(corners.size());
  for (std::size_t i = 0; i + 1 < polygons.first.size(); ++i) {
    const auto polygon = corners.subspan(polygons.first[i], polygons.first[i + 1] - polygons.first[i]);
    progress.at(i, polygons.first.size());
    triangulate(polygon, mesh.positions, mesh.triangles);
    for (std::size_t k = 0; k < polygon.size(); ++k)
      edges.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  }
  mesh.edges = unique_edges(edges, mesh.positions.size());
  return mesh;
}

// `file` is what messages call it, `name` what the mesh is called.
std::variant<Mesh, ObjError> parse(std::string text, const std::string& file, const std::string& name,
                                   Progress* progress, ObjNotes* notes) {
  const ObjScan scan = scan_obj(text, {progress, share_read, share_scanned});
  if (!scan.error.empty()) return ObjError{file + scan.error};
  if (notes != nullptr) *notes = {scan.loose_edges, scan.loose_line};

  Polygons polygons{.progress = {progress, share_scanned, share_parsed},
                    .expected = scan.vertices + scan.corners};
  polygons.positions.reserve(scan.vertices);
  polygons.corners.reserve(scan.corners);
  polygons.first.reserve(scan.faces + 1);
  TextBuffer buffer(text.data() + scan.skip, text.data() + text.size());
  std::istream in(&buffer);
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = take_vertex;
  callbacks.index_cb = take_face;
  tinyobj::LoadObjWithCallback(in, callbacks, &polygons);
  if (polygons.positions.size() != scan.vertices || polygons.corners.size() != scan.corners ||
      polygons.first.size() != scan.faces + 1) {
    return ObjError{
        file + ": tinyobjloader reads other vertices or faces than the file has. Export the mesh again."};
  }
  text = std::string();
  return mesh_of(std::move(polygons), name, {progress, share_parsed, 1.0});
}

std::variant<Mesh, ObjError> read(std::istream& in, const std::string& file, const std::string& name,
                                  std::size_t expected, Progress* progress, ObjNotes* notes) {
  try {
    if (progress != nullptr) progress->begin(Progress::Task::reading);
    std::string text;
    constexpr std::size_t least = 4096, most = std::size_t{16} << 20;
    text.reserve(expected);
    std::size_t size = 0;
    do {
      const std::size_t left = size < expected ? expected - size : std::max(size, least);
      const std::size_t wanted = std::min(left, most);
      text.resize(size + wanted);
      in.read(text.data() + size, static_cast<std::streamsize>(wanted));
      size += static_cast<std::size_t>(in.gcount());
      // A file may grow while it is read.
      if (size > most_bytes) return ObjError{file + " has more than 1 GB. Reduce the mesh to fewer faces."};
      if (progress != nullptr)
        progress->at(share_read * static_cast<double>(size) / static_cast<double>(std::max(size, expected)));
    } while (in);
    if (in.bad())
      return ObjError{file + " cannot be read to its end. Check the disk or copy the file elsewhere."};
    text.resize(size);
    return parse(std::move(text), file, name, progress, notes);
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return ObjError{file + " does not fit into memory. Reduce the mesh and open it again."};
}

}  // namespace

std::variant<Mesh, ObjError> read_obj(std::istream& in, const std::string& name, Progress* progress,
                                      ObjNotes* notes) {
  return read(in, name, name, 0, progress, notes);
}

std::variant<Mesh, ObjError> read_obj_file(const std::filesystem::path& path, Progress* progress,
                                           ObjNotes* notes) {
  const std::string file = printable(path.string());
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  switch (status.type()) {
    case std::filesystem::file_type::regular:
      break;
    case std::filesystem::file_type::not_found:
      return ObjError{file + " does not exist. Check the path."};
    case std::filesystem::file_type::directory:
      return ObjError{file + " is a folder. Name an OBJ file in it."};
    case std::filesystem::file_type::none:
    case std::filesystem::file_type::unknown:
      return ObjError{file + " cannot be reached (" + error.message() +
                      "). Check the path and its permissions."};
    default:
      return ObjError{file + " is no ordinary file. Save the mesh to a file and open that."};
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > most_bytes) {
    return ObjError{file + " has " + gigabytes(size) +
                    "; at most 1 GB is read. Reduce the mesh to fewer faces and open it again."};
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    const int reason = errno;
    if (reason == ENOENT) return ObjError{file + " does not exist any more. Check the path."};
    return ObjError{file + " cannot be opened (" + std::generic_category().message(reason) +
                    "). Check its permissions."};
  }
  // One byte more than the file has, so that its end is met in the first read.
  return read(in, file, printable(path.stem().string()), error ? 0 : static_cast<std::size_t>(size) + 1,
              progress, notes);
}

}  // namespace knit
