#include "app/explain/fit_size.h"

#include <algorithm>
#include <cmath>

#include "knit/model/stitch_size.h"
#include "knit/model/words.h"

namespace app {

namespace {

std::string why_not(const knit::Timeline& timeline) {
  const knit::State& state = timeline.furthest();
  if (timeline.parameters().rhythm.counts == knit::CountPlanning::whole)
    return "The size is fitted to counts in a rhythm; choose those first (--counts rhythm).";
  if (!timeline.edits().empty())
    return "The size is fitted from the start; take back what was changed on the way first.";
  if (timeline.parameters().rows.cast_on != 0)
    return "The size is fitted where the cast on is left to the rhythm; set it to auto first (--cast-on "
           "auto).";
  if (state.stage() == knit::Stage::timing || (state.stage() == knit::Stage::tubes && !state.tubes))
    return "The size is fitted once the tubes are planned; go on to the rows first.";
  if (!state.tubes)
    return "The size is fitted where rows come from contours; choose those first (--rows contours).";
  const auto tubes = static_cast<std::int64_t>(state.tubes->tubes.size());
  if (tubes != 1)
    return "The size is fitted where the piece is one tube; this one has " + std::to_string(tubes) + ".";
  return {};
}

std::string rounded_text(double value, double digits) {
  return knit::short_number(std::round(digits * value) / digits);
}

std::string fitted_words(const knit::SizeFit& fit, const knit::Parameters& asked,
                         const knit::Parameters& taken) {
  const bool gauge = asked.size.from() == knit::SizesFrom::gauge;
  const std::string size = gauge ? rounded_text(asked.size.height_cm, 100.0) + " cm asked, " +
                                       rounded_text(taken.size.height_cm, 100.0) + " cm taken"
                                 : "a stitch width of " + knit::short_number(asked.stitch.width) +
                                       " asked, " + rounded_text(taken.stitch.width, 1e6) + " taken";
  const auto& counts = fit.fitted.counts;
  const std::int32_t widest = *std::max_element(counts.begin(), counts.end());
  return "Fitted: " + size + ". The widest row has room for " + knit::stitch_count_text(widest) + " there, " +
         knit::plural(fit.fitted.sections, "section", "sections") + " of " +
         std::to_string(widest / fit.fitted.sections) + ".";
}

}  // namespace

std::variant<FittedSize, std::string> fitted_size(const knit::Timeline& timeline) {
  if (std::string why = why_not(timeline); !why.empty()) return why;
  const knit::Parameters& asked = timeline.parameters();
  std::vector<double> ideals;
  for (const double length : timeline.furthest().tubes->tubes.front().lengths)
    ideals.push_back(length / asked.stitch.width);
  const auto fit = ideals.empty() ? std::nullopt : knit::fit_size(ideals, asked.rhythm);
  if (!fit)
    return FittedSize{asked, "No other size within 4 % has a rhythm that reads better; it stays as it is."};
  FittedSize fitted{asked, {}};
  knit::give_size(fitted.parameters, fit->fitted.size);
  fitted.words = fitted_words(*fit, asked, fitted.parameters);
  return fitted;
}

}  // namespace app
