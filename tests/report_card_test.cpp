// The report card: its figures, when they are there, where they stand, and what a click on it gives.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/files/card.h"
#include "app/panels/kit/run_cache.h"
#include "app/panels/report/card_cache.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/view.h"
#include "knit/model/stitch_size.h"
#include "tests/support/bodies.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

namespace {

using namespace desk;

constexpr std::array plots{"plot/course", "plot/wale", "plot/corner", "plot/rows"};
constexpr std::array figures{"course/mean",
                             "course/cv",
                             "course/p95",
                             "course/max",
                             "wale/mean",
                             "wale/cv",
                             "wale/p95",
                             "wale/max",
                             "sideways",
                             "mirror/mean",
                             "mirror/max",
                             "knit-to-mesh/mean",
                             "knit-to-mesh/max",
                             "mesh-to-knit/mean",
                             "mesh-to-knit/max",
                             "uncovered",
                             "stretched",
                             "area",
                             "quads",
                             "regular",
                             "increases",
                             "decreases",
                             "most"};

std::shared_ptr<const knit::Closeness> some_closeness() {
  return std::make_shared<const knit::Closeness>(knit::Closeness{
      {100, 0.01, 0.02}, {100, 0.02, 0.03}, 4.0, 9.5, 10.0, knit::Coverage{{0.1, {{3, {}, 0.1}}}, {}, 1}});
}

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool inside(const Box& a, const Box& b) {
  return a.x >= b.x && a.y >= b.y && a.right() <= b.right() && a.bottom() <= b.bottom();
}

// What the card has marked.
std::vector<std::pair<std::string, Box>> parts_of(const Desk& desk) {
  std::vector<std::pair<std::string, Box>> parts;
  for (const auto& [name, box] : desk.ui.controls) {
    for (const char* beginning : {"figure/", "line/", "missing/", "plot/", "side/"}) {
      if (name.rfind(beginning, 0) == 0) parts.emplace_back(name, box);
    }
  }
  return parts;
}

void check_places(const Desk& desk) {
  const auto parts = parts_of(desk);
  CHECK(parts.size() > 20);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    INFO(parts[i].first);
    CHECK(inside(parts[i].second, desk.layout.explanation));
    for (std::size_t j = 0; j < i; ++j) {
      INFO(parts[j].first);
      CHECK_FALSE(overlap(parts[i].second, parts[j].second));
    }
  }
  for (const char* plot : plots) {
    INFO(plot);
    REQUIRE(desk.ui.controls.count(plot) == 1);
    CHECK(desk.ui.controls.at(plot).height > 60.0f * desk.layout.scale);
  }
}

const CardFigure* find_figure(const std::vector<CardGroup>& groups, const std::string& name) {
  for (const CardGroup& group : groups) {
    for (const CardLine& line : group.lines) {
      for (const auto& figure : line.figures) {
        if (figure && figure->name == "figure/" + name) return &*figure;
      }
    }
  }
  return nullptr;
}

std::string missing_of(const std::vector<CardGroup>& groups, const std::string& name) {
  for (const CardGroup& group : groups) {
    for (const CardLine& line : group.lines) {
      if (line.name == name) return line.missing;
    }
  }
  return "no such line";
}

knit::Quality fine_quality() {
  knit::Quality quality;
  quality.course.count = quality.wale.count = 100;
  quality.course.mean = quality.wale.mean = 1.0;
  quality.course.cv = 0.05;
  quality.wale.cv = 0.15;
  quality.offset = 0.8;
  quality.shaping = {30, 30, 5};
  quality.steady_shaping = 5;
  quality.mirror = knit::MirrorError{0.1, 0.2};
  return quality;
}

constexpr std::array labels_of_card{"line/", "head/", "figure/", "missing/", "plot/", "tube/", "positions"};

bool tip_is_shown() {
  const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
  return tip != nullptr && tip->Active;
}

// Of the wishes the one place to go to.
knit::Place sought(const Actions& wishes) {
  REQUIRE(count_of<SeekPlace>(wishes) == 1);
  for (const Action& wish : wishes)
    if (const auto* seek = wish.get_if<SeekPlace>()) return seek->place;
  return {};
}

}  // namespace

