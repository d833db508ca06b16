// A written pattern that is checked: its shape at a gauge, what there is to see of it, and what actions make of it.
#include "app/checker/checker.h"

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <thread>

#include "app/actions/picture_session.h"
#include "app/checker/checked_scene.h"
#include "app/describe/describe.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

const std::string good = "CO 6 sts.\nRnd 1: [K1, m1l] 6 times. (12 sts)\nRnds 2-3: Knit. (12 sts)\nBO all.\n";
const std::string bad = "CO 6 sts.\nRnd 1: [K1, m1l] 6 times. (13 sts)\nRnd 2: Knit. (12 sts)\nBO 12 sts.\n";

knit::CheckedPiece piece_of(const std::vector<std::int64_t>& counts, bool flat = false) {
  knit::CheckedPiece piece;
  piece.flat = flat;
  std::size_t line = 1;
  for (const std::int64_t count : counts) piece.rounds.push_back({line++, count});
  return piece;
}

knit::CheckedSize size_of(std::vector<knit::CheckedPiece> pieces) {
  knit::CheckedSize size;
  size.pieces = std::move(pieces);
  for (std::size_t line = 1; line <= 40; ++line) {
    knit::CheckedLine& told = size.lines.emplace_back();
    told.number = line;
    told.verdict = knit::LineVerdict::holds;
  }
  return size;
}

// Of hand-made results, as if the checker had said so.
Checker checker_with(knit::CheckedSize size) {
  Checker checker;
  auto checked = std::make_shared<knit::CheckedPattern>();
  checked->verdict = size.verdict;
  checked->sizes.push_back(std::move(size));
  checker.checked = std::move(checked);
  checker.checked_text = checker.text;
  return checker;
}

const Checker& checker_of(const Session& session) {
  REQUIRE(session.view->checker);
  return *session.view->checker;
}

std::vector<double> heights_of(const PlacedPiece& piece) {
  std::vector<double> heights;
  for (const PlacedRound& round : piece.rounds) heights.push_back(round.height);
  return heights;
}

}  // namespace

TEST_CASE("a round is a ring as long as its stitches and stands a row higher along the slope") {
  const CheckedGauge gauge{20.0, 25.0};  // 0.5 cm x 0.4 cm
  const CheckedShape shape = shape_of(size_of({piece_of({40, 40, 44, 30, 30})}), gauge);
  REQUIRE(shape.pieces.size() == 1);
  const PlacedPiece& piece = shape.pieces[0];
  CHECK(piece.rounds[0].half == Approx(40 * 0.5 / (2.0 * std::numbers::pi)));
  const double out = 4 * 0.5 / (2.0 * std::numbers::pi);  // 0.318 cm
  const double up = std::sqrt(0.4 * 0.4 - out * out);
  // In by 14 stitches is further than a row is high: it lies flat.
  const std::vector<double> should{0.0, 0.4, 0.4 + up, 0.4 + up, 0.8 + up};
  REQUIRE(heights_of(piece).size() == should.size());
  for (std::size_t i = 0; i < should.size(); ++i)
    CHECK(heights_of(piece)[i] == Approx(should[i]).margin(1e-12));
  CHECK(shape.bounds.high.y == Approx(0.8 + up));
  const auto corners = corners_of(piece, piece.rounds[0]);
  REQUIRE(corners.size() == ring_corners);
  for (const glm::dvec3& corner : corners)
    CHECK(std::hypot(corner.x - piece.middle, corner.z) == Approx(piece.rounds[0].half));
}

TEST_CASE("rows are strips that lie flat, and pieces stand side by side with their names") {
  knit::CheckedPiece thumb = piece_of({10, 10, 8});
  thumb.name = "Thumb";
  thumb.made = 2;
  const CheckedShape shape =
      shape_of(size_of({piece_of({20, 10, 30}, true), thumb, piece_of({})}), {20.0, 25.0});
  REQUIRE(shape.pieces.size() == 2);  // one of no round is none
  CHECK(shape.pieces[0].rounds[1].half == Approx(0.5 * 10 * 0.5));
  CHECK(heights_of(shape.pieces[0])[2] == Approx(0.8));
  CHECK(corners_of(shape.pieces[0], shape.pieces[0].rounds[0]).size() == 2);
  CHECK(shape.pieces[0].middle + shape.pieces[0].half < shape.pieces[1].middle - shape.pieces[1].half);
  CHECK(shape.pieces[0].name == "Piece 1");
  CHECK(shape.pieces[1].name == "Thumb, 2 of them");
}

