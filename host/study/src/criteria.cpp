// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/criteria.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <utility>

#include "horopter/study/filters.hpp"

namespace horopter::study {

std::string name_of(const Preparation& preparation) {
  switch (preparation.feature) {
    case Feature::camera:
      return "hardware";
    case Feature::log_sign:
      return fmt::format("LoG w={:g}", preparation.log_w_px);
    case Feature::dog_sign:
      return fmt::format("DoG w={:g}", preparation.log_w_px);
    case Feature::roberts_sign:
      return "Roberts";
    case Feature::direction:
      return preparation.lowpass ? "LP" : "none";
    default:
      if (preparation.highpass) return preparation.lowpass ? "LP+HP" : "HP";
      return preparation.lowpass ? "LP" : "none";
  }
}

Plane prepare(const Image& image, const Preparation& preparation) { return prepare(to_plane(image), preparation); }

Plane prepare(const Plane& image, const Preparation& preparation) {
  Plane plane = image;
  if (preparation.feature == Feature::camera) return plane;
  if (preparation.feature == Feature::log_sign) return log_sign(plane, preparation.log_w_px);
  if (preparation.feature == Feature::dog_sign) return dog_sign(plane, preparation.log_w_px);
  if (preparation.feature == Feature::roberts_sign) return roberts_sign(plane);
  if (preparation.lowpass) plane = lowpass(plane);
  if (preparation.feature == Feature::direction) return sobel_direction(plane);
  if (preparation.highpass) plane = highpass(plane);
  return plane;
}

void Pair::set_kernel(int kernel) {
  if (kernel < 1 || kernel % 2 == 0) throw std::invalid_argument("the side of a correlation window is odd");
  if (kernel == kernel_) return;
  kernel_ = kernel;
  sums_.clear();
}

const Plane& Pair::shared(const std::string& key, const std::function<Plane()>& make) {
  const auto found = shared_.find(key);
  return found != shared_.end() ? found->second : shared_.emplace(key, make()).first->second;
}

const Plane& Pair::shared_sum(const std::string& key, const std::function<Plane()>& make) {
  const auto found = sums_.find(key);
  return found != sums_.end() ? found->second : sums_.emplace(key, make()).first->second;
}

const Plane& Pair::sum(Sum which) {
  const auto products = [](const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < a.values.size(); ++i) result.values[i] = a.values[i] * b.values[i];
    return result;
  };
  const auto summed = [&](const char* key, const Plane& a, const Plane* b) -> const Plane& {
    return shared_sum(key, [&] {
      return b == nullptr ? box_sum(a, kernel_) : box_sum(shared(key, [&] { return products(a, *b); }), kernel_);
    });
  };
  switch (which) {
    case Sum::r:
      return summed("r", r_, nullptr);
    case Sum::s:
      return summed("s", s_, nullptr);
    case Sum::rr:
      return summed("rr", r_, &r_);
    case Sum::ss:
      return summed("ss", s_, &s_);
    default:
      return summed("rs", r_, &s_);
  }
}

double Criterion::best(int) const { return similarity() ? 1 : 0; }
double Criterion::worst(int) const { return std::numeric_limits<double>::infinity(); }

const std::vector<std::unique_ptr<Criterion>>& criteria() {
  static const auto all = [] {
    std::vector<std::unique_ptr<Criterion>> result;
    for (auto* family : {cross_correlation_criteria, binary_criteria, squared_criteria, absolute_criteria,
                         direction_criteria, hardware_criteria}) {
      for (auto& one : family()) result.push_back(std::move(one));
    }
    return result;
  }();
  return all;
}

const Criterion& criterion(const std::string& name) {
  std::string known;
  for (const auto& one : criteria()) {
    if (one->name() == name) return *one;
    known += (known.empty() ? "" : ", ") + one->name();
  }
  throw std::invalid_argument(fmt::format("criterion '{}': expected one of {}", name, known));
}

}  // namespace horopter::study
