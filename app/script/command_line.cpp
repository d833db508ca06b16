#include "app/script/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "app/base/text.h"
#include "app/checker/checker.h"
#include "app/files/export.h"
#include "app/files/pattern_export.h"
#include "app/files/session_file.h"
#include "app/lessons/lesson.h"
#include "app/script/figure_words.h"
#include "app/script/opening_words.h"
#include "app/script/pieces.h"
#include "app/script/queries.h"
#include "app/script/subcommands.h"
#include "app/script/yarn_words.h"
#include "app/session/pattern_pieces.h"
#include "app/session/presets.h"
#include "app/session/view.h"
#include "knit/base/number_text.h"
#include "knit/import/quoting.h"
#include "knit/model/stage.h"
#include "knit/pattern/limb_words.h"
#include "knit/trade/world_words.h"

namespace app {

namespace {

struct Words {
  std::string session, diff, why, select, point, go_to;
  std::vector<std::string> breaks, sweep;
  OpeningWords opening;
  std::string example, preset, at, side, list, row_columns, centre, positions, knit_along;
  std::vector<std::string> settings;  // beside the parameter table; empty: not given
  std::vector<std::string> saves;     // beside the table of exports; empty: not given
  std::string size;
  FigureWords figures;
  YarnWords yarn_drawn;
  std::string index_sizes, index_placement = "thesis", check_file;
  std::string check_line, check_size, check_gauge;
  bool check_window = false, check_json = false;
  std::string theme, scale;
  std::string lesson, lesson_page;
  std::string title, yarn, colour, needle;
  std::vector<std::string> piece_names;
  std::string piece_order;
  bool markers = false, stars = false;
  std::string pattern_form, turns, fit_size;
  std::vector<std::string> beside;  // PARAM=VALUE
  bool explain = false, ways_on = false, presenting = false, embedded = false, follow = false;
  bool headless = false, empty = false, list_examples = false, list_parameters = false, list_lessons = false,
       list_stitch_words = false;
};

std::string list_parameters_text() {
  std::string text;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    const std::string fallback =
        info.fallback.empty() ? knit::value_text(info, knit::Parameters{}) : std::string(info.fallback);
    text += "--" + std::string(info.key) + "\t" + knit::range_text(info);
    if (!info.unit.empty()) text += " (" + std::string(info.unit) + ")";
    text += "; default " + fallback + "\t" + std::string(info.help) + "\n";
  }
  return text;
}

std::string lessons_text(const std::filesystem::path& assets) {
  std::string text;
  for (const LessonEntry& entry : list_lessons(assets)) {
    const std::string key = entry.key.empty() ? "(" + entry.title + " cannot be read)" : entry.key;
    text += key + "\t" + (entry.key.empty() ? "" : entry.title + "\t") + entry.about + "\n";
  }
  return text;
}

// An option without a value, as from an empty variable of a script, is a mistake and no wish for the default.
void refuse_empty_values(CLI::App& app) {
  const auto given = [](const std::string& text) { return text.empty() ? "needs a value" : std::string(); };
  for (CLI::Option* option : app.get_options()) option->check(given);
}

void declare_saves(CLI::App& app, std::vector<std::string>& saves) {
  const auto table = exports();
  saves.resize(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::string help(table[i].help);
    if (!table[i].endings.words.empty()) help.append("; a name that ends in ").append(table[i].endings.words);
    app.add_option(option_of(table[i]), saves[i], help);
  }
}

// What is opened, with which settings.
void declare_opening(CLI::App& app, Words& words) {
  app.add_option("MESH", words.opening.mesh, "Wavefront OBJ file to open");
  app.add_option("--example", words.example, "open an example instead (see --list-examples)");
  app.add_option("--session", words.session, "open a saved session instead");
  app.add_flag("--empty", words.empty, "open nothing: the window says how to begin");
  declare_opening_words(app, words.opening);
  app.add_option("--preset", words.preset, "settings for a purpose: " + preset_keys());
  app.add_option("--fit-size", words.fit_size,
                 "on: make the piece up to 4 % larger or smaller where its rhythm reads better then");
  const auto table = knit::parameter_table();
  words.settings.resize(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    app.add_option("--" + std::string(table[i].key), words.settings[i], std::string(table[i].help))
        ->group("Parameters")
        ->allow_extra_args(false);
  }
}

// How long the run is, and how it is looked at.
void declare_looking(CLI::App& app, Words& words) {
  app.add_flag("--headless", words.headless, "no window: run, write what is asked, exit");
  app.add_option("--at", words.at, "where to stop: end, a number of steps, or STAGE[:ROW[:ITEM]]");
  app.add_option(
      "--go-to", words.go_to,
      "go to what is named, from there, and say what is there: \"row 7\", \"widest round\", \"why row 7\"");
  app.add_option("--side", words.side, "what the right column shows: " + one_of(side_keys));
  app.add_option("--list", words.list, "which list stands below the step: " + one_of(list_keys));
  app.add_option("--row-columns", words.row_columns,
                 "what the list of rows says of each, as A,B: " + one_of(row_column_keys) + "; or none");
  app.add_option("--centre", words.centre, "what the centre shows: view, chart, or chart:B, of a piece");
  app.add_option("--positions", words.positions,
                 "where stitches that have settled or relaxed are shown, measured and written: " +
                     one_of(positions_keys));
  declare_yarn(app, words.yarn_drawn);
  app.add_flag("--present", words.presenting,
               "for a class: the view, the step's sentence in large words, a thin timeline");
  app.add_flag("--embed", words.embedded,
               "without menus, for a page around it; in a browser the wheel is that page's until a click");
  app.add_option("--beside", words.beside,
                 "show another run left of this one, at the same place: of PARAM=VALUE")
      ->allow_extra_args(false);
  app.add_option("--theme", words.theme, "dark or light");
  app.add_option("--scale", words.scale, "size of words and lines, 0.75 to 2.5; 1.5 for a projector");
  app.add_option("--lesson", words.lesson, "begin a lesson: its key (see --list-lessons), or a file of one");
  app.add_option("--lesson-page", words.lesson_page, "the lesson's page to begin with, from 1");
  app.add_option("--knit-along", words.knit_along,
                 "knit along, beginning with this round, or 12.1: the first short row on round 12");
  app.add_flag("--follow", words.follow, "turn the view to what happens when that is behind the surface");
}

// What is asked about the run.
void declare_asking(CLI::App& app, Words& words) {
  app.add_option("--break", words.breaks, "stop where this holds; may be given more than once")
      ->allow_extra_args(false);
  app.add_option("--why", words.why,
                 "say which step made stitch:ROW:ITEM or refused vertex:ID, or why row:ROW has its count");
  app.add_flag("--ways-on", words.ways_on,
               "of a run that stopped: try what else knits the mesh, and say what does");
  app.add_option("--select", words.select,
                 "light stitch:ROW:ITEM, or all wale:FROM:TO, in the view, which turns to it");
  app.add_flag("--explain", words.explain,
               "print the pseudo-code with the line that just ran, and the values");
  app.add_option("--point", words.point, "light this variable of the pseudo-code in the view");
  app.add_option("--sweep", words.sweep, "run for PARAM=FROM:TO:N and write a table as CSV; twice: a grid")
      ->allow_extra_args(false);
  app.add_option("--diff", words.diff, "say what differs from the run of another session file");
}

// What a person says about the written pattern.
void declare_pattern(CLI::App& app, Words& words) {
  app.add_option("--title", words.title, "the pattern's title")->group("Pattern");
  app.add_option("--yarn", words.yarn, "the yarn's name, for the pattern")->group("Pattern");
  app.add_option("--colour", words.colour, "the yarn's colour, for the pattern")->group("Pattern");
  app.add_option("--needle-mm", words.needle, "the needle, for the pattern; else the usual one")
      ->group("Pattern");
  app.add_flag("--markers", words.markers, "the pattern puts markers at main stitches")->group("Pattern");
  app.add_option("--turns", words.turns,
                 "short rows turn in German short rows (german) or by wrap and turn (wrap)")
      ->group("Pattern")
      ->type_name("HOW");
  app.add_flag("--stars", words.stars, "the pattern writes repeats as *...; rep from *")->group("Pattern");
  app.add_option(
         "--pattern-form", words.pattern_form,
         "full, or short: named rounds and [Knit 2 rnds, inc rnd] 3 times, where that says the same; without "
         "it, short where counts are in a rhythm")
      ->group("Pattern");
  app.add_option("--piece-name", words.piece_names, "what a piece of the pattern is called: A=Tail")
      ->group("Pattern")
      ->allow_extra_args(false);
  app.add_option("--piece-order", words.piece_order,
                 "the order in which pieces are worked, by their letters in the cheapest one: B,A,C")
      ->group("Pattern");
}

// In the order of --help.
void declare(CLI::App& app, Words& words) {
  app.set_version_flag("--version", "knit-mesh " KNIT_MESH_VERSION);
  declare_opening(app, words);
  declare_looking(app, words);
  declare_asking(app, words);
  declare_saves(app, words.saves);
  declare_pattern(app, words);
  declare_figures(app, words.figures);
  app.add_option("--size", words.size, "size of the picture or window, WIDTHxHEIGHT (1440x900)");
  app.add_flag("--list-examples", words.list_examples, "list the examples");
  app.add_flag("--list-lessons", words.list_lessons, "list the lessons");
  app.add_flag("--list-stitch-words", words.list_stitch_words,
               "list the stitch words that check knows, with what each takes and makes");
  app.add_flag("--list-parameters", words.list_parameters,
               "list the parameters with range, unit and default");
  CLI::App* index = app.add_subcommand("index", "print the label arrays for a list of row sizes, one a line");
  index->add_option("SIZES", words.index_sizes, "row sizes, the cast on first: 6,12,17,22")->required();
  index->add_option("--placement", words.index_placement, placements_of_index());
  refuse_empty_values(app);
  refuse_empty_values(*index);
  CLI::App* check = app.add_subcommand("check", "read a written pattern and say where it does not add up");
  check->add_option("FILE", words.check_file, "text, Markdown, HTML or JSON (\"-\": standard input)")
      ->required();
  check->add_flag("--window", words.check_window,
                  "show it in the window, to be gone through and mended there");
  check->add_option("--save-picture", words.figures.picture, "save a picture of it, with its shape, as PNG");
  check->add_flag("--alone", words.figures.alone, "the picture is of the shape alone");
  check->add_option("--size", words.size, "size of the picture or window, WIDTHxHEIGHT (1440x900)");
  check->add_option("--line", words.check_line, "the line to begin with, from 1: its round is lit");
  check->add_option("--of-size", words.check_size, "the pattern's size that is shown, by its name or number");
  check->add_option("--gauge", words.check_gauge, "stitches x rows on 10 cm, for the shape (22x32)");
  check->add_option("--theme", words.theme, "dark or light");
  check->add_option("--scale", words.scale, "size of words and lines, 0.75 to 2.5");
  check->add_flag("--json", words.check_json, "print every line's verdict as JSON, for editors");
  refuse_empty_values(*check);
}

bool parse_size(const std::string& text, int& width, int& height) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return false;
  const auto number = [](std::string_view part, int& value) {
    const auto result = knit::number_from(part.data(), part.data() + part.size(), value);
    return result.ec == std::errc() && result.ptr == part.data() + part.size() && value >= 64 &&
           value <= 16384;
  };
  return number(std::string_view(text).substr(0, cross), width) &&
         number(std::string_view(text).substr(cross + 1), height);
}

