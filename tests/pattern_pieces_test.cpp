// Patterns in pieces: what is told is worked on a needle and holders, without a look at how it was made, and must come out
// even, as the very live stitches that the fabric's rows were worked on.
#include "knit/pattern/pieces.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "app/files/pattern_export.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern_lines.h"
#include "app/panels/pattern/pattern_parts.h"
#include "knit/mesh/shapes.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "knit/pattern/written_pattern.h"
#include "knit/run/timeline.h"
#include "tests/support/bodies.h"
#include "tests/support/catch.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace knit;

namespace {

// --- a needle, holders, gaps ---

struct Loop {
  std::int32_t piece = 0;  // below 0: of a gap, -its number
  std::int32_t place = 0;
  friend auto operator<=>(const Loop&, const Loop&) = default;
};

class Hands {
 public:
  Hands(const Pieces& pieces, const Fabric& fabric) : pieces_(pieces), fabric_(fabric) {}

  void work() {
    for (now_ = 0; now_ < static_cast<std::int32_t>(pieces_.pieces.size()); ++now_) {
      INFO(piece_name(now_));
      begin();
      work_rounds();
      end();
    }
    CHECK(needle_.empty());
    CHECK(held() == 0);
    CHECK(to_pick_up_.empty());
    CHECK(waste_.empty());
    CHECK(hanging_.empty());
    CHECK(cast_on_.size() == pieces_.gaps.size());
    CHECK(most_ == pieces_.held_most);
    CHECK(yarns_ == pieces_.yarns);
  }

 private:
  [[nodiscard]] const Piece& piece() const { return pieces_.piece(now_); }
  [[nodiscard]] std::int32_t last_size(std::int32_t piece) const {
    return pieces_.piece(piece).rounds.last_count();
  }
  [[nodiscard]] std::int32_t held() const {
    return static_cast<std::int32_t>(std::count_if(
        holders_.begin(), holders_.end(), [](const auto& holder) { return !holder.second.empty(); }));
  }

  void begin() {
    take_yarn();
    const std::vector<Loop> lying = std::exchange(needle_, {});
    std::size_t dealt = 0;
    for (const Lay& lay : piece().laid) lay_down(lay, lying, dealt);
    CHECK(dealt == lying.size());
    if (piece().is_cast_on()) {
      CHECK(piece().laid.empty());
      if (piece().start == PieceStart::provisional) waste_.insert(now_);
    } else {
      CHECK(static_cast<std::int32_t>(needle_.size()) + loops_ == piece().rounds.cast_on);
      if (loops_ == 0) compare_with_fabric();
    }
    loops_ = 0;
  }

  void lay_down(const Lay& lay, const std::vector<Loop>& lying, std::size_t& dealt) {
    CHECK(lay.count > 0);
    switch (lay.kind) {
      case LayKind::keep:
      case LayKind::set_aside: {
        const bool keep = lay.kind == LayKind::keep;
        auto& to = keep ? needle_ : holders_[{now_ - 1, lay.piece}];
        CHECK((keep ? lay.piece == now_ - 1 : lay.piece > now_));
        for (std::int32_t i = 0; i < lay.count; ++i) {
          REQUIRE(dealt < lying.size());
          CHECK(lying[dealt] == Loop{now_ - 1, lay.first + i});
          to.push_back(lying[dealt++]);
        }
        return;
      }
      case LayKind::take:
        for (std::int32_t i = 0; i < lay.count; ++i)
          take({lay.piece, (lay.first + i) % last_size(lay.piece)});
        return;
      case LayKind::cast_on:
        CHECK(cast_on_.insert(lay.gap).second);
        CHECK(lay.count == pieces_.gap(lay.gap));
        for (std::int32_t i = 0; i < lay.count; ++i) {
          needle_.push_back({-lay.gap, i});
          to_pick_up_.insert({-lay.gap, i});
        }
        return;
      case LayKind::pick_up:
        for (std::int32_t i = lay.count; i-- > 0;) {
          needle_.push_back({-lay.gap, lay.first + i});
          CHECK(to_pick_up_.erase({-lay.gap, lay.first + i}) == 1);
        }
        return;
      case LayKind::loops:
        CHECK(waste_.erase(lay.piece) == 1);
        CHECK(lay.count == pieces_.piece(lay.piece).rounds.cast_on);
        loops_ = lay.count;
        return;
    }
  }

