// What the parts of a published line do with needle and holders; for the published reader's files alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "knit/reader/reader_grammar.h"

namespace knit {

enum class PublishedUse : std::uint8_t {
  work,
  hold,       // onto a holder
  take,       // off a holder
  add,        // cast on or picked up
  insert,     // worked with waste yarn, which is taken out later: an afterthought thumb
  slip_back,  // what was worked last
  spread,     // "increasing 6 sts evenly"
  as_before,  // "work as for first leg"
  join_ends,  // two live ends
  close,      // bound off or drawn together
  none
};

struct PublishedPart {
  PublishedUse use = PublishedUse::none;
  Tokens tokens;
  std::optional<std::int64_t> count;  // none: all that is there
  std::string name;                   // of a holder or a section, as it is told; empty: not told
  bool some = false;                  // take: "the first 12 of"
  bool maybe = false;                 // take: only if there is such a holder
  bool picks_up = false;              // add: along an edge
  bool at_gap = false;                // add: that edge is a gap's
  bool goes_on = false;               // add: beside what is on the needle
  bool floats = false;                // work: to a place that is not told in stitches ("to marker")
  bool held = false;                  // take: "the held sts", or off a holder that is named
  bool again = false;                 // as_before: what was made last, once more
  bool own = false;                   // join_ends: both ends may be on the needle ("the remaining 16 sts")
  bool all = false;                   // join_ends, close: "both", "all"
};

// A line's label; beside those of reader_grammar.h "Dividing rnd:", "Next rnd (dec):", without a number.
std::optional<RoundLabel> published_label(const Tokens& line);
// A sentence's parts in order, at commas, semicolons and "and k7" that stand in no bracket; brackets without work are left out.
// `is_round`: what is nothing else is work.
std::vector<PublishedPart> parts_of(const Tokens& sentence, bool is_round);

// "first leg": small letters, without articles and words for stitches and holders.
std::string holder_name(const Tokens& tokens);
// One is called like the other, but for more words or an s.
bool same_name(const std::string& told, const std::string& known);

// "THUMB", "First leg:", "Legs (make 2)": few words, no number but that, and nothing to work.
struct SectionTitle {
  std::string name;
  std::int64_t made = 1;
  bool tells = false;  // MATERIALS, NOTES: nothing is worked there
};
std::optional<SectionTitle> title_in(const Tokens& tokens);

// "Rep rnds 3-4 twice more", "rep last 2 rnds until 12 sts remain"
struct RepeatedRounds {
  std::optional<std::int64_t> first;  // none: the last `count`
  std::int64_t last = 0, count = 1, times = 1;
  std::optional<std::int64_t> until;  // stitches
  bool understood = false;
};
// Nothing where the line repeats no rounds.
std::optional<RepeatedRounds> repeated_rounds(const Tokens& tokens);

}  // namespace knit
