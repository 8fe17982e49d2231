// SPDX-License-Identifier: Apache-2.0
// Triangle meshes: what may be a skin, and rays against it by Embree.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

/// Height of a triangle, as a share of its longest edge, below which it has no normal worth the name.
constexpr double kFlattest = 1e-6;
/// Vector area of a sheet with one border, as a share of its area, below which it is a body with a hole.
constexpr double kSheet = 0.25;

/// Disjoint sets of indices.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

struct Edge {
  std::uint32_t low, high, triangle;
  bool upward;  ///< the triangle runs from low to high
};

std::string place(const Vector3d& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", p.x(), p.y(), p.z()); }

/// Throws where a mesh is none of a body or a sheet. True for triangles of bodies.
std::vector<bool> check(const TriangleMesh& mesh) {
  const auto& points = mesh.vertices_mm;
  if (mesh.triangles.empty()) throw std::invalid_argument("the mesh has no triangle");
  for (const Vector3d& point : points) {
    if (!point.allFinite()) throw std::invalid_argument("a vertex is not finite");
  }
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[(i + 1) % 3];
      if (a >= points.size()) throw std::invalid_argument(fmt::format("triangle {} has a vertex that is none", t));
      if (b >= points.size()) continue;  // said in its turn
      longest = std::max(longest, (points[a] - points[b]).norm());
      edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
    const double doubled =
        (points[corners[1]] - points[corners[0]]).cross(points[corners[2]] - points[corners[0]]).norm();
    if (!(doubled > kFlattest * longest * longest)) {
      throw std::invalid_argument(
          fmt::format("triangle {} near {} is degenerate: its corners lie on a line", t, place(points[corners[0]])));
    }
  }
  std::ranges::sort(edges,
                    [](const Edge& a, const Edge& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  Sets parts(mesh.triangles.size());
  std::vector<Edge> border;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next].low == edges[i].low && edges[next].high == edges[i].high) ++next;
    const std::string where = place(points[edges[i].low]);
    if (next - i > 2) throw std::invalid_argument("more than two triangles share an edge near " + where);
    if (next - i == 1) {
      border.push_back(edges[i]);
    } else {
      if (edges[i].upward == edges[i + 1].upward) {
        throw std::invalid_argument(fmt::format("triangle {} near {} is inverted against its neighbour {}",
                                                edges[i].triangle, where, edges[i + 1].triangle));
      }
      parts.join(edges[i].triangle, edges[i + 1].triangle);
    }
    i = next;
  }

  struct Part {
    double volume = 0;
    double area = 0;
    Vector3d vector_area = Vector3d::Zero();
    int borders = 0;
    Vector3d at_border;
  };
  std::vector<Part> of(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    Part& part = of[parts.find(t)];
    // Relative to a vertex of the part: far from the origin the volume would be lost in rounding.
    const Vector3d& origin = points[mesh.triangles[parts.find(t)][0]];
    const Vector3d a = points[corners[0]] - origin;
    const Vector3d doubled = (points[corners[1]] - points[corners[0]]).cross(points[corners[2]] - points[corners[0]]);
    part.volume += a.dot(doubled) / 6;
    part.area += doubled.norm() / 2;
    part.vector_area += doubled / 2;
  }
  Sets loops(points.size());
  for (const Edge& edge : border) loops.join(edge.low, edge.high);
  std::vector<bool> counted(points.size());
  for (const Edge& edge : border) {
    Part& part = of[parts.find(edge.triangle)];
    const std::uint32_t loop = loops.find(edge.low);
    if (counted[loop]) continue;
    counted[loop] = true;
    ++part.borders;
    part.at_border = points[edge.low];
  }
  std::vector<bool> is_body(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Part& part = of[parts.find(t)];
    is_body[t] = part.borders == 0;
    if (parts.find(t) != t) continue;
    if (part.borders == 0 && !(part.volume > 0)) {
      throw std::invalid_argument(
          fmt::format("a body near {} is inside out: its triangles run clockwise seen from outside",
                      place(points[mesh.triangles[t][0]])));
    }
    if (mesh.open || part.borders == 0) continue;
    if (part.borders > 1 || part.vector_area.norm() < kSheet * part.area) {
      throw std::invalid_argument("the mesh has a hole near " + place(part.at_border));
    }
  }
  return is_body;
}

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

