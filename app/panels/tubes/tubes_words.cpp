#include "app/panels/tubes/tubes_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "knit/model/words.h"
#include "knit/tubes/low_limbs.h"

namespace app {

namespace {

using knit::plural;
using knit::short_number;

constexpr std::size_t most_left_out = 3;  // that are told one by one

// Two digits, or whole: "0.014", "0.63", "12".
std::string size_text(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), value < 10.0 ? "%.2g" : "%.0f", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

std::string sized(double value, std::string_view one, std::string_view many) {
  const std::string number = size_text(value);
  return number + " " + std::string(number == "1" ? one : many);
}

// Told by their number and what they are of the surface, not one by one; empty: there are none.
std::string low_limbs_words(const knit::TubePlan& plan, const knit::TubeGraph& graph) {
  const knit::LowLimbs low = knit::low_limbs(graph, plan);
  if (low.count == 0) return "";
  return "Left out: " + plural(low.count, "limb", "limbs") +
         " lower than a twentieth of a round, together at most " +
         short_number(std::ceil(1e4 * low.share) / 100.0) + " % of the surface.";
}

std::string rounds_text(std::int32_t rounds) { return plural(rounds, "round", "rounds"); }

std::string rowless_words(const knit::TubePlan& plan, const knit::Tube& tube) {
  const knit::TubeEvent& bottom = plan.event(tube.bottom);
  const knit::TubeEvent& top = plan.event(tube.top);
  if (top.kind == knit::EventKind::ring_cast_on)
    return "No round: an edge that tubes " + names_of_tubes(top.above) + " start from, back to back.";
  if (bottom.kind == knit::EventKind::ring_bind_off)
    return "No round: an edge at which tubes " + names_of_tubes(bottom.below) + " are grafted to each other.";
  return "No round: lower than a row, so its stitches are only dealt on.";
}

std::string overview(const knit::TubePlan& plan, const TubesLayout& layout) {
  const auto tubes = static_cast<std::int64_t>(plan.tubes.size());
  std::string words = tubes == 1 ? "One tube from end to end" : plural(tubes, "tube", "tubes");
  words += ", " + rounds_text(layout.rounds) + ", " + plural(plan.yarns, "yarn", "yarns");
  if (plan.yarns > 1) words += ", each in its own colour";
  if (plan.held_most == 0) return words + ". Nothing waits on a holder.";
  words += ". At most " +
           plural(plan.held_most, "loop waits on a holder.", "loops wait on holders at the same time.");
  if (!plan.order_is_exact) words += " Another order may need fewer.";
  return words;
}

std::string left_out_words(const knit::TubePlan& plan, const knit::LeftOut& left_out) {
  const double rounds = left_out.height / plan.stitch_height;
  const double stitches = left_out.girth / plan.stitch_width;
  const std::string size =
      sized(rounds, "round", "rounds") + " high and " + sized(stitches, "stitch", "stitches") + " round";
  const std::string keeps =
      left_out.width_that_keeps > 0.0
          ? "; stitches narrower than " + short_number(left_out.width_that_keeps) + " would keep it."
          : ".";
  if (left_out.handle)
    return "Left out: a hole at " + knit::vertex_text(left_out.from) + ", its thinner side " + size + keeps;
  return "Left out: a limb at " + knit::vertex_text(left_out.from) + ", " + size + keeps;
}

std::string genus_words(const knit::TubePlan& plan, const knit::TubeGraph& graph) {
  const std::int32_t holes = graph.loops();
  if (holes == 0) return "The surface has no hole to go through: genus 0, no loop among the tubes.";
  std::string words = "The surface has " + plural(holes, "hole", "holes") + " to go through: genus " +
                      std::to_string(holes) + ", as many loops among the tubes";
  const std::int32_t closed = holes - loops_of(plan);
  if (closed > 0)
    words += ", of which " + std::to_string(closed) + (closed == 1 ? " is" : " are") + " left out";
  return words + ".";
}

std::string machine_words(MachineVerdict verdict) {
  const std::string yes = "A knitting machine could make it too (McCann's criterion): ";
  switch (verdict) {
    case MachineVerdict::tree:
      return yes + "tubes that form a tree can always be laid out upward without crossing.";
    case MachineVerdict::drawn:
      return yes + "here its tubes stand upward and cross nowhere.";
    case MachineVerdict::series_parallel:
      return yes + "its tubes can be laid out upward without crossing, though here some do.";
    case MachineVerdict::not_known:
      break;
  }
  return "Whether a knitting machine could make it is not known (McCann's criterion): no way was found to "
         "lay its tubes out upward without crossing. By hand that does not matter.";
}

}  // namespace

std::string stitches_of_tube(const knit::TubePlan& plan, knit::TubeId tube, const TubeCount& count,
                             std::string_view word) {
  const knit::Tube& of = plan.tube(tube);
  if (count.rows == of.rows()) return std::to_string(count.stitches) + std::string(word);
  std::int64_t held = 0;
  for (const double length : of.lengths)
    held += std::max<std::int64_t>(3, std::llround(length / plan.stitch_width));
  return "about " + std::to_string(held) + std::string(word);
}

std::string tube_words(const knit::TubePlan& plan, const TubesLayout& layout, knit::TubeId tube,
                       const TubeCount& count) {
  const knit::Tube& of = plan.tube(tube);
  const TubePlace& place = layout.tubes[static_cast<std::size_t>(tube)];
  std::string words = "Tube " + knit::tube_name(tube);
  if (of.rows() > 0)
    words += ": " + rounds_text(of.rows()) + ", " + stitches_of_tube(plan, tube, count, " stitches") + ".";
  else
    words += ". " + rowless_words(plan, of);
  words += "\n" + sized(of.height / plan.stitch_height, "row", "rows") + " high, up to " +
           sized(of.longest / plan.stitch_width, "stitch", "stitches") + " round";
  words += place.yarn < 0 ? "." : "; yarn " + std::to_string(place.yarn + 1) + ".";
  if (of.twins.size() > 1)
    words += "\nTubes " + names_of_tubes(of.twins) + " are alike and get the same rounds.";
  if (of.forced) words += "\nIt is lower than a row and gets one round all the same.";
  if (of.inner)
    words +=
        "\nAn inner tube: its right side faces the middle of its rounds, so it is pushed through to the "
        "inside when it is done.";
  if (of.rows() == 0) return words;
  const knit::RowId last = place.first_row + of.rows() - 1;
  words += "\nRows " + std::to_string(place.first_row) + " to " + std::to_string(last) + ".";
  return words + "\nClick: to its first row.";
}

std::vector<std::string> plan_words(const knit::TubePlan& plan, const TubesLayout& layout,
                                    const knit::TubeGraph* graph) {
  std::vector<std::string> sentences{overview(plan, layout)};
  // Those first that the least change would keep.
  std::vector<knit::LeftOut> left_out;
  std::copy_if(plan.left_out.begin(), plan.left_out.end(), std::back_inserter(left_out),
               [&](const knit::LeftOut& one) { return graph == nullptr || !knit::is_low(plan, one); });
  std::stable_sort(left_out.begin(), left_out.end(), [](const knit::LeftOut& a, const knit::LeftOut& b) {
    return a.width_that_keeps > b.width_that_keeps;
  });
  const std::size_t told = std::min(left_out.size(), most_left_out);
  for (std::size_t i = 0; i < told; ++i) sentences.push_back(left_out_words(plan, left_out[i]));
  if (told < left_out.size())
    sentences.push_back("Left out too: " + std::to_string(left_out.size() - told) + " more, smaller still.");
  if (graph != nullptr) {
    if (std::string low = low_limbs_words(plan, *graph); !low.empty()) sentences.push_back(std::move(low));
  }
  if (graph != nullptr) sentences.push_back(genus_words(plan, *graph));
  sentences.push_back(machine_words(machine_verdict(plan, layout)));
  return sentences;
}

}  // namespace app
