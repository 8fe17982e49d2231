// SPDX-License-Identifier: Apache-2.0
// Compiled once for each of Instructions, which HOROPTER_INSTRUCTIONS names. Of all that is in the object file nothing but
// the function below is seen by others (hls/CMakeLists.txt): what it shares with them by its name, they must not take.
#include "stages/engine.hpp"

#define HOROPTER_JOINED(a, b) a##b
#define HOROPTER_NAMED(a, b) HOROPTER_JOINED(a, b)

namespace horopter::native {
namespace {

/// OF_STAGES: the same type for all profiles that have the same stages.
template <hls::Profile OF_STAGES>
class ProfileEngine final : public Engine {
 public:
  ProfileEngine(const hls::Profile& profile, int threads) : profile_(profile), pipeline_(threads, profile.store_rows) {}
  FrameResult process(const ImageView& left, const ImageView& right, const TableView& table,
                      const Settings& settings) override {
    return pipeline_.process(left, right, table, settings);
  }
  void prepare(const TableView& table, int lookahead) override { pipeline_.prepare(table, lookahead); }
  [[nodiscard]] int frames_that_expanded() const override { return pipeline_.frames_that_expanded(); }
  [[nodiscard]] int threads() const override { return pipeline_.threads(); }
  [[nodiscard]] const hls::Profile& profile() const override { return profile_; }

 private:
  hls::Profile profile_;
  Pipeline<OF_STAGES> pipeline_;
};

}  // namespace

std::unique_ptr<Engine> HOROPTER_NAMED(make_engine_, HOROPTER_INSTRUCTIONS)(std::string_view profile_name, int threads);

std::unique_ptr<Engine> HOROPTER_NAMED(make_engine_, HOROPTER_INSTRUCTIONS)(std::string_view profile_name,
                                                                            int threads) {
#define HOROPTER_PROFILE(name, ...) \
  if (profile_name == #name)        \
    return std::make_unique<ProfileEngine<hls::profiles::name.of_stages()>>(hls::profiles::name, threads);
#include "horopter/hls/profiles.def"
#undef HOROPTER_PROFILE
  return nullptr;
}

}  // namespace horopter::native
