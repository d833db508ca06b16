// The same words make the same run, whichever door they come through.
#include <algorithm>

#include "app/actions/apply_parts.h"
#include "app/actions/parameters_text.h"
#include "app/files/link.h"
#include "app/files/session_json.h"
#include "app/lessons/lesson.h"
#include "app/script/command_line.h"
#include "app/script/open_as_asked.h"
#include "app/session/sweep.h"
#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/samples.h"
#include "tests/support/session.h"

using namespace app;
using test_support::example_session;
using test_support::sample_of;

namespace {

Session opened_with(const std::vector<std::string>& words) {
  const auto parsed = parse_command_line(words, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  REQUIRE_FALSE(open_as_asked(session, std::get<CommandLine>(parsed)));
  REQUIRE(session.document);
  return session;
}

knit::Parameters by_option(const std::string& key, const std::string& value) {
  return opened_with({"--" + key + "=" + value}).document->timeline.parameters();
}

knit::Parameters by_knob(const knit::ParameterInfo& info, const std::string& value) {
  Session session = example_session("thesis-sphere");
  knit::Parameters parameters = session.document->timeline.parameters();
  REQUIRE_FALSE(knit::set_value(info, parameters, value));
  apply(session, Tune{parameters});
  return session.document->timeline.parameters();
}

knit::Parameters by_paste(const std::string& key, const std::string& value) {
  Session session = example_session("thesis-sphere");
  apply(session, PasteParameters{key + " = " + value});
  return session.document->timeline.parameters();
}

knit::Parameters by_lesson(const knit::ParameterInfo& info, const std::string& value) {
  Session session = example_session("thesis-sphere");
  do_deed(session, SetParameters{{{&info, value}}});
  return session.document->timeline.parameters();
}

std::optional<knit::Parameters> by_sweep(const knit::ParameterInfo& info, const std::string& value) {
  if (!can_be_swept(info)) return std::nullopt;
  const Session session = example_session("thesis-sphere");
  const double at = std::stod(value);
  const SweepPlan plan{{std::string(info.key), at, 2.0 * at, 2}, std::nullopt};
  const auto knobs = swept_knobs(sweep_base_of(session.document->timeline), plan, {at});
  REQUIRE(std::holds_alternative<Knobs>(knobs));
  return std::get<Knobs>(knobs).base;
}

std::size_t stitches_of(const knit::Parameters& parameters) {
  const Session session = example_session("thesis-sphere");
  knit::Timeline timeline(session.document->timeline.input_pointer(), parameters);
  timeline.extend_to_end();
  return timeline.furthest().fabric.stitch_count();
}

}  // namespace

TEST_CASE("doors: each parameter comes out the same by option, knob, paste, lesson and sweep") {
  std::size_t number = 0;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (!test_support::is_tried(number++)) continue;
    const std::string key(info.key);
    const std::string value = sample_of(info);
    CAPTURE(key, value);
    const knit::Parameters wanted = by_option(key, value);
    CHECK(knit::value_text(info, wanted) == value);
    CHECK(wanted != example_session("thesis-sphere").document->timeline.parameters());
    CHECK(by_knob(info, value) == wanted);
    CHECK(by_paste(key, value) == wanted);
    CHECK(by_lesson(info, value) == wanted);
    CHECK(by_sweep(info, value).value_or(wanted) == wanted);
  }
}

TEST_CASE("doors: each parameter comes back from a session file and from a link") {
  std::size_t number = 0;
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    if (!test_support::is_tried(number++)) continue;
    const Session session = opened_with({"--" + std::string(info.key) + "=" + sample_of(info)});
    const knit::Parameters& wanted = session.document->timeline.parameters();
    CAPTURE(info.key);
    const auto saved = read_saved(to_json(saved_of(session)).dump());
    REQUIRE(std::holds_alternative<SavedSession>(saved));
    CHECK(resolved(std::get<SavedSession>(saved).knobs, session.document->timeline.input()).base.stitch ==
          wanted.stitch);
    CHECK(resolved(std::get<SavedSession>(saved).knobs, session.document->timeline.input()).base.epsilon() ==
          wanted.epsilon());
    const auto link = link_by_options(session);
    REQUIRE(link);
    std::vector<std::string> words;
    for (std::size_t begin = link->find(' '); begin != std::string::npos;) {
      const std::size_t end = link->find(' ', begin + 1);
      words.push_back(link->substr(begin + 1, end == std::string::npos ? end : end - begin - 1));
      begin = end;
    }
    const Session again = opened_with(words);
    for (const knit::ParameterInfo& other : knit::parameter_table())
      CHECK(knit::same_value(other, again.document->timeline.parameters(), wanted));
  }
}

TEST_CASE("doors: a stitch width of 0.2 takes epsilon along, and makes 2091 stitches, by every door") {
  const knit::ParameterInfo& width = *knit::find_parameter("stitch-width");
  for (const knit::Parameters& parameters :
       {by_option("stitch-width", "0.2"), by_knob(width, "0.2"), by_paste("stitch-width", "0.2"),
        by_lesson(width, "0.2"), *by_sweep(width, "0.2")}) {
    CHECK(parameters.epsilon() == 0.1);
    CHECK(stitches_of(parameters) == 2091);
  }
}
