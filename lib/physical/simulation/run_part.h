// SPDX-License-Identifier: MIT
// A part of a run: what is done before and after each step of physics, and saved with the world.
//
// A part that is saved lists its members once, for both directions (base/byte_members.h), and
// says in `accept` whether what it was given makes sense in this run:
//
//     class Odometer final : public SavedPart<Odometer> {
//      public:
//       void before_step(RunState& run, const RunHooks& hooks) override;
//       static void members(auto& each, auto& odometer) { each.list(odometer.driven_); }
//       bool accept(RunState& run);
//
// It is then a member of RunState, and takes its place in the order of work and in that of bytes,
// both in simulation.cpp.
#pragma once

#include <atomic>
#include <functional>

#include "base/byte_members.h"
#include "physical/robots/crew.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct RunState;

struct RunHooks {
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const CrewLine&)> on_line;  ///< what robots and blocks say
  std::function<void(const World&)> after_step;
};

class RunPart {
 public:
  virtual ~RunPart() = default;
  virtual void before_step(RunState& /*run*/, const RunHooks& /*hooks*/) {}
  virtual void after_step(RunState& /*run*/) {}
  virtual void save(BytesOut& /*out*/) const {}
  /// Takes up what was saved, in a run that has not begun, after its world and the parts that
  /// were saved before this one. False when the bytes are none of this part; the run is then of
  /// no use.
  virtual bool load(BytesIn& /*in*/, RunState& /*run*/) { return true; }
};

template <class Part>
class SavedPart : public RunPart {
 public:
  void save(BytesOut& out) const override { Part::members(out, static_cast<const Part&>(*this)); }
  bool load(BytesIn& in, RunState& run) override {
    Part& part = static_cast<Part&>(*this);
    Part::members(in, part);
    return in.good() && part.accept(run);
  }
};

}  // namespace stig::physics
