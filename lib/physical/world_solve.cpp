// SPDX-License-Identifier: MIT
// From bodies and contacts to the solver's task, and back.
#include <algorithm>
#include <cmath>

#include "physical/world_state.h"

namespace stig {

namespace {

constexpr int kFirstSweeps = 50;  ///< times as many sweeps in the first step

/// A free body before this step's forces, or a fixed one.
SolverBody solver_body(const Body& body) {
  SolverBody out;
  out.p = body.p;
  out.v = body.v;
  out.w = body.w;
  if (body.fixed) return out;
  out.v -= body.kick_v;
  out.w -= body.kick_w;
  out.kick_v = body.kick_v;
  out.kick_w = body.kick_w;
  out.inverse_mass = 1 / body.mass;
  out.inverse_inertia = body.inverse_inertia();
  return out;
}

/// Fills a task; remembers which body stands where.
class TaskMaker {
 public:
  TaskMaker(WorldState& world, SolverTask& task)
      : world_(world),
        task_(task),
        slot_(world.bodies.size(), 0),
        mechanism_(world.articulations.all.size()) {
    task_.mechanisms.clear();
    task_.links.clear();
    task_.axes.clear();
    task_.contacts.clear();
    task_.slots.clear();
    task_.bodies.assign(1, {});  // the first: all that does not move
    for (std::size_t i = 0; i < mechanism_.size(); ++i) {
      if (awake(world, world.articulations.all[i])) add_mechanism(i);
    }
    for (const Contact& contact : world.contacts) {
      if (!takes_part(world, contact.a) && !takes_part(world, contact.b)) continue;
      task_.contacts.push_back(contact);
      task_.slots.emplace_back(slot_of(contact.a), slot_of(contact.b));
    }
  }

  /// Null: the body is in no contact.
  const SolverBody* result(std::uint32_t body) const {
    return slot_[body] == 0 ? nullptr : &task_.bodies[slot_[body]];
  }

 private:
  void add_mechanism(std::size_t number) {
    Articulation& it = world_.articulations.all[number];
    mechanism_[number] = static_cast<std::uint32_t>(task_.mechanisms.size());
    add_axes(it, mechanism_[number], world_.config.step, task_.axes);
    it.held = !task_.axes.empty() && task_.axes.back().mechanism == mechanism_[number];
    it.way.assign(it.size(), 0);
    for (std::size_t i = 0; i < it.size(); ++i) it.v[i] -= it.kick[i];
    task_.mechanisms.push_back(
        {it.size(), it.inverse.data(), it.v.data(), it.kick.data(), it.way.data()});
  }

  SolverBody link_body(const Body& body) {
    Articulation& it = world_.articulations.all[static_cast<std::size_t>(body.articulation)];
    it.held = true;
    SolverBody out;
    out.p = body.p;
    out.link = static_cast<std::int32_t>(task_.links.size());
    const auto [motion, change] = part_motion(it, body.part, it.v);
    task_.links.push_back({mechanism_[static_cast<std::size_t>(body.articulation)],
                           it.poses[body.part].p, it.columns_of(body.part), motion.w, change.v,
                           change.w});
    return out;
  }

  std::uint32_t slot_of(std::uint32_t i) {
    if (i == kFloorBody || !world_.bodies[i].awake) return 0;
    if (slot_[i] == 0) {
      slot_[i] = static_cast<std::uint32_t>(task_.bodies.size());
      const Body& body = world_.bodies[i];
      task_.bodies.push_back(body.articulation < 0 ? solver_body(body) : link_body(body));
    }
    return slot_[i];
  }

  WorldState& world_;
  SolverTask& task_;
  std::vector<std::uint32_t> slot_, mechanism_;
};

/// The most bodies one upon the other, as contacts lead up from what does not move.
int storeys(const SolverTask& task) {
  // Who lies upon whom, both ways; side by side is no storey.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> upon;
  for (std::size_t c = 0; c < task.contacts.size(); ++c) {
    const auto [a, b] = task.slots[c];
    if (std::abs(task.contacts[c].normal.z) < 0.5) continue;
    upon.emplace_back(a, b);
    upon.emplace_back(b, a);
  }
  std::sort(upon.begin(), upon.end());
  std::vector<int> level(task.bodies.size(), -1);
  std::vector<std::uint32_t> todo;
  for (std::uint32_t i = 0; i < task.bodies.size(); ++i) {
    if (task.bodies[i].inverse_mass > 0 || task.bodies[i].link >= 0) continue;
    level[i] = 0;
    todo.push_back(i);
  }
  int most = 0;
  for (std::size_t next = 0; next < todo.size(); ++next) {
    const std::uint32_t below = todo[next];
    auto at = std::lower_bound(upon.begin(), upon.end(), std::pair(below, std::uint32_t{0}));
    for (; at != upon.end() && at->first == below; ++at) {
      if (level[at->second] >= 0) continue;
      most = std::max(most, level[at->second] = level[below] + 1);
      todo.push_back(at->second);
    }
  }
  return most;
}

/// High columns need more sweeps: with one they sway for ever, and turn by it.
int sweeps_for(int storeys) { return storeys <= 6 ? 1 : storeys <= 10 ? 2 : 8; }

void take_over(WorldState& world, const TaskMaker& maker) {
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    const SolverBody* out = maker.result(i);
    body.free = out == nullptr;
    if (out == nullptr || body.articulation >= 0) continue;
    body.v = out->v;
    body.w = out->w;
    body.way_v = out->way_v;
    body.way_w = out->way_w;
  }
}

void take_over_mechanisms(WorldState& world, const SolverTask& task) {
  std::size_t at = 0;
  for (Articulation& it : world.articulations.all) {
    if (!awake(world, it)) continue;
    at = keep_axes(it, task.axes, at);
    bool supported = !it.floating;
    for (const LinkBody& link : it.links) supported = supported || !world.bodies[link.body].free;
    for (const LinkBody& link : it.links) world.bodies[link.body].free = !supported;
    note_motions(it);
    set_body_velocities(it, world.bodies);
  }
}

}  // namespace

void solve_world(WorldState& world) {
  // Kept from step to step for its memory alone, of which it takes much.
  thread_local SolverTask task;
  const TaskMaker maker(world, task);
  task.dt = world.config.step;
  task.small_steps = world.config.small_steps;
  // What is spawned at rest finds its forces at once, instead of sinking while they grow.
  task.sweeps =
      world.config.sweeps * sweeps_for(storeys(task)) * (world.tick == 0 ? kFirstSweeps : 1);
  solve(task);
  auto solved = task.contacts.begin();
  for (Contact& contact : world.contacts) {
    if (solved != task.contacts.end() && key(*solved) == key(contact)) contact = *solved++;
  }
  take_over(world, maker);
  take_over_mechanisms(world, task);
}

}  // namespace stig
