// SPDX-License-Identifier: Apache-2.0
// A skin in millimetres on real photographs: pairs of a chessboard from opencv-doc. Leave one out: the rig is
// calibrated on the other pairs, the plane of the board is found in the left image alone. Where does the map carry the
// corners, and what does the machine see of the board while the skin moves through it along its normal?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "board_pixels.hpp"
#include "boards.hpp"
#include "cli/progress.hpp"
#include "horopter/image/image.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/row_check.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using Eigen::Vector2d;

constexpr int kSlots = 15;
constexpr const char* kProfile = "vga";
/// Distortion terms: those for which the corners are carried, the first for the machine's frames.
constexpr std::array kTerms{"k1k2p1p2", "k1"};

std::vector<cv::Point2d> left_corners(const Board& board) {
  std::vector<cv::Point2d> corners;
  for (const Vector2d& corner : board.corners[0]) corners.emplace_back(corner.x(), corner.y());
  return corners;
}

/// Share of the board whose pixels a table for `compete` would supervise.
double staying_in_rows(const CameraPair& cameras, const Board& board) {
  const ViewLimits view = view_limits(find_profile(kProfile), Decision::compete);
  Image states = board.left;
  std::vector<Point> row(static_cast<std::size_t>(states.width));
  for (int y = 0; y < states.height; ++y) {
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = {static_cast<double>(x), static_cast<double>(y)};
    const Rays rays = cameras.rays(row, view);
    for (std::size_t x = 0; x < row.size(); ++x) {
      const bool stays = rays.row_error[x] <= kLargestRowError;
      states.pixels[static_cast<std::size_t>(y) * row.size() + x] =
          static_cast<std::uint8_t>(stays ? State::clear : State::unsupervised);
    }
  }
  return count_board(left_corners(board), states).decidable_share();
}

/// Every pixel, whatever the rule: the images are not rectified, and that shows what the rule makes of it.
CompiledMap table_of(const RigSkin& skin, const Board& board) {
  return compile_map(skin, find_profile(kProfile), {board.left.width, board.left.height, Scan::progressive});
}

/// What the table says between its pixels.
Vector2d carried(const MapTable& table, const Vector2d& pixel) {
  const int x = static_cast<int>(std::floor(pixel.x()));
  const int y = static_cast<int>(std::floor(pixel.y()));
  Vector2d sum = Vector2d::Zero();
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const auto e = table.expand(x + dx, y + dy);
      if (!e) return Vector2d::Constant(std::nan(""));
      const double weight = (1 - std::abs(pixel.x() - x - dx)) * (1 - std::abs(pixel.y() - y - dy));
      sum += std::ldexp(weight, -MapTable::kFractionBits) * Vector2d(double(e->x), double(e->y));
    }
  }
  return sum;
}

/// One for all boards, as each of them lies in its own plane: the median.
std::optional<ChosenThickness> thickness_of(const std::vector<SkinPlane>& planes, const Board& board,
                                            ThicknessOption option, const MachineProfile& profile, Settings& settings) {
  const ScanGeometry geometry{board.left.width, board.left.height, Scan::progressive};
  std::vector<ChosenThickness> all;
  for (const SkinPlane& plane : planes) {
    const auto chosen = set_thickness(option, plane.moved(0), profile, geometry, settings);
    if (!chosen) return {};
    all.push_back(*chosen);
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::ranges::nth_element(all, middle, {}, &ChosenThickness::tolerance_px);
  option = {.tolerance_px = middle->tolerance_px, .thickness_mm = {}};
  Summary across_mm{INFINITY, 0, 0};
  for (const SkinPlane& plane : planes) {
    const Summary one = set_thickness(option, plane.moved(0), profile, geometry, settings)->across_mm;
    across_mm.smallest = std::min(across_mm.smallest, one.smallest);
    across_mm.largest = std::max(across_mm.largest, one.largest);
    across_mm.mean += one.mean / static_cast<double>(planes.size());
  }
  return ChosenThickness{middle->tolerance_px, across_mm};
}

/// The board of each pair as a skin, by the rig of the others; corners of the left image through its map, by lens
/// terms. The planes are those of the first terms.
std::vector<SkinPlane> carry_corners(StudyReport& report, const std::vector<Board>& boards,
                                     const calib::TargetSpec& spec) {
  Csv csv({"terms", "pair", "rms_px", "largest_px"});
  std::vector<SkinPlane> planes;
  Progress progress("calibrating without one pair");
  std::size_t step = 0;
  for (const char* terms : kTerms) {
    double square_sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < boards.size(); ++i) {
      progress.show(step++, kTerms.size() * boards.size());
      const auto& [left, right] = boards[i].corners;
      const SkinPlane plane = plane_of(calibrate_boards(boards, spec, terms, i), boards[i], spec);
      if (terms == kTerms[0]) planes.push_back(plane);
      const CompiledMap map = table_of(plane.moved(0), boards[i]);
      double sum = 0;
      double largest = 0;
      for (std::size_t c = 0; c < left.size(); ++c) {
        const double error = (carried(map.table, left[c]) - right[c]).norm();
        sum += error * error;
        largest = std::max(largest, error);
      }
      csv.row(terms, boards[i].name, std::sqrt(sum / static_cast<double>(left.size())), largest);
      square_sum += sum;
      count += left.size();
    }
    const double rms_px = std::sqrt(square_sum / static_cast<double>(count));
    report.result["corners_rms_px"][terms] = rms_px;
    report.finding(
        "left corners through the map land {:.3f} px RMS from the right ones, lens terms {}, {} corners, leave one out",
        rms_px, terms, count);
  }
  progress.clear();
  report.table("corners.csv", csv);
  return planes;
}

