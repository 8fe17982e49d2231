// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/table_facts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using hls::table::Facts;
using hls::table::ShiftRange;

constexpr int kFine_px = 4;   // between samples that areas have where the surface may change abruptly
constexpr int kStep_px = 16;  // between those that shifts have
static_assert(kStep_px % kFine_px == 0, "samples are fine samples, too");
static_assert(kStep_px <= 1 << hls::table::area_block_log2, "every block has a sample");
/// Neighbours that differ by more have all pixels between them looked at.
constexpr double kLargestChange = 17.0 / 16;
/// Beyond the largest angle, where nothing is supervised: a pixel on a small radius has a part there.
constexpr double kBeyond_deg = 2;

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
  for (int place = 0; place < size - 1; place += kFine_px) places.push_back(place);
  places.push_back(size - 1);
  return places;
}

constexpr std::size_t kFineInStep = kStep_px / kFine_px;

/// Steps that begin before the last of so many fine samples.
std::size_t steps_of(std::size_t fine) { return std::max<std::size_t>(1, (fine + kFineInStep - 2) / kFineInStep); }

bool areas_differ(double a, double b) { return std::max(a, b) > kLargestChange * std::min(a, b); }

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

bool areas_may_be_true(const MapTable& table, const CameraPair& cameras, double error_px) {
  const Facts& facts = table.facts();
  const ScanGeometry& geometry = table.geometry();
  const int subsample = facts.subsample;
  const auto columns = static_cast<std::size_t>(Facts::blocks(geometry.width / subsample));
  const calib::Camera& left = cameras.left();
  for (int y = 0; y < geometry.height; y += kStep_px) {
    for (int x = 0; x < geometry.width / subsample; x += kStep_px) {
      Point source;
      bool seen = true;
      for (int i = 0; seen && i < subsample; ++i) {
        const auto expanded = table.expand(subsample * x + i, y);
        seen = expanded.has_value();
        if (!seen) break;
        source.x += std::ldexp(static_cast<double>(expanded->x), -MapTable::kFractionBits) / subsample;
        source.y += std::ldexp(static_cast<double>(expanded->y), -MapTable::kFractionBits) / subsample;
      }
      const Point pixel = geometry.to_frame({subsample * x + 0.5 * (subsample - 1), static_cast<double>(y)});
      Matrix2d slope;
      const auto undistorted = left.model.undistort({pixel.x, pixel.y}, &slope);
      if (!seen || !undistorted) continue;
      // The nearest place that the pixel may see.
      double distance = std::numeric_limits<double>::infinity();
      const double norm = undistorted->homogeneous().norm();
      for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {0, 0}}) {
        const auto place =
            cameras.place_mm(pixel, geometry.to_frame({source.x + dx * error_px, source.y + dy * error_px}));
        if (place) distance = std::min(distance, (*place - left.world_to_camera.centre()).norm() / norm);
      }
      if (!std::isfinite(distance)) continue;
      const double least_mm2 =
          distance * distance * std::abs(slope.determinant()) / norm * subsample * geometry.row_step();
      const std::size_t block = static_cast<std::size_t>(y >> hls::table::area_block_log2) * columns +
                                static_cast<std::size_t>(x >> hls::table::area_block_log2);
      constexpr double kCode = 15.0 / 16;  // one code less, for rounding
      if (hls::table::decode_area(facts.areas.at(block)) < kCode * least_mm2) return false;
    }
  }
  return true;
}

/// What is known of the fine samples' areas, and the largest of each block. Areas: 0 where nothing is met.
struct SkinScale::Areas {
  explicit Areas(const SkinScale& scale)
      : scale(scale),
        columns(Facts::blocks(scale.width_)),
        rows(Facts::blocks(scale.height_)),
        blocks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
        fine(scale.directions_.size(), std::numeric_limits<double>::quiet_NaN()) {}