std::optional<std::string> read_saves(const Words& words, CommandLine& line) {
  for (std::size_t i = 0; i < words.saves.size(); ++i) {
    const std::string& path = words.saves[i];
    if (path.empty()) continue;
    const ExportInfo& info = exports()[i];
    if (auto fault = fault_of_ending(info, path, option_of(info) + " cannot be \"" + path + "\""))
      return fault;
    line.saves.push_back({std::string(info.key), path});
  }
  return std::nullopt;
}

// Stitch sizes may be given in one view only, unless --sizes says which one counts.
std::optional<std::string> clash_of_sizes(const CommandLine& line) {
  const auto clash = knit::clash_of_views(line.settings);
  if (!clash) return std::nullopt;
  return "--" + std::string(clash->gauge->key) + " and --" + std::string(clash->mesh->key) +
         " both give the stitch size; give one of them, or --sizes mesh or gauge to say which counts.";
}

// The index of a word among those that an option takes; a sentence where it is none of them.
std::optional<std::string> choose(const std::string& option, const std::string& word,
                                  std::span<const std::string_view> names, std::size_t& index) {
  const auto name = std::find(names.begin(), names.end(), word);
  index = static_cast<std::size_t>(name - names.begin());
  if (name != names.end()) return std::nullopt;
  return option + " cannot be \"" + word + "\"; give " + one_of(names) + ".";
}

