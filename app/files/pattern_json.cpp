#include "app/files/pattern_json.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "knit/pattern/limb_needle.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using knit::Hand;

std::string_view json_word(Hand hand) { return hand == Hand::knit ? "knit" : knit::word_of(hand); }

Json operations_json(const std::vector<knit::Operation>& operations) {
  Json all = Json::array();
  for (std::size_t i = 0, end = 0; i < operations.size(); i = end) {
    for (end = i; end < operations.size() && operations[end] == operations[i];) ++end;
    Json run{{"hand", json_word(operations[i].hand)}, {"count", end - i}};
    if (operations[i].at_main) run["main"] = true;
    all.push_back(std::move(run));
  }
  return all;
}

Json round_json(const knit::Round& round) {
  Json json{{"number", round.number},
            {"before", round.before},
            {"after", round.after},
            {"operations", operations_json(round.operations)}};
  for (const knit::ShortRowPair& pair : round.pairs) json["pairs"].push_back({pair.first, pair.last});
  return json;
}

Json short_row_json(const knit::GraphShortRow& row) {
  return {{"row", row.row},
          {"first", row.first},
          {"stitches", row.stitches},
          {"side", row.wrong_side ? "WS" : "RS"},
          {"worked", row.worked}};
}

Json cast_on_stitch() { return {{"hand", "cast on"}, {"below", Json::array()}}; }

Json stitch_json(const knit::GraphStitch& stitch) {
  Json json{{"hand", json_word(stitch.hand)}, {"below", Json::array()}};
  for (std::int32_t i = 0; i < stitch.count; ++i) json["below"].push_back(stitch.first + i);
  if (stitch.count == 0) json["bar_after"] = stitch.first;
  return json;
}

