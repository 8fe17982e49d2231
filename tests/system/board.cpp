// SPDX-License-Identifier: Apache-2.0
// The program with a board: the ULX3S, Verilated, behind a pseudo-terminal, as a user has it behind a serial port; and
// what else can be there.
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "board_terminal.hpp"
#include "eventually.hpp"
#include "horopter/machine/loader.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/native_device.hpp"
#include "rig_text.hpp"
#include "sandbox.hpp"
#include "shared_data.hpp"

using namespace horopter::test;
using horopter::Run;

namespace {

/// Left and right image of constraints/ulx3s/horopter_pattern.sv, of the frame `index`.
std::pair<horopter::Image, horopter::Image> pattern(int index, int width, int height) {
  const auto grey = [](unsigned bx, unsigned by) {
    const auto bits = [](unsigned value) { return value & 0xFFFFU; };
    bx &= 0x3FFU;
    by &= 0x3FFU;
    unsigned h = bits(bx << 6) ^ by ^ 0x9E37U;
    h = bits(h + bits((h & 0x7FFU) << 5));
    h = h ^ (h >> 5) ^ (by << 3);
    h = bits(h + bits((h & 0x1FFFU) << 3));
    h = h ^ (h >> 7);
    return static_cast<std::uint8_t>(32 + (h & 0x7FU) + (h >> 7 & 0x3FU));
  };
  horopter::Image left(width, height);
  horopter::Image right(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      left.at(x, y) = grey(static_cast<unsigned>(x + 32 + index) >> 2, static_cast<unsigned>(y) >> 2);
      right.at(x, y) = static_cast<std::uint8_t>(left.at(x, y) + 1);
    }
  }
  return {left, right};
}

std::vector<Run> read_runs(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  std::vector<Run> runs;
  while (std::getline(lines, line)) {
    Run run;
    int state = 0;
    REQUIRE(std::sscanf(line.c_str(), "%d,%d,%d,%d", &run.row, &run.start, &run.end, &state) == 4);
    run.state = static_cast<horopter::State>(state);
    runs.push_back(run);
  }
  return runs;
}

/// Two fields' tables: 3 px to the left at the left edge, 7 at the right one.
std::string write_table(const Sandbox& box, const std::string& name = "skin") {
  box.write(name + ".yaml", "surface:\n  type: homography\n  matrix: [[0.995, 0, -3], [0, 1, 0], [0, 0, 1]]\n");
  const auto made = box.run(
      {"map", "--skin", name + ".yaml", "--profile", "field", "--size", "756x572", "-o", name + ".hmap", "--json"});
  INFO(made.err);
  REQUIRE(made.status == 0);
  return nlohmann::json::parse(made.out)["tables"][0]["crc"];
}

/// Two fields' tables of 14 KiB: the left camera's image is curved.
void write_large_table(const Sandbox& box) {
  box.write("rig.yaml", two_cameras(756, 572, 700, "-50, 0, 0", {"{k1: -0.3}", "{}"}));
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0, 0, -1]}\n");
  const auto made =
      box.run({"map", "--skin", "skin.yaml", "--rig", "rig.yaml", "--profile", "field", "-o", "skin.hmap"});
  INFO(made.err);
  REQUIRE(made.status == 0);
}

nlohmann::json status_of(const Sandbox& box, const std::string& engine) {
  const auto result = box.run({"status", "--engine", engine, "--json"});
  INFO(result.err);
  REQUIRE(result.status == 0);
  return nlohmann::json::parse(result.out);
}

void wait_for_crc(const Sandbox& box, const std::string& engine, const std::string& crc) {
  nlohmann::json status;
  for (int i = 0; i < 60; ++i) {
    status = status_of(box, engine);
    if (!status["table"].is_null() && status["table"].value("crc", "") == crc) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  CAPTURE(status.dump());
  FAIL("the table is not active");
}

/// Before its first frame a machine does not say by which table frames are made.
void wait_for_frame(const Sandbox& box, const std::string& engine) {
  REQUIRE(eventually([&] { return status_of(box, engine)["frame"]["sequence"].get<int>() > 0; }));
}

void check_fault(const Sandbox& box, const std::vector<std::string>& arguments, const std::string& message) {
  const auto result = box.run(arguments);
  CAPTURE(arguments, result.err);
  CHECK(result.status == 4);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("horopter: ") && Catch::Contains(message));
}

