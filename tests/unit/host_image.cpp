// SPDX-License-Identifier: Apache-2.0
// Images: what is read, and what is refused.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <random>
#include <span>
#include <tuple>

#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"
#include "horopter/image/frames.hpp"
#include "horopter/image/image.hpp"
#include "horopter/image/output.hpp"
#include "host_temporary.hpp"
#include "shared_data.hpp"
#include "video_hole.hpp"

namespace horopter {
namespace {

cv::Mat textured(int type = CV_8UC3, cv::Size size = {64, 48}) {
  cv::Mat image(size, type);
  cv::theRNG().state = 7;
  cv::randu(image, 0, 256);
  cv::GaussianBlur(image, image, {5, 5}, 1.5);
  return image;
}

std::vector<std::uint8_t> encoded(const std::string& extension, const cv::Mat& image,
                                  const std::vector<int>& parameters = {}) {
  std::vector<std::uint8_t> bytes;
  REQUIRE(cv::imencode(extension, image, bytes, parameters));
  return bytes;
}

std::string error_of(const std::filesystem::path& path) {
  try {
    load_image(path);
  } catch (const FileError& error) {
    CHECK(status_of(error) == ExitStatus::bad_file);
    CHECK(std::string(error.what()).starts_with(path.string() + ": "));
    CHECK_THAT(error.what(), Catch::Contains("expected"));
    return error.what();
  }
  FAIL("no error for " << path);
  return {};
}

/// How many of 40 copies `read` refuses. In each of them 1000 random bytes lie over a part of those from `begin` to `end`;
/// none of them is 0xFF, which begins a marker of JPEG.
template <class Read>
int refused_of_40(const std::vector<std::uint8_t>& whole, std::size_t begin, std::size_t end, const Read& read) {
  constexpr std::size_t kOverwritten = 1000;
  std::mt19937 random(7);
  int refused = 0;
  for (int trial = 0; trial < 40; ++trial) {
    auto bytes = whole;
    const std::size_t at = begin + random() % (end - begin - kOverwritten);
    for (std::size_t i = at; i < at + kOverwritten; ++i) bytes[i] = static_cast<std::uint8_t>(random() % 0xFF);
    try {
      read(bytes);
    } catch (const FileError&) {
      ++refused;
    }
  }
  return refused;
}

/// Where the directory of a TIFF, with the lowest byte first, has this tag.
std::size_t tiff_entry(const std::vector<std::uint8_t>& bytes, unsigned tag) {
  const auto number = [&](std::size_t at, int length) {
    std::size_t value = 0;
    for (int i = length; i-- > 0;) value = value << 8 | bytes.at(at + static_cast<std::size_t>(i));
    return value;
  };
  const std::size_t directory = number(4, 4), entries = number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    if (const std::size_t entry = directory + 2 + 12 * i; number(entry, 2) == tag) return entry;
  }
  FAIL("no tag " << tag);
  return 0;
}

/// A TIFF of one row in LZW: grey values 0, 1, … with a code of 9 bits for each, and an end of so many bits, or none.
std::vector<std::uint8_t> lzw_tiff(unsigned width, unsigned codes, unsigned end_bits, unsigned fill_order = 1) {
  constexpr unsigned kClear = 256, kEnd = 257, kBits = 9;
  std::vector<bool> bits;
  const auto add_code = [&](unsigned code, unsigned length) {
    for (unsigned i = length; i-- > 0;) bits.push_back((code >> i & 1U) != 0);
  };
  add_code(kClear, kBits);
  for (unsigned code = 0; code < codes; ++code) add_code(code, kBits);
  if (end_bits != 0) add_code(kEnd, end_bits);
  std::vector<std::uint8_t> strip((bits.size() + 7) / 8 + (end_bits != 0 ? 2 : 0));  // a writer may fill up with zeros
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i]) strip[i / 8] |= static_cast<std::uint8_t>(0x80U >> i % 8);
  }
  std::vector<std::uint8_t> bytes{'I', 'I', 42, 0};
  const auto add = [&](std::size_t value, int length) {
    for (int i = 0; i < length; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  };
  const std::vector<std::pair<unsigned, std::size_t>> tags{{256, width}, {257, 1},           {258, 8}, {259, 5},
                                                           {262, 1},     {266, fill_order},  {273, 8}, {277, 1},
                                                           {278, 1},     {279, strip.size()}};
  add(8 + strip.size(), 4);
  bytes.insert(bytes.end(), strip.begin(), strip.end());
  add(tags.size(), 2);
  for (const auto& [tag, value] : tags) {
    add(tag, 2);
    add(4, 2);  // of type LONG
    add(1, 4);
    add(value, 4);
  }
  add(0, 4);
  return bytes;
}

}  // namespace

TEST_CASE("Images of every format become Rec. 601 luma") {
  const TemporaryDirectory directory;
  const cv::Mat colour = textured();
  cv::Mat grey;
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  const std::string extension = GENERATE(".png", ".ppm", ".bmp", ".tiff", ".jpg");
  CAPTURE(extension);
  const Image image = load_image(directory.write("image" + extension, encoded(extension, colour)));
  REQUIRE(image.width == 64);
  REQUIRE(image.height == 48);
  double sum = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double expected = 0.299 * colour.at<cv::Vec3b>(y, x)[2] + 0.587 * colour.at<cv::Vec3b>(y, x)[1] +
                              0.114 * colour.at<cv::Vec3b>(y, x)[0];
      sum += std::abs(image.at(x, y) - expected);
      if (extension != ".jpg") REQUIRE(std::abs(image.at(x, y) - expected) <= 0.51);
    }
  }
  CHECK(sum / (64 * 48) < 2.0);  // JPEG loses a little
}

