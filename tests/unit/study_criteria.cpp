// SPDX-License-Identifier: Apache-2.0
// Every criterion against its formula in Tables 8.1 and 8.2, written out pixel by pixel; the filters before it; and the
// hardware's stages against plain integers.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "horopter/calib/random.hpp"
#include "horopter/study/criteria.hpp"
#include "horopter/study/filters.hpp"
#include "horopter/study/series.hpp"

using namespace horopter;
using namespace horopter::study;

namespace {

constexpr int kWidth = 37;
constexpr int kHeight = 31;

Image random_image(std::uint64_t seed) {
  Image image(kWidth, kHeight);
  horopter::calib::Random random(seed);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random.next());
  return image;
}

using Window = std::vector<double>;

double mean(const Window& w) {
  double sum = 0;
  for (const double v : w) sum += v;
  return sum / static_cast<double>(w.size());
}
double total(const Window& r, const Window& s, const std::function<double(double, double)>& f) {
  double sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) sum += f(r[i], s[i]);
  return sum;
}
double scale_of(double r, double s) { return (r > 0 && s > 0) || (r < 0 && s < 0) ? r / s : 1; }
double cyclic(double a, double b) {
  const double turn = std::remainder(a - b, 1.0);
  return 360 * std::abs(turn);
}

/// The tables, word by word.
double plain(const std::string& name, const Window& r, const Window& s) {
  const double mr = mean(r);
  const double ms = mean(s);
  const auto product = [](double a, double b) { return a * b; };
  const auto centred = [&](double a, double b) { return (a - mr) * (b - ms); };
  const auto vr = [&] { return total(r, r, [&](double a, double) { return (a - mr) * (a - mr); }); };
  const auto vs = [&] { return total(s, s, [&](double a, double) { return (a - ms) * (a - ms); }); };
  const auto zero_mean = [&](double a, double b) { return (a - mr) - (b - ms); };
  const double q = scale_of(mr, ms);
  const auto squared = [](auto f) { return [f](double a, double b) { return f(a, b) * f(a, b); }; };
  const auto absolute = [](auto f) { return [f](double a, double b) { return std::abs(f(a, b)); }; };
  const auto difference = [](double a, double b) { return a - b; };
  const auto scaled = [q](double a, double b) { return a - q * b; };
  if (name == "NCC") return total(r, s, product) / std::sqrt(total(r, r, product) * total(s, s, product));
  if (name == "ZNCC") return total(r, s, centred) / std::sqrt(vr() * vs());
  if (name == "MOR") return 2 * total(r, s, centred) / (vr() + vs());
  if (name == "NISH" || name == "NISD" || name == "NACK") return total(r, s, product);
  if (name == "CCF") return static_cast<double>(r.size()) / total(r, s, product);
  if (name == "SSD") return total(r, s, squared(difference));
  if (name == "ZSSD") return total(r, s, squared(zero_mean));
  if (name == "LSSD") return total(r, s, squared(scaled));
  if (name == "ZNSSD") return total(r, s, squared(zero_mean)) / std::sqrt(vr() * vs());
  if (name == "SAD") return total(r, s, absolute(difference));
  if (name == "ZSAD") return total(r, s, absolute(zero_mean));
  if (name == "LSAD") return total(r, s, absolute(scaled));
  if (name == "NSAD") {
    const double n = static_cast<double>(r.size());
    return total(r, s, absolute(difference)) / std::sqrt(std::abs(mr * n) * std::abs(ms * n));
  }
  if (name == "DSAD") return total(r, s, cyclic);
  if (name == "DSSD") return total(r, s, squared(cyclic));
  FAIL("no formula for " << name);
  return 0;
}

Window window(const Plane& plane, int x, int y, int kernel) {
  Window result;
  for (int j = -kernel / 2; j <= kernel / 2; ++j)
    for (int i = -kernel / 2; i <= kernel / 2; ++i) result.push_back(plane.at(x + i, y + j));
  return result;
}

std::vector<Preparation> preparations_of(Feature feature) {
  switch (feature) {
    case Feature::direction:
      return {{feature, false}, {feature, true}};
    case Feature::log_sign:
    case Feature::dog_sign:
      return {{feature, false, false, 3}, {feature, false, false, 5.5}};
    case Feature::roberts_sign:
    case Feature::camera:
      return {{feature}};
    default:
      return {{feature, false, false}, {feature, true, false}, {feature, false, true}, {feature, true, true}};
  }
}

}  // namespace

