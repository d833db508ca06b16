// Animations, read back: frames, delays, sizes, and that cancelling or failing leaves nothing.
#include "app/render/animation_file.h"

#include <cmath>
#include <numeric>

#include "app/actions/hosting.h"
#include "app/actions/picture_session.h"
#include "app/render/gif_palette.h"
#include "app/render/headless_gl.h"
#include "app/session/document.h"
#include "app/session/jobs.h"
#include "app/session/outbox.h"
#include "app/session/program.h"
#include "app/session/view.h"
#include "app/window/animation.h"
#include "tests/support/catch.h"
#include "tests/support/pictures.h"
#include "tests/support/session.h"

using namespace app;
using test_support::Folder;
using test_support::Frames;

namespace {

constexpr int width = 160, height = 120;

SaveAnimation wish_for(const std::filesystem::path& path, int frames = 5, bool panels = false) {
  return {path, {200, 600}, frames, 8.0, width, height, panels};
}

Image single(const Session& session, std::size_t position, bool panels = false, int w = width,
             int h = height) {
  const Folder folder;
  Session there = session;
  there.document->timeline.seek(position);
  REQUIRE(save_figure_headless(there, {folder.path() / "one.png", w, h, panels, false}) == std::nullopt);
  return test_support::read_png(test_support::read_text(folder.path() / "one.png"));
}

Image plain_picture(int w, int h, std::uint8_t level) {
  Image image{.width = w, .height = h, .rgba = {}};
  for (int i = 0; i < w * h; ++i) {
    for (const int c : {level + i % 7, int{level}, 40, 255})
      image.rgba.push_back(static_cast<std::uint8_t>(c));
  }
  return image;
}

// Without giflib there is nothing to read back.
bool can_write_gif() {
  const Folder folder;
  const auto opened = open_animation(folder.path() / "a.gif", {width, height, 1, 10.0});
  const auto* trouble = std::get_if<std::string>(&opened);
  if (trouble != nullptr) WARN("animated GIF is not tested: " << *trouble);
  return trouble == nullptr;
}

// A GL context for tests that step by themselves.
struct Studio {
  HeadlessGl gl = std::get<HeadlessGl>(HeadlessGl::open());
};

}  // namespace

TEST_CASE("frames are spread evenly, and the last one always shows the end") {
  CHECK(frames_in({0, 1000}, 120) == 120);
  CHECK(frames_in({0, 3}, 120) == 4);
  CHECK(frames_in({7, 7}, 120) == 1);
  CHECK(frames_in({0, 1000}, 0) == 1);
  CHECK(position_of_frame({5, 25}, 1, 0) == 25);
  const Stretch stretch{100, 1103};
  std::size_t before = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::size_t position = position_of_frame(stretch, 12, i);
    CHECK(std::abs(static_cast<double>(position) - (100.0 + 1003.0 * static_cast<double>(i) / 11.0)) <= 0.5);
    if (i > 0) CHECK(position > before);
    before = position;
  }
  CHECK(position_of_frame(stretch, 12, 0) == 100);
  CHECK(before == 1103);
}

TEST_CASE("an animated PNG has its frames, delays and size, and they equal pictures taken singly") {
  const Session session = test_support::finished_small_session();
  const Folder folder;
  const auto path = folder.path() / "run.png";
  REQUIRE(save_animation_headless(session, wish_for(path), false) == std::nullopt);
  CHECK(folder.files() == 1);
  const std::string bytes = test_support::read_text(path);
  const Frames frames = test_support::read_apng(bytes);
  REQUIRE(frames.pictures.size() == 5);
  CHECK(frames.plays == 0);
  for (const double seconds : frames.seconds) CHECK(seconds == Approx(1.0 / 8.0));
  for (const Image& picture : frames.pictures) {
    CHECK(picture.width == width);
    CHECK(picture.height == height);
  }
  CHECK(test_support::difference_of(frames.pictures.front(), single(session, 200)).most == 0);
  CHECK(test_support::difference_of(frames.pictures[2], single(session, 400)).most == 0);
  CHECK(test_support::difference_of(frames.pictures.back(), single(session, 600)).most == 0);
  CHECK(test_support::difference_of(frames.pictures.front(), frames.pictures.back()).most > 0);
  CHECK(frames.rectangle[1] < frames.rectangle[0]);  // only what changes
  // Any other program shows the first frame.
  CHECK(test_support::read_png(bytes).rgba == frames.pictures.front().rgba);

  REQUIRE(save_animation_headless(session, wish_for(folder.path() / "again.apng"), false) == std::nullopt);
  CHECK(test_support::read_text(folder.path() / "again.apng") == bytes);
}