TEST_CASE("Grey, alpha and palettes are read too") {
  const TemporaryDirectory directory;
  const cv::Mat grey = textured(CV_8UC1);
  for (const std::string extension : {".png", ".pgm", ".bmp", ".tiff"}) {
    const Image image = load_image(directory.write("grey" + extension, encoded(extension, grey)));
    CHECK(std::equal(image.pixels.begin(), image.pixels.end(), grey.datastart));
  }
  cv::Mat alpha;
  cv::cvtColor(grey, alpha, cv::COLOR_GRAY2BGRA);
  const Image image = load_image(directory.write("alpha.png", encoded(".png", alpha)));
  CHECK(image.at(5, 7) == grey.at<std::uint8_t>(7, 5));
  CHECK(load_image(directory.write("plain.pgm", "P2 # text\n2 1\n255\n 7 200\n")).pixels ==
        std::vector<std::uint8_t>{7, 200});
}

TEST_CASE("A truncated image is detected wherever it is cut, whatever the decoder says") {
  const TemporaryDirectory directory;
  const std::string extension = GENERATE(".jpg", ".progressive.jpg", ".png", ".pgm", ".ppm", ".bmp", ".tiff");
  CAPTURE(extension);
  const cv::Mat source = textured(extension == ".pgm" ? CV_8UC1 : CV_8UC3);
  std::vector<int> parameters;
  if (extension == ".progressive.jpg") parameters = {cv::IMWRITE_JPEG_PROGRESSIVE, 1};
  const auto bytes = encoded(extension.substr(extension.rfind('.')), source, parameters);
  REQUIRE_NOTHROW(load_image(directory.write("whole" + extension, bytes)));
  for (int cut = 1; cut <= 40; ++cut) {
    // The first cuts take single bytes off the end; trailing directories of TIFF come last in the file, so all count.
    const std::size_t length = cut <= 4 ? bytes.size() - cut : bytes.size() * (cut - 4) / 37;
    if (length == 0 || length >= bytes.size()) continue;
    CAPTURE(length, bytes.size());
    error_of(directory.write("cut" + extension, std::vector(bytes.begin(), bytes.begin() + length)));
  }
}

TEST_CASE("An image that claims to be huge is refused before it is decoded") {
  const TemporaryDirectory directory;
  const auto [extension, width_at, bytes_each] =
      GENERATE(std::tuple{".png", 16, 4}, std::tuple{".jpg", -1, 2}, std::tuple{".bmp", 18, 4});
  CAPTURE(extension);
  auto bytes = encoded(extension, textured(CV_8UC1));
  const auto put = [&, count = bytes_each](std::size_t at, unsigned value, bool big_endian) {
    for (int i = 0; i < count; ++i) {
      bytes[at + static_cast<std::size_t>(i)] =
          static_cast<std::uint8_t>(value >> 8 * (big_endian ? count - 1 - i : i));
    }
  };
  std::size_t at = static_cast<std::size_t>(width_at);
  if (width_at < 0) {  // SOF0: height, then width
    const std::array<std::uint8_t, 2> frame{0xFF, 0xC0};
    at = static_cast<std::size_t>(std::ranges::search(bytes, frame).begin() - bytes.begin()) + 5;
  }
  const bool big_endian = std::string(extension) != ".bmp";
  put(at, 65500, big_endian);
  put(at + static_cast<std::size_t>(bytes_each), 65500, big_endian);
  if (std::string(extension) == ".png") {
    const std::uint32_t crc = crc32(std::span(bytes).subspan(12, 17));
    for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
  }
  CHECK_THAT(error_of(directory.write(std::string("huge") + extension, bytes)), Catch::Contains("65500x65500"));
}

TEST_CASE("A JPEG cut in its data with an end marker put behind is detected") {
  const TemporaryDirectory directory;
  auto bytes = encoded(".jpg", textured());
  bytes.resize(bytes.size() / 2);
  bytes.insert(bytes.end(), {0xFF, 0xD9});
  CHECK_THAT(error_of(directory.write("cut.jpg", bytes)), Catch::Contains("truncated"));
}

TEST_CASE("The real JPEG that a decoder still shows is refused") {
  const auto folder = test::opencv_images();
  if (!folder) return;
  const auto path = *folder / "left01.jpg";
  const TemporaryDirectory directory;
  auto bytes = bytes_of(path);
  CHECK(load_image(path).width == 640);
  bytes.resize(bytes.size() - 1000);
  const auto cut = directory.write("left01.jpg", bytes);
  CHECK(!cv::imread(cut.string(), cv::IMREAD_GRAYSCALE).empty());
  CHECK_THAT(error_of(cut), Catch::Contains("no end-of-image marker"));
}

