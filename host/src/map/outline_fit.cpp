// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/outline_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "horopter/map/look_lattice.hpp"

namespace horopter {
namespace {

using hls::table::Span;

constexpr Point kNowhere{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

bool is_good(Reason reason, const Point& source) { return !is_excluded(reason) && !std::isnan(source.x); }

/// Runs of true among 0 … count - 1: the longest, the first of several.
template <class Good>
Span longest_run(int count, Good good) {
  Span longest;
  for (int i = 0; i < count; ++i) {
    if (!good(i)) continue;
    const int first = i;
    while (i < count && good(i)) ++i;
    if (i - first > longest.end - longest.first) longest = {first, i};
  }
  return longest;
}

bool is_empty(const Span& span) { return span.first == span.end; }

bool has_an_end(const Outline& outline, int width) {
  const auto whole = [&](const Span& span) { return span == Span{0, width}; };
  return !std::ranges::all_of(outline.spans, whole) && !std::ranges::all_of(outline.spans, is_empty);
}

void append(Rays& to, const Rays& more) {
  const auto add = [](auto& all, const auto& some) { all.insert(all.end(), some.begin(), some.end()); };
  add(to.directions, more.directions);
  for (std::size_t i = 0; i < to.right_view.size(); ++i) add(to.right_view[i], more.right_view[i]);
  add(to.over_length, more.over_length);
  add(to.row_error, more.row_error);
  to.largest_shift_px = more.largest_shift_px;
}

}  // namespace

std::optional<Outline> outline_of(const LookLattice& lattice, const ScanGeometry& geometry) {
  Outline outline;
  for (int y = 0; y < geometry.height; ++y) {
    const std::size_t row = lattice.index(0, y);
    const auto at = [&](int x) { return row + static_cast<std::size_t>(x); };
    const Span span =
        longest_run(geometry.width, [&](int x) { return is_good(lattice.reasons[at(x)], lattice.sources[at(x)]); });
    outline.spans.push_back(span);
  }
  if (!has_an_end(outline, geometry.width)) return {};
  outline.see = [&lattice](int x, int y, std::span<Point> sources) {
    const std::size_t first = lattice.index(x, y);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const std::size_t at = first + i;
      sources[i] = is_good(lattice.reasons[at], lattice.sources[at]) ? lattice.sources[at] : kNowhere;
    }
  };
  return outline;
}

OutlineTracer::OutlineTracer(const CameraPair& cameras, const ScanGeometry& geometry, const ViewLimits& view)
    : geometry_(geometry),
      view_(view),
      columns_((geometry.width + kWidth - 1) / kWidth),
      blocks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((geometry.height + kHeight - 1) / kHeight)),
      rays_(cameras.rays({}, view)) {}

std::size_t OutlineTracer::rays_of(const CameraPair& cameras, int column, int row) {
  const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  if (blocks_[at].first_ray < 0) {
    if (rays_.size() > kMostRays) {
      for (Block& block : blocks_) block.first_ray = -1;
      rays_ = cameras.rays({}, view_);
    }
    std::array<Point, kWidth * kHeight> pixels;
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const int x = column * kWidth + i % kWidth;
      const int y = row * kHeight + i / kWidth;
      pixels[static_cast<std::size_t>(i)] = geometry_.to_frame({double(x), double(y)});
    }
    blocks_[at].first_ray = static_cast<std::int32_t>(rays_.size());
    append(rays_, cameras.rays(pixels, view_));
  }
  return static_cast<std::size_t>(blocks_[at].first_ray);
}

