// What a person says about pieces: names that stay with their pieces, an order that can be worked or is refused with the
// reason, what it costs; undone and redone, kept in sessions and in links, forgotten with the mesh.
#include "app/session/planned_pieces.h"

#include "app/files/link.h"
#include "app/files/session_json.h"
#include "app/script/command_line.h"
#include "app/session/outbox.h"
#include "knit/pattern/written_pattern.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

using Letters = std::vector<std::string>;

// Two legs, A and B, that join in body C.
Session finished(const std::string& example) {
  Session session = test_support::example_session(example);
  apply(session, ToLast{});
  return session;
}

PatternPieces& said(Session& session) { return session.document->pieces; }

std::string refused(Session& session, const Action& action) {
  const PatternPieces before = said(session);
  const std::size_t notices = session.outbox->notices.size();
  apply(session, action);
  CHECK(said(session) == before);
  REQUIRE(session.outbox->notices.size() == notices + 1);
  return session.outbox->notices.back().text;
}

}  // namespace

TEST_CASE("a piece's name and an order are read from text, or a sentence says what is wrong") {
  CHECK(std::get<0>(read_piece_name("AB=Tail")) == std::pair<std::string, std::string>("AB", "Tail"));
  for (const char* bad : {"", "A", "A=", "A=tail", "a=Tail", "ABC=Tail", "A=Two words", "=Tail"})
    CHECK(std::holds_alternative<std::string>(read_piece_name(bad)));
  CHECK(std::get<Letters>(read_piece_order("B,A,C")) == Letters{"B", "A", "C"});
  for (const char* bad : {"", "B,", "b,a", "A,B,A", "A B"})
    CHECK(std::holds_alternative<std::string>(read_piece_order(bad)));
  CHECK(piece_order_text({"B", "A", "C"}) == "B,A,C");
}

TEST_CASE("names stay with their pieces in another order") {
  Session session = finished("trousers");
  apply(session, SetPieceNames{{{"A", "Shin"}}});
  CHECK(planned_pieces(session).name_of(0) == "Shin A");
  apply(session, SetPieceOrder{{"B", "A", "C"}});
  const PlannedPieces planned = planned_pieces(session);
  CHECK(planned.chosen);
  CHECK(planned.letters == Letters{"B", "A", "C"});
  CHECK(planned.name_of(0) == "Limb A");
  CHECK(planned.name_of(1) == "Shin B");
  CHECK(session.outbox->notices.empty());
  apply(session, SetPieceNames{{{"A", ""}}});
  CHECK(said(session).names.empty());
  CHECK(planned_pieces(session).name_of(1) == "Limb B");
}

TEST_CASE("an order that cannot be worked is refused with the reason, and nothing changes") {
  Session session = finished("trousers");
  CHECK(refused(session, SetPieceOrder{{"A", "C", "B"}}) ==
        "Body C is worked on the stitches of Limb B, so that one must come first.");
  CHECK(refused(session, SetPieceOrder{{"A", "B"}}) ==
        "The order must name each of the 3 pieces A to C once.");
  CHECK(refused(session, SetPieceOrder{{"A", "B", "B"}}) ==
        "Piece B stands twice in the order; name each once.");
  CHECK(refused(session, SetPieceNames{{{"A", "two words"}}}) ==
        "A piece cannot be called \"two words\"; give one capitalised word: Tail.");
  CHECK(session.document->changes.undo.empty());
  Session sphere = finished("sphere");
  CHECK(refused(sphere, SetPieceOrder{{"B", "A"}}) ==
        "This pattern is of one piece, so there is nothing to put in order.");
}

TEST_CASE(
    "an order that was asked for before the run is known is taken if it can be worked, else it is said why "
    "not") {
  Session session = test_support::example_session("trousers");
  apply(session, SetPieceOrder{{"C", "A", "B"}});
  CHECK(said(session).order == Letters{"C", "A", "B"});
  session.document->timeline.extend_to_end();
  session.document->timeline.seek(session.document->timeline.known());
  const PlannedPieces planned = planned_pieces(session);
  CHECK_FALSE(planned.chosen);
  CHECK(planned.letters == Letters{"A", "B", "C"});
  CHECK(planned.refused == "Body C is worked on the stitches of Limb A, so that one must come first.");
}

