// SPDX-License-Identifier: Apache-2.0
#include "horopter/draw/plan_drawing.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "horopter/base/xml.hpp"
#include "horopter/plan/plan.hpp"

namespace horopter {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPanel = 420;  // px, width and height
constexpr double kHead = 34;
constexpr double kGap = 24;
constexpr int kSamples = 48;  // of a skin, along and across the image

constexpr const char* kSeen = "#2ca02c";
constexpr const char* kUnseen = "#ff7f0e";
constexpr const char* kZone = "#999999";
constexpr const char* kEntry = "#d62728";
constexpr const char* kObstacle = "#222222";

/// Coordinates of the rig: x along the baseline, z along the axis of symmetry.
class RigFrame {
 public:
  explicit RigFrame(const CameraPair& cameras) : axis_(cameras) {
    const Vector3d base = cameras.right().world_to_camera.centre() - cameras.left().world_to_camera.centre();
    y_ = axis_.direction.cross(base).normalized();
    x_ = y_.cross(axis_.direction);
  }
  Vector3d operator()(const Vector3d& place) const { return turn(place - axis_.middle_mm); }
  Vector3d turn(const Vector3d& direction) const {
    return {x_.dot(direction), y_.dot(direction), axis_.direction.dot(direction)};
  }

 private:
  StereoAxis axis_;
  Vector3d x_, y_;
};

struct Dot {
  Vector3d place;  // rig's coordinates
  const char* colour;
};

/// 1, 2 or 5 times a power of ten, at most.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= length) return factor * power;
  return power;
}

/// One view: `across` is the rig's axis that goes to the right.
class View {
 public:
  View(double left_px, int across, const Eigen::AlignedBox3d& box, double scale)
      : left_(left_px), across_(across), middle_(box.center()[across]), top_(box.min().z()), scale_(scale) {}
  Vector2d operator()(const Vector3d& place) const {
    return {left_ + kPanel / 2 + (place[across_] - middle_) * scale_, kHead + (place.z() - top_) * scale_};
  }
  int across() const { return across_; }

 private:
  double left_;
  int across_;
  double middle_, top_, scale_;
};

std::string wedge(const View& view, const RigFrame& frame, const calib::Camera& camera, double deepest,
                  const char* colour) {
  // The outermost of the pixels at the sides: with distortion not those of the middle row.
  const auto sight = [&](double u, double v) -> Vector3d {
    const auto normalised = camera.model.undistort({u * (camera.width_px - 1), v * (camera.height_px - 1)});
    if (!normalised) return Vector3d::Constant(NAN);
    return frame.turn(camera.world_to_camera.rotation.transpose() * normalised->homogeneous());
  };
  const Vector3d place = frame(camera.world_to_camera.centre());
  double low = INFINITY;
  double high = -INFINITY;
  for (int i = 0; i <= 20; ++i) {
    for (const double side : {0.0, 1.0}) {
      const Vector3d way = view.across() == 0 ? sight(side, i / 20.0) : sight(i / 20.0, side);
      if (!(way.z() > 0)) continue;
      low = std::min(low, way[view.across()] / way.z());
      high = std::max(high, way[view.across()] / way.z());
    }
  }
  if (!(low < high)) return "";
  const auto corner = [&](double slope) {
    Vector3d at = place;
    at.z() = deepest;
    at[view.across()] += slope * (deepest - place.z());
    return view(at);
  };
  const Vector2d a = view(place);
  const Vector2d b = corner(low);
  const Vector2d c = corner(high);
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z\" fill=\"{}\" fill-opacity=\"0.13\" stroke=\"{}\" "
      "stroke-opacity=\"0.6\"/>\n<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"><title>{}</title></circle>\n",
      a.x(), a.y(), b.x(), b.y(), c.x(), c.y(), colour, colour, a.x(), a.y(), colour, xml_text(camera.name));
}

}  // namespace

