// SPDX-License-Identifier: Apache-2.0
// The rule `compete` as the commands that measure it use it: by the native engine, the only one that has it.
#pragma once

#include <memory>
#include <utility>

#include "horopter/image.hpp"
#include "horopter/map.hpp"
#include "horopter/profile.hpp"
#include "stages/engine.hpp"

namespace horopter::cli {

class CompeteMachine {
 public:
  struct Result {
    Image states;
    bool alarm = false;
  };

  /// For images of width × height; lookahead in rows, enough for every table.
  CompeteMachine(const MachineProfile& profile, int width, int height, int lookahead,
                 const native::CompeteSettings& competition)
      : engine_(native::make_engine(profile.name)), settings_(native::Settings::defaults(profile, width, height)) {
    settings_.lookahead = lookahead;
    settings_.compete = true;
    settings_.competition = competition;
  }

  Result process(const MapTable& table, const Image& left, const Image& right) {
    const auto view = [](const Image& image) {
      return native::ImageView{image.pixels.data(), image.width, image.height, image.width};
    };
    native::FrameResult frame = engine_->process(view(left), view(right), native::TableView(table.words()), settings_);
    Result result;
    result.states.width = frame.width;
    result.states.height = frame.height;
    result.states.pixels = std::move(frame.states);
    result.alarm = frame.alarm;
    return result;
  }

 private:
  std::unique_ptr<native::Engine> engine_;
  native::Settings settings_;
};

}  // namespace horopter::cli
