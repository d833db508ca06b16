// Setting a run's parameters and edits exactly: what undo, redo and opened sessions stand on.
#include <utility>

#include "knit/mesh/branching_shapes.h"
#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "tests/support/scrub.h"

using namespace test_support;

namespace {

knit::Parameters with(knit::Parameters parameters, const char* key, const std::string& value) {
  INFO(key);
  REQUIRE_FALSE(knit::set_value(*knit::find_parameter(key), parameters, value));
  return parameters;
}

// A run of its own that was given all of it before it began.
knit::Timeline fresh(const std::shared_ptr<const knit::Input>& input, const knit::Parameters& base,
                     const std::vector<knit::Edit>& edits) {
  knit::Timeline timeline(input, base);
  timeline.set_knobs(base, edits);
  timeline.extend_to_end();
  return timeline;
}

void check_same_run(knit::Timeline& a, knit::Timeline& b) {
  a.extend_to_end();
  REQUIRE(a.known() == b.known());
  CHECK(a.steps() == b.steps());
  CHECK(hashes_forward(a) == hashes_forward(b));
}

}  // namespace

TEST_CASE("set knobs: from anywhere to any base and edits, the run is the fresh one with these") {
  const auto input = small_sphere();
  const knit::Parameters base = small_parameters();
  const knit::Edit at_rows{{knit::Stage::rows, 5, 3}, with(base, "epsilon", "0.2")};
  const knit::Edit at_stitches{{knit::Stage::stitches, 4, 0}, with(base, "placement", "even")};
  const knit::Edit later{{knit::Stage::rows, 8, 0}, with(base, "epsilon", "0.12")};
  const std::vector<std::vector<knit::Edit>> lists{
      {}, {at_rows}, {at_rows, at_stitches}, {later}, {at_stitches}};
  const std::vector<knit::Parameters> bases{base, with(base, "close", "thesis"),
                                            with(base, "stitch-width", "0.4"),
                                            with(base, "placement", "nearest")};
  knit::Timeline timeline(input, base);
  timeline.extend_to_end();
  for (const auto& from : lists) {
    for (const auto& to : lists) {
      for (const knit::Parameters& other : bases) {
        timeline.set_knobs(base, from);
        timeline.extend_to_end();
        timeline.set_knobs(other, to);
        CHECK(timeline.base_parameters() == knit::Timeline(input, other).base_parameters());
        REQUIRE(timeline.edits().size() == to.size());
        knit::Timeline wanted = fresh(input, other, to);
        timeline.extend_to_end();
        REQUIRE(timeline.steps() == wanted.steps());
        REQUIRE(knit::hash_of(timeline.furthest()) == knit::hash_of(wanted.furthest()));
      }
    }
  }
  knit::Timeline wanted = fresh(input, bases.back(), lists.back());
  check_same_run(timeline, wanted);
}

TEST_CASE("set knobs goes back exactly over what tune and edit from here did") {
  const auto input = small_sphere();
  knit::Timeline timeline(input, small_parameters());
  timeline.extend_to_end();
  const auto before = hashes_forward(timeline);
  timeline.seek(timeline.position_of({knit::Stage::rows, 6, 4}));
  const knit::Place here = timeline.place();
  timeline.edit_from_here(with(timeline.parameters(), "epsilon", "0.28"));
  const std::vector<knit::Edit> edits = timeline.edits();
  const auto edited = [&] {
    knit::Timeline copy = timeline;
    copy.extend_to_end();
    return hashes_forward(copy);
  }();
  timeline.set_knobs(small_parameters(), {});
  timeline.extend_to_end();
  CHECK(timeline.place() == here);
  CHECK(hashes_forward(timeline) == before);
  timeline.set_knobs(small_parameters(), edits);
  CHECK(timeline.edits() == edits);
  timeline.extend_to_end();
  CHECK(hashes_forward(timeline) == edited);
  CHECK(edited != before);
}

TEST_CASE("set knobs keeps the place, keeps the start, and keeps the steps before the first change") {
  knit::Timeline timeline(small_sphere(), small_parameters());
  timeline.extend_to_end();
  const knit::Place here{knit::Stage::rows, 9, 2};
  timeline.seek(timeline.position_of(here));
  timeline.set_knobs(with(small_parameters(), "close", "thesis"), {});
  CHECK(timeline.known() > 100);  // rows before the first closing gap are not run again
  timeline.extend_to_end();
  CHECK(timeline.place() == here);

  timeline.seek(0);
  timeline.set_knobs(small_parameters(), {});
  timeline.extend_to_end();
  CHECK(timeline.position() == 0);
  timeline.seek(timeline.known());
  const std::size_t known = timeline.known();
  timeline.set_knobs(small_parameters(), {});
  CHECK(timeline.complete());
  CHECK(timeline.known() == known);
}

TEST_CASE("set knobs on the welded mesh is the run on the welded mesh") {
  const knit::Mesh mesh = knit::sphere(40, 16, true);
  const auto plain = knit::make_input(mesh);
  const auto welded = knit::make_input(knit::weld(mesh));
  knit::Timeline timeline(plain, small_parameters());
  timeline.extend_to_end();
  timeline.set_knobs(with(small_parameters(), "weld", "on"), {}, welded);
  check_equals_fresh(timeline, with(small_parameters(), "weld", "on"));
  CHECK(timeline.input_pointer() == welded);
}

TEST_CASE("stitches settle, or do not, as the knob says, wherever the run has come to") {
  using knit::Settling;
  const auto input = knit::make_input(knit::trousers(0.12));
  knit::Parameters parameters;
  parameters.timing.axis = {knit::AxisKind::y, {0.0, 1.0, 0.0}};
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  knit::give_width(parameters, 0.2);
  for (const auto& [from, to] :
       {std::pair{Settling::off, Settling::on}, {Settling::by_itself, Settling::off}}) {
    for (const knit::Stage stage : {knit::Stage::settle, knit::Stage::done}) {
      CAPTURE(stage, from);
      parameters.settle.settling = from;
      knit::Timeline timeline(input, parameters);
      timeline.extend_to({stage, 0, 0});
      parameters.settle.settling = to;
      timeline.tune(parameters);
      knit::Timeline other(input, parameters);
      timeline.extend_to_end();
      other.extend_to_end();
      CHECK(timeline.steps() == other.steps());
      CHECK(timeline.furthest() == other.furthest());
    }
  }
}
