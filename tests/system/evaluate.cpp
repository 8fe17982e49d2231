// SPDX-License-Identifier: Apache-2.0
// `horopter evaluate` from outside, on a made-up pair.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "sandbox.hpp"
#include "shared_data.hpp"

using namespace horopter::test;

namespace {

constexpr int kBackground = 4;
constexpr int kBlock = 14;

/// A textured block at disparity 14 before a background at 4; disparities times 8.
Sandbox& with_pair(Sandbox& box) {
  cv::Mat left(120, 200, CV_8UC1);
  cv::RNG random(3);
  random.fill(left, cv::RNG::UNIFORM, 20, 236);
  cv::GaussianBlur(left, left, {5, 5}, 1.2);
  cv::Mat disparity(left.size(), CV_8UC1, cv::Scalar(8 * kBackground));
  disparity(cv::Rect(90, 40, 60, 50)) = 8 * kBlock;
  cv::Mat right = left.clone();
  for (const int d : {kBackground, kBlock}) {
    for (int y = 0; y < left.rows; ++y) {
      for (int x = d; x < left.cols; ++x) {
        if (disparity.at<std::uint8_t>(y, x) == 8 * d) right.at<std::uint8_t>(y, x - d) = left.at<std::uint8_t>(y, x);
      }
    }
  }
  cv::imwrite((box / "left.png").string(), left);
  cv::imwrite((box / "right.png").string(), right);
  cv::imwrite((box / "truth.pgm").string(), disparity);
  return box;
}

std::vector<std::string> on_pair() {
  return {"evaluate",    "--left",    "left.png", "--right", "right.png",
          "--disparity", "truth.pgm", "--scale",  "8",       "--json"};
}

}  // namespace

TEST_CASE("evaluate compares the skin with two matchers") {
  Sandbox box;
  with_pair(box);
  const auto result = box.run(on_pair());
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  CHECK(result.err.empty());
  const auto json = nlohmann::json::parse(result.out);
  REQUIRE(json["pairs"].size() == 1);
  CHECK(json["pairs"][0]["disparities"] == nlohmann::json({kBackground, kBlock}));
  for (const char* method : {"horopter", "stereobm", "stereosgbm"}) {
    CAPTURE(method);
    const auto& found = json["pairs"][0]["methods"][method];
    CHECK(found["iou"].get<double>() > 0.7);
    CHECK(found["found"] == 2);
    CHECK(found["objects"] == 2);
    CHECK(found["false_per_frame"] == 0);
    CHECK(found["seconds"].get<double>() > 0);
    CHECK(found["by_disparity"].size() == 2);
    CHECK(!found["parameters"].empty());
    CHECK(json["mean"][method]["iou"] == found["iou"]);
    for (const char* change : {"gain", "noise", "vertical"}) {
      CHECK(json["changed"][change]["mean"][method]["iou"].get<double>() > 0.5);
    }
    CHECK(json["changed"]["noise"]["mean"][method]["iou"] != found["iou"]);
  }
}