TEST_CASE("A JPEG with other bytes in the middle of its data is refused") {
  const bool restarts = GENERATE(false, true);
  CAPTURE(restarts);
  const auto bytes = encoded(".jpg", textured(CV_8UC3, {640, 480}), {cv::IMWRITE_JPEG_RST_INTERVAL, restarts ? 20 : 0});
  constexpr std::array<std::uint8_t, 2> kScan{0xFF, 0xDA};
  const auto scan = static_cast<std::size_t>(std::ranges::search(bytes, kScan).begin() - bytes.begin());
  const std::size_t begin = scan + 2 + (bytes[scan + 2] << 8 | bytes[scan + 3]), end = bytes.size() - 2;
  CHECK_NOTHROW(decode_image(bytes, "whole"));
  CHECK_NOTHROW(check_jpeg_packet(bytes, "whole"));
  CHECK(refused_of_40(bytes, begin, end, [](const auto& damaged) { decode_image(damaged, "damaged"); }) >= 38);
  CHECK(refused_of_40(bytes, begin, end, [](const auto& damaged) { check_jpeg_packet(damaged, "damaged"); }) >= 38);
  // Where zeros lie over the end of the data, decoders may have all pixels before the last zero.
  auto padded = bytes;
  padded.insert(padded.end() - 2, 100, std::uint8_t{0});
  CHECK_THROWS_WITH(decode_image(padded, "padded"), Catch::Contains("extraneous"));
  CHECK_THROWS_WITH(check_jpeg_packet(padded, "padded"), Catch::Contains("extraneous"));
}

TEST_CASE("A TIFF with other bytes in its compressed data is refused, and so are kinds without any check") {
  const cv::Mat image = textured(CV_8UC3, {320, 240});
  const auto bytes = encoded(".tiff", image);
  const std::size_t compression = tiff_entry(bytes, 259);
  REQUIRE(bytes[compression + 8] == 5);  // LZW
  CHECK_NOTHROW(decode_image(bytes, "whole"));
  constexpr std::size_t kHeader = 8;
  const std::size_t end = bytes.size() - 1000;  // the directory lies behind it
  CHECK(refused_of_40(bytes, kHeader, end, [](const auto& damaged) { decode_image(damaged, "damaged"); }) >= 38);
  const auto plain = encoded(".tiff", image, {cv::IMWRITE_TIFF_COMPRESSION, 1});
  CHECK(decode_image(plain, "plain") == decode_image(bytes, "whole"));
  for (const int other : {8, 32773}) {  // Deflate, PackBits
    CHECK_THROWS_WITH(decode_image(encoded(".tiff", image, {cv::IMWRITE_TIFF_COMPRESSION, other}), "other"),
                      Catch::Contains("a TIFF of compression " + std::to_string(other)) && Catch::Contains("expected"));
  }
  auto shorter = plain;
  shorter[tiff_entry(shorter, 257) + 8] = 241;  // of 240 rows
  CHECK_THROWS_WITH(decode_image(shorter, "shorter"), Catch::Contains("TIFF"));
}

TEST_CASE("LZW in TIFF may end as older writers end it, but not before its last code") {
  constexpr unsigned kPixels = 254;  // behind so many codes those that follow have a bit more
  for (const unsigned end_bits : {0U, 9U, 10U}) {
    CAPTURE(end_bits);
    const Image image = decode_image(lzw_tiff(kPixels, kPixels, end_bits), "whole");
    REQUIRE(image.width == kPixels);
    for (int x = 0; x < image.width; ++x) CHECK(image.at(x, 0) == x);
    CHECK_THROWS_WITH(decode_image(lzw_tiff(kPixels, kPixels - 1, end_bits), "cut"),
                      Catch::Contains("a damaged TIFF strip"));
  }
  CHECK_THROWS_WITH(decode_image(lzw_tiff(kPixels, kPixels, 10, 2), "turned"),
                    Catch::Contains("FillOrder 2; expected 1"));
}

TEST_CASE("Orientation is refused where a decoder would turn the image") {
  auto bytes = encoded(".tiff", textured(CV_8UC1));
  const std::size_t entry = tiff_entry(bytes, 339);  // SampleFormat, which is 1 in any case
  REQUIRE(bytes[entry + 8] == 1);
  bytes[entry] = 274 & 0xFF;
  bytes[entry + 1] = 274 >> 8;
  CHECK_NOTHROW(decode_image(bytes, "upright"));
  bytes[entry + 8] = 3;
  CHECK_THROWS_WITH(decode_image(bytes, "turned"), Catch::Contains("orientation 3; expected orientation 1"));
}

TEST_CASE("16-bit images are refused in clear words") {
  const TemporaryDirectory directory;
  const cv::Mat deep(8, 8, CV_16UC1, cv::Scalar(1000));
  for (const std::string extension : {".png", ".pgm", ".tiff"}) {
    const auto message = error_of(directory.write("deep" + extension, encoded(extension, deep)));
    CHECK_THAT(message, Catch::Contains("16"));
    CHECK_THAT(message, Catch::Contains("expected an 8-bit image"));
  }
}

TEST_CASE("Missing, empty, unreadable and alien files are refused") {
  const TemporaryDirectory directory;
  CHECK_THAT(error_of(directory / "none.png"), Catch::Contains("no such file"));
  CHECK_THAT(error_of(directory.write("empty.png", "")), Catch::Contains("empty"));
  CHECK_THAT(error_of(directory.path()), Catch::Contains("directory"));
  CHECK_THAT(error_of(directory.write("text.png", "These are not the pixels that you are looking for.")),
             Catch::Contains("not an image"));
  auto damaged = encoded(".png", textured());
  damaged[damaged.size() / 2] ^= 0x10;
  CHECK_THAT(error_of(directory.write("damaged.png", damaged)), Catch::Contains("CRC"));
}

