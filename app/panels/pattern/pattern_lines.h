// The written pattern as lines of a panel, and where each stands: worked out once for a pattern and a width, so
// that a frame draws only what is seen, however long the pattern is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/kit/imgui_glue.h"
#include "app/session/session.h"
#include "app/session/view.h"
#include "knit/pattern/written_pattern.h"

namespace app {

struct PatternLine {
  // named: what a named round is ("Inc rnd:"); its rounds are all those that are worked so
  enum class Kind : std::uint8_t { title, faint, heading, piece, plain, item, entry, round, remark, named };
  Kind kind = Kind::plain;
  std::string label;  // before the words, in a column of its own: "Rnds 8-12:", "k2tog"
  std::string words;  // once placed with line feeds where lines end
  // That it says, as the fabric's rows are numbered. Of a deal the first round after it, of a heading all of its piece.
  std::optional<RoundSpan> rounds;
  // The same of twins that are made by the same words, and of a named round all but the first.
  std::vector<RoundSpan> twins = {};
  std::int16_t deal = 0;  // before its piece's first round, from 1; 0: none

  // The round, or one of a twin.
  [[nodiscard]] bool says(std::int32_t round) const;
  // What is meant is a part of it; all of a heading's piece must be meant.
  [[nodiscard]] bool is_meant(const RoundSpan& meant) const;
};

// In the document's order. `plan`: of a pattern in pieces the one that it is written from; else null.
std::vector<PatternLine> lines_of(const knit::WrittenPattern& pattern, const knit::LimbPlan* plan = nullptr);

class PatternLayout {
 public:
  struct Placed {
    PatternLine line;
    float top = 0.0f, height = 0.0f;  // in window units, from the document's top
    float words_left = 0.0f;          // from the left edge
  };

  // Needs a frame of ImGui's. `key`: another for every other pattern. `plan`: as in lines_of.
  void refresh(const knit::WrittenPattern& pattern, const knit::LimbPlan* plan, std::uint64_t key,
               float width, const Fonts& fonts, float scale);

  [[nodiscard]] const std::vector<Placed>& lines() const { return lines_; }
  [[nodiscard]] float height() const { return height_; }
  // The first line that ends below a height.
  [[nodiscard]] std::size_t line_below(float height) const;
  // The line that says a round, or a deal before it; none: there is no such line.
  [[nodiscard]] std::optional<std::size_t> line_of(std::int32_t round, std::int16_t deal = 0) const;

 private:
  struct Key {
    std::uint64_t pattern = 0;
    float width = -1.0f, scale = 0.0f;
    friend bool operator==(const Key&, const Key&) = default;
  };
  void place(const Fonts& fonts);

  Key key_;
  std::vector<Placed> lines_;
  float height_ = 0.0f;
};

// The font that a kind of line is set in.
ImFont* font_of(PatternLine::Kind kind, const Fonts& fonts);

}  // namespace app
