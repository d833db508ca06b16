#include "app/entries/action_names.h"

#include <type_traits>
#include <utility>

namespace app {

namespace {

using enum Reach;

template <class A>
using For = std::type_identity<A>;

// Files and where one stands.
constexpr ActionName named(For<OpenExample>) { return {"Open an example", control, "welcome/sphere"}; }
constexpr ActionName named(For<OpenFile>) { return {"Open a mesh file", control, "open/open"}; }
constexpr ActionName named(For<CloseMesh>) { return {"Close the mesh", control, "menu/Close"}; }
constexpr ActionName named(For<StepBy>) { return {"Step by item, row or stage", control, "forward"}; }
constexpr ActionName named(For<SeekTo>) { return {"Go to a position", control, "track"}; }
constexpr ActionName named(For<SeekPlace>) { return {"Go to a place", control, "row/2"}; }
constexpr ActionName named(For<ToFirst>) { return {"Go to the start", control, "first"}; }
constexpr ActionName named(For<ToLast>) { return {"Go to the end", control, "last"}; }
constexpr ActionName named(For<SetPlaying>) { return {"Play or pause", control, "play"}; }
constexpr ActionName named(For<SetSpeed>) { return {"Set the speed", control, "speed"}; }
constexpr ActionName named(For<PassTime>) { return {"Let time pass", machine, "The clock's tick."}; }

// Parameters.
constexpr ActionName named(For<Tune>) { return {"Change a parameter", control, "knob/epsilon"}; }
constexpr ActionName named(For<EditFromHere>) { return {"Change a parameter from here on", control, "mode"}; }
constexpr ActionName named(For<RemoveEdit>) {
  return {"Take back a change on the way", control, "edit/0/remove"};
}
constexpr ActionName named(For<ApplyPreset>) { return {"Take a preset", control, "menu/Best rows"}; }
constexpr ActionName named(For<CancelWork>) { return {"Cancel long work", control, "waiting/cancel"}; }
constexpr ActionName named(For<SetPicking>) {
  return {"Pick the start or the end in the view", control, "pick/start"};
}
constexpr ActionName named(For<PickVertex>) {
  return {"Take a vertex as start or end", view, "A click, after Pick beside the parameter."};
}
constexpr ActionName named(For<Settle>) {
  return {"End a held change", machine, "The hand that drags a knob has let go of it."};
}
constexpr ActionName named(For<Undo>) { return {"Undo a change", control, "undo"}; }
constexpr ActionName named(For<Redo>) { return {"Redo a change", control, "redo"}; }
constexpr ActionName named(For<CopyParameters>) { return {"Copy all parameters", control, "copy"}; }
constexpr ActionName named(For<PasteParameters>) { return {"Paste parameters", control, "paste"}; }

// Why, and finding one's way.
constexpr ActionName named(For<Select>) {
  return {"Select an element, or nothing", control, "selected/close"};
}
constexpr ActionName named(For<LookAt>) {
  return {"Look at what a figure or a mark is of", control, "track"};
}
constexpr ActionName named(For<SelectSized>) {
  return {"Light all edges or corners of a size", control, "plot/wale"};
}
constexpr ActionName named(For<ShowWhy>) { return {"Show why an element is there", control, "selected/why"}; }
constexpr ActionName named(For<ToTouch>) {
  return {"Go to a step that touches what is selected", control, "selected/forward"};
}
constexpr ActionName named(For<GoTo>) {
  return {"Go to what is named", control, "menu/Why does this row have so many stitches?"};
}
constexpr ActionName named(For<GoBack>) {
  return {"Go back to where one was", control, "menu/Back to where you were"};
}
constexpr ActionName named(For<GoForward>) { return {"Go forward again", control, "menu/Forward again"}; }
constexpr ActionName named(For<StepDeep>) { return {"Step over, into or out", control, "menu/Step into"}; }
constexpr ActionName named(For<SetBreaks>) { return {"Set break conditions", control, "break/add"}; }
constexpr ActionName named(For<RunToBreak>) { return {"Go to a break", control, "break/next"}; }
constexpr ActionName named(For<SetLoop>) { return {"Play round and round in a stretch", control, "loop"}; }
constexpr ActionName named(For<SetSlowMotion>) {
  return {"Slow down where it matters", control, "slow-motion"};
}

// Two settings side by side.
constexpr ActionName named(For<PinRun>) { return {"Pin this run", control, "compare/pin"}; }
constexpr ActionName named(For<SwapPinned>) { return {"Swap with the pinned run", control, "compare/swap"}; }
constexpr ActionName named(For<Unpin>) { return {"Let the pinned run go", control, "compare/unpin"}; }
constexpr ActionName named(For<StartSweep>) { return {"Start a sweep", control, "sweep/start"}; }
constexpr ActionName named(For<CancelSweep>) { return {"Cancel the sweep", control, "sweep/cancel"}; }
constexpr ActionName named(For<TakeSweepValue>) {
  return {"Take the value of a sweep's run", view, "A click on its point in the sweep's plot or map."};
}

// Sessions.
constexpr ActionName named(For<OpenSession>) { return {"Open a session", control, "open/open"}; }
constexpr ActionName named(For<CopyLink>) {
  return {"Copy a command line for this", control, "menu/Copy a command line that opens exactly this"};
}
constexpr ActionName named(For<CopyRows>) { return {"Copy the list of rows", control, "rows/copy"}; }
constexpr ActionName named(For<TakeRescued>) { return {"Open the rescued session", control, "rescue/open"}; }
constexpr ActionName named(For<DropRescued>) {
  return {"Forget the rescued session", control, "rescue/forget"};
}

// The view.
constexpr ActionName named(For<SetLayer>) { return {"Show or hide a layer", control, "layer/surface"}; }
constexpr ActionName named(For<Orbit>) { return {"Turn the view", view, "A drag with the left button."}; }
constexpr ActionName named(For<Pan>) { return {"Move the view", view, "A drag with the right button."}; }
constexpr ActionName named(For<Zoom>) { return {"Zoom", view, "The wheel."}; }
constexpr ActionName named(For<FrameAll>) { return {"Frame the mesh", control, "menu/Frame the mesh"}; }
constexpr ActionName named(For<SetFollowing>) {
  return {"Turn the view to what happens behind the surface", control, "menu/Turn to what happens"};
}
constexpr ActionName named(For<TurnToStep>) {
  return {"Turn the view to the step", machine, "It turns by itself while that is chosen."};
}
constexpr ActionName named(For<SetAspect>) {
  return {"Fit the view's shape", machine, "The window or a panel has another size."};
}
constexpr ActionName named(For<ShowSide>) { return {"Show a side panel", control, "side/report"}; }
constexpr ActionName named(For<ShowList>) { return {"Show a list", control, "list"}; }
constexpr ActionName named(For<Present>) {
  return {"Present to a class", control, "menu/Present to a class"};
}
constexpr ActionName named(For<SetRing>) {
  return {"Ring round the pointer while presenting", control, "menu/Ring round the pointer"};
}
constexpr ActionName named(For<ShowBoth>) {
  return {"Show the pinned run beside this one", control, "menu/Show the pinned run beside this one"};
}
constexpr ActionName named(For<SetPositions>) {
  return {"Show stitches settled or as placed", control, "menu/Stitches as placed"};
}
constexpr ActionName named(For<SetYarnLook>) {
  return {"Set the yarn's colours and stripes", control, "yarn/colour"};
}
constexpr ActionName named(For<ShowAs>) {
  return {"Show mesh, stitches, the relaxed piece or yarn", control, "looking"};
}
constexpr ActionName named(For<SetPatternOptions>) {
  return {"Set what stands over the pattern", control, "pattern/Title"};
}
constexpr ActionName named(For<SetPieceNames>) {
  return {"Name pieces of the pattern", view,
          "Their names in the list of pieces, at the head of the pattern."};
}
constexpr ActionName named(For<SetPieceOrder>) {
  return {"Set the order of pieces", view,
          "A drag of a line in the list of pieces, at the head of the pattern."};
}
constexpr ActionName named(For<ShowCentre>) {
  return {"Show the view or the chart", control, "menu/The view or the chart"};
}
constexpr ActionName named(For<HoverStitch>) {
  return {"Light a stitch", machine, "It is under the pointer; nothing is done to it."};
}
constexpr ActionName named(For<HoverRounds>) {
  return {"Light rounds", machine, "They are under the pointer; nothing is done to them."};
}
constexpr ActionName named(For<KnitAlong>) {
  return {"Knit along, or put it away", control, "menu/Knit along, round by round"};
}
constexpr ActionName named(For<Export>) { return {"Save a file", control, "save/save"}; }

// A written pattern that is checked.
constexpr ActionName named(For<ShowChecker>) {
  return {"Check a written pattern", control, "menu/Check a written pattern"};
}
constexpr ActionName named(For<CheckFile>) {
  return {"Check the pattern in a file", view, "A pattern that is dropped on the window, or chosen in Open."};
}
constexpr ActionName named(For<SetCheckedText>) {
  return {"Type or paste the pattern that is checked", control, "checker/paste"};
}
constexpr ActionName named(For<RestoreCheckedText>) {
  return {"Put the pattern back that stood there before", control, "checker/restore"};
}
constexpr ActionName named(For<SaveCheckedText>) {
  return {"Save the checked pattern", control, "checker/save"};
}
constexpr ActionName named(For<GoToCheckedLine>) {
  return {"Go to a line of the checked pattern", control, "checker/mistake/2"};
}
constexpr ActionName named(For<ToMistake>) {
  return {"Go to the pattern's next mistake", control, "checker/next"};
}
constexpr ActionName named(For<ShowCheckedSize>) {
  return {"Show another size of the checked pattern", view, "The sizes over the text, where it has several."};
}
constexpr ActionName named(For<SetCheckedGauge>) {
  return {"Set the gauge of the pattern's preview", control, "checker/stitches"};
}

// The program itself.
constexpr ActionName named(For<SetTheme>) { return {"Choose the theme", control, "menu/Light"}; }
constexpr ActionName named(For<SetScale>) {
  return {"Set the size of words and lines", control, "menu/Projector"};
}
constexpr ActionName named(For<ShowRowColumn>) {
  return {"Choose columns of the list of rows", control, "rows/columns"};
}
constexpr ActionName named(For<SetMotion>) { return {"Allow short movements", control, "menu/Motion"}; }
constexpr ActionName named(For<ShowPanel>) { return {"Show or close a panel", control, "menu/Parameters"}; }
constexpr ActionName named(For<SetSplit>) { return {"Set the size of a panel", control, "split/left"}; }
constexpr ActionName named(For<ResetLayout>) {
  return {"Reset the layout", control, "menu/Reset the layout"};
}
constexpr ActionName named(For<ForgetRecent>) {
  return {"Forget the recent files and examples", control, "recent/forget"};
}

// Learning.
constexpr ActionName named(For<StartLesson>) { return {"Start a lesson", control, "menu/learn"}; }
constexpr ActionName named(For<LeaveLesson>) { return {"Leave the lesson", control, "lesson/leave"}; }
constexpr ActionName named(For<TurnLesson>) { return {"Turn the lesson's page", control, "lesson/back"}; }
constexpr ActionName named(For<AnswerLesson>) {
  return {"Answer the lesson's question", control, "lesson/answer"};
}
constexpr ActionName named(For<SetPredicting>) {
  return {"Guess before each verdict", control, "menu/predict"};
}
constexpr ActionName named(For<Guess>) { return {"Guess a verdict", control, "predict/accepted"}; }
constexpr ActionName named(For<PointAt>) {
  return {"Light a variable in the view", machine, "It is under the pointer; nothing is done to it."};
}

// Figures.
constexpr ActionName named(For<SavePicture>) { return {"Save a picture", control, "menu/Save a picture..."}; }
constexpr ActionName named(For<SaveAnimation>) {
  return {"Save an animation", control, "menu/Save an animation..."};
}
constexpr ActionName named(For<CancelAnimation>) {
  return {"Cancel the animation", control, "animation/cancel"};
}

// Help and dialogs.
constexpr ActionName named(For<ShowActionPalette>) {
  return {"Show all actions", control, "menu/All actions"};
}
constexpr ActionName named(For<ShowGoTo>) { return {"Ask where to go", control, "menu/Go to..."}; }
constexpr ActionName named(For<ShowGlossary>) { return {"Show the glossary", control, "menu/Glossary"}; }
constexpr ActionName named(For<ShowHelp>) { return {"Show keys and mouse", control, "menu/Keys and mouse"}; }
constexpr ActionName named(For<ShowOpenDialog>) { return {"Choose a file to open", control, "welcome/open"}; }
constexpr ActionName named(For<DismissNotice>) { return {"Dismiss a notice", control, "notice/0"}; }
constexpr ActionName named(For<PutNoteAway>) {
  return {"Put away what is said of the place", control, "note/away"};
}
constexpr ActionName named(For<RepairAndOpen>) {
  return {"Repair the mesh and open it", control, "repair/open"};
}
constexpr ActionName named(For<DropRepairOffer>) {
  return {"Leave the mesh unrepaired", control, "repair/not-now"};
}
constexpr ActionName named(For<UndoRepair>) { return {"Undo the repairs", control, "repair/undo"}; }
constexpr std::string_view by_words = "In the list of all actions, where a curve is typed.";
constexpr ActionName named(For<SetCurves>) { return {"Set all curves", view, by_words}; }
constexpr ActionName named(For<AddCurve>) { return {"Begin or end at a curve", view, by_words}; }
constexpr ActionName named(For<RemoveCurve>) { return {"Remove a curve", view, by_words}; }
constexpr ActionName named(For<SwapCurves>) { return {"Swap the curves of start and end", view, by_words}; }
constexpr ActionName named(For<OpenCurves>) { return {"Open a file of curves", view, by_words}; }
constexpr ActionName named(For<Quit>) { return {"Quit", control, "menu/Quit"}; }

template <std::size_t... i>
constexpr auto all_named(std::index_sequence<i...> /*indices*/) {
  return std::array{named(For<ActionKinds::at<i>>{})...};
}

constexpr auto names = all_named(std::make_index_sequence<ActionKinds::size>());

}  // namespace

const std::array<ActionName, ActionKinds::size>& action_names() { return names; }

const ActionName& name_of(const Action& action) { return names.at(action.index()); }

}  // namespace app
