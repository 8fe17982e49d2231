// SPDX-License-Identifier: Apache-2.0
// Chessboards: found by OpenCV, their corners fitted as the crossing of two blurred edges.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>

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

// A search takes seconds in a large image that shows many other things. The searches after the first one seldom find a
// board, so they are made in a smaller image.
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

/// Mean grey level of 3×3 pixels. Outside the image, the nearest pixel of its border counts.
double mean_around(const GreyImage& image, const Vector2d& p) {
  const int x = static_cast<int>(std::lround(p.x()));
  const int y = static_cast<int>(std::lround(p.y()));
  double sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      sum += image(std::clamp(x + dx, 0, image.width - 1), std::clamp(y + dy, 0, image.height - 1));
  return sum / 9;
}

/// What is seen at the places where a longer board would have its next row of corners.
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
    const auto along = steps(board, x, y);
    const Vector2d along_x = along.first;
    const Vector2d along_y = along.second;
    // The next corner of the line, by a parabola through three: squares shrink with distance, and the lens bends lines.
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

/// Sizes near the one asked for, and shorter ones, as of a board that leaves the image; the most alike first.
std::vector<cv::Size> other_sizes(const TargetSpec& spec) {
  std::vector<cv::Size> sizes;
  for (int c = spec.columns + 3; c >= 3; --c)
    for (int r = spec.rows + 3; r >= 3; --r) {
      const bool near = c >= spec.columns - 2 && r >= spec.rows - 2;
      const bool cut = (c <= spec.columns && r == spec.rows) || (c == spec.columns && r <= spec.rows);
      if ((near || cut) && (c != spec.columns || r != spec.rows)) sizes.emplace_back(c, r);
    }
  const auto rank = [&](const cv::Size& size) {
    const int unlike = std::abs(size.width - spec.columns) + std::abs(size.height - spec.rows);
    return std::tuple(unlike, -size.width, -size.height);
  };
  std::ranges::sort(sizes, {}, rank);
  return sizes;
}

/// The sides on which more than half of the places beyond a board lie outside the image, as "left and upper".
std::string borders_beside(const GreyImage& image, const Board& board) {
  std::string borders;
  for (int side = 0; side < 4; ++side) {
    const Beyond beyond = look_beyond(image, board, side);
    if (2 * beyond.outside > beyond.places) (borders += borders.empty() ? "" : " and ") += side_name(board, side);
  }
  return borders;
}

/// Throws TargetError that says what else is in the image.
[[noreturn]] void explain(const cv::Mat& grey, const GreyImage& image, const TargetSpec& spec) {
  const std::string wanted = size_text(spec.columns, spec.rows);
  if (!cv::checkChessboard(grey, cv::Size(spec.columns, spec.rows)))
    throw TargetError(Reason::no_target, "no chessboard of " + wanted + " inner corners found");
  const cv::Mat small = reduced(grey, kOtherSizesSide_px);
  for (const cv::Size& size : other_sizes(spec)) {
    const auto board = find_board(small, grey.size(), size.width, size.height, true);
    if (!board) continue;
    const std::string found = size_text(size.width, size.height);
    const bool smaller = size.width <= spec.columns && size.height <= spec.rows;
    if (const std::string borders = smaller ? borders_beside(image, *board) : ""; !borders.empty())
      throw TargetError(Reason::partly_outside, "the chessboard is partly outside the image: only " + found + " of " +
                                                    wanted + " inner corners are seen, next to the " + borders +
                                                    " border of the image");
    throw TargetError(Reason::wrong_size,
                      "wrong pattern size: a chessboard of " + found + " inner corners found, expected " + wanted);
  }
  throw TargetError(Reason::hidden, "something like a chessboard found, but not " + wanted +
                                        " inner corners: it is partly hidden, outside the image or of another size");
}

Board find_first_guess(const cv::Mat& grey, const GreyImage& image, const TargetSpec& spec) {
  auto found = find_board(grey, grey.size(), spec.columns, spec.rows, true);
  if (!found) found = find_board(reduced(grey, kThoroughSide_px), grey.size(), spec.columns, spec.rows, false);
  if (!found) explain(grey, image, spec);
  return *found;
}

