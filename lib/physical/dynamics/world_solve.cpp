// SPDX-License-Identifier: MIT
// From bodies and contacts to the solver's tasks, and back. Each island of bodies that contacts
// join is a task of its own: a blow in one asks for more sweeps there and nowhere else, and what
// a robot's wheels take stays in the processor's nearest cache through all small steps.
#include <algorithm>
#include <cmath>

#include "base/islands.h"
#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

constexpr int kFirstSweeps = 50;  ///< times as many sweeps in the first step
constexpr int kFewStoreys = 6;    ///< that one sweep is enough for

/// A free body before this step's forces, which the solver adds in parts, or a fixed one.
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

enum class MemberKind : std::uint8_t { mechanism, grasp, contact };

/// What the solver is given, by its number, and the island that it belongs to.
struct IslandMember {
  std::uint32_t root = 0;
  MemberKind kind = MemberKind::mechanism;
  std::uint32_t number = 0;

  friend auto operator<=>(const IslandMember&, const IslandMember&) = default;
};

/// For whom the islands are: a loose body, a mechanism's first link, or kFloorBody for all that
/// does not give way.
std::uint32_t mover_of(const WorldState& world, std::uint32_t i) {
  if (!takes_part(world, i)) return kFloorBody;
  const std::int32_t number = world.bodies[i].articulation;
  if (number < 0) return world.bodies[i].fixed ? kFloorBody : i;
  return world.articulations.all[static_cast<std::size_t>(number)].links[0].body;
}

/// The members of all islands, one island after the other; in each, mechanisms first.
std::vector<IslandMember> island_members(const WorldState& world) {
  Islands islands(world.bodies.size());
  std::vector<IslandMember> out;
  for (std::uint32_t c = 0; c < world.contacts.size(); ++c) {
    const std::uint32_t a = mover_of(world, world.contacts[c].a);
    const std::uint32_t b = mover_of(world, world.contacts[c].b);
    // Two that do not give way need no solution.
    if (a == kFloorBody && b == kFloorBody) continue;
    if (a != kFloorBody && b != kFloorBody) islands.join(a, b);
    out.push_back({a == kFloorBody ? b : a, MemberKind::contact, c});
  }
  for (std::uint32_t k = 0; k < world.grasps.size(); ++k) {
    const std::uint32_t body = world.grasps[k].body;
    if (takes_part(world, body)) out.push_back({body, MemberKind::grasp, k});
  }
  const auto& all = world.articulations.all;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (awake(world, all[i])) {
      out.push_back({all[i].links[0].body, MemberKind::mechanism, i});
    }
  }
  // Roots are the smallest members, so the order of islands is that of body numbers.
  for (IslandMember& member : out) member.root = islands.root(member.root);
  std::sort(out.begin(), out.end());
  return out;
}

/// Fills tasks, one after the other; remembers which body stands where.
class TaskMaker {
 public:
  TaskMaker(WorldState& world, SolverTask& task)
      : world_(world),
        task_(task),
        slot_(world.bodies.size(), 0),
        mechanism_(world.articulations.all.size()) {}

  /// An island begins. Only the places that were used are cleared, since there may be thousands.
  void clear() {
    for (const std::uint32_t i : numbers_) slot_[i] = 0;
    numbers_.clear();
    last_ = {};
    task_.mechanisms.clear();
    task_.links.clear();
    task_.axes.clear();
    task_.grasps.clear();
    task_.contacts.clear();
    task_.slots.clear();
    task_.bodies.assign(1, {});  // the first: all that does not move
  }
  void add(const IslandMember& member) {
    if (member.kind == MemberKind::mechanism) return add_mechanism(member.number);
    if (member.kind == MemberKind::grasp) return add_grasp(world_.grasps[member.number]);
    const Contact& contact = world_.contacts[member.number];
    if (within_grasp(world_, contact.a, contact.b)) return;
    task_.contacts.push_back(contact);
    task_.slots.emplace_back(slot_of(contact.a), slot_of(contact.b));
  }
  /// The bodies in contact; that of place k in the task is number k - 1.
  const std::vector<std::uint32_t>& numbers() const { return numbers_; }