std::span<const Point> OutlineTracer::look(const CameraPair& cameras, const Surface& surface, int x, int y) {
  const int column = x / kWidth;
  const int row = y / kHeight;
  Block& block =
      blocks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  if (block.seen < 0) {
    std::array<Look, kWidth * kHeight> looks;
    cameras.look_at_runs(surface, rays_, geometry_.row_step(), view_, looks, rays_of(cameras, column, row));
    block.seen = static_cast<std::int32_t>(seen_.size());
    std::ranges::transform(looks, seen_.emplace_back().begin(), [&](const Look& there) {
      return is_good(there.reason, there.source) ? geometry_.from_frame(there.source) : kNowhere;
    });
  }
  const Sources& sources = seen_[static_cast<std::size_t>(block.seen)];
  return std::span(sources).subspan(static_cast<std::size_t>(y % kHeight * kWidth + x % kWidth),
                                    static_cast<std::size_t>(kWidth - x % kWidth));
}

std::optional<Outline> OutlineTracer::trace(const CameraPair& cameras, const Surface& surface,
                                            const LookLattice& coarse) {
  for (Block& block : blocks_) block.seen = -1;
  seen_.clear();
  const int step_y = 1 << coarse.shape.y_log2;
  const int step_x_log2 = coarse.shape.x_log2;
  const int coarse_columns = ((geometry_.width - 1) >> step_x_log2) + 1;
  const int coarse_rows = ((geometry_.height - 1) >> coarse.shape.y_log2) + 1;
  std::vector<Span> begin;  // by row of the lattice, in pixels that are on the skin: first … end - 1
  bool all = true;
  std::size_t longest = 0;
  for (int row = 0; row < coarse_rows; ++row) {
    const auto good = [&](int column) {
      const std::size_t at = coarse.index(column << step_x_log2, row * step_y);
      return is_good(coarse.reasons[at], coarse.sources[at]);
    };
    const Span run = longest_run(coarse_columns, good);
    all = all && run == Span{0, coarse_columns};
    begin.push_back(is_empty(run) ? Span{} : Span{run.first << step_x_log2, ((run.end - 1) << step_x_log2) + 1});
    const auto length = [](const Span& span) { return span.end - span.first; };
    if (length(begin.back()) > length(begin[longest])) longest = begin.size() - 1;
  }
  if (all || is_empty(begin[longest])) return {};

  const auto good = [&](int x, int y) { return !std::isnan(look(cameras, surface, x, y)[0].x); };
  Outline outline;
  outline.spans.resize(static_cast<std::size_t>(geometry_.height));
  // From where it is said to be about.
  const auto trace_row = [&](int y, Span about) {
    int first = about.first;
    int last = about.end - 1;
    if (good(first, y)) {
      while (first > 0 && good(first - 1, y)) --first;
    } else {
      do {
        if (++first > last) return;
      } while (!good(first, y));
    }
    if (good(last, y)) {
      while (last + 1 < geometry_.width && good(last + 1, y)) ++last;
    } else {
      while (!good(--last, y)) {
      }
    }
    outline.spans[static_cast<std::size_t>(y)] = {first, last + 1};
  };
  const auto trace_on = [&](int first_y, int direction) {
    for (int y = first_y; y >= 0 && y < geometry_.height; y += direction) {
      Span about = y == first_y && direction > 0 ? begin[longest] : outline.span(y - direction);
      if (is_empty(about)) {  // the next row of the lattice may be on the skin again
        const int ahead = direction > 0 ? (y + step_y - 1) / step_y : y / step_y;
        if (ahead >= coarse_rows) continue;
        about = begin[static_cast<std::size_t>(ahead)];
        if (is_empty(about)) continue;
      }
      trace_row(y, about);
    }
  };
  const int middle = static_cast<int>(longest) * step_y;
  trace_on(middle, 1);
  trace_on(middle - 1, -1);
  if (!has_an_end(outline, geometry_.width)) return {};
  outline.see = [this, &cameras, &surface](int x, int y, std::span<Point> sources) {
    for (std::size_t i = 0; i < sources.size();) {
      const auto there = look(cameras, surface, x + static_cast<int>(i), y);
      const auto count = std::min(there.size(), sources.size() - i);
      std::ranges::copy(there.first(count), sources.begin() + static_cast<std::ptrdiff_t>(i));
      i += count;
    }
  };
  return outline;
}

}  // namespace horopter
