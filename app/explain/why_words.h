// Elements and the reasons for them in words: for the command line, the panels and the view.
#pragma once

#include <optional>
#include <string>

#include "app/session/session.h"
#include "knit/insight/why.h"

namespace app {

// "stitch 4 of row 14": as people and the program's sentences count, all from 1 but vertices.
std::string words_of(const knit::Element& thing);

// "stitch:14:3": rows and items from 1, vertices from 0. Nothing where it cannot be read.
std::string text_of(const knit::Element& thing);
std::optional<knit::Element> thing_named(const std::string& text);

// One or two sentences: what made, chose and moved it, or what became of it. Requires a vertex of the mesh.
std::string why_words(const knit::Timeline& timeline, const knit::Element& thing);

// "row 7" or "row:7", from 1. Nothing where it cannot be read.
std::optional<std::int32_t> row_named(const std::string& text);

// The column edge of the longest wale; none before rows are joined.
std::optional<knit::ColumnEdgeElement> longest_wale_of(const knit::Timeline& timeline);

// What decided in the last step, beside its sentence; empty where there is nothing to add.
std::string cause(const Session& session);

}  // namespace app
