#include "knit/yarn/loop_frames.h"

#include <array>
#include <glm/geometric.hpp>

namespace knit {

namespace {

// Figures of the settled shapes, in widths, heights and radii.
constexpr double room = 0.21, decrease_wide = 0.92, on_top = 0.6, behind = -1.4;
constexpr double bar_wide = 0.7, made_in = -1.3;
constexpr double lift = 0.76, foot_wide = 0.55 * 0.71, foot_in = -1.8, tip_wide = 0.99, tip_in = -1.6;
constexpr double strand_up = -0.296, strand_out = -0.196;  // of a plain loop's ends
constexpr double bridge_half = 0.25;

struct Where {
  std::size_t path = 0, step = 0;
};

// The stitch after which the strand between two is: they follow each other on the yarn, or after the first comes what is worked
// on the second. no_stitch: they are not of one strand.
class Strands {
 public:
  Strands(std::span<const WorkedFrom> worked, std::span<const YarnPath> paths)
      : worked_(worked), paths_(paths), where_(worked.size()) {
    for (std::size_t path = 0; path < paths.size(); ++path) {
      for (std::size_t step = 0; step < paths[path].steps.size(); ++step)
        where_[paths[path].steps[step].stitch] = {path, step};
    }
  }
  [[nodiscard]] std::uint32_t between(std::uint32_t a, std::uint32_t b) const {
    if (a == no_stitch || b == no_stitch) return no_stitch;
    if (next_of(a) == b) return a;
    if (next_of(b) == a) return b;
    const std::uint32_t next = next_of(a);
    return next != no_stitch && worked_[next].parents[0] == b ? a : no_stitch;
  }

 private:
  [[nodiscard]] std::uint32_t next_of(std::uint32_t stitch) const {
    const auto& [path, step] = where_[stitch];
    const std::vector<YarnStep>& steps = paths_[path].steps;
    return step + 1 < steps.size() ? steps[step + 1].stitch : no_stitch;
  }
  std::span<const WorkedFrom> worked_;
  std::span<const YarnPath> paths_;
  std::vector<Where> where_;
};

class Framing {
 public:
  Framing(std::vector<LoopFrame> stitches, std::span<const WorkedFrom> worked, double radius)
      : worked_(worked), radius_(radius) {
    made_.stitch = std::move(stitches);
    made_.lifted_after.assign(worked.size(), no_stitch);
    made_.bar_of.assign(worked.size(), 0);
  }

  LoopFrames make(const Strands& strands) {
    lift_bars(strands);
    const auto count = static_cast<std::uint32_t>(worked_.size());
    std::vector<glm::dvec3> aside(count, glm::dvec3(0.0));
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_increase(worked_[i].kind)) make_room(worked_[i].beside, aside);
    }
    for (std::uint32_t i = 0; i < count; ++i) made_.stitch[i].place += aside[i];
    made_.head = made_.stitch;
    made_.base = made_.stitch;
    for (std::uint32_t i = 0; i < count; ++i) frame(i);
    return std::move(made_);
  }

 private:
  void lift_bars(const Strands& strands) {
    for (std::uint32_t i = 0; i < worked_.size(); ++i) {
      if (!is_increase(worked_[i].kind)) continue;
      const std::uint32_t after = strands.between(worked_[i].beside[1], worked_[i].beside[2]);
      if (after == no_stitch || made_.lifted_after[after] != no_stitch) continue;
      made_.lifted_after[after] = i;
      made_.bar_of[i] = 1;
    }
  }
  void make_room(const std::array<std::uint32_t, 4>& beside, std::vector<glm::dvec3>& aside) {
    constexpr std::array<double, 4> share{-0.5, -1.0, 1.0, 0.5};
    const glm::dvec3 course = made_.stitch[beside[1]].course;
    for (std::size_t i = 0; i < share.size(); ++i) {
      if (worked_[beside[i]].kind != LoopKind::bridge) aside[beside[i]] += room * share[i] * course;
    }
  }

  void frame(std::uint32_t i) {
    const WorkedFrom& from = worked_[i];
    LoopFrame& base = made_.base[i];
    switch (from.kind) {
      case LoopKind::cast_on:
        base.place -= base.wale;
        return;
      case LoopKind::bridge:
        base.wale *= 2.0 * bridge_half;
        base.place -= 0.5 * base.wale;
        made_.head[i].wale = base.wale;
        made_.head[i].place += 0.5 * base.wale;
        return;
      case LoopKind::m1l:
      case LoopKind::m1r:
        base = between(made_.stitch[from.beside[1]], made_.stitch[from.beside[2]]);
        base.course *= bar_wide;
        base.raised = made_in * radius_;
        return;
      case LoopKind::picked_up:
      case LoopKind::knit:
      case LoopKind::k2tog:
      case LoopKind::ssk:
        base = head_under(from.parents[0], i);
        if (from.parents[1] != no_stitch) take_together(i);
        return;
    }
  }

  // The frame out of which a loop comes; of a bridge, on the loop's side of it.
  [[nodiscard]] LoopFrame head_under(std::uint32_t parent, std::uint32_t made) const {
    LoopFrame frame = made_.stitch[parent];
    if (worked_[parent].kind != LoopKind::bridge) return frame;
    const glm::dvec3 way = made_.stitch[made].place - frame.place;
    frame.place += (glm::dot(way, frame.wale) < 0.0 ? -bridge_half : bridge_half) * frame.wale;
    frame.wale = way;
    frame.course = made_.stitch[made].course;
    return frame;
  }

  void take_together(std::uint32_t i) {
    const WorkedFrom& from = worked_[i];
    const LoopFrame one = head_under(from.parents[0], i), two = head_under(from.parents[1], i);
    LoopFrame& base = made_.base[i];
    base = knit::between(one, two);
    const std::size_t top = from.kind == LoopKind::ssk ? 0 : 1;
    for (std::size_t k = 0; k < 2; ++k) {
      if (worked_[from.parents[k]].kind == LoopKind::bridge) continue;
      made_.head[from.parents[k]] = base;
      made_.head[from.parents[k]].raised = (k == top ? on_top : behind) * radius_;
    }
    base.course *= decrease_wide;
  }

  std::span<const WorkedFrom> worked_;
  double radius_;
  LoopFrames made_;
};

}  // namespace

glm::dvec3 LoopFrames::course_at(std::uint32_t a, std::uint32_t b) const {
  return 0.5 * (stitch[a].course + stitch[b].course);
}

LoopFrame LoopFrames::bar_base(std::uint32_t a, std::uint32_t b, double width, double radius) const {
  LoopFrame foot = between(base[a], base[b]);
  const LoopFrame top = between(stitch[a], stitch[b]);
  foot.place += strand_up * foot.wale + strand_out * width * foot.out + lift * top.wale;
  foot.course = foot_wide * top.course;
  foot.wale = top.wale;
  foot.out = top.out;
  foot.raised = foot_in * radius;
  return foot;
}

LoopFrame LoopFrames::bar_head(std::uint32_t made, double radius) const {
  LoopFrame tip = base[made];
  tip.course *= tip_wide;
  tip.raised = tip_in * radius;
  return tip;
}

LoopFrames loop_frames(std::vector<LoopFrame> stitches, std::span<const WorkedFrom> worked,
                       std::span<const YarnPath> paths, double radius) {
  return Framing(std::move(stitches), worked, radius).make(Strands(worked, paths));
}

}  // namespace knit