/// The rule as asked for, and what there is to say of it.
Settings settings_of(StudyReport& report, const StudyScope& scope, const std::vector<SkinPlane>& planes,
                     const std::vector<Board>& boards) {
  Settings settings;
  settings.proof.needed = false;  // each photograph is another scene
  settings.decision = scope.decision;
  if (const auto chosen = thickness_of(planes, boards[0], scope.thickness, find_profile(kProfile), settings)) {
    report.result.update(chosen->json());
    report.finding("{}", chosen->text(settings));
  }
  if (settings.decision == Decision::compete) {
    double staying = 0;
    for (std::size_t i = 0; i < boards.size(); ++i) staying += staying_in_rows(planes[i].cameras, boards[i]);
    staying /= static_cast<double>(boards.size());
    report.result["staying_in_rows"] = staying;
    report.finding(
        "a table made with --decision compete would supervise {:.3f} of the board: elsewhere epipolar lines, bent by "
        "the lenses, leave the row by more than {} px; these tables supervise all of it",
        staying, kLargestRowError);
  }
  return settings;
}

/// The table of every board at one displacement.
using Maps = std::vector<CompiledMap>;

std::vector<Maps> compile(const std::vector<double>& shifts_mm, const std::vector<SkinPlane>& planes,
                          const std::vector<Board>& boards) {
  std::vector<Maps> result;
  Progress progress("tables for displacement");
  for (const double shift_mm : shifts_mm) {
    progress.show(result.size(), shifts_mm.size());
    Maps& maps = result.emplace_back();
    for (std::size_t i = 0; i < boards.size(); ++i) maps.push_back(table_of(planes[i].moved(shift_mm), boards[i]));
  }
  return result;
}

/// The engines, which must see the same.
class Machines {
 public:
  Machines(const std::vector<std::string>& engines, const Settings& settings, const Board& board, int lookahead) {
    for (const std::string& engine : engines) {
      const MachineProfile& profile = find_profile(kProfile);
      monitors_.push_back(std::make_unique<Monitor>(make_device(engine, profile), profile, settings));
      monitors_.back()->start(board.left.width, board.left.height, lookahead);
    }
  }

  /// What the first engine sees.
  FrameResult process(const Board& board, const CompiledMap& map) {
    const int slot = frames_++ % kSlots;
    std::vector<FrameResult> results;
    for (const auto& monitor : monitors_) {
      monitor->upload(slot, map.table);
      monitor->select(slot);
      results.push_back(monitor->process(board.left, board.right));
      const FrameResult& a = results.front();
      const FrameResult& b = results.back();
      different_ += a.states == b.states && a.alarm == b.alarm && a.table_crc == b.table_crc ? 0 : 1;
    }
    return std::move(results.front());
  }

  int frames() const { return frames_; }
  int different() const { return different_; }

 private:
  std::vector<std::unique_ptr<Monitor>> monitors_;
  int frames_ = 0;
  int different_ = 0;
};

/// Of all boards at one displacement: means, and the least and most of `in_skin`.
struct Shares {
  double in_skin = 0, least = 1, most = 0, decidable = 0, skin_of_all = 0;
  int alarms = 0;
};

