#include "app/explain/why_words.h"

#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "knit/insight/narrate.h"
#include "knit/model/words.h"
#include "knit/rows/rows.h"

namespace app {

namespace {

std::string str(std::int64_t number) { return std::to_string(number); }

// Keys in the order of Element's alternatives.
constexpr std::array<std::string_view, 6> keys{"stitch", "edge", "column", "face", "label", "vertex"};

struct RowAndItem {
  std::int32_t row, item;
};
struct Parts {
  RowAndItem operator()(const knit::StitchElement& s) const { return {s.row, s.stitch}; }
  RowAndItem operator()(const knit::RowEdgeElement& e) const { return {e.row, e.stitch}; }
  RowAndItem operator()(const knit::ColumnEdgeElement& e) const { return {e.row, e.edge}; }
  RowAndItem operator()(const knit::FaceElement& f) const { return {f.row, f.face}; }
  RowAndItem operator()(const knit::LabelElement& l) const { return {l.row, l.cell}; }
  RowAndItem operator()(const knit::VertexElement& /*v*/) const { return {0, 0}; }
};

knit::Element thing_of(std::size_t key, const RowAndItem& at) {
  switch (key) {
    case 0:
      return knit::StitchElement{at.row, at.item};
    case 1:
      return knit::RowEdgeElement{at.row, at.item};
    case 2:
      return knit::ColumnEdgeElement{at.row, at.item};
    case 3:
      return knit::FaceElement{at.row, at.item};
    default:
      return knit::LabelElement{at.row, at.item};
  }
}

struct ElementWords {
  std::string operator()(const knit::StitchElement& s) const {
    return "stitch " + str(s.stitch + 1) + " of row " + str(s.row);
  }
  std::string operator()(const knit::RowEdgeElement& e) const {
    return "row edge " + str(e.stitch + 1) + " of row " + str(e.row);
  }
  std::string operator()(const knit::ColumnEdgeElement& e) const {
    return "column edge " + str(e.edge + 1) + " into row " + str(e.row);
  }
  std::string operator()(const knit::FaceElement& f) const {
    return "face " + str(f.face + 1) + " into row " + str(f.row);
  }
  std::string operator()(const knit::LabelElement& l) const {
    return "label of cell " + str(l.cell) + " into row " + str(l.row);
  }
  std::string operator()(const knit::VertexElement& v) const { return "vertex " + str(v.vertex); }
};

std::string said_by(const knit::Timeline& timeline, std::size_t step) {
  return knit::narrate(timeline.step(step), timeline.parameters_of_step(step));
}

std::string refusal_words(const knit::Timeline& timeline, const knit::VertexStory& story) {
  const auto* s = knit::get_if<knit::CandidateMeasured>(timeline.step(*story.decided));
  if (s == nullptr) return "";
  const knit::Parameters& parameters = timeline.parameters_of_step(*story.decided);
  const knit::Band band = knit::band_of(parameters.rows, parameters.stitch);
  return "Passed over in row " + str(story.row) + ": it lies " + knit::short_number(s->distance) +
         " from stitch " + str(s->stitch) + ", too " +
         (s->verdict == knit::Verdict::too_near ? "near" : "far") + " for the band " +
         knit::short_number(band.low) + " to " + knit::short_number(band.high) + ".";
}

std::string vertex_words(const knit::Timeline& timeline, const knit::VertexElement& v) {
  const knit::VertexStory story = knit::story_of(timeline, v.vertex);
  const std::string row = "row " + str(story.row);
  switch (story.fate) {
    case knit::Fate::unused:
      return "No triangle has this vertex; it makes no row.";
    case knit::Fate::no_row:
      return "Its level makes no row: it lies before the cast on or after the last row.";
    case knit::Fate::cut_rows:
      return "Rows are cut through the surface here; no vertex is a candidate.";
    case knit::Fate::cast_on:
      return "It lies on the cast on's cycle, along which the stitches are spread evenly.";
    case knit::Fate::not_yet:
      return "The run has not come so far yet.";
    case knit::Fate::begins_row:
      return "It begins " + row + ", nearest to the start direction.";
    case knit::Fate::accepted:
    case knit::Fate::taken:
      return said_by(timeline, *story.decided);
    case knit::Fate::refused:
      return refusal_words(timeline, story);
    case knit::Fate::never_reached:
      return story.row > 0 ? "Never reached: the run ended before " + row + " came to it."
                           : "Never reached: the run ended before there were rows.";
  }
  return "";
}

std::string stitch_words(const knit::Timeline& timeline, const knit::StitchElement& stitch) {
  const auto made = knit::made_by(timeline, stitch);
  if (!made) return "There is no such stitch so far.";
  const auto chosen = knit::chosen_by(timeline, stitch);
  // What chose its vertex tells more than what kept it.
  std::string words = said_by(timeline, chosen.value_or(*made));
  if (chosen) words += " Kept at step " + str(static_cast<std::int64_t>(*made) + 1) + ".";
  const auto moved = knit::moved_by(timeline, stitch);
  if (!moved) return words;
  const bool spread = knit::is<knit::RowResampled>(timeline.step(*moved));
  return words + (spread ? " The row was spread evenly afterwards." : " Moved when the gap was shared out.");
}

}  // namespace

std::string words_of(const knit::Element& thing) { return std::visit(ElementWords{}, thing); }

std::string text_of(const knit::Element& thing) {
  const std::string key(keys.at(thing.index()));
  if (const auto* v = std::get_if<knit::VertexElement>(&thing)) return key + ":" + str(v->vertex);
  const RowAndItem at = std::visit(Parts{}, thing);
  return key + ":" + str(at.row) + ":" + str(at.item);
}

std::optional<knit::Element> thing_named(const std::string& text) {
  const auto parts = split(text, ':');
  const auto key = std::find(keys.begin(), keys.end(), parts[0]);
  if (key == keys.end()) return std::nullopt;
  if (*key == "vertex") {
    const auto vertex = parts.size() == 2 ? whole_number<knit::VertexId>(parts[1]) : std::nullopt;
    if (!vertex || *vertex == knit::no_vertex) return std::nullopt;
    return knit::VertexElement{*vertex};
  }
  if (parts.size() != 3) return std::nullopt;
  const auto row = whole_number<std::int32_t>(parts[1]);
  const auto item = whole_number<std::int32_t>(parts[2]);
  if (!row || !item || *row < 1 || *item < 0) return std::nullopt;
  return thing_of(static_cast<std::size_t>(key - keys.begin()), {*row, *item});
}

std::string why_words(const knit::Timeline& timeline, const knit::Element& thing) {
  if (const auto* vertex = std::get_if<knit::VertexElement>(&thing)) return vertex_words(timeline, *vertex);
  if (const auto* stitch = std::get_if<knit::StitchElement>(&thing)) return stitch_words(timeline, *stitch);
  const auto made = knit::made_by(timeline, thing);
  return made ? said_by(timeline, *made) : "There is no such thing so far.";
}

}  // namespace app
