// Entries about what is seen: from which side, which panels and lists, in which theme and size.
#include <array>
#include <cmath>
#include <numbers>

#include "app/actions/looking.h"
#include "app/actions/navigate.h"
#include "app/base/text.h"
#include "app/checker/checker.h"
#include "app/entries/action_entries_parts.h"
#include "app/files/pattern_export.h"
#include "app/files/session_file.h"
#include "app/scene/colour_text.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/pattern_pieces.h"
#include "app/session/program.h"
#include "app/session/remarks.h"
#include "app/session/view.h"
#include "knit/model/words.h"

namespace app {

namespace {

using Read = std::variant<Action, std::string>;

struct Side {
  const char* words;
  double yaw, pitch;  // of the camera; a turn of 1 is a right angle
};

void add_sides(EntryList& list) {
  constexpr std::array sides{Side{"Look from the front", 0.0, 0.0}, Side{"Look from the right", 1.0, 0.0},
                             Side{"Look from the back", 2.0, 0.0},  Side{"Look from the left", 3.0, 0.0},
                             Side{"Look from above", 0.0, 0.9},     Side{"Look from below", 0.0, -0.9}};
  constexpr double right_angle = 0.5 * std::numbers::pi;
  const Camera& camera = list.session.view->gaze.camera;
  for (const Side& side : sides) {
    // The shorter way round.
    const double turn = std::remainder(side.yaw * right_angle - camera.yaw, 4.0 * right_angle);
    list.add({side.words, group::view, "", Orbit{turn, side.pitch * right_angle - camera.pitch},
              list.unless_open(), "", true});
  }
}

void add_moves(EntryList& list) {
  constexpr double by = 0.25;  // of half the view
  list.add({"Zoom in", group::view, "", Zoom{0.8, {0.0, 0.0}}, list.unless_open(), "", true});
  list.add({"Zoom out", group::view, "", Zoom{1.25, {0.0, 0.0}}, list.unless_open(), "", true});
  list.add({"Move the view left", group::view, "", Pan{{-by, 0.0}}, list.unless_open(), "", true});
  list.add({"Move the view right", group::view, "", Pan{{by, 0.0}}, list.unless_open(), "", true});
  list.add({"Move the view up", group::view, "", Pan{{0.0, by}}, list.unless_open(), "", true});
  list.add({"Move the view down", group::view, "", Pan{{0.0, -by}}, list.unless_open(), "", true});
  const bool following = list.session.view->following;
  list.add({following ? "Leave the view as it is turned" : "Turn the view to what happens", group::view,
            "When it is behind the surface.", SetFollowing{!following}});
}

ActionPrompt ask_stripes() {
  return {"Rounds of each colour, 0 for no stripes", "4",
          [](const Session& session, const std::string& typed) -> Read {
            YarnLook look = session.view->yarn;
            const auto rounds = whole_number<int>(typed);
            if (!rounds || *rounds < 0 || *rounds > most_stripe_rounds)
              return "Rounds are a whole number from 0 to " + std::to_string(most_stripe_rounds) +
                     ", not \"" + typed + "\".";
            look.stripe_rounds = *rounds;
            return SetYarnLook{look};
          }};
}

ActionPrompt ask_yarn_colour(Colour YarnLook::*which) {
  return {"A colour like #d8b48c", "#d8b48c",
          [which](const Session& session, const std::string& typed) -> Read {
            YarnLook look = session.view->yarn;
            const auto colour = colour_of_hex(typed);
            if (!colour) return "A colour is like #d8b48c, not \"" + typed + "\".";
            look.*which = *colour;
            return SetYarnLook{look};
          }};
}

ActionPrompt ask_yarn_radius() {
  return {"Radius in widths of a stitch, or auto", "auto",
          [](const Session& session, const std::string& typed) -> Read {
            YarnLook look = session.view->yarn;
            const auto radius = read_yarn_radius(typed);
            if (!radius)
              return "A radius is auto or from " + knit::number_text(least_yarn_radius) + " to " +
                     knit::number_text(most_yarn_radius) + " widths of a stitch, not \"" + typed + "\".";
            look.radius = *radius;
            return SetYarnLook{look};
          }};
}

void add_yarn(EntryList& list) {
  for (std::size_t i = 0; i < yarn_colours_keys.size(); ++i) {
    YarnLook look = list.session.view->yarn;
    const bool so = look.by == static_cast<YarnColours>(i);
    look.by = static_cast<YarnColours>(i);
    list.add({"Colour the yarn by " + std::string(yarn_colours_keys[i]), group::view, "", SetYarnLook{look},
              so ? "It is." : ""});
  }
  list.add(
      {"Set the drawn yarn's colour to...", group::view, "", ask_yarn_colour(&YarnLook::wool), "", "", true});
  list.add({"Set the drawn yarn's second colour to...", group::view, "", ask_yarn_colour(&YarnLook::second),
            "", "", true});
  list.add({"Stripe the yarn by rounds...", group::view, "", ask_stripes(), "", "", true});
  list.add({"Set the drawn yarn's radius to...", group::view, "", ask_yarn_radius(), "", "", true});
  YarnLook eased = list.session.view->yarn;
  const bool room = eased.easing > 0;
  eased.easing = room ? 0 : usual_yarn_easing;
  list.add({room ? "Draw the yarn as it is worked" : "Make room where the yarn overlaps", group::view, "",
            SetYarnLook{eased}});
}

void add_shown(EntryList& list) {
  const Session& session = list.session;
  for (std::size_t i = 0; i < side_keys.size(); ++i) {
    const auto side = static_cast<SidePanel>(i);
    list.add({"Show the side panel: " + std::string(side_keys[i]), group::panels, "", ShowSide{side},
              session.view->side == side ? "It is shown." : ""});
  }
  for (std::size_t i = 0; i < list_keys.size(); ++i) {
    const auto shown = static_cast<RunList>(i);
    list.add({"Show the list: " + std::string(list_keys[i]), group::panels, "Below the step.",
              ShowList{shown}, session.view->list == shown ? "It is shown." : ""});
  }
  for (std::size_t i = 0; i < positions_keys.size(); ++i) {
    const auto positions = static_cast<Positions>(i);
    list.add({"Show stitches as they are " + std::string(positions_keys[i]), group::view,
              "In the view, in figures and in what is saved.", SetPositions{positions},
              session.view->positions == positions ? "They are shown so." : ""});
  }
  for (std::size_t i = 0; i < looking_keys.size(); ++i) {
    const auto looking = static_cast<Looking>(i);
    list.add({"Show the piece as " + std::string(looking_keys[i]), group::view,
              "Layers and positions together.", ShowAs{looking},
              looking_of(session) == looking ? "It is shown so." : list.unless_open()});
  }
  add_yarn(list);
  list.add({"Ring round the pointer while presenting: on or off", group::view, "",
            SetRing{!session.view->ring}, "", "", true});
  for (std::size_t i = 0; i < panel_keys.size(); ++i) {
    const auto panel = static_cast<Panel>(i);
    list.add({"Open or close the panel: " + std::string(panel_keys[i]), group::panels, "",
              ShowPanel{panel, !session.program->preferences.shows(panel)}});
  }
}

// In units of a plain screen.
ActionPrompt ask_split(Split split) {
  return {"Size, or 0 for as there is room", "300",
          [split](const Session& /*session*/, const std::string& typed) -> Read {
            const auto size = whole_number<int>(typed);
            if (size && *size >= 0 && *size <= 10000) return SetSplit{split, static_cast<double>(*size)};
            return "A size is a whole number from 0 to 10000, not \"" + typed + "\".";
          }};
}

void add_layout(EntryList& list) {
  list.add(
      {"Set the width of the left panel to...", group::panels, "", ask_split(Split::left), "", "", true});
  list.add(
      {"Set the width of the right panel to...", group::panels, "", ask_split(Split::right), "", "", true});
  list.add(
      {"Set the height of the timeline to...", group::panels, "", ask_split(Split::bottom), "", "", true});
  list.add({"Copy the list of rows as CSV", group::panels, "", CopyRows{}, list.unless_open()});
  for (std::size_t i = 0; i < row_column_keys.size(); ++i) {
    const auto column = static_cast<RowColumn>(i);
    const bool shown = list.session.program->preferences.shows(column);
    list.add({(shown ? "Hide" : "Show") + std::string(" the column ") + std::string(row_column_keys[i]) +
                  " of the list of rows",
              group::panels, "", ShowRowColumn{column, !shown}});
  }
  list.add({"Put the panels back as they were at first", group::panels, "Reset the layout.", ResetLayout{}});
}

Read read_scale(const Session& /*session*/, const std::string& typed) {
  const auto percent = whole_number<int>(typed);
  const double scale = percent ? static_cast<double>(*percent) / 100.0 : 0.0;
  if (scale >= smallest_scale && scale <= largest_scale) return SetScale{scale};
  return "The size is from 75 to 250 per cent, not \"" + typed + "\".";
}

void add_look(EntryList& list) {
  const Preferences& now = list.session.program->preferences;
  for (std::size_t i = 0; i < theme_keys.size(); ++i) {
    const auto theme = static_cast<ThemeKind>(i);
    list.add({"Use the " + std::string(theme_keys[i]) + " theme", group::program, "", SetTheme{theme},
              now.theme == theme ? "It is in use." : ""});
  }
  list.add({"Words and lines in their usual size", group::program, "", SetScale{1.0}});
  list.add({"Words and lines large, for a projector", group::program, "", SetScale{projector_scale}});
  list.add({"Set the size of words and lines to...", group::program, "",
            ActionPrompt{"Per cent", "125", read_scale}});
  list.add({"Allow or stop short movements", group::program, "", SetMotion{!now.motion}});
}

}  // namespace

void add_view_entries(EntryList& list) {
  add_shown(list);
  add_layout(list);
  add_sides(list);
  add_moves(list);
  add_look(list);
}

// Entries about files: examples, what was opened lately, pictures, the pattern's words; and notices.

namespace {

using Read = std::variant<Action, std::string>;

Read read_line(const Session& /*session*/, const std::string& typed) {
  const auto line = whole_number<std::size_t>(typed);
  if (line && *line >= 1) return GoToCheckedLine{*line};
  return "A line is a whole number from 1, not \"" + typed + "\".";
}

Read read_size(const Session& session, const std::string& typed) {
  const auto& checker = session.view->checker;
  const std::size_t sizes = checker && checker->checked ? checker->checked->sizes.size() : 1;
  for (std::size_t i = 0; i < sizes; ++i)
    if (checker && checker->checked && checker->checked->sizes[i].name == typed) return ShowCheckedSize{i};
  const auto number = whole_number<std::size_t>(typed);
  if (number && *number >= 1 && *number <= sizes) return ShowCheckedSize{*number - 1};
  return "The pattern has " + knit::plural(static_cast<std::int64_t>(sizes), "size", "sizes") + "; \"" +
         typed + "\" is none of them, by name or by number.";
}

Read read_checked_gauge(const Session& /*session*/, const std::string& typed) {
  if (const auto gauge = checked_gauge(typed)) return SetCheckedGauge{gauge->stitches, gauge->rows};
  return "A gauge is stitches x rows on 10 cm, like 22x32, each from 1 to 200.";
}

// A written pattern that is checked.
void add_checker(EntryList& list) {
  const auto& checker = list.session.view->checker;
  const std::string none = checker ? "" : "No pattern is being checked.";
  list.add(
      {"Check the pattern in the file...", group::the_pattern, "Text, Markdown or HTML, by its path.",
       ActionPrompt{"Path", "pattern.txt", [](const Session& /*session*/, const std::string& typed) -> Read {
                      return CheckFile{typed};
                    }}});
  list.add(
      {"Check these words...", group::the_pattern, "In place of the text that is checked.",
       ActionPrompt{"Words", "CO 6 sts.", [](const Session& /*session*/, const std::string& typed) -> Read {
                      return SetCheckedText{typed, true};
                    }}});
  list.add({"Save the checked pattern as...", group::the_pattern, "By its path.",
            ActionPrompt{"Path", "pattern.txt",
                         [](const Session& /*session*/, const std::string& typed) -> Read {
                           return SaveCheckedText{typed};
                         }},
            none});
  list.add({"Put back the pattern that stood there before", group::the_pattern, "", RestoreCheckedText{},
            checker && checker->before ? "" : "No other text stood there."});
  list.add({"Go to a line of the checked pattern...", group::the_pattern, "",
            ActionPrompt{"Line", "1", read_line}, none});
  list.add({"Show another size of the checked pattern...", group::the_pattern, "",
            ActionPrompt{"Size", "1", read_size}, none});
  list.add({"Set the gauge of the pattern's preview...", group::the_pattern, "Stitches x rows on 10 cm.",
            ActionPrompt{"Gauge", "22x32", read_checked_gauge}});
}

void add_opening(EntryList& list, const ActionSources& sources) {
  add_checker(list);
  list.add(
      {"Open file...", group::files, "A mesh (.obj), a session (.json) or a pattern (.txt), by its path.",
       ActionPrompt{"Path", "mesh.obj", [](const Session& /*session*/, const std::string& typed) -> Read {
                      std::error_code error;
                      if (std::filesystem::is_regular_file(typed, error)) return opening_of(typed);
                      return typed + " is no file.";
                    }}});
  for (const std::string& name : sources.examples) {
    list.add({"Open the example " + name, group::files, "", OpenExample{name}, "", "", true});
  }
  for (const auto& [path, opening] : sources.recent) {
    list.add({"Open again: " + path, group::files, "", opening, "", "", true});
  }
  const std::string no_offer = list.session.jobs->repair_offer ? "" : "No mesh waits for repairs.";
  list.add({"Repair the mesh and open it", group::files, "What was found wrong with it is repaired.",
            RepairAndOpen{}, no_offer});
  list.add({"Do not repair the mesh", group::files, "What is open stays.", DropRepairOffer{}, no_offer});
  list.add({"Undo the repairs", group::files, "Back to what was open before.", UndoRepair{},
            list.session.document && list.session.document->before_repair
                ? ""
                : "No mesh was repaired in this window."});
  const bool none = list.session.program->preferences.recent.empty();
  list.add({"Forget the recent files and examples", group::files, "", ForgetRecent{},
            none ? "Nothing is remembered." : ""});
  const std::string no_rescue = list.session.program->rescued ? "" : "No session was left by a crash.";
  list.add({"Open the session from before the crash", group::files, "", TakeRescued{}, no_rescue});
  list.add({"Forget the session from before the crash", group::files, "", DropRescued{}, no_rescue});
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
  return SaveAnimation{typed, row.value_or(Stretch{0, session.document->timeline.known()})};
}

void add_figures(EntryList& list) {
  list.add({"Save a picture of any size...", group::files, "Of the view alone, without panels.",
            ActionPrompt{"Name and size", "picture.png 1920x1080", read_picture}, list.unless_open()});
  list.add({"Save an animation of this row...", group::files,
            "An animated picture, or numbered ones in a folder.",
            ActionPrompt{"Name", "row.gif", read_animation}, list.unless_open()});
  list.add({"Cancel the animation", group::files, "", CancelAnimation{},
            list.session.jobs->animation ? "" : "No animation is in progress."});
}

// The pattern's options with one of its words set.
ActionPrompt ask_words(const char* label, const char* example, std::string knit::PatternOptions::*field) {
  return {label, example, [field](const Session& session, const std::string& typed) -> Read {
            knit::PatternOptions options = session.view->pattern;
            options.*field = typed;
            return SetPatternOptions{std::move(options)};
          }};
}

Read read_needle(const Session& session, const std::string& typed) {
  knit::PatternOptions options = session.view->pattern;
  options.needle_mm = needle_mm_of(typed);
  if (!options.needle_mm) return "The needle cannot be \"" + typed + "\" mm; give " + needle_range + ".";
  return SetPatternOptions{std::move(options)};
}

void add_switch(EntryList& list, const char* words, bool knit::PatternOptions::*field) {
  knit::PatternOptions options = list.session.view->pattern;
  options.*field = !(options.*field);
  list.add({words, group::the_pattern, "", SetPatternOptions{std::move(options)}, "", "", true});
}

void add_turns(EntryList& list) {
  knit::PatternOptions options = list.session.view->pattern;
  const bool wraps = options.turns == knit::ShortRowTurns::wrap;
  options.turns = wraps ? knit::ShortRowTurns::german : knit::ShortRowTurns::wrap;
  list.add({"Wrap and turn in short rows: on or off", group::the_pattern,
            wraps ? "On: German short rows otherwise." : "Off: German short rows.",
            SetPatternOptions{std::move(options)}, "", "", true});
}

void add_short_form(EntryList& list) {
  knit::PatternOptions options = list.session.view->pattern;
  const auto& document = list.session.document;
  const bool is_short =
      document ? in_form(options, document->timeline.furthest()).form == knit::PatternForm::short_form
               : options.form == knit::PatternForm::short_form;
  options.form = is_short ? knit::PatternForm::full : knit::PatternForm::short_form;
  list.add({"The pattern in its short form: on or off", group::the_pattern, "",
            SetPatternOptions{std::move(options)}, "", "", true});
}

Read read_named_piece(const Session& /*session*/, const std::string& typed) {
  auto named = read_piece_name(typed);
  if (auto* fault = std::get_if<std::string>(&named)) return std::move(*fault);
  const auto& [letters, word] = std::get<0>(named);
  return SetPieceNames{{{letters, word}}};
}

Read read_ordered_pieces(const Session& /*session*/, const std::string& typed) {
  auto order = read_piece_order(typed);
  if (auto* fault = std::get_if<std::string>(&order)) return std::move(*fault);
  return SetPieceOrder{std::get<0>(std::move(order))};
}

void add_pieces(EntryList& list) {
  list.add({"Name a piece of the pattern...", group::the_pattern, "By its letter in the cheapest order.",
            ActionPrompt{"Letter and name", "A=Tail", read_named_piece}, list.unless_open()});
  list.add({"Work the pieces in the order...", group::the_pattern, "By their letters in the cheapest order.",
            ActionPrompt{"Letters", "B,A,C", read_ordered_pieces}, list.unless_open()});
  const bool chosen = list.session.document && !list.session.document->pieces.order.empty();
  list.add({"Work the pieces in the cheapest order", group::the_pattern, "", SetPieceOrder{},
            chosen ? "" : "No other order was chosen."});
}

void add_pattern(EntryList& list) {
  list.add({"Set the pattern's title to...", group::the_pattern, "",
            ask_words("Title", "A ball for Ada", &knit::PatternOptions::title), "", "", true});
  list.add({"Set the pattern's yarn to...", group::the_pattern, "",
            ask_words("Yarn", "Merino DK", &knit::PatternOptions::yarn), "", "", true});
  list.add({"Set the yarn's colour to...", group::the_pattern, "",
            ask_words("Colour", "sea green", &knit::PatternOptions::colour), "", "", true});
  list.add({"Set the needle to...", group::the_pattern, "", ActionPrompt{"Needle, in mm", "4", read_needle},
            "", "", true});
  add_switch(list, "Markers at main lines: on or off", &knit::PatternOptions::markers);
  add_switch(list, "Repeats with stars: on or off", &knit::PatternOptions::stars);
  add_short_form(list);
  add_turns(list);
  list.add({"Knit along from round...", group::the_pattern, "One round at a time, large.",
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
  add_pieces(list);
  const std::size_t notices = list.session.outbox->notices.size();
  list.add({"Dismiss the newest notice", group::program, "", DismissNotice{notices > 0 ? notices - 1 : 0},
            notices > 0 ? "" : "There is no notice."});
  const bool noted = list.session.document && !list.session.document->place_note.empty();
  list.add({"Put away what is said of the place", group::program, "", PutNoteAway{},
            noted ? "" : "Nothing is said of the place."});
}

}  // namespace app
