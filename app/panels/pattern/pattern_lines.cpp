#include "app/panels/pattern/pattern_lines.h"

#include "app/panels/kit/widgets.h"
#include "app/session/view.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

namespace app {

namespace {

using Kind = PatternLine::Kind;

// "(30 sts)", "Rnd 7" and "6 times" stay on one line.
std::string unbroken(std::string text) {
  constexpr std::string_view blank = "\xC2\xA0";
  for (const std::string_view word : {" sts", " st)", " times"}) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      text.replace(at, 1, blank);
  }
  for (std::size_t at = text.find("Rnd "); at != std::string::npos; at = text.find("Rnd ", at + 1))
    text.replace(at + 3, 1, blank);
  return text;
}

// "Rnd 7:" apart from what is worked.
PatternLine line_of_round(const knit::RoundLine& round) {
  const std::string text = unbroken(round.text());
  const std::size_t colon = text.find(": ");
  const RoundSpan rows{round.first + round.rows_before, round.last + round.rows_before};
  PatternLine line{Kind::round, {}, text, rows};
  if (colon != std::string::npos) {
    line.label = text.substr(0, colon + 1);
    line.words = text.substr(colon + 2);
  }
  for (const std::int32_t before : round.twins_before)
    line.twins.push_back({round.first + before, round.last + before});
  return line;
}

std::string in_lower_case(std::string words) {
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return words;
}

// "knit 2 rnds": 2; a name: 1.
std::int32_t rounds_of_part(std::string_view part) {
  constexpr std::string_view knits = "knit ";
  std::int32_t rounds = 1;
  if (part.starts_with(knits)) std::from_chars(part.data() + knits.size(), part.data() + part.size(), rounds);
  return std::max(1, rounds);
}

// The rounds of a line of the short form that are worked as `name` says: of "[Knit 2 rnds, inc rnd] 3 times" every third.
// The words in brackets are a turn: rounds to knit, and names of one round each.
std::vector<std::int32_t> rounds_named(const knit::RoundLine& line, std::string_view name) {
  const std::size_t open = line.words.starts_with('[') ? 1 : 0;
  const std::string turn =
      in_lower_case(line.words.substr(open, open > 0 ? line.words.find(']') - 1 : std::string::npos));
  std::vector<std::int32_t> found;
  std::int32_t round = line.first;
  while (round <= line.last) {
    const std::int32_t begun = round;
    for (std::size_t at = 0; at < turn.size();) {
      const std::size_t end = std::min(turn.find(", ", at), turn.size());
      const std::string part = turn.substr(at, end - at);
      if (part == name) found.push_back(round);
      round += rounds_of_part(part);
      at = end + 2;
    }
    if (round == begun || open == 0) break;
  }
  return found;
}

// "Inc rnd: [K1, m1l, k to next m, m1r] 4 times. (+8 sts)", of the rounds that are worked so.
PatternLine line_of_named(const std::string& text, const knit::WrittenPattern& pattern) {
  const std::size_t colon = std::min(text.find(": "), text.size());
  const std::string name = text.substr(0, colon);
  PatternLine line{Kind::named, name + ":", unbroken(text.substr(std::min(colon + 2, text.size()))), {}};
  for (const auto& instruction : pattern.instructions) {
    if (!instruction.round || instruction.round->counts.empty()) continue;
    for (const std::int32_t round : rounds_named(*instruction.round, in_lower_case(name))) {
      const RoundSpan span{round, round};
      if (line.rounds)
        line.twins.push_back(span);
      else
        line.rounds = span;
    }
  }
  return line;
}

// A long deal is read item by item.
std::string one_item_a_line(std::string words) {
  constexpr std::size_t is_long = 200;
  if (words.size() < is_long) return words;
  for (std::size_t at = words.find(": "); at != std::string::npos; at = words.find(", ", at + 1))
    words[at + 1] = '\n';
  return words;
}

// Of pieces: what they are called, how they begin and end, and what is to be thought of. Each heading stands for the next
// pieces made together; what comes before their first round are their deals, what comes after it their ends.
class PieceLines {
 public:
  PieceLines(const knit::WrittenPattern& pattern, const knit::LimbPlan* plan)
      : pattern_(pattern), plan_(plan) {}

