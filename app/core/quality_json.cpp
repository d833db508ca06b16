#include "app/core/quality_json.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

Json value_if(bool there, double value) { return there ? Json(value) : Json(nullptr); }

Json ratio(double part, double whole) { return value_if(whole > 0.0, part / whole); }

Json spread_json(const knit::Spread& spread) {
  if (spread.count == 0) return nullptr;
  const knit::Histogram& histogram = spread.histogram;
  return {{"mean", spread.mean},
          {"cv", spread.cv},
          {"min", spread.low},
          {"max", spread.high},
          {"p95", spread.p95},
          {"histogram", {{"low", histogram.low}, {"high", histogram.high}, {"bins", histogram.bins}}}};
}

Json rows_json(const std::vector<knit::RowFit>& rows) {
  Json all = Json::array();
  for (const knit::RowFit& row : rows) {
    all.push_back({{"row", row.row},
                   {"stitches", row.stitches},
                   {"length", row.length},
                   {"ideal", row.ideal},
                   {"course_cv", row.course_cv}});
  }
  return all;
}

Json mirror_json(const std::optional<knit::MirrorError>& mirror) {
  if (!mirror) return nullptr;
  return {{"mean", mirror->mean}, {"max", mirror->max}};
}

Json distances_json(const knit::Distances& distances, double diagonal) {
  if (distances.samples == 0) return nullptr;
  return {{"mean", distances.mean},
          {"max", distances.max},
          {"mean_share", ratio(distances.mean, diagonal)},
          {"max_share", ratio(distances.max, diagonal)}};
}

}  // namespace

Json to_json(const knit::Quality& quality) {
  const bool any_wale = quality.wale.count > 0;
  const bool any_face = quality.faces.quads + quality.faces.triangles > 0;
  Json json;
  json["stitch_width"] = quality.stitch_width;
  json["stitch_height"] = quality.stitch_height;
  json["course"] = spread_json(quality.course);
  json["long_course"] = spread_json(quality.long_course);
  json["worst_course_cv_in_row"] = value_if(quality.course.count > 0, quality.worst_course_cv_in_row);
  json["wale"] = spread_json(quality.wale);
  json["corner"] = spread_json(quality.corner);
  json["rows"] = rows_json(quality.rows);
  json["quad_share"] = value_if(any_face, quality.quad_share);
  json["regular_share"] = value_if(any_wale && quality.rows.size() > 2, quality.regular_share);
  json["shaping"] = {{"increases", quality.shaping.increases},
                     {"decreases", quality.shaping.decreases},
                     {"max_in_a_row", quality.shaping.max_in_a_row},
                     {"steady", quality.steady_shaping}};
  json["offset"] = value_if(any_wale, quality.offset);
  json["long_offset"] = value_if(any_wale && quality.long_course.count > 0, quality.long_offset);
  json["mirror"] = mirror_json(quality.mirror);
  return json;
}

Json to_json(const knit::Closeness& closeness) {
  return {{"distance",
           {{"knit_to_mesh", distances_json(closeness.knit_to_mesh, closeness.diagonal)},
            {"mesh_to_knit", distances_json(closeness.mesh_to_knit, closeness.diagonal)}}},
          {"area_ratio", ratio(closeness.knit_area, closeness.mesh_area)}};
}

Json quality_json(const knit::Quality& quality, const knit::Closeness* closeness) {
  Json json = to_json(quality);
  json.update(closeness != nullptr ? to_json(*closeness)
                                   : Json{{"distance", nullptr}, {"area_ratio", nullptr}});
  return json;
}

}  // namespace app
