#include "tests/benchmark/soak.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <random>
#include <thread>

#include "app/actions/hosting.h"
#include "app/actions/opening.h"
#include "app/base/files.h"
#include "app/compare/sweep_work.h"
#include "app/files/rescue.h"
#include "app/render/headless_gl.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "app/window/animation.h"
#include "knit/model/stitch_size.h"
#include "tests/benchmark/ball_file.h"
#include "tests/benchmark/cost.h"
#include "tests/benchmark/desk.h"
#include "tests/benchmark/pipeline.h"

namespace benchmark {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double frame_s = 1.0 / 60.0;
constexpr double megabyte = 1024.0 * 1024.0;

struct Memory {
  double resident_mb = 0.0, in_use_mb = 0.0;
};

Memory memory_now() {
  malloc_trim(0);  // what is kept in store says nothing
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  const auto in_use = mallinfo2();
  return {static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / megabyte,
          static_cast<double>(in_use.uordblks + in_use.hblkhd) / megabyte};
}

// A folder of its own, gone with it.
class Workshop {
 public:
  Workshop() : path(fs::temp_directory_path() / ("knit-mesh-soak-" + std::to_string(getpid()))) {
    fs::create_directories(path);
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  const fs::path path;
};

// A person who tries everything, the same in each round.
class Person {
 public:
  explicit Person(const fs::path& assets)
      : desk_(assets), large_(60000), keeper_(desk_.session, workshop_.path / "state") {
    auto opened = app::HeadlessGl::open();
    if (auto* gl = std::get_if<app::HeadlessGl>(&opened)) {
      gl_.emplace(std::move(*gl));
      drawer_ = std::make_unique<app::FrameDrawer>(assets);
    }
  }

  void round() {
    random_.seed(7);
    for (const std::string& name : app::list_examples(desk_.session.program->assets)) {
      open_and_finish(app::OpenExample{name});
      tune();
      look_around();
      play();
      export_all();
      film();
      compare();
    }
    open_files();
    open_and_finish(app::OpenExample{"thesis-sphere"});
  }
  [[nodiscard]] bool draws() const { return drawer_ != nullptr; }

