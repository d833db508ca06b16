// What the palette of all actions, the glossary and words that explain themselves remember between frames.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/explain/glossary.h"

namespace app {

struct ActionSources;  // app/actions/action_entries.h

struct ActionPaletteState {
  bool shown = false;
  std::array<char, 512> field{};
  int field_number = 0;  // changes when the field is emptied or filled from outside
  bool refocus = false;
  std::string begin_with;           // what the field holds when it opens: by a link
  std::string searched;             // what the list was last made for
  std::size_t chosen = 0;           // in the list shown
  bool follow = false;              // the chosen line is to be scrolled to
  std::string asking;               // the words of the entry for which something is typed; empty: searching
  std::vector<std::string> recent;  // words of entries, newest first
  std::shared_ptr<const ActionSources> sources;  // read when it opens
};

struct GlossaryState {
  bool shown = false;
  std::array<char, 128> search{};
  std::string followed;  // the term that the list was last scrolled to
};

// Terms by the text that they stand in.
struct TermCache {
  std::map<std::string, std::vector<TermAt>, std::less<>> texts;
};

struct WordsState {
  ActionPaletteState palette;
  GlossaryState glossary;
  TermCache terms;
};

}  // namespace app
