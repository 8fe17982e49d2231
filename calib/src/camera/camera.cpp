// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/camera.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "camera/lens_evaluate.hpp"
#include "horopter/calib/error.hpp"
#include "horopter/calib/vectorised.hpp"

namespace horopter::calib {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Matrix3d rotation_from_vector(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle < 1e-300) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Vector3d rotation_to_vector(const Matrix3d& rotation) {
  const Eigen::AngleAxisd angle_axis(rotation);
  return angle_axis.angle() * angle_axis.axis();
}

Vector3d euler_from_rotation_deg(const Matrix3d& r) {
  const double degrees = 180 / M_PI;
  return {degrees * std::atan2(r(2, 1), r(2, 2)), degrees * std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0))),
          degrees * std::atan2(r(1, 0), r(0, 0))};
}

Matrix3d nearest_rotation(const Matrix3d& matrix) {
  const Eigen::JacobiSVD<Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

namespace {

struct LensPlane {
  double unit, unit_x, unit_y, cx, cy;
  double limit;  ///< radius inside of which the map is one to one
};

template <bool kRational, bool kBent>
[[gnu::always_inline]] inline void apply_lens(const LensCoefficients& lens, const LensPlane& plane, const double* x,
                                              const double* y, std::size_t count, PixelBatch& out) {
  for (std::size_t i = 0; i < count; ++i) {
    const double px = x[i] * plane.unit, py = y[i] * plane.unit;
    const LensValue v = lens_value<kRational, kBent>(lens, px, py);
    const bool inside = px * px + py * py < plane.limit * plane.limit;
    out.x[i] = inside ? v.x * plane.unit_x + plane.cx : std::numeric_limits<double>::quiet_NaN();
    out.y[i] = inside ? v.y * plane.unit_y + plane.cy : std::numeric_limits<double>::quiet_NaN();
    out.xx[i] = plane.unit_x * plane.unit * v.xx;
    out.xy[i] = plane.unit_x * plane.unit * v.xy;
    out.yx[i] = plane.unit_y * plane.unit * v.yx;
    out.yy[i] = plane.unit_y * plane.unit * v.yy;
  }
}

/// Newton's method from the undistorted place. Its error squares in each step, times half the map's curvature, which is
/// below 0.01 per pixel in any lens that a sensor is used with: after a step of 0.01 px another changes nothing that
/// matters. Four steps settle what is up to some 50 px off. All of `kRun` take as many steps, of all together where it is
/// 0.
template <bool kRational, bool kBent, std::size_t kRun>
[[gnu::always_inline]] inline void invert_lens(const LensCoefficients& coefficients, const LensPlane& plane,
                                               const double* x, const double* y, std::size_t count, PixelBatch& out) {
  const LensCoefficients lens = coefficients;
  const double unit = plane.unit;
  const double enough = 0.01 / std::max(plane.unit_x, plane.unit_y);
  double px[PixelBatch::kSize], py[PixelBatch::kSize], step[PixelBatch::kSize];
  for (std::size_t i = 0; i < count; ++i) {
    px[i] = x[i] * unit;
    py[i] = y[i] * unit;
  }
  const std::size_t run = kRun == 0 ? count : kRun;
  const auto take_step = [&](std::size_t first) __attribute__((always_inline)) {
    for (std::size_t i = first; i < first + run; ++i) {
      const LensValue v = lens_value<kRational, kBent>(lens, px[i], py[i]);
      const double over = 1 / (v.xx * v.yy - v.xy * v.yx);
      const double off_x = v.x - x[i] * unit, off_y = v.y - y[i] * unit;
      out.xx[i] = over * v.yy;
      out.xy[i] = -over * v.xy;
      out.yx[i] = -over * v.yx;
      out.yy[i] = over * v.xx;
      const double step_x = out.xx[i] * off_x + out.xy[i] * off_y;
      const double step_y = out.yx[i] * off_x + out.yy[i] * off_y;
      px[i] -= step_x;
      py[i] -= step_y;
      step[i] = step_x * step_x + step_y * step_y;
    }
    bool settled = true;
    for (std::size_t i = first; i < first + run; ++i) settled &= !(step[i] >= enough * enough);
    return settled;
  };
  // Run after run in each round: a processor does several at a time.
  std::array<bool, PixelBatch::kSize> settled{};
  bool all = false;
  for (int iteration = 0; iteration < 4 && !all; ++iteration) {
    all = true;
    for (std::size_t first = 0; first < count; first += run) {
      if (!settled[first]) settled[first] = take_step(first);
      all &= settled[first];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    // Inside the disc the map is one to one: this is the inverse.
    const bool good =
        static_cast<bool>((step[i] < enough * enough) & (px[i] * px[i] + py[i] * py[i] < plane.limit * plane.limit));
    out.x[i] = good ? px[i] * plane.unit_x + plane.cx : std::numeric_limits<double>::quiet_NaN();
    out.y[i] = good ? py[i] * plane.unit_y + plane.cy : std::numeric_limits<double>::quiet_NaN();
    out.xx[i] *= plane.unit_x * unit;
    out.xy[i] *= plane.unit_x * unit;
    out.yx[i] *= plane.unit_y * unit;
    out.yy[i] *= plane.unit_y * unit;
  }
}

}  // namespace

CameraModel::CameraModel(const Intrinsics& intrinsics) : intrinsics_(intrinsics) {
  if (const auto* tsai = std::get_if<TsaiIntrinsics>(&intrinsics)) {
    tsai_ = true;
    unit_x_ = tsai->sx / tsai->dx_mm;
    unit_y_ = 1 / tsai->dy_mm;
    unit_ = tsai->f_mm;
    fx_ = tsai->fx_px();
    fy_ = tsai->fy_px();
    cx_ = tsai->cx_px;
    cy_ = tsai->cy_px;
    lens_ = LensMap(tsai->lens());
  } else {
    const auto& brown = std::get<BrownConradyIntrinsics>(intrinsics);
    tsai_ = false;
    unit_x_ = fx_ = brown.fx_px;
    unit_y_ = fy_ = brown.fy_px;
    unit_ = 1;
    cx_ = brown.cx_px;
    cy_ = brown.cy_px;
    lens_ = LensMap(brown.lens);
  }
  const double positive[] = {unit_x_, unit_y_, unit_, fx_, fy_};
  for (const double value : positive) {
    if (!(value > 0 && std::isfinite(value))) {
      throw std::invalid_argument("a camera's focal lengths, pitches and sx must be positive");
    }
  }
  bool finite = std::isfinite(cx_) && std::isfinite(cy_);
  for (const double value : lens_.coefficients().array()) finite = finite && std::isfinite(value);
  if (!finite) throw std::invalid_argument("a camera's parameters must be finite");
}

Matrix3d CameraModel::matrix() const {
  Matrix3d k;
  k << fx_, 0, cx_, 0, fy_, cy_, 0, 0, 1;
  return k;
}

std::optional<Vector2d> CameraModel::undistort(const Vector2d& pixel, Matrix2d* jacobian) const {
  const Vector2d plane((pixel.x() - cx_) / unit_x_, (pixel.y() - cy_) / unit_y_);
  auto value = tsai_ ? lens_.forward(plane, jacobian) : lens_.inverse(plane, jacobian);
  if (!value) return std::nullopt;
  *value /= unit_;
  if (jacobian != nullptr) *jacobian = *jacobian * Vector2d(1 / (unit_x_ * unit_), 1 / (unit_y_ * unit_)).asDiagonal();
  return value;
}

std::optional<Vector2d> CameraModel::distort(const Vector2d& normalised, Matrix2d* jacobian) const {
  const Vector2d plane = normalised * unit_;
  const auto value = tsai_ ? lens_.inverse(plane, jacobian) : lens_.forward(plane, jacobian);
  if (!value) return std::nullopt;
  if (jacobian != nullptr) *jacobian = Vector2d(unit_x_ * unit_, unit_y_ * unit_).asDiagonal() * *jacobian;
  return Vector2d(value->x() * unit_x_ + cx_, value->y() * unit_y_ + cy_);
}

void CameraModel::distort(std::span<const double> x, std::span<const double> y, PixelBatch& pixels) const {
  distort_by<0>(x, y, pixels);
}

void CameraModel::distort_runs(std::span<const double> x, std::span<const double> y, PixelBatch& pixels) const {
  if (x.size() % PixelBatch::kRun != 0) throw std::invalid_argument("no whole number of runs");
  distort_by<PixelBatch::kRun>(x, y, pixels);
}

template <std::size_t kRun>
void CameraModel::distort_by(std::span<const double> x, std::span<const double> y, PixelBatch& pixels) const {
  const LensPlane plane{unit_, unit_x_, unit_y_, cx_, cy_, lens_.limit_radius() * (1 - 1e-6)};
  const LensCoefficients& c = lens_.coefficients();
  const bool rational = c.k4 != 0 || c.k5 != 0 || c.k6 != 0;
  const double* const px = x.data();
  const double* const py = y.data();
  const std::size_t count = x.size();
  const bool bent = c.p1 != 0 || c.p2 != 0 || c.s1 != 0 || c.s2 != 0 || c.s3 != 0 || c.s4 != 0;
  if (tsai_ && rational) vectorised<invert_lens<true, true, kRun>>(c, plane, px, py, count, pixels);
  if (tsai_ && !rational && bent) vectorised<invert_lens<false, true, kRun>>(c, plane, px, py, count, pixels);
  if (tsai_ && !rational && !bent) vectorised<invert_lens<false, false, kRun>>(c, plane, px, py, count, pixels);
  if (!tsai_ && rational) vectorised<apply_lens<true, true>>(c, plane, px, py, count, pixels);
  if (!tsai_ && !rational && bent) vectorised<apply_lens<false, true>>(c, plane, px, py, count, pixels);
  if (!tsai_ && !rational && !bent) vectorised<apply_lens<false, false>>(c, plane, px, py, count, pixels);
  // At the border of the disc, and where the steps had not settled, the careful way decides.
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isnan(pixels.x[i]) || std::isnan(x[i] + y[i])) continue;
    Matrix2d slope;
    const auto pixel = distort({x[i], y[i]}, &slope);
    if (!pixel) continue;
    pixels.x[i] = pixel->x();
    pixels.y[i] = pixel->y();
    pixels.xx[i] = slope(0, 0);
    pixels.xy[i] = slope(0, 1);
    pixels.yx[i] = slope(1, 0);
    pixels.yy[i] = slope(1, 1);
  }
}

