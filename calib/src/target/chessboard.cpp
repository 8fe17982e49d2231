// SPDX-License-Identifier: Apache-2.0
// Chessboards: found by OpenCV, their corners fitted as the crossing of two blurred edges.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "target/steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;
using Reason = TargetError::Reason;

struct Board {
  int columns, rows;
  std::vector<Vector2d> corners;  ///< row by row
  const Vector2d& at(int x, int y) const { return corners[static_cast<std::size_t>(y) * columns + x]; }
};

// A search takes seconds where a large image is full of other things. Those that follow the first one, and are in vain
// as a rule, are made in a smaller image.
constexpr int kThoroughSide_px = 640;
constexpr int kOtherSizesSide_px = 400;

/// The image with its longer side at most this long.
cv::Mat reduced(const cv::Mat& grey, int side_px) {
  const double factor = static_cast<double>(side_px) / std::max(grey.cols, grey.rows);
  if (factor >= 1) return grey;
  cv::Mat small;
  cv::resize(grey, small, {}, factor, factor, cv::INTER_AREA);
  return small;
}

/// A board in `small`, at its place in an image of another size.
std::optional<Board> find_board(const cv::Mat& small, cv::Size full, int columns, int rows, bool fast_check) {
  std::vector<cv::Point2f> found;
  const int flags =
      cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | (fast_check ? cv::CALIB_CB_FAST_CHECK : 0);
  if (!cv::findChessboardCorners(small, cv::Size(columns, rows), found, flags)) return std::nullopt;
  Board board{columns, rows, {}};
  for (const cv::Point2f& p : found) {
    board.corners.emplace_back((p.x + 0.5) * full.width / small.cols - 0.5,
                               (p.y + 0.5) * full.height / small.rows - 0.5);
  }
  return board;
}

/// Neighbour steps at a corner, one square along x and y.
std::pair<Vector2d, Vector2d> steps(const Board& board, int x, int y) {
  const int xl = std::max(0, x - 1);
  const int xr = std::min(board.columns - 1, x + 1);
  const int yu = std::max(0, y - 1);
  const int yl = std::min(board.rows - 1, y + 1);
  return {(board.at(xr, y) - board.at(xl, y)) / (xr - xl), (board.at(x, yl) - board.at(x, yu)) / (yl - yu)};
}

/// Grey level of 3×3 pixels; beyond the image its border goes on.
double mean_around(const GreyImage& image, const Vector2d& p) {
  const int x = static_cast<int>(std::lround(p.x()));
  const int y = static_cast<int>(std::lround(p.y()));
  double sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      sum += image(std::clamp(x + dx, 0, image.width - 1), std::clamp(y + dy, 0, image.height - 1));
  return sum / 9;
}

/// Corners that a longer board would have beyond one of its sides.
struct Beyond {
  int crossings = 0;  ///< are corners
  int outside = 0;    ///< lie outside the image, or too near its border
  int places = 0;
};
Beyond look_beyond(const GreyImage& image, const Board& board, int side) {
  Beyond result;
  const bool vertical = side % 2 == 1;
  const int n = vertical ? board.columns : board.rows;
  for (int i = 0; i < n; ++i) {
    const int x = vertical ? i : side == 0 ? 0 : board.columns - 1;
    const int y = vertical ? side == 1 ? 0 : board.rows - 1 : i;
    const auto [along_x, along_y] = steps(board, x, y);
    // Where the next corner of the line would be, by a parabola: squares shrink with distance, and the lens bends.
    const int inward_x = vertical ? 0 : side == 0 ? 1 : -1;
    const int inward_y = !vertical ? 0 : side == 1 ? 1 : -1;
    const Vector2d p =
        3 * board.at(x, y) - 3 * board.at(x + inward_x, y + inward_y) + board.at(x + 2 * inward_x, y + 2 * inward_y);
    const Vector2d outward = p - board.at(x, y);
    ++result.places;
    // All four squares around the place.
    const Vector2d far = p + outward;
    if (far.x() < 0 || far.y() < 0 || far.x() > image.width - 1 || far.y() > image.height - 1) {
      ++result.outside;
      continue;
    }
    // Black and white change at a crossing; at the border of a board three of four squares are white.
    const auto contrast = [&](const Vector2d& at) {
      std::array<double, 4> square{};
      for (int k = 0; k < 4; ++k) {
        const Vector2d middle = at + 0.3 * (k == 0 || k == 3 ? 1 : -1) * along_x + 0.3 * (k < 2 ? 1 : -1) * along_y;
        square[k] = mean_around(image, middle);
      }
      const double across = (square[0] + square[2] - square[1] - square[3]) / 2;
      const double uneven = std::max(std::abs(square[0] - square[2]), std::abs(square[1] - square[3]));
      return uneven < 0.4 * std::abs(across) ? across : 0.0;
    };
    const double here = contrast(board.at(x, y));
    const double there = contrast(p);
    if (here * there < 0 && std::abs(there) > 0.5 * std::abs(here)) ++result.crossings;
  }
  return result;
}

