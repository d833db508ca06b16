#include "knit/import/repair.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "knit/import/check.h"
#include "knit/import/check_topology.h"
#include "knit/import/quoting.h"
#include "knit/import/repair_parts.h"
#include "knit/mesh/edge_table.h"
#include "knit/mesh/union_find.h"

namespace knit {

namespace {

struct Labels {
  const char* would;
  const char* did;
};
constexpr std::array<Labels, repair_count> labels{Labels{"Drop stray vertices", "Dropped stray vertices"},
                                                  Labels{"Weld", "Welded"},
                                                  Labels{"Drop doubled faces", "Dropped doubled faces"},
                                                  Labels{"Drop fins", "Dropped fins"},
                                                  Labels{"Keep the largest piece", "Kept the largest piece"},
                                                  Labels{"Turn faces round", "Turned faces round"},
                                                  Labels{"Fill small holes", "Filled small holes"},
                                                  Labels{"Close openings flat", "Closed openings flat"}};
constexpr std::string_view piece_key = "piece-";

Effect drop_unreferenced(const Mesh& mesh) {
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const VertexId v : triangle) used[v] = 1;
  std::vector<VertexId> moved(used.size(), no_vertex);
  Effect effect{{mesh.name, {}, mesh.triangles, {}}, 0, "drops", "dropped", ""};
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    moved[v] = static_cast<VertexId>(effect.mesh.positions.size());
    effect.mesh.positions.push_back(mesh.positions[v]);
  }
  for (Triangle& triangle : effect.mesh.triangles)
    for (VertexId& v : triangle) v = moved[v];
  for (const auto& [a, b] : mesh.edges)
    if (used[a] != 0 && used[b] != 0) effect.mesh.edges.push_back({moved[a], moved[b]});
  effect.count = mesh.positions.size() - effect.mesh.positions.size();
  effect.what = counted(effect.count, "vertex that belongs", "vertices that belong") + " to no face";
  return effect;
}

// Of faces at the same three places the first stays.
Effect drop_doubles(const Mesh& mesh) {
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  std::vector<std::pair<Triangle, std::size_t>> places;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle place = twins_of(mesh.triangles[t], twin);
    std::sort(place.begin(), place.end());
    places.emplace_back(place, t);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::uint8_t> drop(mesh.triangles.size(), 0);
  std::size_t twice = 0;
  std::size_t flat = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [place, t] = places[i];
    const bool collapses = collapsed(place);
    if (!collapses && (i == 0 || places[i - 1].first != place)) continue;
    drop[t] = 1;
    ++(collapses ? flat : twice);
  }
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < drop.size(); ++t)
    if (drop[t] == 0) kept.push_back(mesh.triangles[t]);
  std::string what;
  if (twice > 0) what = counted(twice, "face that stands", "faces that stand") + " there twice";
  if (flat > 0) {
    what += (what.empty() ? "" : " and ") + counted(flat, "face", "faces") + " with two corners at one place";
  }
  return {with_triangles(mesh, std::move(kept)), twice + flat, "drops", "dropped", what};
}

// Triangles in sheets: joined across edges of at most `widest` triangles.
struct Sheets {
  std::vector<std::uint32_t> of;      // per triangle: its sheet, by its lowest triangle
  std::vector<std::uint32_t> size;    // per sheet
  std::vector<std::uint8_t> open;     // per sheet: it has an edge of its own alone
  std::vector<std::uint8_t> crowded;  // per sheet: it has an edge of three or more triangles
};

