// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/table_facts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using hls::table::Facts;
using hls::table::ShiftRange;

constexpr int kStep_px = 16;  // between samples
static_assert(kStep_px <= 1 << hls::table::area_block_log2, "every block has a sample");

/// Both of two pixels that are one of the result.
[[gnu::always_inline]] inline void join_pixels(const std::uint8_t* here, std::size_t count, std::uint8_t* both) {
  for (std::size_t x = 0; x < count; ++x) both[x] = here[2 * x] & here[2 * x + 1];
}

/// Supervised pixels in each column, up to this row, at most `side`; whether there are so many.
[[gnu::always_inline]] inline void count_down(const std::uint8_t* here, std::size_t count, std::uint8_t side,
                                              std::uint8_t* above, std::uint8_t* whole) {
  for (std::size_t x = 0; x < count; ++x) {
    const auto more = static_cast<std::uint8_t>(above[x] + (above[x] < side ? 1 : 0));
    above[x] = here[x] != 0 ? more : std::uint8_t{0};
    whole[x] = above[x] == side ? 1 : 0;
  }
}

/// Pixels of the result all of whose support, `reach` pixels around them, has a source.
std::uint32_t judgeable_pixels(const Image& supervised, int subsample, int reach) {
  constexpr std::uint64_t kAll = 0x0101010101010101;
  const auto width = static_cast<std::size_t>(supervised.width / subsample);
  const std::size_t words = (width + 7) / 8;
  if (reach > 127) throw std::invalid_argument("windows larger than any stage's");
  const auto side = static_cast<std::uint8_t>(2 * reach + 1);
  std::vector<std::uint8_t> both(width);
  std::vector<std::uint8_t> above(width);
  std::vector<std::uint8_t> whole(8 * words);
  std::uint64_t count = 0;
  for (int y = 0; y < supervised.height; ++y) {
    const std::uint8_t* here = supervised.row(y).data();
    if (subsample == 2) {
      calib::vectorised<join_pixels>(here, width, both.data());
      here = both.data();
    }
    calib::vectorised<count_down>(here, width, side, above.data(), whole.data());
    std::size_t before = 0;  // whole columns in a row, up to this one
    for (std::size_t x = 0; x < 8 * words; x += 8) {
      std::uint64_t eight;
      std::memcpy(&eight, &whole[x], 8);
      if (eight == kAll) {
        count += before + 8 >= side ? std::min<std::size_t>(8, before + 9 - side) : 0;
        before += 8;
      } else if (eight == 0) {
        before = 0;
      } else {
        for (std::size_t i = x; i < x + 8; ++i) {
          before = whole[i] != 0 ? before + 1 : 0;
          count += before >= side ? 1 : 0;
        }
      }
    }
  }
  return static_cast<std::uint32_t>(count);
}

/// 0, the step, twice the step …, and the last pixel.
std::vector<int> sample_places(int size) {
  std::vector<int> places;
  for (int place = 0; place < size - 1; place += kStep_px) places.push_back(place);
  places.push_back(size - 1);
  return places;
}

std::optional<Vector2d> seen_at(const calib::Camera& camera, const Vector3d& in_camera, Matrix2d* lens = nullptr) {
  if (!(in_camera.z() > 0)) return std::nullopt;
  return camera.model.distort(in_camera.head<2>() / in_camera.z(), lens);
}

/// To blocks without an area (0) those of their neighbours, until all have one.
void fill_blocks(std::vector<double>& areas, int columns, int rows) {
  const auto at = [&](int column, int row) -> double& {
    return areas[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  };
  std::vector<double> before;
  while (std::ranges::find(areas, 0.0) != areas.end()) {
    before = areas;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        if (at(column, row) != 0) continue;
        for (int r = std::max(0, row - 1); r <= std::min(row + 1, rows - 1); ++r) {
          for (int c = std::max(0, column - 1); c <= std::min(column + 1, columns - 1); ++c) {
            const auto index =
                static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
            at(column, row) = std::max(at(column, row), before[index]);
          }
        }
      }
    }
  }
}

}  // namespace

Facts facts_of(const MapTable& table, const MachineProfile& profile) {
  const Image supervised = table.supervised(profile.weight_bits);
  Facts facts;
  facts.subsample = profile.subsample;
  // `thesis` judges where all windows are whole, `compete` where its 3×3 low-pass is (stages/planes.hpp).
  if (profile.has_thesis()) {
    facts.judgeable_by_thesis = judgeable_pixels(supervised, profile.subsample, profile.offset());
  }
  if (profile.has_compete()) facts.judgeable_by_compete = judgeable_pixels(supervised, profile.subsample, 1);
  return facts;
}