std::optional<Vector2d> CameraModel::project(const Vector3d& point) const {
  if (!(point.z() > 0)) return std::nullopt;
  return distort(point.head<2>() / point.z());
}

double CameraModel::limit_radius_px() const {
  const double limit = tsai_ ? lens_.limit_radius_mapped() / unit_ : lens_.limit_radius();
  return limit * fy_;
}

namespace {

/// Least squares of the coefficients in `terms` such that lens_forward(from) = to; the map is linear in them.
LensCoefficients fit_lens(const std::vector<int>& terms, const std::vector<Vector2d>& from,
                          const std::vector<Vector2d>& to) {
  const auto rows = static_cast<Eigen::Index>(2 * from.size());
  Eigen::MatrixXd a(rows, static_cast<Eigen::Index>(terms.size()));
  Eigen::VectorXd b(rows);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    Eigen::Matrix<double, 2, LensCoefficients::kCount> by_coefficients;
    lens_forward({}, from[i], nullptr, &by_coefficients);
    for (std::size_t term = 0; term < terms.size(); ++term) {
      a.block<2, 1>(row, static_cast<Eigen::Index>(term)) = by_coefficients.col(terms[term]);
    }
    b.segment<2>(row) = to[i] - from[i];
  }
  const Eigen::VectorXd scale = a.colwise().norm().cwiseMax(1e-300);
  const Eigen::VectorXd solution =
      (a * scale.cwiseInverse().asDiagonal()).colPivHouseholderQr().solve(b).cwiseQuotient(scale);
  std::array<double, LensCoefficients::kCount> values{};
  for (std::size_t term = 0; term < terms.size(); ++term) {
    values[static_cast<std::size_t>(terms[term])] = solution[static_cast<Eigen::Index>(term)];
  }
  return LensCoefficients::from(values);
}

