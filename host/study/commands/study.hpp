// SPDX-License-Identifier: Apache-2.0
// The studies behind `horopter study`: each writes tables and plots into a directory and returns its figures as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/thickness.hpp"
#include "horopter/image/output.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter::cli {

struct StudyScope {
  std::uint64_t seed = 1;  ///< of the noise
  bool quick = false;      ///< about a tenth of the images, methods and runs: to see that all is well
  std::string data = "/usr/share/doc/opencv-doc/examples/data";  ///< photographs of studies that take some
  std::vector<std::string> engines;                              ///< that must agree
  std::string texture;                                           ///< kind of simulated texture; empty: the study's own
  std::string picture;                                           ///< a user's image as texture; empty: none
  std::string series;  ///< list of a user's image series instead of simulated images; empty: none
  Decision decision = Decision::thesis;
  std::string list;                         ///< of stereo pairs; empty: the study's own
  std::string synthesised;                  ///< what scripts/synth wrote of the stages; empty: none
  std::string generated = "rtl/generated";  ///< what hlsc made of the stages
  ThicknessOption thickness;
};

/// Sub-pixel edge estimators on simulated edges (thesis 6.7).
nlohmann::json study_edges(OutputDirectory& directory, const StudyScope& scope);
/// Calibration with a rendered rig (thesis 6.8, 6.9).
nlohmann::json study_calibration(OutputDirectory& directory, const StudyScope& scope);
/// Bilinear interpolation with weights of few bits, for scaling and translation (thesis 7.5).
nlohmann::json study_interpolation(OutputDirectory& directory, const StudyScope& scope);
/// Thickness and exploitation over tilt and place (thesis 11.1, Fig. 11.2, 11.3).
nlohmann::json study_geometry(OutputDirectory& directory, const StudyScope& scope);
/// The morphological operators side by side (thesis 5.2, Fig. 5.7).
nlohmann::json study_operators(OutputDirectory& directory, const StudyScope& scope);
/// Measures of texture, and texture against noise (thesis 9, Tables 9.1, 9.2, Fig. 9.1, 9.2).
nlohmann::json study_texture(OutputDirectory& directory, const StudyScope& scope);
/// Bits of the direction and of its difference (thesis 10.4.5, Fig. 10.4).
nlohmann::json study_resolution(OutputDirectory& directory, const StudyScope& scope);
/// Operations and memory accesses of each step (thesis 10.1, Table 10.1).
nlohmann::json study_computation(OutputDirectory& directory, const StudyScope& scope);

/// Every correlation criterion over disparity (thesis 8.4, 11.2.1).
nlohmann::json study_segmentation(OutputDirectory& directory, const StudyScope& scope);
/// Changes of brightness (Table 8.3).
nlohmann::json study_invariance(OutputDirectory& directory, const StudyScope& scope);
/// Noise, differing scale, differing blur (Table 8.4).
nlohmann::json study_influences(OutputDirectory& directory, const StudyScope& scope);
/// Small objects (thesis 8.5).
nlohmann::json study_objects(OutputDirectory& directory, const StudyScope& scope);
/// Operations of each criterion (Table 8.5).
nlohmann::json study_cost(OutputDirectory& directory, const StudyScope& scope);
/// What the hardware's stage detects at which displacement (thesis 11.2).
nlohmann::json study_detection(OutputDirectory& directory, const StudyScope& scope);
/// A skin in millimetres on photographs of a chessboard, moved through it (10.4, 11.2).
nlohmann::json study_board(OutputDirectory& directory, const StudyScope& scope);

/// Variants of the rules of decision: what each gains and costs (12.1 to 12.4).
nlohmann::json study_decision(OutputDirectory& directory, const StudyScope& scope);

using Study = nlohmann::json (*)(OutputDirectory&, const StudyScope&);

struct NamedStudy {
  const char* name;
  const char* what;
  Study run;
};
/// Those of `horopter study all`, in the order of its page. A result may hold "findings" (lines for the terminal),
/// "figures" ([{"file", "title"}]; without it every SVG is one), "conditions" and "statements" (study_statements.hpp).
const std::vector<NamedStudy>& studies();

/// Runs all of studies(), each into a directory of its name, and writes index.html and STUDY.md beside them.
nlohmann::json study_all(const std::string& out, const StudyScope& scope);

}  // namespace horopter::cli
