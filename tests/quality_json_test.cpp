#include "app/files/report.h"

#include "tests/support/catch.h"
#include "tests/support/run.h"
#include "tests/support/tube.h"

using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

bool any_null(const Json& json) {
  if (!json.is_structured()) return json.is_null();
  return std::any_of(json.begin(), json.end(), any_null);
}

knit::Quality small_quality(std::size_t strips) {
  knit::Timeline timeline(test_support::small_sphere(), test_support::small_parameters());
  timeline.extend_to_end();
  knit::State state = timeline.furthest();
  state.fabric = test_support::first_strips(state.fabric, strips);
  return knit::measure_quality(timeline.input(), state, 0.3, 0.2);
}

knit::Closeness some_closeness() { return {{10, 0.5, 1.0}, {20, 0.25, 2.0}, 4.0, 3.0, 6.0}; }

}  // namespace

TEST_CASE("quality json: all fields of a finished run are there, in order", "[quality]") {
  const knit::Closeness closeness = some_closeness();
  const Json json = app::quality_json(small_quality(100), &closeness);
  CHECK(keys_of(json) == std::vector<std::string>{"stitch_width", "stitch_height", "course", "long_course",
                                                  "worst_course_cv_in_row", "wale", "corner", "corner_off",
                                                  "rows", "tubes", "quad_share", "regular_share", "shaping",
                                                  "offset", "long_offset", "mirror", "distance",
                                                  "area_ratio"});
  CHECK(keys_of(json["course"]) == std::vector<std::string>{"mean", "cv", "min", "max", "p95", "histogram"});
  CHECK(keys_of(json["corner"]["histogram"]) == std::vector<std::string>{"low", "high", "bins"});
  CHECK(keys_of(json["shaping"]) ==
        std::vector<std::string>{"increases", "decreases", "max_in_a_row", "steady"});
  CHECK(keys_of(json["rows"][0]) ==
        std::vector<std::string>{"row", "stitches", "length", "ideal", "course_cv"});
  CHECK(keys_of(json["tubes"][0]) == std::vector<std::string>{"name", "rounds", "stitches", "wale_cv",
                                                              "wale_max", "worst_course_cv_in_row"});
  CHECK_FALSE(any_null(json));
}

TEST_CASE("quality json: what is uncovered, and stretched", "[quality]") {
  const knit::Uncovered uncovered{0.25, {{7, {1.0, 2.0, 3.0}, 0.125, knit::UncoveredKind::flat, 0.0}}};
  CHECK(app::to_json(uncovered) ==
        Json::parse(R"({"share": 0.25, "where": [{"vertex": 7, "at": [1.0, 2.0, 3.0], "share": 0.125}]})"));
  CHECK(app::to_json(std::vector<knit::Stretched>{{1, 4, 6, 2.5, 0.5, {5, 0}}}) ==
        Json::parse(R"([{"tube": "B", "from": 4, "to": 6, "longest": 2.5, "share": 0.5}])"));
}

TEST_CASE("quality json: values stand under their own names", "[quality]") {
  const knit::Quality quality = small_quality(100);
  const Json json = app::to_json(quality);
  CHECK(json["stitch_width"] == 0.3);
  CHECK(json["stitch_height"] == 0.2);
  CHECK(json["course"]["mean"] == quality.course.mean);
  CHECK(json["course"]["cv"] == quality.course.cv);
  CHECK(json["course"]["min"] == quality.course.low);
  CHECK(json["course"]["max"] == quality.course.high);
  CHECK(json["course"]["p95"] == quality.course.p95);
  CHECK(json["wale"]["mean"] == quality.wale.mean);
  CHECK(json["corner"]["histogram"]["bins"] == quality.corner.histogram.bins);
  CHECK(json["corner"]["histogram"]["high"] == 180.0);
  CHECK(json["worst_course_cv_in_row"] == quality.worst_course_cv_in_row);
  CHECK(json["rows"].size() == quality.rows.size());
  CHECK(json["rows"][3]["row"] == 4);
  CHECK(json["rows"][3]["stitches"] == quality.rows[3].stitches);
  CHECK(json["rows"][3]["length"] == quality.rows[3].length);
  CHECK(json["rows"][3]["ideal"] == quality.rows[3].ideal);
  REQUIRE(json["tubes"].size() == 1);
  CHECK(json["tubes"][0]["name"] == "A");
  CHECK(json["tubes"][0]["rounds"] == quality.rows.size());
  CHECK(json["tubes"][0]["wale_max"] == quality.wale.high);
  CHECK(json["tubes"][0]["wale_cv"] == quality.wale.cv);
  CHECK(json["quad_share"] == quality.quad_share);
  CHECK(json["regular_share"] == quality.regular_share);
  CHECK(json["shaping"]["decreases"] == quality.shaping.decreases);
  CHECK(json["shaping"]["steady"] == 5);
  CHECK(json["offset"] == quality.offset);
  CHECK(json["mirror"]["max"] == quality.mirror->max);
}

TEST_CASE("quality json: distances beside their shares of the diagonal", "[quality]") {
  CHECK(app::to_json(some_closeness()) == Json::parse(R"({"distance":
    {"knit_to_mesh": {"mean": 0.5, "max": 1.0, "mean_share": 0.125, "max_share": 0.25},
     "mesh_to_knit": {"mean": 0.25, "max": 2.0, "mean_share": 0.0625, "max_share": 0.5}},
    "area_ratio": 0.5})"));
}

TEST_CASE("quality json: what is not there is null", "[quality]") {
  const Json rows_only = app::quality_json(small_quality(0), nullptr);
  CHECK(rows_only["course"].is_object());
  CHECK(rows_only["rows"].size() > 3);
  for (const char* key : {"wale", "corner", "quad_share", "regular_share", "offset", "long_offset", "mirror",
                          "distance", "area_ratio"}) {
    CAPTURE(key);
    REQUIRE(rows_only.contains(key));
    CHECK(rows_only[key].is_null());
  }
  const Json nothing = app::quality_json(knit::Quality{}, nullptr);
  CHECK(nothing["course"].is_null());
  CHECK(nothing["worst_course_cv_in_row"].is_null());
  CHECK(nothing["rows"] == Json::array());
  CHECK(nothing["shaping"]["increases"] == 0);

  const auto two_short_rows = test_support::tube_state({{5, 5}});
  const Json tube =
      app::to_json(knit::measure_quality(*test_support::small_sphere(), two_short_rows, 0.3, 0.2));
  CHECK(tube["offset"].is_number());
  CHECK(tube["long_course"].is_null());
  CHECK(tube["long_offset"].is_null());
  CHECK(tube["regular_share"].is_null());

  knit::Closeness flat = some_closeness();
  flat.diagonal = flat.mesh_area = 0.0;
  flat.mesh_to_knit = {};
  const Json distances = app::to_json(flat);
  CHECK(distances["area_ratio"].is_null());
  CHECK(distances["distance"]["mesh_to_knit"].is_null());
  CHECK(distances["distance"]["knit_to_mesh"]["mean"] == 0.5);
  CHECK(distances["distance"]["knit_to_mesh"]["max_share"].is_null());
}
