// SPDX-License-Identifier: Apache-2.0
// Table 8.2: criteria based on absolute differences. Where the window's own mean is taken from each pixel there are no
// running sums (thesis 8.6); such a window is summed anew.
#include <cmath>
#include <stdexcept>
#include <vector>

#include "horopter/study/filters.hpp"
#include "window_sums.hpp"

namespace horopter::study {
namespace {

const Plane& absolute_sum(Pair& pair) {
  return pair.shared_sum("|r-s|", [&] {
    const Plane& differences = pair.shared("|r-s|", [&] {
      Plane result(pair.r().width, pair.r().height);
      for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = std::abs(pair.r().values[i] - pair.s().values[i]);
      return result;
    });
    return box_sum(differences, pair.kernel());
  });
}

/// Σ |r − scale·s| with a scale for each window.
template <int K>
void fill_windows(const Plane& r, const Plane& s, const Plane& scale, Plane& result) {
  constexpr int kReach = K / 2;
  const int count = r.width - K + 1;
  for (int y = kReach; y < r.height - kReach; ++y) {
    double* out = result.row(y) + kReach;
    const double* q = scale.row(y) + kReach;
    for (int j = -kReach; j <= kReach; ++j) {
      const double* a = r.row(y + j);
      const double* b = s.row(y + j);
      for (int x = 0; x < count; ++x) {
        double sum = 0;
        for (int i = 0; i < K; ++i) sum += std::abs(a[x + i] - q[x] * b[x + i]);
        out[x] += sum;
      }
    }
  }
}

/// Σ |difference − offset| with an offset for each window.
template <int K>
void fill_windows(const Plane& difference, const Plane& offset, Plane& result) {
  constexpr int kReach = K / 2;
  const int count = difference.width - K + 1;
  for (int y = kReach; y < difference.height - kReach; ++y) {
    double* out = result.row(y) + kReach;
    const double* m = offset.row(y) + kReach;
    for (int j = -kReach; j <= kReach; ++j) {
      const double* a = difference.row(y + j);
      for (int x = 0; x < count; ++x) {
        double sum = 0;
        for (int i = 0; i < K; ++i) sum += std::abs(a[x + i] - m[x]);
        out[x] += sum;
      }
    }
  }
}

/// Calls f.operator()<K>() for the pair's K.
template <class F>
void with_kernel(int kernel, F f) {
  switch (kernel) {
    case 3:
      return f.template operator()<3>();
    case 5:
      return f.template operator()<5>();
    case 7:
      return f.template operator()<7>();
    case 9:
      return f.template operator()<9>();
    case 11:
      return f.template operator()<11>();
    case 13:
      return f.template operator()<13>();
    case 17:
      return f.template operator()<17>();
    case 21:
      return f.template operator()<21>();
    default:
      throw std::invalid_argument("ZSAD, LSAD: windows of 3×3 to 13×13, 17×17 and 21×21");
  }
}

class Sad final : public Criterion {
 public:
  std::string name() const override { return "SAD"; }
  bool similarity() const override { return false; }
  Plane compare(Pair& pair) const override { return absolute_sum(pair); }
};

class Zsad final : public Criterion {
 public:
  std::string name() const override { return "ZSAD"; }
  bool similarity() const override { return false; }
  Plane compare(Pair& pair) const override {
    const Plane& difference = pair.shared("r-s", [&] {
      Plane result(pair.r().width, pair.r().height);
      for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = pair.r().values[i] - pair.s().values[i];
      return result;
    });
    Plane mean(difference.width, difference.height);
    const double n = static_cast<double>(pair.kernel()) * pair.kernel();
    const Plane& r = pair.sum(Pair::Sum::r);
    const Plane& s = pair.sum(Pair::Sum::s);
    for (std::size_t i = 0; i < mean.values.size(); ++i) mean.values[i] = (r.values[i] - s.values[i]) / n;
    Plane result(difference.width, difference.height);
    with_kernel(pair.kernel(), [&]<int K>() { fill_windows<K>(difference, mean, result); });
    return result;
  }
};

class Lsad final : public Criterion {
 public:
  std::string name() const override { return "LSAD"; }
  bool similarity() const override { return false; }
  Plane compare(Pair& pair) const override {
    const Plane& r = pair.sum(Pair::Sum::r);
    const Plane& s = pair.sum(Pair::Sum::s);
    Plane scale(r.width, r.height);
    for (std::size_t i = 0; i < scale.values.size(); ++i) scale.values[i] = local_scale(r.values[i], s.values[i]);
    Plane result(r.width, r.height);
    with_kernel(pair.kernel(), [&]<int K>() { fill_windows<K>(pair.r(), pair.s(), scale, result); });
    return result;
  }
};

class Nsad final : public Criterion {
 public:
  std::string name() const override { return "NSAD"; }
  bool similarity() const override { return false; }
  Plane compare(Pair& pair) const override {
    const Plane& r = pair.sum(Pair::Sum::r);
    const Plane& s = pair.sum(Pair::Sum::s);
    Plane result = absolute_sum(pair);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      const double norm = std::sqrt(std::abs(r.values[i]) * std::abs(s.values[i]));
      result.values[i] = norm > 0 ? result.values[i] / norm : kUndefined;
    }
    return result;
  }
};

}  // namespace

std::vector<std::unique_ptr<Criterion>> absolute_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(std::make_unique<Sad>());
  result.push_back(std::make_unique<Zsad>());
  result.push_back(std::make_unique<Lsad>());
  result.push_back(std::make_unique<Nsad>());
  return result;
}

}  // namespace horopter::study
