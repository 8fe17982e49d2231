// SPDX-License-Identifier: Apache-2.0
// Results are neither lost nor stale: a run that fails, is stopped or killed, places that are hard to write to.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pairs.hpp"
#include "sandbox.hpp"

using namespace horopter::test;

namespace {

/// Both images of pair 0, repeated so that a run takes minutes.
const std::string kLongRun =
    "n=0; images=''; for i in $(seq 500); do images=\"$images left0.png left1.png\"; done\n"
    "right=$(echo $images | sed s/left/right/g)\n"
    "horopter run --left $images $images --right $right $right --skin skin.yaml --out out & pid=$!\n"
    "half=.out.horopter-$pid-0.partial\n"
    "until [ -e $half/frame-0002-state.png ] || [ -e out/$half/frame-0002-state.png ] || [ $((n += 1)) -gt 3000 ]\n"
    "do sleep 0.02; done\n";

}  // namespace

TEST_CASE("The summary of an earlier run never stands beside a run that failed") {
  Sandbox box;
  with_pairs(box);
  const auto arguments = run_arguments();
  REQUIRE(box.run(arguments).status == 0);
  const auto summary = box.read("out/summary.json");
  const auto picture = box.read("out/frame-0000-state.png");
  const auto good = box.read("left0.png");
  for (const std::string& bad : {std::string("no image"), good.substr(0, good.size() / 2)}) {
    box.write("left0.png", bad);
    CHECK(box.run(arguments).status == 3);
    CHECK_FALSE(fs::exists(box / "out/summary.json"));
    CHECK(box.read("out/earlier-summary.json") == summary);
    CHECK(box.read("out/frame-0000-state.png") == picture);
  }
  box.write("left0.png", good);
  // What killed runs leave; and what is not theirs.
  const std::vector<std::string> others{".other.horopter-999999999-0.partial", ".out.999999999.partial",
                                        ".out.horopter-mine.partial"};
  fs::create_directory(box / ".out.horopter-999999999-0.partial");
  box.write(".out.horopter-999999999-0.partial/frame-0000-state.png", "half");
  for (const std::string& other : others) fs::create_directory(box / other);
  CHECK(box.run(arguments).status == 0);
  CHECK(box.read("out/summary.json") == summary);
  CHECK_FALSE(fs::exists(box / "out/earlier-summary.json"));
  CHECK_FALSE(fs::exists(box / ".out.horopter-999999999-0.partial"));
  for (const std::string& other : others) CHECK(fs::exists(box / other));
}

TEST_CASE("An option that cannot be, of these images, changes no results") {
  Sandbox box;
  with_pairs(box);
  const auto arguments = run_arguments();
  REQUIRE(box.run(arguments).status == 0);
  const auto files = box.files();
  const auto summary = box.read("out/summary.json");
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
           {"--alarm-frames", "2/3"}, {"--object", "900px"}, {"--profile", "field", "--decision", "compete"}}) {
    CAPTURE(wrong);
    CHECK(box.run(arguments + wrong).status == 2);
    CHECK(box.files() == files);
    CHECK(box.read("out/summary.json") == summary);
  }
}

TEST_CASE("A bad image at the end: earlier results stay, what was made is kept apart and marked") {
  Sandbox box;
  with_pairs(box, 3);
  const std::vector<std::string> three{"run",       "--left",     "left0.png",  "left1.png",  "left2.png",
                                       "--right",   "right0.png", "right1.png", "right2.png", "--skin",
                                       "skin.yaml", "--out",      "out"};
  const auto whole = box.read("left2.png");
  const bool has_earlier = GENERATE(false, true);
  if (has_earlier) REQUIRE(box.run(three).status == 0);
  const auto earlier = has_earlier ? box.read("out/frame-0002-state.png") : "";
  box.write("left2.png", whole.substr(0, whole.size() / 2));
  for (int again = 0; again < 2; ++again) {
    const auto failed = box.run(three);
    CHECK(failed.status == 3);
    CHECK_THAT(failed.err, Catch::Contains("out/incomplete") && Catch::Contains("first 2 frames"));
    const auto summary = nlohmann::json::parse(box.read("out/incomplete/summary.json"));
    CHECK(summary["incomplete"] == true);
    CHECK_THAT(summary["reason"].get<std::string>(), Catch::Contains("left2.png"));
    CHECK(summary["frames"].size() == 2);
    CHECK(fs::exists(box / "out/incomplete/frame-0001-overlay.png"));
    CHECK_FALSE(fs::exists(box / "out/summary.json"));
    CHECK(fs::exists(box / "out/earlier-summary.json") == has_earlier);
    if (has_earlier) CHECK(box.read("out/frame-0002-state.png") == earlier);
  }
  box.write("out/incomplete/mine.txt", "stays");
  box.write("left2.png", whole);
  REQUIRE(box.run(three).status == 0);
  CHECK(box.read("out/incomplete/mine.txt") == "stays");
  CHECK_FALSE(fs::exists(box / "out/incomplete/summary.json"));
  CHECK_FALSE(fs::exists(box / "out/earlier-summary.json"));
  const auto summary = nlohmann::json::parse(box.read("out/summary.json"));
  CHECK(summary["frames"].size() == 3);
  CHECK_FALSE(summary.contains("incomplete"));
}

