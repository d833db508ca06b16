#include "app/files/card.h"

#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/session/document.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

const char* const after_cast_on = "after the cast on";
const char* const after_stitches = "after the stitches";
const char* const after_faces = "after the faces";

std::size_t at(CardColumn column) { return static_cast<std::size_t>(column); }

CardFigure figure_of(std::string name, std::string text, std::string help) {
  return {"figure/" + std::move(name), std::move(text), std::move(help), false};
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

CardLine spread_line(const EdgeWords& words, const knit::Spread& spread, Judged cv) {
  CardLine line{words.name,
                words.title,
                "/ " + words.unit,
                "Lengths of " + words.edges + ", counted in " + words.units + "; 1 is right.",
                {},
                ""};
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
  put(CardColumn::p95, "p95", spread.p95, 2, "95 % of " + words.edges + " are no longer than this.");
  put(CardColumn::max, "max", spread.high, 2,
      "The longest of " + words.edges + "; the shortest is " + fixed_text(spread.low, 2) + ".");
  return line;
}

CardLine course_line(const knit::Quality& quality) {
  const EdgeWords words{"course", "Course", "all course edges (along the rows)", "w", "stitch widths w"};
  CardLine line = spread_line(words, quality.course, Judged::course_cv);
  if (quality.long_course.count > 0) {
    line.figures[at(CardColumn::cv)]->help +=
        " In rows of 12 stitches or more: " + fixed_text(quality.long_course.cv, 3) +
        "; in the worst row: " + fixed_text(quality.worst_course_cv_in_row, 3) + ".";
  }
  return line;
}

CardLine wale_line(const knit::Quality& quality) {
  const EdgeWords words{"wale", "Wale", "all wale edges (from row to row)", "h", "stitch heights h"};
  return spread_line(words, quality.wale, Judged::wale_cv);
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

// Two figures of one kind, in the last two columns.
CardLine pair_line(std::string name, const char* words, const char* unit, const char* help, CardFigure first,
                   CardFigure second) {
  CardLine line{std::move(name), words, unit, help, {}, ""};
  line.figures[at(CardColumn::p95)] = std::move(first);
  line.figures[at(CardColumn::max)] = std::move(second);
  return line;
}

// Of a closeness that came with its coverage.
CardLine uncovered_line(const knit::Closeness& closeness) {
  const knit::Coverage none;
  const knit::Coverage& coverage = closeness.coverage ? *closeness.coverage : none;
  std::int64_t rows = 0;
  double longest = 0.0;
  for (const knit::Stretched& stretched : coverage.stretched) {
    rows += stretched.to - stretched.from + 1;
    longest = std::max(longest, stretched.longest);
  }
  std::string where = "Share of the surface that no row covers, in %.";
  for (const knit::UncoveredPlace& place : coverage.uncovered.places) {
    where += (&place == &coverage.uncovered.places.front() ? " At " : ", ") +
             knit::vertex_text(place.vertex) + ": " + knit::percent_text(place.share);
  }
  if (!coverage.uncovered.places.empty()) where += ".";
  std::string stretched = "Rows with wales longer than 1.5 h";
  stretched += rows > 0 ? "; the longest has " + fixed_text(longest, 2) + " h." : ".";
  return pair_line(
      "uncovered", "Uncovered, stretched rows", "%",
      "Share of the surface that no row covers; rows whose wales are longer than 1.5 stitch heights.",
      figure_of("uncovered", fixed_text(100.0 * coverage.uncovered.share, 1), where),
      figure_of("stretched", std::to_string(rows), stretched));
}

CardLine quads_line(const knit::Quality& quality) {
  const auto share = [](double part) { return fixed_text(100.0 * part, 1); };
  return pair_line(
      "quads", "Quads, regular stitches", "%",
      "Share of the faces with four corners, and of the stitches with one below and one above.",
      figure_of("quads", share(quality.quad_share), "Share of the faces that have four corners, in %."),
      figure_of("regular", share(quality.regular_share),
                "Share of the stitches between first and last row that have one stitch below and one above, "
                "in %."));
}

CardLine shaping_line(const knit::Quality& quality) {
  return pair_line("shaping", "Increases, decreases", "", "Stitches that the pattern adds, and takes away.",
                   figure_of("increases", std::to_string(quality.shaping.increases),
                             "Stitches that the pattern adds, m1l and m1r together."),
                   figure_of("decreases", std::to_string(quality.shaping.decreases),
                             "Stitches that the pattern takes away, k2tog and ssk together."));
}

CardLine most_line(const knit::Quality& quality) {
  const std::string steady = std::to_string(quality.steady_shaping);
  CardLine line{"most",
                "Most in a row",
                "(steady: " + steady + ")",
                "Most increases or decreases in one row, beside what a flat disc takes in every row.",
                {},
                ""};
  const double share = quality.steady_shaping > 0 ? static_cast<double>(quality.shaping.max_in_a_row) /
                                                        static_cast<double>(quality.steady_shaping)
                                                  : 0.0;
  line.figures[at(CardColumn::max)] = judged(
      figure_of("most", std::to_string(quality.shaping.max_in_a_row),
                "Most increases or decreases in one row; a flat disc takes " + steady + " in every row."),
      Judged::most_in_a_row, share);
  return line;
}

CardLine area_line(const knit::Closeness& closeness) {
  const char* const help = "Area of the knit mesh over that of the mesh that came in; 1 is right.";
  CardLine line{"area", "Area, knit / mesh", "", help, {}, ""};
  const double ratio = closeness.mesh_area > 0.0 ? closeness.knit_area / closeness.mesh_area : 0.0;
  line.figures[at(CardColumn::max)] = figure_of("area", fixed_text(ratio, 3), help);
  return line;
}

CardLine missing_line(CardLine line, std::string why) {
  for (auto& figure : line.figures) figure.reset();
  line.unit = line.name == "most" ? "" : line.unit;
  line.missing = std::move(why);
  return line;
}

}  // namespace

bool is_outside(Judged figure, double value) {
  return std::any_of(bounds.begin(), bounds.end(),
                     [&](const Bound& bound) { return bound.figure == figure && value > bound.most; });
}

std::vector<CardGroup> card_groups(const knit::Quality* quality, const knit::Closeness* closeness,
                                   bool measuring) {
  const knit::Quality none;
  const knit::Quality& q = quality != nullptr ? *quality : none;
  const knit::Closeness unmeasured;
  const knit::Closeness& c = closeness != nullptr ? *closeness : unmeasured;
  const bool rows = q.course.count > 0;
  const bool strips = q.wale.count > 0;
  const bool stitches = strips || q.shaping.increases + q.shaping.decreases > 0;
  const auto when = [](bool there, CardLine line, const char* why) {
    return there ? std::move(line) : missing_line(std::move(line), why);
  };
  const char* const no_closeness = measuring ? "measuring..." : "after the run";
  const auto measured = [&](CardLine line) {
    return closeness != nullptr ? std::move(line) : missing_line(std::move(line), no_closeness);
  };
  return {{true,
           {when(rows, course_line(q), after_cast_on), when(strips, wale_line(q), after_faces),
            when(strips, sideways_line(q), after_faces), when(strips, mirror_line(q), after_faces)}},
          {false,
           {measured(knit_to_mesh_line(c)), measured(mesh_to_knit_line(c)),
            closeness == nullptr || c.coverage ? measured(uncovered_line(c))
                                               : missing_line(uncovered_line(c), after_faces)}},
          {false,
           {measured(area_line(c)), when(strips, quads_line(q), after_faces),
            when(stitches, shaping_line(q), after_stitches), when(stitches, most_line(q), after_stitches)}}};
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

std::string line_text(const CardLine& line) {
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

std::string rows_text(const knit::Quality& quality) {
  std::string text = "\n" + left("row", 6) + right("stitches", number_width) + right("length / w", 12) +
                     right("course CV", 12) + "\n";
  for (const knit::RowFit& row : quality.rows) {
    text += left(std::to_string(row.row), 6) + right(std::to_string(row.stitches), number_width) +
            right(fixed_text(row.ideal, 2), 12) + right(fixed_text(row.course_cv, 4), 12) + "\n";
  }
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
      knit::measure_quality(timeline.input(), timeline.state(), p.stitch.width, p.stitch.height);
  const auto closeness = closeness_now(*session.document);
  std::string text = "Report card of " + timeline.input().mesh.name +
                     ": stitch width w = " + knit::number_text(quality.stitch_width) +
                     ", stitch height h = " + knit::number_text(quality.stitch_height) + " mesh units\n\n";
  text += left("", words_width);
  for (const char* column : {"mean ", "CV ", "95 % ", "max "}) text += right(column, number_width);
  text.pop_back();
  text += "\n";
  for (const CardGroup& group : card_groups(&quality, closeness.get(), false)) {
    for (const CardLine& line : group.lines) text += line_text(line);
  }
  return text + "* more than a knitter would want\n" + tubes_text(quality) + rows_text(quality);
}

}  // namespace app