TEST_CASE("every criterion is its formula, to 1e-9") {
  const Image left = random_image(1);
  const Image right = random_image(2);
  REQUIRE(criteria().size() == 18);
  for (const auto& one : criteria()) {
    if (one->feature() == Feature::camera) continue;
    for (const Preparation& preparation : preparations_of(one->feature())) {
      const Plane r = prepare(left, preparation);
      const Plane s = prepare(right, preparation);
      Pair pair(r, s);
      for (const int kernel : {5, 7, 9, 11, 13}) {
        pair.set_kernel(kernel);
        const Plane result = one->compare(pair);
        for (int y = kernel / 2; y < kHeight - kernel / 2; ++y)
          for (int x = kernel / 2; x < kWidth - kernel / 2; ++x) {
            CAPTURE(one->name(), name_of(preparation), kernel, x, y);
            const double expected = plain(one->name(), window(r, x, y, kernel), window(s, x, y, kernel));
            // High-passed grey values may add up to 0: NSAD is infinite then. CCF is where they correlate the wrong way.
            if (std::isinf(expected) || (one->name() == "CCF" && expected < 0)) {
              REQUIRE(std::isinf(result.at(x, y)));
              continue;
            }
            REQUIRE(std::abs(result.at(x, y) - expected) <= 1e-9 * std::abs(expected));
          }
        if (one->name() == "CCF") continue;  // brighter windows are better than equal ones
        // Equal windows are the best there is.
        Pair same(r, r);
        same.set_kernel(kernel);
        const Plane equal = one->compare(same);
        CAPTURE(one->name(), name_of(preparation));
        CHECK(equal.at(kWidth / 2, kHeight / 2) == Approx(one->best(kernel)).margin(1e-6));
      }
    }
  }
}

TEST_CASE("windows without variation or brightness are never a match") {
  const Plane grey(20, 20, 80);
  const Plane black(20, 20, 0);
  for (const char* name : {"ZNCC", "MOR", "ZNSSD"}) {
    Pair pair(grey, grey);
    const double value = criterion(name).compare(pair).at(10, 10);
    CHECK((criterion(name).similarity() ? value == 0 : std::isinf(value)));
  }
  Pair pair(black, grey);
  CHECK(criterion("NCC").compare(pair).at(10, 10) == 0);
  CHECK(std::isinf(criterion("NSAD").compare(pair).at(10, 10)));
  const Plane none = sobel_direction(grey);
  Plane ramp(20, 20);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) ramp.at(x, y) = 3 * x;
  const Plane along = sobel_direction(ramp);
  Pair flat(none, none);
  CHECK(criterion("DSAD").compare(flat).at(10, 10) == 45 * 81);
  Pair half(none, along);
  CHECK(criterion("DSAD").compare(half).at(10, 10) == 90 * 81);
  CHECK_THROWS_WITH(criterion("XYZ"), Catch::Contains("ZNSSD"));
}

TEST_CASE("the hardware's criterion is its stages' arithmetic on whole images") {
  const Image left = random_image(3);
  Image right = random_image(4);
  // Plain integers, from the stages' descriptions.
  const auto directions = [](const Image& image) {
    Plane smooth(kWidth, kHeight);
    for (int y = 1; y < kHeight - 1; ++y)
      for (int x = 1; x < kWidth - 1; ++x) {
        int sum = 8;
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i) sum += (2 - std::abs(i)) * (2 - std::abs(j)) * image.at(x + i, y + j);
        const int rounded = sum / 16;
        smooth.at(x, y) = rounded;
      }
    Plane result(kWidth, kHeight);
    for (int y = 2; y < kHeight - 2; ++y)
      for (int x = 2; x < kWidth - 2; ++x) {
        double gx = 0;
        double gy = 0;
        for (int k = -1; k <= 1; ++k) {
          gx += (2 - std::abs(k)) * (smooth.at(x + 1, y + k) - smooth.at(x - 1, y + k));
          gy += (2 - std::abs(k)) * (smooth.at(x + k, y + 1) - smooth.at(x + k, y - 1));
        }
        result.at(x, y) = std::atan2(gy, gx) * 128 / std::numbers::pi;
      }
    return result;
  };
  const Plane a = directions(left);
  const Plane b = directions(right);
  const Plane r = prepare(left, {Feature::camera});
  const Plane s = prepare(right, {Feature::camera});
  Pair pair(r, s);
  for (const int kernel : {5, 9, 13}) {
    pair.set_kernel(kernel);
    const Plane result = criterion("hardware").compare(pair);
    const int reach = kernel / 2 + 2;
    for (int y = reach; y < kHeight - reach; ++y)
      for (int x = reach; x < kWidth - reach; ++x) {
        // The stage's angle is within 0.45° of the real one before rounding, so a difference within 0.9° + 1/256 turn:
        // at most a step of 8/256 turn more or less.
        double low = 0;
        double high = 0;
        for (int j = -kernel / 2; j <= kernel / 2; ++j)
          for (int i = -kernel / 2; i <= kernel / 2; ++i) {
            const double turn = std::abs(std::remainder(a.at(x + i, y + j) - b.at(x + i, y + j), 256.0));
            low += std::clamp(std::floor((turn - 1.7) / 8), 0.0, 15.0);
            high += std::clamp(std::floor((turn + 1.7) / 8), 0.0, 15.0);
          }
        REQUIRE(result.at(x, y) >= low);
        REQUIRE(result.at(x, y) <= high);
      }
  }
}