/// Which others a frame of the pattern has depends on which frame it is.
bool has_faults(const nlohmann::json& faults, const std::vector<std::string>& names) {
  return std::ranges::all_of(
      names, [&](const auto& name) { return std::find(faults.begin(), faults.end(), name) != faults.end(); });
}

}  // namespace

TEST_CASE("From photographs to a board, and the board's runs are those of the native engine") {
  const auto folder = opencv_images();
  if (!folder) return;
  const Sandbox box;
  const auto must = [&](const std::vector<std::string>& arguments) {
    const auto result = box.run(arguments);
    CAPTURE(arguments, result.err);
    REQUIRE(result.status == 0);
    return result.out;
  };
  must({"calibrate", "--left", (*folder / "left??.jpg").string(), "--right", (*folder / "right??.jpg").string(),
        "--target", "chessboard:9x6:30mm", "-o", "rig.yaml"});
  box.write("skin.yaml", "surface: {type: plane, point_mm: [26, -52, 458], normal: [-0.268, 0.156, -0.951]}\n");
  const auto table = nlohmann::json::parse(
      must({"map", "--skin", "skin.yaml", "--rig", "rig.yaml", "--profile", "field", "-o", "skin.hmap", "--json"}));
  const std::string crc = table["tables"][0]["crc"];

  Terminal terminal;
  BoardBehind board(terminal);
  const std::string before = status_of(box, terminal.engine())["table"]["crc"];
  REQUIRE(before != crc);
  const auto report =
      nlohmann::json::parse(must({"upload", "--engine", terminal.engine(), "--map", "skin.hmap", "--json"}));
  CHECK(report["tables"].size() == 2);
  CHECK(report["tables"][0]["crc"] == crc);
  wait_for_crc(box, terminal.engine(), crc);
  auto status = status_of(box, terminal.engine());
  const int slot = report["tables"][0]["slot"];
  const auto bytes = report["tables"][0]["bytes"].get<int>();
  CHECK(status["table"] ==
        nlohmann::json{{"slot", slot}, {"crc", crc}, {"bytes", bytes}, {"width_px", 640}, {"height_rows", 240}});
  CHECK_THAT(
      must({"status", "--engine", terminal.engine()}),
      Catch::Contains(fmt::format("slot {} is active, CRC {}, {} bytes, for images of 640x240 px", slot, crc, bytes)) &&
          Catch::Contains("WIDTH") && Catch::Contains("px 640"));

  status = status_of(box, terminal.engine());
  // By the pattern's right image, which is its left one: there is no world that these cameras would see so.
  CHECK(has_faults(status["frame_faults"], {"one_camera", "disagree"}));
  CHECK(has_faults(status["faults"], {"one_camera", "disagree", "unproven"}));
  must({"status", "--engine", terminal.engine(), "--runs", "runs.csv", "--states", "states.png"});
  const auto runs = read_runs(box.read("runs.csv"));
  CHECK(runs.size() > 500);

  // The same pattern, in one of the frames around the one that was kept: the pattern counts from the machine's start.
  const auto& profile = horopter::find_profile("field");
  const auto maps = horopter::load_maps(box / "skin.hmap");
  horopter::Monitor native(horopter::make_native_device(profile), profile,
                           horopter::settings_for(horopter::Settings{}, profile, maps));
  native.start(640, 240, maps.lookahead());
  native.upload(0, maps.maps[0].table);
  native.select(0);
  int equal = 0;
  const auto sequence = status["frame"]["sequence"].get<int>();
  for (int index = sequence; index < sequence + 60 && equal == 0; ++index) {
    const auto [left, right] = pattern(index, 640, 240);
    if (native.process(left, right).runs == runs) ++equal;
  }
  CHECK(equal == 1);

  // Such frames teach nothing, and the board says what is wrong with them. An upload leaves it so.
  const auto blocks = [&] {
    const std::string text = must({"status", "--engine", terminal.engine()});
    return std::tuple(text.find("watch 1") != text.npos, text.find("teach 1") != text.npos,
                      text.find("taught 1") != text.npos);
  };
  CHECK(blocks() == std::tuple(false, false, false));
  const auto taught = box.run({"teach", "--engine", terminal.engine(), "--frames", "1", "--margin", "12", "--json"});
  CHECK(taught.status == 4);
  CHECK_THAT(taught.err, Catch::Contains("one_camera") && Catch::Contains("the machine is still teaching"));
  must({"upload", "--engine", terminal.engine(), "--map", "skin.hmap"});
  CHECK(std::get<1>(blocks()));
  CHECK(eventually([&] {
    return has_faults(status_of(box, terminal.engine())["frame_faults"], {"one_camera", "disagree", "teaching"});
  }));
  must({"teach", "--engine", terminal.engine(), "--off"});
  CHECK_FALSE(std::get<1>(blocks()));

  // What a board cannot do is said before it is touched.
  box.write("left.pgm", "P5 640 480 255\n" + std::string(640 * 480, 'x'));
  box.write("right.pgm", "P5 640 480 255\n" + std::string(640 * 480, 'y'));
  const auto run = box.run({"run", "--engine", terminal.engine(), "--left", "left.pgm", "--right", "right.pgm",
                            "--skin", "skin.hmap", "--profile", "field", "--out", "out"});
  CHECK(run.status == 2);
  CHECK_THAT(run.err, Catch::Contains("this machine takes no pictures"));
  CHECK(status_of(box, terminal.engine())["table"]["crc"] == crc);
}