TEST_CASE("a click on a tab shows its side, once, and R shows the next") {
  Desk desk;
  desk.open();
  CHECK(desk.session.view->side == SidePanel::step);
  CHECK(desk.click("side/step").empty());
  const Actions wishes = desk.click("side/report");
  CHECK(only<ShowSide>(wishes).side == SidePanel::report);
  desk.act(wishes);
  CHECK(desk.session.view->side == SidePanel::report);
  desk.settle();
  CHECK(desk.click("side/report").empty());
  CHECK(desk.ui.controls.count("layer/faces") == 0);
  CHECK(only<ShowSide>(desk.press({Key::R, {}, 0})).side == SidePanel::pattern);
  desk.session.view->side = static_cast<SidePanel>(side_keys.size() - 1);
  CHECK(only<ShowSide>(desk.press({Key::R, {}, 0})).side == SidePanel::step);
  desk.act(desk.click("side/step"));
  desk.settle();
  CHECK(desk.ui.controls.count("layer/faces") == 1);
  CHECK(desk.ui.controls.count("plot/rows") == 0);
}

TEST_CASE("a click on a row of the plot goes to that row, hovering only tells") {
  Desk desk;
  desk.open();
  desk.session.view->side = SidePanel::report;
  desk.session.document->timeline.seek(desk.session.document->timeline.known());
  desk.settle();
  const auto last = static_cast<std::int32_t>(desk.session.document->timeline.state().fabric.rows().size());
  const Actions hovered = desk.frames({desk.over("plot/rows", 0.6f), MouseLeave{}});
  CHECK(count_of<HoverRounds>(hovered) == hovered.size());  // lights the row in the view, and no longer
  REQUIRE(hovered.size() == 1);
  const knit::Place end = sought(desk.click("plot/rows", 0.995f));
  CHECK(end.row == last);
  CHECK(end.stage == knit::Stage::pattern);
  const Actions wishes = desk.click("plot/rows", 0.55f);
  const knit::Place middle = sought(wishes);
  CHECK(middle.row > 1);
  CHECK(middle.row < last);
  desk.act(wishes);
  CHECK(desk.session.document->timeline.place().row == middle.row);
}

TEST_CASE("a click on a bar lights all that it counts, and once more no longer") {
  Desk desk;
  desk.open();
  desk.session.view->side = SidePanel::report;
  desk.session.document->timeline.seek(desk.session.document->timeline.known());
  desk.settle();
  const knit::State& state = desk.session.document->timeline.state();
  const knit::StitchSize& stitch = desk.session.document->timeline.parameters().stitch;
  const knit::Quality* quality = desk.ui.own<CardCache>().quality();
  REQUIRE(quality != nullptr);
  const auto check = [&](const char* plot, knit::Measured of, const knit::Histogram& histogram) {
    INFO(plot);
    std::size_t lit = 0, bars = 0;
    for (std::size_t bin = 0; bin < histogram.bins.size(); ++bin) {
      const float across = (static_cast<float>(bin) + 0.5f) / static_cast<float>(histogram.bins.size());
      const Actions wishes = desk.click(plot, across);
      if (histogram.bins[bin] == 0) {
        CHECK(wishes.empty());
        continue;
      }
      ++bars;
      const auto& range = only<SelectSized>(wishes).range;
      REQUIRE(range);
      CHECK(range->of == of);
      const auto things = knit::things_of_size(state, stitch, *range);
      CHECK((of == knit::Measured::corner ? things.size() <= histogram.bins[bin] && !things.empty()
                                          : things.size() == histogram.bins[bin]));
      lit += things.size();
    }
    CHECK(bars > 2);
    CHECK(lit > bars);
  };
  check("plot/course", knit::Measured::course, quality->course.histogram);
  check("plot/wale", knit::Measured::wale, quality->wale.histogram);
  check("plot/corner", knit::Measured::corner, quality->corner.histogram);
  const auto& bins = quality->course.histogram.bins;
  const auto most = static_cast<float>(std::max_element(bins.begin(), bins.end()) - bins.begin());
  const float across = (most + 0.5f) / static_cast<float>(bins.size());
  desk.act(desk.click("plot/course", across));
  REQUIRE(desk.session.document->travel.sized);
  desk.settle();
  CHECK_FALSE(only<SelectSized>(desk.click("plot/course", across)).range);
}

