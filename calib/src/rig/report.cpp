// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "camera/parameter_list.hpp"
#include "camera/rotation.hpp"
#include "rig/judge.hpp"

namespace horopter::calib {
namespace {

using namespace detail;
using Eigen::Vector2d;
using nlohmann::json;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// JSON has neither infinity nor NaN.
json finite(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json values(const std::vector<Parameter>& parameters) {
  json object = json::object();
  for (const Parameter& parameter : parameters) object[parameter.name] = finite(parameter.value);
  return object;
}

json deviations(const std::vector<Parameter>& parameters) {
  json object = json::object();
  for (const Parameter& parameter : parameters) {
    if (parameter.free) object[parameter.name] = finite(parameter.sd);
  }
  return object;
}

/// A mean over the points; null where there are none.
json over(const PointErrors& errors, double value) { return errors.count > 0 ? finite(value) : json(nullptr); }

json error_json(const PointErrors& errors) {
  return {{"mean", over(errors, errors.mean_px)},
          {"sd", over(errors, errors.sd_px)},
          {"max", over(errors, errors.max_px)},
          {"rms", over(errors, errors.rms_px)},
          {"points", errors.count}};
}

/// Enough digits for the deviation to be read.
std::string parameter_text(const Parameter& parameter) {
  if (!parameter.free) return fmt::format("{:.6g}  (fixed)", parameter.value);
  if (!std::isfinite(parameter.sd)) return fmt::format("{:.6g}  (not determined)", parameter.value);
  if (!(parameter.sd > 0)) return fmt::format("{:.8g}", parameter.value);
  const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(parameter.sd))), 0, 15);
  const bool small = std::abs(parameter.value) < 1e-3 && parameter.value != 0;
  return small ? fmt::format("{:.4e} ± {:.1e}", parameter.value, parameter.sd)
               : fmt::format("{:.{}f} ± {:.{}f}", parameter.value, digits, parameter.sd, digits);
}

/// The limits of a camera from images hold for one from points.
void judge(const CameraReport& own, const Camera& camera, bool coplanar, Report& report) {
  const auto sd = [&](const char* name) { return std::ranges::find(own.parameters, name, &Parameter::name)->sd; };
  // What one plane cannot tell the warning one_plane says.
  if (!coplanar) judge_intrinsics(camera, sd("fy_px"), std::max(sd("cx_px"), sd("cy_px")), report);
  judge_fit(camera.name + ": the points", own.rms_px, camera.width_px,
            "are they in one unit, and each pixel that of its point?", report);
}

/// Of the second camera in the first's coordinates. Given the points, the two cameras are independent.
Matrix6 relative_covariance(const Pose& relative, const Pose& first, const Matrix6& of_first,
                            const Matrix6& of_second) {
  // Both poses change by a small rotation d and a translation s: R by d₂ − R·d₁, and t = t₂ − R·t₁ with it.
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = relative.rotation;
  Matrix6 by_second = Matrix6::Identity();
  by_second.bottomLeftCorner<3, 3>() = cross_matrix(relative.rotation * first.translation_mm);
  const Matrix6 by_first = by_second * turned;
  return by_second * of_second * by_second.transpose() + by_first * of_first * by_first.transpose();
}

}  // namespace

PointErrors merge(std::span<const PointErrors> errors) {
  PointErrors all;
  double sum = 0, squares = 0, nce = 0;
  for (const PointErrors& part : errors) {
    all.count += part.count;
    const auto n = static_cast<double>(part.count);
    sum += n * part.mean_px;
    squares += n * part.rms_px * part.rms_px;
    nce += n * part.nce;
    all.max_px = std::max(all.max_px, part.max_px);
    all.residuals_px.insert(all.residuals_px.end(), part.residuals_px.begin(), part.residuals_px.end());
  }
  if (all.count == 0) return all;
  const auto n = static_cast<double>(all.count);
  all.mean_px = sum / n;
  all.rms_px = std::sqrt(squares / n);
  all.sd_px = all.count > 1 ? std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1))) : 0;
  all.nce = nce / n;
  all.nce_thesis = all.nce / 0.2;
  return all;
}

