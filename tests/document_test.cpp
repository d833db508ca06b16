// What closing and opening leave of the mesh that was open: nothing. The parts of a session are taken apart field by
// field here, so that a new field does not compile until somebody has said what it is.
#include "app/session/document.h"

#include "app/actions/opening.h"
#include "app/checker/checker.h"
#include "app/files/figures.h"
#include "app/lessons/lesson.h"
#include "app/lessons/predict.h"
#include "app/session/jobs.h"
#include "app/session/learning.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;

namespace {

using Names = std::vector<std::string>;

struct Field {
  const char* name;
  bool differs;
};
Names those_that_differ(const std::vector<Field>& fields) {
  Names names;
  for (const Field& field : fields)
    if (field.differs) names.emplace_back(field.name);
  return names;
}
std::size_t count_of(const Names& names) { return names.size(); }

// The same mesh, run as far with the same parameters, and shown at the same place.
bool same(const knit::Timeline& a, const knit::Timeline& b) {
  return a.input().mesh.positions == b.input().mesh.positions && knobs_of(a) == knobs_of(b) &&
         a.known() == b.known() && a.position() == b.position() && a.state() == b.state() &&
         a.sought() == b.sought();
}

// --- which fields of a part differ -------------------------------------------------------------------------

Names different(const Travel& a, const Travel& b) {
  const auto& [history, left_by_seek, selected, sized, hits, running_to, loop, loop_places, kept] = a;
  return those_that_differ(
      {{"history", history.behind != b.history.behind || history.ahead != b.history.ahead},
       {"left_by_seek", left_by_seek != b.left_by_seek},
       {"selected", selected != b.selected},
       {"sized", sized != b.sized},
       {"hits", hits.reach() != b.hits.reach()},
       {"running_to", running_to != b.running_to},
       {"loop", loop != b.loop},
       {"loop_places", loop_places.has_value() != b.loop_places.has_value()},
       {"kept", kept.has_value() != b.kept.has_value()}});
}

Names different(const Changes& a, const Changes& b) {
  const auto& [undo, redo, open, open_keys, before] = a;
  return those_that_differ({{"undo", undo != b.undo},
                            {"redo", redo != b.redo},
                            {"open", open != b.open},
                            {"open_keys", open_keys != b.open_keys},
                            {"before", before != b.before}});
}

// Times are not compared: `load_ms` never is the same twice.
Names different(const Document& a, const Document& b) {
  [[maybe_unused]] const auto& [source, original, mesh_hash, findings, repaired, before_repair, defaults,
                                timeline, before_change, changes, travel, place_note, pinned, sweep, saved,
                                closeness, closeness_run, load_ms, run_ms, pieces] = a;
  return those_that_differ({{"source", source != b.source},
                            {"original", original->positions != b.original->positions},
                            {"mesh_hash", mesh_hash != b.mesh_hash},
                            {"findings", findings.size() != b.findings.size()},
                            {"mended", repaired.size() != b.repaired.size()},
                            {"before_mend", before_repair != b.before_repair},
                            {"defaults", !(defaults == b.defaults)},
                            {"timeline", !same(timeline, b.timeline)},
                            {"before_change", before_change.has_value() != b.before_change.has_value()},
                            {"changes", !different(changes, b.changes).empty()},
                            {"travel", !different(travel, b.travel).empty()},
                            {"place_note", place_note != b.place_note},
                            {"pinned", pinned.has_value() != b.pinned.has_value()},
                            {"sweep", sweep.has_value() != b.sweep.has_value()},
                            {"saved", saved != b.saved},
                            {"closeness", closeness != b.closeness},
                            {"closeness_run", closeness_run != b.closeness_run},
                            {"run_ms", run_ms != b.run_ms},
                            {"pieces", pieces != b.pieces}});
}

Names different(const Gaze& a, const Gaze& b) {
  const auto& [camera, camera_kept, picking, knit_along_deal, hovered_stitch, hovered_rounds,
               hovered_twin_stitches, hovered_twins, chart_piece, knit_along, knit_along_round] = a;
  return those_that_differ({{"camera", !(camera == b.camera)},
                            {"camera_kept", camera_kept != b.camera_kept},
                            {"picking", picking != b.picking},
                            {"knit_along_deal", knit_along_deal != b.knit_along_deal},
                            {"hovered_stitch", hovered_stitch != b.hovered_stitch},
                            {"hovered_rounds", hovered_rounds != b.hovered_rounds},
                            {"hovered_twin_stitches", hovered_twin_stitches != b.hovered_twin_stitches},
                            {"hovered_twins", hovered_twins != b.hovered_twins},
                            {"chart_piece", chart_piece != b.chart_piece},
                            {"knit_along", knit_along != b.knit_along},
                            {"knit_along_round", knit_along_round != b.knit_along_round}});
}

Names different(const View& a, const View& b) {
  const auto& [gaze, aspect, layers, playback, slow_motion, presenting, ring, both, following, breaks, side,
               list, centre, positions, pattern, dialogs, checker, checking, yarn] = a;
  return those_that_differ({{"gaze", !different(gaze, b.gaze).empty()},
                            {"aspect", aspect != b.aspect},
                            {"layers", layers != b.layers},
                            {"playback", !(playback == b.playback)},
                            {"slow_motion", slow_motion != b.slow_motion},
                            {"following", following != b.following},
                            {"breaks", breaks != b.breaks},
                            {"side", side != b.side},
                            {"list", list != b.list},
                            {"centre", centre != b.centre},
                            {"presenting", presenting != b.presenting},
                            {"ring", ring != b.ring},
                            {"both", both != b.both},
                            {"positions", positions != b.positions},
                            {"pattern", !(pattern == b.pattern)},
                            {"dialogs", !(dialogs == b.dialogs)},
                            {"checker", checker != b.checker},
                            {"checking", checking != b.checking},
                            {"yarn", !(yarn == b.yarn)}});
}

Names different(const Learning& a, const Learning& b) {
  const auto& [lesson, prediction, pointed_variable] = a;
  return those_that_differ({{"lesson", lesson != b.lesson},
                            {"prediction", prediction != b.prediction},
                            {"pointed_variable", pointed_variable != b.pointed_variable}});
}

Names different(const Outbox& a, const Outbox& b) {
  const auto& [pictures, pages, worksheets, screenshots, clipboard, notices, quit] = a;
  return those_that_differ({{"pictures", pictures != b.pictures},
                            {"pages", pages != b.pages},
                            {"worksheets", worksheets != b.worksheets},
                            {"screenshots", screenshots != b.screenshots},
                            {"clipboard", clipboard != b.clipboard},
                            {"notices", notices != b.notices},
                            {"quit", quit != b.quit}});
}

Names different(const Jobs& a, const Jobs& b) {
  const auto& [beside, opening, made_mesh, repair_offer, run, flight, animation, pattern_check] = a;
  const auto& [long_step, awaited, measuring] = run;
  return those_that_differ({{"beside", beside != b.beside},
                            {"opening", opening != b.opening},
                            {"made_mesh", made_mesh != b.made_mesh},
                            {"mend_offer", repair_offer.has_value() != b.repair_offer.has_value()},
                            {"long_step", long_step.has_value() != b.run.long_step.has_value()},
                            {"awaited", awaited.has_value() != b.run.awaited.has_value()},
                            {"measuring", measuring.has_value() != b.run.measuring.has_value()},
                            {"flight", flight != b.flight},
                            {"animation", animation != b.animation},
                            {"pattern_check", pattern_check.has_value() != b.pattern_check.has_value()}});
}

Names different(const Program& a, const Program& b) {
  const auto& [assets, preferences, rescued, embedded] = a;
  return those_that_differ({{"assets", assets != b.assets},
                            {"preferences", !(preferences == b.preferences)},
                            {"rescued", rescued != b.rescued},
                            {"embedded", embedded != b.embedded}});
}

constexpr std::size_t document_fields = 19, travel_fields = 9, change_fields = 5, view_fields = 19,
                      gaze_fields = 11, learning_fields = 3, outbox_fields = 7, job_fields = 10,
                      program_fields = 4;

// --- a session with something in every field ---------------------------------------------------------------

void fill(Document& document) {
  const knit::Parameters base = document.timeline.base_parameters();
  document.source.repairs = {knit::RepairKind::holes};
  document.mesh_hash = "elsewhere";
  document.findings.emplace_back();
  document.repaired.emplace_back();
  document.before_repair = std::make_shared<const Session>();
  document.defaults.rows.cast_on = 77;
  document.timeline.extend(300);
  document.timeline.seek(200);
  document.before_change = base;
  document.changes = {{Change{{base, {}}, {}}}, {Change{{base, {}}, {}}}, true, {"cast-on"}, Knobs{base, {}}};
  Travel& travel = document.travel;
  travel.history = {{document.timeline.place()}, {document.timeline.place()}};
  travel.left_by_seek = 200;
  travel.selected = knit::VertexElement{3};
  travel.sized = knit::SizeRange{knit::Measured::course, 1.0, 1.5};
  travel.hits.refresh(document.timeline, {std::get<knit::BreakCondition>(knit::parse_break("row=3"))},
                      BreakHits::all);
  travel.running_to = 1;
  travel.loop = Stretch{10, 20};
  travel.loop_places = PlaceStretch{document.timeline.place(), document.timeline.place()};
  travel.kept = KeptPlace{document.timeline.place(), {}};
  document.place_note = "Another place.";
  Pin pin;
  pin.input = document.timeline.input_pointer();
  pin.knobs = knobs_of(document.timeline);
  pin.known = true;
  document.pinned = std::move(pin);
  document.sweep.emplace();
  document.saved = SavedAs{"a.json", "{}"};
  document.closeness = std::make_shared<const knit::Closeness>();
  document.closeness_run = 5;
  document.run_ms = 12.0;
  document.pieces = {{{"A", "Tail"}}, {"B", "A"}};
}

void fill(View& view) {
  view.gaze.camera.yaw = 0.25;
  view.gaze.camera_kept = true;
  view.gaze.picking = Picking::end;
  view.gaze.knit_along_deal = 1;
  view.gaze.hovered_stitch = StitchAt{2, 3};
  view.gaze.hovered_rounds = RoundSpan{2, 3};
  view.gaze.hovered_twin_stitches = {StitchAt{9, 1}};
  view.gaze.hovered_twins = {RoundSpan{9, 10}};
  view.gaze.chart_piece = "B";
  view.gaze.knit_along = 4;
  view.gaze.knit_along_round = 4;
  view.aspect = 1.25;
  view.layers.fill(false);
  view.playback = {true, -1, 50.0, 0.5};
  view.slow_motion = true;
  view.following = true;
  view.breaks = {std::get<knit::BreakCondition>(knit::parse_break("row=3"))};
  view.side = SidePanel::report;
  view.list = RunList::problems;
  view.centre = CentrePanel::chart;
  view.presenting = true;
  view.ring = false;
  view.both = true;
  view.positions = Positions::placed;
  view.yarn.stripe_rounds = 4;
  view.pattern.title = "Ball";
  view.dialogs.help_open = true;
  view.checker = std::make_shared<const Checker>();
  view.checking = true;
}

Session full_session() {
  Session session = test_support::example_session("egg");
  fill(*session.document);
  fill(*session.view);
  session.learning->prediction = std::make_shared<const Prediction>();
  session.learning->pointed_variable = "epsilon";
  session.outbox->pictures.emplace_back();
  session.outbox->pages.emplace_back("page.html");
  session.outbox->worksheets.emplace_back("sheet.html");
  session.outbox->screenshots.emplace_back("shot.png");
  session.outbox->clipboard = "words";
  session.outbox->notices = {{Notice::Kind::info, "Something was said."}};
  session.outbox->quit = true;
  session.jobs->beside = true;
  session.jobs->made_mesh = std::make_shared<const MadeMesh>();
  session.jobs->repair_offer = RepairOffer{{"", "a.obj", {}}, "It has a hole.", nullptr};
  session.jobs->run.long_step.emplace();
  session.jobs->run.awaited.emplace();
  session.jobs->run.measuring.emplace();
  session.jobs->flight = CameraFlight{Camera{}, {}, 0.1};
  session.jobs->animation = std::make_shared<const AnimationRun>();
  session.jobs->pattern_check.emplace();
  session.program->rescued = Rescued{"a.json", "egg"};
  session.program->embedded = true;
  return session;
}

// What begins at an opening, and a lesson, which stands before another document.
void fill_more(Session& session) {
  session.jobs->opening = std::make_shared<Opening>();
  session.jobs->opening->progress = std::make_shared<knit::Progress>();
  LessonRun run;
  run.before = std::make_shared<const Session>(session);
  session.learning->lesson = std::make_shared<const LessonRun>(std::move(run));
}

const Names none;

}  // namespace

