// `knit-mesh check`: lines, summary and exit codes.
#include "app/script/subcommands.h"

#include <nlohmann/json.hpp>

#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::is_one_sentence;

namespace {

const std::string good = "CO 6 sts.\nRnd 1: [K1, m1l] 6 times. (12 sts)\nRnds 2-3: Knit. (12 sts)\nBO all.\n";
const std::string bad = "CO 6 sts.\nRnd 1: [K1, m1l] 6 times. (13 sts)\nRnd 2: Kint. (12 sts)\nBO 12 sts.\n";

Answer answered(const std::vector<std::string>& words) {
  auto parsed = parse_command_line(words, KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<Answer>(parsed));
  return std::get<Answer>(std::move(parsed));
}

}  // namespace

TEST_CASE("check says that every count holds") {
  const Answer answer = check_text(good, "ball");
  CHECK(answer.exit_code == 0);
  CHECK(answer.out ==
        "3 rounds; 4 lines worked, 0 not understood, 0 without instructions: every count holds.\n");
  CHECK(answer.error.empty());
}

TEST_CASE("check prints a line a mistake and a summary") {
  const Answer answer = check_text(bad, "ball");
  CHECK(answer.exit_code == 1);
  CHECK(answer.out ==
        "line 2: Rnd 1 makes 12 stitches, the line says 13.\nline 3: Rnd 2: the word \"kint\" is not known.\n"
        "2 rounds; 3 lines worked, 1 not understood, 0 without instructions: it does not add up.\n");
  CHECK(answer.error.empty());
}

TEST_CASE("check says which line and word it does not understand with an exit code of its own") {
  const Answer answer = check_text("CO 6 sts.\nRnd 1: Kint.\nRnd 2: Knit.\n", "ball");
  CHECK(answer.exit_code == 5);
  CHECK(answer.out ==
        "line 2: Rnd 1: the word \"kint\" is not known.\n"
        "2 rounds; 1 line worked, 2 not understood, 0 without instructions: not understood.\n");
  const Answer json = check_text("CO 6 sts.\nRnd 1: Kint.\n", "ball", CheckForm::json);
  CHECK(json.exit_code == 5);
  const auto told = nlohmann::json::parse(json.out);
  CHECK(told["verdict"] == "not understood");
  CHECK(told["sizes"][0]["lines"][1]["at"] == 7);
  CHECK(told["sizes"][0]["lines"][0]["stitches"] == 6);
}

namespace {

nlohmann::json told_of(const std::string& text, int exit_code) {
  const Answer answer = check_text(text, "ball", CheckForm::json);
  CHECK(answer.exit_code == exit_code);
  CHECK(answer.error.empty());
  return nlohmann::json::parse(answer.out);
}

}  // namespace

TEST_CASE("check --json: a pattern that holds has each line and each round of its pieces") {
  const auto told = told_of("Ball\n" + good, 0);
  CHECK(told["verdict"] == "holds");
  CHECK(told["worked"] == 4);
  CHECK(told["not_understood"] == 0);
  CHECK(told["no_instructions"] == 1);
  CHECK(told["rounds"] == 3);
  REQUIRE(told["sizes"].size() == 1);
  const auto& size = told["sizes"][0];
  CHECK(size["name"] == "");
  CHECK(size["verdict"] == "holds");
  CHECK(size["lines"][0]["verdict"] == "no instruction");
  CHECK_FALSE(size["lines"][0].contains("stitches"));
  CHECK(size["lines"][2] == nlohmann::json({{"line", 3}, {"verdict", "holds"}, {"stitches", 12}}));
  REQUIRE(size["pieces"].size() == 1);
  CHECK(size["pieces"][0]["name"] == "ball");
  CHECK(size["pieces"][0]["made"] == 1);
  CHECK(size["pieces"][0]["flat"] == false);
  std::vector<int> stitches;
  for (const auto& round : size["pieces"][0]["rounds"]) stitches.push_back(round["stitches"].get<int>());
  CHECK(stitches == std::vector{6, 12, 12, 12});
}

TEST_CASE("check --json: what is wrong has its line and sentence and what is left is a remark") {
  const auto told = told_of("CO 6 sts.\nRnd 1: [K1, m1l] 6 times. (13 sts)\n", 1);
  CHECK(told["verdict"] == "does not add up");
  CHECK(told["sizes"][0]["lines"][1]["line"] == 2);
  CHECK(told["sizes"][0]["lines"][1]["sentence"] == "line 2: Rnd 1 makes 12 stitches, the line says 13.");
  CHECK(told_of("CO 6 sts.\nRnd 1: Knit.\n", 0)["remark"] == "6 stitches are on the needles at the end.");
}

TEST_CASE("check --json: each size has its own verdict") {
  const auto told =
      told_of("CO 20 (24) sts.\nRnd 1: [K8 (10), k2tog] 2 times. 18 (23) sts.\nBO 18 (23) sts.\n", 1);
  REQUIRE(told["sizes"].size() == 2);
  CHECK(told["sizes"][0]["name"] == "20");
  CHECK(told["sizes"][0]["verdict"] == "holds");
  CHECK(told["sizes"][1]["name"] == "24");
  CHECK(told["sizes"][1]["verdict"] == "does not add up");
}

TEST_CASE("check --json: several pieces are told apart") {
  const auto told =
      told_of("Head\nCO 6 sts.\nRnd 1: Knit.\nBO.\nLegs (make 2)\nCO 8 sts.\nRow 1: Knit.\nBO.\n", 0);
  const auto& pieces = told["sizes"][0]["pieces"];
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[1]["name"] == "legs");
  CHECK(pieces[1]["made"] == 2);
  CHECK(pieces[1]["flat"] == true);
  CHECK(pieces[1]["rounds"][0] == nlohmann::json({{"line", 6}, {"stitches", 8}}));
}

TEST_CASE("check refuses what is no pattern or cannot be read") {
  for (const char* text : {"", "hello, I am no pattern\n", "v 0 0 0\nf 1 2 3\n", "CO 6 sts\n"}) {
    const Answer answer = check_text(text, "ball");
    CHECK(answer.exit_code == 2);
    CHECK(answer.out.empty());
    CHECK(is_one_sentence(answer.error));
  }
  const test_support::Folder folder;
  for (const std::string& path : {(folder.path() / "missing.txt").string(), folder.path().string()}) {
    const Answer answer = answered({"check", path});
    CHECK(answer.exit_code == 2);
    CHECK(answer.out.empty());
    CHECK(is_one_sentence(answer.error));
  }
}

TEST_CASE("check is a command of the program") {
  const test_support::Folder folder;
  test_support::write_text(folder.path() / "good.txt", good);
  test_support::write_text(folder.path() / "bad.txt", bad);
  CHECK(answered({"check", (folder.path() / "good.txt").string()}).exit_code == 0);
  CHECK(answered({"check", (folder.path() / "bad.txt").string()}).exit_code == 1);
  CHECK(answered({"check"}).exit_code == 2);
  CHECK(answered({"check", ""}).exit_code == 2);
}