Report report_of(std::span<const PointCalibration> cameras) {
  Report report;
  std::vector<PointErrors> errors;
  for (const PointCalibration& calibration : cameras) {
    report.method = point_method_name(calibration.method);
    report.rig.cameras.push_back(calibration.camera);
    report.iterations += calibration.iterations;
    const std::string prefix = cameras.size() > 1 ? calibration.camera.name + ": " : "";
    for (const std::string& warning : calibration.warnings) {
      const auto colon = warning.find(": ");
      report.warnings.push_back(warning.substr(0, colon + 2) + prefix + warning.substr(colon + 2));
    }
    CameraReport& own = report.cameras.emplace_back();
    own.name = calibration.camera.name;
    own.parameters = calibration.parameters;
    own.parameters.push_back({"tz_over_f", calibration.tz_over_f, calibration.tz_over_f_sd, true});
    own.rms_px = calibration.errors.rms_px;
    own.pixels = calibration.pixels;
    own.residuals = calibration.errors.residuals_px;
    errors.push_back(calibration.errors);
  }
  report.rig.world = "the points' own";
  report.errors = merge(errors);
  if (cameras.size() > 1) {
    const Pose relative = report.rig.between(0, 1);
    report.baseline_mm = relative.translation_mm.norm();
    const Matrix6 covariance = relative_covariance(relative, cameras[0].camera.world_to_camera,
                                                   cameras[0].pose_covariance, cameras[1].pose_covariance);
    const Eigen::Vector3d direction = relative.translation_mm.normalized();
    report.baseline_sd_mm = std::sqrt(direction.dot(covariance.bottomRightCorner<3, 3>() * direction));
    append_pose(report.relative, relative, covariance, true);
    if (are_exchanged(report.rig.cameras[0], report.rig.cameras[1])) {
      report.warnings.push_back(fmt::format("left_right_exchanged: {} stands to the left of {}", report.cameras[1].name,
                                            report.cameras[0].name));
    }
  }
  for (std::size_t i = 0; i < cameras.size(); ++i)
    judge(report.cameras[i], report.rig.cameras[i], cameras[i].coplanar, report);
  report.usable = report.problems.empty();
  return report;
}

json to_json(const Report& report) {
  json parameters = json::object(), sds = json::object();
  if (!report.cameras.empty()) {
    parameters = values(report.cameras.front().parameters);
    sds = deviations(report.cameras.front().parameters);
  }
  json rms = json::object();
  for (const CameraReport& camera : report.cameras) {
    if (report.cameras.size() > 1) {
      parameters[camera.name] = values(camera.parameters);
      sds[camera.name] = deviations(camera.parameters);
    }
    rms[camera.name] = finite(camera.rms_px);
  }
  // Always the same members: a single camera is the left one.
  if (!rms.contains("left")) rms["left"] = report.cameras.empty() ? json(nullptr) : finite(report.cameras[0].rms_px);
  if (!rms.contains("right")) rms["right"] = nullptr;
  rms["stereo"] = report.cameras.size() > 1 ? over(report.errors, report.errors.rms_px) : json(nullptr);
  rms["all"] = over(report.errors, report.errors.rms_px);
  if (!report.relative.empty()) {
    parameters["relative"] = values(report.relative);
    sds["relative"] = deviations(report.relative);
  }
  json views = json::array();
  for (const ViewReport& view : report.views) {
    views.push_back({{"file", view.file},
                     {"camera", view.camera},
                     {"view", view.view},
                     {"found", view.found},
                     {"used", view.used},
                     {"rms_px", view.found && std::isfinite(view.rms_px) ? json(view.rms_px) : json(nullptr)},
                     {"problem", view.problem}});
  }
  json result{{"method", report.method},
              {"usable", report.usable},
              {"image_error_px", error_json(report.errors)},
              {"rms_px", rms},
              {"nce", over(report.errors, report.errors.nce)},
              {"nce_thesis", over(report.errors, report.errors.nce_thesis)},
              {"baseline_mm", report.baseline_mm ? finite(*report.baseline_mm) : json(nullptr)},
              {"baseline_sd_mm", report.baseline_mm ? finite(report.baseline_sd_mm) : json(nullptr)},
              {"parameters", parameters},
              {"standard_deviations", sds},
              {"views", views},
              {"warnings", report.warnings},
              {"problems", report.problems},
              {"iterations", report.iterations},
              {"seconds", report.seconds}};
  if (report.withheld) {
    result["withheld"] = {{"image_error_px", error_json(*report.withheld)},
                          {"nce", over(*report.withheld, report.withheld->nce)},
                          {"nce_thesis", over(*report.withheld, report.withheld->nce_thesis)}};
  }
  return result;
}