std::string draw_plan(const std::string& title, const CameraPair& cameras, const std::vector<PlannedView>& skins,
                      const EntryPlan* entries) {
  const RigFrame frame(cameras);
  Eigen::AlignedBox3d box;
  std::vector<Dot> dots;
  const auto add = [&](const Vector3d& place, const char* colour) {
    dots.push_back({frame(place), colour});
    box.extend(dots.back().place);
  };
  for (const calib::Camera* camera : {&cameras.left(), &cameras.right()}) {
    box.extend(frame(camera->world_to_camera.centre()));
  }
  std::vector<std::pair<std::string, double>> labels;
  for (const PlannedView& skin : skins) {
    std::vector<Point> pixels;
    std::vector<Sight> sights;
    const int subsample = cameras.left().width_px / skin.watch->width();
    const int row_step = cameras.left().height_px / skin.watch->height();
    for (int j = 0; j < kSamples; ++j) {
      for (int i = 0; i < kSamples; ++i) {
        const int x = i * (skin.watch->width() - 1) / (kSamples - 1);
        const int y = j * (skin.watch->height() - 1) / (kSamples - 1);
        pixels.push_back({(x + 0.5) * subsample - 0.5, static_cast<double>(y) * row_step});
        sights.push_back(skin.watch->pixel(x, y));
      }
    }
    const Rays rays = cameras.rays(pixels);
    std::vector<Hit> hits(pixels.size());
    const Vector3d left = cameras.left().world_to_camera.centre();
    skin.watch->skin().intersect(left, rays.directions, hits);
    double nearest = INFINITY;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (!std::isfinite(hits[i].distance) || sights[i] == Sight::no_skin) continue;
      // What is outside the right image may be far away: it does not set the scale.
      const Vector3d place = left + hits[i].distance * rays.directions[i];
      if (sights[i] == Sight::outside_right || sights[i] == Sight::angle) {
        dots.push_back({frame(place), kUnseen});
        continue;
      }
      add(place, sights[i] == Sight::seen ? kSeen : kUnseen);
      nearest = std::min(nearest, dots.back().place.z());
    }
    if (std::isfinite(nearest)) labels.emplace_back(skin.name, nearest);
  }
  if (entries != nullptr) {
    for (const auto& mark : entries->skin) {
      if (mark.sight != Sight::seen) add(mark.place_mm, kUnseen);
    }
    for (const Vector3d& place : entries->zone_mm) add(place, kZone);
    for (const Vector3d& place : entries->unseen_mm) add(place, kEntry);
    for (const Vector3d& place : entries->path_mm) box.extend(frame(place));
    for (const Vector3d& place : entries->obstacles_mm) dots.push_back({frame(place), kObstacle});
  }
  const Vector3d room = 0.06 * box.sizes().array() + 0.02 * box.sizes().maxCoeff();
  box.min() -= room;
  box.max() += room;
  const double scale = kPanel / box.sizes().maxCoeff();
  const double height = kHead + box.sizes().z() * scale;

  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\" "
      "font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"10\" y=\"15\" "
      "font-size=\"13\">{2}</text>\n",
      2 * kPanel + kGap, height + 58, xml_text(title));
  for (const int across : {0, 1}) {
    const double left = across * (kPanel + kGap);
    const View view(left, across, box, scale);
    svg += fmt::format("<clipPath id=\"view{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{:.1f}\"/></clipPath>\n",
                       across, left, kHead, kPanel, height - kHead);
    svg +=
        fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-weight=\"bold\">{}</text>\n<g clip-path=\"url(#view{})\">\n",
                    left + 10, kHead - 4, across == 0 ? "baseline to the right" : "baseline into the page", across);
    svg += wedge(view, frame, cameras.left(), box.max().z(), "#1f77b4");
    svg += wedge(view, frame, cameras.right(), box.max().z(), "#9467bd");
    const Vector2d from = view({0, 0, 0});
    const Vector2d to = view({0, 0, box.max().z()});
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#888\" stroke-dasharray=\"6 4\"/>\n",
                       from.x(), from.y(), to.x(), to.y());
    // Dots at one place of the drawing are drawn once. Of obstacles, a section through the axis of symmetry.
    for (const char* colour : {kZone, kObstacle, kEntry, kUnseen, kSeen}) {
      std::set<std::pair<int, int>> drawn;
      std::string path;
      for (const Dot& dot : dots) {
        if (dot.colour != colour) continue;
        if (colour == kObstacle && std::abs(dot.place[1 - across]) > 0.6 * entries->step_mm) continue;
        const Vector2d at = view(dot.place);
        if (!(std::abs(at.x()) < 1e4 && std::abs(at.y()) < 1e4)) continue;
        if (!drawn.insert({static_cast<int>(std::round(2 * at.x())), static_cast<int>(std::round(2 * at.y()))}).second)
          continue;
        path += fmt::format("M{:.1f} {:.1f}h0", at.x(), at.y());
      }
      if (path.empty()) continue;
      svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" fill=\"none\"/>\n",
                         path, colour, colour == kEntry ? 4 : 2.4);
    }
    if (entries != nullptr && !entries->path_mm.empty()) {
      std::string path;
      for (const Vector3d& place : entries->path_mm) {
        const Vector2d at = view(frame(place));
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x(), at.y());
      }
      svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"1.5\" fill=\"none\"/>\n", path, kEntry);
    }
    for (const auto& [name, z] : labels) {
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\">{}</text>\n", left + 6,
                         view({0, 0, z}).y() - 3, xml_text(name));
    }
    svg += "</g>\n";
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{:.1f}\" fill=\"none\" stroke=\"black\"/>\n",
                       left, kHead, kPanel, height - kHead);
  }
  const double bar = round_length(0.25 * kPanel / scale);
  svg += fmt::format(
      "<path d=\"M10 {0:.1f}h{1:.1f}M10 {2:.1f}v8M{3:.1f} {2:.1f}v8\" stroke=\"black\" fill=\"none\"/><text "
      "x=\"{4:.1f}\" "
      "y=\"{5:.1f}\">{6:g} mm</text>\n",
      height + 14, bar * scale, height + 10, 10 + bar * scale, 16 + bar * scale, height + 18, bar);
  double x = 10;
  const auto legend = [&](const char* colour, const std::string& text) {
    svg += fmt::format(
        "<circle cx=\"{:.0f}\" cy=\"{:.0f}\" r=\"4\" fill=\"{}\"/><text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n", x + 4,
        height + 40, colour, x + 12, height + 44, xml_text(text));
    x += 22 + 5.5 * static_cast<double>(text.size());
  };
  legend("#1f77b4", "left camera");
  legend("#9467bd", "right camera");
  legend(kSeen, "skin, supervised");
  legend(kUnseen, "skin, not supervised");
  if (entries != nullptr) {
    legend(kZone, "protected zone");
    if (!entries->unseen_mm.empty()) legend(kEntry, "entered unseen, a way in");
    if (!entries->obstacles_mm.empty()) legend(kObstacle, "obstacles (section)");
  }
  return svg + "</svg>\n";
}

}  // namespace horopter
