// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/frames.hpp"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/videoio.hpp>
#include <span>
#include <string_view>

#include "horopter/base/error.hpp"
#include "horopter/image/mat.hpp"
#include "image_check.hpp"
#include "video.hpp"

namespace horopter {
namespace {

namespace fs = std::filesystem;

class FileSource : public FrameSource {
 public:
  explicit FileSource(fs::path path) : path_(std::move(path)) {}
  std::optional<NamedImage> next() override {
    if (done_) return std::nullopt;
    done_ = true;
    return NamedImage{path_.string(), load_image(path_)};
  }
  std::optional<std::size_t> count() const override { return 1; }

 private:
  fs::path path_;
  bool done_ = false;
};

class CameraSource : public FrameSource {
 public:
  CameraSource(std::string name, int camera) : name_(std::move(name)) {
    if (!capture_.open(camera))
      throw FileError(name_, "", "this camera cannot be opened", "the number of a camera, or a file");
  }
  std::optional<NamedImage> next() override {
    cv::Mat frame;
    if (!capture_.read(frame) || frame.empty()) {
      throw FileError(name_, fmt::format("frame {}", index_), "the camera gives no image", "an image");
    }
    const std::string name = fmt::format("{}#{}", name_, index_++);
    if (frame.depth() != CV_8U) throw FileError(name, "", "more than 8 bits a sample", "8-bit grey or colour");
    return NamedImage{name, grey_image(frame)};
  }
  std::optional<std::size_t> count() const override { return std::nullopt; }
  bool is_live() const override { return true; }

 private:
  std::string name_;
  cv::VideoCapture capture_;
  std::size_t index_ = 0;
};

class ListSource : public FrameSource {
 public:
  explicit ListSource(std::vector<std::unique_ptr<FrameSource>> parts) : parts_(std::move(parts)) {}
  std::optional<NamedImage> next() override {
    for (; at_ < parts_.size(); ++at_) {
      if (auto image = parts_[at_]->next()) return image;
    }
    return std::nullopt;
  }
  std::optional<std::size_t> count() const override {
    std::size_t sum = 0;
    for (const auto& part : parts_) {
      const auto count = part->count();
      if (!count) return std::nullopt;
      sum += *count;
    }
    return sum;
  }
  bool is_live() const override {
    return std::ranges::any_of(parts_, [](const auto& part) { return part->is_live(); });
  }
  std::vector<std::string> warnings() const override {
    std::vector<std::string> all;
    for (const auto& part : parts_) std::ranges::move(part->warnings(), std::back_inserter(all));
    return all;
  }

 private:
  std::vector<std::unique_ptr<FrameSource>> parts_;
  std::size_t at_ = 0;
};

enum class Container { none, avi, mp4, matroska, other };

Container sniff_container(const fs::path& path) {
  std::array<char, 12> head{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), head.size());
  const auto is = [&](std::size_t at, std::array<unsigned char, 4> magic) {
    return std::equal(magic.begin(), magic.end(), head.begin() + static_cast<std::ptrdiff_t>(at),
                      [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); });
  };
  if (is(0, {'R', 'I', 'F', 'F'}) && is(8, {'A', 'V', 'I', ' '})) return Container::avi;
  if (is(4, {'f', 't', 'y', 'p'})) return Container::mp4;
  if (is(0, {0x1A, 0x45, 0xDF, 0xA3})) return Container::matroska;
  const bool mpeg = is(0, {0, 0, 1, 0xBA});
  if (mpeg || is(0, {'O', 'g', 'g', 'S'})) return Container::other;
  return Container::none;
}

/// The head of an element of Matroska: its number, and its length, if it tells one.
struct MatroskaHead {
  std::uint64_t number = 0;
  std::optional<std::uint64_t> length;
};

