// SPDX-License-Identifier: Apache-2.0
#include "stereo_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string_view>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/image/mat.hpp"
#include "horopter/machine/device.hpp"

namespace horopter::cli {
namespace {

constexpr double kNoiseSigma = 5;
constexpr std::uint64_t kNoiseSeed = 6;

/// Throws FileError where it makes nothing, or more than an image is.
Image resize_image(const Image& image, double factor, const std::string& file) {
  if (factor == 1) return image;
  constexpr double kSmallestSide = 1, kMostPixels = 1 << 26;
  const double width = image.width * factor, height = image.height * factor;
  if (std::min(width, height) < kSmallestSide || width * height > kMostPixels) {
    throw FileError(file, "", fmt::format("resized by {:g} it is {:.4g}x{:.4g} pixels", factor, width, height),
                    fmt::format("at least {:g} pixel a side, at most {:g} in all", kSmallestSide, kMostPixels));
  }
  Image result(static_cast<int>(std::lround(image.width * factor)),
               static_cast<int>(std::lround(image.height * factor)));
  cv::Mat to = mat_of(result);
  cv::resize(mat_of(image), to, to.size(), 0, 0, factor < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  return result;
}

std::uint8_t clip(double value) { return static_cast<std::uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0)); }

Image with_gain(const Image& image) {
  Image result = image;
  for (auto& g : result.pixels) g = clip(0.5 * g + 40);
  return result;
}

Image with_noise(const Image& image) {
  cv::Mat noise(image.height, image.width, CV_64F);
  cv::RNG random(kNoiseSeed);
  random.fill(noise, cv::RNG::NORMAL, 0, kNoiseSigma);
  Image result = image;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    result.pixels[i] = clip(result.pixels[i] + noise.ptr<double>()[i]);
  }
  return result;
}

Image shifted_vertically(const Image& image) {
  Image result = image;
  for (int y = 0; y + 1 < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) result.at(x, y) = clip(0.5 * (image.at(x, y) + image.at(x, y + 1)));
  }
  return result;
}

struct Change {
  std::string name;
  const char* what;
  Image (*apply)(const Image&);
};

const std::vector<Change>& changes() {
  static const std::vector<Change> all{
      {"none", "as it is", [](const Image& image) { return image; }},
      {"gain", "right image times 0.5, plus 40", with_gain},
      {"noise", "right image with noise, sigma 5 grey levels", with_noise},
      {"vertical", "right image shifted by 0.5 px vertically", shifted_vertically},
  };
  return all;
}

const Change& find_change(const std::string& name) {
  const auto found = std::ranges::find(changes(), name, &Change::name);
  if (found == changes().end()) throw UsageError(fmt::format("no change is named '{}'", name));
  return *found;
}

}  // namespace

std::vector<StereoPairFiles> read_pair_list(const std::string& path) {
  const std::string expected =
      "`name left right disparity scale resize mask`; the last three may be left out, the numbers are positive";
  const auto bytes = read_file(path, "a list of pairs: " + expected);
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  const auto directory = std::filesystem::path(path).parent_path();
  std::vector<StereoPairFiles> pairs;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<std::string> fields;
    for (std::string word; words >> word;) fields.push_back(word);
    if (fields.empty()) continue;
    const std::string place = fmt::format("line {}", number);
    if (fields.size() < 4 || fields.size() > 7) {
      throw FileError(path, place, fmt::format("{} fields", fields.size()), expected);
    }
    const auto factor = [&](std::size_t index) {
      if (index >= fields.size()) return 1.0;
      const std::string& field = fields[index];
      char* end = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      if (end != field.c_str() + field.size() || !std::isfinite(value) || value <= 0) {  // a byte 0 ends no number
        std::string shown = field;
        std::ranges::replace(shown, '\0', '?');
        throw FileError(path, place, fmt::format("'{}'", shown), expected);
      }
      return value;
    };
    const auto file = [&](std::size_t index) { return (directory / fields[index]).string(); };
    pairs.push_back(
        {fields[0], file(1), file(2), file(3), factor(4), factor(5), fields.size() > 6 ? file(6) : std::string()});
  }
  if (pairs.empty()) throw FileError(path, "", "no pair", expected);
  return pairs;
}

namespace {

/// Not 0 where the mask is 255: the masks of public sets have another value where one camera sees.
std::vector<std::uint8_t> load_mask(const std::string& file, const Image& left, const std::string& left_file) {
  Image mask = load_image(file);
  if (mask.width != left.width || mask.height != left.height) {
    throw FileError(file, "", fmt::format("{}x{} pixels", mask.width, mask.height),
                    fmt::format("{}x{}, as {}", left.width, left.height, left_file));
  }
  for (auto& value : mask.pixels) value = value == 255 ? 1 : 0;
  if (std::ranges::count(mask.pixels, 1) == 0) {
    throw FileError(file, "", "no pixel is 255", "a mask: 255 where both cameras see");
  }
  return std::move(mask.pixels);
}

}  // namespace

StereoPair load_pair(const StereoPairFiles& files) {
  const Image left = load_image(files.left);
  const Image right = load_image(files.right);
  const DisparityMap truth = load_disparity(files.disparity, files.scale);
  for (const auto& [file, width, height] :
       {std::tuple(files.right, right.width, right.height), {files.disparity, truth.width, truth.height}}) {
    if (width != left.width || height != left.height) {
      throw FileError(file, "", fmt::format("{}x{} pixels", width, height),
                      fmt::format("{}x{}, as {}", left.width, left.height, files.left));
    }
  }
  const auto wide = std::ranges::find_if(truth.px, [&](float d) { return d >= static_cast<float>(truth.width); });
  if (wide != truth.px.end()) {
    throw FileError(files.disparity, "", fmt::format("with a scale of {:g} a disparity of {:g} px", files.scale, *wide),
                    fmt::format("less than the {} px of the image's width", truth.width));
  }
  const std::vector<std::uint8_t> seen =
      files.mask.empty() ? std::vector<std::uint8_t>() : load_mask(files.mask, left, files.left);
  StereoPair pair{files.name,
                  resize_image(left, files.resize, files.left),
                  resize_image(right, files.resize, files.right),
                  truth,
                  files.left,
                  seen};
  if (files.resize != 1) {
    pair.truth = resized(truth, files.resize, pair.left.width, pair.left.height);
    if (!seen.empty()) {
      const DisparityMap mask{left.width, left.height, {seen.begin(), seen.end()}};
      const DisparityMap small = resized(mask, 1, pair.left.width, pair.left.height);
      pair.seen.assign(small.px.begin(), small.px.end());
    }
  }
  return pair;
}

SkinFile skin_at(double disparity_px, const Image& image) {
  const Point centre{image.width / 2.0, image.height / 2.0};
  SkinFile skin;
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -disparity_px, 0, 1, 0, 0, 0, 1}, centre);
  skin.path = fmt::format("the plane at disparity {:g}", disparity_px);
  return skin;
}

std::vector<Answer> answers_of(const Image& states) {
  std::vector<Answer> answers;
  answers.reserve(states.pixels.size());
  for (const std::uint8_t state : states.pixels) {
    answers.push_back(static_cast<State>(state) == State::skin          ? Answer::skin
                      : static_cast<State>(state) == State::undecidable ? Answer::undecidable
                                                                        : Answer::clear);
  }
  return answers;
}

const std::vector<std::string>& change_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Change& change : changes()) all.push_back(change.name);
    return all;
  }();
  return names;
}

std::string describe_change(const std::string& name) { return find_change(name).what; }

Image changed(const Image& right, const std::string& name) { return find_change(name).apply(right); }

}  // namespace horopter::cli
