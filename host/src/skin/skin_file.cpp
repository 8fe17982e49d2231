// SPDX-License-Identifier: Apache-2.0
#include "horopter/skin/skin_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/calib/yaml_keys.hpp"
#include "horopter/skin/rig_skin.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;
namespace yaml = calib::yaml;

/// The map that a file holds.
YAML::Node load(const std::filesystem::path& path, const std::string& expected) {
  const auto bytes = read_file(path, expected);
  const YAML::Node root = yaml::parse(path.string(), {bytes.begin(), bytes.end()}, expected);
  if (!root.IsMap()) yaml::fail(path.string(), root, "", "", expected);
  return root;
}

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
      yaml::Keys keys(file, item, what);
      points.push_back({point(file, keys.get("left", "[x, y]"), what + ": left"),
                        point(file, keys.get("right", "[x, y]"), what + ": right")});
      keys.finish();
    } else if (item.IsSequence() && item.size() == 2) {
      points.push_back({point(file, item[0], what + ": left"), point(file, item[1], what + ": right")});
    } else {
      yaml::fail(file, item, what, "", "{left: [x, y], right: [x, y]}");
    }
  }
  return points;
}

/// Points that contradict each other have a least squares homography, too, that is wrong at all of them.
void check_fit(const std::string& file, const YAML::Node& points, const HomographyFit& fit) {
  constexpr double kLargest_px = 5;
  const auto count = static_cast<double>(points.size());
  if (points.size() <= 4) return;  // these fit whatever they are
  // Of an error, the fit shows the share that it is not free to take: 2 of 10 numbers with five points.
  const double largest_px = kLargest_px * std::sqrt((2 * count - 8) / (2 * count));
  if (fit.largest_px <= largest_px) return;
  yaml::fail(
      file, points[fit.worst], "surface.points",
      fmt::format("point {} of {} is {:.1f} px from where the plane of all points has it in the right image; it or "
                  "another is wrong",
                  fit.worst + 1, points.size(), fit.largest_px),
      fmt::format("points that lie on one plane; of so many each is within {:.1f} px", largest_px));
}

/// What stands behind the keys of skin.yaml.
class Keys : public yaml::Keys {
 public:
  using yaml::Keys::Keys;

  Vector3d vector(const std::string& key) { return vector(get(key, "[x, y, z]"), path(key)); }
  Vector3d vector(const std::string& key, const Vector3d& otherwise) { return has(key) ? vector(key) : otherwise; }
  Vector3d vector(const YAML::Node& node, const std::string& what) const {
    const auto values = numbers(node, what, 3, "[x, y, z]");
    return {values[0], values[1], values[2]};
  }
  std::vector<double> numbers(const YAML::Node& node, const std::string& what, std::size_t count,
                              const std::string& expected) const {
    if (!node.IsSequence() || node.size() != count) yaml::fail(file(), node, what, "", expected);
    std::vector<double> values;
    for (const YAML::Node item : node) values.push_back(yaml::number(file(), item, what));
    return values;
  }
  double positive(const std::string& key, double otherwise) {
    if (!has(key)) return otherwise;
    const double value = yaml::number(file(), get(key, "a number"), path(key));
    if (!(value > 0)) fail(key, "", "a number above 0");
    return value;
  }
  double within(const std::string& key, double smallest, double largest, const std::string& unit) {
    const double value = yaml::number(file(), get(key, "a number, " + unit), path(key));
    if (!(value >= smallest && value <= largest))
      fail(key, "", fmt::format("{:g} to {:g} {}", smallest, largest, unit));
    return value;
  }
  Vector3d rotation_deg() { return vector("rotation_deg", Vector3d::Zero()); }
  /// x_world = R · x + position, R = Rz · Ry · Rx.
  calib::Pose pose(const Vector3d& position_mm) {
    const Vector3d angles = rotation_deg() * (M_PI / 180);
    const auto turn = [&](int axis) {
      return calib::rotation_from_vector(Vector3d(angles[axis] * Vector3d::Unit(axis)));
    };
    return {turn(2) * turn(1) * turn(0), position_mm};
  }
  /// Items of a list that is not empty.
  std::vector<YAML::Node> list(const std::string& key, const std::string& expected) {
    const YAML::Node node = get(key, expected);
    if (!node.IsSequence() || node.size() == 0) fail(key, "", expected);
    return {node.begin(), node.end()};
  }
};