TEST_CASE("What happens in the middle of an upload leaves the table in use in use") {
  const Sandbox box;
  write_large_table(box);
  auto terminal = std::make_unique<Terminal>();
  auto board = std::make_unique<BoardBehind>(*terminal);
  const std::string before = status_of(box, terminal->engine())["table"]["crc"];
  const std::vector<std::string> upload{"upload", "--engine", terminal->engine(), "--map", "skin.hmap", "--unproven"};
  constexpr std::size_t kMiddle = 4000;  // bytes from the host: among those of the first table

  board->at_byte(kMiddle, BoardBehind::Event::reset);
  check_fault(box, upload, "the board was reset");
  board->drain();
  CHECK(status_of(box, terminal->engine())["table"]["crc"] == before);
  wait_for_frame(box, terminal->engine());

  const auto is_in_use = [&](const std::string& engine) {
    const auto status = status_of(box, engine);
    CHECK(status["table"]["crc"] == before);
    CHECK(status["running"] == true);
    CHECK(status["registers"]["map_status"]["busy"] == 1);  // it was the middle
    CHECK_THAT(
        box.run({"status", "--engine", engine}).out,
        Catch::Contains("is active, CRC " + before) && Catch::Contains("an upload has begun, and is not complete"));
  };
  board->at_byte(kMiddle, BoardBehind::Event::noise);
  check_fault(box, upload, "has stopped answering");
  board->drain();
  board->quiet();
  is_in_use(terminal->engine());

  board->at_byte(kMiddle, BoardBehind::Event::unplug);
  check_fault(box, upload, "the port has gone");
  check_fault(box, upload, terminal->name());
  Terminal other;
  board->plug(other);
  board->drain();
  is_in_use(other.engine());

  // The line a second, and the cable pulled meanwhile.
  board->at_byte(1000, BoardBehind::Event::unplug);
  const auto watch = box.run({"status", "--engine", other.engine(), "--watch", "--json"});
  CHECK(watch.status == 4);
  CHECK_THAT(watch.err, Catch::Contains("the port has gone"));
  REQUIRE(std::ranges::count(watch.out, '\n') >= 1);
  std::istringstream lines(watch.out);
  for (std::string line; std::getline(lines, line);) CHECK(nlohmann::json::parse(line)["running"] == true);
}

