// SPDX-License-Identifier: Apache-2.0
// Small problems of nonlinear least squares, solved until no digit moves.
//
// `Residuals` is a class with `int NumResiduals() const` and, for T a double or one of Ceres's dual numbers,
// `bool operator()(const T* parameters, T* residuals) const`, from which the derivatives follow.
#pragma once

#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>

namespace horopter::calib {

/// A parameter that must stay within limits.
struct Limited {
  int index;
  double low, high;
};

namespace detail {

template <int kParameters, class Residuals>
void minimise_freely(const Residuals& residuals, Eigen::Matrix<double, kParameters, 1>& parameters) {
  using Function = ceres::TinySolverAutoDiffFunction<Residuals, Eigen::Dynamic, kParameters>;
  const Function function(residuals);
  ceres::TinySolver<Function> solver;
  solver.options.max_num_iterations = 100;
  solver.options.gradient_tolerance = 1e-14;
  solver.options.parameter_tolerance = 1e-14;
  solver.options.function_tolerance = std::numeric_limits<double>::min();
  solver.Solve(function, &parameters);
}

/// The same residuals with one parameter held.
template <int kParameters, class Residuals>
struct Held {
  const Residuals& residuals;
  int index;
  double value;

  int NumResiduals() const { return residuals.NumResiduals(); }
  template <class T>
  bool operator()(const T* parameters, T* values) const {
    std::array<T, kParameters> all;
    std::copy_n(parameters, kParameters, all.begin());
    all[index] = T(value);
    return residuals(all.data(), values);
  }
};

}  // namespace detail

/// Moves `parameters` from a start to the nearest minimum of the sum of squared residuals, by Levenberg and Marquardt's
/// method. A minimum beyond the limits is replaced by the one on the nearer limit.
template <int kParameters, class Residuals>
void minimise(const Residuals& residuals, const Limited& limited, Eigen::Matrix<double, kParameters, 1>& parameters) {
  const Eigen::Matrix<double, kParameters, 1> start = parameters;
  double& value = parameters[limited.index];
  if (limited.low < limited.high) {
    detail::minimise_freely(residuals, parameters);
    if (value >= limited.low && value <= limited.high) return;
  }
  const double limit = value > limited.high ? limited.high : limited.low;
  parameters = start;
  value = limit;
  detail::minimise_freely(detail::Held<kParameters, Residuals>{residuals, limited.index, limit}, parameters);
}

}  // namespace horopter::calib
