// SPDX-License-Identifier: MIT
// The robots and blocks of a run, with their controllers.
#pragma once

#include <array>
#include <optional>

#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct ControllerFactory;
struct PlacedScene;
struct Scene;

class RunAgents final : public RunPart {
 public:
  RunAgents(const Scene& scene, const PlacedScene& placed, bool resumable,
            const ControllerFactory& controllers);

  /// Null in a scene without controllers and script.
  const Crew* crew() const { return crew_ ? &*crew_ : nullptr; }
  Crew* crew() { return crew_ ? &*crew_ : nullptr; }
  /// A block that has come into the world.
  void add(const RunState& run, std::size_t body);

  /// A control tick where one is due; what programs say goes to the hooks and the trace.
  void before_step(RunState& run, const RunHooks& hooks) override;
  void save(BytesOut& out) const override;
  bool load(BytesIn& in, RunState& run) override;

 private:
  std::optional<Crew> crew_;
};

/// What a block's LEDs show now; most of them.
Led led_of(const RunState& run, std::size_t body);
/// Likewise of each face, in the order of its radios.
std::array<int, 6> faces_of(const RunState& run, std::size_t body);

}  // namespace stig::physics
