// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/filters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace horopter::study {
namespace {

/// The image with `reach` more pixels on each side, like its last ones.
Plane extended(const Plane& image, int reach) {
  Plane result(image.width + 2 * reach, image.height + 2 * reach);
  for (int y = 0; y < result.height; ++y) {
    const double* source = image.row(std::clamp(y - reach, 0, image.height - 1));
    double* row = result.row(y);
    std::fill(row, row + reach, source[0]);
    std::copy(source, source + image.width, row + reach);
    std::fill(row + reach + image.width, row + result.width, source[image.width - 1]);
  }
  return result;
}

/// f(p, stride): p[−stride … stride] are the neighbours.
template <class F>
Plane of_neighbours(const Plane& image, F f) {
  const Plane wide = extended(image, 1);
  Plane result(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    const double* source = wide.row(y + 1) + 1;
    double* row = result.row(y);
    for (int x = 0; x < image.width; ++x) row[x] = f(source + x, wide.width);
  }
  return result;
}

double smooth(const double* p, std::ptrdiff_t step) { return p[-step] + 2 * p[0] + p[step]; }

/// Adds weights_y ⊗ weights_x of the image.
void add_separable(Plane& result, const Plane& image, const std::vector<double>& along,
                   const std::vector<double>& down) {
  const int reach = static_cast<int>(along.size() / 2);
  const Plane wide = extended(image, reach);
  Plane rows(image.width, wide.height);
  for (int y = 0; y < wide.height; ++y) {
    double* row = rows.row(y);
    for (std::size_t i = 0; i < along.size(); ++i) {
      const double* source = wide.row(y) + i;
      for (int x = 0; x < image.width; ++x) row[x] += along[i] * source[x];
    }
  }
  for (int y = 0; y < image.height; ++y) {
    double* row = result.row(y);
    for (std::size_t j = 0; j < down.size(); ++j) {
      const double* source = rows.row(y + static_cast<int>(j));
      for (int x = 0; x < image.width; ++x) row[x] += down[j] * source[x];
    }
  }
}

void sort_pair(double& low, double& high) {
  const double smaller = std::min(low, high);
  high = std::max(low, high);
  low = smaller;
}

}  // namespace

Plane to_plane(const Image& image) {
  Plane result(image.width, image.height);
  std::copy(image.pixels.begin(), image.pixels.end(), result.values.begin());
  return result;
}

Plane lowpass(const Plane& image) {
  return of_neighbours(image, [](const double* p, std::ptrdiff_t stride) {
    return (smooth(p - stride, 1) + 2 * smooth(p, 1) + smooth(p + stride, 1)) / 16;
  });
}

Plane highpass(const Plane& image) {
  return of_neighbours(image, [](const double* p, std::ptrdiff_t stride) {
    double sum = 0;
    for (const double* row : {p - stride, p, p + stride}) sum += row[-1] + row[0] + row[1];
    return 9 * p[0] - sum;
  });
}

Plane median(const Plane& image) {
  const Plane wide = extended(image, 1);
  Plane result(image.width, image.height);
  // Columns are sorted once and used three times: the median is that of the largest of the lows, the median of the
  // middles and the smallest of the highs.
  const auto count = static_cast<std::size_t>(wide.width);
  std::vector<double> low(count);
  std::vector<double> middle(count);
  std::vector<double> high(count);
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(wide.row(y), count, low.begin());
    std::copy_n(wide.row(y + 1), count, middle.begin());
    std::copy_n(wide.row(y + 2), count, high.begin());
    for (std::size_t x = 0; x < count; ++x) {
      sort_pair(low[x], middle[x]);
      sort_pair(middle[x], high[x]);
      sort_pair(low[x], middle[x]);
    }
    double* row = result.row(y);
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
      const double lows = std::max(low[x], std::max(low[x + 1], low[x + 2]));
      const double highs = std::min(high[x], std::min(high[x + 1], high[x + 2]));
      const double middles =
          std::max(std::min(middle[x], middle[x + 1]), std::min(std::max(middle[x], middle[x + 1]), middle[x + 2]));
      row[x] = std::max(std::min(lows, highs), std::min(std::max(lows, highs), middles));
    }
  }
  return result;
}

