// The curve of the yarn, read back by a counter of its own: what is pulled through what, how long it is, where it overlaps.
#include "knit/yarn/yarn_curve.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "app/files/load.h"
#include "app/session/presets.h"
#include "knit/model/stitch_size.h"
#include "knit/relax/relax.h"
#include "knit/run/timeline.h"
#include "knit/yarn/eased_yarn.h"
#include "knit/yarn/loop_shape.h"
#include "knit/yarn/yarn.h"
#include "tests/support/catch.h"
#include "tests/support/short_tube.h"
#include "tests/support/yarn_crossings.h"

using namespace knit;

namespace {

struct Piece {
  Fabric fabric;
  std::vector<glm::dvec3> at;
  StitchSize stitch;
};

// Rounds on circles of their size, a stitch high.
Piece tube_of(const std::vector<std::int32_t>& sizes, double height = 0.72) {
  Piece piece{test_support::fabric_of({sizes, {}}), {}, {}};
  piece.stitch.width = 1.0;
  piece.stitch.height = height;
  double up = 0.0, around = 0.0;
  for (const std::int32_t size : sizes) {
    const double radius = size / (2.0 * std::numbers::pi);
    if (around > 0.0)
      up += std::sqrt(std::max(0.05, height * height - (radius - around) * (radius - around)));
    around = radius;
    for (std::int32_t i = 0; i < size; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / size;
      piece.at.push_back({radius * std::sin(angle), up, -radius * std::cos(angle)});
    }
  }
  return piece;
}

Piece example(const std::string& name, std::string_view preset, bool relaxed = true) {
  const auto loaded = app::load_example(KNIT_ASSETS_DIR, name);
  const auto& made = std::get<app::Loaded>(loaded);
  const Parameters parameters =
      resolved(app::with_preset(*app::find_preset(preset), made.parameters), *made.input);
  Timeline timeline(made.input, parameters);
  timeline.extend_to_end();
  REQUIRE(timeline.stop() == nullptr);
  Piece piece{timeline.furthest().fabric, {}, parameters.stitch};
  piece.at = relaxed ? relax(piece.fabric, piece.stitch, {}).positions : knitting_path(piece.fabric);
  return piece;
}

// What a stitch of plain knitting takes.
double munden(const StitchSize& stitch) { return std::sqrt(21.0 * stitch.height * stitch.width); }

// Of the loops alone: Munden knows no lifted bars and no ends.
double length_a_loop(const Yarn& yarn, std::size_t stitches) {
  constexpr std::size_t fine = 8;
  double length = 0.0;
  for (const YarnCurve& curve : yarn.curves) {
    const auto places = sampled(curve, fine);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (curve.parts[i / fine] == YarnPart::loop) length += glm::distance(places[i], places[i + 1]);
    }
  }
  return length / static_cast<double>(stitches);
}

Yarn yarn_of(const Piece& piece) { return make_yarn(piece.fabric, piece.at, piece.stitch); }

}  // namespace

TEST_CASE("yarn curve: the plain and the twisted loop are those that were fitted") {
  const LoopShape plain = plain_loop(), twisted = twisted_loop(true);
  const std::array<std::array<double, 3>, 4> asked{
      {{-0.5, -0.296, -0.196}, {-0.199, -0.203, -0.096}, {-0.131, 0.077, 0.093}, {-0.25, 0.5, 0.183}}};
  const std::array<std::array<double, 3>, 4> turned{
      {{-0.5, -0.296, -0.196}, {-0.244, -0.203, -0.002}, {0.036, 0.077, 0.248}, {0.25, 0.5, 0.223}}};
  for (std::size_t i = 0; i < asked.size(); ++i) {
    CHECK(std::abs(plain[i].u - asked[i][0]) < 6e-4);
    CHECK(std::abs(plain[i].v - asked[i][1]) < 6e-4);
    CHECK(std::abs(plain[i].n - asked[i][2]) < 1.1e-3);
    CHECK(std::abs(twisted[i].u - turned[i][0]) < 6e-4);
    CHECK(std::abs(twisted[i].n - turned[i][2]) < 1.1e-3);
    CHECK(std::abs(plain[12 - i].u + plain[i].u) < 1e-12);
  }
}

TEST_CASE("yarn curve: it goes through its points and is as long as it is") {
  YarnCurve curve;
  curve.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  CHECK(std::abs(length_of(curve) - 3.0) < 1e-12);
  curve.points = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}};
  const auto places = sampled(curve, 4);
  REQUIRE(places.size() == 9);
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    CHECK(glm::distance(places[4 * i], curve.points[i]) < 1e-15);
}