SurfacePtr read_surface(Keys& keys);

Capsule read_segment(Keys& segment) {
  return {segment.vector("from_mm"), segment.vector("to_mm"),
          yaml::number(segment.file(), segment.get("radius_mm", "a number"), segment.path("radius_mm"))};
}

std::vector<Capsule> read_capsules(Keys& keys) {
  std::vector<Capsule> capsules;
  for (const YAML::Node& item : keys.list("segments", "a list of {from_mm, to_mm, radius_mm}")) {
    Keys segment(keys.file(), item, keys.path("segments"));
    capsules.push_back(read_segment(segment));
    segment.finish();
  }
  return capsules;
}

SurfacePtr read_mesh_surface(Keys& keys) {
  const YAML::Node name = keys.get("file", "a PLY, STL or OBJ file");
  if (!name.IsScalar() || name.Scalar().empty()) keys.fail("file", "", "the name of a PLY, STL or OBJ file");
  const calib::Pose pose = keys.pose(keys.vector("position_mm", Vector3d::Zero()));
  const double unit_mm = keys.positive("unit_mm", 1);
  const bool open = keys.flag("open");
  const double triangles = keys.positive("triangles", 0);  // 0: not told
  const std::filesystem::path path = keys.beside(name.Scalar());
  try {
    TriangleMesh mesh = read_mesh(path, unit_mm);
    if (const auto found = static_cast<double>(mesh.triangles.size()); triangles != 0 && found != triangles) {
      keys.fail("triangles", fmt::format("{} has {:.0f}", path.string(), found), fmt::format("{:.10g}", triangles));
    }
    mesh.open = open;
    for (Vector3d& vertex : mesh.vertices_mm) vertex = pose * vertex;
    return make_mesh(std::move(mesh));
  } catch (const std::invalid_argument& error) {
    throw FileError(path.string(), "", error.what(),
                    "a mesh that is closed, or a sheet; `open: true` where borders are meant");
  }
}

SurfacePtr read_height_field(Keys& keys) {
  const Vector3d origin = keys.vector("origin_mm", Vector3d::Zero());
  const auto step = keys.numbers(keys.get("step_mm", "[dx, dy]"), keys.path("step_mm"), 2, "[dx, dy]");
  const std::string expected = "2 or more rows of 2 or more heights, all of one length";
  std::vector<std::vector<double>> heights;
  for (const YAML::Node& row : keys.list("heights_mm", expected)) {
    heights.push_back(
        keys.numbers(row, keys.path("heights_mm"), heights.empty() ? row.size() : heights[0].size(), expected));
  }
  return make_mesh(height_field(origin, {step[0], step[1]}, heights));
}

/// What stands in a surface of each type. The one list of the types.
struct Type {
  const char* name;
  const char* keys;  ///< for --help
  std::function<SurfacePtr(Keys&)> read;
};

