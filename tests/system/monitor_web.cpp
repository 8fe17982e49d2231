// SPDX-License-Identifier: Apache-2.0
// The page of a monitor from outside: who may do what, and what hostile requests cost.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "eventually.hpp"
#include "fake_control.hpp"
#include "horopter/base/error.hpp"
#include "horopter/draw/overlay.hpp"
#include "horopter/image/image.hpp"
#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/users.hpp"
#include "horopter/monitor/web.hpp"
#include "http.hpp"
#include "moments.hpp"
#include "plc.hpp"
#include "running.hpp"
#include "sandbox.hpp"

using namespace horopter;
using namespace horopter::test;
using Json = nlohmann::ordered_json;
using monitor::Role;
using monitor::WebConfiguration;

namespace {

constexpr auto kLong = std::chrono::seconds(60);
const std::string kPassword = "correct horse";

/// Hashing takes its time: once for all tests.
const std::string& users_text() {
  static const std::string text = [] {
    Sandbox box;
    const fs::path file = box / "users";
    monitor::set_user(file, "vera", Role::viewer, kPassword);
    monitor::set_user(file, "otto", Role::plant_operator, kPassword);
    monitor::set_user(file, "emma", Role::engineer, kPassword);
    return box.read("users");
  }();
  return text;
}

/// A page with its log and a monitor that is not one.
struct Cell {
  Sandbox box;
  FakeControl control;
  std::unique_ptr<monitor::EventLog> log;
  std::unique_ptr<monitor::Web> web;

  explicit Cell(WebConfiguration configuration = {}) {
    const fs::path users = box.write("users", users_text());
    REQUIRE(::chmod(users.c_str(), 0600) == 0);
    monitor::LogSettings settings;
    settings.directory = box / "log";
    settings.patience_s = 1e6;
    settings.pictures_per_s = 1000;
    log = std::make_unique<monitor::EventLog>(settings);
    configuration.port = 0;
    configuration.users = users;
    configuration.decision_limit_ms = 1e6;  // of a machine that may be slow
    configuration.requests_per_s = 0;
    configuration.login_failures_per_min = 0;
    web = std::make_unique<monitor::Web>(
        configuration,
        monitor::Web::Sources{.control = &control, .log = log.get(), .metrics = [] { return "horopter_up 1\n"; }});
    control.add(*log);
  }
  explicit Cell(bool restart_allowed) : Cell(allowing(restart_allowed)) {}

  static WebConfiguration allowing(bool restart) {
    WebConfiguration configuration;
    configuration.restart_allowed = restart;
    return configuration;
  }

  /// Good, then an alarm, then good again: it waits for a restart.
  void stop_it() {
    control.judge(*moment_of(1));
    std::string why;
    REQUIRE(control.restart({"button", ""}, 0, why));
    control.judge(*moment_of(2, true));
    control.judge(*moment_of(3));
    REQUIRE_FALSE(control.safe());
  }
};

/// A browser, as far as the page is concerned.
class Browser {
 public:
  explicit Browser(const Cell& cell) : client_("127.0.0.1", cell.web->port()), port_(cell.web->port()) {
    client_.set_keep_alive(true);
    client_.set_read_timeout(kLong);
  }
  explicit Browser(const Cell& cell, const std::string& name) : Browser(cell) {
    REQUIRE(log_in(name, kPassword) == 200);
  }

  int log_in(const std::string& name, const std::string& password) {
    const auto answer = client_.Post("/api/login", own_origin(), Json{{"name", name}, {"password", password}}.dump(),
                                     "application/json");
    REQUIRE(answer);
    if (answer->status == 200) {
      const std::string text = answer->get_header_value("Set-Cookie");
      cookie_ = text.substr(0, text.find(';'));
      attributes_ = text.substr(text.find(';'));
      const Json session = Json::parse(get("/api/session")->body);
      token_ = session["token"].is_string() ? session["token"].get<std::string>() : "";  // the user may be gone already
    }
    return answer->status;
  }
  httplib::Result get(const std::string& path) {
    auto answer = client_.Get(path, {{"Cookie", cookie_}});
    REQUIRE(answer);
    return answer;
  }
  Json json(const std::string& path) { return Json::parse(get(path)->body); }
  int post(const std::string& path, const Json& json) { return post(path, json, own_origin(), token_); }
  int post(const std::string& path, const Json& json, httplib::Headers headers, const std::string& token) {
    headers.emplace("Cookie", cookie_);
    if (!token.empty()) headers.emplace("X-Horopter-Token", token);
    const auto answer = client_.Post(path, headers, json.dump(), "application/json");
    REQUIRE(answer);
    said_ = answer->body;
    return answer->status;
  }
  httplib::Headers own_origin() const { return {{"Origin", "http://127.0.0.1:" + std::to_string(port_)}}; }
  const std::string& said() const { return said_; }
  const std::string& token() const { return token_; }
  const std::string& attributes() const { return attributes_; }

