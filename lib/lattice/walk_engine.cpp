// SPDX-License-Identifier: MIT
// Walk motion in a box: agents and enabled sites live in one dense
// array of flag bytes, padded by a cell all round (solid sides, or portals to the
// other side); the structure itself stays in the world. In large boxes the kernel has two bits a
// cell beside the bytes, and agents are in these alone while they walk.
#include <algorithm>
#include <cassert>

#include "lattice/agent_orders.h"
#include "lattice/engines.h"
#include "lattice/walk_kernel.h"

namespace stig::lattice {
namespace {

/// From so many cells on, with the padding, bits are faster than bytes.
constexpr std::int32_t kPackedFrom = 1 << 18;

/// Dense indices of a padded box.
struct Field {
  Box box;
  std::int32_t row = 0, slice = 0, size = 0;

  explicit Field(const Box& b) : box(b), row(b.size.x + 2), slice(row * (b.size.y + 2)) {
    size = slice * (b.size.z + 2);
  }
  // The padding makes every move from a cell of the box a valid index, without a test of
  // bounds.
  std::int32_t index(Cell c) const {
    const Offset o = c - box.low;
    return (o.z + 1) * slice + (o.y + 1) * row + o.x + 1;
  }
  Cell cell(std::int32_t index) const {
    return box.low + Offset{index % row - 1, index % slice / row - 1, index / slice - 1};
  }
  std::int32_t step(Offset o) const { return o.z * slice + o.y * row + o.x; }
};

Moves moves_of(const Field& field, const Neighbourhood& n, int count) {
  Moves moves;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const bool chosen = count == n.size || n.is_face[i] || (count == 18 && n.is_edge[i]);
    if (chosen) moves.step[moves.count++] = field.step(n.offsets[i]);
  }
  assert(moves.count == static_cast<std::uint32_t>(count));
  return moves;
}

class WalkRun {
 public:
  WalkRun(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks);
  SwarmResult run();

 private:
  void mark_sides();
  std::uint8_t side_flag(Cell cell) const;
  void place_agents();
  std::int32_t random_free_cell(std::uint32_t agent) const;
  void put_agent(std::int32_t cell);
  void pack();
  void unpack();
  void fill();

  Terminated steps();
  bool sweep();
  bool stimulate(std::uint32_t agent);
  void walk(std::uint32_t agent);
  bool ended() const { return enabled_ == 0 || log_.deposits_spent() || world_.stage_spent(); }

  std::uint8_t& flags(std::int32_t index) { return flags_[static_cast<std::size_t>(index)]; }
  bool is(std::int32_t index, int bits) const {
    return (flags_[static_cast<std::size_t>(index)] & bits) != 0;
  }
  std::int32_t portal(std::int32_t index) const {
    return field_.index(world_.wrap(field_.cell(index)));
  }
  void set_enabled(std::int32_t index, bool enabled);
  void set_bit(std::int32_t index, std::uint64_t bit, bool on);
  std::int32_t cell_of_agent(std::uint32_t agent) const {
    return packed_ ? static_cast<std::int32_t>(static_cast<std::uint32_t>(position_[agent]) / 2)
                   : position_[agent];
  }
  bool occupied(std::int32_t index) const;
  void move_agent(std::uint32_t agent, std::int32_t to);
  std::uint64_t unreachable() const;
  bool flood_meets_agent(std::int32_t site, std::vector<std::uint8_t>& seen) const;

