// SPDX-License-Identifier: Apache-2.0
#include "horopter/plan/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "horopter/base/error.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Share of a distance by which something else must be nearer to hide a place.
constexpr double kSamePoint = 1e-5;
/// Steps end on surfaces by rounding.
constexpr double kWholeStep = 1 + 1e-9;
constexpr std::int64_t kLargestLattice = 10'000'000;

struct SightWords {
  std::string_view name, text;
};
constexpr std::array<SightWords, kSightCount> kWords{{
    {"seen", "seen"},
    {"no_skin", "past the skin"},
    {"outside_left", "the skin is outside the left image"},
    {"outside_right", "the skin is outside the right image"},
    {"angle", "the skin is seen too far from its normal"},
    {"scale", "the skin is reduced to less than 1/2 in the right image"},
    {"row", "the epipolar line of the skin's pixel leaves the row"},
    {"hidden", "the skin is hidden by another part of it"},
    {"obstacle", "the skin is hidden by an obstacle"},
    {"border", "the skin is at the border of what is watched, within the machine's windows"},
}};

Sight sight_of(Reason reason) {
  switch (reason) {
    case Reason::none:
      return Sight::seen;
    case Reason::outside:
      return Sight::outside_right;
    case Reason::scale:
      return Sight::scale;
    case Reason::angle:
      return Sight::angle;
    case Reason::row:
      return Sight::row;
    case Reason::hidden:
      return Sight::hidden;
    case Reason::no_source:
    case Reason::grid:
      break;
  }
  return Sight::no_skin;
}

/// First meeting of the way from one place to another with a surface, in ways; infinite: none.
double first_meeting(const Surface& surface, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  Hit hit;
  surface.intersect(from, {&way, 1}, {&hit, 1});
  return hit.distance <= kWholeStep ? hit.distance : std::numeric_limits<double>::infinity();
}

/// Meetings from either end: a body is met where it is left, too.
std::array<double, 2> meetings(const Surface& surface, const Vector3d& from, const Vector3d& to) {
  return {first_meeting(surface, from, to), 1 - first_meeting(surface, to, from)};
}

bool crosses(const Surface& surface, const Vector3d& from, const Vector3d& to, double up_to) {
  const auto [first, last] = meetings(surface, from, to);
  return first <= up_to || (std::isfinite(last) && last <= up_to);
}

bool stands_before(const Surface* obstacles, const Vector3d& camera, const Vector3d& place) {
  if (obstacles == nullptr) return false;
  const Vector3d way = place - camera;
  Hit hit;
  obstacles->intersect(camera, {&way, 1}, {&hit, 1});
  return hit.distance < 1 - kSamePoint;
}

/// The lattice of a search. Off round numbers, on which surfaces lie.
class Lattice {
 public:
  Lattice(const Eigen::AlignedBox3d& box, double step) : origin_(box.min().array() - 0.0137 * step), step_(step) {
    double points = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double count = std::ceil(box.sizes()[axis] / step + 0.02) + 1;
      points *= count;
      if (!(points <= static_cast<double>(kLargestLattice))) {
        throw std::invalid_argument(
            fmt::format("a step of {:.4g} mm is too fine for a space of {:.4g} x {:.4g} x {:.4g} mm", step,
                        box.sizes().x(), box.sizes().y(), box.sizes().z()));
      }
      size_[axis] = static_cast<int>(count);
    }
  }
  std::size_t points() const { return static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]; }
  Vector3i at(std::size_t index) const {
    const auto i = static_cast<int>(index);
    return {i % size_[0], i / size_[0] % size_[1], i / size_[0] / size_[1]};
  }
  Vector3d place(std::size_t index) const { return origin_ + step_ * at(index).cast<double>(); }
  /// The corners of the cell around a place.
  std::array<std::size_t, 8> around(const Vector3d& place) const {
    const Vector3i low = ((place - origin_) / step_).array().floor().cast<int>().max(0).min(size_.array() - 2);
    std::array<std::size_t, 8> corners{};
    for (int i = 0; i < 8; ++i) {
      const Vector3i p = low + Vector3i(i & 1, i >> 1 & 1, i >> 2);
      corners[static_cast<std::size_t>(i)] =
          static_cast<std::size_t>(p[0]) +
          static_cast<std::size_t>(size_[0]) * (p[1] + static_cast<std::size_t>(size_[1]) * p[2]);
    }
    return corners;
  }
  /// The neighbour in one of six directions.
  std::optional<std::size_t> neighbour(std::size_t index, int direction) const {
    const int axis = direction / 2;
    const int side = direction % 2 == 0 ? -1 : 1;
    const int to = at(index)[axis] + side;
    if (to < 0 || to >= size_[axis]) return {};
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? size_[0] : static_cast<std::size_t>(size_[0]) * size_[1];
    return side > 0 ? index + stride : index - stride;
  }
  bool on_border(std::size_t index) const {
    const Vector3i p = at(index);
    return (p.array() == 0).any() || (p.array() == size_.array() - 1).any();
  }

 private:
  Vector3d origin_;
  double step_;
  Vector3i size_;
};

