// The glossary: its terms, where they are found in a text, and the window that shows them.
#include "app/explain/glossary.h"
#include "app/session/view.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "knit/model/words.h"
#include "tests/support/desk.h"
#include "tests/support/session.h"

using namespace desk;

namespace {

std::vector<std::string> names_in(std::string_view list) {
  std::vector<std::string> names;
  std::istringstream in{std::string(list)};
  for (std::string name; std::getline(in, name, ',');) names.push_back(name.substr(name[0] == ' ' ? 1 : 0));
  return names;
}

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return text;
}

std::vector<std::string> words_found(const std::string& text) {
  std::vector<std::string> words;
  for (const TermAt& at : terms_in(text)) words.push_back(text.substr(at.begin, at.end - at.begin));
  return words;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("each term of the glossary stands once, by the alphabet, and says what it means") {
  CHECK(glossary().size() >= 35);
  std::set<std::string> seen;
  std::string before;
  for (const Term& term : glossary()) {
    const std::string word = small(std::string(term.word));
    INFO(word);
    CHECK(before < word);
    before = word;
    CHECK(seen.insert(word).second);
    for (const std::string& form : names_in(term.forms)) {
      INFO(form);
      CHECK(seen.insert(small(form)).second);
      CHECK(find_term(form) == &term);
    }
    CHECK(find_term(term.word) == &term);
    CHECK(term.meaning.size() > 30);
    CHECK(term.meaning.size() < 330);
    CHECK(term.meaning.back() == '.');
  }
}

TEST_CASE("every see-also of the glossary leads to another term") {
  for (const Term& term : glossary()) {
    INFO(term.word);
    const auto others = seen_from(term);
    CHECK(others.size() == names_in(term.see).size());
    CHECK(std::count(others.begin(), others.end(), &term) == 0);
  }
}

TEST_CASE("the sections that the glossary names are there") {
  const std::string algorithm = test_support::read_text(std::string(KNIT_SOURCE_DIR) + "/docs/algorithm.md");
  for (const Term& term : glossary()) {
    INFO(term.word);
    std::istringstream parts{std::string(term.where)};
    for (std::string part; std::getline(parts, part, ';');) {
      part = part.substr(part[0] == ' ' ? 1 : 0);
      const std::string file = part.substr(0, part.find(','));
      INFO(part);
      if (file == "docs/algorithm.md") {
        CHECK(algorithm.find("# " + part.substr(file.size() + 2) + "\n") != std::string::npos);
      } else if (file.rfind("docs/", 0) == 0) {
        CHECK(std::filesystem::exists(std::string(KNIT_SOURCE_DIR) + "/" + file));
      } else {
        CHECK(file == "the thesis");
      }
    }
  }
}

TEST_CASE("every stage, label and verdict is in the glossary, and every rule is named there") {
  for (const knit::Stage stage : knit::machine_stages) {
    INFO(knit::name_of(stage));
    CHECK(find_term(knit::name_of(stage)) != nullptr);
  }
  CHECK(find_term(knit::name_of(knit::Stage::import)) != nullptr);
  for (int label = 0; label <= 6; ++label) {
    INFO(knit::name_of(static_cast<knit::Label>(label)));
    CHECK(find_term(knit::name_of(static_cast<knit::Label>(label))) != nullptr);
  }
  for (int verdict = 0; verdict < 3; ++verdict)
    CHECK(find_term(knit::name_of(static_cast<knit::Verdict>(verdict))) == find_term("verdict"));
  const std::string said =
      std::string(find_term("rule")->meaning) + std::string(find_term("placement")->meaning);
  for (int rule = 0; rule <= static_cast<int>(knit::Rule::nearest); ++rule) {
    const std::string name(knit::name_of(static_cast<knit::Rule>(rule)));
    INFO(name);
    CHECK(said.find(name) != std::string::npos);
  }
}

TEST_CASE("words are found whole, in the plural, the longest first and each once") {
  CHECK(terms_in("3 times").empty());
  CHECK(terms_in("timing").size() == 1);
  CHECK(words_found("Row 5: vertex 12 is too near") == Words{"Row", "vertex", "too near"});
  CHECK(words_found("two rows of stitches, wales and saddles") ==
        Words{"rows", "stitches", "wales", "saddles"});
  CHECK(words_found("the main stitch and two mains") == Words{"main stitch"});
  CHECK(words_found("the Cast-on stitch") == Words{"Cast-on", "stitch"});
  CHECK(words_found("narrow rowing arrows, stitched") == Words{});
  CHECK(words_found("within \xCE\xB5 of it") == Words{"\xCE\xB5"});
  CHECK(words_found("minima and maxima") == Words{"minima", "maxima"});
  CHECK(words_found("a stitch, another stitch") == Words{"stitch"});
  CHECK(words_found("").empty());
  CHECK(find_term("stitch") != nullptr);
  CHECK(find_term("no such word") == nullptr);
  CHECK(find_term("") == nullptr);
}

TEST_CASE("the glossary is searched by beginning, then by part, then by meaning") {
  CHECK(search_glossary("").size() == glossary().size());
  REQUIRE(!search_glossary("cours").empty());
  CHECK(search_glossary("cours").front()->word == "course");
  CHECK(search_glossary("ssk").front()->word == "SSK");
  CHECK(search_glossary("cycle").front()->word == "ring");
  const auto found = search_glossary("mountain");
  REQUIRE(found.size() == 1);
  CHECK(found[0]->word == "saddle");
  CHECK(search_glossary("qqq").empty());
}

TEST_CASE("the glossary opens by F2, leads on by its links and closes by Escape") {
  Desk desk(1280, 720);
  desk.open();
  desk.act(desk.press({Key::F2, {}, 0}));
  REQUIRE(desk.session.view->dialogs.glossary_open);
  desk.settle();
  desk.type("saddle");
  desk.settle();
  CHECK(desk.ui.controls.count("glossary/row") == 0);
  desk.act(desk.click("glossary/saddle"));
  desk.settle();
  desk.act(desk.click("glossary/see/critical point"));
  CHECK(desk.session.view->dialogs.glossary_term == "critical point");
  // The link's words count, though they are not what is searched for.
  desk.act(desk.press({Key::Escape, {}, 0}));
  CHECK_FALSE(desk.session.view->dialogs.glossary_open);
  desk.settle();
  CHECK(desk.ui.controls.count("glossary/search") == 0);
  only<SetPlaying>(desk.press({Key::Space, {}, 0}));
}

TEST_CASE("the arrow keys go through what the glossary's search finds") {
  Desk desk(1280, 720);
  desk.open();
  desk.session.view->dialogs.glossary_open = true;
  desk.settle();
  CHECK(only<ShowGlossary>(desk.press({Key::Down, {}, 0})).term == glossary()[1].word);
  desk.session.view->dialogs.glossary_term = glossary()[1].word;
  CHECK(only<ShowGlossary>(desk.press({Key::Up, {}, 0})).term == glossary()[0].word);
  CHECK_FALSE(only<ShowGlossary>(desk.press({Key::F2, {}, 0})).open);
}

TEST_CASE("a word of the step's sentence opens the glossary there, and keys go on working") {
  Desk desk(1280, 720);
  desk.open();
  apply(desk.session, SeekPlace{{knit::Stage::rows, 2, 5}});
  desk.settle();
  REQUIRE(desk.ui.controls.count("term/row") == 1);
  const Box word = desk.ui.controls.at("term/row");
  const Box step = desk.ui.controls.at("step");
  CHECK(word.x >= step.x);
  CHECK(word.right() <= step.right());
  CHECK(word.width > 5.0f);
  const Actions wishes = desk.frames({desk.over("term/row"), MouseClick{MouseButton::Left, true},
                                      MouseClick{MouseButton::Left, false}, MouseLeave{}});
  const auto& shown = only<ShowGlossary>(wishes);
  CHECK(shown.open);
  CHECK(shown.term == "row");
  desk.act(wishes);
  desk.settle();
  only<SetPlaying>(desk.press({Key::Space, {}, 0}));
  CHECK_FALSE(only<ShowGlossary>(desk.press({Key::Escape, {}, 0})).open);
}

TEST_CASE("a parameter's name leads to the glossary where that has it") {
  Desk desk(1280, 1280);
  desk.open();
  CHECK(only<ShowGlossary>(desk.click("knob-label/epsilon")).term == "epsilon");
  CHECK(only<ShowGlossary>(desk.click("knob-label/stitch-width")).term == "stitch width");
}
