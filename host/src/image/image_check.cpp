// SPDX-License-Identifier: Apache-2.0
#include "image_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <optional>

#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"

namespace horopter {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Numbers in a file, and the errors that name a place in it.
class Reader {
 public:
  Reader(Bytes bytes, const std::string& name, bool big_endian) : bytes_(bytes), name_(name), big_endian_(big_endian) {}

  std::size_t size() const { return bytes_.size(); }
  void need(std::size_t begin, std::size_t length, const char* what) const {
    if (begin > bytes_.size() || length > bytes_.size() - begin) truncated(what, begin, length);
  }
  std::uint8_t u8(std::size_t at) const {
    need(at, 1, "a byte");
    return bytes_[at];
  }
  std::uint32_t number(std::size_t at, int length) const {
    need(at, length, "a number");
    std::uint32_t value = 0;
    for (int i = 0; i < length; ++i) value = value << 8 | bytes_[at + (big_endian_ ? i : length - 1 - i)];
    return value;
  }
  std::uint32_t u16(std::size_t at) const { return number(at, 2); }
  std::uint32_t u32(std::size_t at) const { return number(at, 4); }
  Bytes bytes() const { return bytes_; }
  Bytes part(std::size_t begin, std::size_t length) const { return bytes_.subspan(begin, length); }

  [[noreturn]] void truncated(const char* what, std::size_t begin, std::size_t length) const {
    throw FileError(name_, fmt::format("byte {}", bytes_.size()), "the file is truncated",
                    fmt::format("{} of {} bytes at byte {}", what, length, begin));
  }
  [[noreturn]] void bad(std::size_t at, const std::string& found, const std::string& expected) const {
    throw FileError(name_, fmt::format("byte {}", at), found, expected);
  }
  /// Before anything is decoded: a small file may claim an image of gigabytes.
  void check_size(std::size_t at, std::uint64_t width, std::uint64_t height) const {
    constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
    if (width == 0 || height == 0 || width > kMostPixels || height > kMostPixels || width * height > kMostPixels) {
      bad(at, fmt::format("an image of {}x{} pixels", width, height), fmt::format("1 to {} pixels", kMostPixels));
    }
    size_ = {static_cast<int>(width), static_cast<int>(height)};
  }
  /// What check_size was last told.
  const std::optional<ImageSize>& image_size() const { return size_; }
  [[noreturn]] void bad_depth(std::size_t at, unsigned bits) const {
    bad(at, fmt::format("{} bits a sample", bits), "an 8-bit image, grey or colour");
  }

 private:
  Bytes bytes_;
  const std::string& name_;
  bool big_endian_;
  mutable std::optional<ImageSize> size_;
};

constexpr std::array<std::uint8_t, 3> kJpegBegin{0xFF, 0xD8, 0xFF};
constexpr std::array<std::uint8_t, 8> kPngBegin{0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};

/// Where an image begins, from a place on.
std::size_t find_image(Bytes bytes, std::size_t from, Bytes begin) {
  const auto found = std::ranges::search(bytes.subspan(from), begin);
  return found.empty() ? bytes.size() : static_cast<std::size_t>(found.begin() - bytes.begin());
}

/// One image, of which nothing more may follow: a decoder would show the first alone.
void check_alone(const Reader& file, std::size_t next) {
  if (next < file.size()) file.bad(next, "another image behind the first", "one image in a file");
}

/// Returns where it ends.
std::size_t check_one_jpeg(const Reader& file) {
  std::size_t at = 2;
  bool frame = false;
  bool scan = false;
  while (true) {
    if (at >= file.size()) {
      file.bad(file.size(), "the file is truncated: no end-of-image marker", "a complete JPEG");
    }
    if (file.u8(at) != 0xFF) file.bad(at, "no JPEG marker", "0xFF and a marker code");
    while (at < file.size() && file.u8(at) == 0xFF) ++at;
    if (at >= file.size()) {
      file.bad(file.size(), "the file is truncated: no end-of-image marker", "a complete JPEG");
    }
    const std::uint8_t marker = file.u8(at++);
    if (marker == 0xD9) break;
    if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) continue;
    const std::size_t length = file.u16(at);
    if (length < 2) file.bad(at, "a JPEG segment shorter than its length field", "at least 2 bytes");
    file.need(at, length, "a JPEG segment");
    const bool is_frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame) {
      frame = true;
      if (file.u8(at + 2) != 8) file.bad_depth(at + 2, file.u8(at + 2));
      file.check_size(at + 3, file.u16(at + 5), file.u16(at + 3));
    }
    at += length;
    if (marker != 0xDA) continue;
    scan = true;
    // Entropy-coded data: up to a marker that is neither a stuffed zero nor a restart.
    while (at + 1 < file.size() &&
           !(file.u8(at) == 0xFF && file.u8(at + 1) != 0x00 && !(file.u8(at + 1) >= 0xD0 && file.u8(at + 1) <= 0xD7) &&
             file.u8(at + 1) != 0xFF)) {
      ++at;
    }
    if (at + 1 >= file.size()) {
      file.bad(file.size(), "the file is truncated: no end-of-image marker", "a complete JPEG");
    }
  }
  if (!frame || !scan) file.bad(at, "the JPEG ends without an image", "a frame header and a scan");
  return at;
}