  PatternLine line_of(const knit::WrittenPattern::Instruction& instruction) {
    using Words = knit::WrittenPattern::Instruction::Kind;
    if (instruction.round) {
      rounds_begun_ = true;
      return line_of_round(*instruction.round);
    }
    PatternLine line{Kind::remark, {}, instruction.remark, {}};
    if (instruction.kind == Words::remark) return line;
    if (instruction.kind == Words::step && !pattern_.in_pieces)
      return line_of_named(instruction.remark, pattern_);
    line.kind = instruction.kind == Words::heading ? Kind::piece : Kind::round;
    line.words = unbroken(instruction.remark);
    if (instruction.kind == Words::heading) begin_piece();
    if (plan_ == nullptr || now_ >= pattern_.pieces.size()) return line;
    for (const std::int32_t piece : pattern_.pieces[now_].pieces) {
      const std::vector<knit::RowId>& rows = plan_->piece(piece).rows;
      const RoundSpan whole{rows.front(), rows.back()};
      const std::int32_t at = rounds_begun_ ? whole.last : whole.first;
      const RoundSpan span = line.kind == Kind::piece ? whole : RoundSpan{at, at};
      if (line.rounds)
        line.twins.push_back(span);
      else
        line.rounds = span;
    }
    if (line.kind == Kind::round && !rounds_begun_) {
      line.deal = next_deal();
      line.words = one_item_a_line(std::move(line.words));
    }
    return line;
  }

 private:
  void begin_piece() {
    now_ = begun_ ? now_ + 1 : 0;
    begun_ = true;
    rounds_begun_ = false;
    deals_ = 0;
  }
  // A long deal may be told on several lines; casting on is a round.
  std::int16_t next_deal() {
    const auto& deals = plan_->piece(pattern_.pieces[now_].pieces.front()).deals;
    if (static_cast<std::size_t>(deals_) < deals.size()) ++deals_;
    return deals_;
  }

  const knit::WrittenPattern& pattern_;
  const knit::LimbPlan* plan_;
  std::size_t now_ = 0;
  bool begun_ = false, rounds_begun_ = false;
  std::int16_t deals_ = 0;
};

// Space before a kind of line, in plain units; the fonts' own leading is not counted.
float space_before(Kind kind) {
  switch (kind) {
    case Kind::heading:
    case Kind::piece:
      return 12.0f;
    case Kind::remark:
      return 6.0f;
    case Kind::title:
    case Kind::faint:
    case Kind::plain:
    case Kind::item:
    case Kind::entry:
    case Kind::round:
    case Kind::named:
      break;
  }
  return 0.0f;
}

float width_of(const std::string& words, ImFont* font) {
  push_font(font);
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  pop_font();
  return width;
}

// Labels of a kind stand in one column; a label that would leave the words too little room does not widen it.
struct LabelColumns {
  std::array<float, 10> widths{};
  [[nodiscard]] float& of(Kind kind) { return widths[static_cast<std::size_t>(kind)]; }
};

LabelColumns label_columns(const std::vector<PatternLayout::Placed>& lines, const Fonts& fonts, float most) {
  LabelColumns columns;
  for (const auto& placed : lines) {
    if (placed.line.label.empty()) continue;
    float& width = columns.of(placed.line.kind);
    width = std::max(width, std::min(most, width_of(placed.line.label, fonts.strong)));
  }
  return columns;
}

}  // namespace

ImFont* font_of(PatternLine::Kind kind, const Fonts& fonts) {
  switch (kind) {
    case Kind::title:
      return fonts.heading;
    case Kind::heading:
    case Kind::piece:
      return fonts.strong;
    case Kind::faint:
    case Kind::plain:
    case Kind::item:
    case Kind::entry:
    case Kind::round:
    case Kind::remark:
    case Kind::named:
      break;
  }
  return fonts.text;
}

bool PatternLine::says(std::int32_t round) const {
  return (rounds && rounds->holds(round)) ||
         std::any_of(twins.begin(), twins.end(), [&](const RoundSpan& span) { return span.holds(round); });
}

