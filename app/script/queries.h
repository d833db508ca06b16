// What a command line asks beside files: each answers on standard output, without a window.
//
// The `fault_of_...` look at the words alone, before anything is opened; the error is one sentence.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/script/command_line.h"

namespace app {

// --why row:ROW|stitch:ROW:ITEM|vertex:ID: the step, its numbers and its sentence. why_query.cpp
std::optional<std::string> fault_of_why(const std::string& thing);
// What --select may be: a thing, or all things of a size; empty is fine.
std::optional<std::string> fault_of_select(const std::string& what);
// Lights it, and the view turns to it. Does nothing where nothing is open or nothing is to be selected.
void select_as_asked(Session& session, const std::string& what);
Answer why_answer(Session& session, const std::string& thing);

// --go-to WORDS: goes there from the step shown; one line of what is there.
std::optional<std::string> fault_of_go_to(const std::string& words);
Answer go_to_answer(Session& session, const std::string& words);

// --break COND. break_query.cpp
std::optional<std::string> fault_of_break(const std::string& condition);
std::vector<knit::BreakCondition> breaks_of(const std::vector<std::string>& texts);  // those without a fault
// Goes to the first step from the one shown on at which a condition holds, else to the end; says which and
// what happens there as a line for standard error.
Answer break_answer(Session& session);

// --sweep PARAM=FROM:TO:N, once or twice: CSV, a header and a line a run. sweep_query.cpp
std::optional<std::string> fault_of_sweep(const std::vector<std::string>& axes);
// The session keeps the sweep, so that a picture shows it; in a window it goes on beside it and nothing is written.
Answer sweep_answer(Session& session, const std::vector<std::string>& axes);

// --explain: the pseudo-code at the current place with the line that just ran, the variables and the sentence.
// explain_query.cpp
Answer explain_answer(const Session& session);
// --point NAME: one of its variables, lit in pictures.
std::optional<std::string> fault_of_point(const std::string& variable);

// --ways-on: what else knits a mesh whose run stopped, each tried to the end; a line each with the rows and the options
// that make it.
Answer ways_answer(Session& session);

// --diff OTHER.json: what differs from the run of another session, which is pinned. diff_query.cpp
Answer diff_answer(Session& session, const std::filesystem::path& other);

}  // namespace app