void check_jpeg(const Reader& file) { check_alone(file, find_image(file.bytes(), check_one_jpeg(file), kJpegBegin)); }

void check_png(const Reader& file, unsigned largest_bits) {
  std::size_t at = 8;
  bool header = false;
  bool data = false;
  while (true) {
    if (at + 12 > file.size()) {
      file.bad(file.size(), "the file is truncated: no IEND chunk", "a complete PNG");
    }
    const std::size_t length = file.u32(at);
    if (length > file.size() || at + 12 + length > file.size()) file.truncated("a PNG chunk", at, length + 12);
    const std::uint32_t type = file.u32(at + 4);
    if (crc32(file.part(at + 4, length + 4)) != file.u32(at + 8 + length)) {
      file.bad(at, "a PNG chunk with a wrong CRC", "undamaged data");
    }
    if (type == 0x49484452) {  // IHDR
      header = true;
      if (length != 13) file.bad(at, "a PNG header of a wrong length", "13 bytes");
      if (file.u8(at + 16) > largest_bits) file.bad_depth(at + 16, file.u8(at + 16));
      file.check_size(at + 8, file.u32(at + 8), file.u32(at + 12));
    }
    if (type == 0x6163544C) file.bad(at, "an animated PNG", "one image in a file");  // acTL
    data = data || type == 0x49444154;                                               // IDAT
    if (type == 0x49454E44) break;                                                   // IEND
    at += length + 12;
  }
  if (!header || !data) file.bad(at, "the PNG ends without an image", "IHDR and IDAT chunks");
  check_alone(file, find_image(file.bytes(), at + 12, kPngBegin));
}

void check_pnm(const Reader& file, unsigned largest_bits) {
  const char kind = static_cast<char>(file.u8(1));
  std::size_t at = 2;
  const auto space = [&] { return at < file.size() && std::isspace(file.u8(at)) != 0; };
  const auto number = [&](const char* what) -> std::optional<unsigned> {
    while (space() || (at < file.size() && file.u8(at) == '#')) {
      if (file.u8(at) == '#') {
        while (at < file.size() && file.u8(at) != '\n') ++at;
      } else {
        ++at;
      }
    }
    if (at >= file.size()) return std::nullopt;
    if (std::isdigit(file.u8(at)) == 0) file.bad(at, "no number", what);
    unsigned value = 0;
    while (at < file.size() && std::isdigit(file.u8(at)) != 0) {
      value = value * 10 + (file.u8(at++) - '0');
      if (value > 1'000'000) file.bad(at, "a number that is too large", what);
    }
    return value;
  };
  if (kind == '1' || kind == '4') file.bad(0, "a bilevel PBM", "an 8-bit image, grey or colour");
  std::array<unsigned, 3> header{};
  for (unsigned& value : header) {
    const auto read = number("width, height and largest value");
    if (!read) file.bad(file.size(), "the file is truncated", "a PNM header with width, height and largest value");
    value = *read;
  }
  const auto [width, height, largest] = header;
  file.check_size(0, width, height);
  const bool wide = largest_bits == 16 && largest == 65535;
  if (largest > 255 && !wide)
    file.bad(at, fmt::format("16-bit samples (largest value {})", largest), "an 8-bit image, grey or colour");
  if (largest != 255 && !wide) file.bad(at, fmt::format("largest value {}", largest), "255, an 8-bit image");
  const std::size_t samples = std::size_t{width} * height * (kind == '3' || kind == '6' ? 3 : 1);
  const std::size_t bytes = wide ? 2 : 1;
  if (kind == '5' || kind == '6') {
    file.need(at, 1, "a space before the pixels");
    file.need(at + 1, samples * bytes, "pixels");
    at += 1 + samples * bytes;
  } else {
    for (std::size_t i = 0; i < samples; ++i) {
      const auto value = number("a grey value");
      if (!value) file.truncated("grey values", at, samples);
      if (*value > largest) file.bad(at, fmt::format("grey value {}", *value), fmt::format("at most {}", largest));
    }
  }
  while (space()) ++at;
  check_alone(file, at);
}

