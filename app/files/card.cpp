#include "app/files/card.h"

#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/session/document.h"
#include "app/session/remarks.h"
#include "app/session/shown.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

const char* const after_cast_on = "after the cast on";
const char* const after_stitches = "after the stitches";
const char* const after_faces = "after the faces";

std::size_t at(CardColumn column) { return static_cast<std::size_t>(column); }

CardFigure figure_of(std::string name, std::string text, std::string help) {
  return {"figure/" + std::move(name), std::move(text), std::move(help), false, {}};
}

FigureWay row_way(knit::RowId row) { return row > 0 ? FigureWay(FigureRow{row}) : FigureWay(); }
FigureWay course_way(const knit::EdgeAt& at) {
  return at.known() ? FigureWay(knit::Element(knit::RowEdgeElement{at.row, at.edge})) : FigureWay();
}
FigureWay wale_way(const knit::EdgeAt& at) {
  return at.known() ? FigureWay(knit::Element(knit::ColumnEdgeElement{at.row, at.edge})) : FigureWay();
}
FigureWay stitch_way(const knit::StitchRef& at) {
  return at.row != 0 ? FigureWay(knit::Element(knit::StitchElement{at.row, at.stitch})) : FigureWay();
}

CardFigure judged(CardFigure figure, Judged what, double value) {
  figure.outside = is_outside(what, value);
  if (figure.outside) {
    const auto bound =
        std::find_if(bounds.begin(), bounds.end(), [&](const Bound& b) { return b.figure == what; });
    figure.help += " A knitter would want at most " + std::string(bound->words) + ".";
  }
  return figure;
}

// Words of a kind of edge, for both lines of lengths.
struct EdgeWords {
  std::string name, title, edges, unit, units;
};

CardLine spread_line(const EdgeWords& words, const knit::Spread& spread, Judged cv, knit::Measured of) {
  CardLine line{words.name,
                words.title,
                "/ " + words.unit,
                "Lengths of " + words.edges + ", counted in " + words.units + "; 1 is right.",
                {},
                "",
                false};
  const auto put = [&](CardColumn column, const char* key, double value, int decimals,
                       const std::string& help) -> CardFigure& {
    line.figures[at(column)] = figure_of(words.name + "/" + key, fixed_text(value, decimals), help);
    return *line.figures[at(column)];
  };
  put(CardColumn::mean, "mean", spread.mean, 2,
      "Mean length of " + words.edges + ", counted in " + words.units + "; 1 is right.");
  CardFigure& uneven = put(CardColumn::cv, "cv", spread.cv, 3,
                           "Coefficient of variation: standard deviation of the lengths of " + words.edges +
                               " over their mean; 0 is perfectly even.");
  uneven = judged(std::move(uneven), cv, spread.cv);
  put(CardColumn::p95, "p95", spread.p95, 2, "95 % of " + words.edges + " are no longer than this.").way =
      knit::SizeRange{of, spread.p95};
  put(CardColumn::max, "max", spread.high, 2,
      "The longest of " + words.edges + "; the shortest is " + fixed_text(spread.low, 2) + ".");
  return line;
}

CardLine course_line(const knit::Quality& quality, Judged judge) {
  const EdgeWords words{"course", "Course", "all course edges (along the rows)", "w", "stitch widths w"};
  CardLine line = spread_line(words, quality.course, judge, knit::Measured::course);
  line.figures[at(CardColumn::max)]->way = course_way(quality.longest_course);
  line.figures[at(CardColumn::cv)]->way = row_way(quality.uneven_row);
  if (quality.long_course.count > 0) {
    line.figures[at(CardColumn::cv)]->help +=
        " In rows of 12 stitches or more: " + fixed_text(quality.long_course.cv, 3) +
        "; in the worst row: " + fixed_text(quality.worst_course_cv_in_row, 3) + ".";
  }
  return line;
}

CardLine wale_line(const knit::Quality& quality) {
  const EdgeWords words{"wale", "Wale", "all wale edges (from row to row)", "h", "stitch heights h"};
  CardLine line = spread_line(words, quality.wale, Judged::wale_cv, knit::Measured::wale);
  line.figures[at(CardColumn::max)]->way = wale_way(quality.longest_wale);
  // What makes wales uneven are the long ones.
  if (quality.wale.high > knit::stretched_above)
    line.figures[at(CardColumn::cv)]->way = knit::SizeRange{knit::Measured::wale, knit::stretched_above};
  std::optional<CardFigure>& most = line.figures[at(CardColumn::max)];
  most = judged(std::move(*most), Judged::longest_wale, quality.wale.high);
  return line;
}