Eigen::AlignedBox3d space_around(const Watch& watch, const Surface& zone, const EntrySearch& search) {
  Eigen::AlignedBox3d box;
  zone.extend(box);
  if (box.isEmpty()) throw std::invalid_argument("the zone has no ends");
  watch.skin().extend(box);
  box.extend(watch.field_mm());  // ways lead round its rim, wherever the skin ends
  if (watch.obstacles() != nullptr) watch.obstacles()->extend(box);
  if (search.from_mm) box.extend(*search.from_mm);
  return box;
}

/// Whether a place is inside a body. Ways from outside meet it; ways from inside do not, or meet it from behind.
bool is_inside(const Surface& body, const Vector3d& place) {
  Eigen::AlignedBox3d box;
  body.extend(box);
  const double far = 2 * box.extend(place).sizes().norm();
  for (int direction = 0; direction < 6; ++direction) {
    Vector3d way(0.0137, 0.0071, 0.0033);  // off the edges of what is built along axes
    way[direction / 2] += direction % 2 == 0 ? -1 : 1;
    way *= far;
    const Vector3d back = -way;
    Hit out, in;
    body.intersect(place, {&way, 1}, {&out, 1});
    body.intersect(place + way, {&back, 1}, {&in, 1});
    const bool from_behind = !std::isfinite(out.distance) || out.normal.dot(way) > 0;
    if (in.distance < 1 && from_behind) return true;
  }
  return false;
}

/// The points of the lattice around where people are that lie on their side of everything. Throws UsageError.
std::vector<std::size_t> beside(const Vector3d& from, const Lattice& lattice, const Watch& watch, const Surface& zone) {
  const std::string what = fmt::format("--from {:g} {:g} {:g}", from.x(), from.y(), from.z());
  const std::vector<SurfacePtr> parts = zone.parts();
  if (is_inside(zone, from) || std::ranges::any_of(parts, [&](auto& part) { return is_inside(*part, from); })) {
    throw UsageError(what + " lies in the zone; expected a place outside");
  }
  std::vector<std::size_t> starts;
  for (const std::size_t corner : lattice.around(from)) {
    const Vector3d place = lattice.place(corner);
    const auto between = [&](const Surface& surface) { return crosses(surface, from, place, kWholeStep); };
    if (between(zone) || between(watch.skin())) continue;
    if (watch.obstacles() == nullptr || !between(*watch.obstacles())) starts.push_back(corner);
  }
  if (!starts.empty()) return starts;
  throw UsageError(
      what +
      " lies on an obstacle or in it, or is shut in there; expected a place where people are, or a smaller --step");
}

/// Places not more than two steps apart belong to one opening.
std::vector<Opening> group(const std::vector<EntryPlan::Mark>& entries, double step) {
  std::vector<Opening> openings;
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto x_of = [&](std::size_t i) { return entries[i].place_mm.x(); };
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(x_of(i), i); });
  std::vector<bool> taken(entries.size());
  for (std::size_t first = 0; first < order.size(); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    Opening opening;
    std::array<std::int64_t, kSightCount> reasons{};
    std::vector<std::size_t> open{first};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const EntryPlan::Mark& entry = entries[order[at]];
      opening.box_mm.extend(entry.place_mm);
      ++opening.places;
      ++reasons[static_cast<std::size_t>(entry.sight)];
      const auto visit = [&](std::size_t other) {
        if (taken[other] || (entries[order[other]].place_mm - entry.place_mm).norm() > 2 * step) return;
        taken[other] = true;
        open.push_back(other);
      };
      for (std::size_t i = at + 1; i < order.size() && x_of(order[i]) <= entry.place_mm.x() + 2 * step; ++i) visit(i);
      for (std::size_t i = at; i > 0 && x_of(order[i - 1]) >= entry.place_mm.x() - 2 * step; --i) visit(i - 1);
    }
    opening.reason = static_cast<Sight>(std::ranges::max_element(reasons) - reasons.begin());
    // The largest first; of the same size in the order in which they were found.
    openings.insert(std::ranges::upper_bound(openings, opening.places, std::ranges::greater{}, &Opening::places),
                    opening);
  }
  return openings;
}

}  // namespace