  LatticeWorld world_;
  const SwarmConfig* config_;
  RunLog log_;
  Field field_;
  Moves moves_;
  bool packed_;  ///< are bits_ in use?
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::int32_t> position_;              ///< indices; twice these where packed_
  std::array<std::vector<std::int32_t>, 4> steps_;  ///< moves of four steps, by agent
  const std::int32_t* move_ = nullptr;              ///< of this step, by agent
  AgentOrders orders_;
  WalkOrder order_;
  std::uint64_t enabled_ = 0;  ///< number of enabled cells
  std::uint64_t step_ = 0;
};

WalkRun::WalkRun(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks)
    : world_(std::move(world)),
      config_(&config),
      log_(config, hooks, world_.rules().rule_count()),
      field_(*config.box),
      moves_(moves_of(field_, world_.rules().neighbours(), config.moves)),
      packed_(false),
      flags_(static_cast<std::size_t>(field_.size) + 4),
      orders_(config.seed, config.run, static_cast<std::uint32_t>(config.agents)) {
  for (auto& steps : steps_) steps.resize(static_cast<std::size_t>(config.agents));
  mark_sides();
  place_agents();
  if (config.vectorise && field_.size >= kPackedFrom) pack();
}

void WalkRun::mark_sides() {
  const Box& box = field_.box;
  const bool floor = world_.rules().floor();
  std::int32_t i = 0;
  for (std::int32_t z = -1; z <= box.size.z; ++z) {
    const bool level_inside = z >= 0 && z < box.size.z && !(floor && box.low.z + z < 0);
    for (std::int32_t y = -1; y <= box.size.y; ++y) {
      const bool row_inside = level_inside && y >= 0 && y < box.size.y;
      for (std::int32_t x = -1; x <= box.size.x; ++x, ++i) {
        if (row_inside && x >= 0 && x < box.size.x) continue;
        flags(i) = side_flag(box.low + Offset{x, y, z});
      }
    }
  }
  world_.structure().for_each([&](Cell cell, Colour) { flags(field_.index(cell)) = kSolidCell; });
}

/// The flag of a cell of the padding, or of one below the floor. A portal stands for the
/// cell across a periodic side.
std::uint8_t WalkRun::side_flag(Cell cell) const {
  const Cell inside = world_.wrap(cell);
  const bool below_floor = world_.rules().floor() && cell.z < 0;
  return below_floor || !field_.box.contains(inside) ? kSolidCell : kPortalCell;
}

void WalkRun::place_agents() {
  position_.reserve(static_cast<std::size_t>(config_->agents));
  for (const Cell cell : config_->agents_at) put_agent(field_.index(cell));
  for (auto a = position_.size(); a < static_cast<std::size_t>(config_->agents); ++a) {
    put_agent(random_free_cell(static_cast<std::uint32_t>(a)));
  }
}

void WalkRun::put_agent(std::int32_t cell) {
  assert(flags(cell) == 0);
  flags(cell) = kAgentCell;
  position_.push_back(cell);
}

/// Goes over to bits: of flags and agents, before any site is enabled.
void WalkRun::pack() {
  packed_ = true;
  bits_.assign(static_cast<std::size_t>(field_.size) / 32 + 1, 0);
  for (std::int32_t i = 0; i < field_.size; ++i) {
    if (is(i, kSolidCell | kAgentCell)) set_bit(i, kOccupiedBit, true);
    if (is(i, kPortalCell)) set_bit(i, kSpecialBit, true);
  }
  for (std::int32_t& position : position_) {
    flags(position) = 0;
    position = static_cast<std::int32_t>(static_cast<std::uint32_t>(position) * 2);
  }
  for (std::size_t m = 0; m < moves_.count; ++m) moves_.step[m] *= 2;
}

/// Back to bytes, for looks at the whole field.
void WalkRun::unpack() {
  for (std::uint32_t agent = 0; agent < position_.size(); ++agent) {
    position_[agent] = cell_of_agent(agent);
    flags(position_[agent]) = static_cast<std::uint8_t>(flags(position_[agent]) | kAgentCell);
  }
  for (std::size_t m = 0; m < moves_.count; ++m) moves_.step[m] /= 2;
  packed_ = false;
}

/// Uniform over the cells without brick and agent.
std::int32_t WalkRun::random_free_cell(std::uint32_t agent) const {
  Random random(config_->seed, config_->run, Purpose::start, agent, 0);
  const Box& box = field_.box;
  const auto below = [&](std::int32_t size) {
    return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(size)));
  };
  // Rejection sampling is uniform; after 64 failures few cells are free, and they are
  // counted.
  for (int attempt = 0; attempt < 64; ++attempt) {
    const Offset o{below(box.size.x), below(box.size.y), below(box.size.z)};
    const std::int32_t cell = field_.index(box.low + o);
    if (flags_[static_cast<std::size_t>(cell)] == 0) return cell;
  }
  // The box is nearly full: count what is free and take one of it.
  const auto last = flags_.begin() + field_.size;
  const auto free = static_cast<std::uint64_t>(std::count(flags_.begin(), last, std::uint8_t{0}));
  assert(free > 0);
  std::uint64_t skip = random.below(free);
  std::int32_t cell = 0;
  while (flags_[static_cast<std::size_t>(cell)] != 0 || skip-- != 0) ++cell;
  return cell;
}

