// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "horopter/calib/homography.hpp"
#include "horopter/calib/target.hpp"
#include "target/steps.hpp"

namespace horopter::calib {
namespace {

using detail::GridCell;
using detail::PlaneFit;
using detail::PlaneView;
using detail::Quad;
using detail::size_text;
using Eigen::Vector2d;
using Reason = TargetError::Reason;

std::string count_of(std::size_t n, const char* what) {
  return (n == 0 ? "no" : std::to_string(n)) + " " + what + (n == 1 ? "" : "s");
}

const char* kind_text(TargetKind kind) {
  return kind == TargetKind::squares ? "squares" : kind == TargetKind::diamonds ? "diamonds" : "chessboard corners";
}

cv::Mat grey8(const cv::Mat& image) {
  if (image.empty()) throw TargetError(Reason::bad_image, "the image is empty");
  if (image.depth() != CV_8U) throw TargetError(Reason::bad_image, "the image has not 8 bits a sample");
  if (image.cols < 32 || image.rows < 32)
    throw TargetError(Reason::bad_image,
                      "the image is only " + size_text(image.cols, image.rows) + " pixels; at least 32x32 are needed");
  cv::Mat grey;
  if (image.channels() == 1) return image;
  if (image.channels() == 3)
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  else if (image.channels() == 4)
    cv::cvtColor(image, grey, cv::COLOR_BGRA2GRAY);
  else
    throw TargetError(Reason::bad_image, "the image has " + std::to_string(image.channels()) + " channels");
  return grey;
}

/// Corners of one fiducial, by lines through sub-pixel points of its sides.
struct Refined {
  std::array<Vector2d, 4> corners;
  double contrast;  ///< inside minus outside
  double rms_px;
};

class Refiner {
 public:
  Refiner(const GreyImage& image, const TargetOptions& options, double gap_over_side)
      : image_(image), options_(options), gap_over_side_(gap_over_side) {}

  /// Corners clockwise in the image. `view` straightens; may be null. Nothing when a side is not there.
  std::optional<Refined> refine(const std::array<Vector2d, 4>& corners, bool bright, const PlaneView* view) {
    std::array<Line, 4> lines;
    Refined result{corners, 0, 0};
    double shortest = 1e9;
    for (int i = 0; i < 4; ++i) shortest = std::min(shortest, (corners[(i + 1) % 4] - corners[i]).norm());
    const EdgeEstimator& estimator = estimator_for(shortest);
    for (int i = 0; i < 4; ++i) {
      const Vector2d& a = corners[i];
      const Vector2d& b = corners[(i + 1) % 4];
      const double length = (b - a).norm();
      const Vector2d inward = Vector2d(a.y() - b.y(), b.x() - a.x()) / length;
      const double margin = std::min(estimator.reach_px(), 0.35 * length);
      const int count = options_.points_per_edge > 0 ? options_.points_per_edge
                                                     : std::clamp(static_cast<int>(length - 2 * margin) + 1, 4, 48);
      const auto points = edge_points(image_, estimator, a, b, bright ? inward : Vector2d(-inward), count, margin);
      if (points.size() < 3 || points.size() * 10 < static_cast<std::size_t>(count) * 6) return std::nullopt;
      std::vector<Vector2d> straight;
      for (const EdgePoint& point : points) {
        straight.push_back(view ? view->undistort(point.position_px) : point.position_px);
        result.contrast += (bright ? 1 : -1) * point.contrast / (4.0 * static_cast<double>(points.size()));
      }
      const auto line = fit_line(straight);
      if (!line) return std::nullopt;
      lines[i] = *line;
      result.rms_px += line->rms_px * line->rms_px / 4;
    }
    for (int i = 0; i < 4; ++i) {
      const auto corner = intersect(lines[(i + 3) % 4], lines[i]);
      if (!corner) return std::nullopt;
      result.corners[i] = view ? view->distort(*corner) : *corner;
      if (!((result.corners[i] - corners[i]).norm() < std::max(2.5, 0.2 * shortest))) return std::nullopt;
    }
    result.rms_px = std::sqrt(result.rms_px);
    return result;
  }

