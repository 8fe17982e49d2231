// SPDX-License-Identifier: Apache-2.0
// files: recorded images, shown at a rate.
#include <filesystem>
#include <string>
#include <thread>
#include <utility>

#include "camera/grabbers.hpp"
#include "horopter/base/error.hpp"
#include "horopter/image/frames.hpp"

namespace horopter::monitor {
namespace {

class FilesGrabber : public Grabber {
 public:
  FilesGrabber(std::string pattern, const CameraSettings& settings)
      : pattern_(std::move(pattern)),
        repeat_(settings.camera.repeat),
        period_(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / settings.frames_per_s))),
        begin_(settings.begin),
        frames_(open_frames({pattern_})) {}

  std::optional<CameraFrame> next(std::chrono::milliseconds patience) override {
    const auto give_up = Clock::now() + patience;
    while (!next_ && !ended_) {
      read();
      if (!next_ && Clock::now() > give_up) return std::nullopt;
    }
    if (ended_) return std::nullopt;
    const auto due = due_of(number_);
    const auto until = std::min(due, Clock::now() + patience);
    std::this_thread::sleep_until(until);
    if (until < due) return std::nullopt;
    CameraFrame frame;
    frame.image = std::move(*std::exchange(next_, std::nullopt));
    frame.number = number_++;
    frame.taken = due.time_since_epoch();
    frame.arrived = Clock::now();
    frame.taken_here = due;
    return frame;
  }
  [[nodiscard]] bool ended() const override { return ended_; }

 private:
  Clock::time_point due_of(std::uint64_t number) const { return begin_ + static_cast<Duration::rep>(number) * period_; }

  /// Opened again, or late, it passes over what would have been shown by now: an image has the same number in each round,
  /// and beside the other camera. Also an image that cannot be read: it would be met each time.
  void read() {
    std::optional<NamedImage> image;
    try {
      image = frames_->next();
    } catch (const FileError& error) {
      // A list goes on behind it. A video may stay there, and say the same again.
      if (in_time_ || due_of(number_) > Clock::now() || error.what() == unreadable_) throw;
      unreadable_ = error.what();
      ++unreadable_images_;
      ++number_;
      return;
    }
    if (!image) {
      if (repeat_ && number_ != round_begin_) {
        begin_again();
      } else {
        ended_ = true;
      }
      return;
    }
    const std::uint64_t left_out = image->time ? image->time->left_out : 0;  // lost when it was recorded
    number_ += left_out - std::min(left_out, unreadable_images_);            // by its time those are left out, too
    unreadable_.clear();
    unreadable_images_ = 0;
    in_time_ = in_time_ || due_of(number_) > Clock::now();
    if (in_time_) {
      next_ = std::move(image->image);
    } else {
      ++number_;
    }
  }

  void begin_again() {
    frames_ = open_frames({pattern_});
    unreadable_images_ = 0;
    const std::uint64_t round = number_ - round_begin_;
    round_begin_ = number_;
    if (in_time_) return;
    const auto now = Clock::now();
    if (now <= due_of(number_)) return;
    const auto late = static_cast<std::uint64_t>((now - due_of(number_)) / period_);
    number_ = round_begin_ += late / round * round;
  }

  std::string pattern_;
  bool repeat_;
  Duration period_;
  Clock::time_point begin_;
  std::unique_ptr<FrameSource> frames_;
  std::optional<Image> next_;
  std::uint64_t number_ = 0, round_begin_ = 0;
  std::string unreadable_;  ///< what the last one's error said, up to the next image
  std::uint64_t unreadable_images_ = 0;
  bool in_time_ = false;  ///< from now on none is passed over
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<Grabber> open_files(const std::string& place, const CameraSettings& settings) {
  return std::make_unique<FilesGrabber>((std::filesystem::path(settings.directory) / place).string(), settings);
}

}  // namespace horopter::monitor
