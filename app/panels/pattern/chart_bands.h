// How a chart lies in the window: whole or, where it is too wide to be read, in bands one below the other, as on a sheet of paper.
// Columns count from 0 at the right edge; the first band has the first of them. Pixels.
#pragma once

#include <cstddef>

namespace app {

struct ChartRoom {
  float width = 0.0f, height = 0.0f;  // for squares, numbers taken off
  float gap = 0.0f;                   // above every band, for its words
  float legible = 1.0f;               // smaller squares are broken rather, where breaking helps
  float largest = 1.0f;               // no square is larger
};

struct ChartBands {
  std::size_t columns = 1, rows = 1;  // of the chart
  std::size_t each = 1, count = 1;    // columns of each band but the last; bands
  float side = 1.0f, gap = 0.0f;      // of a square; 0 where the chart is whole

  struct Place {
    float x = 0.0f, y = 0.0f;
  };
  [[nodiscard]] float width() const { return side * static_cast<float>(each); }
  [[nodiscard]] float height() const {
    return static_cast<float>(count) * (gap + side * static_cast<float>(rows));
  }
  [[nodiscard]] std::size_t columns_in(std::size_t band) const {
    return band + 1 < count ? each : columns - (count - 1) * each;
  }
  // The upper left corner of a square, from that of all bands. Row 0 is the lowest of each band.
  [[nodiscard]] Place at(std::size_t row, std::size_t column) const {
    const std::size_t band = column / each;
    return {side * static_cast<float>(each - 1 - column % each),
            gap + static_cast<float>(band) * (gap + side * static_cast<float>(rows)) +
                side * static_cast<float>(rows - 1 - row)};
  }
  [[nodiscard]] ChartBands scaled(float by) const {
    ChartBands larger = *this;
    larger.side *= by;
    larger.gap *= by;
    return larger;
  }
};

// Whole where its squares are legible or its height alone makes them small; else in as many bands as give the largest squares.
// Where these are still too small: in the fewest bands that are not wider than the room with legible squares, and higher than it.
ChartBands bands_for(std::size_t columns, std::size_t rows, const ChartRoom& room);

}  // namespace app
