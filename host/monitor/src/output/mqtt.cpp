// SPDX-License-Identifier: Apache-2.0
#include "output/mqtt.hpp"

#include <fmt/format.h>
#include <mosquitto.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/calib/text_file.hpp"
#include "output/lines.hpp"
#include "output/ticker.hpp"

namespace horopter::monitor {
namespace {

constexpr int kKeepAlive_s = 5;  ///< the shortest that libmosquitto takes
// QoS.
constexpr int kAtMostOnce = 0;
constexpr int kOnce = 1;  ///< at least once: after an outage libmosquitto says it again, however old it is
/// Though nothing changes, the state is said again that often.
constexpr auto kAgain = std::chrono::seconds(1);
/// A broker that takes nothing for so long hangs. It is said something once a second.
constexpr auto kAnswer = std::chrono::seconds(2);
/// And what it does not take must not fill the memory.
constexpr int kMostUnanswered = 100;
/// At the end, for the last message.
constexpr auto kLastWait = std::chrono::milliseconds(500);
constexpr const char* kStopped = "stopped";

struct Destroy {
  void operator()(mosquitto* client) const { mosquitto_destroy(client); }
};

/// The first line of a file.
std::string password_of(const std::filesystem::path& file) {
  std::string text = calib::read_text(file, "a password in the first line");
  text.resize(std::min(text.find_first_of("\r\n"), text.size()));
  if (text.empty()) throw FileError(file.string(), "", "no password", "one in the first line");
  return text;
}

class MqttPart : public Part {
 public:
  MqttPart(const MqttCell& mqtt, const Cell& cell, const SafeState& state, const Control& control)
      : mqtt_(mqtt),
        cell_(cell),
        control_(control),
        state_topic_(mqtt.topic + "/state"),
        event_topic_(mqtt.topic + "/event") {
    static std::once_flag once;
    std::call_once(once, [] { mosquitto_lib_init(); });
    client_.reset(mosquitto_new(mqtt.client_id.empty() ? nullptr : mqtt.client_id.c_str(), true, this));
    if (client_ == nullptr) fail("this client_id is not possible");
    set_up();
    const std::string gone =
        json_line(nlohmann::ordered_json{{"cell", cell.name}, {"safe", false}, {"reason", "the monitor is gone"}});
    check(mosquitto_will_set(client_.get(), state_topic_.c_str(), static_cast<int>(gone.size()), gone.data(), kOnce,
                             true));
    mosquitto_connect_callback_set(client_.get(), [](mosquitto*, void* self, int code) {
      static_cast<MqttPart*>(self)->answered();
      static_cast<MqttPart*>(self)->waiting_ = 0;  // of the connection before
      static_cast<MqttPart*>(self)->connected_ = code == 0;
      static_cast<MqttPart*>(self)->changed_ = true;
    });
    mosquitto_disconnect_callback_set(
        client_.get(), [](mosquitto*, void* self, int) { static_cast<MqttPart*>(self)->connected_ = false; });
    mosquitto_reconnect_delay_set(client_.get(), 1, 5, false);
    mosquitto_connect_async(client_.get(), mqtt.host.c_str(), mqtt.port, kKeepAlive_s);  // or it is tried again
    check(mosquitto_loop_start(client_.get()));
    ticker_.emplace(state, [this](const Signal& signal) { look(signal); });
  }
  ~MqttPart() override {
    ticker_->stop();
    say_state(false, "the monitor has ended");
    const auto until = Clock::now() + kLastWait;
    const auto wait_while = [&](auto condition) {
      while (connected_ && condition() && Clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    };
    wait_while([&] { return waiting_ > 0; });
    mosquitto_disconnect(client_.get());
    wait_while([] { return true; });  // its thread sends it: who stopped it at once would leave the last will instead
    mosquitto_loop_stop(client_.get(), true);
  }
  MqttPart(const MqttPart&) = delete;
  MqttPart& operator=(const MqttPart&) = delete;

  [[nodiscard]] std::string trouble() const override {
    if (!connected_) return fmt::format("no connection to the MQTT broker {}:{}", mqtt_.host, mqtt_.port);
    const bool hangs = waiting_ > 0 && Clock::now() - Clock::time_point(Clock::duration(answered_)) > kAnswer;
    return hangs ? fmt::format("the MQTT broker {}:{} does not answer", mqtt_.host, mqtt_.port) : "";
  }
  void stopped(const Status& status, const MomentPtr& /*moment*/) override { event(kStopped, status, {}, ""); }
  void released(const Status& status, const Actor& by) override { event("released", status, by, ""); }
  void noted(const Status& status, const Actor& actor, const std::string& what) override {
    event("noted", status, actor, what);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw FileError(cell_.path.string(), "outputs.mqtt", why, "what the broker needs");
  }
  void check(int code) const {
    if (code != MOSQ_ERR_SUCCESS) fail(mosquitto_strerror(code));
  }

  void set_up() {
    mosquitto* client = client_.get();
    if (!mqtt_.user.empty()) {
      check(mosquitto_username_pw_set(client, mqtt_.user.c_str(), password_of(mqtt_.password_file).c_str()));
    }
    if (!mqtt_.ca_file.empty()) {
      const bool own = !mqtt_.certificate_file.empty();
      check(mosquitto_tls_set(client, mqtt_.ca_file.c_str(), nullptr, own ? mqtt_.certificate_file.c_str() : nullptr,
                              own ? mqtt_.key_file.c_str() : nullptr, nullptr));
    }
    mosquitto_unsubscribe_callback_set(client, [](mosquitto*, void* self, int) {
      static_cast<MqttPart*>(self)->answered();
      --static_cast<MqttPart*>(self)->waiting_;
    });
  }

  void answered() { answered_ = Clock::now().time_since_epoch().count(); }

  /// False: it was dropped.
  bool publish(const std::string& topic, const std::string& text, int qos, bool retain) {
    if (!connected_ || waiting_ >= kMostUnanswered) return false;
    const int code = mosquitto_publish(client_.get(), nullptr, topic.c_str(), static_cast<int>(text.size()),
                                       text.data(), qos, retain);
    // A question behind it, which every broker answers and nobody else hears: it gives up what it never had.
    if (waiting_ == 0) answered();  // before, it was asked nothing
    ++waiting_;
    if (mosquitto_unsubscribe(client_.get(), nullptr, state_topic_.c_str()) != MOSQ_ERR_SUCCESS) --waiting_;
    return code == MOSQ_ERR_SUCCESS;
  }

  bool publish_event(const std::string& text) { return publish(event_topic_, text, kOnce, false); }

  /// With the mutex, before whatever else is said.
  void say_missed_stop() {
    if (!missed_stop_.empty() && publish_event(missed_stop_)) missed_stop_.clear();
  }

  void look(const Signal& signal) {
    const auto now = Clock::now();
    const bool changed = changed_.exchange(false) || signal.safe != said_safe_;
    if (!changed && now - said_at_ < kAgain) return;
    said_safe_ = signal.safe;
    said_at_ = now;
    say_state(signal.safe, "");
  }

  /// `safe` as the outputs say it now, which may be less than the last decision.
  void say_state(bool safe, const std::string& reason) {
    auto json = status_json(control_.status(), cell_);
    json["safe"] = safe;
    if (!reason.empty()) json["reason"] = reason;
    const std::lock_guard lock(mutex_);
    say_missed_stop();
    publish(state_topic_, json_line(json), kAtMostOnce, true);
  }

  void event(const std::string& name, const Status& status, const Actor& actor, const std::string& what) {
    const std::string text = json_line(event_json(name, status, cell_, actor, what));
    {
      const std::lock_guard lock(mutex_);
      say_missed_stop();
      if (!publish_event(text) && name == kStopped) missed_stop_ = text;
    }
    changed_ = true;
  }

  MqttCell mqtt_;
  const Cell& cell_;
  const Control& control_;
  std::string state_topic_, event_topic_;
  std::unique_ptr<mosquitto, Destroy> client_;
  std::atomic<bool> connected_ = false, changed_ = true;
  std::atomic<int> waiting_ = 0;          ///< questions without an answer
  std::atomic<Clock::rep> answered_ = 0;  ///< at this time
  std::mutex mutex_;                      ///< of the order in which it is said
  std::string missed_stop_;               ///< the last one that was dropped, as where the broker's absence is its cause
  bool said_safe_ = false;                // of the ticker's thread
  Clock::time_point said_at_{};
  std::optional<Ticker> ticker_;
};

}  // namespace

std::unique_ptr<Part> make_mqtt(const MqttCell& mqtt, const Cell& cell, const SafeState& state,
                                const Control& control) {
  return std::make_unique<MqttPart>(mqtt, cell, state, control);
}

}  // namespace horopter::monitor