TEST_CASE("what an order costs is told in yarns and holders against the cheapest") {
  Session session = finished("octopus");
  const PlannedPieces cheapest = planned_pieces(session);
  CHECK(order_price(cheapest) == "As many yarns and holders as the cheapest order.");
  PlannedPieces dear = cheapest;
  dear.plan.yarns += 2;
  dear.plan.held_most += 1;
  CHECK(order_price(dear) == "2 yarns and 1 holder more than the cheapest order.");
  dear.plan.held_most -= 2;
  CHECK(order_price(dear) == "2 yarns more and 1 holder fewer than the cheapest order.");
  dear.plan.yarns -= 2;
  CHECK(order_price(dear) == "1 holder fewer than the cheapest order.");
  // Every order that is taken is worked as told.
  Letters turned = cheapest.letters;
  std::swap(turned[0], turned[3]);
  apply(session, SetPieceOrder{turned});
  const PlannedPieces planned = planned_pieces(session);
  CHECK(planned.chosen);
  CHECK(planned.plan.pieces[0].tube == cheapest.plan.pieces[3].tube);
  CHECK(planned.plan.cost >= cheapest.plan.cost);
}

TEST_CASE("names and order are undone and redone among other changes") {
  Session session = finished("trousers");
  const knit::Parameters first = session.document->timeline.parameters();
  apply(session, SetPieceNames{{{"A", "Leg"}, {"B", "Leg"}}});
  knit::Parameters changed = first;
  changed.rows.cast_on = 6;
  apply(session, Tune{changed});
  apply(session, SetPieceOrder{{"B", "A", "C"}});
  REQUIRE(session.document->changes.undo.size() == 3);
  apply(session, Undo{});
  CHECK(said(session).order.empty());
  CHECK(session.document->timeline.parameters().rows.cast_on == 6);
  apply(session, Undo{});
  CHECK(session.document->timeline.parameters().rows.cast_on == first.rows.cast_on);
  CHECK(said(session).names.size() == 2);
  apply(session, Undo{});
  CHECK(said(session) == PatternPieces{});
  for (int i = 0; i < 3; ++i) apply(session, Redo{});
  CHECK(said(session).order == Letters{"B", "A", "C"});
  CHECK(said(session).names.at("B") == "Leg");
  CHECK(session.document->timeline.parameters().rows.cast_on == 6);
  apply(session, SetPieceOrder{{"B", "A", "C"}});  // nothing new
  CHECK(session.document->changes.undo.size() == 3);
}

TEST_CASE("names and order go into a session and come back, and are forgotten with the mesh") {
  Session session = finished("trousers");
  apply(session, SetPieceNames{{{"A", "Leg"}}});
  apply(session, SetPieceOrder{{"B", "A", "C"}});
  apply(session, KnitAlong{31, 1});
  const std::string text = to_json(saved_of(session)).dump();
  const auto read = read_saved(text);
  REQUIRE(std::holds_alternative<SavedSession>(read));
  CHECK(std::get<SavedSession>(read).pieces == said(session));
  CHECK(std::get<SavedSession>(read).round == 31);
  CHECK(std::get<SavedSession>(read).deal == 1);
  for (const char* bad : {R"("piece-order":["B","B"])", R"("piece-order":[1])", R"("piece-order":["b"])"}) {
    std::string spoilt = text;
    const std::string good = R"("piece-order":["B","A","C"])";
    REQUIRE(spoilt.find(good) != std::string::npos);
    spoilt.replace(spoilt.find(good), good.size(), bad);
    CHECK(std::holds_alternative<std::string>(read_saved(spoilt)));
  }
  apply(session, OpenExample{"y"});
  CHECK(said(session) == PatternPieces{});
}

TEST_CASE("a link says names and order, and the command line takes them") {
  Session session = finished("trousers");
  apply(session, SetPieceNames{{{"A", "Leg"}}});
  apply(session, SetPieceOrder{{"B", "A", "C"}});
  const std::string link = link_by_options(session).value();
  CHECK(link.find(" --piece-name A=Leg --piece-order B,A,C") != std::string::npos);
  const auto parsed = parse_command_line(
      {"--example", "trousers", "--headless", "--piece-name", "A=Leg", "--piece-order", "B,A,C"},
      KNIT_ASSETS_DIR);
  REQUIRE(std::holds_alternative<CommandLine>(parsed));
  Session opened;
  opened.program->assets = KNIT_ASSETS_DIR;
  CHECK_FALSE(open_as_asked(opened, std::get<CommandLine>(parsed)));
  CHECK(said(opened) == said(session));
  CHECK(opened.view->pattern.piece_names.empty());
  CHECK(opened.document->changes.undo.empty());
  auto wrong = std::get<CommandLine>(parsed);
  wrong.piece_order = {"C", "A", "B"};
  CHECK(open_as_asked(opened, wrong) ==
        "--piece-order: Body C is worked on the stitches of Leg A, so that one must come first.");
  CHECK(std::holds_alternative<Answer>(
      parse_command_line({"--example", "trousers", "--piece-order", "B,A,B"}, KNIT_ASSETS_DIR)));
}
