// Works a run out and holds every promise against it: graph, rows, live stitches, joins, strips, faces, lines, that going
// back and forth changes nothing, and where stitches settle that only their places change.
#pragma once

#include <cstddef>
#include <string>

#include "tests/stress/random_run.h"

namespace stress {

enum class Verdict { sound, stopped, broken };

struct Outcome {
  Verdict verdict = Verdict::sound;
  std::string words;  // why it stopped, or what is broken
  std::size_t steps = 0, tubes = 0, deals = 0, stitches = 0, left_out = 0, handles_left_out = 0;
  std::size_t settled = 0;    // 1: its stitches did
  double milliseconds = 0.0;  // of the run itself, processor time
};
Outcome check_run(const RandomRun& run);

}  // namespace stress
