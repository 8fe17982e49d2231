// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/web.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

#include "access.hpp"
#include "answers.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/monitor/users.hpp"
#include "log/durable.hpp"
#include "page_files.hpp"
#include "server.hpp"

namespace horopter::monitor {
namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* kJson = "application/json";
constexpr const char* kTokenHeader = "X-Horopter-Token";
constexpr const char* kExpectsStop = "Expected the number of the stop that was seen.";
constexpr std::size_t kLogPage = 50;
constexpr double kNotesPerMin = 20;   // of what was refused
constexpr double kLoginsPerMin = 60;  // of all addresses
constexpr auto kIdleSession = std::chrono::hours(2);

bool is_loopback(const std::string& address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

bool is_address(const std::string& host) {
  in_addr v4{};
  in6_addr v6{};
  return ::inet_pton(AF_INET, host.c_str(), &v4) == 1 || ::inet_pton(AF_INET6, host.c_str(), &v6) == 1;
}

/// Of `host:port`, `[v6]:port`.
std::string host_in(const std::string& authority) {
  if (authority.starts_with('[')) return authority.substr(1, authority.find(']') - 1);
  return authority.substr(0, authority.rfind(':'));
}

bool is_same_name(const std::string& one, const std::string& another) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(one, another, {}, lower, lower);
}

WebConfiguration check(WebConfiguration configuration) {
  const bool here = is_loopback(configuration.address);
  const bool tls = !configuration.certificate.empty();
  const auto refuse = [](const std::string& why) { throw UsageError("the page: " + why); };
  if (configuration.certificate.empty() != configuration.key.empty()) {
    refuse("a certificate and its key belong together");
  }
  if (!here && configuration.users.empty()) {
    refuse(fmt::format("it would listen on {} without users; expected a file of users, or 127.0.0.1",
                       configuration.address));
  }
  if (!here && !tls && !configuration.without_tls) {
    refuse(fmt::format(
        "it would listen on {} without TLS, passwords readable on the way; expected `tls` with a certificate "
        "and its key, or 127.0.0.1",
        configuration.address));
  }
  if (configuration.port < 0 || configuration.port > 65535) refuse("its port is not 0 to 65535");
  if (!(configuration.decision_limit_ms > 0) || !(configuration.pictures_per_s > 0) || !(configuration.session_h > 0)) {
    refuse("its limits of time must be above 0");
  }
  begin_sodium();
  return configuration;
}

httplib::Headers headers_of_all() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
           "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
          {"X-Content-Type-Options", "nosniff"},
          {"X-Frame-Options", "DENY"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Permissions-Policy", "camera=(), microphone=(), geolocation=()"},
          {"Cache-Control", "no-store"}};
}

void answer(Response& response, int status, const Json& json) {
  response.status = status;
  response.set_content(json_line(json), kJson);
}

void refuse(Response& response, int status, const std::string& why) { answer(response, status, {{"error", why}}); }

std::string cookie_in(const Request& request, const std::string& name) {
  const std::string text = request.get_header_value("Cookie");
  std::size_t begin = 0;
  while (begin < text.size()) {
    const auto end = std::min(text.find(';', begin), text.size());
    std::string part = text.substr(begin, end - begin);
    part.erase(0, part.find_first_not_of(' '));
    if (part.starts_with(name + "=")) return part.substr(name.size() + 1);
    begin = end + 1;
  }
  return {};
}

std::optional<std::int64_t> whole(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc{} || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

std::optional<std::int64_t> whole(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_integer()) return std::nullopt;
  const auto number = found->get<std::int64_t>();
  return number < 0 ? std::nullopt : std::optional(number);
}

/// Who asks.
struct Visitor {
  std::string token;
  std::optional<Session> session;
  std::optional<User> user;
  bool may_look = false;

  [[nodiscard]] bool has(Role role) const { return user && user->role >= role; }
};

}  // namespace