TEST_CASE("an animation with panels equals pictures with panels") {
  Session session = test_support::finished_small_session();
  session.program->preferences.theme = ThemeKind::light;
  const Folder folder;
  SaveAnimation wish = wish_for(folder.path() / "run.png", 3, true);
  wish.width = 640;
  wish.height = 400;
  REQUIRE(save_animation_headless(session, wish, false) == std::nullopt);
  const Frames frames = test_support::read_apng(test_support::read_text(wish.path));
  REQUIRE(frames.pictures.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    const Image one = single(session, position_of_frame(wish.stretch, 3, i), true, 640, 400);
    CHECK(test_support::difference_of(frames.pictures[i], one).most == 0);
  }
}

TEST_CASE("an animated GIF has its frames and delays, in colours close to the true ones") {
  if (!can_write_gif()) return;
  const Session session = test_support::finished_small_session();
  const Folder folder;
  const auto path = folder.path() / "run.gif";
  REQUIRE(save_animation_headless(session, wish_for(path), false) == std::nullopt);
  const std::string bytes = test_support::read_text(path);
  CHECK(bytes.substr(0, 6) == "GIF89a");
  CHECK(test_support::contains(bytes, "NETSCAPE2.0"));
  CHECK(bytes.back() == ';');
  const Frames frames = test_support::read_gif(bytes);
  REQUIRE(frames.pictures.size() == 5);
  const double all = std::accumulate(frames.seconds.begin(), frames.seconds.end(), 0.0);
  CHECK(all == Approx(5.0 / 8.0).margin(0.006));  // 0.125 s are no whole hundredths
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(frames.seconds[i] == Approx(1.0 / 8.0).margin(0.0051));
    const auto difference =
        test_support::difference_of(frames.pictures[i], single(session, position_of_frame({200, 600}, 5, i)));
    CHECK(difference.mean < 1.0);
    CHECK(difference.most < 48);
  }
  REQUIRE(save_animation_headless(session, wish_for(folder.path() / "again.gif"), false) == std::nullopt);
  CHECK(test_support::read_text(folder.path() / "again.gif") == bytes);
}

TEST_CASE("a folder gets numbered pictures, and what else is in it stays") {
  const Session session = test_support::finished_small_session();
  const Folder folder;
  const auto path = folder.path() / "frames";
  std::filesystem::create_directory(path);
  test_support::write_text(path / "notes.txt", "mine");
  REQUIRE(save_animation_headless(session, wish_for(path, 3), false) == std::nullopt);
  CHECK(folder.files() == 1);
  CHECK(test_support::read_text(path / "notes.txt") == "mine");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto name = "frame_000" + std::to_string(i + 1) + ".png";
    const Image picture = test_support::read_png(test_support::read_text(path / name));
    CHECK(picture.rgba == single(session, position_of_frame({200, 600}, 3, i)).rgba);
  }
  CHECK_FALSE(std::filesystem::exists(path / "frame_0004.png"));
  // A new folder is made.
  REQUIRE(save_animation_headless(session, wish_for(folder.path() / "more/", 2), false) == std::nullopt);
  CHECK(std::filesystem::exists(folder.path() / "more" / "frame_0002.png"));
}

TEST_CASE("an animation that is cancelled leaves nothing, and the old file as it was") {
  const Studio studio;
  for (const char* name : {"a.gif", "a.png", "frames"}) {
    CAPTURE(name);
    if (name == std::string("a.gif") && !can_write_gif()) continue;
    const Folder folder;
    Session session = test_support::finished_small_session();
    const auto path = folder.path() / name;
    if (path.has_extension()) test_support::write_text(path, "old");
    const std::size_t before = folder.files();
    apply(session, wish_for(path, 9));
    REQUIRE(session.jobs->animation != nullptr);
    std::unique_ptr<AnimationMaker> maker;
    for (int i = 0; i < 3; ++i) tend_animation(session, maker);
    REQUIRE(session.jobs->animation != nullptr);
    CHECK(session.jobs->animation->done == 3);
    CHECK(folder.files() == before + 1);  // half of it, aside
    apply(session, CancelAnimation{});
    tend_animation(session, maker);
    CHECK(folder.files() == before);
    if (path.has_extension()) CHECK(test_support::read_text(path) == "old");
    CHECK(session.outbox->notices.empty());
    // And another one may be made at once.
    apply(session, wish_for(path, 2));
    for (int i = 0; i < 2; ++i) tend_animation(session, maker);
    CHECK(session.jobs->animation == nullptr);
    REQUIRE(session.outbox->notices.size() == 1);
    CHECK(session.outbox->notices[0].kind == Notice::Kind::info);
  }
}

