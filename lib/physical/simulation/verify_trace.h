// SPDX-License-Identifier: MIT
// A trace's scene, run again and compared.
#pragma once

#include <cstdint>
#include <string>

#include "physical/scene/controller_factory.h"
#include "physical/simulation/loaded_scene.h"
#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"
#include "physical/trace/pose_trace.h"

namespace stig::physics {

struct TraceComparison {
  bool identical = false;
  bool interrupted = false;    ///< before any difference: then no verdict
  std::uint64_t compared = 0;  ///< hashes
  std::string difference;      ///< in words; empty when identical
};

/// The controllers must be those with which the trace was made.
TraceComparison verify_trace(const PoseTrace& trace, const LoadedScene& loaded,
                             const RunHooks& hooks,
                             const ControllerFactory& controllers = lua_controllers());

}  // namespace stig::physics
