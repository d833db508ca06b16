#include "app/explain/destination.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>
#include <utility>

#include "app/base/text.h"
#include "app/explain/destination_reader.h"
#include "app/explain/found_words.h"
#include "app/explain/why_words.h"
#include "app/session/at.h"
#include "app/session/document.h"
#include "app/session/planned_pieces.h"
#include "app/session/remarks.h"
#include "app/session/view.h"
#include "knit/insight/as_asked.h"
#include "knit/insight/causes.h"
#include "knit/insight/narrate.h"
#include "knit/insight/problems.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/words.h"
#include "knit/run/machine.h"
#include "knit/stitches/operations.h"

namespace app {

namespace {

using Found = std::variant<Destination, NoDestination>;

NoDestination nowhere(std::string why) { return {std::move(why), true}; }
std::string digits(std::int64_t number) { return std::to_string(number); }
std::string small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}
std::string ranked(std::int64_t n) {
  const std::int64_t tens = n % 100;
  const bool teens = tens >= 11 && tens <= 13;
  const char* ending = teens ? "th" : n % 10 == 1 ? "st" : n % 10 == 2 ? "nd" : n % 10 == 3 ? "rd" : "th";
  return digits(n) + ending;
}

// Of a run with limbs that are known.
std::optional<PlannedPieces> pieces_of(const Session& session) {
  const knit::State& run = session.document->timeline.furthest();
  if (!knit::has_limbs(run) || !knit::limbs_are_known(run)) return std::nullopt;
  return planned_pieces(run, session.document->pieces, session.view->pattern);
}

// What a number of rows stops at.
std::string rows_there(const knit::Timeline& timeline) {
  const std::int32_t rows = timeline.furthest().fabric.row_count();
  return "The run has " + std::string(timeline.complete() ? "only " : "so far ") +
         knit::plural(rows, "row", "rows") + ".";
}

class Finder {
 public:
  Finder(const Session& session, const PlaceWish& wish)
      : session_(session), wish_(wish), timeline_(session.document->timeline), run_(timeline_.furthest()) {}

  [[nodiscard]] Found find() const {
    switch (wish_.goal) {
      case Goal::row:
      case Goal::round:
        return find_row();
      case Goal::stitch:
        return find_stitch();
      case Goal::vertex:
        return find_vertex();
      case Goal::step:
        return find_step();
      case Goal::widest:
      case Goal::narrowest:
        return find_extreme_row();
      case Goal::longest_wale:
      case Goal::shortest_wale:
        return find_extreme_wale();
      case Goal::change:
        return find_change();
      case Goal::problem:
        return find_problem();
      case Goal::operation:
        return find_operation();
      case Goal::stop:
        return find_stop();
      case Goal::at:
        return find_place();
    }
    return nowhere("");
  }

 private:
  // --- rows --------------------------------------------------------------------------------------------------

  // The row shown; 0: none.
  [[nodiscard]] std::int32_t current_row() const {
    return timeline_.position() == 0 ? 0 : std::max(0, timeline_.place().row);
  }

  // In the stage that is shown, if it has rows.
  [[nodiscard]] knit::Place end_of(std::int32_t row) const {
    const knit::Stage at = timeline_.state().stage();
    const bool there = at > knit::Stage::rows && at < knit::Stage::settle && row > 1;
    return {there ? at : knit::stage_of_row(row), row, std::numeric_limits<std::int32_t>::max()};
  }

  [[nodiscard]] std::string said_by(std::size_t step) const {
    return knit::narrate(timeline_.step(step), timeline_.parameters_of_step(step));
  }

  // "Row 7 has 33 stitches, 5 more than row 6. 33 of the ring's 128 vertices ..."
  [[nodiscard]] std::string row_words(std::int32_t id) const {
    if (wish_.why) return knit::why_count(timeline_, id);
    const knit::Row& row = run_.fabric.row(id);
    const std::int32_t count = knit::size_of(row);
    std::string words = "Row " + digits(id) + " has " + knit::stitch_count_text(count);
    if (!row.on.empty()) {
      const std::int32_t change = count - row.on.size();
      const knit::Row* below = run_.fabric.row_below(id);
      words += change == 0 ? ", as many as "
                           : ", " + digits(std::abs(change)) + (change > 0 ? " more" : " fewer") + " than ";
      words += below != nullptr ? "row " + digits(below->id) : "what it is worked on";
    }
    words += ".";
    const auto decided = knit::count_decided_by(timeline_, id);
    return decided ? words + " " + said_by(*decided) : words;
  }

