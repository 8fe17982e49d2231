// SPDX-License-Identifier: Apache-2.0
// `horopter monitor` from outside: recorded pairs as live cameras, events on standard output, Modbus and MQTT by clients that
// are not ours, cameras that go, a broker that goes. Limits of time are long: a slow computer fails no test.
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "horopter/monitor/users.hpp"
#include "http.hpp"
#include "rig_text.hpp"
#include "running.hpp"

using namespace horopter::test;

namespace {

/// Of these four the third is an alarm, where an object is 100 px: the pattern repeats, and smaller ones are in most.
const std::string kFiles = "  left: {source: 'files:" + kData + "left0[1-4].jpg', repeat: true}\n" +
                           "  right: {source: 'files:" + kData + "right0[1-4].jpg', repeat: true}\n";

std::string gst_source(const std::string& side, const std::string& options) {
  return "  " + side + ": {source: 'gst:multifilesrc location=" + kData + side +
         "%02d.jpg start-index=1 stop-index=6 " + options + " caps=image/jpeg,framerate=2/1 ! jpegdec'}\n";
}

/// The input registers as pymodbus reads them, as soon as it is safe or has not been for long.
json read_modbus(const Sandbox& box, int port, bool safe) {
  box.write("client.py",
            "import json, sys, time\n"
            "from pymodbus.client import ModbusTcpClient\n"
            "client = ModbusTcpClient('127.0.0.1', port=int(sys.argv[1]))\n"
            "client.connect()\n"
            "for _ in range(600):\n"
            "    registers = client.read_input_registers(0, 14, slave=1).registers\n"
            "    if registers[2] == int(sys.argv[2]): break\n"
            "    time.sleep(0.1)\n"
            "bits = client.read_discrete_inputs(0, 4, slave=1).bits[:4]\n"
            "written = client.write_register(0, 1, slave=1).isError()\n"
            "print(json.dumps({'registers': registers, 'bits': bits, 'write_refused': written}))\n");
  Running client(box, {"/usr/bin/python3", "client.py", std::to_string(port), safe ? "1" : "0"}, "client");
  const int status = client.wait();
  INFO(client.err());
  REQUIRE(status == 0);
  return json::parse(client.out());
}

}  // namespace

