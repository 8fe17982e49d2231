// SPDX-License-Identifier: Apache-2.0
// The correlation criteria of Tables 8.1 and 8.2, plain cross correlation (eq. 8.1), those of directions (eq. 8.5, 8.6),
// the binary ones (8.1.4), and what the hardware computes, all as planes of one value per pixel.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/study/raster.hpp"

namespace horopter::study {

/// What a criterion works on.
enum class Feature {
  grey,          ///< grey values, optionally low-pass or high-pass filtered
  direction,     ///< of Sobel's gradient, optionally after the low-pass
  log_sign,      ///< sign of the Laplacian of Gaussian
  dog_sign,      ///< sign of a difference of two Gaussians, which is nearly the same
  roberts_sign,  ///< +1 where Roberts' gradient is above its mean nearby
  camera         ///< the 8-bit image as it is: the hardware filters by itself
};

struct Preparation {
  Feature feature = Feature::grey;
  bool lowpass = false;
  bool highpass = false;  ///< after the low-pass; Feature::grey only
  double log_w_px = 0;    ///< Feature::log_sign and dog_sign only
  friend auto operator<=>(const Preparation&, const Preparation&) = default;
};

std::string name_of(const Preparation& preparation);
Plane prepare(const Plane& image, const Preparation& preparation);
Plane prepare(const Image& image, const Preparation& preparation);

/// Two prepared images of one size, and what criteria share of them: made when first asked for.
class Pair {
 public:
  /// r and s of the thesis; both must outlive this.
  Pair(const Plane& r, const Plane& s) : r_(r), s_(s) {}
  const Plane& r() const { return r_; }
  const Plane& s() const { return s_; }
  /// Side of the windows, px, odd.
  int kernel() const { return kernel_; }
  void set_kernel(int kernel);

  enum class Sum { r, s, rr, ss, rs };
  /// Over the window, for each pixel.
  const Plane& sum(Sum which);
  /// What does not depend on the window; `key` is of whoever makes it.
  const Plane& shared(const std::string& key, const std::function<Plane()>& make);
  /// What does.
  const Plane& shared_sum(const std::string& key, const std::function<Plane()>& make);

 private:
  const Plane& r_;
  const Plane& s_;
  int kernel_ = 9;
  std::map<std::string, Plane> shared_;
  std::map<std::string, Plane> sums_;
};

class Criterion {
 public:
  virtual ~Criterion() = default;
  virtual std::string name() const = 0;
  virtual Feature feature() const { return Feature::grey; }
  /// A similarity is largest, a dissimilarity 0 for equal windows.
  virtual bool similarity() const = 0;
  /// Of equal windows, for a similarity.
  virtual double best(int kernel) const;
  /// Of windows as different as can be, where there is such a number; else infinite.
  virtual double worst(int kernel) const;
  /// The criterion of r against s for each pixel whose window lies in the image; others mean nothing. A window in which
  /// it is undefined (no variation, no brightness) has similarity 0, or an infinite dissimilarity.
  virtual Plane compare(Pair& pair) const = 0;
};

/// All of them, in the thesis's order, the hardware's last.
const std::vector<std::unique_ptr<Criterion>>& criteria();
/// Throws std::invalid_argument, naming those there are.
const Criterion& criterion(const std::string& name);

/// Families, each in a file of its own.
std::vector<std::unique_ptr<Criterion>> cross_correlation_criteria();
std::vector<std::unique_ptr<Criterion>> binary_criteria();
std::vector<std::unique_ptr<Criterion>> squared_criteria();
std::vector<std::unique_ptr<Criterion>> absolute_criteria();
std::vector<std::unique_ptr<Criterion>> direction_criteria();
std::vector<std::unique_ptr<Criterion>> hardware_criteria();

}  // namespace horopter::study
