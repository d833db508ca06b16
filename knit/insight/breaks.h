// Break conditions: what a run is stopped at, forwards and backwards. Functions of steps and finished rows.
//
// As text: stage=rows  row=14  label=m1l  grows>4  shrinks>4  gap  stall  over-double  wider>1.3  narrower<0.7  split  join  hold
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "knit/model/settings_table.h"
#include "knit/run/state.h"
#include "knit/run/step.h"

namespace knit {

enum class BreakKind : std::uint8_t {
  stage,        // its first step
  row,          // its first step in each stage that has rows
  label,        // a stitch gets it
  grows,        // a finished row has more stitches than the row before, by more than `count`
  shrinks,      // fewer
  gap,          // a row closes with a gap outside the band, before that gap is shared
  stall,        // nothing lay in the band
  over_double,  // a row wants more increases than the row before has stitches
  wider,        // a finished row has a stitch wider than `bound` stitch widths
  narrower,     // narrower
  split,        // a loop is cut in two
  join,         // two loops become one
  hold,         // a loop begins to wait on a holder: after a deal, or because the yarn goes on elsewhere
};

struct BreakCondition {
  BreakKind kind = BreakKind::stall;
  Stage stage = Stage::timing;  // these four: as the kind says, else as they are here
  Label label = Label::knit;
  std::int32_t count = 0;
  double bound = 0.0;
  friend bool operator==(const BreakCondition&, const BreakCondition&) = default;
};

// The error is one sentence.
std::variant<BreakCondition, std::string> parse_break(std::string_view text);
std::string text_of(const BreakCondition& condition);   // reads back equal
std::string words_of(const BreakCondition& condition);  // "a row grows by more than 4 stitches"

// How many stitches the row has that this step finishes; none: it finishes no row.
std::optional<std::int32_t> finished_row_size(const Step& step);

// The step after which a condition holds; for a run that stopped, steps.size() stands for the stop.
struct BreakHit {
  std::size_t step = 0;
  std::size_t condition = 0;
  friend bool operator==(const BreakHit&, const BreakHit&) = default;
};

// Takes a run's steps in order, from the first, and carries what conditions look back at.
class BreakScanner {
 public:
  BreakScanner() = default;
  explicit BreakScanner(std::vector<BreakCondition> conditions);

  // `parameters`: in force for the step. `fabric`: of the run, with at least the row that the step
  // finishes.
  void take(const Step& step, const Parameters& parameters, const Fabric& fabric);
  // Why the run ended before its last stage, after its last step.
  void take_stop(const Step& stop);

  [[nodiscard]] const std::vector<BreakCondition>& conditions() const { return conditions_; }
  [[nodiscard]] const std::vector<BreakHit>& hits() const { return hits_; }  // by step, then condition
  [[nodiscard]] std::size_t count(std::size_t condition) const { return counts_[condition]; }
  [[nodiscard]] std::size_t taken() const { return taken_; }  // steps

 private:
  void hit(std::size_t condition);
  // Whether a loop begins to wait; takes down how many do.
  bool begins_to_wait(const Step& step);

  std::vector<BreakCondition> conditions_;
  bool measures_ = false;  // a condition asks for widths
  bool casts_on_ = false;  // the tube taken up has no row yet and is worked on none
  std::int32_t held_ = 0;  // loops on holders
  std::vector<BreakHit> hits_;
  std::vector<std::size_t> counts_;
  std::size_t taken_ = 0;
  std::optional<Place> last_;
};

}  // namespace knit
