// The written pattern in its panel: what is lit, what is hovered, what is typed.
#include <algorithm>

#include "app/files/pattern_export.h"
#include "app/panels/dialogs/file_dialogs.h"
#include "app/panels/pattern/chart_cache.h"
#include "app/panels/pattern/pattern_lines.h"
#include "app/panels/pattern/pattern_parts.h"
#include "app/panels/timeline/track.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "tests/support/desk.h"

using namespace desk;

namespace {

// A desk with a finished run and its pattern at the side.
void show_pattern(Desk& desk) {
  desk.open();
  desk.act({ShowSide{SidePanel::pattern}});
  desk.settle();
}

// The first round whose line stands on the screen, counted from `from`.
std::int32_t seen_round(Desk& desk, std::int32_t from = 1) {
  for (std::int32_t round = from; round <= desk.ui.own<ChartCache>().last_row(); ++round) {
    if (desk.ui.controls.count("pattern/round/" + std::to_string(round)) > 0) return round;
  }
  FAIL("no round is seen");
  return 0;
}

bool is_seen(Desk& desk, std::int32_t round) {
  const auto line = desk.ui.own<PatternView>().layout.line_of(round);
  REQUIRE(line);
  const auto& rounds = desk.ui.own<PatternView>().layout.lines()[*line].line.rounds;
  return desk.ui.controls.count("pattern/round/" + std::to_string(rounds->first)) > 0;
}

Actions type_into(Desk& desk, const std::string& field, const std::string& words) {
  desk.act(desk.frames(
      {desk.over(field), MouseClick{MouseButton::Left, true}, MouseClick{MouseButton::Left, false}}));
  Actions all;
  for (const char c : words) {
    const Actions wishes = desk.frames({Text{static_cast<char32_t>(c)}});
    desk.act(wishes);
    all.insert(all.end(), wishes.begin(), wishes.end());
  }
  return all;
}

void leave_field(Desk& desk) {
  desk.act(desk.click("pattern/text", 0.02f));
  desk.settle();
}

void open_fields(Desk& desk) {
  desk.act(desk.click("pattern/fields", 0.3f));
  desk.settle();
}

}  // namespace

TEST_CASE("the pattern's lines are the document, in its order") {
  Desk desk;
  show_pattern(desk);
  const knit::WrittenPattern& pattern = desk.ui.own<ChartCache>().pattern();
  const std::vector<PatternLine> lines = lines_of(pattern);
  CHECK(lines.front().words == pattern.title);
  CHECK(lines.back().words == pattern.finishing.back());
  std::vector<std::string> headings;
  std::int32_t next = 1;
  for (const PatternLine& line : lines) {
    if (line.kind == PatternLine::Kind::heading) headings.push_back(line.words);
    if (!line.rounds) continue;
    CHECK(line.rounds->first == next);
    next = line.rounds->last + 1;
  }
  CHECK(next == desk.ui.own<ChartCache>().last_row() + 1);
  CHECK(headings == std::vector<std::string>{"Finished size", "Materials", "Gauge", "Abbreviations", "Notes",
                                             "Instructions", "Finishing"});
}

TEST_CASE("lines stand one below the other, and a round finds its own") {
  Desk desk;
  show_pattern(desk);
  const PatternLayout& layout = desk.ui.own<PatternView>().layout;
  float bottom = 0.0f;
  for (std::size_t i = 0; i < layout.lines().size(); ++i) {
    const auto& placed = layout.lines()[i];
    CHECK(placed.top >= bottom);
    CHECK(placed.height > 10.0f);
    bottom = placed.top + placed.height;
    CHECK(layout.line_below(placed.top) == i);
  }
  CHECK(bottom <= layout.height());
  for (std::int32_t round = 1; round <= desk.ui.own<ChartCache>().last_row(); ++round) {
    const auto line = layout.line_of(round);
    REQUIRE(line);
    CHECK(layout.lines()[*line].line.rounds->holds(round));
  }
  CHECK_FALSE(layout.line_of(0));
  CHECK_FALSE(layout.line_of(desk.ui.own<ChartCache>().last_row() + 1));
}

