// SPDX-License-Identifier: Apache-2.0
// cell.yaml: cameras, skin, limits, outputs, log and page of one cell. Read strictly: what it does not know is an error.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "horopter/machine/monitor.hpp"
#include "horopter/monitor/monitor_faults.hpp"

namespace horopter::monitor {

/// The right camera's images beside the left one's, in one.
enum class Layout { single, side_by_side };
/// Who says when an image was taken: this computer when it arrives, or the cameras' clocks, which must be one.
enum class Stamps { arrival, camera };

/// A source of images.
struct CameraCell {
  std::string name;                             ///< of the rig's camera; `left`, `right` unless told
  std::string source;                           ///< files:, gst:, v4l2:, gev:
  std::string serial;                           ///< that it must have; empty = that of its first image
  std::map<std::string, std::string> features;  ///< GenICam, in the order of their names
  std::string trigger;                          ///< GenICam's TriggerSource; empty = the camera runs by itself
  bool repeat = false;                          ///< files: begin again after the last
  bool exposure_may_change = false;
};

struct ModbusCell {
  std::string address = "127.0.0.1";
  int port = 502;
};

struct MqttCell {
  std::string host;
  int port = 1883;
  std::string topic;  ///< before /state and /event; of no other cell
  std::string client_id;
  std::string user;
  std::filesystem::path password_file;
  std::filesystem::path ca_file;           ///< TLS where it is given
  std::filesystem::path certificate_file;  ///< of this client; with its key
  std::filesystem::path key_file;
};

struct GpioCell {
  std::string chip;
  int safe_line = -1;
  int unsafe_line = -1;
  int pulse_line = -1;  ///< that changes again and again while it is safe; -1: none
};

struct OutputsCell {
  std::optional<ModbusCell> modbus;
  std::optional<MqttCell> mqtt;
  std::optional<GpioCell> gpio;
};

struct LogCell {
  std::filesystem::path directory;
  double size_mb = 1000;
};

struct TlsCell {
  std::filesystem::path certificate_file;
  std::filesystem::path key_file;
};

struct WebCell {
  std::string listen = "127.0.0.1:8080";
  std::filesystem::path users_file;
  std::optional<TlsCell> tls;
  std::vector<std::string> names;  ///< of this computer, by which browsers may ask for the page
  bool restart = false;            ///< a restart over the network is allowed
};

struct TeachCell {
  bool needed = false;  ///< until it was taught, all that is undecidable counts as an object; false: nobody teaches it
  int frames = 500;     ///< that a person's command to teach takes, unless it says another number
  int margin = BlindSettings{}.margin;
  bool less_light = false;  ///< taught also as half of the light would show the images
};

struct Cell {
  std::filesystem::path path;
  std::uint32_t crc = 0;  ///< its checksum() when it was read
  std::string name;

  Layout layout = Layout::single;     ///< side_by_side: the left source gives both
  std::array<CameraCell, 2> cameras;  ///< left, right
  double frames_per_s = 0;
  std::optional<double> largest_skew_ms;  ///< default: largest_skew_ms() below
  Stamps stamps = Stamps::arrival;

  std::filesystem::path rig;  ///< may be empty
  std::filesystem::path skin;
  std::string profile;  ///< empty = the smallest that holds the image
  std::string engine = "native";
  Settings settings;  ///< live; restart by the register, or by itself
  // As --tolerance, --thickness and --object of `run`; at most one of the first two, and of the last two.
  std::optional<double> tolerance_px;
  std::optional<double> thickness_mm;
  std::optional<double> object_px;
  std::optional<double> object_mm;

  double object_speed_m_s = 1.6;
  double decision_limit_ms = 0;  ///< older, a decision says nothing
  TeachCell teach;
  OutputsCell outputs;
  std::optional<LogCell> log;
  std::optional<WebCell> web;

  [[nodiscard]] double period_ms() const { return 1000 / frames_per_s; }
};

/// Throws FileError, with file, line, key, what stands there and what was expected, also where a file that it names is
/// missing; UsageError for an engine or a profile that this build does not have.
Cell load_cell(const std::filesystem::path& path);

/// CRC-32 of the cell's file, the rig's and the skin's, as they are now.
std::uint32_t checksum(const Cell& cell);

/// The longest time between the two images of a pair in which an object goes no further than the tolerance by which the
/// skin is thick: tolerance · way for a px / speed. On the thesis's rig, 1.37 mm/px where the skin is, 0.7 px at 1.6 m/s
/// are 0.6 ms.
double largest_skew_ms(double tolerance_px, double mm_per_px, double object_speed_m_s);

/// A source without what is secret in it: user and password of an address.
std::string without_secrets(const std::string& source);

/// The keys and what they mean, for --help.
std::string cell_help();

}  // namespace horopter::monitor
