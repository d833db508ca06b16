// Presenting to a class: what is left of the window, how large words are broken, which keys step; two runs side by side
// at the same place.
#include "app/panels/timeline/present.h"

#include <imgui.h>

#include <cfloat>
#include <cmath>

#include "app/actions/pinned_session.h"
#include "app/compare/beside_words.h"
#include "app/panels/kit/large_lines.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "tests/support/desk.h"

namespace {

using namespace desk;

void lay_out_again(Desk& desk, float width, float height, float scale) {
  desk.layout = layout_of(width, height, scale, layout_wish(desk.session));
  desk.settle();
}

std::string joined(const std::vector<std::string>& lines) {
  std::string words;
  for (const std::string& line : lines) words += (words.empty() ? "" : " ") + line;
  return words;
}

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

knit::Parameters wider_band() {
  knit::Parameters parameters = wide_band();
  knit::give_width(parameters, 0.5);
  return parameters;
}

}  // namespace

TEST_CASE("F5 leaves the view, the caption and a thin timeline, and F5 and Esc bring the panels back") {
  Desk desk(1280, 720, 2);
  desk.open();
  desk.act({Action(only<Present>(desk.press({Key::F5, {}, 0})))});
  REQUIRE(desk.session.view->presenting);
  lay_out_again(desk, 1280, 720, 2);
  for (const char* there : {"view", "caption", "track"}) CHECK(desk.ui.controls.count(there) == 1);
  for (const char* gone : {"play", "menu/file", "side/report", "knob/epsilon"})
    CHECK(desk.ui.controls.count(gone) == 0);
  CHECK_FALSE(only<Present>(desk.press({Key::F5, {}, 0})).on);
  desk.act(desk.press({Key::Escape, {}, 0}));
  CHECK_FALSE(desk.session.view->presenting);
}

TEST_CASE("page keys step, and a press on the thin timeline goes there") {
  Desk desk(1280, 720, 2);
  desk.open();
  CHECK(only<StepBy>(desk.press({Key::PageDown, {}, 0})).direction == 1);
  CHECK(only<StepBy>(desk.press({Key::PageUp, {}, 0})).direction == -1);
  apply(desk.session, Present{});
  lay_out_again(desk, 1280, 720, 2);
  CHECK(count_of<SeekTo>(desk.click("track", 0.9f)) > 0);
}

TEST_CASE("while presenting a ring follows the pointer, unless it is put away") {
  Desk desk(1280, 720, 2);
  desk.open();
  const auto ring = [&](float x, float y) {
    desk.frame({MouseMove{x, y}});
    desk.frame();
    const ImVector<ImDrawVert>& drawn = ImGui::GetForegroundDrawList()->VtxBuffer;
    return drawn.Size > 0 && std::abs(drawn[0].pos.x - x) < 100.0f && std::abs(drawn[0].pos.y - y) < 100.0f;
  };
  CHECK_FALSE(ring(300.0f, 200.0f));
  apply(desk.session, Present{});
  lay_out_again(desk, 1280, 720, 2);
  CHECK(ring(300.0f, 200.0f));
  CHECK(ring(700.0f, 300.0f));
  desk.session.view->ring = false;
  CHECK_FALSE(ring(300.0f, 200.0f));
}

TEST_CASE("presenting, boxes do not overlap and fill the window, with a lesson and with two halves") {
  for (const auto& [width, height] :
       {std::pair{1280.0f, 720.0f}, {1920.0f, 1080.0f}, {3840.0f, 2160.0f}, {700.0f, 1000.0f}}) {
    for (const float lesson : {0.0f, lesson_height}) {
      for (const bool both : {false, true}) {
        LayoutWish wish;
        wish.lesson = lesson;
        wish.presenting = true;
        wish.both = both;
        const Layout layout = layout_of(width, height, presenting_scale(width, height, 1.0f), wish);
        const std::array boxes{layout.view, layout.other_view, layout.caption, layout.timeline,
                               layout.lesson};
        float area = 0.0f;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          area += boxes[i].width * boxes[i].height;
          for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(boxes[i], boxes[j]));
        }
        CHECK(area > 0.98f * width * height);
        CHECK(area <= width * height);
        CHECK(layout.other_view.width == (both ? layout.view.width : 0.0f));
      }
    }
  }
}

TEST_CASE("large lines have at most 40 letters, are about equally long and lose no word") {
  CHECK(even_lines("one two three", 40) == std::vector<std::string>{"one two three"});
  CHECK(even_lines("aaaa bbbb cccc dddd", 14) == std::vector<std::string>{"aaaa bbbb", "cccc dddd"});
  CHECK(even_lines("\xCE\xB5\xCE\xB5 \xCE\xB5\xCE\xB5", 5).size() == 1);  // letters, not bytes
  Session session;
  session.document = Document(small_run(wide_band()));
  session.document->timeline.extend_to_end();
  for (std::size_t at = 0; at <= session.document->timeline.known(); ++at) {
    session.document->timeline.seek(at);
    const std::string words = sentence(session);
    const auto lines = even_lines(words, longest_large_line);
    CHECK(joined(lines) == words);
    for (const std::string& line : lines) {
      CHECK(line.size() <= longest_large_line + 8);  // bytes: some letters have two or three
      if (lines.size() > 1) CHECK(line.size() >= shortest_large_line - 8);
    }
  }
}

