// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/calib/random.hpp"

namespace horopter::study {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kSamples = 2;  ///< of a pixel, along each side

struct Paint {
  double grey;       ///< in full light
  double contrast;   ///< standard deviation of the pattern
  double smooth_mm;  ///< size of its smallest blotches
};

Paint paint_of(Coat coat) {
  switch (coat) {
    case Coat::textured:
      return {120, 35, 1.5};
    case Coat::plain:
      return {140, 0, 1};
    case Coat::skin:
      return {165, 3, 2};
    default:
      return {18, 1, 1.5};
  }
}

/// Pattern at a place of a body's surface, of deviation 1: noise in three sizes, the same for the same seed.
class Pattern {
 public:
  Pattern(std::uint64_t seed, double smallest_mm) : seed_(seed), smallest_mm_(smallest_mm) {}

  double at(double u_mm, double v_mm) const {
    constexpr double kLike = 1.73;  // makes the deviation of three sizes together about 1
    double sum = 0;
    double size = smallest_mm_;
    for (std::uint64_t octave = 0; octave < 3; ++octave, size *= 2.5) sum += blotches(u_mm / size, v_mm / size, octave);
    return sum / kLike;
  }

 private:
  double corner(std::int64_t i, std::int64_t j, std::uint64_t octave) const {
    const std::uint64_t place =
        static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U ^ static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4FU;
    const auto bits = calib::mix(calib::mix(seed_ + octave) ^ place) >> 40U;
    return (static_cast<double>(bits) * 0x1p-24 - 0.5) * 3.46;  // deviation 1
  }
  double blotches(double u, double v, std::uint64_t octave) const {
    const double i = std::floor(u), j = std::floor(v);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double a = ease(u - i), b = ease(v - j);
    const auto at = [&](int di, int dj) {
      return corner(static_cast<std::int64_t>(i) + di, static_cast<std::int64_t>(j) + dj, octave);
    };
    // Between corners the deviation is less: brought back to about 1.
    return 1.45 * ((1 - a) * ((1 - b) * at(0, 0) + b * at(0, 1)) + a * ((1 - b) * at(1, 0) + b * at(1, 1)));
  }

  std::uint64_t seed_;
  double smallest_mm_;
};

/// Where the samples of a pixel lie, in pixels from its centre.
Eigen::Vector2d sample_place(int number) {
  const int column = number % kSamples, row = number / kSamples;
  return {(column + 0.5) / kSamples - 0.5, (row + 0.5) / kSamples - 0.5};
}

int reflected(int place, int size) {
  if (size == 1) return 0;
  const int period = 2 * size - 2;
  const int at = ((place % period) + period) % period;
  return at < size ? at : period - at;
}

double sample(const Image& photograph, double x, double y) {
  const double i = std::floor(x), j = std::floor(y);
  const double a = x - i, b = y - j;
  const auto at = [&](int di, int dj) -> double {
    return photograph.at(reflected(static_cast<int>(i) + di, photograph.width),
                         reflected(static_cast<int>(j) + dj, photograph.height));
  };
  return (1 - a) * ((1 - b) * at(0, 0) + b * at(0, 1)) + a * ((1 - b) * at(1, 0) + b * at(1, 1));
}

/// Pixels in which a body may be seen.
struct Box {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< the last two are outside
};

Box seen_in(const calib::Camera& camera, const std::vector<Capsule>& segments) {
  double left = camera.width_px, top = camera.height_px, right = -1, bottom = -1;
  for (const Capsule& segment : segments) {
    for (const Vector3d& end : {segment.from_mm, segment.to_mm}) {
      const Vector3d place = camera.world_to_camera * end;
      const auto pixel = camera.project(end);
      if (!pixel || !(place.z() > 2 * segment.radius_mm)) {
        throw std::invalid_argument("a body that a camera does not see as a whole");
      }
      const double reach = 1.1 * camera.model.fx_px() * segment.radius_mm / (place.z() - segment.radius_mm) + 2;
      left = std::min(left, pixel->x() - reach);
      right = std::max(right, pixel->x() + reach);
      top = std::min(top, pixel->y() - reach);
      bottom = std::max(bottom, pixel->y() + reach);
    }
  }
  // One pixel less than the image: the sights of neighbours are needed.
  return {std::clamp(static_cast<int>(left), 0, camera.width_px - 1),
          std::clamp(static_cast<int>(top), 0, camera.height_px - 1),
          std::clamp(static_cast<int>(right) + 1, 0, camera.width_px - 1),
          std::clamp(static_cast<int>(bottom) + 1, 0, camera.height_px - 1)};
}

}  // namespace

