#include "app/files/pattern_export.h"

#include <nlohmann/json.hpp>

#include "app/base/text.h"
#include "knit/run/timeline.h"
#include "tests/support/catch.h"
#include "tests/support/hand_rounds.h"
#include "tests/support/run.h"
#include "tests/support/session.h"
#include "tests/support/xml_check.h"

using namespace app;
using namespace test_support;
using nlohmann::json;

namespace {

knit::Hand hand_called(const std::string& word) {
  const std::vector<std::string> words{"knit", "m1r", "m1l", "k2tog", "ssk"};
  const auto found = std::find(words.begin(), words.end(), word);
  REQUIRE(found != words.end());
  return static_cast<knit::Hand>(found - words.begin());
}

knit::KnitGraph graph_in(const json& document) {
  knit::KnitGraph graph;
  for (const json& row : document.at("graph")) {
    std::vector<knit::GraphStitch>& stitches = graph.rows.emplace_back();
    for (const json& stitch : row) {
      if (graph.rows.size() == 1) {
        CHECK(stitch.at("hand") == "cast on");
        CHECK(stitch.at("below").empty());
        stitches.emplace_back();
        continue;
      }
      const json& below = stitch.at("below");
      stitches.push_back({hand_called(stitch.at("hand")),
                          (below.empty() ? stitch.at("bar_after") : below.front()).get<std::int32_t>(),
                          static_cast<std::int32_t>(below.size())});
      if (below.size() == 2) CHECK(below[1] == below[0].get<int>() + 1);
    }
  }
  return graph;
}

knit::Rounds rounds_in(const json& document) {
  knit::Rounds rounds;
  rounds.cast_on = document.at("cast_on");
  for (const json& round : document.at("rounds")) {
    knit::Round made{round.at("number"), {}, round.at("before"), round.at("after")};
    for (const json& run : round.at("operations")) {
      for (int i = 0; i < run.at("count"); ++i)
        made.operations.push_back({hand_called(run.at("hand")), run.value("main", false)});
    }
    rounds.rounds.push_back(made);
  }
  return rounds;
}

knit::WrittenPattern small_pattern() {
  knit::WrittenPattern pattern;
  pattern.title = "Ball";
  pattern.level = "Easy";
  pattern.start = "CO 6 sts.";
  pattern.instructions.push_back({knit::RoundLine{2, 2, "[K1, m1l] 6 times", 12}, ""});
  pattern.instructions.push_back({std::nullopt, "Stuff firmly."});
  pattern.instructions.push_back({knit::RoundLine{3, 5, "Knit", 12}, ""});
  pattern.finishing = {"Fasten off."};
  return pattern;
}

knit::Chart small_chart() { return knit::chart_of(hand_rounds(6, {"klklklklklkl"})); }

}  // namespace

TEST_CASE("pattern export: knitspeak of a small ball") {
  const knit::Rounds ball = hand_rounds(6, {"klklklklklkl", "kkkkkkkkkkkk", "kkkkkkkkkkkk", "k/kkkkkk\\k",
                                            "kkkkrkkkkkk", "k/kkkkkkkk", "/////"});
  CHECK(pattern_knitspeak(ball) ==
        "CO 6 sts (Rnd 1).\n"
        "Round 2: *k1, M1L, repeat from *. (12 sts)\n"
        "Rounds 3-4: knit. (12 sts)\n"
        "Round 5: k1, k2tog, k6, ssk, k1. (10 sts)\n"
        "Round 6: k4, M1R, k6. (11 sts)\n"
        "Round 7: k1, k2tog, k8. (10 sts)\n"
        "Round 8: *k2tog, repeat from *. (5 sts)\n");
  CHECK(pattern_knitspeak(hand_rounds(6, {})) == "CO 6 sts (Rnd 1).\n");
}

TEST_CASE("pattern export: equal work on other counts is not one line") {
  const std::string text = pattern_knitspeak(hand_rounds(8, {"////", "//"}));
  CHECK(lines_of(text).size() == 3);
}

TEST_CASE("pattern export: json holds the rounds and the graph") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const knit::Rounds rounds = random_rounds(seed);
    const json document = json::parse(pattern_json(rounds));
    CHECK(document.at("format") == "knit-mesh pattern");
    CHECK(document.at("version") == 1);
    REQUIRE(rounds_in(document) == rounds);
    REQUIRE(graph_in(document) == knit::graph_of(rounds));
  }
}

