// autoknit's constraint files. The layouts are those of four of its models; the files are made here.
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "knit/curves/cons_file.h"
#include "tests/support/catch.h"
#include "tests/support/cons_bytes.h"

using namespace knit;
using namespace test_support;

namespace {

// Of so many points; a closed one's last is its first.
ConsChain chain_of(std::size_t points, bool closed, float value, float radius) {
  ConsChain chain{.points = {}, .value = value, .radius = radius};
  for (std::size_t i = 0; i < points; ++i)
    chain.points.emplace_back(0.5 * static_cast<double>(i), value, 0.25 * static_cast<double>(i * i));
  if (closed) chain.points.back() = chain.points.front();
  return chain;
}

std::vector<Cycle> cons_read(const std::string& bytes) {
  auto read = read_cons(bytes);
  if (const auto* said = std::get_if<std::string>(&read)) FAIL(*said);
  return std::get<0>(std::move(read));
}

std::string cons_fault(const std::string& bytes) {
  const auto read = read_cons(bytes);
  const auto* said = std::get_if<std::string>(&read);
  return said == nullptr ? std::string() : *said;
}

std::string elbow_bytes() {
  return cons_bytes({chain_of(2, false, -0.5F, 0.071F), chain_of(2, false, 0.5F, 0.066F)});
}

}  // namespace

TEST_CASE("curves cons: two slots, as of simple-elbow and split-swiss", "[curves]") {
  const std::string bytes = elbow_bytes();
  CHECK(bytes.size() == 80);
  const std::vector<Cycle> cycles = cons_read(bytes);
  REQUIRE(cycles.size() == 2);
  CHECK(cycles[0].as == CycleEnd::start);
  CHECK(cycles[1].as == CycleEnd::end);
  for (const Cycle& cycle : cycles) CHECK(cycle.kind == CycleKind::band);
  CHECK(cycles[0].radius == Approx(0.071));
  CHECK(cycles[1].radius == Approx(0.066));
  CHECK(cycles[1].points == std::vector{glm::dvec3(0.0, 0.5, 0.0), glm::dvec3(0.5, 0.5, 0.25)});
  CHECK(time_of(cycles[0]) == 0.0);
  CHECK(time_of(cycles[1]) == 1.0);
}

TEST_CASE("curves cons: three closed chains, as of misc-cactus", "[curves]") {
  const std::string bytes = cons_bytes(
      {chain_of(17, true, 1.0F, 0.0F), chain_of(17, true, 0.3F, 0.0F), chain_of(17, true, -1.0F, 0.0F)});
  CHECK(bytes.size() == 656);
  const std::vector<Cycle> cycles = cons_read(bytes);
  REQUIRE(cycles.size() == 3);
  for (const Cycle& cycle : cycles) {
    CHECK(cycle.kind == CycleKind::path);
    CHECK(cycle.points.size() == 16);
    CHECK_FALSE(cycle.radius);
  }
  CHECK(cycles[0].as == CycleEnd::end);
  CHECK(cycles[1].as == CycleEnd::end);
  CHECK(cycles[2].as == CycleEnd::start);
  CHECK(time_of(cycles[1]) == Approx(0.65));
}

TEST_CASE("curves cons: slots and a closed chain, as of the bunny", "[curves]") {
  const std::string bytes = cons_bytes(
      {chain_of(3, false, 0.5F, 3.57F), chain_of(3, false, 0.5F, 1.97F), chain_of(9, true, -0.5F, 0.0F)});
  CHECK(bytes.size() == 224);
  const std::vector<Cycle> cycles = cons_read(bytes);
  REQUIRE(cycles.size() == 3);
  CHECK(cycles[0].kind == CycleKind::band);
  CHECK(cycles[0].as == CycleEnd::end);
  CHECK(cycles[1].as == CycleEnd::end);
  CHECK(cycles[2].kind == CycleKind::path);
  CHECK(cycles[2].as == CycleEnd::start);
  CHECK(cycles[2].points.size() == 8);
}

TEST_CASE("curves cons: a point with a radius is a circle", "[curves]") {
  const std::vector<Cycle> cycles = cons_read(cons_bytes({chain_of(1, false, 0.0F, 0.5F)}));
  REQUIRE(cycles.size() == 1);
  CHECK(cycles[0].kind == CycleKind::circle);
  CHECK(cycles[0].radius == 0.5);
}

TEST_CASE("curves cons: cut and other files are refused", "[curves]") {
  const std::string bytes = elbow_bytes();
  CHECK(cons_fault(bytes.substr(0, 50)) == "The constraint file ends within its points.");
  CHECK(cons_fault(bytes.substr(0, 2)) == "Not a constraint file of autoknit: 2 bytes, 8 expected at least.");
  CHECK(cons_fault(bytes.substr(0, 79)) == "Not a constraint file of autoknit: 79 bytes, 80 expected.");
  CHECK(cons_fault(bytes + "x") == "Not a constraint file of autoknit: 81 bytes, 80 expected.");
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_FALSE(cons_fault(bytes.substr(0, size)).empty());

  std::string greedy = bytes;
  greedy[56] = 3;  // points of the first chain: more than there are when the second has its two
  CHECK(cons_fault(greedy) == "The constraint file's chains have more points than it holds.");
  std::string spare = bytes;
  spare[56] = 1;
  CHECK(cons_fault(spare) == "The constraint file's chains use 3 of its 4 points.");
  CHECK(cons_fault(cons_bytes({chain_of(3, false, 0.0F, 0.0F)})) ==
        "Chain 1 of the constraint file is open and has no radius, so it goes round nothing.");
  ConsChain broken = chain_of(2, false, 0.0F, 1.0F);
  broken.points[0].x = std::numeric_limits<double>::infinity();
  CHECK(cons_fault(cons_bytes({broken})) == "The constraint file has a number that is not finite.");
}
