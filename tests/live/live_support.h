// SPDX-License-Identifier: MIT
// Small runs to be looked at.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "live/lattice_live.h"
#include "live/pose_live.h"
#include "live/session.h"
#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig {

using namespace live;
using Json = nlohmann::json;

inline RuleSet tower_rules(int high) {
  const std::string text =
      "stigc: 1\nname: tower\nlattice: cubic\nfloor: true\nbricks:\n  a: {name: red, color: "
      "\"#ff0000\"}\n"
      "start:\n  - {at: [0, 0, 0], brick: a}\nrules:\n  - name: raise\n    place: a\n    when: |\n"
      "      ? ? ?   ? ? ?   ? ? ?\n      ? ? ?   ? * ?   ? a ?\n      ? ? ?   ? ? ?   ? ? ?\n"
      "    height: {max: " +
      std::to_string(high) + "}\n";
  Diagnostics diagnostics;
  auto rules = read_rule_set(std::make_shared<const SourceFile>("tower.yaml", text), diagnostics);
  REQUIRE_MESSAGE(rules, to_text(diagnostics));
  return std::move(*rules);
}

inline SwarmConfig event_config() {
  SwarmConfig config;
  config.motion = Motion::event;
  config.max_deposits = 5000;
  return config;
}

inline LoadedScene falling_blocks() {
  FileError error;
  const auto block = read_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", 1 << 20, error);
  const auto program = read_file(STIG_SOURCE_DIR "/blocks/stigmergic.lua", 1 << 20, error);
  REQUIRE((block && program));
  Diagnostics diagnostics;
  auto loaded = load_scene({{"s.yaml",
                             "stigc_scene: 1\nduration: 1.5\nstock: 2\nblocks:\n"
                             "  - {at: [0, 0, 0.1]}\n  - {at: [0.02, 0.01, 0.3]}\n"},
                            {"stigmergic.yaml", *block},
                            {"stigmergic.lua", *program}},
                           1, diagnostics);
  REQUIRE_MESSAGE(loaded, to_text(diagnostics));
  return std::move(*loaded);
}

/// A session at work in a thread of its own.
class AtWork {
 public:
  explicit AtWork(std::function<std::unique_ptr<LiveRun>()> make, bool paused = false)
      : session(settings_of(make, paused), LiveLoad{make(), {}, {}}),
        thread_([this] { trace_ = session.work(stop_); }) {}
  ~AtWork() { end(); }

  Json ask(const std::string& command) {
    std::string problem;
    const auto read = read_command(command, problem);
    REQUIRE_MESSAGE(read, problem);
    return Json::parse(session.call(*read));
  }
  /// The trace's bytes.
  std::string end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return trace_;
  }

 private:
  static LiveSettings settings_of(const std::function<std::unique_ptr<LiveRun>()>& make,
                                  bool paused) {
    LiveSettings out;
    out.load = [make] { return LiveLoad{make(), {}, {}}; };
    out.paused = paused;
    out.speed = std::nullopt;
    return out;
  }

  std::atomic<bool> stop_{false};
  std::string trace_;

 public:
  LiveSession session;

 private:
  std::thread thread_;
};

/// The data of the last event of a kind that a looker is told, once `wanted` is true of it.
template <class Wanted>
Json told(LiveSession& session, Looker& looker, const std::string& kind, const Wanted& wanted) {
  const std::string before = "event: " + kind + "\ndata: ";
  for (int tries = 0; tries < 3000; ++tries) {
    const auto text = session.next(looker, std::chrono::milliseconds(20));
    REQUIRE(text);
    const std::size_t at = text->rfind(before);
    if (at == std::string::npos) continue;
    const std::size_t from = at + before.size();
    Json data = Json::parse(text->substr(from, text->find('\n', from) - from));
    if (wanted(data)) return data;
  }
  FAIL("never told");
  return {};
}

}  // namespace stig
