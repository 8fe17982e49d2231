// SPDX-License-Identifier: Apache-2.0
// What README and the pages of docs/ tell a new user to type works as it stands there.
//
// A block of shell commands is run, with the other blocks of its page, from top to bottom in an empty directory. One
// after a comment `<!-- parsed, not run: WHY -->` is parsed only, and so are commands within the text.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "sandbox.hpp"

using namespace horopter::test;

namespace {

const std::string kData = "/usr/share/doc/opencv-doc/examples/data/";
const std::string kFence = "```";
const fs::path kProject = HOROPTER_SOURCE_DIR;

struct Page {
  std::string name;
  std::string text;
};

std::vector<Page> pages() {
  std::vector<fs::path> files{kProject / "README.md"};
  for (const auto& entry : fs::directory_iterator(kProject / "docs")) {
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Page> result;
  for (const fs::path& file : files) {
    result.push_back({fs::relative(file, kProject).string(), read_text(file)});
  }
  return result;
}

struct Block {
  std::string text;
  bool run = true;
};

/// The blocks of a page that are marked as this language.
std::vector<Block> blocks(const std::string& page, const std::string& language) {
  const std::string opening = kFence + language + "\n";
  std::vector<Block> result;
  for (auto at = page.find(opening); at != std::string::npos; at = page.find(opening, at + 1)) {
    const auto begin = at + opening.size();
    const auto before = page.rfind('\n', at < 2 ? 0 : at - 2);
    const std::string line = before == std::string::npos ? "" : page.substr(before + 1, at - before - 2);
    result.push_back(
        {page.substr(begin, page.find(kFence, begin) - begin), !line.starts_with("<!-- parsed, not run:")});
  }
  return result;
}

/// Lines of shell, those that go on joined.
std::vector<std::string> lines_of(std::string block) {
  for (auto at = block.find("\\\n"); at != std::string::npos; at = block.find("\\\n")) block.erase(at, 2);
  std::istringstream stream(block);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool has_option(const std::string& help, const std::string& option) {
  for (auto at = help.find(option); at != std::string::npos; at = help.find(option, at + 1)) {
    const char before = at == 0 ? ' ' : help[at - 1];
    const char after = at + option.size() == help.size() ? ' ' : help[at + option.size()];
    const auto ends = [](char c) { return std::string(" ,\n\"]|").find(c) != std::string::npos; };
    if ((ends(before) || before == '[') && ends(after)) return true;
  }
  return false;
}

/// A command line within the text or a block: the program or the script has the command and its options.
void check_command(const Sandbox& box, const std::string& line) {
  CAPTURE(line);
  std::istringstream words(line.substr(0, line.find('#')));
  std::string name;
  words >> name;
  std::vector<std::string> command;
  std::vector<std::string> options;
  for (std::string word; words >> word;) {
    if (word.starts_with("-")) options.push_back(word);
    if (!word.starts_with("-") && options.empty()) command.push_back(word);
  }
  static std::map<std::vector<std::string>, std::string> helps;
  std::string help;
  if (name.starts_with("scripts/")) {
    help = read_text(kProject / name);
  } else if (name == "horopter") {
    if (!helps.contains(command)) {
      const auto result = box.run(command + std::vector<std::string>{"--help"});
      CHECK(result.status == 0);
      helps[command] = result.out;
    }
    help = helps[command];
  } else {
    return;
  }
  CHECK_FALSE(help.empty());
  for (const std::string& option : options) {
    CAPTURE(option);
    CHECK(has_option(help, option));
  }
}

}  // namespace

TEST_CASE("The commands of every page run in order, in an empty directory") {
  int commands = 0;
  for (const Page& page : pages()) {
    std::string script = "set -eu\n";
    for (const Block& block : blocks(page.text, "sh")) {
      if (!block.run) continue;
      script += block.text;
      for (const std::string& line : lines_of(block.text)) commands += line.starts_with("horopter ") ? 1 : 0;
    }
    Sandbox box;
    CAPTURE(page.name);
    const auto result = box.run_shell(script);
    CAPTURE(result.out, result.err);
    CHECK(result.status == 0);
  }
  CHECK(commands >= 12);
}

TEST_CASE("Every command of every page has the options that it is given") {
  Sandbox box;
  int commands = 0;
  const std::regex quoted("`((?:horopter|scripts/)[^`]*)`");
  for (const Page& page : pages()) {
    CAPTURE(page.name);
    for (const Block& block : blocks(page.text, "sh")) {
      for (const std::string& line : lines_of(block.text)) {
        check_command(box, line);
        ++commands;
      }
    }
    std::string text = page.text;
    std::ranges::replace(text, '\n', ' ');
    for (std::sregex_iterator match(text.begin(), text.end(), quoted), end; match != end; ++match) {
      check_command(box, (*match)[1]);
      ++commands;
    }
  }
  CHECK(commands >= 40);
}

TEST_CASE("The skins of every page run on the photographs that it names") {
  Sandbox box;
  const auto calibrated = box.run({"calibrate", "--left", kData + "left??.jpg", "--right", kData + "right??.jpg",
                                   "--target", "chessboard:9x6:30mm", "-o", "rig.yaml"});
  CAPTURE(calibrated.err);
  REQUIRE(calibrated.status == 0);
  int skins = 0;
  for (const Page& page : pages()) {
    for (const Block& block : blocks(page.text, "yaml")) {
      if (!Catch::contains(block.text, "surface:")) continue;
      ++skins;
      box.write("skin.yaml", block.text);
      CAPTURE(page.name, block.text);
      const auto result = box.run({"run", "--left", kData + "left01.jpg", "--right", kData + "right01.jpg", "--skin",
                                   "skin.yaml", "--rig", "rig.yaml", "--out", "out", "--json"});
      CAPTURE(result.err);
      REQUIRE(result.status == 0);
      CHECK(nlohmann::json::parse(result.out)["frames"][0]["alarm"] == true);
    }
  }
  CHECK(skins >= 1);
}
