// SPDX-License-Identifier: Apache-2.0
// Inputs that several commands take, checked in one way.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin_file.hpp"

namespace horopter::cli {

/// Of what the left camera sees of a skin. One of which less is supervised is meant otherwise, or not seen as it is meant.
inline constexpr double kLittleSupervised = 0.5;

/// The profiles and the largest images that they take, for help.
std::string profile_sizes();
/// Throws FileError when the profile does not hold an image of this size.
void check_image_size(const std::string& name, int width, int height, const MachineProfile& profile);
/// "at most the 1920x1080 of profile hd", for messages: the largest image that is taken as it is.
std::string largest_image();
/// The profile that is named, else the smallest that holds images of this size. Throws FileError, about a place
/// in the file, where it does not.
const MachineProfile& choose_profile(const std::string& profile, const std::string& file, const std::string& place,
                                     int width, int height);
/// A rig from rig.yaml, or another format that calib::load_rig knows; its warnings are said. Throws FileError.
calib::Rig read_rig(const std::string& path);
/// The cameras of --rig; nothing where the option is not given. Throws FileError.
std::optional<calib::Rig> read_rig_option(const std::string& path);
/// The first two cameras, as left and right one. Throws FileError where there are not two, or they are exchanged.
CameraPair first_pair(const calib::Rig& rig, const std::string& file);
/// A file that an option names; empty where it is not given.
struct NamedFile {
  std::string option;
  std::string path;
};
/// No output may replace an input or another output. Throws UsageError, which names both options.
void check_outputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);
/// There and not empty; contents are checked by load_or_compile_maps.
void check_skin_file(const std::string& path);

/// A skin's files, which are read several times: those that are used must be those that were checked.
class SkinFiles {
 public:
  explicit SkinFiles(std::string skin);
  /// Throws FileError where one of them is not as it was.
  void check_unchanged() const;

 private:
  [[nodiscard]] std::uint32_t checksum() const;

  std::string skin_;
  std::uint32_t checksum_;
};

/// A table (.hmap), not a skin.yaml. Throws FileError where there is neither.
bool is_table(const std::string& skin);
/// A skin.yaml, not a table (.hmap), whose skin moves.
bool is_moving_skin(const std::string& skin);
/// A skin.yaml for images of this size. Throws FileError where the rig's are others.
SkinFile load_skin_for(const std::string& skin, const std::optional<calib::Rig>& rig, int image_width,
                       int image_height);
/// A skin.yaml whose surface lies in the rig's world. Throws FileError.
std::unique_ptr<RigSkin> load_rig_skin(const std::string& skin, const calib::Rig& rig);
/// Tables for a rule from a skin.yaml, or from an .hmap of the same profile, size and, where one is given, rig. Throws
/// FileError, also for an .hmap with a pixel that the rule cannot serve. Without a rig of their own that is not known,
/// see report_rows.
MapSet load_or_compile_maps(const std::string& skin, const std::optional<calib::Rig>& rig,
                            const MachineProfile& profile, int image_width, int image_height, Decision decision);

/// "table 3 of 6: ", counted from 0; nothing where there is one.
std::string table_prefix(std::size_t table, std::size_t tables);

/// The share, 0 to 1, that is supervised of what the left camera sees of a skin, in the table with the least; 1 where it
/// sees nothing. Less than kLittleSupervised is said on standard error. `reports`: of the tables of a skin, or of its motion.
double check_supervised(const std::string& skin, const std::vector<const MapReport*>& reports, bool has_rig);

/// An alarm must be possible. Throws FileError for a table in which the rule can judge no more pixels than it takes,
/// and says on standard error when it takes more than half of them. The tables of a skin, or of its motion.
void check_alarm_limit(const std::string& skin, const std::vector<const MapTable*>& tables,
                       const MachineProfile& profile, Decision decision, double alarm_percent);

/// Says on standard error what is not told of the cameras: where little of the images can be compared, where epipolar lines
/// are too steep, without a rig, or of fields. `rig`: its text, or empty.
void warn_of_proof(const std::string& skin, const std::vector<const MapTable*>& tables, const MachineProfile& profile,
                   int lookahead, const Settings& settings, const std::string& rig);

/// Says on standard error that the cameras of `rig` (its text, or empty) were designed and not measured. For commands that
/// judge the images of real ones.
void warn_of_designed_rig(const std::string& skin, const std::string& rig);

/// Whether epipolar lines were followed, for programs (`rows_checked`) and, where they could not be, for people.
/// Nothing for a rule that does not need it.
void report_rows(Decision decision, bool has_rig, nlohmann::ordered_json& summary, bool json);
/// Of a skin that is planned: what epipolar lines that leave the row cost, for people. False, and said on standard
/// error, where they leave it at so many pixels that there is no table for the rule.
bool report_row_count(const RowCount& rows, const ViewLimits& view, bool json);

}  // namespace horopter::cli