SkinScale::SkinScale(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry)
    : cameras_(std::move(cameras)),
      width_(geometry.width / profile.subsample),
      height_(geometry.height),
      subsample_(profile.subsample),
      row_step_(geometry.row_step()) {
  const calib::Camera& left = cameras_.left();
  const calib::Camera& right = cameras_.right();
  const Vector3d eye = left.world_to_camera.centre();
  const double nearest_mm = (right.world_to_camera.centre() - eye).norm();
  for (const int y : sample_places(height_)) {
    for (const int x : sample_places(width_)) {
      const Point pixel = geometry.to_frame({subsample_ * x + 0.5 * (subsample_ - 1), static_cast<double>(y)});
      Sample sample{x, y, {}, {}, {}};
      const auto undistorted = left.model.undistort({pixel.x, pixel.y}, &sample.slope);
      if (!undistorted) continue;
      const Vector3d direction = left.world_to_camera.rotation.transpose() * undistorted->homogeneous();
      sample.farthest = seen_at(right, right.world_to_camera.rotation * direction);
      sample.nearest = seen_at(right, right.world_to_camera * (eye + nearest_mm * direction.normalized()));
      samples_.push_back(sample);
      directions_.push_back(direction);
    }
  }
}

std::optional<ShiftRange> SkinScale::shift_at(const Sample& sample, const Vector3d& direction, const Hit& hit) const {
  const calib::Camera& right = cameras_.right();
  const calib::Pose& left_pose = cameras_.left().world_to_camera;
  const Vector3d point = right.world_to_camera * (left_pose.centre() + hit.distance * direction);
  Matrix2d lens;
  const auto source = seen_at(right, point, &lens);
  if (!source) return std::nullopt;
  // The source moves with the left pixel along the row as the skin's tangent plane says: dP = t (dv − v (n·dv)/(n·v)).
  const Vector3d along = left_pose.rotation.transpose() * Vector3d(sample.slope(0, 0), sample.slope(1, 0), 0);
  const Vector3d moves = right.world_to_camera.rotation *
                         (hit.distance * (along - direction * (hit.normal.dot(along) / hit.normal.dot(direction))));
  const Vector2d gradient = lens * (moves.head<2>() - point.head<2>() / point.z() * moves.z()) / point.z();
  const auto shift = [&](const std::optional<Vector2d>& seen) {
    return seen ? (*seen - *source).dot(gradient) / gradient.squaredNorm() / subsample_ : std::nan("");
  };
  double far_px = shift(sample.farthest);
  double near_px = shift(sample.nearest);
  if (std::isnan(far_px) && std::isnan(near_px)) return std::nullopt;
  // What the lens model does not reach lies beyond the image, on the other side.
  if (std::isnan(near_px)) near_px = std::copysign(width_, -far_px);
  if (std::isnan(far_px)) far_px = std::copysign(width_, -near_px);
  // The hypothesis pixel must be in the image.
  const auto [lowest, highest] = std::minmax(near_px, far_px);
  return ShiftRange{static_cast<int>(std::floor(std::clamp<double>(lowest, -sample.x, 0))),
                    static_cast<int>(std::ceil(std::clamp<double>(highest, 0, width_ - 1 - sample.x)))};
}

void SkinScale::measure(const Surface& surface, Facts& facts) const {
  std::vector<Hit> hits(samples_.size());
  surface.intersect(cameras_.left().world_to_camera.centre(), directions_, hits);
  const int columns = Facts::blocks(width_);
  const int rows = Facts::blocks(height_);
  std::vector<double> areas(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));  // the largest
  std::optional<ShiftRange> shifts;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    const double facing = std::abs(hits[i].normal.dot(directions_[i]));
    if (!std::isfinite(hits[i].distance) || !(facing > 0)) continue;
    // Solid angle |J|/|v|³ of a pixel with z = 1, at the distance t|v|, over the cosine n·v/|v|.
    const double area_mm2 =
        hits[i].distance * hits[i].distance * std::abs(sample.slope.determinant()) / facing * subsample_ * row_step_;
    // A sample at the border of two blocks is the end of the one before, too.
    for (const int y : {std::max(0, sample.y - 1), sample.y}) {
      for (const int x : {std::max(0, sample.x - 1), sample.x}) {
        double& largest =
            areas[static_cast<std::size_t>(y >> hls::table::area_block_log2) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(x >> hls::table::area_block_log2)];
        largest = std::max(largest, area_mm2);
      }
    }
    const auto here = shift_at(sample, directions_[i], hits[i]);
    if (!here) continue;
    if (!shifts) shifts.emplace();
    shifts->lowest_px = std::min(shifts->lowest_px, here->lowest_px);
    shifts->highest_px = std::max(shifts->highest_px, here->highest_px);
  }
  facts.shifts = shifts;
  facts.areas.clear();
  if (std::ranges::all_of(areas, [](double area_mm2) { return area_mm2 == 0; })) return;
  fill_blocks(areas, columns, rows);
  for (const double area_mm2 : areas) facts.areas.push_back(hls::table::encode_area(area_mm2));
}

}  // namespace horopter
