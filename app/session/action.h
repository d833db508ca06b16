// Everything a person can do, as values: buttons, keys, the command line and tests all speak these. `apply`
// is the one place where a session changes.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/base/kind_list.h"
#include "app/curves/curve_wish.h"
#include "app/session/changes.h"
#include "app/session/preferences.h"
#include "app/session/session.h"
#include "app/session/sweep.h"
#include "app/session/travel.h"
#include "app/session/view.h"
#include "knit/import/repair.h"

namespace app {

struct OpenExample {
  std::string name;
};
struct OpenFile {
  std::filesystem::path path;
  knit::RepairWish repairs{};
  CurveWish curves{};  // to be cut along
};                     // with default parameters for its size
struct CloseMesh {};   // nothing is open then; a lesson is left, what was pinned is let go
// Repairs: knit/repair.h. What a mesh that could not be opened was offered.
struct RepairAndOpen {};
struct DropRepairOffer {};
struct UndoRepair {};  // back to what was open before
// Where knitting begins and ends: knit/curves/cycle.h. The open mesh is cut along exactly these.
struct SetCurves {
  std::vector<knit::Cycle> curves;
};
struct AddCurve {
  knit::Cycle curve;
};  // in place of one that is the same end
struct RemoveCurve {
  std::size_t number = 1;  // of the list, from 1
};
struct SwapCurves {};  // starts become ends, and ends starts
struct OpenCurves {
  CurveWish wish;
};

// The timeline.
enum class Unit : std::uint8_t { item, row, stage };
struct StepBy {
  Unit unit = Unit::item;
  int direction = 1;
};
struct SeekTo {
  std::size_t position = 0;
};
struct SeekPlace {
  knit::Place place;
};
struct ToFirst {};
struct ToLast {};
struct SetPlaying {
  bool playing = true;
  int direction = 1;
};
struct SetSpeed {
  double steps_per_second = 60.0;
};
struct PassTime {
  double seconds = 0.0;
};  // the clock's tick: plays, and works the run out further

// Parameters.
// `held`: by a hand that has not let go; Settle says when it has. What it changes meanwhile is undone as one.
struct Tune {
  knit::Parameters parameters;
  bool held = false;
};  // as if from the start
struct EditFromHere {
  knit::Parameters parameters;
  bool held = false;
};  // the past stays
struct RemoveEdit {
  std::size_t index = 0;
};
struct ApplyPreset {
  std::string key;
};                     // as Tune
struct CancelWork {};  // long work: back to the parameters before the change that asked for it
struct SetPicking {
  Picking picking = Picking::nothing;
};
struct PickVertex {
  knit::VertexId vertex = knit::no_vertex;
};  // for whatever session.view->gaze.picking asks

struct Settle {};  // the hand has let go: the next change of parameters is undone apart from those before
struct Undo {};    // of changes of parameters and edits
struct Redo {};
struct CopyParameters {};  // as text, to the clipboard
struct PasteParameters {
  std::string text;
};  // as Tune; from parameters_text.h

// Why, and finding one's way: travel.h.
struct Select {
  std::optional<knit::Element> thing;
};  // shown in view, chart and lists
// From a figure to what it is of: selected, and the view turns to it where it does not face it.
struct LookAt {
  knit::Element thing;
};
// All edges or corners of a size: lit in the view, which turns to one of them; none: no longer.
struct SelectSized {
  std::optional<knit::SizeRange> range;
};
struct ShowWhy {
  knit::Element thing;
};  // selects it and goes to the step that made or refused it
struct ToTouch {
  int direction = 1;
};  // the next, or the last, step that had to do with what is selected
// To what a person names: "row 7", "widest round", "why stitch 20:5" (app/explain/destination.h). What is there is said;
// what is not there is said too, and one stays.
struct GoTo {
  std::string where;
};
struct GoBack {};  // to where one was before a jump
struct GoForward {};
enum class Depth : std::uint8_t { over, into, out };
struct StepDeep {
  Depth depth = Depth::over;
  int direction = 1;
};
struct SetBreaks {
  std::vector<knit::BreakCondition> conditions;
};
struct RunToBreak {
  int direction = 1;
};
struct SetLoop {
  std::optional<Stretch> stretch;
};  // playing goes round in it; none: no loop
struct SetSlowMotion {
  bool on = true;
};  // playing slows down where something interesting happens

// Two settings side by side: pins.h, sweep.h.
struct PinRun {};  // keeps the current run as the one compared with
struct SwapPinned {};
struct Unpin {};
struct StartSweep {
  SweepPlan plan;
};
struct CancelSweep {};
struct TakeSweepValue {
  std::size_t run = 0;
};  // the parameters of one of its runs, as Tune

// Sessions: session_file.h.
struct OpenSession {
  std::filesystem::path path;
};
struct CopyLink {};     // the command line that opens exactly this, to the clipboard
struct CopyRows {};     // the list of rows as CSV, to the clipboard
struct TakeRescued {};  // the session saved aside before a crash
struct DropRescued {};

// The view.
struct SetLayer {
  Layer layer = Layer::surface;
  bool on = true;
};
struct Orbit {
  double yaw = 0.0, pitch = 0.0;
};
struct Pan {
  glm::dvec2 move{0.0};
};
struct Zoom {
  double factor = 1.0;
  glm::dvec2 cursor{0.0};
};
struct FrameAll {};
struct SetFollowing {
  bool on = true;
};  // whether the view turns to what happens behind the surface
struct TurnToStep {
  double seconds = 0.0;
};  // so far as it turns in this time; nothing where the step is in sight: app/facing/step_place.h
struct SetAspect {
  double aspect = 1.6;
};
struct ShowSide {
  SidePanel side = SidePanel::step;
};
struct ShowList {
  RunList list = RunList::rows;
};
struct SetPositions {
  Positions positions = Positions::settled;
};
struct SetYarnLook {
  YarnLook look;
};
struct ShowAs {
  Looking looking = Looking::stitches;
};  // layers and positions together: app/actions/looking.h
struct Present {
  bool on = true;
};  // for a class: the view, one large sentence, row and count, a thin timeline
struct SetRing {
  bool on = true;
};  // round the pointer, while presenting
struct ShowBoth {
  bool on = true;
};  // the pinned run left of this one, at the same place

// Files. A failure is a notice in the session.
struct Export {
  std::string what = "mesh";  // its key in the table of app/files/export.h
  std::filesystem::path path;
};

// The program itself, for every mesh: preferences.h.
struct SetTheme {
  ThemeKind theme = ThemeKind::dark;
};
struct SetScale {
  double scale = 1.0;
};
struct SetMotion {
  bool on = true;
};
struct ShowPanel {
  Panel panel = Panel::side;
  bool open = true;
};
struct ShowRowColumn {
  RowColumn column = RowColumn::stitches;
  bool shown = true;
};
struct SetSplit {
  Split split = Split::left;
  double size = 0.0;  // plain units; 0: as there is room
};
struct ResetLayout {};
struct ForgetRecent {};

// Learning: lesson.h, predict.h.
struct StartLesson {
  std::string key;
};
struct LeaveLesson {};
struct TurnLesson {
  int direction = 1;  // to the next page, or the one before
};
struct AnswerLesson {
  std::string answer;  // what was chosen, typed or clicked, as the lesson's page asks
};
struct SetPredicting {
  bool on = true;
};
struct Guess {
  knit::Verdict verdict = knit::Verdict::accepted;
};
// A variable of the pseudo-code is pointed at: shown in the view.
struct PointAt {
  std::string variable;  // its name; empty: none
};

// Figures: figures.h. Any size, alone or with the panels, with or without a ground.
struct SavePicture {
  std::filesystem::path path;
  int width = 1600, height = 1200;  // pixels
  bool panels = false;
  bool transparent = false;  // alone only
};
struct SaveAnimation {
  std::filesystem::path path;  // .gif, .png (animated), or a folder for numbered PNG
  Stretch stretch;
  int frames = 120;  // most
  double frames_per_second = 20.0;
  int width = 960, height = 720;
  bool panels = false;
};
struct CancelAnimation {};

// The program.
struct ShowActionPalette {
  bool open = true;
};
struct ShowGoTo {
  bool open = true;
};
struct ShowGlossary {
  bool open = true;
  std::string term;  // to begin with; empty: the first
};
struct ShowHelp {
  bool open = true;
};
struct SetPatternOptions {
  knit::PatternOptions options;
};
// Pieces of the pattern: pattern_pieces.h. Refused with a sentence where it cannot be.
struct SetPieceNames {
  std::map<std::string, std::string> names;  // of these pieces; an empty word: the program's own
};
struct SetPieceOrder {
  std::vector<std::string> order;  // empty: the cheapest
};
struct ShowCentre {
  CentrePanel centre = CentrePanel::view;
  // Of a pattern in pieces whose chart is shown, by its letters; empty: that of the round at hand; none: as it is.
  std::optional<std::string> piece = std::nullopt;
};
// `twins`: what the same words, or the same chart, stand for besides.
struct HoverStitch {
  std::optional<StitchAt> stitch;
  std::vector<StitchAt> twins = {};
};
struct HoverRounds {
  std::optional<RoundSpan> rounds;
  std::vector<RoundSpan> twins = {};
};
struct KnitAlong {
  std::optional<std::int32_t> round;  // none: put it away
  std::int16_t deal = 0;              // of those before a piece's first round, from 1; 0: the round itself
};
struct ShowOpenDialog {
  bool open = true;
};
struct DismissNotice {
  std::size_t index = 0;
};
// A written pattern that is checked: app/checker/checker.h. What asks for one where there is none begins an empty one.
struct ShowChecker {
  bool open = true;
};  // over the mesh, which stays; closing keeps the text
struct CheckFile {
  std::filesystem::path path;
};  // its text takes the place of what stands there, which can be had back
struct SetCheckedText {
  std::string text;
  bool whole = false;  // in place of all that stands there: it can be had back
};
struct RestoreCheckedText {};  // what stood there before; once more: back
struct SaveCheckedText {
  std::filesystem::path path;
};
struct GoToCheckedLine {
  std::size_t line = 1, at = 0, length = 0;  // from 1; a byte of it, and so many marked from there
};
struct ToMistake {
  int direction = 1;
};  // the next line with a sentence, or the one before
struct ShowCheckedSize {
  std::size_t index = 0;
};
struct SetCheckedGauge {
  double stitches = 22.0, rows = 32.0;  // on 10 cm
};
struct PutNoteAway {};  // why another place is shown, or what is there
struct Quit {};

// All of them, in the order of their numbers.
using ActionKinds =
    KindList<OpenExample, OpenFile, StepBy, SeekTo, SeekPlace, ToFirst, ToLast, SetPlaying, SetSpeed,
             PassTime, Tune, EditFromHere, RemoveEdit, ApplyPreset, CancelWork, SetPicking, PickVertex,
             Settle, Undo, Redo, CopyParameters, PasteParameters, Select, ShowWhy, ToTouch, GoBack, GoForward,
             StepDeep, SetBreaks, RunToBreak, SetLoop, SetSlowMotion, PinRun, SwapPinned, Unpin, StartSweep,
             CancelSweep, TakeSweepValue, OpenSession, CopyLink, TakeRescued, DropRescued, SetLayer, Orbit,
             Pan, Zoom, FrameAll, SetAspect, ShowSide, ShowList, SetPatternOptions, ShowCentre, HoverStitch,
             HoverRounds, KnitAlong, Export, SetTheme, SetScale, SetMotion, ShowPanel, SetSplit, ResetLayout,
             ForgetRecent, StartLesson, LeaveLesson, TurnLesson, AnswerLesson, SetPredicting, Guess, PointAt,
             SavePicture, SaveAnimation, CancelAnimation, ShowActionPalette, ShowGlossary, ShowHelp,
             ShowOpenDialog, DismissNotice, Quit, CloseMesh, RepairAndOpen, DropRepairOffer, UndoRepair,
             SetPositions, SetPieceNames, SetPieceOrder, GoTo, ShowGoTo, LookAt, SelectSized, Present,
             SetRing, ShowBoth, SetFollowing, TurnToStep, CopyRows, ShowRowColumn, PutNoteAway, ShowChecker,
             CheckFile, SetCheckedText, RestoreCheckedText, SaveCheckedText, GoToCheckedLine, ToMistake,
             ShowCheckedSize, SetCheckedGauge, SetYarnLook, ShowAs, SetCurves, AddCurve, RemoveCurve,
             SwapCurves, OpenCurves>;

// One of these, with what it says; never changed once made. Not a std::variant: of so many kinds that would cost
// each file that makes one some seconds of compiling.
class Action {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): an action is what it says
  template <class What, std::enable_if_t<ActionKinds::has<What>, int> = 0>
  Action(What what)
      : what_(std::make_shared<const What>(std::move(what))), index_(ActionKinds::index_of<What>) {}

  [[nodiscard]] std::size_t index() const { return index_; }
  template <class What>
  [[nodiscard]] bool is() const {
    return index_ == ActionKinds::index_of<What>;
  }
  // Null: it is another.
  template <class What>
  [[nodiscard]] const What* get_if() const {
    return is<What>() ? static_cast<const What*>(what_.get()) : nullptr;
  }
  // Requires is<What>().
  template <class What>
  [[nodiscard]] const What& get() const {
    return *static_cast<const What*>(what_.get());
  }

 private:
  std::shared_ptr<const void> what_;
  std::size_t index_;
};
using Actions = std::vector<Action>;

void apply(Session& session, const Action& action);

// Example names in the order of the menu, from the assets folder; empty when it is missing.
std::vector<std::string> list_examples(const std::filesystem::path& assets);

}  // namespace app