 private:
  const EdgeEstimator& estimator_for(double side_px) {
    const bool fixed = options_.method == EdgeMethod::tabatabai_2d;
    const int smallest = fixed || options_.method == EdgeMethod::gaussian ? 9 : 5;
    int window = fixed || options_.method == EdgeMethod::zernike_9 ? 9 : 13;
    // Over 40 % of a side, the window must reach neither a corner nor the next fiducial.
    while (window > smallest && (side_px < (window + 3) / 0.6 || side_px * gap_over_side_ < window / 2.0 + 2))
      window -= 2;
    auto& estimator = estimators_[window];
    if (!estimator) {
      EdgeOptions edge;
      edge.window_px = window;
      edge.two_windows = options_.two_windows;
      estimator = make_edge_estimator(options_.method, edge);
    }
    return *estimator;
  }

  const GreyImage& image_;
  const TargetOptions& options_;
  double gap_over_side_;
  std::map<int, std::unique_ptr<EdgeEstimator>> estimators_;
};

/// The fiducials that were found, by their place in a grid: whole numbers x and y, in pitches. From x to y it is a
/// quarter turn clockwise in the image. Which corner of the grid is the first one of the spec is not yet known.
class Grid {
 public:
  using Place = std::pair<int, int>;  // y, x
  struct Fiducial {
    std::array<Vector2d, 4> corners;  ///< the spec's order, in the frame of the grid
  };

  Grid(const cv::Mat& grey, const TargetSpec& spec, const TargetOptions& options)
      : image_(grey_image(grey)),
        spec_(spec),
        refiner_(image_, options,
                 (spec.kind == TargetKind::diamonds ? spec.pitch_mm / std::sqrt(2.0) : spec.pitch_mm) / spec.side_mm -
                     (spec.kind == TargetKind::diamonds ? 0.5 : 1.0)) {
    for (const Vector2d& corner : TargetSpec{spec.kind, 1, 1, spec.side_mm, spec.pitch_mm}.points_mm())
      template_.push_back((corner - Vector2d(spec.box_mm() / 2, -spec.box_mm() / 2)) / spec.pitch_mm);
  }
  Grid(const Grid&) = delete;  // refiner_ refers to image_
  Grid& operator=(const Grid&) = delete;

  void take(const std::vector<Quad>& quads, const std::vector<GridCell>& cells) {
    bright_ = quads[cells.front().quad].contrast > 0;
    for (const GridCell& cell : cells) {
      const Quad& quad = quads[cell.quad];
      std::array<Vector2d, 4> corners;
      for (int i = 0; i < 4; ++i) corners[i] = quad.corners[(cell.first + i) % 4];
      rough_[{cell.y, cell.x}] = corners;
      if (const auto refined = refiner_.refine(corners, bright_, nullptr))
        fiducials_[{cell.y, cell.x}] = {refined->corners};
    }
    drop_misfits();
  }

  std::size_t size() const { return fiducials_.size(); }
  bool bright() const { return bright_; }

  struct Extent {
    int x0, y0, x1, y1;
    int columns() const { return x1 - x0 + 1; }
    int rows() const { return y1 - y0 + 1; }
  };
  Extent extent() const {
    Extent e{1 << 20, 1 << 20, -(1 << 20), -(1 << 20)};
    for (const auto& [place, fiducial] : fiducials_) {
      e.x0 = std::min(e.x0, place.second);
      e.x1 = std::max(e.x1, place.second);
      e.y0 = std::min(e.y0, place.first);
      e.y1 = std::max(e.y1, place.first);
    }
    return e;
  }

