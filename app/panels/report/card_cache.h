// The report card's figures, measured again only when what they depend on has changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/files/card.h"
#include "knit/quality/quality.h"
#include "knit/run/timeline.h"

namespace app {

class CardCache {
 public:
  CardCache() = default;
  explicit CardCache(double budget_ms) : budget_ms_(budget_ms) {}

  // Once a frame while the card is seen. While the run moves, measuring takes at most the budget a frame in the
  // mean, however large the run is: then the figures may be those of some frames ago. Once it rests they are of
  // the state shown.
  void refresh(const knit::Timeline& timeline);

  // Null while there is no row. Of where stitches settled, once they have.
  [[nodiscard]] const knit::Quality* quality() const { return quality_ ? &*quality_ : nullptr; }
  // Of where they were placed, too; null while nothing has settled.
  [[nodiscard]] const SettledFigures* both() const { return quality_ && both_ ? &*both_ : nullptr; }
  // Of where they come to lie in the air; null before the piece has been relaxed.
  [[nodiscard]] const knit::Quality* relaxed() const { return quality_ && relaxed_ ? &*relaxed_ : nullptr; }
  [[nodiscard]] std::size_t times_measured() const { return times_measured_; }

 private:
  struct Key {
    std::shared_ptr<const knit::Input> input;
    double width = 0.0, height = 0.0;
    bool settled = false;        // or settling
    std::uint64_t relaxed = 0;   // its content
    std::uint64_t products = 0;  // what is finished of the run, by content: replayed steps make new pointers
    friend bool operator==(const Key&, const Key&) = default;
  };
  static Key key_of(const knit::Timeline& timeline);
  void measure(const knit::Timeline& timeline);

  double budget_ms_ = 2.0;  // what measuring may take a frame
  std::optional<knit::Quality> quality_;
  std::optional<SettledFigures> both_;
  std::optional<knit::Quality> relaxed_;
  Key measured_, seen_;   // of quality_; of the last frame
  double owed_ms_ = 0.0;  // of the last measuring, not yet paid off by frames
  std::size_t times_measured_ = 0;
};

}  // namespace app
