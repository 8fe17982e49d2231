// SPDX-License-Identifier: Apache-2.0
// files: recorded images, shown at a rate.
#include <filesystem>
#include <thread>
#include <utility>

#include "camera/grabbers.hpp"
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
        frames_(open_frames({pattern_})) {
    // Opened again, or late: where it would be now.
    if (const auto now = Clock::now(); now > begin_) number_ = static_cast<std::uint64_t>((now - begin_) / period_) + 1;
  }

  std::optional<CameraFrame> next(std::chrono::milliseconds patience) override {
    if (!next_ && !ended_) read();
    if (ended_) return std::nullopt;
    const auto due = begin_ + static_cast<Duration::rep>(number_) * period_;
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
  void read() {
    auto image = frames_->next();
    if (!image && repeat_) {
      frames_ = open_frames({pattern_});
      image = frames_->next();
    }
    if (image) {
      if (image->time) number_ += image->time->left_out;  // lost when it was recorded
      next_ = std::move(image->image);
    } else {
      ended_ = true;
    }
  }

  std::string pattern_;
  bool repeat_;
  Duration period_;
  Clock::time_point begin_;
  std::unique_ptr<FrameSource> frames_;
  std::optional<Image> next_;
  std::uint64_t number_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<Grabber> open_files(const std::string& place, const CameraSettings& settings) {
  return std::make_unique<FilesGrabber>((std::filesystem::path(settings.directory) / place).string(), settings);
}

}  // namespace horopter::monitor