void WalkRun::set_enabled(std::int32_t index, bool enabled) {
  if (is(index, kEnabledCell) == enabled) return;
  flags(index) = static_cast<std::uint8_t>(flags(index) ^ kEnabledCell);
  if (packed_) set_bit(index, kSpecialBit, enabled);
  enabled ? ++enabled_ : --enabled_;
}

void WalkRun::set_bit(std::int32_t index, std::uint64_t bit, bool on) {
  std::uint64_t& word = bits_[static_cast<std::size_t>(index) / 32];
  const std::uint64_t mask = bit << (index % 32 * 2);
  word = on ? word | mask : word & ~mask;
}

/// Enables the sites of the present stage, or of the next that has any.
void WalkRun::fill() {
  do {
    // Every enabled flag is cleared by searching until none is left; stages are few.
    for (std::int32_t i = 0; enabled_ > 0; ++i) set_enabled(i, false);
    for (const Cell site : world_.enabled_sites()) set_enabled(field_.index(site), true);
  } while ((enabled_ == 0 || world_.stage_spent()) && world_.next_stage());
}

SwarmResult WalkRun::run() {
  fill();
  const Terminated end = steps();
  if (packed_) unpack();
  const std::uint64_t left = enabled_;
  return log_.finish(world_, end, left, left == 0 ? 0 : unreachable());
}

Terminated WalkRun::steps() {
  const auto agents = static_cast<std::uint64_t>(config_->agents);
  while (true) {
    if (enabled_ == 0) return Terminated::saturated;
    if (log_.deposits_spent() || world_.stage_spent()) return Terminated::deposits;
    if (log_.limit_reached(agents)) return log_.why();
    step_ = log_.begin_step();
    order_ = orders_.of_step(step_);
    sweep();
  }
}

bool WalkRun::sweep() {
  if (step_ % 4 == 0 || step_ == 1) {
    draw_moves(config_->seed, config_->run, step_ / 4, moves_, config_->vectorise, steps_);
  }
  move_ = steps_[step_ % 4].data();
  std::uint32_t agent = order_.base;
  for (std::uint32_t left = order_.count; left > 0; --left) {
    // The kernel moves agents until one is on an enabled site or at a portal; these two
    // cases are handled here, and the loop goes on.
    left -= packed_ ? walk_some_packed(bits_.data(), position_.data(), move_, order_, agent, left)
                    : walk_some(flags_.data(), position_.data(), move_, order_, agent, left);
    if (left == 0) break;
    if (is(cell_of_agent(agent), kEnabledCell) && stimulate(agent)) return true;
    walk(agent);
    agent = order_.next(agent);
  }
  return false;
}

