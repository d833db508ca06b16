// The pinned run behind the current one: its rows and columns as thin, pale lines.
#pragma once

#include <memory>
#include <vector>

#include "app/scene/scene.h"
#include "app/session/pins.h"
#include "app/session/session.h"
#include "app/session/view.h"
#include "knit/fabric/stitch.h"

namespace app {

// Keeps the lines of each row as long as the same run is pinned, so that a renderer uploads them once.
class Ghost {
 public:
  // Rows and strips that are the same in the current run are left out: there is nothing to tell apart.
  void describe(const Session& session, Scene& scene);

 private:
  using Lines = std::shared_ptr<const std::vector<Line>>;
  void refresh(const Session& session, const Theme& theme, const Pin& pin);

  std::shared_ptr<const knit::Input> input_, here_;  // of the pinned run and the current one
  std::uint64_t end_ = 0;                            // hash of the state that the lines are of
  const Theme* theme_ = nullptr;                     // of the lines
  Positions positions_ = Positions::settled;         // likewise
  bool same_mesh_ = false;
  struct RowLines {
    knit::RowId id;        // below 0: of a deal
    Lines edges, columns;  // columns: down to what the row is worked on; null where there are none
  };
  std::vector<RowLines> rows_;
};

}  // namespace app
