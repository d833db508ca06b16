// From a pattern's text to its pieces: headings with the lines beneath them, without remarks and wrapping.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "knit/reader/limbs_scan.h"
#include "knit/reader/reader_text.h"

namespace knit {

struct LimbHeading {
  std::vector<LimbName> names;  // several: made together, the word in the plural
  std::int32_t made = 1, rounds = 0, stitches = 0;
};
std::optional<LimbHeading> limb_heading_of(std::string_view line);

struct LimbSection {
  std::size_t line = 0;
  LimbHeading heading;
  std::vector<TextLine> lines;
};
struct LimbSections {
  std::vector<LimbSection> sections;
  std::optional<TextLine> stray;  // stands before the first piece
  std::size_t last_line = 0;
};
LimbSections limb_sections_of(std::string_view text);

// "Legs", "Branches", "Feet": what several are called together.
std::string several(const std::string& word);
// What one of them is likely called.
std::string one_of_several(const std::string& word);
// "Limb A, Limb B and Body C": holders
std::optional<std::vector<LimbName>> limb_list(LimbScan& at);

// "Limbs B and C: Break yarn. ..." within pieces made together: for whom it is, and the words.
struct LimbLabel {
  std::vector<LimbName> names;
  std::string_view words;
};
std::optional<LimbLabel> limb_label_of(std::string_view line);

}  // namespace knit
