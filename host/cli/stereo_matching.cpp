// SPDX-License-Identifier: Apache-2.0
#include "stereo_matching.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "horopter/image/mat.hpp"

namespace horopter::cli {
namespace {

/// OpenCV takes multiples of 16. At least 16 px more than the scene needs: where it ends is not known beforehand.
int number_of_disparities(double largest_px) { return (static_cast<int>(std::ceil(largest_px)) + 16 + 15) / 16 * 16; }

/// OpenCV answers no pixel whose farthest partner would lie left of the image, though its own may lie in it.
cv::Mat with_left_border(const Image& image, int columns) {
  cv::Mat wider;
  cv::copyMakeBorder(mat_of(image), wider, 0, 0, columns, 0, cv::BORDER_REPLICATE);
  return wider;
}

Matching match(cv::StereoMatcher& matcher, const Image& left, const Image& right, int runs) {
  Matching result;
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const int border = matcher.getMinDisparity() + matcher.getNumDisparities();
  const cv::Mat wider_left = with_left_border(left, border);
  const cv::Mat wider_right = with_left_border(right, border);
  cv::Mat wider_disparity;
  result.seconds = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    matcher.compute(wider_left, wider_right, wider_disparity);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    result.seconds = std::min(result.seconds, took.count());
  }
  cv::setNumThreads(threads);
  const int none = (matcher.getMinDisparity() - 1) * cv::StereoMatcher::DISP_SCALE;
  const cv::Mat_<short> disparity = wider_disparity.colRange(border, wider_disparity.cols).clone();
  result.disparity_px.reserve(disparity.total());
  for (const auto& value : disparity) {
    result.disparity_px.push_back(value <= none ? std::numeric_limits<float>::quiet_NaN()
                                                : static_cast<float>(value) / float{cv::StereoMatcher::DISP_SCALE});
  }
  result.parameters = {{"minDisparity", matcher.getMinDisparity()},
                       {"numDisparities", matcher.getNumDisparities()},
                       {"blockSize", matcher.getBlockSize()},
                       {"speckleWindowSize", matcher.getSpeckleWindowSize()},
                       {"speckleRange", matcher.getSpeckleRange()},
                       {"disp12MaxDiff", matcher.getDisp12MaxDiff()},
                       {"threads", 1}};
  return result;
}

}  // namespace

Matching match_bm(const Image& left, const Image& right, double largest_px, int runs) {
  const auto matcher = cv::StereoBM::create(number_of_disparities(largest_px), 15);
  matcher->setUniquenessRatio(15);
  matcher->setSpeckleWindowSize(100);
  matcher->setSpeckleRange(2);
  matcher->setDisp12MaxDiff(1);
  Matching result = match(*matcher, left, right, runs);
  result.parameters.update({{"preFilterType", matcher->getPreFilterType()},
                            {"preFilterSize", matcher->getPreFilterSize()},
                            {"preFilterCap", matcher->getPreFilterCap()},
                            {"textureThreshold", matcher->getTextureThreshold()},
                            {"uniquenessRatio", matcher->getUniquenessRatio()}});
  return result;
}

Matching match_sgbm(const Image& left, const Image& right, double largest_px, int runs) {
  constexpr int kBlock = 3;
  const auto matcher = cv::StereoSGBM::create(0, number_of_disparities(largest_px), kBlock, 8 * kBlock * kBlock,
                                              32 * kBlock * kBlock, 1, 63, 10, 100, 2, cv::StereoSGBM::MODE_SGBM);
  Matching result = match(*matcher, left, right, runs);
  result.parameters.update({{"P1", matcher->getP1()},
                            {"P2", matcher->getP2()},
                            {"preFilterCap", matcher->getPreFilterCap()},
                            {"uniquenessRatio", matcher->getUniquenessRatio()},
                            {"mode", "SGBM"}});
  return result;
}

std::vector<Answer> answers_of(const Matching& matching, double disparity_px, double tolerance_px) {
  std::vector<Answer> answers;
  answers.reserve(matching.disparity_px.size());
  for (const float found : matching.disparity_px) {
    answers.push_back(std::isnan(found)                                        ? Answer::undecidable
                      : std::abs(double{found} - disparity_px) <= tolerance_px ? Answer::skin
                                                                               : Answer::clear);
  }
  return answers;
}

}  // namespace horopter::cli
