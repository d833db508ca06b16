// Words from files in messages.
#include "knit/import/quoting.h"

#include "tests/support/catch.h"

using namespace knit;

TEST_CASE("quoting: a name keeps its letters and loses what breaks a line or speaks to a terminal") {
  CHECK(printable("Mütze 1.obj") == "Mütze 1.obj");
  CHECK(printable("two\nlines\x1b[31m\x7f") == "two?lines?[31m?");
  CHECK(printable("").empty());
}

TEST_CASE("quoting: a long name is cut between characters") {
  CHECK(printable_start("sphere", 6) == "sphere");
  CHECK(printable_start("spheres", 6) == "sphere...");
  CHECK(printable_start("abü", 3) == "abü");
  CHECK(printable_start("abücd", 3) == "abü...");
}

TEST_CASE("quoting: a word is short, printable and in quotation marks") {
  CHECK(knit::quoted("vt") == "\"vt\"");
  CHECK(knit::quoted("a\tü") == "\"a???\"");
  CHECK(knit::quoted(std::string(25, 'x')) == "\"" + std::string(24, 'x') + "...\"");
}
