// SPDX-License-Identifier: Apache-2.0
// Frames and fields: what the hardware is fed with, and where it lies in the full frame (thesis 7.6, 10.4.3).
#pragma once

namespace horopter {

struct Point {
  double x = 0;
  double y = 0;
};

/// Which rows of the full frame a table is for.
enum class Scan { progressive = 0, even_field = 1, odd_field = 2 };

/// Size of what the hardware is fed with (a frame, or a field), and where it lies in the full frame:
/// y = 2·y_f + parity for fields. Left and right fields of a pair have the same parity.
struct ScanGeometry {
  int width = 0;
  int height = 0;
  Scan scan = Scan::progressive;

  int row_step() const { return scan == Scan::progressive ? 1 : 2; }
  int first_row() const { return scan == Scan::odd_field ? 1 : 0; }
  Point to_frame(Point scanned) const { return {scanned.x, row_step() * scanned.y + first_row()}; }
  Point from_frame(Point frame) const { return {frame.x, (frame.y - first_row()) / row_step()}; }
  /// Whether a place is on the pixels; NaN is not.
  bool holds(Point scanned) const {
    return scanned.x >= 0 && scanned.y >= 0 && scanned.x <= width - 1 && scanned.y <= height - 1;
  }
  friend bool operator==(const ScanGeometry&, const ScanGeometry&) = default;
};

}  // namespace horopter
