#include "app/compare/beside_words.h"

#include <array>
#include <cstddef>
#include <system_error>

#include "app/session/changes.h"
#include "app/session/document.h"
#include "knit/base/number_text.h"
#include "knit/model/settings_table.h"
#include "knit/model/words.h"

namespace app {

namespace {

constexpr std::size_t most_named = 2;

// A number of many digits has five, each of several with commas between too; other words stay.
std::string shortened(const std::string& text) {
  if (const std::size_t comma = text.find(','); comma != std::string::npos)
    return shortened(text.substr(0, comma)) + " x " + shortened(text.substr(comma + 1));
  constexpr std::size_t short_enough = 7;
  constexpr int digits = 5;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto read = knit::number_from(text.data(), end, value);
  if (text.size() <= short_enough || read.ec != std::errc() || read.ptr != end) return text;
  std::array<char, 32> room{};
  const auto written = knit::number_into(room.data(), room.data() + room.size(), value, digits);
  return {room.data(), written.ptr};
}

void append(std::string& words, const std::string& more) { words += (words.empty() ? "" : ", ") + more; }

}  // namespace

BesideWords beside_words(const Session& session) {
  const Knobs& there = session.document->pinned->knobs;
  const Knobs here = knobs_of(session.document->timeline);
  BesideWords words;
  std::size_t differing = 0;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string pinned = knit::value_text(info, there.base);
    const std::string now = knit::value_text(info, here.base);
    if (pinned == now || knit::only_follows(info, there.base, here.base)) continue;
    if (++differing > most_named) continue;
    const bool told_apart = shortened(pinned) != shortened(now);
    append(words.pinned, std::string(info.label) + " " + (told_apart ? shortened(pinned) : pinned));
    append(words.here, std::string(info.label) + " " + (told_apart ? shortened(now) : now));
  }
  if (differing > most_named) {
    const std::string more =
        knit::plural(static_cast<std::int64_t>(differing - most_named), "other value", "other values");
    append(words.pinned, more);
    append(words.here, more);
  }
  if (there.edits != here.edits) {
    append(words.pinned, "changes on the way");
    append(words.here, "changes on the way");
  }
  if (words.pinned.empty()) words.pinned = words.here = "the same values";
  return words;
}

}  // namespace app
