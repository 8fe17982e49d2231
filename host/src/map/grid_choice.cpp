// SPDX-License-Identifier: Apache-2.0
#include "grid_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

namespace horopter {
namespace {

/// Grids tried where none loses little enough, and how much more than with the first of them may be expected to be lost.
constexpr int kLastTries = 3;
constexpr double kWorthATry = 1.05;
/// The precision of cells that an outline cuts is left out where the limit is kept then, or nearly, and much less is lost.
constexpr double kMuchLess = 0.75;
constexpr double kNearly = 1.25;

struct Spacing {
  int nx, ny;
  std::size_t bytes;
};

/// That fit, fewest bytes first.
std::vector<Spacing> spacings_of(const Grids& grids, std::size_t largest_bytes) {
  std::vector<Spacing> spacings;
  for (int nx = 0; nx <= grids.limits.largest_spacing_log2; ++nx) {
    for (int ny = 0; ny <= grids.limits.largest_spacing_log2; ++ny) {
      const std::size_t bytes = MapTable::pool_bytes(grids.geometry, nx, ny, grids.outline != nullptr, grids.areas);
      if (bytes <= largest_bytes) spacings.push_back({nx, ny, bytes});
    }
  }
  std::ranges::sort(spacings, {}, &Spacing::bytes);
  return spacings;
}

std::string unseen_text(const MapReport& report) {
  std::string text = "no pixel is supervised";
  for (int i = 1; i < kReasonCount; ++i) {
    if (report.by_reason[i] == 0) continue;
    text += fmt::format(", {:.1f} % {}",
                        100.0 * static_cast<double>(report.by_reason[i]) / static_cast<double>(report.pixels),
                        reason_text(static_cast<Reason>(i)));
  }
  return text;
}

/// Tries grids and keeps the best.
class Search {
 public:
  explicit Search(const Grids& grids)
      : grids_(grids),
        largest_bytes_(grids.limits.largest_bytes != 0 ? grids.limits.largest_bytes : grids.profile.pool_bytes),
        spacings_(spacings_of(grids, largest_bytes_)) {}
  CompiledMap best();

 private:
  bool is_likely(const Spacing& spacing) const;
  double share_beyond(const Spacing& spacing, double error_px) const {
    return grids_.forecast.share_beyond(spacing.nx, spacing.ny, error_px);
  }
  bool consider(const GridFit& grid);
  bool attempt(const Spacing& spacing);
  void try_last();

  const Grids& grids_;
  std::size_t largest_bytes_;
  std::vector<Spacing> spacings_;
  std::vector<const Spacing*> tried_;
  std::optional<CompiledMap> best_;
  std::optional<CompiledMap> best_of_whole_cells_;  ///< within the limits, but for cells that the outline cuts
  std::optional<UnseenError> nothing_;
};

bool Search::is_likely(const Spacing& spacing) const {
  const MapLimits& limits = grids_.limits;
  return (grids_.outline != nullptr ||
          grids_.forecast.lost_share(spacing.nx, spacing.ny) <= limits.largest_lost_share * grids_.margin) &&
         share_beyond(spacing, limits.error_px * grids_.margin) <= (1 - limits.share) * grids_.margin;
}

/// Whether it loses little enough.
bool Search::consider(const GridFit& grid) {
  const MapReport& report = grid.report();
  if (report.supervised() == 0) {
    nothing_.emplace(report);
    return false;
  }
  const double lost = report.lost_share();
  const bool good = lost <= grids_.limits.largest_lost_share;
  if (good || !best_ || lost < best_->report.lost_share()) best_ = grid.take();
  return good;
}

/// Whether a grid of this spacing loses little enough.
bool Search::attempt(const Spacing& spacing) {
  if (std::ranges::find(tried_, &spacing) != tried_.end()) return false;
  tried_.push_back(&spacing);
  GridFit grid = grids_.fit(spacing.nx, spacing.ny, grids_.outline);
  if (consider(grid)) return true;
  const double largest = grids_.limits.largest_lost_share;
  const double much_less = std::min(kMuchLess * grid.report().lost_share(), kNearly * largest);
  if (!best_of_whole_cells_ && grid.leave_out_cut() && grid.report().lost_share() <= std::max(largest, much_less)) {
    best_of_whole_cells_ = grid.take();
  }
  if (best_of_whole_cells_) return false;
  return grids_.outline != nullptr && consider(grids_.fit(spacing.nx, spacing.ny, nullptr));
}

/// Where creases, or the border of what is seen, keep too many pixels off, the grid loses them all.
void Search::try_last() {
  std::multimap<double, const Spacing*> last;  // equal ones in the order of their bytes
  for (const Spacing& spacing : spacings_) {
    const double too_many = std::max(0.0, share_beyond(spacing, grids_.limits.error_px) - (1 - grids_.limits.share));
    last.emplace(grids_.forecast.lost_share(spacing.nx, spacing.ny) + too_many, &spacing);
  }
  for (const auto& [loss, spacing] : last | std::views::take(kLastTries)) {
    if (loss <= kWorthATry * last.begin()->first && (attempt(*spacing) || best_of_whole_cells_)) return;
  }
}

CompiledMap Search::best() {
  const auto good = [&](const Spacing& spacing) { return is_likely(spacing) && attempt(spacing); };
  if (!std::ranges::any_of(spacings_, good) && !best_of_whole_cells_) try_last();
  const MapLimits& limits = grids_.limits;
  if (best_of_whole_cells_ && !(best_ && best_->report.lost_share() <= limits.largest_lost_share)) {
    best_ = std::move(best_of_whole_cells_);
  }
  if (!best_ && nothing_) throw UnseenError(*nothing_);
  if (!best_) {
    throw std::runtime_error(fmt::format(
        "no table of at most {} bytes (the pool of profile {} holds {}) stays within {} "
        "px of it for {} % of the pixels",
        largest_bytes_, grids_.profile.name, grids_.profile.pool_bytes, limits.error_px, 100 * limits.share));
  }
  return *std::move(best_);
}

}  // namespace

UnseenError::UnseenError(const MapReport& report) : std::runtime_error(unseen_text(report)) {}

std::string rows_text(RowReach reach) {
  return fmt::format("y{:+d} to y{:+d} ({} rows)", -reach.behind, reach.ahead, reach.ahead + reach.behind + 1);
}

CompiledMap choose(const Grids& grids) {
  CompiledMap best = Search(grids).best();
  const MachineProfile& profile = grids.profile;
  const RowReach reach = best.report.reach;
  const auto lookahead = lookahead_for(profile, reach);
  if (!lookahead) {
    throw std::runtime_error(
        fmt::format("left row y needs the right rows {}; the store of profile {} holds {} rows, of "
                    "which it gives {}{}",
                    rows_text(reach), profile.name, profile.store_rows,
                    rows_text({profile.rows_behind(), profile.largest_lookahead()}), store_that_holds(profile, reach)));
  }
  best.report.lookahead = *lookahead;
  return best;
}

}  // namespace horopter