TEST_CASE("A program that is killed in the middle of an upload leaves a board that works") {
  const Sandbox box;
  const std::string crc = write_table(box);
  Terminal terminal;
  BoardBehind board(terminal);
  const std::string before = status_of(box, terminal.engine())["table"]["crc"];
  wait_for_frame(box, terminal.engine());
  const std::string command = "horopter upload --engine " + terminal.engine() + " --map skin.hmap --unproven";
  board.at_byte(500, BoardBehind::Event::pause);
  CHECK(box.run_shell(command + " & sleep 2; kill -KILL $!; wait $!").status == 128 + SIGKILL);
  board.at_byte(0, BoardBehind::Event::none);
  terminal.release();
  const auto status = status_of(box, terminal.engine());
  CHECK(status["table"]["crc"] == before);
  CHECK(box.run_shell(command).status == 0);
  wait_for_crc(box, terminal.engine(), crc);

  // Cameras that cannot wait, and again ones that can.
  CHECK(box.run_shell(command + " --live").status == 0);
  CHECK(status_of(box, terminal.engine())["live"] == true);
  CHECK_THAT(box.run({"status", "--engine", terminal.engine()}).out,
             Catch::Contains("cameras   live: they cannot wait"));
  CHECK(box.run_shell(command).status == 0);
  CHECK(status_of(box, terminal.engine())["live"] == false);
}

TEST_CASE("Registers in this computer's memory") {
  const Sandbox box;
  write_table(box);
  const auto machine = horopter::make_native_device(horopter::find_profile("field"));
  const auto file = [&](std::uint32_t changed, std::uint32_t value) {
    std::string bytes(4096, '\0');
    for (const auto& r : horopter::registers::kRegisters) {
      if (r.address > horopter::registers::build_compete::kAddress) continue;
      const std::uint32_t word = r.address == changed ? value : machine->read(r.address);
      for (unsigned i = 0; i < 4; ++i) bytes[r.address + i] = static_cast<char>(word >> (8 * i));
    }
    return "uio:" + box.write("registers", bytes);
  };
  const std::string engine = file(0xFFF, 0);
  const auto status = status_of(box, engine);
  CHECK(status["build"]["profile"] == "field");
  CHECK(status["running"] == false);
  // Memory that is no machine: it does not fill a slot.
  check_fault(box, {"upload", "--engine", engine, "--map", "skin.hmap"}, "is not in the machine after its upload");
  const auto states = box.run({"status", "--engine", engine, "--states", "states.png"});
  CHECK(states.status == 2);
  CHECK_THAT(states.err, Catch::Contains("without streams"));

  check_fault(box, {"status", "--engine", file(0x000, 0)}, "no Horopter: its ID is 00000000");
  check_fault(box, {"status", "--engine", file(0x004, 7U << 16)}, "register map 7.0; expected");
  check_fault(box, {"status", "--engine", file(0x004, 2U << 16)}, "register map 2.0; expected 2.");
  check_fault(box, {"status", "--engine", file(0x008, 480U << 16 | 600U)}, "600x480 px, but is none of the profiles");
  check_fault(box, {"status", "--engine", "uio:/dev/no-such-device"}, "cannot be opened");
  check_fault(box, {"status", "--engine", "uio:/dev/null"}, "cannot be mapped");
  check_fault(box, {"status", "--engine", "uio:/dev/zero"}, "no Horopter: its ID is 00000000");
  check_fault(box, {"status", "--engine", engine + "@100"}, "expected a multiple of the page size");
  check_fault(box, {"status", "--engine", engine + "@4096"},
              "has 4096 bytes; expected 4096 bytes of registers at 4096");
  check_fault(box, {"status", "--engine", "uio:" + box.write("short", "HORO")}, "has 4 bytes; expected 4096 bytes");
  {
    const int other = ::open((box / "registers").c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(::flock(other, LOCK_EX | LOCK_NB) == 0);
    check_fault(box, {"status", "--engine", engine}, "is used by another program; expected a machine that is free");
    ::close(other);
  }
}

TEST_CASE("A restart is given where it counts, and refused with the reason where it does not") {
  namespace reg = horopter::registers;
  const Sandbox box;
  const auto machine = horopter::make_native_device(horopter::find_profile("field"));
  const auto restart = [&](std::uint32_t status, std::uint32_t interlock) {
    std::string bytes(4096, '\0');
    const auto put = [&](std::uint32_t address, std::uint32_t word) {
      for (unsigned i = 0; i < 4; ++i) bytes[address + i] = static_cast<char>(word >> (8 * i));
    };
    for (const auto& r : reg::kRegisters) {
      if (r.address <= reg::build_compete::kAddress) put(r.address, machine->read(r.address));
    }
    put(reg::status::kAddress, reg::status::kRunning.put(1) | status);
    put(reg::interlock::kAddress, interlock);
    return box.run({"restart", "--engine", "uio:" + box.write("registers", bytes)});
  };
  const auto written = [&] {
    const std::string bytes = box.read("registers");
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i) {
      word |= std::uint32_t{static_cast<unsigned char>(bytes[reg::restart::kAddress + i])} << (8 * i);
    }
    return word;
  };
  const std::uint32_t unsafe = reg::status::kUnsafe.put(1);
  const std::uint32_t waits = unsafe | reg::status::kWaiting.put(1);
  const std::uint32_t by_register = reg::interlock::kByRegister.put(1) | reg::interlock::kFrames.put(2);

  const auto safe = restart(reg::status::kSafe.put(1), by_register);
  CHECK(safe.status == 0);
  CHECK_THAT(safe.out, Catch::Contains("SAFE already"));
  const auto pin = restart(waits, reg::interlock::kByPin.put(1));
  CHECK(pin.status == 4);
  CHECK_THAT(pin.out, Catch::Contains("`horopter upload --restart register`"));
  const auto early = restart(unsafe, by_register);
  CHECK(early.status == 4);
  CHECK_THAT(early.out, Catch::Contains("its last 2 frames were not all without fault and alarm"));
  CHECK(written() == 0);
  // Both pins at once: the hardware is broken, and that is not safe.
  CHECK(restart(unsafe | reg::status::kSafe.put(1), by_register).status == 4);
  // Memory that is no machine takes the key and does not become safe.
  const auto given = restart(waits, by_register);
  CHECK(written() == reg::kRestartKey);
  CHECK(given.status == 4);
  CHECK_THAT(given.out, Catch::Contains("a frame with a fault or an alarm came in between, or none"));
}

