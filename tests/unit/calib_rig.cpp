// SPDX-License-Identifier: Apache-2.0
// rig.yaml and the files of other programs: one calibration in three formats, there and back, damaged files.
#include <catch2/catch.hpp>
#include <filesystem>

#include "horopter/calib/error.hpp"
#include "horopter/calib/rig.hpp"
#include "host_temporary.hpp"
#include "shared_data.hpp"

using namespace horopter::calib;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

Rig example() {
  Rig rig;
  rig.world = "camera left";
  Camera left{.name = "left", .width_px = 640, .height_px = 480, .model = {}, .world_to_camera = {}};
  left.model = CameraModel(
      BrownConradyIntrinsics{533.56315600145820,
                             533.59655195592040,
                             342.53435236607157,
                             234.76541376921730,
                             {.k1 = -0.28865446441043141, .k2 = 0.0935985591651, .p1 = 1.2e-3, .p2 = -1.4e-4}});
  Camera right = left;
  right.name = "right";
  right.model = CameraModel(BrownConradyIntrinsics{536.9, 536.4, 327.4, 249.9, {.k1 = -0.29, .k2 = 0.106, .k3 = 0.01}});
  right.world_to_camera = {rotation_from_vector({0.007, 0.004, -0.0035}), {-99.8132973, 1.1017, -0.1429}};
  rig.cameras = {left, right};
  return rig;
}

double difference(const Camera& a, const Camera& b) {
  double largest = std::max({std::abs(a.model.fx_px() - b.model.fx_px()), std::abs(a.model.fy_px() - b.model.fy_px()),
                             std::abs(a.model.cx_px() - b.model.cx_px()), std::abs(a.model.cy_px() - b.model.cy_px())});
  const auto x = a.model.lens().coefficients().array(), y = b.model.lens().coefficients().array();
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
  return largest;
}

double difference(const Rig& a, const Rig& b) {
  REQUIRE(a.cameras.size() == b.cameras.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    CHECK(a.cameras[i].name == b.cameras[i].name);
    largest = std::max(largest, difference(a.cameras[i], b.cameras[i]));
  }
  if (a.cameras.size() > 1) {
    const Pose p = a.between(0, 1), q = b.between(0, 1);
    largest = std::max(largest, (p.rotation - q.rotation).cwiseAbs().maxCoeff());
    largest = std::max(largest, (p.translation_mm - q.translation_mm).cwiseAbs().maxCoeff());
  }
  return largest;
}

std::vector<fs::path> write_all(const horopter::TemporaryDirectory& folder, const Exported& exported) {
  std::vector<fs::path> files;
  for (const ExportedFile& file : exported.files) files.push_back(folder.write(file.name, file.text));
  return files;
}

}  // namespace

TEST_CASE("one calibration in three formats is one rig") {
  const auto folder = horopter::test::shared_data("formats");
  if (!folder) return;
  const std::vector<fs::path> yaml{*folder / "intrinsics.yml", *folder / "extrinsics.yml"};
  const std::vector<fs::path> ros{*folder / "ros_left.yaml", *folder / "ros_right.yaml"};
  const RigFile json = load_rig(*folder / "stereo_all.json", {.opencv_unit_mm = 1});
  const RigFile kalibr = load_rig(*folder / "camchain.yaml");
  const ImportOptions given{.opencv_unit_mm = 1, .width_px = 640, .height_px = 480};
  const RigFile opencv = load_rig(yaml, given);
  CHECK(json.format == "OpenCV");
  CHECK(kalibr.format == "Kalibr camchain");
  CHECK(load_rig(ros).format == "ROS camera_info");
  CHECK(json.rig.cameras[0].width_px == 640);
  CHECK(json.rig.baseline_mm() == Approx(99.8195).epsilon(1e-4));
  CHECK(json.rig.between(0, 1).translation_mm.x() == Approx(-99.813297366071239).epsilon(1e-12));
  for (const RigFile& other : {kalibr, opencv, load_rig(ros)}) {
    INFO(other.format);
    CHECK(difference(json.rig, other.rig) < 1e-6);
    CHECK(other.rig.cameras[1].height_px == 480);
    CHECK(other.warnings.empty());
  }
  CHECK_THROWS_WITH(load_rig(yaml), Contains("T: a translation without a unit") && Contains("--unit"));
  const RigFile unknown = load_rig(yaml, {.opencv_unit_mm = 1});
  REQUIRE(unknown.warnings.size() == 2);
  CHECK_THAT(unknown.warnings[0], Contains("image_size_unknown"));
  // Both files in the other order.
  CHECK(difference(json.rig, load_rig(std::vector<fs::path>{yaml[1], yaml[0]}, given).rig) < 1e-6);
  CHECK_THROWS_WITH(load_rig(yaml[0]), Contains("no T") || Contains("no R"));
  CHECK_THROWS_WITH(load_rig(yaml[1]), Contains("no camera matrix"));
}

