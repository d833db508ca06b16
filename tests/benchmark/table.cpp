#include "tests/benchmark/table.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/base/files.h"
#include "app/base/text.h"
#include "tests/benchmark/ball_file.h"

namespace benchmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* begin_mark = "<!-- measured: begin -->\n";
constexpr const char* end_mark = "<!-- measured: end -->\n";

// Two figures that count.
std::string number(const Json& value) {
  const double x = value.get<double>();
  if (x == 0.0) return "0";
  const int digits = 1 - static_cast<int>(std::floor(std::log10(std::abs(x))));
  return app::fixed_text(x, std::max(0, digits));
}

std::string grouped(const Json& value) {
  const std::string digits = std::to_string(value.get<std::size_t>());
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string cells(std::initializer_list<std::string> all) {
  std::string line = "|";
  for (const std::string& cell : all) line += " " + cell + " |";
  return line + "\n";
}

std::string goal(const char* what, const Json& measured, double most, const std::string& unit) {
  const bool met = measured.get<double>() <= most;
  return cells({what, "<= " + number(Json(most)) + unit, number(measured) + unit, met ? "met" : "missed"});
}

std::string goals(const Json& suite) {
  std::string text = cells({"Goal", "at most", "measured", ""}) + "|---|---|---|---|\n";
  text += goal("pipeline over parse, thesis sphere", suite["thesis_sphere"]["run_over_parse"]["median"], 0.25,
               "");
  text += goal("pipeline over parse, a million triangles, rows from contours",
               suite["million_triangles"]["run_over_parse"]["median"], 0.5, "");
  text +=
      goal("seek at a million steps, 99th percentile", suite["million_steps"]["seek"]["p99_ms"], 1.0, " ms");
  text += goal("history beside keyframes, a step", suite["million_steps"]["history"]["bytes_a_step"], 64.0,
               " bytes");
  if (const Json& shape = suite["branching"]; !shape.contains("left_out")) {
    const double third = shape["drag"]["third_of_a_frame_ms"].get<double>();
    text += goal("seek on a shape that branches, 99th percentile", shape["seek"]["p99_ms"], 1.0, " ms");
    text += goal("a frame there while the stitch width is dragged, 99th percentile",
                 shape["drag"]["stitch_width"]["own_ms"]["p99"], third, " ms");
    text += goal("a frame there while epsilon is dragged, 99th percentile",
                 shape["drag"]["epsilon"]["own_ms"]["p99"], third, " ms");
  }
  text += goal("growth of the run with size, slope on log-log", suite["growth"]["run_slope"], 1.1, "");
  text += goal("growth of opening with size, slope on log-log", suite["growth"]["open_slope"], 1.1, "");
  const Json& checking = suite["checking"];
  text += goal("checking a megabyte of written pattern", checking["check_ms"], 1000.0, " ms");
  text += goal("the same with 40 sizes, each worked", checking["sizes_ms"], 1000.0, " ms");
  text += goal("a key typed into a pattern of 1,000 lines, 99th percentile", checking["key"]["key_ms"]["p99"],
               1000.0 / 60.0, " ms");
  return text + "\n";
}

std::string checks(const Json& suite) {
  const Json& checking = suite["checking"];
  std::string text = cells({"Checking a written pattern", "measured"}) + "|---|---|\n";
  text += cells({"a megabyte over parsing as much of a mesh's text", number(checking["over_parse"])});
  text +=
      cells({"a megabyte that tells 40 sizes over one that tells none", number(checking["sizes_over_one"])});
  text += cells(
      {"the frame of a key typed into " + grouped(checking["key"]["lines"]) + " lines over one without it",
       number(checking["key"]["key_over_still"])});
  return text + "\n";
}

std::string stages(const Json& suite) {
  const Json& small = suite["thesis_sphere"];
  const Json& large = suite["million_triangles"];
  std::string text =
      cells({"Over parsing the same file", grouped(small["triangles"]) + " triangles, thesis sphere",
             grouped(large["triangles"]) + " triangles, contours"}) +
      "|---|---|---|\n";
  for (const auto& [name, ratio] : small["stage_over_parse"].items())
    text += cells({name, number(ratio), number(large["stage_over_parse"][name])});
  text += cells({"recorded, with keyframes", number(small["run_over_parse"]["median"]),
                 number(large["run_over_parse"]["median"])});
  text += cells({"its 10th to 90th percentile",
                 number(small["run_over_parse"]["p10"]) + " to " + number(small["run_over_parse"]["p90"]),
                 number(large["run_over_parse"]["p10"]) + " to " + number(large["run_over_parse"]["p90"])});
  return text + "\n";
}

std::string growth(const Json& suite) {
  std::string text = cells({"Triangles", "opening, ms", "run with contours, ms"}) + "|---|---|---|\n";
  for (const Json& size : suite["growth"]["sizes"])
    text += cells({grouped(size["triangles"]), number(size["open_ms"]), number(size["run_ms"])});
  text += cells({"slope", number(suite["growth"]["open_slope"]), number(suite["growth"]["run_slope"])});
  return text + "\n";
}

std::string travelling(const Json& suite) {
  const Json& seek = suite["million_steps"]["seek"];
  const Json& history = suite["million_steps"]["history"];
  const Json& tune = suite["tune_to_picture"];
  const Json& scrub = suite["scrub"];
  std::string text =
      cells({"Going through a run", "median", "99th percentile", "most"}) + "|---|---|---|---|\n";
  const auto row = [](const std::string& what, const Json& all) {
    return cells({what, number(all["median"]), number(all["p99"]), number(all["max"])});
  };
  text += cells({"seek among " + grouped(seek["steps"]) + " steps, ms", number(seek["median_ms"]),
                 number(seek["p99_ms"]), number(seek["max_ms"])});
  text += row("a frame of scrubbing there, ms", scrub["frame_ms"]);
  text += row("changed parameter to picture, thesis sphere, ms", tune["change_to_picture_ms"]);
  text += row("of that the change, ms", tune["change_ms"]);
  text += row("of that what is to be seen, ms", tune["describe_ms"]);
  text += row("of that the panels, ms", tune["panels_ms"]);
  text += "\nBeside " + grouped(history["keyframes"]) + " keyframes (" + grouped(history["keyframe_bytes"]) +
          " bytes of at most " + grouped(history["keyframe_budget_bytes"]) + ") a step takes " +
          number(history["bytes_a_step"]) + " bytes, with what is set aside for more " +
          number(history["set_aside_bytes_a_step"]) + ".\n\n";
  return text;
}

std::string branches(const Json& suite) {
  const Json& shape = suite["branching"];
  if (shape.contains("left_out"))
    return "No shape that branches: " + shape["left_out"].get<std::string>() + "\n\n";
  const Json& seek = shape["seek"];
  std::string text = cells({"A shape that branches: " + shape["mesh"].get<std::string>() + ", " +
                                grouped(shape["triangles"]) + " triangles, " + grouped(shape["tubes"]) +
                                " tubes, " + grouped(seek["steps"]) + " steps",
                            "measured"}) +
                     "|---|---|\n";
  text += cells({"linear run over parsing", number(shape["linear"]["run_over_parse"]["median"])});
  text += cells({"geodesic run over parsing", number(shape["geodesic"]["run_over_parse"]["median"])});
  text += cells({"geodesic: all that follows over the solve", number(shape["geodesic"]["rest_over_solve"])});
  text +=
      cells({"seek, median / 99th percentile / most, ms",
             number(seek["median_ms"]) + " / " + number(seek["p99_ms"]) + " / " + number(seek["max_ms"])});
  for (const auto& [key, words] :
       {std::pair{"stitch_width", "stitch width"}, std::pair{"epsilon", "epsilon (not read)"}}) {
    const Json& drag = shape["drag"][key];
    const Json& own = drag["own_ms"];
    const Json& behind = drag["frames_behind"];
    text +=
        cells({"a frame while the " + std::string(words) + " is dragged, median / 99th percentile / most, ms",
               number(own["median"]) + " / " + number(own["p99"]) + " / " + number(own["max"])});
    text += cells({"how many frames its picture is behind, median / most",
                   number(behind["median"]) + " / " + number(behind["max"])});
  }
  const Json& settling = shape["drag"]["settling"];
  const Json& own = settling["own_ms"];
  text += cells({"a frame while " + grouped(settling["stitches"]) +
                     " stitches settle after a change, median / 99th percentile / most, ms",
                 number(own["median"]) + " / " + number(own["p99"]) + " / " + number(own["max"])});
  text += cells({"frames until they have settled", grouped(settling["frames"])});
  return text + "\n";
}

std::string worst(const Json& part) {
  std::string text;
  for (const char* what : {"act_ms", "describe_ms", "panels_ms"})
    text += (text.empty() ? "" : " / ") + number(part[what]["max"]);
  return text;
}

std::string windows(const Json& suite) {
  const Json& one = suite["window_1m"];
  const Json& five = suite["window_5m"];
  std::string text =
      cells({"In a window, the worst frame's parts, ms: action / scene / panels",
             grouped(one["triangles"]) + " triangles", grouped(five["triangles"]) + " triangles"}) +
      "|---|---|---|\n";
  for (const char* part : {"opening", "working_out", "camera", "scrubbing"}) {
    std::string name = part;
    if (name == "working_out") name = "working the run out";
    text += cells({name, worst(one[part]), worst(five[part])});
  }
  text += cells({"a click on the surface", number(one["click_ms"]["max"]), number(five["click_ms"]["max"])});
  text +=
      cells({"cancelling an opening", number(one["cancel"]["frame_ms"]), number(five["cancel"]["frame_ms"])});
  text += cells({"until its worker has ended", number(one["cancel"]["worker_ended_after_ms"]),
                 number(five["cancel"]["worker_ended_after_ms"])});
  text += cells({"opening takes, s", number(one["opening"]["seconds"]), number(five["opening"]["seconds"])});
  return text;
}

}  // namespace

std::optional<std::string> write_table(const std::filesystem::path& suite_file,
                                       const std::filesystem::path& page_file) {
  const Json suite = Json::parse(read_text(suite_file), nullptr, false);
  if (!suite.is_object()) return suite_file.string() + " is no JSON object; give what --suite has printed.";
  const std::string page = read_text(page_file);
  const std::size_t begin = page.find(begin_mark);
  const std::size_t end = page.find(end_mark);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    return page_file.string() + " has no lines \"" + begin_mark + "\" and after it its end; write them in.";
  const std::string threads = std::to_string(suite["threads"].get<unsigned>());
  const std::string text = "Measured on " + threads + " threads of one machine in one run.\n\n" +
                           goals(suite) + stages(suite) + branches(suite) + growth(suite) + checks(suite) +
                           travelling(suite) + windows(suite);
  return app::write_file(page_file, page.substr(0, begin) + begin_mark + text + page.substr(end));
}

}  // namespace benchmark