TEST_CASE("Teaching ends when frames enough were good, and says why where they are not") {
  namespace reg = horopter::registers;
  const Sandbox box;
  const auto machine = horopter::make_native_device(horopter::find_profile("field"));
  std::vector<std::uint32_t> words(1024);
  for (const auto& r : reg::kRegisters) {
    if (r.address <= reg::build_compete::kAddress) words[r.address / 4] = machine->read(r.address);
  }
  const auto start = [&](int teach_frames) {
    return box.run(
        {"teach", "--engine", "uio:" + (box / "registers").string(), "--frames", std::to_string(teach_frames)});
  };
  const auto teach = [&](bool running) {
    words[reg::status::kAddress / 4] = reg::status::kRunning.put(running);
    box.write("registers", std::string(reinterpret_cast<const char*>(words.data()), 4 * words.size()));
    return start(3);
  };
  const auto left_with = [&] { return static_cast<unsigned>(box.read("registers")[reg::blocks::kAddress]) & 3U; };

  const auto stopped = teach(false);
  CHECK(stopped.status == 4);
  CHECK_THAT(stopped.err, Catch::Contains("`horopter upload` starts it"));
  CHECK(left_with() == 0);

  words[reg::build_window::kAddress / 4] &= ~reg::build_window::kBlind.mask();
  const auto without = teach(true);
  CHECK(without.status == 2);
  CHECK_THAT(without.err, Catch::Contains("built without the stage `blind`"));
  words[reg::build_window::kAddress / 4] |= reg::build_window::kBlind.mask();

  const auto silent = teach(true);
  CHECK(silent.status == 4);
  CHECK_THAT(silent.err, Catch::Contains("no frame was finished in 5 s; the machine is still teaching"));
  CHECK(left_with() == 3);

  // Somebody who makes frames behind the registers. Who comes does so behind the eighth frame, and stands still soon.
  enum class Zone { empty, never_empty, alarm_at_the_end, somebody_comes, somebody_comes_between_looks };
  std::uint32_t taught = 0;
  bool taught_before = false;
  bool judged_by_it = false;  // a frame that did not teach knew what another teaching had left
  const auto with_frames = [&](Zone zone, int teach_frames = 3) {
    std::atomic<bool> ends = false;
    const bool comes = zone == Zone::somebody_comes || zone == Zone::somebody_comes_between_looks;
    words[reg::status::kAddress / 4] = reg::status::kRunning.put(1);
    words[reg::taught::kAddress / 4] = taught;
    words[reg::map_status::kAddress / 4] = reg::map_status::kActiveSlot.put(2);
    words[reg::blocks::kAddress / 4] = reg::blocks::kWatch.put(taught_before) | reg::blocks::kTeach.put(taught_before);
    box.write("registers", std::string(reinterpret_cast<const char*>(words.data()), 4 * words.size()));
    std::thread frames([&] {
      const int file = ::open((box / "registers").c_str(), O_RDWR | O_CLOEXEC);
      const auto put = [&](std::uint32_t address, std::uint32_t word) {
        REQUIRE(::pwrite(file, &word, sizeof word, address) == sizeof word);
      };
      int alarms_left = comes ? 10 : 0;
      for (std::uint32_t sequence = 1; !ends; ++sequence) {
        std::uint32_t blocks = 0;
        REQUIRE(::pread(file, &blocks, sizeof blocks, reg::blocks::kAddress) == sizeof blocks);
        const bool teaching = (blocks & reg::blocks::kTeach.mask()) != 0;
        const bool alarm = teaching && alarms_left > 0 && (taught >= 8 || alarms_left < 10);
        if (alarm) --alarms_left;
        std::uint32_t load = 0;  // of the table that is in use: a fault
        REQUIRE(::pread(file, &load, sizeof load, reg::map_control::kAddress) == sizeof load);
        put(reg::map_control::kAddress, 0);
        const bool forgets =
            teaching ? alarm || load != 0 || zone == Zone::never_empty : taught != 0 && zone == Zone::alarm_at_the_end;
        judged_by_it = judged_by_it || (!teaching && taught >= 500);
        const bool anew = teaching && !taught_before;
        taught = forgets || anew ? 0 : taught + (taught_before ? 1 : 0);
        taught_before = teaching;
        put(reg::taught::kAddress, taught);
        put(reg::faults_cameras::kAddress, 0);  // which the command has cleared
        put(reg::faults_machine::kAddress, 0);
        put(reg::frame_faults_machine::kAddress, teaching ? horopter::Faults(reg::Fault::teaching).machine() : 0);
        put(reg::frame_status::kAddress, reg::frame_status::kSeen.put(alarm && zone == Zone::somebody_comes));
        put(reg::frame_sequence::kAddress, sequence);
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
      }
      ::close(file);
    });
    const auto result = start(teach_frames);
    ends = true;
    frames.join();
    return result;
  };
  const auto good = with_frames(Zone::empty);
  CHECK(good.status == 0);
  CHECK_THAT(good.out, Catch::Contains("taught by 3 frames"));
  CHECK(left_with() == 1);
  // What was taught before is no part of it: a teaching that was done, and one that was stopped on its way.
  for (const bool stopped_on_its_way : {false, true}) {
    taught = 500;
    taught_before = stopped_on_its_way;
    judged_by_it = false;
    CHECK(with_frames(Zone::empty).status == 0);
    if (stopped_on_its_way) CHECK_FALSE(judged_by_it);
    CHECK(taught >= 3);
    CHECK(taught < 100);
    CHECK(left_with() == 1);
  }
  const auto forgotten = with_frames(Zone::alarm_at_the_end);
  CHECK(forgotten.status == 4);
  CHECK_THAT(forgotten.err, Catch::Contains("all is forgotten; teach again"));
  CHECK(left_with() == 1);  // and all that is undecidable counts
  const auto never = with_frames(Zone::never_empty);
  CHECK(never.status == 4);
  CHECK_THAT(never.err, Catch::Contains("3 in a row have not been without fault and alarm"));
  CHECK(left_with() == 3);
  for (const Zone zone : {Zone::somebody_comes, Zone::somebody_comes_between_looks}) {
    CAPTURE(zone == Zone::somebody_comes);
    const auto disturbed = with_frames(zone, 10);
    CAPTURE(disturbed.err);
    CHECK(disturbed.status == 4);
    CHECK_THAT(disturbed.err, Catch::Contains("while it learned there was an alarm"));
    CHECK(left_with() == 3);  // never safe by what it knows
  }
}