TEST_CASE("a rig survives its own file bit by bit") {
  const horopter::TemporaryDirectory folder;
  Rig rig = example();
  rig.world = "a \"robot\" cell";
  rig.cameras[1].model = CameraModel(TsaiIntrinsics{.f_mm = 10.123456789012345,
                                                    .dx_mm = 0.0113,
                                                    .dy_mm = 0.011,
                                                    .sx = 1.0123,
                                                    .cx_px = 381.5,
                                                    .cy_px = 286.2,
                                                    .kappa1 = 1e-3,
                                                    .kappa3 = -1.2345678901234e-9,
                                                    .p1 = 1e-5,
                                                    .s2 = -3e-5});
  rig.cameras[0].world_to_camera = {rotation_from_vector({1, 2, 0.5}), {1.0 / 3, 2e3, 7}};
  const RigFile back = load_rig(folder.write("rig.yaml", to_yaml(rig)));
  CHECK(back.format == "rig.yaml");
  CHECK(back.warnings.empty());
  CHECK(back.rig.world == rig.world);
  CHECK(difference(rig, back.rig) < 1e-15);
  CHECK(std::get<TsaiIntrinsics>(back.rig.cameras[1].model.intrinsics()).kappa3 == -1.2345678901234e-9);
  CHECK((back.rig.cameras[0].world_to_camera.rotation - rig.cameras[0].world_to_camera.rotation).norm() < 1e-15);
  CHECK(to_yaml(back.rig).size() == to_yaml(rig).size());
}

TEST_CASE("a rig survives export to OpenCV and ROS") {
  const horopter::TemporaryDirectory folder;
  const Rig rig = example();
  const Exported opencv = to_opencv(rig), ros = to_ros(rig);
  CHECK(opencv.warnings.empty());
  CHECK(difference(rig, load_rig(write_all(folder, opencv)).rig) < 1e-9);
  const RigFile from_ros = load_rig(write_all(folder, ros));
  CHECK(difference(rig, from_ros.rig) < 1e-9);
  CHECK(from_ros.rig.cameras[0].width_px == 640);
  // All twelve terms go to OpenCV; ROS has no thin prism.
  Rig full = rig;
  full.cameras[0].model = CameraModel(
      BrownConradyIntrinsics{533, 534, 342, 235, {.k1 = -0.2, .k4 = 0.01, .k5 = 0.002, .s1 = 1e-4, .s4 = 1e-5}});
  CHECK(difference(full, load_rig(write_all(folder, to_opencv(full))).rig) < 1e-9);
  CHECK_THROWS_WITH(to_ros(full), Contains("thin prism"));
}

TEST_CASE("a camera's name that leads out of the directory is not exported to ROS") {
  Rig rig = example();
  for (const char* const name : {"../../evil", "/evil", "a/b", ".", "..", ".hidden", "a\nb"}) {
    CAPTURE(name);
    rig.cameras[1].name = name;
    CHECK_THROWS_WITH(to_ros(rig), Contains("expected one without '/'"));
  }
  rig.cameras[1].name = "right camera 2.1 (Süd)";
  CHECK(to_ros(rig).files.back().name == "right camera 2.1 (Süd).yaml");
}