std::optional<std::string> read_side(const Words& words, CommandLine& line) {
  std::size_t index = 0;
  if (!words.list.empty()) {
    if (auto trouble = choose("--list", words.list, list_keys, index)) return trouble;
    line.list = static_cast<RunList>(index);
  }
  if (words.side.empty()) return std::nullopt;
  if (auto trouble = choose("--side", words.side, side_keys, index)) return trouble;
  line.side = static_cast<SidePanel>(index);
  line.side_given = true;
  return std::nullopt;
}

std::optional<std::string> read_row_columns(const Words& words, CommandLine& line) {
  if (words.row_columns.empty()) return std::nullopt;
  decltype(Preferences::row_columns) shown{};
  if (words.row_columns != "none") {
    for (const std::string_view word : split(words.row_columns, ',')) {
      std::size_t index = 0;
      if (auto trouble = choose("--row-columns", std::string(word), row_column_keys, index)) return trouble;
      shown.at(index) = true;
    }
  }
  line.row_columns = shown;
  return std::nullopt;
}

std::optional<std::string> read_look(const Words& words, CommandLine& line) {
  if (!words.theme.empty()) {
    std::size_t index = 0;
    if (auto trouble = choose("--theme", words.theme, theme_keys, index)) return trouble;
    line.theme = static_cast<ThemeKind>(index);
  }
  if (!words.positions.empty()) {
    std::size_t index = 0;
    if (auto trouble = choose("--positions", words.positions, positions_keys, index)) return trouble;
    line.positions = static_cast<Positions>(index);
  }
  if (words.scale.empty()) return std::nullopt;
  double scale = 0.0;
  const char* end = words.scale.data() + words.scale.size();
  const auto result = knit::number_from(words.scale.data(), end, scale);
  if (result.ec != std::errc() || result.ptr != end || !(scale >= smallest_scale && scale <= largest_scale))
    return "--scale cannot be \"" + words.scale + "\"; give a number from 0.75 to 2.5.";
  line.scale = scale;
  return std::nullopt;
}

