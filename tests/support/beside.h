// A session as in a window, on a mesh whose solves take long; time passes only as a test says.
#pragma once

#include <chrono>
#include <string>
#include <thread>

#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/program.h"
#include "knit/model/stitch_size.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

namespace test_support {

// Above the number of triangles from which on steps may be long (knit/machine.cpp).
inline std::shared_ptr<const knit::Mesh> large_ball() {
  return std::make_shared<const knit::Mesh>(knit::sphere(160, 70));
}

inline knit::Parameters large_parameters(knit::TimingKind timing = knit::TimingKind::linear) {
  knit::Parameters parameters;
  parameters.timing.kind = timing;
  knit::give_width(parameters, 0.2);
  knit::give_epsilon(parameters, 0.1);
  parameters.rows.source = knit::RowSource::contours;
  parameters.stitches.placement = knit::PlacementPolicy::nearest;
  return parameters;
}

inline app::Session beside_session(const knit::Parameters& parameters) {
  app::Session session;
  session.program->assets = KNIT_ASSETS_DIR;
  session.jobs->beside = true;
  const auto mesh = large_ball();
  session.document = app::Document(knit::Timeline(knit::make_input(*mesh), parameters));
  session.document->original = mesh;
  session.document->defaults = parameters;
  return session;
}

// Ticks until the test holds; between ticks a worker has time to go on.
template <class Test>
void tick_until(app::Session& session, Test done) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  while (!done(session)) {
    app::apply(session, app::PassTime{0.001});
    REQUIRE(std::chrono::steady_clock::now() < give_up);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

inline bool run_is_complete(const app::Session& session) { return session.document->timeline.complete(); }
inline bool is_working(const app::Session& session) { return session.jobs->run.long_step.has_value(); }
inline bool is_measured(const app::Session& session) { return session.document->closeness != nullptr; }

// The whole run at once, as without a window.
inline std::uint64_t plain_hash(const knit::Parameters& parameters) {
  knit::Timeline timeline(knit::make_input(*large_ball()), parameters);
  timeline.extend_to_end();
  return knit::hash_of(timeline.furthest());
}

}  // namespace test_support