TEST_CASE("a line of the pattern ends at a blank, never within a number or between it and its unit") {
  std::size_t ends = 0;
  for (const float width : {700.0f, 900.0f, 1280.0f, 1920.0f}) {
    Desk desk(width, 960, 1, KNIT_ASSETS_DIR "/fonts");
    show_pattern(desk);
    const knit::WrittenPattern& pattern = desk.ui.own<ChartCache>().pattern();
    std::string whole;
    for (const PatternLine& line : lines_of(pattern)) whole += line.words + " ";
    std::string words;
    for (const auto& placed : desk.ui.own<PatternView>().layout.lines()) {
      const std::string& line = placed.line.words;
      words += line + " ";
      ends += static_cast<std::size_t>(std::count(line.begin(), line.end(), '\n'));
      CHECK(line.find("\n%") == std::string::npos);
      CHECK(line.find("\ncm") == std::string::npos);
    }
    for (std::string* text : {&whole, &words}) std::replace(text->begin(), text->end(), '\n', ' ');
    CHECK(words == whole);
  }
  CHECK(ends > 20);
}

TEST_CASE("a line under the pointer lights its rounds in the view, and a click goes there") {
  Desk desk;
  show_pattern(desk);
  desk.act({ToLast{}});
  desk.settle();
  Describer describer;
  const std::size_t before = describer.describe(desk.session).lines.size();
  const std::int32_t round = seen_round(desk, 2);
  const std::string line = "pattern/round/" + std::to_string(round);
  const Actions hovered = desk.frames({desk.over(line)});
  REQUIRE(count_of<HoverRounds>(hovered) == 1);
  desk.act(hovered);
  REQUIRE(desk.session.view->gaze.hovered_rounds);
  const RoundSpan rounds = *desk.session.view->gaze.hovered_rounds;
  CHECK(rounds.first == round);
  std::size_t stitches = 0;
  for (std::int32_t r = rounds.first; r <= rounds.last; ++r)
    stitches += desk.session.document->timeline.state()
                    .fabric.rows()[static_cast<std::size_t>(r) - 1]
                    ->stitches.size();
  CHECK(describer.describe(desk.session).lines.size() == before + stitches);
  const Actions clicked = desk.click(line);
  REQUIRE(count_of<SeekPlace>(clicked) == 1);
  for (const Action& wish : clicked) {
    if (const auto* seek = wish.get_if<SeekPlace>()) CHECK(seek->place.row == round);
  }
  desk.act(desk.frames({MouseLeave{}}));
  CHECK_FALSE(desk.session.view->gaze.hovered_rounds);
}

TEST_CASE("rounds meant before they are made stand where they are going to be") {
  Desk desk;
  show_pattern(desk);
  desk.act({ToFirst{}, HoverRounds{RoundSpan{3, 4}}});
  REQUIRE(desk.session.document->timeline.state().fabric.rows().empty());
  Describer describer;
  const auto& rows = desk.session.document->timeline.furthest().fabric.rows();
  const std::size_t lit = describer.describe(desk.session).lines.size();
  desk.act({HoverRounds{std::nullopt}});
  CHECK(lit ==
        describer.describe(desk.session).lines.size() + rows[2]->stitches.size() + rows[3]->stitches.size());
  desk.act({HoverRounds{RoundSpan{-5, 100000}}});
  CHECK(describer.describe(desk.session).lines.size() > lit);
}

TEST_CASE("the round at hand is kept in sight while the run plays") {
  Desk desk(1280, 520);
  show_pattern(desk);
  desk.act({ToFirst{}});
  desk.settle();
  const std::int32_t last = desk.ui.own<ChartCache>().last_row();
  CHECK_FALSE(is_seen(desk, last));
  for (const std::int32_t round : {2, last / 2, last, 3}) {
    CAPTURE(round);
    desk.act({SeekPlace{{knit::Stage::rows, round, INT32_MAX}}});
    desk.settle();
    CHECK(is_seen(desk, round));
  }
  // A stitch that is pointed at in the view brings its line too.
  desk.act({HoverStitch{StitchAt{last, 0}}});
  desk.settle();
  CHECK(is_seen(desk, last));
}

TEST_CASE("another side leaves no round lit") {
  Desk desk;
  show_pattern(desk);
  desk.act({ToLast{}});
  desk.settle();
  desk.act(desk.frames({desk.over("pattern/round/" + std::to_string(seen_round(desk)))}));
  REQUIRE(desk.session.view->gaze.hovered_rounds);
  desk.act({ShowSide{SidePanel::step}});
  desk.act(desk.frame());
  CHECK_FALSE(desk.session.view->gaze.hovered_rounds);
}

