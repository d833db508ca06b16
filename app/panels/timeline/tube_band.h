// Which tube is worked at each step of a run, and where loops are dealt: the band below the stages, and its marks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/timeline/track.h"
#include "app/session/run_key.h"

namespace app {

// Worked out once, and anew when the run has changed or got further. Positions: numbers of steps taken before.
class TubeBand {
 public:
  // Rows of one tube that follow each other, in one stage; the cast on and the rows are one.
  struct Stretch {
    knit::TubeId tube = 0;
    knit::RowId first = 0, last = 0;
    std::size_t begin = 0, end = 0;
    bool is_making = false;  // of the cast on or the rows, where deals are
  };
  struct Mark {
    std::int32_t event = 0;  // of the plan
    std::size_t at = 0;      // shows the deal's first step
  };

  void refresh(const knit::Timeline& timeline);

  // Both rising; empty where all is one tube.
  [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
  [[nodiscard]] std::int32_t yarn(knit::TubeId tube) const { return yarns_[static_cast<std::size_t>(tube)]; }
  // That a position lies in; null: none.
  [[nodiscard]] const Stretch* at(std::size_t position) const;

 private:
  void find_stretches(const knit::Timeline& timeline);
  void find_marks(const knit::Timeline& timeline);

  RunKey key_;
  std::size_t known_ = 0;
  std::vector<Stretch> stretches_;
  std::vector<Mark> marks_;
  std::vector<std::int32_t> yarns_;
};

// The parts of the track that it takes: letters and marks over the band, at the foot of the stages.
struct BandPlace {
  float letters = 0.0f;  // the top of both; the track's bottom where there is no band
  float band = 0.0f;     // the top of the band
};
BandPlace place_of_band(const PanelFrame& frame, const Track& track);

void draw_tube_band(PanelFrame& frame, const Track& track);
// The event's mark under the pointer, as drawn last.
std::optional<TubeBand::Mark> mark_under(const PanelFrame& frame, const Track& track);
// "Tube C, round 4 of 12."; empty where no tube is worked.
std::string tube_words_at(const PanelFrame& frame, std::size_t position);

}  // namespace app