TEST_CASE("no count is too large and none too small for a shape") {
  const CheckedShape shape =
      shape_of(size_of({piece_of({0, 0}), piece_of({std::numeric_limits<std::int64_t>::max(), 0, -5})}), {});
  REQUIRE(shape.pieces.size() == 1);
  CHECK(std::isfinite(shape.bounds.radius));
  CHECK(shape_of(size_of({}), {}).pieces.empty());
  CHECK(std::isfinite(shape_of(size_of({}), {}).bounds.radius));
  const CheckedShape tall = shape_of(size_of({piece_of(std::vector<std::int64_t>(9000, 40))}), {});
  CHECK(9000 / stride_of(tall) <= 1500);
}

TEST_CASE("the place where a round is seen leads to its line") {
  Checker checker = checker_with(size_of({piece_of({40, 44, 48, 48, 48, 40, 30, 20})}));
  const CheckedShape shape = shape_of(*checker.shown(), checker.gauge);
  checker.camera.frame(shape.bounds, 1.5);
  checker.camera.pitch = 0.1;
  const Sight sight = checker.camera.view(1.5);
  std::size_t found = 0;
  for (std::size_t i = 3; i < 6; ++i) {  // the sides are seen from there
    const PlacedRound& low = shape.pieces[0].rounds[i - 1];
    const PlacedRound& high = shape.pieces[0].rounds[i];
    const glm::dvec3 towards =
        glm::normalize(glm::dvec3(sight.eye.x - shape.pieces[0].middle, 0.0, sight.eye.z));
    const glm::dvec3 at = glm::dvec3(shape.pieces[0].middle, 0.5 * (low.height + high.height), 0.0) +
                          0.5 * (low.half + high.half) * towards;
    const glm::vec4 place = sight.projection * sight.view * glm::vec4(glm::vec3(at), 1.0F);
    const auto line = line_under(shape, sight, {place.x / place.w, place.y / place.w});
    REQUIRE(line);
    CHECK(*line == high.line);
    ++found;
  }
  CHECK(found == 3);
  CHECK_FALSE(line_under(shape, sight, {0.99, 0.99}));
}

TEST_CASE("rings of lines with a mistake have its colour, and that of the caret is lit") {
  knit::CheckedSize size = size_of({piece_of({40, 40, 40, 40})});
  size.lines[1].verdict = knit::LineVerdict::does_not_add_up;
  size.lines[2].verdict = knit::LineVerdict::not_claimed;
  Checker checker = checker_with(std::move(size));
  checker.caret.line = 4;
  CheckedScene kept;
  const auto described = [&](const Theme& theme) {
    Scene scene;
    scene.theme = &theme;
    kept.describe(checker, 1.5, scene);
    return scene;
  };
  const Scene scene = described(dark_theme);
  const auto lines_of = [&](const Scene& of, Colour colour) {
    std::size_t count = 0;
    for (const Line& line : *of.line_sets.at(0)) count += line.colour == colour ? 1 : 0;
    return count;
  };
  CHECK(lines_of(scene, dark_theme.problem) == ring_corners);
  CHECK(lines_of(scene, dark_theme.warning) == ring_corners);
  CHECK(lines_of(scene, dark_theme.column_edge) == 2 * ring_corners);
  CHECK(scene.faces.at(0)->faces.size() == 3 * ring_corners);
  REQUIRE(scene.lines.size() == ring_corners);
  CHECK(scene.lines[0].colour == dark_theme.selected);
  CHECK(scene == described(dark_theme));  // nothing is uploaded anew
  CHECK(lines_of(described(light_theme), light_theme.problem) == ring_corners);
  // Faces look outward.
  for (const FaceShape::Face& face : scene.faces[0]->faces) {
    const glm::vec3 middle = 0.25F * (face.corners[0] + face.corners[1] + face.corners[2] + face.corners[3]);
    const float centre = 0.5F * static_cast<float>(40.0 * (10.0 / 22.0) / std::numbers::pi);
    CHECK(glm::dot(face.normal, middle - glm::vec3(centre, middle.y, 0.0F)) > 0.0F);
  }
}

