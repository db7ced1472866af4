// SPDX-License-Identifier: MIT
// Each target has a process of its own: so its peak of memory can be told, and what one target
// leaves in the allocator does not slow down the next.
#include "assembly_named.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "assembly/assemble.h"
#include "assembly/large_targets.h"
#include "growth.h"
#include "synthesis/shapes.h"

namespace stig::bench {

namespace {

constexpr double kSoon = 10, kLater = 180;  // s of the processor that a target may take
/// The deadline is one of the clock, and the machine may be busy.
constexpr double kPatience = 5;

struct Named {
  std::string name;
  std::function<Target()> draw;
  double most_seconds = kSoon;
};

std::vector<Named> named_targets() {
  constexpr std::uint64_t kSeed = 1;
  constexpr std::size_t kMany = 100'000;
  return {{"wall 60×1×3",
           [] {
             return box({60, 1, 3});
           }},
          {"plate 20×20",
           [] {
             return box({20, 20, 1});
           }},
          {"maze, corridors of 3", [] { return maze_target(500, 3, kSeed); }},
          {"maze, corridors of 1", [] { return maze_target(500, 1, kSeed); }},
          {"town, paved", [] { return paved_town_target(2000, kSeed); }},
          {"town, terraced", [] { return terraced_town_target(2000, kSeed); }},
          {"plate 57×57",
           [] {
             return box({57, 57, 1});
           }},
          {"plate 77×77",
           [] {
             return box({77, 77, 1});
           }},
          {"wall 33334×1×3",
           [] {
             return box({33'334, 1, 3});
           },
           kLater},
          {"plate 317×317",
           [] {
             return box({317, 317, 1});
           },
           kLater},
          {"maze, corridors of 3", [] { return maze_target(kMany, 3, kSeed); }, kLater},
          {"town, paved", [] { return paved_town_target(kMany, kSeed); }, kLater},
          {"town, terraced", [] { return terraced_town_target(kMany, kSeed); }, kLater}};
}

enum Answer { kFound, kImpossible, kUnknown, kAnswers };

std::string in_words(const Assembly& made) {
  if (made.plan) {
    return made.plan->any_number ? "rules for any number of robots" : "rules for one robot";
  }
  if (made.too_many) return "UNKNOWN: too many bricks to look for rules";
  if (!made.obstacle) return "UNKNOWN: not found";
  switch (made.obstacle->kind) {
    case AssemblyObstacle::Kind::apart:
      return "impossible: in parts";
    case AssemblyObstacle::Kind::remainder:
      return fmt::format("impossible: {} bricks of which none can be put last",
                         made.obstacle->remainder.bricks.count());
    case AssemblyObstacle::Kind::stretch:
      return "impossible: slices too many for the colours";
    case AssemblyObstacle::Kind::runs:
      return "impossible: rows too long for the colours";
    case AssemblyObstacle::Kind::rules:
      return "impossible: no rules do, whatever the colours";
    case AssemblyObstacle::Kind::exhausted:
      break;
  }
  return "impossible: every order was looked at";
}

/// In the process of the target: says what came of it, and ends.
[[noreturn]] void answer(const Target& target, const Named& named, const Abilities& robot,
                         int kinds) {
  AssemblyTask task;
  task.target = target;
  task.robot = robot;
  task.most_colours = kinds;
  task.wording = {"target", named.name, {}};
  AssemblyHooks hooks;
  hooks.deadline = Deadline::after(kPatience * named.most_seconds);
  const Assembly made = assemble(task, 1, hooks);
  std::cout << fmt::format("{:24} {:>7}  {:<52}", named.name, target.cells.size(), in_words(made))
            << std::flush;
  _exit(made.plan ? kFound : made.obstacle ? kImpossible : kUnknown);
}

struct Outcome {
  Answer answer = kUnknown;
  double seconds = 0;  ///< of the processor, in both modes
  double megabytes = 0;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Outcome measure(const Named& named, const Abilities& robot, int kinds, std::size_t& bricks) {
  const Target target = named.draw();
  bricks = target.cells.size();
  std::cout << std::flush;  // or the child would print it again
  const pid_t child = fork();
  if (child == 0) answer(target, named, robot, kinds);
  int status = 0;
  rusage used{};
  while (child > 0 && wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  Outcome out;
  if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) < kAnswers) {
    out.answer = static_cast<Answer>(WEXITSTATUS(status));
  }
  out.seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  out.megabytes = static_cast<double>(used.ru_maxrss) / 1024;
  return out;
}

void print_growth(const char* what, const std::vector<std::pair<double, double>>& points) {
  if (points.size() < 2) return;
  const Growth growth = growth_of(points);
  std::cout << fmt::format("{}: seconds ~ {:.2g} · bricks^{:.2f}, of {} targets\n", what,
                           growth.factor, growth.exponent, points.size());
}

}  // namespace

bool measure_named(const Abilities& robot, int kinds) {
  std::cout << fmt::format("{:24} {:>7}  {:<52} {:>8} {:>7} {:>6}\n", "target", "bricks",
                           fmt::format("with {} kinds of brick", kinds), "s", "at most", "MB");
  std::vector<std::pair<double, double>> points[kAnswers];
  bool met = true;
  for (const Named& named : named_targets()) {
    std::size_t bricks = 0;
    const Outcome out = measure(named, robot, kinds, bricks);
    const bool in_time = out.answer != kUnknown && out.seconds <= named.most_seconds;
    std::cout << fmt::format(" {:>8.2f} {:>7.0f} {:>6.0f}{}\n", out.seconds, named.most_seconds,
                             out.megabytes, in_time ? "" : "  MISSED");
    points[out.answer].emplace_back(static_cast<double>(bricks), out.seconds);
    met = met && in_time;
  }
  print_growth("found", points[kFound]);
  print_growth("proved impossible", points[kImpossible]);
  return met;
}

}  // namespace stig::bench
