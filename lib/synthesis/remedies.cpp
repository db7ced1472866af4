// SPDX-License-Identifier: MIT
// Tries what a user could change and reports only what worked. Each trial is a synthesis of
// its own with a sixth of the effort, so an answer costs at most about as much as the
// failed search. Remedies are phrased as options of `stigc synth`, ready to be used.
#include "synthesis/remedies.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "rules/cell_text.h"
#include "synthesis/reasons.h"
#include "synthesis/recolour.h"
#include "synthesis/scaffold.h"

namespace stig::synthesis {
namespace {

using Kind = Obstacle::Kind;

class RemedyFinder {
 public:
  RemedyFinder(const Target& target, const SynthesisOptions& options, const SynthesisHooks& hooks)
      : target_(target), options_(options), hooks_(hooks), each_(options.effort / kTries) {}

  std::vector<std::string> find(const Obstacle& obstacle) {
    switch (obstacle.kind) {
      case Kind::bad_start:
        other_start();
        break;
      case Kind::not_connected:
        start_in_each_part();
        break;
      case Kind::asymmetric:
        other_start();
        smaller_group();
        break;
      case Kind::look_alike:
      case Kind::colours:
        more_colours();
        other_start();
        free_colours();
        recolour();
        scaffold();
        break;
    }
    return std::move(remedies_);
  }

 private:
  std::optional<Solution> tried(const Target& target, SynthesisOptions options) {
    options.effort = each_;
    return synthesise(target, options, hooks_).best;
  }

  void add(const std::string& what, const Solution& solution) {
    remedies_.push_back(fmt::format(
        "{} ({}, {})", what, counted(static_cast<std::size_t>(solution.colour_count), "colour"),
        counted(solution.rules.size(), "rule")));
  }

  /// The start that was given may be the obstacle; the likely ones are tried in its place.
  void other_start() {
    if (options_.start.empty()) return;
    SynthesisOptions options = options_;
    options.start.clear();
    const auto solution = tried(target_, options);
    if (!solution) return;
    std::string starts;
    for (std::size_t i = 0; i < solution->frame->cells.size(); ++i) {
      const auto orbit = static_cast<std::size_t>(solution->frame->orbit_of[i]);
      if (!solution->frame->orbits[orbit].start) continue;
      const Cell c = solution->frame->cells[i];
      starts += fmt::format("--start {},{},{} ", c.x, c.y, c.z);
    }
    starts.pop_back();
    add(starts, *solution);
  }

  /// A subgroup asks for less symmetry of the target, at the price of more rules.
  void smaller_group() {
    SynthesisOptions options = options_;
    for (const Symmetry smaller : {Symmetry::rotations, Symmetry::none}) {
      if (smaller >= options_.symmetry) continue;
      options.symmetry = smaller;
      if (const auto solution = tried(target_, options)) {
        return add(fmt::format("--symmetry {}", to_string(smaller)), *solution);
      }
    }
  }

  /// Under a symmetry the start has to be mapped to itself, which one cell of each part is
  /// not.
  void start_in_each_part() {
    if (options_.symmetry != Symmetry::none) return;
    SynthesisOptions options = options_;
    options.start = one_of_each_part(target_, options_.start);
    if (options.start.size() > kMostStarts) return;
    const auto solution = tried(target_, options);
    if (!solution) return;
    std::string starts;
    for (const Cell c : options.start) {
      starts += fmt::format("{}--start {},{},{}", starts.empty() ? "" : " ", c.x, c.y, c.z);
    }
    add(starts, *solution);
  }

  void more_colours() {
    if (options_.most_colours >= kMaxColours) return;
    SynthesisOptions options = options_;
    options.most_colours = kMaxColours;
    if (const auto solution = tried(target_, options)) {
      const int more = solution->colour_count - options_.most_colours;
      add(fmt::format("--colours {}, {} more", solution->colour_count, more), *solution);
    }
  }

  /// Colours that a file gives are a demand on the rules; without them the shape may well be
  /// buildable.
  void free_colours() {
    if (target_.bricks.empty()) return;
    Target free = target_;
    free.bricks.clear();
    free.colours.assign(free.cells.size(), StateSet::anything());
    SynthesisOptions options = options_;
    if (const auto solution = tried(free, options)) add("--colours free", *solution);
  }

  void recolour() {
    const Placing placing{options_.start.empty()
                              ? likely_starts(target_, options_.symmetry, options_.floor).front()
                              : options_.start,
                          options_.symmetry, options_.floor};
    Effort effort(hooks_.deadline);
    const auto found = find_recolouring(
        target_, placing, {&effort, static_cast<std::uint64_t>(each_ * kStepsOfEffort)});
    if (!found || found->changes.size() > kMostChanges) return;
    const auto solution = tried(found->target, options_);
    if (!solution) return;
    std::string changes;
    for (const auto& [cell, colour] : found->changes) {
      changes += fmt::format("{}{} as {}", changes.empty() ? "" : ", ", cell_text(cell),
                             target_.bricks[colour - 1U].symbol);
    }
    add(fmt::format("colour {}", changes), *solution);
  }

  /// Cells beside those that have to count, or on them: three times as many at most. The
  /// plain target is solved with all colours first: its clique shows which cells have to
  /// count.
  void scaffold() {
    SynthesisOptions options = options_;
    options.most_colours = kMaxColours;
    const auto plain = tried(target_, options);
    const std::vector<Cell> run =
        plain ? counting_cells(*plain, static_cast<int>(target_.bricks.size()))
              : longest_run(target_);
    const auto found = find_scaffold(target_, run, 3 * run.size(), options_.most_colours + 1,
                                     options_, each_, hooks_);
    if (!found) return;
    add(fmt::format("--scaffold {}", found->cells.size()), *found->result.best);
  }

  /// One try may take this part of the effort.
  static constexpr double kTries = 6;
  static constexpr std::size_t kMostStarts = 16, kMostChanges = 12;
  const Target& target_;
  const SynthesisOptions& options_;
  const SynthesisHooks& hooks_;
  double each_;
  std::vector<std::string> remedies_;
};

}  // namespace

std::vector<std::string> find_remedies(const Target& target, const SynthesisOptions& options,
                                       const Obstacle& obstacle, const SynthesisHooks& hooks) {
  return RemedyFinder(target, options, hooks).find(obstacle);
}

}  // namespace stig::synthesis