 private:
  httplib::Client client_;
  int port_;
  std::string cookie_ = "none=1";
  std::string token_;
  std::string attributes_;
  std::string said_;
};

/// All that comes back of these bytes until the other side closes.
std::string raw(int port, const std::string& bytes) {
  const int socket = connect_to(port, kLong);
  REQUIRE(socket >= 0);
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) break;
    sent += static_cast<std::size_t>(count);
  }
  ::shutdown(socket, SHUT_WR);
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::recv(socket, buffer, sizeof buffer, 0)) > 0;) text.append(buffer, buffer + got);
  ::close(socket);
  return text;
}

std::string get_raw(int port, const std::string& target, const std::string& more = "") {
  return raw(port, "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" + more + "\r\n");
}

int status_in(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::atoi(answer.substr(9, 3).c_str()) : 0;
}

}  // namespace

TEST_CASE("The key of colours has those of the pictures") {
  constexpr int kSide = 64;
  const horopter::Image left(kSide, kSide, 128);
  horopter::FrameResult result;
  result.states = horopter::Image(kSide, kSide);
  result.blind.assign(result.states.pixels.size(), 0);
  result.object_limit_pixels = 200;
  const auto fill = [&](int x, int y, int width, int height, horopter::State state) {
    for (int row = y; row < y + height; ++row) {
      for (int column = x; column < x + width; ++column) {
        result.states.at(column, row) = static_cast<std::uint8_t>(state);
      }
    }
  };
  fill(0, 0, 20, 20, horopter::State::skin);
  fill(40, 0, 6, 6, horopter::State::skin);
  fill(0, 40, 20, 10, horopter::State::undecidable);
  fill(40, 40, 20, 20, horopter::State::unsupervised);
  for (int x = 0; x < 20; ++x) result.blind[static_cast<std::size_t>(49 * kSide + x)] = 1;
  const auto colour_at = [](const horopter::Picture& picture, std::size_t pixel) {
    const std::uint8_t* bgr = picture.bgr.data() + 3 * pixel;
    return fmt::format("#{:02x}{:02x}{:02x}", bgr[2], bgr[1], bgr[0]);
  };
  const auto has = [&](const horopter::Picture& picture, const std::string& colour) {
    for (std::size_t i = 0; i < picture.bgr.size() / 3; ++i) {
      if (colour_at(picture, i) == colour) return true;
    }
    return false;
  };
  Cell cell(true);
  Browser nobody(cell);
  const std::string css = nobody.get("/page.css")->body;
  const std::string page = nobody.get("/")->body;
  const auto states = horopter::draw_states(left, result);
  const auto at = [&](int x, int y) { return colour_at(states, static_cast<std::size_t>(y * kSide + x)); };
  CHECK_THAT(css, Catch::Contains(".key-clear { background: " + at(30, 30) + ";"));
  CHECK_THAT(css, Catch::Contains(".key-skin { background: " + at(5, 5) + ";"));
  CHECK_THAT(css, Catch::Contains(".key-dim { background: " + at(5, 45) + ";"));
  CHECK_THAT(css, Catch::Contains(".key-blind { background: " + at(5, 49) + ";"));
  CHECK_THAT(css, Catch::Contains(at(40, 40) + " 0 2px, " + at(41, 40) + " 2px"));
  const auto overlay = horopter::draw_overlay(left, result);
  for (const std::string key : {".key-object { border: 3px solid ", ".key-small { border: 3px solid "}) {
    const auto place = css.find(key);
    REQUIRE(place != std::string::npos);
    CHECK(has(overlay, css.substr(place + key.size(), 7)));
  }
  for (const char* key : {"clear", "skin", "blind", "dim", "hatched", "object", "small"}) {
    CHECK_THAT(page, Catch::Contains("<li><span class=\"key key-" + std::string(key) + "\"></span><b>"));
  }
}

