// The table of all knobs, in the order of the pipeline (parameters.h says what an entry means).
#include <array>

#include "knit/model/parameters.h"

namespace knit {

namespace {

template <auto Field, class Enum>
constexpr Choice choice(std::span<const std::string_view> names) {
  return {[](const Parameters& p) { return static_cast<int>(p.*Field); },
          [](Parameters& p, int value) { p.*Field = static_cast<Enum>(value); }, names};
}

constexpr std::array<std::string_view, 4> timing_names{"linear", "arc-length", "geodesic", "harmonic"};
constexpr std::array<std::string_view, 2> source_names{"rings", "contours"};
constexpr std::array<std::string_view, 3> metric_names{"euclidean", "arc", "geodesic"};
constexpr std::array<std::string_view, 2> sizes_names{"mesh", "gauge"};
constexpr std::array<std::string_view, 2> stall_names{"continue", "stop"};
constexpr std::array<std::string_view, 2> anchor_names{"keep", "drop"};
constexpr std::array<std::string_view, 2> switch_names{"on", "off"};
constexpr std::array<std::string_view, 3> closing_names{"none", "thesis", "arc"};
constexpr std::array<std::string_view, 2> off_on_names{"off", "on"};

const std::array table{
    ParameterInfo{"weld", "Weld", "", "Merge vertices at exactly the same place when the mesh is opened.",
                  "Mesh", Stage::import, choice<&Parameters::weld, Weld>(off_on_names)},
    ParameterInfo{"axis", "Axis", "",
                  "The direction of knitting: x, y, z or a direction X,Y,Z. The time rises along it.",
                  "Timing", Stage::timing, AxisChoice{}},
    ParameterInfo{
        "start", "Start vertex", "vertex",
        "Where the time is 0: a vertex of the mesh, counted from 0, or auto for the lowest along the axis.",
        "Timing", Stage::timing, PickedVertex{&Parameters::start}},
    ParameterInfo{"end", "End vertex", "vertex",
                  "Where the time is 1: a vertex of the mesh, counted from 0, or auto for the highest along "
                  "the axis (with geodesic timing: the farthest from the start).",
                  "Timing", Stage::timing, PickedVertex{&Parameters::end}},
    ParameterInfo{
        "timing", "Timing", "",
        "How the time rises. linear: along the axis, Algorithm 1. arc-length: the same levels, with "
        "equal steps of time equally high on the surface. geodesic: with the distance from the "
        "start along the surface. harmonic: as smoothly as can be from start to end, with equal "
        "steps equally high.",
        "Timing", Stage::timing, choice<&Parameters::timing, TimingKind>(timing_names)},
    ParameterInfo{
        "level-tolerance", "Level tolerance", "of the time, 0 to 1",
        "Vertices whose times lie closer together than this belong to one level, one cycle to pick from.",
        "Timing", Stage::timing, Number{&Parameters::level_tolerance, 0.0, 0.1}},
    ParameterInfo{
        "sizes", "Sizes from", "",
        "Which view of the stitch size is the given one; the other one follows. mesh: width and "
        "height in the mesh's units. gauge: stitches and rounds per 10 cm, with the finished height.",
        "Stitch size", Stage::done, choice<&Parameters::sizes, SizesFrom>(sizes_names)},
    ParameterInfo{"stitch-width", "Stitch width w", "mesh units",
                  "How wide a stitch is: the distance that Algorithm 2 looks for between neighbouring "
                  "stitches, and what the length of a contour is divided by.",
                  "Stitch size", Stage::cast_on, Number{&Parameters::stitch_width, 0.0, no_limit}},
    ParameterInfo{"stitch-height", "Stitch height h", "mesh units",
                  "How high a row is: contours lie this far apart on the surface. auto: 0.72 of the width. "
                  "Rings lie where the mesh has them; there it only judges.",
                  "Stitch size", Stage::cast_on,
                  Number{&Parameters::stitch_height, 0.0, no_limit, Zero::means_auto}},
    ParameterInfo{"gauge", "Gauge", "stitches, rounds in 10 cm",
                  "What a swatch of the yarn counts in 10 cm: stitches across and rounds up, as 22,32.",
                  "Stitch size", Stage::done, GaugeChoice{&Parameters::gauge}},
    ParameterInfo{"height-cm", "Finished height", "cm",
                  "How high the finished object shall be along the axis; it ties centimetres to mesh units.",
                  "Stitch size", Stage::done, Number{&Parameters::height_cm, 0.0, 10000.0}},
    ParameterInfo{
        "rows", "Rows from", "",
        "rings: Algorithm 2 picks stitches from the mesh's own vertices. contours: the surface is cut "
        "at equal steps of time, and stitches stand at equal arcs along each cut.",
        "Rows", Stage::cast_on, choice<&Parameters::rows, RowSource>(source_names)},
    ParameterInfo{
        "start-direction", "Rounds begin at", "",
        "The side on which every round begins: a direction X,Y,Z across the axis, or auto for -z (-x "
        "where that is the axis).",
        "Rows", Stage::cast_on, DirectionChoice{&Parameters::start_direction}},
    ParameterInfo{
        "cast-on", "Cast on", "stitches",
        "Stitches of the first row, spread evenly. auto: 6 with rings; with contours as many as its "
        "length holds.",
        "Rows", Stage::cast_on, Count{&Parameters::cast_on, 3, 1000, true}},
    ParameterInfo{
        "metric", "Metric", "",
        "The ruler of Algorithm 2. euclidean: straight through the air, as in the thesis. arc: along "
        "the cycle. geodesic: the shortest way on the surface.",
        "Rows", Stage::rows, choice<&Parameters::metric, Metric>(metric_names)},
    ParameterInfo{
        "epsilon", "Epsilon \xCE\xB5", "mesh units",
        "Half the band's width: a vertex is accepted at a distance within [w - \xCE\xB5, w + \xCE\xB5]. The "
        "first one wins, so \xCE\xB5 sets the stitch length as much as w does.",
        "Rows", Stage::rows, Number{&Parameters::epsilon, 0.0, no_limit}},
    ParameterInfo{
        "on-stall", "When nothing is in the band", "",
        "continue: take the vertex nearest to the stitch width, and log it. stop: end the run there.", "Rows",
        Stage::rows, choice<&Parameters::on_stall, OnStall>(stall_names)},
    ParameterInfo{
        "last-anchor", "Last anchor", "",
        "keep: the last vertex picked is always a stitch. drop: not when it is nearer than w/2 to the first.",
        "Rows", Stage::rows, choice<&Parameters::last_anchor, LastAnchor>(anchor_names)},
    ParameterInfo{
        "resample", "Resample jumps", "",
        "on: a row that more than doubles or halves is spread anew within that limit, and logged. off: stop.",
        "Rows", Stage::rows, choice<&Parameters::resample, Resample>(switch_names)},
    ParameterInfo{
        "close", "Closing gap", "",
        "How the gap between last and first stitch is shared out: none, the thesis's shift, or equal arcs.",
        "Rows", Stage::rows, choice<&Parameters::close, Closing>(closing_names)},
    ParameterInfo{"placement", "Placement", "", placement_help, "Stitches", Stage::stitches,
                  choice<&Parameters::placement, PlacementPolicy>(placement_names)},
    ParameterInfo{"stacking-penalty", "Against stacking", "squared widths",
                  "nearest: what it costs to place shaping above the shaping of the row before; 0 lets it "
                  "stack.",
                  "Stitches", Stage::stitches,
                  Number{&Parameters::stacking_penalty, 0.0, 1000.0, Zero::allowed}},
    ParameterInfo{"follow-mains", "Follow the mains", "",
                  "nearest: on places all shaping beside main stitches, so that it runs in lines.",
                  "Stitches", Stage::stitches, choice<&Parameters::follow_mains, FollowMains>(off_on_names)},
};

}  // namespace

std::span<const ParameterInfo> parameter_table() { return table; }

}  // namespace knit
