// SPDX-License-Identifier: Apache-2.0
// Moments of a monitor that nobody runs, for tests of its log and its page.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <random>
#include <string>

#include "horopter/machine/report.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::test {

/// When the first pair arrived; the others after it by their number and the rate.
inline const monitor::Clock::time_point kBegin = monitor::Clock::now();

inline Image noise(int width, int height, std::uint32_t seed) {
  Image image(width, height);
  std::mt19937 random(seed);
  for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random());
  return image;
}

inline monitor::Status status_of(std::uint64_t frame, bool alarm) {
  monitor::Status status;
  status.time = std::chrono::system_clock::time_point(std::chrono::milliseconds(1'800'000'000'000 + 40 * frame));
  status.frame = frame;
  status.safe = !alarm;
  status.alarm = alarm;
  status.restart = alarm ? monitor::Restart::needed : monitor::Restart::not_needed;
  status.table = 0;
  status.table_crc = 0x1234abcd;
  status.skew_ms = 0.2;
  status.explained = 0.93;
  status.taught = true;
  status.decision_ms = 12.5;
  for (const char* name : {"left", "right"}) {
    monitor::CameraState camera;
    camera.name = name;
    camera.source = "files:recorded";
    camera.connected = true;
    camera.frames = frame;
    camera.frames_per_s = 25;
    camera.exposure_us = 5000;
    camera.sharpness = 0.41;
    status.cameras.push_back(camera);
  }
  if (!alarm) return status;
  status.causes.push_back(
      {"alarm", "Something is in the skin", "Take it out, look whether somebody is inside, restart."});
  status.latched = status.causes;
  monitor::ObjectState object;
  object.id = 7;
  object.pixels = 240;
  object.x = 10;
  object.y = 8;
  object.width = 20;
  object.height = 12;
  object.age_frames = 1;
  object.size_mm = 85;
  object.distance_mm = 912;
  object.speed_mm_s = 1430;
  status.objects.push_back(object);
  return status;
}

/// A pair of noise, small, at 25 pairs a second.
inline monitor::MomentPtr moment_of(std::uint64_t frame, bool alarm = false, int width = 64, int height = 48) {
  auto moment = std::make_shared<monitor::Moment>();
  moment->arrived = kBegin + std::chrono::milliseconds(40 * frame);
  moment->left = noise(width, height, static_cast<std::uint32_t>(2 * frame));
  moment->right = noise(width, height, static_cast<std::uint32_t>(2 * frame + 1));
  moment->result.states = Image(width, height, static_cast<std::uint8_t>(State::clear));
  moment->status = status_of(frame, alarm);
  for (const monitor::ObjectState& object : moment->status.objects) {
    for (int y = object.y; y < object.y + object.height; ++y) {
      for (int x = object.x; x < object.x + object.width; ++x) {
        moment->result.states.at(x, y) = static_cast<std::uint8_t>(State::skin);
      }
    }
  }
  moment->result.alarm = alarm;
  moment->result.safe = !alarm;
  moment->result.object_limit_pixels = 100;
  return moment;
}

}  // namespace horopter::test