const std::vector<Type>& types() {
  static const std::vector<Type> all{
      {"plane", "point_mm: [x, y, z], normal: [x, y, z]",
       [](Keys& keys) { return make_plane(keys.vector("point_mm"), keys.vector("normal")); }},
      {"planes", "polygons_mm: a list of polygons, each 3 or more corners [x, y, z] in order",
       [](Keys& keys) {
         std::vector<Polygon> polygons;
         for (const YAML::Node& item : keys.list("polygons_mm", "a list of polygons")) {
           Polygon& polygon = polygons.emplace_back();
           if (!item.IsSequence()) yaml::fail(keys.file(), item, keys.path("polygons_mm"), "", "a list of corners");
           for (const YAML::Node corner : item) polygon.push_back(keys.vector(corner, keys.path("polygons_mm")));
         }
         return make_polygons(polygons);
       }},
      {"ellipsoid", "centre_mm, half_axes_mm: [a, b, c], rotation_deg (0)",
       [](Keys& keys) { return make_ellipsoid(keys.pose(keys.vector("centre_mm")), keys.vector("half_axes_mm")); }},
      {"mesh",
       "file: of type PLY, STL or OBJ; unit_mm (1), position_mm (0), rotation_deg (0), open (false): its borders are "
       "meant; triangles: how many it must have (any number)",
       read_mesh_surface},
      {"heightfield", "step_mm: [dx, dy], heights_mm: rows along x; origin_mm (0) of the first", read_height_field},
      {"box", "centre_mm, size_mm: [x, y, z], rotation_deg (0)",
       [](Keys& keys) { return make_box(keys.pose(keys.vector("centre_mm")), keys.vector("size_mm")); }},
      {"capsules", "segments: a list of {from_mm, to_mm, radius_mm}",
       [](Keys& keys) { return make_capsules(read_capsules(keys)); }},
      {"union", "surfaces: a list of surfaces",
       [](Keys& keys) {
         std::vector<SurfacePtr> surfaces;
         for (const YAML::Node& item : keys.list("surfaces", "a list of surfaces")) {
           Keys part(keys.file(), item, keys.path("surfaces"));
           surfaces.push_back(read_surface(part));
         }
         return make_union(surfaces);
       }},
  };
  return all;
}

const char* const kHomography = "homography";
const char* const kCorrespondences = "correspondences";

std::string type_names() {
  std::string names;
  for (const Type& type : types()) names += type.name + std::string(", ");
  return names + kHomography + " or " + kCorrespondences;
}

std::string type_of(Keys& keys) {
  const YAML::Node node = keys.get("type", type_names());
  if (!node.IsScalar()) keys.fail("type", "", type_names());
  return node.Scalar();
}

SurfacePtr read_surface(Keys& keys) {
  const std::string name = type_of(keys);
  const auto type = std::ranges::find(types(), name, &Type::name);
  if (type == types().end()) keys.fail("type", "unknown type '" + name + "'", type_names());
  SurfacePtr surface;
  try {
    surface = type->read(keys);
  } catch (const std::invalid_argument& error) {
    yaml::fail(keys.file(), keys.node(), keys.path("type") + ": " + name, error.what(), type->keys);
  }
  keys.finish();
  return surface;
}

double read_time(Keys& key) { return yaml::number(key.file(), key.get("time_s", "a number"), key.path("time_s")); }

/// Between two poses the skin turns by the shortest way: one of half a turn and more would go the other way, or nowhere.
void check_turn(Keys& key, const Vector3d& before_deg) {
  const double turn_deg = (key.rotation_deg() - before_deg).lpNorm<1>();  // at least the angle of both rotations
  if (turn_deg < 180) return;
  key.fail("rotation_deg", fmt::format("turns by {:g} degrees from the pose before, summed over the axes", turn_deg),
           "less than 180: poses in between");
}

MovingSurfacePtr read_poses(Keys& motion, SurfacePtr surface) {
  const Vector3d about = motion.vector("about_mm", Vector3d::Zero());
  std::vector<TimedPose> poses;
  Vector3d before_deg = Vector3d::Zero();
  for (const YAML::Node& item : motion.list("poses", "a list of {time_s, shift_mm, rotation_deg}")) {
    Keys key(motion.file(), item, motion.path("poses"));
    const double time_s = read_time(key);
    const calib::Pose pose = key.pose(key.vector("shift_mm", Vector3d::Zero()));
    poses.push_back({time_s, pose.translation_mm, pose.rotation});
    check_turn(key, before_deg);
    before_deg = key.rotation_deg();
    key.finish();
  }
  return make_moving(std::move(surface), about, poses);
}

