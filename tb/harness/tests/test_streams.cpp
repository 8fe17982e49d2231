// SPDX-License-Identifier: Apache-2.0
// The stream modules under every pair of paces, which tests the harness's endpoints too.
#include <Vtb_axis_fifo.h>
#include <Vtb_axis_skid.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "horopter/tb/axis.hpp"
#include "horopter/tb/image.hpp"
#include "horopter/tb/simulation.hpp"

using namespace horopter::tb;

namespace {

Pace pace(int kind, std::uint64_t seed) {
  switch (kind) {
    case 0:
      return {};
    case 1:
      return Pace::periodic(3, 2);
    case 2:
      return Pace::periodic(1, 6);
    default:
      return Pace::random(50, seed);
  }
}

/// Every byte of random frames comes out, in order, whatever both ends do.
template <class Model>
void carries_everything(const std::string& name) {
  const int source_pace = GENERATE(0, 1, 2, 3), sink_pace = GENERATE(0, 1, 2, 3);
  Rng rng{name};
  Simulation<Model> simulation{rng.next(), 200'000};
  Model& model = simulation.model();
  VideoSource source{{&model.s_valid_i, &model.s_ready_o, &model.s_data_i}, pace(source_pace, rng.next())};
  StreamSink<std::uint8_t> sink{
      name, {&model.m_valid_o, &model.m_ready_i, &model.m_data_o}, pace(sink_pace, rng.next())};
  simulation.attach(source);
  simulation.attach(sink);
  simulation.reset();

  const Image image = noise_image(64, 32, rng);
  source.send(image);
  const std::uint64_t start = simulation.cycle();
  simulation.run_until([&] { return sink.beats().size() == image.pixels.size(); }, 50'000, "all bytes");
  if (source_pace == 0 && sink_pace == 0) CHECK(simulation.cycle() - start <= image.pixels.size() + 8);
  simulation.run(50);
  REQUIRE(sink.beats().size() == image.pixels.size());
  for (std::size_t n = 0; n < image.pixels.size(); ++n) REQUIRE(sink.beats()[n].data == image.pixels[n]);

  // A reset in mid-stream empties it.
  source.send(image);
  simulation.run(100);
  simulation.reset();
  sink.take();
  simulation.run(50);
  CHECK(sink.beats().empty());
}

}  // namespace

TEST_CASE("skid buffer: nothing is lost, doubled or reordered") { carries_everything<Vtb_axis_skid>("skid"); }

TEST_CASE("FIFO: nothing is lost, doubled or reordered") { carries_everything<Vtb_axis_fifo>("fifo"); }

TEST_CASE("a beat that changes while it waits is a protocol error") {
  std::uint8_t valid = 1, ready = 0, data = 7;
  StreamSink<std::uint8_t> sink{"broken", {&valid, &ready, &data}, Pace::periodic(1, 1000)};
  sink.drive();  // ready
  sink.sample();
  sink.drive();  // from now on not
  sink.sample();
  data = 8;
  sink.drive();
  CHECK_THROWS_AS(sink.sample(), ProtocolError);
}

TEST_CASE("a wait that never ends is an error that says for what") {
  Simulation<Vtb_axis_skid> simulation{1};
  CHECK_THROWS_WITH(simulation.run_until([] { return false; }, 10, "nothing"), "waited 10 clocks for nothing");
}
