// SPDX-License-Identifier: MIT
// A thin coat over httplib, in the one file that knows it. A client that listens for events has a
// thread of the pool to itself; there are more threads than such clients, so that commands find
// one, also when a crowd sends requests a byte at a time. Who does not read is dropped when the
// system's buffer is full and the time to write is over.
#include "live/server.h"

#include <httplib.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <random>
#include <thread>

#include "lattice/trace.h"

namespace stig::live {

namespace {

constexpr std::size_t kThreadsForCommands = 56;
constexpr int kReadSeconds = 2, kWriteSeconds = 2;
constexpr int kSendBuffer = 1 << 18;     ///< bytes, of each connection
constexpr std::size_t kMostBody = 4096;  ///< bytes; more than any command
constexpr std::chrono::milliseconds kPatience{1000};

using httplib::Request;
using httplib::Response;

std::string replaced(std::string text, std::string_view what, const std::string& with) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

/// The page may ask this server, and knows that it is live by the number of its run.
std::string live_page(const std::string& page_template, const LiveSession::Beginning& beginning) {
  std::string head = "<meta name=\"stig-live\" content=\"" + std::to_string(beginning.run) +
                     "\">\n<link rel=\"icon\" href=\"data:,\">\n<title>";
  const std::string coated = replaced(
      replaced(page_template, "default-src 'none'", "default-src 'none'; connect-src 'self'"),
      "<title>", head);
  return page_of(coated, *beginning.page).value_or("");
}

void refuse(Response& response, int status, const char* why) {
  response.status = status;
  response.set_content(std::string(why) + "\n", "text/plain");
}

}  // namespace

std::string random_token() {
  std::random_device source;
  std::string out;
  for (int i = 0; i < 4; ++i) {
    for (std::uint32_t bits = source(), k = 0; k < 8; ++k, bits >>= 4) {
      out += "0123456789abcdef"[bits & 15];
    }
  }
  return out;
}

bool same_token(std::string_view given, std::string_view token) {
  unsigned differs = given.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const char c = i < given.size() ? given[i] : '\0';
    differs |= static_cast<unsigned char>(c) ^ static_cast<unsigned char>(token[i]);
  }
  return differs == 0;
}

struct LiveServer::State {
  LiveSession& session;
  std::string page_template, token;
  httplib::Server http;
  socket_t listener = -1;  ///< of `http`, which keeps it to itself
  int port = 0;
  std::thread thread;

  State(LiveSession& a_session, std::string text, std::string a_token)
      : session(a_session), page_template(std::move(text)), token(std::move(a_token)) {}

  void set_up();
  bool may(const Request& request, Response& response) const;
  bool is_own(const std::string& host) const;
  void events(Response& response);
  void command(const Request& request, Response& response);
  void checkpoint(const Request& request, Response& response);
};

bool LiveServer::State::is_own(const std::string& host) const {
  const std::string end = ":" + std::to_string(port);
  return host == "127.0.0.1" + end || host == "localhost" + end;
}

/// Names under which other sites may reach this machine are refused before the token is looked at.
bool LiveServer::State::may(const Request& request, Response& response) const {
  constexpr std::string_view kScheme = "http://";
  if (request.get_header_value_count("Host") != 1 || !is_own(request.get_header_value("Host"))) {
    refuse(response, 403, "another host is meant");
    return false;
  }
  if (request.has_header("Origin")) {
    const std::string origin = request.get_header_value("Origin");
    if (!origin.starts_with(kScheme) || !is_own(origin.substr(kScheme.size()))) {
      refuse(response, 403, "another site asks");
      return false;
    }
  }
  const std::string given = request.has_header("X-Stig-Token")
                                ? request.get_header_value("X-Stig-Token")
                                : request.get_param_value("token");
  if (same_token(given, token)) return true;
  refuse(response, 403, "the address that the program printed has a token, which is missing here");
  return false;
}

