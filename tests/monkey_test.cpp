// A monkey at the desk: thousands of actions drawn at random from a seed, on each example. Nothing may break, and
// the same actions replayed on a fresh session must lead to the same state. The sanitizers watch without the replay,
// which would use memory in just the same way once more.
#include <array>
#include <cstdlib>
#include <functional>
#include <random>
#include <span>

#include "app/actions/hosting.h"
#include "app/describe/describe.h"
#include "app/session/document.h"
#include "app/session/outbox.h"
#include "app/session/presets.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "tests/support/catch.h"
#include "tests/support/repeated.h"
#include "tests/support/session.h"

using namespace app;

namespace {

constexpr int few_iterations = 2;  // of settling: what a thousand runs have time for

class Monkey {
 public:
  explicit Monkey(unsigned seed, std::filesystem::path folder) : random_(seed), folder_(std::move(folder)) {}

  Action next(const Session& session) {
    const knit::Timeline& timeline = session.document->timeline;
    switch (below(40)) {
      case 0:
      case 1:
      case 2:
        return StepBy{static_cast<Unit>(below(3)), direction()};
      case 3:
      case 4:
      case 5:
      case 6:
        return SeekTo{below(timeline.known() + timeline.known() / 8 + 2)};
      case 7:
        return SeekPlace{place(timeline)};
      case 8:
        return below(2) == 0 ? Action(ToFirst{}) : Action(ToLast{});
      case 9:
        return SetPlaying{below(2) == 0, direction()};
      case 10:
        return SetSpeed{std::pow(10.0, uniform(-1.0, 6.0))};
      case 11:
      case 12:
      case 13:
        return PassTime{uniform(0.0, 0.3)};
      case 14:
        return Tune{tuned(timeline.parameters(), session.document->defaults)};
      case 15:
        return EditFromHere{tuned(timeline.parameters(), session.document->defaults)};
      case 16:
        return RemoveEdit{below(4)};
      case 17:
        return below(8) > 0 ? Action(Settle{})
                            : Action(ApplyPreset{std::string(presets()[below(presets().size())].key)});
      case 18:
        return Undo{};
      case 19:
        return Redo{};
      case 20:
        return CopyParameters{};
      case 21:
        return PasteParameters{below(3) == 0 ? "nonsense" : session.outbox->clipboard.value_or("")};
      case 22:
      case 23:
        return ShowWhy{thing(session)};
      case 24:
        return below(4) == 0 ? Action(Select{}) : Action(Select{thing(session)});
      case 25:
        return ToTouch{direction()};
      case 26:
        return below(2) == 0 ? Action(GoBack{}) : Action(GoForward{});
      case 27:
      case 28:
        return StepDeep{static_cast<Depth>(below(3)), direction()};
      case 29:
        return SetBreaks{breaks()};
      case 30:
        return RunToBreak{direction()};
      case 31:
        return below(3) == 0 ? Action(SetLoop{}) : Action(SetLoop{stretch(timeline)});
      case 32:
        return SetSlowMotion{below(2) == 0};
      case 33:
        return pinned();
      case 34:
        return swept(session);
      case 35:
        return filed(session);
      case 36:
        return looked(session);
      case 37:
        return turned();
      case 38:
        return KnitAlong{below(3) == 0 ? std::nullopt : std::optional(static_cast<std::int32_t>(below(80)))};
      default:
        return said();
    }
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  int direction() { return below(2) == 0 ? 1 : -1; }
  std::int32_t small(std::size_t bound) { return static_cast<std::int32_t>(below(bound)) - 1; }

  knit::Place place(const knit::Timeline& timeline) {
    if (timeline.known() > 0 && below(2) == 0) return timeline.step(below(timeline.known())).place;
    return {static_cast<knit::Stage>(1 + below(7)), small(90), small(400)};
  }

  // One or two knobs turned, mostly within reason: stitches must stay few enough for the test to end.
  knit::Parameters tuned(knit::Parameters parameters, const knit::Parameters& defaults) {
    const auto table = knit::parameter_table();
    for (std::size_t turns = 1 + below(2); turns > 0; --turns) {
      const knit::ParameterInfo& info = table[below(table.size())];
      if (const auto* number = std::get_if<knit::Number>(&info.kind)) {
        const double usual = number->get(defaults);
        number->set(parameters, below(12) == 0 ? number->low : usual * std::pow(2.0, uniform(-0.6, 2.0)));
      } else if (const auto* choice = std::get_if<knit::Choice>(&info.kind)) {
        // The timings that are solved for cost most: once in a while; and so does settling, which each change does anew.
        const bool dear =
            info.key == "timing" || info.key == "metric" || info.key == "rows" || info.key == "settle";
        choice->set(parameters, dear && below(30) > 0 ? 0 : static_cast<int>(below(choice->names.size())));
      } else if (const auto* count = std::get_if<knit::Count>(&info.kind)) {
        const bool iterations = info.key == "settle-iterations";
        count->set(parameters, iterations ? few_iterations : static_cast<int>(below(20)));
      } else if (const auto* picked = std::get_if<knit::PickedVertex>(&info.kind)) {
        picked->set(parameters, below(3) > 0 ? knit::no_vertex : static_cast<knit::VertexId>(below(3000)));
      } else {
        static_cast<void>(knit::set_value(info, parameters, std::array{"x", "y", "z", "1,2,3"}[below(4)]));
      }
    }
    return parameters;
  }

  knit::Element thing(const Session& session) {
    const auto row =
        static_cast<std::int32_t>(below(session.document->timeline.furthest().fabric.rows().size() + 3));
    const std::int32_t item = small(90);
    switch (below(6)) {
      case 0:
        return knit::StitchElement{row, item};
      case 1:
        return knit::RowEdgeElement{row, item};
      case 2:
        return knit::ColumnEdgeElement{row, item};
      case 3:
        return knit::FaceElement{row, item};
      case 4:
        return knit::LabelElement{row, item};
      default:
        return knit::VertexElement{
            static_cast<knit::VertexId>(below(session.document->timeline.input().mesh.positions.size() + 2))};
    }
  }

  std::vector<knit::BreakCondition> breaks() {
    constexpr std::array texts{"stage=rows", "row=14", "label=m1l",   "grows>2",   "shrinks>2",
                               "gap",        "stall",  "over-double", "wider>1.2", "narrower<0.8"};
    std::vector<knit::BreakCondition> conditions;
    for (std::size_t count = below(4); count > 0; --count)
      conditions.push_back(std::get<knit::BreakCondition>(knit::parse_break(texts[below(texts.size())])));
    return conditions;
  }

  Stretch stretch(const knit::Timeline& timeline) {
    const std::size_t begin = below(timeline.known() + 1);
    return {begin, begin + below(timeline.known() / 4 + 2)};
  }

  Action pinned() {
    switch (below(3)) {
      case 0:
        return SwapPinned{};
      case 1:
        return Unpin{};
      default:
        return PinRun{};
    }
  }

  Action swept(const Session& session) {
    if (below(6) > 0) return below(2) == 0 ? Action(CancelSweep{}) : Action(TakeSweepValue{below(4)});
    const double width = session.document->defaults.stitch.width;
    return StartSweep{{{"epsilon", 0.2 * width, 0.9 * width, 3}, std::nullopt}};
  }

  // The kinds that need no window; a saved session is opened again now and then.
  Action filed(const Session& session) {
    const std::filesystem::path saved = folder_ / "monkey-session.json";
    switch (below(30)) {
      case 0:
        return Export{"session", saved};
      case 1:
        return OpenSession{saved};
      case 2:
        return Export{"card", "/dev/null"};
      case 3:
        return Export{"mesh", folder_ / "no" / "such" / "folder.obj"};
      case 4:
        return CopyLink{};
      case 5:
        return TakeRescued{};
      case 6:
        return PutNoteAway{};
      default:
        return DismissNotice{session.outbox->notices.empty() ? 0 : below(session.outbox->notices.size())};
    }
  }

  Action looked(const Session& session) {
    switch (below(7)) {
      case 0:
        return SetLayer{static_cast<Layer>(below(layer_count)), below(2) == 0};
      case 1:
        return ShowSide{static_cast<SidePanel>(below(side_keys.size()))};
      case 2:
        return ShowCentre{static_cast<CentrePanel>(below(2))};
      case 3:
        return HoverStitch{StitchAt{small(80), small(80)}};
      case 4:
        return SetPicking{static_cast<Picking>(below(3))};
      case 5:
        return SetPositions{static_cast<Positions>(below(2))};
      default:
        return PickVertex{
            static_cast<knit::VertexId>(below(session.document->timeline.input().mesh.positions.size() + 2))};
    }
  }

  Action turned() {
    switch (below(4)) {
      case 0:
        return Orbit{uniform(-2.0, 2.0), uniform(-2.0, 2.0)};
      case 1:
        return Pan{{uniform(-1.0, 1.0), uniform(-1.0, 1.0)}};
      case 2:
        return Zoom{std::pow(2.0, uniform(-2.0, 2.0)), {uniform(-1.0, 1.0), uniform(-1.0, 1.0)}};
      default:
        return FrameAll{};
    }
  }

  Action said() {
    switch (below(4)) {
      case 0:
        return ShowHelp{below(2) == 0};
      case 1:
        return ShowOpenDialog{below(2) == 0};
      case 2:
        return SetAspect{uniform(0.2, 3.0)};
      default:
        return CancelWork{};
    }
  }

  std::mt19937 random_;
  std::filesystem::path folder_;
};

struct Fingerprint {
  std::uint64_t shown = 0, furthest = 0;
  std::size_t position = 0, known = 0, notices = 0;
  knit::Parameters base;
  std::vector<knit::Edit> edits;
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

Fingerprint fingerprint_of(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  return {knit::hash_of(timeline.state()),
          knit::hash_of(timeline.furthest()),
          timeline.position(),
          timeline.known(),
          session.outbox->notices.size(),
          timeline.base_parameters(),
          timeline.edits()};
}

constexpr int actions_between_looks = 250;

// KNIT_MONKEY_ACTIONS says how many; tools/thorough.sh asks for many more.
int actions_in_all() {
  if (const char* wish = std::getenv("KNIT_MONKEY_ACTIONS")) return std::atoi(wish);
  return test_support::repeated(1500);
}

void play_with(const std::string& example, unsigned seed) {
  const test_support::Folder folder;
  Session session = test_support::example_session(example);
  Session replayed = test_support::example_session(example);
  knit::Parameters quick = session.document->timeline.parameters();
  quick.settle.most_iterations = few_iterations;
  for (Session* each : {&session, &replayed}) {
    apply(*each, Tune{quick});
    forget_changes(*each);  // no undoing leads behind it
  }
  Monkey monkey(seed, folder.path());
  Describer describer;
  const int count = actions_in_all();
  for (int i = 0; i < count; ++i) {
    const Action action = monkey.next(session);
    INFO("seed " << seed << ", action " << i << ", kind " << action.index());
    apply(session, action);
    if (test_support::whole()) apply(replayed, action);
    if (i % actions_between_looks != 0) continue;
    if (test_support::whole()) REQUIRE(fingerprint_of(session) == fingerprint_of(replayed));
    CHECK(describer.describe(session).mesh != nullptr);
  }
  if (test_support::whole()) CHECK(fingerprint_of(session) == fingerprint_of(replayed));
}

}  // namespace

TEST_CASE("a monkey on the thesis sphere breaks nothing, and can be replayed") {
  play_with("thesis-sphere", 1);
}
TEST_CASE("a monkey on the sphere breaks nothing, and can be replayed") { play_with("sphere", 2); }
TEST_CASE("a monkey on the egg breaks nothing, and can be replayed") { play_with("egg", 3); }
TEST_CASE("a monkey on the capsule breaks nothing, and can be replayed") { play_with("capsule", 4); }
TEST_CASE("a monkey on the cone breaks nothing, and can be replayed") { play_with("cone", 5); }
TEST_CASE("a monkey on the stretched sphere breaks nothing, and can be replayed") {
  play_with("stretched-sphere", 6);
}
TEST_CASE("a monkey on the torus breaks nothing, and can be replayed") { play_with("torus", 7); }
TEST_CASE("a monkey on the vase breaks nothing, and can be replayed") { play_with("vase", 8); }
TEST_CASE("a monkey on the starfish breaks nothing, and can be replayed") { play_with("starfish", 10); }