std::string name_of(Coat coat) {
  switch (coat) {
    case Coat::textured:
      return "textured";
    case Coat::plain:
      return "plain";
    case Coat::skin:
      return "skin-coloured";
    default:
      return "black glove";
  }
}

std::vector<Capsule> rod_segments(double diameter_mm, double length_mm) {
  const double radius = diameter_mm / 2;
  const double half = std::max(0.0, length_mm / 2 - radius);
  return {{{-half, 0, -radius}, {half, 0, -radius}, radius}};
}

std::vector<Capsule> hand_segments() {
  constexpr double kPalm = 13, kFinger = 8.5;
  std::vector<Capsule> segments;
  for (const double y : {-28.0, -10.0, 10.0, 28.0}) segments.push_back({{-75, y * 0.8, -kPalm}, {5, y, -kPalm}, kPalm});
  for (const auto& [y, length, spread] :
       {std::array{-30.0, 55.0, -14.0}, {-10.0, 75.0, -5.0}, {10.0, 80.0, 5.0}, {29.0, 70.0, 14.0}}) {
    segments.push_back({{5, y, -kPalm}, {5 + length, y + spread, -kPalm}, kFinger});
  }
  segments.push_back({{-45, 30, -kPalm}, {5, 68, -kPalm}, 10});
  return segments;
}

PlacedBody place(const std::vector<Capsule>& segments, const Vector3d& front_mm, const Eigen::Matrix3d& axes) {
  PlacedBody body{segments, front_mm, axes};
  for (Capsule& segment : body.segments) {
    segment.from_mm = front_mm + axes * segment.from_mm;
    segment.to_mm = front_mm + axes * segment.to_mm;
  }
  return body;
}

WallScene::WallScene(const CameraPair& cameras, const Image& photograph, const Vector3d& point_mm,
                     const Vector3d& normal)
    : cameras_(cameras) {
  const SurfacePtr wall = make_plane(point_mm, normal);
  const Vector3d v_axis = normal.normalized().cross(Vector3d::UnitX()).normalized();
  const Vector3d u_axis = v_axis.cross(normal.normalized()).normalized();
  views_[0].camera = &cameras_.left();
  views_[1].camera = &cameras_.right();
  const double mm_per_px = (point_mm - cameras_.left().world_to_camera.centre()).norm() / cameras_.left().model.fx_px();
  for (std::size_t side = 0; side < 2; ++side) {
    View& view = views_[side];
    const calib::Camera& camera = *view.camera;
    const int width = camera.width_px, height = camera.height_px;
    view.centre_mm = camera.world_to_camera.centre();
    view.sights = Raster<Vector3f>(width, height);
    view.on_wall_mm = Raster<Vector2f>(width, height);
    empty_[side] = Raster<float>(width, height);
    const Eigen::Matrix3d to_world = camera.world_to_camera.rotation.transpose();
    std::vector<Vector3d> sights(static_cast<std::size_t>(width));
    std::vector<Hit> hits(sights.size());
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto seen = camera.model.undistort({x, y});
        if (!seen) throw std::invalid_argument("a pixel that sees nothing");
        sights[static_cast<std::size_t>(x)] = to_world * seen->homogeneous();
      }
      wall->intersect(view.centre_mm, sights, hits);
      for (int x = 0; x < width; ++x) {
        const auto& sight = sights[static_cast<std::size_t>(x)];
        const Vector3d place = view.centre_mm + hits[static_cast<std::size_t>(x)].distance * sight - point_mm;
        if (!place.allFinite()) throw std::invalid_argument("a wall that a camera does not see all over");
        view.sights.at(x, y) = sight.cast<float>();
        const double u = place.dot(u_axis), v = place.dot(v_axis);
        view.on_wall_mm.at(x, y) = Vector2f(static_cast<float>(u), static_cast<float>(v));
        double sum = 0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const Eigen::Vector2d in_pixel = sample_place(i);
          sum += sample(photograph, u / mm_per_px + in_pixel.x() + 0.5 * photograph.width,
                        v / mm_per_px + in_pixel.y() + 0.5 * photograph.height);
        }
        empty_[side].at(x, y) = static_cast<float>(sum / (kSamples * kSamples));
      }
    }
  }
}

