// SPDX-License-Identifier: MIT
// Serves a session to browsers on this machine, and to nobody else.
//
//     GET  /                      the page
//     GET  /events                what happens, as server-sent events (session.h)
//     POST /command               JSON (command.h); answered as JSON
//     GET  /checkpoint?number=1   a checkpoint, as a file
//
// All of it takes the token, as parameter `token` or header X-Stig-Token, and a Host, and if there
// is one an Origin, that are this server's own: so neither other users of the machine nor pages of
// other sites, under whatever name they reach it, see the run or touch it. Nothing is read from the
// disk.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "live/session.h"

namespace stig::live {

/// 128 bits from the system's source of random numbers, as text.
std::string random_token();

/// Takes as long for every wrong token of a length.
bool same_token(std::string_view given, std::string_view token);

class LiveServer {
 public:
  /// The session must outlive it.
  LiveServer(LiveSession& session, std::string page_template, std::string token);
  ~LiveServer();

  /// Takes a port of 127.0.0.1, 0: any that is free. Nothing when it cannot be had.
  std::optional<int> bind(int port);
  /// Serves in threads of its own, until `stop`. Once, after bind.
  void start();
  /// Ends what is under way; the session is closed for it.
  void stop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stig::live
