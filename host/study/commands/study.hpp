// SPDX-License-Identifier: Apache-2.0
// The studies behind `horopter study`: each measures something of the thesis again and reports it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/thickness.hpp"
#include "horopter/machine/monitor.hpp"
#include "report.hpp"

namespace horopter::cli {

struct StudyScope {
  std::uint64_t seed = 1;  ///< of the noise
  bool times = false;      ///< also measure by the clock, which is not the same twice
  bool quick = false;      ///< about a tenth of the images, methods and runs: to see that all is well
  std::string data = "/usr/share/doc/opencv-doc/examples/data";  ///< photographs of studies that take some
  std::vector<std::string> engines;                              ///< that must agree
  std::string texture;                                           ///< kind of simulated texture; empty: the study's own
  std::string picture;                                           ///< a user's image as texture; empty: none
  std::string series;  ///< list of a user's image series instead of simulated images; empty: none
  Decision decision = Decision::thesis;
  std::vector<std::string> lists;           ///< of stereo pairs, each a set; empty: the study's own
  std::string sets;                         ///< directory of public sets of pairs; empty: none
  std::string synthesised;                  ///< what scripts/synth wrote of the stages; empty: none
  std::string generated = "rtl/generated";  ///< what hlsc made of the stages
  ThicknessOption thickness;
  int frames = 2;           ///< of each pair, or disturbance
  int crossings = 1;        ///< of each body, surface and speed
  bool less_light = false;  ///< taught machines are taught for less light, too
  int window_px = 0;        ///< of the left image, that a skin covers; 0: all of it
  bool harder = false;      ///< disturbances of a part of an image, and others that are harder to tell
  bool hands = false;       ///< only bodies of 40 mm, before machines that were taught
  std::string engine = "native";
};

using Study = void (*)(StudyReport&, const StudyScope&);

// What each of them measures stands beside its name in studies(); of the last five, where their options are.
void study_edges(StudyReport& report, const StudyScope& scope);
void study_calibration(StudyReport& report, const StudyScope& scope);
void study_sampling(StudyReport& report, const StudyScope& scope);
void study_interpolation(StudyReport& report, const StudyScope& scope);
void study_segmentation(StudyReport& report, const StudyScope& scope);
void study_invariance(StudyReport& report, const StudyScope& scope);
void study_influences(StudyReport& report, const StudyScope& scope);
void study_objects(StudyReport& report, const StudyScope& scope);
void study_cost(StudyReport& report, const StudyScope& scope);
void study_detection(StudyReport& report, const StudyScope& scope);
void study_slopes(StudyReport& report, const StudyScope& scope);
void study_problems(StudyReport& report, const StudyScope& scope);
void study_operators(StudyReport& report, const StudyScope& scope);
void study_texture(StudyReport& report, const StudyScope& scope);
void study_resolution(StudyReport& report, const StudyScope& scope);
void study_computation(StudyReport& report, const StudyScope& scope);
void study_geometry(StudyReport& report, const StudyScope& scope);
void study_board(StudyReport& report, const StudyScope& scope);
void study_decision(StudyReport& report, const StudyScope& scope);
void study_earned(StudyReport& report, const StudyScope& scope);
void study_walk(StudyReport& report, const StudyScope& scope);
void study_late(StudyReport& report, const StudyScope& scope);

struct NamedStudy {
  const char* name;
  const char* what;
  Study run;
};
/// Those of `horopter study all`, in the order of its page.
const std::vector<NamedStudy>& studies();

/// Runs one into a directory of its own and returns what its summary.json says.
nlohmann::json run_study(Study study, const std::filesystem::path& out, const StudyScope& scope);
/// Runs all of studies(), each into a directory of its name, and writes index.html and STUDY.md beside them.
nlohmann::json study_all(const std::string& out, const StudyScope& scope);

}  // namespace horopter::cli
