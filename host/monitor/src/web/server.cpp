// SPDX-License-Identifier: Apache-2.0
#include "server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "horopter/base/error.hpp"

namespace horopter::monitor {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kNice = 10;  // the decision goes first
constexpr std::size_t kBuffer = 4096;
constexpr std::size_t kDrained = 65'536;
constexpr auto kDrainTime = std::chrono::milliseconds(300);

using AddressCall = int(int, sockaddr*, socklen_t*);

void address_of(AddressCall* call, int socket, std::string& address, int& port) {
  sockaddr_storage place{};
  socklen_t size = sizeof place;
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> service{};
  if (call(socket, reinterpret_cast<sockaddr*>(&place), &size) != 0 ||
      ::getnameinfo(reinterpret_cast<const sockaddr*>(&place), size, host.data(), host.size(), service.data(),
                    service.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
    return;
  }
  address = host.data();
  const std::string_view text = service.data();
  std::from_chars(text.data(), text.data() + text.size(), port);
}

const char* words_of(int status) {
  switch (status) {
    case 405:
      return "Method Not Allowed";
    case 411:
      return "Length Required";
    case 413:
      return "Payload Too Large";
    case 414:
      return "URI Too Long";
    case 431:
      return "Request Header Fields Too Large";
    case 505:
      return "HTTP Version Not Supported";
    default:
      return "Bad Request";
  }
}

/// Threads that serve connections. The one that accepts waits while all are busy, and the rest waits in the system.
class Pool : public httplib::TaskQueue {
 public:
  explicit Pool(std::size_t threads) {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
  }
  void enqueue(std::function<void()> work) override {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [&] { return jobs_.size() < kMostWaiting || ending_; });
    jobs_.push_back(std::move(work));
    lock.unlock();
    wake_.notify_one();
  }
  void shutdown() override {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_all();
    room_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  static constexpr std::size_t kMostWaiting = 16;

  void run() {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [&] { return !jobs_.empty() || ending_; });
      if (jobs_.empty()) return;
      const auto work = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      room_.notify_one();
      work();
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable room_;
  std::deque<std::function<void()>> jobs_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

struct SslFree {
  void operator()(SSL* ssl) const { SSL_free(ssl); }
};

/// A connection: every read and write ends at a deadline.
class Connection : public httplib::Stream {
 public:
  Connection(int socket, SSL_CTX* tls) : socket_(socket) {
    ::fcntl(socket_, F_SETFL, ::fcntl(socket_, F_GETFL) | O_NONBLOCK);
    const int on = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (tls == nullptr) return;
    ssl_.reset(SSL_new(tls));
    if (!ssl_ || SSL_set_fd(ssl_.get(), socket_) != 1) broken_ = true;
  }

  void set_deadline(Clock::time_point deadline) { deadline_ = deadline; }
  void close_after_answer() { last_ = true; }
  [[nodiscard]] bool is_last() const { return last_ || broken_; }

  bool begin() {
    if (broken_) return false;
    if (!ssl_) return true;
    return repeat([&] { return SSL_accept(ssl_.get()); }) == 1;
  }

  /// Waits for the first byte of a request.
  bool wait_for_more() { return !buffer_.empty() || fill(); }

  /// The head of a request, up to its empty line; nothing where it does not come, or is longer than `most`.
  std::optional<std::string_view> head(std::size_t most, bool& too_long) {
    std::size_t looked = 0;
    for (;;) {
      const std::string_view text(buffer_);
      const auto end = text.find("\r\n\r\n", looked);
      if (end != std::string_view::npos && end + 4 <= most) return text.substr(0, end + 4);
      too_long = text.size() >= most;
      if (too_long) return std::nullopt;
      looked = text.size() < 3 ? 0 : text.size() - 3;
      if (!fill()) return std::nullopt;
    }
  }

  [[nodiscard]] bool is_readable() const override { return !broken_; }
  [[nodiscard]] bool is_writable() const override { return !broken_; }

  ssize_t read(char* bytes, size_t size) override {
    if (buffer_.size() == begin_ && !fill()) return -1;
    const std::size_t count = std::min(size, buffer_.size() - begin_);
    std::memcpy(bytes, buffer_.data() + begin_, count);
    begin_ += count;
    if (begin_ == buffer_.size()) {
      buffer_.clear();
      begin_ = 0;
    }
    return static_cast<ssize_t>(count);
  }

  ssize_t write(const char* bytes, size_t size) override {
    std::size_t written = 0;
    while (written < size) {
      const int part = static_cast<int>(std::min<std::size_t>(size - written, 1 << 20));
      const auto count = repeat([&] {
        return ssl_ ? SSL_write(ssl_.get(), bytes + written, part)
                    : static_cast<int>(::send(socket_, bytes + written, static_cast<std::size_t>(part), MSG_NOSIGNAL));
      });
      if (count <= 0) {
        broken_ = true;
        return -1;
      }
      written += static_cast<std::size_t>(count);
    }
    return static_cast<ssize_t>(size);
  }

  /// What was read of the request that ended is forgotten.
  void next_request() {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }

  /// The answer arrives also where the other side is still sending.
  void end() {
    if (ssl_ && !broken_) SSL_shutdown(ssl_.get());
    ::shutdown(socket_, SHUT_WR);
    deadline_ = Clock::now() + kDrainTime;
    std::array<char, kBuffer> rest{};
    std::size_t drained = 0;
    while (drained < kDrained && wait(POLLIN)) {
      const ssize_t got = ::recv(socket_, rest.data(), rest.size(), 0);
      if (got <= 0) break;
      drained += static_cast<std::size_t>(got);
    }
  }

  void get_remote_ip_and_port(std::string& address, int& port) const override {
    address_of(&::getpeername, socket_, address, port);
  }
  void get_local_ip_and_port(std::string& address, int& port) const override {
    address_of(&::getsockname, socket_, address, port);
  }
  [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
  bool wait(short what) const {
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
      if (left <= 0) return false;
      pollfd place{.fd = socket_, .events = what, .revents = 0};
      const int ready = ::poll(&place, 1, static_cast<int>(std::min<std::int64_t>(left, 60'000)));
      if (ready > 0) return true;
      if (ready < 0 && errno != EINTR) return false;
    }
  }

  /// Until it is done, fails, or the deadline has come.
  template <class Work>
  int repeat(Work&& work) {
    for (;;) {
      ERR_clear_error();
      errno = 0;
      const int result = work();
      if (result > 0) return result;
      short what = 0;
      if (ssl_) {
        const int problem = SSL_get_error(ssl_.get(), result);
        if (problem == SSL_ERROR_WANT_READ) what = POLLIN;
        if (problem == SSL_ERROR_WANT_WRITE) what = POLLOUT;
      } else if (result < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
        what = writing_ ? POLLOUT : POLLIN;
      }
      if (what == 0 || !wait(what)) {
        broken_ = true;
        return -1;
      }
    }
  }

  bool fill() {
    if (broken_) return false;
    std::array<char, kBuffer> bytes{};
    writing_ = false;
    const int count = repeat([&] {
      return ssl_ ? SSL_read(ssl_.get(), bytes.data(), static_cast<int>(bytes.size()))
                  : static_cast<int>(::recv(socket_, bytes.data(), bytes.size(), 0));
    });
    writing_ = true;
    if (count <= 0) return false;
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }

  int socket_;
  std::unique_ptr<SSL, SslFree> ssl_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what was not yet read in it
  Clock::time_point deadline_{};
  bool writing_ = true;
  bool broken_ = false;
  bool last_ = false;
};

thread_local Connection* current = nullptr;

bool is_target(std::string_view target, std::size_t most) {
  if (target.empty() || target.front() != '/' || target.size() > most) return false;
  const auto query = target.find('?');
  const std::string_view path = target.substr(0, query);
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  if (!std::ranges::all_of(path, [&](char c) { return plain(c) || c == '/'; })) return false;
  if (path.find("..") != std::string_view::npos) return false;
  return query == std::string_view::npos ||
         std::ranges::all_of(target.substr(query + 1), [&](char c) { return plain(c) || c == '=' || c == '&'; });
}

bool is_field_name(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

struct Head {
  int refused = 0;  ///< the status of the answer; 0 = it is let through
  bool last = false;
};

/// Only the few forms that the page needs.
Head judge(std::string_view head, const ServerLimits& limits) {
  const auto refuse = [](int status) { return Head{.refused = status, .last = true}; };
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < head.size();) {
    const auto end = head.find("\r\n", begin);
    lines.push_back(head.substr(begin, end - begin));
    begin = end + 2;
    if (lines.size() > limits.header_lines + 2) return refuse(431);
  }
  lines.pop_back();  // the empty one
  if (lines.empty()) return refuse(400);
  for (const std::string_view line : lines) {
    if (!std::ranges::all_of(line, [](char c) { return c == '\t' || (c >= ' ' && c != '\x7f'); })) return refuse(400);
  }

  const std::string_view first = lines.front();
  const auto space = first.find(' ');
  const auto second = first.find(' ', space == std::string_view::npos ? space : space + 1);
  if (second == std::string_view::npos) return refuse(400);
  const std::string_view method = first.substr(0, space);
  const std::string_view target = first.substr(space + 1, second - space - 1);
  const std::string_view version = first.substr(second + 1);
  if (version != "HTTP/1.1" && version != "HTTP/1.0") return refuse(505);
  if (method != "GET" && method != "POST") return refuse(405);
  if (target.size() > limits.target_bytes) return refuse(414);
  if (!is_target(target, limits.target_bytes)) return refuse(400);

  Head result;
  int hosts = 0;
  std::optional<std::size_t> length;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto colon = lines[i].find(':');
    if (colon == std::string_view::npos || !is_field_name(lines[i].substr(0, colon))) return refuse(400);
    const std::string_view name = lines[i].substr(0, colon);
    const std::string_view value = trimmed(lines[i].substr(colon + 1));
    for (const char* never : {"Transfer-Encoding", "Content-Encoding", "Range", "Expect", "Upgrade", "Trailer", "TE"}) {
      if (same_word(name, never)) return refuse(400);
    }
    if (same_word(name, "Host")) ++hosts;
    if (same_word(name, "Connection") && same_word(value, "close")) result.last = true;
    if (!same_word(name, "Content-Length")) continue;
    std::size_t bytes = 0;
    const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), bytes);
    if (length || problem != std::errc{} || end != value.data() + value.size()) return refuse(400);
    length = bytes;
  }
  if (hosts != 1) return refuse(400);
  if (method == "POST" && !length) return refuse(411);
  if (method == "GET" && length.value_or(0) != 0) return refuse(400);
  if (length.value_or(0) > limits.body_bytes) return refuse(413);
  return result;
}

void answer(Connection& connection, int status) {
  const std::string text = fmt::format(
      "HTTP/1.1 {} {}\r\nContent-Length: 0\r\nConnection: close\r\nX-Content-Type-Options: nosniff\r\n"
      "Cache-Control: no-store\r\n\r\n",
      status, words_of(status));
  connection.write(text.data(), text.size());
}

}  // namespace

struct GuardedServer::Tls {
  struct Free {
    void operator()(SSL_CTX* made) const { SSL_CTX_free(made); }
  };
  std::unique_ptr<SSL_CTX, Free> context;
};

GuardedServer::GuardedServer(const ServerLimits& limits, const std::filesystem::path& certificate,
                             const std::filesystem::path& key)
    : limits_(limits) {
  new_task_queue = [this]() -> httplib::TaskQueue* { return new Pool(limits_.connections); };
  if (certificate.empty()) return;
  tls_ = std::make_unique<Tls>();
  tls_->context.reset(SSL_CTX_new(TLS_server_method()));
  SSL_CTX* const context = tls_->context.get();
  if (context == nullptr) throw Error(ExitStatus::fault, "OpenSSL cannot be initialised");
  SSL_CTX_set_min_proto_version(context, TLS1_2_VERSION);
  SSL_CTX_set_options(context, SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION);
  SSL_CTX_set_mode(context, SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  if (SSL_CTX_use_certificate_chain_file(context, certificate.c_str()) != 1) {
    throw FileError(certificate.string(), "", "the certificate cannot be read", "a certificate (chain) as PEM");
  }
  if (SSL_CTX_use_PrivateKey_file(context, key.c_str(), SSL_FILETYPE_PEM) != 1 ||
      SSL_CTX_check_private_key(context) != 1) {
    throw FileError(key.string(), "", "the key cannot be read, or is not that of the certificate",
                    "the certificate's private key as PEM, without a password");
  }
}

GuardedServer::~GuardedServer() = default;

void GuardedServer::close_after_answer(httplib::Response& response) {
  response.set_header("Connection", "close");
  if (current != nullptr) current->close_after_answer();
}

void GuardedServer::stop_all() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (const socket_t socket : sockets_) ::shutdown(socket, SHUT_RDWR);
  }
  stop();
}

bool GuardedServer::admit(socket_t socket, const std::string& address) {
  const std::lock_guard lock(mutex_);
  if (stopping_ || of_address_[address] >= limits_.per_address) return false;
  ++of_address_[address];
  sockets_.insert(socket);
  return true;
}

void GuardedServer::leave(socket_t socket, const std::string& address) {
  const std::lock_guard lock(mutex_);
  sockets_.erase(socket);
  if (--of_address_[address] == 0) of_address_.erase(address);
}

bool GuardedServer::process_and_close_socket(socket_t socket) {
  std::string address;
  int port = 0;
  address_of(&::getpeername, socket, address, port);
  if (!admit(socket, address)) {
    ::close(socket);
    return false;
  }
  {
    Connection connection(socket, tls_ ? tls_->context.get() : nullptr);
    current = &connection;
    connection.set_deadline(Clock::now() + limits_.request);
    bool open = connection.begin();
    while (open) {
      connection.set_deadline(Clock::now() + limits_.idle);
      if (!connection.wait_for_more()) break;
      connection.set_deadline(Clock::now() + limits_.request);
      bool too_long = false;
      const auto head = connection.head(limits_.head_bytes, too_long);
      if (!head && !too_long) break;
      const Head judged = head ? judge(*head, limits_) : Head{.refused = 431, .last = true};
      if (judged.last) connection.close_after_answer();
      connection.set_deadline(Clock::now() + limits_.request + limits_.response);
      if (judged.refused != 0) {
        answer(connection, judged.refused);
        break;
      }
      bool closed = false;
      open = process_request(connection, connection.is_last(), closed, nullptr) && !closed && !connection.is_last();
      connection.next_request();
    }
    connection.end();
    current = nullptr;
  }
  leave(socket, address);
  ::close(socket);
  return true;
}

}  // namespace horopter::monitor