TEST_CASE("the full session of these tests has something in every field", "[document]") {
  Session full = full_session();
  fill_more(full);
  const Session fresh;
  const Session opened = test_support::example_session("sphere");
  CHECK(count_of(different(*full.document, *opened.document)) == document_fields);
  CHECK(count_of(different(full.document->travel, opened.document->travel)) == travel_fields);
  CHECK(count_of(different(full.document->changes, opened.document->changes)) == change_fields);
  CHECK(count_of(different(*full.view, *fresh.view)) == view_fields);
  CHECK(count_of(different(full.view->gaze, fresh.view->gaze)) == gaze_fields);
  CHECK(count_of(different(*full.learning, *fresh.learning)) == learning_fields);
  CHECK(count_of(different(*full.outbox, *fresh.outbox)) == outbox_fields);
  CHECK(count_of(different(*full.jobs, *fresh.jobs)) == job_fields);
  CHECK(count_of(different(*full.program, *fresh.program)) == program_fields);
}

TEST_CASE("a closed session is as a fresh one but for what is not the mesh's", "[document]") {
  const Session full = full_session();
  Session closed = full;
  closed.jobs->opening = std::make_shared<Opening>();
  closed.jobs->opening->progress = std::make_shared<knit::Progress>();
  apply(closed, CloseMesh{});
  const Session fresh;
  CHECK_FALSE(closed.document);
  CHECK(closed.view->gaze == fresh.view->gaze);
  CHECK(*closed.learning == *fresh.learning);
  // What looking at the next mesh goes on with; what else was asked for; how the program is set.
  CHECK(different(*closed.view, *full.view) == Names{"gaze", "playback"});
  CHECK(closed.view->playback == Playback{false, 1, full.view->playback.steps_per_second, 0.0});
  CHECK(different(*closed.outbox, *full.outbox) == Names{"notices"});
  CHECK(closed.outbox->notices.empty());
  CHECK(different(*closed.jobs, *fresh.jobs) == Names{"beside", "made_mesh", "pattern_check"});
  CHECK(different(*closed.program, *full.program) == none);
}

