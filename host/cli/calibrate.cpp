// SPDX-License-Identifier: Apache-2.0
// horopter calibrate: cameras from points, from images of a flat target, or from other programs' files.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/calib/error.hpp"
#include "horopter/calib/points.hpp"
#include "horopter/calib/report.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/calib/target.hpp"
#include "horopter/calib/views.hpp"
#include "horopter/image/frames.hpp"
#include "horopter/image/mat.hpp"
#include "horopter/image/output.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "progress.hpp"
#include "settings.hpp"

namespace horopter::cli {
namespace {

struct CalibrateOptions {
  std::vector<std::string> points, withhold, right_points, right_withhold;
  std::string sensor, right_sensor;
  std::string method;
  std::string centre = "auto";
  std::string lens;

  std::vector<std::string> left, right, images;
  bool pair_by_order = false;
  std::string target;
  std::string distortion;
  std::vector<double> heights_mm;

  std::vector<std::string> import;
  std::string unit;  // of OpenCV's files
  std::string size;

  std::string output, export_opencv, export_ros, picture;
  bool json = false;
};

/// The calibration library has its own errors: a message about a file, or about what was measured.
[[noreturn]] void rethrow(const std::string& what) { throw Error(ExitStatus::bad_file, what); }

/// A message about points names the files they came from.
std::string from_files(const std::vector<std::string>& files, const std::string& message) {
  return files.front() + (files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : "") + ": " + message;
}

struct PointFile {
  std::string name;
  std::vector<std::array<double, 5>> sorted_points;
};

/// Throws FileError where all the points of one file are in the other, too: they would count twice, or judge themselves.
void check_apart(const PointFile& a, const PointFile& b) {
  const auto& [small, large] = a.sorted_points.size() < b.sorted_points.size() ? std::tie(a, b) : std::tie(b, a);
  if (!std::ranges::includes(large.sorted_points, small.sorted_points)) return;
  throw FileError(small.name, "", fmt::format("all its points are in {}, too", large.name), "each measurement once");
}

/// The points of all files, none of which repeats another or one of `earlier`; they are added to these.
std::vector<calib::PointPair> read_all(const std::vector<std::string>& files, std::vector<PointFile>& earlier) {
  std::vector<calib::PointPair> points;
  for (const std::string& file : files) {
    const auto more = calib::read_points(file);
    points.insert(points.end(), more.begin(), more.end());
    PointFile read{file, {}};
    for (const auto& [world, pixel] : more) {
      read.sorted_points.push_back({world.x(), world.y(), world.z(), pixel.x(), pixel.y()});
    }
    std::ranges::sort(read.sorted_points);
    for (const PointFile& other : earlier) check_apart(other, read);
    earlier.push_back(std::move(read));
  }
  return points;
}

calib::PointOptions point_options(const CalibrateOptions& options) {
  calib::PointOptions result;
  if (options.centre == "given") {
    result.centre = calib::CentreSearch::given;
  } else if (options.centre == "search") {
    result.centre = calib::CentreSearch::searched;
  } else if (options.centre != "auto") {
    throw UsageError(fmt::format("--centre '{}'; expected auto, given or search", options.centre));
  }
  std::string rest = options.lens.empty() ? "k1" : options.lens;
  if (rest.starts_with("k1")) rest.erase(0, 2);
  const auto take = [&](const char* term) {
    const auto at = rest.find(term);
    if (at == std::string::npos) return false;
    rest.erase(at, 2);
    return true;
  };
  result.kappa2 = take("k2");
  result.kappa3 = take("k3");
  const bool p1 = take("p1"), p2 = take("p2"), s1 = take("s1"), s2 = take("s2");
  result.decentring = p1;
  result.thin_prism = s1;
  if (!rest.empty() || p1 != p2 || s1 != s2 || (!options.lens.empty() && !options.lens.starts_with("k1"))) {
    throw UsageError(
        fmt::format("--distortion '{}'; for points expected k1, then any of k2 k3 p1p2 s1s2", options.lens));
  }
  return result;
}

calib::Report from_points(const CalibrateOptions& options) {
  if (options.sensor.empty()) throw UsageError("--points needs --sensor FILE");
  calib::PointMethod method;
  try {
    method = calib::point_method(options.method.empty() ? "full" : options.method);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--method: ") + error.what());
  }
  const calib::PointOptions point = point_options(options);
  std::vector<calib::PointCalibration> cameras;
  std::vector<calib::PointErrors> withheld;
  const auto add = [&](const std::vector<std::string>& files, const std::vector<std::string>& withhold,
                       const std::string& sensor_file, const std::string& name) {
    std::vector<PointFile> read;
    const auto points = read_all(files, read);
    const calib::Sensor sensor = calib::read_sensor(sensor_file);
    const auto held = read_all(withhold, read);
    try {
      cameras.push_back(calib::calibrate_points(points, sensor, method, point));
    } catch (const calib::CalibrationError& error) {
      throw calib::CalibrationError(from_files(files, error.what()));
    }
    cameras.back().camera.name = name;
    if (held.empty()) return;
    try {
      withheld.push_back(calib::evaluate(cameras.back().camera, held));
    } catch (const calib::CalibrationError& error) {
      throw calib::CalibrationError(from_files(withhold, error.what()));
    }
  };
  const bool two = !options.right_points.empty();
  add(options.points, options.withhold, options.sensor, two ? "left" : "camera");
  if (two) {
    add(options.right_points, options.right_withhold,
        options.right_sensor.empty() ? options.sensor : options.right_sensor, "right");
  }
  calib::Report report = calib::report_of(cameras);
  if (!withheld.empty()) report.withheld = calib::merge(withheld);
  return report;
}

/// The target in one image; what keeps it from being found becomes part of the report.
calib::SeenTarget find_target(const NamedImage& named, const calib::TargetSpec& spec) {
  calib::SeenTarget seen{.file = named.name, .pixels = {}, .problem = {}};
  try {
    calib::TargetView view = calib::detect_target(mat_of(named.image), spec);
    seen.pixels = std::move(view.image_px);
    seen.oriented = view.oriented;
  } catch (const calib::TargetError& error) {
    seen.problem = error.what();
  }
  return seen;
}

calib::Report from_images(const CalibrateOptions& options) {
  if (options.target.empty()) {
    throw UsageError(
        "images need --target: chessboard:9x6:30mm (inner corners, side), squares:8x8:12.7mm:22.58mm (side, pitch) or "
        "diamonds:…");
  }
  calib::TargetSpec spec;
  calib::ViewOptions view_options;
  try {
    spec = calib::TargetSpec::parse(options.target);
    view_options.distortion =
        calib::distortion_terms(options.distortion.empty() ? "k1k2p1p2" : std::string_view(options.distortion));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  view_options.heights_mm = options.heights_mm;
  if (!options.sensor.empty()) view_options.pitch_mm = calib::read_sensor(options.sensor).dy_mm;

  std::vector<calib::ViewCamera> cameras;
  Progress progress("images searched for the target:");
  std::size_t searched = 0;
  const auto take = [&](calib::ViewCamera& camera, const NamedImage& image, std::optional<std::size_t> count) {
    if (camera.views.empty()) {
      camera.width_px = image.image.width;
      camera.height_px = image.image.height;
    } else if (camera.width_px != image.image.width || camera.height_px != image.image.height) {
      throw FileError(image.name, "", fmt::format("the image is {}x{} pixels", image.image.width, image.image.height),
                      fmt::format("{}x{} as {}", camera.width_px, camera.height_px, camera.views.front().file));
    }
    camera.views.push_back(find_target(image, spec));
    progress.show(++searched, count);
  };
  if (!options.images.empty()) {
    cameras.push_back({.name = "camera", .views = {}});
    const auto source = open_frames(options.images);
    while (auto image = source->next()) {
      take(cameras[0], *image, source->count());
    }
  } else {
    if (options.left.empty() || options.right.empty()) throw UsageError("--left and --right go together");
    cameras.push_back({.name = "left", .views = {}});
    cameras.push_back({.name = "right", .views = {}});
    PairSource source(options.left, options.right,
                      options.pair_by_order ? PairNumbers::ignored : PairNumbers::must_agree);
    while (auto pair = source.next()) {
      const auto pairs = source.count();
      const auto images = pairs ? std::optional(2 * *pairs) : std::nullopt;
      take(cameras[0], pair->left, images);
      take(cameras[1], pair->right, images);
    }
  }
  progress.clear();
  try {
    return calib::calibrate_views(cameras, spec.points_mm(), view_options);
  } catch (const calib::CalibrationError& error) {
    // The views still say which images held the target.
    calib::Report report;
    report.method = "joint";
    report.problems.push_back(error.what());
    for (const calib::ViewCamera& camera : cameras) {
      for (std::size_t i = 0; i < camera.views.size(); ++i) {
        const calib::SeenTarget& seen = camera.views[i];
        report.views.push_back({.camera = camera.name,
                                .file = seen.file,
                                .view = static_cast<int>(i),
                                .found = !seen.pixels.empty(),
                                .problem = seen.problem});
      }
    }
    return report;
  }
}

calib::RigFile import_files(const CalibrateOptions& options) {
  calib::ImportOptions import;
  if (options.unit == "m") {
    import.opencv_unit_mm = 1000;
  } else if (options.unit == "cm") {
    import.opencv_unit_mm = 10;
  } else if (options.unit == "mm") {
    import.opencv_unit_mm = 1;
  } else if (!options.unit.empty()) {
    throw UsageError(fmt::format("--unit '{}'; expected mm, cm or m", options.unit));
  }
  if (!options.size.empty()) {
    const auto size = size_of(options.size);
    if (!size) throw UsageError(fmt::format("--size '{}'; expected WIDTHxHEIGHT, as 640x480", options.size));
    std::tie(import.width_px, import.height_px) = *size;
  }
  return calib::load_rig(std::vector<std::filesystem::path>(options.import.begin(), options.import.end()), import);
}

std::vector<NamedFile> named(const char* option, const std::vector<std::string>& files) {
  std::vector<NamedFile> result;
  for (const std::string& file : files) result.push_back({option, file});
  return result;
}

/// `ros`: what is written into --export-ros. A rig.yaml may be imported and written to itself: import_rig looks at that.
void check_places(const CalibrateOptions& options, const std::vector<calib::ExportedFile>& ros) {
  std::vector<NamedFile> outputs{{"--export-opencv", options.export_opencv}, {"--picture", options.picture}};
  for (const calib::ExportedFile& file : ros) {
    outputs.push_back({"--export-ros", (std::filesystem::path(options.export_ros) / file.name).string()});
  }
  check_outputs(outputs, named("--import", options.import));
  outputs.push_back({"--output", options.output});
  std::vector<NamedFile> inputs{{"--sensor", options.sensor}, {"--right-sensor", options.right_sensor}};
  for (const auto& [option, files] : {std::pair{"--points", &options.points},
                                      {"--withhold", &options.withhold},
                                      {"--right-points", &options.right_points},
                                      {"--right-withhold", &options.right_withhold},
                                      {"--left", &options.left},
                                      {"--right", &options.right},
                                      {"--images", &options.images}}) {
    for (const NamedFile& file : named(option, *files)) inputs.push_back(file);
  }
  check_outputs(outputs, inputs);
}

std::vector<std::string> write_rig(const CalibrateOptions& options, const calib::Rig& rig) {
  // Before anything is written: a rig that a format cannot hold leaves nothing.
  calib::Exported opencv, ros;
  if (!options.export_opencv.empty()) opencv = calib::to_opencv(rig);
  if (!options.export_ros.empty()) ros = calib::to_ros(rig);
  check_places(options, ros.files);
  if (!options.export_opencv.empty()) write_file(options.export_opencv, opencv.files.front().text);
  if (!options.export_ros.empty()) {
    OutputDirectory directory(options.export_ros);
    for (const calib::ExportedFile& file : ros.files) directory.write(file.name, file.text);
    directory.commit();
  }
  if (!options.output.empty()) write_file(options.output, calib::to_yaml(rig));  // last: where it is, all is
  std::vector<std::string> warnings = std::move(opencv.warnings);
  warnings.insert(warnings.end(), ros.warnings.begin(), ros.warnings.end());
  return warnings;
}

nlohmann::json rig_json(const calib::RigFile& file) {
  nlohmann::json cameras = nlohmann::json::array();
  for (const calib::Camera& camera : file.rig.cameras) {
    nlohmann::json rotation = nlohmann::json::array(), translation = nlohmann::json::array();
    for (int row = 0; row < 3; ++row) {
      const Eigen::RowVector3d r = camera.world_to_camera.rotation.row(row);
      rotation.push_back({r[0], r[1], r[2]});
      translation.push_back(camera.world_to_camera.translation_mm[row]);
    }
    const auto lens = camera.model.lens().coefficients().array();
    cameras.push_back({{"name", camera.name},
                       {"image_size", {camera.width_px, camera.height_px}},
                       {"fx_px", camera.model.fx_px()},
                       {"fy_px", camera.model.fy_px()},
                       {"cx_px", camera.model.cx_px()},
                       {"cy_px", camera.model.cy_px()},
                       {"lens", std::vector<double>(lens.begin(), lens.end())},
                       {"rotation", rotation},
                       {"translation_mm", translation}});
  }
  const double baseline = file.rig.baseline_mm();
  return {{"method", "import"},
          {"format", file.format},
          {"usable", true},
          {"baseline_mm", std::isfinite(baseline) ? nlohmann::json(baseline) : nlohmann::json(nullptr)},
          {"cameras", cameras},
          {"warnings", file.warnings}};
}

ExitStatus import_rig(const CalibrateOptions& options) {
  calib::RigFile file = import_files(options);
  if (file.format != "rig.yaml") check_outputs({{"--output", options.output}}, named("--import", options.import));
  const auto more = write_rig(options, file.rig);
  file.warnings.insert(file.warnings.end(), more.begin(), more.end());
  if (options.json) {
    std::puts(json_text(rig_json(file)).c_str());
    return ExitStatus::done;
  }
  fmt::print("format    {}\n", file.format);
  for (const calib::Camera& camera : file.rig.cameras) {
    fmt::print("camera    {}: {}x{} pixels, fx {:.4f}, fy {:.4f}, centre ({:.4f}, {:.4f}) px\n", camera.name,
               camera.width_px, camera.height_px, camera.model.fx_px(), camera.model.fy_px(), camera.model.cx_px(),
               camera.model.cy_px());
  }
  if (file.rig.cameras.size() > 1) fmt::print("baseline  {:.4f} mm\n", file.rig.baseline_mm());
  for (const std::string& warning : file.warnings) fmt::print("warning: {}\n", warning);
  return ExitStatus::done;
}

void check_usage(const CalibrateOptions& options) {
  const bool points = !options.points.empty(), images = !options.images.empty(),
             pairs = !options.left.empty() || !options.right.empty(), import = !options.import.empty();
  if (points + images + pairs + import != 1) {
    throw UsageError("expected one of --points, --left with --right, --images, or --import");
  }
  const auto only = [&](bool given, const char* name, bool allowed, const char* with) {
    if (given && !allowed) throw UsageError(fmt::format("{} goes with {} only", name, with));
  };
  only(!options.method.empty(), "--method", points, "--points");
  only(!options.withhold.empty(), "--withhold", points, "--points");
  only(!options.right_points.empty(), "--right-points", points, "--points");
  only(!options.right_sensor.empty() || !options.right_withhold.empty(), "--right-sensor or --right-withhold",
       !options.right_points.empty(), "--right-points");
  only(options.centre != "auto", "--centre", points, "--points");
  only(!options.target.empty(), "--target", images || pairs, "images");
  only(!options.heights_mm.empty(), "--heights", images || pairs, "images");
  only(!options.distortion.empty(), "--distortion", !import, "--points and images");
  only(!options.sensor.empty(), "--sensor", !import, "--points and images");
  only(!options.size.empty() || !options.unit.empty(), "--size or --unit", import, "--import");
  only(!options.picture.empty(), "--picture", !import, "--points and images");
}

ExitStatus calibrate(CalibrateOptions options) {
  check_usage(options);
  check_places(options, {});
  if (!options.import.empty()) return import_rig(options);
  calib::Report report;
  bool determined = true;
  if (!options.points.empty()) {
    options.lens = options.distortion;
    try {
      report = from_points(options);
    } catch (const calib::CalibrationError& error) {
      report.method = options.method.empty() ? "full" : options.method;
      report.problems.push_back(error.what());
      determined = false;
    }
  } else {
    report = from_images(options);
    determined = !report.cameras.empty();
  }
  if (const std::string problem = calib::baseline_problem(report.rig); report.usable && !problem.empty()) {
    report.problems.push_back(problem);
    report.usable = false;
  }
  if (!options.picture.empty() && determined) {
    const cv::Mat picture = calib::residual_picture(report);
    write_file(options.picture, encode_png_bgr(picture.cols, picture.rows, {picture.data, picture.total() * 3}));
  }
  if (report.usable) {
    const auto more = write_rig(options, report.rig);
    report.warnings.insert(report.warnings.end(), more.begin(), more.end());
  }
  if (options.json) {
    std::puts(json_text(calib::to_json(report)).c_str());
  } else if (determined) {
    std::fputs(calib::to_text(report).c_str(), stdout);
    for (const std::string& warning : report.warnings) {
      // A rig all the same, but one that should not be relied on: not at the end of a long report only.
      if (!warning.starts_with("one_view") && !warning.starts_with("one_pair")) continue;
      std::fprintf(stderr, "horopter: warning: %s\n", warning.c_str());
    }
  }
  if (!report.usable) {
    std::string all;
    for (const std::string& problem : report.problems) all += (all.empty() ? "" : "; ") + problem;
    if (!determined) rethrow(all);
    throw Error(ExitStatus::check_failed, "no rig is made: " + all);
  }
  return ExitStatus::done;
}

}  // namespace

void add_calibrate(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command =
      app.add_subcommand("calibrate", "Calibrate cameras from points or images, or read other programs' calibrations");
  const auto files = [&](const char* name, std::vector<std::string>& value, const char* text, const char* group) {
    command->add_option(name, value, text)->type_name("FILE...")->group(group);
  };
  files("--left", options->left, "Images of the left camera: files, globs, directories",
        "From images of a flat target");
  files("--right", options->right, "Images of the right camera, in the same order", "From images of a flat target");
  add_pair_by_order(*command, options->pair_by_order)->group("From images of a flat target");
  files("--images", options->images, "Images of a single camera", "From images of a flat target");
  command
      ->add_option("--target", options->target,
                   "chessboard:9x6:30mm (inner corners, side), squares:8x8:12.7mm:22.58mm (side, pitch), diamonds:…")
      ->type_name("SPEC")
      ->group("From images of a flat target");
  command
      ->add_option("--heights", options->heights_mm,
                   "The target was lifted to these heights (mm), one per image, and not moved otherwise")
      ->delimiter(',')
      ->check(any_number())
      ->type_name("MM,...")
      ->group("From images of a flat target");
  files("--points", options->points, "Lines of x_mm y_mm z_mm u_px v_px; several files are one set", "From points");
  files("--withhold", options->withhold, "Other points, which take no part and judge the result", "From points");
  files("--right-points", options->right_points, "The same for a second camera, in the same world", "From points");
  files("--right-withhold", options->right_withhold, "Withheld points of the second camera", "From points");
  command
      ->add_option("--sensor", options->sensor,
                   "width_px height_px dx_mm dy_mm cx_px cy_px [sx]; with images only for f in mm")
      ->type_name("FILE");
  command->add_option("--right-sensor", options->right_sensor, "Sensor of the second camera (default: the same)")
      ->type_name("FILE")
      ->group("From points");
  command->add_option("--method", options->method, "dlt (linear), tsai (two steps) or full (default)")
      ->type_name("M")
      ->group("From points");
  command
      ->add_option("--centre", options->centre,
                   "Image centre of tsai, start of full: given by the sensor, search, or auto (default)")
      ->type_name("HOW")
      ->group("From points");
  command
      ->add_option("--distortion", options->distortion,
                   "Images: none or a row of k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 of OpenCV's model (default k1k2p1p2). "
                   "Points: k1, then any of k2 k3 p1p2 s1s2 of the thesis's model (default k1)")
      ->type_name("TERMS");
  files("--import", options->import,
        "rig.yaml, OpenCV FileStorage (YAML, XML, JSON), ROS camera_info (left, right) or Kalibr camchain",
        "From other programs");
  command->add_option("--unit", options->unit, "Unit of T in OpenCV's files, which do not say it: mm, cm or m")
      ->type_name("U")
      ->group("From other programs");
  command->add_option("--size", options->size, "Image size where the files do not say, WIDTHxHEIGHT")
      ->type_name("WxH")
      ->group("From other programs");
  command->add_option("-o,--output", options->output, "The rig to write (rig.yaml)")->type_name("FILE");
  command->add_option("--export-opencv", options->export_opencv, "Write it as OpenCV FileStorage too (.yml)")
      ->type_name("FILE");
  command->add_option("--export-ros", options->export_ros, "Write it as ROS camera_info too")->type_name("DIR");
  command->add_option("--picture", options->picture, "Residuals as vectors over the images (PNG)")->type_name("FILE");
  command->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  command->footer(
      "No rig is written unless the measurements determine it: exit status 3 when they cannot, 1 when the result is not\n"
      "good enough to be used. Image coordinates: (0, 0) is the centre of the first pixel.\n\n"
      "Examples:\n"
      "  horopter calibrate --left left*.jpg --right right*.jpg --target chessboard:9x6:30mm -o rig.yaml\n"
      "  horopter calibrate --points low.txt high.txt --withhold middle.txt --sensor sensor.yaml --method full\n"
      "  horopter calibrate --import intrinsics.yml extrinsics.yml --size 640x480 --unit mm -o rig.yaml");
  command->callback([options, &outcome] {
    try {
      outcome.status = calibrate(*options);
    } catch (const calib::CalibrationError& error) {
      rethrow(error.what());
    }
  });
}

}  // namespace horopter::cli
