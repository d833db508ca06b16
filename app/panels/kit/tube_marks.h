// How tubes look wherever panels show them: a yarn's colour, an event's symbol, and both in words.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/palette.h"
#include "knit/tubes/plan.h"

namespace app {

// Each tube's yarn, from 0 in the order of taking up: a tube goes on with that of a tube below it that was worked just before;
// else a new one is taken up. -1: an edge at a ring, which has none.
std::vector<std::int32_t> yarns_of(const knit::TubePlan& plan);
// The labels' colours, so ordered that neighbours differ most.
Colour yarn_colour(std::int32_t yarn);

// Cast on: a dot. Split and join: a triangle that opens upward, and one that closes. Bind off: a square. Ring: a ring.
// `r`: half its size; `under`: of the ground within a ring.
void draw_event_symbol(ImDrawList& list, knit::EventKind kind, ImVec2 at, float r, ImU32 colour, ImU32 under);

std::string names_of_tubes(std::span<const knit::TubeId> tubes);  // "A", "A and B", "A, B and C"
std::string_view event_word(knit::EventKind kind);                // "cast on"
std::string event_words(const knit::TubePlan& plan, std::int32_t event);

}  // namespace app