TEST_CASE("large words fit into the caption at 1280 x 720, and 20 letters a line do too") {
  ImGuiGlue glue;
  const Fonts fonts = glue.load_fonts("", 2.0f, style::text_size);
  glue.begin_frame({1280, 720, 1, 1, 1.0f / 60.0f}, {});
  std::string words = "Row 12 takes vertex 1204 as its stitch";
  for (int i = 0; i < 9; ++i) {
    const LargeWords large = large_words(fonts.heading, words, 40.0f, 1180.0f, 150.0f);
    CHECK(joined(large.lines) == words);
    CHECK(static_cast<float>(large.lines.size()) * large_line_height * large.size <= 150.0f);
    for (const std::string& line : large.lines)
      CHECK(fonts.heading->CalcTextSizeA(large.size, FLT_MAX, 0.0f, line.c_str()).x <= 1180.0f);
    words += " and then goes on to another one there";
  }
  glue.end_frame();
}

TEST_CASE("row and count: so far in a row, whole after it, and the stage before there are rows") {
  knit::Timeline timeline = small_run(wide_band());
  CHECK(row_and_count(timeline) == "Timing");
  timeline.extend_to_end();
  timeline.seek(timeline.position_of({knit::Stage::stitches, 2, 0}));
  const std::string all = std::to_string(timeline.furthest().fabric.row_count());
  const std::string count = std::to_string(timeline.furthest().fabric.row(2).stitches.size());
  CHECK(row_and_count(timeline) == "Row 2 of " + all + ": " + count + " stitches");
  std::size_t in_progress = 0;
  for (std::size_t at = 1; at <= timeline.known(); ++at) {
    timeline.seek(at);
    const knit::Place place = timeline.place();
    const bool so_far = row_and_count(timeline).find(" so far") != std::string::npos;
    if (so_far) CHECK((place.stage == knit::Stage::rows || place.stage == knit::Stage::cast_on));
    in_progress += so_far ? 1 : 0;
  }
  CHECK(in_progress > 10);
}

TEST_CASE("both runs are seen at the same place, and what differs is named") {
  Session session;
  session.document = Document(small_run(wide_band()));
  apply(session, ShowBoth{});
  CHECK_FALSE(session.view->both);
  CHECK(session.outbox->notices.size() == 1);
  apply(session, PinRun{});
  apply(session, Tune{wider_band()});
  session.document->timeline.extend_to_end();
  apply(session, ShowBoth{});
  REQUIRE(session.view->both);
  PinnedSession pinned;
  const knit::Timeline& here = session.document->timeline;
  for (const std::size_t at : {std::size_t{0}, here.known() / 3, here.known() / 2, here.known()}) {
    session.document->timeline.seek(at);
    const Session* there = pinned.refresh(session);
    REQUIRE(there != nullptr);
    const knit::Timeline& other = there->document->timeline;
    CHECK(knobs_of(other) == session.document->pinned->knobs);
    if (at == 0) CHECK(other.position() == 0);
    if (at == here.known()) CHECK(other.state() == session.document->pinned->end);
    if (at > 0 && at < here.known()) CHECK(other.position() == other.position_of(here.place()));
  }
  const BesideWords words = beside_words(session);
  CHECK(words.pinned == "Stitch width w 0.45");
  CHECK(words.here == "Stitch width w 0.5");
  knit::Parameters by_gauge = knobs_of(here).base;
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(knit::keys::gauge), by_gauge,
                                "13.888888888888889,19.29012345679"));
  apply(session, Tune{by_gauge});
  CHECK(beside_words(session).here.find("Gauge 13.889 x 19.29") != std::string::npos);
  apply(session, Unpin{});
  CHECK(pinned.refresh(session) == nullptr);
}

TEST_CASE("with a pinned run B shows it in the left half, and only the right half is picked in") {
  Desk desk;
  desk.open();
  desk.act({PinRun{}, Tune{wider_band()}});
  desk.act(desk.press({Key::B, {}, 0}));
  REQUIRE(desk.session.view->both);
  lay_out_again(desk, 1280, 960, 1);
  CHECK(desk.ui.controls.count("other-view") == 1);
  CHECK(count_of<ShowWhy>(desk.click("other-view")) == 0);
  desk.frames({desk.over("other-view"), MouseClick{MouseButton::Left, true}});
  const MouseMove middle = desk.over("other-view");
  const Actions turned =
      desk.frames({MouseMove{middle.x + 40.0f, middle.y}, MouseMove{middle.x + 60.0f, middle.y},
                   MouseClick{MouseButton::Left, false}});
  CHECK(count_of<Orbit>(turned) > 0);
}
