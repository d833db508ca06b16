#include "app/explain/why_words.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "app/base/text.h"
#include "app/session/document.h"
#include "knit/insight/causes.h"
#include "knit/insight/longest_wale.h"
#include "knit/insight/narrate.h"
#include "knit/insight/why_tubes.h"
#include "knit/model/measured.h"
#include "knit/model/words.h"
#include "knit/quality/ease.h"
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

// A deal goes by a row below 0.
std::string deal_name(std::int32_t row) { return "deal " + str(-row); }
std::string bridge_name(std::int32_t row) { return "the bridge of " + deal_name(row); }

struct ElementWords {
  std::string operator()(const knit::StitchElement& s) const {
    if (s.row < 0) return "stitch " + str(s.stitch + 1) + " of " + bridge_name(s.row);
    return "stitch " + str(s.stitch + 1) + " of row " + str(s.row);
  }
  std::string operator()(const knit::RowEdgeElement& e) const {
    if (e.row < 0) return "edge " + str(e.stitch + 1) + " of " + bridge_name(e.row);
    return "row edge " + str(e.stitch + 1) + " of row " + str(e.row);
  }
  std::string operator()(const knit::ColumnEdgeElement& e) const {
    if (e.row < 0) return "column edge " + str(e.edge + 1) + " of " + deal_name(e.row);
    return "column edge " + str(e.edge + 1) + " into row " + str(e.row);
  }
  std::string operator()(const knit::FaceElement& f) const {
    if (f.row < 0) return "face " + str(f.face + 1) + " of " + deal_name(f.row);
    return "face " + str(f.face + 1) + " into row " + str(f.row);
  }
  std::string operator()(const knit::LabelElement& l) const {
    return "label of cell " + str(l.cell + 1) + " into row " + str(l.row);
  }
  std::string operator()(const knit::VertexElement& v) const { return "vertex " + str(v.vertex); }
};

// As steps are counted for people, from 1.
std::string step_number(std::size_t step) { return str(static_cast<std::int64_t>(step) + 1); }
std::string made_words(std::size_t step) { return " Made at step " + step_number(step) + "."; }

std::string said_by(const knit::Timeline& timeline, std::size_t step) {
  return knit::narrate(timeline.step(step), timeline.parameters_of_step(step));
}

// What became the stitch that a refused vertex was measured for.
std::string taken_instead_words(const knit::Timeline& timeline, const knit::StitchElement& stitch) {
  const auto chosen = knit::chosen_by(timeline, stitch);
  if (!chosen) return "";
  const auto* accepted = knit::get_if<knit::CandidateMeasured>(timeline.step(*chosen));
  const auto* missed = knit::get_if<knit::BandMissed>(timeline.step(*chosen));
  const std::string is = " became stitch " + str(stitch.stitch + 1) + " instead, ";
  if (accepted != nullptr)
    return " Vertex " + str(accepted->candidate) + is + knit::short_number(accepted->distance) + " away.";
  return missed == nullptr
             ? ""
             : " Vertex " + str(missed->taken) + is + knit::short_number(missed->distance) + " away.";
}

std::string refusal_words(const knit::Timeline& timeline, const knit::VertexStory& story) {
  const auto* s = knit::get_if<knit::CandidateMeasured>(timeline.step(*story.decided));
  if (s == nullptr) return "";
  const knit::Parameters& parameters = timeline.parameters_of_step(*story.decided);
  const knit::Band band = knit::band_of(parameters.rows, parameters.stitch);
  return "Passed over in row " + str(story.row) + ": it lies " + knit::short_number(s->distance) +
         " from stitch " + str(s->stitch) + ", too " +
         (s->verdict == knit::Verdict::too_near ? "near" : "far") + " for the band " +
         knit::short_number(band.low) + " to " + knit::short_number(band.high) + "." +
         taken_instead_words(timeline, {story.row, s->stitch});
}

// With one tube nobody needs its name.
bool names_tubes(const knit::State& run) { return run.tubes && run.tubes->tubes.size() > 1; }

std::string names_of(const std::vector<knit::TubeId>& tubes) {
  std::string names;
  for (std::size_t i = 0; i < tubes.size(); ++i)
    names += (i == 0 ? "" : i + 1 == tubes.size() ? " and " : ", ") + knit::tube_name(tubes[i]);
  return names;
}

