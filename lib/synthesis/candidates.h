// SPDX-License-Identifier: MIT
// The orders that a target's cells may be placed in: which can be used at all, and how
// many colours each needs at least.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "synthesis/effort.h"
#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// An order of a frame that may do, and how many colours it needs at least.
struct Candidate {
  std::size_t frame = 0;
  std::function<Order(const Frame&)> make;
  int at_least = 1;
  int refuted = 0;  ///< so many colours do not do
  int least() const { return std::max(at_least, refuted + 1); }
};

/// What an order may cost under these options.
ScheduleLimits schedule_limits(const SynthesisOptions& options);

class Candidates {
 public:
  using Tell = std::function<void(const std::string& what)>;

  /// Target and options must outlive this.
  Candidates(const Target& target, const SynthesisOptions& options, Tell tell)
      : target_(target), options_(options), tell_(std::move(tell)) {}

  void add_start(const std::vector<Cell>& start);
  /// Looks at the families of orders, and for small targets at all that have no ties.
  void look_at_families(const Allowance& looking, const Allowance& whole);
  /// Where every colour is given and no family does: changes orders step by step.
  void search(const Allowance& allowance);
  /// Looks at every order whatsoever, ties and all, from every start there is. True when
  /// it was done: then what no candidate can do cannot be done. False for large targets,
  /// where the options rule orders out, or when the allowance did not suffice.
  bool look_at_every_order(const Allowance& allowance);

  /// Nothing when the time is over.
  std::optional<Schedule> schedule_of(const Candidate& candidate, const Allowance& allowance) const;
  const std::vector<std::shared_ptr<const Frame>>& frames() const { return frames_; }
  std::size_t tried() const { return tried_; }
  /// Is every colour given, so that an order is right or wrong without a solver?
  bool all_given() const;
  /// Why an order cannot do with any number of colours: the first that was met.
  const std::optional<Obstacle>& look_alike() const { return look_alike_; }
  void note_look_alike(const Schedule& schedule, const Clash& clash);

  std::vector<Candidate> list;

 private:
  using Maker = std::function<Order(const Frame&)>;
  void look_at(std::size_t frame, const Maker& make, const Allowance& allowance);
  bool clashes_as_given(const Schedule& schedule, std::size_t frame);
  Colouring given_colours(std::size_t frame) const;
  bool starts_are_all() const;

  const Target& target_;
  const SynthesisOptions& options_;
  Tell tell_;
  std::vector<std::shared_ptr<const Frame>> frames_;
  std::set<std::uint64_t> seen_;
  std::size_t tried_ = 0;
  bool gave_up_ = false;  ///< an order had too many states, or nothing was left to spend
  std::optional<Obstacle> look_alike_;
};

}  // namespace stig::synthesis