TEST_CASE("recorded pairs as live cameras: events in JSON, Modbus by pymodbus, and a good end") {
  const CellBox box;
  const int port = free_port();
  box.cell(kFiles, "restart: by_itself\nlimits: {object: 100px, decision_ms: 30000}\noutputs: {modbus: {port: " +
                       std::to_string(port) + "}}\n");
  Running monitor = box.start();
  const json released = monitor.event("released");
  INFO(monitor.out() << monitor.err());
  REQUIRE(released.is_object());
  CHECK(released["safe"] == true);
  CHECK(released["by"]["name"] == "configuration");
  const json read = read_modbus(box, port, true);
  const auto& registers = read["registers"];
  CHECK(registers[0] == 1);
  CHECK(registers[1] > 0);
  CHECK(registers[2] == 1);
  CHECK(registers[3] == 0);
  CHECK(registers[5] < 30'000);
  CHECK(read["write_refused"] == true);
  char crc[9];
  std::snprintf(crc, sizeof crc, "%04x%04x", registers[12].get<unsigned>(), registers[13].get<unsigned>());
  // A busy computer may drop a pair, and stop for that: the photographs come again.
  const json stopped = monitor.event("stopped", [](const json& event) { return has_cause(event, "alarm"); });
  INFO(monitor.out());
  REQUIRE(stopped.is_object());
  CHECK(stopped["configuration"] == crc);
  REQUIRE(stopped["objects"].size() == 1);
  // From the left camera; the skin is 300 mm before it, and the board below and right of the middle.
  CHECK(stopped["objects"][0]["distance_mm"] > 300);
  CHECK(stopped["objects"][0]["distance_mm"] < 340);
  CHECK(monitor.end(SIGTERM) == 0);
  for (const json& event : monitor.events()) CHECK(event["configuration"] == crc);
}

TEST_CASE("the hardware in simulation judges live cameras, too") {
  const CellBox box;
  const auto has_rtl = box.run({"run", "--help"}).out.find("native, rtl") != std::string::npos;
  if (!has_rtl) {
    std::cout << "skipped: this build has no engine rtl\n";
    return;
  }
  std::map<std::string, json> objects;
  for (const std::string engine : {"native", "rtl"}) {
    CAPTURE(engine);
    box.write(
        "cell.yaml",
        "name: test\nengine: " + engine + "\ncameras:\n" + kFiles +
            "  frames_per_s: " + (engine == "rtl" ? "0.25" : "2") +
            "\nrig: rig.yaml\nskin: skin.yaml\nrestart: by_itself\nlimits: {object: 100px, decision_ms: 60000}\n");
    Running monitor = box.start();
    const json released = monitor.event("released");
    INFO(monitor.out() << monitor.err());
    REQUIRE(released.is_object());
    const json stopped = monitor.event("stopped", [](const json& event) { return has_cause(event, "alarm"); });
    REQUIRE(stopped.is_object());
    REQUIRE(stopped["objects"].size() == 1);
    objects[engine] = stopped["objects"][0];
    CHECK(monitor.end(SIGTERM) == 0);
  }
  for (const char* what : {"pixels", "box", "distance_mm"}) CHECK(objects["rtl"][what] == objects["native"][what]);
}

TEST_CASE("without a restart it is not safe, however good the images") {
  const CellBox box;
  box.cell(kFiles, "limits: {object: 100px, decision_ms: 30000}\n");
  Running monitor = box.start();
  const json possible = monitor.event("restart_possible");
  INFO(monitor.out() << monitor.err());
  REQUIRE(possible.is_object());
  const int at = possible["frame"];
  REQUIRE(eventually([&] {  // and it stays so
    const auto events = monitor.events();
    return !events.empty() && events.back()["frame"] > at;
  }));
  CHECK(monitor.end(SIGTERM) == 0);
  for (const json& event : monitor.events()) {
    CHECK(event["safe"] == false);
    CHECK(event["event"] != "released");
  }
}

TEST_CASE("a restart from the page of a running monitor, and the log of the stop after it") {
  const CellBox box;
  const int port = free_port();
  const std::string password = "correct horse";
  horopter::monitor::set_user(box / "users", "anna", horopter::monitor::Role::plant_operator, password);
  box.cell(kFiles, "limits: {object: 100px, decision_ms: 30000}\nlog: {directory: log}\nweb: {listen: '127.0.0.1:" +
                       std::to_string(port) + "', users_file: users, restart: true}\n");
  Running monitor = box.start();
  REQUIRE(monitor.event("restart_possible").is_object());

  httplib::Client page("127.0.0.1", port);
  page.set_read_timeout(60s);
  httplib::Headers headers{{"Origin", "http://127.0.0.1:" + std::to_string(port)}};
  const auto login =
      page.Post("/api/login", headers, json{{"name", "anna"}, {"password", password}}.dump(), "application/json");
  REQUIRE(login);
  REQUIRE(login->status == 200);
  const std::string cookie = login->get_header_value("Set-Cookie");
  headers.emplace("Cookie", cookie.substr(0, cookie.find(';')));
  headers.emplace("X-Horopter-Token", json::parse(page.Get("/api/session", headers)->body)["token"].get<std::string>());
  // Every fourth photograph is an alarm: a restart that meets it is refused, and asked for again.
  REQUIRE(eventually([&] {
    const json seen = {{"stop", json::parse(page.Get("/api/status", headers)->body)["stop"]}};
    page.Post("/api/restart", headers, seen.dump(), "application/json");
    std::this_thread::sleep_for(300ms);
    for (const json& event : monitor.events()) {
      if (event["event"] == "released") return true;
    }
    return false;
  }));
  CHECK(monitor.event("released")["by"]["name"] == "anna");
  REQUIRE(monitor.event("stopped", [](const json& event) { return has_cause(event, "alarm"); }).is_object());
  const auto metrics = page.Get("/metrics", headers);
  REQUIRE(metrics);
  CHECK(metrics->status == 200);
  CHECK_THAT(metrics->body, Catch::Contains("horopter_safe"));
  CHECK(monitor.end(SIGTERM) == 0);

  const auto checked = box.run({"log", "log", "--check"});
  INFO(checked.out << checked.err);
  CHECK(checked.status == 0);
  const auto listed = box.run({"log", "log", "--json"});
  CHECK_THAT(listed.out, Catch::Contains("anna") && Catch::Contains("\"alarm\"") && Catch::Contains(".jpg"));
}

TEST_CASE("it ends after so many pairs") {
  const CellBox box;
  box.cell(kFiles, "limits: {object: 100px, decision_ms: 30000}\n");
  Running monitor = box.start({"--frames", "2"});
  CHECK(monitor.wait() == 0);
}

TEST_CASE("files of which no pair was judged are an error") {
  const Sandbox box;
  box.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]\n");
  // Without a rig the first pair only tells the size, where it is not over before its file is open.
  box.write("cell.yaml", "cameras: {left: {source: 'files:" + kData + "left01.jpg'}, right: {source: 'files:" + kData +
                             "right01.jpg'}, frames_per_s: 2, largest_skew_ms: 10}\nskin: skin.yaml\n" +
                             "restart: by_itself\nlimits: {object: 100px, decision_ms: 30000}\n");
  const auto result = box.run({"monitor", "cell.yaml"});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Catch::Contains("cell.yaml: cameras") &&
                             Catch::Contains("all images were over before the first pair was judged"));
}