void check_bmp(const Reader& file) {
  file.need(0, 30, "a BMP header");
  const std::size_t pixels = file.u32(10);
  const std::uint32_t header = file.u32(14);
  const bool core = header == 12;
  const std::int64_t width = core ? file.u16(18) : static_cast<std::int32_t>(file.u32(18));
  const std::int64_t height = core ? file.u16(20) : std::abs(std::int64_t{static_cast<std::int32_t>(file.u32(22))});
  const unsigned bits = file.u16(core ? 24 : 28);
  const std::uint32_t compression = core ? 0 : file.u32(30);
  if (width <= 0 || height == 0) file.bad(18, "an empty BMP", "positive width and height");
  file.check_size(18, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  if (bits == 16) file.bad(28, "a BMP with 16 bits a pixel", "an 8-bit image, grey or colour");
  const bool run_length = compression == 1 || compression == 2;
  const std::size_t length = run_length ? (file.size() > 38 ? file.u32(34) : 0)
                                        : static_cast<std::size_t>((width * bits + 31) / 32 * 4 * height);
  file.need(pixels, length, "pixels");
}

// Of tag 259. Other kinds have no check that decoders look at.
constexpr std::uint32_t kTiffPlain = 1, kTiffLzw = 5;

/// Whether the LZW data of a TIFF stand for so many bytes (TIFF 6.0, section 13), and each code for one or more. Decoders
/// stop quietly at the bytes that they need.
bool is_whole_lzw(Bytes data, std::uint64_t expected) {
  constexpr unsigned kClear = 256, kEnd = 257, kFirst = 258, kFewestBits = 9, kMostBits = 12;
  std::array<std::uint32_t, 1U << kMostBits> lengths{};
  std::fill_n(lengths.begin(), kClear, 1);
  std::uint64_t sum = 0;
  std::size_t at_bit = 0;
  unsigned next = kFirst, bits = kFewestBits;
  bool wider = false;      // since the last code
  std::uint32_t last = 0;  // none
  const auto code_of = [&](unsigned length) -> std::optional<unsigned> {
    if (at_bit + length > data.size() * 8) return std::nullopt;
    unsigned code = 0;
    for (std::size_t bit = at_bit; bit < at_bit + length; ++bit)
      code = code << 1 | (data[bit / 8] >> (7 - bit % 8) & 1U);
    return code;
  };
  while (true) {
    const auto code = code_of(bits);
    if (sum == expected) {  // some writers leave the end out, and older ones of libtiff do not widen it
      if (!code || *code == kEnd || (wider && code_of(bits - 1) == kEnd)) return true;
    }
    if (!code || *code == kEnd) return false;
    at_bit += bits;
    wider = false;
    if (*code == kClear) {
      next = kFirst;
      bits = kFewestBits;
      last = 0;
      continue;
    }
    if (last == 0 ? *code > kClear : *code > next || next == lengths.size()) return false;
    if (last != 0) {
      lengths[next++] = last + 1;
      wider = next + 1 == 1U << bits && bits < kMostBits;
      if (wider) ++bits;
    }
    last = lengths[*code];
    sum += last;
  }
}

void check_tiff(const Reader& file, std::uint8_t version) {
  if (version != 42) file.bad(2, "a BigTIFF", "a TIFF of version 42");
  const std::size_t directory = file.u32(4);
  file.need(directory, 2, "a TIFF directory");
  const unsigned entries = file.u16(directory);
  file.need(directory + 2, std::size_t{entries} * 12 + 4, "a TIFF directory");
  const std::size_t link = directory + 2 + std::size_t{entries} * 12;
  if (file.u32(link) != 0) file.bad(link, "another image behind the first", "one image in a file");

  struct Values {
    std::size_t at = 0;
    unsigned count = 0;
    int size = 0;
  };
  Values offsets;
  Values counts;
  std::uint32_t width = 0, height = 0, rows_per_strip = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t tile_width = 0, tile_height = 0, samples = 1, compression = kTiffPlain;
  bool planes = false, eight_bits = false;
  for (unsigned i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + std::size_t{i} * 12;
    const unsigned tag = file.u16(entry);
    const unsigned type = file.u16(entry + 2);
    const unsigned count = file.u32(entry + 4);
    const int size = type == 3 ? 2 : type == 4 ? 4 : 1;
    const bool inside = std::size_t{count} * size <= 4;
    const std::size_t at = inside ? entry + 8 : file.u32(entry + 8);
    if (tag == 258) {  // BitsPerSample
      eight_bits = count > 0;
      for (unsigned sample = 0; sample < count; ++sample) {
        if (const unsigned bits = file.u16(at + std::size_t{sample} * 2); bits != 8) file.bad_depth(at, bits);
      }
    }
    if (tag == 256) width = file.number(at, size);
    if (tag == 257) height = file.number(at, size);
    if (tag == 259) compression = file.number(at, size);
    if (tag == 266 && file.number(at, size) != 1) {  // decoders turn the bits of each byte
      file.bad(entry, fmt::format("a TIFF with FillOrder {}", file.number(at, size)), "1, the highest bit first");
    }
    if (tag == 274 && file.number(at, size) != 1) {  // decoders turn it, each in its own way
      file.bad(entry, fmt::format("a TIFF with orientation {}", file.number(at, size)),
               "orientation 1, the first pixel at the top left");
    }
    if (tag == 277) samples = file.number(at, size);
    if (tag == 278) rows_per_strip = file.number(at, size);
    if (tag == 284) planes = file.number(at, size) == 2;
    if (tag == 322) tile_width = file.number(at, size);
    if (tag == 323) tile_height = file.number(at, size);
    if (tag == 273 || tag == 324) offsets = {at, count, size};  // StripOffsets, TileOffsets
    if (tag == 279 || tag == 325) counts = {at, count, size};   // StripByteCounts, TileByteCounts
  }
  const bool tiles = tile_width != 0 || tile_height != 0;
  if (tiles) file.check_size(directory, tile_width, tile_height);
  file.check_size(directory, width, height);
  if (!eight_bits) file.bad_depth(directory, 1);
  if (offsets.count == 0 || offsets.count != counts.count) {
    file.bad(directory, "a TIFF without pixels", "strips or tiles with offsets and byte counts");
  }
  if (compression != kTiffPlain && compression != kTiffLzw) {
    file.bad(directory, fmt::format("a TIFF of compression {}", compression), "none or LZW (5), or PNG");
  }
  const std::uint32_t part_width = tiles ? tile_width : width;
  const std::uint32_t part_height = tiles ? tile_height : std::min(rows_per_strip, height);
  if (part_height == 0) file.bad(directory, "a TIFF with strips of no row", "one row or more");
  const std::uint32_t across = tiles ? (width + part_width - 1) / part_width : 1;
  const std::uint32_t down = (height + part_height - 1) / part_height;
  const std::uint64_t parts = std::uint64_t{across} * down;
  if (offsets.count != parts * (planes ? samples : 1)) {
    file.bad(directory, fmt::format("a TIFF with {} strips or tiles", offsets.count),
             "as many as its size and its samples need");
  }
  for (unsigned i = 0; i < offsets.count; ++i) {
    const std::size_t begin = file.number(offsets.at + std::size_t{i} * offsets.size, offsets.size);
    const std::size_t length = file.number(counts.at + std::size_t{i} * counts.size, counts.size);
    file.need(begin, length, "a TIFF strip");
    const std::uint64_t row = i % parts;  // tiles are always whole
    const std::uint64_t rows = tiles ? part_height : std::min<std::uint64_t>(part_height, height - row * part_height);
    const std::uint64_t pixels = rows * part_width * (planes ? 1 : samples);
    const bool whole = compression == kTiffLzw ? is_whole_lzw(file.part(begin, length), pixels) : length >= pixels;
    if (!whole) file.bad(begin, "a damaged TIFF strip or tile", fmt::format("{} bytes of pixels", pixels));
  }
}

Reader reader(Bytes bytes, ImageFormat format, const std::string& name) {
  const bool tiff = format == ImageFormat::tiff;
  return {bytes, name, tiff ? bytes[0] == 'M' : format != ImageFormat::bmp};
}

void check(const Reader& file, ImageFormat format, unsigned largest_bits) {
  switch (format) {
    case ImageFormat::jpeg:
      return check_jpeg(file);
    case ImageFormat::png:
      return check_png(file, largest_bits);
    case ImageFormat::pnm:
      return check_pnm(file, largest_bits);
    case ImageFormat::bmp:
      return check_bmp(file);
    case ImageFormat::tiff:
      return check_tiff(file, file.u8(file.u8(0) == 'M' ? 3 : 2));
    case ImageFormat::unknown:
      break;
  }
  // A file cut within its first bytes may have no recognisable start left.
  file.bad(0, file.size() < 16 ? "the file is truncated or not an image" : "not an image",
           "PNG, JPEG, PNM, BMP or TIFF");
}

}  // namespace

