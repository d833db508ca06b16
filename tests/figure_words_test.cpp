// The command line's part about pictures and animations.
#include "app/script/figure_words.h"
#include "app/session/document.h"

#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

using Strings = std::vector<std::string>;

CommandLine line_of(const Strings& arguments) {
  const auto parsed = parse_command_line(arguments, KNIT_ASSETS_DIR);
  if (const auto* answer = std::get_if<Answer>(&parsed)) FAIL(answer->error);
  return std::get<CommandLine>(parsed);
}

std::string error_of(const Strings& arguments) {
  const auto parsed = parse_command_line(arguments, KNIT_ASSETS_DIR);
  CAPTURE(arguments);
  REQUIRE(std::holds_alternative<Answer>(parsed));
  CHECK(std::get<Answer>(parsed).exit_code == exit_usage);
  return std::get<Answer>(parsed).error;
}

}  // namespace

TEST_CASE("the command line asks for a picture and an animation") {
  const CommandLine plain = line_of({});
  CHECK_FALSE(plain.picture);
  CHECK_FALSE(plain.animation);
  const CommandLine line =
      line_of({"--save-picture", "p.png", "--alone", "--transparent", "--size", "300x200", "--save-animation",
               "a.gif", "--from", "rows:2", "--to", "500", "--frames", "30", "--fps", "12.5"});
  REQUIRE(line.picture);
  CHECK(line.picture->path == "p.png");
  CHECK(line.picture->width == 300);
  CHECK(line.picture->height == 200);
  CHECK_FALSE(line.picture->panels);
  CHECK(line.picture->transparent);
  REQUIRE(line.animation);
  CHECK(line.animation->frames == 30);
  CHECK(line.animation->frames_per_second == 12.5);
  CHECK(line.animation->width == 300);
  CHECK_FALSE(line.animation->panels);
  CHECK(std::get<knit::Place>(line.from) == knit::Place{knit::Stage::rows, 2, 0});
  CHECK(std::get<std::size_t>(line.to) == 500);
  CHECK(line_of({"--save-picture", "p.png"}).picture->panels);
  CHECK(line_of({"--save-gltf", "m.glb"}).saves.at(0).what == "gltf");
  CHECK(line_of({"--save-plots", "p.csv"}).saves.at(0).what == "plots");
}

TEST_CASE("what is wrong about figures on the command line is said in a sentence") {
  for (const Strings& arguments :
       {Strings{"--save-picture", "p.jpg"}, Strings{"--alone"},
        Strings{"--transparent", "--save-picture", "p.png"},
        Strings{"--transparent", "--alone", "--save-animation", "a.gif"}, Strings{"--frames", "3"},
        Strings{"--from", "3"}, Strings{"--save-animation", "a.mov"},
        Strings{"--save-animation", "a.gif", "--frames", "0"},
        Strings{"--save-animation", "a.gif", "--fps", "60"},
        Strings{"--save-animation", "a.gif", "--fps", "ten"},
        Strings{"--save-animation", "a.gif", "--to", "moon"}, Strings{"--save-gltf", "m.obj"},
        Strings{"--save-plots", "p.png"}}) {
    const std::string error = error_of(arguments);
    CAPTURE(error);
    CHECK(test_support::is_one_sentence(error));
  }
  CHECK(test_support::contains(error_of({"--save-animation", "a.gif", "--to", "moon"}), "--to"));
}

TEST_CASE("from and to are places of the run, and looking them up moves nothing") {
  Session session = test_support::finished_small_session();
  session.document->timeline.seek(77);
  const AskedStretch whole = asked_stretch(session, line_of({}));
  CHECK(whole.stretch == Stretch{0, session.document->timeline.known()});
  CHECK(whole.notes.empty());
  CHECK(session.document->timeline.position() == 77);
  const CommandLine some = line_of({"--save-animation", "a.gif", "--from", "rows:3", "--to", "99999999"});
  const AskedStretch asked = asked_stretch(session, some);
  session.document->timeline.seek(asked.stretch.begin);
  CHECK(session.document->timeline.place() == knit::Place{knit::Stage::rows, 3, 0});
  CHECK(asked.stretch.end == session.document->timeline.known());
  CHECK(asked.notes.size() == 1);
}
