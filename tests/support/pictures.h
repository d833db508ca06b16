// Reads pictures back with a decoder that is not ours: PNG, animated PNG (its frames by hand), GIF.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/render/image.h"
#include "tests/support/catch.h"

// The system's library may hold the same names.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace test_support {

struct Frames {
  std::vector<app::Image> pictures;    // each whole
  std::vector<double> seconds;         // of each
  std::vector<std::size_t> rectangle;  // pixels that each brought along
  int plays = -1;                      // 0: over and over
};

inline app::Image read_png(const std::string& bytes) {
  app::Image image;
  int channels = 0;
  unsigned char* data =
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()),
                            static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 4);
  REQUIRE(data != nullptr);
  image.rgba.assign(
      data, data + 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  stbi_image_free(data);
  return image;
}

struct PngChunk {
  std::string kind, data;
};

inline std::uint32_t big_endian(const std::string& bytes, std::size_t at, std::size_t count = 4) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

// The slow way, from the definition.
inline std::uint32_t png_crc(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xedb88320U : crc >> 1U;
  }
  return ~crc;
}

inline std::vector<PngChunk> png_chunks(const std::string& bytes) {
  REQUIRE(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  std::vector<PngChunk> chunks;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t size = big_endian(bytes, at);
    REQUIRE(at + 12 + size <= bytes.size());
    CHECK(png_crc(bytes.substr(at + 4, 4 + size)) == big_endian(bytes, at + 8 + size));
    chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, size)});
    at += 12 + size;
  }
  REQUIRE(chunks.back().kind == "IEND");
  return chunks;
}

inline std::string as_bytes(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> static_cast<unsigned>(shift));
  return bytes;
}

inline std::string as_chunk(const PngChunk& chunk) {
  return as_bytes(static_cast<std::uint32_t>(chunk.data.size())) + chunk.kind + chunk.data +
         as_bytes(png_crc(chunk.kind + chunk.data));
}

// Each frame laid over the one before, as the standard says for frames that stay.
inline Frames read_apng(const std::string& bytes) {
  Frames frames;
  const std::vector<PngChunk> chunks = png_chunks(bytes);
  const std::string head = chunks.at(0).data;
  app::Image canvas;
  std::string control;
  std::uint32_t sequence = 0, promised = 0;
  for (const PngChunk& chunk : chunks) {
    if (chunk.kind == "acTL") {
      promised = big_endian(chunk.data, 0);
      frames.plays = static_cast<int>(big_endian(chunk.data, 4));
    }
    if (chunk.kind == "fcTL" || chunk.kind == "fdAT") CHECK(big_endian(chunk.data, 0) == sequence++);
    if (chunk.kind == "fcTL") control = chunk.data;
    if (chunk.kind != "IDAT" && chunk.kind != "fdAT") continue;
    const std::string pixels = chunk.kind == "IDAT" ? chunk.data : chunk.data.substr(4);
    const std::string part_head = control.substr(4, 8) + head.substr(8);
    const app::Image part = read_png(bytes.substr(0, 8) + as_chunk({"IHDR", part_head}) +
                                     as_chunk({"IDAT", pixels}) + as_chunk({"IEND", ""}));
    if (canvas.rgba.empty()) {
      canvas = part;
      CHECK(part.width == static_cast<int>(big_endian(head, 0)));
    }
    const auto x0 = static_cast<int>(big_endian(control, 12)), y0 = static_cast<int>(big_endian(control, 16));
    for (int y = 0; y < part.height; ++y) {
      for (int x = 0; x < 4 * part.width; ++x)
        canvas.rgba.at(static_cast<std::size_t>(4 * ((y0 + y) * canvas.width + x0) + x)) =
            part.rgba.at(static_cast<std::size_t>(4 * y * part.width + x));
    }
    frames.pictures.push_back(canvas);
    frames.rectangle.push_back(part.rgba.size() / 4);
    frames.seconds.push_back(static_cast<double>(big_endian(control, 20, 2)) / big_endian(control, 22, 2));
  }
  CHECK(promised == frames.pictures.size());
  return frames;
}

inline Frames read_gif(const std::string& bytes) {
  Frames frames;
  int* delays = nullptr;
  int width = 0, height = 0, count = 0, channels = 0;
  unsigned char* data = stbi_load_gif_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()),
                                                  static_cast<int>(bytes.size()), &delays, &width, &height,
                                                  &count, &channels, 4);
  REQUIRE(data != nullptr);
  const std::size_t size = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    frames.pictures.push_back({width, height, {data + i * size, data + (i + 1) * size}});
    frames.seconds.push_back(delays[i] / 1000.0);
  }
  stbi_image_free(data);
  stbi_image_free(delays);
  return frames;
}

// The farthest that a channel of a pixel is from the other's, and how far they are in the mean.
struct Difference {
  int most = 0;
  double mean = 0.0;
};
inline Difference difference_of(const app::Image& a, const app::Image& b) {
  REQUIRE(a.rgba.size() == b.rgba.size());
  Difference difference;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int far = std::abs(int{a.rgba[i]} - int{b.rgba[i]});
    difference.most = std::max(difference.most, far);
    difference.mean += far;
  }
  difference.mean /= static_cast<double>(std::max<std::size_t>(1, a.rgba.size()));
  return difference;
}

}  // namespace test_support