std::string_view sight_name(Sight sight) { return kWords[static_cast<std::size_t>(sight)].name; }
std::string_view sight_text(Sight sight) { return kWords[static_cast<std::size_t>(sight)].text; }

Watch::Watch(CameraPair cameras, SurfacePtr skin, SurfacePtr obstacles, const MachineProfile& profile,
             const ScanGeometry& geometry, const ViewLimits& limits)
    : cameras_(std::move(cameras)),
      skin_(std::move(skin)),
      obstacles_(std::move(obstacles)),
      geometry_(geometry),
      subsample_(profile.subsample),
      width_(geometry.width / profile.subsample),
      height_(geometry.height) {
  const Vector3d left_mm = cameras_.left().world_to_camera.centre();
  const Vector3d right_mm = cameras_.right().world_to_camera.centre();
  skin_->check_cameras(left_mm, right_mm);
  const auto frame_width = static_cast<std::size_t>(geometry.width);
  std::vector<Point> points(frame_width);
  std::vector<Look> looks(frame_width);
  std::vector<Hit> hits(frame_width);
  std::vector<Sight> alone(static_cast<std::size_t>(width_) * height_, Sight::seen);
  for (int y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < frame_width; ++x) {
      points[x] = geometry.to_frame({static_cast<double>(x), static_cast<double>(y)});
    }
    const Rays rays = cameras_.rays(points, limits);
    cameras_.look(*skin_, rays, geometry.row_step(), limits, looks);
    skin_->intersect(left_mm, rays.directions, hits);
    for (std::size_t x = 0; x < static_cast<std::size_t>(width_) * subsample_; ++x) {
      Sight sight = sight_of(looks[x].reason);
      if (sight == Sight::seen && !geometry.holds(geometry.from_frame(looks[x].source))) sight = Sight::outside_right;
      const Vector3d place = left_mm + hits[x].distance * rays.directions[x];
      if (sight == Sight::seen && obstacles_ &&
          (stands_before(obstacles_.get(), left_mm, place) || stands_before(obstacles_.get(), right_mm, place))) {
        sight = Sight::obstacle;
      }
      if (sight == Sight::seen) field_mm_.extend(place);
      Sight& pixel = alone[static_cast<std::size_t>(y) * width_ + x / subsample_];
      if (pixel == Sight::seen) pixel = sight;
    }
  }
  // A pixel is decided where all of its support is there: first along the rows, then down the columns.
  const int reach = profile.offset();
  const auto narrow = [&](const std::vector<Sight>& from, int count, int lines, std::size_t along, std::size_t across) {
    std::vector<Sight> to = from;
    std::vector<int> unseen(static_cast<std::size_t>(count) + 1);  // before each pixel of a line
    for (std::size_t line = 0; line < static_cast<std::size_t>(lines); ++line) {
      for (int i = 0; i < count; ++i) unseen[i + 1] = unseen[i] + (from[line * across + i * along] != Sight::seen);
      for (int i = 0; i < count; ++i) {
        Sight& pixel = to[line * across + i * along];
        const bool whole = i >= reach && i + reach < count && unseen[i + reach + 1] == unseen[i - reach];
        if (pixel == Sight::seen && !whole) pixel = Sight::border;
      }
    }
    return to;
  };
  const auto stride = static_cast<std::size_t>(width_);
  pixels_ = narrow(narrow(alone, width_, height_, 1, stride), height_, width_, stride, 1);
}

Sight Watch::at(const Vector3d& place) const {
  const Vector3d left_mm = cameras_.left().world_to_camera.centre();
  const auto seen = cameras_.left().project(place);
  if (!seen) return Sight::outside_left;
  const Point scanned = geometry_.from_frame({seen->x(), seen->y()});
  if (!geometry_.holds(scanned)) return Sight::outside_left;
  const Vector3d way = place - left_mm;
  Hit hit;
  skin_->intersect(left_mm, {&way, 1}, {&hit, 1});
  if (!(hit.distance >= 1 - kSamePoint)) return Sight::hidden;
  const double x = (scanned.x + 0.5) / subsample_ - 0.5;
  for (const double row : {std::floor(scanned.y), std::ceil(scanned.y)}) {
    for (const double column : {std::floor(x), std::ceil(x)}) {
      const int at_x = std::clamp(static_cast<int>(column), 0, width_ - 1);
      const Sight sight = pixel(at_x, std::clamp(static_cast<int>(row), 0, height_ - 1));
      if (sight != Sight::seen) return sight;
    }
  }
  return Sight::seen;
}

