#include "app/explain/step_table.h"

#include <algorithm>

#include "knit/insight/step_fields.h"
#include "knit/model/words.h"
#include "knit/rows/row_variables.h"
#include "knit/stitches/stitch_variables.h"
#include "knit/timing/timing_variables.h"

namespace app {

namespace {

// Places in a ring or a larger row: steps have them from 0, as the files of steps do; whoever reads counts from 1.
bool is_place(const knit::CodeVariable* variable) {
  return variable == &knit::var::cell || variable == &knit::var::partner || variable == &knit::var::order;
}

struct FieldText {
  const knit::CodeVariable* variable;

  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(std::int64_t value) const {
    if (is_place(variable)) return std::to_string(value + 1);
    // One tube all the way: no level splits.
    return value < 0 && variable == &knit::var::split_level ? "none" : std::to_string(value);
  }
  std::string operator()(double value) const { return knit::short_number(value); }
  std::string operator()(const std::string& value) const { return value; }
};

}  // namespace

std::vector<std::pair<std::string, std::string>> numbers_of(const knit::Step& step) {
  std::vector<std::pair<std::string, std::string>> numbers;
  for (const knit::StepField& field : knit::fields_of(step)) {
    std::string name(field.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    numbers.emplace_back(std::move(name), std::visit(FieldText{field.variable}, field.value));
  }
  return numbers;
}

}  // namespace app
