// The report card's figures in words: what stands where, what it means, and what a knitter would rather not see.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/session/session.h"
#include "app/session/view.h"
#include "knit/insight/sized.h"
#include "knit/quality/closeness.h"
#include "knit/quality/ease.h"
#include "knit/quality/quality.h"
#include "knit/run/timeline.h"

namespace app {

// What a knitter would want a figure not to exceed.
// Rows are cut so that courses are even; where stitches settle, courses give way to wales.
enum class Judged : std::uint8_t {
  course_cv,
  settled_course_cv,
  wale_cv,
  longest_wale,
  sideways,
  most_in_a_row,
  knit_to_mesh,
  turned
};
struct Bound {
  Judged figure;
  double most;
  std::string_view words;
};
inline constexpr std::array bounds{
    Bound{Judged::course_cv, 0.05, "0.05"},
    Bound{Judged::settled_course_cv, 0.16, "0.16"},
    Bound{Judged::wale_cv, 0.15, "0.15"},
    Bound{Judged::longest_wale, 2.0, "2 h"},
    Bound{Judged::sideways, 0.8, "0.8 w"},
    Bound{Judged::most_in_a_row, 1.0, "what a flat disc takes"},  // times the steady bound
    Bound{Judged::knit_to_mesh, 0.01, "1 % of the diagonal"},     // of the diagonal
    Bound{Judged::turned, 0.0, "0"},
};
bool is_outside(Judged figure, double value);

// What a figure is of, and a click on it leads to: a thing, all things of a size, or a row.
struct FigureRow {
  std::int32_t row = 1;
};
using FigureWay = std::variant<std::monostate, knit::Element, knit::SizeRange, FigureRow>;

struct CardFigure {
  std::string name;  // of its mark: "figure/course/cv"
  std::string text;
  std::string help;  // in one sentence; another one when it is outside
  bool outside = false;
  FigureWay way{};
};
// "Click: to this edge." Empty where it leads nowhere.
std::string_view click_words(const FigureWay& way);

enum class CardColumn : std::uint8_t { mean, cv, p95, max };
inline constexpr std::size_t card_columns = 4;

struct CardLine {
  std::string name;  // "course"
  std::string words, unit;
  std::string help;  // in one sentence
  std::array<std::optional<CardFigure>, card_columns> figures;
  std::string missing;  // instead of the figures: "after the faces"
  bool single =
      false;  // one figure, in the last column, that belongs under no head: it stands beside its words
};

using CardHeads = std::array<std::string_view, card_columns>;
inline constexpr CardHeads card_heads{"mean", "CV", "95 %", "max"};
inline constexpr CardHeads settled_heads{"", "", "placed", "settled"};
std::string_view help_of_head(std::string_view head);  // in one sentence

struct CardGroup {
  bool headed = false;  // the columns' names stand above
  std::vector<CardLine> lines;
  CardHeads heads = card_heads;
};

// That of the positions that are wished, where it has them; null where nothing is measured.
const knit::Closeness* closeness_shown(const knit::Closeness* closeness, Positions positions);

// Both figures of stitches that have settled (knit/settle): where they were placed, and where they are.
struct SettledFigures {
  knit::Quality placed, settled;
  knit::EaseMoves moves;
  std::int32_t iterations = 0;
};
// Of the state shown; none where nothing has settled.
std::optional<SettledFigures> settled_figures(const knit::Timeline& timeline);

// What is known of a run's figures. Null: not there yet.
struct CardFigures {
  const knit::Quality* quality = nullptr;  // of the positions that are shown
  const knit::Closeness* closeness =
      nullptr;                           // of where stitches settled; it has that of where they were placed
  const SettledFigures* both = nullptr;  // null too where nothing has settled
  Positions shown = Positions::settled;
  bool measuring = false;  // closeness is on its way
};
std::vector<CardGroup> card_groups(const CardFigures& known);
inline std::vector<CardGroup> card_groups(const knit::Quality* quality, const knit::Closeness* closeness,
                                          bool measuring) {
  return card_groups(CardFigures{quality, closeness, nullptr, Positions::settled, measuring});
}

// The report card as plain text: the same figures as in the panel, and each row beside the stitches that its
// length holds.

// Requires something open. Measures what has not been measured yet.
std::string card_text(const Session& session);

}  // namespace app