  /// Fits the plane to the fiducials that were found. False when they do not determine it.
  bool fit() {
    const auto [plane, pixels] = all_corners();
    auto fitted = detail::fit_plane(plane, pixels, image_.width, image_.height);
    if (!fitted) return false;
    plane_ = std::move(*fitted);
    return true;
  }

  /// Looks for fiducials at the places where the plane expects more of them: in the gaps of the grid, and in the rows
  /// and columns beside it.
  void complete() {
    for (int round = 0; round < 400; ++round) {
      if (!fit()) return;
      const Extent e = extent();
      bool added = false;
      for (int y = e.y0; y <= e.y1; ++y)
        for (int x = e.x0; x <= e.x1; ++x) added |= !has(x, y) && recover(x, y);
      const auto side = [&](int x, int y, int dx, int dy, int n) {
        int found = 0;
        std::vector<Place> new_ones;
        for (int i = 0; i < n; ++i)
          if (recover(x + i * dx, y + i * dy)) {
            ++found;
            new_ones.emplace_back(y + i * dy, x + i * dx);
          }
        // One thing beside the target may look like a fiducial by chance. Half a row of them does not.
        if (2 * found <= n)
          for (const Place& place : new_ones) fiducials_.erase(place);
        else
          added = true;
      };
      side(e.x0 - 1, e.y0, 0, 1, e.rows());
      side(e.x1 + 1, e.y0, 0, 1, e.rows());
      side(e.x0, e.y0 - 1, 1, 0, e.columns());
      side(e.x0, e.y1 + 1, 1, 0, e.columns());
      if (!added) return;
    }
  }

  bool has(int x, int y) const { return fiducials_.count({y, x}) > 0; }
  const Fiducial& at(int x, int y) const { return fiducials_.at({y, x}); }

  /// Whether all of a fiducial at this place would lie in the image.
  bool inside(int x, int y) const {
    for (const Vector2d& corner : predicted(x, y))
      if (!corner.allFinite() || corner.x() < 2 || corner.y() < 2 || corner.x() > image_.width - 3 ||
          corner.y() > image_.height - 3)
        return false;
    return true;
  }
  /// The same for a row of n places, from (x, y) in steps of (dx, dy).
  bool inside(int x, int y, int dx, int dy, int n) const {
    for (int i = 0; i < n; ++i)
      if (!inside(x + i * dx, y + i * dy)) return false;
    return true;
  }

  /// Blooming and ink move the edges of all fiducials outwards or inwards. Finds by how much, and moves the corners
  /// back. Returns the displacement along x and y of the image, px.
  Vector2d settle() {
    const auto [plane, pixels] = all_corners();
    std::vector<detail::Spread> spreads;
    for (const auto& [place, fiducial] : fiducials_)
      for (int i = 0; i < 4; ++i) {
        // The corner is where the sides before and after it meet. Both of them move.
        const Vector2d before = (fiducial.corners[i] - fiducial.corners[(i + 3) % 4]).normalized();
        const Vector2d after = (fiducial.corners[(i + 1) % 4] - fiducial.corners[i]).normalized();
        const Vector2d n1(before.y(), -before.x());
        const Vector2d n2(after.y(), -after.x());
        Eigen::Matrix2d normals;
        normals << n1.transpose(), n2.transpose();
        detail::Spread moves;
        moves << n1.x() * n1.x(), 2 * n1.x() * n1.y(), n1.y() * n1.y(), n2.x() * n2.x(), 2 * n2.x() * n2.y(),
            n2.y() * n2.y();
        spreads.push_back(normals.inverse() * moves);
      }
    const auto fitted = detail::fit_plane(plane, pixels, image_.width, image_.height, spreads);
    if (!fitted) return {0, 0};
    std::size_t i = 0;
    for (auto& [place, fiducial] : fiducials_)
      for (Vector2d& corner : fiducial.corners) corner -= spreads[i++] * fitted->spread;
    fit();
    return {fitted->spread[0], fitted->spread[2]};
  }