TEST_CASE("pattern export: json's graph is the one that the run's links make") {
  knit::Timeline timeline(small_sphere(), small_parameters());
  timeline.extend_to_end();
  const json document = json::parse(pattern_json(knit::rounds_of(timeline.furthest())));
  CHECK(graph_in(document) == knit::graph_of(timeline.furthest()));
}

TEST_CASE("pattern export: a round or row is one line of json") {
  const knit::Rounds rounds = hand_rounds(6, {"klklklklklkl", "kkkkkkkkkkkk"});
  CHECK(lines_of(pattern_json(rounds)).size() == 7 + 2 + 3 + 2);
}

TEST_CASE("pattern html: each round is an item, in order, and nothing is lost") {
  const knit::WrittenPattern pattern = small_pattern();
  const std::string html = pattern_html(pattern, small_chart());
  CHECK(occurrences(html, "<li class=\"round\">") == 2);
  std::size_t at = 0;
  for (const char* part :
       {">Ball<", "Easy", ">CO 6 sts.<", "<li class=\"round\">", "<li class=\"remark\">Stuff firmly.</li>",
        "<li class=\"round\">", ">Fasten off.<", "<svg ", "</html>"}) {
    CAPTURE(part);
    at = html.find(part, at);
    REQUIRE(at != std::string::npos);
    ++at;
  }
  for (const auto& instruction : pattern.instructions) {
    if (instruction.round)
      CHECK(contains(html, "<li class=\"round\">" + xml_text(instruction.round->text()) + "</li>"));
  }
  CHECK_FALSE(contains(html, "<img"));
  CHECK_FALSE(contains(html, "Materials"));
}

TEST_CASE("pattern html: stands alone") {
  const std::string html = pattern_html(small_pattern(), small_chart(), std::vector<std::uint8_t>{1, 2, 3});
  CHECK(contains(html, "src=\"data:image/png;base64,AQID\""));
  CHECK(occurrences(html, "src=") == 1);
  for (const char* outside : {"<link", "<script", "url(", "@import"}) CHECK_FALSE(contains(html, outside));
  CHECK(occurrences(html, "http") == 1);  // the name of SVG's language
}

TEST_CASE("pattern html: hostile text stays text") {
  const std::string hostile = "</title><script>alert('x')</script>\" onload=\"&amp;";
  knit::WrittenPattern pattern = small_pattern();
  pattern.title = pattern.level = pattern.gauge = pattern.start = hostile;
  pattern.size = pattern.materials = pattern.notes = pattern.finishing = {hostile};
  pattern.abbreviations = {{hostile, hostile}};
  pattern.instructions = {{std::nullopt, hostile}, {knit::RoundLine{2, 2, hostile, 6}, ""}};
  const std::string html = pattern_html(pattern, small_chart());
  CHECK_FALSE(contains(html, "<script"));
  CHECK_FALSE(contains(html, "\" onload"));
  CHECK(occurrences(html, "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&quot; onload=&quot;&amp;amp;") ==
        13);
  CHECK(occurrences(html, "</title>") == 2);  // the page's and the chart's
}

TEST_CASE("pattern html: many rounds stand in two columns") {
  knit::WrittenPattern pattern = small_pattern();
  CHECK_FALSE(contains(pattern_html(pattern, small_chart()), "class=\"rounds long\""));
  for (int i = 0; i < 30; ++i) pattern.instructions.push_back(pattern.instructions.front());
  CHECK(contains(pattern_html(pattern, small_chart()), "class=\"rounds long\""));
}

TEST_CASE("base64: the standard's examples") {
  const auto encoded = [](const std::string& text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
  };
  CHECK(encoded("") == "");
  CHECK(encoded("f") == "Zg==");
  CHECK(encoded("fo") == "Zm8=");
  CHECK(encoded("foo") == "Zm9v");
  CHECK(encoded("foob") == "Zm9vYg==");
  CHECK(encoded("fooba") == "Zm9vYmE=");
  CHECK(encoded("foobar") == "Zm9vYmFy");
  CHECK(base64(std::vector<std::uint8_t>{0xff, 0xfe, 0xfb}) == "//77");
}

TEST_CASE("xml text: marks are written out and control characters left out") {
  CHECK(xml_text("a<b>&\"'\n\x01\x1b"
                 "c") == "a&lt;b&gt;&amp;&quot;&#39;\nc");
}
