// Words that explain themselves: the glossary's are underlined where they stand; the pointer on one shows what it
// means, a click opens the glossary there.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/explain/glossary.h"
#include "app/panels/kit/frame.h"

namespace app {

// Terms by the text that they stand in.
struct TermCache {
  std::map<std::string, std::vector<TermAt>, std::less<>> texts;
};

// As wrapped_text, one item; each word is the control "term/WORD".
void glossary_wrapped_text(PanelFrame& frame, std::string_view words);
void glossary_wrapped_text(PanelFrame& frame, std::string_view words, Colour colour);

// For the last item, which is that word: a heading. Without such a term nothing.
void explains(PanelFrame& frame, std::string_view word);
// For the last item: a tooltip, and a click leads to the first of the glossary's words in `words`, if there is one.
// `free_below`: so much below the item the tip leaves free, too.
void explained_tooltip(PanelFrame& frame, const std::string& help, std::string_view words,
                       float free_below = 0.0f);

}  // namespace app
