// A rhythm for a whole piece: against plans that are known, and what holds of every plan.
#include "knit/rhythm/rhythm_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/support/catch.h"
#include "tests/support/known_rhythms.h"
#include "tests/support/profile_rows.h"
#include "tests/support/repeated.h"
#include "tests/support/rough_sphere.h"

using namespace knit;
using Catch::Matchers::WithinAbs;
using test_support::Dice;

namespace {

std::vector<double> whole(const test_support::GoldenPiece& piece) {
  std::vector<double> ideals = piece.ideals;
  for (auto row = piece.ideals.size(); ideals.size() < static_cast<std::size_t>(piece.rows); ++row)
    ideals.push_back(piece.ideals[static_cast<std::size_t>(piece.rows) - 1 - row]);
  return ideals;
}

std::vector<double> golden_ideals(std::string_view name) {
  for (const auto& piece : test_support::golden_pieces()) {
    if (piece.name == name) return whole(piece);
  }
  return {};
}

// A curve of a few bulges between two ends that are poles or openings.
std::vector<double> random_profile(Dice& dice) {
  const std::size_t rows = 3 + dice.below(dice.below(10) == 0 ? 80 : 35);
  const double belt = dice.between(6.0, dice.below(10) == 0 ? 120.0 : 50.0);
  std::vector<double> knots{dice.below(2) == 0 ? 3.0 : dice.between(3.0, belt)};
  const std::size_t bulges = 1 + dice.below(4);
  for (std::size_t i = 0; i < bulges; ++i) knots.push_back(dice.between(0.3, 1.0) * belt);
  knots.push_back(dice.below(2) == 0 ? 3.0 : dice.between(3.0, belt));
  std::vector<double> ideals;
  for (std::size_t row = 0; row < rows; ++row) {
    const double at =
        static_cast<double>(row) / static_cast<double>(rows - 1) * (static_cast<double>(knots.size()) - 1.0);
    const auto knot = std::min(static_cast<std::size_t>(at), knots.size() - 2);
    const double part = at - static_cast<double>(knot);
    const double smooth = part * part * (3.0 - 2.0 * part);
    ideals.push_back(std::lerp(knots[knot], knots[knot + 1], smooth));
  }
  if (dice.below(4) == 0) {  // mirrored
    for (std::size_t row = 0; row < rows / 2; ++row) ideals[rows - 1 - row] = ideals[row];
  }
  return ideals;
}

RhythmSettings random_settings(Dice& dice) {
  RhythmSettings settings;
  settings.style = static_cast<RhythmStyle>(dice.below(4));
  settings.changes = dice.below(3) == 0 ? static_cast<std::int32_t>(3 + dice.below(10)) : 0;
  settings.tolerance = dice.between(1.0, 8.0);
  settings.fit_size = dice.below(2) == 0 ? FitSize::on : FitSize::off;
  settings.dial = rhythm_dials()[dice.below(rhythm_dials().size())];
  return settings;
}

// From "+8/2x6; knit 16; -8/2x6'".
std::vector<RhythmSegment> segments_of(std::string_view text) {
  std::vector<RhythmSegment> segments;
  std::istringstream in{std::string(text)};
  std::string word;
  while (in >> word) {
    RhythmSegment segment;
    if (word == "knit") {
      in >> segment.rows;
      in.ignore();
    } else {
      segment.kind = word.find('\'') == std::string::npos ? SegmentKind::pre : SegmentKind::post;
      char between = ' ';
      std::istringstream(word) >> segment.change >> between >> segment.rows >> between >> segment.times;
    }
    segments.push_back(segment);
  }
  return segments;
}

// The same counts in as many segments; in the same words too, unless those are equally good.
void check_same(const RhythmPlan& plan, std::int32_t first, std::string_view segments,
                std::size_t& other_words) {
  const std::vector<RhythmSegment> known = segments_of(segments);
  CHECK(segments_text(known) == segments);
  CHECK(plan.counts == counts_of(first, known));
  CHECK(plan.segments.size() == known.size());
  other_words += plan.segments == known ? 0 : 1;
}

// What is wrong with a plan of these ideals, by the rules that every plan keeps; empty: nothing.
std::string fault_of(const RhythmPlan& plan, const std::vector<double>& ideals) {
  if (plan.counts.size() != ideals.size() || plan.roles.size() != ideals.size()) return "rows";
  if (counts_of(plan.counts.front(), plan.segments) != plan.counts) return "segments";
  for (std::size_t row = 0; row < plan.counts.size(); ++row) {
    const std::int32_t count = plan.counts[row];
    if (count < 1 || count % plan.sections != 0) return "no whole sections in row " + std::to_string(row);
    if (row == 0) continue;
    const std::int32_t before = plan.counts[row - 1];
    if (count > 2 * before || 2 * count < before) return "more than double, or less than half";
    if (!may_change(before / plan.sections, (count - before) / plan.sections)) return "no room in a section";
    if ((plan.roles[row] == RowRole::change) != (count != before))
      return "role of row " + std::to_string(row);
    if (std::abs(count - before) > plan.changes) return "changes by too many";
  }
  std::vector<std::int32_t> reversed(plan.counts.rbegin(), plan.counts.rend());
  if (is_mirrored(ideals) && reversed != plan.counts) return "not mirrored";
  return {};
}

// Of a plan's cost what the dial scales.
double dial_part(const RhythmPlan& plan, const RhythmPrices& prices) {
  // Of a plan that mirrors the plain stretch in the middle is in its half only if that is long enough; recounted there.
  std::vector<RhythmSegment> segments = plan.segments;
  double both = 1.0;
  if (plan.mirrored) {
    both = 2.0;
    const auto half = static_cast<std::int32_t>((plan.counts.size() + 1) / 2) - 1;
    std::int32_t used = 0;
    std::vector<RhythmSegment> opening;
    for (const RhythmSegment& segment : segments) {
      if (used >= half) break;
      opening.push_back(segment);
      used += segment.length();
    }
    segments = opening;
  }
  double sum = 0.0;
  for (const RhythmSegment& segment : segments) {
    const bool single = prices.single > 0.0 && std::abs(segment.change) == plan.sections;
    sum += segment.change == 0 ? prices.plain : prices.rhythm + (single ? prices.single : 0.0);
  }
  return both * sum;
}

}  // namespace