  void take(const Loop& loop) {
    auto* holder = &holders_[{loop.piece, now_}];
    if (holder->empty()) holder = &holders_[{loop.piece, -1}];
    const auto found = std::find(holder->begin(), holder->end(), loop);
    REQUIRE(found != holder->end());
    holder->erase(found);
    needle_.push_back(loop);
  }

  // A gap's stitches are one bridge's, always the same.
  void compare_with_fabric() {
    const LiveStitches& on = fabric_.row(piece().first_row).on;
    REQUIRE(on.size() == static_cast<std::int32_t>(needle_.size()));
    for (std::int32_t i = 0; i < on.size(); ++i) {
      const Loop& loop = needle_[static_cast<std::size_t>(i)];
      const StitchRef ref = on.at(i);
      CHECK(is_bridge(ref) == (loop.piece < 0));
      if (loop.piece < 0)
        CHECK(bridges_.emplace(loop, ref).first->second == ref);
      else
        CHECK(ref == StitchRef{last_row(loop.piece), loop.place});
    }
  }
  [[nodiscard]] RowId last_row(std::int32_t piece) const {
    return pieces_.piece(piece).first_row + pieces_.piece(piece).round_count() - 1;
  }

  void take_yarn() {
    if (piece().yarn == PieceYarn::begun) {
      ++yarns_;
      return;
    }
    const auto first = std::find_if(piece().laid.begin(), piece().laid.end(),
                                    [](const Lay& lay) { return lay.kind != LayKind::set_aside; });
    REQUIRE(first != piece().laid.end());
    CHECK(first->first == 0);
    CHECK(hanging_.erase(first->piece) == 1);
    CHECK(pieces_.piece(first->piece).end.yarn_for == now_);
    CHECK((piece().yarn == PieceYarn::goes_on) == (first->piece + 1 == now_));
  }

  void work_rounds() {
    most_ = std::max(most_, held());
    std::int32_t there = piece().rounds.cast_on, number = piece().is_cast_on() ? 2 : 1;
    for (const Round& round : piece().rounds.rounds) {
      const OperationCount sum = count(round.operations);
      CHECK(round.number == number++);
      CHECK(round.before == there);
      CHECK(sum.consumed == there);
      CHECK(sum.produced == round.after);
      there = round.after;
      CHECK(there == size_of(fabric_.row(piece().first_row + round.number - 1)));
    }
    needle_.clear();
    for (std::int32_t i = 0; i < there; ++i) needle_.push_back({now_, i});
  }

  void end() {
    const PieceEnd& end = piece().end;
    if (end.yarn_for >= 0) hanging_.insert(now_);
    switch (end.kind) {
      case PieceEndKind::goes_on:
        CHECK(pieces_.piece(now_ + 1).start == PieceStart::divided);
        return;
      case PieceEndKind::held:
        holders_[{now_, -1}] = std::exchange(needle_, {});
        return;
      case PieceEndKind::grafted: {
        std::int32_t own = 0, others = 0;
        for (const Grafted& graft : end.grafts) {
          own += graft.own;
          others += graft.others;
        }
        CHECK(own == static_cast<std::int32_t>(needle_.size()));
        CHECK(others == static_cast<std::int32_t>(holders_[{end.to.front(), -1}].size()));
        holders_[{end.to.front(), -1}].clear();
        break;
      }
      case PieceEndKind::closed:
        break;
    }
    needle_.clear();
  }

