#include "app/base/beside.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace app {

void start_beside(std::function<void()> work) { std::thread(std::move(work)).detach(); }

void start_in_pieces(std::function<bool()> piece) {
  std::thread([piece = std::move(piece)] {
    while (piece()) {
    }
  }).detach();
}

unsigned hands_beside() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace app
