// Parts of reading lessons: deeds, what is waited for, settings. lesson_read.cpp puts them together.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/core/json_fields.h"
#include "app/core/lesson.h"

namespace app {

// What is missing is said in a lesson author's words.
void need(JsonFields& fields, const std::string& key);
std::string need_text(JsonFields& fields, const std::string& key);  // not empty either
std::int64_t need_whole(JsonFields& fields, const std::string& key, std::int64_t low, std::int64_t high);
const nlohmann::json& need_array(JsonFields& fields, const std::string& key);
std::string joined(std::span<const std::string_view> words);  // "a, b, c"

Settings read_settings(JsonFields& fields, const std::string& key);
std::vector<Deed> read_deeds(JsonFields& page);  // its "do"
Wait read_wait(JsonFields fields);

}  // namespace app
