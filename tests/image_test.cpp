#include "app/render/image.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tests/support/catch.h"

namespace {

namespace fs = std::filesystem;

// A folder of its own that goes when the test is over.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("image test " + std::to_string(std::random_device{}()));
  Folder() { fs::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

app::Image two_by_three() {
  app::Image image{.width = 2, .height = 3, .rgba = {}};
  image.rgba.assign(24, 200);
  return image;
}

}  // namespace

TEST_CASE("a PNG holds the picture's size and leaves nothing beside it") {
  const Folder folder;
  const fs::path file = folder.path / "picture.png";
  REQUIRE_FALSE(app::save_png(file.string(), two_by_three()).has_value());
  const std::string bytes = bytes_of(file);
  REQUIRE(bytes.size() > 24);
  CHECK(bytes.substr(1, 3) == "PNG");
  CHECK(bytes.substr(16, 8) == std::string("\0\0\0\2\0\0\0\3", 8));
  CHECK(folder.files() == 1);
}

TEST_CASE("a picture replaces an older one, and a link stays a link") {
  const Folder folder;
  const fs::path file = folder.path / "picture.png";
  const fs::path link = folder.path / "link.png";
  std::ofstream(file) << "old";
  fs::create_symlink("picture.png", link);
  REQUIRE_FALSE(app::save_png(link.string(), two_by_three()).has_value());
  CHECK(fs::is_symlink(link));
  CHECK(bytes_of(file).substr(1, 3) == "PNG");
  CHECK(folder.files() == 2);
}

TEST_CASE("what cannot be written is said in a sentence") {
  const Folder folder;
  const auto no_folder = app::save_png((folder.path / "none" / "picture.png").string(), two_by_three());
  REQUIRE(no_folder.has_value());
  CHECK(no_folder->find("picture.png") != std::string::npos);
  CHECK(app::save_png(folder.path.string(), two_by_three()).has_value());
  app::Image broken = two_by_three();
  broken.rgba.pop_back();
  CHECK(app::save_png((folder.path / "broken.png").string(), broken).has_value());
  CHECK(folder.files() == 0);
}

TEST_CASE("a device is written to, not replaced") {
  if (fs::is_character_file("/dev/null")) {
    CHECK_FALSE(app::save_png("/dev/null", two_by_three()).has_value());
    CHECK(fs::is_character_file("/dev/null"));
  }
}