EntryPlan plan_entries(const Watch& watch, const Surface& zone, const EntrySearch& search) {
  EntryPlan plan;
  plan.space_mm = space_around(watch, zone, search);
  const double longest = plan.space_mm.sizes().maxCoeff();
  plan.step_mm = search.step_mm > 0 ? search.step_mm : longest / 64;
  const double margin = search.margin_mm > 0 ? search.margin_mm : std::max(longest / 8, 3 * plan.step_mm);
  plan.space_mm.min().array() -= margin;
  plan.space_mm.max().array() += margin;
  const Lattice lattice(plan.space_mm, plan.step_mm);

  // From where a point was reached, and what let one pass there last.
  constexpr std::uint32_t kUnreached = 0xFFFFFFFF;
  std::vector<std::uint32_t> from(lattice.points(), kUnreached);
  std::vector<Sight> passed(lattice.points(), Sight::no_skin);
  std::vector<std::uint32_t> queue;
  const auto start = [&](std::size_t index) {
    from[index] = static_cast<std::uint32_t>(index);
    queue.push_back(from[index]);
  };
  if (search.from_mm) {
    for (const std::size_t corner : beside(*search.from_mm, lattice, watch, zone)) start(corner);
  } else {
    for (std::size_t i = 0; i < lattice.points(); ++i) {
      if (lattice.on_border(i)) start(i);
    }
  }

  std::vector<EntryPlan::Mark> entries;
  std::vector<std::uint32_t> entered_from;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t here = queue[next];
    const Vector3d a = lattice.place(here);
    for (int direction = 0; direction < 6; ++direction) {
      const auto there = lattice.neighbour(here, direction);
      if (!there) continue;
      const Vector3d b = lattice.place(*there);
      const double entry = first_meeting(zone, a, b);
      const bool enters = std::isfinite(entry);
      if (!enters && from[*there] != kUnreached) continue;
      const double up_to = std::min(entry, 1.0) * kWholeStep;
      if (watch.obstacles() != nullptr && crosses(*watch.obstacles(), a, b, up_to)) continue;
      Sight sight = passed[here];
      bool seen = false;
      for (const double meeting : meetings(watch.skin(), a, b)) {
        if (!std::isfinite(meeting) || meeting > up_to) continue;
        const Vector3d place = a + meeting * (b - a);
        sight = watch.at(place);
        plan.skin.push_back({place, sight});
        seen = seen || sight == Sight::seen;
      }
      if (enters) {
        if (seen) continue;
        entries.push_back({a + entry * (b - a), sight});
        entered_from.push_back(static_cast<std::uint32_t>(here));
        continue;
      }
      if (seen) continue;
      from[*there] = static_cast<std::uint32_t>(here);
      passed[*there] = sight;
      queue.push_back(static_cast<std::uint32_t>(*there));
    }
  }
  for (std::size_t i = 0; i < lattice.points(); ++i) {
    for (int direction = 0; direction < 6; ++direction) {
      const auto there = lattice.neighbour(i, direction);
      if (!there) continue;
      const Vector3d a = lattice.place(i);
      const Vector3d b = lattice.place(*there);
      const auto add = [&](const Surface& surface, std::vector<Vector3d>& places) {
        const double meeting = first_meeting(surface, a, b);
        if (std::isfinite(meeting)) places.emplace_back(a + meeting * (b - a));
      };
      add(zone, plan.zone_mm);
      if (watch.obstacles() != nullptr) add(*watch.obstacles(), plan.obstacles_mm);
    }
  }
  for (const EntryPlan::Mark& entry : entries) plan.unseen_mm.push_back(entry.place_mm);
  plan.openings = group(entries, plan.step_mm);
  if (plan.openings.empty()) return plan;
  // The queue goes by length: the first entry of the largest opening has a shortest way.
  std::size_t first = 0;
  while (!plan.openings.front().box_mm.contains(entries[first].place_mm)) ++first;
  plan.path_mm.push_back(entries[first].place_mm);
  for (std::uint32_t at = entered_from[first];; at = from[at]) {
    plan.path_mm.push_back(lattice.place(at));
    if (from[at] == at) break;
  }
  std::ranges::reverse(plan.path_mm);
  return plan;
}

}  // namespace horopter
