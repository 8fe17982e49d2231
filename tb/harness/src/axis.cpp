// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/axis.hpp"

namespace horopter::tb {

void VideoSource::send(const Image& image, Damage damage) {
  for (unsigned y = 0; y < image.height; ++y) {
    unsigned width = image.width;
    if (y == damage.row) {
      if (damage.kind == Damage::Kind::missing_line) continue;
      if (damage.kind == Damage::Kind::short_line) width -= damage.amount;
      if (damage.kind == Damage::Kind::long_line) width += damage.amount;
    }
    for (unsigned x = 0; x < width; ++x) {
      Beat beat{};
      beat.is_pixel = true;
      beat.data = image.at(x < image.width ? x : image.width - 1, y);
      beat.first = x == 0 && ((y == 0 && damage.kind != Damage::Kind::missing_start) ||
                              (y == damage.row && damage.kind == Damage::Kind::extra_start));
      beat.last = x + 1 == width;
      beats_.push_back(beat);
    }
  }
}

void VideoSource::drive() {
  while (blank_ == 0 && !beats_.empty() && !beats_.front().is_pixel) finish_front();
  if (blank_ > 0) {
    --blank_;
  } else if (!offering_) {
    offering_ = !beats_.empty() && pace_.next();
  }
  *pins_.valid = offering_;
  if (!offering_) return;
  const Beat& beat = beats_.front();
  *pins_.data = beat.data;
  if (pins_.user) *pins_.user = beat.first;
  if (pins_.last) *pins_.last = beat.last;
}

void VideoSource::sample() {
  if (!offering_ || !(*pins_.ready || live_)) return;
  ++(*pins_.ready ? taken_ : lost_);
  offering_ = false;
  finish_front();
}

void VideoSource::finish_front() {
  blank_ = beats_.front().blank_after;
  beats_.pop_front();
}

void VideoSource::reset() {
  beats_.clear();
  blank_ = 0;
  offering_ = false;
  *pins_.valid = 0;
  *pins_.data = 0;
  if (pins_.user) *pins_.user = 0;
  if (pins_.last) *pins_.last = 0;
}

}  // namespace horopter::tb
