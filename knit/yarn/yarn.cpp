#include "knit/yarn/yarn.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "knit/yarn/loop_ends.h"
#include "knit/yarn/loop_frames.h"
#include "knit/yarn/loop_shape.h"
#include "knit/yarn/stitch_frames.h"
#include "knit/yarn/worked_from.h"
#include "knit/yarn/yarn_pen.h"

namespace knit {

namespace {

// In the order of the yarn.
std::vector<glm::dvec3> points_of(const LoopShape& shape, const LoopFrame& base, const LoopFrame& head,
                                  double width, bool back) {
  std::vector<glm::dvec3> points;
  for (const LoopPoint& point : shape) points.push_back(placed(point, base, head, width));
  if (back) std::reverse(points.begin(), points.end());
  return points;
}

class Maker {
 public:
  Maker(const Fabric& fabric, std::span<const glm::dvec3> positions, const StitchSize& stitch, double radius)
      : fabric_(fabric),
        width_(stitch.width),
        radius_(radius > 0.0 ? radius : radius_of_width * stitch.width),
        worked_(worked_from(fabric)),
        paths_(yarn_paths(fabric)),
        frames_(loop_frames(stitch_frames(fabric, positions, worked_, paths_), worked_, paths_, radius_)),
        pen_(radius_, 2.0 * stitch.width) {}

  Yarn make() {
    for (const YarnPath& path : paths_) add_path(path);
    Yarn yarn{pen_.take(), counts_};
    yarn.counts.cuts = pen_.cuts();
    for (const WorkedFrom& from : worked_) {
      if (is_increase(from.kind)) ++(yarn.counts.half_hitches);
    }
    yarn.counts.half_hitches -= yarn.counts.bars;
    return yarn;
  }

 private:
  void add_path(const YarnPath& path) {
    pen_.begin();
    for (std::size_t i = 0; i < path.steps.size(); ++i) {
      const YarnStep& step = path.steps[i];
      if (i > 0) join(path.steps[i - 1], step);
      const std::uint32_t stitch = step.stitch;
      pen_.add(points_of(shape_of(worked_[stitch].kind, frames_.bar_of[stitch]), frames_.base[stitch],
                         frames_.head[stitch], width_, step.back),
               stitch, YarnPart::loop);
    }
    if (!path.steps.empty() && path.last > 0) finish(path);
  }

  // What lies between two loops: nothing, or the bar that a stitch above is made of.
  void join(const YarnStep& a, const YarnStep& b) {
    if (a.back != b.back) ++counts_.turns;
    const std::uint32_t made = frames_.lifted_after[a.stitch];
    if (made == no_stitch) return;
    const LoopShape shape = worked_[made].kind == LoopKind::m1l ? front_ : behind_;
    const LoopFrame foot = frames_.bar_base(a.stitch, b.stitch, width_, radius_);
    std::vector<glm::dvec3> points = points_of(shape, foot, frames_.bar_head(made, radius_), width_, a.back);
    pen_.add_bar(std::move(points), 0.16 * (a.back ? -1.0 : 1.0) * frames_.course_at(a.stitch, b.stitch),
                 made);
    ++counts_.bars;
  }

  [[nodiscard]] const LoopShape& shape_of(LoopKind kind, bool has_bar) const {
    if (kind == LoopKind::cast_on || kind == LoopKind::bridge) return front_;
    if (!has_bar && kind == LoopKind::m1l) return front_;
    if (!has_bar && kind == LoopKind::m1r) return behind_;
    return plain_;
  }

  // What is done with the stitches that the yarn leaves live.
  void finish(const YarnPath& path) {
    const Row& row = fabric_.row(path.last);
    for (const auto& deal : fabric_.deals()) {
      if (deal->kind == DealKind::ring_bind_off && is_end_of(*deal, row)) return graft(*deal, row);
    }
    const LiveStitches live = fabric_.live(row.tube);
    if (live.empty() || live != all_of(row) || !is_last_of_tube(row)) return;
    const std::vector<std::uint32_t> stitches = fabric_.path_indices(live);
    const bool drawn = stitches.size() <= drawn_together;
    (drawn ? counts_.drawn : counts_.bound_off) += static_cast<std::int32_t>(stitches.size());
    for (std::size_t i = 0; i < stitches.size(); ++i) {
      const LoopFrame& head = frames_.head[stitches[i]];
      if (drawn) {
        pen_.add(drawn_through(head, width_), stitches[i], YarnPart::drawn);
      } else {
        const LoopFrame& next = frames_.head[stitches[(i + 1) % stitches.size()]];
        pen_.add(points_of(plain_, head, chained(next, radius_), width_, false), stitches[i],
                 YarnPart::bind_off);
      }
    }
  }
  [[nodiscard]] bool is_last_of_tube(const Row& row) const {
    return std::none_of(fabric_.rows().begin(), fabric_.rows().end(),
                        [&](const auto& other) { return other->tube == row.tube && other->id > row.id; });
  }
  // Grafting is done by the yarn that comes last to one of the two rims.
  [[nodiscard]] static bool is_end_of(const Deal& deal, const Row& row) {
    RowId last = 0;
    for (const LiveStitches& live : deal.taken) {
      for (const StitchSpan& span : live.spans) last = std::max(last, span.row);
    }
    return last == row.id;
  }
  void graft(const Deal& deal, const Row& row) {
    const std::vector<std::uint32_t> own = fabric_.path_indices(all_of(row));
    const auto is_own = [&](std::uint32_t stitch) { return stitch >= own.front() && stitch <= own.back(); };
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (auto edge : deal.column_edges) {
      if (!is_own(edge[0])) std::swap(edge[0], edge[1]);
      pairs.push_back(edge);
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [stitch, other] = pairs[i];
      const std::uint32_t next = pairs[(i + 1) % pairs.size()][1];
      pen_.add(points_of(plain_, frames_.head[stitch], facing(frames_.head[other], frames_.head[next]),
                         width_, false),
               stitch, YarnPart::graft);
      ++counts_.grafted;
    }
  }

  const Fabric& fabric_;
  double width_, radius_;
  std::vector<WorkedFrom> worked_;
  std::vector<YarnPath> paths_;
  LoopFrames frames_;
  YarnPen pen_;
  YarnCounts counts_;
  LoopShape plain_ = plain_loop(), front_ = twisted_loop(true), behind_ = twisted_loop(false);
};

}  // namespace

Yarn make_yarn(const Fabric& fabric, std::span<const glm::dvec3> positions, const StitchSize& stitch,
               double radius) {
  return Maker(fabric, positions, stitch, radius).make();
}

}  // namespace knit