Sheets find_sheets(const Mesh& mesh, std::size_t widest) {
  const std::size_t count = mesh.triangles.size();
  const EdgeTable table = make_edge_table(mesh.triangles, find_twins(mesh.positions));
  UnionFind joined(count);
  const auto for_each_edge = [&](auto&& visit) {
    for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
      for (std::uint32_t i = table.first[v], end = i; i < table.first[v + 1]; i = end) {
        while (end < table.first[v + 1] && table.uses[end].high == table.uses[i].high) ++end;
        visit(std::span(table.uses).subspan(i, end - i));
      }
    }
  };
  for_each_edge([&](std::span<const EdgeUse> uses) {
    if (uses.size() > widest) return;
    for (const EdgeUse& use : uses) joined.join(uses[0].half_edge / 3, use.half_edge / 3);
  });
  Sheets sheets{std::vector<std::uint32_t>(count), std::vector<std::uint32_t>(count, 0),
                std::vector<std::uint8_t>(count, 0), std::vector<std::uint8_t>(count, 0)};
  for (std::size_t t = 0; t < count; ++t) {
    sheets.of[t] = static_cast<std::uint32_t>(joined.find(static_cast<std::uint32_t>(t)));
    ++sheets.size[sheets.of[t]];
  }
  for_each_edge([&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) {
      const std::uint32_t sheet = sheets.of[use.half_edge / 3];
      if (uses.size() == 1) sheets.open[sheet] = 1;
      if (uses.size() > 2) sheets.crowded[sheet] = 1;
    }
  });
  return sheets;
}

std::vector<Triangle> of_sheets(const Mesh& mesh, const Sheets& sheets,
                                const std::vector<std::uint8_t>& keep) {
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (keep[sheets.of[t]] != 0) kept.push_back(mesh.triangles[t]);
  return kept;
}

std::size_t largest_of(const Sheets& sheets) {
  return static_cast<std::size_t>(std::max_element(sheets.size.begin(), sheets.size.end()) -
                                  sheets.size.begin());
}

// A sheet with a free rim that hangs on a crowded edge. What carries it is never dropped: the largest.
Effect drop_fins(const Mesh& mesh) {
  const Sheets sheets = find_sheets(mesh, 2);
  const std::size_t largest = largest_of(sheets);
  std::vector<std::uint8_t> keep(sheets.size.size(), 1);
  std::size_t fins = 0;
  for (std::size_t s = 0; s < keep.size(); ++s) {
    if (sheets.size[s] == 0 || s == largest || sheets.open[s] == 0 || sheets.crowded[s] == 0) continue;
    keep[s] = 0;
    ++fins;
  }
  std::vector<Triangle> kept = of_sheets(mesh, sheets, keep);
  const std::size_t dropped = mesh.triangles.size() - kept.size();
  return {with_triangles(mesh, std::move(kept)), fins, "drops", "dropped",
          counted(fins, "sheet", "sheets") + " of " + counted(dropped, "triangle", "triangles") +
              (fins == 1 ? " that hangs" : " that hang") + " on an edge of three or more"};
}

// The sheets that are pieces, in the order in which pieces are counted. Triangles that collapse belong to none.
std::vector<std::uint32_t> pieces_by_size(const Mesh& mesh, const Sheets& sheets) {
  const std::vector<VertexId> twin = find_twins(mesh.positions);
  std::vector<VertexId> lowest(sheets.size.size(), no_vertex);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle corners = twins_of(mesh.triangles[t], twin);
    if (collapsed(corners)) continue;
    VertexId& least = lowest[sheets.of[t]];
    least = std::min({least, corners[0], corners[1], corners[2]});
  }
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t s = 0; s < lowest.size(); ++s)
    if (lowest[s] != no_vertex) pieces.push_back(s);
  std::stable_sort(pieces.begin(), pieces.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(sheets.size[b], lowest[a]) < std::pair(sheets.size[a], lowest[b]);
  });
  return pieces;
}

double area_of(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.positions;
  return 0.5 * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
}

// `number` from 1. Triangles that collapse go too. Nothing is done where there is one piece, or no such one.
Effect keep_piece(const Mesh& mesh, std::size_t number) {
  const Sheets sheets = find_sheets(mesh, mesh.triangles.size());
  const std::vector<std::uint32_t> pieces = pieces_by_size(mesh, sheets);
  if (pieces.size() < 2 || number > pieces.size()) return {mesh, 0, "", "", ""};
  std::vector<std::uint8_t> keep(sheets.size.size(), 0);
  keep[pieces[number - 1]] = 1;
  std::vector<Triangle> kept = of_sheets(mesh, sheets, keep);
  const std::size_t dropped = mesh.triangles.size() - kept.size();
  const std::size_t others = pieces.size() - 1;
  return {with_triangles(mesh, std::move(kept)), others, "drops", "dropped",
          counted(others, "piece", "pieces") + " of " + counted(dropped, "triangle", "triangles")};
}