std::optional<std::string> read_queries(const Words& words, CommandLine& line) {
  if (!words.session.empty() && (!words.opening.mesh.empty() || !words.example.empty()))
    return "give either a session or a mesh, not both.";
  line.session = words.session;
  if (!words.opening.mesh.empty() && is_session_file(words.opening.mesh)) line.session = words.opening.mesh;
  line.breaks = words.breaks;
  line.sweep = words.sweep;
  line.diff = words.diff;
  line.why = words.why;
  line.ways_on = words.ways_on;
  line.go_to = words.go_to;
  line.select = words.select;
  line.explain = words.explain;
  line.follow = words.follow;
  if (!words.fit_size.empty() && words.fit_size != "on" && words.fit_size != "off")
    return "--fit-size cannot be " + knit::quoted(words.fit_size) + "; give on or off.";
  line.fit_size = words.fit_size == "on";
  line.point = words.point;
  for (const std::string& text : line.breaks) {
    if (auto fault = fault_of_break(text)) return fault;
  }
  if (auto fault = fault_of_sweep(line.sweep)) return fault;
  if (auto fault = fault_of_point(line.point)) return fault;
  if (auto fault = fault_of_go_to(line.go_to)) return fault;
  if (auto fault = fault_of_select(line.select)) return fault;
  return line.why.empty() ? std::nullopt : fault_of_why(line.why);
}