struct Samples {
  std::vector<Vector2d> pixels;
  std::vector<Vector2d> directions;
};

Samples sample(const CameraModel& model, int width_px, int height_px) {
  if (width_px < 2 || height_px < 2) throw CalibrationError("a conversion of lens models needs the size of the sensor");
  Samples samples;
  constexpr int kColumns = 41, kRows = 31;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const Vector2d pixel((width_px - 1.0) * column / (kColumns - 1), (height_px - 1.0) * row / (kRows - 1));
      const auto direction = model.undistort(pixel);
      if (!direction) {
        throw CalibrationError("the lens model ends inside the image: no direction for pixel (" +
                               std::to_string(pixel.x()) + ", " + std::to_string(pixel.y()) + ")");
      }
      samples.pixels.push_back(pixel);
      samples.directions.push_back(*direction);
    }
  }
  return samples;
}

Conversion judge(Intrinsics intrinsics, const Samples& samples) {
  const CameraModel fitted(intrinsics);
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < samples.pixels.size(); ++i) {
    const auto pixel = fitted.distort(samples.directions[i]);
    const double error = pixel ? (*pixel - samples.pixels[i]).norm() : std::numeric_limits<double>::infinity();
    sum += error * error;
    largest = std::max(largest, error);
  }
  if (!std::isfinite(largest)) throw CalibrationError("the converted lens model does not cover the image");
  return {intrinsics, std::sqrt(sum / static_cast<double>(samples.pixels.size())), largest};
}

}  // namespace