TEST_CASE("filters are their definitions") {
  const Plane image = to_plane(random_image(5));
  const int x = 17;
  const int y = 14;
  Window near = window(image, x, y, 3);
  CHECK(highpass(image).at(x, y) == 9 * image.at(x, y) - mean(near) * 9);
  CHECK(lowpass(image).at(x, y) ==
        (near[0] + near[2] + near[6] + near[8] + 2 * (near[1] + near[3] + near[5] + near[7]) + 4 * near[4]) / 16);
  const Plane middle = median(image);
  for (int j = 1; j < kHeight - 1; ++j)
    for (int i = 1; i < kWidth - 1; ++i) {
      near = window(image, i, j, 3);
      std::nth_element(near.begin(), near.begin() + 4, near.end());
      REQUIRE(middle.at(i, j) == near[4]);
    }
  // Eq. 8.7 with the mean of the weights removed.
  for (const double w : {2.0, 5.0}) {
    const int reach = log_reach(w);
    CHECK(reach == (w == 2.0 ? 3 : 8));  // 1.5 w
    double removed = 0;
    const auto weight = [&](int i, int j) {
      const double a = 4.0 * (i * i + j * j) / (w * w);
      return (1 - a) * std::exp(-a);
    };
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) removed += weight(i, j);
    removed /= (2 * reach + 1) * (2 * reach + 1);
    double expected = 0;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) expected += (weight(i, j) - removed) * image.at(x + i, y + j);
    CHECK(log_filter(image, w).at(x, y) == Approx(expected).epsilon(1e-9));
    CHECK(log_sign(image, w).at(x, y) == (expected >= 0 ? 1 : -1));
  }
  const double gx = image.at(x + 1, y - 1) + 2 * image.at(x + 1, y) + image.at(x + 1, y + 1) - image.at(x - 1, y - 1) -
                    2 * image.at(x - 1, y) - image.at(x - 1, y + 1);
  const double gy = image.at(x - 1, y + 1) + 2 * image.at(x, y + 1) + image.at(x + 1, y + 1) - image.at(x - 1, y - 1) -
                    2 * image.at(x, y - 1) - image.at(x + 1, y - 1);
  CHECK(sobel(image).x.at(x, y) == gx);
  CHECK(sobel(image).y.at(x, y) == gy);
  CHECK(sobel_direction(image).at(x, y) == Approx(std::atan2(gy, gx) / (2 * std::numbers::pi)));

  // A Gaussian of a point has its deviation, and keeps the sum.
  Plane point(41, 41);
  point.at(20, 20) = 1;
  const Plane bell = gaussian(point, 2);
  double sum = 0;
  double across = 0;
  double down = 0;
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) {
      sum += bell.at(i, j);
      across += bell.at(i, j) * (i - 20) * (i - 20);
      down += bell.at(i, j) * (j - 20) * (j - 20);
    }
  CHECK(sum == Approx(1));
  CHECK(across == Approx(4).epsilon(0.01));
  CHECK(down == Approx(4).epsilon(0.01));

  // A difference of Gaussians is positive within w/2 of a point, as the Laplacian is.
  const Plane disc = dog_sign(point, 8);
  for (int i = 0; i <= dog_reach(8); ++i) {
    CAPTURE(i);
    if (i != 4) CHECK(disc.at(20 + i, 20) == (i < 4 ? 1 : -1));
    if (i > 4) CHECK(log_sign(point, 8).at(20, 20 + std::min(i, log_reach(8))) == -1);
  }
  // Roberts' gradient against its mean.
  const auto roberts = [&](int i, int j) {
    return std::abs(image.at(i, j) - image.at(i + 1, j + 1)) + std::abs(image.at(i + 1, j) - image.at(i, j + 1));
  };
  double around = 0;
  for (int j = -4; j <= 4; ++j)
    for (int i = -4; i <= 4; ++i) around += roberts(x + i, y + j) / 81;
  CHECK(roberts_sign(image).at(x, y) == (roberts(x, y) > around ? 1 : -1));
}

TEST_CASE("images are prepared in the order low-pass, high-pass or direction") {
  const Image image = random_image(6);
  const Plane grey = to_plane(image);
  CHECK(prepare(image, {}) == grey);
  CHECK(prepare(image, {Feature::camera}) == grey);
  CHECK(prepare(image, {Feature::grey, true}) == lowpass(grey));
  CHECK(prepare(image, {Feature::grey, false, true}) == highpass(grey));
  CHECK(prepare(image, {Feature::grey, true, true}) == highpass(lowpass(grey)));
  CHECK(prepare(image, {Feature::log_sign, false, false, 3}) == log_sign(grey, 3));
  const auto direction_at = [](const Plane& plane) { return sobel_direction(plane).at(17, 14); };
  CHECK(prepare(image, {Feature::direction}).at(17, 14) == direction_at(grey));
  CHECK(prepare(image, {Feature::direction, true}).at(17, 14) == direction_at(lowpass(grey)));
}
