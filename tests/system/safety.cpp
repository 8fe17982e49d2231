// SPDX-License-Identifier: Apache-2.0
// What a new user may do wrong must not read as safe: nothing to see, a skin too small for its alarm, one camera twice.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "rig_text.hpp"
#include "sandbox.hpp"

using namespace horopter::test;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

cv::Mat noise(std::uint64_t seed, double mean, double sigma) {
  cv::Mat image(kHeight, kWidth, CV_64FC1);
  cv::RNG random(seed);
  random.fill(image, cv::RNG::NORMAL, mean, sigma);
  return image;
}

cv::Mat grey(const cv::Mat& image) {
  cv::Mat result;
  image.convertTo(result, CV_8UC1);
  return result;
}

cv::Mat ramp() {
  cv::Mat image(kHeight, kWidth, CV_64FC1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) image.at<double>(y, x) = 40 + x / 8.0 + y / 8.0;
  }
  return image;
}

/// Two cameras 40 mm apart, images left.png and right.png, and a skin.
Sandbox& with(Sandbox& box, const cv::Mat& left, const cv::Mat& right, const std::string& surface) {
  box.write("rig.yaml", two_cameras(320, 240, 300, "-40, 0, 0"));
  box.write("skin.yaml", "surface: " + surface + "\n");
  cv::imwrite((box / "left.png").string(), left);
  cv::imwrite((box / "right.png").string(), right);
  return box;
}

const std::vector<std::string> kRun{"run",       "--left", "left.png", "--right", "right.png", "--skin",
                                    "skin.yaml", "--rig",  "rig.yaml", "--out",   "out",       "--json"};

constexpr const char* kPlane = "{type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}";
constexpr const char* kEllipsoid = "{type: ellipsoid, centre_mm: [0, 0, 1000], half_axes_mm: [300, 250, 200]}";
constexpr const char* kBox = "{type: box, centre_mm: [0, 0, 900], size_mm: [300, 250, 200]}";

}  // namespace

TEST_CASE("Cameras that decide nothing are not safe: blind and too_undecidable, on any skin, by default") {
  const std::string surface = GENERATE(kPlane, kEllipsoid, kBox);
  const std::string decision = GENERATE("thesis", "compete");
  const std::string scene = GENERATE("ramp", "dark");
  CAPTURE(surface, decision, scene);
  Sandbox box;
  if (scene == "ramp") {
    with(box, grey(ramp() + noise(1, 0, 1)), grey(ramp() + noise(2, 0, 1)), surface);
  } else {
    const double sigma = GENERATE(1.5, 3.0);
    CAPTURE(sigma);
    with(box, grey(noise(1, 30, sigma)), grey(noise(2, 30, sigma)), surface);
  }
  const auto result = box.run(kRun + std::vector<std::string>{"--decision", decision, "--alarm-limit", "3"});
  CAPTURE(result.err);
  REQUIRE(result.status == 4);
  const auto frame = nlohmann::json::parse(result.out)["frames"][0];
  CHECK(frame["faults"] == nlohmann::json{"left_blind", "right_blind", "too_undecidable"});
  CHECK(frame["safe"] == false);

  // The limit is a share of what `map` says that the rule can judge, to the pixel.
  const auto map = box.run({"map", "--skin", "skin.yaml", "--rig", "rig.yaml", "--profile", "vga", "--alarm-limit", "3",
                            "--decision", decision, "--json"});
  REQUIRE(map.status == 0);
  const auto supported = nlohmann::json::parse(map.out)["tables"][0]["supported"][decision].get<int>();
  CHECK(supported == kWidth * kHeight - frame["unsupervised_pixels"].get<int>());
  const auto faults = [&](double undecidable) {
    const auto at =
        box.run(kRun + std::vector<std::string>{"--decision", decision, "--alarm-limit", "3", "--undecidable-limit",
                                                std::to_string(std::min(100.0, 100 * undecidable / supported))});
    return nlohmann::json::parse(at.out)["frames"][0]["faults"].size();
  };
  const int undecidable = frame["undecidable_pixels"];
  CHECK(faults(undecidable + 0.5) == 2);
  CHECK(faults(undecidable - 0.5) == 3);
}

