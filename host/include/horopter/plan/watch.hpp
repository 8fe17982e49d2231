// SPDX-License-Identifier: Apache-2.0
// Which places of a skin two cameras watch, and where a protected zone can be entered past them (E2; thesis 11.1,
// Fig. 11.4).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// Whether an object that crosses a skin at a place is seen, or why it is not.
enum class Sight : std::uint8_t {
  seen,
  no_skin,        ///< it crosses no skin at all
  outside_left,   ///< the left image does not show the place
  outside_right,  ///< nor the right one
  angle,          ///< too far from the skin's normal (11.2.2)
  scale,          ///< reduced to less than 1/2 in the right image (7.5)
  row,            ///< an epipolar line leaves the row: `ViewLimits::largest_shift_px`
  hidden,         ///< another part of the skin stands before it
  obstacle,       ///< an obstacle stands before it
  border,         ///< a pixel of the windows around it is one of those above
};
inline constexpr int kSightCount = 10;
/// As in reports: a word for programs, and a phrase for people.
std::string_view sight_name(Sight sight);
std::string_view sight_text(Sight sight);

/// The places of a skin that a profile's machine decides about: in both images with the whole support of their pixel.
class Watch {
 public:
  /// `obstacles` stand before the skin; null without. Throws std::invalid_argument where the cameras cannot watch it.
  Watch(CameraPair cameras, SurfacePtr skin, SurfacePtr obstacles, const MachineProfile& profile,
        const ScanGeometry& geometry, const ViewLimits& limits = {});

  const CameraPair& cameras() const { return cameras_; }
  const Surface& skin() const { return *skin_; }
  const Surface* obstacles() const { return obstacles_.get(); }
  /// Around all places of the skin that both images show, within the limits.
  const Eigen::AlignedBox3d& field_mm() const { return field_mm_; }
  int width() const { return width_; }    ///< of the result, pixels
  int height() const { return height_; }  ///< rows
  /// Of a pixel of the result, whose line of sight meets the skin or not.
  Sight pixel(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }
  /// Of a place on the skin. All pixels of the result around it must be seen.
  Sight at(const Eigen::Vector3d& place_mm) const;

 private:
  CameraPair cameras_;
  SurfacePtr skin_;
  SurfacePtr obstacles_;
  ScanGeometry geometry_;
  int subsample_, width_, height_;
  Eigen::AlignedBox3d field_mm_;
  std::vector<Sight> pixels_;
};

/// Places through which the zone is entered, side by side.
struct Opening {
  Eigen::AlignedBox3d box_mm;  ///< around the places
  std::int64_t places = 0;
  Sight reason = Sight::no_skin;  ///< of most of them
};

struct EntryPlan {
  double step_mm = 0;
  /// An opening as wide as this has an edge of the lattice through it, however it slants. One along the diagonal of the
  /// lattice's squares needs the most: √3 steps.
  double surely_found_mm() const { return 1.75 * step_mm; }
  Eigen::AlignedBox3d space_mm;               ///< that was searched
  std::vector<Eigen::Vector3d> zone_mm;       ///< where the lattice meets the zone's surface
  std::vector<Eigen::Vector3d> obstacles_mm;  ///< and obstacles
  std::vector<Eigen::Vector3d> unseen_mm;     ///< of these, reached without being seen; empty: no entry
  std::vector<Opening> openings;              ///< largest first
  /// A shortest way into the largest opening, from where people are.
  std::vector<Eigen::Vector3d> path_mm;

  /// Where ways meet the skin, for drawings.
  struct Mark {
    Eigen::Vector3d place_mm;
    Sight sight = Sight::seen;
  };
  std::vector<Mark> skin;
};

struct EntrySearch {
  double step_mm = 0;    ///< of the lattice; 0: 1/64 of the longest side
  double margin_mm = 0;  ///< around the space; 0: 1/8 of the longest side, at least 3 steps
  /// Where people are; without it everywhere at the border of the space around zone, skin and its field, and obstacles.
  std::optional<Eigen::Vector3d> from_mm = {};
};

/// Floods the space around a zone on a lattice: a step is seen when it crosses the skin at a place that is seen,
/// impossible when it crosses an obstacle, and an entry when it crosses the zone's surface unseen. The zone may be the
/// skin itself. Throws std::invalid_argument for a zone without ends, and for a lattice of more than 10 million points;
/// UsageError where people are in the zone, or have no place beside obstacles.
EntryPlan plan_entries(const Watch& watch, const Surface& zone, const EntrySearch& search = {});

}  // namespace horopter
