// The suite's figures as tables in a page of the docs, between two marks; the rest of the page is left alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace benchmark {

// The error is one sentence.
std::optional<std::string> write_table(const std::filesystem::path& suite, const std::filesystem::path& page);

}  // namespace benchmark
