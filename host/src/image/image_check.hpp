// SPDX-License-Identifier: Apache-2.0
// Structure of image files: complete or not, and how many bits a sample. Decoders show what is left of a truncated
// file; a monitor must not.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace horopter {

enum class ImageFormat { jpeg, png, pnm, bmp, tiff, unknown };

ImageFormat sniff_format(std::span<const std::uint8_t> bytes);

struct ImageSize {
  int width = 0, height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// The size that the begin of a file tells; nothing where it tells none.
std::optional<ImageSize> size_in_header(std::span<const std::uint8_t> bytes);

/// Throws FileError, unless the file is complete and holds one image, of samples of 8 bits (or fewer, for palettes); `largest_bits`
/// 16 allows PNG and PNM of 16 bits too.
void check_structure(std::span<const std::uint8_t> bytes, ImageFormat format, const std::string& name,
                     unsigned largest_bits = 8);

/// The JPEG images, one behind the other, each complete. Throws FileError where one is not, or where there is none.
std::vector<std::span<const std::uint8_t>> jpegs_in(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace horopter