/// OpenCV may start rows at either end. Afterwards they run as on the print, which is never mirrored.
void unmirror(Board& board) {
  const Vector2d x_step = board.at(board.columns - 1, 0) - board.at(0, 0);
  const Vector2d y_step = board.at(0, board.rows - 1) - board.at(0, 0);
  if (x_step.x() * y_step.y() - x_step.y() * y_step.x() >= 0) return;
  for (int y = 0; y < board.rows; ++y)
    std::reverse(board.corners.begin() + static_cast<long>(y) * board.columns,
                 board.corners.begin() + static_cast<long>(y + 1) * board.columns);
}

/// The corner near a guess. When it is far from the guess, it is measured again in a window around it. Throws
/// TargetError.
Saddle measure_corner(const GreyImage& image, const Vector2d& guess, const Vector2d& along_x, const Vector2d& along_y) {
  const double spacing = std::min(along_x.norm(), along_y.norm());
  const double room = std::min({guess.x(), guess.y(), image.width - 1 - guess.x(), image.height - 1 - guess.y()}) - 0.5;
  const double half = std::min(std::clamp(0.45 * spacing, 3.0, 8.0), room);
  auto saddle = half < 2 ? std::nullopt : fit_saddle(image, guess, along_x, along_y, half);
  if (saddle && (saddle->position_px - guess).norm() > 0.7)
    saddle = fit_saddle(image, saddle->position_px, along_x, along_y, half);
  if (!saddle || (saddle->position_px - guess).norm() > std::max(2.0, 0.2 * spacing))
    throw TargetError(Reason::hidden, "the chessboard corner near pixel (" + std::to_string(std::lround(guess.x())) +
                                          ", " + std::to_string(std::lround(guess.y())) + ") cannot be measured");
  return *saddle;
}

/// A board with its corners measured.
struct MeasuredBoard {
  Board board;
  double median_side_px = 0;
  bool white_first = false;  ///< the square between the first corner and its neighbours is white
};

MeasuredBoard measure(const GreyImage& image, const Board& guess) {
  MeasuredBoard result{guess};
  std::vector<double> sides;
  double white = 0;
  for (int y = 0; y < guess.rows; ++y)
    for (int x = 0; x < guess.columns; ++x) {
      const auto [along_x, along_y] = steps(guess, x, y);
      sides.push_back((along_x.norm() + along_y.norm()) / 2);
      const Saddle saddle = measure_corner(image, guess.at(x, y), along_x, along_y);
      result.board.corners[static_cast<std::size_t>(y) * guess.columns + x] = saddle.position_px;
      white += ((x + y) % 2 ? -1 : 1) * saddle.amplitude;
    }
  result.white_first = white > 0;
  std::nth_element(sides.begin(), sides.begin() + sides.size() / 2, sides.end());
  result.median_side_px = sides[sides.size() / 2];
  return result;
}

/// Throws TargetError when the board goes on beyond one of its sides: it is another board then.
void check_ends(const GreyImage& image, const Board& board) {
  for (int side = 0; side < 4; ++side) {
    const Beyond beyond = look_beyond(image, board, side);
    if (beyond.crossings > 1 && 2 * beyond.crossings > beyond.places - beyond.outside)
      throw TargetError(Reason::wrong_size,
                        "wrong pattern size: the chessboard has more than " + size_text(board.columns, board.rows) +
                            " inner corners; it goes on at the " + side_name(board, side) + " side");
  }
}

}  // namespace

TargetView detect_chessboard(const cv::Mat& grey, const TargetSpec& spec) {
  if (spec.columns < 3 || spec.rows < 3)
    throw TargetError(Reason::wrong_size, "a chessboard of " + size_text(spec.columns, spec.rows) +
                                              " inner corners cannot be found: at least 3x3 are needed");
  const GreyImage image = grey_image(grey);
  Board guess = find_first_guess(grey, image, spec);
  unmirror(guess);
  auto [board, median_side_px, white_first] = measure(image, guess);
  check_ends(image, board);

  TargetView view;
  // The square inside the first corner (towards +x, +y) has the colour of the one outside it, diagonally.
  view.oriented = (spec.columns + spec.rows) % 2 == 1;
  const bool to_the_left = board.at(board.columns - 1, 0).x() < board.at(0, 0).x();
  if (view.oriented ? white_first : to_the_left) std::reverse(board.corners.begin(), board.corners.end());
  view.target_mm = spec.points_mm();
  view.image_px = board.corners;
  view.fiducial_px = median_side_px;
  check_order(spec, view.image_px);
  if (const auto fit = fit_plane(view.target_mm, view.image_px, image.width, image.height))
    view.plane_rms_px = fit->rms_px;
  return view;
}

}  // namespace horopter::calib::detail