CardLine sideways_line(const knit::Quality& quality) {
  CardLine line{"sideways", "Sideways",
                "/ w",      "How far wale edges lean along their rows, in stitch widths w; 0 is upright.",
                {},         ""};
  line.figures[at(CardColumn::max)] =
      judged(figure_of("sideways", fixed_text(quality.offset, 2),
                       "The farthest that a wale edge leans along its rows, in stitch widths w; between rows "
                       "of 12 stitches or more: " +
                           fixed_text(quality.long_offset, 2) + "."),
             Judged::sideways, quality.offset);
  line.figures[at(CardColumn::max)]->way = wale_way(quality.leans_most);
  return line;
}

CardLine mirror_line(const knit::Quality& quality) {
  CardLine line{
      "mirror", "Mirror error",
      "/ w",    "How far the left half is from being the right half's mirror image, in stitch widths w.",
      {},       ""};
  if (!quality.mirror) {
    line.missing = "no mirror plane";
    return line;
  }
  const std::string help =
      " that wale edges lie from where their mirror image would be, in the plane of the axis and the "
      "rounds' beginning, in stitch widths w.";
  line.figures[at(CardColumn::mean)] =
      figure_of("mirror/mean", fixed_text(quality.mirror->mean, 2), "How far in the mean" + help);
  line.figures[at(CardColumn::max)] =
      figure_of("mirror/max", fixed_text(quality.mirror->max, 2), "How far at most" + help);
  return line;
}

CardLine distance_line(const char* name, const char* words, const knit::Distances& distances, double diagonal,
                       const std::string& whose) {
  CardLine line{name, words, "%", "Distances from " + whose + ", as % of the bounding box's diagonal.",
                {},   ""};
  const auto percent = [&](double distance) {
    return fixed_text(diagonal > 0.0 ? 100.0 * distance / diagonal : 0.0, 2);
  };
  line.figures[at(CardColumn::mean)] =
      figure_of(std::string(name) + "/mean", percent(distances.mean),
                "Mean distance from " + whose + ", as % of the bounding box's diagonal.");
  line.figures[at(CardColumn::max)] =
      figure_of(std::string(name) + "/max", percent(distances.max),
                "Greatest distance from " + whose + ", as % of the bounding box's diagonal.");
  return line;
}

CardLine knit_to_mesh_line(const knit::Closeness& closeness) {
  const knit::Distances& distances = closeness.knit_to_mesh;
  CardLine line = distance_line("knit-to-mesh", "Knit to mesh", distances, closeness.diagonal,
                                "the knit mesh to the mesh that came in");
  std::optional<CardFigure>& most = line.figures[at(CardColumn::max)];
  const double share = closeness.diagonal > 0.0 ? distances.max / closeness.diagonal : 0.0;
  most = judged(std::move(*most), Judged::knit_to_mesh, share);
  return line;
}

CardLine mesh_to_knit_line(const knit::Closeness& closeness) {
  return distance_line("mesh-to-knit", "Mesh to knit", closeness.mesh_to_knit, closeness.diagonal,
                       "the mesh that came in to the knit mesh, open ends and all");
}

// One figure that belongs under no head.
CardLine single_line(std::string name, const char* words, const char* unit, const char* help,
                     CardFigure figure) {
  CardLine line{std::move(name), words, unit, help, {}, "", true};
  line.figures[at(CardColumn::max)] = std::move(figure);
  return line;
}

// Of a closeness that came with its coverage, or of none.
CardLine uncovered_line(const knit::Closeness& closeness) {
  const knit::Coverage none;
  const knit::Coverage& coverage = closeness.coverage ? *closeness.coverage : none;
  std::string where = "Share of the surface that no row covers, in %.";
  for (const knit::UncoveredPlace& place : coverage.uncovered.places) {
    where += (&place == &coverage.uncovered.places.front() ? " At " : ", ") +
             knit::vertex_text(place.vertex) + ": " + knit::percent_text(place.share);
  }
  if (!coverage.uncovered.places.empty()) where += ".";
  CardLine line = single_line("uncovered", "Uncovered", "%", "Share of the surface that no row covers.",
                              figure_of("uncovered", fixed_text(100.0 * coverage.uncovered.share, 1), where));
  if (!coverage.uncovered.places.empty())
    line.figures[at(CardColumn::max)]->way =
        knit::Element(knit::VertexElement{coverage.uncovered.places.front().vertex});
  return line;
}

