#include "knit/insight/step_fields.h"

namespace knit {

namespace {

struct NumbersOf {
  StepFields operator()(const Stopped& s) const {
    return {{"reason", name_of(s.reason)},
            {"level", s.level},
            {"count", s.count},
            {"value", s.value},
            {"time", s.time},
            {"other", s.other},
            {"vertex", s.vertex}};
  }
  StepFields operator()(const auto& event) const { return event.numbers(); }
};

}  // namespace

StepFields fields_of(const Step& step) { return visit_event(NumbersOf{}, step.what); }

}  // namespace knit