Conversion to_brown_conrady(const CameraModel& model, int width_px, int height_px) {
  if (std::holds_alternative<BrownConradyIntrinsics>(model.intrinsics())) return {model.intrinsics(), 0, 0};
  BrownConradyIntrinsics brown{model.fx_px(), model.fy_px(), model.cx_px(), model.cy_px(), {}};
  if (model.lens().coefficients() == LensCoefficients{}) return {brown, 0, 0};
  const Samples samples = sample(model, width_px, height_px);
  std::vector<Vector2d> distorted;
  distorted.reserve(samples.pixels.size());
  for (const Vector2d& pixel : samples.pixels) {
    distorted.emplace_back((pixel.x() - brown.cx_px) / brown.fx_px, (pixel.y() - brown.cy_px) / brown.fy_px);
  }
  brown.lens = fit_lens({0, 1, 2, 3, 4}, samples.directions, distorted);
  return judge(brown, samples);
}

Conversion to_tsai(const CameraModel& model, int width_px, int height_px, double dx_mm, double dy_mm) {
  if (std::holds_alternative<TsaiIntrinsics>(model.intrinsics())) return {model.intrinsics(), 0, 0};
  TsaiIntrinsics tsai;
  tsai.f_mm = model.fy_px() * dy_mm;
  tsai.dx_mm = dx_mm;
  tsai.dy_mm = dy_mm;
  tsai.sx = model.fx_px() * dx_mm / tsai.f_mm;
  tsai.cx_px = model.cx_px();
  tsai.cy_px = model.cy_px();
  if (model.lens().coefficients() == LensCoefficients{}) return {tsai, 0, 0};
  const Samples samples = sample(model, width_px, height_px);
  std::vector<Vector2d> distorted, undistorted;
  for (std::size_t i = 0; i < samples.pixels.size(); ++i) {
    distorted.emplace_back((samples.pixels[i].x() - tsai.cx_px) * dx_mm / tsai.sx,
                           (samples.pixels[i].y() - tsai.cy_px) * dy_mm);
    undistorted.push_back(samples.directions[i] * tsai.f_mm);
  }
  const LensCoefficients lens = fit_lens({0, 1, 2, 3, 4, 8, 10}, distorted, undistorted);
  tsai.kappa1 = lens.k1;
  tsai.kappa2 = lens.k2;
  tsai.kappa3 = lens.k3;
  tsai.p1 = lens.p2;
  tsai.p2 = lens.p1;
  tsai.s1 = lens.s1;
  tsai.s2 = lens.s3;
  return judge(tsai, samples);
}

}  // namespace horopter::calib