std::string event_words(const knit::TubeEvent& event) {
  switch (event.kind) {
    case knit::EventKind::cast_on:
      return "Tube " + names_of(event.above) + " begins here.";
    case knit::EventKind::split:
      return "Tube " + names_of(event.below) + " splits into " + names_of(event.above) + " here.";
    case knit::EventKind::join:
      return "Tubes " + names_of(event.below) + " join to " + names_of(event.above) + " here.";
    case knit::EventKind::bind_off:
      return "Tube " + names_of(event.below) + " ends here.";
    case knit::EventKind::ring_cast_on:
      return "Tubes " + names_of(event.above) + " start from one edge around here.";
    case knit::EventKind::ring_bind_off:
      return "Tubes " + names_of(event.below) + " end edge to edge around here.";
  }
  return "";
}

// " Its first row, row 12, is cast on with 8 stitches." Of a tube that goes on from another there is nothing to add.
std::string end_words(const knit::State& run, const knit::TubeEvent& event) {
  const bool begins = event.kind == knit::EventKind::cast_on;
  if (!begins && event.kind != knit::EventKind::bind_off) return "";
  const knit::TubeId tube = begins ? event.above.front() : event.below.front();
  const knit::Row* end = nullptr;
  for (const auto& row : run.fabric.rows()) {
    if (row->tube == tube && (end == nullptr || !begins)) end = &*row;
  }
  if (end == nullptr) return "";
  const std::string row = ", row " + str(end->id) + ", ";
  if (begins)
    return " Its first row" + row + "is cast on with " + knit::stitch_count_text(knit::size_of(*end)) + ".";
  const bool whole = !run.fabric.rows().empty() && run.finished();
  return whole ? " Its last row" + row + "has " + knit::stitch_count_text(knit::size_of(*end)) + "." : "";
}

// What became of a limb or a hole that has an end here, and what would keep it.
std::string left_out_words(const knit::TubePlan& plan, const knit::LeftOut& left) {
  const std::string size = knit::measured(left.height / plan.stitch_height, "round", "rounds") +
                           " high and " +
                           knit::measured(left.girth / plan.stitch_width, "stitch", "stitches") + " round";
  const std::string way_on =
      left.width_that_keeps > 0.0
          ? "; a stitch " + knit::short_number(left.width_that_keeps) + " wide would keep it."
          : ".";
  const std::string ends = knit::vertex_text(left.from) + " to " + knit::vertex_text(left.to);
  if (left.handle)
    return "Here the level sets go round a hole whose thinner side, from " + ends + ", is " + size +
           ": too small for this stitch, it is left out and no handle is made" + way_on;
  return "Here is an end of the limb from " + ends + ", " + size + ": smaller than a round, it is left out" +
         way_on;
}

// All that happens at a critical vertex, with the steps and numbers of its deals.
std::string critical_words(const knit::Timeline& timeline, const knit::CriticalStory& story) {
  std::string words;
  const auto add = [&](const std::string& sentence) { words += (words.empty() ? "" : " ") + sentence; };
  if (!timeline.furthest().tubes) return said_by(timeline, story.found.front());
  const knit::TubePlan& plan = *timeline.furthest().tubes;
  for (const std::int32_t event : story.events) {
    add(event_words(plan.event(event)) + end_words(timeline.furthest(), plan.event(event)));
    if (knit::closes_handle(plan, event)) add("They hang together below already, so this closes a handle.");
  }
  for (const std::int32_t left : story.left_out)
    add(left_out_words(plan, plan.left_out[static_cast<std::size_t>(left)]));
  for (const std::size_t step : story.dealt)
    add("Step " + str(static_cast<std::int64_t>(step) + 1) + ": " + said_by(timeline, step));
  // A saddle between what was left out and what is knitted has become a plain vertex of a tube.
  return words.empty() ? said_by(timeline, story.found.front()) : words;
}

