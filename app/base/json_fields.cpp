#include "app/base/json_fields.h"

#include <algorithm>
#include <utility>

#include "knit/import/quoting.h"
#include "knit/model/settings_table.h"

namespace app {

using Json = nlohmann::json;

namespace {

constexpr std::size_t longest_name = 80;  // in a message

}  // namespace

JsonFields::JsonFields(const Json& object, std::string where)
    : JsonFields(&object, std::move(where), std::make_shared<std::string>()) {}

JsonFields::JsonFields(const Json* object, std::string where, std::shared_ptr<std::string> fault)
    : object_(object),
      where_(std::move(where)),
      fault_(std::move(fault)),
      nothing_(std::make_shared<const Json>(Json::array())) {
  if (object_->is_object()) return;
  if (fault_->empty())
    *fault_ = where_.empty()
                  ? "it is no JSON object."
                  : "\"" + knit::printable_start(where_, longest_name) + "\" must be an object, { ... }.";
}

std::string JsonFields::name_of(const std::string& key) const {
  return where_.empty() ? key : where_ + "." + key;
}

void JsonFields::set_fault(const std::string& key, const std::string& words) {
  if (fault_->empty()) *fault_ = "\"" + knit::printable_start(name_of(key), longest_name) + "\" " + words;
}

bool JsonFields::has(const std::string& key) const { return object_->is_object() && object_->contains(key); }

const Json* JsonFields::find(const std::string& key) {
  if (!has(key)) {
    set_fault(key, "is missing; add it, or save the file again.");
    return nullptr;
  }
  return &(*object_)[key];
}

double JsonFields::number(const std::string& key, double low, double high) {
  const Json* value = find(key);
  const double number = value != nullptr && value->is_number() ? value->get<double>() : low - 1.0;
  if (number >= low && number <= high) return number;
  set_fault(key, "must be a number from " + knit::number_text(low) + " to " + knit::number_text(high) + ".");
  return low;
}

std::int64_t JsonFields::whole(const std::string& key, std::int64_t low, std::int64_t high) {
  const Json* value = find(key);
  const bool is_whole =
      value != nullptr && value->is_number_integer() &&
      !(value->is_number_unsigned() && value->get<std::uint64_t>() > static_cast<std::uint64_t>(high));
  const std::int64_t number = is_whole ? value->get<std::int64_t>() : low;
  if (is_whole && number >= low && number <= high) return number;
  set_fault(key, "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) + ".");
  return low;
}

bool JsonFields::flag(const std::string& key) {
  const Json* value = find(key);
  if (value != nullptr && value->is_boolean()) return value->get<bool>();
  set_fault(key, "must be true or false.");
  return false;
}

std::string JsonFields::text(const std::string& key) {
  const Json* value = find(key);
  if (value != nullptr && value->is_string()) return value->get<std::string>();
  set_fault(key, "must be text in quotes.");
  return "";
}

std::size_t JsonFields::choice(const std::string& key, std::span<const std::string_view> names) {
  const std::string name = text(key);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string all;
  for (const std::string_view known : names) all.append(all.empty() ? "" : ", ").append(known);
  set_fault(key, "must be one of " + all + ".");
  return 0;
}

JsonFields JsonFields::object(const std::string& key) {
  const Json* value = find(key);
  return {value != nullptr ? value : nothing_.get(), name_of(key), fault_};
}

const Json& JsonFields::array(const std::string& key) {
  const Json* value = find(key);
  if (value != nullptr && value->is_array()) return *value;
  set_fault(key, "must be a list, [ ... ].");
  return *nothing_;
}

JsonFields JsonFields::entry(const std::string& key, std::size_t index) {
  return {&array(key)[index], name_of(key) + "[" + std::to_string(index) + "]", fault_};
}

}  // namespace app