TEST_CASE("a rhythm of one family is the known one") {
  std::size_t other_words = 0;
  for (const auto& known : test_support::golden_plans()) {
    INFO(known.piece << " " << known.sections << " x " << known.each);
    const std::vector<double> ideals = golden_ideals(known.piece);
    REQUIRE(!ideals.empty());
    const RhythmFamily family{known.sections, known.each == 1, known.each == 2};
    const auto plan = plan_family(ideals, family, 1.0);
    REQUIRE(plan);
    check_same(*plan, known.first, known.segments, other_words);
    CHECK_THAT(plan->cost, WithinAbs(known.cost, 1e-4));
    CHECK_THAT(plan->seen.local, WithinAbs(known.seen_local, 2e-4));
    CHECK_THAT(plan->seen.belt, WithinAbs(known.seen_belt, 2e-4));
    CHECK(fault_of(*plan, ideals).empty());
  }
  CHECK(other_words <= 3);
}

TEST_CASE("of families, dials and sizes the known one is chosen, always within the tolerance") {
  std::size_t other_words = 0;
  const std::vector<test_support::ChosenPlan> all = test_support::chosen_plans();
  for (std::size_t i = 0; i < all.size(); i += test_support::whole() ? 1 : 10) {
    const test_support::ChosenPlan& known = all[i];
    INFO(known.shape << " " << known.size_cm << " cm, " << known.gauge_stitches << "x" << known.gauge_rounds
                     << (known.pairs ? " pairs" : " lines"));
    const auto at = [&](double size) {
      return test_support::rows_of_curve(known.shape, size * known.size_cm,
                                         {known.gauge_stitches, known.gauge_rounds});
    };
    RhythmSettings settings;
    settings.style = known.pairs ? RhythmStyle::pairs : RhythmStyle::lines;
    const auto plan = plan_rhythm(at, settings);
    REQUIRE(plan);
    CHECK(plan->within);
    CHECK(plan->changes == known.changes);
    check_same(*plan, known.first, known.segments, other_words);
    CHECK(plan->counts.size() == static_cast<std::size_t>(known.rows));
    CHECK_THAT(plan->seen.local, WithinAbs(known.seen_local, 0.051));
    CHECK_THAT(plan->seen.rms, WithinAbs(known.seen_rms, 0.051));
    CHECK_THAT(plan->seen.belt, WithinAbs(known.seen_belt, 0.051));
    CHECK(plan->seen.worst() <= 3.5);
    CHECK(std::abs(plan->size - 1.0) <= 0.04);
    CHECK(fault_of(*plan, at(plan->size)).empty());
  }
  CHECK(other_words <= 3);
}