Shares shares_at(double shift_mm, const std::vector<Board>& boards, const Maps& maps, Machines& machines, Csv& csv) {
  Shares result;
  const double n = static_cast<double>(boards.size());
  for (std::size_t i = 0; i < boards.size(); ++i) {
    const FrameResult frame = machines.process(boards[i], maps[i]);
    const BoardPixels pixels = count_board(left_corners(boards[i]), frame.states);
    csv.row(shift_mm, boards[i].name, pixels.decidable_share(), pixels.skin_share(), pixels.skin_of_all(),
            frame.alarm ? 1 : 0);
    result.in_skin += pixels.skin_share() / n;
    result.least = std::min(result.least, pixels.skin_share());
    result.most = std::max(result.most, pixels.skin_share());
    result.decidable += pixels.decidable_share() / n;
    result.skin_of_all += pixels.skin_of_all() / n;
    result.alarms += frame.alarm ? 1 : 0;
  }
  return result;
}

void displace(StudyReport& report, const std::vector<double>& shifts_mm, const std::vector<Board>& boards,
              const std::vector<Maps>& maps, Machines& machines) {
  Csv csv({"shift_mm", "pair", "decidable", "in_skin", "skin_of_all", "alarm"});
  const auto panel = [](const char* title, const char* y_label) {
    return Panel{title, "displacement along the normal, mm", y_label, {}};
  };
  Panel decidable = panel("In the skin, of what is decidable", "share of the board's decidable pixels");
  Panel all = panel("Of the whole board", "share of the board's pixels");
  decidable.curves = {{"mean", {}}, {"least", {}}, {"most", {}}};
  all.curves = {{"decidable (mean)", {}}, {"in the skin (mean)", {}}};
  Progress progress("displacement");
  for (std::size_t s = 0; s < shifts_mm.size(); ++s) {
    progress.show(s, shifts_mm.size());
    const Shares shares = shares_at(shifts_mm[s], boards, maps[s], machines, csv);
    decidable.curves[0].points.emplace_back(shifts_mm[s], shares.in_skin);
    decidable.curves[1].points.emplace_back(shifts_mm[s], shares.least);
    decidable.curves[2].points.emplace_back(shifts_mm[s], shares.most);
    all.curves[0].points.emplace_back(shifts_mm[s], shares.decidable);
    all.curves[1].points.emplace_back(shifts_mm[s], shares.skin_of_all);
    report.result["shares"].push_back({{"shift_mm", shifts_mm[s]},
                                       {"decidable", shares.decidable},
                                       {"in_skin", shares.in_skin},
                                       {"least", shares.least},
                                       {"most", shares.most},
                                       {"skin_of_all", shares.skin_of_all},
                                       {"alarms", shares.alarms}});
    report.finding(
        "skin displaced by {:+4.0f} mm: {:.3f} of the board decidable; of that {:.3f} in the skin ({:.3f} to {:.3f}), "
        "{:.3f} of all; alarms {}/{}",
        shifts_mm[s], shares.decidable, shares.in_skin, shares.least, shares.most, shares.skin_of_all, shares.alarms,
        boards.size());
  }
  progress.clear();
  report.table("displacement.csv", csv);
  report.plot("displacement.svg", "Skins through a real chessboard, displaced", {decidable, all}, 2);
}

}  // namespace

void study_board(StudyReport& report, const StudyScope& scope) {
  const auto spec = calib::TargetSpec::parse("chessboard:9x6:30mm");
  std::vector<Board> boards = load_boards(scope.data, spec);
  if (scope.quick) boards.resize(5);
  const std::vector<SkinPlane> planes = carry_corners(report, boards, spec);
  const std::vector<double> shifts_mm =
      scope.quick ? std::vector<double>{0, -50, 50} : std::vector<double>{-100, -50, -20, -10, 0, 10, 20, 50, 100};
  const std::vector<Maps> maps = compile(shifts_mm, planes, boards);
  int lookahead = 0;
  for (const Maps& of_shift : maps)
    for (const CompiledMap& map : of_shift) lookahead = std::max(lookahead, map.report.lookahead);
  Machines machines(scope.engines, settings_of(report, scope, planes, boards), boards[0], lookahead);
  displace(report, shifts_mm, boards, maps, machines);
  report.result["pairs"] = boards.size();
  report.result["target"] = spec.text();
  report.result["decision"] = name_of(scope.decision);
  report.result["engines"] = scope.engines;
  report.result["frames"] = machines.frames();
  report.result["frames_different"] = machines.different();
  if (scope.engines.size() > 1) {
    report.finding("{}", machines.different() == 0
                             ? fmt::format("native and rtl: all {} frames identical", machines.frames())
                             : fmt::format("{} of {} frames DIFFER", machines.different(), machines.frames()));
  }
}

}  // namespace horopter::cli