TEST_CASE("a figure leads to what it is of, and says so") {
  Desk desk;
  desk.open();
  desk.session.view->side = SidePanel::report;
  desk.session.document->timeline.seek(desk.session.document->timeline.known());
  desk.settle();
  const knit::State& state = desk.session.document->timeline.state();
  const knit::StitchSize& stitch = desk.session.document->timeline.parameters().stitch;
  const knit::Quality quality = *desk.ui.own<CardCache>().quality();
  const auto longest = [&](const char* figure, knit::Measured of, double size) {
    INFO(figure);
    const knit::Element thing = only<LookAt>(desk.click(figure)).thing;
    const auto things = knit::things_of_size(state, stitch, {of, size});
    CHECK(std::any_of(things.begin(), things.end(), [&](const auto& one) { return one.thing == thing; }));
  };
  longest("figure/course/max", knit::Measured::course, quality.course.high);
  longest("figure/wale/max", knit::Measured::wale, quality.wale.high);
  CHECK(sought(desk.click("figure/course/cv")).row == quality.uneven_row);
  CHECK(quality.rows[static_cast<std::size_t>(quality.uneven_row) - 1].course_cv ==
        quality.worst_course_cv_in_row);
  CHECK(sought(desk.click("figure/most")).row == quality.most_shaped_row);
  CHECK(std::abs(state.fabric.join_into(quality.most_shaped_row)->change()) == quality.shaping.max_in_a_row);
  CHECK(only<SelectSized>(desk.click("figure/wale/p95")).range ==
        knit::SizeRange{knit::Measured::wale, quality.wale.p95});
  CHECK(std::holds_alternative<knit::ColumnEdgeElement>(only<LookAt>(desk.click("figure/sideways")).thing));
  CHECK(desk.click("figure/course/mean").empty());
}

TEST_CASE("every label, head, figure and plot of the card has a tip") {
  Desk desk(1440, 1200);
  knit::Parameters parameters;
  parameters.rows.source = knit::RowSource::contours;
  parameters.settle.settling = knit::Settling::on;
  knit::give_width(parameters, 0.2);
  desk.session.view->side = SidePanel::report;
  const auto walk = [&](std::size_t least) {
    const auto marks = desk.ui.controls;
    std::size_t walked = 0;
    for (const auto& [name, box] : marks) {
      const bool is_label =
          std::any_of(labels_of_card.begin(), labels_of_card.end(),
                      [&, &of = name](const char* begin) { return of.rfind(begin, 0) == 0; });
      if (!is_label) continue;
      INFO(name);
      desk.frames({desk.over(name, 0.5f), desk.over(name, 0.5f)});
      CHECK(tip_is_shown());
      ++walked;
    }
    desk.frames({MouseLeave{}});
    desk.settle();
    CHECK_FALSE(tip_is_shown());
    CHECK(walked >= least);
  };
  desk.settle();
  walk(15);  // nothing open: lines without figures
  desk.session.document = Document({knit::make_input(test_support::arch()), parameters});
  desk.session.document->timeline.extend_to_end();
  desk.session.document->timeline.seek(desk.session.document->timeline.known());
  desk.session.document->closeness = some_closeness();
  desk.settle();
  REQUIRE(desk.ui.controls.count("head/settled") == 1);
  REQUIRE(desk.ui.controls.count("head/Longest") == 1);
  walk(40);
}

TEST_CASE("what a label of the card is about is said in one plain sentence") {
  const auto check = [](const std::vector<CardGroup>& groups, std::size_t least) {
    std::size_t lines = 0;
    for (const CardGroup& group : groups) {
      for (const CardLine& line : group.lines) {
        INFO(line.words << ": " << line.help);
        CHECK(test_support::is_one_sentence(line.help));
        CHECK(line.help.size() <= 140);
        ++lines;
      }
    }
    CHECK(lines >= least);
  };
  const knit::Quality quality = fine_quality();
  check(card_groups(nullptr, nullptr, false), 12);
  check(card_groups(&quality, some_closeness().get(), false), 12);
  for (const std::string_view head : card_heads)
    CHECK(test_support::is_one_sentence(std::string(help_of_head(head))));
}

TEST_CASE("figures end where their heads end, and those under no head stand beside their words") {
  for (const float width : {1100.0f, 1280.0f, 1920.0f}) {
    CAPTURE(width);
    Desk desk(width, 960);
    desk.open();
    desk.session.view->side = SidePanel::report;
    desk.session.document->timeline.seek(desk.session.document->timeline.known());
    desk.session.document->closeness = some_closeness();
    desk.settle();
    const auto end = [&](const std::string& name) { return desk.ui.controls.at(name).right(); };
    for (const char* line : {"course", "wale"}) {
      for (const auto& [figure, head] : {std::pair{"mean", "mean"}, std::pair{"cv", "CV"},
                                         std::pair{"p95", "95 %"}, std::pair{"max", "max"}})
        CHECK(end("figure/" + std::string(line) + "/" + figure) ==
              Approx(end(std::string("head/") + head)).margin(1.0));
    }
    CHECK(end("figure/sideways") == Approx(end("head/max")).margin(1.0));
    for (const auto& [line, figure] :
         {std::pair{"uncovered", "uncovered"}, std::pair{"stretched", "stretched"},
          std::pair{"quads", "quads"}, std::pair{"decreases", "decreases"}}) {
      const Box words = desk.ui.controls.at(std::string("line/") + line);
      const Box number = desk.ui.controls.at(std::string("figure/") + figure);
      CHECK(words.y == Approx(number.y).margin(1.0));
      CHECK(number.x >= words.right());
      CHECK(number.right() - words.x < 0.55f * desk.layout.explanation.width);
    }
  }
}