TEST_CASE("while an animation is made one may look at something else, and the window is drawn as ever") {
  const Studio studio;
  const Folder folder;
  Session session = test_support::finished_small_session();
  FrameDrawer drawer(session.program->assets);
  const FrameShape shape{640, 400, 640, 400};
  for (int i = 0; i < 4; ++i) drawer.draw(session, shape, {});
  const Image before = drawer.target().read();
  const Session asked = session;
  apply(session, wish_for(folder.path() / "a.png", 4));
  apply(session, wish_for(folder.path() / "b.png", 4));
  REQUIRE(session.outbox->notices.size() == 1);  // one at a time
  CHECK(test_support::is_one_sentence(session.outbox->notices[0].text));
  session.outbox->notices.clear();
  std::unique_ptr<AnimationMaker> maker;
  tend_animation(session, maker);
  apply(session, ToFirst{});
  apply(session, Orbit{1.0, 0.2});
  tend_animation(session, maker);
  drawer.draw(session, shape, {});
  CHECK_FALSE(drawer.busy());
  while (session.jobs->animation) tend_animation(session, maker);
  const Frames frames = test_support::read_apng(test_support::read_text(folder.path() / "a.png"));
  REQUIRE(frames.pictures.size() == 4);
  CHECK(test_support::difference_of(frames.pictures.back(), single(asked, 600)).most == 0);
}

TEST_CASE("a picture is taken beside the window's own frame") {
  const Studio studio;
  const Folder folder;
  Session session = test_support::finished_small_session();
  FrameDrawer drawer(session.program->assets);
  const FrameShape shape{640, 400, 640, 400};
  for (int i = 0; i < 4; ++i) drawer.draw(session, shape, {});
  const Image before = drawer.target().read();
  apply(session, SavePicture{folder.path() / "big.png", 1000, 300, false, true});
  REQUIRE(session.outbox->pictures.size() == 1);
  save_figures(session, take_outgoing(session).pictures);
  CHECK(session.outbox->pictures.empty());
  REQUIRE(session.outbox->notices.size() == 1);
  CHECK(session.outbox->notices[0].kind == Notice::Kind::info);
  const Image big = test_support::read_png(test_support::read_text(folder.path() / "big.png"));
  CHECK(big.width == 1000);
  CHECK(big.height == 300);
  session.outbox->notices.clear();
  drawer.draw(session, shape, {});
  CHECK(drawer.target().read().rgba == before.rgba);
}

TEST_CASE("where nothing can be written an animation says so before it begins, and leaves what is there") {
  const Studio studio;
  const Folder folder;
  test_support::write_text(folder.path() / "file", "mine");
  std::filesystem::create_directory(folder.path() / "dir.gif");
  for (const auto& path :
       {folder.path() / "none" / "a.gif", folder.path() / "none" / "a.png", folder.path() / "none" / "frames",
        folder.path() / "file", folder.path() / "dir.gif"}) {
    CAPTURE(path);
    Session session = test_support::finished_small_session();
    apply(session, wish_for(path));
    REQUIRE(session.jobs->animation != nullptr);
    std::unique_ptr<AnimationMaker> maker;
    tend_animation(session, maker);
    CHECK(session.jobs->animation == nullptr);
    REQUIRE(session.outbox->notices.size() == 1);
    CHECK(session.outbox->notices[0].kind == Notice::Kind::error);
    CHECK(test_support::is_one_sentence(session.outbox->notices[0].text));
    CHECK(test_support::contains(session.outbox->notices[0].text, path.string()));
  }
  CHECK(test_support::read_text(folder.path() / "file") == "mine");
  CHECK(folder.files() == 2);
}

TEST_CASE("wishes for figures that cannot be are refused in a sentence") {
  Session session = test_support::finished_small_session();
  const SaveAnimation good = wish_for("a.gif");
  const auto animation = [&](auto change) {
    SaveAnimation wish = good;
    change(wish);
    return fault_of(wish);
  };
  CHECK_FALSE(fault_of(good).has_value());
  for (const auto& fault :
       {animation([](auto& w) { w.path = "a.mp4"; }), animation([](auto& w) { w.path = ""; }),
        animation([](auto& w) { w.frames = 0; }), animation([](auto& w) { w.frames = 10000; }),
        animation([](auto& w) { w.frames_per_second = 0.0; }),
        animation([](auto& w) { w.frames_per_second = std::nan(""); }),
        animation([](auto& w) { w.width = 63; }), animation([](auto& w) { w.height = 16385; }),
        animation([](auto& w) {
          w.stretch = {700, 200};
        })}) {
    REQUIRE(fault.has_value());
    CHECK(test_support::is_one_sentence(*fault));
  }
  for (const SavePicture& wish :
       {SavePicture{"a.jpg"}, SavePicture{"a.png", 10, 10}, SavePicture{"a.png", 100, 100, true, true}}) {
    const auto fault = fault_of(wish);
    REQUIRE(fault.has_value());
    CHECK(test_support::is_one_sentence(*fault));
    const std::size_t notices = session.outbox->notices.size();
    apply(session, wish);
    CHECK(session.outbox->pictures.empty());
    CHECK(session.outbox->notices.size() == notices + 1);
  }
  CHECK(animation_kind_of("a.GIF") == AnimationKind::gif);
  CHECK(animation_kind_of("a.apng") == AnimationKind::apng);
  CHECK(animation_kind_of("frames") == AnimationKind::folder);
}

