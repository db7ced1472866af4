// SPDX-License-Identifier: MIT
// The server as those meet it who should not: without token, under another name, with too much, in
// crowds, and without reading.
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "live/server.h"
#include "live_support.h"

namespace stig {
namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";
const std::string kTemplate =
    "<meta content=\"default-src 'none'; x\"><title>@TITLE@</title><i>@DATA@</i>";

SwarmConfig big_config() {
  SwarmConfig config = event_config();
  config.max_deposits = 200'000;
  return config;
}

/// A tower that is paused, served.
struct Served {
  AtWork work{[] { return lattice_live(tower_rules(100), event_config(), "tower"); }, true};
  LiveServer server{work.session, kTemplate, kToken};
  int port = server.bind(0).value_or(0);

  Served() {
    REQUIRE(port > 0);
    server.start();
  }
  httplib::Client client() const {
    httplib::Client out("127.0.0.1", port);
    out.set_read_timeout(20);
    return out;
  }
  std::string host() const { return "127.0.0.1:" + std::to_string(port); }
  int status(const std::string& path, const httplib::Headers& headers = {}) const {
    const auto result = client().Get(path, headers);
    return result ? result->status : 0;
  }
  int post(const std::string& body) const {
    const auto result =
        client().Post("/command", {{"X-Stig-Token", kToken}}, body, "application/json");
    return result ? result->status : 0;
  }
};

TEST_CASE("the page comes with the token alone, knows that it is live, and may ask its server") {
  const Served served;
  const auto page = served.client().Get("/?token=" + kToken);
  REQUIRE(page);
  CHECK(page->status == 200);
  CHECK(page->body.find("default-src 'none'; connect-src 'self'; x") != std::string::npos);
  CHECK(page->body.find("<meta name=\"stig-live\" content=\"1\">") != std::string::npos);
  CHECK(page->get_header_value("Referrer-Policy") == "no-referrer");
  CHECK(page->get_header_value("Cache-Control") == "no-store");
  for (const std::string& wrong : {std::string(), kToken.substr(1), kToken + "0",
                                   std::string(32, '0'), "1" + kToken.substr(1)}) {
    CAPTURE(wrong);
    CHECK(served.status("/?token=" + wrong) == 403);
    CHECK(served.status("/events?token=" + wrong) == 403);
    CHECK(served.status("/", {{"X-Stig-Token", wrong}}) == 403);
  }
  CHECK(served.status("/", {{"X-Stig-Token", kToken}}) == 200);
}

TEST_CASE("other hosts and other sites are refused, whatever token they have") {
  const Served served;
  const std::string page = "/?token=" + kToken;
  const std::string port = std::to_string(served.port);
  CHECK(served.status(page, {{"Host", "localhost:" + port}}) == 200);
  for (const std::string host : {"evil.example", "127.0.0.1", "127.0.0.1:1", "127.0.0.1.evil:1"}) {
    CHECK_MESSAGE(served.status(page, {{"Host", host}}) == 403, host);
  }
  CHECK(served.status(page, {{"Origin", "http://" + served.host()}}) == 200);
  for (const std::string origin : {"http://evil.example", "null", "https://127.0.0.1"}) {
    CHECK_MESSAGE(served.status(page, {{"Origin", origin}}) == 403, origin);
  }
  CHECK(served.status(page, {{"Origin", "https://" + served.host()}}) == 403);
}

TEST_CASE("there are no files behind it") {
  const Served served;
  for (const std::string path : {"/etc/passwd", "/../etc/passwd", "/..%2f..%2fetc%2fpasswd", "//",
                                 "/events/../x", "/checkpoint"}) {
    CHECK_MESSAGE(served.status(path + "?token=" + kToken) == 404, path);
  }
  for (const std::string number : {"0", "1", "-1", "1e1", "99999999999999999999", ""}) {
    CHECK_MESSAGE(served.status("/checkpoint?number=" + number + "&token=" + kToken) == 404,
                  number);
  }
}

TEST_CASE("commands are carried out, others and huge ones refused") {
  const Served served;
  CHECK(served.post(R"({"do":"step","count":3})") == 200);
  CHECK(served.post(R"({"do":"checkpoint"})") == 200);
  const auto file = served.client().Get("/checkpoint?number=1&token=" + kToken);
  REQUIRE(file);
  CHECK(file->status == 200);
  CHECK(file->body.starts_with("stigtrc1"));
  CHECK(file->get_header_value("Content-Disposition").find("checkpoint-1.stigt") !=
        std::string::npos);
  CHECK(served.post("{}") == 400);
  CHECK(served.post(std::string(1'000'000, 'x')) == 413);
  const auto without = served.client().Post("/command", R"({"do":"run"})", "application/json");
  REQUIRE(without);
  CHECK(without->status == 403);
}

TEST_CASE("who does not read is dropped, and makes room") {
  AtWork work([] { return lattice_live(tower_rules(100'000), big_config(), "tower"); });
  LiveServer server(work.session, kTemplate, kToken);
  const int port = server.bind(0).value_or(0);
  REQUIRE(port > 0);
  server.start();
  std::atomic<bool> over{false};
  std::atomic<std::size_t> in{0};
  std::vector<std::thread> idlers;
  for (std::size_t i = 0; i < kMostLookers; ++i) {
    idlers.emplace_back([&] {
      httplib::Client client("127.0.0.1", port);
      client.set_socket_options([](socket_t socket) {
        const int bytes = 4096;
        setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
      });
      client.Get("/events?token=" + kToken, [&](const char*, std::size_t) {
        ++in;
        while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return false;
      });
    });
  }
  while (in < kMostLookers) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  while (!work.session.join()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  Looker looker;
  told(work.session, looker, "state", [](const Json& now) { return now["time"] == 100'000; });
  over = true;
  for (std::thread& one : idlers) one.join();
}

TEST_CASE("fifty clients hold nothing up") {
  Served served;
  served.work.ask(R"({"do":"run"})");
  std::vector<std::thread> crowd;
  std::atomic<int> got_in{0}, refused{0}, events{0};
  for (int i = 0; i < 50; ++i) {
    crowd.emplace_back([&] {
      httplib::Client client("127.0.0.1", served.port);
      client.set_read_timeout(20);
      bool in = false;
      const auto result = client.Get(
          "/events?token=" + kToken,
          [&](const httplib::Response& response) {
            in = response.status == 200;
            in ? ++got_in : ++refused;
            return in;
          },
          [&](const char*, std::size_t) { return ++events < 2000; });
    });
  }
  // While they hang on, commands are answered.
  for (int i = 0; i < 20; ++i) CHECK(served.post(R"({"do":"pause"})") == 200);
  while (got_in + refused < 50) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  CHECK(got_in >= 1);
  CHECK(refused >= 1);
  CHECK(got_in <= static_cast<int>(kMostLookers));
  served.server.stop();
  for (std::thread& one : crowd) one.join();
}

int connected(const Served& served) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(served.port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int out = socket(AF_INET, SOCK_STREAM, 0);
  REQUIRE(connect(out, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  return out;
}

TEST_CASE("who sends a byte now and then holds nothing up, and has an answer in the end") {
  Served served;
  const std::string request =
      "GET /?token=" + kToken + " HTTP/1.1\r\nHost: " + served.host() + "\r\n\r\n";
  std::vector<int> slow;
  for (int i = 0; i < 30; ++i) slow.push_back(connected(served));
  for (const char c : request.substr(0, 20)) {
    // One that has been too slow is gone by now.
    for (const int one : slow) send(one, &c, 1, MSG_NOSIGNAL);
    CHECK(served.post(R"({"do":"pause"})") == 200);
  }
  slow.push_back(connected(served));
  for (const char c : request) REQUIRE(send(slow.back(), &c, 1, MSG_NOSIGNAL) == 1);
  std::string answer(12, '\0');
  CHECK(recv(slow.back(), answer.data(), answer.size(), MSG_WAITALL) == 12);
  CHECK(answer == "HTTP/1.1 200");
  for (const int one : slow) close(one);
}

TEST_CASE("tokens are long, differ, and are compared whole") {
  const std::string token = random_token();
  CHECK(token.size() == 32);
  CHECK(token != random_token());
  CHECK(same_token(token, token));
  CHECK(!same_token("", token));
  CHECK(!same_token(token.substr(0, 31), token));
  CHECK(!same_token(token + token, token));
}

}  // namespace
}  // namespace stig
