// SPDX-License-Identifier: Apache-2.0
#include "horopter/skin.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/error.hpp"
#include "yaml.hpp"

namespace horopter {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Pixels per unit when the condition of a matrix is judged: the size of images, so that translations and
/// rotations have comparable entries.
constexpr double kPixelScale = 1000;
/// Ratio of the smallest to the largest singular value below which a homography flattens the image to a line.
constexpr double kSingular = 1e-9;
/// The same for the second smallest singular value of the equations of a fit: below it, points do not determine it.
constexpr double kDegenerate = 1e-4;

bool is_singular(const RowMajor3& matrix) {
  const Eigen::Vector3d scale(kPixelScale, kPixelScale, 1);
  const RowMajor3 scaled = scale.cwiseInverse().asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::Vector3d singular = Eigen::JacobiSVD<RowMajor3>(scaled).singularValues();
  return !(singular[2] > kSingular * singular[0]);
}

Matrix3 to_array(const RowMajor3& matrix) {
  Matrix3 array;
  std::copy_n(matrix.data(), 9, array.begin());
  return array;
}

/// Moves the centroid to the origin and scales the mean distance from it to √2.
RowMajor3 normalisation(std::span<const Point> points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Point& p : points) mean += Eigen::Vector2d(p.x, p.y);
  mean /= static_cast<double>(points.size());
  double distance = 0;
  for (const Point& p : points) distance += (Eigen::Vector2d(p.x, p.y) - mean).norm();
  distance /= static_cast<double>(points.size());
  if (!(distance > 1e-9)) throw std::invalid_argument("all points are the same point");
  const double scale = std::sqrt(2.0) / distance;
  RowMajor3 matrix;
  matrix << scale, 0, -scale * mean.x(), 0, scale, -scale * mean.y(), 0, 0, 1;
  return matrix;
}

const char* const kTypes = "homography or correspondences (plane, planes, ellipsoid, mesh and heightfield follow)";

Point point(const std::string& file, const YAML::Node& node, const std::string& what) {
  if (!node.IsSequence() || node.size() != 2) yaml::fail(file, node, what, "", "[x, y] in pixels");
  return {yaml::number(file, node[0], what), yaml::number(file, node[1], what)};
}

Matrix3 read_matrix(const std::string& file, const YAML::Node& node) {
  const std::string what = "surface.matrix";
  const std::string expected = "3 rows of 3 numbers, left pixel to right pixel";
  if (!node.IsSequence() || node.size() != 3) yaml::fail(file, node, what, "", expected);
  Matrix3 matrix{};
  for (std::size_t row = 0; row < 3; ++row) {
    if (!node[row].IsSequence() || node[row].size() != 3) yaml::fail(file, node[row], what, "", expected);
    for (std::size_t column = 0; column < 3; ++column) {
      matrix[row * 3 + column] = yaml::number(file, node[row][column], what);
    }
  }
  return matrix;
}

std::vector<Correspondence> read_points(const std::string& file, const YAML::Node& node) {
  const std::string what = "surface.points";
  if (!node.IsSequence() || node.size() < 4) {
    yaml::fail(file, node, what, "", "a list of at least 4 {left: [x, y], right: [x, y]}");
  }
  std::vector<Correspondence> points;
  for (const YAML::Node item : node) {
    if (item.IsMap()) {
      points.push_back({point(file, yaml::member(file, item, "left", "[x, y]"), what + ": left"),
                        point(file, yaml::member(file, item, "right", "[x, y]"), what + ": right")});
    } else if (item.IsSequence() && item.size() == 2) {
      points.push_back({point(file, item[0], what + ": left"), point(file, item[1], what + ": right")});
    } else {
      yaml::fail(file, item, what, "", "{left: [x, y], right: [x, y]}");
    }
  }
  return points;
}

}  // namespace

HomographySkin::HomographySkin(const Matrix3& matrix, Point visible, std::string_view type)
    : matrix_(matrix), type_(type) {
  for (const double entry : matrix) {
    if (!std::isfinite(entry)) throw std::invalid_argument("the matrix is not finite");
  }
  if (is_singular(Eigen::Map<const RowMajor3>(matrix.data()))) {
    throw std::invalid_argument("the matrix is singular: it maps the image to a line or a point");
  }
  const double denominator = matrix[6] * visible.x + matrix[7] * visible.y + matrix[8];
  if (denominator < 0) std::ranges::transform(matrix_, matrix_.begin(), std::negate<>());
}

std::optional<Point> HomographySkin::source(Point left) const {
  const auto& h = matrix_;
  const double s = h[6] * left.x + h[7] * left.y + h[8];
  if (!(s > 0)) return std::nullopt;
  const Point right{(h[0] * left.x + h[1] * left.y + h[2]) / s, (h[3] * left.x + h[4] * left.y + h[5]) / s};
  if (!std::isfinite(right.x) || !std::isfinite(right.y)) return std::nullopt;
  return right;
}

