// A value of each parameter that is not its default, so that a new parameter needs no line in the tests.
#pragma once

#include <string>

#include "knit/model/settings_table.h"

namespace test_support {

struct SampleText {
  std::string operator()(const knit::Number& number) const {
    const double high = number.high >= knit::no_limit ? 0.08 : number.high;
    const double middle = number.low + 0.5 * (high - number.low);
    const bool usual = middle == number.get(knit::Parameters{});
    return knit::number_text(usual ? number.low + 0.25 * (high - number.low) : middle);
  }
  std::string operator()(const knit::Count& count) const { return std::to_string(count.low + 5); }
  std::string operator()(const knit::PickedVertex& /*picked*/) const { return "7"; }
  std::string operator()(const knit::AxisChoice& /*axis*/) const { return "0.5,1,0"; }
  std::string operator()(const knit::DirectionChoice& /*direction*/) const { return "1,0,0"; }
  std::string operator()(const knit::GaugeChoice& /*gauge*/) const { return "24,30"; }
  std::string operator()(const knit::Choice& choice) const {
    const auto usual = static_cast<std::size_t>(choice.get(knit::Parameters{}));
    return std::string(choice.names[usual == 0 ? choice.names.size() - 1 : 0]);
  }
};

inline std::string sample_of(const knit::ParameterInfo& info) { return std::visit(SampleText{}, info.kind); }

}  // namespace test_support