TEST_CASE("Each role may do what it may, and no more") {
  Cell cell(true);
  cell.stop_it();

  Browser nobody(cell);
  CHECK(nobody.get("/api/status")->status == 401);
  CHECK(nobody.get("/api/picture")->status == 401);
  CHECK(nobody.get("/api/log")->status == 401);
  CHECK(nobody.get("/metrics")->status == 401);
  CHECK(nobody.get("/api/session")->status == 200);
  CHECK(nobody.get("/")->status == 200);
  CHECK(nobody.post("/api/restart", {{"stop", 1}}) == 401);

  Browser viewer(cell, "vera");
  CHECK_THAT(viewer.attributes(), Catch::Contains("; HttpOnly") && Catch::Contains("; SameSite=Strict"));
  const auto status = viewer.json("/api/status");
  CHECK(status["state"] == "not_safe");
  CHECK(status["restart"] == "possible");
  CHECK(status["latched"][0]["name"] == "alarm");
  CHECK(viewer.get("/metrics")->body == "horopter_up 1\n");
  CHECK(viewer.json("/api/session")["may_restart"] == false);
  CHECK(viewer.post("/api/restart", {{"stop", status["stop"]}}) == 403);
  CHECK_THAT(viewer.said(), Catch::Contains("The role viewer may not do this"));
  CHECK(viewer.post("/api/teach", {{"frames", 10}}) == 403);
  CHECK(cell.control.asked().size() == 1);  // that of the button
  CHECK_FALSE(cell.control.safe());

  Browser plant_operator(cell, "otto");
  CHECK(plant_operator.json("/api/session")["may_restart"] == true);
  CHECK(plant_operator.post("/api/teach", {{"frames", 10}}) == 403);
  CHECK(plant_operator.post("/api/restart", {{"stop", status["stop"]}}) == 200);
  CHECK(cell.control.asked().back().by == "otto");
  CHECK(cell.control.safe());
  cell.control.judge(*moment_of(4));
  CHECK(plant_operator.json("/api/status")["state"] == "safe");

  Browser engineer(cell, "emma");
  CHECK(engineer.json("/api/session")["may_teach"] == true);
  CHECK(engineer.json("/api/session")["teach_allowed"] == false);  // what the page says; the monitor refuses
  const int stop = engineer.json("/api/status")["stop"];
  CHECK(engineer.post("/api/teach", {{"frames", 10}}) == 400);
  CHECK(engineer.post("/api/teach", {{"frames", 10}, {"stop", stop - 1}}) == 409);
  CHECK_THAT(engineer.said(), Catch::Contains("since you looked"));
  CHECK(cell.control.asked().back().what == "restart");
  CHECK(engineer.post("/api/teach", {{"frames", 10}, {"stop", stop}}) == 200);
  CHECK(cell.control.asked().back().what == "teach 10");
  CHECK(engineer.post("/api/teach", {{"frames", 0}, {"stop", stop}}) == 409);
  CHECK_THAT(engineer.said(), Catch::Contains("0 frames"));
  CHECK(engineer.post("/api/teach", {{"frames", (std::int64_t{1} << 32) + 10}, {"stop", stop}}) == 400);
  CHECK(engineer.post("/api/teach", {{"frames", "many"}, {"stop", stop}}) == 400);
  CHECK(engineer.post("/api/logout", Json::object()) == 200);
  CHECK(engineer.get("/api/status")->status == 401);

  REQUIRE(cell.log->flush(kLong));
  const auto events = viewer.json("/api/log")["events"];
  const auto has = [&](const std::string& kind, const std::string& by) {
    return std::ranges::any_of(events, [&](const Json& event) { return event["kind"] == kind && event["by"] == by; });
  };
  CHECK(has("restart", "otto"));
  CHECK(has("refused", "vera"));
  CHECK(has("login", "emma"));
}

TEST_CASE("Safe is shown only where everything says so, and the decision is not old") {
  WebConfiguration configuration;
  configuration.look_without_login = true;
  Cell cell(configuration);
  Browser browser(cell);
  CHECK(browser.json("/api/status")["state"] == "old");  // there was no pair yet
  CHECK(browser.get("/api/picture")->status == 404);
  cell.control.judge(*moment_of(1));
  CHECK(browser.json("/api/status")["state"] == "not_safe");
  std::string why;
  REQUIRE(cell.control.restart({"button", ""}, 0, why));
  CHECK(browser.json("/api/status")["state"] == "safe");
  auto old = *moment_of(2);
  cell.control.judge(old);
  CHECK(browser.json("/api/status")["state"] == "safe");
  cell.control.judge(*moment_of(3, true));
  CHECK(browser.json("/api/status")["state"] == "alarm");

  // A page whose limit is shorter than any answer takes.
  monitor::WebConfiguration strict;
  strict.port = 0;
  strict.decision_limit_ms = 1e-6;
  FakeControl control;
  const monitor::Web web(strict, {.control = &control, .log = nullptr, .metrics = {}});
  control.judge(*moment_of(1));
  REQUIRE(control.restart({"button", ""}, 0, why));
  httplib::Client client("127.0.0.1", web.port());
  const auto answer = client.Get("/api/status");
  REQUIRE(answer);
  CHECK(Json::parse(answer->body)["state"] == "old");
  CHECK(client.Get("/metrics")->status == 404);
}