TEST_CASE("Random damage never crashes the loader") {
  const TemporaryDirectory directory;
  const std::uint32_t seed = Catch::rngSeed();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const std::string extension : {".jpg", ".png", ".pgm", ".bmp", ".tiff"}) {
    const auto bytes = encoded(extension, textured(CV_8UC1));
    for (int trial = 0; trial < 60; ++trial) {
      auto copy = bytes;
      for (int i = 0; i < 3; ++i)
        copy[random() % (trial % 2 == 0 ? copy.size() : 64)] = static_cast<std::uint8_t>(random());
      try {
        decode_image(copy, "damaged");
      } catch (const FileError&) {
      }
    }
  }
}

TEST_CASE("Fields are the even and the odd rows") {
  Image image(2, 5);
  for (int y = 0; y < 5; ++y) image.at(0, y) = static_cast<std::uint8_t>(y);
  CHECK(field_of(image, 0).height == 3);
  CHECK(field_of(image, 1).height == 2);
  CHECK(field_of(image, 0).at(0, 2) == 4);
  CHECK(field_of(image, 1).at(0, 1) == 3);
}

TEST_CASE("Sequences come from files, patterns and directories, in order") {
  const TemporaryDirectory directory;
  for (const char* name : {"left2.png", "left1.png", "right1.png", "right2.png", "notes.txt"}) {
    directory.write(name, encoded(".png", textured(CV_8UC1)));
  }
  const auto names = [&](const std::vector<std::string>& arguments) {
    std::string joined;
    const auto source = open_frames(arguments);
    while (const auto image = source->next()) joined += std::filesystem::path(image->name).filename().string() + " ";
    return joined;
  };
  CHECK(names({(directory / "left*.png").string()}) == "left1.png left2.png ");
  CHECK(names({directory.path().string()}) == "left1.png left2.png right1.png right2.png ");
  CHECK(names({(directory / "right2.png").string(), (directory / "left1.png").string()}) == "right2.png left1.png ");
  CHECK_THROWS_AS(open_frames({(directory / "middle*.png").string()}), FileError);
  CHECK_THROWS_AS(open_frames({(directory / "none.png").string()}), FileError);
  CHECK_THROWS_AS(open_frames({"camera:97"}), FileError);
  CHECK_THROWS_WITH(PairSource({(directory / "left*.png").string()}, {(directory / "right1.png").string()}),
                    Catch::Contains("2 left images but 1 right images"));
}

TEST_CASE("Images are paired as people count, and only with those of the same number") {
  const TemporaryDirectory directory;
  const auto image = encoded(".png", textured(CV_8UC1));
  for (const char* side : {"l", "r", "cut", "one", "six"}) std::filesystem::create_directory(directory / side);
  for (const char* name :
       {"l/img8.png",    "l/img9.png",  "l/img10.png",   "l/img11.png",   "r/img08.png",   "r/img09.png",
        "r/img10.png",   "r/img11.png", "cut/img08.png", "cut/img10.png", "cut/img11.png", "cut/img12.png",
        "one/im2.png",   "one/im6.png", "six/im6.png",   "left1.png",     "right1.png",    "right2.png",
        "right.png",     "0_7.png",     "1_7.png",       "0_8.png",       "1_8.png",       "2_8.png",
        "7_0.png",       "7_1.png",     "8_0.png",       "8_1.png",       "a1_left_4.png", "a2_right_4.png",
        "a2_right_5.png"}) {
    directory.write(name, image);
  }
  const auto pairs = [&](const std::vector<std::string>& left, const std::vector<std::string>& right,
                         PairNumbers numbers = PairNumbers::must_agree) {
    const auto full = [&](const std::vector<std::string>& names) {
      std::vector<std::string> paths;
      for (const std::string& name : names) paths.push_back((directory / name).string());
      return paths;
    };
    std::string joined;
    PairSource source(full(left), full(right), numbers);
    while (const auto pair = source.next()) {
      joined += std::filesystem::path(pair->left.name).stem().string() + "-" +
                std::filesystem::path(pair->right.name).stem().string() + " ";
    }
    return joined;
  };
  const std::string counted = "img8-img08 img9-img09 img10-img10 img11-img11 ";
  CHECK(pairs({"l"}, {"r"}) == counted);
  CHECK(pairs({"l/img*"}, {"r/*.png"}) == counted);
  CHECK_THROWS_WITH(pairs({"l"}, {"cut"}), Catch::Contains("img10.png: its number is not that of the left image") &&
                                               Catch::Contains("img9.png") && Catch::Contains("--pair-by-order"));
  CHECK(pairs({"l"}, {"cut"}, PairNumbers::ignored) == "img8-img08 img9-img10 img10-img11 img11-img12 ");
  // One number is the moment's, or that of a camera.
  CHECK_NOTHROW(pairs({"left1.png"}, {"right1.png"}));
  CHECK_NOTHROW(pairs({"left1.png"}, {"right.png"}));
  CHECK_THROWS_AS(pairs({"left1.png"}, {"right2.png"}), FileError);
  CHECK_NOTHROW(pairs({"one/im2.png"}, {"one/im6.png"}));
  CHECK_THROWS_AS(pairs({"one/im2.png"}, {"six/im6.png"}), FileError);
  // One is the moment's, one the camera's.
  CHECK_NOTHROW(pairs({"0_*.png"}, {"1_*.png"}));
  CHECK_NOTHROW(pairs({"7_0.png", "8_0.png"}, {"7_1.png", "8_1.png"}));
  CHECK_THROWS_AS(pairs({"0_7.png"}, {"1_8.png"}), FileError);
  CHECK_THROWS_AS(pairs({"0_7.png", "0_8.png"}, {"1_7.png", "2_8.png"}), FileError);
  CHECK_NOTHROW(pairs({"a1_left_4.png"}, {"a2_right_4.png"}));
  CHECK_THROWS_AS(pairs({"a1_left_4.png"}, {"a2_right_5.png"}), FileError);
}