 private:
  void add_mechanism(std::size_t number) {
    Articulation& it = world_.articulations.all[number];
    mechanism_[number] = static_cast<std::uint32_t>(task_.mechanisms.size());
    add_axes(it, mechanism_[number], world_.config.step, task_.axes);
    // With motors or stops of its own a mechanism is never in free flight.
    it.held = !task_.axes.empty() && task_.axes.back().mechanism == mechanism_[number];
    it.way.assign(it.size(), 0);
    // As for bodies: the solver adds the forces in parts.
    for (std::size_t i = 0; i < it.size(); ++i) it.v[i] -= it.kick[i];
    task_.mechanisms.push_back(
        {it.size(), it.inverse.data(), it.v.data(), it.kick.data(), it.way.data()});
  }

  void add_grasp(const Grasp& grasp) {
    if (!holds(world_, grasp)) return;
    const Contact& contact = grasp.contacts[0];
    const std::uint32_t link = contact.a == grasp.body ? contact.b : contact.a;
    task_.grasps.push_back({slot_of(link), slot_of(grasp.body), grasp.impulse});
  }

  /// Bodies of a part mostly come one after the other, and move as it does, whichever of them
  /// touches.
  const PartMotion& motion_of(const Articulation& it, std::uint32_t part) {
    if (last_ != std::pair(&it, part)) {
      last_ = {&it, part};
      last_motion_ = part_motion(it, part, it.v);
    }
    return last_motion_;
  }

  SolverBody link_body(const Body& body) {
    Articulation& it = world_.articulations.all[static_cast<std::size_t>(body.articulation)];
    it.held = true;
    SolverBody out;
    out.p = body.p;
    out.link = static_cast<std::int32_t>(task_.links.size());
    const auto& [motion, change] = motion_of(it, body.part);
    task_.links.push_back({mechanism_[static_cast<std::size_t>(body.articulation)],
                           it.poses[body.part].p, it.columns_of(body.part), motion.w, change.v,
                           change.w});
    return out;
  }

  /// A body gets its place when a contact first asks for it. The floor and bodies that are not
  /// awake share the first place of a task, which nothing moves.
  std::uint32_t slot_of(std::uint32_t i) {
    if (i == kFloorBody || !world_.bodies[i].awake) return 0;
    if (slot_[i] == 0) {
      slot_[i] = static_cast<std::uint32_t>(task_.bodies.size());
      numbers_.push_back(i);
      const Body& body = world_.bodies[i];
      task_.bodies.push_back(body.articulation < 0 ? solver_body(body) : link_body(body));
    }
    return slot_[i];
  }

  WorldState& world_;
  SolverTask& task_;
  std::vector<std::uint32_t> slot_, mechanism_, numbers_;
  std::pair<const Articulation*, std::uint32_t> last_{};
  PartMotion last_motion_;
};