TEST_CASE("a Tsai rig is exported by a fit that says how good it is, and loses its world by name") {
  const horopter::TemporaryDirectory folder;
  Rig rig = example();
  for (Camera& camera : rig.cameras) {
    camera.model = CameraModel(
        TsaiIntrinsics{.f_mm = 10, .dx_mm = 0.018, .dy_mm = 0.018, .cx_px = 321, .cy_px = 242, .kappa1 = 1.5e-3});
    camera.world_to_camera.translation_mm.z() += 700;
  }
  const Exported exported = to_opencv(rig);
  REQUIRE(exported.warnings.size() == 3);
  CHECK_THAT(exported.warnings[0], Contains("world_lost"));
  CHECK_THAT(exported.warnings[1], Contains("lens_converted: left"));
  const Rig back = load_rig(write_all(folder, exported)).rig;
  for (int u = 0; u < 640; u += 40) {
    const Eigen::Vector2d pixel(u, 100);
    CHECK((*back.cameras[0].model.distort(*rig.cameras[0].model.undistort(pixel)) - pixel).norm() < 0.02);
  }
  CHECK((back.between(0, 1).translation_mm - rig.between(0, 1).translation_mm).norm() < 1e-9);
}

TEST_CASE("damaged files are refused by name and place") {
  const horopter::TemporaryDirectory folder;
  const std::string good = to_yaml(example());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return folder.write("rig.yaml", text.replace(at, from.size(), to));
  };
  CHECK_THROWS_AS(load_rig("/nowhere/rig.yaml"), FileError);
  CHECK_THROWS_WITH(load_rig(folder.write("empty.yaml", "")), Contains("empty"));
  CHECK_THROWS_WITH(load_rig(folder.write("text.yaml", "hello\n")), Contains("expected rig.yaml"));
  CHECK_THROWS_WITH(load_rig(replaced("horopter_rig: 1", "horopter_rig: 2")), Contains("version 2"));
  CHECK_THROWS_WITH(load_rig(replaced("brown_conrady", "fisheye")), Contains("fisheye") && Contains("line 8"));
  CHECK_THROWS_WITH(load_rig(replaced("fx_px: 533.5631560014582", "fx_px: -1")), Contains("positive"));
  CHECK_THROWS_WITH(load_rig(replaced("fx_px: 533.5631560014582", "fx_px: .nan")), Contains("finite"));
  CHECK_THROWS_WITH(load_rig(replaced("k2:", "k9:")), Contains("'k9' is not known"));
  // What is blank is no 0.
  for (const std::string term : {"k1", "k2"}) {
    CHECK_THROWS_WITH(load_rig(replaced(term + ": ", term + ": , k6: ")),
                      Contains(term) && Contains("nothing") && Contains("expected a finite number"));
  }
  CHECK_THROWS_WITH(load_rig(replaced("    fy_px", "    fyy_px")), Contains("fy_px") && Contains("missing"));
  CHECK_THROWS_WITH(load_rig(replaced("rotation: [[1", "rotation: [[2")), Contains("rotation matrix"));
  CHECK_THROWS_WITH(load_rig(replaced("rotation: [[1", "rotation: [[-1")), Contains("mirror"));
  CHECK_THROWS_WITH(load_rig(replaced("name: \"right\"", "name: \"left\"")), Contains("two cameras named"));
  CHECK_THROWS_WITH(load_rig(replaced("[640, 480]", "[640]")), Contains("image_size"));
  CHECK_THROWS_AS(load_rig(folder.write("cut.yaml", good.substr(0, good.size() / 2))), FileError);
  CHECK_THROWS_AS(load_rig(folder.write("cut.json", "{ \"M1\": { \"type_id\": \"opencv-matrix\", \"rows\": 3,")),
                  FileError);
  // Found by fuzzing: an exception of the standard library, out of OpenCV; text on which OpenCV does not end;
  // matrices that take all memory.
  CHECK_THROWS_AS(load_rig(folder.write("odd.yml", "!p c:5\nrig-!!opencv-matrix\n ")), FileError);
  CHECK_THROWS_AS(load_rig(folder.write("odd.json", "{ :!!opencv-matrix")), FileError);
  // The same: OpenCV's parser of XML reads beyond an end that follows an attribute's `=`.
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<M1 type_id=\"opencv-matrix\"><rows>1</rows><cols>1</cols><dt>d</dt>"
      "<data>1.</data></M1>\n</opencv_storage>\n";
  for (std::size_t at = 1; at < xml.size(); ++at) {
    CAPTURE(at);
    CHECK_THROWS_AS(load_rig(folder.write("cut.xml", xml.substr(0, at))), FileError);
    std::string zero = xml;
    zero[at] = '\0';
    CHECK_THROWS_WITH(load_rig(folder.write("zero.xml", zero)), Contains("a byte 0"));
  }
  CHECK_THROWS_WITH(load_rig(folder.write(
                        "open.xml", "<?xml version=\"1.0\"?>\n<opencv_storage><M1 type_id= <!-- </opencv_storage>")),
                    Contains("a comment without an end"));
  const std::string huge =
      "%YAML:1.0\n---\nM: !!opencv-matrix\n   rows: 100000\n   cols: 100000\n   dt: d\n   data: [1]\n";
  CHECK_THROWS_WITH(load_rig(folder.write("huge.yml", huge)), Contains("M: not a matrix"));
  CHECK_THROWS_WITH(load_rig(replaced("fx_px: 533.5631560014582", "fx_px: 1e300")),
                    Contains("a focal length of 1e+300"));
  CHECK_THROWS_WITH(load_rig(folder.write("k.yaml", "cam0:\n  camera_model: omni\n")), Contains("omni"));
  CHECK_THROWS_WITH(load_rig(folder.write("k.yaml",
                                          "cam0: {camera_model: pinhole, intrinsics: [1, 2, 3, 4], distortion_model: "
                                          "equidistant, distortion_coeffs: [0, 0, 0, 0], resolution: [4, 4]}\n")),
                    Contains("equidistant"));
  // Degrees where radians are expected; half a turn, rounded up, is one.
  const auto turned = [&](const std::string& vector) {
    Exported exported = to_opencv(example());
    std::string& text = exported.files.front().text;
    const auto begin = text.find("\nR: "), end = text.find("\nT: ");
    REQUIRE(begin < end);
    REQUIRE(end != std::string::npos);
    text.replace(begin, end - begin, "\nR: " + vector);
    return load_rig(write_all(folder, exported)).rig;
  };
  CHECK_THROWS_WITH(turned("[ 0., 5., 0. ]"), Contains("R: a rotation by 5 radians") && Contains("not degrees"));
  CHECK(turned("[ 0., 0., 3.1416 ]").between(0, 1).rotation(0, 0) == Approx(-1));
  // Metres where mm are expected.
  Rig small = example();
  small.cameras[1].world_to_camera.translation_mm /= 1000;
  CHECK_THROWS_WITH(load_rig(write_all(folder, to_opencv(small))), Contains("mm apart") && Contains("unit"));
  Exported metres = to_opencv(small);
  std::string& text = metres.files.front().text;
  CHECK_THROWS_WITH(load_rig(write_all(folder, metres), {.opencv_unit_mm = 1000}), Contains("that --unit names"));
  text.erase(text.find("length_unit: mm"), std::string_view("length_unit: mm").size());
  CHECK(load_rig(write_all(folder, metres), {.opencv_unit_mm = 1000}).rig.baseline_mm() == Approx(99.82).epsilon(1e-3));
}
