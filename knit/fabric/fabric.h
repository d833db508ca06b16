// The knitted thing as a graph: rows, what joins each to the stitches it is worked on, and the faces between.
//
// A row is worked on live stitches: it takes a stretch of what hangs on the needle and puts its own stitches in
// their place. A cast on takes none. So with L(0) = nothing,
//   L(k) = L(k - 1) with row k's `on` replaced by row k,
// and every stitch is taken by at most one row. Today a row takes all of L, a round on a round; splits, short rows and
// pieces only deal live stitches otherwise. Nobody outside asks for the row "before": what a row hangs on is asked for
// here, and so is whether it is closed.
//
// Rows come first, then their joins, then their strips, each in working order; what is there is never changed.
#pragma once

#include <vector>

#include "knit/fabric/join.h"
#include "knit/fabric/row.h"
#include "knit/fabric/strip.h"

namespace knit {

class Fabric {
 public:
  // In working order.
  [[nodiscard]] const std::vector<Shared<Row>>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Shared<Join>>& joins() const { return joins_; }
  [[nodiscard]] const std::vector<Shared<Strip>>& strips() const { return strips_; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] RowId row_count() const { return static_cast<RowId>(rows_.size()); }
  [[nodiscard]] RowId next_row() const { return row_count() + 1; }
  [[nodiscard]] bool has_row(RowId id) const { return id >= 1 && id <= row_count(); }

  // Requires has_row(id).
  [[nodiscard]] const Row& row(RowId id) const { return *rows_[static_cast<std::size_t>(id) - 1]; }
  // The same as a product, whose pointer is its identity.
  [[nodiscard]] const Shared<Row>& shared_row(RowId id) const {
    return rows_[static_cast<std::size_t>(id) - 1];
  }
  // Requires strip_into(id).
  [[nodiscard]] const Shared<Strip>& shared_strip(RowId id) const;
  // Null where there is none: not yet made, or of a cast on.
  [[nodiscard]] const Row* find_row(RowId id) const { return has_row(id) ? &row(id) : nullptr; }
  [[nodiscard]] const Join* join_into(RowId id) const;
  [[nodiscard]] const Strip* strip_into(RowId id) const;

  // What hangs on the needle now.
  [[nodiscard]] const LiveStitches& live() const { return live_; }
  // What a row is worked on; of the row to come, what hangs on the needle.
  [[nodiscard]] const LiveStitches& live_below(RowId id) const { return has_row(id) ? row(id).on : live_; }
  // The one row that all of these are; null: there are none, or it is more than one.
  [[nodiscard]] const Row* row_below(RowId id) const;
  // All rows that a row's join and strip stand between: those below, then itself.
  [[nodiscard]] std::vector<std::shared_ptr<const Row>> rows_about(RowId id) const;
  // The rows that are worked on stitches of this one, rising.
  [[nodiscard]] std::vector<RowId> rows_on(RowId id) const;
  // Whether stitches of it hang on the needle; those of a finished piece are bound off.
  [[nodiscard]] bool is_live(RowId id) const;

  [[nodiscard]] const Stitch& stitch(const StitchRef& ref) const {
    return row(ref.row).stitches[static_cast<std::size_t>(ref.stitch)];
  }
  [[nodiscard]] const glm::dvec3& position(const StitchRef& ref) const { return stitch(ref).position; }

  // The two sides of a join whose row is there: the stitches that its cells are, and those that they hang on.
  [[nodiscard]] LiveStitches larger(const Join& join) const;
  [[nodiscard]] LiveStitches smaller(const Join& join) const;

  // Along the knitting path, through all rows in working order, from 0.
  [[nodiscard]] std::uint32_t first_on_path(RowId id) const;
  [[nodiscard]] std::vector<std::uint32_t> path_indices(const LiveStitches& live) const;
  [[nodiscard]] std::size_t stitch_count() const;

  // Each takes its place after what is there. A row has the next number and takes all that hangs on the needle.
  void add(Row row);
  void add(Shared<Join> join);
  void add(Shared<Strip> strip);

  // What a copy costs: pointers, not what is shared.
  [[nodiscard]] std::size_t copy_bytes() const;
  [[nodiscard]] auto fields() const { return std::tie(rows_, joins_, strips_, live_); }
  friend bool operator==(const Fabric&, const Fabric&) = default;

 private:
  std::vector<Shared<Row>> rows_;
  std::vector<Shared<Join>> joins_;    // by the rows they make, rising
  std::vector<Shared<Strip>> strips_;  // likewise
  LiveStitches live_;
};

// The stitches by their numbers along the path. Refers to the fabric, and knows the rows that are there now.
class KnittingPath {
 public:
  explicit KnittingPath(const Fabric& fabric);
  [[nodiscard]] StitchRef at(std::uint32_t number) const;
  [[nodiscard]] const glm::dvec3& position(std::uint32_t number) const {
    return fabric_->position(at(number));
  }

 private:
  const Fabric* fabric_;
  std::vector<std::uint32_t> first_;  // of each row, rising
};

// All positions along the path.
std::vector<glm::dvec3> knitting_path(const Fabric& fabric);

}  // namespace knit
