// Animated PNG: an ordinary PNG whose first picture is followed by others, each only as large as what
// changes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/files.h"
#include "app/render/animation_file.h"

namespace app {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> png_signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

constexpr std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1U) : c >> 1U;
    table[n] = c;
  }
  return table;
}
constexpr std::array<std::uint32_t, 256> crc_table = make_crc_table();

std::uint32_t crc_of(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const std::uint8_t byte : bytes) crc = crc_table[(crc ^ byte) & 0xffU] ^ (crc >> 8U);
  return ~crc;
}

void append_u16(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(value));
}
void append_u32(Bytes& bytes, std::uint32_t value) {
  append_u16(bytes, value >> 16U);
  append_u16(bytes, value & 0xffffU);
}
std::uint32_t u32_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) << 24U | static_cast<std::uint32_t>(bytes[at + 1]) << 16U |
         static_cast<std::uint32_t>(bytes[at + 2]) << 8U | bytes[at + 3];
}

// Every chunk of one kind, joined. Requires a PNG.
Bytes chunks_of(std::span<const std::uint8_t> png, std::string_view kind) {
  Bytes data;
  for (std::size_t at = png_signature.size(); at + 12 <= png.size();) {
    const std::size_t size = u32_at(png, at);
    if (std::equal(kind.begin(), kind.end(), png.begin() + static_cast<std::ptrdiff_t>(at + 4))) {
      const auto part = png.subspan(at + 8, size);
      data.insert(data.end(), part.begin(), part.end());
    }
    at += 12 + size;
  }
  return data;
}

class ApngFile : public AnimationFile {
 public:
  ApngFile(AsideFile file, const AnimationShape& shape) : file_(std::move(file)), shape_(shape) {}

  std::optional<std::string> add(const Image& image) override {
    const bool first = before_.rgba.empty();
    const PixelPatch patch =
        first ? PixelPatch{0, 0, image.width, image.height} : changed_patch(before_, image);
    const Bytes png = png_bytes(cut_out(image, patch));
    if (png.empty()) return "a picture of the animation is too large for a PNG file; make it smaller.";
    if (first) begin(png);
    write_control(patch);
    Bytes data = chunks_of(png, "IDAT");
    if (first) {
      write_chunk("IDAT", data);
    } else {
      Bytes numbered;
      append_u32(numbered, sequence_++);
      numbered.insert(numbered.end(), data.begin(), data.end());
      write_chunk("fdAT", numbered);
    }
    before_ = image;
    return good_ ? std::nullopt : file_.finish();
  }

  std::optional<std::string> finish() override {
    write_chunk("IEND", {});
    return file_.finish();
  }

 private:
  void begin(const Bytes& png) {
    good_ = file_.write(png_signature) && good_;
    write_chunk("IHDR", chunks_of(png, "IHDR"));
    Bytes control;
    append_u32(control, static_cast<std::uint32_t>(shape_.frames));
    append_u32(control, 0);  // over and over
    write_chunk("acTL", control);
  }

  void write_control(const PixelPatch& patch) {
    Bytes control;
    append_u32(control, sequence_++);
    for (const int value : {patch.width, patch.height, patch.x, patch.y})
      append_u32(control, static_cast<std::uint32_t>(value));
    append_u16(control, 100);  // seconds a picture, as a fraction
    append_u16(control, static_cast<std::uint32_t>(std::lround(100.0 * shape_.frames_per_second)));
    control.push_back(0);  // it stays
    control.push_back(0);  // and takes the place of what was there
    write_chunk("fcTL", control);
  }

  void write_chunk(std::string_view kind, const Bytes& data) {
    Bytes chunk;
    append_u32(chunk, static_cast<std::uint32_t>(data.size()));
    chunk.insert(chunk.end(), kind.begin(), kind.end());
    chunk.insert(chunk.end(), data.begin(), data.end());
    append_u32(chunk, crc_of(std::span(chunk).subspan(4)));
    good_ = file_.write(chunk) && good_;
  }

  AsideFile file_;
  AnimationShape shape_;
  Image before_;
  std::uint32_t sequence_ = 0;
  bool good_ = true;
};

}  // namespace

OpenedAnimation open_apng(const std::filesystem::path& path, const AnimationShape& shape) {
  auto file = AsideFile::open(path);
  if (auto* error = std::get_if<std::string>(&file)) return std::move(*error);
  return std::make_unique<ApngFile>(std::move(std::get<AsideFile>(file)), shape);
}

}  // namespace app