MatroskaHead read_matroska_head(std::istream& stream) {
  const auto read = [&](bool keeps_mark) {
    const int first = std::max(stream.get(), 0);
    const int more = first == 0 ? 0 : std::countl_zero(static_cast<std::uint8_t>(first));
    std::uint64_t value = keeps_mark ? first : first & (0x7F >> more);
    bool ones = value == (0x7FU >> more);
    for (int i = 0; i < more; ++i) {
      const int byte = std::max(stream.get(), 0);
      ones = ones && byte == 0xFF;
      value = value << 8 | static_cast<unsigned>(byte);
    }
    return std::pair{value, ones};
  };
  const auto number = read(true).first;
  const auto [length, unknown] = read(false);
  return {number, unknown ? std::nullopt : std::optional(length)};
}

[[noreturn]] void refuse_cut(const fs::path& path, std::uint64_t size, std::uint64_t length, std::uint64_t at) {
  throw FileError(path.string(), fmt::format("byte {}", size), "the video is truncated",
                  fmt::format("{} bytes from byte {} on", length, at));
}

/// The segment, which is all behind the file's head. A recorder that was killed has not told its length.
void check_matroska(const fs::path& path) {
  const std::uint64_t size = fs::file_size(path);
  std::ifstream stream(path, std::ios::binary);
  const auto head = read_matroska_head(stream);
  stream.seekg(static_cast<std::streamoff>(head.length.value_or(0)), std::ios::cur);
  constexpr std::uint64_t kSegment = 0x18538067;
  const auto segment = read_matroska_head(stream);
  const auto at = static_cast<std::uint64_t>(std::max<std::streamoff>(stream.tellg(), 0));
  const bool is_segment = stream && segment.number == kSegment;
  if (is_segment && segment.length && *segment.length > size - at) refuse_cut(path, size, *segment.length, at);
}

/// Lists in the file must end where the file does. Decoders stop quietly at a cut.
void check_container(const fs::path& path, Container container) {
  if (container == Container::matroska) return check_matroska(path);
  if (container != Container::avi && container != Container::mp4) return;
  const auto size = static_cast<std::uint64_t>(fs::file_size(path));
  std::ifstream stream(path, std::ios::binary);
  const auto number = [&](int length, bool big_endian) {
    std::array<unsigned char, 8> bytes{};
    stream.read(reinterpret_cast<char*>(bytes.data()), length);
    std::uint64_t value = 0;
    for (int i = 0; i < length; ++i) value = value << 8 | bytes[big_endian ? i : length - 1 - i];
    return value;
  };
  std::uint64_t at = 0;
  while (at < size) {
    if (container == Container::avi && size - at < 12) return;  // padding after the last list
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(at) + (container == Container::avi ? 4 : 0));
    std::uint64_t length = number(4, container == Container::mp4);
    if (container == Container::avi) {
      length += 8 + (length & 1U);
      if (length == 8) return;  // written by a recorder that was killed: no list length at all
    } else if (length == 1) {
      stream.seekg(static_cast<std::streamoff>(at) + 8);
      length = number(8, true);
    } else if (length == 0) {
      return;  // up to the end of the file
    }
    if (length < 8 || length > size - at) refuse_cut(path, size, length, at);
    at += length;
  }
}

bool has_extension(const fs::path& path, std::span<const std::string_view> extensions) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(extensions, extension) != extensions.end();
}