  /// Measures all corners once more, along sides that are straightened by the distortion found so far.
  void polish() {
    for (int pass = 0; pass < 2; ++pass) {
      if (!fit()) return;
      for (auto& [place, fiducial] : fiducials_)
        if (const auto refined = refiner_.refine(fiducial.corners, bright_, &plane_.view))
          fiducial.corners = refined->corners;
    }
    fit();
  }

  /// Whether the fiducial has a hole: the background shows in its middle.
  bool marked(int x, int y) const {
    const PlaneView& view = plane_.view;
    const Vector2d middle(x, y);
    const double side = spec_.side_mm / spec_.pitch_mm;
    const auto mean = [&](double radius) {
      double sum = 0;
      for (int i = 0; i < 8; ++i) {
        const double angle = i * 3.14159265358979 / 4;
        sum += sample(view.project(middle + radius * Vector2d(std::cos(angle), std::sin(angle)))) / 8;
      }
      return sum;
    };
    double outside = 0;
    for (const Vector2d& corner : template_) outside += sample(view.project(middle + 1.25 * corner)) / 4;
    const double inside = mean(0.36 * side);
    const double core = (sample(view.project(middle)) + mean(0.04 * side)) / 2;
    return (core - outside) / (inside - outside) < 0.6 && (inside > outside) == bright_;
  }

  const PlaneFit& plane() const { return plane_; }
  /// Image direction of the grid's x at the middle of the target.
  Eigen::Matrix2d directions() const {
    const Extent e = extent();
    return plane_.view.jacobian(Vector2d((e.x0 + e.x1) / 2.0, (e.y0 + e.y1) / 2.0));
  }
  const GreyImage& image() const { return image_; }

 private:
  struct Corners {
    std::vector<Vector2d> plane;  ///< in pitches
    std::vector<Vector2d> pixels;
  };
  Corners all_corners() const {
    Corners corners;
    for (const auto& [place, fiducial] : fiducials_)
      for (int i = 0; i < 4; ++i) {
        corners.plane.push_back(Vector2d(place.second, place.first) + template_[i]);
        corners.pixels.push_back(fiducial.corners[i]);
      }
    return corners;
  }

  std::array<Vector2d, 4> predicted(int x, int y) const {
    std::array<Vector2d, 4> corners;
    for (int i = 0; i < 4; ++i) corners[i] = plane_.view.project(Vector2d(x, y) + template_[i]);
    return corners;
  }

  double sample(const Vector2d& p) const {
    const int x = std::clamp(static_cast<int>(std::lround(p.x())), 0, image_.width - 1);
    const int y = std::clamp(static_cast<int>(std::lround(p.y())), 0, image_.height - 1);
    return image_(x, y);
  }

  bool recover(int x, int y) {
    if (has(x, y) || !inside(x, y)) return false;
    const auto refined = refiner_.refine(predicted(x, y), bright_, nullptr);
    if (!refined || std::abs(refined->contrast) < 10 || refined->rms_px > 0.7) return false;
    fiducials_[{y, x}] = {refined->corners};
    return true;
  }

  /// Quads that joined the grid by chance do not fit its plane.
  void drop_misfits() {
    for (int round = 0; round < 10 && fiducials_.size() > 6 && fit(); ++round) {
      std::vector<double> sorted = plane_.residual_px;
      std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
      const double limit = std::max(2.5, 8 * sorted[sorted.size() / 2]);
      std::size_t i = 0;
      std::optional<Place> worst;
      double worst_residual = limit;
      for (const auto& entry : fiducials_)
        for (int k = 0; k < 4; ++k, ++i)
          if (plane_.residual_px[i] > worst_residual) {
            worst_residual = plane_.residual_px[i];
            worst = entry.first;
          }
      if (!worst) return;
      fiducials_.erase(*worst);
    }
  }

