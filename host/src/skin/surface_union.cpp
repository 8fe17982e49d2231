// SPDX-License-Identifier: Apache-2.0
// Surfaces made of surfaces.
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kChunk = 128;

class Union : public Surface {
 public:
  explicit Union(std::vector<SurfacePtr> parts) : parts_(std::move(parts)) {
    if (parts_.empty()) throw std::invalid_argument("a union of nothing");
  }

  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    std::array<Hit, kChunk> other;
    for (std::size_t first = 0; first < directions.size(); first += kChunk) {
      const auto chunk = directions.subspan(first, std::min(kChunk, directions.size() - first));
      const auto nearest = hits.subspan(first, chunk.size());
      parts_.front()->intersect(origin, chunk, nearest);
      for (std::size_t part = 1; part < parts_.size(); ++part) {
        parts_[part]->intersect(origin, chunk, std::span(other).first(chunk.size()));
        for (std::size_t i = 0; i < chunk.size(); ++i) {
          if (other[i].distance < nearest[i].distance) nearest[i] = other[i];
        }
      }
    }
  }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    for (const SurfacePtr& part : parts_) part->check_cameras(left, right);
  }

  void extend(Eigen::AlignedBox3d& box) const override {
    for (const SurfacePtr& part : parts_) part->extend(box);
  }

  std::string description() const override {
    std::string text;
    for (const SurfacePtr& part : parts_) text += (text.empty() ? "" : "; ") + part->description();
    return text;
  }

  std::vector<SurfacePtr> parts() const override {
    std::vector<SurfacePtr> all;
    for (const SurfacePtr& part : parts_) {
      const std::vector<SurfacePtr> own = part->parts();
      if (own.empty()) all.push_back(part);
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }

 private:
  std::vector<SurfacePtr> parts_;
};

class Moved : public Surface {
 public:
  Moved(SurfacePtr surface, const calib::Pose& pose) : surface_(std::move(surface)), pose_(pose) {
    if (!pose.rotation.isUnitary(1e-6) || !pose.translation_mm.allFinite()) {
      throw std::invalid_argument("a pose is a rotation and a finite translation");
    }
  }

  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    std::array<Vector3d, kChunk> turned;
    const Vector3d from = pose_.inverse() * origin;
    for (std::size_t first = 0; first < directions.size(); first += kChunk) {
      const std::size_t count = std::min(kChunk, directions.size() - first);
      for (std::size_t i = 0; i < count; ++i) turned[i] = pose_.rotation.transpose() * directions[first + i];
      const auto part = hits.subspan(first, count);
      surface_->intersect(from, std::span(turned).first(count), part);
      for (Hit& hit : part) hit.normal = pose_.rotation * hit.normal;
    }
  }

  bool simple() const override { return surface_->simple(); }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    const calib::Pose back = pose_.inverse();
    surface_->check_cameras(back * left, back * right);
  }

  void extend(Eigen::AlignedBox3d& box) const override {
    Eigen::AlignedBox3d own;
    surface_->extend(own);
    if (!own.sizes().allFinite() || own.isEmpty()) return;  // a plane's ends are on other axes now
    const Vector3d middle = pose_ * own.center();
    const Vector3d reach = pose_.rotation.cwiseAbs() * own.sizes() / 2;
    box.extend(Vector3d(middle - reach));
    box.extend(Vector3d(middle + reach));
  }

  std::string description() const override { return surface_->description() + ", moved"; }

 private:
  SurfacePtr surface_;
  calib::Pose pose_;
};

}  // namespace

SurfacePtr make_union(std::vector<SurfacePtr> surfaces) { return std::make_shared<Union>(std::move(surfaces)); }

SurfacePtr make_moved(SurfacePtr surface, const calib::Pose& pose) {
  return std::make_shared<Moved>(std::move(surface), pose);
}

}  // namespace horopter