TEST_CASE("the view of a narrower picture keeps all that was seen") {
  Session session = test_support::small_session();
  session.view->aspect = 1.6;
  const double fov = session.view->gaze.camera.field_of_view;
  fit_view(session, 2.4);
  CHECK(session.view->gaze.camera.field_of_view == fov);
  CHECK(session.view->aspect == 2.4);
  fit_view(session, 1.2);
  CHECK(std::tan(0.5 * session.view->gaze.camera.field_of_view) * 1.2 == Approx(std::tan(0.5 * fov) * 2.4));
}

TEST_CASE("a palette keeps flat colours exactly, and at most 255 of many") {
  const Image few = plain_picture(16, 16, 90);
  const PalettedImage exact = GifPalette().next(few, nullptr);
  CHECK(exact.colours.size() == 7);
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    const PaletteColour colour = exact.colours.at(exact.pixels[i]);
    CHECK(colour == PaletteColour{few.rgba[4 * i], few.rgba[4 * i + 1], few.rgba[4 * i + 2]});
  }
  Image many{.width = 200, .height = 200, .rgba = {}};
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const bool flat = y < 20;
      for (const int c : {flat ? 24 : x, flat ? 27 : y, flat ? 33 : (x + y) / 2, 255})
        many.rgba.push_back(static_cast<std::uint8_t>(c));
    }
  }
  const PalettedImage quantised = GifPalette().next(many, nullptr);
  CHECK(quantised.colours.size() <= 255);
  CHECK(quantised.colours.size() > 200);
  CHECK(quantised.colours.at(quantised.pixels[0]) == PaletteColour{24, 27, 33});
  for (std::size_t i = 0; i < quantised.pixels.size(); ++i) {
    const PaletteColour colour = quantised.colours.at(quantised.pixels[i]);
    const int far =
        std::max({std::abs(colour.r - many.rgba[4 * i]), std::abs(colour.g - many.rgba[4 * i + 1]),
                  std::abs(colour.b - many.rgba[4 * i + 2])});
    if (far > 24) FAIL_CHECK("a colour is far off: " << far);
  }
  Image changed = few;
  changed.rgba[4 * 5] = 1;
  const PalettedImage one = GifPalette().next(changed, &few);
  CHECK(std::count(one.pixels.begin(), one.pixels.end(), unchanged_index) == 255);
  CHECK(one.pixels[5] != unchanged_index);
}

TEST_CASE("a colour that comes back in an animation is shown as it was") {
  Image first{.width = 64, .height = 64, .rgba = {}};
  for (int i = 0; i < 64 * 64; ++i) {
    for (const int c : {i / 64 * 4, i % 64 * 4, i / 32, 255})
      first.rgba.push_back(static_cast<std::uint8_t>(c));
  }
  Image covered = first;
  for (std::size_t i = 0; i < 4 * 640; i += 4) covered.rgba[i] = covered.rgba[i + 1] = 255;
  GifPalette palette;
  const PalettedImage a = palette.next(first, nullptr);
  palette.next(covered, &first);
  const PalettedImage b = palette.next(first, &covered);
  for (std::size_t i = 0; i < 640; ++i) {
    REQUIRE(b.pixels[i] != unchanged_index);
    CHECK(b.colours.at(b.pixels[i]) == a.colours.at(a.pixels[i]));
  }
}

TEST_CASE("what changes between two pictures is found exactly") {
  const Image before = plain_picture(20, 10, 50);
  Image now = before;
  const auto same = changed_patch(before, now);
  CHECK(same.width == 1);
  CHECK(same.height == 1);
  now.rgba[4 * (3 * 20 + 7)] = 0;
  now.rgba[4 * (6 * 20 + 4) + 1] = 0;
  const PixelPatch patch = changed_patch(before, now);
  CHECK(patch.x == 4);
  CHECK(patch.y == 3);
  CHECK(patch.width == 4);
  CHECK(patch.height == 4);
  const Image part = cut_out(now, patch);
  CHECK(part.rgba.size() == 4 * 16);
  CHECK(part.rgba[4 * 3] == 0);
}