bool has_image_extension(const fs::path& path) {
  constexpr auto kExtensions =
      std::to_array<std::string_view>({".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".pnm", ".bmp", ".tif", ".tiff"});
  return has_extension(path, kExtensions);
}

/// Of images and videos that a directory is not read for.
bool has_other_extension(const fs::path& path) {
  constexpr auto kExtensions = std::to_array<std::string_view>(
      {".webp", ".gif",  ".jp2",  ".j2k", ".j2c",  ".jpf",  ".jpx",  ".jpe", ".jfif", ".jps", ".jxl",  ".jxr",
       ".heic", ".heif", ".avif", ".exr", ".hdr",  ".pic",  ".dib",  ".pbm", ".pam",  ".pxm", ".ras",  ".sr",
       ".tga",  ".psd",  ".ico",  ".dng", ".cr2",  ".cr3",  ".nef",  ".arw", ".raf",  ".orf", ".rw2",  ".raw",
       ".apng", ".mng",  ".qoi",  ".avi", ".mp4",  ".m4v",  ".mkv",  ".mov", ".webm", ".mpg", ".mpeg", ".m2v",
       ".ogv",  ".ogg",  ".wmv",  ".asf", ".flv",  ".mts",  ".m2ts", ".ts",  ".vob",  ".3gp", ".y4m",  ".yuv",
       ".h264", ".264",  ".h265", ".265", ".hevc", ".mjpg", ".mjpeg"});
  return has_extension(path, kExtensions);
}

std::unique_ptr<FrameSource> open_file(const fs::path& path) {
  const Container container = sniff_container(path);
  if (container == Container::none) return std::make_unique<FileSource>(path);
  check_container(path, container);
  return std::make_unique<Video>(path.string());
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A name as text and numbers in turn, text first. Numbers are without leading zeros.
std::vector<std::string> parts_of(std::string_view name) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool in_number = parts.size() % 2 == 0;
    if (is_digit(name[i]) != in_number) parts.emplace_back();
    if (is_digit(name[i]) && parts.back() == "0") parts.back().clear();
    parts.back() += name[i];
  }
  return parts;
}

/// As people count: numbers by their value.
bool in_order(const fs::path& a, const fs::path& b) {
  const auto parts_a = parts_of(a.string());
  const auto parts_b = parts_of(b.string());
  for (std::size_t i = 0; i < std::min(parts_a.size(), parts_b.size()); ++i) {
    if (parts_a[i] == parts_b[i]) continue;
    const bool longer_is_larger = i % 2 == 1 && parts_a[i].size() != parts_b[i].size();
    return longer_is_larger ? parts_a[i].size() < parts_b[i].size() : parts_a[i] < parts_b[i];
  }
  return parts_a.size() != parts_b.size() ? parts_a.size() < parts_b.size() : a < b;
}

/// What one argument, or a part of it, names.
struct Input {
  std::string name;
  std::optional<int> camera;
};

void list_directory(const fs::path& path, std::vector<Input>& inputs) {
  constexpr const char* kTypes = "PNG, JPEG, PNM, BMP or TIFF files";
  std::vector<fs::path> files, left_out;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    std::error_code dangling;
    const fs::path& file = entry.path();
    if (file.filename().string().starts_with('.')) continue;
    if (has_image_extension(file)) {
      (entry.is_regular_file(dangling) ? files : left_out).push_back(file);
    } else if (has_other_extension(file) && !entry.is_directory(dangling)) {
      left_out.push_back(file);
    }
  }
  if (error) throw FileError(path.string(), "", "the directory cannot be read", "a directory of images");
  if (!left_out.empty()) {  // what follows in the list would be of another moment
    const fs::path first = *std::ranges::min_element(left_out, in_order);
    throw FileError(path.string(), first.filename().string(),
                    has_image_extension(first) ? "this is no file, or a link to none"
                                               : "a directory with files that are no images that can be read",
                    fmt::format("only {} in the directory, or a pattern", kTypes));
  }
  if (files.empty()) throw FileError(path.string(), "", "no image in this directory", kTypes);
  std::ranges::sort(files, in_order);
  for (const fs::path& file : files) inputs.push_back({file.string(), {}});
}

std::optional<int> camera_number(std::string_view argument) {
  if (argument.starts_with("camera:")) argument.remove_prefix(7);
  int number = 0;
  const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), number);
  if (error != std::errc() || end != argument.data() + argument.size() || number < 0) return std::nullopt;
  return number;
}