TEST_CASE("A pair of different sizes is refused by the name of the right image") {
  const TemporaryDirectory directory;
  directory.write("left.png", encoded(".png", textured(CV_8UC1)));
  directory.write("right.png", encoded(".png", cv::Mat(48, 63, CV_8UC1, cv::Scalar(9))));
  PairSource pairs({(directory / "left.png").string()}, {(directory / "right.png").string()});
  CHECK_THROWS_WITH(pairs.next(), Catch::Contains("right.png: the image is 63x48 pixels; expected 64x48"));
}

TEST_CASE("Videos are read frame by frame, and a truncated one is detected") {
  const auto folder = test::opencv_images();
  if (!folder) return;
  const auto path = *folder / "Megamind.avi";
  const TemporaryDirectory directory;
  const auto source = open_frames({path.string()});
  const auto frame = source->next();
  REQUIRE(frame);
  CHECK(frame->image.width == 720);
  CHECK(frame->name == path.string() + "#0");
  auto bytes = bytes_of(path);
  bytes.resize(bytes.size() / 2);
  CHECK_THROWS_WITH(open_frames({directory.write("cut.avi", bytes).string()}), Catch::Contains("truncated"));
}

TEST_CASE("A file of more than one image is refused; padding is none") {
  const TemporaryDirectory directory;
  const std::string extension = GENERATE(".jpg", ".png", ".pgm", ".ppm");
  CAPTURE(extension);
  const auto image = encoded(extension, textured(extension == ".pgm" ? CV_8UC1 : CV_8UC3));
  auto padded = image;
  padded.insert(padded.end(), 3, extension[2] == 'g' || extension[2] == 'p' ? '\n' : '\0');
  CHECK_NOTHROW(load_image(directory.write("padded" + extension, padded)));
  padded.insert(padded.end(), image.begin(), image.end());
  const std::string two = error_of(directory.write("two" + extension, padded));
  CHECK_THAT(two, Catch::Contains("another image") && Catch::Contains("expected one image"));
  if (extension != ".pgm") return;
  CHECK_THAT(error_of(directory.write("text.pgm", "P2 2 1 255 7 200\nP2 2 1 255 7 201\n")),
             Catch::Contains("another image"));
  const auto stack = directory / "stack.tiff";
  REQUIRE(cv::imwritemulti(stack.string(), std::vector<cv::Mat>{textured(), textured()}));
  CHECK_THAT(error_of(stack), Catch::Contains("another image") && Catch::Contains("expected one image"));
}

TEST_CASE("The packet of a stream is a whole image, or two fields") {
  const auto image = encoded(".jpg", textured());
  auto fields = image;
  fields.insert(fields.end(), {0, 0});
  fields.insert(fields.end(), image.begin(), image.end());
  CHECK_NOTHROW(check_jpeg_packet(image, "packet"));
  CHECK_NOTHROW(check_jpeg_packet(fields, "packet"));
  CHECK_THROWS_AS(check_jpeg_packet({}, "packet"), FileError);
  CHECK_THROWS_AS(check_jpeg_packet(std::span(image).subspan(2), "packet"), FileError);
  for (const auto& whole : {image, fields}) {
    const auto cut = std::span(whole).first(whole.size() - image.size() / 5);
    CHECK_THROWS_WITH(check_jpeg_packet(cut, "packet"), Catch::Contains("no end-of-image marker"));
  }
  auto hole = image;  // its end is there
  hole.erase(hole.end() - 300, hole.end() - 100);
  CHECK_THROWS_WITH(check_jpeg_packet(hole, "packet"), Catch::Contains("damaged or truncated"));
}

/// 5 images, by FFmpeg.
std::string write_video(const std::filesystem::path& path, const std::string& codec, double images_per_s = 10) {
  cv::VideoWriter video(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]),
                        images_per_s, {256, 192});
  REQUIRE(video.isOpened());
  cv::Mat image;
  cv::resize(textured(), image, {256, 192}, 0, 0, cv::INTER_NEAREST);
  for (int i = 0; i < 5; ++i) {
    cv::flip(image, image, i % 2);
    video.write(image);
  }
  return path.string();
}

int frames_of(const std::string& path) {
  int frames = 0;
  for (const auto source = open_frames({path}); source->next();) ++frames;
  return frames;
}

TEST_CASE("A video of JPEG images is read up to the first that is damaged") {
  const TemporaryDirectory directory;
  const std::string name = GENERATE("video.avi", "video.mkv", "video.mov");
  const auto path = write_video(directory / name, "MJPG");
  CHECK(frames_of(path) == 5);
  auto bytes = bytes_of(path);
  const auto frame = jpeg_at(bytes, 3), next = jpeg_at(bytes, 4);
  std::fill(next - (next - frame) / 5, next - 30, std::uint8_t{0});  // what FFmpeg still shows
  directory.write(name, bytes);
  CHECK_THROWS_WITH(frames_of(path), Catch::Contains(name + "#3") && (Catch::Contains("damaged or truncated") ||
                                                                      Catch::Contains("no end-of-image marker")));
}