TEST_CASE("what is typed is checked at once without a mesh, and closing keeps it") {
  Session session;
  apply(session, ShowChecker{});
  CHECK(session.view->checking);
  CHECK(checker_of(session).up_to_date());
  apply(session, SetCheckedText{bad});
  CHECK(checker_of(session).up_to_date());
  CHECK(checker_of(session).checked->verdict == CheckVerdict::does_not_add_up);
  CHECK(checker_of(session).shown()->lines.at(1).verdict == knit::LineVerdict::does_not_add_up);
  CHECK_FALSE(checker_of(session).moved);
  CHECK(checker_of(session).unsaved());
  apply(session, ShowChecker{false});
  CHECK_FALSE(session.view->checking);
  apply(session, ShowChecker{});
  CHECK(*checker_of(session).text == bad);
  apply(session, SetCheckedText{good});
  CHECK(checker_of(session).checked->verdict == CheckVerdict::holds);
  CHECK(summary_words(checker_of(session)).find("Every count holds") == 0);
}

TEST_CASE("a large text is read by a worker in a window, one at a time, and what was typed meanwhile next") {
  Session session;
  session.jobs->beside = true;
  std::string large = "CO 12 sts.\n";
  for (int i = 1; large.size() < 60'000; ++i) large += "Rnd " + std::to_string(i) + ": Knit. (12 sts)\n";
  apply(session, SetCheckedText{large});
  REQUIRE(session.jobs->pattern_check);
  CHECK_FALSE(checker_of(session).up_to_date());
  apply(session, SetCheckedText{large + "Rnd 9999: Knit. (13 sts)\n"});
  for (int i = 0; i < 3000 && !checker_of(session).up_to_date(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    apply(session, PassTime{0.01});
  }
  CHECK(checker_of(session).up_to_date());
  CHECK_FALSE(session.jobs->pattern_check);
  CHECK(checker_of(session).checked->verdict == CheckVerdict::does_not_add_up);
}

TEST_CASE("a file is opened and saved, and what stood there before is not lost") {
  const test_support::Folder folder;
  const auto file = folder.path() / "ball.txt";
  test_support::write_text(file, bad);
  Session session;
  apply(session, SetCheckedText{"my own"});
  apply(session, CheckFile{file});
  CHECK(session.view->checking);
  CHECK(*checker_of(session).text == bad);
  CHECK(checker_of(session).path == file);
  CHECK_FALSE(checker_of(session).unsaved());
  apply(session, RestoreCheckedText{});
  CHECK(*checker_of(session).text == "my own");
  apply(session, RestoreCheckedText{});
  CHECK(*checker_of(session).text == bad);
  apply(session, SetCheckedText{good});
  CHECK(checker_of(session).unsaved());
  apply(session, SaveCheckedText{file});
  CHECK(test_support::read_text(file) == good);
  CHECK_FALSE(checker_of(session).unsaved());
  for (const auto& nowhere : {folder.path() / "none.txt", folder.path()}) {
    session.outbox->notices.clear();
    apply(session, CheckFile{nowhere});
    REQUIRE(session.outbox->notices.size() == 1);
    CHECK(session.outbox->notices[0].text.find("cannot be read") != std::string::npos);
    CHECK(*checker_of(session).text == good);
  }
}

TEST_CASE("the caret goes to mistakes, round at the end, and stays within the text") {
  Session session;
  apply(session,
        SetCheckedText{"CO 6 sts.\nRnd 1: Knit. (7 sts)\nRnd 2: Knit. (6 sts)\nRnd 3: Knit. (5 sts)\n"});
  apply(session, ToMistake{1});
  CHECK(checker_of(session).caret.line == 2);
  CHECK(checker_of(session).caret.length > 0);
  apply(session, ToMistake{1});
  CHECK(checker_of(session).caret.line == 4);
  apply(session, ToMistake{1});
  CHECK(checker_of(session).caret.line == 2);
  apply(session, ToMistake{-1});
  CHECK(checker_of(session).caret.line == 4);
  apply(session, GoToCheckedLine{999, 999, 999});
  CHECK(checker_of(session).caret == TextCaret{5, 0, 0});
  apply(session, GoToCheckedLine{1, 3, 999});
  CHECK(checker_of(session).caret.line == 1);
  CHECK(checker_of(session).caret.at == 3);
  apply(session, SetCheckedText{good});
  apply(session, ToMistake{1});
  CHECK(session.outbox->notices.back().text == "No line has a mistake.");
}

TEST_CASE("the preview shows all of a shape that grows while one types, unless it was moved by hand") {
  Session session;
  apply(session, ShowChecker{});
  std::string text = "CO 6 sts.\n";
  apply(session, SetCheckedText{text});
  const double small = checker_of(session).camera.distance;
  text += "Rnd 1: Kfb around. (12 sts)\nRnd 2: Kfb around. (24 sts)\nRnds 3-20: Knit. (24 sts)\n";
  apply(session, SetCheckedText{text});
  const Camera grown = checker_of(session).camera;
  CHECK(grown.distance > 2.0 * small);
  apply(session, Zoom{0.5, {0.0, 0.0}});
  const Camera near = checker_of(session).camera;
  apply(session, SetCheckedText{text + "Rnds 21-40: Knit. (24 sts)\n"});
  CHECK(checker_of(session).camera == near);
  apply(session, FrameAll{});
  apply(session, SetCheckedText{text});
  CHECK(checker_of(session).camera == grown);
}

TEST_CASE("the preview turns by itself, and opening a mesh shows the mesh") {
  Session session = test_support::small_session();
  apply(session, SetCheckedText{good, true});
  const Camera mesh = session.view->gaze.camera;
  const Camera before = checker_of(session).camera;
  apply(session, Orbit{0.3, 0.1});
  apply(session, Zoom{0.5, {0.0, 0.0}});
  CHECK(session.view->gaze.camera == mesh);
  CHECK_FALSE(checker_of(session).camera == before);
  apply(session, SetCheckedGauge{30.0, 40.0});
  CHECK(checker_of(session).gauge == CheckedGauge{30.0, 40.0});
  apply(session, SetCheckedGauge{0.0, 40.0});
  CHECK(checker_of(session).gauge == CheckedGauge{30.0, 40.0});
  const Scene scene = Describer().describe(figure_session(session));
  CHECK(scene.mesh == nullptr);
  CHECK_FALSE(scene.faces.empty());
  apply(session, OpenExample{"thesis-sphere"});
  CHECK_FALSE(session.view->checking);
  CHECK(*checker_of(session).text == good);
  CHECK(Describer().describe(session).mesh != nullptr);
}

TEST_CASE("bytes and lines of a text lead to each other") {
  const std::string text = "a\n\nbcd";
  const auto starts = line_starts(text);
  CHECK(starts == std::vector<std::size_t>{0, 2, 3});
  for (std::size_t byte = 0; byte <= text.size(); ++byte)
    CHECK(byte_of(starts, text.size(), caret_at(starts, byte)) == byte);
  CHECK(byte_of(starts, text.size(), {2, 9, 0}) == 2);
  CHECK(line_starts("").size() == 1);
  CHECK(checked_gauge("22x32") == CheckedGauge{});
  for (const char* wrong : {"", "22", "x", "22x", "0x32", "22x32x1", "nanx3", "22x900"})
    CHECK_FALSE(checked_gauge(wrong));
}
