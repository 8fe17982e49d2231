// SPDX-License-Identifier: Apache-2.0
// Studies from outside, at their quick size: what they find, and the files they write.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sandbox.hpp"

using namespace horopter::test;
using nlohmann::json;

namespace {

/// Runs a study at its quick size, checks its files, and returns its figures.
json study(const Sandbox& box, const std::string& name, const std::set<std::string>& files) {
  const auto result = box.run({"study", name, "--quick", "--out", name, "--json"});
  CAPTURE(name, result.err);
  REQUIRE(result.status == 0);
  for (const std::string& file : files) {
    const std::string text = box.read(name + "/" + file);
    CAPTURE(file);
    CHECK(text.size() > 100);
    if (file.ends_with(".svg")) CHECK_THAT(text, Catch::StartsWith("<?xml") && Catch::EndsWith("</svg>\n"));
  }
  const json figures = json::parse(result.out);
  CHECK(figures["findings"].size() > 0);
  return figures;
}

}  // namespace

TEST_CASE("study resolution: 4 bits after differencing cost less than 7 %, 8-bit directions less than 2 %") {
  Sandbox box;
  const json figures = study(box, "resolution", {"fig-10-4.csv", "fig-10-4.svg", "rounding.csv"});
  const json& losses = figures["losses"]["5x5"];
  CHECK(losses["4 bit after differencing"]["largest_from_0.3_px"].get<double>() < 0.07);
  CHECK(losses["7 bit after differencing"]["against_floating_point"].get<double>() < 0.02);
  // One bit more is needed before differencing, and one bit in all is not enough.
  CHECK(losses["1 bit after differencing"]["largest_from_0.3_px"].get<double>() > 0.1);
  CHECK(losses["4 bit before differencing"]["largest_from_0.3_px"].get<double>() >
        losses["4 bit after differencing"]["largest_from_0.3_px"].get<double>());
  // The low-pass is rounded to grey levels: the weaker the texture, the more of it that is. The insides of large leaves
  // are weak at every contrast.
  double last = 1;
  for (const char* grey : {"6", "12", "24", "40"}) {
    const double largest = figures["rounding"][grey]["largest"];
    CAPTURE(grey);
    CHECK(largest < last);
    last = largest;
  }
  CHECK(figures["rounding"]["40"]["largest"].get<double>() < 0.05);
  CHECK(figures["rounding"]["40"]["within_2_percent_from_px"].get<double>() <= 1.05);
}

TEST_CASE("study texture: Table 9.1, and one curve over texture to noise") {
  Sandbox box;
  const json figures = study(box, "texture",
                             {"table-9-1.csv", "table-9-2.csv", "fig-9-1.csv", "fig-9-1.svg", "fig-9-2.csv",
                              "fig-9-2.svg", "fig-9-2-measures.csv"});
  const auto within = [](const json& apart) { return apart["within"].get<double>(); };
  CHECK(within(figures["strengths"]) < 0.03);
  // Kinds differ by their spectra, with noise and without; the thesis's measure of the ratio is the best.
  CHECK(within(figures["kinds_of_like_spectrum"]) < 0.6 * within(figures["kinds"]));
  CHECK(within(figures["kinds_without_noise"]) > 0.03);
  for (const auto& [name, apart] : figures["measures_of_ratio"].items()) {
    CAPTURE(name);
    CHECK(within(apart) >= within(figures["kinds"]));
  }
  const auto passes = [&](const char* name) { return figures["patterns"][name]["passes_lowpass"].get<double>(); };
  CHECK(passes("band-noise to 12 px") == Approx(passes("texture 20")).epsilon(0.05));
  CHECK(passes("band-noise") < 0.8 * passes("texture 20"));
  const auto scale = [&](const char* measure) {
    return figures["measures"][measure]["plain"]["scale_factor"].get<double>();
  };
  CHECK(scale("Std dev 7×7") == 1);
  CHECK(scale("Sobel") == Approx(6.8).epsilon(0.03));
  CHECK(scale("Prewitt") == Approx(4.7).epsilon(0.03));
  const auto deviation = [&](const char* measure, const char* filter) {
    return figures["measures"][measure][filter]["relative_std_dev"].get<double>();
  };
  CHECK(deviation("Sobel", "plain") == Approx(0.525).epsilon(0.05));
  CHECK(deviation("Sobel", "lowpass") < 0.8 * deviation("Sobel", "plain"));
}

TEST_CASE("study operators: majority and clusterlet elimination are better than opening and closing") {
  Sandbox box;
  const json figures =
      study(box, "operators", {"fig-5-7.csv", "fig-5-7.png", "operators-noise.csv", "operators-noise.svg"});
  const auto wrong = [&](const char* name) { return figures["operators"][name]["wrong"].get<double>(); };
  CHECK(wrong("majority 7x7") < wrong("threshold"));
  CHECK(wrong("majority 7x7") < wrong("opening 5x5"));
  CHECK(wrong("majority 7x7") < wrong("closing 5x5"));
  CHECK(figures["operators"]["majority 7x7"]["clusters"].get<int>() <
        figures["operators"]["threshold"]["clusters"].get<int>());
  // Two runs are one.
  box.run({"study", "operators", "--quick", "--out", "again"});
  for (const char* file : {"fig-5-7.png", "operators-noise.csv", "summary.json"}) {
    CHECK(box.read(std::string("operators/") + file) == box.read(std::string("again/") + file));
  }
}

TEST_CASE("study geometry: the images are exploited best where the axes meet") {
  Sandbox box;
  const json figures =
      study(box, "geometry", {"fig-11-2.csv", "fig-11-2.svg", "fig-11-3.csv", "fig-11-3.svg", "fig-11-3.png"});
  for (const auto& [name, setup] : figures["tilt"].items()) {
    CAPTURE(name);
    CHECK(setup["best_tilt_deg"].get<double>() == Approx(setup["converging_tilt_deg"].get<double>()).margin(1));
    CHECK(setup["best_exploitation"].get<double>() > 0.9);
    CHECK(setup["exploitation_without_tilt"].get<double>() < 0.75);
  }
}

TEST_CASE("study computation: Table 10.1") {
  Sandbox box;
  const json figures = study(box, "computation", {"table-10-1.csv"});
  for (const auto& [name, step] : figures["steps"].items()) {
    CAPTURE(name);
    // Printed in whole millions, most of them rounded up, which adds up.
    CHECK(step["memory_accesses_million_per_s"].get<double>() ==
          Approx(step["printed_memory_accesses"].get<double>()).margin(name == "Total" ? 3 : 1.1));
    if (name == "Transformation" || name == "Total") continue;  // 16xy instead of 14xy
    CHECK(step["operations_million_per_s"].get<double>() ==
          Approx(step["operations_by_the_printed_formula"].get<double>()).epsilon(1e-9));
  }
}
