// The report card's figures in words: what stands where, what it means, and what a knitter would rather not see.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "knit/quality/closeness.h"
#include "knit/quality/quality.h"

namespace app {

// What a knitter would want a figure not to exceed.
enum class Judged : std::uint8_t { course_cv, wale_cv, sideways, most_in_a_row, knit_to_mesh };
struct Bound {
  Judged figure;
  double most;
  std::string_view words;
};
inline constexpr std::array bounds{
    Bound{Judged::course_cv, 0.05, "0.05"},
    Bound{Judged::wale_cv, 0.15, "0.15"},
    Bound{Judged::sideways, 0.8, "0.8 w"},
    Bound{Judged::most_in_a_row, 1.0, "what a flat disc takes"},  // times the steady bound
    Bound{Judged::knit_to_mesh, 0.01, "1 % of the diagonal"},     // of the diagonal
};
bool is_outside(Judged figure, double value);

struct CardFigure {
  std::string name;  // of its mark: "figure/course/cv"
  std::string text;
  std::string help;  // in one sentence; another one when it is outside
  bool outside = false;
};

enum class CardColumn : std::uint8_t { mean, cv, p95, max };
inline constexpr std::size_t card_columns = 4;

struct CardLine {
  std::string name;  // "course"
  std::string words, unit;
  std::string help;  // in one sentence
  std::array<std::optional<CardFigure>, card_columns> figures;
  std::string missing;  // instead of the figures: "after the faces"
};

struct CardGroup {
  bool headed = false;  // the columns' names stand above
  std::vector<CardLine> lines;
};

// `quality` and `closeness` may be null: not there yet. `measuring`: closeness is on its way.
std::vector<CardGroup> card_groups(const knit::Quality* quality, const knit::Closeness* closeness,
                                   bool measuring);

// The report card as plain text: the same figures as in the panel, and each row beside the stitches that its
// length holds.

// Requires something open. Measures what has not been measured yet.
std::string card_text(const Session& session);

}  // namespace app