TEST_CASE("the same by GStreamer, until a camera is gone: named, and not safe") {
  const CellBox box;
  const int port = free_port();
  box.cell(gst_source("left", "loop=true") + gst_source("right", "loop=false"),
           "restart: by_itself\nlimits: {object: 100px, decision_ms: 1500}\noutputs: {modbus: {port: " +
               std::to_string(port) + "}}\n");
  Running monitor = box.start();
  json lost;
  eventually([&] {
    for (const json& event : monitor.events()) {
      if (has_cause(event, "right_camera_lost") && event["causes"].dump().find("has ended") != std::string::npos) {
        lost = event;
      }
    }
    return lost.is_object();
  });
  INFO(monitor.out() << monitor.err());
  REQUIRE(lost.is_object());
  CHECK(lost["safe"] == false);
  CHECK_THAT(lost["causes"].dump(), Catch::Contains("right camera"));
  CHECK(lost["frame"] > 0);
  const auto registers = read_modbus(box, port, false)["registers"];
  CHECK(registers[2] == 0);
  CHECK(registers[3] == 1);
  CHECK((registers[10].get<unsigned>() << 16 | registers[11].get<unsigned>()) != 0);
  CHECK(monitor.end(SIGINT) == 0);
}

TEST_CASE("MQTT: a state that is kept, a last will, and a broker that goes is named and not safe") {
  const CellBox box;
  const std::string port = std::to_string(free_port());
  box.write("broker.conf", "listener " + port + " 127.0.0.1\nallow_anonymous false\npassword_file users\n");
  box.write("users", "");
  // It gives up root, and must read its files all the same.
  fs::permissions(box / "", fs::perms::others_exec, fs::perm_options::add);
  fs::permissions((box / "").parent_path().parent_path(), fs::perms::others_exec, fs::perm_options::add);
  box.write("password", "secret\n");
  REQUIRE(Running(box, {"mosquitto_passwd", "-b", "users", "cell", "secret"}, "passwd").wait() == 0);
  fs::permissions(box / "users", fs::perms::others_read, fs::perm_options::add);
  Running broker(box, {"/usr/sbin/mosquitto", "-c", "broker.conf"}, "broker");
  const auto listen = [&](const std::string& topic) {
    return std::vector<std::string>{"mosquitto_sub", "-h", "127.0.0.1", "-p", port, "-u", "cell", "-P",
                                    "secret",        "-t", topic,       "-q", "1"};
  };
  box.cell(kFiles,
           "restart: by_itself\nlimits: {object: 100px, decision_ms: 30000}\noutputs: {mqtt: {host: 127.0.0.1, port: " +
               port + ", topic: cells/3, user: cell, password_file: password}}\n");
  const auto last_state = [](const Running& listener) {
    json last = json::object();
    std::istringstream lines(listener.out());
    for (std::string line; std::getline(lines, line);) {
      if (!lines.eof()) last = json::parse(line);
    }
    return last;
  };
  SECTION("killed") {
    Running monitor = box.start();
    const json released = monitor.event("released");
    INFO(monitor.out() << monitor.err() << broker.err());
    REQUIRE(released.is_object());
    Running listener(box, listen("cells/3/state"), "listener");
    REQUIRE(eventually([&] { return last_state(listener).value("safe", false); }));
    monitor.end(SIGKILL);
    REQUIRE(eventually([&] { return last_state(listener).contains("reason"); }));
    CHECK(last_state(listener)["safe"] == false);
    Running later(box, listen("cells/3/state"), "later");
    CHECK(eventually([&] { return last_state(later).contains("reason"); }));
  }
  SECTION("ended, and a broker that goes") {
    Running monitor = box.start();
    REQUIRE(monitor.event("released").is_object());
    Running listener(box, listen("cells/3/#"), "listener");
    REQUIRE(eventually([&] { return last_state(listener).value("safe", false); }));
    broker.end(SIGKILL);
    const json stopped = monitor.event("stopped", [](const json& event) { return has_cause(event, "output"); });
    INFO(monitor.out());
    REQUIRE(stopped.is_object());
    CHECK_THAT(stopped["causes"].dump(), Catch::Contains("MQTT broker 127.0.0.1:" + port));
    CHECK(monitor.end(SIGTERM) == 0);
  }
  SECTION("a broker that goes and comes: the stop that nobody heard is told, before the state") {
    Running monitor = box.start();
    REQUIRE(monitor.event("released").is_object());
    {
      Running early(box, listen("cells/3/#"), "early");
      REQUIRE(eventually([&] { return last_state(early).value("safe", false); }));  // `released` is told
    }
    broker.end(SIGKILL);
    REQUIRE(monitor.event("stopped", [](const json& event) { return has_cause(event, "output"); }).is_object());
    monitor.send(SIGSTOP);  // until somebody listens
    box.write("broker.conf", box.read("broker.conf") + "log_dest stderr\nlog_type all\n");
    Running next(box, {"/usr/sbin/mosquitto", "-c", "broker.conf"}, "next");
    REQUIRE(eventually([&] { return next.err().find(" running") != std::string::npos; }));
    Running listener(box, listen("cells/3/#"), "listener");
    REQUIRE(eventually([&] { return next.err().find("Sending SUBACK") != std::string::npos; }));
    monitor.send(SIGCONT);
    REQUIRE(eventually([&] { return listener.out().find('\n') != std::string::npos; }));
    const std::string out = listener.out();
    INFO(out << next.err());
    const json first = json::parse(out.substr(0, out.find('\n')));
    CHECK(first.value("event", "") == "stopped");
    CHECK(has_cause(first, "output"));
    CHECK(monitor.end(SIGTERM) == 0);
  }
  SECTION("a broker that hangs and goes: no state of before is said again to the next one") {
    Running monitor = box.start();
    REQUIRE(monitor.event("released").is_object());
    Running listener(box, listen("cells/3/state"), "listener");
    REQUIRE(eventually([&] { return last_state(listener).value("safe", false); }));
    broker.send(SIGSTOP);
    std::this_thread::sleep_for(2500ms);  // of states that it does not take
    broker.end(SIGKILL);
    box.write("broker.conf", box.read("broker.conf") + "log_dest stderr\nlog_type all\n");
    Running next(box, {"/usr/sbin/mosquitto", "-c", "broker.conf"}, "next");
    const auto got_state = [&](const std::string& duplicate) {
      std::istringstream lines(next.err());
      for (std::string line; std::getline(lines, line);) {
        if (line.find(duplicate) != std::string::npos && line.find("'cells/3/state'") != std::string::npos) return true;
      }
      return false;
    };
    REQUIRE(eventually([&] { return got_state("(d0,"); }));
    CHECK_FALSE(got_state("(d1,"));
    CHECK(monitor.end(SIGTERM) == 0);
    CHECK(eventually([&] { return next.err().find("Received DISCONNECT") != std::string::npos; }));
  }
}

