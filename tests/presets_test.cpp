// Presets: settings that the table takes, that run, and that say what they are for.
#include "app/session/presets.h"
#include "app/session/document.h"
#include "app/session/outbox.h"

#include <set>

#include "knit/model/settings_table.h"
#include "knit/model/stitch_size.h"
#include "knit/quality/measures.h"
#include "tests/support/catch.h"
#include "tests/support/session.h"

using namespace app;
using test_support::contains;
using test_support::example_session;
using test_support::is_one_sentence;

namespace {

const Preset& preset(std::string_view key) {
  const Preset* found = find_preset(key);
  REQUIRE(found != nullptr);
  return *found;
}

}  // namespace

TEST_CASE("there are four presets, each found by its key, with a title and a sentence") {
  std::set<std::string_view> keys;
  for (const Preset& p : presets()) {
    CAPTURE(p.key);
    keys.insert(p.key);
    CHECK(find_preset(p.key) == &p);
    CHECK_FALSE(p.title.empty());
    CHECK(is_one_sentence(std::string(p.about)));
    CHECK_FALSE(p.settings.empty());
  }
  CHECK(keys == std::set<std::string_view>{"thesis", "best-rows", "knitters-gauge", "hand"});
  CHECK(presets().size() == 4);
  CHECK(preset_keys() == "thesis, best-rows, knitters-gauge or hand");
  CHECK(find_preset("") == nullptr);
  CHECK(find_preset("Thesis") == nullptr);
}

TEST_CASE("every setting of a preset is taken by the table, and is in force afterwards") {
  // Away from every default, so that a setting which is not applied shows.
  knit::Parameters odd;
  odd.timing.kind = knit::TimingKind::harmonic;
  knit::give_sizes(odd, knit::SizesFrom::gauge);
  knit::give_height(odd, 0.7);
  knit::give_gauge(odd, {9.0, 9.0});
  odd.size.height_cm = 99.0;
  odd.rows.start_direction = glm::dvec3(1.0, 0.0, 0.0);
  odd.rows.cast_on = 9;
  odd.rows.metric = knit::Metric::arc;
  odd.rows.last_anchor = knit::LastAnchor::drop;
  odd.rows.close = knit::Closing::none;
  odd.stitches.placement = knit::PlacementPolicy::even;
  odd.stitches.stacking_penalty = 3.0;
  odd.stitches.follow_mains = knit::FollowMains::on;
  odd.settle.settling = knit::Settling::on;
  for (const Preset& p : presets()) {
    std::set<std::string_view> keys;
    for (const PresetSetting& setting : p.settings) {
      CAPTURE(p.key, setting.key, setting.value);
      CHECK(keys.insert(setting.key).second);
      const knit::ParameterInfo* info = knit::find_parameter(setting.key);
      REQUIRE(info != nullptr);
      knit::Parameters scratch = odd;
      CHECK_FALSE(knit::set_value(*info, scratch, setting.value));
      CHECK(knit::value_text(*info, with_preset(p, odd)) == setting.value);
    }
    // What it does not name stays.
    const knit::Parameters set = with_preset(p, odd);
    for (const knit::ParameterInfo& info : knit::parameter_table()) {
      if (keys.count(info.key) == 0) CHECK(knit::value_text(info, set) == knit::value_text(info, odd));
    }
    CHECK(with_preset(p, set) == set);
  }
}

TEST_CASE("each preset runs to the end on the sphere, the egg and the vase") {
  const std::string name = GENERATE(as<std::string>(), "sphere", "egg", "vase");
  Session session = example_session(name);
  for (const Preset& p : presets()) {
    CAPTURE(name, p.key);
    apply(session, ApplyPreset{std::string(p.key)});
    apply(session, ToLast{});
    CHECK(session.outbox->notices.empty());
    CHECK(session.document->timeline.stop() == nullptr);
    CHECK(session.document->timeline.state().finished());
    CHECK(knit::euler_characteristic(session.document->timeline.state()) == 0);
  }
}

TEST_CASE("the thesis's preset gives the thesis's sphere its golden counts, from wherever one comes") {
  Session session = example_session("thesis-sphere");
  apply(session, ApplyPreset{"best-rows"});
  knit::Parameters other = session.document->timeline.parameters();
  other.rows.start_direction = glm::dvec3(1.0, 0.0, 0.0);
  other.rows.cast_on = 9;
  other.rows.last_anchor = knit::LastAnchor::drop;
  apply(session, Tune{other});
  apply(session, ToLast{});
  CHECK(session.document->timeline.state().fabric.stitch_count() != 3372);
  apply(session, ApplyPreset{"thesis"});
  apply(session, ToLast{});
  CHECK(session.outbox->notices.empty());
  CHECK(session.document->timeline.state().fabric.stitch_count() == 3372);
  CHECK(knit::count_faces(session.document->timeline.state()).quads == 3307);
  CHECK(knit::count_faces(session.document->timeline.state()).triangles == 118);
}

TEST_CASE("the knitter's gauge makes an object of 12 cm from 22 stitches and 32 rounds in 10 cm") {
  Session session = example_session("sphere");
  apply(session, ApplyPreset{"knitters-gauge"});
  const knit::Parameters& p = session.document->timeline.parameters();
  CHECK(p.stitch.width == Approx(10.0 / 22.0 / 6.0));
  CHECK(p.stitch.height == Approx(10.0 / 32.0 / 6.0));
  CHECK(p.epsilon() / p.stitch.width == Approx(0.25));  // as the example has it
}

TEST_CASE("a preset is a change for the whole run: the place is kept, and twice is once") {
  Session session = example_session("egg");
  apply(session, ToLast{});
  const knit::Place place{knit::Stage::rows, 5, 2};
  apply(session, SeekPlace{place});
  apply(session, ApplyPreset{"best-rows"});
  apply(session, PassTime{0.0});
  CHECK(session.document->timeline.place() == place);
  CHECK(session.document->timeline.edits().empty());
  CHECK(session.document->timeline.base_parameters() ==
        with_preset(preset("best-rows"), session.document->timeline.base_parameters()));

  const knit::Parameters once = session.document->timeline.parameters();
  const std::uint64_t end = knit::hash_of(session.document->timeline.furthest());
  const std::size_t known = session.document->timeline.known();
  apply(session, ApplyPreset{"best-rows"});
  CHECK(session.document->timeline.parameters() == once);
  CHECK(session.document->timeline.known() == known);  // nothing to run anew
  CHECK(knit::hash_of(session.document->timeline.furthest()) == end);
  CHECK(session.document->timeline.place() == place);
}

TEST_CASE("an unknown preset is a notice and nothing else, with or without a mesh") {
  Session empty;
  apply(empty, ApplyPreset{"thesis"});
  CHECK(empty.outbox->notices.empty());
  for (Session session : {Session{}, test_support::finished_small_session()}) {
    const std::size_t known = session.document ? session.document->timeline.known() : 0;
    apply(session, ApplyPreset{"fluffy"});
    REQUIRE(session.outbox->notices.size() == 1);
    CHECK(session.outbox->notices[0].kind == Notice::Kind::error);
    CHECK(is_one_sentence(session.outbox->notices[0].text));
    CHECK(contains(session.outbox->notices[0].text, "fluffy"));
    CHECK(contains(session.outbox->notices[0].text, preset_keys()));
    CHECK((session.document ? session.document->timeline.known() : 0) == known);
  }
}
