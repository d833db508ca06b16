#include "knit/reader/published_needle.h"

#include <algorithm>
#include <utility>

#include "knit/reader/published_words.h"
#include "knit/reader/reader_work.h"

namespace knit {

namespace {

bool is_called(const PublishedHolder& holder, const std::string& name) {
  return name.empty() || same_name(name, holder.name) || same_name(holder.name, name);
}

std::string in_line(std::size_t line) { return "line " + std::to_string(line); }

}  // namespace

void PublishedLoop::add(std::int64_t count, PublishedStitch stitch) {
  if (count > 0)
    stitches.insert(stitches.end(), static_cast<std::size_t>(std::min(count, most_stitches)), stitch);
}

void PublishedLoop::resize(std::int64_t count, PublishedStitch stitch) {
  stitches.resize(static_cast<std::size_t>(std::clamp<std::int64_t>(count, 0, most_stitches)), stitch);
}

PublishedHolder* PublishedHolders::find(const HolderWanted& wanted) {
  PublishedHolder* best = nullptr;
  int best_fit = -1;
  for (std::size_t i = all_.size(); i-- > 0;) {
    PublishedHolder& held = all_[i];
    if (held.emptied > 0 || !is_called(held, wanted.name)) continue;
    int fit = 0;
    if (wanted.count && held.loop.known && held.loop.count() == *wanted.count) fit += 4;
    if (!wanted.name.empty() && wanted.name == held.name) fit += 2;
    if (wanted.name.empty() && !wanted.section.empty() && !held.name.empty() &&
        is_called(held, wanted.section))
      fit += 2;
    if (fit > best_fit) best = &held, best_fit = fit;
  }
  return best;
}

std::vector<PublishedHolder*> PublishedHolders::called(const std::string& name) {
  std::vector<PublishedHolder*> found, any;
  for (PublishedHolder& held : all_) {
    if (held.emptied > 0) continue;
    any.push_back(&held);
    if (!name.empty() && is_called(held, name) && !held.name.empty()) found.push_back(&held);
  }
  return found.empty() ? any : found;
}

bool PublishedHolders::any_divided() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const PublishedHolder& held) { return held.divided || held.waste; });
}

std::string PublishedHolders::why_not(const HolderWanted& wanted) const {
  for (std::size_t i = all_.size(); i-- > 0;) {
    const PublishedHolder& held = all_[i];
    if (held.emptied > 0 && is_called(held, wanted.name))
      return "the holder" + of_the_name(held.name) + " is empty: its stitches were taken in " +
             in_line(held.emptied) + ".";
  }
  std::string there;
  for (const PublishedHolder& held : all_) {
    if (held.emptied > 0) continue;
    const std::string how_many = held.loop.known ? std::to_string(held.loop.count()) : "some";
    there += (there.empty() ? "; held are " : ", ") + how_many + of_the_name(held.name) + " (" +
             in_line(held.line) + ")";
  }
  return "there are no held stitches" + of_the_name(wanted.name) + there + ".";
}

void PublishedHolders::excuse(std::optional<std::int64_t> count) {
  const auto alike = [&](const PublishedHolder& held) {
    return held.emptied == 0 && count && held.loop.known && held.loop.count() == *count;
  };
  const bool some = std::any_of(all_.begin(), all_.end(), alike);
  for (PublishedHolder& held : all_) held.excused = held.excused || (some ? alike(held) : held.emptied == 0);
}

void PublishedHolders::doubt(std::size_t line) {
  for (PublishedHolder& held : all_) {
    if (held.line != line) continue;
    held.loop.known = false;
    held.excused = true;
  }
}

std::int64_t PublishedHolders::count() const {
  std::int64_t count = 0;
  for (const PublishedHolder& held : all_) count += held.loop.count() + 1;
  return count;
}

std::string PublishedHolders::left_over() const {
  std::string text;
  for (const PublishedHolder& held : all_) {
    if (held.emptied > 0 || held.excused) continue;
    const std::string how_many = held.loop.known ? stitches_are(held.loop.count()) : "stitches are";
    const std::string place =
        std::string(" left on the ") + (held.waste ? "waste yarn" : "holder") + of_the_name(held.name);
    text += text.empty() ? "" : "; ";
    text += how_many;
    text += place + " (" + in_line(held.line) + ")";
  }
  return text.empty() ? "" : text + ".";
}

std::string PublishedHolders::forgotten(std::int64_t missing, std::size_t line) {
  for (std::size_t i = all_.size(); i-- > 0;) {
    PublishedHolder& held = all_[i];
    if (held.emptied > 0 || !held.loop.known || held.loop.count() != missing || missing < 1) continue;
    held.emptied = line;
    return "; " + std::to_string(missing) + of_the_name(held.name) + (missing == 1 ? " is" : " are") +
           " still held (" + in_line(held.line) + ")";
  }
  return "";
}

std::string stitches_are(std::int64_t count) { return stitches_text(count) + (count == 1 ? " is" : " are"); }

std::string of_the_name(const std::string& name) { return name.empty() ? "" : " of the " + name; }

}  // namespace knit