bool PatternLine::is_meant(const RoundSpan& meant) const {
  const auto touches = [&](const RoundSpan& span) {
    if (kind == Kind::piece) return meant.first <= span.first && span.last <= meant.last;
    return span.first <= meant.last && meant.first <= span.last;
  };
  return (rounds && touches(*rounds)) || std::any_of(twins.begin(), twins.end(), touches);
}

std::vector<PatternLine> lines_of(const knit::WrittenPattern& pattern, const knit::LimbPlan* plan) {
  std::vector<PatternLine> lines;
  const auto add = [&](Kind kind, const std::string& words) { lines.push_back({kind, {}, words, {}}); };
  const auto add_all = [&](const char* heading, Kind kind, const std::vector<std::string>& all) {
    add(Kind::heading, heading);
    for (const std::string& words : all) add(kind, words);
  };
  add(Kind::title, pattern.title);
  add(Kind::faint, "Project level: " + pattern.level);
  add_all("Finished size", Kind::plain, pattern.size);
  add_all("Materials", Kind::item, pattern.materials);
  add_all("Gauge", Kind::plain, {pattern.gauge});
  add(Kind::heading, "Abbreviations");
  for (const auto& [word, meaning] : pattern.abbreviations) lines.push_back({Kind::entry, word, meaning, {}});
  add_all("Notes", Kind::item, pattern.notes);
  add(Kind::heading, "Instructions");
  lines.push_back({pattern.in_pieces ? Kind::plain : Kind::round, {}, unbroken(pattern.start), {}});
  if (!pattern.in_pieces) lines.back().rounds = RoundSpan{1, 1};
  PieceLines pieces(pattern, plan);
  for (const auto& instruction : pattern.instructions) lines.push_back(pieces.line_of(instruction));
  add_all("Finishing", Kind::plain, pattern.finishing);
  return lines;
}

void PatternLayout::refresh(const knit::WrittenPattern& pattern, const knit::LimbPlan* plan,
                            std::uint64_t key, float width, const Fonts& fonts, float scale) {
  const Key wanted{key, width, scale};
  if (wanted == key_) return;
  key_ = wanted;
  lines_.clear();
  for (PatternLine& line : lines_of(pattern, plan)) lines_.push_back({std::move(line)});
  place(fonts);
}

void PatternLayout::place(const Fonts& fonts) {
  const float unit = key_.scale;
  const float edge = 8.0f * unit;  // left and right, inside a lit line too
  LabelColumns columns = label_columns(lines_, fonts, 0.35f * key_.width);
  float top = 2.0f * unit;
  for (Placed& placed : lines_) {
    PatternLine& line = placed.line;
    const float indent = line.kind == Kind::item || line.kind == Kind::remark ? 12.0f * unit : 0.0f;
    const float column = line.label.empty() ? 0.0f : columns.of(line.kind) + 8.0f * unit;
    placed.words_left = edge + indent + column;
    const float room = std::max(20.0f * unit, key_.width - placed.words_left - edge);
    push_font(font_of(line.kind, fonts));
    line.words = wrapped_at_blanks(line.words, room);
    const float words = ImGui::CalcTextSize(line.words.c_str(), nullptr, false, room).y;
    pop_font();
    top += space_before(line.kind) * unit;
    placed.top = top;
    placed.height = words + 4.0f * unit;
    top += placed.height + (line.kind == Kind::remark ? 6.0f * unit : 0.0f);
  }
  height_ = top + 6.0f * unit;
}

std::size_t PatternLayout::line_below(float height) const {
  const auto found = std::partition_point(lines_.begin(), lines_.end(), [&](const Placed& placed) {
    return placed.top + placed.height <= height;
  });
  return static_cast<std::size_t>(found - lines_.begin());
}

std::optional<std::size_t> PatternLayout::line_of(std::int32_t round, std::int16_t deal) const {
  const auto found = std::find_if(lines_.begin(), lines_.end(), [&](const Placed& placed) {
    return placed.line.kind == Kind::round && placed.line.deal == deal && placed.line.says(round);
  });
  if (found == lines_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - lines_.begin());
}

}  // namespace app
