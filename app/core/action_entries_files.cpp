// Entries about files: examples, what was opened lately, pictures, the pattern's words; and notices.
#include "app/core/action_entries_parts.h"
#include "app/core/navigate.h"
#include "app/core/pattern_file.h"
#include "app/core/session_file.h"
#include "app/core/words.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

constexpr const char* files = "Files";
constexpr const char* the_pattern = "The pattern";
constexpr const char* program = "The program";

void add_opening(EntryList& list, const ActionSources& sources) {
  list.add(
      {"Open file...", files, "A mesh (.obj) or a session (.json), by its path.",
       ActionPrompt{"Path", "mesh.obj", [](const Session& /*session*/, const std::string& typed) -> Read {
                      std::error_code error;
                      if (std::filesystem::is_regular_file(typed, error)) return opening_of(typed);
                      return typed + " is no file.";
                    }}});
  for (const std::string& name : sources.examples) {
    list.add({"Open the example " + name, files, "", OpenExample{name}, "", "", true});
  }
  for (const auto& [path, opening] : sources.recent) {
    list.add({"Open again: " + path, files, "", opening, "", "", true});
  }
  const std::string no_offer = list.session.mend_offer ? "" : "No mesh waits for mends.";
  list.add({"Mend the mesh and open it", files, "What was found wrong with it is mended.", MendAndOpen{},
            no_offer});
  list.add({"Do not mend the mesh", files, "What is open stays.", DropMendOffer{}, no_offer});
  list.add({"Undo the mends", files, "Back to what was open before.", UndoMend{},
            list.session.before_mend ? "" : "No mesh was mended in this window."});
  const bool none = list.session.preferences.recent.empty();
  list.add(
      {"Forget what was opened lately", files, "", ForgetRecent{}, none ? "Nothing is remembered." : ""});
  const std::string no_rescue = list.session.rescued ? "" : "No session was left by a crash.";
  list.add({"Open the session from before the crash", files, "", TakeRescued{}, no_rescue});
  list.add({"Forget the session from before the crash", files, "", DropRescued{}, no_rescue});
}

// "ball.png", or with a size: "ball.png 1920x1080".
Read read_picture(const Session& /*session*/, const std::string& typed) {
  const std::size_t blank = typed.rfind(' ');
  SavePicture wish{typed.substr(0, blank)};
  if (blank != std::string::npos) {
    const auto size = split(std::string_view(typed).substr(blank + 1), 'x');
    const auto width = whole_number<int>(size[0]);
    const auto height = size.size() == 2 ? whole_number<int>(size[1]) : std::nullopt;
    if (!width || !height || *width < 64 || *height < 64 || *width > 16384 || *height > 16384)
      return "After the name, a size is WIDTHxHEIGHT, each from 64 to 16384, not \"" +
             typed.substr(blank + 1) + "\".";
    wish.width = *width;
    wish.height = *height;
  }
  if (wish.path.extension() != ".png") return "A picture's name ends in .png.";
  return wish;
}

Read read_animation(const Session& session, const std::string& typed) {
  if (typed.empty()) return "Give a name: FILE.gif, FILE.png, or a folder for numbered pictures.";
  const auto row = stretch_of_row(session);
  return SaveAnimation{typed, row.value_or(Stretch{0, session.timeline->known()})};
}

void add_figures(EntryList& list) {
  list.add({"Save a picture of any size...", files, "Of the view alone, without panels.",
            ActionPrompt{"Name and size", "picture.png 1920x1080", read_picture}, list.unless_open()});
  list.add({"Save an animation of this row...", files, "An animated picture, or numbered ones in a folder.",
            ActionPrompt{"Name", "row.gif", read_animation}, list.unless_open()});
  list.add({"Cancel the animation", files, "", CancelAnimation{},
            list.session.animation ? "" : "No animation is in the making."});
}

// The pattern's options with one of its words set.
ActionPrompt ask_words(const char* label, const char* example, std::string knit::PatternOptions::*field) {
  return {label, example, [field](const Session& session, const std::string& typed) -> Read {
            knit::PatternOptions options = session.pattern;
            options.*field = typed;
            return SetPatternOptions{std::move(options)};
          }};
}

Read read_needle(const Session& session, const std::string& typed) {
  knit::PatternOptions options = session.pattern;
  options.needle_mm = needle_mm_of(typed);
  if (!options.needle_mm) return "The needle cannot be \"" + typed + "\" mm; give " + needle_range + ".";
  return SetPatternOptions{std::move(options)};
}

void add_switch(EntryList& list, const char* words, bool knit::PatternOptions::*field) {
  knit::PatternOptions options = list.session.pattern;
  options.*field = !(options.*field);
  list.add({words, the_pattern, "", SetPatternOptions{std::move(options)}, "", "", true});
}

void add_pattern(EntryList& list) {
  list.add({"Set the pattern's title to...", the_pattern, "",
            ask_words("Title", "A ball for Ada", &knit::PatternOptions::title), "", "", true});
  list.add({"Set the pattern's yarn to...", the_pattern, "",
            ask_words("Yarn", "Merino DK", &knit::PatternOptions::yarn), "", "", true});
  list.add({"Set the yarn's colour to...", the_pattern, "",
            ask_words("Colour", "sea green", &knit::PatternOptions::colour), "", "", true});
  list.add({"Set the needle to...", the_pattern, "", ActionPrompt{"Needle, in mm", "4", read_needle}, "", "",
            true});
  add_switch(list, "Markers at main lines: on or off", &knit::PatternOptions::markers);
  add_switch(list, "Repeats with stars: on or off", &knit::PatternOptions::stars);
  list.add({"Knit along from round...", the_pattern, "One round at a time, large.",
            ActionPrompt{"Round", "1",
                         [](const Session& /*session*/, const std::string& typed) -> Read {
                           const auto round = whole_number<std::int32_t>(typed);
                           if (round && *round >= 1) return KnitAlong{*round};
                           return "A round is a whole number from 1 on, not \"" + typed + "\".";
                         }},
            list.unless_open()});
}

}  // namespace

void add_file_entries(EntryList& list, const ActionSources& sources) {
  add_opening(list, sources);
  add_figures(list);
  add_pattern(list);
  const std::size_t notices = list.session.notices.size();
  list.add({"Dismiss the newest notice", program, "", DismissNotice{notices > 0 ? notices - 1 : 0},
            notices > 0 ? "" : "There is no notice."});
}

}  // namespace app