Effect turn_faces(const Mesh& mesh) {
  const Topology topology = study_topology(mesh.triangles, find_twins(mesh.positions));
  Effect effect{mesh, 0, "turns", "turned", ""};
  if (!topology.crowded_edges.empty() || topology.one_sided_at != no_vertex) return effect;
  std::vector<std::uint8_t> turned(mesh.triangles.size(), 0);
  for (const std::size_t t : topology.minority) turned[t] = 1;
  const auto turn_as_said = [&] {
    effect.mesh.triangles = mesh.triangles;
    for (std::size_t t = 0; t < turned.size(); ++t)
      if (turned[t] != 0) std::swap(effect.mesh.triangles[t][1], effect.mesh.triangles[t][2]);
  };
  turn_as_said();
  if (signed_volume(effect.mesh, bounds_of_used(mesh)) < 0.0) {
    for (std::uint8_t& turn : turned) turn ^= 1;
    turn_as_said();
  }
  effect.count = static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
  effect.what = counted(effect.count, "face", "faces") + ", so that all face outwards";
  return effect;
}

Effect effect_of(const Mesh& mesh, RepairKind kind) {
  if (const std::size_t number = piece_kept(kind)) return keep_piece(mesh, number);
  switch (kind) {
    case RepairKind::unreferenced:
      return drop_unreferenced(mesh);
    case RepairKind::weld:
      return weld_near(mesh);
    case RepairKind::doubles:
      return drop_doubles(mesh);
    case RepairKind::fins:
      return drop_fins(mesh);
    case RepairKind::largest_piece:
      return keep_piece(mesh, 1);
    case RepairKind::reorient:
      return turn_faces(mesh);
    case RepairKind::holes:
      return fill_holes(mesh);
    case RepairKind::openings:
      return close_openings(mesh);
  }
  return {mesh, 0, "", "", ""};
}

}  // namespace

RepairKind keeping_piece(std::size_t number) { return static_cast<RepairKind>(repair_count + number - 1); }

std::size_t piece_kept(RepairKind kind) {
  const auto value = static_cast<std::size_t>(kind);
  return value < repair_count ? 0 : value - repair_count + 1;
}

std::string key_of(RepairKind kind) {
  if (const std::size_t number = piece_kept(kind)) return std::string(piece_key) + std::to_string(number);
  return std::string(repair_keys.at(static_cast<std::size_t>(kind)));
}

std::optional<RepairKind> repair_named(std::string_view key) {
  const auto found = std::find(repair_keys.begin(), repair_keys.end(), key);
  if (found != repair_keys.end()) return static_cast<RepairKind>(found - repair_keys.begin());
  if (!key.starts_with(piece_key)) return std::nullopt;
  const std::string_view digits = key.substr(piece_key.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  if (!whole || number < 1 || number > most_pieces) return std::nullopt;
  return keeping_piece(number);
}

Mesh with_triangles(const Mesh& mesh, std::vector<Triangle> triangles) {
  std::vector<std::uint8_t> keep(mesh.positions.size(), 1);
  for (const Triangle& triangle : mesh.triangles)
    for (const VertexId v : triangle) keep[v] = 0;
  for (const Triangle& triangle : triangles)
    for (const VertexId v : triangle) keep[v] = 1;
  Mesh changed{mesh.name, {}, std::move(triangles), {}};
  std::vector<VertexId> moved(keep.size(), no_vertex);
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (keep[v] == 0) continue;
    moved[v] = static_cast<VertexId>(changed.positions.size());
    changed.positions.push_back(mesh.positions[v]);
  }
  std::vector<std::array<VertexId, 2>> sides;
  for (Triangle& triangle : changed.triangles) {
    for (VertexId& v : triangle) v = moved[v];
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({triangle[k], triangle[(k + 1) % 3]});
  }
  sides = unique_edges(sides, changed.positions.size());
  for (const auto& [a, b] : mesh.edges) {
    if (keep[a] == 0 || keep[b] == 0) continue;
    const std::array<VertexId, 2> edge{std::min(moved[a], moved[b]), std::max(moved[a], moved[b])};
    if (std::binary_search(sides.begin(), sides.end(), edge)) changed.edges.push_back(edge);
  }
  return changed;
}