std::vector<Input> inputs_of(const std::vector<std::string>& arguments) {
  std::vector<Input> inputs;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (fs::is_directory(argument, error)) {
      list_directory(argument, inputs);
    } else if (fs::exists(argument, error)) {
      inputs.push_back({argument, {}});
    } else if (const auto camera = camera_number(argument)) {
      inputs.push_back({argument, camera});
    } else if (argument.find_first_of("*?[") != std::string::npos) {
      glob_t matches{};
      const int result = ::glob(argument.c_str(), GLOB_ERR, nullptr, &matches);
      std::vector<std::string> files(matches.gl_pathv, matches.gl_pathv + (result == 0 ? matches.gl_pathc : 0));
      ::globfree(&matches);
      if (files.empty()) throw FileError(argument, "", "no file matches this pattern", "images or videos");
      std::ranges::sort(files, in_order);
      for (const std::string& file : files) {
        if (!fs::is_directory(file)) inputs.push_back({file, {}});
      }
    } else {
      throw FileError(argument, "", "there is no such file",
                      "an image, a video, a directory, a pattern or a camera number");
    }
  }
  return inputs;
}

/// Images of one camera are of one size. Looks at the begin of each file, so that a pattern which matches others, too,
/// is found before an hour of work.
void check_sizes(const std::vector<Input>& inputs) {
  constexpr std::size_t kBegin = 1 << 16;
  std::vector<std::uint8_t> begin;
  std::string first;
  ImageSize expected;
  for (const Input& input : inputs) {
    if (input.camera || !fs::is_regular_file(input.name)) continue;
    begin.resize(kBegin);
    std::ifstream stream(input.name, std::ios::binary);
    stream.read(reinterpret_cast<char*>(begin.data()), kBegin);
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    const auto size = size_in_header(begin);
    if (!size) continue;
    if (first.empty()) {
      first = input.name;
      expected = *size;
    } else if (*size != expected) {
      throw FileError(input.name, "", fmt::format("the image is {}x{} pixels", size->width, size->height),
                      fmt::format("{}x{} as in {}", expected.width, expected.height, first));
    }
  }
}

std::unique_ptr<FrameSource> open_inputs(const std::vector<Input>& inputs) {
  check_sizes(inputs);
  std::vector<std::unique_ptr<FrameSource>> sources;
  for (const Input& input : inputs) {
    if (input.camera) {
      sources.push_back(std::make_unique<CameraSource>(input.name, *input.camera));
    } else {
      sources.push_back(open_file(input.name));
    }
  }
  return std::make_unique<ListSource>(std::move(sources));
}

/// One camera cannot be both.
void check_two_cameras(const std::vector<Input>& left, const std::vector<Input>& right) {
  for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
    std::error_code error;
    const bool same = left[i].camera ? left[i].camera == right[i].camera
                                     : !right[i].camera && fs::equivalent(left[i].name, right[i].name, error);
    if (!same) continue;
    throw FileError(right[i].name, "", "this is the left image, too", "what the other camera saw at the same moment");
  }
}

/// The numbers in a file's name, and the text around them.
struct NumberedName {
  explicit NumberedName(const fs::path& path) : directory(path.parent_path()) { add(path.stem()); }
  /// Of the nearest folder that has numbers.
  void add_folder() {
    for (const std::size_t before = numbers.size(); numbers.size() == before && directory.has_relative_path();) {
      add(directory.filename());
      directory = directory.parent_path();
    }
  }
  fs::path directory;
  std::vector<std::string> text, numbers;

 private:
  void add(const fs::path& name) {
    const auto parts = parts_of(name.string());
    for (std::size_t i = 0; i < parts.size(); ++i) (i % 2 == 0 ? text : numbers).push_back(parts[i]);
  }
};

/// As names tell moments: where neither name has a number, by their folders. Of a single pair, folders may as well name
/// the cameras.
std::pair<NumberedName, NumberedName> numbered_names(const Input& left, const Input& right, bool is_single) {
  std::pair names{NumberedName(left.name), NumberedName(right.name)};
  if (!is_single && names.first.numbers.empty() && names.second.numbers.empty()) {
    names.first.add_folder();
    names.second.add_folder();
  }
  return names;
}