// Where a vertex stands when rows are cut: no row is picked from it, but rows run beside it.
std::string cut_words(const knit::Timeline& timeline, knit::VertexId vertex) {
  std::string cut = "Rows are cut through the surface here; no vertex is a candidate.";
  const auto on = knit::on_tube(timeline, vertex);
  if (!on) return cut;
  const auto critical = knit::critical_story(timeline, vertex);
  if (critical) cut = critical_words(timeline, *critical);
  if (on->tube < 0 && critical && !critical->left_out.empty()) return cut;
  if (on->tube < 0) return cut + " It lies on a part that is left out: smaller than a row.";
  const std::string tube = names_tubes(timeline.furthest()) ? " on tube " + knit::tube_name(on->tube) : "";
  if (on->below > 0 && on->above > 0)
    return cut + " It lies" + tube + " between rows " + str(on->below) + " and " + str(on->above) + ".";
  if (on->below > 0) return cut + " It lies" + tube + " above row " + str(on->below) + ".";
  if (on->above > 0) return cut + " It lies" + tube + " below row " + str(on->above) + ".";
  return tube.empty() ? cut : cut + " It lies" + tube + ".";
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
      return cut_words(timeline, v.vertex);
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

// " It belongs to tube B, whose first row this is: ..."
std::string tube_words(const knit::Timeline& timeline, knit::RowId id) {
  const knit::State& run = timeline.furthest();
  const knit::Row* row = run.fabric.find_row(id);
  if (row == nullptr || !names_tubes(run)) return "";
  const knit::Row* below = run.fabric.row_below(id);
  const bool first = below == nullptr || below->tube != row->tube;
  std::string words = " It belongs to tube " + knit::tube_name(row->tube);
  if (!first) return words + ".";
  words += ", whose first row this is, ";
  return words +
         (row->on.empty() ? "cast on." : "worked on " + knit::stitch_count_text(row->on.size()) + ".");
}

std::string deal_words(const knit::Timeline& timeline, std::int32_t row) {
  const knit::Deal* deal = knit::deal_numbered(timeline.furthest(), -row);
  if (deal == nullptr || !timeline.furthest().tubes) return "";
  return event_words(timeline.furthest().tubes->event(deal->event));
}

std::string point_text(const glm::dvec3& p) {
  return "(" + knit::short_number(p.x) + ", " + knit::short_number(p.y) + ", " + knit::short_number(p.z) +
         ")";
}

// " Placed at (0.1, 0.2, 0.3); moved 0.6 w while settling, to (0.1, 0.2, 0.4)." Empty where nothing has settled.
std::string move_words(const knit::Timeline& timeline, const knit::StitchElement& stitch) {
  const auto move = knit::move_of(timeline.furthest(), {stitch.row, stitch.stitch});
  if (!move) return "";
  const double width = timeline.parameters_of_stop().stitch.width;
  const double length = glm::distance(move->from, move->to) / width;
  return " Placed at " + point_text(move->from) + "; moved " + fixed_text(length, 2) +
         " w while settling, to " + point_text(move->to) + ".";
}

std::string stitch_words(const knit::Timeline& timeline, const knit::StitchElement& stitch) {
  const auto made = knit::made_by(timeline, stitch);
  if (!made) return "There is no such stitch so far.";
  const std::string went = move_words(timeline, stitch);
  if (stitch.row < 0) return said_by(timeline, *made) + " " + deal_words(timeline, stitch.row) + went;
  const auto chosen = knit::chosen_by(timeline, stitch);
  // What chose its vertex tells more than what kept it.
  std::string words = said_by(timeline, chosen.value_or(*made));
  words += chosen ? " Kept at step " + step_number(*made) + "." : made_words(*made);
  const std::string refused = knit::why_refused_before(timeline, stitch);
  if (!refused.empty()) words += " " + refused;
  words += tube_words(timeline, stitch.row);
  const auto moved = knit::moved_by(timeline, stitch);
  if (!moved) return words + went;
  const bool spread = knit::is<knit::RowResampled>(timeline.step(*moved));
  words += spread ? " The row was spread evenly afterwards." : " Moved when the gap was distributed.";
  return words + went;
}

// " It is 0.0851 long, 1.18 h, from stitch 3 of row 6 to stitch 4 of row 7." of a wale, and whether none is longer.
std::string length_words(const knit::Timeline& timeline, const knit::Element& thing) {
  const auto* edge = std::get_if<knit::ColumnEdgeElement>(&thing);
  if (edge == nullptr || edge->row < 0) return "";
  const knit::Fabric& fabric = timeline.furthest().fabric;
  const auto wale = knit::wale_at(fabric, edge->row, edge->edge);
  if (!wale) return "";
  const double heights = wale->length / timeline.parameters_of_stop().stitch.height;
  const auto longest = knit::longest_wale(fabric);
  const bool is_longest = longest && longest->row == wale->row && longest->cell == wale->cell;
  const auto name = [](const knit::StitchRef& ref) {
    return app::words_of(knit::Element(knit::StitchElement{ref.row, ref.stitch}));
  };
  return " " + std::string(is_longest ? "The longest wale: it" : "It") + " is " +
         knit::short_number(wale->length) + " long, " + knit::short_number(heights) + " h, from " +
         name(wale->below) + " to " + name(wale->above) + ".";
}

// " It is the 3rd of the row's 6 K2tog." and why it stands there.
std::string label_words(const knit::Timeline& timeline, const knit::LabelElement& label) {
  const std::string why = knit::why_label(timeline, label);
  std::string words = why.empty() ? "" : " " + why;
  const knit::Join* join = timeline.furthest().fabric.join_into(label.row);
  if (join == nullptr || label.cell >= static_cast<std::int32_t>(join->labels.size())) return words;
  const auto begin = join->labels.begin();
  const knit::Label is = join->labels[static_cast<std::size_t>(label.cell)];
  if (!knit::is_shaping(is)) return words;
  const auto number = std::count(begin, begin + label.cell + 1, is);
  const auto all = std::count(begin, join->labels.end(), is);
  return words + " It is " + std::string(knit::name_of(is)) + " " + str(number) + " of " + str(all) +
         " in the row, in working order.";
}

}  // namespace