Repaired repair(const Mesh& mesh, RepairKind kind) {
  Effect effect = effect_of(mesh, kind);
  if (effect.count == 0) return {mesh, {kind, 0, "", ""}};
  const std::size_t number = piece_kept(kind);
  const std::string piece = number > 0 ? " piece " + std::to_string(number) : "";
  const Labels label = number > 0 ? Labels{"Keep", "Kept"} : labels.at(static_cast<std::size_t>(kind));
  return {std::move(effect.mesh),
          {kind, effect.count, label.would + piece + ": " + effect.verb + " " + effect.what + ".",
           label.did + piece + ": " + effect.past + " " + effect.what + "."}};
}

// Which repairs help: tried in their order, each kept only where the check finds less wrong after it.

namespace {

bool has(const CheckResult& result, FindingKind kind) {
  return std::any_of(result.findings.begin(), result.findings.end(),
                     [&](const Finding& finding) { return finding.kind == kind; });
}

// Nothing here can make these fit.
bool beyond_repair(const CheckResult& result) {
  return has(result, FindingKind::no_triangles) || has(result, FindingKind::index_out_of_range) ||
         has(result, FindingKind::no_extent);
}

bool is_about(RepairKind kind, const CheckResult& wrong) {
  if (piece_kept(kind) > 0) return has(wrong, FindingKind::several_pieces);
  switch (kind) {
    case RepairKind::unreferenced:
      return has(wrong, FindingKind::not_finite);
    case RepairKind::weld:
      return has(wrong, FindingKind::open_edges) || has(wrong, FindingKind::several_pieces);
    case RepairKind::doubles:
    case RepairKind::fins:
      return has(wrong, FindingKind::edge_not_manifold);
    case RepairKind::largest_piece:
      return has(wrong, FindingKind::several_pieces);
    case RepairKind::reorient:  // filling goes round a hole as the faces at its rim do
      return has(wrong, FindingKind::open_edges) && has(wrong, FindingKind::flipped_faces);
    case RepairKind::holes:
    case RepairKind::openings:
      return has(wrong, FindingKind::open_edges);
  }
  return false;
}

// How much is wrong; what hides the rest is more than all of it.
std::size_t badness(const CheckResult& result) {
  if (has(result, FindingKind::not_finite)) return std::numeric_limits<std::size_t>::max();
  std::size_t sum = 0;
  for (const Finding& finding : result.findings)
    if (finding.severity == Severity::error) sum += finding.count;
  return sum;
}

// What every repair but dropping strays relies on.
bool is_in_range(const Mesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return std::max({t[0], t[1], t[2]}) < mesh.positions.size();
  });
}

bool is_finite(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

// Each kind once, as they are carried out; the piece that is asked for before the largest.
std::vector<RepairKind> in_order(const std::vector<RepairKind>& kinds) {
  const auto last = static_cast<std::size_t>(RepairKind::largest_piece);
  std::vector<RepairKind> ordered;
  for (std::size_t i = 0; i < repair_count; ++i) {
    for (const RepairKind kind : kinds)
      if (i == last && piece_kept(kind) > 0) ordered.push_back(kind);
    const auto kind = static_cast<RepairKind>(i);
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) ordered.push_back(kind);
  }
  return ordered;
}

// All that may help, with that piece (0: the largest) to be kept.
std::vector<RepairKind> every_kind(std::size_t piece) {
  std::vector<RepairKind> kinds;
  for (std::size_t i = 0; i < repair_count; ++i) {
    const auto kind = static_cast<RepairKind>(i);
    kinds.push_back(kind == RepairKind::largest_piece && piece > 0 ? keeping_piece(piece) : kind);
  }
  return kinds;
}

