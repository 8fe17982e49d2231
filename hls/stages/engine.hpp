// SPDX-License-Identifier: Apache-2.0
// The native engine of any profile behind one type; library horopter::native.
#pragma once

#include <memory>
#include <string_view>

#include "stages/pipeline.hpp"

namespace horopter::native {

class Engine {
 public:
  virtual ~Engine() = default;
  virtual FrameResult process(const ImageView& left, const ImageView& right, const TableView& table,
                              const Settings& settings) = 0;
  [[nodiscard]] virtual const hls::Profile& profile() const = 0;
};

/// Null for a name that profiles.def does not have. An engine remembers the last frame only to find a frozen camera.
std::unique_ptr<Engine> make_engine(std::string_view profile_name, int threads = 1);

}  // namespace horopter::native
