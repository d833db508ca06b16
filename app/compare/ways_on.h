// Ways on from a run that stopped: other settings with which the same mesh is knitted to the end.
//
// A short list by what stopped it, cheapest first. Each is run whole on a thread of its own, and only what finished is
// found; nothing here is guessed. The window's buttons and --ways-on both take what stands here.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/session/sweep.h"
#include "knit/run/step.h"

namespace app {

struct WayOn {
  std::string key;    // "contours": of its button
  std::string words;  // "Rows from contours"
  std::function<void(knit::Parameters&)> set;
  std::string options;  // of the command line: "--rows contours"
};

// One that finished.
struct FoundWay {
  WayOn way;
  std::size_t rows = 0, stitches = 0;
  [[nodiscard]] std::string result() const;  // "57 rows"
};

// The parameters with the way's settings; what it does not name stays.
knit::Parameters with_way(const WayOn& way, knit::Parameters parameters);

// Worth trying, in the order in which they are tried: each differs from what was in force when the run stopped.
std::vector<WayOn> ways_to_try(const knit::Input& input, const knit::Parameters& at_stop,
                               const knit::Step& stop);

// So many are found before the rest is left untried.
inline constexpr std::size_t enough_ways = 4;

// Tries them one after the other. Whoever drops it does not wait: the thread ends by itself.
class WaysOnWork {
 public:
  // Requires a run that stopped, worked out as far.
  explicit WaysOnWork(const knit::Timeline& timeline);
  ~WaysOnWork();
  WaysOnWork(const WaysOnWork&) = delete;
  WaysOnWork& operator=(const WaysOnWork&) = delete;

  void wait() const;
  [[nodiscard]] bool running() const;
  [[nodiscard]] std::size_t tried() const;  // rises
  [[nodiscard]] std::size_t total() const;
  [[nodiscard]] std::vector<FoundWay> found() const;  // so far, as tried

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

// What is offered, in one sentence: which ways finish, or that none of those tried does.
std::string words_of(const WaysOnWork& work);

}  // namespace app