CardLine stretched_line(const knit::Closeness& closeness) {
  const knit::Coverage none;
  const knit::Coverage& coverage = closeness.coverage ? *closeness.coverage : none;
  std::int64_t rows = 0;
  const knit::Stretched* worst = nullptr;
  for (const knit::Stretched& stretched : coverage.stretched) {
    rows += stretched.to - stretched.from + 1;
    if (worst == nullptr || stretched.longest > worst->longest) worst = &stretched;
  }
  std::string help = "Rows with wales longer than 1.5 h";
  help += worst != nullptr ? "; the longest has " + fixed_text(worst->longest, 2) + " h." : ".";
  CardLine line = single_line("stretched", "Stretched rows", "",
                              "How many rows have wales longer than 1.5 stitch heights.",
                              figure_of("stretched", std::to_string(rows), help));
  if (worst != nullptr) line.figures[at(CardColumn::max)]->way = stitch_way(worst->at);
  return line;
}

std::string share_text(double part) { return fixed_text(100.0 * part, 1); }

CardLine quads_line(const knit::Quality& quality) {
  return single_line("quads", "Quads", "%", "Share of the faces with four corners.",
                     figure_of("quads", share_text(quality.quad_share),
                               "Share of the faces that have four corners, in %; the others have three."));
}

CardLine regular_line(const knit::Quality& quality) {
  return single_line(
      "regular", "Regular stitches", "%", "Share of the stitches with one below and one above.",
      figure_of("regular", share_text(quality.regular_share),
                "Share of the stitches between first and last row that have one stitch below and one above, "
                "in %."));
}

CardLine increases_line(const knit::Quality& quality) {
  return single_line("increases", "Increases", "", "Stitches that the pattern adds.",
                     figure_of("increases", std::to_string(quality.shaping.increases),
                               "Stitches that the pattern adds, m1l and m1r together."));
}

CardLine decreases_line(const knit::Quality& quality) {
  return single_line("decreases", "Decreases", "", "Stitches that the pattern takes away.",
                     figure_of("decreases", std::to_string(quality.shaping.decreases),
                               "Stitches that the pattern takes away, k2tog and ssk together."));
}

CardLine most_line(const knit::Quality& quality) {
  const std::string steady = std::to_string(quality.steady_shaping);
  CardLine line{"most",
                "Most shaping a row",
                "(steady: " + steady + ")",
                "Most increases or decreases in one row; steady is how many a flat disc takes in every row.",
                {},
                "",
                true};
  const double share = quality.steady_shaping > 0 ? static_cast<double>(quality.shaping.max_in_a_row) /
                                                        static_cast<double>(quality.steady_shaping)
                                                  : 0.0;
  line.figures[at(CardColumn::max)] = judged(
      figure_of("most", std::to_string(quality.shaping.max_in_a_row),
                "Most increases or decreases in one row; a flat disc takes " + steady + " in every row."),
      Judged::most_in_a_row, share);
  line.figures[at(CardColumn::max)]->way = row_way(quality.most_shaped_row);
  return line;
}

CardLine area_line(const knit::Closeness& closeness) {
  const char* const help = "Area of the knit mesh over that of the mesh that came in; 1 is right.";
  const double ratio = closeness.mesh_area > 0.0 ? closeness.knit_area / closeness.mesh_area : 0.0;
  return single_line("area", "Area, knit / mesh", "", help, figure_of("area", fixed_text(ratio, 3), help));
}

// --- placed and settled -----------------------------------------------------------------------------------------

// How far stitches went.
CardLine moved_line(const SettledFigures& both) {
  const double width = both.settled.stitch_width;
  const std::string after = " from where they were placed to where they are at ease, after " +
                            knit::plural(both.iterations, "iteration", "iterations") + ".";
  CardLine line{"moved", "Moved", "/ w", "How far stitches went while settling, in stitch widths w.", {}, ""};
  line.figures[at(CardColumn::mean)] = figure_of("moved/mean", fixed_text(both.moves.mean / width, 2),
                                                 "How far stitches went in the mean" + after);
  line.figures[at(CardColumn::max)] = figure_of("moved/max", fixed_text(both.moves.most / width, 2),
                                                "How far the stitch that went farthest went" + after);
  line.figures[at(CardColumn::max)]->way = stitch_way(both.moves.of);
  return line;
}

