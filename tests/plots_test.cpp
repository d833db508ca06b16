// Small plots on a stage of their own: what they draw stays on their ground, what is clicked is told.
#include "app/panels/kit/plots.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/panels/kit/widgets.h"
#include "tests/support/desk.h"

namespace {

using namespace desk;

// One panel over all of the window with one plot in it.
class Stage {
 public:
  explicit Stage(float scale = 1.0f)
      : layout_(layout_of(800 * scale, 600 * scale, scale)),
        fonts_(glue_.load_fonts(KNIT_ASSETS_DIR "/fonts", scale, style::text_size)) {
    style::apply(scale);
  }
  template <class Draw>
  auto frame(Draw draw, const std::vector<InputEvent>& events = {}) {
    glue_.begin_frame({layout_.window.width, layout_.window.height, 1, 1, 1.0f / 60.0f}, events);
    PanelFrame frame{session_, memory_, scene_, layout_, fonts_, {}};
    begin_panel("stage", layout_.window);
    const auto result = draw(frame);
    drawn_ = bounds_of(*ImGui::GetWindowDrawList());
    indices_ = ImGui::GetWindowDrawList()->VtxBuffer.Size;
    ImGui::End();
    glue_.end_frame();
    return result;
  }
  [[nodiscard]] Box box(const char* name) const { return memory_.controls.at(name); }
  [[nodiscard]] const Box& drawn() const { return drawn_; }
  [[nodiscard]] int indices() const { return indices_; }

 private:
  // Of all that was drawn but the panel itself.
  static Box bounds_of(const ImDrawList& list) {
    Box box{1e9f, 1e9f, -1e9f, -1e9f};
    float right = -1e9f;
    float bottom = -1e9f;
    const ImU32 panel = style::packed(dark_theme.panel);
    for (const ImDrawVert& vertex : list.VtxBuffer) {
      if (vertex.col == panel) continue;
      box.x = std::min(box.x, vertex.pos.x);
      box.y = std::min(box.y, vertex.pos.y);
      right = std::max(right, vertex.pos.x);
      bottom = std::max(bottom, vertex.pos.y);
    }
    return {box.x, box.y, right - box.x, bottom - box.y};
  }

  ImGuiGlue glue_;
  Layout layout_;
  Fonts fonts_;
  Session session_;
  PanelMemory memory_;
  Scene scene_;
  Box drawn_;
  int indices_ = 0;
};

HistogramPlot histogram(const std::vector<std::size_t>& bins) {
  HistogramPlot plot;
  plot.name = "plot/some";
  plot.title = "Lengths";
  plot.counted = "edges";
  plot.high = 2.0;
  plot.bins = bins;
  plot.reference = 1.0;
  plot.mean = 0.9;
  plot.missing = "after the faces";
  return plot;
}

RowPlot rows(const std::vector<double>& values, const std::vector<double>& ideals) {
  RowPlot plot;
  plot.name = "plot/rows";
  plot.title = "Stitches a row";
  plot.value_words = "made";
  plot.ideal_words = "ideal";
  plot.values = values;
  plot.ideals = ideals;
  plot.missing = "after the cast on";
  return plot;
}

void check_inside(const Stage& stage, const char* name, float scale) {
  const Box box = stage.box(name);
  const float slack = 6.0f * scale;  // smooth edges, and marks that stand on the very ends
  CHECK(stage.drawn().x >= box.x - slack);
  CHECK(stage.drawn().y >= box.y - slack);
  CHECK(stage.drawn().right() <= box.right() + slack);
  CHECK(stage.drawn().bottom() <= box.bottom() + slack);
}

}  // namespace

TEST_CASE("an axis is marked at round numbers, few enough") {
  CHECK(tick_step(70.0, 3) == 50.0);
  CHECK(tick_step(70.0, 4) == 20.0);
  CHECK(tick_step(1000.0, 2) == 500.0);
  CHECK(tick_step(9.0, 1) == 10.0);
  CHECK(tick_step(2.0, 5) == 1.0);
  CHECK(tick_step(0.0, 3) == 1.0);
  CHECK(tick_step(std::numeric_limits<double>::quiet_NaN(), 3) == 1.0);
  for (double high = 1.5; high < 1e6; high *= 1.7) {
    for (const int most : {1, 2, 3, 5}) {
      CAPTURE(high, most);
      CHECK(high / tick_step(high, most) <= most * 1.0001);
    }
  }
}