  [[nodiscard]] Found to_row(std::int64_t number, const std::string& before = "") const {
    if (number < 1) return nowhere("There is no row 0; rows count from 1.");
    if (number > run_.fabric.row_count()) {
      if (timeline_.complete() || number > 1000000) return nowhere(rows_there(timeline_));
      const auto row = static_cast<std::int32_t>(number);
      const std::string words = "Row " + digits(row) + " is not worked out yet; the run goes on to it.";
      return Destination{words, {}, {}, end_of(row), false};
    }
    const auto row = static_cast<std::int32_t>(number);
    const auto decided = wish_.why ? knit::count_decided_by(timeline_, row) : std::nullopt;
    if (decided) return Destination{before + row_words(row), {}, *decided + 1, {}, true};
    return Destination{before + row_words(row), {}, {}, end_of(row), wish_.why};
  }

  [[nodiscard]] Found find_row() const {
    if (!wish_.piece.empty()) return find_round_of_piece();
    if (!wish_.number) return find_row_by_rank();
    if (wish_.rounds && knit::has_limbs(run_)) return nowhere(which_piece(*wish_.number));
    return to_row(*wish_.number);
  }

  [[nodiscard]] Found find_row_by_rank() const {
    const std::int32_t here = current_row();
    switch (wish_.which.kind) {
      case WhichOne::Kind::next:
        return to_row(here + 1);
      case WhichOne::Kind::previous:
        return here > 1 ? to_row(here - 1) : Found(nowhere("No row comes before the one shown."));
      case WhichOne::Kind::last:
        return run_.fabric.empty() ? Found(nowhere("There is no row yet.")) : to_row(run_.fabric.row_count());
      default:
        break;
    }
    if (!wish_.why) return to_row(wish_.which.count);
    if (here == 0) return nowhere("No row is shown here; go to one, or say which: why row 7.");
    return to_row(here);
  }

  // "Round 12 could be of Body A or Leg B; ..."
  [[nodiscard]] std::string which_piece(std::int64_t round) const {
    const auto pieces = pieces_of(session_);
    if (!pieces) return "The pieces are known once the whole run is worked out; until then, go to rows.";
    std::vector<std::string> names = piece_names_of(session_);
    names.resize(std::min<std::size_t>(names.size(), 6));
    const std::vector<std::string_view> views(names.begin(), names.end());
    return "Each piece has rounds of its own; say of which: round " + digits(round) + " of " + one_of(views) +
           ".";
  }

  // A piece by its name, its letter, or its word where only one has it; -1: none.
  [[nodiscard]] static std::int32_t piece_called(const PlannedPieces& pieces, const std::string& called) {
    std::int32_t by_word = -1;
    std::int32_t with_word = 0;
    for (std::int32_t i = 0; i < pieces.plan.count(); ++i) {
      const std::string name = small_letters(pieces.name_of(i));
      const std::size_t gap = name.rfind(' ');
      if (name == called || (gap != std::string::npos && name.substr(gap + 1) == called)) return i;
      if (name.substr(0, gap) != called) continue;
      by_word = i;
      ++with_word;
    }
    return with_word == 1 ? by_word : -1;
  }

  [[nodiscard]] Found find_round_of_piece() const {
    const auto row = row_of_piece(wish_.number.value_or(0));
    if (const auto* none = std::get_if<NoDestination>(&row)) return *none;
    const auto [id, name] = std::get<0>(row);
    return to_row(id, "Round " + digits(wish_.number.value_or(0)) + " of " + name + ". ");
  }

