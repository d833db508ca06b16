// What the smallest steps of the stage tubes do.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "knit/model/event.h"
#include "knit/tubes/plan.h"

namespace knit {

struct FieldSmoothed {
  static constexpr std::string_view kind = "field-smoothed";
  std::int32_t tubes;  // that the level sets fell into before
  double length;       // smoothed over, in mesh units
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const FieldSmoothed&, const FieldSmoothed&) = default;
};

struct GraphFound {
  static constexpr std::string_view kind = "graph-found";
  std::int32_t tubes, nodes, loops, unfolded;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const GraphFound&, const GraphFound&) = default;
};

struct NodeFound {
  static constexpr std::string_view kind = "node-found";
  NodeKind node;
  VertexId vertex;              // of the mesh
  std::int32_t closed, opened;  // tubes that end here, that begin here
  double value;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const NodeFound&, const NodeFound&) = default;
};

struct TubeLeftOut {
  static constexpr std::string_view kind = "tube-left-out";
  bool handle;  // else a limb
  VertexId vertex;
  float rows, stitches,
      keeps;  // its height in stitch heights, its girth in stitch widths, a stitch width that keeps it
  std::uint16_t together = 0;  // 0: it alone; else so many low limbs, of which it is the highest
  std::uint16_t at_most = 0;   // what they all are of the surface, in hundredths of a percent, rounded up
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  [[nodiscard]] bool unusual(const Parameters& /*parameters*/) const { return true; }
  friend bool operator==(const TubeLeftOut&, const TubeLeftOut&) = default;
};

struct TubesPlanned {
  static constexpr std::string_view kind = "tubes-planned";
  std::int32_t tubes, rows, events, held, yarns;
  std::int32_t tried;  // orders
  bool exact;
  [[nodiscard]] std::string sentence(const Telling& at) const;
  [[nodiscard]] StepFields numbers() const;
  friend bool operator==(const TubesPlanned&, const TubesPlanned&) = default;
};

// Why the stage stopped, and what a person may do.
std::string tubes_stop_sentence(const Stopped& stop);

using TubesEvent = std::variant<FieldSmoothed, GraphFound, NodeFound, TubeLeftOut, TubesPlanned>;

}  // namespace knit