TEST_CASE("What a decoder notices of a damaged video is an error") {
  const TemporaryDirectory directory;
  const auto [name, codec] = GENERATE(table<std::string, std::string>(
      {{"a.avi", "MP4V"}, {"c.mkv", "mpg2"}, {"d.mp4", "avc1"}, {"e.mkv", "H264"}, {"f.mov", "png "}}));
  CAPTURE(name);
  const auto path = write_video(directory / name, codec);
  CHECK(frames_of(path) == 5);
  CHECK(open_frames({path})->warnings().empty());
  const auto whole = bytes_of(path);
  int noticed = 0;
  for (int tenth = 3; tenth <= 7; ++tenth) {
    auto bytes = whole;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(whole.size()) * tenth / 10, 100, std::uint8_t{0});
    directory.write(name, bytes);
    try {
      frames_of(path);
    } catch (const FileError& error) {
      ++noticed;
      CHECK_THAT(error.what(), Catch::Contains(name + "#") && Catch::Contains("damaged"));
    }
  }
  CHECK(noticed >= 3);  // of 5
}

TEST_CASE("A video is turned as its file says") {
  const TemporaryDirectory directory;
  const auto path = write_video(directory / "video.mp4", "MP4V");
  const auto first = [&] { return open_frames({path})->next().value().image; };
  const Image lying = first();
  auto bytes = bytes_of(path);
  constexpr std::array<std::uint8_t, 4> kTrackHeader{'t', 'k', 'h', 'd'};
  constexpr std::ptrdiff_t kMatrix = 44;  // behind these letters, in version 0; ISO/IEC 14496-12, 8.3.2
  const auto matrix = std::ranges::search(bytes, kTrackHeader).begin() + kMatrix;
  constexpr std::array<std::uint8_t, 20> kClockwise{0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 0, 0, 0, 0};
  std::ranges::copy(kClockwise, matrix);
  directory.write("video.mp4", bytes);
  const Image standing = first();
  CHECK((standing.width == 192 && standing.height == 256));
  CHECK(standing.at(191, 10) == lying.at(10, 0));
  CHECK(standing.at(3, 255) == lying.at(255, 188));
}

TEST_CASE("A video may tell viewers to leave out its last image") {
  const TemporaryDirectory directory;
  const auto path = write_video(directory / "video.mp4", "MP4V");
  auto bytes = bytes_of(path);
  constexpr std::array<std::uint8_t, 4> kEditList{'e', 'l', 's', 't'};
  // Behind these letters version and count, of 4 bytes each, then the length in ms; ISO/IEC 14496-12, 8.6.6.
  const auto length_ms = std::ranges::search(bytes, kEditList).end() + 8;
  REQUIRE((length_ms[2] << 8 | length_ms[3]) == 500);
  length_ms[2] = 400 >> 8;
  length_ms[3] = 400 & 0xFF;
  directory.write("video.mp4", bytes);
  CHECK(open_frames({path})->count() == 5);
  CHECK(frames_of(path) == 4);
}

TEST_CASE("Of videos whose decoders notice no damage there is a warning") {
  const TemporaryDirectory directory;
  const auto path = write_video(directory / "video.webm", "VP80");
  CHECK(frames_of(path) == 5);
  const auto warnings = PairSource({path}, {write_video(directory / "other.avi", "MJPG")}).warnings();
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Contains("video.webm: damage") && Catch::Contains("vp8"));
}

TEST_CASE("A cut video of Matroska is refused, and one whose recorder was killed is none") {
  const TemporaryDirectory directory;
  const auto path = write_video(directory / "video.mkv", "mpg2");
  auto bytes = bytes_of(path);
  const auto whole = bytes;
  bytes.resize(bytes.size() * 2 / 3);
  directory.write("video.mkv", bytes);
  CHECK_THROWS_WITH(open_frames({path}), Catch::Contains("truncated"));
  constexpr std::array<std::uint8_t, 4> kSegment{0x18, 0x53, 0x80, 0x67};
  bytes = whole;
  const auto length = std::ranges::search(bytes, kSegment).end();
  REQUIRE(*length == 0x01);  // of 8 bytes
  std::fill_n(length + 1, 7, std::uint8_t{0xFF});
  directory.write("video.mkv", bytes);
  CHECK(frames_of(path) == 5);
  bytes.resize(bytes.size() * 2 / 3);
  directory.write("video.mkv", bytes);
  CHECK_THROWS_WITH(frames_of(path), Catch::Contains("File ended prematurely"));
}

TEST_CASE("Two videos are paired by their times") {
  const TemporaryDirectory directory;
  const auto left = write_video(directory / "left.mkv", "MJPG"), right = write_video(directory / "right.mkv", "MJPG");
  const auto pairs = [&](const std::string& other, PairNumbers numbers = PairNumbers::must_agree) {
    int count = 0;
    for (PairSource source({left}, {other}, numbers); source.next();) ++count;
    return count;
  };
  CHECK(pairs(right) == 5);
  const auto slow = write_video(directory / "slow.avi", "MJPG", 8);
  CHECK_THROWS_WITH(pairs(slow),
                    Catch::Contains("slow.avi#3") && Catch::Contains("0.375 s") && Catch::Contains("0.300 s"));
  CHECK(pairs(slow, PairNumbers::ignored) == 5);
  auto bytes = bytes_of(right);
  delay_images(bytes, 3, 5, 100);
  directory.write("right.mkv", bytes);
  CHECK_THROWS_WITH(pairs(right), Catch::Contains("right.mkv#3") && Catch::Contains("--pair-by-order"));
  std::vector<std::size_t> left_out;
  for (const auto source = open_frames({right}); const auto image = source->next();) {
    left_out.push_back(image->time.value().left_out);
  }
  CHECK(left_out == std::vector<std::size_t>{0, 0, 0, 1, 0});
}