std::string listed(std::string_view name, const std::vector<Json>& lines) {
  std::string out = "  \"" + std::string(name) + "\": [";
  for (std::size_t i = 0; i < lines.size(); ++i) out += (i == 0 ? "\n    " : ",\n    ") + lines[i].dump();
  return out + (lines.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string pattern_json(const knit::Rounds& rounds) {
  std::vector<Json> worked, graph;
  for (const knit::Round& round : rounds.rounds) worked.push_back(round_json(round));
  const knit::KnitGraph whole = knit::graph_of(rounds);
  for (const std::vector<knit::GraphStitch>& row : whole.rows) {
    Json stitches = Json::array();
    for (const knit::GraphStitch& stitch : row)
      stitches.push_back(graph.empty() ? cast_on_stitch() : stitch_json(stitch));
    graph.push_back(std::move(stitches));
  }
  std::vector<Json> short_rows;
  for (const knit::GraphShortRow& row : whole.short_rows) short_rows.push_back(short_row_json(row));
  return "{\n  \"format\": \"knit-mesh pattern\",\n  \"version\": 1,\n  \"cast_on\": " +
         std::to_string(rounds.cast_on) + ",\n" + listed("rounds", worked) + ",\n" + listed("graph", graph) +
         (short_rows.empty() ? "" : ",\n" + listed("short_rows", short_rows)) + "\n}\n";
}

namespace {

std::string_view json_word(knit::LimbDealKind kind) {
  constexpr std::array<std::string_view, 8> words{"cast on", "provisional", "loops",  "rejoin",
                                                  "aside",   "move",        "divide", "join"};
  return words.at(static_cast<std::size_t>(kind));
}
std::string_view json_word(knit::LimbItemKind kind) {
  constexpr std::array<std::string_view, 4> words{"keep", "take", "cast on", "pick up"};
  return words.at(static_cast<std::size_t>(kind));
}
std::string_view json_word(knit::LimbEndKind kind) {
  constexpr std::array<std::string_view, 4> words{"held", "goes on", "closed", "grafted"};
  return words.at(static_cast<std::size_t>(kind));
}

Json item_json(const knit::LimbNames& names, const knit::LimbItem& item) {
  Json json{{"use", json_word(item.kind)}, {"count", item.count}};
  if (item.kind == knit::LimbItemKind::take) {
    json["holder"] = names.holder(item.piece, item.holder);
    json["first"] = item.first;
    json["held"] = item.held;
  }
  if (item.gap > 0) json["gap"] = item.gap;
  if (item.kind == knit::LimbItemKind::pick_up) json["first"] = item.first;
  return json;
}

Json deal_json(const knit::LimbNames& names, const knit::LimbDeal& deal) {
  Json json{{"kind", json_word(deal.kind)}, {"after", deal.after}};
  if (deal.kind == knit::LimbDealKind::loops) json["piece"] = names(deal.piece);
  if (deal.kind == knit::LimbDealKind::divide || deal.kind == knit::LimbDealKind::set_aside)
    json["holder"] = names.holder(deal.piece, deal.holder);
  if (deal.kind == knit::LimbDealKind::divide) {
    json["keep"] = deal.before;
    json["held"] = deal.held;
    json["gap"] = deal.gap;
    json["bridge"] = deal.bridge;
    json["rest"] = deal.rest;
  }
  if (deal.kind == knit::LimbDealKind::move) json["slip"] = deal.before;
  if (deal.items.empty()) return json;
  json["items"] = Json::array();
  for (const knit::LimbItem& item : deal.items) json["items"].push_back(item_json(names, item));
  return json;
}

// [own stitch, the other's], each in its last round from its marker.
Json pairs_json(const knit::LimbEnd& end, std::int32_t own_count, std::int32_t others_count) {
  Json pairs = Json::array();
  std::int32_t own = own_count - end.slips_back, other = end.other_first + others_count;
  for (const knit::LimbGraft& graft : end.grafts) {
    for (std::int32_t a = 0; a < graft.own; ++a) {
      for (std::int32_t b = 0; b < graft.others; ++b)
        pairs.push_back({(own + a) % own_count, (other - b + others_count) % others_count});
    }
    own += graft.own;
    other -= graft.others;
  }
  return pairs;
}

Json end_json(const knit::LimbNames& names, const knit::LimbPlan& plan, const knit::LimbPiece& piece) {
  const knit::LimbEnd& end = piece.end;
  Json json{{"kind", json_word(end.kind)}};
  if (end.piece >= 0) json["piece"] = names(end.piece);
  if (end.kind != knit::LimbEndKind::grafted) return json;
  json["by"] = end.three_needle ? "three-needle" : "kitchener";
  json["slips_back"] = end.slips_back;
  json["others_first"] = end.other_first;
  json["grafts"] = Json::array();
  for (const knit::LimbGraft& graft : end.grafts) json["grafts"].push_back({graft.own, graft.others});
  json["pairs"] = pairs_json(end, piece.last_count(), plan.piece(end.piece).last_count());
  return json;
}

// What the stitches of a round hang on, of those below from the marker.
Json row_json(const knit::LimbRound& round) {
  Json row = Json::array();
  const knit::KnitGraph graph =
      knit::graph_of(knit::Rounds{round.before, {{2, round.operations, round.before, round.after}}});
  for (knit::GraphStitch stitch : graph.rows.back()) {
    // The last stitch is worked first where it is slipped back; two that are taken together may lie on both sides of the marker.
    const auto from_marker = [&](std::int32_t worked) {
      return round.slips_back ? (worked + round.before - 1) % round.before : worked;
    };
    Json json = stitch_json(stitch);
    for (Json& below : json["below"]) below = from_marker(below.get<std::int32_t>());
    if (stitch.count == 0) json["bar_after"] = from_marker(stitch.first);
    row.push_back(std::move(json));
  }
  return row;
}

Json graph_json(const knit::LimbPiece& piece) {
  Json rows = Json::array();
  if (piece.is_cast_on())
    rows.push_back(Json(static_cast<std::size_t>(piece.first_count()), cast_on_stitch()));
  for (const knit::LimbRound& round : piece.rounds) rows.push_back(row_json(round));
  return rows;
}

// `row`: of the piece's graph, -1 for what it begins on.
std::vector<knit::GraphShortRow> short_rows_of(const knit::LimbPiece& piece) {
  std::vector<knit::GraphShortRow> rows;
  std::int32_t below = piece.is_cast_on() ? 0 : -1;
  for (const knit::LimbRound& round : piece.rounds) {
    const knit::Rounds alone{round.before, {{2, round.operations, round.before, round.after, round.pairs}}};
    for (knit::GraphShortRow row : knit::graph_of(alone).short_rows) {
      row.row = below;
      rows.push_back(row);
    }
    ++below;
  }
  return rows;
}

// Stitches that follow each other, one run: [piece, first, count, step], or ["gap 2", first, count, step]; the step is -1 where
// they run backwards.
Json live_json(const knit::LimbNames& names, const std::vector<knit::NeedleStitch>& needle) {
  Json runs = Json::array();
  for (std::size_t i = 0, end = 0; i < needle.size(); i = end) {
    const auto follows = [&](std::size_t k, std::int32_t step) {
      return k < needle.size() && needle[k].piece == needle[i].piece && needle[k].gap == needle[i].gap &&
             needle[k].stitch == needle[k - 1].stitch + step;
    };
    const std::int32_t step = follows(i + 1, -1) ? -1 : 1;
    for (end = i + 1; follows(end, step);) ++end;
    const std::string whose =
        needle[i].gap > 0 ? "gap " + std::to_string(needle[i].gap) : names(needle[i].piece);
    runs.push_back({whose, needle[i].stitch, end - i, step});
  }
  return runs;
}

Json piece_json(const knit::LimbNames& names, const knit::LimbPlan& plan, std::int32_t number,
                const knit::PieceNeedle& needle) {
  const knit::LimbPiece& piece = plan.piece(number);
  Json json{{"name", names(number)}, {"begin", Json::array()}, {"rounds", Json::array()}};
  if (piece.twins.front() != number) json["twin_of"] = names(piece.twins.front());
  if (piece.inner) json["inner"] = true;
  for (const knit::LimbDeal& deal : piece.deals) json["begin"].push_back(deal_json(names, deal));
  if (!piece.is_cast_on()) json["live"] = live_json(names, needle.begin);
  std::int32_t next = piece.is_cast_on() ? 2 : 1;
  for (const knit::LimbRound& round : piece.rounds) {
    Json line = round_json({next++, round.operations, round.before, round.after, round.pairs});
    if (round.slips_back) line["slips_back"] = true;
    json["rounds"].push_back(std::move(line));
  }
  json["graph"] = graph_json(piece);
  for (const knit::GraphShortRow& row : short_rows_of(piece))
    json["short_rows"].push_back(short_row_json(row));
  json["rows"] = piece.rows;
  json["starts"] = piece.starts;
  json["end"] = end_json(names, plan, piece);
  return json;
}

}  // namespace

std::string pattern_json(const knit::LimbPlan& plan, const knit::PatternOptions& options) {
  const knit::LimbNames names(plan, options);
  const std::vector<knit::PieceNeedle> needles = knit::needles_of(plan);
  std::vector<Json> lines;
  lines.reserve(static_cast<std::size_t>(plan.count()));
  for (std::int32_t i = 0; i < plan.count(); ++i)
    lines.push_back(piece_json(names, plan, i, needles[static_cast<std::size_t>(i)]));
  return "{\n  \"format\": \"knit-mesh pattern\",\n  \"version\": 2,\n  \"yarns\": " +
         std::to_string(plan.yarns) + ",\n  \"holders\": " + std::to_string(plan.held_most) +
         ",\n  \"holders_needed\": " + std::to_string(knit::holders_needed(plan)) +
         ",\n  \"gaps\": " + Json(plan.gaps).dump() + ",\n" + listed("pieces", lines) + "\n}\n";
}

}  // namespace app
