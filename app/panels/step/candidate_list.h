// The table of a row's candidates as a panel shows it: made again only when the row has changed, and sorted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "knit/insight/candidates.h"
#include "knit/insight/why.h"

namespace app {

enum class CandidateColumn : std::uint8_t { order, vertex, distance, verdict, stitch };

class CandidateList {
 public:
  // Once a frame that shows it. Whether anything has changed.
  bool refresh(const knit::Timeline& timeline, std::int32_t row);
  void sort_by(CandidateColumn column, bool falling);

  [[nodiscard]] const knit::CandidateTable& table() const { return table_; }
  // The candidate that stands in line `line` of the list.
  [[nodiscard]] const knit::Candidate& at(std::size_t line) const { return table_.candidates[lines_[line]]; }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] std::size_t line_of(std::int32_t order) const;
  // Which stitch of its row a candidate became as it was picked, from 1; 0: none.
  [[nodiscard]] std::int32_t stitch_of(std::int32_t order) const {
    return stitches_[static_cast<std::size_t>(order)];
  }

  // The place in the ring of what is selected: a vertex, or a stitch picked at one.
  [[nodiscard]] std::optional<std::int32_t> order_of(const knit::Timeline& timeline,
                                                     const knit::Element& thing) const;

  // What the list was last scrolled to, so that it follows only when that changes.
  std::optional<std::int32_t> shown;

 private:
  struct Key {
    std::shared_ptr<const knit::Ring> ring;
    std::int32_t row = -1;
    std::size_t begin = 0, end = 0;  // the row's steps
    knit::Parameters parameters;
    bool operator==(const Key&) const = default;
  };
  void sort();

  Key key_;
  knit::CandidateTable table_;
  std::vector<std::size_t> lines_;      // indices of candidates, sorted
  std::vector<std::int32_t> stitches_;  // by order
  CandidateColumn column_ = CandidateColumn::order;
  bool falling_ = false;
};

}  // namespace app
