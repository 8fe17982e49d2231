// SPDX-License-Identifier: Apache-2.0
// Targets of chapter 6 in simulated images, and the estimators that measure them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "horopter/calib/edge.hpp"
#include "horopter/calib/edge_profile.hpp"

namespace horopter::cli {

/// An estimator as the study names it.
struct Contender {
  std::string name;
  calib::EdgeMethod method;
  calib::EdgeOptions options;
};

/// All methods, the linear one with windows of 9 and of 13 px, and Zernike's with two windows.
std::vector<Contender> contenders();
/// The five of Tables 6.1 and 6.2, in their order.
std::vector<Contender> contenders_of_the_tables();

/// Maximum likelihood knows the blur; nobody else does.
std::unique_ptr<calib::EdgeEstimator> make(const Contender& contender, double blur_px);

struct Corners {
  std::array<Eigen::Vector2d, 4> at;
  bool found = false;
  Eigen::Vector2d centre() const { return (at[0] + at[1] + at[2] + at[3]) / 4; }
};

/// Of a bright square in an image, as simulate_square makes it.
Corners measure_corners(const calib::GreyImage& image, const calib::EdgeEstimator& estimator,
                        const Eigen::Vector2d& centre, double side, double angle_deg, int points_per_edge);

inline constexpr double kSide_px = 64;

/// As a camera makes it: noise of 1 grey level, 8 bits.
calib::Imaging noisy(double blur_px);

}  // namespace horopter::cli