MovingSurfacePtr read_moving_segments(Keys& motion, Keys& surface) {
  const std::vector<Capsule> first = read_capsules(surface);
  const std::string expected =
      fmt::format("[[from, to], …], each [x, y, z], of {} segments, whose radii `surface` gives", first.size());
  std::vector<TimedCapsules> later;
  for (const YAML::Node& item : motion.list("segments", "a list of {time_s, ends_mm}")) {
    Keys key(motion.file(), item, motion.path("segments"));
    TimedCapsules timed{read_time(key), first};
    const auto ends = key.list("ends_mm", expected);
    if (ends.size() != first.size()) key.fail("ends_mm", "", expected);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!ends[i].IsSequence() || ends[i].size() != 2)
        yaml::fail(key.file(), ends[i], key.path("ends_mm"), "", expected);
      timed.capsules[i].from_mm = key.vector(ends[i][0], key.path("ends_mm"));
      timed.capsules[i].to_mm = key.vector(ends[i][1], key.path("ends_mm"));
    }
    key.finish();
    later.push_back(std::move(timed));
  }
  return make_moving_capsules(first, later);
}

void read_motion(Keys& root, Keys& surface, SurfacePtr shape, SkinFile& result) {
  Keys motion(root.file(), root.get("motion", "a map"), "motion");
  result.motion_limits.images_per_s = motion.within("frame_rate_per_s", 0.1, 10'000, "a second");
  result.motion_limits.object_speed_m_s = motion.within("object_speed_m_s", 1e-3, 100, "m/s");
  result.motion_limits.tolerance_px = motion.positive("tolerance_px", kD95_px);
  try {
    if (motion.has("segments")) {
      result.motion = read_moving_segments(motion, surface);
    } else {
      result.motion = read_poses(motion, std::move(shape));
    }
  } catch (const std::invalid_argument& error) {
    yaml::fail(root.file(), motion.node(), "motion", error.what(), "a surface at times that rise");
  }
  motion.finish();
}

/// Throws FileError where two cameras are no left and right one.
void check_pair(Keys& root, const calib::Rig& pair) {
  const std::string &left = pair.cameras[0].name, &right = pair.cameras[1].name;
  if (calib::are_exchanged(pair.cameras[0], pair.cameras[1])) {
    root.fail(
        "cameras", fmt::format("the right camera, {}, stands to the left of the left one, {}", right, left),
        fmt::format("[{}, {}], and their images likewise; or the rig's translation with the other sign", right, left));
  }
  if (const std::string problem = calib::baseline_problem(pair); !problem.empty()) root.fail("cameras", problem, "");
}

/// The two cameras that skin.yaml names, or the first two.
calib::Rig two_cameras(Keys& root, const calib::Rig& rig) {
  std::string names;
  for (const calib::Camera& camera : rig.cameras) names += (names.empty() ? "" : ", ") + camera.name;
  calib::Rig pair{rig.world, {}};
  if (!root.has("cameras")) {
    if (rig.cameras.size() < 2) root.fail("cameras", "the rig has one camera", "two");
    pair.cameras = {rig.cameras[0], rig.cameras[1]};
    check_pair(root, pair);
    return pair;
  }
  const std::string expected = "[left, right], two of the rig's cameras: " + names;
  const YAML::Node list = root.get("cameras", expected);
  if (!list.IsSequence() || list.size() != 2) root.fail("cameras", "", expected);
  for (const YAML::Node item : list) {
    const auto found =
        item.IsScalar() ? std::ranges::find(rig.cameras, item.Scalar(), &calib::Camera::name) : rig.cameras.end();
    if (found == rig.cameras.end()) yaml::fail(root.file(), item, "cameras", "", expected);
    pair.cameras.push_back(*found);
  }
  if (pair.cameras[0].name == pair.cameras[1].name) root.fail("cameras", "one camera twice", expected);
  check_pair(root, pair);
  return pair;
}

}  // namespace