// One figure of both: how it was where stitches were placed, and how it is.
struct BothWords {
  std::string name, title, unit, help;
};
CardLine both_line(const BothWords& words, std::array<double, 2> values, int decimals,
                   std::optional<Judged> judge = std::nullopt) {
  CardFigure placed = figure_of("placed/" + words.name, fixed_text(values[0], decimals),
                                "As stitches were placed: " + words.help);
  CardFigure settled = figure_of("settled/" + words.name, fixed_text(values[1], decimals),
                                 "Where they settled: " + words.help);
  if (judge) settled = judged(std::move(settled), *judge, values[1]);
  CardLine line{"both/" + words.name,
                words.title,
                words.unit,
                "As stitches were placed, and where they settled: " + words.help,
                {},
                ""};
  line.figures[at(CardColumn::p95)] = std::move(placed);
  line.figures[at(CardColumn::max)] = std::move(settled);
  return line;
}

// Of both closenesses, in per cent of the diagonal.
CardLine both_distances(const BothWords& words, const knit::Closeness& settled,
                        knit::Distances knit::Closeness::*which) {
  const auto percent = [&](const knit::Closeness& closeness) {
    return closeness.diagonal > 0.0 ? 100.0 * (closeness.*which).max / closeness.diagonal : 0.0;
  };
  return both_line(words, {percent(*settled.placed), percent(settled)}, 2);
}

void add_measured(const knit::Closeness& settled, std::vector<CardLine>& lines) {
  const knit::Closeness& placed = *settled.placed;
  if (settled.coverage && placed.coverage) {
    const auto turned = [](const knit::Closeness& c) {
      return static_cast<double>(c.coverage->turned.faces);
    };
    lines.push_back(both_line({"turned", "Faces turned over", "", "faces that lie with their inside out."},
                              {turned(placed), turned(settled)}, 0, Judged::turned));
  }
  const std::string share = ", as % of the diagonal.";
  lines.push_back(both_distances(
      {"knit-to-mesh", "Knit to mesh", "%", "the greatest distance from the knit mesh to the mesh" + share},
      settled, &knit::Closeness::knit_to_mesh));
  lines.push_back(both_distances(
      {"mesh-to-knit", "Mesh to knit", "%", "the greatest distance from the mesh to the knit mesh" + share},
      settled, &knit::Closeness::mesh_to_knit));
}

CardGroup settled_group(const SettledFigures& both, const knit::Closeness* closeness) {
  const knit::Quality &p = both.placed, &s = both.settled;
  CardGroup group{true, {}, settled_heads};
  group.lines = {
      both_line({"wale-cv", "Wale CV", "", "how uneven wale edges are, standard deviation over mean."},
                {p.wale.cv, s.wale.cv}, 3, Judged::wale_cv),
      both_line({"wale-max", "Longest wale", "/ h", "the longest wale edge, in stitch heights h."},
                {p.wale.high, s.wale.high}, 2),
      both_line({"course-cv", "Course CV", "", "how uneven course edges are, standard deviation over mean."},
                {p.course.cv, s.course.cv}, 3, Judged::settled_course_cv),
      both_line({"corner", "Corners off square", "\xC2\xB0",
                 "how far quads' corners are from 90 degrees, in the mean."},
                {p.corner_off.mean, s.corner_off.mean}, 1)};
  group.lines[1].figures[at(CardColumn::max)]->way = wale_way(s.longest_wale);
  group.lines[2].figures[at(CardColumn::max)]->way = row_way(s.uneven_row);
  if (closeness != nullptr && closeness->placed) add_measured(*closeness, group.lines);
  return group;
}

CardLine missing_line(CardLine line, std::string why) {
  for (auto& figure : line.figures) figure.reset();
  line.unit = line.name == "most" ? "" : line.unit;
  line.missing = std::move(why);
  return line;
}

}  // namespace

std::string_view click_words(const FigureWay& way) {
  if (std::holds_alternative<FigureRow>(way)) return "Click: to this row.";
  if (std::holds_alternative<knit::SizeRange>(way)) return "Click: the longer ones light up in the view.";
  const auto* thing = std::get_if<knit::Element>(&way);
  if (thing == nullptr) return "";
  if (std::holds_alternative<knit::VertexElement>(*thing))
    return "Click: the view turns to the largest part.";
  if (std::holds_alternative<knit::StitchElement>(*thing)) return "Click: the view turns to this stitch.";
  return "Click: the view turns to this edge.";
}