  GreyImage image_;
  TargetSpec spec_;
  Refiner refiner_;
  bool bright_ = false;
  std::vector<Vector2d> template_;  ///< corners in pitches from the middle of a fiducial
  std::map<Place, std::array<Vector2d, 4>> rough_;
  std::map<Place, Fiducial> fiducials_;
  PlaneFit plane_;  ///< the last that could be fitted
};

[[noreturn]] void no_target(const std::vector<Quad>& quads, std::size_t largest, const TargetSpec& spec) {
  std::string message = "no grid of " + size_text(spec.columns, spec.rows) + " " + kind_text(spec.kind) + " found: ";
  message += quads.empty() ? "nothing in the image looks like a fiducial"
                           : count_of(quads.size(), "quadrilateral") + ", of which " +
                                 (largest < 2 ? "none are" : std::to_string(largest) + " are") +
                                 " neighbours at the given side and pitch";
  const TargetKind other = spec.kind == TargetKind::squares ? TargetKind::diamonds : TargetKind::squares;
  for (const auto& [kind, ratio] : {std::pair{other, spec.pitch_mm / spec.side_mm},
                                    {TargetKind::squares, 1.5},
                                    {TargetKind::squares, 2.0},
                                    {TargetKind::diamonds, 2.0},
                                    {TargetKind::diamonds, 2.8}}) {
    const std::size_t n = detail::link_grid(quads, kind, ratio).size();
    if (n < 6 || n < 2 * largest) continue;
    message += "; " + std::to_string(n) + " of them are " + kind_text(kind) + " at a pitch of about " +
               (std::abs(ratio - 1.5) < 1e-9   ? "1.5"
                : std::abs(ratio - 2) < 1e-9   ? "2"
                : std::abs(ratio - 2.8) < 1e-9 ? "2.8"
                                               : "the given number of") +
               " sides";
    break;
  }
  throw TargetError(Reason::no_target, message);
}

/// The place in the grid of column x and row y, counted from the top left of the grid after it was turned by `quarter`
/// quarter turns.
std::pair<int, int> turned(const Grid::Extent& e, int quarter, int x, int y) {
  switch (quarter) {
    case 0:
      return {e.x0 + x, e.y0 + y};
    case 1:
      return {e.x1 - y, e.y0 + x};  // new x is the old y, new y is minus the old x
    case 2:
      return {e.x1 - x, e.y1 - y};
    default:
      return {e.x0 + y, e.y1 - x};
  }
}

/// The borders of the image beside which the grid would go on, as "left and upper".
std::string borders_beside(const Grid& grid) {
  const Grid::Extent e = grid.extent();
  // The frame of the grid may be turned against the image: what lies beside it is named in the image.
  const auto name = [](const Vector2d& direction) {
    if (std::abs(direction.x()) > std::abs(direction.y())) return direction.x() > 0 ? "right" : "left";
    return direction.y() > 0 ? "lower" : "upper";
  };
  std::string borders;
  const auto look = [&](bool whole, const Vector2d& direction) {
    if (!whole) borders += (borders.empty() ? "" : " and ") + std::string(name(direction));
  };
  const Eigen::Matrix2d d = grid.directions();
  look(grid.inside(e.x0 - 1, e.y0, 0, 1, e.rows()), -d.col(0));
  look(grid.inside(e.x1 + 1, e.y0, 0, 1, e.rows()), d.col(0));
  look(grid.inside(e.x0, e.y0 - 1, 1, 0, e.columns()), -d.col(1));
  look(grid.inside(e.x0, e.y1 + 1, 1, 0, e.columns()), d.col(1));
  return borders;
}

[[noreturn]] void wrong_extent(const Grid& grid, const TargetSpec& spec) {
  const int w = grid.extent().columns();
  const int h = grid.extent().rows();
  const auto within = [&](int c, int r) { return w <= c && h <= r; };
  const std::string wanted = size_text(spec.columns, spec.rows);
  const std::string found = size_text(w, h) + " " + kind_text(spec.kind);
  if (within(spec.columns, spec.rows) || within(spec.rows, spec.columns))
    if (const std::string borders = borders_beside(grid); !borders.empty())
      throw TargetError(Reason::partly_outside, "the target is partly outside the image: only " + found + " of " +
                                                    wanted + " are seen, next to the " + borders +
                                                    " border of the image");
  throw TargetError(Reason::wrong_size, "wrong pattern size: found " + found + ", expected " + wanted);
}

/// Throws TargetError unless the grid has the size of the spec and no fiducial is missing.
void check_extent(const Grid& grid, const TargetSpec& spec) {
  const Grid::Extent e = grid.extent();
  const auto fits = [&](int c, int r) { return e.columns() == c && e.rows() == r; };
  if (!fits(spec.columns, spec.rows) && !fits(spec.rows, spec.columns)) wrong_extent(grid, spec);
  std::size_t missing = 0;
  std::string first;
  for (int y = e.y0; y <= e.y1; ++y)
    for (int x = e.x0; x <= e.x1; ++x) {
      if (grid.has(x, y) || missing++ > 0) continue;
      const Vector2d p = grid.plane().view.project(Vector2d(x, y));
      first = "(" + std::to_string(std::lround(p.x())) + ", " + std::to_string(std::lround(p.y())) + ")";
    }
  if (missing > 0)
    throw TargetError(Reason::hidden, count_of(missing, "fiducial") + " of " + size_text(spec.columns, spec.rows) +
                                          " hidden or damaged, the first at pixel " + first);
}

}  // namespace

GreyImage grey_image(const cv::Mat& image) {
  const cv::Mat grey = grey8(image);
  GreyImage result(grey.cols, grey.rows);
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 0; x < grey.cols; ++x) result(x, y) = grey.at<std::uint8_t>(y, x);
  return result;
}