/// The agent's site matches: deposit, with the rule's probability. True when the run ends.
bool WalkRun::stimulate(std::uint32_t agent) {
  const std::int32_t index = cell_of_agent(agent);
  const Cell site = field_.cell(index);
  Random random(config_->seed, config_->run, Purpose::deposit, agent, step_);
  const Match match = world_.choose(site, random);
  const double probability = world_.rules().probability(match.rule);
  if (probability < 1 && random.unit() >= probability) return false;
  const Colour colour = world_.rules().place(match.rule);
  set_enabled(index, false);
  flags(index) = static_cast<std::uint8_t>(flags(index) | kSolidCell);
  if (packed_) set_bit(index, kSpecialBit, true);  // a brick with an agent in it
  world_.deposit(site, colour, [&](Cell neighbour, const View& view) {
    set_enabled(field_.index(neighbour), world_.rules().enabled(view, neighbour.z, world_.stage()));
  });
  log_.record({site, colour, match, static_cast<std::int32_t>(agent), step_});
  if (enabled_ == 0 || world_.stage_spent()) fill();
  return ended();
}

void WalkRun::walk(std::uint32_t agent) {
  const std::int32_t step = packed_ ? move_[agent] / 2 : move_[agent];
  std::int32_t to = cell_of_agent(agent) + step;
  if (is(to, kPortalCell)) to = portal(to);
  if (!occupied(to)) move_agent(agent, to);
}

bool WalkRun::occupied(std::int32_t index) const {
  if (!packed_) return is(index, kSolidCell | kAgentCell);
  return (bits_[static_cast<std::size_t>(index) / 32] >> (index % 32 * 2) & kOccupiedBit) != 0;
}

void WalkRun::move_agent(std::uint32_t agent, std::int32_t to) {
  const std::int32_t from = cell_of_agent(agent);
  if (!packed_) {
    flags(from) = static_cast<std::uint8_t>(flags(from) & ~kAgentCell);
    flags(to) = static_cast<std::uint8_t>(flags(to) | kAgentCell);
    position_[agent] = to;
    return;
  }
  // A brick stays occupied, and is not special any more.
  set_bit(from, is(from, kSolidCell) ? kSpecialBit : kOccupiedBit, false);
  set_bit(to, kOccupiedBit, true);
  position_[agent] = static_cast<std::int32_t>(static_cast<std::uint32_t>(to) * 2);
}

/// Enabled cells that no agent can get to: a flood from each until it meets an agent.
/// Agents are many and near, so most floods are short.
std::uint64_t WalkRun::unreachable() const {
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(field_.size));  // 1 + reached
  std::uint64_t found = 0;
  for (std::int32_t site = 0; site < field_.size; ++site) {
    if (!is(site, kEnabledCell)) continue;
    const std::uint8_t known = seen[static_cast<std::size_t>(site)];
    found += known != 0 ? known == 1 : !flood_meets_agent(site, seen);
  }
  return found;
}

/// Floods the open cells around a site; true when an agent, or a region known to be
/// reached, is met. Marks the region 2 if so and 1 if not.
bool WalkRun::flood_meets_agent(std::int32_t site, std::vector<std::uint8_t>& seen) const {
  std::vector<std::int32_t> region;
  bool met = false;
  const auto visit = [&](std::int32_t cell) {
    met = met || is(cell, kAgentCell) || seen[static_cast<std::size_t>(cell)] == 2;
    if (is(cell, kSolidCell) || seen[static_cast<std::size_t>(cell)] != 0) return;
    seen[static_cast<std::size_t>(cell)] = 1;
    region.push_back(cell);
  };
  visit(site);
  for (std::size_t next = 0; next < region.size() && !met; ++next) {
    for (std::size_t m = 0; m < moves_.count; ++m) {
      const std::int32_t to = region[next] + moves_.step[m];
      visit(is(to, kPortalCell) ? portal(to) : to);
    }
  }
  if (met) {
    for (const std::int32_t cell : region) seen[static_cast<std::size_t>(cell)] = 2;
  }
  return met;
}

}  // namespace

SwarmResult run_walk(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks) {
  return WalkRun(std::move(world), config, hooks).run();
}

}  // namespace stig::lattice