  double add(int x, int y, const Vector3d& direction, double determinant, const Hit& hit) {
    const double facing = std::abs(hit.normal.dot(direction));
    if (!std::isfinite(hit.distance) || !(facing > 0)) return 0;
    // Solid angle |J|/|v|³ of a pixel with z = 1, at the distance t|v|, over the cosine n·v/|v|.
    const double area_mm2 = hit.distance * hit.distance * std::abs(determinant) /
                            std::max(facing, scale.smallest_cosine_ * direction.norm()) * scale.subsample_ *
                            scale.row_step_;
    // A sample at the border of two blocks is the end of the one before, too.
    for (const int to_y : {std::max(0, y - 1), y}) {
      for (const int to_x : {std::max(0, x - 1), x}) {
        double& largest =
            blocks[static_cast<std::size_t>(to_y >> hls::table::area_block_log2) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(to_x >> hls::table::area_block_log2)];
        largest = std::max(largest, area_mm2);
      }
    }
    return area_mm2;
  }

  const SkinScale& scale;
  int columns, rows;  ///< of blocks
  std::vector<double> blocks;
  std::vector<double> fine;  ///< NaN: not looked at
};

SkinScale::SkinScale(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry,
                     const ViewLimits& view)
    : cameras_(std::move(cameras)),
      width_(geometry.width / profile.subsample),
      height_(geometry.height),
      subsample_(profile.subsample),
      row_step_(geometry.row_step()),
      smallest_cosine_(std::cos(std::min(90.0, view.largest_angle_deg + kBeyond_deg) * M_PI / 180)),
      columns_(sample_places(width_)),
      rows_(sample_places(height_)) {
  const calib::Camera& left = cameras_.left();
  const calib::Camera& right = cameras_.right();
  const Vector3d eye = left.world_to_camera.centre();
  const double nearest_mm = (right.world_to_camera.centre() - eye).norm();
  for (const int y : rows_) {
    for (const int x : columns_) {
      const Point pixel = geometry.to_frame({subsample_ * x + 0.5 * (subsample_ - 1), static_cast<double>(y)});
      Sample sample{x, y, directions_.size(), {}, {}, {}};
      const auto undistorted = left.model.undistort({pixel.x, pixel.y}, &sample.slope);
      const Vector3d direction = undistorted
                                     ? Vector3d(left.world_to_camera.rotation.transpose() * undistorted->homogeneous())
                                     : Vector3d(Vector3d::Constant(std::nan("")));
      directions_.push_back(direction);
      determinants_.push_back(undistorted ? sample.slope.determinant() : 0);
      const auto is_step = [](int place, int size) { return place % kStep_px == 0 || place == size - 1; };
      if (!undistorted || !is_step(x, width_) || !is_step(y, height_)) continue;
      sample.farthest = seen_at(right, right.world_to_camera.rotation * direction);
      sample.nearest = seen_at(right, right.world_to_camera * (eye + nearest_mm * direction.normalized()));
      samples_.push_back(sample);
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
  Areas areas(*this);
  facts.shifts = look_at_steps(surface, areas);
  look_at_fine(surface, areas);
  look_between(surface, areas);
  facts.areas.clear();
  if (std::ranges::all_of(areas.blocks, [](double area_mm2) { return area_mm2 == 0; })) return;
  fill_blocks(areas.blocks, areas.columns, areas.rows);
  for (const double area_mm2 : areas.blocks) facts.areas.push_back(hls::table::encode_area(area_mm2));
}

std::optional<ShiftRange> SkinScale::look_at_steps(const Surface& surface, Areas& areas) const {
  std::vector<Vector3d> directions;
  directions.reserve(samples_.size());
  for (const Sample& sample : samples_) directions.push_back(directions_[sample.place]);
  std::vector<Hit> hits(directions.size());
  surface.intersect(cameras_.left().world_to_camera.centre(), directions, hits);
  std::optional<ShiftRange> shifts;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    const double area_mm2 = areas.add(sample.x, sample.y, directions[i], determinants_[sample.place], hits[i]);
    areas.fine[sample.place] = area_mm2;
    if (area_mm2 == 0) continue;
    const auto here = shift_at(sample, directions[i], hits[i]);
    if (!here) continue;
    if (!shifts) shifts.emplace();
    shifts->lowest_px = std::min(shifts->lowest_px, here->lowest_px);
    shifts->highest_px = std::max(shifts->highest_px, here->highest_px);
  }
  return shifts;
}

void SkinScale::look_at_fine(const Surface& surface, Areas& areas) const {
  const std::size_t step_columns = steps_of(columns_.size());
  const std::size_t step_rows = steps_of(rows_.size());
  std::vector<std::uint8_t> wanted(step_columns * step_rows, surface.simple() ? 0 : 1);
  if (surface.simple()) {
    // Within its outline its areas are largest at samples. About the outline the squares beside are wanted, too: it may
    // bulge into them between two samples.
    const auto met = [&](std::size_t column, std::size_t row) {
      return areas.fine[std::min(row * kFineInStep, rows_.size() - 1) * columns_.size() +
                        std::min(column * kFineInStep, columns_.size() - 1)] > 0;
    };
    for (std::size_t row = 0; row < step_rows; ++row) {
      for (std::size_t column = 0; column < step_columns; ++column) {
        const bool first = met(column, row);
        if (first == met(column + 1, row) && first == met(column, row + 1) && first == met(column + 1, row + 1)) {
          continue;
        }
        for (std::size_t r = row - std::min<std::size_t>(row, 1); r <= std::min(row + 1, step_rows - 1); ++r) {
          for (std::size_t c = column - std::min<std::size_t>(column, 1); c <= std::min(column + 1, step_columns - 1);
               ++c) {
            wanted[r * step_columns + c] = 1;
          }
        }
      }
    }
  }
  std::vector<std::size_t> places;
  std::vector<Vector3d> directions;
  std::vector<Hit> hits;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const std::uint8_t* const wanted_here = &wanted[std::min(row / kFineInStep, step_rows - 1) * step_columns];
    places.clear();
    directions.clear();
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      const std::size_t place = row * columns_.size() + column;
      if (!std::isnan(areas.fine[place]) || wanted_here[std::min(column / kFineInStep, step_columns - 1)] == 0) {
        continue;
      }
      places.push_back(place);
      directions.push_back(directions_[place]);
    }
    hits.assign(directions.size(), {});
    surface.intersect(cameras_.left().world_to_camera.centre(), directions, hits);
    for (std::size_t i = 0; i < places.size(); ++i) {
      areas.fine[places[i]] = areas.add(columns_[places[i] - row * columns_.size()], rows_[row], directions[i],
                                        determinants_[places[i]], hits[i]);
    }
  }
}