TEST_CASE("A serial port without a Horopter board") {
  const Sandbox box;
  write_table(box);
  const auto upload = [&](const std::string& engine) {
    return std::vector<std::string>{"upload", "--engine", engine, "--map", "skin.hmap"};
  };
  const auto status = [](const std::string& engine) { return std::vector<std::string>{"status", "--engine", engine}; };
  check_fault(box, upload("serial:/dev/no-such-port"), "no such port; expected one");
  check_fault(box, upload("serial:/dev/null"), "is no serial port; expected one");
  Terminal terminal;
  check_fault(box, status(terminal.engine()), "nothing answers; expected a Horopter board");
  {
    const int other = ::open(terminal.name().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    REQUIRE(other >= 0);
    REQUIRE(::flock(other, LOCK_EX | LOCK_NB) == 0);
    check_fault(box, status(terminal.engine()), "another program has it open; expected a free port");
    ::close(other);
  }
  {
    const Behind echo(terminal, [](Terminal& t) { t.write(t.read()); });
    check_fault(box, status(terminal.engine()), "no answer of a Horopter board: another device");
  }
  {
    std::mt19937 random(1);
    const Behind noise(terminal, [&](Terminal& t) {
      std::vector<std::uint8_t> bytes(64);
      std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random()); });
      t.write(bytes);
      t.read();
    });
    check_fault(box, upload(terminal.engine()), "no answer of a Horopter board: another device");
  }
  if (::geteuid() == 0) {
    Terminal pulled;
    const Behind cable(pulled, [](Terminal& t) {
      if (!t.read().empty()) t.hang_up();
    });
    check_fault(box, status(pulled.engine()), "the port has gone");
    REQUIRE(::chmod(terminal.name().c_str(), 0) == 0);
    const auto result =
        box.run_shell("cd / && setpriv --reuid=65534 --clear-groups horopter status --engine " + terminal.engine());
    CAPTURE(result.err);
    CHECK(result.status == 4);
    CHECK_THAT(result.err, Catch::Contains("this user may not open it; expected permission"));
  }
}