class Web::Site {
 public:
  Site(WebConfiguration configuration, Sources sources)
      : configuration_(check(std::move(configuration))),
        sources_(std::move(sources)),
        users_(configuration_.users),
        sessions_(std::chrono::duration_cast<Clock::duration>(
                      std::chrono::duration<double, std::ratio<3600>>(configuration_.session_h)),
                  kIdleSession),
        requests_(configuration_.requests_per_s, 3 * configuration_.requests_per_s),
        failures_(configuration_.login_failures_per_min / 60, configuration_.login_failures_per_min),
        picture_(configuration_.pictures_per_s),
        server_(ServerLimits{}, configuration_.certificate, configuration_.key) {
    if (sources_.control == nullptr) throw std::invalid_argument("Web: without a control");
    set_up();
    const bool bound = configuration_.port == 0
                           ? (port_ = server_.bind_to_any_port(configuration_.address)) > 0
                           : server_.bind_to_port(configuration_.address, port_ = configuration_.port);
    if (!bound) {
      throw UsageError(
          fmt::format("the page cannot listen on {}, port {}; expected an address of this computer, and a "
                      "port that is free",
                      configuration_.address, configuration_.port));
    }
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::yield();
  }

  ~Site() {
    server_.stop_all();
    thread_.join();
  }
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  [[nodiscard]] int port() const { return port_; }

 private:
  enum class Needs { nothing, look };
  using Handler = std::function<void(const Request&, Response&, const Visitor&)>;

  void set_up() {
    server_.set_default_headers(headers_of_all());
    server_.set_payload_max_length(ServerLimits{}.body_bytes);
    server_.set_keep_alive_max_count(1'000'000'000);
    server_.set_tcp_nodelay(true);
    // Nothing of what went wrong inside is for visitors.
    server_.set_exception_handler([](const Request&, Response& response, const std::exception_ptr&) {
      GuardedServer::close_after_answer(response);
      refuse(response, 500, "This went wrong inside the monitor.");
    });
    server_.set_error_handler([](const Request&, Response& response) {
      if (!response.body.empty()) return;  // of a handler, which had the whole request
      GuardedServer::close_after_answer(response);
      refuse(response, response.status, "There is nothing here.");
    });
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (is_let_in(request, response)) return httplib::Server::HandlerResponse::Unhandled;
      GuardedServer::close_after_answer(response);  // with what it may still be sending
      return httplib::Server::HandlerResponse::Handled;
    });

