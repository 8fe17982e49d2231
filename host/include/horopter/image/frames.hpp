// SPDX-License-Identifier: Apache-2.0
// Sequences of images: files, globs, directories, videos, cameras.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "horopter/image/image.hpp"

namespace horopter {

/// When an image of a video was taken, as the video says.
struct VideoTime {
  std::size_t index = 0;     ///< from 0, in its video
  double time_s = 0;         ///< since the video's first image
  double period_s = 0;       ///< the video's usual time from image to image
  std::size_t left_out = 0;  ///< images for which there is a hole in time before this one
};

struct NamedImage {
  std::string name;  ///< the file, or the video or camera with the number of the frame: `walk.avi#12`
  Image image;
  std::optional<VideoTime> time = {};  ///< of videos that have one
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// The next image, or nothing after the last. Throws FileError.
  virtual std::optional<NamedImage> next() = 0;
  /// How many images there are in all, if known.
  virtual std::optional<std::size_t> count() const = 0;
  /// A camera: it has no end of its own.
  virtual bool is_live() const { return false; }
  /// What a user must know of the sources, a sentence each: videos in which damage may not be noticed.
  virtual std::vector<std::string> warnings() const { return {}; }
};

/// Each argument is a file (image or video), a glob pattern, a directory (its image files) or the number of a camera. What
/// a pattern or a directory holds comes in the order of its names, numbers in them by their value: img8, img09, img10.
/// Names are checked here, contents when read. Throws FileError for what does not exist, and for a directory with images
/// or videos that are not read, or with links to none.
std::unique_ptr<FrameSource> open_frames(const std::vector<std::string>& arguments);

/// Where the index of an image is its time: numbers in the names of files must rise by one. Of files without numbers
/// nothing is known. Throws FileError, naming the image behind the hole.
void check_consecutive(const std::vector<std::string>& arguments);

struct FramePair {
  NamedImage left;
  NamedImage right;
};

/// What the numbers in the names of two files say: whether the files belong together.
enum class PairNumbers {
  /// A number may differ only where it names the camera: im2 beside im6, cam0_0012 beside cam1_0012. Folders tell
  /// moments, too: m5/left beside m5/right.
  must_agree,
  ignored,  ///< the order alone counts
};

/// Two sources in step. Throws FileError when both are one file or camera, when the numbers in the names of a pair, or the
/// times of two videos by more than half an image, do not agree, when the images of a pair differ in size, when sizes change from pair to pair, or when one source ends before
/// the other.
class PairSource {
 public:
  PairSource(const std::vector<std::string>& left, const std::vector<std::string>& right,
             PairNumbers numbers = PairNumbers::must_agree);
  std::optional<FramePair> next();
  std::optional<std::size_t> count() const;
  bool is_live() const { return left_->is_live() && right_->is_live(); }
  std::vector<std::string> warnings() const;

 private:
  PairNumbers numbers_;
  std::unique_ptr<FrameSource> left_;
  std::unique_ptr<FrameSource> right_;
  std::string first_name_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace horopter