std::array<double, 4> HomographySkin::derivatives(Point left) const {
  const auto& h = matrix_;
  const double s = h[6] * left.x + h[7] * left.y + h[8];
  const double x = (h[0] * left.x + h[1] * left.y + h[2]) / s;
  const double y = (h[3] * left.x + h[4] * left.y + h[5]) / s;
  return {(h[0] - x * h[6]) / s, (h[1] - x * h[7]) / s, (h[3] - y * h[6]) / s, (h[4] - y * h[7]) / s};
}

std::string HomographySkin::description() const {
  const auto& h = matrix_;
  return fmt::format("{} [[{:.6g}, {:.6g}, {:.6g}], [{:.6g}, {:.6g}, {:.6g}], [{:.6g}, {:.6g}, {:.6g}]]", type_, h[0],
                     h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8]);
}

HomographyFit fit_homography(std::span<const Correspondence> points) {
  if (points.size() < 4) {
    throw std::invalid_argument(fmt::format("{} points; a homography takes at least 4", points.size()));
  }
  std::vector<Point> left;
  std::vector<Point> right;
  for (const Correspondence& c : points) {
    for (const double value : {c.left.x, c.left.y, c.right.x, c.right.y}) {
      if (!std::isfinite(value)) throw std::invalid_argument("a point is not finite");
    }
    left.push_back(c.left);
    right.push_back(c.right);
  }
  const RowMajor3 left_normal = normalisation(left);
  const RowMajor3 right_normal = normalisation(right);

  // Two equations a point; one more row of zeros makes 4 points square enough for the full set of right vectors.
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(2 * points.size() + 1), 9);
  Eigen::Index row = 0;
  for (const Correspondence& c : points) {
    const Eigen::Vector3d l = left_normal * Eigen::Vector3d(c.left.x, c.left.y, 1);
    const Eigen::Vector3d r = right_normal * Eigen::Vector3d(c.right.x, c.right.y, 1);
    equations.row(row) << -l.transpose(), Eigen::RowVector3d::Zero(), r.x() * l.transpose();
    equations.row(row + 1) << Eigen::RowVector3d::Zero(), -l.transpose(), r.y() * l.transpose();
    row += 2;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(equations, Eigen::ComputeThinV);
  const Eigen::VectorXd& singular = svd.singularValues();
  if (!(singular[7] > kDegenerate * singular[0])) {
    throw std::invalid_argument("the points do not determine a homography: too many of them lie on one line");
  }
  const Eigen::VectorXd solution = svd.matrixV().col(8);
  RowMajor3 normalised;
  std::copy_n(solution.data(), 9, normalised.data());
  RowMajor3 matrix = right_normal.inverse() * normalised * left_normal;
  matrix /= matrix.norm();
  if (std::abs(matrix(2, 2)) > 1e-9) matrix /= matrix(2, 2);
  if (is_singular(matrix)) throw std::invalid_argument("the points lie on a line in one of the images");

  HomographyFit fit;
  fit.matrix = to_array(matrix);
  const HomographySkin skin(fit.matrix, points.front().left);
  double sum = 0;
  for (const Correspondence& c : points) {
    const auto mapped = skin.source(c.left);
    if (!mapped) throw std::invalid_argument("the horizon of the fitted plane runs between the points");
    const double distance = std::hypot(mapped->x - c.right.x, mapped->y - c.right.y);
    sum += distance * distance;
    fit.largest_px = std::max(fit.largest_px, distance);
  }
  fit.rms_px = std::sqrt(sum / static_cast<double>(points.size()));
  return fit;
}

SkinFile load_skin(const std::filesystem::path& path, Point centre) {
  const std::string file = path.string();
  const YAML::Node root = yaml::load(path, "a skin: `surface:` with a `type`");
  const YAML::Node surface = yaml::member(file, root, "surface", "a map with `type`");
  const YAML::Node type_node = yaml::member(file, surface, "type", kTypes);
  if (!type_node.IsScalar()) yaml::fail(file, type_node, "surface.type", "", kTypes);
  const std::string& type = type_node.Scalar();

  SkinFile result;
  result.path = file;
  YAML::Node source;
  try {
    if (type == "homography") {
      source = yaml::member(file, surface, "matrix", "3 rows of 3 numbers");
      result.skin = std::make_unique<HomographySkin>(read_matrix(file, source), centre);
    } else if (type == "correspondences") {
      source = yaml::member(file, surface, "points", "a list of at least 4 {left: [x, y], right: [x, y]}");
      result.correspondences = read_points(file, source);
      result.fit = fit_homography(result.correspondences);
      result.skin =
          std::make_unique<HomographySkin>(result.fit->matrix, result.correspondences.front().left, "correspondences");
    } else {
      for (const char* known : {"plane", "planes", "ellipsoid", "mesh", "heightfield"}) {
        if (type == known) yaml::fail(file, type_node, "surface.type", "'" + type + "' is not supported yet", kTypes);
      }
      yaml::fail(file, type_node, "surface.type", "unknown type '" + type + "'", kTypes);
    }
  } catch (const std::invalid_argument& error) {
    yaml::fail(
        file, source, type == "homography" ? "surface.matrix" : "surface.points", error.what(),
        type == "homography" ? "an invertible, finite 3x3 matrix" : "4 or more points, no line through nearly all");
  }
  return result;
}

}  // namespace horopter