SkinFile load_skin(const std::filesystem::path& path, Point centre, const calib::Rig* rig) {
  const std::string file = path.string();
  const YAML::Node root_node = load(path, "a skin: `surface:` with a `type`");
  Keys root(file, root_node, "skin");
  Keys surface(file, root.get("surface", "a map with `type`"), "surface");
  const std::string type = type_of(surface);

  SkinFile result;
  result.path = file;
  if (type == kHomography || type == kCorrespondences) {
    YAML::Node source;
    try {
      if (type == kHomography) {
        source = surface.get("matrix", "3 rows of 3 numbers");
        result.skin = std::make_unique<HomographySkin>(read_matrix(file, source), centre);
      } else {
        source = surface.get("points", "a list of at least 4 {left: [x, y], right: [x, y]}");
        result.correspondences = read_points(file, source);
        result.fit = fit_homography(result.correspondences);
        check_fit(file, source, *result.fit);
        result.skin =
            std::make_unique<HomographySkin>(result.fit->matrix, result.correspondences.front().left, kCorrespondences);
      }
    } catch (const std::invalid_argument& error) {
      yaml::fail(
          file, source, type == kHomography ? "surface.matrix" : "surface.points", error.what(),
          type == kHomography ? "an invertible, finite 3x3 matrix" : "4 or more points, no line through nearly all");
    }
    surface.finish();
    root.finish();
    return result;
  }
  const SurfacePtr shape = read_surface(surface);
  if (rig == nullptr) {
    throw UsageError(fmt::format("{}: a {} is seen through cameras: --rig is required", file, type));
  }
  const calib::Rig cameras = two_cameras(root, *rig);
  if (root.has("motion")) read_motion(root, surface, shape, result);
  root.finish();
  try {
    result.skin = std::make_unique<RigSkin>(CameraPair(cameras.cameras[0], cameras.cameras[1]), shape, type);
  } catch (const std::invalid_argument& error) {
    yaml::fail(file, surface.node(), "surface", error.what(), "a surface in front of both cameras");
  }
  result.rig = calib::to_yaml(cameras);
  return result;
}

SurfacePtr load_surface(const std::filesystem::path& path) {
  const std::string file = path.string();
  const YAML::Node node = load(path, "a shape: `surface:` with a `type`");
  Keys root(file, node, "shape");
  Keys surface(file, root.get("surface", "a map with `type`"), "surface");
  SurfacePtr shape = read_surface(surface);
  for (const char* of_skins : {"cameras", "motion"}) root.has(of_skins);
  root.finish();
  return shape;
}

std::vector<std::filesystem::path> files_named_in(const std::filesystem::path& path) {
  std::vector<std::filesystem::path> files;
  const std::function<void(const YAML::Node&)> add_of = [&](const YAML::Node& node) {
    for (const auto& item : node) {
      if (!node.IsMap()) {
        add_of(item);
      } else if (item.first.IsScalar() && item.first.Scalar() == "file" && item.second.IsScalar()) {
        files.push_back(path.parent_path() / item.second.Scalar());
      } else {
        add_of(item.second);
      }
    }
  };
  add_of(load(path, "a skin: `surface:` with a `type`"));
  return files;
}

bool has_motion(const std::filesystem::path& path) {
  const YAML::Node root = load(path, "a skin: `surface:` with a `type`");
  return root.IsMap() && root["motion"].IsDefined();
}

std::string skin_file_help() {
  std::string text =
      "skin.yaml holds `surface:` with `type:` and what belongs to it, in the world coordinates of the rig; values in\n"
      "parentheses need not be given. `cameras: [left, right]` beside it names two of the rig's cameras (the first two).\n";
  for (const Type& type : types()) text += fmt::format("  {:16} {}\n", type.name, type.keys);
  text += fmt::format("  {:16} matrix: 3 rows of 3 numbers, left pixel to right pixel; uses no rig\n", kHomography);
  text += fmt::format("  {:16} points: 4 or more of {{left: [x, y], right: [x, y]}}; uses no rig\n", kCorrespondences);
  text +=
      "`motion:` beside it makes a skin that moves, for `run`: from `surface` at time 0 to what it lists, one table a\n"
      "frame, in steps that no object slips through; intermediate skins are inserted where it would move too far.\n"
      "  frame_rate_per_s  frames a second, or fields of profile field\n"
      "  object_speed_m_s  of the fastest object that is not to be missed; tolerance_px (0.7): D95, see\n"
      "                    `plan thickness`; less where the settings of `run` find less\n"
      "  poses             a list of {time_s, shift_mm (0), rotation_deg (0)}; about_mm (0): what it is turned about\n"
      "  segments          for capsules instead: a list of {time_s, ends_mm: [[from, to], ...]}\n";
  return text + "rotation_deg: angles about x, y, z; R = Rz Ry Rx takes the surface's coordinates to the world's.\n";
}

}  // namespace horopter
