// Everything that can be set, in groups by the stage that reads them; and what the stitch comes to on a mesh.
//
// A stage takes its own group and those before it, and the StitchSize; so nothing it does can depend on what comes
// later. settings_table.h says of each setting what people read: key, unit, range, meaning. Lengths are in mesh units.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <variant>

#include "knit/mesh/mesh.h"
#include "knit/model/placement_policy.h"
#include "knit/model/relax_settings.h"
#include "knit/model/rhythm_settings.h"

namespace knit {

enum class AxisKind : std::uint8_t { x, y, z, custom };
struct Axis {
  AxisKind kind = AxisKind::y;
  glm::dvec3 custom{0.0, 1.0, 0.0};            // read only when kind is custom; any length but zero
  [[nodiscard]] glm::dvec3 direction() const;  // unit length
  friend bool operator==(const Axis&, const Axis&) = default;
};

// by_itself: linear, but geodesic where too much lies flat or uneven (knit/timing/choice.h).
enum class TimingKind : std::uint8_t { linear, arc_length, geodesic, harmonic, by_itself };
// Of the field, before its level sets are followed from contour to contour. by_itself: where they form more than one tube.
enum class Smoothing : std::uint8_t { by_itself, off, on };
// follow: on the wale that the round below begins on. direction: all on one side.
enum class RoundStart : std::uint8_t { follow, direction };
// The mesh's own vertices, or cuts through edges; by_itself: rings where the mesh has them (knit/rows/choice.h).
enum class RowSource : std::uint8_t { rings, contours, by_itself };
enum class Metric : std::uint8_t { euclidean, arc, geodesic };  // the ruler of Algorithm 2
enum class SizesFrom : std::uint8_t { mesh, gauge };      // which view of the stitch size is the given one
enum class Closing : std::uint8_t { none, thesis, arc };  // how the closing gap is shared out
enum class LastAnchor : std::uint8_t { keep, drop };      // drop: when nearer than w/2 to the first stitch
enum class OnStall : std::uint8_t { continue_, stop };    // when no vertex lies in the band
enum class Resample : std::uint8_t { on, off };           // when a row more than doubles or halves
// Whether stitches are moved on the surface to where they are at ease; by_itself: those of contours.
enum class Settling : std::uint8_t { off, on, by_itself };
enum class FollowMains : std::uint8_t { off, on };              // nearest: shaping stands beside mains
enum class GraftBy : std::uint8_t { kitchener, three_needle };  // how two live rims become one seam
// Whether a tube that is longer on one side gets short rows there. auto: where they pay.
enum class ShortRows : std::uint8_t { off, automatic };
// Rows that a tube keeps as they are beside an event; by_itself: what settles best, no short rows among it.
enum class KeptBeside : std::uint8_t { by_itself, none, one, two };
enum class SwapEnds : std::uint8_t { off, on };  // of an open mesh: where it begins and where it ends
enum class Weld : std::uint8_t { off, on };      // merge coincident vertices on import

struct MeshSettings {
  Weld weld = Weld::off;
  friend bool operator==(const MeshSettings&, const MeshSettings&) = default;
};

struct TimingSettings {
  Axis axis;
  VertexId start = no_vertex;  // picked by hand; no_vertex: the extreme vertex along the axis
  VertexId end = no_vertex;
  TimingKind kind = TimingKind::linear;
  double level_tolerance = 1e-5;  // vertices whose times differ by less are of one level
  SwapEnds swap_ends = SwapEnds::off;
  friend bool operator==(const TimingSettings&, const TimingSettings&) = default;
};

// A knitter's swatch: stitches and rounds in 10 cm.
struct Gauge {
  double stitches = 22.0;
  double rounds = 32.0;
  friend bool operator==(const Gauge&, const Gauge&) = default;
};

inline constexpr double height_of_width = 0.72;  // of a stitch whose height is left to itself
struct MeshSize {
  double width = 0.1;
  double height = 0.0;  // 0: height_of_width of the width
  friend bool operator==(const MeshSize&, const MeshSize&) = default;
};
struct GaugeSize {
  Gauge gauge;
  friend bool operator==(const GaugeSize&, const GaugeSize&) = default;
};
// The stitch's size is stated once, in one of two views; stitch_size.h resolves it.
struct SizeSettings {
  std::variant<MeshSize, GaugeSize> given;
  double height_cm = 12.0;  // of the finished object, along the axis
  [[nodiscard]] SizesFrom from() const { return given.index() == 0 ? SizesFrom::mesh : SizesFrom::gauge; }
  friend bool operator==(const SizeSettings&, const SizeSettings&) = default;
};

// A length that grows with the stitch: `part` where a stitch is `whole` wide. Two numbers, because a quotient cannot
// give back every length that people type. Whole 0: `part` is meant as it stands, whatever the width turns out to be.
struct WidthShare {
  double part = 0.5;
  double whole = 1.0;
  [[nodiscard]] double of(double width) const {
    return whole == width || whole == 0.0 ? part : part / whole * width;
  }
  // As shares: 1 of 2 is 2 of 4, but for rounding.
  friend bool operator==(const WidthShare& a, const WidthShare& b) {
    if (a.whole == 0.0 || b.whole == 0.0) return a.part == b.part && a.whole == b.whole;
    const double difference = a.part * b.whole - b.part * a.whole;
    return (difference < 0.0 ? -difference : difference) <= 1e-14 * a.part * b.whole;
  }
};

struct TubeSettings {
  Smoothing smoothing = Smoothing::by_itself;
  double smoothing_length = 1.0;  // in stitch heights
  int smallest_limb = 1;          // rows
  friend bool operator==(const TubeSettings&, const TubeSettings&) = default;
};

struct RowsSettings {
  RowSource source = RowSource::rings;
  RoundStart round_start = RoundStart::follow;
  std::optional<glm::dvec3> start_direction;  // where rounds begin, any length but zero; none: -z, or -x
  int cast_on = 0;                            // 0: 6 for rings, as the length says for contours
  Metric metric = Metric::euclidean;
  WidthShare epsilon;
  OnStall on_stall = OnStall::continue_;
  LastAnchor last_anchor = LastAnchor::keep;
  Resample resample = Resample::on;
  Closing close = Closing::arc;
  friend bool operator==(const RowsSettings&, const RowsSettings&) = default;
};

// Of tubes of contours.
struct ShortRowSettings {
  ShortRows rows = ShortRows::off;
  KeptBeside kept = KeptBeside::by_itself;
  double turn_cost = 5.0;  // of a pair, in stitches that lag a row too much
  double turn_step = 4.0;  // stitches that turns stay apart
  int shortest = 4;        // stitches of a short row
  friend bool operator==(const ShortRowSettings&, const ShortRowSettings&) = default;
};

struct StitchSettings {
  PlacementPolicy placement = PlacementPolicy::thesis;
  double stacking_penalty = 0.0;  // nearest: in squared stitch widths, for shaping above shaping
  FollowMains follow_mains = FollowMains::off;
  friend bool operator==(const StitchSettings&, const StitchSettings&) = default;
};

// Weights of squares that a perfect fabric has at 0, each a share of the stitch's size.
struct SettleSettings {
  Settling settling = Settling::off;
  double wale = 2.0;    // of a wale's length, against h
  double course = 1.0;  // of a course's, against w
  double shear = 0.25;  // of a quad's two diagonals, which are to be alike
  double rim = 1.0;     // of the way from where the rim of an opening was
  double fold = 1.0;    // of a face's corner that is about to turn over
  double cover = 1.0;   // of a place that fabric slides off, as from the end of a limb
  int most_iterations = 60;
  friend bool operator==(const SettleSettings&, const SettleSettings&) = default;
};

// What no stage reads: how the pattern is told.
struct PatternSettings {
  GraftBy graft = GraftBy::kitchener;
  friend bool operator==(const PatternSettings&, const PatternSettings&) = default;
};

// In the order in which they are read.
struct Settings {
  MeshSettings mesh;
  TimingSettings timing;
  SizeSettings size;
  TubeSettings tubes;
  RowsSettings rows;
  RhythmSettings rhythm;
  ShortRowSettings short_rows;
  StitchSettings stitches;
  SettleSettings settle;
  RelaxSettings relax;
  PatternSettings pattern;
  friend bool operator==(const Settings&, const Settings&) = default;
};

// The stitch on one mesh, in both views.
struct StitchSize {
  double width = MeshSize{}.width;
  double height = height_of_width * MeshSize{}.width;
  bool height_follows = true;  // the width: it was left to itself
  Gauge gauge;
  double centimetres_per_unit = 1.0;  // of the mesh
  friend bool operator==(const StitchSize&, const StitchSize&) = default;
};

// The settings of a run with what they make of the stitch on its mesh: what people call the parameters.
struct Parameters : Settings {
  StitchSize stitch;  // as resolved() last found it; the given view is always up to date
  [[nodiscard]] double epsilon() const { return rows.epsilon.of(stitch.width); }
  // What is stated says all; the rest follows from it on the same mesh.
  friend bool operator==(const Parameters& a, const Parameters& b) {
    return static_cast<const Settings&>(a) == static_cast<const Settings&>(b);
  }
};

// Stitch width 3 % of the bounding box's diagonal and half of it as epsilon.
Parameters default_parameters(const Bounds& bounds);

}  // namespace knit
