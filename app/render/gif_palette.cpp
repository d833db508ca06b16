#include "app/render/gif_palette.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

namespace app {

namespace {

constexpr std::size_t most_colours = 255;
constexpr std::size_t most_known = 191;        // the others are for what is new
constexpr std::size_t most_exact = 32;         // of many: those that fill the most pixels
constexpr std::size_t exact_from_part = 400;   // and no fewer than one in so many
constexpr std::size_t most_that_pull = 20000;  // more would take long and change little
constexpr int rounds_of_pulling = 3;

struct Counted {
  std::uint32_t colour = 0;  // 0xrrggbb
  std::size_t pixels = 0;
};

std::uint32_t colour_at(const Image& image, std::size_t pixel) {
  const std::uint8_t* p = image.rgba.data() + 4 * pixel;
  return static_cast<std::uint32_t>(p[0]) << 16U | static_cast<std::uint32_t>(p[1]) << 8U | p[2];
}
int channel(std::uint32_t colour, int i) {
  return static_cast<int>(colour >> (16U - 8U * static_cast<unsigned>(i)) & 0xffU);
}
PaletteColour unpacked(std::uint32_t c) {
  return {static_cast<std::uint8_t>(channel(c, 0)), static_cast<std::uint8_t>(channel(c, 1)),
          static_cast<std::uint8_t>(channel(c, 2))};
}

bool is_unchanged(const Image& image, const Image* before, std::size_t pixel) {
  return before != nullptr &&
         std::memcmp(image.rgba.data() + 4 * pixel, before->rgba.data() + 4 * pixel, 4) == 0;
}

// The commonest first; of equals the darker, so that the same picture gives the same palette.
std::vector<Counted> count_colours(const Image& image, const Image* before) {
  std::unordered_map<std::uint32_t, std::size_t> counts;
  for (std::size_t pixel = 0; 4 * pixel < image.rgba.size(); ++pixel) {
    if (!is_unchanged(image, before, pixel)) ++counts[colour_at(image, pixel)];
  }
  std::vector<Counted> counted;
  counted.reserve(counts.size());
  for (const auto& [colour, pixels] : counts) counted.push_back({colour, pixels});
  std::sort(counted.begin(), counted.end(), [](const Counted& a, const Counted& b) {
    return a.pixels != b.pixels ? a.pixels > b.pixels : a.colour < b.colour;
  });
  return counted;
}

// Colours from `begin` to `end` that one of the palette stands for.
struct Cell {
  std::size_t begin = 0, end = 0;
  int longest = 0;  // the channel that they spread over most
  double weight = 0.0;
};

Cell cell_of(const std::vector<Counted>& colours, std::size_t begin, std::size_t end) {
  Cell cell{begin, end};
  std::array<int, 3> low{255, 255, 255}, high{0, 0, 0};
  double pixels = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    pixels += static_cast<double>(colours[i].pixels);
    for (int c = 0; c < 3; ++c) {
      const auto at = static_cast<std::size_t>(c);
      low[at] = std::min(low[at], channel(colours[i].colour, c));
      high[at] = std::max(high[at], channel(colours[i].colour, c));
    }
  }
  std::array<int, 3> spread{};
  for (std::size_t c = 0; c < 3; ++c) spread[c] = high[c] - low[c];
  cell.longest = static_cast<int>(std::max_element(spread.begin(), spread.end()) - spread.begin());
  const double widest = spread[static_cast<std::size_t>(cell.longest)];
  cell.weight = widest * widest * pixels;
  return cell;
}

// Where half of its pixels are darker; both halves have at least one colour.
std::size_t middle_of(std::vector<Counted>& colours, const Cell& cell) {
  const auto at = [&](std::size_t i) { return colours.begin() + static_cast<std::ptrdiff_t>(i); };
  std::sort(at(cell.begin), at(cell.end), [&](const Counted& a, const Counted& b) {
    const int x = channel(a.colour, cell.longest), y = channel(b.colour, cell.longest);
    return x != y ? x < y : a.colour < b.colour;
  });
  std::size_t all = 0, half = 0;
  for (std::size_t i = cell.begin; i < cell.end; ++i) all += colours[i].pixels;
  for (std::size_t i = cell.begin; i + 1 < cell.end; ++i) {
    half += colours[i].pixels;
    if (2 * half >= all) return i + 1;
  }
  return cell.end - 1;
}

struct Mean {
  std::array<std::size_t, 3> sums{};
  std::size_t pixels = 0;
  void add(const Counted& counted) {
    pixels += counted.pixels;
    for (std::size_t c = 0; c < 3; ++c)
      sums[c] += counted.pixels * static_cast<std::size_t>(channel(counted.colour, static_cast<int>(c)));
  }
  [[nodiscard]] PaletteColour colour() const {
    const auto mean = [&](std::size_t c) {
      return static_cast<std::uint8_t>((sums[c] + pixels / 2) / pixels);
    };
    return {mean(0), mean(1), mean(2)};
  }
};

PaletteColour mean_of(const std::vector<Counted>& colours, const Cell& cell) {
  Mean mean;
  for (std::size_t i = cell.begin; i < cell.end; ++i) mean.add(colours[i]);
  return mean.colour();
}

// Median cut: the cell that is spread most, counted by its pixels, is halved until there are enough.
std::vector<Cell> cut(std::vector<Counted>& colours, std::size_t most) {
  std::vector<Cell> cells{cell_of(colours, 0, colours.size())};
  while (cells.size() < most) {
    const auto widest = std::max_element(cells.begin(), cells.end(),
                                         [](const Cell& a, const Cell& b) { return a.weight < b.weight; });
    if (widest->weight <= 0.0) break;
    const Cell cell = *widest;
    const std::size_t middle = middle_of(colours, cell);
    *widest = cell_of(colours, cell.begin, middle);
    cells.push_back(cell_of(colours, middle, cell.end));
  }
  return cells;
}

std::uint32_t packed(const PaletteColour& c) {
  return static_cast<std::uint32_t>(c.r) << 16U | static_cast<std::uint32_t>(c.g) << 8U | c.b;
}

// A palette in the making: which of its colours stands for which of the picture's.
class Choice {
 public:
  std::vector<PaletteColour> colours;
  std::unordered_map<std::uint32_t, std::uint8_t> index_of;  // by the picture's colour

