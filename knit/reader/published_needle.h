// Needle, named holders and gaps of a published pattern, each as the stitches that lie there; for the published reader alone.
//
// A number of stitches that nobody can tell after a mistake is not known: nothing is said of it until a line states it.
// What goes wrong is a sentence without its line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace knit {

struct PublishedStitch {
  std::int32_t line = 0;     // where it was made
  std::int32_t section = 0;  // by number
};

struct PublishedLoop {
  std::vector<PublishedStitch> stitches;
  bool known = true;
  bool doubtful = false;  // as a line states that made another number: so many, or nobody can tell
  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(stitches.size()); }
  void add(std::int64_t count, PublishedStitch stitch);
  void resize(std::int64_t count, PublishedStitch stitch);
};

struct PublishedHolder {
  std::string name;
  PublishedLoop loop;
  std::size_t line = 0;     // where they were put on it
  std::size_t emptied = 0;  // where they were taken off again; 0: they are on it
  bool divided = false;     // off a needle that went on with others
  bool waste = false;       // worked with waste yarn: twice as many loops come out, or one more or less
  bool excused = false;     // not said again at the end: a mistake stands for it
  bool implied = false;     // nothing says that they are put there
};

struct HolderWanted {
  std::string name;     // as it is told; empty: any
  std::string section;  // where it is told
  std::optional<std::int64_t> count;
};

class PublishedHolders {
 public:
  void put(PublishedHolder holder) { all_.push_back(std::move(holder)); }
  // The one that is meant: of that name, of those one with that count, of those the one filled last. Null: there is none.
  PublishedHolder* find(const HolderWanted& wanted);
  // All that are not empty, by name; all of them where none is called so.
  std::vector<PublishedHolder*> called(const std::string& name);
  [[nodiscard]] bool any_divided() const;
  // Why it is not there, and what is.
  [[nodiscard]] std::string why_not(const HolderWanted& wanted) const;
  // Where one that is told is not there, the others are not blamed as left over.
  void excuse(std::optional<std::int64_t> count);
  // Those that were filled in a line with a mistake: nobody can tell with how many.
  void doubt(std::size_t line);
  [[nodiscard]] std::int64_t count() const;  // of all stitches
  // Whether a holder has just what is missing: what is said of it; empty: none has. It counts as emptied.
  std::string forgotten(std::int64_t missing, std::size_t line);
  // What is left over, in one sentence; empty: nothing.
  [[nodiscard]] std::string left_over() const;

 private:
  std::vector<PublishedHolder> all_;
};

std::string stitches_are(std::int64_t count);      // "5 stitches are"
std::string of_the_name(const std::string& name);  // " of the thumb"; empty where it has none

}  // namespace knit
