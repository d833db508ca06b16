// Everything unusual in a run, worst first: functions of steps. And remarks on the whole run, which no step tells of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knit/insight/problem_counts.h"
#include "knit/insight/why.h"
#include "knit/quality/coverage.h"
#include "knit/quality/measures.h"

namespace knit {

struct Problem {
  std::size_t step = 0;
  ProblemKind kind = ProblemKind::stopped;
  double size = 0.0;  // the larger, the worse among its kind
  friend bool operator==(const Problem&, const Problem&) = default;
};

// None exactly where is_unusual says so.
std::optional<Problem> problem_of(const Step& step, std::size_t index, const Parameters& parameters);

// What a problem's step is about: a stitch, a vertex; none: nothing that can be pointed at, as of a stop.
std::optional<Element> thing_of_problem(const Step& step);

// Takes problems as a run grows. Worse kinds come first at any time; within a kind, the worst first once
// `finish` was called and the order of taking before, so that a growing run is never sorted again.
class ProblemRanking {
 public:
  void take(const Problem& problem);
  void finish();
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Problem& operator[](std::size_t i) const;

 private:
  std::array<std::vector<Problem>, static_cast<std::size_t>(ProblemKind::count_)> by_kind_;
  std::size_t size_ = 0;
  bool sorted_ = true;
};

// What a remark is about, and by index what scripts call it.
enum class RemarkKind : std::uint8_t { size, swatch, uncovered, turned, stretched, placement, knitted };
inline constexpr std::array<std::string_view, 7> remark_keys{"size",      "swatch",    "uncovered", "turned",
                                                             "stretched", "placement", "knitted"};

// A result that is not what was asked for: the size, a swatch that is hardly knitted fabric, what rows leave uncovered, faces that are turned over, rows whose wales are stretched, what comes off the needles otherwise. One of the two
// places is set, or none where it is about all of the piece.
struct Remark {
  RemarkKind kind = RemarkKind::size;
  std::string words;                           // what, where, and a way on
  std::optional<StitchRef> at = std::nullopt;  // a stitch at the end of the longest wale, or of a turned face
  VertexId vertex = no_vertex;                 // of the mesh, in an uncovered part
  [[nodiscard]] bool uncovered() const { return vertex != no_vertex; }
};

// Worth a line of its own: a wale of two rows' height, or more than a quarter of all wales there.
inline bool is_remarkable(const Stretched& rows) { return rows.longest > 2.0 || rows.share > 0.25; }
inline constexpr std::size_t most_stretched = 6;  // stretches that are told one by one

// Uncovered parts first, the largest first; then turned faces, all in one; then the stretched rows that are remarkable,
// the longest wale first.
// `parameters`: as the run has chosen them, none on auto; the ways on hang on them.
std::vector<Remark> remarks_on(const Coverage& coverage, const Parameters& parameters);
// The same in one sentence; empty where there is nothing to remark.
std::string summary_of(const Coverage& coverage);

}  // namespace knit
