// SPDX-License-Identifier: Apache-2.0
// 8-bit grey images, read from files that are checked before a decoder sees them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace horopter {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< row by row, no padding

  Image() = default;
  Image(int columns, int rows, std::uint8_t value = 0)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * rows, value) {}
  std::uint8_t& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  std::uint8_t at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
  std::span<const std::uint8_t> row(int y) const {
    return std::span(pixels).subspan(static_cast<std::size_t>(y) * width, width);
  }
  bool empty() const { return pixels.empty(); }
  friend bool operator==(const Image&, const Image&) = default;
};

/// Reads PNG, JPEG, PNM (P2, P3, P5, P6), BMP or TIFF with 8 bits a sample; colour becomes grey by Rec. 601 luma.
/// Pixels stay where the sensor had them: orientation tags are ignored, and a TIFF that is to be turned is refused. Throws
/// FileError for a file that is missing, empty, truncated, of another depth, not an image or more than one, even when a
/// decoder would still show it; and for a damaged one, where its format tells: PNG always, JPEG and LZW in TIFF nearly
/// always, but not all damage of a few bytes; plain TIFF, PNM and BMP never.
Image load_image(const std::filesystem::path& path);
/// The same for bytes in memory; `name` stands for the file in messages.
Image decode_image(std::span<const std::uint8_t> bytes, const std::string& name);

/// What a video or a stream holds of one moment as JPEG: an image, or its two fields. Throws FileError where any of it
/// is missing or damaged: decoders of streams make that up.
void check_jpeg_packet(std::span<const std::uint8_t> bytes, const std::string& name);

/// One field of a progressive image: rows parity, parity + 2, …
Image field_of(const Image& image, int parity);

}  // namespace horopter