/// The one number in which both names differ, if there is one and all others agree.
std::optional<std::size_t> only_difference(const NumberedName& left, const NumberedName& right) {
  if (left.numbers.size() != right.numbers.size()) return std::nullopt;
  std::optional<std::size_t> only;
  for (std::size_t i = 0; i < left.numbers.size(); ++i) {
    if (left.numbers[i] == right.numbers[i]) continue;
    if (only) return std::nullopt;
    only = i;
  }
  return only;
}

[[noreturn]] void refuse_numbers(const Input& left, const Input& right) {
  throw FileError(right.name, "", fmt::format("its number is not that of the left image, {}", left.name),
                  "the image of the same moment, or --pair-by-order where the order alone counts");
}

/// The numbers of all folders above a file.
std::vector<std::string> folder_numbers(const Input& input) {
  std::vector<std::string> numbers;
  if (input.camera) return numbers;
  const auto parts = parts_of(fs::path(input.name).parent_path().string());
  for (std::size_t i = 1; i < parts.size(); i += 2) numbers.push_back(parts[i]);
  return numbers;
}

/// Folders of moments, of images that have other numbers, too: a folder's number differs in no pair, or, where it names
/// cameras or what they are in, in the same way in all of them.
void check_folders(const std::vector<Input>& left, const std::vector<Input>& right) {
  const auto first_left = folder_numbers(left.front()), first_right = folder_numbers(right.front());
  for (std::size_t i = 1; i < left.size(); ++i) {
    const auto l = folder_numbers(left[i]), r = folder_numbers(right[i]);
    if (l.size() != r.size() || l.size() != first_left.size() || l.size() != first_right.size()) continue;
    for (std::size_t k = 0; k < l.size(); ++k) {
      if (l[k] == r[k] && first_left[k] == first_right[k]) continue;
      if (l[k] != first_left[k] || r[k] != first_right[k]) refuse_numbers(left[i], right[i]);
    }
  }
}

/// Two names of one moment have the same numbers. One may differ, where it names the camera: it does not change from
/// pair to pair, and something else tells the pairs apart or leaves it no other meaning.
void check_numbers(const std::vector<Input>& left, const std::vector<Input>& right) {
  if (left.size() != right.size() || left.empty()) return;
  check_folders(left, right);
  std::optional<std::pair<std::string, std::string>> cameras;  // their numbers, once they are known
  std::optional<std::size_t> differing, same;                  // pairs: where cameras have numbers, all differ
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i].camera || right[i].camera) continue;
    const auto [l, r] = numbered_names(left[i], right[i], left.size() == 1);
    if (l.numbers.empty() || r.numbers.empty()) continue;
    if (l.numbers == r.numbers) {
      if (differing) refuse_numbers(left[*differing], right[*differing]);
      same = i;
      continue;
    }
    const auto differs = only_difference(l, r);
    bool agree = l.numbers.size() != r.numbers.size() && l.numbers.back() == r.numbers.back();
    if (differs) {
      const bool nothing_else = l.directory == r.directory && l.text == r.text;
      const bool others_follow = *differs + 1 < l.numbers.size();
      const std::pair numbers{l.numbers[*differs], r.numbers[*differs]};
      agree = (nothing_else || others_follow) && (!cameras || *cameras == numbers) && !same;
      cameras = numbers;
      if (!differing) differing = i;
    }
    if (agree) continue;
    refuse_numbers(left[i], right[i]);
  }
}

/// Of two videos that begin at one moment.
void check_times(const NamedImage& left, const NamedImage& right) {
  if (!left.time || !right.time || left.time->index != right.time->index) return;
  const double half_a_period_s = std::min(left.time->period_s, right.time->period_s) / 2;
  if (std::abs(left.time->time_s - right.time->time_s) <= half_a_period_s) return;
  throw FileError(right.name, "",
                  fmt::format("its time in the video is {:.3f} s, that of {} is {:.3f} s", right.time->time_s,
                              left.name, left.time->time_s),
                  "the image of the same moment, or --pair-by-order where the order alone counts");
}