TEST_CASE("A restart needs the token, the origin, the configuration, and the stop that was seen") {
  Cell cell(true);
  cell.stop_it();
  Browser browser(cell, "otto");
  const auto stop = browser.json("/api/status")["stop"];
  const Json seen{{"stop", stop}};
  const auto before = cell.control.asked().size();
  CHECK(browser.post("/api/restart", seen, browser.own_origin(), "") == 403);
  CHECK(browser.post("/api/restart", seen, browser.own_origin(), std::string(64, '0')) == 403);
  CHECK(browser.post("/api/restart", seen, {{"Origin", "http://evil.example"}}, browser.token()) == 403);
  CHECK(browser.post("/api/restart", seen, {{"Origin", "null"}}, browser.token()) == 403);
  CHECK(browser.post("/api/restart", seen, {{"Sec-Fetch-Site", "cross-site"}}, browser.token()) == 403);
  CHECK(browser.post("/api/restart", Json::object()) == 400);
  CHECK(cell.control.asked().size() == before);
  CHECK(browser.post("/api/restart", {{"stop", 99}}) == 409);
  CHECK_FALSE(cell.control.safe());
  // Somebody crossed the skin since the page was looked at: also while it was not safe, and though the pictures are good again.
  cell.control.judge(*moment_of(5, true));
  const Json crossed{{"stop", browser.json("/api/status")["stop"]}};
  CHECK(browser.post("/api/restart", seen) == 409);
  CHECK_THAT(browser.said(), Catch::Contains("since you looked"));
  CHECK(browser.post("/api/restart", crossed) == 409);
  CHECK_THAT(browser.said(), Catch::Contains("The last pictures were not good."));
  cell.control.judge(*moment_of(6));
  CHECK(browser.post("/api/restart", seen) == 409);
  CHECK_FALSE(cell.control.safe());
  CHECK(browser.post("/api/restart", crossed) == 200);
  CHECK(cell.control.safe());
  // Something else stopped it.
  cell.control.judge(*moment_of(7, true));
  cell.control.judge(*moment_of(8));
  CHECK(browser.post("/api/restart", crossed) == 409);
  CHECK_FALSE(cell.control.safe());

  Cell without(false);
  without.stop_it();
  Browser same(without, "otto");
  CHECK(same.post("/api/restart", {{"stop", 1}}) == 403);
  CHECK_THAT(same.said(), Catch::Contains("The configuration does not allow a restart from the page"));
  CHECK_FALSE(without.control.safe());
}

TEST_CASE("Log-ins: wrong ones are refused, counted and logged, and users who go have no session") {
  WebConfiguration configuration;
  Cell cell(configuration);
  Browser browser(cell);
  CHECK(browser.log_in("otto", "wrong password") == 403);
  CHECK(browser.log_in("nobody", kPassword) == 403);
  CHECK(browser.log_in("", "") == 400);
  CHECK(browser.log_in("otto", std::string(300, 'x')) == 400);
  REQUIRE(browser.log_in("otto", kPassword) == 200);
  CHECK(browser.get("/api/status")->status == 200);
  REQUIRE(cell.log->flush(kLong));
  const auto events = cell.log->entries(1'000'000, 100);
  CHECK(std::ranges::count_if(events, [](const auto& e) { return e.json["kind"] == "login_refused"; }) == 2);
  for (const auto& event : events) CHECK_FALSE(Catch::contains(event.json.dump(), kPassword));
  REQUIRE(monitor::remove_user(cell.box / "users", "otto"));
  CHECK(eventually([&] { return browser.get("/api/status")->status == 401; }));
  // A file that others may read is none.
  REQUIRE(::chmod((cell.box / "users").c_str(), 0644) == 0);
  CHECK(eventually([&] { return browser.log_in("vera", kPassword) == 403; }));

  Sandbox box;
  const fs::path users = box.write("users", users_text());
  REQUIRE(::chmod(users.c_str(), 0600) == 0);
  WebConfiguration limited;
  limited.port = 0;
  limited.users = users;
  limited.login_failures_per_min = 3;
  FakeControl control;
  const monitor::Web web(limited, {.control = &control, .log = nullptr, .metrics = {}});
  httplib::Client client("127.0.0.1", web.port());
  const auto status = [&](const std::string& password) {
    return client.Post("/api/login", Json{{"name", "vera"}, {"password", password}}.dump(), "application/json")->status;
  };
  for (int i = 0; i < 3; ++i) CHECK(status("wrong password") == 403);
  CHECK(status(kPassword) == 429);
}