std::string words_of(const knit::Element& thing) { return std::visit(ElementWords{}, thing); }

std::string text_of(const knit::Element& thing) {
  const std::string key(keys.at(thing.index()));
  if (const auto* v = std::get_if<knit::VertexElement>(&thing)) return key + ":" + str(v->vertex);
  const RowAndItem at = std::visit(Parts{}, thing);
  return key + ":" + str(at.row) + ":" + str(at.item + 1);
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
  const auto kind = static_cast<std::size_t>(key - keys.begin());
  const bool label = kind == 4;  // a deal has none
  if (!row || !item || *row == 0 || (label && *row < 0) || *item < 1) return std::nullopt;
  return thing_of(kind, {*row, *item - 1});
}

std::string why_words(const knit::Timeline& timeline, const knit::Element& thing) {
  if (const auto* vertex = std::get_if<knit::VertexElement>(&thing)) return vertex_words(timeline, *vertex);
  if (const auto* stitch = std::get_if<knit::StitchElement>(&thing)) return stitch_words(timeline, *stitch);
  const auto made = knit::made_by(timeline, thing);
  if (!made) return "There is no such element so far.";
  const std::int32_t row = std::visit(Parts{}, thing).row;
  const auto* label = std::get_if<knit::LabelElement>(&thing);
  return said_by(timeline, *made) + (label != nullptr ? label_words(timeline, *label) : "") +
         length_words(timeline, thing) + made_words(*made) +
         (row < 0 ? " " + deal_words(timeline, row) : tube_words(timeline, row));
}

std::optional<knit::ColumnEdgeElement> longest_wale_of(const knit::Timeline& timeline) {
  const auto longest = knit::longest_wale(timeline.furthest().fabric);
  return longest ? std::optional(knit::ColumnEdgeElement{longest->row, longest->cell}) : std::nullopt;
}

std::optional<std::int32_t> row_named(const std::string& text) {
  const std::size_t head = text.rfind("row", 0) == 0 ? 3 : std::string::npos;
  if (head == std::string::npos || text.size() < 5 || (text[head] != ' ' && text[head] != ':'))
    return std::nullopt;
  const auto row = whole_number<std::int32_t>(text.substr(head + 1));
  return row && *row >= 1 ? row : std::nullopt;
}

std::string cause(const Session& session) {
  if (!session.document || stop_shown(session) != nullptr) return "";
  const knit::Timeline& timeline = session.document->timeline;
  return timeline.position() == 0 ? "" : knit::cause_of(timeline, timeline.position() - 1);
}

}  // namespace app