TEST_CASE("Files and engines that are not the board's") {
  const Sandbox box;
  write_table(box);
  box.write("vga.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -3], [0, 1, 0], [0, 0, 1]]\n");
  REQUIRE(box.run({"map", "--skin", "vga.yaml", "--profile", "vga", "-o", "vga.hmap"}).status == 0);
  Terminal terminal;
  const BoardBehind board(terminal);
  const auto upload = [&](const std::vector<std::string>& more) {
    return std::vector<std::string>{"upload", "--engine", terminal.engine()} + more;
  };
  check_bad_file(box, upload({"--map", "vga.hmap"}), "vga.hmap", "a table for profile vga");
  check_bad_file(box, upload({"--map", "none.hmap"}), "none.hmap", "");
  check_bad_file(box, upload({"--map", "vga.yaml"}), "vga.yaml", "this is no table");
  const auto states = box.run({"status", "--engine", "native", "--states", "states.png"});
  CHECK(states.status == 2);
  CHECK_THAT(states.err, Catch::Contains("engine native has no frame to show; expected serial:PORT"));
  const auto compete = box.run(upload({"--map", "skin.hmap", "--decision", "compete"}));
  CHECK(compete.status == 2);
  CHECK_THAT(compete.err, Catch::Contains("does not have the decision 'compete'"));
  for (const char* engine : {"serial:", "serial:/dev/ttyUSB0@9600", "serial:/dev/ttyUSB0@", "uio:", "uio:/dev/uio0,a",
                             "uio:/dev/uio0@x", "serial", "other"}) {
    const auto result = box.run({"status", "--engine", engine});
    CAPTURE(engine, result.err);
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Catch::Contains("expected"));
  }
}