TEST_CASE("Results are complete or not there") {
  const TemporaryDirectory directory;
  const auto results = directory / "deep/results";
  {
    OutputDirectory output(results);
    output.write("a.txt", "a");
  }
  CHECK(std::filesystem::is_empty(directory.path()));
  const auto is_result = [](const std::string& name) { return name.starts_with("frame"); };
  {
    OutputDirectory output(results, is_result);
    output.write("frame-0.txt", "old");
    output.write("frame-1.txt", "old");
    output.commit();
  }
  directory.write("deep/results/notes.txt", "mine");
  {
    OutputDirectory output(results, is_result);
    output.write("frame-0.txt", "new");
    CHECK(bytes_of(results / "frame-0.txt").front() == 'o');
    output.commit();
  }
  CHECK(bytes_of(results / "frame-0.txt").front() == 'n');
  CHECK(!std::filesystem::exists(results / "frame-1.txt"));
  CHECK(std::filesystem::exists(results / "notes.txt"));
  CHECK(std::distance(std::filesystem::directory_iterator(directory / "deep"), {}) == 1);
  CHECK_THROWS_AS(OutputDirectory(directory.write("file", "x")), FileError);
  OutputDirectory output(results);
  for (const char* const name : {"", ".", "..", "../up.txt", "sub/file.txt", "/file.txt", "file/"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(output.write(name, "x"), FileError);
  }
  CHECK_THROWS_AS(write_file(directory / "none/file", "x"), FileError);
}

TEST_CASE("Beside a file that is written, only what a killed process left of it is taken away") {
  const TemporaryDirectory directory;
  const auto left = directory.write(".x.horopter-999999999-0.partial", "half");
  const auto at_work = directory.write(".x.horopter-999999999-1.partial", "half");
  const int lock = ::open(at_work.c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(::flock(lock, LOCK_EX | LOCK_NB) == 0);
  // Another process of this number, in another container.
  const std::string own = ".x.horopter-" + std::to_string(::getpid()) + "-0.partial";
  const int same = ::open(directory.write(own, "half").c_str(), O_RDWR | O_CLOEXEC);
  REQUIRE(::flock(same, LOCK_EX | LOCK_NB) == 0);
  const std::vector<std::filesystem::path> others{
      directory.write(".x.20261130", "a backup"), directory.write(".x.999999999.partial", "somebody's"),
      directory.write(".x.horopter-.partial", "somebody's"), directory.write(".y.horopter-1-0.partial", "of y")};
  write_file(directory / "x", "new");
  CHECK(bytes_of(directory / "x").size() == 3);
  CHECK_FALSE(std::filesystem::exists(left));
  CHECK(bytes_of(at_work).size() == 4);
  CHECK(bytes_of(directory / own).size() == 4);
  for (const auto& other : others) CHECK(std::filesystem::exists(other));
  CHECK(std::distance(std::filesystem::directory_iterator(directory.path()), {}) == 7);
  ::close(lock);
  ::close(same);
  write_file(directory / "x", "newer");
  CHECK_FALSE(std::filesystem::exists(at_work));
  CHECK_FALSE(std::filesystem::exists(directory / own));
  const std::string longest(255, 'n');
  write_file(directory / longest, "x");
  CHECK(bytes_of(directory / longest).size() == 1);
}

TEST_CASE("A file that is written anew keeps its mode and the links to it, and a pipe takes it as it is") {
  namespace fs = std::filesystem;
  const TemporaryDirectory directory;
  const auto mode_of = [&](const char* name) { return fs::status(directory / name).permissions(); };
  directory.write("private", "old");
  fs::permissions(directory / "private", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_directory(directory / "links");
  fs::create_symlink("../private", directory / "links/link");
  fs::create_symlink("later", directory / "links/dangling");
  for (const char* name : {"private", "links/link"}) {
    write_file(directory / name, std::string("new ") + name);
    CHECK(bytes_of(directory / "private") == bytes_of(directory.write("same", std::string("new ") + name)));
    CHECK(mode_of("private") == (fs::perms::owner_read | fs::perms::owner_write));
  }
  write_file(directory / "links/dangling", "x");
  CHECK(fs::is_regular_file(directory / "links/later"));
  CHECK(fs::is_symlink(directory / "links/link"));
  CHECK(fs::is_symlink(directory / "links/dangling"));
  CHECK(mode_of("same") == mode_of("links/later"));  // as of any new file
  REQUIRE(::mkfifo((directory / "pipe").c_str(), 0600) == 0);
  const int reader = ::open((directory / "pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  write_file(directory / "pipe", "through");
  std::array<char, 16> text{};
  CHECK(::read(reader, text.data(), text.size()) == 7);
  ::close(reader);
  CHECK(fs::is_fifo(directory / "pipe"));
  write_file("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("Folders of moments are paired by their numbers") {
  const TemporaryDirectory directory;
  const auto image = encoded(".png", textured(CV_8UC1));
  const auto make = [&](const std::string& name) {
    std::filesystem::create_directories((directory / name).parent_path());
    directory.write(name, image);
  };
  const auto pairs = [&](const std::string& left, const std::string& right,
                         PairNumbers numbers = PairNumbers::must_agree) {
    PairSource source({(directory / left).string()}, {(directory / right).string()}, numbers);
    return source.count();
  };
  for (int i = 1; i < 24; ++i) {
    const std::string moment = "dm/m" + std::to_string(i);
    for (const char* name : {"/left.png", "/right.png", "/left0.png", "/right0.png", "/cam0/a.png", "/cam1/a.png"}) {
      make(moment + name);
    }
  }
  for (const char* name : {"c0/a.png", "c0/b.png", "c1/a.png", "c1/b.png"}) make(name);
  const std::vector<std::pair<std::string, std::string>> all{{"dm/m*/left.png", "dm/m*/right.png"},
                                                             {"dm/m*/left0.png", "dm/m*/right0.png"},
                                                             {"dm/m*/cam0/a.png", "dm/m*/cam1/a.png"}};
  for (const auto& [left, right] : all) CHECK(pairs(left, right) == 23);
  CHECK(pairs("c0", "c1") == 2);
  CHECK(pairs("dm/m7/left.png", "dm/m7/right.png") == 1);
  CHECK(pairs("dm/m7/left.png", "dm/m8/right.png") == 1);  // they may be cameras
  // The left camera lost one, the right camera another.
  for (const char* lost :
       {"m5/left.png", "m5/left0.png", "m5/cam0/a.png", "m22/right.png", "m22/right0.png", "m22/cam1/a.png"}) {
    std::filesystem::remove(directory / "dm" / lost);
  }
  for (const auto& [left, right] : all) {
    CAPTURE(left);
    CHECK_THROWS_WITH(pairs(left, right), Catch::Contains("m5/") && Catch::Contains("m6/") &&
                                              Catch::Contains("its number is not that of the left image"));
    CHECK(pairs(left, right, PairNumbers::ignored) == 22);
  }
  // One after the other, so that a single pair is not of one moment.
  for (const char* name : {"s/left_4_v2.png", "s/left_6_v2.png", "s/right_4_v2.png", "s/right_5_v2.png"}) make(name);
  CHECK_THROWS_WITH(pairs("s/left*", "s/right*"), Catch::Contains("right_5_v2.png: its number"));
}

TEST_CASE("A directory that holds what is not read is refused, by its name") {
  const TemporaryDirectory directory;
  for (const char* name : {"img1.png", "img2.png", "img4.PNG"})
    directory.write(name, encoded(".png", textured(CV_8UC1)));
  for (const char* name : {"notes.txt", "rig.yaml", "times.csv", "frames.json", ".img3.webp", "Makefile"}) {
    directory.write(name, "x");
  }
  std::filesystem::create_directory(directory / "more");
  const std::vector<std::string> argument{directory.path().string()};
  REQUIRE(open_frames(argument)->count() == 3);
  for (const std::string name : {"img3.webp", "img3.GIF", "img3.jp2", "img3.heic", "img3.avif", "img3.exr", "img3.hdr",
                                 "img3.mp4", "img3.avi", "img3.mkv", "img3.mov"}) {
    directory.write(name, "x");
    directory.write("img9.webp", "x");
    CHECK_THROWS_WITH(open_frames(argument),
                      Catch::Contains(": " + name +
                                      ": a directory with files that are no images that can be read; "
                                      "expected only PNG"));
    std::filesystem::remove(directory / name);
    std::filesystem::remove(directory / "img9.webp");
  }
  std::filesystem::create_symlink(directory / "img2.png", directory / "img3.png");
  CHECK(open_frames(argument)->count() == 4);
  std::filesystem::remove(directory / "img3.png");
  std::filesystem::create_symlink(directory / "none.png", directory / "img3.png");
  CHECK_THROWS_WITH(open_frames(argument), Catch::Contains(": img3.png: this is no file, or a link to none"));
}

TEST_CASE("Where images are steps of time, none may be missing") {
  const TemporaryDirectory directory;
  std::filesystem::create_directories(directory / "m8");
  std::filesystem::create_directories(directory / "m9");
  std::filesystem::create_directories(directory / "m11");
  const auto check = [&](const std::vector<std::string>& names) {
    std::vector<std::string> paths;
    for (const std::string& name : names) paths.push_back(directory.write(name, "x").string());
    check_consecutive(paths);
  };
  CHECK_NOTHROW(check({"a.png"}));
  CHECK_NOTHROW(check({"a.png", "b.png", "c.png"}));
  CHECK_NOTHROW(check({"cam0_0008.png", "cam0_0009.png", "cam0_0010.png"}));
  CHECK_NOTHROW(check({"m8/left1.png", "m9/left1.png"}));
  CHECK_NOTHROW(check_consecutive({"camera:0"}));
  CHECK_THROWS_WITH(check({"i8.png", "i9.png", "i11.png"}),
                    Catch::Contains("i11.png: it is not the image after") && Catch::Contains("expected number 10"));
  CHECK_THROWS_WITH(check({"i98_2.png", "i99_2.png", "i101_2.png"}), Catch::Contains("expected number 100"));
  CHECK_THROWS_WITH(check({"m9/left.png", "m11/left.png"}), Catch::Contains("expected number 10"));
  CHECK_THROWS_WITH(check({"i1.png", "i2.png", "i2.png"}), Catch::Contains("expected number 3"));
  CHECK_THROWS_WITH(check({"i2.png", "i1.png"}), Catch::Contains("expected number 3"));
  CHECK_THROWS_WITH(check({"left.png", "left1.png"}), Catch::Contains("a number in each name"));
}

}  // namespace horopter