void SkinScale::look_between(const Surface& surface, Areas& areas) const {
  struct Between {
    int x, y;
    double determinant;
  };
  std::vector<Between> pixels;
  std::vector<Vector3d> directions;
  std::vector<Hit> hits;
  for (std::size_t row = 0; row + 1 < rows_.size(); ++row) {
    pixels.clear();
    directions.clear();
    for (std::size_t column = 0; column + 1 < columns_.size(); ++column) {
      const std::size_t upper = row * columns_.size() + column;
      const std::size_t lower = upper + columns_.size();
      double smallest = std::nan(""), largest = std::nan("");
      for (const std::size_t place : {upper, upper + 1, lower, lower + 1}) {  // NaN counts for neither
        smallest = std::fmin(smallest, areas.fine[place]);
        largest = std::fmax(largest, areas.fine[place]);
      }
      if (!areas_differ(smallest, largest)) continue;
      const double width = columns_[column + 1] - columns_[column];
      const double height = rows_[row + 1] - rows_[row];
      for (int y = rows_[row]; y <= rows_[row + 1]; ++y) {
        for (int x = columns_[column]; x <= columns_[column + 1]; ++x) {
          const double along = (x - columns_[column]) / width;
          const double down = (y - rows_[row]) / height;
          const auto between = [&](const auto& of) -> std::decay_t<decltype(of[upper])> {
            return (1 - down) * ((1 - along) * of[upper] + along * of[upper + 1]) +
                   down * ((1 - along) * of[lower] + along * of[lower + 1]);
          };
          pixels.push_back({x, y, between(determinants_)});
          directions.emplace_back(between(directions_));
        }
      }
    }
    hits.assign(directions.size(), {});
    surface.intersect(cameras_.left().world_to_camera.centre(), directions, hits);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      areas.add(pixels[i].x, pixels[i].y, directions[i], pixels[i].determinant, hits[i]);
    }
  }
}

}  // namespace horopter
