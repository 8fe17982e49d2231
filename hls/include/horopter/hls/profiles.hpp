// SPDX-License-Identifier: Apache-2.0
// The profiles of profiles.def as constants: horopter::hls::profiles::field and so on.
#pragma once

#include <array>
#include <string_view>

namespace horopter::hls {

/// The rules that a build has; where it has both, a register chooses for each frame.
enum class Decisions { thesis, compete, both };
/// Which of them needs a stage.
enum class Rule { always, thesis, compete };

/// The largest sizes a build supports. A structural type: stages take it as a template argument.
struct Profile {
  int width = 0;            // of the camera images, px
  int height = 0;           // px
  int subsample = 1;        // horizontal pixels whose mean is one pixel of the result: 1 or 2
  int dsad_window = 9;      // k of the k×k sum of direction differences
  int majority_window = 7;  // m of the m×m majority
  int weight_bits = 3;      // of an interpolation weight: 1/8 px at 3
  int store_rows = 64;      // ring of the image store
  int pool_bytes = 0;       // mapping tables
  int hypotheses = 1;       // right images compared: the skin and its neighbours in disparity
  int clock_khz = 0;
  Decisions decisions = Decisions::both;
  // Of the rule `compete`:
  int planes = 19;       // that compete, see stages/planes.hpp
  int sum_rows = 7;      // of the window in which costs are summed
  int sum_columns = 9;   // px
  int ballot_reach = 9;  // rows above and below that vote
  bool paths = true;     // whether the pixel above helps, see stages/plane_paths.hpp

  [[nodiscard]] constexpr bool has_thesis() const { return decisions != Decisions::compete; }
  [[nodiscard]] constexpr bool has_compete() const { return decisions != Decisions::thesis; }
  [[nodiscard]] constexpr bool has(Rule rule) const {
    return rule == Rule::always || (rule == Rule::thesis ? has_thesis() : has_compete());
  }

  /// A progressive image becomes two fields, even rows first (thesis 7.6, 10.4.3).
  [[nodiscard]] constexpr bool takes_fields() const { return subsample == 2; }
  [[nodiscard]] constexpr int fields_per_image() const { return takes_fields() ? 2 : 1; }

  /// Width of the result, px.
  [[nodiscard]] constexpr int result_width() const { return width / subsample; }

  /// Sub-sampling halves the rate, so both images share one low-pass, Sobel and direction stage: their pixels alternate
  /// in one stream, the left image's first (thesis 10.4.3).
  [[nodiscard]] constexpr bool packed() const { return subsample == 2; }
  [[nodiscard]] constexpr int stream_lanes() const { return packed() ? 1 : 2; }
  [[nodiscard]] constexpr int stream_stride() const { return packed() ? 2 : 1; }
  /// Beats of a row from `subsample` to `difference`.
  [[nodiscard]] constexpr int stream_beats() const { return result_width() * stream_stride(); }

  /// Rows (and columns) by which the result of a pixel leaves the window stages late: 3×3 low-pass, 3×3 Sobel, k×k sum,
  /// m×m majority, all causal.
  [[nodiscard]] constexpr int offset() const { return 2 + (dsad_window - 1) / 2 + (majority_window - 1) / 2; }
  /// The same of `compete`, whose stages delay their marks with the pixel, so that there is no offset in columns.
  [[nodiscard]] constexpr int compete_offset() const {
    return 1 + (sum_rows - 1) / 2 + ballot_reach + (majority_window - 1) / 2;
  }

  /// Rows of beats without pixels after each frame: enough for the result of its last pixel and one beat more; with
  /// `compete`, in rows of 32 px, for its delay within the row, too.
  [[nodiscard]] constexpr int flush_rows(bool compete = false) const {
    return compete ? compete_offset() + 3 : offset() + 1;
  }

  /// Side of the cells, px, on whose means whole images are compared (stages/cells.hpp).
  [[nodiscard]] constexpr int cell() const { return width > 1024 ? 16 : 8; }

  /// Without what stages do not depend on: profiles for which it is the same have the same stages.
  [[nodiscard]] constexpr Profile of_stages() const {
    Profile profile = *this;
    profile.store_rows = 0;
    profile.pool_bytes = 0;
    return profile;
  }

  /// The same with other windows: `dsad` 5 to 13, `majority` 3 to 9, odd.
  [[nodiscard]] constexpr Profile with_windows(int dsad, int majority) const {
    Profile profile = *this;
    profile.dsad_window = dsad;
    profile.majority_window = majority;
    return profile;
  }

  friend constexpr bool operator==(const Profile&, const Profile&) = default;
};

namespace profiles {
#define HOROPTER_PROFILE(name, width, height, subsample, dsad, majority, weight_bits, store_rows, pool_bytes,  \
                         hypotheses, decisions, planes, sum_rows, sum_columns, ballot_reach, paths, clock_khz) \
  inline constexpr Profile name{width,                                                                         \
                                height,                                                                        \
                                subsample,                                                                     \
                                dsad,                                                                          \
                                majority,                                                                      \
                                weight_bits,                                                                   \
                                store_rows,                                                                    \
                                pool_bytes,                                                                    \
                                hypotheses,                                                                    \
                                clock_khz,                                                                     \
                                Decisions::decisions,                                                          \
                                planes,                                                                        \
                                sum_rows,                                                                      \
                                sum_columns,                                                                   \
                                ballot_reach,                                                                  \
                                paths != 0};
#include "horopter/hls/profiles.def"
#undef HOROPTER_PROFILE
}  // namespace profiles

struct NamedProfile {
  std::string_view name;
  Profile profile;
};

/// All profiles, in the order of profiles.def.
inline constexpr auto named_profiles = std::to_array<NamedProfile>({
#define HOROPTER_PROFILE(name, ...) {#name, profiles::name},
#include "horopter/hls/profiles.def"
#undef HOROPTER_PROFILE
});

}  // namespace horopter::hls