TEST_CASE("Results in a directory that is all that may be written") {
  Sandbox box;
  with_pairs(box);
  // Its parent takes no files, whoever asks; and it is on another file system.
  auto arguments = run_arguments();
  arguments.back() = "/proc/self/cwd";
  const auto result = box.run(arguments);
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  CHECK(fs::exists(box / "frame-0000-state.png"));
  CHECK(fs::exists(box / "summary.json"));
  for (const std::string& file : box.files()) CHECK_FALSE(file.starts_with("."));
}

TEST_CASE("SIGTERM and SIGINT end a run at once, and keep what was made") {
  Sandbox box;
  with_pairs(box, 2);
  const auto [signal, status] = GENERATE(table<std::string, int>({{"TERM", 143}, {"INT", 130}}));
  const auto result = box.run_shell(kLongRun + "kill -" + signal + " $pid; wait $pid; echo status $?");
  CAPTURE(result.err);
  CHECK_THAT(result.out, Catch::Contains("status " + std::to_string(status)));
  CHECK_THAT(result.err, Catch::Contains("stopped by SIG" + signal));
  const auto summary = nlohmann::json::parse(box.read("out/incomplete/summary.json"));
  CHECK(summary["incomplete"] == true);
  CHECK(summary["reason"] == "stopped by a signal");
  const std::size_t frames = summary["frames"].size();
  CHECK(frames >= 2);
  CHECK(frames < 1000);
  CHECK(box.files().size() == 5 + 2 + 2 * frames + 1);  // inputs, out/incomplete, pictures, summary
}

TEST_CASE("What a killed run leaves is taken away by the next") {
  Sandbox box;
  with_pairs(box, 2);
  const bool exists = GENERATE(false, true);
  if (exists) fs::create_directory(box / "out");
  const auto result = box.run_shell(kLongRun + "kill -KILL $pid; wait $pid; ls -a . out | grep partial");
  CHECK_THAT(result.out, Catch::Contains(".partial"));
  REQUIRE(box.run(run_arguments()).status == 0);
  for (const std::string& file : box.files()) CHECK_THAT(file, !Catch::Contains("partial"));
}

TEST_CASE("SIGTERM ends every command at once, and leaves nothing half made") {
  static const std::vector<std::string> commands{
      "run --left l.png --right r.png --skin pipe --out out",
      "map --skin pipe --profile vga -o map.hmap",
      "evaluate --list pipe --disparities 1",
      "calibrate --points pipe --sensor pipe -o rig.yaml",
      "plan thickness --rig pipe --distance 500 --out out",
      "plan rig --rig pipe --distance 500 --out out",
      "study all --out out",
      "map --inspect pipe",
  };
  const std::string command = GENERATE(from_range(commands));
  CAPTURE(command);
  Sandbox box;
  // `timeout` passes the signal on; who does not end within 20 s is killed.
  const auto result = box.run_shell("mkfifo pipe; timeout --signal=KILL 20 horopter " + command +
                                    " & sleep 0.5; kill -TERM $!; wait $!; echo status $?");
  CAPTURE(result.err);
  CHECK_THAT(result.out, Catch::Contains("status 143"));
  for (const std::string& file : box.files()) CHECK_THAT(file, !Catch::Contains("partial"));
}

TEST_CASE("status --watch ends when nobody reads it any more") {
  const std::string more = GENERATE("", " --json");
  const Sandbox box;
  const auto result = box.run_shell("{ timeout --signal=KILL 60 horopter status --engine native --watch" + more +
                                    "; echo $? > status; } | head -c 1");
  CAPTURE(result.err);
  CHECK(result.out.size() == 1);
  CHECK(box.read("status") == "3\n");
  CHECK_THAT(result.err, Catch::Contains("standard output"));
}

TEST_CASE("A full standard output is an error") {
  Sandbox box;
  with_pairs(box);
  for (const std::string command :
       {"run --left left0.png --right right0.png --skin skin.yaml --out out",
        "run --left left0.png --right right0.png --skin skin.yaml --out out --json", "--help",
        "map --skin skin.yaml --profile vga -o map.hmap", "map --skin skin.yaml --profile vga --json"}) {
    CAPTURE(command);
    const auto result = box.run_shell("horopter " + command + " > /dev/full");
    CHECK(result.status == 3);
    CHECK_THAT(result.err, Catch::Contains("standard output"));
  }
}