/// The most bodies one upon the other, as contacts lead up from what does not move, breadth first:
/// each body counts by its shortest way up.
int storeys(const SolverTask& task) {
  if (task.contacts.size() <= kFewStoreys) return 0;  // no more than these
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
  // The queue is the list itself.
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

/// High columns need more sweeps: with one they sway for ever, and turn by it. The numbers were
/// tried on columns and walls: fewer let them fall, more cost time for nothing.
int sweeps_for(int storeys) { return storeys <= kFewStoreys ? 1 : storeys <= 10 ? 2 : 8; }

void take_over(WorldState& world, const TaskMaker& maker, const SolverTask& task) {
  for (std::size_t k = 0; k < maker.numbers().size(); ++k) {
    Body& body = world.bodies[maker.numbers()[k]];
    const SolverBody& out = task.bodies[k + 1];
    body.free = false;
    if (body.articulation >= 0) continue;
    body.v = out.v;
    body.w = out.w;
    body.way_v = out.way_v;
    body.way_w = out.way_w;
  }
}

/// Returns the place behind its axes.
std::size_t take_over(WorldState& world, Articulation& it, const SolverTask& task, std::size_t at) {
  at = keep_axes(it, task.axes, at);
  // It flies if none of its bodies touches anything.
  bool supported = !it.floating;
  for (const LinkBody& link : it.links) supported = supported || !world.bodies[link.body].free;
  for (const LinkBody& link : it.links) world.bodies[link.body].free = !supported;
  note_motions(it);
  set_body_velocities(it, world.bodies);
  return at;
}

using MemberIterator = std::vector<IslandMember>::const_iterator;

void solve_members(const WorldState& world, TaskMaker& maker, SolverTask& task,
                   MemberIterator begin, MemberIterator end) {
  // In the order of members, which is fixed by their numbers.
  maker.clear();
  std::for_each(begin, end, [&](const IslandMember& member) { maker.add(member); });
  // What is spawned at rest finds its forces at once, instead of sinking while they grow.
  task.sweeps =
      world.config.sweeps * sweeps_for(storeys(task)) * (world.tick == 0 ? kFirstSweeps : 1);
  solve(task);
}

/// Velocities of the island's mechanisms, one after the other, with this step's forces.
std::vector<double> mechanism_velocities(const WorldState& world, MemberIterator begin,
                                         MemberIterator end) {
  std::vector<double> out;
  for (; begin != end && begin->kind == MemberKind::mechanism; ++begin) {
    const std::vector<double>& v = world.articulations.all[begin->number].v;
    out.insert(out.end(), v.begin(), v.end());
  }
  return out;
}

void set_mechanism_velocities(WorldState& world, const std::vector<double>& from,
                              MemberIterator begin, MemberIterator end) {
  for (std::size_t at = 0; begin != end && begin->kind == MemberKind::mechanism; ++begin) {
    std::vector<double>& v = world.articulations.all[begin->number].v;
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(at), v.size(), v.begin());
    at += v.size();
  }
}

/// Gives up each of the island's grasps whose contacts cannot bear what came out. False: one was.
bool all_bear(WorldState& world, const SolverTask& task, MemberIterator begin, MemberIterator end) {
  bool all = true;
  std::size_t next = 0;
  for (; begin != end; ++begin) {
    if (begin->kind != MemberKind::grasp || !holds(world, world.grasps[begin->number])) continue;
    all = bears(world, begin->number, task.grasps[next++].impulse) && all;
  }
  return all;
}

void solve_island(WorldState& world, TaskMaker& maker, SolverTask& task, MemberIterator begin,
                  MemberIterator end) {
  const bool grasps = std::any_of(
      begin, end, [](const IslandMember& one) { return one.kind == MemberKind::grasp; });
  const std::vector<double> before =
      grasps ? mechanism_velocities(world, begin, end) : std::vector<double>{};
  solve_members(world, maker, task, begin, end);
  // The step begins anew where contacts take over: a joint holds for no moment longer.
  while (grasps && !all_bear(world, task, begin, end)) {
    set_mechanism_velocities(world, before, begin, end);
    solve_members(world, maker, task, begin, end);
  }
  take_over(world, maker, task);
  std::size_t axis = 0, contact = 0;
  for (auto member = begin; member != end; ++member) {
    switch (member->kind) {
      case MemberKind::mechanism:
        axis = take_over(world, world.articulations.all[member->number], task, axis);
        break;
      case MemberKind::grasp:
        break;  // bears() has kept what came out
      case MemberKind::contact: {
        Contact& own = world.contacts[member->number];
        if (!within_grasp(world, own.a, own.b)) own = task.contacts[contact++];
        break;
      }
    }
  }
}

}  // namespace

void solve_world(WorldState& world) {
  // Kept from step to step for its memory alone, of which it takes much.
  thread_local SolverTask task;
  task.dt = world.config.step;
  task.small_steps = world.config.small_steps;
  TaskMaker maker(world, task);
  for (const std::uint32_t i : world.awake) world.bodies[i].free = true;
  const std::vector<IslandMember> members = island_members(world);
  for (auto begin = members.begin(); begin != members.end();) {
    const auto end = std::find_if(begin, members.end(),
                                  [&](const IslandMember& one) { return one.root != begin->root; });
    solve_island(world, maker, task, begin, end);
    begin = end;
  }
}

}  // namespace stig::physics