WallScene::Views WallScene::lit(const Light& light) const {
  Views result = empty_;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < result[side].values.size(); ++i) {
      const Vector2f& place = views_[side].on_wall_mm.values[i];
      result[side].values[i] *= static_cast<float>(light(place.x(), place.y()));
    }
  }
  return result;
}

WallScene::Views WallScene::with_body(const PlacedBody& body, Coat coat, std::uint64_t seed) const {
  const SurfacePtr surface = make_capsules(body.segments);
  const Paint paint = paint_of(coat);
  const Pattern pattern(seed, paint.smooth_mm);
  const Vector3d lamp = Vector3d(-0.3, -0.6, -1).normalized();
  Views result = empty_;
  std::vector<Vector3d> sights;
  std::vector<Hit> hits;
  for (std::size_t side = 0; side < 2; ++side) {
    const View& view = views_[side];
    const Box box = seen_in(*view.camera, body.segments);
    for (int y = box.top; y < box.bottom; ++y) {
      sights.clear();
      for (int x = box.left; x < box.right; ++x) {
        const Vector3f& sight = view.sights.at(x, y);
        const Vector3f right = view.sights.at(x + 1, y) - sight, below = view.sights.at(x, y + 1) - sight;
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const Vector2f in_pixel = sample_place(i).cast<float>();
          sights.emplace_back((sight + in_pixel.x() * right + in_pixel.y() * below).cast<double>());
        }
      }
      hits.resize(sights.size());
      surface->intersect(view.centre_mm, sights, hits);
      for (int x = box.left; x < box.right; ++x) {
        double sum = 0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const std::size_t n =
              static_cast<std::size_t>(x - box.left) * kSamples * kSamples + static_cast<std::size_t>(i);
          if (!std::isfinite(hits[n].distance)) {
            sum += empty_[side].at(x, y);
            continue;
          }
          const Vector3d place =
              body.axes.transpose() * (view.centre_mm + hits[n].distance * sights[n] - body.front_mm);
          const double light = 0.55 + 0.45 * std::max(0.0, hits[n].normal.dot(lamp));
          const double painted = paint.contrast == 0 ? 0 : paint.contrast * pattern.at(place.x(), place.y());
          sum += std::clamp((paint.grey + painted) * light, 0.0, 255.0);
        }
        result[side].at(x, y) = static_cast<float>(sum / (kSamples * kSamples));
      }
    }
  }
  return result;
}

Image expose(const Raster<float>& view, double noise_grey, std::uint64_t seed, std::uint64_t number) {
  calib::Random random(calib::mix(seed + 0x5CE7E), number);
  Image image(view.width, view.height);
  for (std::size_t i = 0; i < view.values.size(); ++i) {
    const double grey = view.values[i] + noise_grey * random.gaussian();
    image.pixels[i] = static_cast<std::uint8_t>(std::clamp(std::floor(grey + 0.5), 0.0, 255.0));
  }
  return image;
}

}  // namespace horopter::study