Plane gaussian(const Plane& image, double deviation_px) {
  if (deviation_px <= 0) return image;
  const int reach = static_cast<int>(std::ceil(4 * deviation_px));
  std::vector<double> weights;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    weights.push_back(std::exp(-i * i / (2 * deviation_px * deviation_px)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  Plane result(image.width, image.height);
  add_separable(result, image, weights, weights);
  return result;
}

int log_reach(double w) { return static_cast<int>(std::ceil(1.5 * w)); }

Plane log_filter(const Plane& image, double w) {
  if (!(w >= 1 && w <= 40)) throw std::invalid_argument("log_filter: w is 1 to 40 px");
  const int reach = log_reach(w);
  const auto size = static_cast<std::size_t>(2 * reach + 1);
  // (1 − a − b)·e^(−a)·e^(−b) = (1 − a)e^(−a)·e^(−b) − e^(−a)·b e^(−b)
  std::vector<double> bell(size);
  std::vector<double> rest(size);
  std::vector<double> moment(size);
  double sum_bell = 0;
  double sum_rest = 0;
  double sum_moment = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double offset = static_cast<double>(i) - reach;
    const double a = 4 * offset * offset / (w * w);
    bell[i] = std::exp(-a);
    rest[i] = (1 - a) * bell[i];
    moment[i] = -a * bell[i];
    sum_bell += bell[i];
    sum_rest += rest[i];
    sum_moment += moment[i];
  }
  const double mean = (sum_rest + sum_moment) * sum_bell / static_cast<double>(size * size);
  Plane result(image.width, image.height);
  add_separable(result, image, rest, bell);
  add_separable(result, image, bell, moment);
  add_separable(result, image, std::vector<double>(size, 1), std::vector<double>(size, -mean));
  return result;
}

Plane log_sign(const Plane& image, double w) {
  Plane result = log_filter(image, w);
  for (double& value : result.values) value = value >= 0 ? 1 : -1;
  return result;
}

namespace {

constexpr double kWider = 1.6;  ///< of the wider Gaussian, against the narrower
/// Where both are equal, w/2 from the middle, over the narrower one's deviation.
const double kMiddle = 2 * std::sqrt(2 * kWider * kWider / (kWider * kWider - 1) * std::log(kWider * kWider));

}  // namespace

int dog_reach(double w) { return static_cast<int>(std::ceil(4 * kWider * w / kMiddle)); }

Plane dog_sign(const Plane& image, double w) {
  if (!(w >= 1 && w <= 40)) throw std::invalid_argument("dog_sign: w is 1 to 40 px");
  Plane result = gaussian(image, w / kMiddle);
  const Plane wide = gaussian(image, kWider * w / kMiddle);
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = result.values[i] >= wide.values[i] ? 1 : -1;
  return result;
}

Plane roberts_sign(const Plane& image) {
  constexpr int kNearby = 2 * (kRobertsReach - 1) + 1;
  Plane result = of_neighbours(image, [](const double* p, std::ptrdiff_t stride) {
    return std::abs(p[0] - p[stride + 1]) + std::abs(p[1] - p[stride]);
  });
  const Plane sums = box_sum(result, kNearby);
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = result.values[i] * kNearby * kNearby > sums.values[i] ? 1 : -1;
  return result;
}

Gradient sobel(const Plane& image) {
  return {of_neighbours(image, [](const double* p,
                                  std::ptrdiff_t stride) { return smooth(p + 1, stride) - smooth(p - 1, stride); }),
          of_neighbours(image, [](const double* p, std::ptrdiff_t stride) {
            return smooth(p + stride, 1) - smooth(p - stride, 1);
          })};
}

Plane sobel_direction(const Plane& image) {
  Gradient gradient = sobel(image);
  for (std::size_t i = 0; i < gradient.x.values.size(); ++i) {
    double& x = gradient.x.values[i];
    const double y = gradient.y.values[i];
    x = x == 0 && y == 0 ? std::numeric_limits<double>::quiet_NaN() : std::atan2(y, x) / (2 * std::numbers::pi);
  }
  return std::move(gradient.x);
}

Plane box_sum(const Plane& image, int size) {
  if (size < 1 || size % 2 == 0) throw std::invalid_argument("box_sum: the window's side is odd");
  Plane result(image.width, image.height);
  if (image.width < size || image.height < size) return result;
  const int reach = size / 2;
  std::vector<double> columns(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y) {
    const double* entering = image.row(y);
    if (y < size) {
      for (std::size_t x = 0; x < columns.size(); ++x) columns[x] += entering[x];
    } else {
      const double* leaving = image.row(y - size);
      for (std::size_t x = 0; x < columns.size(); ++x) columns[x] += entering[x] - leaving[x];
    }
    if (y < size - 1) continue;
    double* row = result.row(y - reach);
    double sum = 0;
    for (int x = 0; x < size - 1; ++x) sum += columns[static_cast<std::size_t>(x)];
    for (int x = size - 1; x < image.width; ++x) {
      sum += columns[static_cast<std::size_t>(x)];
      row[x - reach] = sum;
      sum -= columns[static_cast<std::size_t>(x - size + 1)];
    }
  }
  return result;
}

}  // namespace horopter::study