ImageFormat sniff_format(Bytes bytes) {
  const auto starts = [&](std::initializer_list<std::uint8_t> magic) {
    if (bytes.size() < magic.size()) return false;
    std::size_t i = 0;
    for (const std::uint8_t byte : magic) {
      if (bytes[i++] != byte) return false;
    }
    return true;
  };
  if (starts({0xFF, 0xD8})) return ImageFormat::jpeg;
  if (starts({0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A})) return ImageFormat::png;
  if (starts({'B', 'M'})) return ImageFormat::bmp;
  if (starts({'I', 'I', 42, 0}) || starts({'M', 'M', 0, 42}) || starts({'I', 'I', 43, 0}) ||
      starts({'M', 'M', 0, 43})) {
    return ImageFormat::tiff;
  }
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' && std::isspace(bytes[2]) != 0) {
    return ImageFormat::pnm;
  }
  return ImageFormat::unknown;
}

void check_structure(Bytes bytes, ImageFormat format, const std::string& name, unsigned largest_bits) {
  check(reader(bytes, format, name), format, largest_bits);
}

std::vector<Bytes> jpegs_in(Bytes bytes, const std::string& name) {
  if (sniff_format(bytes) != ImageFormat::jpeg) throw FileError(name, "", "no JPEG begins here", "a complete JPEG");
  std::vector<Bytes> images;
  while (!bytes.empty()) {
    const std::size_t end = check_one_jpeg(Reader(bytes, name, true));
    images.push_back(bytes.first(end));
    bytes = bytes.subspan(find_image(bytes, end, kJpegBegin));
  }
  return images;
}

std::optional<ImageSize> size_in_header(Bytes bytes) {
  const std::string name;
  const ImageFormat format = sniff_format(bytes);
  const Reader file = reader(bytes, format, name);
  try {
    check(file, format, 16);
  } catch (const FileError&) {  // of a file that is not whole here, or not good: whoever reads it says so
  }
  return file.image_size();
}

}  // namespace horopter