TEST_CASE("the round under the pointer on the timeline is meant everywhere") {
  Desk desk;
  show_pattern(desk);
  const knit::Timeline& timeline = desk.session.document->timeline;
  const knit::Place wanted{knit::Stage::stitches, desk.ui.own<ChartCache>().last_row() / 2, INT32_MAX};
  const Box box = desk.ui.controls.at("track");
  const float margin = desk.layout.scale * 6.0f;
  const Track track{box.x + margin, box.right() - margin, box.y, box.bottom(), timeline.known()};
  const float x = track.x_of(timeline.position_of(wanted));
  const Actions hovered = desk.frames({MouseMove{x, box.y + 0.5f * box.height}});
  const std::size_t position = track.position_at(x);
  const std::int32_t row = timeline.step(position - 1).place.row;
  CHECK(only<HoverRounds>(hovered).rounds == RoundSpan{row, row});
  desk.act(hovered);
  desk.settle();
  CHECK(is_seen(desk, row));
  desk.act(desk.frames({MouseMove{track.x_of(1), box.y + 0.5f * box.height}}));
  CHECK_FALSE(desk.session.view->gaze.hovered_rounds);  // no rows there
}

TEST_CASE("who knits along goes on from the line that is clicked") {
  Desk desk;
  show_pattern(desk);
  desk.act({KnitAlong{2}});
  desk.settle();
  const std::int32_t round = seen_round(desk, 3);
  const Actions clicked = desk.click("pattern/round/" + std::to_string(round));
  CHECK(count_of<KnitAlong>(clicked) == 1);
}

TEST_CASE("the pattern's own words are folded away, and taken as they are typed") {
  Desk desk;
  show_pattern(desk);
  CHECK(desk.ui.controls.count("pattern/Title") == 0);
  open_fields(desk);
  CHECK(count_of<SetPatternOptions>(type_into(desk, "pattern/Title", "My ball")) == 7);
  CHECK(desk.session.view->pattern.title == "My ball");
  type_into(desk, "pattern/Yarn", "Wool");
  type_into(desk, "pattern/Colour", "moss");
  leave_field(desk);
  CHECK(desk.session.view->pattern.title == "My ball");
  CHECK(desk.session.view->pattern.yarn == "Wool");
  CHECK(desk.session.view->pattern.colour == "moss");
  CHECK(desk.ui.own<ChartCache>().pattern().title == "My ball");
  CHECK(desk.ui.own<ChartCache>().pattern().materials.front().find("Wool, in moss") != std::string::npos);
  for (const char* box : {"pattern/markers", "pattern/stars", "pattern/short"})
    desk.act(desk.click(box, 0.1f));
  CHECK(desk.session.view->pattern.markers);
  CHECK(desk.session.view->pattern.stars);
  CHECK(desk.session.view->pattern.form == knit::PatternForm::short_form);
}

TEST_CASE("options that come from elsewhere fill the fields") {
  Desk desk;
  show_pattern(desk);
  open_fields(desk);
  type_into(desk, "pattern/Title", "Mine");
  knit::PatternOptions options;
  options.title = "From a file";
  options.needle_mm = 3.25;
  leave_field(desk);
  desk.act({SetPatternOptions{options}});
  desk.settle();
  CHECK(desk.ui.own<PatternFields>().title.text() == "From a file");
  CHECK(desk.ui.own<PatternFields>().needle.text() == "3.25");
}

TEST_CASE(
    "a needle is a number from 0.5 to 50, another is refused with a sentence, and stays to be repaired") {
  Desk desk;
  show_pattern(desk);
  open_fields(desk);
  type_into(desk, "pattern/Needle", "3.5x");
  CHECK(desk.session.view->pattern.needle_mm == 3.5);
  CHECK(desk.ui.own<PatternFields>().trouble.empty());  // not while it is typed
  leave_field(desk);
  CHECK(desk.ui.own<PatternFields>().trouble ==
        "The needle cannot be \"3.5x\" mm; give a number from 0.5 to 50.");
  CHECK(desk.ui.own<PatternFields>().needle.text() == "3.5x");
  CHECK(desk.session.view->pattern.needle_mm == 3.5);  // the last that could be
  for (const char* bad : {"0", "0.4", "51", "nan", "3,5", "-2", "4 mm"}) CHECK_FALSE(needle_mm_of(bad));
  CHECK(needle_mm_of("0.5") == 0.5);
  CHECK(needle_mm_of("50") == 50.0);
}

TEST_CASE("before there are labels the panel says so, and saving is at hand after") {
  Desk desk;
  desk.act({ShowSide{SidePanel::pattern}});
  desk.settle();
  CHECK(desk.ui.controls.count("pattern/text") == 0);
  show_pattern(desk);
  desk.click("pattern/save");
  CHECK(desk.ui.own<SaveDialog>().wanted == find_export("pattern"));
}
