// The knitted thing as a graph: rows, what joins each to the stitches it is worked on, the faces between, and the deals.
//
// A row is worked on live stitches: it takes a stretch of what hangs on the needle and puts its own stitches in
// their place. A cast on takes none. Each tube has a loop of live stitches from its first row, or from the deal that
// begins it, on. So with L(t) the loop of tube t,
//   a row of t    takes L(t) and becomes L(t)
//   a short row   takes a stretch S of L(t), round and round, and puts its own in their place, one for one:
//                 L(t) = A S B  ->  A R B, |R| = |S|; it keeps who hung beside S then, the last of A and the first of B
//   a split of t  takes L(t) and gives L(u), L(v); a join the other way round; a graft takes two and gives none
// and every stitch is taken once, a stitch of a bridge twice. Short rows come in pairs over one stretch, out and back; the round
// over them takes a loop of several rows and changes its count as if they were not there: taken away one for one they leave
// the loop that it would take without them (`under_short_rows`).
// Nobody outside asks for the row "before": what a row hangs
// on is asked for here, and so is whether it is closed.
//
// Rows and deals come first, then joins, then strips, each in working order; what is there is never changed.
#pragma once

#include <span>
#include <vector>

#include "knit/fabric/deal.h"
#include "knit/fabric/join.h"
#include "knit/fabric/row.h"
#include "knit/fabric/strip.h"

namespace knit {

struct LiveLoop {
  TubeId tube = 0;
  LiveStitches stitches;
  [[nodiscard]] auto fields() const { return std::tie(tube, stitches); }
  friend bool operator==(const LiveLoop&, const LiveLoop&) = default;
};

class Fabric {
 public:
  // In working order.
  [[nodiscard]] const std::vector<Shared<Row>>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Shared<Deal>>& deals() const { return deals_; }
  [[nodiscard]] const std::vector<Shared<Join>>& joins() const { return joins_; }
  [[nodiscard]] const std::vector<Shared<Strip>>& strips() const { return strips_; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] RowId row_count() const { return static_cast<RowId>(rows_.size()); }
  [[nodiscard]] RowId next_row() const { return row_count() + 1; }
  [[nodiscard]] bool has_row(RowId id) const { return id >= 1 && id <= row_count(); }
  // The first row after this one that is worked on others, so that it has a join and a strip; 0: there is none.
  [[nodiscard]] RowId next_worked(RowId id) const;

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

  // What hangs on needle and holders now, in the order in which it came there.
  [[nodiscard]] const std::vector<LiveLoop>& live() const { return live_; }
  // None where the tube is not begun, or dealt already.
  [[nodiscard]] LiveStitches live(TubeId tube) const;
  [[nodiscard]] std::int32_t live_count() const;
  // What a row is worked on; of the row to come, what the last one left on the needle.
  [[nodiscard]] LiveStitches live_below(RowId id) const;
  // The one row that all of these are, or are an arc of, short rows taken away; null: there are none, or it is more than one.
  [[nodiscard]] const Row* row_below(RowId id) const;
  // Whether a row is worked on all of the row that was made just before it.
  [[nodiscard]] bool continues(RowId id) const;
  // The same stitches with short rows taken away: what the round over them would be worked on without them.
  [[nodiscard]] LiveStitches under_short_rows(const LiveStitches& live) const;
  // The stitches below a row that were marked by a turn since and that it works, as places in what it is worked on, rising.
  [[nodiscard]] std::vector<std::int32_t> marked_below(RowId id) const;
  // All rows and deals that a row's join and strip stand between: those below, then itself.
  [[nodiscard]] std::vector<std::shared_ptr<const void>> products_about(RowId id) const;
  // The rows that are worked on stitches of this one, rising.
  [[nodiscard]] std::vector<RowId> rows_on(RowId id) const;
  // Whether stitches of it hang on a needle; those of a finished piece are bound off.
  [[nodiscard]] bool is_live(RowId id) const;

  [[nodiscard]] const Stitch& stitch(const StitchRef& ref) const;
  [[nodiscard]] const glm::dvec3& position(const StitchRef& ref) const { return stitch(ref).position; }
  [[nodiscard]] std::vector<Stitch> stitches_of(const LiveStitches& live) const;

  // The two sides of a join whose row is there: the stitches that its cells are, and those that they hang on.
  [[nodiscard]] LiveStitches larger(const Join& join) const;
  [[nodiscard]] LiveStitches smaller(const Join& join) const;

  // Along the knitting path, through all rows and bridges in working order, from 0. A short row worked back has its last
  // stitch first.
  [[nodiscard]] std::uint32_t first_on_path(RowId id) const;
  [[nodiscard]] std::uint32_t path_index(const StitchRef& ref) const;
  [[nodiscard]] std::vector<std::uint32_t> path_indices(const LiveStitches& live) const;
  [[nodiscard]] std::size_t stitch_count() const;

  // Each takes its place after what is there. A row has the next number and takes its tube's loop whole, or, a short row, a
  // stretch of it; a deal takes the loops of its tubes whole.
  void add(Row row);
  void add(Deal deal);
  void add(Shared<Join> join);
  void add(Shared<Strip> strip);

  // The same stitches at other places, given along the path. Nothing else of it changes.
  [[nodiscard]] Fabric moved_to(std::span<const glm::dvec3> positions) const;

  // What a copy costs: pointers, not what is shared.
  [[nodiscard]] std::size_t copy_bytes() const;
  [[nodiscard]] auto fields() const { return std::tie(rows_, deals_, joins_, strips_, live_); }
  friend bool operator==(const Fabric&, const Fabric&) = default;

 private:
  void add_short(Row row);

  std::vector<Shared<Row>> rows_;
  std::vector<Shared<Deal>> deals_;
  std::vector<Shared<Join>> joins_;    // by the rows they make, rising
  std::vector<Shared<Strip>> strips_;  // likewise
  std::vector<LiveLoop> live_;
};

// The stitches by their numbers along the path. Refers to the fabric, and knows what is there now.
class KnittingPath {
 public:
  explicit KnittingPath(const Fabric& fabric);
  [[nodiscard]] StitchRef at(std::uint32_t number) const;
  [[nodiscard]] const glm::dvec3& position(std::uint32_t number) const {
    return fabric_->position(at(number));
  }

 private:
  struct Stretch {
    std::uint32_t first;
    RowId row;          // or a bridge's
    std::int32_t last;  // of a row worked back: the stitch it begins with; -1: of all others
  };
  const Fabric* fabric_;
  std::vector<Stretch> stretches_;  // rising
};

// All positions along the path.
std::vector<glm::dvec3> knitting_path(const Fabric& fabric);

}  // namespace knit
