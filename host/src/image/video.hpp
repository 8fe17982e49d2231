// SPDX-License-Identifier: Apache-2.0
// Images of a video file, by FFmpeg. Its decoders make up what is missing in a damaged file; a monitor must not: whatever
// the reader of the file or the decoder notices is an error.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "horopter/image/frames.hpp"

namespace horopter {

class Video : public FrameSource {
 public:
  /// Throws FileError where the file is no video, or one that this build of FFmpeg does not decode.
  explicit Video(std::string path);
  ~Video() override;
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
  /// Grey, turned as the file tells viewers to turn it. Throws FileError where a packet or an image is damaged, and where
  /// the file ends before the images that it announces.
  std::optional<NamedImage> next() override;
  std::optional<std::size_t> count() const override;
  std::vector<std::string> warnings() const override;

 private:
  struct Decoder;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace horopter
