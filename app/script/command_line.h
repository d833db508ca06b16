// The command line: a contract that others script against. It turns words into the same actions that buttons
// make.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/curves/curve_wish.h"
#include "app/script/round_words.h"
#include "app/script/yarn_words.h"
#include "app/session/action.h"
#include "app/session/at.h"
#include "app/session/preferences.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"

namespace app {

struct CommandLine {
  Action open = OpenExample{"thesis-sphere"};
  std::string preset;  // its key; empty: none. Comes before the settings
  std::vector<std::pair<const knit::ParameterInfo*, std::string>> settings;  // values as text, checked
  std::optional<At> at;  // none: the end when headless, the start in the window
  bool headless = false;
  bool empty = false;        // nothing is to be opened
  bool every_piece = false;  // of the mesh, one after the other: pieces.h. Headless
  knit::PatternOptions pattern;
  SidePanel side = SidePanel::step;        // what the right column shows
  std::optional<RunList> list;             // below the step
  CentrePanel centre = CentrePanel::view;  // what the centre shows
  std::optional<std::string> chart_piece;  // whose chart, by its letters
  std::optional<Positions> positions;  // of stitches that have settled; none: settled, or as a session has it
  std::optional<ThemeKind> theme;      // none: as the preferences have it
  std::optional<double> scale;         // likewise
  std::optional<decltype(Preferences::row_columns)> row_columns;  // of the list of rows; likewise
  std::vector<std::string> piece_order;    // letters, as they are worked; empty: the cheapest
  std::optional<RoundWords> knit_along;    // the round to begin with, as the pattern counts
  bool follow = false;                     // the view turns to what happens behind the surface
  bool fit_size = false;                   // to the rhythm, once all else is set
  std::filesystem::path session;           // instead of a mesh; empty: none
  std::vector<std::string> breaks, sweep;  // as given: queries.h
  std::string diff, why, select;
  bool explain = false, ways_on = false;
  std::string point;                        // a variable of the pseudo-code
  std::string lesson;                       // its key or file; empty: none
  std::optional<std::int32_t> lesson_page;  // from 1
  std::vector<Export> saves;
  std::optional<SavePicture> picture;
  std::optional<SaveAnimation> animation;  // its stretch: from and to
  At from = std::size_t{0}, to = AtEnd{};
  int width = 1440, height = 900;  // of the picture or the window, in pixels of a plain screen

  bool side_given = false, centre_given = false;  // beside a session only what is given counts
  std::string go_to;                              // as given: queries.h
  bool presenting = false;                        // for a class
  bool embedded = false;                          // in a page of others: no menus
  // Of the run that is shown beside the one that is opened; empty: none is.
  std::vector<std::pair<const knit::ParameterInfo*, std::string>> beside;

  std::filesystem::path checked;            // a pattern that is shown with its verdicts; empty: none
  std::optional<std::size_t> checked_line;  // where the caret stands, from 1
  std::string checked_size;                 // its name or its number from 1; empty: the first
  std::optional<SetCheckedGauge> checked_gauge;
  YarnWish yarn;     // layers, mesh or yarn, its colours
  CurveWish curves;  // of an example or a session; those of a mesh's file are in `open`
};

// The program's answer without a window: help, a list, an error.
struct Answer {
  int exit_code = 0;
  std::string out;    // for standard output
  std::string error;  // one line for standard error
};

inline constexpr int exit_done = 0;
inline constexpr int exit_stopped = 1;         // the algorithm stopped on this mesh
inline constexpr int exit_usage = 2;           // bad usage, or an unreadable or unfit file
inline constexpr int exit_not_understood = 5;  // check: a line of work is not understood
inline constexpr int exit_no_break = 4;        // no condition of --break holds

inline Answer bad_usage(const std::string& sentence) { return {exit_usage, "", sentence}; }

std::string_view program_version();  // "0.1.0"

// `arguments` without the program's name.
std::variant<CommandLine, Answer> parse_command_line(const std::vector<std::string>& arguments,
                                                     const std::filesystem::path& assets);

// Opens the mesh and sets the parameters; the error is one sentence. For a window a large mesh may be left to a
// worker (session.jobs->opening); once it is open, set_as_asked does the rest.
std::optional<std::string> open_as_asked(Session& session, const CommandLine& line);
// Requires something open.
std::optional<std::string> set_as_asked(Session& session, const CommandLine& line);

}  // namespace app