  // The fabric's row that a round of the piece wished for is, and the piece's name.
  [[nodiscard]] std::variant<std::pair<std::int32_t, std::string>, NoDestination> row_of_piece(
      std::int64_t round) const {
    if (!knit::has_limbs(run_)) {
      const bool known = timeline_.complete() || run_.fabric.row_count() > 0;
      return nowhere(known ? "This run is of one piece; say row " + digits(round) + "."
                           : "There is no piece yet.");
    }
    const auto pieces = pieces_of(session_);
    if (!pieces) return nowhere("The pieces are known once the whole run is worked out.");
    const std::int32_t piece = piece_called(*pieces, wish_.piece);
    if (piece < 0) return nowhere("No piece is called \"" + wish_.piece + "\". " + which_piece(round));
    const knit::LimbPiece& of = pieces->plan.piece(piece);
    if (round < 1 || round > of.round_count())
      return nowhere(pieces->name_of(piece) + " has " + knit::plural(of.round_count(), "round", "rounds") +
                     ".");
    return std::pair(of.rows[static_cast<std::size_t>(round) - 1], pieces->name_of(piece));
  }

  // Where a round of so many centimetres is far from what the mesh has around.
  [[nodiscard]] std::string girth_words(double around_cm) const {
    const double mesh_cm = knit::size_asked(run_, timeline_.parameters()).around_cm;
    if (std::abs(around_cm - mesh_cm) <= knit::size_off * mesh_cm) return "";
    return " The mesh is " + knit::short_number(mesh_cm) + " cm around at its widest.";
  }

  [[nodiscard]] Found find_extreme_row() const {
    const auto& rows = run_.fabric.rows();
    if (rows.empty()) return nowhere("There is no row yet.");
    const bool widest = wish_.goal == Goal::widest;
    const auto less = [](const auto& a, const auto& b) { return knit::size_of(*a) < knit::size_of(*b); };
    const auto best = widest ? std::max_element(rows.begin(), rows.end(), less)
                             : std::min_element(rows.begin(), rows.end(), less);
    const std::int32_t count = knit::size_of(**best);
    const auto alike = std::count_if(rows.begin(), rows.end(),
                                     [&](const auto& row) { return knit::size_of(*row) == count; });
    const double sts = timeline_.parameters().stitch.gauge.stitches, around_cm = count * 10.0 / sts;
    std::string words = "The " + std::string(widest ? "widest" : "narrowest") + " row" +
                        (timeline_.complete() ? "" : " so far") + " is row " + digits((*best)->id) + ": " +
                        knit::stitch_count_text(count) + ", " + knit::short_number(around_cm) +
                        " cm around at " + knit::short_number(sts) + " stitches in 10 cm.";
    if (alike > 1) words += " " + knit::plural(alike - 1, "more row has", "more rows have") + " as many.";
    if (widest && timeline_.complete()) words += girth_words(around_cm);
    return Destination{words, {}, {}, end_of((*best)->id), false};
  }

  [[nodiscard]] Found find_change() const {
    std::vector<std::int32_t> found;
    for (const auto& row : run_.fabric.rows())
      if (!row->on.empty() && row->on.size() == *wish_.number && knit::size_of(*row) == *wish_.second)
        found.push_back(row->id);
    if (found.empty())
      return nowhere("No row" + std::string(timeline_.complete() ? "" : " so far") + " goes from " +
                     digits(*wish_.number) + " to " + knit::stitch_count_text(*wish_.second) + ".");
    std::string before;
    if (found.size() > 1) {
      before = "The first of " + digits(static_cast<std::int64_t>(found.size())) +
               " such rows; the next is row " + digits(found[1]) + ". ";
    }
    return to_row(found.front(), before);
  }

  // --- things ------------------------------------------------------------------------------------------------

  // Selects it, and goes to the step that made it, or decided on it.
  [[nodiscard]] Destination to_thing(const knit::Element& thing, std::string words) const {
    const auto made = knit::made_by(timeline_, thing);
    return {std::move(words), thing, made ? std::optional(*made + 1) : std::nullopt, {}, wish_.why};
  }