std::string to_text(const Report& report) {
  std::string text = fmt::format("method         {}\n", report.method);
  const auto line = [&](const std::string& name, const PointErrors& e) {
    text += fmt::format(
        "{:<14} {} points: mean {:.4f}, sd {:.4f}, max {:.4f}, RMS {:.4f} px; NCE {:.4f} (r_sp = 1), "
        "{:.3f} (r_sp = 0.2)\n",
        name, e.count, e.mean_px, e.sd_px, e.max_px, e.rms_px, e.nce, e.nce_thesis);
  };
  line("image error", report.errors);
  if (report.withheld) line("withheld", *report.withheld);
  for (const CameraReport& camera : report.cameras) {
    text += fmt::format("\ncamera {}: RMS {:.4f} px\n", camera.name, camera.rms_px);
    for (const Parameter& parameter : camera.parameters) {
      if (!parameter.free && parameter.value == 0) continue;
      text += fmt::format("  {:<16} {}\n", parameter.name, parameter_text(parameter));
    }
  }
  if (!report.relative.empty()) {
    text += fmt::format("\n{} as seen from {}\n", report.cameras[1].name, report.cameras[0].name);
    for (const Parameter& parameter : report.relative) {
      text += fmt::format("  {:<16} {}\n", parameter.name, parameter_text(parameter));
    }
  }
  if (report.baseline_mm) {
    text += fmt::format("  {:<16} {}\n", "baseline_mm",
                        parameter_text({"", *report.baseline_mm, report.baseline_sd_mm, true}));
  }
  if (!report.views.empty()) {
    text += "\nviews\n";
    for (const ViewReport& view : report.views) {
      text += view.found
                  ? fmt::format("  {:<8} {:.4f} px{}  {}{}\n", view.camera, view.rms_px, view.used ? "" : "  left out",
                                view.file, view.problem.empty() ? "" : " (" + view.problem + ")")
                  : fmt::format("  {:<8} not found  {} ({})\n", view.camera, view.file, view.problem);
    }
  }
  for (const std::string& warning : report.warnings) text += "warning: " + warning + "\n";
  for (const std::string& problem : report.problems) text += "NOT USABLE: " + problem + "\n";
  return text;
}

cv::Mat residual_picture(const Report& report) {
  int width = 0, height = 0;
  std::vector<int> lefts;
  for (const Camera& camera : report.rig.cameras) {
    lefts.push_back(width);
    width += std::max(camera.width_px, 64) + 8;
    height = std::max(height, std::max(camera.height_px, 64));
  }
  constexpr int kFooter = 40;
  cv::Mat picture(height + kFooter, std::max(width, 320), CV_8UC3, cv::Scalar(255, 255, 255));
  // The typical residual is drawn 15 pixels long, by a factor that is easy to read.
  std::vector<double> sizes;
  for (const CameraReport& camera : report.cameras) {
    for (const Vector2d& residual : camera.residuals) {
      if (residual.allFinite()) sizes.push_back(residual.norm());
    }
  }
  std::ranges::sort(sizes);
  const double typical = sizes.empty() ? 0 : sizes[sizes.size() * 3 / 4];
  double factor = 1;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 1e4, 1e5, 1e6}) {
    if (typical * step <= 20) factor = step;
  }
  constexpr int kShift = 4;  // sub-pixel drawing, in sixteenths
  const auto fixed = [](double x, double y) {
    return cv::Point(cvRound(std::clamp(x, -1e5, 1e5) * (1 << kShift)),
                     cvRound(std::clamp(y, -1e5, 1e5) * (1 << kShift)));
  };
  for (std::size_t c = 0; c < report.cameras.size(); ++c) {
    const CameraReport& camera = report.cameras[c];
    const Camera& model = report.rig.cameras[c];
    const int left = lefts[c];
    cv::rectangle(picture, {left, 0, std::max(model.width_px, 64), std::max(model.height_px, 64)}, {160, 160, 160});
    for (std::size_t i = 0; i < camera.pixels.size() && i < camera.residuals.size(); ++i) {
      const Vector2d& at = camera.pixels[i];
      const Vector2d& residual = camera.residuals[i];
      if (!residual.allFinite()) continue;
      const bool large = residual.norm() > 3 * camera.rms_px;
      const cv::Scalar colour = large ? cv::Scalar(0, 0, 220) : cv::Scalar(160, 80, 0);
      const cv::Point start = fixed(left + at.x(), at.y());
      const cv::Point end = fixed(left + at.x() + factor * residual.x(), at.y() + factor * residual.y());
      cv::line(picture, start, end, colour, 1, cv::LINE_AA, kShift);
      cv::circle(picture, start, 1 << kShift, colour, cv::FILLED, cv::LINE_AA, kShift);
    }
    const cv::Point centre = fixed(left + model.model.cx_px(), model.model.cy_px());
    const int arm = 6 << kShift;
    cv::line(picture, centre - cv::Point(arm, 0), centre + cv::Point(arm, 0), {0, 140, 0}, 1, cv::LINE_AA, kShift);
    cv::line(picture, centre - cv::Point(0, arm), centre + cv::Point(0, arm), {0, 140, 0}, 1, cv::LINE_AA, kShift);
    cv::putText(picture, fmt::format("{}: RMS {:.3f} px", camera.name, camera.rms_px), {left + 6, height + 16},
                cv::FONT_HERSHEY_SIMPLEX, 0.45, {0, 0, 0}, 1, cv::LINE_AA);
  }
  const double bar_px = 30 / factor;
  cv::line(picture, {6, height + 30}, {36, height + 30}, {0, 0, 0}, 2);
  cv::putText(picture, fmt::format("{:.3g} px, residuals {:g} times enlarged; red: more than 3 RMS", bar_px, factor),
              {44, height + 34}, cv::FONT_HERSHEY_SIMPLEX, 0.4, {0, 0, 0}, 1, cv::LINE_AA);
  return picture;
}

}  // namespace horopter::calib