TEST_CASE("the card keeps to its column and nothing on it overlaps, at every stage and with nothing open") {
  struct Size {
    float width, height, scale;
  };
  for (const Size& size :
       {Size{1280, 720, 1}, Size{1440, 900, 1}, Size{3840, 2160, 2}, Size{2560, 1440, 2}}) {
    CAPTURE(size.width, size.height, size.scale);
    Desk desk(size.width, size.height, size.scale, KNIT_ASSETS_DIR "/fonts");
    desk.session.view->side = SidePanel::report;
    desk.settle();
    check_places(desk);
    desk.open();
    for (const RunCache::Stretch& stage : std::vector(desk.ui.own<RunCache>().stages())) {
      for (const std::size_t position : {stage.begin, (stage.begin + stage.end) / 2, stage.end}) {
        CAPTURE(position);
        desk.session.document->timeline.seek(position);
        desk.session.jobs->run.measuring = position % 2 == 0 ? std::optional(Measuring{}) : std::nullopt;
        desk.session.document->closeness = position % 3 == 0 ? some_closeness() : nullptr;
        CHECK(desk.frame().empty());
        check_places(desk);
      }
    }
    desk.session.document->closeness = some_closeness();
    CHECK(desk.frame().empty());
    check_places(desk);
    for (const char* figure : figures) {
      INFO(figure);
      CHECK(desk.ui.controls.count(std::string("figure/") + figure) == 1);
    }
  }
}

TEST_CASE("every figure has words of its own, and the card of a small window scrolls") {
  const auto closeness = some_closeness();
  const knit::Quality quality = fine_quality();
  std::set<std::string> helps;
  for (const CardGroup& group : card_groups(&quality, closeness.get(), false)) {
    for (const CardLine& line : group.lines) {
      INFO(line.name);
      CHECK(line.missing.empty());
      CHECK(line.help.back() == '.');
      for (const auto& figure : line.figures) {
        if (!figure) continue;
        INFO(figure->name);
        CHECK(figure->help.back() == '.');
        CHECK(helps.insert(figure->help).second);
      }
    }
  }
  CHECK(helps.size() == figures.size());
  Desk desk(640, 400, 1);
  desk.session.view->side = SidePanel::report;
  desk.open();
  CHECK(desk.frame().empty());
}

TEST_CASE("a figure is marked only beyond what a knitter would want") {
  knit::Quality quality = fine_quality();
  knit::Closeness closeness = *some_closeness();
  closeness.knit_to_mesh.max = 0.01 * closeness.diagonal;
  const auto outside = [&](const std::string& name) {
    const auto groups = card_groups(&quality, &closeness, false);
    const CardFigure* figure = find_figure(groups, name);
    REQUIRE(figure != nullptr);
    CHECK(figure->outside == (figure->help.find("A knitter would want") != std::string::npos));
    return figure->outside;
  };
  const std::array judged{"course/cv", "wale/cv", "wale/max", "sideways", "most", "knit-to-mesh/max"};
  for (const char* name : judged) {
    INFO(name);
    CHECK_FALSE(outside(name));
  }
  quality.course.cv = 0.051;
  quality.wale.cv = 0.151;
  quality.wale.high = 2.01;
  quality.offset = 0.81;
  quality.shaping.max_in_a_row = 6;
  closeness.knit_to_mesh.max = 0.0101 * closeness.diagonal;
  for (const char* name : judged) {
    INFO(name);
    CHECK(outside(name));
  }
  CHECK_FALSE(outside("course/mean"));
  CHECK_FALSE(outside("mesh-to-knit/max"));
}