    page("/", page::kHtml, "text/html; charset=utf-8");
    page("/page.css", page::kCss, "text/css; charset=utf-8");
    page("/page.js", page::kJs, "text/javascript; charset=utf-8");
    page("/icon.svg", page::kIcon, "image/svg+xml");
    get("/api/session", Needs::nothing,
        [this](const Request&, Response& response, const Visitor& visitor) { tell_session(response, visitor); });
    get("/api/status", Needs::look,
        [this](const Request&, Response& response, const Visitor&) { tell_status(response); });
    get("/api/picture", Needs::look,
        [this](const Request&, Response& response, const Visitor&) { show_picture(response); });
    get("/api/log", Needs::look,
        [this](const Request& request, Response& response, const Visitor&) { list_log(request, response); });
    get(R"(/api/log/(\d{1,12}))", Needs::look,
        [this](const Request& request, Response& response, const Visitor&) { show_entry(request, response); });
    get(R"(/api/log/(\d{1,12})/([a-z0-9.-]{1,64}))", Needs::look,
        [this](const Request& request, Response& response, const Visitor&) { show_log_picture(request, response); });
    if (sources_.metrics) {
      get("/metrics", Needs::look, [this](const Request&, Response& response, const Visitor&) {
        response.set_content(sources_.metrics(), "text/plain; version=0.0.4; charset=utf-8");
      });
    }
    server_.Post("/api/login", [this](const Request& request, Response& response) { log_in(request, response); });
    change("/api/logout", Role::viewer, [this](const Json&, Response& response, const Visitor& visitor, const Actor&) {
      sessions_.end(visitor.token);
      response.set_header("Set-Cookie", cookie("", 0));
      answer(response, 200, {{"done", true}});
    });
    change("/api/restart", Role::plant_operator,
           [this](const Json& json, Response& response, const Visitor&, const Actor& actor) {
             restart(json, response, actor);
           });
    change("/api/teach", Role::engineer,
           [this](const Json& json, Response& response, const Visitor&, const Actor& actor) {
             teach(json, response, actor);
           });
  }

  void page(const std::string& path, std::string_view text, const char* type) {
    server_.Get(path, [text, type](const Request&, Response& response) {
      response.set_content(text.data(), text.size(), type);
    });
  }

  void get(const std::string& path, Needs needs, Handler handler) {
    server_.Get(path, [this, needs, handler = std::move(handler)](const Request& request, Response& response) {
      const Visitor visitor = visitor_of(request);
      if (needs == Needs::look && !visitor.may_look) return refuse(response, 401, "Log in first.");
      handler(request, response, visitor);
    });
  }

  /// A change of state: session, token, role.
  void change(const std::string& path, Role role,
              std::function<void(const Json&, Response&, const Visitor&, const Actor&)> handler) {
    server_.Post(path, [this, path, role, handler = std::move(handler)](const Request& request, Response& response) {
      const Visitor visitor = visitor_of(request);
      if (!visitor.user) return refuse(response, 401, "Log in first.");
      const Actor actor{.name = visitor.user->name, .address = request.remote_addr};
      if (!same_secret(request.get_header_value(kTokenHeader), visitor.session->request)) {
        note_refused("refused", actor, fmt::format("{}: refused, the request had no valid token.", path));
        return refuse(response, 403, "The request has no valid token.");
      }
      if (!visitor.has(role)) {
        note_refused("refused", actor,
                     fmt::format("{}: refused, the role {} may not.", path, name_of(visitor.user->role)));
        return refuse(
            response, 403,
            fmt::format("The role {} may not do this. Ask an {}.", name_of(visitor.user->role), name_of(role)));
      }
      const Json json = Json::parse(request.body, nullptr, false);
      if (!json.is_object()) return refuse(response, 400, "The request is no JSON object.");
      handler(json, response, visitor, actor);
    });
  }

  /// Before anything is looked up: the right host, the right origin, not too many.
  bool is_let_in(const Request& request, Response& response) {
    if (!requests_.allows(request.remote_addr)) {
      response.set_header("Retry-After", "2");
      refuse(response, 429, "Too many requests.");
      return false;
    }
    const std::string authority = request.get_header_value("Host");
    const std::string host = host_in(authority);
    const bool is_known = std::ranges::any_of(configuration_.host_names,
                                              [&](const std::string& name) { return is_same_name(name, host); });
    if (host != "localhost" && !is_address(host) && !is_known) {
      refuse(response, 421, "The page is not known by this name.");
      return false;
    }
    if (request.method == "GET") return true;
    const std::string site = request.get_header_value("Sec-Fetch-Site");
    const std::string origin = request.get_header_value("Origin");
    const std::string own = (configuration_.certificate.empty() ? "http://" : "https://") + authority;
    const bool foreign = request.get_header_value_count("Origin") > 1 ||
                         (request.has_header("Origin") && origin != own) || (!site.empty() && site != "same-origin");
    if (foreign) {
      note_refused("refused", {.name = "", .address = request.remote_addr},
                   fmt::format("{}: refused, it came from another page.", request.path));
      refuse(response, 403, "The request comes from another page.");
      return false;
    }
    if (request.get_header_value("Content-Type") != kJson) {
      refuse(response, 415, "Expected application/json.");
      return false;
    }
    return true;
  }

  std::string cookie_name() const { return configuration_.certificate.empty() ? "horopter" : "__Host-horopter"; }

  std::string cookie(const std::string& token, std::int64_t seconds) const {
    return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age={}{}", cookie_name(), token, seconds,
                       configuration_.certificate.empty() ? "" : "; Secure");
  }

  Visitor visitor_of(const Request& request) {
    Visitor visitor;
    visitor.token = cookie_in(request, cookie_name());
    visitor.session = sessions_.find(visitor.token);
    if (visitor.session) {
      // A user who was removed, or has another password, has no session any more.
      visitor.user = users_.find(visitor.session->user);
      if (visitor.user && visitor.user->hash != visitor.session->hash) visitor.user.reset();
      if (!visitor.user) {
        sessions_.end(visitor.token);
        visitor.session.reset();
      }
    }
    visitor.may_look = visitor.user.has_value() || configuration_.look_without_login || !users_.possible();
    return visitor;
  }

  void tell_session(Response& response, const Visitor& visitor) {
    Json json{{"title", configuration_.title},
              {"may_look", visitor.may_look},
              {"login_possible", users_.possible()},
              {"user", nullptr},
              {"role", nullptr},
              {"token", nullptr},
              {"may_restart", visitor.has(Role::plant_operator) && configuration_.restart_allowed},
              {"may_teach", visitor.has(Role::engineer)},
              {"restart_allowed", configuration_.restart_allowed},
              {"teach_allowed", configuration_.teach_allowed},
              {"teach_frames", configuration_.teach_frames}};
    if (visitor.user) {
      json["user"] = visitor.user->name;
      json["role"] = name_of(visitor.user->role);
      json["token"] = visitor.session->request;
    }
    answer(response, 200, json);
  }

  void log_in(const Request& request, Response& response) {
    const Json json = Json::parse(request.body, nullptr, false);
    const std::string name = json.is_object() ? text_in(json, "name") : "";
    const std::string password = json.is_object() ? text_in(json, "password") : "";
    if (name.empty() || name.size() > 64 || password.empty() || password.size() > kLongestPassword) {
      return refuse(response, 400, "Expected a name and a password.");
    }
    // Each try takes time and memory: few in all, one at a time.
    if (!failures_.allows(request.remote_addr) || !tries_.allows("")) {
      response.set_header("Retry-After", "60");
      note_refused("login_refused", {.name = name, .address = request.remote_addr}, "Log-in refused: too many tries.");
      return refuse(response, 429, "Too many tries. Wait a minute.");
    }
    const auto user = users_.find(name);
    bool fits = false;
    {
      const std::lock_guard one(hashing_);
      fits = is_password(user ? &*user : nullptr, password);
    }
    if (!fits) {
      note_refused("login_refused", {.name = name, .address = request.remote_addr},
                   "Log-in refused: name or password is wrong.");
      return refuse(response, 403, "Name or password is wrong.");
    }
    failures_.give_back(request.remote_addr);
    const std::string token = sessions_.begin(*user);
    response.set_header("Set-Cookie",
                        cookie(token, static_cast<std::int64_t>(std::lround(configuration_.session_h * 3600))));
    if (sources_.log != nullptr) {
      sources_.log->note("login", {.name = name, .address = request.remote_addr},
                         fmt::format("Logged in as {}.", name_of(user->role)));
    }
    answer(response, 200, {{"done", true}});
  }

  void restart(const Json& json, Response& response, const Actor& actor) {
    if (!configuration_.restart_allowed) {
      note_refused("refused", actor, "Restart refused: the configuration does not allow it from the page.");
      return refuse(response, 403,
                    "The configuration does not allow a restart from the page (`web`: `restart: true`).");
    }
    const auto seen = whole(json, "stop");
    if (!seen) return refuse(response, 400, kExpectsStop);
    std::string why;
    if (!sources_.control->restart(actor, static_cast<std::uint64_t>(*seen), why)) return refuse(response, 409, why);
    answer(response, 200, {{"done", true}});
  }

  void teach(const Json& json, Response& response, const Actor& actor) {
    const auto frames = whole(json, "frames");
    if (!frames || !std::in_range<int>(*frames)) return refuse(response, 400, "Expected a number of frames.");
    const auto seen = whole(json, "stop");
    if (!seen) return refuse(response, 400, kExpectsStop);
    std::string why;
    if (!sources_.control->teach(static_cast<int>(*frames), actor, static_cast<std::uint64_t>(*seen), why)) {
      return refuse(response, 409, why);
    }
    answer(response, 200, {{"done", true}});
  }

  static std::optional<double> age_of(const MomentPtr& latest) {
    if (!latest) return std::nullopt;
    return std::chrono::duration<double, std::milli>(Clock::now() - latest->arrived).count();
  }

  void tell_status(Response& response) {
    const Status status = sources_.control->status();
    const MomentPtr latest = sources_.control->latest();
    Json json = status_json(status, age_of(latest), configuration_.decision_limit_ms);
    json["stop"] = status.stops;
    json["log"] = nullptr;
    if (sources_.log != nullptr) {
      const auto trouble = sources_.log->trouble();
      const auto newest = sources_.log->entries(std::numeric_limits<std::int64_t>::max(), 1);
      json["log"] = {{"newest", newest.empty() ? 0 : newest.front().number},
                     {"trouble", trouble ? Json{{"text", trouble->text}, {"advice", trouble->advice}} : Json(nullptr)}};
    }
    json["users_trouble"] = !users_.problem().empty();
    answer(response, 200, json);
  }

  void show_picture(Response& response) {
    const auto made = picture_.get(sources_.control->latest());
    if (!made || made->jpeg.empty()) return refuse(response, 404, "There is no picture yet.");
    response.set_header("X-Horopter-Frame", std::to_string(made->frame));
    response.set_header(
        "X-Horopter-Age-Ms",
        fmt::format("{:.0f}", std::chrono::duration<double, std::milli>(Clock::now() - made->arrived).count()));
    response.set_content(made->jpeg, "image/jpeg");
  }

  void list_log(const Request& request, Response& response) {
    auto before = std::numeric_limits<std::int64_t>::max();
    if (request.has_param("before")) {
      const auto given = whole(request.get_param_value("before"));
      if (!given) return refuse(response, 400, "Expected the number of an event.");
      before = *given;
    }
    Json events = Json::array();
    if (sources_.log != nullptr) {
      for (const LogEntry& entry : sources_.log->entries(before, kLogPage)) events.push_back(entry_json(entry));
    }
    answer(response, 200, {{"events", std::move(events)}, {"log", sources_.log != nullptr}});
  }

  void show_entry(const Request& request, Response& response) {
    const auto number = whole(request.matches[1].str());
    const auto entry = number && sources_.log != nullptr ? sources_.log->entry(*number) : std::nullopt;
    if (!entry) return refuse(response, 404, "There is no such event.");
    answer(response, 200, {{"event", entry->json}, {"pictures", entry->pictures}, {"complete", entry->complete}});
  }

  void show_log_picture(const Request& request, Response& response) {
    const std::string name = request.matches[2].str();
    const auto number = whole(request.matches[1].str());
    const auto path = number && sources_.log != nullptr ? sources_.log->picture(*number, name) : std::nullopt;
    if (!path) return refuse(response, 404, "There is no such picture.");
    std::ifstream stream(*path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream || bytes.empty()) return refuse(response, 404, "The picture is not there any more.");
    response.set_content(bytes, name.ends_with(".png") ? "image/png" : "image/jpeg");
  }

  /// What was refused is in the log, but nobody can fill it with that.
  void note_refused(const std::string& kind, const Actor& actor, std::string what) {
    if (sources_.log == nullptr) return;
    const std::lock_guard lock(notes_mutex_);
    if (!notes_.allows("")) {
      ++not_noted_;
      return;
    }
    if (not_noted_ > 0) what += fmt::format(" {} more were refused before.", std::exchange(not_noted_, 0));
    sources_.log->note(kind, actor, what);
  }

  const WebConfiguration configuration_;
  const Sources sources_;
  UserList users_;
  Sessions sessions_;
  RateLimit requests_;
  RateLimit failures_;
  RateLimit tries_{kLoginsPerMin / 60, kLoginsPerMin};
  RateLimit notes_{kNotesPerMin / 60, kNotesPerMin};
  std::mutex notes_mutex_;
  int not_noted_ = 0;
  std::mutex hashing_;
  LivePicture picture_;
  int port_ = 0;
  GuardedServer server_;
  std::thread thread_;
};

Web::Web(WebConfiguration configuration, Sources sources)
    : site_(std::make_unique<Site>(std::move(configuration), std::move(sources))) {}
Web::~Web() = default;
int Web::port() const { return site_->port(); }

}  // namespace horopter::monitor