TEST_CASE("yarn curve: in a tube every loop is drawn through what it is worked from") {
  std::size_t decreased = 0, increased = 0;
  for (const auto& sizes : {std::vector<std::int32_t>{36, 36, 36, 36},
                            {36, 36, 36, 36, 33, 33, 33, 33, 30, 30, 30, 30},
                            {30, 30, 30, 30, 33, 33, 33, 33, 36, 36, 36, 36}}) {
    const Piece piece = tube_of(sizes);
    const Yarn yarn = yarn_of(piece);
    const auto counted = test_support::crossings_of(piece.fabric, piece.at, yarn.curves);
    REQUIRE(counted.knit.all > 70);
    CHECK(counted.knit.right == counted.knit.all);
    CHECK(counted.decrease.right == counted.decrease.all);
    CHECK(counted.bar.right == counted.bar.all);
    CHECK(counted.no_bar == 0);
    decreased += static_cast<std::size_t>(counted.decrease.all);
    increased += static_cast<std::size_t>(counted.bar.all);
    REQUIRE(yarn.curves.size() == 1);
    CHECK(yarn.counts.cuts == 0);
    CHECK(yarn.counts.bound_off == sizes.back());
    CHECK(std::abs(length_a_loop(yarn, piece.at.size()) / munden(piece.stitch) - 1.0) < 0.03);
    // Twelve points a stitch, and those of bars and of the chain.
    const std::size_t bars = static_cast<std::size_t>(yarn.counts.bars);
    const std::size_t chain = static_cast<std::size_t>(yarn.counts.bound_off);
    CHECK(yarn.curves[0].points.size() == 12 * (piece.at.size() + bars + chain) + 1);
    CHECK(yarn.curves[0].radius == 0.125);
  }
  CHECK(decreased == 12);
  CHECK(increased == 6);
}

TEST_CASE("yarn curve: what is not drawn through is seen") {
  const Piece piece = tube_of({20, 20, 20, 20});
  Yarn yarn = yarn_of(piece);
  // The third round laid before the second.
  for (std::size_t i = 0; i < yarn.curves[0].points.size(); ++i) {
    if (yarn.curves[0].stitches[i] >= 40 && yarn.curves[0].stitches[i] < 60)
      yarn.curves[0].points[i] +=
          0.5 * glm::dvec3(yarn.curves[0].points[i].x, 0.0, yarn.curves[0].points[i].z);
  }
  const auto counted = test_support::crossings_of(piece.fabric, piece.at, yarn.curves);
  CHECK(counted.knit.right == 0);
}

TEST_CASE("yarn curve: a relaxed sphere is knitted as its graph says") {
  const Piece piece = example("sphere", "best-rows");
  const Yarn yarn = yarn_of(piece);
  const auto counted = test_support::crossings_of(piece.fabric, piece.at, yarn.curves);
  REQUIRE(counted.knit.all > 1500);
  CHECK(counted.knit.share() >= 0.995);
  CHECK(counted.decrease.share() >= 0.99);
  CHECK(counted.bar.share() >= 0.99);
  CHECK(counted.no_bar == 0);
  CHECK(yarn.counts.half_hitches == 0);
  CHECK(yarn.counts.cuts == 0);
  CHECK(yarn.counts.drawn == 5);
  CHECK(std::abs(length_a_loop(yarn, piece.at.size()) / munden(piece.stitch) - 1.0) < 0.05);
  CHECK(yarn == yarn_of(piece));
}

TEST_CASE("yarn curve: eased, loops that overlap come apart and stay drawn through") {
  // Shaping, where parents' heads lie on each other.
  const Piece piece = tube_of({36, 36, 36, 36, 33, 33, 33, 33, 30, 30, 30, 30, 27, 27, 27, 27});
  const Yarn yarn = yarn_of(piece);
  const auto deep = [&](const Yarn& of) {
    return test_support::overlapping(of.curves, piece.stitch.width, 0.25);
  };
  const Yarn eased = eased_yarn(yarn, piece.stitch.width, 30);
  CHECK(deep(yarn) > 0.03);
  CHECK(deep(eased) < 0.4 * deep(yarn));  // what is left is mostly of the chain at the end
  const auto counted = test_support::crossings_of(piece.fabric, piece.at, eased.curves);
  CHECK(counted.knit.right == counted.knit.all);
  CHECK(counted.decrease.right == counted.decrease.all);
  CHECK(std::abs(length_a_loop(eased, piece.at.size()) / length_a_loop(yarn, piece.at.size()) - 1.0) < 0.04);
  REQUIRE(eased.curves.size() == yarn.curves.size());
  CHECK(eased.curves[0].stitches == yarn.curves[0].stitches);
  CHECK(eased == eased_yarn(yarn, piece.stitch.width, 30));
  CHECK(yarn == eased_yarn(yarn, piece.stitch.width, 0));
}

TEST_CASE("yarn curve: in relaxed examples little of the yarn lies deep in other yarn") {
  for (const auto& [name, preset] : {std::pair{"sphere", "best-rows"},
                                     {"sphere", "knitters-gauge"},
                                     {"egg", "best-rows"},
                                     {"vase", "best-rows"},
                                     {"capsule", "best-rows"}}) {
    CAPTURE(name, preset);
    const Piece piece = example(name, preset);
    const Yarn yarn = yarn_of(piece);
    const Yarn eased = eased_yarn(yarn, piece.stitch.width, 30);
    CHECK(test_support::overlapping(yarn.curves, piece.stitch.width, 0.25) < 0.065);
    CHECK(test_support::overlapping(eased.curves, piece.stitch.width, 0.25) < 0.015);
    const auto counted = test_support::crossings_of(piece.fabric, piece.at, eased.curves);
    CHECK(counted.knit.share() >= 0.995);
    CHECK(counted.decrease.right == counted.decrease.all);
    CHECK(counted.bar.share() >= 0.92);
  }
}