  // Those shown before keep their colour while there is room; gives the others.
  std::vector<Counted> take_known(const std::vector<Counted>& all,
                                  const std::unordered_map<std::uint32_t, std::uint32_t>& shown_as) {
    std::vector<Counted> rest;
    std::unordered_map<std::uint32_t, std::uint8_t> places;  // by the colour shown
    for (const Counted& counted : all) {
      const auto known = shown_as.find(counted.colour);
      const bool again = known != shown_as.end() && places.count(known->second) > 0;
      if (known == shown_as.end() || (!again && colours.size() >= most_known)) {
        rest.push_back(counted);
        continue;
      }
      if (!again) places[known->second] = add(unpacked(known->second));
      index_of[counted.colour] = places[known->second];
    }
    return rest;
  }

  // The commonest as they are; all, where there is room for all.
  void take_exact(std::vector<Counted>& rest, std::size_t enough_pixels) {
    const bool all = rest.size() <= most_colours - colours.size();
    std::size_t count = 0;
    while (count < rest.size() && (all || (count < most_exact && colours.size() < most_known &&
                                           rest[count].pixels > enough_pixels))) {
      index_of[rest[count].colour] = add(unpacked(rest[count].colour));
      ++count;
    }
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count));
  }

  // Median cut finds a colour for each cell; then each of the picture's colours takes the nearest, and each
  // of the palette's moves to the middle of those that took it.
  void take_near(std::vector<Counted>& rest) {
    if (rest.empty()) return;
    const std::size_t first = colours.size();
    const std::vector<Counted> commonest(
        rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(std::min(rest.size(), most_that_pull)));
    for (const Cell& cell : cut(rest, most_colours - first)) add(mean_of(rest, cell));
    for (int round = 0; round < rounds_of_pulling; ++round) pull(commonest, first);
    for (const Counted& counted : rest) index_of[counted.colour] = nearest(counted.colour);
  }

 private:
  // Green counts most to the eye, then red.
  [[nodiscard]] std::uint8_t nearest(std::uint32_t colour) const {
    const int r = channel(colour, 0), g = channel(colour, 1), b = channel(colour, 2);
    std::size_t best = 0;
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const int x = r - colours[i].r, y = g - colours[i].g, z = b - colours[i].b;
      const int far = 3 * x * x + 4 * y * y + 2 * z * z;
      if (far < least) {
        least = far;
        best = i;
      }
    }
    return static_cast<std::uint8_t>(best);
  }

  // Those from `first` on.
  void pull(const std::vector<Counted>& pulling, std::size_t first) {
    std::vector<Mean> means(colours.size());
    for (const Counted& counted : pulling) means[nearest(counted.colour)].add(counted);
    for (std::size_t i = first; i < colours.size(); ++i) {
      if (means[i].pixels > 0) colours[i] = means[i].colour();
    }
  }

  std::uint8_t add(const PaletteColour& colour) {
    colours.push_back(colour);
    return static_cast<std::uint8_t>(colours.size() - 1);
  }
};

}  // namespace

PalettedImage GifPalette::next(const Image& image, const Image* before) {
  Choice choice;
  std::vector<Counted> rest = choice.take_known(count_colours(image, before), shown_as_);
  choice.take_exact(rest, image.rgba.size() / 4 / exact_from_part);
  choice.take_near(rest);
  if (choice.colours.empty()) choice.colours.push_back({});
  if (before == nullptr) {
    for (const auto& [colour, index] : choice.index_of) shown_as_[colour] = packed(choice.colours[index]);
  }
  PalettedImage made;
  made.pixels.reserve(image.rgba.size() / 4);
  for (std::size_t pixel = 0; 4 * pixel < image.rgba.size(); ++pixel) {
    const bool left_out = is_unchanged(image, before, pixel);
    made.pixels.push_back(left_out ? unchanged_index : choice.index_of.at(colour_at(image, pixel)));
  }
  made.colours = std::move(choice.colours);
  return made;
}

}  // namespace app