TEST_CASE("numbers are written with a real minus, and nothing is minus zero") {
  CHECK(fixed_text(0.125, 2) == "0.12");
  CHECK(fixed_text(17.0, 0) == "17");
  CHECK(fixed_text(-1.5, 1) ==
        "\xE2\x88\x92"
        "1.5");
  CHECK(fixed_text(-0.001, 2) == "0.00");
}

TEST_CASE("a histogram stays within its item, whatever its bins hold") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const float scale : {1.0f, 2.0f}) {
    Stage stage(scale);
    const std::vector<std::vector<std::size_t>> all{
        {}, {0, 0, 0}, {7}, {0, 1, 2, 3000000, 5}, std::vector<std::size_t>(400, 3)};
    for (const auto& bins : all) {
      for (const double mean : {0.9, -5.0, 17.0, nan}) {
        CAPTURE(bins.size(), mean);
        HistogramPlot plot = histogram(bins);
        plot.mean = mean;
        stage.frame([&](PanelFrame& frame) {
          draw_histogram(frame, plot, ImVec2(150 * scale, 90 * scale));
          return 0;
        });
        CHECK(stage.box("plot/some").width == 150 * scale);
        CHECK(stage.box("plot/some").height == 90 * scale);
        check_inside(stage, "plot/some", scale);
      }
    }
  }
}

TEST_CASE("a click on the row plot tells its row, elsewhere it tells nothing") {
  Stage stage;
  const std::vector<double> made{6, 12, 18, 24, 30, 36, 30, 24, 18, 12};
  const RowPlot plot = rows(made, made);
  const auto draw = [&](PanelFrame& frame) { return draw_row_plot(frame, plot, ImVec2(300, 140)); };
  CHECK_FALSE(stage.frame(draw));
  const Box box = stage.box("plot/rows");
  const auto click_at = [&](float x, float y) {
    std::optional<std::size_t> told;
    for (const InputEvent& event :
         {InputEvent(MouseMove{x, y}), InputEvent(MouseClick{MouseButton::Left, true}),
          InputEvent(MouseClick{MouseButton::Left, false})}) {
      CHECK_FALSE(told);
      told = stage.frame(draw, {event});
    }
    return told;
  };
  const float middle = box.y + 0.5f * box.height;
  CHECK(click_at(box.right() - 2.0f, middle) == std::size_t{9});
  std::size_t before = 0;
  for (float x = box.x + 30.0f; x < box.right(); x += 13.0f) {
    const auto told = click_at(x, middle);
    REQUIRE(told);
    CHECK(*told >= before);
    CHECK(*told <= before + 1);
    before = *told;
  }
  CHECK(before == 9);
  CHECK_FALSE(click_at(box.x + 100.0f, box.y + 5.0f));         // the title
  CHECK_FALSE(click_at(box.x + 3.0f, middle));                 // the words beside the axis
  CHECK_FALSE(click_at(box.x + 100.0f, box.bottom() + 9.0f));  // below
}

TEST_CASE("a row that is not there yet cannot be clicked") {
  Stage stage;
  const std::vector<double> made{6, 12};
  RowPlot plot = rows(made, made);
  plot.rows = 10;
  plot.current = 2;
  const auto draw = [&](PanelFrame& frame) { return draw_row_plot(frame, plot, ImVec2(300, 140)); };
  stage.frame(draw);
  const Box box = stage.box("plot/rows");
  stage.frame(draw, {MouseMove{box.right() - 20.0f, box.y + 70.0f}});
  stage.frame(draw, {MouseClick{MouseButton::Left, true}});
  CHECK_FALSE(stage.frame(draw, {MouseClick{MouseButton::Left, false}}));
}

TEST_CASE("a row plot stays within its item and its triangles stay few, whatever its rows hold") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const float scale : {1.0f, 2.0f}) {
    Stage stage(scale);
    std::vector<double> long_run;
    for (int i = 0; i < 20000; ++i) long_run.push_back(100.0 + 50.0 * std::sin(0.01 * i));
    const std::vector<std::vector<double>> all{{},          {6},     {6, nan, infinity, -3}, {nan}, {0, 0, 0},
                                               {6, 6e6, 6}, long_run};
    for (const auto& values : all) {
      CAPTURE(values.size());
      RowPlot plot = rows(values, values);
      for (const auto current : {std::optional<std::size_t>(), std::optional<std::size_t>(0),
                                 std::optional<std::size_t>(values.size()), std::optional<std::size_t>(40)}) {
        plot.current = current;
        stage.frame(
            [&](PanelFrame& frame) { return draw_row_plot(frame, plot, ImVec2(300 * scale, 140 * scale)); });
        check_inside(stage, "plot/rows", scale);
        CHECK(stage.indices() < 30000);  // an index has 16 bits
      }
    }
  }
}
