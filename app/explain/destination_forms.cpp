// The forms in which places are named: told, completed, and asked by the menu.
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "app/explain/destination.h"

namespace app {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}

// What can be typed, each as it stands; the first ones are shown where nothing is typed.
constexpr std::array form_examples{std::string_view("row 7"),
                                   std::string_view("stitch 20:5"),
                                   std::string_view("vertex 120"),
                                   std::string_view("step 100"),
                                   std::string_view("widest round"),
                                   std::string_view("longest wale"),
                                   std::string_view("first problem"),
                                   std::string_view("43 to 65"),
                                   std::string_view("third k2tog of round 24"),
                                   std::string_view("next increase"),
                                   std::string_view("why row 7"),
                                   std::string_view("why stitch 20:5"),
                                   std::string_view("why stopped")};

constexpr std::array form_beginnings{std::string_view("row "),
                                     std::string_view("round "),
                                     std::string_view("stitch "),
                                     std::string_view("vertex "),
                                     std::string_view("step "),
                                     std::string_view("widest round"),
                                     std::string_view("narrowest round"),
                                     std::string_view("longest wale"),
                                     std::string_view("shortest wale"),
                                     std::string_view("first problem"),
                                     std::string_view("next problem"),
                                     std::string_view("worst problem"),
                                     std::string_view("first k2tog"),
                                     std::string_view("next k2tog"),
                                     std::string_view("next ssk"),
                                     std::string_view("next increase"),
                                     std::string_view("next decrease"),
                                     std::string_view("third k2tog of the decreasing half"),
                                     std::string_view("first k2tog of the decreasing half"),
                                     std::string_view("next k2tog of the decreasing half"),
                                     std::string_view("first increase of the increasing half"),
                                     std::string_view("third k2tog after the widest round"),
                                     std::string_view("last row"),
                                     std::string_view("why row "),
                                     std::string_view("why stitch "),
                                     std::string_view("why not vertex "),
                                     std::string_view("why stopped"),
                                     std::string_view("end"),
                                     std::string_view("start")};

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.size() > beginning.size() && lower(text).compare(0, beginning.size(), beginning) == 0;
}

// "round 12 of l": with the names that go on so.
std::vector<std::string> with_pieces(const Session& session, const std::string& typed) {
  const std::string small = lower(typed);
  const std::size_t of = small.rfind(" of ");
  if (of == std::string::npos || small.find("round") == std::string::npos) return {};
  std::vector<std::string> texts;
  for (const std::string& name : piece_names_of(session)) {
    std::string text = typed.substr(0, of + 4) + name;
    if (begins_with(text, small)) texts.push_back(std::move(text));
  }
  return texts;
}

constexpr std::array questions{
    WhyQuestion{"Why does this row have so many stitches?", "why row",
                "Of the row shown: goes to the step that gave it its number of stitches."},
    WhyQuestion{"Why is this stitch here?", "why stitch",
                "Of the stitch, edge or face selected: goes to the step that made it."},
    WhyQuestion{"Why is this vertex not a stitch?", "why not vertex",
                "Of the vertex selected: goes to the step that refused or took it."},
    WhyQuestion{"Why did the run stop?", "why stopped", "Goes to where it ends."}};

}  // namespace

std::span<const WhyQuestion> why_questions() { return questions; }

std::string destination_forms() {
  return "Give row 7, round 12 of Leg A, stitch 20:5, vertex 120, step 100, widest round, longest wale, "
         "first problem, 43 "
         "to 65 (where the stitches go from 43 to 65), third k2tog of round 24, next increase, or why and "
         "one of these.";
}

std::vector<std::string> completions_of(const Session& session, const std::string& typed) {
  std::vector<std::string> texts;
  if (typed.empty()) {
    texts.assign(form_examples.begin(), form_examples.end());
    return texts;
  }
  texts = with_pieces(session, typed);
  const std::string small = lower(typed);
  for (const std::string_view form : form_beginnings)
    if (begins_with(std::string(form), small)) texts.emplace_back(form);
  return texts;
}

}  // namespace app