std::string number_after(std::string number) {
  for (auto digit = number.rbegin(); digit != number.rend(); ++digit) {
    if (*digit != '9') {
      ++*digit;
      return number;
    }
    *digit = '0';
  }
  return "1" + number;
}

}  // namespace

void check_consecutive(const std::vector<std::string>& arguments) {
  const std::vector<Input> inputs = inputs_of(arguments);
  std::vector<std::string> before;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    auto parts = inputs[i].camera ? std::vector<std::string>(1)
                                  : parts_of(fs::path(inputs[i].name).replace_extension().string());
    before.swap(parts);
    if (i == 0) continue;
    const std::vector<std::string>&last = parts, &now = before;
    const std::size_t count = std::min(last.size(), now.size());
    std::vector<std::size_t> differ;  // numbers
    for (std::size_t k = 1; k < count; k += 2) {
      if (last[k] != now[k]) differ.push_back(k);
    }
    const bool as_many = last.size() / 2 == now.size() / 2;
    if (as_many && differ.empty() && (last != now || count < 2)) continue;  // nothing is known
    if (as_many && differ.size() == 1 && now[differ[0]] == number_after(last[differ[0]])) continue;
    throw FileError(inputs[i].name, "", fmt::format("it is not the image after {}", inputs[i - 1].name),
                    as_many ? fmt::format("number {}: each image is a step in time",
                                          number_after(last[differ.empty() ? count / 2 * 2 - 1 : differ.back()]))
                            : "a number in each name, or in none: each image is a step in time");
  }
}

std::unique_ptr<FrameSource> open_frames(const std::vector<std::string>& arguments) {
  return open_inputs(inputs_of(arguments));
}

PairSource::PairSource(const std::vector<std::string>& left, const std::vector<std::string>& right, PairNumbers numbers)
    : numbers_(numbers) {
  const std::vector<Input> left_inputs = inputs_of(left);
  const std::vector<Input> right_inputs = inputs_of(right);
  check_two_cameras(left_inputs, right_inputs);
  if (numbers == PairNumbers::must_agree) check_numbers(left_inputs, right_inputs);
  left_ = open_inputs(left_inputs);
  right_ = open_inputs(right_inputs);
  const auto left_count = left_->count();
  const auto right_count = right_->count();
  if (left_count && right_count && left_count != right_count) {
    const bool left_short = *left_count < *right_count;
    throw FileError(left_short ? left.back() : right.back(), "",
                    fmt::format("{} left images but {} right images", *left_count, *right_count),
                    "one right image for each left image");
  }
}

std::optional<std::size_t> PairSource::count() const {
  const auto left_count = left_->count();
  return left_count ? left_count : right_->count();
}

std::vector<std::string> PairSource::warnings() const {
  auto all = left_->warnings();
  std::ranges::move(right_->warnings(), std::back_inserter(all));
  return all;
}

std::optional<FramePair> PairSource::next() {
  auto left = left_->next();
  auto right = right_->next();
  if (!left && !right) return std::nullopt;
  if (!left || !right) {
    throw FileError(left ? left->name : right->name, "",
                    left ? "there is no right image to it" : "there is no left image to it",
                    "as many left as right images");
  }
  if (numbers_ == PairNumbers::must_agree) check_times(*left, *right);
  if (left->image.width != right->image.width || left->image.height != right->image.height) {
    throw FileError(right->name, "", fmt::format("the image is {}x{} pixels", right->image.width, right->image.height),
                    fmt::format("{}x{} as in {}", left->image.width, left->image.height, left->name));
  }
  if (width_ == 0) {
    first_name_ = left->name;
    width_ = left->image.width;
    height_ = left->image.height;
  } else if (left->image.width != width_ || left->image.height != height_) {
    throw FileError(left->name, "", fmt::format("the image is {}x{} pixels", left->image.width, left->image.height),
                    fmt::format("{}x{} as in {}", width_, height_, first_name_));
  }
  return FramePair{std::move(*left), std::move(*right)};
}

}  // namespace horopter
