// Where a person goes by naming it, and one or two sentences of what is there: "row 7", "round 12 of Leg A", "stitch 20:5",
// "widest round", "longest wale", "first problem", "43 to 65", "third k2tog of round 24", "why row 7".
//
// "43 to 65" is the row where the count of stitches goes from 43 to 65. Operations count in the order in which hands work
// them. Of a run in the making what is known of it counts, and it is said that it goes on.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/session/session.h"
#include "knit/insight/why.h"

namespace app {

struct Destination {
  std::string words;                   // what is there
  std::optional<knit::Element> thing;  // to be selected
  // One of the two at most; neither: one stays where one is. The place may be worked out only then.
  std::optional<std::size_t> position;  // steps taken
  std::optional<knit::Place> place;
  bool asks_why = false;  // the words are what was asked for
};

struct NoDestination {
  std::string why;          // one sentence
  bool understood = false;  // it is a form, and leads nowhere in this run
};

// Requires something open. Cost: some forms look at all steps or all edges.
std::variant<Destination, NoDestination> destination_of(const Session& session, const std::string& typed);

// "Body A", "Leg B": those of a run with limbs, once they are known; else none.
std::vector<std::string> piece_names_of(const Session& session);

// Texts that what is typed could be the beginning of, with this run's pieces by their names.
std::vector<std::string> completions_of(const Session& session, const std::string& typed);

// What is asked about what is shown or selected, and how it is asked for in words.
struct WhyQuestion {
  std::string_view words, where, help;
};
std::span<const WhyQuestion> why_questions();

// "Give row 7, ...": the forms in one sentence.
std::string destination_forms();

}  // namespace app
