#include "app/script/figure_words.h"

#include <CLI/CLI.hpp>

#include "app/actions/hosting.h"
#include "app/actions/navigate.h"
#include "app/base/text.h"
#include "app/files/figures.h"
#include "app/session/document.h"
#include "knit/base/number_text.h"

namespace app {

namespace {

// What is about a picture or an animation needs one.
std::optional<std::string> fault_of_company(const FigureWords& words) {
  const bool any = !words.picture.empty() || !words.animation.empty();
  if (words.alone && !any) return "--alone is for --save-picture and --save-animation; give one of them too.";
  if (words.transparent && words.picture.empty())
    return "--transparent is for --save-picture; give that too.";
  if (words.transparent && !words.alone)
    return "--transparent needs --alone: panels have a background of their own.";
  const std::pair<const char*, const std::string*> only_animated[] = {
      {"--from", &words.from}, {"--to", &words.to}, {"--frames", &words.frames}, {"--fps", &words.rate}};
  for (const auto& [option, word] : only_animated) {
    if (!word->empty() && words.animation.empty())
      return std::string(option) + " is for --save-animation; give that too.";
  }
  return std::nullopt;
}

std::optional<std::string> read_place(const char* option, const std::string& word, At& at) {
  if (word.empty()) return std::nullopt;
  const auto place = parse_at(word);
  if (place) at = *place;
  if (place) return std::nullopt;
  return std::string(option) + " cannot be \"" + word +
         "\"; give end, a number of steps, or STAGE[:ROW[:ITEM]] with a stage of timing, cast-on, rows, "
         "stitches, faces, pattern.";
}

std::optional<std::string> read_animation(const FigureWords& words, bool size_given, CommandLine& line) {
  if (words.animation.empty()) return std::nullopt;
  SaveAnimation wish;
  wish.path = words.animation;
  wish.panels = !words.alone;
  if (size_given) {
    wish.width = line.width;
    wish.height = line.height;
  } else if (wish.panels) {
    wish.width = 1280;  // what panels are made for
    wish.height = 720;
  }
  if (!words.frames.empty()) {
    const auto frames = whole_number<int>(words.frames);
    if (!frames || *frames < 1 || *frames > most_frames)
      return "--frames cannot be \"" + words.frames + "\"; give a number from 1 to 9999.";
    wish.frames = *frames;
  }
  if (!words.rate.empty()) {
    const char* end = words.rate.data() + words.rate.size();
    const auto result = knit::number_from(words.rate.data(), end, wish.frames_per_second);
    const bool fits = wish.frames_per_second >= slowest_rate && wish.frames_per_second <= fastest_rate;
    if (result.ec != std::errc() || result.ptr != end || !fits)
      return "--fps cannot be \"" + words.rate + "\"; give a number from 0.5 to 50.";
  }
  if (auto trouble = read_place("--from", words.from, line.from)) return trouble;
  if (auto trouble = read_place("--to", words.to, line.to)) return trouble;
  if (auto fault = fault_of(wish)) return fault;
  line.animation = wish;
  return std::nullopt;
}

}  // namespace

void declare_figures(CLI::App& app, FigureWords& words) {
  const char* const group = "Figures";
  app.add_option("--save-picture", words.picture, "write a picture as PNG, of --size")->group(group);
  app.add_option("--save-animation", words.animation,
                 "write an animation: a name that ends in .gif or .png, or a folder for numbered PNG")
      ->group(group);
  app.add_flag("--alone", words.alone, "both without panels")->group(group);
  app.add_flag("--transparent", words.transparent, "the picture without a background; needs --alone")
      ->group(group);
  app.add_option("--from", words.from, "where the animation begins, as --at (0)")->group(group);
  app.add_option("--to", words.to, "where it ends, as --at (end)")->group(group);
  app.add_option("--frames", words.frames, "how many frames at most (120)")->group(group);
  app.add_option("--fps", words.rate, "frames a second, 0.5 to 50 (20)")->group(group);
}

std::optional<std::string> read_figures(const FigureWords& words, bool size_given, CommandLine& line) {
  if (auto fault = fault_of_company(words)) return fault;
  if (!words.picture.empty()) {
    const SavePicture wish{words.picture, line.width, line.height, !words.alone, words.transparent};
    if (auto fault = fault_of(wish)) return fault;
    line.picture = wish;
  }
  return read_animation(words, size_given, line);
}

AskedStretch asked_stretch(Session& session, const CommandLine& line) {
  AskedStretch asked;
  const std::size_t place = session.document->timeline.position();
  const auto position_of = [&](const At& at) {
    if (auto nearest = go_to(session, at)) asked.notes.push_back(std::move(*nearest));
    return session.document->timeline.position();
  };
  asked.stretch.begin = position_of(line.from);
  asked.stretch.end = position_of(line.to);
  show_position(session, place);
  return asked;
}

}  // namespace app
