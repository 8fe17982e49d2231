// SPDX-License-Identifier: Apache-2.0
// Values on a grid, row by row.
#pragma once

#include <cstddef>
#include <vector>

namespace horopter::study {

template <class T>
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<T> values;

  Raster() = default;
  Raster(int columns, int rows, T value = {})
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}
  T* row(int y) { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
  const T* row(int y) const { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
  T& at(int x, int y) { return row(y)[x]; }
  T at(int x, int y) const { return row(y)[x]; }
  friend bool operator==(const Raster&, const Raster&) = default;
};

/// Grey values or what is made of them. Filters of 8-bit images are exact in it.
using Plane = Raster<double>;

}  // namespace horopter::study