// Where no repair alone makes it better, all of them together may: welding closes a crack and leaves faces twice, which
// the next one drops. Then those are left out, last first, without which it is fit too. At most twice as many repairs as
// there are kinds for each kind.
std::optional<RepairPlan> plan_together(const Mesh& mesh, std::size_t piece) {
  RepairPlan plan = carry_out(mesh, every_kind(piece));
  if (!check(plan.mesh).fit()) return std::nullopt;
  std::vector<RepairKind> kinds = plan.kinds();
  for (std::size_t i = kinds.size(); i-- > 0;) {
    std::vector<RepairKind> fewer = kinds;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    RepairPlan tried = carry_out(mesh, fewer);
    if (!check(tried.mesh).fit()) continue;
    kinds = std::move(fewer);
    plan = std::move(tried);
  }
  const auto keeps = std::find_if(kinds.begin(), kinds.end(), [](RepairKind kind) {
    return kind == RepairKind::largest_piece || piece_kept(kind) > 0;
  });
  if (keeps != kinds.end()) plan.pieces = piece_shares(carry_out(mesh, {kinds.begin(), keeps}).mesh);
  return plan;
}

}  // namespace

std::size_t RepairWish::piece() const {
  for (const RepairKind kind : kinds)
    if (const std::size_t number = piece_kept(kind)) return number;
  return 0;
}

std::vector<RepairKind> RepairPlan::kinds() const {
  std::vector<RepairKind> all;
  for (const RepairStep& step : steps) all.push_back(step.kind);
  return all;
}

std::optional<RepairPlan> plan_repairs(const Mesh& mesh, std::size_t piece) {
  CheckResult wrong = check(mesh);
  if (wrong.fit() || beyond_repair(wrong)) return std::nullopt;
  RepairPlan plan{mesh, {}, {}};
  for (const RepairKind kind : every_kind(piece)) {
    if (!is_about(kind, wrong)) continue;
    if (kind != RepairKind::unreferenced && has(wrong, FindingKind::not_finite)) return std::nullopt;
    Repaired repaired = repair(plan.mesh, kind);
    if (repaired.step.count == 0) continue;
    CheckResult after = check(repaired.mesh);
    const bool prepares = kind == RepairKind::reorient;
    if (!prepares && badness(after) >= badness(wrong)) continue;
    if (kind == RepairKind::largest_piece || piece_kept(kind) > 0) plan.pieces = piece_shares(plan.mesh);
    plan.mesh = std::move(repaired.mesh);
    plan.steps.push_back(std::move(repaired.step));
    wrong = std::move(after);
    if (wrong.fit()) return plan;
  }
  return plan_together(mesh, piece);
}

RepairPlan carry_out(const Mesh& mesh, const std::vector<RepairKind>& kinds) {
  RepairPlan plan{mesh, {}, {}};
  if (mesh.triangles.empty() || !is_in_range(mesh)) return plan;
  for (const RepairKind kind : in_order(kinds)) {
    if (kind != RepairKind::unreferenced && !is_finite(plan.mesh)) break;
    Repaired repaired = repair(plan.mesh, kind);
    if (repaired.step.count == 0) continue;
    plan.mesh = std::move(repaired.mesh);
    plan.steps.push_back(std::move(repaired.step));
  }
  return plan;
}

std::vector<PieceShare> piece_shares(const Mesh& mesh) {
  const Sheets sheets = find_sheets(mesh, mesh.triangles.size());
  std::vector<double> area(sheets.size.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    area[sheets.of[t]] += area_of(mesh, mesh.triangles[t]);
  std::vector<PieceShare> shares;
  double whole = 0.0;
  for (const std::uint32_t piece : pieces_by_size(mesh, sheets)) {
    shares.push_back({sheets.size[piece], area[piece]});
    whole += area[piece];
  }
  for (PieceShare& piece : shares) piece.share = whole > 0.0 ? piece.share / whole : 0.0;
  return shares;
}

std::size_t pieces_to_choose(const Mesh& mesh, const RepairWish& wish) {
  std::vector<RepairKind> before;
  for (const RepairKind kind : wish.kinds)
    if (kind < RepairKind::largest_piece) before.push_back(kind);
  const auto plan = wish.all ? plan_repairs(mesh, wish.piece()) : std::nullopt;
  if (plan) {
    for (const RepairKind kind : plan->kinds())
      if (kind < RepairKind::largest_piece) before.push_back(kind);
  }
  const Mesh repaired = carry_out(mesh, before).mesh;
  if (repaired.triangles.empty() || !is_in_range(repaired) || !is_finite(repaired)) return 0;
  return pieces_by_size(repaired, find_sheets(repaired, repaired.triangles.size())).size();
}

}  // namespace knit
