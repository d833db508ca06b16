#include "app/explain/step_table.h"

#include <algorithm>

#include "knit/insight/step_fields.h"
#include "knit/model/words.h"
#include "knit/timing/timing_variables.h"

namespace app {

namespace {

struct FieldText {
  const knit::CodeVariable* variable;

  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(std::int64_t value) const {
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
