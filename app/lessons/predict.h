// Guessing each verdict before it falls: playing pauses before a vertex is measured, and what a person guesses is
// held against the step itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "app/session/session.h"
#include "knit/mesh/mesh.h"

namespace app {

struct Prediction {
  std::int32_t guessed = 0, right = 0;
  std::int32_t streak = 0;  // right ones in a row
  // Of the last guess, while its step is the one shown.
  struct Told {
    std::size_t position = 0;
    bool right = false;
    std::string words;  // the step's sentence
  };
  std::optional<Told> told;
  std::optional<std::size_t> playing_from;  // playing was paused here and goes on after the guess
};

// Not its verdict, which is still to fall.
struct AskedVertex {
  knit::VertexId anchor = knit::no_vertex, candidate = knit::no_vertex;
};
// The vertex that is measured next, while guessing is on; none: nothing is to be guessed here.
std::optional<AskedVertex> asked_vertex(const Session& session);

// While guessing is on: the first position from the one shown up to `end` before which a verdict waits.
std::optional<std::size_t> verdict_ahead(const Session& session, std::size_t end);

}  // namespace app
