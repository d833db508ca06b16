// Actions that are done in files of their own, by what they are about; `apply` hands them on.
#pragma once

#include <chrono>
#include <string>

#include "app/files/load.h"
#include "app/files/session_file.h"
#include "app/lessons/lesson.h"
#include "app/session/action.h"
#include "app/session/document.h"

namespace app {

// apply_why.cpp
void take(Session& session, const Select& action);
void take(Session& session, const LookAt& action);
void take(Session& session, const SelectSized& action);
void take(Session& session, const ShowWhy& action);
void take(Session& session, const ToTouch& action);
void take(Session& session, const GoBack& action);
void take(Session& session, const GoForward& action);
// Before a jump: the place left behind can be come back to.
void remember_place(Session& session);

// apply.cpp: the speed stays.
void stop_playing(Session& session);

// apply_travel.cpp
void take(Session& session, const StepDeep& action);
void take(Session& session, const SetBreaks& action);
void take(Session& session, const GoTo& action);
void take(Session& session, const RunToBreak& action);
void take(Session& session, const SetLoop& action);
void take(Session& session, const SetSlowMotion& action);
// The clock's tick: carries the hits of break conditions and the loop on with the run.
void tend_travel(Session& session);
void fly_on(Session& session, double seconds);  // the camera, where it is on its way
// As far as so many seconds lead; stops at a break condition's hit. Requires something open.
void play(Session& session, double seconds);

// apply_changes.cpp
void take(Session& session, const Settle& action);
void take(Session& session, const Undo& action);
void take(Session& session, const Redo& action);
void take(Session& session, const CopyParameters& action);
void take(Session& session, const PasteParameters& action);
// Before parameters or edits change: what they were can be gone back to.
void remember_knobs(Session& session);
// A notice, unless it is the newest already.
void tell(Session& session, const std::string& words);

// apply_repair.cpp: what became of opening the mesh at `path`, repaired as wished: it is shown, or it is said why not,
// or repairs are offered.
void show_opened(Session& session, std::variant<Loaded, NotOpened> opened, const std::filesystem::path& path,
                 const knit::RepairWish& repairs, std::chrono::steady_clock::time_point start);

// apply.cpp: what was opened takes the place of what is open, which is handed back; `start`: when opening began.
Part<Document> show_loaded(Session& session, Loaded loaded, Source source,
                           std::chrono::steady_clock::time_point start);
// Likewise with a document as it is, or with none. What was said about the other, begun for it and seen of it goes;
// how one looks, and what was asked for besides, stays.
Part<Document> show_instead(Session& session, Part<Document> document);
// What was open, how one looked at it, what was said and offered then. The window's shape is as it is now.
void go_back_to(Session& session, const Session& before);

// apply_pieces.cpp
void take(Session& session, const SetPieceNames& action);
void take(Session& session, const SetPieceOrder& action);
void take(Session& session, const ShowCentre& action);

// apply_compare.cpp
void take(Session& session, const PinRun& action);
void take(Session& session, const SwapPinned& action);
void take(Session& session, const Unpin& action);
void take(Session& session, const ShowBoth& action);
void take(Session& session, const StartSweep& action);
void take(Session& session, const CancelSweep& action);
void take(Session& session, const TakeSweepValue& action);

// apply_session.cpp
// A session file was read: shown, as OpenSession or TakeRescued does it.
void take_opened(Session& session, OpenedSession opened, std::chrono::steady_clock::time_point start,
                 bool rescued);
void take(Session& session, const OpenSession& action);
void take(Session& session, const CopyLink& action);
void take(Session& session, const CopyRows& action);
void take(Session& session, const TakeRescued& action);
void take(Session& session, const DropRescued& action);

// apply_preferences.cpp
void take(Session& session, const SetTheme& action);
void take(Session& session, const SetScale& action);
void take(Session& session, const SetMotion& action);
void take(Session& session, const ShowPanel& action);
void take(Session& session, const ShowRowColumn& action);
void take(Session& session, const SetSplit& action);
void take(Session& session, const ResetLayout& action);
void take(Session& session, const ForgetRecent& action);
// After something was opened: it comes first among the recent ones.
void note_opened(Session& session);
// After it could not be: a file that has gone is not offered again.
void note_not_opened(Session& session, const Source& source);

// apply_repair.cpp
void take(Session& session, const OpenFile& action);
void take(Session& session, const RepairAndOpen& action);
void take(Session& session, const DropRepairOffer& action);
void take(Session& session, const UndoRepair& action);

void take(Session& session, const SetCurves& action);
void take(Session& session, const AddCurve& action);
void take(Session& session, const RemoveCurve& action);
void take(Session& session, const SwapCurves& action);
void take(Session& session, const OpenCurves& action);
// The run goes on, with these knobs, on the mesh as it was cut; what was left out is said.
void show_cut(Session& session, const Loaded& loaded, const Knobs& knobs);

// apply_lesson.cpp
void take(Session& session, const StartLesson& action);
void take(Session& session, const LeaveLesson& action);
void take(Session& session, const TurnLesson& action);
void take(Session& session, const AnswerLesson& action);
// lesson_deeds.cpp: a deed of a page; done through `apply`, except for what no hand can do at once.
void do_deed(Session& session, const Deed& deed);
// After every action: what the lesson waits for may have been done.
void tend_lesson(Session& session, const Action& action);

// apply_predict.cpp
void take(Session& session, const SetPredicting& action);
void take(Session& session, const Guess& action);
// Playing has stopped here, and goes on after the guess.
void wait_for_guess(Session& session);
// After every action: a verdict that comes next is known, and what was told about the last one fits the place.
void tend_prediction(Session& session);

// apply_checker.cpp
void take(Session& session, const ShowChecker& action);
void take(Session& session, const CheckFile& action);
void take(Session& session, const SetCheckedText& action);
void take(Session& session, const RestoreCheckedText& action);
void take(Session& session, const SaveCheckedText& action);
void take(Session& session, const GoToCheckedLine& action);
void take(Session& session, const ToMistake& action);
void take(Session& session, const ShowCheckedSize& action);
void take(Session& session, const SetCheckedGauge& action);
// The clock's tick: shows what a worker has read, and lets it read what was typed meanwhile.
void tend_checker(Session& session);
// Of the view that is turned: the checker's while that is shown; true where it was one.
bool turn_checker(Session& session, const Action& action);

// apply_figures.cpp
void take(Session& session, const SavePicture& action);
void take(Session& session, const SaveAnimation& action);
void take(Session& session, const CancelAnimation& action);

}  // namespace app