TEST_CASE("a ball of 12 cm is five lines") {
  const auto plan = plan_rhythm(resized_ideals(golden_ideals("sphere")), {});
  REQUIRE(plan);
  CHECK(segments_text(plan->segments) == "+8/2x6; +8/3x3; knit 16; -8/3x3'; -8/2x6'");
  CHECK(plan->sections == 4);
  CHECK(plan->changes == 8);
  CHECK(plan->mirrored);
  CHECK(*std::max_element(plan->counts.begin(), plan->counts.end()) == 80);
}

TEST_CASE("every plan of random profiles keeps the rules") {
  Dice dice(20);
  std::size_t planned = 0;
  std::size_t mirrored = 0;
  const int cases = test_support::repeated(10000);
  for (int i = 0; i < cases; ++i) {
    const IdealsAt ideals = resized_ideals(random_profile(dice));
    const auto plan = plan_rhythm(ideals, random_settings(dice));
    if (!plan) continue;
    ++planned;
    mirrored += plan->mirrored ? 1 : 0;
    const std::string fault = fault_of(*plan, ideals(plan->size));
    if (!fault.empty()) FAIL_CHECK("case " << i << ": " << fault);
  }
  CHECK(planned > static_cast<std::size_t>(cases) * 9 / 10);
  CHECK(mirrored > static_cast<std::size_t>(cases) / 20);
}

TEST_CASE("a cheaper rhythm never makes a plan worse within a family") {
  Dice dice(7);
  for (int i = 0; i < test_support::repeated(300); ++i) {
    const std::vector<double> ideals = random_profile(dice);
    const std::array families{RhythmFamily{4, false, true}, RhythmFamily{4, true, true},
                              RhythmFamily{5, true, false}};
    const RhythmFamily family = families[dice.below(families.size())];
    double before = std::numeric_limits<double>::infinity();
    for (const double dial : rhythm_dials()) {
      const auto plan = plan_family(ideals, family, dial);
      REQUIRE(plan);
      const double shape = plan->cost - dial_part(*plan, rhythm_prices(family, dial, ideals));
      CHECK(shape <= before * (1.0 + 1e-9) + 1e-6);
      before = shape;
    }
  }
}

TEST_CASE("a plan from a row that is made is what is left of the whole plan") {
  for (const char* name : {"egg", "vase", "cone"}) {
    const std::vector<double> ideals = golden_ideals(name);
    const RhythmFamily family{8, true, false};
    const auto plan = plan_family(ideals, family, 1.0);
    REQUIRE(plan);
    std::int32_t row = 0;
    for (std::size_t i = 0; i < plan->segments.size(); ++i) {
      const RhythmSegment& done = plan->segments[i];
      row += done.length();
      const SegmentEnd ended = done.kind == SegmentKind::plain ? SegmentEnd::plain
                               : done.kind == SegmentKind::pre ? SegmentEnd::changed
                                                               : SegmentEnd::rested;
      const std::int32_t count = plan->counts[static_cast<std::size_t>(row)];
      const auto rest = plan_family(ideals, family, 1.0, {row, count, ended});
      REQUIRE(rest);
      INFO(name << " from row " << row);
      CHECK(rest->segments ==
            std::vector<RhythmSegment>(plan->segments.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                       plan->segments.end()));
      CHECK(rest->counts == std::vector<std::int32_t>(plan->counts.begin() + row, plan->counts.end()));
    }
  }
}

