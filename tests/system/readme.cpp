// SPDX-License-Identifier: Apache-2.0
// What README tells a new user to type works as it stands there.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "sandbox.hpp"

using namespace horopter::test;

namespace {

const std::string kData = "/usr/share/doc/opencv-doc/examples/data/";

/// The blocks of README that are marked as this language.
std::vector<std::string> blocks(const std::string& language) {
  std::ifstream stream(HOROPTER_README, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::string fence = "```";
  std::vector<std::string> result;
  for (auto at = text.find(fence + language + "\n"); at != std::string::npos;
       at = text.find(fence + language + "\n", at + 1)) {
    const auto begin = at + fence.size() + language.size() + 1;
    result.push_back(text.substr(begin, text.find(fence, begin) - begin));
  }
  return result;
}

}  // namespace

TEST_CASE("README's skins run on the photographs that it names") {
  Sandbox box;
  const auto calibrated = box.run({"calibrate", "--left", kData + "left??.jpg", "--right", kData + "right??.jpg",
                                   "--target", "chessboard:9x6:30mm", "-o", "rig.yaml"});
  CAPTURE(calibrated.err);
  REQUIRE(calibrated.status == 0);
  int skins = 0;
  for (const std::string& block : blocks("yaml")) {
    if (!Catch::contains(block, "surface:")) continue;
    ++skins;
    box.write("skin.yaml", block);
    CAPTURE(block);
    const auto result = box.run({"run", "--left", kData + "left01.jpg", "--right", kData + "right01.jpg", "--skin",
                                 "skin.yaml", "--rig", "rig.yaml", "--out", "out", "--json"});
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    if (Catch::contains(block, "correspondences")) {
      CHECK(nlohmann::json::parse(result.out)["frames"][0]["alarm"] == true);
    }
  }
  CHECK(skins == 2);
}

TEST_CASE("Every command in README's blocks has the options that it is given") {
  Sandbox box;
  int commands = 0;
  for (std::string block : blocks("sh")) {
    for (auto at = block.find("\\\n"); at != std::string::npos; at = block.find("\\\n")) block.erase(at, 2);
    std::istringstream lines(block);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("build/release/bin/")) line.erase(0, 18);
      if (!line.starts_with("horopter ")) continue;
      ++commands;
      std::istringstream words(line.substr(9, line.find('#') - 9));
      std::string word;
      words >> word;
      std::vector<std::string> command{word};
      std::vector<std::string> options;
      while (words >> word) {
        if (word.starts_with("-")) options.push_back(word);
        if (!word.starts_with("-") && options.empty()) command.push_back(word);
      }
      const std::string help = box.run(command + std::vector<std::string>{"--help"}).out;
      for (const std::string& option : options) {
        CAPTURE(line, option);
        CHECK_THAT(help, Catch::Contains(option));
      }
    }
  }
  CHECK(commands >= 6);
}
