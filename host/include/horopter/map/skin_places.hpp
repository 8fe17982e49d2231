// SPDX-License-Identifier: Apache-2.0
// Where on the skin the pixels of a result look, in mm of the rig's world, by its mapping table and the two cameras.
//
// A table says for each left pixel where the right camera would see the skin. The two lines of sight meet there: so the
// table and its rig are enough, and a skin's file is not needed. What comes out is the skin as the machine watches it; the
// table's error, of at most 1/16 px at 99 % of the pixels, is a small part of the thickness of any skin (±1.5 px).
//
// The areas in the table's header (hls/table_format.hpp) are not used here. A code of theirs has three bits after the
// leading one, and may be 6 % off; it is the mean of 32×32 pixels, and of all that these see, supervised or not. Summed
// over patches of 96×96 pixels of Table 11.1's rig they are 4 % off on planes and 16 % at the edge of a box.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "horopter/map/map.hpp"
#include "horopter/skin/rig_skin.hpp"

namespace horopter {

struct SkinPlace {
  Eigen::Vector3d at_mm;
  Eigen::Vector3d along_mm;  ///< to the next pixel of the row
  Eigen::Vector3d down_mm;   ///< to the pixel below
  /// Of the skin that the pixel sees.
  double area_mm2() const { return along_mm.cross(down_mm).norm(); }
};

/// The places of one table's pixels. They are computed when they are first asked for, so one object is not for several
/// threads at once.
class SkinPlaces {
 public:
  static constexpr int kBlock = 4;  ///< pixels either way

  /// The table must live as long.
  SkinPlaces(const MapTable& table, CameraPair cameras);

  /// Of a pixel of the result (after sub-sampling) with a source; nothing without, or where the lines of sight do not
  /// determine a place. Blocks, from pixel (0, 0) on, are taken for plane.
  std::optional<SkinPlace> at(int x, int y);
  /// Of this pixel alone.
  std::optional<SkinPlace> exactly_at(int x, int y) const;

 private:
  /// In the right image, coordinates of the scan; nothing outside the result, too.
  std::optional<Point> source(int x, int y) const;
  std::optional<Eigen::Vector3d> place_mm(int x, int y) const;
  /// From a pixel into one direction, as far as there are places.
  struct Side {
    int reach;
    Eigen::Vector3d end;
    double bend;  ///< mm
  };
  Side side(int x, int y, int dx, int dy, const Eigen::Vector3d& here) const;
  struct Block {
    enum class Known : std::uint8_t { not_yet, no, yes } known = Known::not_yet;
    int x = 0, y = 0;  ///< the pixel that stands for it
    SkinPlace place;
  };
  void look(int column, int row, Block& block) const;

  const MapTable& table_;
  CameraPair cameras_;
  int width_, height_;  ///< of the result
  int columns_;         ///< blocks in a row
  std::vector<Block> blocks_;
};

}  // namespace horopter