TEST_CASE("MQTT by TLS: both show their certificates; a broker of another name, or of nobody we know, is none") {
  const CellBox box;
  const std::string port = std::to_string(free_port());
  const auto made = box.run_shell(
      "set -e; new() { openssl req -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -subj /CN=$1 -keyout $1.key "
      "-out $1.csr; }\n"
      "authority() { openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=$1 "
      "-keyout $1.key -out $1.pem; }\n"
      "sign() { echo \"subjectAltName=$3\" > san; openssl x509 -req -in $1.csr -CA $2.pem -CAkey $2.key -CAcreateserial "
      "-days 2 -extfile san -out $1.pem; }\n"
      "{ authority ours; authority other; new broker; new elsewhere; new cell; sign broker ours DNS:localhost\n"
      "sign elsewhere ours DNS:elsewhere.example; sign cell ours DNS:cell; } 2>&1");
  INFO(made.out);
  REQUIRE(made.status == 0);
  const auto broker_of = [&](const std::string& name) {
    box.write(name + ".conf", "user root\nlistener " + port + " 127.0.0.1\ncafile ours.pem\ncertfile " + name +
                                  ".pem\nkeyfile " + name + ".key\nrequire_certificate true\nallow_anonymous true\n");
    return Running(box, {"/usr/sbin/mosquitto", "-c", name + ".conf"}, name);
  };
  const auto cell = [&](const std::string& keys) {
    box.cell(
        kFiles,
        "restart: by_itself\nlimits: {object: 100px, decision_ms: 30000}\noutputs: {mqtt: {host: localhost, port: " +
            port + keys + "}}\n");
  };
  const std::string shown = ", certificate_file: cell.pem, key_file: cell.key";
  SECTION("good") {
    const Running broker = broker_of("broker");
    cell(", ca_file: ours.pem" + shown);
    Running monitor = box.start();
    const json released = monitor.event("released");
    INFO(monitor.out() << monitor.err() << broker.err());
    REQUIRE(released.is_object());
    const Running listener(box,
                           {"mosquitto_sub", "-h", "localhost", "-p", port, "--cafile", "ours.pem", "--cert",
                            "cell.pem", "--key", "cell.key", "-t", "horopter/test/state"},
                           "listener");
    CHECK(eventually([&] { return listener.out().find("\"safe\":true") != std::string::npos; }));
    CHECK(monitor.end(SIGTERM) == 0);
  }
  SECTION("not") {
    const auto [name, keys] = GENERATE_COPY(table<std::string, std::string>({
        {"broker", ", ca_file: other.pem" + shown},
        {"elsewhere", ", ca_file: ours.pem" + shown},
        {"broker", ", ca_file: ours.pem"},
        {"broker", ""},
    }));
    CAPTURE(name, keys);
    const Running broker = broker_of(name);
    cell(keys);
    Running monitor = box.start();
    const json refused = monitor.event("causes", [](const json& event) {
      return event["frame"] >= 2 && event["causes"].dump().find("MQTT broker") != std::string::npos;
    });
    INFO(monitor.out() << monitor.err() << broker.err());
    CHECK(refused.is_object());
    CHECK(monitor.end(SIGTERM) == 0);
    for (const json& event : monitor.events()) CHECK(event["safe"] == false);
  }
}

