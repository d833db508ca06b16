// Which mends help: tried in their order, each kept only where the check finds less wrong after it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "knit/check.h"
#include "knit/mend.h"

namespace knit {

namespace {

bool has(const CheckResult& result, FindingKind kind) {
  return std::any_of(result.findings.begin(), result.findings.end(),
                     [&](const Finding& finding) { return finding.kind == kind; });
}

// Nothing here can make these fit.
bool beyond_mending(const CheckResult& result) {
  return has(result, FindingKind::no_triangles) || has(result, FindingKind::index_out_of_range) ||
         has(result, FindingKind::no_extent);
}

bool is_about(MendKind kind, const CheckResult& wrong) {
  switch (kind) {
    case MendKind::unreferenced:
      return has(wrong, FindingKind::not_finite);
    case MendKind::weld:
      return has(wrong, FindingKind::open_edges) || has(wrong, FindingKind::several_pieces);
    case MendKind::doubles:
    case MendKind::fins:
      return has(wrong, FindingKind::edge_not_manifold);
    case MendKind::largest_piece:
      return has(wrong, FindingKind::several_pieces);
    case MendKind::reorient:  // filling goes round a hole as the faces at its rim do
      return has(wrong, FindingKind::open_edges) && has(wrong, FindingKind::flipped_faces);
    case MendKind::holes:
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

// What every mend but dropping strays relies on.
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

}  // namespace

std::vector<MendKind> MendPlan::kinds() const {
  std::vector<MendKind> all;
  for (const MendStep& step : steps) all.push_back(step.kind);
  return all;
}

std::optional<MendPlan> plan_mends(const Mesh& mesh) {
  CheckResult wrong = check(mesh);
  if (wrong.fit() || beyond_mending(wrong)) return std::nullopt;
  MendPlan plan{mesh, {}};
  for (std::size_t i = 0; i < mend_count; ++i) {
    const auto kind = static_cast<MendKind>(i);
    if (!is_about(kind, wrong)) continue;
    if (kind != MendKind::unreferenced && has(wrong, FindingKind::not_finite)) return std::nullopt;
    Mended mended = mend(plan.mesh, kind);
    if (mended.step.count == 0) continue;
    CheckResult after = check(mended.mesh);
    const bool prepares = kind == MendKind::reorient;
    if (!prepares && badness(after) >= badness(wrong)) continue;
    plan.mesh = std::move(mended.mesh);
    plan.steps.push_back(std::move(mended.step));
    wrong = std::move(after);
    if (wrong.fit()) return plan;
  }
  return std::nullopt;
}

MendPlan carry_out(const Mesh& mesh, const std::vector<MendKind>& kinds) {
  MendPlan plan{mesh, {}};
  if (mesh.triangles.empty() || !is_in_range(mesh)) return plan;
  for (std::size_t i = 0; i < mend_count; ++i) {
    const auto kind = static_cast<MendKind>(i);
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
    if (kind != MendKind::unreferenced && !is_finite(plan.mesh)) break;
    Mended mended = mend(plan.mesh, kind);
    if (mended.step.count == 0) continue;
    plan.mesh = std::move(mended.mesh);
    plan.steps.push_back(std::move(mended.step));
  }
  return plan;
}

}  // namespace knit