std::string_view help_of_head(std::string_view head) {
  if (head == "mean") return "The mean of all values.";
  if (head == "CV") return "Coefficient of variation: standard deviation over mean; 0 is perfectly even.";
  if (head == "95 %") return "95 % of the values are no larger than this.";
  if (head == "max") return "The largest of all values.";
  if (head == "placed") return "Where the rows put the stitches.";
  if (head == "settled") return "Where the stitches are at ease.";
  return "";
}

bool is_outside(Judged figure, double value) {
  return std::any_of(bounds.begin(), bounds.end(),
                     [&](const Bound& bound) { return bound.figure == figure && value > bound.most; });
}

const knit::Closeness* closeness_shown(const knit::Closeness* closeness, Positions positions) {
  if (closeness == nullptr) return nullptr;
  if (positions == Positions::placed && closeness->placed) return closeness->placed.get();
  if (positions == Positions::relaxed && closeness->relaxed) return closeness->relaxed.get();
  return closeness;
}

std::optional<SettledFigures> settled_figures(const knit::Timeline& timeline) {
  const auto moves = knit::measure_moves(timeline.state());
  if (!moves) return std::nullopt;
  const knit::StitchSize& stitch = timeline.parameters().stitch;
  const auto quality_of = [&](const knit::State& state) {
    return knit::measure_quality(timeline.input(), state, stitch.width, stitch.height);
  };
  SettledFigures both{quality_of(knit::placed_state(timeline.state())), quality_of(timeline.state()), *moves};
  for (std::size_t i = timeline.position_of({knit::Stage::settle, 0, -1}); i < timeline.position(); ++i) {
    if (timeline.step(i).place.stage != knit::Stage::settle) break;
    const auto* settled = knit::get_if<knit::StitchesSettled>(timeline.step(i));
    if (settled != nullptr && settled->taken) ++both.iterations;
  }
  return both;
}

std::vector<CardGroup> card_groups(const CardFigures& known) {
  const knit::Quality none;
  const knit::Quality& q = known.quality != nullptr ? *known.quality : none;
  const knit::Closeness* closeness = closeness_shown(known.closeness, known.shown);
  const bool settled = known.both != nullptr && known.shown == Positions::settled;
  const knit::Closeness unmeasured;
  const knit::Closeness& c = closeness != nullptr ? *closeness : unmeasured;
  const bool rows = q.course.count > 0;
  const bool strips = q.wale.count > 0;
  const bool stitches = strips || q.shaping.increases + q.shaping.decreases > 0;
  const auto when = [](bool there, CardLine line, const char* why) {
    return there ? std::move(line) : missing_line(std::move(line), why);
  };
  const char* const no_closeness = known.measuring ? "measuring..." : "after the run";
  const auto measured = [&](CardLine line) {
    return closeness != nullptr ? std::move(line) : missing_line(std::move(line), no_closeness);
  };
  const auto covered = [&](CardLine line) {
    return closeness == nullptr || c.coverage ? measured(std::move(line))
                                              : missing_line(std::move(line), after_faces);
  };
  const Judged course = settled ? Judged::settled_course_cv : Judged::course_cv;
  std::vector<CardGroup> groups{
      {true,
       {when(rows, course_line(q, course), after_cast_on), when(strips, wale_line(q), after_faces),
        when(strips, sideways_line(q), after_faces), when(strips, mirror_line(q), after_faces)}},
      {false, {measured(knit_to_mesh_line(c)), measured(mesh_to_knit_line(c))}},
      {false,
       {covered(uncovered_line(c)), covered(stretched_line(c)), when(strips, quads_line(q), after_faces),
        when(strips, regular_line(q), after_faces), when(stitches, increases_line(q), after_stitches),
        when(stitches, decreases_line(q), after_stitches), measured(area_line(c)),
        when(stitches, most_line(q), after_stitches)}}};
  if (known.both == nullptr) return groups;
  // Both distances stand side by side then.
  if (known.closeness != nullptr && known.closeness->placed)
    std::erase_if(groups[1].lines, [](const CardLine& line) {
      return line.name.ends_with("-to-knit") || line.name.ends_with("-to-mesh");
    });
  std::erase_if(groups, [](const CardGroup& group) { return group.lines.empty(); });
  groups.front().lines.push_back(moved_line(*known.both));
  groups.insert(groups.begin() + 1, settled_group(*known.both, known.closeness));
  return groups;
}