TEST_CASE("what runs is what has the checksum: a skin that is changed while the monitor begins is refused") {
  const Sandbox box;
  box.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]\n");
  const auto source = [](const std::string& side) {
    return "  " + side + ": {source: 'gst:multifilesrc location=" + side +
           "%d.jpg stop-index=0 loop=true caps=image/jpeg,framerate=2/1 ! jpegdec'}\n";
  };
  box.write("cell.yaml", "cameras:\n" + source("left") + source("right") +
                             "  frames_per_s: 2\n  largest_skew_ms: 100\nskin: skin.yaml\nlimits: {object: 100px, "
                             "decision_ms: 30000}\n");
  Running monitor(box, {HOROPTER_PROGRAM, "monitor", "cell.yaml", "--json", "--frames", "1"}, "monitor");
  REQUIRE(monitor.event("noted").is_object());  // it has read the cell; the machine waits for the first images
  const bool changed = GENERATE(true, false);
  if (changed) box.write("skin.yaml", box.read("skin.yaml") + "# changed\n");
  for (const std::string side : {"left", "right"}) fs::copy_file(kData + side + "01.jpg", box / (side + "0.jpg"));
  const int status = monitor.wait();
  INFO(monitor.err());
  CHECK(status == (changed ? 3 : 0));
  if (changed) CHECK_THAT(monitor.err(), Catch::Contains("was changed while the monitor began"));
}