const char* side_name(const Board& board, int side) {
  const Vector2d middle = (board.at(0, 0) + board.at(board.columns - 1, board.rows - 1)) / 2;
  const Vector2d edge =
      side == 0   ? Vector2d((board.at(0, 0) + board.at(0, board.rows - 1)) / 2)
      : side == 1 ? Vector2d((board.at(0, 0) + board.at(board.columns - 1, 0)) / 2)
      : side == 2 ? Vector2d((board.at(board.columns - 1, 0) + board.at(board.columns - 1, board.rows - 1)) / 2)
                  : Vector2d((board.at(0, board.rows - 1) + board.at(board.columns - 1, board.rows - 1)) / 2);
  const Vector2d d = edge - middle;
  if (std::abs(d.x()) > std::abs(d.y())) return d.x() > 0 ? "right" : "left";
  return d.y() > 0 ? "lower" : "upper";
}

std::string size_text(int columns, int rows) { return std::to_string(columns) + "x" + std::to_string(rows); }

/// What else is in the image, for the message.
[[noreturn]] void explain(const cv::Mat& grey, const GreyImage& image, const TargetSpec& spec) {
  const std::string wanted = size_text(spec.columns, spec.rows);
  // Sizes near the one asked for, and shorter ones, as of a board that leaves the image.
  std::vector<cv::Size> sizes;
  for (int c = spec.columns + 3; c >= 3; --c)
    for (int r = spec.rows + 3; r >= 3; --r) {
      const bool near = c >= spec.columns - 2 && r >= spec.rows - 2;
      const bool cut = (c <= spec.columns && r == spec.rows) || (c == spec.columns && r <= spec.rows);
      if ((near || cut) && (c != spec.columns || r != spec.rows)) sizes.emplace_back(c, r);
    }
  const auto unlike = [&](const cv::Size& size) {
    return std::abs(size.width - spec.columns) + std::abs(size.height - spec.rows);
  };
  std::stable_sort(sizes.begin(), sizes.end(),
                   [&](const cv::Size& one, const cv::Size& two) { return unlike(one) < unlike(two); });
  if (cv::checkChessboard(grey, cv::Size(spec.columns, spec.rows))) {
    const cv::Mat small = reduced(grey, kOtherSizesSide_px);
    for (const cv::Size& size : sizes) {
      const auto board = find_board(small, grey.size(), size.width, size.height, true);
      if (!board) continue;
      std::string borders;
      if (size.width <= spec.columns && size.height <= spec.rows)
        for (int side = 0; side < 4; ++side) {
          const Beyond beyond = look_beyond(image, *board, side);
          if (2 * beyond.outside > beyond.places)
            (borders += borders.empty() ? "" : " and ") += side_name(*board, side);
        }
      if (!borders.empty())
        throw TargetError(Reason::partly_outside, "the chessboard is partly outside the image: only " +
                                                      size_text(size.width, size.height) + " of " + wanted +
                                                      " inner corners are seen, next to the " + borders +
                                                      " border of the image");
      throw TargetError(Reason::wrong_size, "wrong pattern size: a chessboard of " +
                                                size_text(size.width, size.height) + " inner corners found, expected " +
                                                wanted);
    }
    throw TargetError(Reason::hidden, "something like a chessboard found, but not " + wanted +
                                          " inner corners: it is partly hidden, outside the image or of another size");
  }
  throw TargetError(Reason::no_target, "no chessboard of " + wanted + " inner corners found");
}

}  // namespace