namespace {

constexpr std::size_t words_width = 36;
constexpr std::size_t number_width = 10;

std::string right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}
std::string left(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

// Words and figure of a line that stands under no head.
std::string single_text(const CardLine& line) {
  const auto& figure = line.figures[at(CardColumn::max)];
  std::string text = left(line.words + (line.unit.empty() ? "" : " " + line.unit), words_width);
  if (!line.missing.empty()) return text + right("-", number_width) + "  " + line.missing + "\n";
  return text + right(figure->text + (figure->outside ? "*" : ""), number_width) + "\n";
}

std::string line_text(const CardLine& line) {
  if (line.single) return single_text(line);
  std::string text = left(line.words + (line.unit.empty() ? "" : " " + line.unit), words_width);
  if (!line.missing.empty()) return text + right("-", number_width) + "  " + line.missing + "\n";
  for (const auto& figure : line.figures) {
    // A star marks what a knitter would rather not see.
    const std::string number = figure ? figure->text + (figure->outside ? "*" : " ") : "";
    text += right(number, number_width);
  }
  while (text.back() == ' ') text.pop_back();
  return text + "\n";
}

std::string heads_text(const CardHeads& heads) {
  std::string text = left("", words_width);
  for (const std::string_view head : heads) text += right(std::string(head) + " ", number_width);
  text.pop_back();
  return text + "\n";
}

std::string rows_text(const knit::Quality& quality) {
  std::string text = "\n" + left("row", 6) + right("stitches", number_width) + right("length / w", 12) +
                     right("course CV", 12) + "\n";
  for (const knit::RowFit& row : quality.rows) {
    text += left(std::to_string(row.row), 6) + right(std::to_string(row.stitches), number_width) +
            right(fixed_text(row.ideal, 2), 12) + right(fixed_text(row.course_cv, 4), 12) + "\n";
  }
  return text;
}

std::string remarks_text(const std::vector<knit::Remark>& remarks) {
  std::string text = remarks.empty() ? "" : "\nNot as asked:\n";
  for (const knit::Remark& remark : remarks) text += "- " + remark.words + "\n";
  return text;
}

// Where there is more than one.
std::string tubes_text(const knit::Quality& quality) {
  if (quality.tubes.size() < 2) return "";
  std::string text = "\n" + left("tube", 6) + right("rounds", number_width) +
                     right("stitches", number_width) + right("wale CV", 12) + right("longest / h", 13) +
                     right("course CV", 12) + "\n";
  for (const knit::TubeFit& tube : quality.tubes) {
    const bool wales = tube.wales > 0;
    text += left(knit::tube_name(tube.tube), 6) + right(std::to_string(tube.rounds), number_width) +
            right(std::to_string(tube.stitches), number_width) +
            right(wales ? fixed_text(tube.wale_cv, 3) : "-", 12) +
            right(wales ? fixed_text(tube.longest_wale, 2) : "-", 13) +
            right(fixed_text(tube.worst_course_cv_in_row, 4), 12) + "\n";
  }
  return text;
}

}  // namespace

std::string card_text(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::Parameters& p = timeline.parameters();
  const knit::Quality quality =
      knit::measure_quality(timeline.input(), shown_state(session), p.stitch.width, p.stitch.height);
  const auto both = settled_figures(timeline);
  const auto closeness = closeness_now(*session.document);
  std::string text = "Report card of " + timeline.input().mesh.name + std::string(shown_words(session)) +
                     ": stitch width w = " + knit::number_text(quality.stitch_width) +
                     ", stitch height h = " + knit::number_text(quality.stitch_height) + " mesh units\n\n";
  const CardFigures known{&quality, closeness.get(), both ? &*both : nullptr, session.view->positions};
  for (const CardGroup& group : card_groups(known)) {
    if (group.headed) text += heads_text(group.heads);
    if (group.lines.front().single) text += "\n";
    for (const CardLine& line : group.lines) text += line_text(line);
  }
  const bool measured = closeness && closeness->coverage;
  const auto remarks = timeline.state().finished()
                           ? remarks_of(timeline, measured ? &*closeness->coverage : nullptr)
                           : std::vector<knit::Remark>();
  return text + "* more than a knitter would want\n" + remarks_text(remarks) + tubes_text(quality) +
         rows_text(quality);
}

}  // namespace app
