#include "knit/reader/published_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knit/reader/published_work.h"
#include "knit/reader/reader_text.h"

namespace knit {

bool has_held_stitches(std::string_view text) {
  bool put = false, put_is_last = false, worked = false;
  for (const TextLine& line : pattern_lines(text)) {
    const Tokens tokens = tokens_of(line.text);
    const bool is_round = published_label(tokens).has_value();
    for (const PublishedPart& part : parts_of(tokens, is_round)) {
      const bool sure = !part.maybe && (worked || is_round);
      if (part.use == PublishedUse::take && sure) return true;
      if (put && (part.use == PublishedUse::join_ends || part.use == PublishedUse::take)) return true;
      if (put_is_last && (is_round || part.use == PublishedUse::add)) return true;
      const bool holds =
          (part.use == PublishedUse::hold && worked) || (part.use == PublishedUse::insert && is_round);
      put = put || holds;
      put_is_last = put_is_last || holds;
      worked = worked || is_round || part.use == PublishedUse::add;
    }
  }
  return false;
}

ReadPattern read_published(std::string_view text) {
  PublishedWorker worker;
  for (const TextLine& line : pattern_lines(text)) {
    if (!worker.line(line.number, line.text)) break;
  }
  return worker.finish();
}

}  // namespace knit
