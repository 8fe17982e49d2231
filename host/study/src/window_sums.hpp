// SPDX-License-Identifier: Apache-2.0
// What the criteria of grey values compute from: the sums over one window.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>

#include "horopter/study/criteria.hpp"

namespace horopter::study {

inline constexpr double kUndefined = std::numeric_limits<double>::infinity();

/// With 8-bit images and their filters every sum and every variance here is exact.
struct WindowSums {
  double n, r, s, rr, ss, rs;
  /// n² times variances and covariance.
  double var_r() const { return n * rr - r * r; }
  double var_s() const { return n * ss - s * s; }
  double cov() const { return n * rs - r * s; }
};

/// f(WindowSums) for each pixel.
template <class F>
Plane of_sums(Pair& pair, F f) {
  const Plane& r = pair.sum(Pair::Sum::r);
  const Plane& s = pair.sum(Pair::Sum::s);
  const Plane& rr = pair.sum(Pair::Sum::rr);
  const Plane& ss = pair.sum(Pair::Sum::ss);
  const Plane& rs = pair.sum(Pair::Sum::rs);
  Plane result(r.width, r.height);
  const double n = static_cast<double>(pair.kernel()) * pair.kernel();
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = f(WindowSums{n, r.values[i], s.values[i], rr.values[i], ss.values[i], rs.values[i]});
  return result;
}

/// r̄ / s̄ of the locally scaled criteria; 1 where the signs differ or one is 0 (thesis, footnote 4 of 8.1.2).
inline double local_scale(double r, double s) { return r * s > 0 ? r / s : 1; }

/// A criterion that is a function of WindowSums.
template <class F>
class SumCriterion final : public Criterion {
 public:
  SumCriterion(const char* name, bool similarity, F f) : name_(name), similarity_(similarity), f_(std::move(f)) {}
  std::string name() const override { return name_; }
  bool similarity() const override { return similarity_; }
  Plane compare(Pair& pair) const override { return of_sums(pair, f_); }

 private:
  const char* name_;
  bool similarity_;
  F f_;
};

template <class F>
std::unique_ptr<Criterion> of_window(const char* name, bool similarity, F f) {
  return std::make_unique<SumCriterion<F>>(name, similarity, std::move(f));
}

}  // namespace horopter::study