TEST_CASE("closing out of a lesson closes what was open before it too", "[document]") {
  Session session = full_session();
  fill_more(session);
  apply(session, CloseMesh{});
  CHECK_FALSE(session.document);
  CHECK(*session.learning == Learning{});
}

TEST_CASE("an opened mesh has a fresh document, which may be compared with what was pinned", "[document]") {
  Session full = full_session();
  full.view->aspect = Session().view->aspect;  // the camera is framed for it
  Session session = full;
  apply(session, OpenExample{"sphere"});
  Session fresh = test_support::example_session("sphere");
  apply(fresh, SetPredicting{true});  // as in the other: it wants to know the first step
  CHECK(different(*session.document, *fresh.document) == Names{"pinned"});
  CHECK(session.view->gaze == fresh.view->gaze);
  CHECK(different(*session.view, *full.view) == Names{"gaze", "playback", "checking"});  // it is to be seen
  CHECK(different(*session.outbox, *full.outbox) == Names{"notices"});
  // An animation is made from a session of its own.
  CHECK(different(*session.jobs, Jobs{}) == Names{"beside", "made_mesh", "animation", "pattern_check"});
  CHECK(session.learning->prediction == full.learning->prediction);

  apply(session, CloseMesh{});
  apply(session, OpenExample{"sphere"});
  CHECK(different(*session.document, *test_support::example_session("sphere").document) == none);
}

TEST_CASE("a picture's session is what is open and how one looks at it", "[document]") {
  Session full = full_session();
  fill_more(full);
  apply(full, SavePicture{"a.png"});
  REQUIRE(full.outbox->pictures.size() == 2);
  full.jobs->animation.reset();
  apply(full, SaveAnimation{"a.gif", {10, 20}, 3, 10.0, 64, 64, false});
  REQUIRE(full.jobs->animation);
  const Session& picture = *full.jobs->animation->from;
  CHECK(different(*picture.document, *full.document) == none);
  CHECK(different(*picture.view, *full.view) == Names{"gaze", "playback", "dialogs"});
  CHECK(different(picture.view->gaze, full.view->gaze) ==
        Names{"picking", "hovered_stitch", "hovered_rounds", "hovered_twin_stitches", "hovered_twins"});
  CHECK(*picture.learning == Learning{});
  CHECK(*picture.outbox == Outbox{});
  CHECK(different(*picture.jobs, Jobs{}) == none);
  CHECK(different(*picture.program, *full.program) == Names{"rescued"});
}
