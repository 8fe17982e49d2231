// SPDX-License-Identifier: Apache-2.0
#include "pixel_kinds.hpp"

namespace horopter {
namespace {

/// Of a cell at the end of its row or column, or not.
ByKind<double> weights(const CellGrid& grid, bool last_column, bool last_row) {
  const auto part = [](int size, int n, bool last) { return last ? ((size - 1) & ((1 << n) - 1)) + 1 : 1 << n; };
  const int width = part(grid.scan.width, grid.nx, last_column);
  const int height = part(grid.scan.height, grid.ny, last_row);
  const int across = (width + (1 << grid.sample_x_log2) - 1) >> grid.sample_x_log2;
  const int down = (height + (1 << grid.sample_y_log2) - 1) >> grid.sample_y_log2;
  const ByKind<int> pixels{1, width - 1, height - 1, (width - 1) * (height - 1)};
  const ByKind<int> samples{1, across - 1, down - 1, (across - 1) * (down - 1)};
  ByKind<double> weights{};
  for (int kind = 0; kind < kKinds; ++kind) {
    // Pixels of a kind without a sample go with those of the edge, or of the corner.
    int at = kind;
    if (samples[at] == 0 && at == 3) at = samples[2] != 0 ? 2 : 1;
    if (samples[at] == 0) at = 0;
    weights[at] += static_cast<double>(pixels[kind]) / samples[at];
  }
  return weights;
}

}  // namespace

SampleWeights::SampleWeights(const CellGrid& grid)
    : last_column_(grid.columns - 1),
      last_row_(grid.rows - 1),
      weights_{weights(grid, false, false), weights(grid, true, false), weights(grid, false, true),
               weights(grid, true, true)} {}

}  // namespace horopter