  const Pieces& pieces_;
  const Fabric& fabric_;
  std::int32_t now_ = 0, most_ = 0, yarns_ = 0, loops_ = 0;
  std::vector<Loop> needle_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Loop>>
      holders_;  // of a piece, for whom; -1: for all
  std::set<Loop> to_pick_up_;
  std::set<std::int32_t> cast_on_, waste_, hanging_;
  std::map<Loop, StitchRef> bridges_;
};

// --- the words ---

std::int32_t sum_of(const std::string& text, const std::string& pattern) {
  std::int32_t sum = 0;
  const std::regex number(pattern);
  for (auto at = std::sregex_iterator(text.begin(), text.end(), number); at != std::sregex_iterator(); ++at)
    sum += std::stoi((*at)[1]);
  return sum;
}

// Headings in order, with the rounds and the count that follow; lines that lay stitches on the needle add up.
void check_words(const Pieces& pieces, const WrittenPattern& pattern) {
  using Kind = WrittenPattern::Instruction::Kind;
  std::int32_t piece = -1, round = 0, stitches = 0;
  const auto piece_is_whole = [&] {
    if (piece < 0) return;
    CHECK(round == pieces.piece(piece).round_count());
    CHECK(stitches == pieces.piece(piece).rounds.last_count());
  };
  for (const auto& line : pattern.instructions) {
    INFO(line.remark);
    if (line.round) {
      CHECK(line.round->first == round + 1);
      CHECK(line.round->rows_before + 1 == pieces.piece(piece).first_row);
      round = line.round->last;
      stitches = line.round->stitches;
    } else if (line.kind == Kind::heading) {
      piece_is_whole();
      ++piece;
      round = 0;
      const Piece& now = pieces.piece(piece);
      CHECK(line.remark == piece_name(piece) + ": " + plural(now.round_count(), "rnd", "rnds") + ", " +
                               plural(now.rounds.last_count(), "st", "sts") + " at the end");
    } else if (line.kind == Kind::step && line.row > 0) {
      CHECK(line.row == pieces.piece(piece).first_row);
      stitches = sum_of(line.remark, "CO (\\d+) st");
      CHECK(stitches == pieces.piece(piece).rounds.cast_on);
      round = 1;
    } else if (line.kind == Kind::step) {
      const std::int32_t laid =
          sum_of(line.remark, "(?:keep|take|CO|pick up|its) (\\d+) (?:st|held|of the|loops)");
      const std::int32_t aside = sum_of(line.remark, "place next (\\d+) st");
      stitches = sum_of(line.remark, "\\((\\d+) sts?[;)]");
      CHECK(laid == stitches);
      CHECK(stitches == pieces.piece(piece).rounds.cast_on);
      CHECK(aside == sum_of(line.remark, "; Piece [A-Z]+ (\\d+) sts?"));
    }
  }
  piece_is_whole();
  CHECK(piece + 1 == static_cast<std::int32_t>(pieces.pieces.size()));
}

// --- shapes ---

Parameters parameters_for(const Input& input, double width_share) {
  Parameters parameters = default_parameters(input.bounds);
  give_width(parameters, width_share * input.bounds.diagonal());
  parameters = resolved(parameters, input);
  parameters.timing.axis.kind = AxisKind::y;
  parameters.rows.source = RowSource::contours;
  parameters.stitches.placement = PlacementPolicy::nearest;
  return parameters;
}

State run_of(const Mesh& mesh, double width_share) {
  const auto input = make_input(mesh);
  Timeline run(input, parameters_for(*input, width_share));
  run.extend_to_end();
  REQUIRE(run.complete());
  return run.furthest();
}

Mesh turned_down(Mesh mesh) {
  for (glm::dvec3& p : mesh.positions) p = {p.x, -p.y, -p.z};
  return mesh;
}

Mesh standing_torus() {
  Mesh mesh = torus(32, 16, 1.0, 0.4);
  for (glm::dvec3& p : mesh.positions) p = {p.x, -p.z, p.y};
  return mesh;
}

WrittenPattern words_for(const Pieces& pieces) { return write_pattern(pieces, {22.0, 32.0}, {}, "shape"); }

void check_all(const State& state) {
  REQUIRE(in_pieces(state));
  REQUIRE(pieces_are_known(state));
  const Pieces pieces = pieces_of(state);
  Hands(pieces, state.fabric).work();
  check_words(pieces, words_for(pieces));
}

std::string lines_between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  REQUIRE(begin != std::string::npos);
  return text.substr(begin, text.find(to, begin) - begin);
}