std::optional<std::string> read_centre(const Words& words, CommandLine& line) {
  constexpr std::string_view of_piece = "chart:";
  std::string centre = words.centre;
  if (centre.starts_with(of_piece) && is_piece_letter(std::string_view(centre).substr(of_piece.size()))) {
    line.chart_piece = centre.substr(of_piece.size());
    centre = "chart";
  }
  if (!centre.empty() && centre != "view" && centre != "chart")
    return "--centre cannot be \"" + words.centre + "\"; give view, chart, or chart:B for that of a piece.";
  line.centre = centre == "chart" ? CentrePanel::chart : CentrePanel::view;
  line.centre_given = !words.centre.empty();
  if (words.knit_along.empty()) return std::nullopt;
  line.knit_along = read_round(words.knit_along);
  if (!line.knit_along)
    return "--knit-along cannot be \"" + words.knit_along +
           "\"; give a round from 1, or 12.1 for the first short row on round 12.";
  return std::nullopt;
}

std::optional<std::string> read_lesson_words(const Words& words, CommandLine& line) {
  line.lesson = words.lesson;
  if (words.lesson_page.empty()) return std::nullopt;
  line.lesson_page = whole_number<std::int32_t>(words.lesson_page);
  if (!line.lesson_page || *line.lesson_page < 1)
    return "--lesson-page cannot be \"" + words.lesson_page + "\"; give a page from 1.";
  if (words.lesson.empty()) return "--lesson-page needs a lesson; give --lesson too.";
  return std::nullopt;
}

// "A=Tail"
std::optional<std::string> read_piece_names(const Words& words, CommandLine& line) {
  for (const std::string& given : words.piece_names) {
    const std::size_t sign = given.find('=');
    const std::string letters = given.substr(0, sign);
    const std::string word = sign == std::string::npos ? "" : given.substr(sign + 1);
    const bool known = !letters.empty() && letters.size() <= 2 &&
                       letters.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
    if (!known || !knit::is_piece_word(word))
      return "--piece-name cannot be \"" + given +
             "\"; give a piece's letter and one capitalised word: A=Tail.";
    line.pattern.piece_names[letters] = word;
  }
  return std::nullopt;
}

// "B,A,C"
std::optional<std::string> read_order_words(const Words& words, CommandLine& line) {
  if (words.piece_order.empty()) return std::nullopt;
  auto order = read_piece_order(words.piece_order);
  if (auto* fault = std::get_if<std::string>(&order))
    return "--piece-order cannot be \"" + words.piece_order + "\": " + *fault;
  line.piece_order = std::get<0>(std::move(order));
  return std::nullopt;
}