TEST_CASE("what is wrong with the cell is said at once") {
  const Sandbox box;
  box.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]\n");
  box.write("cell.yaml",
            "cameras: {left: {source: 'files:a*.png'}, right: {source: 'files:b*.png'}, frames_per_s: 5}\nskin: "
            "skin.yaml\nzones: z\n");
  const auto result = box.run({"monitor", "cell.yaml"});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Catch::Contains("cell.yaml: line 3") && Catch::Contains("unknown key 'zones'"));
  CHECK(box.run({"monitor", "none.yaml"}).status == 3);
  CHECK(box.run({"monitor"}).status == 2);
  const auto error_of = [&](const std::string& left, const std::string& right, const std::string& more) {
    box.write("cell.yaml", "cameras: {left: {source: 'files:" + kData + left + "'}, right: {source: 'files:" + kData +
                               right + "'}, frames_per_s: 5}\nskin: skin.yaml\n" + more);
    const auto failed = box.run({"monitor", "cell.yaml"});
    CHECK(failed.status == 3);
    return failed.err;
  };
  CHECK_THAT(error_of("left0[1-3].jpg", "right0[12].jpg", ""), Catch::Contains("right") && Catch::Contains("3 left"));
  CHECK_THAT(error_of("left0[12].jpg", "right0[23].jpg", ""), Catch::Contains("right02.jpg"));
  CHECK_THAT(error_of("left0[12].jpg", "right0[12].jpg", "limits: {tolerance_px: 0.05}\n"),
             Catch::Contains("cell.yaml: limits") && Catch::Contains("0.05 px"));

  // Cameras may be half as slow again as the cell says before it is a fault; an alarm by 2 of 3 frames counts with that.
  box.write("rig.yaml", two_cameras(640, 480, 535, "-100, 0, 0"));
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 900], normal: [0, 0, -1]}\n");
  const auto wanted_rate = [](const std::string& message) {
    CAPTURE(message);
    const auto end = message.find(" frames a second");
    REQUIRE(end != std::string::npos);
    return std::stoi(message.substr(message.rfind(' ', end - 1) + 1));
  };
  const auto run =
      box.run({"run", "--left", kData + "left01.jpg", "--right", kData + "right01.jpg", "--rig", "rig.yaml", "--skin",
               "skin.yaml", "--alarm-frames", "2/3", "--frame-rate", "5", "--out", "out"});
  const int by_run = wanted_rate(run.err);
  const int by_monitor =
      wanted_rate(error_of("left01.jpg", "right01.jpg", "rig: rig.yaml\nlimits: {alarm_frames: 2/3}\n"));
  CHECK(std::abs(by_monitor - 1.5 * by_run) < 2.5);

  // The lines come before the machine, which these limits would refuse.
  for (const std::string pulse : {"", ", pulse_line: 22"}) {
    const std::string lines =
        error_of("left01.jpg", "right01.jpg",
                 "rig: rig.yaml\nlimits: {alarm_frames: 2/3}\noutputs: {gpio: {chip: /dev/no-chip, "
                 "safe_line: 17, unsafe_line: 27" +
                     pulse + "}}\n");
    CHECK_THAT(lines, Catch::Contains("outputs.gpio: no chip /dev/no-chip"));
    CHECK(Catch::contains(lines, "outputs.gpio has no pulse_line") == pulse.empty());
  }
}