  [[nodiscard]] std::string named_words(const knit::Element& thing) const {
    std::string name = words_of(thing);
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    const auto made = knit::made_by(timeline_, thing);
    const std::string step = made ? " (step " + digits(static_cast<std::int64_t>(*made) + 1) + ")" : "";
    return name + step + ": " + why_words(timeline_, thing);
  }

  [[nodiscard]] Found find_stitch() const {
    if (!wish_.number) {
      const auto& selected = session_.document->travel.selected;
      if (!selected || std::holds_alternative<knit::VertexElement>(*selected))
        return nowhere("Click a stitch in the view first, or say which: why stitch 20:5.");
      return to_thing(*selected, named_words(*selected));
    }
    std::int64_t row = *wish_.row;
    if (!wish_.piece.empty()) {
      const auto found = row_of_piece(row);
      if (const auto* none = std::get_if<NoDestination>(&found)) return *none;
      row = std::get<0>(found).first;
    }
    if (row < 1 || row > run_.fabric.row_count()) return nowhere(rows_there(timeline_));
    const auto id = static_cast<std::int32_t>(row);
    const std::int32_t count = knit::size_of(run_.fabric.row(id));
    if (*wish_.number < 1 || *wish_.number > count)
      return nowhere("Row " + digits(row) + " has stitches 1 to " + digits(count) + ".");
    const knit::StitchElement thing{id, static_cast<std::int32_t>(*wish_.number) - 1};
    return to_thing(thing, named_words(thing));
  }

  [[nodiscard]] Found find_vertex() const {
    const std::size_t count = timeline_.input().mesh.positions.size();
    std::optional<knit::Element> thing;
    if (wish_.number) {
      thing = thing_named("vertex:" + digits(*wish_.number));  // as it counts everywhere
    } else {
      thing = session_.document->travel.selected;
      if (!thing || !std::holds_alternative<knit::VertexElement>(*thing))
        return nowhere("Click a vertex of the mesh in the view first, or say which: why not vertex 120.");
    }
    const auto* vertex = thing ? std::get_if<knit::VertexElement>(&*thing) : nullptr;
    if (vertex == nullptr || vertex->vertex >= count)
      return nowhere("The mesh has no vertex " + digits(wish_.number.value_or(0)) + "; its last is " +
                     words_of(knit::VertexElement{static_cast<knit::VertexId>(count - 1)}) + ".");
    return to_thing(*thing, named_words(*thing));
  }

  [[nodiscard]] Found find_step() const {
    const std::int64_t number = *wish_.number;
    const auto known = static_cast<std::int64_t>(timeline_.known());
    if (number < 0) return nowhere("Steps count from 1; 0 is the start.");
    if (number > known && timeline_.complete())
      return nowhere("The run has only " + knit::plural(known, "step", "steps") + ".");
    std::string words = "The start, before the first step.";
    if (number > known) words = "Step " + digits(number) + " is not worked out yet; the run goes on to it.";
    if (number > 0 && number <= known) words = said_by(static_cast<std::size_t>(number) - 1);
    return Destination{words, {}, static_cast<std::size_t>(number), {}, false};
  }

  [[nodiscard]] Found find_place() const {
    const auto at = parse_at(wish_.at);
    if (std::holds_alternative<AtEnd>(*at))
      return Destination{"The end of the run.", {}, {}, knit::Place{knit::Stage::done, 0, 0}, false};
    if (std::holds_alternative<std::size_t>(*at))
      return Destination{"The start, before the first step.", {}, 0, {}, false};
    if (const auto* stage = std::get_if<AtStage>(&*at))
      return Destination{"The beginning of the stage " + std::string(knit::name_of(stage->stage)) + ".",
                         {},
                         {},
                         knit::Place{stage->stage, -1, 0},
                         false};
    return Destination{"The place " + wish_.at + ".", {}, {}, std::get<knit::Place>(*at), false};
  }