 private:
  void act(const app::Action& action) { desk_.act(action); }
  void frame() {
    act(app::PassTime{frame_s});
    if (drawer_) {
      drawer_->draw(desk_.session, shape_of(640, 400), {});
    } else {
      desk_.frame();
    }
    keeper_.pass(desk_.session, frame_s);
    if (drawer_) {
      app::save_figures(desk_.session, app::take_outgoing(desk_.session).pictures);
      app::tend_animation(desk_.session, animation_);
    }
    desk_.session.outbox->screenshots.clear();
    desk_.session.outbox->pages.clear();
    desk_.session.outbox->clipboard.reset();
  }
  void finish() {
    while (desk_.session.jobs->opening || !desk_.session.document->timeline.complete() ||
           desk_.session.jobs->run.measuring) {
      frame();
      if (desk_.session.jobs->opening || desk_.session.jobs->run.long_step)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void open_and_finish(const app::Action& opening) {
    act(opening);
    finish();
    act(app::ToLast{});
    frame();
  }
  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  std::size_t somewhere() {
    return static_cast<std::size_t>(share() * static_cast<double>(desk_.session.document->timeline.known()));
  }

  void tune() {
    const knit::Parameters first = desk_.session.document->timeline.parameters();
    for (int i = 0; i < 6; ++i) {
      knit::Parameters tuned = first;
      knit::give_epsilon(tuned, tuned.epsilon() * (0.7 + 0.6 * share()));
      tuned.rows.source = i % 2 == 0 ? first.rows.source : knit::RowSource::contours;
      act(app::Tune{tuned, true});
      frame();
      finish();
    }
    act(app::Settle{});
    act(app::SeekTo{somewhere()});
    knit::Parameters edited = desk_.session.document->timeline.parameters();
    knit::give_epsilon(edited, edited.epsilon() * 1.05);
    act(app::EditFromHere{edited});
    finish();
    for (int i = 0; i < 4; ++i) act(app::Undo{});
    act(app::Redo{});
    act(app::ApplyPreset{"best-rows"});
    finish();
    act(app::Tune{first});
    finish();
  }
  void look_around() {
    for (int i = 0; i < 20; ++i) {
      act(app::SeekTo{somewhere()});
      act(app::Orbit{0.1, 0.02});
      act(app::Zoom{i % 2 == 0 ? 1.2 : 1.0 / 1.2, {0.1, 0.1}});
      frame();
    }
    for (const auto side : {app::SidePanel::report, app::SidePanel::pattern, app::SidePanel::step}) {
      act(app::ShowSide{side});
      frame();
    }
    act(app::ShowWhy{knit::StitchElement{3, 2}});
    frame();
    act(app::Select{});
    act(app::ShowCentre{app::CentrePanel::chart});
    frame();
    act(app::ShowCentre{app::CentrePanel::view});
    act(app::SetTheme{app::ThemeKind::light});
    frame();
    act(app::SetTheme{app::ThemeKind::dark});
  }
  void play() {
    act(app::ToFirst{});
    act(app::SetPlaying{});
    for (int i = 0; i < 30; ++i) frame();
    act(app::SetPlaying{false});
    act(app::ToLast{});
    frame();
  }
  void export_all() {
    const std::initializer_list<std::pair<const char*, const char*>> all{
        {"mesh", "knit.obj"},   {"map", "map.txt"},         {"report", "report.json"}, {"card", "card.json"},
        {"steps", "steps.csv"}, {"pattern", "pattern.txt"}, {"chart", "chart.svg"},    {"session", "a.json"},
        {"gltf", "knit.glb"},   {"plots", "plots.svg"}};
    for (const auto& [kind, name] : all) act(app::Export{kind, workshop_.path / name});
    frame();
    act(app::OpenSession{workshop_.path / "a.json"});
    finish();
  }
  // A picture, a film, and one given up half-way.
  void film() {
    if (!drawer_) return;
    act(app::SavePicture{workshop_.path / "picture.png", 320, 240, true});
    const app::SaveAnimation film{
        workshop_.path / "film.gif", {0, desk_.session.document->timeline.known()}, 6, 10.0, 160, 120};
    act(film);
    frame();
    act(app::CancelAnimation{});
    frame();
    act(film);
    while (desk_.session.jobs->animation) frame();
  }
  void compare() {
    act(app::PinRun{});
    knit::Parameters other = desk_.session.document->timeline.parameters();
    knit::give_epsilon(other, other.epsilon() * 1.1);
    act(app::Tune{other});
    finish();
    act(app::ShowSide{app::SidePanel::compare});
    frame();
    act(app::SwapPinned{});
    finish();
    act(app::Unpin{});
    act(app::ShowSide{app::SidePanel::sweep});
    const double epsilon = other.epsilon();
    act(app::StartSweep{{{"epsilon", 0.8 * epsilon, epsilon, 6}, std::nullopt}});
    while (desk_.session.document->sweep && desk_.session.document->sweep->work->running()) frame();
    act(app::CancelSweep{});
    act(app::ShowSide{app::SidePanel::step});
  }
  // A large one, read beside; one given up half-way; and one that is not fit.
  void open_files() {
    act(app::OpenFile{large_.path});
    for (int i = 0; i < 3; ++i) frame();
    act(app::CancelWork{});
    open_and_finish(app::OpenFile{large_.path});
    const fs::path bad = workshop_.path / "bad.obj";
    app::write_file(bad, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    act(app::OpenFile{bad});
    frame();
  }

  Workshop workshop_;
  Desk desk_;
  BallFile large_;
  app::RescueKeeper keeper_;
  std::optional<app::HeadlessGl> gl_;
  std::unique_ptr<app::FrameDrawer> drawer_;
  std::unique_ptr<app::AnimationMaker> animation_;  // gone before what it draws with
  std::mt19937_64 random_;
};

// What most rounds stay below: a round may end while a worker has let go of something already.
double height_between(const std::vector<double>& all, std::size_t begin, std::size_t end) {
  return quantile(
      {all.begin() + static_cast<std::ptrdiff_t>(begin), all.begin() + static_cast<std::ptrdiff_t>(end)},
      0.8);
}

// The first third warms up: caches and stores reach their size. What the last third takes more than the one before
// may be chance, so far.
bool is_flat(const std::vector<double>& all, double share, double megabytes) {
  const std::size_t third = all.size() / 3;
  const double before = height_between(all, third, 2 * third);
  const double after = height_between(all, 2 * third, all.size());
  return after <= (1.0 + share) * before + megabytes;
}

}  // namespace

bool soak(const fs::path& assets, double seconds) {
  Person person(assets);
  std::printf("# %s\n# seconds  resident MB  in use MB\n",
              person.draws() ? "with drawing" : "without drawing: there is no OpenGL");
  std::vector<double> resident, in_use;
  const auto start = Clock::now();
  double passed = 0.0;
  do {
    person.round();
    const Memory memory = memory_now();
    resident.push_back(memory.resident_mb);
    in_use.push_back(memory.in_use_mb);
    passed = std::chrono::duration<double>(Clock::now() - start).count();
    std::printf("%9.0f %12.1f %10.2f\n", passed, memory.resident_mb, memory.in_use_mb);
    std::fflush(stdout);
  } while (passed < seconds);
  constexpr std::size_t enough = 6;
  if (resident.size() < enough) {
    std::printf("# %zu rounds: too few to tell\n", resident.size());
    return true;
  }
  const bool flat = is_flat(resident, 0.02, 4.0) && is_flat(in_use, 0.002, 0.5);
  std::printf("# %zu rounds: memory %s\n", resident.size(), flat ? "is flat" : "grows");
  return flat;
}

}  // namespace benchmark
