#include "app/core/step_json.h"

#include "knit/narrate.h"
#include "knit/step_fields.h"

namespace app {

namespace {

struct ParameterValue {
  const knit::Parameters& p;
  const knit::ParameterInfo& info;
  using Json = nlohmann::ordered_json;
  Json operator()(const knit::Number& number) const {
    const bool automatic = number.zero == knit::Zero::means_auto && p.*number.field == 0.0;
    return automatic ? Json("auto") : Json(p.*number.field);
  }
  Json operator()(const knit::Count& count) const {
    return count.zero_means_auto && p.*count.field == 0 ? Json("auto") : Json(p.*count.field);
  }
  Json operator()(const knit::PickedVertex& picked) const {
    return p.*picked.field == knit::no_vertex ? Json("auto") : Json(p.*picked.field);
  }
  Json operator()(const knit::AxisChoice& /*axis*/) const { return knit::value_text(info, p); }
  Json operator()(const knit::DirectionChoice& /*direction*/) const { return knit::value_text(info, p); }
  Json operator()(const knit::GaugeChoice& /*gauge*/) const { return knit::value_text(info, p); }
  Json operator()(const knit::Choice& /*choice*/) const { return knit::value_text(info, p); }
};

}  // namespace

nlohmann::ordered_json to_json(const knit::Parameters& parameters) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const knit::ParameterInfo& info : knit::parameter_table()) {
    json[std::string(info.key)] = std::visit(ParameterValue{parameters, info}, info.kind);
  }
  return json;
}

nlohmann::ordered_json to_json(const knit::Step& step, std::size_t index,
                               const knit::Parameters& parameters) {
  nlohmann::ordered_json json;
  json["step"] = index;
  json["stage"] = knit::name_of(step.place.stage);
  json["row"] = step.place.row;
  json["item"] = step.place.item;
  json["kind"] = knit::kind_name(step);
  for (const knit::StepField& field : knit::fields_of(step)) {
    std::visit([&](const auto& value) { json[std::string(field.name)] = value; }, field.value);
  }
  json["what"] = knit::narrate(step, parameters);
  return json;
}

}  // namespace app