namespace {

/// Fills the grid with the fiducials of the image, all of them and measured. Throws TargetError.
void fill(Grid& grid, const cv::Mat& grey, const TargetSpec& spec) {
  const std::vector<Quad> quads = detail::find_quads(grey);
  const std::vector<GridCell> cells = detail::link_grid(quads, spec.kind, spec.pitch_mm / spec.side_mm);
  if (cells.size() < 4) no_target(quads, cells.size(), spec);
  grid.take(quads, cells);
  if (grid.size() < 4) no_target(quads, cells.size(), spec);
  grid.complete();
  if (!grid.fit()) no_target(quads, cells.size(), spec);
  check_extent(grid, spec);
  grid.polish();
}

/// Quarter turns of the grid's frame in which the target has as many columns and rows as it should.
std::vector<int> possible_quarters(const Grid::Extent& e, const TargetSpec& spec) {
  std::vector<int> quarters;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const bool across = quarter % 2 == 1;
    if ((across ? e.rows() : e.columns()) == spec.columns && (across ? e.columns() : e.rows()) == spec.rows)
      quarters.push_back(quarter);
  }
  return quarters;
}

/// The corner fiducials of the grid that have a hole: places x, y.
std::vector<std::pair<int, int>> holes_of(const Grid& grid) {
  const Grid::Extent e = grid.extent();
  std::vector<std::pair<int, int>> holes;
  for (const int y : {e.y0, e.y1})
    for (const int x : {e.x0, e.x1})
      if (grid.marked(x, y)) holes.emplace_back(x, y);
  return holes;
}

/// The quarter turn that points x most to the right in the image. When two are equal, because x is upright in both, the
/// one that points x down.
int rightmost(const std::vector<int>& quarters, const Eigen::Matrix2d& directions) {
  const auto score = [&](int quarter) {
    const Vector2d x = directions.col(quarter % 2) * (quarter >= 2 ? -1 : 1);
    return x.x() + 1e-6 * x.y();
  };
  return *std::ranges::max_element(quarters, {}, score);
}