class Mesh : public Surface {
 public:
  explicit Mesh(const TriangleMesh& mesh) {
    const std::vector<bool> is_body = check(mesh);
    for (const Vector3d& vertex : mesh.vertices_mm) box_.extend(vertex);
    for (const Vector3d& vertex : mesh.vertices_mm) centre_ += vertex / static_cast<double>(mesh.vertices_mm.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& c = mesh.triangles[t];
      const Vector3d corner = mesh.vertices_mm[c[0]] - centre_;
      const Vector3d normal = (mesh.vertices_mm[c[1]] - mesh.vertices_mm[c[0]])
                                  .cross(mesh.vertices_mm[c[2]] - mesh.vertices_mm[c[0]])
                                  .normalized();
      facets_.push_back({normal, normal.dot(corner), is_body[t]});
      if (is_body[t] && inside_probe_.empty()) {
        inside_probe_.push_back((mesh.vertices_mm[c[0]] + mesh.vertices_mm[c[1]] + mesh.vertices_mm[c[2]]) / 3);
      }
    }
    device_.reset(rtcNewDevice("threads=1"));
    if (!device_) throw std::runtime_error("Embree does not start");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);  // nothing passes between two triangles
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.vertices_mm.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if (vertices == nullptr || indices == nullptr) throw std::runtime_error("no memory for the mesh");
    for (const Vector3d& vertex : mesh.vertices_mm) {
      const Eigen::Vector3f at = (vertex - centre_).cast<float>();
      vertices = std::copy_n(at.data(), 3, vertices);
    }
    for (const auto& triangle : mesh.triangles) indices = std::copy_n(triangle.data(), 3, indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) throw std::runtime_error("Embree refuses the mesh");
  }

  /// Embree, in single precision, says which triangle; where in its plane follows in double precision.
  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    constexpr std::size_t kLanes = 8;
    const Vector3d from = origin - centre_;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t first = 0; first < directions.size(); first += kLanes) {
      const std::size_t count = std::min(kLanes, directions.size() - first);
      alignas(32) std::array<int, kLanes> valid{};
      RTCRayHit8 packet{};
      for (std::size_t lane = 0; lane < count; ++lane) {
        // Of length 1: the directions' own lengths may be beyond single precision.
        const Vector3d direction = directions[first + lane].normalized();
        if (!direction.allFinite()) continue;
        valid[lane] = -1;
        packet.ray.org_x[lane] = static_cast<float>(from.x());
        packet.ray.org_y[lane] = static_cast<float>(from.y());
        packet.ray.org_z[lane] = static_cast<float>(from.z());
        packet.ray.dir_x[lane] = static_cast<float>(direction.x());
        packet.ray.dir_y[lane] = static_cast<float>(direction.y());
        packet.ray.dir_z[lane] = static_cast<float>(direction.z());
        packet.ray.tfar[lane] = std::numeric_limits<float>::infinity();
        packet.ray.mask[lane] = ~0U;
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid.data(), scene_.get(), &context, &packet);
      for (std::size_t lane = 0; lane < count; ++lane) {
        hits[first + lane] = {};
        if (valid[lane] == 0 || packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
        const Facet& facet = facets_[packet.hit.primID[lane]];
        const double slope = facet.normal.dot(directions[first + lane]);
        const double distance = (facet.offset - facet.normal.dot(from)) / slope;
        if (!(distance > 0 && std::isfinite(distance))) continue;
        const bool turned = !facet.is_body && slope > 0;
        hits[first + lane] = {distance, turned ? Vector3d(-facet.normal) : facet.normal};
      }
    }
  }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    for (const Vector3d& camera : {left, right}) {
      for (const Vector3d& probe : inside_probe_) {
        const Vector3d direction = probe - camera;
        Hit hit;
        intersect(camera, {&direction, 1}, {&hit, 1});
        if (std::isfinite(hit.distance) && hit.normal.dot(direction) > 0) {
          throw std::invalid_argument("a camera stands inside the mesh");
        }
      }
    }
  }

  void extend(Eigen::AlignedBox3d& box) const override { box.extend(box_); }

  std::string description() const override { return fmt::format("mesh of {} triangles", facets_.size()); }

 private:
  struct Facet {
    Vector3d normal;
    double offset;
    bool is_body;
  };

  Vector3d centre_ = Vector3d::Zero();  ///< coordinates are relative to it: single precision goes further
  Eigen::AlignedBox3d box_;
  std::vector<Facet> facets_;
  std::vector<Vector3d> inside_probe_;  ///< a place on a body
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
};

}  // namespace

TriangleMesh height_field(const Vector3d& origin_mm, const Eigen::Vector2d& step_mm,
                          const std::vector<std::vector<double>>& heights_mm) {
  if (!(step_mm.cwiseAbs().minCoeff() > 0)) throw std::invalid_argument("the steps of a height field are not 0");
  if (heights_mm.size() < 2 || heights_mm[0].size() < 2) {
    throw std::invalid_argument("a height field has 2 or more rows of 2 or more heights");
  }
  TriangleMesh mesh;
  const std::size_t columns = heights_mm[0].size();
  for (std::size_t row = 0; row < heights_mm.size(); ++row) {
    if (heights_mm[row].size() != columns) throw std::invalid_argument("rows of a height field have one length");
    for (std::size_t column = 0; column < columns; ++column) {
      mesh.vertices_mm.emplace_back(origin_mm + Vector3d(static_cast<double>(column) * step_mm.x(),
                                                         static_cast<double>(row) * step_mm.y(),
                                                         heights_mm[row][column]));
    }
  }
  for (std::size_t row = 0; row + 1 < heights_mm.size(); ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const auto at = static_cast<std::uint32_t>(row * columns + column);
      const auto below = static_cast<std::uint32_t>(at + columns);
      mesh.triangles.push_back({at, at + 1, below + 1});
      mesh.triangles.push_back({at, below + 1, below});
    }
  }
  mesh.open = true;
  return mesh;
}

SurfacePtr make_mesh(TriangleMesh mesh) { return std::make_shared<Mesh>(mesh); }

}  // namespace horopter
