// The table of all settings, in the order of the pipeline (settings_table.h says what an entry means).
#include "knit/model/settings_table.h"

#include <array>

#include "knit/model/stitch_size.h"

namespace knit {

namespace {

// How a field of a group is read and set.
template <auto Group, auto Field>
constexpr auto field() {
  using T = std::decay_t<decltype(Settings{}.*Group.*Field)>;
  return Access<T>{[](const Parameters& p) { return p.*Group.*Field; },
                   [](Parameters& p, T value) { p.*Group.*Field = value; }};
}

template <auto Group, auto Field>
constexpr Choice choice(std::span<const std::string_view> names) {
  using Enum = std::decay_t<decltype(Settings{}.*Group.*Field)>;
  return {{[](const Parameters& p) { return static_cast<int>(p.*Group.*Field); },
           [](Parameters& p, int value) { p.*Group.*Field = static_cast<Enum>(value); }},
          names};
}

bool is_of_rings(const Parameters& p) { return p.rows.source != RowSource::contours; }
bool is_of_contours(const Parameters& p) { return p.rows.source != RowSource::rings; }
bool is_of_nearest(const Parameters& p) {
  return p.stitches.placement == PlacementPolicy::nearest ||
         p.stitches.placement == PlacementPolicy::by_itself;
}

bool is_in_rhythm(const Parameters& p) {
  return is_of_contours(p) && p.rhythm.counts == CountPlanning::rhythm;
}

bool has_short_rows(const Parameters& p) {
  return is_of_contours(p) && p.short_rows.rows == ShortRows::automatic;
}

bool is_settled(const Parameters& p) {
  const bool by_itself = p.settle.settling == Settling::by_itself && is_of_contours(p);
  return p.settle.settling == Settling::on || by_itself;
}
template <auto Field>
constexpr Number settle_weight() {
  return {field<&Settings::settle, Field>(), 0.0, 100.0, Zero::allowed};
}

bool is_relaxed(const Parameters& p) { return p.relax.relaxing == Relaxing::on; }

// The views of the stitch size, and what goes with it.
constexpr Access<double> stitch_width{[](const Parameters& p) { return p.stitch.width; }, give_width};
constexpr Access<double> stitch_height{
    [](const Parameters& p) { return p.stitch.height_follows ? 0.0 : p.stitch.height; }, give_height};
constexpr Access<Gauge> gauge{[](const Parameters& p) { return p.stitch.gauge; }, give_gauge};
constexpr Access<double> epsilon{[](const Parameters& p) { return p.epsilon(); }, give_epsilon};

constexpr std::array<std::string_view, 5> timing_names{"linear", "arc-length", "geodesic", "harmonic",
                                                       "auto"};
constexpr std::array<std::string_view, 3> smoothing_names{"auto", "off", "on"};
constexpr std::array<std::string_view, 2> round_start_names{"follow", "direction"};
constexpr std::array<std::string_view, 3> source_names{"rings", "contours", "auto"};
constexpr std::array<std::string_view, 3> metric_names{"euclidean", "arc", "geodesic"};
constexpr std::array<std::string_view, 2> sizes_names{"mesh", "gauge"};
constexpr std::array<std::string_view, 2> stall_names{"continue", "stop"};
constexpr std::array<std::string_view, 2> anchor_names{"keep", "drop"};
constexpr std::array<std::string_view, 2> switch_names{"on", "off"};
constexpr std::array<std::string_view, 3> closing_names{"none", "thesis", "arc"};
constexpr std::array<std::string_view, 2> off_on_names{"off", "on"};
constexpr std::array<std::string_view, 3> settling_names{"off", "on", "auto"};

constexpr std::array stuffing_names{NamedNumber{"none", 0.0}, NamedNumber{"soft", stuffing_soft},
                                    NamedNumber{"usual", stuffing_usual}, NamedNumber{"firm", stuffing_firm},
                                    NamedNumber{"hard", stuffing_hard}};

constexpr std::array<std::string_view, 2> count_names{"whole", "rhythm"};
constexpr std::array<std::string_view, 2> short_row_names{"off", "auto"};
constexpr std::array<std::string_view, 4> kept_names{"auto", "0", "1", "2"};
constexpr std::array<std::string_view, 2> graft_names{"kitchener", "three-needle"};

constexpr Choice sizes{{[](const Parameters& p) { return static_cast<int>(p.size.from()); },
                        [](Parameters& p, int view) { give_sizes(p, static_cast<SizesFrom>(view)); }},
                       sizes_names};

constexpr std::array table{
    ParameterInfo{"weld",
                  "Weld",
                  "",
                  "Merge vertices at exactly the same place when the mesh is opened.",
                  "Mesh",
                  Stage::import,
                  choice<&Settings::mesh, &MeshSettings::weld>(off_on_names),
                  nullptr,
                  Tie::none,
                  {},
                  "Welding changes the mesh itself; set it for the whole run, not from here."},
    ParameterInfo{"axis", "Axis", "",
                  "The direction of knitting: x, y, z or a direction X,Y,Z. The time rises along it.",
                  "Timing", Stage::timing, AxisChoice{field<&Settings::timing, &TimingSettings::axis>()}},
    ParameterInfo{
        keys::start, "Start vertex", "vertex",
        "Where the time is 0: a vertex of the mesh, counted from 0, or auto for the lowest along the axis.",
        "Timing", Stage::timing, PickedVertex{field<&Settings::timing, &TimingSettings::start>()}},
    ParameterInfo{"end", "End vertex", "vertex",
                  "Where the time is 1: a vertex of the mesh, counted from 0, or auto for the highest along "
                  "the axis (with geodesic timing: the farthest from the start).",
                  "Timing", Stage::timing, PickedVertex{field<&Settings::timing, &TimingSettings::end>()}},
    ParameterInfo{"swap-ends", "Swap the ends", "",
                  "Of a mesh with open edges: whether start and end change places, so that a hat is knitted "
                  "from the crown. A closed mesh does not read it.",
                  "Timing", Stage::timing,
                  choice<&Settings::timing, &TimingSettings::swap_ends>(off_on_names)},
    ParameterInfo{
        "timing", "Timing", "",
        "How the time rises. linear: along the axis, Algorithm 1. arc-length: the same levels, with "
        "equal steps of time equally high on the surface. geodesic: with the distance from the "
        "start along the surface. harmonic: as smoothly as can be from start to end, with equal "
        "steps equally high. auto: linear, or geodesic where too much of the surface lies flat across the "
        "axis, or would be "
        "stretched.",
        "Timing", Stage::timing, choice<&Settings::timing, &TimingSettings::kind>(timing_names)},
    ParameterInfo{
        "level-tolerance", "Level tolerance", "of the time, 0 to 1",
        "Vertices whose times lie closer together than this belong to one level, one cycle to pick from.",
        "Timing", Stage::timing,
        Number{field<&Settings::timing, &TimingSettings::level_tolerance>(), 0.0, 0.1}, is_of_rings},
    ParameterInfo{
        keys::sizes, "Sizes from", "",
        "Which view of the stitch size is the given one; the other one follows. mesh: width and "
        "height in the mesh's units. gauge: stitches and rounds per 10 cm, with the finished height.",
        "Stitch size", Stage::done, sizes},
    ParameterInfo{keys::stitch_width, "Stitch width w", "mesh units",
                  "How wide a stitch is: the distance that Algorithm 2 looks for between neighbouring "
                  "stitches, and what the length of a contour is divided by.",
                  "Stitch size", Stage::tubes, Number{{stitch_width}, 0.0, no_limit}, nullptr, Tie::mesh_view,
                  "3 % of the bounding box's diagonal"},
    ParameterInfo{"stitch-height", "Stitch height h", "mesh units",
                  "How high a row is: contours lie this far apart on the surface. auto: 0.72 of the width. "
                  "Rings lie where the mesh has them; there it only judges.",
                  "Stitch size", Stage::tubes, Number{{stitch_height}, 0.0, no_limit, Zero::follows}, nullptr,
                  Tie::mesh_view},
    ParameterInfo{keys::gauge, "Gauge", "stitches, rounds in 10 cm",
                  "What a swatch of the yarn counts in 10 cm: stitches across and rounds up, as 22,32.",
                  "Stitch size", Stage::done, GaugeChoice{{gauge}}, nullptr, Tie::gauge_view,
                  "follows the stitch size"},
    ParameterInfo{"height-cm", "Finished height", "cm",
                  "How high the finished object shall be along the axis; it ties centimetres to mesh units.",
                  "Stitch size", Stage::done,
                  Number{field<&Settings::size, &SizeSettings::height_cm>(), 0.0, 10000.0}},
    ParameterInfo{"field-smoothing", "Smooth the time", "",
                  "Whether the time is smoothed before its level sets are followed, so that what is smaller "
                  "than a stitch "
                  "makes no tube. auto: where there is more than one tube.",
                  "Tubes", Stage::tubes, choice<&Settings::tubes, &TubeSettings::smoothing>(smoothing_names),
                  is_of_contours},
    ParameterInfo{"smoothing-length", "Smooth over", "stitch heights",
                  "Over how many stitch heights the time is smoothed.", "Tubes", Stage::tubes,
                  Number{field<&Settings::tubes, &TubeSettings::smoothing_length>(), 0.0, 10.0},
                  is_of_contours},
    ParameterInfo{"smallest-limb", "Smallest limb", "rounds",
                  "A limb lower than this is left out. More makes a tidier pattern and a rougher shape.",
                  "Tubes", Stage::tubes,
                  Count{field<&Settings::tubes, &TubeSettings::smallest_limb>(), 1, 20}, is_of_contours},
    ParameterInfo{
        keys::rows,
        "Rows from",
        "",
        "rings: Algorithm 2 picks stitches from the mesh's own vertices. contours: the surface is cut "
        "at equal heights, tube by tube, and stitches stand at equal arcs along each cut: any shape. auto: "
        "rings where the mesh has "
        "them all the way, else contours.",
        "Rows",
        Stage::timing,
        choice<&Settings::rows, &RowsSettings::source>(source_names),
        nullptr,
        Tie::none,
        {},
        "Rows have begun from {} already; set where they come from for the whole run, not from here."},
    ParameterInfo{"round-start", "Rounds begin on", "",
                  "follow: on the wale that the round below begins on, wherever the wales are shortest. "
                  "direction: all on "
                  "one side.",
                  "Rows", Stage::cast_on,
                  choice<&Settings::rows, &RowsSettings::round_start>(round_start_names), is_of_contours},
    ParameterInfo{
        "start-direction", "Rounds begin at", "",
        "The side on which every round begins: a direction X,Y,Z across the axis, or auto for -z (-x "
        "where that is the axis).",
        "Rows", Stage::cast_on, DirectionChoice{field<&Settings::rows, &RowsSettings::start_direction>()}},
    ParameterInfo{
        "cast-on", "Cast on", "stitches",
        "Stitches of the first row, spread evenly. auto: 6 with rings; with contours as many as its "
        "length holds.",
        "Rows", Stage::cast_on, Count{field<&Settings::rows, &RowsSettings::cast_on>(), 3, 1000, true}},
    ParameterInfo{"counts", "Counts", "",
                  "How many stitches rows have. whole: each row as many as its length holds, to the nearest "
                  "whole number. "
                  "rhythm: all "
                  "rows planned together, so that shaping comes in few and regular rhythms and every shaping "
                  "round is one "
                  "repeat; where a piece branches, tube by tube.",
                  "Rhythm", Stage::cast_on, choice<&Settings::rhythm, &RhythmSettings::counts>(count_names),
                  is_of_contours},
    ParameterInfo{"rhythm-tolerance", "Tolerance", "%",
                  "By how much the circumference may be seen to be off, as a mean over six rounds. Less "
                  "keeps nearer to the "
                  "shape and takes more rhythms.",
                  "Rhythm", Stage::cast_on,
                  Number{field<&Settings::rhythm, &RhythmSettings::tolerance>(), 0.0, 50.0}, is_in_rhythm},
    ParameterInfo{"rhythm-changes", "Changes a round", "stitches",
                  "How many stitches a shaping round adds or takes away. auto: whatever reads best.",
                  "Rhythm", Stage::cast_on,
                  Count{field<&Settings::rhythm, &RhythmSettings::changes>(), 2, 60, true}, is_in_rhythm},
    ParameterInfo{
        "rhythm-style", "Shaping stands", "",
        "Where a section's shaping stands. pairs: on both sides of its main stitch, mirrored. lines: before "
        "the "
        "next section. centre: in its middle. stagger: as lines and centre in turn, so that no line is seen.",
        "Rhythm", Stage::cast_on, choice<&Settings::rhythm, &RhythmSettings::style>(rhythm_style_names),
        is_in_rhythm},
    ParameterInfo{
        "rhythm-halves", "Front and back", "",
        "Whether the front and the back of a body that is not round are shaped apart, in one rhythm. "
        "auto: where they differ, in pairs and with the changes in a round left open. off: every "
        "round is one repeat, all around.",
        "Rhythm", Stage::cast_on, choice<&Settings::rhythm, &RhythmSettings::halves>(rhythm_halves_names),
        is_in_rhythm},
    ParameterInfo{"rhythm-simplicity", "Simplicity", "",
                  "How much a rhythm less is worth against the shape: 2.7 makes few, 0.03 keeps to the "
                  "shape. auto: six are "
                  "tried, and what reads best within the tolerance is taken.",
                  "Rhythm", Stage::cast_on,
                  Number{field<&Settings::rhythm, &RhythmSettings::dial>(), 0.0, 100.0, Zero::chosen},
                  is_in_rhythm},
    ParameterInfo{
        "short-rows", "Short rows", "",
        "Whether a tube that is longer on one side gets short rows there. auto: wherever they gain more "
        "than their turns cost. They need settling: unsettled, they are worse than none.",
        "Short rows", Stage::cast_on, choice<&Settings::short_rows, &ShortRowSettings::rows>(short_row_names),
        is_of_contours},
    ParameterInfo{
        "short-rows-kept", "Rows kept", "",
        "How many rows a tube keeps as they are where loops part or meet; the rest may get short rows. auto: "
        "0, 1, 2 and no short rows at all are settled, and what settles best is taken.",
        "Short rows", Stage::cast_on, choice<&Settings::short_rows, &ShortRowSettings::kept>(kept_names),
        has_short_rows},
    ParameterInfo{
        "turn-cost", "Price of a pair", "stitches",
        "What the two turns of a pair cost, in stitches that lag a row too much. More makes fewer pairs.",
        "Short rows", Stage::cast_on,
        Number{field<&Settings::short_rows, &ShortRowSettings::turn_cost>(), 0.0, 100.0, Zero::allowed},
        has_short_rows},
    ParameterInfo{
        "turn-step", "Turns apart", "stitches",
        "How many stitches the turns of neighbouring short rows stay apart.", "Short rows", Stage::cast_on,
        Number{field<&Settings::short_rows, &ShortRowSettings::turn_step>(), 1.0, 20.0}, has_short_rows},
    ParameterInfo{"short-row-min", "Shortest", "stitches", "No short row has fewer stitches than this.",
                  "Short rows", Stage::cast_on,
                  Count{field<&Settings::short_rows, &ShortRowSettings::shortest>(), 3, 1000},
                  has_short_rows},
    ParameterInfo{
        keys::metric, "Metric", "",
        "The ruler of Algorithm 2. euclidean: straight through the air, as in the thesis. arc: along "
        "the cycle. geodesic: the shortest way on the surface.",
        "Rows", Stage::rows, choice<&Settings::rows, &RowsSettings::metric>(metric_names), is_of_rings},
    ParameterInfo{
        keys::epsilon, "Epsilon \xCE\xB5", "mesh units",
        "Half the band's width: a vertex is accepted at a distance within [w - \xCE\xB5, w + \xCE\xB5]. The "
        "first one wins, so \xCE\xB5 sets the stitch length as much as w does.",
        "Rows", Stage::rows, Number{{epsilon}, 0.0, no_limit}, is_of_rings, Tie::width,
        "half the stitch width"},
    ParameterInfo{"on-stall", "On a stall", "",
                  "What happens when nothing is in the band. continue: take the vertex nearest to the stitch "
                  "width, and log it. stop: end the run there.",
                  "Rows", Stage::rows, choice<&Settings::rows, &RowsSettings::on_stall>(stall_names),
                  is_of_rings},
    ParameterInfo{
        "last-anchor", "Last anchor", "",
        "keep: the last vertex picked is always a stitch. drop: not when it is nearer than w/2 to the first.",
        "Rows", Stage::rows, choice<&Settings::rows, &RowsSettings::last_anchor>(anchor_names), is_of_rings},
    ParameterInfo{"resample", "Resample jumps", "",
                  "on: a row that more than doubles or halves is distributed again within that limit, and "
                  "logged. off: stop.",
                  "Rows", Stage::rows, choice<&Settings::rows, &RowsSettings::resample>(switch_names),
                  is_of_rings},
    ParameterInfo{
        "close", "Closing gap", "",
        "How the gap between last and first stitch is distributed: none, the thesis's shift, or equal arcs.",
        "Rows", Stage::rows, choice<&Settings::rows, &RowsSettings::close>(closing_names), is_of_rings},
    ParameterInfo{"placement", "Placement", "", placement_help, "Stitches", Stage::stitches,
                  choice<&Settings::stitches, &StitchSettings::placement>(placement_names)},
    ParameterInfo{
        "stacking-penalty", "Against stacking", "squared widths",
        "nearest: what it costs to place shaping above the shaping of the row before; 0 lets it "
        "stack.",
        "Stitches", Stage::stitches,
        Number{field<&Settings::stitches, &StitchSettings::stacking_penalty>(), 0.0, 1000.0, Zero::allowed},
        is_of_nearest},
    ParameterInfo{"follow-mains", "Follow the mains", "",
                  "nearest: on places all shaping beside main stitches, so that it runs in lines.",
                  "Stitches", Stage::stitches,
                  choice<&Settings::stitches, &StitchSettings::follow_mains>(off_on_names), is_of_nearest},
    ParameterInfo{
        "settle", "Settle", "",
        "Whether the stitches are moved on the surface, once all faces are made, until wales are h "
        "and courses w "
        "long as well as can be. No word of the pattern changes. auto: where rows come from contours; the "
        "mesh's own rings stay, as in the thesis.",
        "Settling", Stage::faces,  // its last step leads to settling or past it
        choice<&Settings::settle, &SettleSettings::settling>(settling_names)},
    ParameterInfo{"settle-wale", "Wales", "", "How much it counts that wales are h long.", "Settling",
                  Stage::settle, settle_weight<&SettleSettings::wale>(), is_settled},
    ParameterInfo{"settle-course", "Courses", "", "How much it counts that stitches are w wide.", "Settling",
                  Stage::settle, settle_weight<&SettleSettings::course>(), is_settled},
    ParameterInfo{"settle-shear", "Shear", "", "How much it counts that quads are square.", "Settling",
                  Stage::settle, settle_weight<&SettleSettings::shear>(), is_settled},
    ParameterInfo{"settle-rim", "Rims", "",
                  "How much it counts that the rims of openings stay where they were.", "Settling",
                  Stage::settle, settle_weight<&SettleSettings::rim>(), is_settled},
    ParameterInfo{"settle-fold", "Folds", "", "How much it counts that no face turns over.", "Settling",
                  Stage::settle, settle_weight<&SettleSettings::fold>(), is_settled},
    ParameterInfo{"settle-cover", "Cover", "",
                  "How much it counts that thin limbs and their ends stay covered.", "Settling",
                  Stage::settle, settle_weight<&SettleSettings::cover>(), is_settled},
    ParameterInfo{"settle-iterations", "Iterations", "", "After how many iterations it ends at the latest.",
                  "Settling", Stage::settle,
                  Count{field<&Settings::settle, &SettleSettings::most_iterations>(), 1, 500}, is_settled},
    ParameterInfo{
        keys::relax, "Relax", "",
        "Whether the piece is taken off the needles and stuffed, once all faces are made: its stitches "
        "leave the mesh and come to lie where equal stitches pull them. That tells its size and shape "
        "before it is knitted. No word of the pattern changes.",
        "Relaxing", Stage::faces,  // the last step before leads there or past it
        choice<&Settings::relax, &RelaxSettings::relaxing>(off_on_names)},
    ParameterInfo{
        "stuffing", "Stuffing", "",
        "How firmly it is stuffed: about the share by which stuffing stretches the fabric. none, soft "
        "(0.02), usual (0.03), firm (0.05), hard (0.1), or a number.",
        "Relaxing", Stage::relax,
        Number{field<&Settings::relax, &RelaxSettings::stuffing>(), 0.0, 0.5, Zero::allowed, stuffing_names},
        is_relaxed},
    ParameterInfo{"relax-iterations", "Most iterations", "",
                  "After how many iterations it ends at the latest.", "Relaxing", Stage::relax,
                  Count{field<&Settings::relax, &RelaxSettings::most_iterations>(), 1, 10000}, is_relaxed},
    ParameterInfo{
        "graft", "Seams by", "",
        "How two rims of live stitches become one seam, as at the top of a ring. kitchener: grafted, a seam "
        "that nobody sees, for a rounded toy. three-needle: bound off together where the stitches pair one "
        "by "
        "one; quicker and firmer, with a ridge, for a flat seam.",
        "Pattern", Stage::done, choice<&Settings::pattern, &PatternSettings::graft>(graft_names),
        is_of_contours},
};

}  // namespace

std::span<const ParameterInfo> parameter_table() { return table; }

}  // namespace knit
