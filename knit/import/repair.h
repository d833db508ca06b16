// Repairs for a mesh that the method cannot take as it is. Each is a pure function that says in words and numbers
// what it does; nothing here is done unless somebody asks for it.
//
// A repair that finds nothing to do gives the mesh back as it was, with count 0. Order is kept: vertices and
// triangles that stay come in the order in which they were. Lengths are in mesh units.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knit/mesh/mesh.h"

namespace knit {

// In the order in which they are carried out: each may rely on those before it.
enum class RepairKind : std::uint16_t {
  unreferenced,   // drops vertices that belong to no face
  weld,           // merges vertices a hair apart, so that a crack closes
  doubles,        // drops faces that stand there twice, and those with two corners at one place
  fins,           // drops sheets that hang on an edge of three or more triangles
  largest_piece,  // keeps the piece of most triangles
  reorient,       // turns faces so that all face outwards
  holes,          // fills small holes
  openings,       // closes large ones flat: the rim of a cup, of a hat, of a scan that stood on a table
};
inline constexpr std::size_t repair_count = 8;
// What scripts and session files call them, and what buttons do.
inline constexpr std::array<std::string_view, repair_count> repair_keys{
    "unreferenced", "weld", "doubles", "fins", "largest-piece", "reorient", "holes", "openings"};
// Beside these there is a kind for each piece that may be kept instead of the largest, at its place in the order:
// "piece-2". Pieces are counted from 1 by their triangles, most first; of equal ones the one with the lowest vertex.
inline constexpr std::size_t most_pieces = 9999;
RepairKind keeping_piece(std::size_t number);
std::size_t piece_kept(RepairKind kind);  // 0: it is about something else

std::string key_of(RepairKind kind);
std::optional<RepairKind> repair_named(std::string_view key);

// Two vertices this near each other, as a part of the mesh's diagonal, are one to `weld`.
inline constexpr double weld_reach = 1e-5;
// A hole is small when it is no longer round than this part of the mesh's diagonal, else an opening: whoever made the
// mesh may have meant it.
inline constexpr double small_hole = 0.5;

// One repair, with its numbers in words.
struct RepairStep {
  RepairKind kind{};
  std::size_t count = 0;  // of what it is about: vertices, faces, pieces or holes
  std::string would;      // "Keep the largest piece: drops 2 pieces of 40 triangles."
  std::string did;        // "Kept the largest piece: dropped 2 pieces of 40 triangles."
};

struct Repaired {
  Mesh mesh;
  RepairStep step;
};
// Requires at least one triangle and indices in range; `unreferenced` alone may be given coordinates that are no numbers.
Repaired repair(const Mesh& mesh, RepairKind kind);

// One of the pieces that a mesh is in.
struct PieceShare {
  std::size_t triangles = 0;
  double share = 0.0;  // of the area of all pieces
};
// In the order in which they are counted. Requires indices in range and coordinates that are numbers.
std::vector<PieceShare> piece_shares(const Mesh& mesh);

struct RepairPlan {
  Mesh mesh;                       // repaired
  std::vector<RepairStep> steps;   // that did something, in their order
  std::vector<PieceShare> pieces;  // there were before one was kept; empty: none had to be chosen
  [[nodiscard]] std::vector<RepairKind> kinds() const;
};
// What a person asks for: these; or whichever are needed, of which only a piece to keep may be among `kinds`.
struct RepairWish {
  bool all = false;
  std::vector<RepairKind> kinds;
  [[nodiscard]] std::size_t piece() const;  // to be kept; 0: none by its number
  [[nodiscard]] bool any() const { return all || !kinds.empty(); }
};
// The repairs that make an unfit mesh fit (check.h); none where it is fit already or where they would not do. Of
// several pieces it keeps that one; 0: the largest.
std::optional<RepairPlan> plan_repairs(const Mesh& mesh, std::size_t piece = 0);
// Exactly these, each once, in their order, whether they are needed or not. Indices need not be in range: then
// nothing is done.
RepairPlan carry_out(const Mesh& mesh, const std::vector<RepairKind>& kinds);
// How many pieces there are to choose from when the repairs before that choice have been carried out; 0: none of it
// can be said.
std::size_t pieces_to_choose(const Mesh& mesh, const RepairWish& wish);

}  // namespace knit
