#include "app/yarn/stitch_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "knit/model/label.h"
#include "knit/model/settings_table.h"

namespace app {

namespace {

// One edge of a face, between stitches by number along the knitting path.
struct FaceEdge {
  std::uint32_t from = 0, to = 0;
  std::string kind;  // "-l1"
};

bool is_loop(const std::string& kind) { return kind.find('l') != std::string::npos; }

class Writer {
 public:
  explicit Writer(const knit::Fabric& fabric) : fabric_(fabric) {
    for (const auto& row : fabric.rows()) {
      if (const knit::Strip* strip = fabric.strip_into(row->id)) add_strip(*row, *strip);
    }
    for (const auto& deal : fabric.deals()) {
      for (const knit::Face& face : deal->faces) add_bridge(face);
    }
  }

  [[nodiscard]] std::string text() const {
    std::string text = "# knit-mesh: a stitch mesh; edges of a face counter-clockwise from the bottom left\n";
    for (const std::string& kind : library_) text += "L " + kind + "\n";
    for (const glm::dvec3& place : knit::knitting_path(fabric_))
      text += "v " + knit::number_text(place.x) + " " + knit::number_text(place.y) + " " +
              knit::number_text(place.z) + "\n";
    return text + faces_ + edges_text();
  }

 private:
  void add_strip(const knit::Row& row, const knit::Strip& strip) {
    const std::uint32_t first = fabric_.first_on_path(row.id);
    const std::uint32_t end = first + static_cast<std::uint32_t>(row.stitches.size());
    const auto above = [&](std::uint32_t stitch) { return stitch >= first && stitch < end; };
    const std::set<std::array<std::uint32_t, 2>> columns(strip.column_edges.begin(),
                                                         strip.column_edges.end());
    const auto rises = [&](const FaceEdge& edge) {
      return columns.contains(std::array{edge.from, edge.to}) ||
             columns.contains(std::array{edge.to, edge.from});
    };
    for (const knit::Face& face : strip.faces) add_face(face, above, rises, knit::works_back(row));
  }

  // `rises`: whether an edge is one of the strip's column edges.
  template <class Above, class Rises>
  void add_face(const knit::Face& face, const Above& above, const Rises& rises, bool back) {
    std::vector<FaceEdge> edges;
    const auto corners = static_cast<std::size_t>(face.corner_count);
    int loops_out = 0;
    for (std::size_t i = 0; i < corners; ++i) {
      FaceEdge edge{face.corners[i], face.corners[(i + 1) % corners], ""};
      if (rises(edge)) {
        // Up on the right, down on the left; to the left the yarn comes in on the right.
        edge.kind = above(edge.to) == back ? "+y1" : "-y1";
      } else if (above(edge.from) || above(edge.to)) {
        edge.kind = "+l1";
        ++loops_out;
      } else {
        edge.kind = "-l1";
      }
      edges.push_back(std::move(edge));
    }
    auto start =
        std::find_if(edges.begin(), edges.end(), [](const FaceEdge& edge) { return edge.kind == "-l1"; });
    if (start == edges.end())
      start = std::find_if(edges.begin(), edges.end(), [&](const FaceEdge& edge) { return above(edge.to); });
    std::rotate(edges.begin(), start, edges.end());
    std::string name = "knit";
    if (knit::is_turn(face.label)) {
      name = "turn";
    } else if (corners == 3) {
      name = loops_out > 0 ? "increase" : "decrease";
    }
    put(name + (back ? "-to-right" : "-to-left"), edges);
  }

  void add_bridge(const knit::Face& face) {
    std::vector<FaceEdge> edges;
    const auto corners = static_cast<std::size_t>(face.corner_count);
    for (std::size_t i = 0; i < corners; ++i)
      edges.push_back({face.corners[i], face.corners[(i + 1) % corners], "x"});
    put("bridge", edges);
  }

  void put(std::string kind, const std::vector<FaceEdge>& edges) {
    ++face_count_;
    faces_ += "f";
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const FaceEdge& edge = edges[i];
      kind += " " + edge.kind;
      faces_ += " " + std::to_string(edge.from + 1);
      if (edge.kind != "x") sides_[std::minmax(edge.from, edge.to)].push_back({face_count_, i + 1, edge});
    }
    auto found = std::find(library_.begin(), library_.end(), kind);
    if (found == library_.end()) found = library_.insert(library_.end(), kind);
    faces_ += "\nT " + std::to_string(found - library_.begin() + 1) + "\n";
  }

  // Where a loop or the yarn goes from one face into another.
  [[nodiscard]] std::string edges_text() const {
    std::string text;
    for (const auto& [ends, sides] : sides_) {
      if (sides.size() != 2 || is_loop(sides[0].edge.kind) != is_loop(sides[1].edge.kind) ||
          sides[0].edge.kind == sides[1].edge.kind)
        continue;
      const bool turned = sides[0].edge.from == sides[1].edge.to;
      text += "e " + std::to_string(sides[0].face) + "/" + std::to_string(sides[0].number) + " " +
              std::to_string(sides[1].face) + "/" + (turned ? "-" : "") + std::to_string(sides[1].number) +
              "\n";
    }
    return text;
  }

  struct Side {
    std::size_t face = 0, number = 0;
    FaceEdge edge;
  };
  const knit::Fabric& fabric_;
  std::vector<std::string> library_;
  std::string faces_;
  std::size_t face_count_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Side>> sides_;
};

}  // namespace

std::string smobj_text(const knit::Fabric& fabric) { return Writer(fabric).text(); }

}  // namespace app