TEST_CASE("Configurations that would not be safe are refused") {
  FakeControl control;
  const auto listen = [&](WebConfiguration configuration) {
    configuration.port = 0;
    const monitor::Web web(configuration, {.control = &control, .log = nullptr, .metrics = {}});
  };
  WebConfiguration everywhere;
  everywhere.address = "0.0.0.0";
  CHECK_THROWS_WITH(listen(everywhere), Catch::Contains("without users"));
  Sandbox box;
  const fs::path users = box.write("users", users_text());
  REQUIRE(::chmod(users.c_str(), 0600) == 0);
  everywhere.users = users;
  CHECK_THROWS_WITH(listen(everywhere), Catch::Contains("without TLS"));
  everywhere.without_tls = true;
  CHECK_NOTHROW(listen(everywhere));
  WebConfiguration half;
  half.certificate = "x.pem";
  CHECK_THROWS_WITH(listen(half), Catch::Contains("belong together"));
  half.key = "y.pem";
  CHECK_THROWS_AS(listen(half), FileError);
  WebConfiguration bad;
  REQUIRE(::chmod(users.c_str(), 0604) == 0);
  bad.users = users;
  CHECK_THROWS_WITH(listen(bad), Catch::Contains("others may read it"));
  const fs::path broken = box.write("broken", "otto captain $argon2id$x\n");
  REQUIRE(::chmod(broken.c_str(), 0600) == 0);
  bad.users = broken;
  CHECK_THROWS_WITH(listen(bad), Catch::Contains("line 1") && Catch::Contains("'captain' is no role"));
}

TEST_CASE("Paths that climb, names of others and odd requests are refused, and nothing else is read") {
  WebConfiguration configuration;
  configuration.look_without_login = true;
  configuration.host_names = {"press3.example", "Press4.example"};
  Cell cell(configuration);
  cell.stop_it();
  REQUIRE(cell.log->flush(kLong));
  Browser browser(cell);
  const int port = cell.web->port();
  const auto stops = browser.json("/api/log")["events"];
  std::string event;
  for (const Json& entry : stops) {
    if (entry["kind"] == "stop") event = std::to_string(entry["number"].get<int>());
  }
  REQUIRE_FALSE(event.empty());
  const auto pictures = browser.json("/api/log/" + event)["pictures"];
  REQUIRE_FALSE(pictures.empty());
  const std::string picture = "/api/log/" + event + "/" + pictures[0].get<std::string>();
  CHECK(decode_image(
            [&] {
              const std::string body = browser.get(picture)->body;
              return std::vector<std::uint8_t>(body.begin(), body.end());
            }(),
            "picture")
            .width > 0);
  for (const std::string& target :
       {std::string("/../users"), std::string("/api/log/../../users"), "/api/log/" + event + "/../../lock",
        "/api/log/" + event + "/%2e%2e/lock", "/api/log/" + event + "/..%2f..%2flock", std::string("//etc/passwd"),
        std::string("/etc/passwd"), "/api/log/" + event + "/lock", std::string("/api/log/-1"),
        std::string("/api/log/99999999999999999999"), std::string("/api/log?before=x"),
        std::string("/api/log?before=-5"), std::string("/page.js/.."), std::string("http://127.0.0.1/"),
        std::string("/\\..\\users"), std::string("/api/status%00")}) {
    CAPTURE(target);
    const std::string answer = get_raw(port, target);
    CHECK(status_in(answer) >= 400);
    CHECK(status_in(answer) < 500);
    CHECK_FALSE(Catch::contains(answer, "argon2id"));
    CHECK_FALSE(Catch::contains(answer, "root:"));
  }
  const std::string headed = get_raw(port, "/");
  for (const char* header : {"Content-Security-Policy: default-src 'none'", "X-Content-Type-Options: nosniff",
                             "frame-ancestors 'none'", "X-Frame-Options: DENY", "Cache-Control: no-store"}) {
    CHECK_THAT(headed, Catch::Contains(header));
  }
  CHECK_FALSE(Catch::contains(headed, "unsafe-inline"));
  CHECK_FALSE(Catch::contains(headed, " style="));
  CHECK_FALSE(Catch::contains(headed, "http://"));  // nothing from elsewhere

  const std::string host = "Host: 127.0.0.1\r\n";
  const auto status_by = [&](const std::string& name) {
    return status_in(raw(port, "GET / HTTP/1.1\r\nHost: " + name + "\r\nConnection: close\r\n\r\n"));
  };
  for (const char* name : {"press3.example", "press3.example:8443", "PRESS3.example", "press4.example"}) {
    CHECK(status_by(name) == 200);
  }
  for (const char* name : {"evil.example", "press3.example.evil.example", "3.example"}) CHECK(status_by(name) == 421);
  CHECK(status_in(raw(port, "GET / HTTP/1.1\r\n\r\n")) == 400);
  CHECK(status_in(raw(port, "GET / HTTP/1.1\r\n" + host + host + "\r\n")) == 400);
  CHECK(status_in(raw(port, "PUT / HTTP/1.1\r\n" + host + "\r\n")) == 405);
  CHECK(status_in(raw(port, "GET / HTTP/9.9\r\n" + host + "\r\n")) == 505);
  CHECK(status_in(raw(port, "GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n")) == 400);
  CHECK(status_in(raw(port, "GET / HTTP/1.1\r\n" + host + "Range: bytes=0-1" + std::string(3000, ',') + "\r\n\r\n")) ==
        400);
  CHECK(status_in(raw(port, "POST /api/login HTTP/1.1\r\n" + host + "\r\n")) == 411);
  CHECK(status_in(raw(port, "POST /api/login HTTP/1.1\r\n" + host + "Content-Length: 99999999\r\n\r\n")) == 413);
  CHECK(status_in(raw(port, "POST /api/login HTTP/1.1\r\n" + host +
                                "Content-Type: text/plain\r\nContent-Length: 2\r\n\r\n{}")) == 415);
  CHECK(status_in(raw(port, "GET /" + std::string(1000, 'a') + " HTTP/1.1\r\n" + host + "\r\n")) == 414);
  CHECK(status_in(raw(port, "GET / HTTP/1.1\r\n" + host + "A: " + std::string(9000, 'a') + "\r\n\r\n")) == 431);
  std::string many = "GET / HTTP/1.1\r\n" + host;
  for (int i = 0; i < 200; ++i) many += "A: b\r\n";
  CHECK(status_in(raw(port, many + "\r\n")) == 431);
  // Not even a hundred megabytes without an end.
  std::string endless = "GET / HTTP/1.1\r\n";
  endless.resize(100'000'000, 'x');
  CHECK(status_in(raw(port, endless)) == 431);
  // A refused request does not bring a second one in its body.
  const std::string smuggled = raw(port, "POST /nothing HTTP/1.1\r\n" + host +
                                             "Content-Length: 40\r\n\r\nGET /api/session HTTP/1.1\r\n" + host + "\r\n");
  CHECK_FALSE(Catch::contains(smuggled, "may_look"));
  CHECK(browser.get("/api/status")->status == 200);
}