void LiveServer::State::events(Response& response) {
  if (!session.join()) return refuse(response, 503, "as many look as can");
  auto looker = std::make_shared<Looker>();
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, looker](std::size_t, httplib::DataSink& sink) {
        const auto text = session.next(*looker, kPatience);
        if (text) return sink.write(text->data(), text->size());
        sink.done();
        return true;
      },
      [this](bool) { session.leave(); });
}

void LiveServer::State::command(const Request& request, Response& response) {
  std::string problem;
  const auto command = read_command(request.body, problem);
  if (!command) return refuse(response, 400, problem.c_str());
  response.set_content(session.call(*command), "application/json");
}

void LiveServer::State::checkpoint(const Request& request, Response& response) {
  const std::string number = request.get_param_value("number");
  const bool digits =
      !number.empty() && number.size() < 9 &&
      std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  const auto bytes = digits ? session.checkpoint(std::stoull(number)) : std::nullopt;
  if (!bytes) return refuse(response, 404, "there is no such checkpoint");
  const char* ending = bytes->starts_with(kTraceMagic) ? ".stigt" : ".stigk";
  response.set_header("Content-Disposition",
                      "attachment; filename=\"checkpoint-" + number + ending + "\"");
  response.set_content(*bytes, "application/octet-stream");
}

void LiveServer::State::set_up() {
  http.new_task_queue = [] { return new httplib::ThreadPool(kMostLookers + kThreadsForCommands); };
  // A connection is for one answer: an idle one would hold a thread.
  http.set_keep_alive_max_count(1);
  http.set_socket_options([this](socket_t socket) {
    listener = socket;
    // Not SO_REUSEPORT, with which another program could share the port. What waits for somebody
    // who does not read is bounded.
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
  });
  http.set_read_timeout(kReadSeconds);
  http.set_write_timeout(kWriteSeconds);
  http.set_payload_max_length(kMostBody);
  http.set_tcp_nodelay(true);
  http.set_default_headers({{"Cache-Control", "no-store"},
                            {"Referrer-Policy", "no-referrer"},
                            {"X-Content-Type-Options", "nosniff"},
                            {"X-Frame-Options", "DENY"},
                            {"Cross-Origin-Resource-Policy", "same-origin"}});
  // Before a body is read.
  http.set_pre_routing_handler([this](const Request& request, Response& response) {
    using Result = httplib::Server::HandlerResponse;
    return may(request, response) ? Result::Unhandled : Result::Handled;
  });
  http.Get("/", [this](const Request&, Response& response) {
    response.set_content(live_page(page_template, session.beginning()), "text/html; charset=utf-8");
  });
  http.Get("/events", [this](const Request&, Response& response) { events(response); });
  http.Get("/checkpoint",
           [this](const Request& request, Response& response) { checkpoint(request, response); });
  http.Post("/command",
            [this](const Request& request, Response& response) { command(request, response); });
}

LiveServer::LiveServer(LiveSession& session, std::string page_template, std::string token)
    : state_(std::make_unique<State>(session, std::move(page_template), std::move(token))) {
  assert(!state_->token.empty());
  state_->set_up();
}

LiveServer::~LiveServer() { stop(); }

std::optional<int> LiveServer::bind(int port) {
  constexpr const char* kLoopback = "127.0.0.1";
  if (port == 0) {
    state_->port = state_->http.bind_to_any_port(kLoopback);
  } else {
    state_->port = state_->http.bind_to_port(kLoopback, port) ? port : -1;
  }
  if (state_->port <= 0) return std::nullopt;
  // The queue of httplib is 5 long. A crowd overflows it, and then the system may turn away clients
  // that believe they are connected (SYN cookies).
  ::listen(state_->listener, SOMAXCONN);
  return state_->port;
}

void LiveServer::start() {
  assert(state_->port > 0 && !state_->thread.joinable());
  state_->thread = std::thread([this] { state_->http.listen_after_bind(); });
}

void LiveServer::stop() {
  if (!state_->thread.joinable()) return;
  state_->session.close();
  // A server that has not begun to listen does not hear it.
  while (!state_->http.is_running()) std::this_thread::yield();
  state_->http.stop();
  state_->thread.join();
}

}  // namespace stig::live
