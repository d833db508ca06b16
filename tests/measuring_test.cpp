// How close the finished piece is, measured beside the window: once it is finished, and of that run only.
#include "app/actions/background_work.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "tests/support/beside.h"

using namespace app;
using namespace test_support;

namespace {

Session measured_session() {
  Session session = small_session();
  session.jobs->beside = true;
  tick_until(session, is_measured);
  return session;
}

knit::Closeness measured_anew(const Session& session) {
  return knit::measure_closeness(session.document->timeline.input(), session.document->timeline.furthest())
      .value();
}

void check_measures(const Session& session) {
  REQUIRE(session.document->closeness);
  const knit::Closeness plain = measured_anew(session);
  CHECK(session.document->closeness->knit_area == plain.knit_area);
  CHECK(session.document->closeness->mesh_to_knit.mean == plain.mesh_to_knit.mean);
  CHECK(session.document->closeness->knit_to_mesh.max == plain.knit_to_mesh.max);
}

void tune_cast_on(Session& session, int count) {
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.rows.cast_on = count;
  apply(session, Tune{parameters});
}

}  // namespace

TEST_CASE("closeness is measured once the run is finished, wherever one looks") {
  Session session = small_session();
  session.jobs->beside = true;
  apply(session, PassTime{0.001});
  CHECK_FALSE(session.jobs->run.measuring);  // the run has only now been worked out
  apply(session, PassTime{0.001});
  CHECK((session.jobs->run.measuring || session.document->closeness));
  tick_until(session, is_measured);
  CHECK_FALSE(session.jobs->run.measuring);
  CHECK_FALSE(session.jobs->run.measuring);
  CHECK(session.document->timeline.position() == 0);
  check_measures(session);
  const auto once = session.document->closeness;
  for (int i = 0; i < 5; ++i) apply(session, PassTime{0.001});
  CHECK(session.document->closeness == once);  // the same object: not measured again
}

TEST_CASE("closeness is forgotten when the run changes, and measured anew") {
  Session session = measured_session();
  const double before = session.document->closeness->knit_area;
  tune_cast_on(session, 9);
  apply(session, PassTime{0.001});
  CHECK(session.document->closeness == nullptr);
  tick_until(session, is_measured);
  CHECK(session.document->closeness->knit_area != before);
  check_measures(session);
}

TEST_CASE("a run that stops is not measured") {
  Session session = small_session();
  session.jobs->beside = true;
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.timing.axis = {knit::AxisKind::z, {}};
  apply(session, Tune{parameters});
  for (int i = 0; i < 5; ++i) apply(session, PassTime{0.001});
  REQUIRE(session.document->timeline.stop() != nullptr);
  CHECK_FALSE(session.jobs->run.measuring);
  CHECK_FALSE(session.jobs->run.measuring);
  CHECK(session.document->closeness == nullptr);
}

TEST_CASE("a change that is taken back before the new run was measured is measured again") {
  Session session = measured_session();
  const int cast_on = session.document->timeline.parameters().rows.cast_on;
  tune_cast_on(session, 9);
  apply(session, PassTime{0.001});
  tune_cast_on(session, cast_on);
  for (int i = 0; i < 4; ++i) apply(session, PassTime{0.001});
  CHECK((session.jobs->run.measuring || session.document->closeness));
  tick_until(session, [](Session& s) { return !s.jobs->run.measuring; });
  check_measures(session);
}

TEST_CASE("a change that leaves the run as it is leaves it measured") {
  Session session = measured_session();
  knit::Parameters parameters = session.document->timeline.parameters();
  parameters.size.height_cm = 30.0;  // the mesh gives the sizes
  apply(session, Tune{parameters});
  for (int i = 0; i < 4; ++i) apply(session, PassTime{0.001});
  CHECK((session.jobs->run.measuring || session.document->closeness));
}

TEST_CASE("a report measures what it reports on") {
  Session session = measured_session();
  apply(session, SeekPlace{{knit::Stage::faces, 5, 3}});
  const auto there =
      knit::measure_closeness(session.document->timeline.input(), session.document->timeline.state());
  REQUIRE(there);
  CHECK(closeness_now(*session.document)->knit_area == there->knit_area);
  apply(session, ToLast{});
  tune_cast_on(session, 9);  // no tick since
  apply(session, ToLast{});
  CHECK(closeness_now(*session.document)->knit_area == measured_anew(session).knit_area);
}