TEST_CASE("a large piece is looked at in small first and planned as it would be at once") {
  const std::vector<double> large = resized_ideals(golden_ideals("sphere"))(8.0);
  RhythmSettings settings;
  settings.fit_size = FitSize::off;
  settings.dial = 0.2;
  double share = 0.0;
  std::ptrdiff_t heard = 0;
  const auto plan = plan_rhythm(resized_ideals(large), settings, {}, [&](double now) {
    CHECK(now >= share);
    share = now;
    ++heard;
  });
  REQUIRE(plan);
  // Every row of half the ball is heard once an attempt: eight in small, two at full size.
  CHECK(heard < 3 * std::ssize(large));
  const auto as_planned = [&](bool one) {
    const auto alone = plan_family(large, {plan->sections, one, true}, settings.dial);
    return alone && alone->counts == plan->counts;
  };
  CHECK((as_planned(false) || as_planned(true)));
}

TEST_CASE("what a person asks for is kept: the changes, the first count, the size") {
  const std::vector<double> ideals = golden_ideals("egg");
  RhythmSettings settings;
  settings.changes = 6;
  settings.fit_size = FitSize::off;
  auto plan = plan_rhythm(resized_ideals(ideals), settings);
  REQUIRE(plan);
  CHECK(plan->changes == 6);
  CHECK(plan->sections == 3);
  CHECK(plan->size == 1.0);

  settings.changes = 7;  // no pairs of these: one a section
  plan = plan_rhythm(resized_ideals(ideals), settings);
  REQUIRE(plan);
  CHECK(plan->sections == 7);

  settings.changes = 0;
  plan = plan_rhythm(resized_ideals(ideals), settings, {0, 10});
  REQUIRE(plan);
  CHECK(plan->counts.front() == 10);
  CHECK(fault_of(*plan, ideals).empty());
  CHECK(!plan_rhythm(resized_ideals(ideals), settings, {0, 11}));
}

TEST_CASE("without a plan within the tolerance the nearest is given, and where it is off") {
  RhythmSettings settings;
  settings.tolerance = 0.1;
  const std::vector<double> ideals = golden_ideals("egg");
  const auto plan = plan_rhythm(resized_ideals(ideals), settings);
  REQUIRE(plan);
  CHECK(!plan->within);
  const std::vector<double> sized = resized_ideals(ideals)(plan->size);
  const double off = std::abs(seen_deviations(plan->counts, sized)[static_cast<std::size_t>(plan->seen.row)]);
  const double against = plan->seen.local >= plan->seen.belt ? sized[static_cast<std::size_t>(plan->seen.row)]
                                                             : *std::max_element(sized.begin(), sized.end());
  CHECK_THAT(plan->seen.worst(), WithinAbs(100.0 * off / against, 1e-9));
}

TEST_CASE("a narrow piece has a rhythm too") {
  for (const double belt : {3.0, 5.0, 9.0, 13.0}) {
    const std::vector<double> ideals(12, belt);
    for (const RhythmStyle style : {RhythmStyle::pairs, RhythmStyle::lines}) {
      RhythmSettings settings;
      settings.style = style;
      const auto plan = plan_rhythm(resized_ideals(ideals), settings);
      REQUIRE(plan);
      CHECK(plan->counts.front() >= 3);
      CHECK(std::abs(plan->counts[6] - belt) < 3.0);
    }
  }
}

TEST_CASE("a larger piece has more rows, and the same shape") {
  const IdealsAt at = resized_ideals(golden_ideals("sphere"));
  const std::vector<double> asked = at(1.0);
  CHECK(asked == golden_ideals("sphere"));
  for (const double size : {0.96, 1.02, 1.04}) {
    const std::vector<double> sized = at(size);
    CHECK(sized.size() == static_cast<std::size_t>(std::round(60.0 * size)) - 1);
    CHECK_THAT(*std::max_element(sized.begin(), sized.end()), WithinAbs(82.88 * size, 0.1));
    CHECK_THAT(sized.front(), WithinAbs(asked.front(), 0.3));
    CHECK_THAT(sized.back(), WithinAbs(asked.back(), 0.3));
    CHECK(is_mirrored(sized));
  }
}
