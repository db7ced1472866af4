// SPDX-License-Identifier: MIT
// Members are listed once, for both directions (base/byte_members.h).
#include "validate/trial_bytes.h"

#include <utility>

#include "base/byte_members.h"

namespace stig::validate {
namespace {

/// A number that is kept in another type.
template <class Wide>
void as(auto& each, auto& value) {
  auto wide = static_cast<Wide>(value);
  each(wide);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(value)>>) {
    value = static_cast<std::remove_reference_t<decltype(value)>>(wide);
  }
}

template <class Value>
void members(auto& each, std::optional<Value>& value, auto member) {
  bool there = value.has_value();
  each(there);
  if (!there) return;
  if (!value) value.emplace();
  member(*value);
}
template <class Value>
void members(auto& each, const std::optional<Value>& value, auto member) {
  each(value.has_value());
  if (value) member(*value);
}

template <class Key>
void pairs(auto& each, std::map<Key, double>& map) {
  std::uint64_t size = map.size();
  each(size);
  // Each takes a byte at least.
  for (std::uint64_t i = 0; i < size && each.good(); ++i) {
    Key key{};
    each(key);
    each(map[key]);
  }
}
template <class Key>
void pairs(auto& each, const std::map<Key, double>& map) {
  each(static_cast<std::uint64_t>(map.size()));
  for (const auto& [key, value] : map) each(key), each(value);
}

}  // namespace

void each_member(auto& each, EitherWay<Cell> auto& cell) {
  each(cell.x), each(cell.y), each(cell.z);
}
void each_member(auto& each, EitherWay<BrickCheck> auto& b) {
  each_member(each, b.cell), as<int>(each, b.wanted), each(b.start);
  members(each, b.block, [&](auto& block) { each(block); });
  as<int>(each, b.led), each_member(each, b.off), each(b.yaw), each(b.turn);
  each_member(each, b.drift), each(b.close), each(b.coloured);
  each(b.dead);
}
void each_member(auto& each, EitherWay<StrayBrick> auto& s) {
  each(s.block), each_member(each, s.cell), as<int>(each, s.led), each_member(each, s.off);
  each(s.yaw), each(s.in_cell);
}
void each_member(auto& each, EitherWay<LooseJoint> auto& j) {
  each_member(each, j.a), each_member(each, j.b), each(j.way), each(j.turn);
}
void each_member(auto& each, EitherWay<Judgement> auto& j) {
  each.choice(j.verdict, BuildVerdict::wrong), each.list(j.bricks), each.list(j.extra);
  each(j.placements), each(j.allowed);
  members(each, j.against, [&](auto& against) { each(against.event), each(against.reason); });
  each(j.worst_way), each(j.worst_turn), each(j.worst_joint_way), each(j.worst_joint_turn);
  each(j.worst_drift), each.list(j.loose);
}
void each_member(auto& each, EitherWay<BrickEvent> auto& e) {
  each.choice(e.kind, BrickEvent::Kind::left), each(e.time), each(e.block);
  each_member(each, e.cell), as<int>(each, e.led), each(e.robot), each(e.structure);
}
void each_member(auto& each, EitherWay<Haul> auto& h) {
  each(h.robot), each(h.block), each(h.from), each(h.to), each(h.way);
  each_member(each, h.taken), each_member(each, h.put), each(h.ended);
  members(each, h.placed, [&](auto& cell) { each_member(each, cell); });
  each(h.structure);
}
void each_member(auto& each, EitherWay<TimeSpan> auto& span) { each(span.from), each(span.to); }
void each_member(auto& each, EitherWay<RobotRecord> auto& r) {
  each(r.name), each_member(each, r.X_WR), each(r.driven), pairs(each, r.spent), each(r.state);
  each(r.since), pairs(each, r.shown), each(r.ideal), each(r.still), each.list(r.idle);
  pairs(each, r.idle_in), each.list(r.busy);
  each(r.energy.wheels), each(r.energy.lift), each(r.energy.current_time);
  each(r.failed), each(r.halted), each(r.left), each(r.fallen), each(r.holding);
}
void each_member(auto& each, EitherWay<WatchedBlock> auto& b) {
  each(b.block), each_member(each, b.X_WB), as<int>(each, b.led), each(b.fixed);
  each(b.dead);
}
void each_member(auto& each, EitherWay<BlockCount> auto& c) {
  each(c.began), each(c.dropped), each(c.structure), each(c.caches), each(c.carried);
  each(c.loose), each(c.fixed), each(c.left);
}
void each_member(auto& each, EitherWay<TrialLine> auto& l) {
  each(l.time), each(l.who), each(l.text), each(l.failure);
}
void each_member(auto& each, EitherWay<TrialPicture> auto& p) { each(p.time), each(p.png); }
void each_member(auto& each, EitherWay<Trial> auto& t) {
  each(t.seed), each(t.hash), each.choice(t.end, TrialEnd::script_failed), each(t.message);
  each(t.time), each.list(t.judgements), each.list(t.events), each.list(t.hauls);
  each.list(t.robots), each.list(t.loose), each_member(each, t.blocks), each.list(t.broken);
  each.list(t.caches);
  each.list(t.lines), each.list(t.pictures), pairs(each, t.measures);
}

std::string trial_bytes(const Trial& trial) {
  BytesOut out;
  each_member(out, trial);
  return out.take();
}

std::optional<Trial> trial_of(std::string_view bytes) {
  ByteReader reader(bytes);
  BytesIn in(reader);
  Trial trial;
  each_member(in, trial);
  if (!in.good() || reader.left() > 0) return std::nullopt;
  return trial;
}

}  // namespace stig::validate
