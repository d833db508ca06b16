// Work beside the window: its result comes out once, it says how far it is, and it ends when nobody waits for it.
#include "app/base/worker.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "tests/support/catch.h"

using namespace app;

namespace {

// A minute at most, so that a mistake fails rather than hangs.
template <class Test>
bool comes_true(const Test& test) {
  for (int i = 0; i < 60000; ++i) {
    if (test()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace

TEST_CASE("worker: the result, or what was thrown, comes out once") {
  Work<int> work([] { return 7; });
  Work<int> failing([]() -> int { throw std::runtime_error("no"); });
  REQUIRE(comes_true([&] { return work.ready() && failing.ready(); }));
  CHECK(work.take() == 7);
  CHECK_FALSE(work.running());
  CHECK_THROWS_AS(failing.take(), std::runtime_error);
}

TEST_CASE("worker: work that is heard says how far it is, and ends when the last who waits is gone") {
  const auto steps = std::make_shared<std::atomic<int>>(0);
  const auto ended = std::make_shared<std::atomic<int>>(0);
  Work<int> work([steps, ended](const knit::Heard& heard) {
    try {
      for (;; ++*steps) heard(0.25);
    } catch (const NobodyWaits&) {
      ++*ended;
      throw;
    }
    return 0;
  });
  REQUIRE(comes_true([&] { return work.share() > 0.0; }));
  CHECK(work.share() == 0.25);
  Work<int> copy = work;
  work.drop();
  const int before = *steps;
  REQUIRE(comes_true([&] { return *steps > before + 10; }));  // the copy waits still
  CHECK(*ended == 0);
  copy = {};
  REQUIRE(comes_true([&] { return *ended == 1; }));
}

TEST_CASE("worker: work that is not heard finishes, whoever waits") {
  const auto done = std::make_shared<std::atomic<bool>>(false);
  Work<int>([done] {
    *done = true;
    return 1;
  }).drop();
  CHECK(comes_true([&] { return done->load(); }));
}