// The pattern's own words; a sentence where one cannot be.
std::optional<std::string> read_pattern_words(const Words& words, CommandLine& line) {
  line.pattern = {words.title, words.yarn, words.colour, std::nullopt, words.markers, words.stars, {}, {}};
  if (!words.pattern_form.empty() && words.pattern_form != "short" && words.pattern_form != "full")
    return "--pattern-form cannot be " + knit::quoted(words.pattern_form) + "; give short or full.";
  if (!words.turns.empty() && words.turns != "german" && words.turns != "wrap")
    return "--turns cannot be " + knit::quoted(words.turns) + "; give german or wrap.";
  if (!words.turns.empty())
    line.pattern.turns = words.turns == "wrap" ? knit::ShortRowTurns::wrap : knit::ShortRowTurns::german;
  if (!words.pattern_form.empty())
    line.pattern.form =
        words.pattern_form == "short" ? knit::PatternForm::short_form : knit::PatternForm::full;
  if (auto fault = read_piece_names(words, line)) return fault;
  if (auto fault = read_order_words(words, line)) return fault;
  if (words.needle.empty()) return std::nullopt;
  line.pattern.needle_mm = needle_mm_of(words.needle);
  if (!line.pattern.needle_mm)
    return "--needle-mm cannot be \"" + words.needle + "\"; give " + needle_range + ".";
  return std::nullopt;
}

// With nothing open there is nothing to set, to ask or to save; a picture of the window can be taken.
// No mesh is opened for it. Without --window its picture is all that is wanted.
std::optional<std::string> read_check(const Words& words, CommandLine& line) {
  if (words.check_file.empty()) return std::nullopt;
  line.checked = words.check_file;
  line.empty = true;
  line.headless = !words.check_window;
  line.checked_size = words.check_size;
  if (!words.check_line.empty()) {
    const auto number = whole_number<std::size_t>(words.check_line);
    if (!number || *number < 1)
      return "check: --line cannot be \"" + words.check_line + "\"; lines count from 1.";
    line.checked_line = *number;
  }
  if (words.check_gauge.empty()) return std::nullopt;
  const auto gauge = checked_gauge(words.check_gauge);
  if (!gauge)
    return "check: --gauge cannot be \"" + words.check_gauge +
           "\"; give stitches x rows on 10 cm, like 22x32, each from 1 to 200.";
  line.checked_gauge = SetCheckedGauge{gauge->stitches, gauge->rows};
  return std::nullopt;
}

std::optional<std::string> fault_of_empty(const CommandLine& line, bool opens) {
  const bool asks = !line.breaks.empty() || !line.sweep.empty() || !line.diff.empty() || !line.why.empty() ||
                    !line.go_to.empty() || !line.select.empty() || line.explain || line.ways_on || line.at ||
                    line.knit_along;
  const bool sets = !line.settings.empty() || !line.preset.empty() || line.fit_size || !line.curves.none();
  const bool saves = (line.picture && line.checked.empty()) || line.animation ||
                     std::any_of(line.saves.begin(), line.saves.end(),
                                 [](const Export& wish) { return find_export(wish.what)->write != nullptr; });
  const bool needs = opens || !line.session.empty() || !line.lesson.empty() || asks || sets || saves;
  if (!line.empty || !needs) return std::nullopt;
  return "--empty opens nothing, so there is no mesh for the other options; leave it out.";
}

std::optional<std::string> read_beside(const Words& words, CommandLine& line) {
  knit::Parameters scratch;
  for (const std::string& given : words.beside) {
    const std::size_t equals = std::min(given.find('='), given.size());
    const knit::ParameterInfo* info = knit::find_parameter(given.substr(0, equals));
    if (info == nullptr || equals == given.size())
      return "--beside cannot be \"" + given + "\"; give PARAM=VALUE with a parameter of --list-parameters.";
    const std::string value = given.substr(equals + 1);
    if (auto error = knit::set_value(*info, scratch, value)) return "--beside: " + *error;
    line.beside.emplace_back(info, value);
  }
  return std::nullopt;
}

