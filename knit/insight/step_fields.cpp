#include "knit/insight/step_fields.h"

namespace knit {

namespace {

struct NumbersOf {
  StepFields operator()(const Stopped& s) const {
    // What these are depends on the reason.
    return {{"reason", nullptr, name_of(s.reason)},
            {"level", nullptr, s.level},
            {"count", nullptr, s.count},
            {"value", nullptr, s.value},
            {"time", nullptr, s.time},
            {"other", nullptr, s.other},
            {"vertex", nullptr, s.vertex}};
  }
  StepFields operator()(const auto& event) const { return event.numbers(); }
};

}  // namespace

StepFields fields_of(const Step& step) { return visit_event(NumbersOf{}, step.what); }

}  // namespace knit