TEST_CASE("compete on a real pair") {
  const auto folder = opencv_images();
  if (!folder) return;
  const std::string data = folder->string() + "/";
  Sandbox box;
  const auto result =
      box.run({"evaluate", "--left", data + "aloeL.jpg", "--right", data + "aloeR.jpg", "--disparity",
               data + "aloeGT.png", "--resize", "0.5", "--decision", "compete", "--change", "none", "--json"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const auto methods = nlohmann::json::parse(result.out)["pairs"][0]["methods"];
  const auto iou = [&](const char* method) { return methods[method]["iou"].get<double>(); };
  CHECK(iou("horopter") > 0.7);
  CHECK(iou("horopter") > iou("stereobm"));
  CHECK(methods["horopter"]["false_per_frame"].get<double>() < 0.5);
}

TEST_CASE("evaluate sets the rule to a tolerance that is given") {
  Sandbox box;
  with_pair(box);
  const auto parameters = [&](const std::vector<std::string>& more) {
    const auto result = box.run(on_pair() + std::vector<std::string>{"--change", "none"} + more);
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return nlohmann::json::parse(result.out)["pairs"][0]["methods"]["horopter"]["parameters"];
  };
  CHECK(parameters({})["threshold_percent"] == 21);
  CHECK(parameters({"--tolerance", "1"})["threshold_percent"] == 21);
  CHECK(parameters({"--tolerance", "0.8"})["threshold_percent"].get<double>() < 20);
  CHECK(parameters({"--tolerance", "4", "--threshold", "30"})["threshold_percent"] == 30);
  CHECK(parameters({"--decision", "compete"})["boundary"] == 8);
  CHECK(parameters({"--decision", "compete", "--tolerance", "0.7"})["boundary"].get<int>() < 6);
  CHECK(parameters({"--decision", "compete", "--tolerance", "0.7", "--boundary", "9"})["boundary"] == 9);
  CHECK(box.run(on_pair() + std::vector<std::string>{"--tolerance", "4"}).status == 2);
}

TEST_CASE("study decision: its chain of stages is the engine, and every part is worth something") {
  Sandbox box;
  with_pair(box);
  box.write("pairs.txt", "made left.png right.png truth.pgm 8\n");
  const std::vector<std::string> study{"study", "decision", "--quick", "--list", "pairs.txt", "--out", "decision"};
  const auto result =
      box.run(study + std::vector<std::string>{"--generated", HOROPTER_SOURCE_DIR "/rtl/generated", "--json"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const auto found = nlohmann::json::parse(result.out)["variants"];
  const auto evaluated = box.run(on_pair() + std::vector<std::string>{"--change", "none", "--decision", "compete"});
  const auto engine = nlohmann::json::parse(evaluated.out)["mean"]["horopter"];
  REQUIRE(found[2]["name"] == "compete, as in vga");
  for (const char* figure : {"iou", "undecidable", "false_per_frame"}) {
    CHECK(found[2][figure].get<double>() == Approx(engine[figure].get<double>()).margin(1e-9));
  }
  CHECK(found[0]["iou"].get<double>() < found[2]["iou"].get<double>());
  CHECK(found[3]["memory_bits_per_column"].get<int>() == found[2]["memory_bits_per_column"].get<int>() - 19 * 6);
  CHECK(found[4]["iou"] != found[2]["iou"]);
  // The committed page, of more pairs, has the same words and variants.
  const std::string page = box.read("decision/DECISION.md");
  const std::string committed = read_text(HOROPTER_SOURCE_DIR "/docs/decision.md");
  const auto words = page.find("| word |");
  REQUIRE(words != std::string::npos);
  CHECK_THAT(committed, Catch::Contains(page.substr(words, page.find("| thesis, 25 %") - words)));
  for (const auto& variant : found)
    CHECK_THAT(committed, Catch::Contains("| " + variant["name"].get<std::string>() + " |"));
  const auto refused = box.run(study + std::vector<std::string>{"--generated", "nowhere"});
  CHECK(refused.status == 3);
}

TEST_CASE("study decision: what is told of a set was chosen by the other sets") {
  const std::string generated = HOROPTER_SOURCE_DIR "/rtl/generated";
  Sandbox box;
  with_pair(box);
  // The second set: the same pair with a fifth of the contrast, of which one half counts.
  for (const std::string side : {"left", "right"}) {
    cv::Mat image = cv::imread((box / (side + ".png")).string(), cv::IMREAD_GRAYSCALE);
    image.convertTo(image, -1, 0.2, 96);
    cv::imwrite((box / (side + "-weak.png")).string(), image);
  }
  cv::Mat mask(120, 200, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(100, 0, 100, 120)) = 255;
  cv::imwrite((box / "mask.png").string(), mask);
  box.write("whole.txt", "made left.png right.png truth.pgm 8\n");
  box.write("weak.txt", "made left-weak.png right-weak.png truth.pgm 8 1 mask.png\n");
  const auto result = box.run({"study", "decision", "--quick", "--list", "whole.txt", "--list", "weak.txt", "--out",
                               "decision", "--generated", generated, "--json"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const auto json = nlohmann::json::parse(result.out);
  const auto& sets = json["left_one_set_out"];
  REQUIRE(sets.size() == 2);
  const auto alone = [&](const char* list) {
    const auto one = box.run({"study", "decision", "--quick", "--list", list, "--out", std::string("alone-") + list,
                              "--generated", generated, "--json"});
    REQUIRE(one.status == 0);
    const auto found = nlohmann::json::parse(one.out);
    CHECK_FALSE(found.contains("left_one_set_out"));
    return found["variants"];
  };
  const std::map<std::string, nlohmann::json> variants{{"whole", alone("whole.txt")}, {"weak", alone("weak.txt")}};
  const auto evaluated = [&](const std::string& list) {
    return nlohmann::json::parse(
        box.run({"evaluate", "--list", list, "--change", "none", "--json"}).out)["mean"]["stereosgbm"];
  };
  for (const auto& [set, name, other] : {std::tuple{0, "whole", "weak"}, {1, "weak", "whole"}}) {
    CHECK(sets[set]["set"] == name);
    nlohmann::json best;
    for (const auto& variant : variants.at(other)) {
      if (variant["name"].get<std::string>().starts_with("thesis") || variant["undecidable_noise"] < 0.9) continue;
      if (best.is_null() || variant["iou"] > best["iou"]) best = variant;
    }
    CHECK(sets[set]["chosen"] == best["name"]);
    for (const auto& variant : variants.at(name)) {
      if (variant["name"] != best["name"]) continue;
      CHECK(sets[set]["iou"].get<double>() == Approx(variant["iou"].get<double>()).margin(1e-9));
    }
    CHECK(sets[set]["iou_stereosgbm"].get<double>() ==
          Approx(evaluated(std::string(name) + ".txt")["iou"].get<double>()).margin(1e-9));
  }
  CHECK(sets[0]["chosen"] != sets[1]["chosen"]);
  // The best of all on this pair, and it decides what is noise.
  const auto& evident = variants.at("whole")[5];
  CHECK(evident["name"] == "without evidence");
  CHECK(evident["undecidable_noise"] < 0.1);
  CHECK(evident["iou"] > variants.at("whole")[4]["iou"]);
  CHECK_THAT(box.read("decision/DECISION.md"), Catch::Contains("## One set left out"));
}

TEST_CASE("evaluate takes a list, with paths relative to it, and sizes") {
  Sandbox box;
  fs::create_directory(box / "data");
  with_pair(box);
  for (const char* name : {"left.png", "right.png", "truth.pgm"}) fs::rename(box / name, box / "data" / name);
  box.write("data/pairs.txt",
            "# two pairs\nwhole left.png right.png truth.pgm 8\n\nhalf left.png right.png truth.pgm 8 0.5\n");
  const auto result =
      box.run({"evaluate", "--list", "data/pairs.txt", "--change", "none", "--disparities", "4,7,14", "--json"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const auto json = nlohmann::json::parse(result.out);
  REQUIRE(json["pairs"].size() == 2);
  const auto iou = [&](int pair, int disparity) {
    return json["pairs"][pair]["methods"]["stereosgbm"]["by_disparity"][disparity]["iou"].get<double>();
  };
  CHECK(json["changed"].empty());
  CHECK(json["pairs"][1]["name"] == "half");
  CHECK(iou(0, 2) > 0.7);
  CHECK(iou(1, 1) > 0.5);  // 14 px at half the size
}

TEST_CASE("The matchers answer all columns that count, also those left of their largest disparity") {
  Sandbox box;
  with_pair(box);
  // 14 px, and 8 of the margin; 32 disparities are searched.
  cv::Mat mask(120, 200, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(22, 0, 10, 120)) = 255;
  cv::imwrite((box / "beside.png").string(), mask);
  const auto result = box.run(on_pair() + std::vector<std::string>{"--change", "none", "--mask", "beside.png"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const auto pair = nlohmann::json::parse(result.out)["pairs"][0];
  CHECK(pair["disparities"] == nlohmann::json({kBackground}));
  for (const char* method : {"stereobm", "stereosgbm"}) {
    CAPTURE(method);
    const auto& found = pair["methods"][method];
    REQUIRE(found["parameters"]["numDisparities"] == 32);
    // At the upper and lower border StereoBM has no whole block.
    CHECK(found["undecidable"].get<double>() < 0.25);
    CHECK(found["iou"].get<double>() > 0.75);
  }
}

TEST_CASE("evaluate counts only what the mask says that both cameras see") {
  Sandbox box;
  with_pair(box);
  const auto evaluated = [&](const std::vector<std::string>& more) {
    const auto result = box.run(on_pair() + std::vector<std::string>{"--change", "none"} + more);
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return nlohmann::json::parse(result.out)["pairs"][0];
  };
  const auto without = evaluated({});
  // Everything, and nothing of the block: 128 is what one camera sees, in the masks of public sets.
  cv::Mat mask(120, 200, CV_8UC1, cv::Scalar(255));
  cv::imwrite((box / "all.png").string(), mask);
  mask(cv::Rect(90, 40, 60, 50)) = 128;
  cv::imwrite((box / "background.png").string(), mask);
  CHECK(evaluated({"--mask", "all.png"})["methods"]["stereosgbm"]["iou"] == without["methods"]["stereosgbm"]["iou"]);
  CHECK(evaluated({"--mask", "background.png"})["disparities"] == nlohmann::json({kBackground}));

  box.write("pairs.txt",
            "whole left.png right.png truth.pgm 8 1 background.png\n"
            "half left.png right.png truth.pgm 8 0.5 background.png\n");
  const auto listed = box.run({"evaluate", "--list", "pairs.txt", "--change", "none", "--json"});
  CAPTURE(listed.err);
  REQUIRE(listed.status == 0);
  const auto pairs = nlohmann::json::parse(listed.out)["pairs"];
  CHECK(pairs[0]["disparities"] == nlohmann::json({kBackground}));
  CHECK(pairs[1]["disparities"] == nlohmann::json({kBackground / 2}));

  cv::imwrite((box / "small.png").string(), mask(cv::Rect(0, 0, 30, 20)));
  check_bad_file(box, on_pair() + std::vector<std::string>{"--mask", "small.png"}, "small.png", "30x20");
  cv::imwrite((box / "none.png").string(), cv::Mat(120, 200, CV_8UC1, cv::Scalar(128)));
  check_bad_file(box, on_pair() + std::vector<std::string>{"--mask", "none.png"}, "none.png", "no pixel is 255");
  box.write("pairs.txt", "one left.png right.png truth.pgm 8 1 small.png more\n");
  check_bad_file(box, {"evaluate", "--list", "pairs.txt"}, "pairs.txt", "8 fields");
}

TEST_CASE("evaluate prints the same as a table") {
  Sandbox box;
  with_pair(box);
  auto arguments = on_pair();
  arguments.pop_back();
  const auto result = box.run(arguments + std::vector<std::string>{"--change", "none"});
  REQUIRE(result.status == 0);
  CHECK_THAT(result.out, Catch::Contains("stereosgbm") && Catch::Contains("numDisparities") && Catch::Contains("mean"));
}

TEST_CASE("evaluate refuses what it cannot use") {
  Sandbox box;
  with_pair(box);
  CHECK(box.run({"evaluate"}).status == 2);
  CHECK(box.run({"evaluate", "--left", "left.png"}).status == 2);
  CHECK(box.run(on_pair() + std::vector<std::string>{"--list", "pairs.txt"}).status == 2);
  CHECK(box.run(on_pair() + std::vector<std::string>{"--scale", "0"}).status == 2);
  CHECK(box.run(on_pair() + std::vector<std::string>{"--profile", "field"}).status == 2);
  box.write("pairs.txt", "one left.png right.png\n");
  check_bad_file(box, {"evaluate", "--list", "pairs.txt"}, "pairs.txt", "line 1");
  box.write("pairs.txt", "one left.png right.png truth.pgm eight\n");
  check_bad_file(box, {"evaluate", "--list", "pairs.txt"}, "pairs.txt", "'eight'");
  box.write("pairs.txt",
            std::string("teddy left.png right.png truth.png 8") + '\0' + " 1\n");  // a byte 0 ends no number
  check_bad_file(box, {"evaluate", "--list", "pairs.txt"}, "pairs.txt", "line 1");
  box.write("pairs.txt", "# nothing\n");
  check_bad_file(box, {"evaluate", "--list", "pairs.txt"}, "pairs.txt", "no pair");
  cv::imwrite((box / "small.png").string(), cv::Mat(20, 30, CV_8UC1, cv::Scalar(8)));
  check_bad_file(box, {"evaluate", "--left", "left.png", "--right", "right.png", "--disparity", "small.png"},
                 "small.png", "30x20");
}
