// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/skin_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace horopter {
namespace {

using Eigen::Vector3d;

/// How far slopes are measured, either way: over so much the rounding of a table's control points, 1/32 px, is nothing,
/// and an edge of the skin is not yet smoothed away.
constexpr int kReach = 4;
/// Bend over that reach, in ways of one side, beyond which it is an edge.
constexpr double kEdge = 0.1;

constexpr int blocks(int size) { return (size + SkinPlaces::kBlock - 1) / SkinPlaces::kBlock; }

}  // namespace

SkinPlaces::SkinPlaces(const MapTable& table, CameraPair cameras)
    : table_(table),
      cameras_(std::move(cameras)),
      width_(table.facts().subsample == 0 ? 0 : table.geometry().width / table.facts().subsample),
      height_(table.geometry().height),
      columns_(blocks(width_)),
      blocks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(blocks(height_))) {}

std::optional<Point> SkinPlaces::source(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return {};
  const int subsample = table_.facts().subsample;
  Point source;
  for (int i = 0; i < subsample; ++i) {
    const auto expanded = table_.expand(subsample * x + i, y);
    if (!expanded) return {};
    source.x += std::ldexp(static_cast<double>(expanded->x), -MapTable::kFractionBits) / subsample;
    source.y += std::ldexp(static_cast<double>(expanded->y), -MapTable::kFractionBits) / subsample;
  }
  return source;
}

std::optional<Vector3d> SkinPlaces::place_mm(int x, int y) const {
  const auto right = source(x, y);
  if (!right) return {};
  const int subsample = table_.facts().subsample;
  const ScanGeometry& geometry = table_.geometry();
  const Point left{subsample * x + 0.5 * (subsample - 1), static_cast<double>(y)};
  return cameras_.place_mm(geometry.to_frame(left), geometry.to_frame(*right));
}

SkinPlaces::Side SkinPlaces::side(int x, int y, int dx, int dy, const Vector3d& here) const {
  // Beyond a pixel without a source another part of the skin may begin.
  int reach = 0;
  while (reach < kReach && source(x + (reach + 1) * dx, y + (reach + 1) * dy)) ++reach;
  for (; reach > 0; --reach) {
    const auto end = place_mm(x + reach * dx, y + reach * dy);
    if (!end) continue;
    const auto middle = reach == kReach ? place_mm(x + reach / 2 * dx, y + reach / 2 * dy) : std::nullopt;
    return {reach, *end, (here - 2 * middle.value_or(0.5 * (here + *end)) + *end).norm()};
  }
  return {0, here, 0};
}

std::optional<SkinPlace> SkinPlaces::exactly_at(int x, int y) const {
  const auto here = place_mm(x, y);
  if (!here) return {};
  const auto slope = [&](int dx, int dy) -> std::optional<Vector3d> {
    const Side back = side(x, y, -dx, -dy, *here);
    const Side ahead = side(x, y, dx, dy, *here);
    if (back.reach + ahead.reach == 0) return {};
    const Vector3d over = (ahead.end - back.end) / (back.reach + ahead.reach);
    if (back.reach < kReach || ahead.reach < kReach) return over;
    // At an edge of the skin the two sides are of different slope; the straighter one is the pixel's own.
    const double bend = (ahead.end - 2 * *here + back.end).norm();
    if (bend <= kEdge * kReach * over.norm()) return over;
    return back.bend < ahead.bend ? Vector3d((*here - back.end) / kReach) : Vector3d((ahead.end - *here) / kReach);
  };
  const auto along = slope(1, 0);
  const auto down = slope(0, 1);
  if (!along || !down) return {};
  return SkinPlace{*here, *along, *down};
}

void SkinPlaces::look(int column, int row, Block& block) const {
  std::array<std::pair<int, int>, kBlock * kBlock> pixels;
  for (int i = 0; i < kBlock * kBlock; ++i) pixels[static_cast<std::size_t>(i)] = {i % kBlock, i / kBlock};
  // The nearest to its middle first.
  std::ranges::sort(pixels, {}, [](const auto& p) {
    const int dx = 2 * p.first - (kBlock - 1), dy = 2 * p.second - (kBlock - 1);
    return std::tuple(dx * dx + dy * dy, p);
  });
  block.known = Block::Known::no;
  for (const auto& [dx, dy] : pixels) {
    const int x = column * kBlock + dx, y = row * kBlock + dy;
    const auto place = exactly_at(x, y);
    if (!place) continue;
    block = {Block::Known::yes, x, y, *place};
    return;
  }
}

std::optional<SkinPlace> SkinPlaces::at(int x, int y) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return {};
  const int column = x / kBlock, row = y / kBlock;
  Block& block =
      blocks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  if (block.known == Block::Known::not_yet) look(column, row, block);
  if (block.known == Block::Known::no) return {};
  SkinPlace place = block.place;
  place.at_mm += (x - block.x) * place.along_mm + (y - block.y) * place.down_mm;
  return place;
}

}  // namespace horopter