/// How the target is turned in the frame of the grid, and whether its print says so. Throws TargetError when the hole
/// says that the image is mirrored.
struct Orientation {
  int quarter = 0;
  bool known = false;
};
Orientation orient(const Grid& grid, const TargetSpec& spec) {
  const Grid::Extent e = grid.extent();
  const std::vector<int> quarters = possible_quarters(e, spec);
  const auto holes = holes_of(grid);
  if (holes.size() != 1) return {rightmost(quarters, grid.directions()), false};
  const auto at_hole = [&](int quarter) { return turned(e, quarter, 0, spec.rows - 1) == holes.front(); };
  const auto found = std::ranges::find_if(quarters, at_hole);
  if (found == quarters.end())
    throw TargetError(Reason::mirrored,
                      "the target is seen mirrored: the marked first fiducial is not at the end of the bottom row "
                      "where the print has it");
  return {*found, true};
}

/// Corners of the grid in the order of the spec.
void read_corners(const Grid& grid, const TargetSpec& spec, int quarter, TargetView& view) {
  const Grid::Extent e = grid.extent();
  std::vector<double> sides;
  for (int row = 0; row < spec.rows; ++row)
    for (int column = 0; column < spec.columns; ++column) {
      const auto [x, y] = turned(e, quarter, column, spec.rows - 1 - row);
      const Grid::Fiducial& fiducial = grid.at(x, y);
      for (int i = 0; i < 4; ++i) {
        view.image_px.push_back(fiducial.corners[(i + quarter) % 4]);
        sides.push_back((fiducial.corners[(i + 1) % 4] - fiducial.corners[i]).norm());
      }
    }
  std::nth_element(sides.begin(), sides.begin() + sides.size() / 2, sides.end());
  view.fiducial_px = sides[sides.size() / 2];
}

}  // namespace

TargetView detect_target(const cv::Mat& image, const TargetSpec& spec, const TargetOptions& options) {
  const cv::Mat grey = grey8(image);
  if (spec.kind == TargetKind::chessboard) return detail::detect_chessboard(grey, spec);
  Grid grid(grey, spec, options);
  fill(grid, grey, spec);
  TargetView view;
  if (options.settle) view.edge_shift_px = grid.settle();
  const auto [quarter, known] = orient(grid, spec);
  view.oriented = known;
  view.target_mm = spec.points_mm();
  view.plane_rms_px = grid.plane().rms_px;
  read_corners(grid, spec, quarter, view);
  check_order(spec, view.image_px);
  const double worst = std::ranges::max(grid.plane().residual_px);
  if (worst > std::max(3.0, 0.2 * view.fiducial_px))
    throw TargetError(Reason::hidden, "a corner lies " + std::to_string(worst) +
                                          " px from where the others say it is: a fiducial is hidden or damaged");
  return view;
}

void check_order(const TargetSpec& spec, const std::vector<Vector2d>& image_px) {
  const std::vector<Vector2d> plane = spec.points_mm();
  if (image_px.size() != plane.size())
    throw TargetError(Reason::wrong_size, "wrong pattern size: " + std::to_string(image_px.size()) +
                                              " corners given, " + spec.text() + " has " +
                                              std::to_string(plane.size()));
  for (const Vector2d& p : image_px)
    if (!p.allFinite()) throw TargetError(Reason::bad_image, "a corner is not a number");
  // The determinant of a homography's derivatives is det(H) / w³, w the third coordinate.
  const auto view = solve_homography(plane, image_px);
  if (!view || !(view->determined > detail::kOnALine)) {
    throw TargetError(Reason::no_target, "the corners lie on a line");
  }
  const auto mirrored = std::ranges::count_if(plane, [&](const Vector2d& p) {
    return view->matrix.determinant() * view->matrix.row(2).dot(p.homogeneous()) < 0;
  });
  if (mirrored > 0)
    throw TargetError(Reason::mirrored, "mirrored order: the corners run the other way round than " + spec.text() +
                                            " can be seen from its front; swap rows or columns");
}

}  // namespace horopter::calib
