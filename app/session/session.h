// All that the program knows: one value. Panels read it and return wishes (action.h); only `apply` and what else
// stands in app/actions changes it.
//
// Everything includes this, so what the parts are made of stands in a header each: whoever uses a part includes
// that.
#pragma once

#include <string>

#include "app/session/part.h"

namespace knit {
struct Parameters;
struct Step;
}  // namespace knit

namespace app {

struct Program;   // program.h
struct Document;  // document.h
struct View;      // view.h
struct Learning;  // learning.h
struct Outbox;    // outbox.h
struct Jobs;      // jobs.h

struct Session {
  // In session.cpp: only there all parts are known.
  Session();
  Session(const Session& other);
  Session(Session&& other) noexcept;
  Session& operator=(const Session& other);
  Session& operator=(Session&& other) noexcept;
  ~Session();

  Part<Program> program;    // never missing, as all but the document
  Part<Document> document;  // nothing open: none
  Part<View> view;
  Part<Learning> learning;
  Part<Outbox> outbox;
  Part<Jobs> jobs;
};

// The last step taken, or null at the start or with nothing open.
const knit::Step* last_step(const Session& session);
// In force for the last step taken (for the next one at the start). Requires something open.
const knit::Parameters& parameters_of_last_step(const Session& session);
// One sentence for the last step; at the very end also why the run stopped. Never empty.
std::string sentence(const Session& session);
// Whether the view shows the run's last state and why that is the last: null unless the run stopped there.
const knit::Step* stop_shown(const Session& session);

}  // namespace app
