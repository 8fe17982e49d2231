// SPDX-License-Identifier: Apache-2.0
// Two cameras of a rig before a photograph on a wall, and a body between: images as the cameras would take them, with
// every condition known.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "horopter/calib/camera.hpp"
#include "horopter/image/image.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/surface.hpp"
#include "horopter/study/raster.hpp"

namespace horopter::study {

/// What a body's surface looks like: a picture on it, of the mean 0, and its grey value in full light.
enum class Coat {
  textured,  ///< patterned cloth
  plain,     ///< one colour
  skin,      ///< a hand's: nearly one colour
  glove,     ///< black, nearly without light
};
std::string name_of(Coat coat);
inline constexpr std::array kCoats{Coat::textured, Coat::plain, Coat::skin, Coat::glove};

/// A body at its place in the world. Its front is what is nearest to the cameras.
struct PlacedBody {
  std::vector<Capsule> segments;
  Eigen::Vector3d front_mm{0, 0, 0};
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: along, across, and towards the cameras
};

/// A rod, and the outline of a hand with its fingers spread: along x, across y, the front at z = 0, the rest at z below 0.
std::vector<Capsule> rod_segments(double diameter_mm, double length_mm);
std::vector<Capsule> hand_segments();
/// The same turned and moved, its front at `front_mm`.
PlacedBody place(const std::vector<Capsule>& segments, const Eigen::Vector3d& front_mm, const Eigen::Matrix3d& axes);

/// Light on the wall at a place of it, mm, and on all else: 1 is full.
using Light = std::function<double(double u_mm, double v_mm)>;

class WallScene {
 public:
  /// The photograph lies on the plane, as large that a pixel of it is about one of the cameras; mirrored where it ends.
  WallScene(const CameraPair& cameras, const Image& photograph, const Eigen::Vector3d& point_mm,
            const Eigen::Vector3d& normal);

  using Views = std::array<Raster<float>, 2>;  ///< left, right; grey values without noise
  const Views& empty() const { return empty_; }
  /// The wall in another light.
  Views lit(const Light& light) const;
  /// The body before the wall. `seed` chooses what is painted on it.
  Views with_body(const PlacedBody& body, Coat coat, std::uint64_t seed) const;

 private:
  struct View {
    const calib::Camera* camera = nullptr;
    Eigen::Vector3d centre_mm;
    Raster<Eigen::Vector3f> sights;  ///< of pixels, world, camera z = 1
    Raster<Eigen::Vector2f> on_wall_mm;
  };

  CameraPair cameras_;
  std::array<View, 2> views_;
  Views empty_;
};

/// What a camera makes of it: noise of a standard deviation, and 8 bits.
Image expose(const Raster<float>& view, double noise_grey, std::uint64_t seed, std::uint64_t number);

}  // namespace horopter::study