std::string told(const WrittenPattern& pattern) {
  std::string text;
  for (const auto& line : pattern.instructions)
    text += (line.round ? line.round->text() : line.remark) + "\n";
  return text;
}

bool has_words(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("pieces: one chain of rows is not in pieces") {
  CHECK_FALSE(in_pieces(run_of(sphere(24, 16), 0.08)));
  CHECK_FALSE(in_pieces(State{}));
}

TEST_CASE("pieces: a torus that stands is divided and joined") {
  for (const double width : {0.03, 0.04, 0.06}) {
    CAPTURE(width);
    const State state = run_of(standing_torus(), width);
    check_all(state);
    const Pieces pieces = pieces_of(state);
    REQUIRE(pieces.pieces.size() == 4);
    CHECK(pieces.yarns == state.tubes->yarns);
    CHECK(pieces.held_most == state.tubes->held_most);
    const std::string text = told(words_for(pieces));
    CHECK(has_words(lines_between(text, "Piece B: ", "Rnd 1"), "Divide: "));
    CHECK(has_words(lines_between(text, "Piece C: ", "Rnd 1"), "held sts of Piece A"));
    CHECK(has_words(lines_between(text, "Piece D: ", "Rnd 1"), "Join with Piece B: "));
    CHECK(pieces.piece(1).end.kind == PieceEndKind::held);
    CHECK(pieces.piece(3).end.kind == PieceEndKind::closed);
  }
}

TEST_CASE("pieces: a torus that lies is cast on provisionally and grafted") {
  const State state = run_of(torus(48, 24, 1.0, 0.4), 0.04);
  check_all(state);
  const Pieces pieces = pieces_of(state);
  REQUIRE(pieces.pieces.size() == 2);
  const std::string text = told(words_for(pieces));
  CHECK(has_words(text, "Pieces A and B start from one cast-on edge (provisional cast on)."));
  CHECK(has_words(text, "Remove the waste yarn of Piece A"));
  CHECK(has_words(text, "Graft to Piece A"));
  CHECK(has_words(text, "through to the inside, wrong sides together."));
  CHECK(pieces.piece(0).inner != pieces.piece(1).inner);
}

TEST_CASE("pieces: two feet are joined, two horns are divided") {
  for (const double width : {0.04, 0.07}) {
    CAPTURE(width);
    const State feet = run_of(test_support::arch(), width);
    check_all(feet);
    CHECK(pieces_of(feet).piece(0).end.kind == PieceEndKind::held);
    const State horns = run_of(turned_down(test_support::arch()), width);
    check_all(horns);
    CHECK(pieces_of(horns).yarns == 2);
  }
}

TEST_CASE("pieces: notes tell yarns, holders, and what is not there yet") {
  const WrittenPattern pattern = words_for(pieces_of(run_of(standing_torus(), 0.05)));
  std::string notes;
  for (const std::string& note : pattern.notes) notes += note + "\n";
  CHECK(has_words(notes, "2 yarns are begun in all"));
  CHECK(has_words(notes, "At most 1 holder is in use at once."));
  CHECK(has_words(notes, "cannot read patterns in pieces yet, and there is no chart for them yet."));
  for (const std::string& line : pattern.size) CHECK_FALSE(has_words(line, "high"));
  CHECK(has_words(pattern_as_text(pattern), "\n\nPiece B: "));
  CHECK(has_words(pattern_as_markdown(pattern), "\n\n### Piece B: "));
}

TEST_CASE("pieces: yarn counts the stitches of all rounds, and of gaps once") {
  const State state = run_of(standing_torus(), 0.05);
  const Gauge gauge{22.0, 32.0};
  const PatternSizes sizes = sizes_of(pieces_of(state), gauge);
  Rounds all;
  all.cast_on = static_cast<std::int32_t>(state.fabric.stitch_count());
  CHECK(sizes.yarn_m == sizes_of(all, gauge).yarn_m);
  CHECK(sizes.height_cm == 0.0);
  CHECK(sizes.length_cm == 0.0);
}

namespace {

// Adds a plain round on a tube's loop; of a tube without one: a cast on.
void add_round(State& state, TubeId tube, std::int32_t cast_on = 0) {
  const LiveStitches on = state.fabric.live(tube);
  const std::int32_t stitches = on.empty() ? cast_on : on.size();
  Join join;
  join.tube = tube;
  join.to = state.fabric.next_row();
  join.from = on;
  join.below = join.above = stitches;
  join.labels.assign(static_cast<std::size_t>(stitches), Label::knit);
  for (std::int32_t i = 0; i < stitches; ++i) join.partner.push_back(i);
  join.link = join.partner;
  Row row;
  row.tube = tube;
  row.id = join.to;
  row.on = on;
  row.stitches.resize(static_cast<std::size_t>(stitches));
  state.fabric.add(std::move(row));
  if (!on.empty()) state.fabric.add(Shared(std::move(join)));
}

// One stretch to the first child, the rest to the second, a bridge of two between.
void add_split(State& state, TubeId from, std::array<TubeId, 2> to, std::int32_t first, std::int32_t count) {
  Deal deal;
  deal.after = state.fabric.row_count();
  deal.from = {from};
  deal.to = {to[0], to[1]};
  const LiveStitches loop = state.fabric.live(from);
  deal.taken = {loop};
  deal.bridge.resize(2);
  const RowId bridge = bridge_row(static_cast<std::int32_t>(state.fabric.deals().size()) + 1);
  LiveStitches one = stretch_of(loop, first, count);
  LiveStitches two = stretch_of(loop, (first + count) % loop.size(), loop.size() - count);
  one.append({bridge, 0, 2});
  two.append({bridge, 1, 1});
  two.append({bridge, 0, 1});
  deal.given = {one, two};
  state.fabric.add(std::move(deal));
}

}  // namespace

TEST_CASE("pieces: a tube without rounds has no words, its children begin on what it was dealt from") {
  State state;
  add_round(state, 0, 20);
  add_round(state, 0);
  add_split(state, 0, {1, 2}, 0, 6);   // tube 2 has no round: 14 stitches and the bridge
  add_split(state, 2, {3, 4}, 12, 8);  // the bridge lies within what tube 3 gets
  for (const TubeId tube : {1, 3, 4}) add_round(state, tube);
  check_all(state);
  const Pieces pieces = pieces_of(state);
  REQUIRE(pieces.pieces.size() == 4);
  CHECK(pieces.held_most == 2);
  CHECK(pieces.yarns == 3);
  const std::string text = told(words_for(pieces));
  CHECK(has_words(
      text,
      "Divide: keep 6 sts, place next 4 sts on a holder for Piece C, place next 8 sts on a holder for "
      "Piece D, place next 2 sts on the holder for Piece C, CO 2 sts over gap 1. (8 sts; Piece C 6 sts; "
      "Piece D 8 sts)"));
  CHECK(has_words(
      text,
      "Rejoin yarn: take 2 held sts of Piece A (its sts 19 to 20), pick up 2 sts along gap 1, take 4 "
      "held sts of Piece A (its sts 7 to 10), CO 2 sts over gap 2. (10 sts)"));
  CHECK(has_words(text, "Rejoin yarn: take 8 held sts of Piece A, pick up 2 sts along gap 2. (10 sts)"));
}

namespace {

app::Document torus_document() {
  const auto input = make_input(standing_torus());
  const Parameters parameters = parameters_for(*input, 0.05);
  app::Document document(Timeline(input, parameters));
  document.original = std::make_shared<const Mesh>(input->mesh);
  document.defaults = parameters;
  document.timeline.extend_to_end();
  return document;
}

app::Session torus_session() {
  app::Session session;
  session.document = torus_document();
  app::apply(session, app::ToLast{});
  return session;
}

}  // namespace

TEST_CASE("pieces: text, Markdown and page have headings and no chart") {
  const app::Session session = torus_session();
  CHECK_FALSE(app::pattern_missing(session));
  const std::string text = pattern_file_text(session, app::PatternFormat::text);
  CHECK(has_words(text, "\n\nPiece D: "));
  CHECK_FALSE(has_words(text, "CHART"));
  CHECK(has_words(pattern_file_text(session, app::PatternFormat::markdown), "\n### Piece D: "));
  const std::string page = pattern_file_text(session, app::PatternFormat::html);
  CHECK(has_words(page, "<li class=\"piece\">Piece D: "));
  CHECK(has_words(page, "<li class=\"round step\">Join with Piece "));
  CHECK_FALSE(has_words(page, "<svg"));
  const std::vector<std::string> lines = pattern_instructions(session);
  CHECK(lines.front() == "Worked in 4 pieces, one after the other, from A to D.");
  CHECK(has_words(lines.at(1), "Piece A: "));
}

TEST_CASE("pieces: chart and knitspeak are refused in one sentence") {
  const app::Session session = torus_session();
  for (const auto& refused :
       {app::chart_missing(session), app::format_missing(session, app::PatternFormat::knitspeak)}) {
    REQUIRE(refused);
    CHECK(test_support::is_one_sentence(*refused));
    CHECK(has_words(*refused, "in pieces"));
  }
  CHECK_FALSE(app::format_missing(session, app::PatternFormat::json));
  const app::Session ball = test_support::finished_small_session();
  CHECK_FALSE(app::chart_missing(ball));
  CHECK_FALSE(app::format_missing(ball, app::PatternFormat::knitspeak));
}

TEST_CASE("pieces: JSON has a line for each, with what it is laid on") {
  const app::Session session = torus_session();
  const auto json = nlohmann::json::parse(pattern_file_text(session, app::PatternFormat::json));
  CHECK(json.at("version") == 2);
  CHECK(json.at("yarns") == 2);
  CHECK(json.at("gaps").size() == 2);
  REQUIRE(json.at("pieces").size() == 4);
  for (const auto& piece : json.at("pieces")) {
    int laid = 0;
    for (const auto& lay : piece.at("laid"))
      laid += lay.at("use") == "set aside" ? 0 : lay.at("count").get<int>();
    if (piece.at("start") != "cast on") CHECK(laid == piece.at("stitches").get<int>());
    CHECK(piece.at("rounds").front().at("before") == piece.at("stitches"));
  }
}

TEST_CASE("pieces: the tab has headings, and its lines say rows of the fabric") {
  const WrittenPattern pattern = words_for(pieces_of(run_of(standing_torus(), 0.05)));
  const std::vector<app::PatternLine> lines = app::lines_of(pattern);
  std::int32_t pieces = 0, row = 0;
  for (const app::PatternLine& line : lines) {
    pieces += line.kind == app::PatternLine::Kind::piece ? 1 : 0;
    if (!line.rounds) continue;
    CHECK(line.rounds->first == row + 1);
    row = line.rounds->last;
  }
  CHECK(pieces == 4);
  CHECK(row == run_of(standing_torus(), 0.05).fabric.row_count());
}

TEST_CASE("pieces: no chart and no knitting along, but a sentence") {
  desk::Desk desk;
  desk.session.document = torus_document();
  desk.act({app::ToLast{}, app::ShowSide{app::SidePanel::pattern}});
  desk.settle();
  CHECK(desk.ui.controls.count("pattern/text") == 1);
  const app::ChartCache& cache = desk.ui.own<app::ChartCache>();
  CHECK(cache.in_pieces());
  CHECK(cache.has_pattern());
  CHECK(cache.rounds() == 0);
  desk.act({app::ShowCentre{app::CentrePanel::chart}, app::KnitAlong{7}});
  desk.settle();
  CHECK(desk.ui.controls.count("chart") == 0);
  CHECK(desk.ui.controls.count("knit-along/line") == 0);
}
