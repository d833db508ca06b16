// What the parts of a published line do with needle and holders; for published_reader.cpp alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "knit/reader/reader_words.h"

namespace knit {

enum class PublishedUse : std::uint8_t { work, hold, take, add, as_before, join_ends, none };

struct PublishedPart {
  PublishedUse use = PublishedUse::none;
  Tokens tokens;
  std::optional<std::int64_t> count;  // none: all that is there
  std::string name;                   // of a holder or a section, as it is told; empty: not told
};

// A sentence's parts in order, at commas and semicolons that stand in no bracket; brackets without work are left out.
// `is_round`: what is nothing else is work.
std::vector<PublishedPart> parts_of(const Tokens& sentence, bool is_round);

// "first leg": small letters, without articles and words for stitches and holders.
std::string holder_name(const Tokens& tokens);
// One is called like the other, but for more words or an s.
bool same_name(const std::string& told, const std::string& known);

}  // namespace knit
