// SPDX-License-Identifier: Apache-2.0
// Which images of a stream count, by the marks that they have before a decoder sees them.
#pragma once

namespace horopter::monitor {

struct PacketMarks {
  bool gap = false;         ///< something is missing before it, or in it
  bool difference = false;  ///< to images before it
  bool damaged = false;
  bool head = false;  ///< of the stream
};

/// Of images one after the other. What joins an image from parts marks a gap at the image that was begun when it was noticed,
/// so this one may have the hole; and so may the next, which has no mark, where the hole reaches over the border of both.
class Succession {
 public:
  /// Whether it is whole, and so is what it is told by. What comes first begins, although it is always marked as a gap.
  bool counts(const PacketMarks& marks) {
    const bool may_have_hole = begun_ && (marks.gap || gap_before_);
    if (marks.gap) behind_gap_ = true;
    gap_before_ = marks.gap && begun_;
    if (!marks.difference) {
      if (!may_have_hole) behind_gap_ = false;
      begun_ = true;
    }
    if (marks.damaged) {
      behind_gap_ = true;
      return false;
    }
    return !behind_gap_ || (!begun_ && marks.head);
  }

 private:
  bool behind_gap_ = true;   ///< and nothing has come since that stands alone
  bool gap_before_ = false;  ///< at the image before
  bool begun_ = false;       ///< with an image; of some kinds heads come before, as differences
};

}  // namespace horopter::monitor
