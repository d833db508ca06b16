// Symmetric positive definite systems of 2 x 2 blocks, two unknowns a stitch: the pattern is worked out once, the numbers
// many times.
//
// Cholesky by panels of columns that fill the same rows (supernodes), with s such a panel and d the panels before it:
//   A_s - sum over d of L_d(rows of s and below) L_d(rows of s)^T  =  (lower triangle over the rest) L_s^T
// The order is a nested dissection, so n stitches fill about 4 n log n blocks and cost about n^1.5 products of blocks, most
// of them in dense pieces of 4 x 4 numbers. Plain data, so that a state may hold the pattern; the same bits every time.
// E. Ng, B. Peyton, "Block sparse Cholesky algorithms on advanced uniprocessor computers", 1993.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "knit/model/heard.h"

namespace knit {

// Row by row: {a, b, c, d} is a b over c d.
using Block = std::array<double, 4>;

// Stitches are renumbered to `place`; rows and columns, of blocks, are these places.
struct BlockPattern {
  std::vector<std::uint32_t> place;  // per stitch
  // A's blocks below the diagonal, column by column: their rows, rising.
  std::vector<std::uint32_t> first, row;
  // Panels: the first column of each, and the end; where its rows below begin, and the end; these, rising.
  std::vector<std::uint32_t> panel, panel_first, panel_row;
  [[nodiscard]] std::size_t size() const { return place.size(); }
  // Of the block that couples two stitches: its number among those below the diagonal. Requires that the pattern has it.
  [[nodiscard]] std::uint32_t slot(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] auto fields() const { return std::tie(place, first, row, panel, panel_first, panel_row); }
  friend bool operator==(const BlockPattern&, const BlockPattern&) = default;
};

// `coupled`: pairs of stitches, each once. The positions tell where to cut.
BlockPattern make_block_pattern(std::span<const std::array<std::uint32_t, 2>> coupled,
                                std::span<const glm::dvec3> positions, const Heard& heard = {});

// A system with this pattern: all of the diagonal, and of the rest what is below it.
struct BlockSystem {
  std::vector<Block> diagonal;    // by place
  std::vector<Block> below;       // by slot; the stitch of its row down, that of its column across
  std::vector<glm::dvec2> right;  // by place: what the product shall be
};

// Factors and solves with `shift` added to the diagonal, keeping its memory for the next one. Refers to the pattern.
class BlockSolver {
 public:
  BlockSolver() = default;
  explicit BlockSolver(const BlockPattern& pattern) { refer_to(pattern); }
  void refer_to(const BlockPattern& pattern, const Heard& heard = {});
  [[nodiscard]] const BlockPattern* pattern() const { return pattern_; }
  // By stitch. False: not positive definite, and nothing is solved.
  [[nodiscard]] bool solve(const BlockSystem& system, double shift, std::vector<glm::dvec2>& solution,
                           const Heard& heard = {});

 private:
  // A panel's numbers, column after column, each `stride` long: its own rows, those below, and up to three that mean nothing.
  struct Panel {
    std::size_t begin = 0, stride = 0, columns = 0;
  };
  // And goes through the right side with each panel.
  [[nodiscard]] bool factor(const BlockSystem& system, double shift, const Heard& heard);
  void load(const BlockSystem& system, double shift, std::uint32_t panel);
  void take_from(std::uint32_t before, std::uint32_t panel);
  void hang_on(std::uint32_t before,
               std::uint32_t row);  // `before` is next taken from the panel of row panel_row[row]
  [[nodiscard]] bool factor_panel(const Panel& panel);
  void substitute(std::span<const std::uint32_t> rows_below, const Panel& panel, std::uint32_t first_column);
  void substitute_back(std::span<const std::uint32_t> rows_below, const Panel& panel,
                       std::uint32_t first_column);
  [[nodiscard]] std::span<const std::uint32_t> rows_below(std::uint32_t panel) const;

  void make_room(std::size_t numbers);

  const BlockPattern* pattern_ = nullptr;
  bool wide_ = false;  // the machine takes four numbers at once
  std::vector<Panel> panels_;
  std::vector<double> done_by_;             // per panel: the share of all products that are made before it
  std::vector<double> numbers_;             // of all panels
  std::vector<std::uint32_t> panel_of_;     // per column
  std::vector<std::uint32_t> local_;        // per row: its number in the panel that is worked on
  std::vector<std::uint32_t> head_, next_;  // lists of the panels that a panel takes from
  std::vector<std::uint32_t> done_;         // per panel: its first row below that is yet to be taken from
  std::vector<double> product_;
  std::vector<double> solved_;
};

}  // namespace knit