TEST_CASE("Requests of noise change nothing and stop nothing") {
  WebConfiguration configuration = Cell::allowing(true);
  configuration.look_without_login = true;
  Cell cell(configuration);
  cell.stop_it();
  const char* const given = std::getenv("HOROPTER_REQUESTS");
  const int requests = given != nullptr ? std::atoi(given) : 3000;
  const auto seed = std::random_device{}();
  std::mt19937 random(seed);
  CAPTURE(seed);
  const auto before = cell.control.asked().size();
  const std::vector<std::string> parts{"GET ",
                                       "POST ",
                                       "/",
                                       "/api/",
                                       "restart",
                                       "teach",
                                       "login",
                                       "log/",
                                       "1/",
                                       "..",
                                       "%2e",
                                       "%00",
                                       " HTTP/1.1\r\n",
                                       "\r\n",
                                       "\n",
                                       "Host: ",
                                       "127.0.0.1",
                                       "Content-Length: ",
                                       "18446744073709551616",
                                       "2",
                                       "-1",
                                       "Cookie: horopter=",
                                       "Origin: ",
                                       "Content-Type: application/json\r\n",
                                       "{}",
                                       "{\"stop\":1}",
                                       "{\"name\":\"otto\",\"password\":\"",
                                       "[[[[[[",
                                       "\xff\xfe",
                                       "X-Horopter-Token: ",
                                       "?before=",
                                       "&",
                                       ";",
                                       ":",
                                       std::string(300, 'a'),
                                       std::string("\0", 1),
                                       "Range: bytes=0-",
                                       "Transfer-Encoding: chunked\r\n",
                                       "Expect: 100-continue\r\n",
                                       "Connection: keep-alive\r\n",
                                       "\r\n\r\n"};
  const std::vector<std::string> whole{
      "GET /api/status HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
      "GET /api/log?before=7 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
      "POST /api/restart HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\nContent-Length: 10\r\n\r\n{\"stop\":1}",
      "GET /api/log/2/frame-00000002-left.png HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"};
  int answered = 0;
  for (int i = 0; i < requests; ++i) {
    std::string bytes;
    if (i % 2 == 0) {
      for (auto count = random() % 25; count > 0; --count) bytes += parts[random() % parts.size()];
    } else {
      bytes = whole[random() % whole.size()];
      for (auto count = random() % 6; count > 0; --count) bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    const std::string answer = raw(cell.web->port(), bytes);
    answered += answer.starts_with("HTTP/1.1 ") ? 1 : 0;
    const bool broken = Catch::contains(answer, "HTTP/1.1 5") && !Catch::contains(answer, "HTTP/1.1 505");
    if (broken) FAIL("answer of 5xx to " << bytes << ": " << answer);
  }
  CHECK(answered > requests / 10);
  CHECK(cell.control.asked().size() == before);
  CHECK_FALSE(cell.control.safe());
  Browser browser(cell);
  CHECK(browser.get("/api/status")->status == 200);
  REQUIRE(cell.log->flush(kLong));
}

TEST_CASE("Fifty slow clients do not slow the decision, and the page is still there") {
  WebConfiguration configuration;
  configuration.look_without_login = true;
  Cell cell(configuration);
  std::vector<int> sockets;
  for (int i = 0; i < 50; ++i) {
    sockets.push_back(connect_to(cell.web->port()));
    REQUIRE(sockets.back() >= 0);
    const std::string begin = "GET /api/picture HTTP/1.1\r\nHo";
    REQUIRE(::send(sockets.back(), begin.data(), begin.size(), MSG_NOSIGNAL) > 0);
  }
  std::atomic<bool> ending = false;
  std::thread drips([&] {
    while (!ending) {
      for (const int socket : sockets) ::send(socket, "x", 1, MSG_NOSIGNAL);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  // The decision is called here: no call of it may wait for any client.
  auto longest = monitor::Clock::duration::zero();
  for (std::uint64_t frame = 1; frame <= 200; ++frame) {
    auto moment = *moment_of(frame, frame % 50 == 0);
    const auto begin = monitor::Clock::now();
    cell.control.judge(std::move(moment));
    longest = std::max(longest, monitor::Clock::now() - begin);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(longest < std::chrono::seconds(2));  // the slow ones hold on for five
  // They are thrown out by and by; then, if not at once, others come in.
  CHECK(eventually([&] {
    httplib::Client client("127.0.0.1", cell.web->port());
    client.set_read_timeout(std::chrono::seconds(2));
    const auto answer = client.Get("/api/status");
    return answer && answer->status == 200;
  }));
  CHECK(eventually([&] {  // every slow one was ended
    return std::ranges::all_of(sockets, [](int socket) {
      char byte = 0;
      const ssize_t got = ::recv(socket, &byte, 1, MSG_DONTWAIT | MSG_PEEK);
      return got == 0 || (got < 0 && errno != EAGAIN && errno != EWOULDBLOCK) || got > 0;
    });
  }));
  ending = true;
  drips.join();
  for (const int socket : sockets) ::close(socket);
}

TEST_CASE("With a certificate the page speaks TLS and nothing else") {
  Sandbox box;
  const auto made = box.run_shell(
      "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=localhost "
      "-keyout key.pem -out cert.pem 2>&1");
  CAPTURE(made.out);
  REQUIRE(made.status == 0);
  WebConfiguration configuration = Cell::allowing(true);
  configuration.certificate = box / "cert.pem";
  configuration.key = box / "key.pem";
  Cell cell(configuration);
  httplib::SSLClient client("127.0.0.1", cell.web->port());
  client.enable_server_certificate_verification(false);
  const auto answer = client.Post("/api/login", {{"Origin", "https://127.0.0.1:" + std::to_string(cell.web->port())}},
                                  Json{{"name", "vera"}, {"password", kPassword}}.dump(), "application/json");
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK_THAT(answer->get_header_value("Set-Cookie"),
             Catch::StartsWith("__Host-horopter=") && Catch::Contains("; Secure"));
  CHECK_FALSE(Catch::contains(get_raw(cell.web->port(), "/"), "HTTP/1.1"));
  for (int i = 0; i < 20; ++i) raw(cell.web->port(), std::string(static_cast<std::size_t>(10 * i), '\x16'));
  CHECK(client.Get("/")->status == 200);
}

TEST_CASE("Users who are changed at the same time: each who was added is there, and none who was removed") {
  Sandbox box;
  const fs::path file = box / "users";
  std::vector<std::thread> threads;
  const auto add = [&](const std::string& name) {
    threads.emplace_back([&file, name] { monitor::set_user(file, name, Role::viewer, kPassword); });
  };
  const auto names = [&] {
    std::vector<std::string> found;
    for (const monitor::User& user : monitor::read_users(file)) found.push_back(user.name);
    std::ranges::sort(found);
    return found;
  };
  const auto join = [&] {
    for (std::thread& thread : threads) thread.join();
    threads.clear();
  };
  for (const char* name : {"a", "b", "c", "d"}) add(name);
  join();
  REQUIRE(names() == std::vector<std::string>{"a", "b", "c", "d"});
  for (const char* name : {"e", "f", "g", "h"}) add(name);
  const bool removed = monitor::remove_user(file, "a");
  join();
  CHECK(removed);
  CHECK(names() == std::vector<std::string>{"b", "c", "d", "e", "f", "g", "h"});
  CHECK(box.files() == std::set<std::string>{"users"});
}

TEST_CASE("A file of users keeps owner, group, mode and links when users change") {
  Sandbox box;
  const fs::path file = box.write("real", users_text());
  fs::create_symlink("real", box / "users");
  if (::geteuid() == 0) REQUIRE(::chown(file.c_str(), 1, 2) == 0);
  REQUIRE(::chmod(file.c_str(), 0640) == 0);
  struct stat before{}, after{};
  REQUIRE(::stat(file.c_str(), &before) == 0);
  monitor::set_user(box / "users", "bert", Role::viewer, kPassword);
  REQUIRE(monitor::remove_user(box / "users", "vera"));
  CHECK(fs::is_symlink(box / "users"));
  REQUIRE(::stat(file.c_str(), &after) == 0);
  CHECK((after.st_mode & 0777) == 0640);
  CHECK(after.st_uid == before.st_uid);
  CHECK(after.st_gid == before.st_gid);
  CHECK(monitor::read_users(file).size() == 3);
}

TEST_CASE("`horopter monitor-user` takes the password from standard input alone") {
  Sandbox box;
  const auto add = box.run_shell("printf 'a long password\\n' | horopter monitor-user users anna operator");
  CAPTURE(add.err);
  CHECK(add.status == 0);
  CHECK(add.out == "users: anna is operator\n");
  const std::string text = box.read("users");
  CHECK_THAT(text, Catch::Contains("anna operator $argon2id$") && !Catch::Contains("long password"));
  struct stat facts{};
  REQUIRE(::stat((box / "users").c_str(), &facts) == 0);
  CHECK((facts.st_mode & 0777) == 0600);
  CHECK(box.run_shell("printf short | horopter monitor-user users bert viewer").status == 2);
  CHECK(box.run_shell("printf 'a long password' | horopter monitor-user users 'b b' viewer").status == 2);
  CHECK(box.run_shell("printf 'a long password' | horopter monitor-user users bert king").status == 2);
  CHECK(box.run_shell("printf 'a long password' | horopter monitor-user users bert").status == 2);
  CHECK(box.run_shell("printf 'another password' | horopter monitor-user users anna engineer").status == 0);
  const auto users = monitor::read_users(box / "users");
  REQUIRE(users.size() == 1);
  CHECK(users[0].role == Role::engineer);
  CHECK(monitor::is_password(&users[0], "another password"));
  CHECK_FALSE(monitor::is_password(&users[0], "a long password"));
  CHECK_FALSE(monitor::is_password(nullptr, "a long password"));
  CHECK(box.run_shell("horopter monitor-user users bert --remove").status == 2);
  const auto both = box.run_shell("horopter monitor-user users anna viewer --remove");
  CHECK(both.status == 2);
  CHECK_THAT(both.err, Catch::Contains("ROLE excludes --remove"));
  CHECK(monitor::read_users(box / "users").size() == 1);
  CHECK(box.run_shell("horopter monitor-user users anna --remove").status == 0);
  CHECK(monitor::read_users(box / "users").empty());
  REQUIRE(::chmod((box / "users").c_str(), 0666) == 0);
  CHECK(box.run_shell("printf 'a long password' | horopter monitor-user users anna viewer").status == 3);
}

TEST_CASE("A signal at the password of `horopter monitor-user` leaves a terminal that shows what is typed") {
  Sandbox box;
  const int program = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  REQUIRE(::grantpt(program) == 0);
  REQUIRE(::unlockpt(program) == 0);
  std::array<char, 256> name{};
  REQUIRE(::ptsname_r(program, name.data(), name.size()) == 0);
  const int terminal = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  const auto shows = [&] {
    termios settings{};
    return ::tcgetattr(terminal, &settings) == 0 && (settings.c_lflag & ECHO) != 0;
  };
  REQUIRE(shows());
  const auto [signal, status] = GENERATE(table<int, int>({{SIGINT, 130}, {SIGTERM, 143}}));
  Running user(
      box,
      {"/bin/sh", "-c", fmt::format("exec '{}' monitor-user users anna viewer <{}", HOROPTER_PROGRAM, name.data())},
      "monitor-user");
  CHECK(eventually([&] { return !shows(); }));
  CHECK(user.end(signal) == status);
  CHECK(shows());
  CHECK_FALSE(fs::exists(box / "users"));
  ::close(terminal);
  ::close(program);
}
