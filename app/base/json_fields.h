// Reading a JSON object that somebody may have written by hand: every field is asked for by name and kind, and
// the first that is missing or wrong is remembered as one sentence. Nothing throws.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace app {

class JsonFields {
 public:
  // `where`: the object's own name in sentences, "camera"; empty for the whole file. The JSON must outlive this.
  explicit JsonFields(const nlohmann::json& object, std::string where = "");

  // Shared by all objects taken from the same one; empty while all went well.
  [[nodiscard]] const std::string& fault() const { return *fault_; }
  void set_fault(const std::string& key, const std::string& words);

  [[nodiscard]] bool has(const std::string& key) const;
  // After a fault these give the lowest value there is.
  double number(const std::string& key, double low, double high);
  std::int64_t whole(const std::string& key, std::int64_t low, std::int64_t high);
  bool flag(const std::string& key);
  std::string text(const std::string& key);
  std::size_t choice(const std::string& key, std::span<const std::string_view> names);  // its index
  JsonFields object(const std::string& key);
  // Empty, not null, after a fault.
  const nlohmann::json& array(const std::string& key);
  // The object that stands at `index` of the array `key`.
  JsonFields entry(const std::string& key, std::size_t index);
  [[nodiscard]] const nlohmann::json& json() const { return *object_; }
  [[nodiscard]] std::string name_of(const std::string& key) const;  // "camera.distance"

 private:
  JsonFields(const nlohmann::json* object, std::string where, std::shared_ptr<std::string> fault);
  // Null, and a fault, where it is missing.
  const nlohmann::json* find(const std::string& key);

  const nlohmann::json* object_;
  std::string where_;
  std::shared_ptr<std::string> fault_;
  std::shared_ptr<const nlohmann::json> nothing_;
};

}  // namespace app
