// What is typed as a place to go to, looked up once and kept: a frame must not walk a run.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "app/explain/destination.h"
#include "app/session/run_key.h"

namespace app {

class DestinationLookup {
 public:
  using Found = std::variant<Destination, NoDestination>;
  // Requires something open. Looks anew where the words, the run or the place shown are others.
  const Found& find(const Session& session, const std::string& typed);
  // Of the last ones.
  [[nodiscard]] const std::vector<std::string>& completions() const { return completions_; }

 private:
  std::string typed_;
  RunKey run_;
  std::size_t position_ = 0;
  bool complete_ = false, looked_ = false;
  Found found_;
  std::vector<std::string> completions_;
};

struct GoToState {
  bool shown = false;
  std::array<char, 128> field{};
  int field_number = 0;  // changes when it is filled from outside
  bool refocus = false;
  int chosen = -1;  // of the completions; -1: none
  DestinationLookup lookup;
};

}  // namespace app