TEST_CASE("what is not there yet says when it will be") {
  const auto nothing = card_groups(nullptr, nullptr, false);
  CHECK(find_figure(nothing, "course/mean") == nullptr);
  CHECK(missing_of(nothing, "course") == "after the cast on");
  CHECK(missing_of(nothing, "wale") == "after the faces");
  CHECK(missing_of(nothing, "most") == "after the stitches");
  CHECK(missing_of(nothing, "area") == "after the run");
  CHECK(missing_of(card_groups(nullptr, nullptr, true), "knit-to-mesh") == "measuring...");
  knit::Quality quality = fine_quality();
  quality.wale.count = 0;
  const auto stitches = card_groups(&quality, nullptr, false);
  CHECK(missing_of(stitches, "course").empty());
  CHECK(missing_of(stitches, "increases").empty());
  CHECK(missing_of(stitches, "quads") == "after the faces");
}

TEST_CASE("quality is measured when something was finished, and never twice for the same") {
  knit::Timeline timeline = small_run(wide_band());
  timeline.extend_to_end();
  CardCache cache;
  cache.refresh(timeline);
  CHECK(cache.quality() == nullptr);
  CHECK(cache.times_measured() == 0);
  std::size_t finished = 0;
  for (std::size_t position = 0; position <= timeline.known(); ++position) {
    timeline.seek(position);
    for (int i = 0; i < 3; ++i) cache.refresh(timeline);
    const knit::State& state = timeline.state();
    const bool rows = !state.fabric.rows().empty();
    REQUIRE((cache.quality() != nullptr) == rows);
    if (rows) REQUIRE(cache.quality()->rows.size() == state.fabric.rows().size());
    if (rows)
      finished = state.fabric.rows().size() + state.fabric.joins().size() + state.fabric.strips().size();
  }
  CHECK(cache.times_measured() == finished);
  // There and back again at once: replayed steps make the same rows anew.
  timeline.seek(0);
  timeline.seek(timeline.known());
  cache.refresh(timeline);
  CHECK(cache.times_measured() == finished);
}

TEST_CASE("while a run moves, measuring keeps to its budget, and is due when the run rests") {
  knit::Timeline timeline = small_run(wide_band());
  timeline.extend_to_end();
  CardCache cache(0.0);  // so that the first measuring is never paid off
  const std::size_t end = timeline.known();
  const std::size_t third_row = timeline.position_of({knit::Stage::rows, 3, INT32_MAX});
  for (int i = 0; i < 10; ++i) {
    timeline.seek(i % 2 == 0 ? end : third_row);
    cache.refresh(timeline);
    REQUIRE(cache.quality() != nullptr);
  }
  CHECK(cache.times_measured() == 1);
  CHECK(cache.quality()->rows.size() != timeline.state().fabric.rows().size());
  cache.refresh(timeline);
  CHECK(cache.times_measured() == 2);
  CHECK(cache.quality()->rows.size() == timeline.state().fabric.rows().size());
  // Another mesh's figures are never shown for this one, not even for a frame.
  knit::Timeline other(knit::make_input(knit::sphere(20, 11, false)), wide_band());
  other.extend_to_end();
  other.seek(other.known());
  cache.refresh(other);
  CHECK(cache.times_measured() == 3);
  CHECK(cache.quality()->rows.size() == other.state().fabric.rows().size());
}

TEST_CASE("quality follows the parameters") {
  knit::Timeline timeline = small_run(wide_band());
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  CardCache cache;
  cache.refresh(timeline);
  REQUIRE(cache.quality() != nullptr);
  CHECK(cache.quality()->stitch_width == wide_band().stitch.width);
  CHECK(cache.quality()->stitch_height == wide_band().stitch.height);
  knit::Parameters wider = wide_band();
  knit::give_width(wider, 0.5);
  timeline.tune(wider);
  timeline.extend_to_end();
  timeline.seek(timeline.known());
  cache.refresh(timeline);
  cache.refresh(timeline);
  CHECK(cache.quality()->stitch_width == 0.5);
}

TEST_CASE("a piece of several tubes has a line for each, and a click goes to the tube's first row") {
  Desk desk;
  desk.open();
  desk.session.view->side = SidePanel::report;
  desk.settle();
  CHECK(desk.ui.controls.count("tube/A") == 0);  // one tube is the whole
  knit::Parameters parameters;
  parameters.rows.source = knit::RowSource::contours;
  knit::give_width(parameters, 0.2);
  desk.session.document = Document({knit::make_input(test_support::arch()), parameters});
  desk.session.document->timeline.extend_to_end();
  desk.session.document->timeline.seek(desk.session.document->timeline.known());
  desk.settle();
  REQUIRE(desk.ui.controls.count("tube/C") == 1);
  const knit::Fabric& fabric = desk.session.document->timeline.state().fabric;
  const knit::RowId row = only<SeekPlace>(desk.click("tube/B")).place.row;
  CHECK(fabric.row(row).tube == 1);
}