  [[nodiscard]] Found find_extreme_wale() const {
    const knit::KnittingPath path(run_.fabric);
    const bool longest = wish_.goal == Goal::longest_wale;
    double best = 0.0;
    std::optional<knit::ColumnEdgeElement> at;
    const auto look = [&](std::int32_t row, const auto& edges) {
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const double length = glm::distance(path.position(edges[i][0]), path.position(edges[i][1]));
        if (at && (longest ? length <= best : length >= best)) continue;
        best = length;
        at = knit::ColumnEdgeElement{row, static_cast<std::int32_t>(i)};
      }
    };
    for (const auto& strip : run_.fabric.strips()) look(strip->to, strip->column_edges);
    const auto& deals = run_.fabric.deals();
    for (std::size_t i = 0; i < deals.size(); ++i)
      look(knit::bridge_row(static_cast<std::int32_t>(i) + 1), deals[i]->column_edges);
    if (!at) return nowhere("There is no wale before the faces are made.");
    const knit::StitchSize& stitch = timeline_.parameters().stitch;
    std::string words = "The " + std::string(longest ? "longest" : "shortest") + " wale" +
                        (timeline_.complete() ? "" : " so far") + " is " + words_of(*at) + ": " +
                        knit::short_number(best) + " in mesh units, " + fixed_text(best / stitch.height, 2) +
                        " times the row height h, " + knit::short_number(best * stitch.centimetres_per_unit) +
                        " cm at this gauge.";
    Destination there = to_thing(*at, words);
    // What is seen already need not be gone back from.
    if (knit::exists(timeline_.state(), *at)) there.position.reset();
    return there;
  }

  // --- steps -------------------------------------------------------------------------------------------------

  [[nodiscard]] Found find_problem() const {
    std::vector<knit::Problem> problems;
    for (std::size_t i = 0; i < timeline_.known(); ++i)
      if (const auto problem = knit::problem_of(timeline_.step(i), i, timeline_.parameters_of_step(i)))
        problems.push_back(*problem);
    const bool stopped = timeline_.stop() != nullptr;
    if (stopped) problems.push_back({timeline_.known(), knit::ProblemKind::stopped, 0.0});
    const bool past = wish_.which.kind == WhichOne::Kind::nth && std::ssize(problems) < wish_.which.count;
    if (problems.empty() || past) return find_remark(problems.size());
    const auto index = index_of(problems);
    if (!index)
      return nowhere("The run has " +
                     knit::plural(static_cast<std::int64_t>(problems.size()), "problem", "problems") +
                     "; there is none such from here.");
    const std::size_t step = problems[*index].step;
    const std::string head = "Problem " + digits(static_cast<std::int64_t>(*index) + 1) + " of " +
                             digits(static_cast<std::int64_t>(problems.size())) + ": ";
    if (step == timeline_.known()) return Destination{head + stop_words(), {}, step, {}, false};
    return Destination{head + said_by(step), {}, step + 1, {}, false};
  }

  // Past the unusual steps, or where there are none: the remarks that are listed with them, in the list's order.
  [[nodiscard]] Found find_remark(std::size_t problems) const {
    const auto remarks = listed_remarks(session_);
    const auto count = static_cast<std::int64_t>(remarks.size());
    const std::size_t index = wish_.which.kind == WhichOne::Kind::last
                                  ? remarks.size() - 1
                                  : static_cast<std::size_t>(wish_.which.count) - 1 - problems;
    const std::string head =
        problems == 0
            ? "No step of the run is a problem"
            : "The run has " + knit::plural(static_cast<std::int64_t>(problems), "problem", "problems");
    if (remarks.empty()) return nowhere(head + (timeline_.complete() ? "." : " so far."));
    if (index >= remarks.size())
      return nowhere(head + ", and there " + (count == 1 ? "is " : "are ") +
                     knit::plural(count, "remark", "remarks") + ".");
    Destination there{
        head + "; remark " + digits(static_cast<std::int64_t>(index) + 1) + " of " + digits(count) + ": ",
        {},
        {},
        {},
        false};
    there.words += remarks[index].words;
    there.thing = remarks[index].thing;
    return there;
  }

