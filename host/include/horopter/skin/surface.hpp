// SPDX-License-Identifier: Apache-2.0
// Surfaces: the shape of a skin in world coordinates, mm, and where lines of sight meet it (T2 to T4; thesis 7.1).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "horopter/calib/camera.hpp"

namespace horopter {

/// The first meeting of a line of sight with a surface.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();  ///< in lengths of the direction; infinite: none
  Eigen::Vector3d normal{0, 0, 0};  ///< length 1: out of a body; of a sheet the side that the line of sight comes from
};

class Surface;
using SurfacePtr = std::shared_ptr<const Surface>;

class Surface {
 public:
  virtual ~Surface() = default;
  /// The first meetings, at distances above 0, of lines of sight from one point. A direction that is not finite meets
  /// nothing. As many hits as directions.
  virtual void intersect(const Eigen::Vector3d& origin_mm, std::span<const Eigen::Vector3d> directions,
                         std::span<Hit> hits) const = 0;
  /// One smooth, convex piece: no part can hide another that faces a camera, and nothing changes abruptly between two
  /// lines of sight.
  virtual bool simple() const { return false; }
  /// Throws std::invalid_argument, saying why, where cameras at these places cannot watch it: inside a body, on
  /// different sides of a plane.
  virtual void check_cameras(const Eigen::Vector3d& left_mm, const Eigen::Vector3d& right_mm) const = 0;
  /// Extends a box by where the surface ends. A plane across an axis of the world adds its place on that axis, other
  /// planes add nothing.
  virtual void extend(Eigen::AlignedBox3d& box_mm) const = 0;
  /// One line for reports.
  virtual std::string description() const = 0;
  /// Of a union its surfaces, in order, those of a union within it in its place; else nothing.
  virtual std::vector<SurfacePtr> parts() const { return {}; }
};

// All of these throw std::invalid_argument for shapes that are not: not finite, without extent, degenerate.

/// The plane through a point; the normal may have any length and either sign.
SurfacePtr make_plane(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal);

/// Corners in order around a plane polygon without self-intersection, 3 or more.
using Polygon = std::vector<Eigen::Vector3d>;
/// Piecewise planes. Corners may be off their polygon's plane by 1e-6 of its size.
SurfacePtr make_polygons(std::vector<Polygon> polygons_mm);

/// Ellipsoid (7.12) with half axes along the axes of `pose`, which takes the ellipsoid's coordinates to the world's.
SurfacePtr make_ellipsoid(const calib::Pose& pose, const Eigen::Vector3d& half_axes_mm);

/// Box around the origin of `pose`, edges along its axes.
SurfacePtr make_box(const calib::Pose& pose, const Eigen::Vector3d& size_mm);

/// All points within a radius of a segment: the hull of a link of a robot's arm.
struct Capsule {
  Eigen::Vector3d from_mm;
  Eigen::Vector3d to_mm;
  double radius_mm = 0;
};
/// The hull of several: what lies inside of one belongs to no surface.
SurfacePtr make_capsules(std::vector<Capsule> capsules);

/// What is met first of several.
SurfacePtr make_union(std::vector<SurfacePtr> surfaces);

/// The same surface elsewhere: `pose` takes its coordinates to the world's. Moving a mesh costs no new search tree.
SurfacePtr make_moved(SurfacePtr surface, const calib::Pose& pose);

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices_mm;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
  bool open = false;                                    ///< its borders are meant
};
/// PLY or STL, text or binary, or OBJ, of triangles and convex polygons; vertices at the same place become one. Throws
/// FileError, with the place, for a file that is not complete, or holds faces in another form. OBJ, and text STL of more
/// than one solid, announce nothing: of a file that ends behind a face, or a solid, only a hole shows it.
TriangleMesh read_mesh(const std::filesystem::path& path, double unit_mm);
/// Heights above (x, y) = origin + (column, row)·step, in rows; ≥ 2 × 2.
TriangleMesh height_field(const Eigen::Vector3d& origin_mm, const Eigen::Vector2d& step_mm,
                          const std::vector<std::vector<double>>& heights_mm);
/// A closed body seen from outside, or a sheet seen from either side. Refuses degenerate triangles, edges with more
/// than two triangles, neighbours of different orientation, bodies inside out, and holes: a border in a body, or a
/// second border in a sheet. One border counts as that of a sheet when the surface's vector area is at least a quarter
/// of its area (1 for a flat sheet, 1/2 for half a sphere, 0 for a body), or when the mesh says that it is open.
SurfacePtr make_mesh(TriangleMesh mesh);

}  // namespace horopter
