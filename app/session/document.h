// The open mesh, its run, and all that was done with them: closing drops it whole, opening makes a fresh one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/session/changes.h"
#include "app/session/pattern_pieces.h"
#include "app/session/pins.h"
#include "app/session/sweep.h"
#include "app/session/travel.h"
#include "knit/curves/cycle.h"
#include "knit/import/check.h"
#include "knit/import/repair.h"
#include "knit/quality/closeness.h"
#include "knit/run/timeline.h"

namespace app {

// Where the mesh came from: one of the two is set once something is open.
struct Source {
  std::string example;                      // "thesis-sphere"
  std::filesystem::path file;               // as given
  std::vector<knit::RepairKind> repairs{};  // carried out on what the file says, in this order
  std::vector<knit::Cycle> curves{};        // cut along then: where knitting begins and ends
  friend bool operator==(const Source&, const Source&) = default;
};

// A session file, and what it says.
struct SavedAs {
  std::filesystem::path path;
  std::string text;
  friend bool operator==(const SavedAs&, const SavedAs&) = default;
};

struct Document {
  explicit Document(knit::Timeline run) : timeline(std::move(run)) {}

  Source source;
  std::shared_ptr<const knit::Mesh> original;  // as read, before welding
  std::string mesh_hash;                       // hash_text of `original`; empty: not known
  std::vector<knit::Finding> findings;         // warnings about the mesh
  std::vector<knit::RepairStep> repaired;      // what was done to it, as source.repairs says
  std::shared_ptr<const Session>
      before_repair;          // what undoing the repairs goes back to; null: nothing to undo
  knit::Parameters defaults;  // of the mesh or example: what reset goes back to
  knit::Timeline timeline;
  std::optional<knit::Parameters> before_change;  // what cancelling goes back to
  Changes changes;                                // of parameters, to undo and redo
  Travel travel;                                  // where one was, what is selected, the loop
  std::string place_note;        // why another place is shown than the one tuned at; else empty
  std::optional<Pin> pinned;     // the run that this one is compared with
  std::optional<Sweep> sweep;    // under way or done
  std::optional<SavedAs> saved;  // the session file last written or opened
  std::shared_ptr<const knit::Closeness> closeness;  // of the finished run; null: not measured
  std::uint64_t closeness_run = 0;                   // closeness_key of what `closeness` belongs to
  double load_ms = 0.0;                              // of opening it
  double run_ms = 0.0;                               // spent on working the run out, so far
  PatternPieces pieces;                              // their names and order, where the pattern has some
};

// To undo to.
Change change_of(const Document& document);

// What `closeness_run` is compared with: the state, and the stitch that coverage is judged by.
std::uint64_t closeness_key(const knit::State& state, const knit::Parameters& parameters);
// How close the finished piece is to the mesh: measured at once, unless it is known.
std::shared_ptr<const knit::Closeness> closeness_now(const Document& document);

}  // namespace app
