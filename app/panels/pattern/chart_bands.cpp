#include "app/panels/pattern/chart_bands.h"

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t most_bands = 12;

// Whole tens of columns where they are not wider than so many.
ChartBands broken(std::size_t columns, std::size_t rows, std::size_t count) {
  ChartBands bands;
  bands.columns = columns;
  bands.rows = rows;
  const std::size_t even = (columns + count - 1) / count, tens = (even + 9) / 10 * 10;
  bands.each = count > 1 ? std::min(tens, columns) : columns;
  bands.count = (columns + bands.each - 1) / bands.each;
  return bands;
}

float across(const ChartBands& bands, const ChartRoom& room) {
  return room.width / static_cast<float>(bands.each);
}

float fitting(const ChartBands& bands, const ChartRoom& room) {
  const auto count = static_cast<float>(bands.count);
  const float up = (room.height / count - room.gap) / static_cast<float>(bands.rows);
  return std::min(across(bands, room), up);
}

}  // namespace

ChartBands bands_for(std::size_t columns, std::size_t rows, const ChartRoom& room) {
  ChartBands whole = broken(std::max<std::size_t>(1, columns), std::max<std::size_t>(1, rows), 1);
  const float up = room.height / static_cast<float>(whole.rows);
  whole.side = std::clamp(std::min(across(whole, room), up), 1.0f, room.largest);
  if (across(whole, room) >= room.legible) return whole;
  ChartBands best = whole, narrow = whole;
  for (std::size_t count = 2; count <= most_bands; ++count) {
    ChartBands bands = broken(whole.columns, whole.rows, count);
    bands.gap = room.gap;
    bands.side = fitting(bands, room);
    if (bands.side > best.side) best = bands;
    if (across(narrow, room) < room.legible) narrow = bands;
  }
  if (best.side >= room.legible) {
    best.side = std::min(best.side, room.largest);
    return best;
  }
  narrow.side = std::clamp(across(narrow, room), 1.0f, room.legible);
  return narrow;
}

}  // namespace app
