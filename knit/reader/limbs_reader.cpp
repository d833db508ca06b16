#include "knit/reader/limbs_reader.h"

#include <algorithm>

#include "knit/reader/limbs_lines.h"
#include "knit/reader/limbs_work.h"

namespace knit {

bool has_limb_headings(std::string_view text) {
  const std::vector<TextLine> lines = pattern_lines(text);
  return std::any_of(lines.begin(), lines.end(),
                     [](const TextLine& line) { return limb_heading_of(line.text).has_value(); });
}

ReadLimbs read_limbs(std::string_view text) {
  LimbSections sections = limb_sections_of(text);
  if (sections.stray) {
    ReadLimbs read;
    const std::string line = std::to_string(sections.stray->number);
    read.mistakes.push_back({sections.stray->number, "line " + line + ": \"" + sections.stray->text +
                                                         "\" stands before the first piece."});
    return read;
  }
  return LimbWorker(std::move(sections.sections), sections.last_line).run();
}

}  // namespace knit