  // Of problems in the order of steps the one that is wished.
  [[nodiscard]] std::optional<std::size_t> index_of(const std::vector<knit::Problem>& problems) const {
    const std::size_t here = timeline_.position();
    switch (wish_.which.kind) {
      case WhichOne::Kind::nth:
        break;
      case WhichOne::Kind::last:
        return problems.size() - 1;
      case WhichOne::Kind::next:
        for (std::size_t i = 0; i < problems.size(); ++i)
          if (problems[i].step + 1 > here && problems[i].step < timeline_.known()) return i;
        return std::nullopt;
      case WhichOne::Kind::previous:
        for (std::size_t i = problems.size(); i-- > 0;)
          if (problems[i].step + 1 < here) return i;
        return std::nullopt;
      case WhichOne::Kind::worst: {
        const auto worse = [](const knit::Problem& a, const knit::Problem& b) {
          return a.kind != b.kind ? a.kind < b.kind : a.size > b.size;
        };
        return static_cast<std::size_t>(std::min_element(problems.begin(), problems.end(), worse) -
                                        problems.begin());
      }
    }
    const auto index = static_cast<std::size_t>(wish_.which.count) - 1;
    return index < problems.size() ? std::optional(index) : std::nullopt;
  }

  [[nodiscard]] std::string stop_words() const {
    return knit::narrate(*timeline_.stop(), timeline_.parameters_of_stop());
  }

  [[nodiscard]] Found find_stop() const {
    if (timeline_.stop() != nullptr) return Destination{stop_words(), {}, timeline_.known(), {}, true};
    if (!timeline_.complete()) return nowhere("The run has not stopped: it is still being worked out.");
    return Destination{finished_words(session_), {}, {}, {}, true};
  }

  // --- operations --------------------------------------------------------------------------------------------

  struct Worked {
    std::int32_t row = 0, cell = 0;
    knit::Label label = knit::Label::knit;
    std::int32_t in_row = 1, of_row = 0;  // its rank among those of its kind in the row
  };

  [[nodiscard]] bool is_wished(knit::Label label) const {
    using knit::Label;
    if (wish_.shaping == Shaping::increase) return label == Label::m1l || label == Label::m1r;
    if (wish_.shaping == Shaping::decrease) return knit::is_decrease(label);
    constexpr std::array labels{Label::k2tog, Label::ssk, Label::m1l, Label::m1r};
    return label == labels.at(static_cast<std::size_t>(wish_.shaping));
  }

  [[nodiscard]] std::string shaping_word() const {
    constexpr std::array<std::string_view, 6> words{"k2tog", "ssk", "m1l", "m1r", "increase", "decrease"};
    return std::string(words.at(static_cast<std::size_t>(wish_.shaping)));
  }

  void add_worked(const knit::Join& join, std::vector<Worked>& worked) const {
    const std::size_t begin = worked.size();
    for (std::size_t cell = 0; cell < join.labels.size(); ++cell)
      if (is_wished(join.labels[cell]))
        worked.push_back({join.to, static_cast<std::int32_t>(cell), join.labels[cell],
                          static_cast<std::int32_t>(worked.size() - begin) + 1, 0});
    for (std::size_t i = begin; i < worked.size(); ++i)
      worked[i].of_row = static_cast<std::int32_t>(worked.size() - begin);
  }

