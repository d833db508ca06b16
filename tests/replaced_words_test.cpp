// All that the program may say: no string has one of the words that were replaced by the field's.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/session.h"

namespace {

namespace fs = std::filesystem;

struct Replaced {
  std::string_view words, by;
};
constexpr std::array replaced{Replaced{"anew", "again"},
                              Replaced{"in the making", "in progress"},
                              Replaced{"at hand", "current"},
                              Replaced{"lately", "recent"},
                              Replaced{"shared out", "distributed"},
                              Replaced{"share out", "distribute"},
                              Replaced{"beside the window", "in the background"},
                              Replaced{"dear", "expensive"},
                              Replaced{"mend", "repair"},
                              Replaced{"mends", "repairs"},
                              Replaced{"a thing", "an element"},
                              Replaced{"no thing", "no element"},
                              Replaced{"such thing", "such element"},
                              Replaced{"happening", "event"},
                              Replaced{"fault", "error"},
                              Replaced{"faults", "errors"},
                              Replaced{"wish", "request"},
                              Replaced{"wishes", "requests"},
                              Replaced{"reader", "checker"},
                              Replaced{"ground of their own", "background"},
                              Replaced{"without a ground", "without a background"},
                              Replaced{"square brackets", "[ ]"},
                              Replaced{"in brackets", "in parentheses"},
                              Replaced{"second pair of eyes", "checker"},
                              Replaced{"times the vertices", "assigns every vertex a time"}};

// The old name of an option and a field of session files, which stay.
constexpr std::array<std::string_view, 2> stay{"--repair,--mend", "mends"};

bool is_word_byte(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_'; }

// As a word of its own, in any case.
bool has_words(const std::string& text, std::string_view words) {
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    const bool begins = at == 0 || !is_word_byte(text[at - 1]);
    const std::size_t end = at + words.size();
    if (begins && (end == text.size() || !is_word_byte(text[end]))) return true;
  }
  return false;
}

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// What stands in quotes in C++ or JSON, neighbours joined; comments and what is included are left out. In small letters.
std::vector<std::string> strings_of(const std::string& code) {
  std::vector<std::string> strings;
  bool joins = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code.compare(i, 2, "//") == 0 || code.compare(i, 8, "#include") == 0) {
      i = code.find('\n', i);
      if (i == std::string::npos) break;
    } else if (code[i] == '\'' && i + 2 < code.size() && (code[i + 2] == '\'' || code[i + 1] == '\\')) {
      i = code.find('\'', i + (code[i + 1] == '\\' ? 3 : 2));
      joins = false;
    } else if (code[i] == '"') {
      std::string text;
      for (++i; i < code.size() && code[i] != '"'; ++i) {
        if (code[i] == '\\') ++i;
        text += code[i];
      }
      if (joins) strings.back() += text;
      if (!joins) strings.push_back(text);
      joins = true;
    } else if (std::isspace(static_cast<unsigned char>(code[i])) == 0) {
      joins = false;
    }
  }
  for (std::string& text : strings) text = small(text);
  return strings;
}

}  // namespace

TEST_CASE("strings are found in code, joined, without what is commented or included") {
  CHECK(strings_of("// \"no\"\n#include \"no.h\"\nf(\"One \"\n  \"two\", '\"', \"three\");") ==
        std::vector<std::string>{"one two", "three"});
  CHECK(has_words("made anew.", "anew"));
  CHECK_FALSE(has_words("renewed", "new"));
}

TEST_CASE("no string has a word that was replaced") {
  std::size_t read = 0;
  for (const char* folder : {"app", "knit", "assets/lessons"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KNIT_SOURCE_DIR) / folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".cpp" && ending != ".h" && ending != ".json") continue;
      for (const std::string& text : strings_of(test_support::read_text(entry.path()))) {
        ++read;
        if (std::find(stay.begin(), stay.end(), text) != stay.end()) continue;
        for (const Replaced& word : replaced) {
          if (!has_words(text, word.words)) continue;
          INFO(entry.path().filename().string() << ": \"" << text << "\"; say " << word.by);
          CHECK(false);
        }
      }
    }
  }
  CHECK(read > 3000);
}

TEST_CASE("the words that were agreed on are said") {
  std::string all;
  for (const char* folder : {"app", "knit"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KNIT_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      for (const std::string& text : strings_of(test_support::read_text(entry.path())))
        all += "\n" + text + "\n";
    }
  }
  for (const char* whole : {"apply changes", "from the start", "from this step", "recent", "background",
                            "custom", "repeat the instructions in [ ] the total number of times given."}) {
    INFO(whole);
    CHECK(all.find("\n" + std::string(whole) + "\n") != std::string::npos);
  }
  CHECK(all.find("must be smaller than the stitch width") != std::string::npos);
  CHECK(all.find("in parentheses") != std::string::npos);
}