TEST_CASE("A plain body before a textured wall is an alarm where the empty zone was taught, on both engines") {
  constexpr int kPairs = 6, kTaught = 3;
  constexpr int kSkin_px = 15, kWall_px = 7;  // disparities; the wall is behind the skin
  Sandbox box;
  cv::Mat wall = noise(3, 128, 60);
  cv::GaussianBlur(wall, wall, {5, 5}, 1.2);
  wall = (wall - 128) * 3 + 128;
  for (int pair = kPairs - 1; pair >= 0; --pair) {
    cv::Mat left = wall.clone(), right;
    const cv::Matx23d shifted(1, 0, -kWall_px, 0, 1, 0);
    cv::warpAffine(wall, right, shifted, wall.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
    if (pair > kTaught) {
      cv::circle(left, {170, 120}, 45, {90}, cv::FILLED);
      cv::circle(right, {170 - kSkin_px, 120}, 45, {90}, cv::FILLED);
    }
    const auto seed = static_cast<std::uint64_t>(2 * pair + 10);
    with(box, grey(left + noise(seed, 0, 1)), grey(right + noise(seed + 1, 0, 1)), kPlane);
    for (const std::string side : {"left", "right"}) {
      fs::rename(box / (side + ".png"), box / (side + std::to_string(pair) + ".png"));
    }
  }
  const auto supervise = [&](const std::string& engine, const std::string& decision, bool teach) {
    std::vector<std::string> arguments{"run",    "--left",     "left*.png", "--right",      "right*.png",
                                       "--skin", "skin.yaml",  "--rig",     "rig.yaml",     "--out",
                                       "out",    "--json",     "--object",  "60px",         "--engine",
                                       engine,   "--decision", decision,    "--still-scene"};
    if (teach) arguments.insert(arguments.end(), {"--teach", std::to_string(kTaught)});
    const auto result = box.run(arguments);
    CAPTURE(result.err, result.out);
    REQUIRE(result.status == 0);
    return nlohmann::json::parse(result.out);
  };
  const auto before = supervise("native", "thesis", false);
  for (const auto& frame : before["frames"]) {
    CHECK(frame["alarm"] == false);  // that is the danger
    CHECK(frame["blind_pixels"] == 0);
  }
  for (const std::string decision : {"thesis", "compete"}) {
    CAPTURE(decision);
    const auto after = supervise("native", decision, true);
    CHECK(after["taught"]["pairs"] == kTaught);
    for (int i = 0; i < kPairs; ++i) {
      const auto& frame = after["frames"][static_cast<std::size_t>(i)];
      CAPTURE(i, frame.dump());
      CHECK(frame["faults"] == (i < kTaught ? nlohmann::json{"teaching"} : nlohmann::json::array()));
      CHECK(frame["alarm"] == (i > kTaught));
      CHECK(frame["safe"] == (i == kTaught));
      if (i <= kTaught) continue;
      REQUIRE(frame["objects"].size() >= 1);
      const auto& object = frame["objects"][0];
      CHECK(object["blind_pixels"].get<int>() >= 2'000);
      CHECK(object["skin_pixels"].get<int>() + object["blind_pixels"].get<int>() == object["area_px"].get<int>());
    }
    auto on_hardware = supervise("rtl", decision, true);
    REQUIRE(on_hardware["frames"].size() == kPairs);
    for (std::size_t i = 0; i < kPairs; ++i) {
      for (const char* what : {"alarm", "safe", "blind_pixels", "objects", "faults"}) {
        CAPTURE(i, what);
        CHECK(on_hardware["frames"][i][what] == after["frames"][i][what]);
      }
    }
    CHECK(on_hardware["taught"] == after["taught"]);
  }
}

TEST_CASE("A frame with a fault or an alarm ends a teaching, and nothing is taught") {
  Sandbox box;
  cv::Mat wall = noise(3, 128, 60);
  cv::GaussianBlur(wall, wall, {5, 5}, 1.2);
  wall = (wall - 128) * 3 + 128;
  wall(cv::Rect(20, 150, 60, 60)) = 128;  // plain: never decided
  cv::Mat right;
  const cv::Matx23d shifted(1, 0, -7, 0, 1, 0);
  cv::warpAffine(wall, right, shifted, wall.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  constexpr int kPairs = 7;
  const auto make = [&](int spoiled, bool covered) {
    for (int pair = 0; pair < kPairs; ++pair) {
      const auto seed = static_cast<std::uint64_t>(2 * pair + 10);
      cv::Mat seen = grey(right + noise(seed + 1, 0, 1)), left = grey(wall + noise(seed, 0, 1));
      if (pair == spoiled && covered) seen = grey(noise(seed + 1, 30, 1));
      if (pair == spoiled && !covered) {  // somebody in the skin, 15 px of disparity
        const cv::Mat person = left(cv::Rect(150, 20, 140, 120)).clone();
        person.copyTo(left(cv::Rect(115, 60, 140, 120)));
        person.copyTo(seen(cv::Rect(100, 60, 140, 120)));
      }
      with(box, left, seen, kPlane);
      for (const auto& [side, image] : {std::pair{"left", left}, {"right", seen}}) {
        cv::imwrite((box / (side + std::to_string(pair) + ".png")).string(), image);
        fs::remove(box / (std::string(side) + ".png"));
      }
    }
    return box.run_proven({"run", "--left", "left*.png", "--right", "right*.png", "--skin", "skin.yaml", "--rig",
                           "rig.yaml", "--out", "out", "--json", "--still-scene", "--teach", "5"});
  };
  // The machine's first frame shows nothing yet, and is unproven all over: it teaches nothing.
  const auto good = nlohmann::json::parse(make(-1, false).out);
  CAPTURE(good["taught"].dump());
  CHECK(good["taught"]["frames"] >= 5);  // the first pair is shown several times
  CHECK(good["taught"]["undecidable_percent"].get<double>() > 0);
  CHECK(good["taught"]["undecidable_percent"].get<double>() < 40);
  const auto refused = [&](int spoiled, bool covered, int status, const std::string& message) {
    CAPTURE(spoiled, covered);
    const auto result = make(spoiled, covered);
    CAPTURE(result.err);
    CHECK(result.status == status);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Catch::Contains(message) && Catch::Contains("nothing is taught"));
  };
  refused(1, true, 4, "left1.png: pair 2 of --teach 5 has right_constant");
  refused(1, false, 3, "left1.png: pair 2 of --teach 5 has an alarm");
  refused(4, true, 4, "left4.png: pair 5 of --teach 5 has right_constant");  // the last one
}

TEST_CASE("A skin too small for its alarm is refused, and one that is nearly so is warned of") {
  Sandbox box;
  with(box, grey(noise(1, 100, 30)), grey(noise(2, 100, 30)),
       "{type: box, centre_mm: [0, 0, 900], size_mm: [160, 160, 200]}");
  const std::vector<std::string> map{"map",       "--skin", "skin.yaml", "--rig", "rig.yaml",
                                     "--profile", "vga",    "-o",        "x.hmap"};
  check_bad_file(box, kRun, "skin.yaml", "too small for an alarm, which takes more than 5 % of the whole image");
  check_bad_file(box, map, "skin.yaml", "too small for an alarm");
  // What the message proposes will do.
  const std::string message = box.run(kRun).err;
  const auto at = message.find("--alarm-limit ");
  REQUIRE(at != std::string::npos);
  const std::string limit = message.substr(at + 14, message.find(',', at) - at - 14);
  const std::vector<std::string> lower{"--alarm-limit", limit};
  const auto result = box.run(kRun + lower);
  CAPTURE(limit, result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.err, !Catch::Contains("an alarm takes"));
  REQUIRE(box.run(map + std::vector<std::string>{"--alarm-limit", limit}).status == 0);
  fs::remove_all(box / "out");
  auto by_table = kRun;
  std::replace(by_table.begin(), by_table.end(), std::string("skin.yaml"), std::string("x.hmap"));
  check_bad_file(box, by_table, "x.hmap", "too small for an alarm");
  const std::string higher = std::to_string(1.5 * std::stod(limit));
  CHECK_THAT(box.run(kRun + std::vector<std::string>{"--alarm-limit", higher}).err,
             Catch::Contains("warning") && Catch::Contains("an alarm takes"));
  // A skin that moves is asked at every step.
  box.write("skin.yaml",
            "surface: {type: box, centre_mm: [0, 0, 900], size_mm: [300, 300, 200]}\n"
            "motion: {frame_rate_per_s: 50, object_speed_m_s: 0.2, poses: [{time_s: 0.4, shift_mm: [480, 0, 0]}]}\n");
  fs::remove_all(box / "out");
  check_bad_file(box, kRun, "skin.yaml", "table ");
}

TEST_CASE("One camera cannot be both") {
  Sandbox box;
  with(box, grey(noise(1, 100, 30)), grey(noise(2, 100, 30)), kPlane);
  const auto arguments = [](const std::vector<std::string>& left, const std::vector<std::string>& right) {
    return std::vector<std::string>{"run", "--left"} + left + std::vector<std::string>{"--right"} + right +
           std::vector<std::string>{"--skin", "skin.yaml", "--rig", "rig.yaml", "--out", "out"};
  };
  check_bad_file(box, arguments({"left.png"}, {"left.png"}), "left.png", "this is the left image, too");
  check_bad_file(box, arguments({"left.png"}, {"./left.png"}), "left.png", "this is the left image, too");
  fs::create_directory(box / "images");
  fs::copy_file(box / "left.png", box / "images/0.png");
  fs::copy_file(box / "right.png", box / "images/1.png");
  check_bad_file(box, arguments({"images"}, {"images"}), "0.png", "this is the left image, too");
  check_bad_file(box, arguments({"0"}, {"camera:0"}), "camera:0", "this is the left image, too");
  // A copy is found out by its pixels.
  fs::copy_file(box / "left.png", box / "copy.png");
  const auto copied = box.run(arguments({"left.png"}, {"copy.png"}));
  CHECK(copied.status == 4);
  const auto frame = nlohmann::json::parse(box.read("out/summary.json"))["frames"][0];
  CHECK(frame["safe"] == false);
  CHECK(frame["faults"] == nlohmann::json{"identical_images"});
}