  [[nodiscard]] std::int32_t widest_row() const {
    const auto& rows = run_.fabric.rows();
    const auto best = std::max_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
      return knit::size_of(*a) < knit::size_of(*b);
    });
    return best == rows.end() ? 0 : (*best)->id;
  }

  [[nodiscard]] Found find_operation() const {
    if (wish_.which.kind == WhichOne::Kind::worst) return nowhere(destination_forms());
    std::optional<std::int64_t> only = wish_.row;
    if (only && !wish_.piece.empty()) {
      const auto found = row_of_piece(*only);
      if (const auto* none = std::get_if<NoDestination>(&found)) return *none;
      only = std::get<0>(found).first;
    } else if (only && wish_.rounds && knit::has_limbs(run_)) {
      return nowhere(which_piece(*only));
    }
    const std::int64_t after = wish_.after_widest ? widest_row() : wish_.after.value_or(0);
    const std::int64_t until = wish_.until_widest ? widest_row() : run_.fabric.row_count();
    std::vector<Worked> worked;
    for (const auto& join : run_.fabric.joins())
      if (only ? join->to == *only : join->to > after && join->to <= until) add_worked(*join, worked);
    return pick_operation(worked, only, after);
  }

  [[nodiscard]] Found pick_operation(const std::vector<Worked>& worked, std::optional<std::int64_t> only,
                                     std::int64_t after) const {
    const std::string where = only                 ? " in row " + digits(*only)
                              : wish_.until_widest ? " up to row " + digits(widest_row()) + ", the widest"
                              : wish_.after_widest ? " after row " + digits(after) + ", the widest"
                              : after > 0          ? " after row " + digits(after)
                                                   : "";
    const auto count = static_cast<std::int64_t>(worked.size());
    const auto index = index_of_worked(worked);
    if (!index) {
      if (run_.fabric.joins().empty())
        return nowhere("Nothing is increased or decreased before the stage stitches.");
      if (count == 0) return nowhere("There is no " + shaping_word() + where + ".");
      if (wish_.which.kind == WhichOne::Kind::nth)
        return nowhere("There " + std::string(count == 1 ? "is" : "are") + " only " + digits(count) + " " +
                       shaping_word() + where + ".");
      return nowhere("No " + shaping_word() + where + " comes " +
                     (wish_.which.kind == WhichOne::Kind::next ? "after" : "before") + " this step.");
    }
    const Worked& found = worked[*index];
    const knit::LabelElement thing{found.row, found.cell};
    const auto made = knit::made_by(timeline_, thing);
    std::string words = "The " + ranked(static_cast<std::int64_t>(*index) + 1) + " of " + digits(count) +
                        " " + shaping_word() + where + ": " +
                        small_letters(std::string(knit::name_of(found.label))) + " " + digits(found.in_row) +
                        " of " + digits(found.of_row) + " in row " + digits(found.row);
    words +=
        made ? ", made by step " + digits(static_cast<std::int64_t>(*made) + 1) + ". " + said_by(*made) : ".";
    return to_thing(thing, words);
  }

  // Next and previous go by the steps that made them.
  [[nodiscard]] std::optional<std::size_t> index_of_worked(const std::vector<Worked>& worked) const {
    if (worked.empty()) return std::nullopt;
    if (wish_.which.kind == WhichOne::Kind::last) return worked.size() - 1;
    if (wish_.which.kind == WhichOne::Kind::nth) {
      const auto index = static_cast<std::size_t>(wish_.which.count) - 1;
      return index < worked.size() ? std::optional(index) : std::nullopt;
    }
    const bool next = wish_.which.kind == WhichOne::Kind::next;
    const std::size_t here = timeline_.position();
    std::size_t step = next ? here : here > 0 ? here - 1 : 0;
    for (; next ? step < timeline_.known() : step-- > 0; step += next ? 1 : 0) {
      const auto* shaping = knit::get_if<knit::ShapingPlaced>(timeline_.step(step));
      if (shaping == nullptr || !is_wished(shaping->label)) continue;
      const std::int32_t row = timeline_.step(step).place.row;
      for (std::size_t i = 0; i < worked.size(); ++i)
        if (worked[i].row == row && worked[i].cell == shaping->cell) return i;
    }
    return std::nullopt;
  }

  const Session& session_;
  const PlaceWish& wish_;
  const knit::Timeline& timeline_;
  const knit::State& run_;
};

}  // namespace

std::vector<std::string> piece_names_of(const Session& session) {
  std::vector<std::string> names;
  const auto pieces = pieces_of(session);
  for (std::int32_t i = 0; pieces && i < pieces->plan.count(); ++i) names.push_back(pieces->name_of(i));
  return names;
}

std::variant<Destination, NoDestination> destination_of(const Session& session, const std::string& typed) {
  const auto wish = read_place_wish(typed);
  if (!wish) return NoDestination{"\"" + typed + "\" is no place. " + destination_forms(), false};
  return Finder(session, *wish).find();
}

}  // namespace app