TargetView detect_chessboard(const cv::Mat& grey, const TargetSpec& spec) {
  if (spec.columns < 3 || spec.rows < 3)
    throw TargetError(Reason::wrong_size, "a chessboard of " + size_text(spec.columns, spec.rows) +
                                              " inner corners cannot be found: at least 3x3 are needed");
  const GreyImage image = grey_image(grey);
  auto found = find_board(grey, grey.size(), spec.columns, spec.rows, true);
  if (!found) {
    found = find_board(reduced(grey, kThoroughSide_px), grey.size(), spec.columns, spec.rows, false);
  }
  if (!found) explain(grey, image, spec);
  Board board = *found;

  // OpenCV may run a row from either end: never mirrored.
  const Vector2d x_step = board.at(board.columns - 1, 0) - board.at(0, 0);
  const Vector2d y_step = board.at(0, board.rows - 1) - board.at(0, 0);
  if (x_step.x() * y_step.y() - x_step.y() * y_step.x() < 0)
    for (int y = 0; y < board.rows; ++y)
      std::reverse(board.corners.begin() + static_cast<long>(y) * board.columns,
                   board.corners.begin() + static_cast<long>(y + 1) * board.columns);

  // Corners; once more where the window was not centred on the result.
  std::vector<double> spacings;
  double sign = 0;
  {
    Board next = board;
    for (int y = 0; y < board.rows; ++y)
      for (int x = 0; x < board.columns; ++x) {
        const auto [along_x, along_y] = steps(board, x, y);
        const double spacing = std::min(along_x.norm(), along_y.norm());
        spacings.push_back((along_x.norm() + along_y.norm()) / 2);
        const Vector2d& guess = board.at(x, y);
        Vector2d& corner = next.corners[static_cast<std::size_t>(y) * board.columns + x];
        double half = std::clamp(0.45 * spacing, 3.0, 8.0);
        const double room =
            std::min({guess.x(), guess.y(), image.width - 1 - guess.x(), image.height - 1 - guess.y()}) - 0.5;
        half = std::min(half, room);
        auto saddle = half < 2 ? std::nullopt : fit_saddle(image, guess, along_x, along_y, half);
        if (saddle && (saddle->position_px - guess).norm() > 0.7)
          saddle = fit_saddle(image, saddle->position_px, along_x, along_y, half);
        if (!saddle || (saddle->position_px - guess).norm() > std::max(2.0, 0.2 * spacing))
          throw TargetError(Reason::hidden, "the chessboard corner near pixel (" +
                                                std::to_string(std::lround(guess.x())) + ", " +
                                                std::to_string(std::lround(guess.y())) + ") cannot be measured");
        corner = saddle->position_px;
        sign += ((x + y) % 2 ? -1 : 1) * saddle->amplitude;
      }
    board = next;
  }

  // A board that goes on is another board.
  int more[4] = {0, 0, 0, 0};
  for (int side = 0; side < 4; ++side) {
    const Beyond beyond = look_beyond(image, board, side);
    if (beyond.crossings > 1 && 2 * beyond.crossings > beyond.places - beyond.outside) more[side] = 1;
  }
  if (more[0] + more[1] + more[2] + more[3] > 0)
    throw TargetError(Reason::wrong_size,
                      "wrong pattern size: the chessboard has more than " + size_text(spec.columns, spec.rows) +
                          " inner corners; it goes on at the " +
                          side_name(board, static_cast<int>(std::max_element(more, more + 4) - more)) + " side");

  TargetView view;
  // The square inside the first corner (towards +x, +y) has the colour of the one outside it, diagonally.
  const auto turn = [&] { std::reverse(board.corners.begin(), board.corners.end()); };
  view.oriented = (spec.columns + spec.rows) % 2 == 1;
  if (view.oriented ? sign > 0 : board.at(board.columns - 1, 0).x() < board.at(0, 0).x()) turn();
  view.target_mm = spec.points_mm();
  view.image_px = board.corners;
  std::nth_element(spacings.begin(), spacings.begin() + spacings.size() / 2, spacings.end());
  view.fiducial_px = spacings[spacings.size() / 2];
  check_order(spec, view.image_px);
  if (const auto fit = fit_plane(view.target_mm, view.image_px, image.width, image.height))
    view.plane_rms_px = fit->rms_px;
  return view;
}

}  // namespace horopter::calib::detail