std::variant<CommandLine, Answer> understand(Words words) {
  CommandLine line;
  if (const auto trouble = read_curve_words(words.opening, words.settings, line)) return bad_usage(*trouble);
  if (!words.opening.mesh.empty() && !words.example.empty()) {
    return bad_usage("give either a mesh or --example, not both.");
  }
  if (!words.opening.mesh.empty()) line.open = OpenFile{words.opening.mesh};
  if (!words.example.empty()) line.open = OpenExample{words.example};
  knit::Parameters scratch;
  for (std::size_t i = 0; i < words.settings.size(); ++i) {
    if (words.settings[i].empty()) continue;
    const knit::ParameterInfo& info = knit::parameter_table()[i];
    if (const auto error = knit::set_value(info, scratch, words.settings[i])) return bad_usage(*error);
    line.settings.emplace_back(&info, words.settings[i]);
  }
  if (const auto clash = clash_of_sizes(line)) return bad_usage(*clash);
  if (const auto trouble = read_saves(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_pattern_words(words, line)) return bad_usage(*trouble);
  line.preset = words.preset;
  if (!words.preset.empty() && find_preset(words.preset) == nullptr) {
    return bad_usage("--preset cannot be \"" + words.preset + "\"; give " + preset_keys() + ".");
  }
  if (!words.at.empty()) {
    line.at = parse_at(words.at);
    if (!line.at) {
      return bad_usage(
          "--at cannot be \"" + words.at +
          "\"; give end, a number of steps, or STAGE[:ROW[:ITEM]] with a stage of timing, cast-on, rows, "
          "stitches, faces, pattern; rows and items count from 1.");
    }
  }
  if (const auto trouble = read_side(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_row_columns(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_look(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_queries(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_opening_words(words.opening, words.headless, line))
    return bad_usage(*trouble);
  if (const auto trouble = read_centre(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_yarn_words(words.yarn_drawn, line.yarn)) return bad_usage(*trouble);
  if (const auto trouble = read_beside(words, line)) return bad_usage(*trouble);
  if (const auto trouble = read_lesson_words(words, line)) return bad_usage(*trouble);
  if (!words.size.empty() && !parse_size(words.size, line.width, line.height)) {
    return bad_usage("--size cannot be \"" + words.size + "\"; give WIDTHxHEIGHT, each from 64 to 16384.");
  }
  if (const auto trouble = read_figures(words.figures, !words.size.empty(), line)) return bad_usage(*trouble);
  line.headless = words.headless;
  line.presenting = words.presenting;
  line.embedded = words.embedded;
  line.empty = words.empty;
  if (const auto trouble = read_check(words, line)) return bad_usage(*trouble);
  if (const auto trouble = fault_of_empty(line, !words.opening.mesh.empty() || !words.example.empty()))
    return bad_usage(*trouble);
  return line;
}

}  // namespace

std::variant<CommandLine, Answer> parse_command_line(const std::vector<std::string>& arguments,
                                                     const std::filesystem::path& assets) {
  Words words;
  CLI::App app("knit-mesh: how a 3D mesh becomes something to knit by hand, step by step.", "knit-mesh");
  declare(app, words);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForVersion& version) {
    return Answer{exit_done, std::string(version.what()) + "\n", ""};
  } catch (const CLI::CallForHelp&) {
    return Answer{exit_done, app.help(), ""};
  } catch (const CLI::ParseError& error) {
    return bad_usage(std::string(error.what()) + "; see knit-mesh --help.");
  }
  if (!words.index_sizes.empty()) return index_answer(words.index_sizes, words.index_placement);
  if (!words.check_file.empty() && !words.check_window && words.figures.picture.empty())
    return check_file(words.check_file, words.check_json ? CheckForm::json : CheckForm::lines);
  if (words.list_stitch_words) return Answer{exit_done, knit::trade_words_table(), ""};
  if (words.list_parameters) return Answer{exit_done, list_parameters_text(), ""};
  if (words.list_lessons) return Answer{exit_done, lessons_text(assets), ""};
  if (words.list_examples) {
    std::string names;
    for (const std::string& name : list_examples(assets)) names += name + "\n";
    return Answer{exit_done, names, ""};
  }
  return understand(std::move(words));
}

std::string_view program_version() { return KNIT_MESH_VERSION; }

}  // namespace app
