// SPDX-License-Identifier: MIT
// Writes and reads traces. Events are coded as differences of sites and steps in
// variable-length integers, which with zstd takes few bytes per event. A trace may come
// from anywhere: lengths are bounded by what is left, numbers by what they mean, and the
// decompressed size by a limit, before anything is allocated for them.
#include "lattice/trace.h"

#include <cassert>

#include <nlohmann/json.hpp>

#include "base/bytes.h"
#include "base/hash.h"
#include "base/packed.h"
#include "rules/rule_printer.h"

namespace stig::lattice {
namespace {

constexpr std::string_view kMagic = kTraceMagic;
constexpr std::size_t kMostTraceBytes = std::size_t{1} << 29;  ///< decompressed
constexpr std::size_t kMostTraceEvents = std::size_t{1} << 25;
enum Tag : std::uint8_t { kEvent = 1, kHash = 2, kEnd = 3 };

nlohmann::json to_json(Cell c) { return {c.x, c.y, c.z}; }

nlohmann::json header_of(const RuleSet& rules, const SwarmConfig& config, const std::string& kind) {
  nlohmann::json h;
  h["kind"] = kind;
  h["rule_set_hash"] = to_hex(rule_set_hash(rules));
  h["motion"] = to_string(config.motion);
  if (config.box) {
    const Box& box = *config.box;
    h["box"] = {{"low", to_json(box.low)},
                {"size", {box.size.x, box.size.y, box.size.z}},
                {"periodic", box.periodic}};
  }
  h["agents"] = config.agents;
  h["moves"] = config.moves;
  for (const Cell c : config.agents_at) h["agents_at"].push_back(to_json(c));
  h["seed"] = config.seed;
  h["run"] = config.run;
  if (config.max_steps) h["max_steps"] = *config.max_steps;
  if (config.max_deposits) h["max_deposits"] = *config.max_deposits;
  return h;
}

/// An integer within bounds; throws on anything else, fractions included. Fractions and
/// numbers beyond 64 bits would otherwise be converted silently.
std::int64_t integer(const nlohmann::json& j, std::int64_t low, std::int64_t high) {
  if (!j.is_number_integer()) throw std::range_error("integer");
  if (j.is_number_unsigned() && j.get<std::uint64_t>() > static_cast<std::uint64_t>(high)) {
    throw std::range_error("integer");
  }
  const auto value = j.get<std::int64_t>();
  if (value < low || value > high) throw std::range_error("integer");
  return value;
}

std::uint64_t unsigned_integer(const nlohmann::json& j) {
  if (!j.is_number_unsigned()) throw std::range_error("integer");
  return j.get<std::uint64_t>();
}

Cell cell_from(const nlohmann::json& j) {
  const auto at = [&](std::size_t i) {
    return static_cast<std::int32_t>(integer(j.at(i), -kMaxCoordinate, kMaxCoordinate));
  };
  if (j.size() != 3) throw std::range_error("cell");
  return {at(0), at(1), at(2)};
}

/// Names are compared with those that are printed, so reader and writer cannot drift apart.
Motion motion_from(const std::string& name) {
  for (const Motion m : {Motion::walk, Motion::teleport, Motion::event}) {
    if (name == to_string(m)) return m;
  }
  throw std::range_error("motion");
}

/// Throws on anything that is not a header; read_trace turns that into a diagnostic.
/// nlohmann's exceptions and ours end in the same diagnostic; a header is machine-made, so
/// its exact fault is of little use.
void read_header(const std::string& text, Trace& trace) {
  const auto h = nlohmann::json::parse(text);
  trace.kind = h.at("kind").get<std::string>();
  if (trace.kind != "swarm" && trace.kind != "given") throw std::range_error("kind");
  trace.rule_set_hash = std::stoull(h.at("rule_set_hash").get<std::string>(), nullptr, 16);
  SwarmConfig& c = trace.config;
  c.motion = motion_from(h.at("motion").get<std::string>());
  if (h.contains("box")) {
    const Cell size = cell_from(h["box"].at("size"));
    c.box = Box{cell_from(h["box"].at("low")), size - Cell{}, h["box"].at("periodic").get<bool>(),
                false};
  }
  c.agents = static_cast<int>(integer(h.at("agents"), 0, 1 << 30));
  c.moves = static_cast<int>(integer(h.at("moves"), 0, 64));
  if (h.contains("agents_at")) {
    for (const auto& cell : h["agents_at"]) c.agents_at.push_back(cell_from(cell));
  }
  c.seed = unsigned_integer(h.at("seed"));
  c.run = static_cast<std::uint32_t>(integer(h.at("run"), 0, (1 << 24) - 1));
  if (h.contains("max_steps")) c.max_steps = unsigned_integer(h["max_steps"]);
  if (h.contains("max_deposits")) c.max_deposits = unsigned_integer(h["max_deposits"]);
}

/// Coordinates are sums of differences, which in a hostile file may leave their range; they
/// are tested before they are stored.
bool read_event(ByteReader& in, Deposit& last) {
  const auto add = [&](std::int32_t& value) {
    constexpr std::int64_t kFarthest = 2147483647;
    const std::int64_t delta = in.zigzag();
    const bool near = delta >= -2 * kFarthest && delta <= 2 * kFarthest;
    const std::int64_t sum = near ? value + delta : kFarthest + 1;
    if (sum < -kFarthest || sum > kFarthest) in.fail();
    value = static_cast<std::int32_t>(in.good() ? sum : 0);
  };
  add(last.site.x);
  add(last.site.y);
  add(last.site.z);
  const std::uint64_t colour = in.varint();
  const std::uint64_t rule = in.varint(), orientation = in.varint(), agent = in.varint();
  const std::uint64_t limit = 0x7fffffff;
  if (colour < 1 || colour > kMaxColours || rule > limit || orientation > limit || agent > limit) {
    return false;
  }
  last.colour = static_cast<Colour>(colour);
  last.match = {static_cast<std::uint32_t>(rule), static_cast<std::uint32_t>(orientation)};
  last.agent = static_cast<std::int32_t>(agent) - 1;
  last.step += in.varint();
  return in.good();
}

/// What is wrong with the decompressed payload; empty: nothing. A tag leads
/// each record; an unknown one is an error, and so is a payload without its end mark.
std::string read_payload(const std::string& payload, Trace& trace) {
  ByteReader in(payload);
  const std::string header(in.block());
  trace.rule_set_yaml = std::string(in.block());
  if (!in.good()) return "its header is cut short";
  try {
    read_header(header, trace);
  } catch (const std::exception&) {
    return "its header is malformed";
  }
  // Events are relative to the one before, so one record is updated in place.
  Deposit event;
  while (true) {
    const std::uint8_t tag = in.u8();
    if (tag == kEvent) {
      if (trace.events.size() == kMostTraceEvents) return "it has more events than can be held";
      if (!read_event(in, event))
        return "event " + std::to_string(trace.events.size() + 1) + " is malformed";
      trace.events.push_back(event);
    } else if (tag == kHash) {
      trace.hashes.push_back(in.u64());
    } else if (tag == kEnd) {
      trace.steps = in.varint();
      const std::uint64_t why = in.varint();
      trace.final_hash = in.u64();
      if (!in.good() || why > 3) return "its end is malformed";
      trace.terminated = static_cast<Terminated>(why);
      return in.left() == 0 ? "" : "there are bytes after its end";
    } else {
      return "it ends before its end mark";
    }
  }
}

}  // namespace

/// The payload is compressed as it comes, so the writer holds little more than the
/// compressed bytes.
struct TraceWriter::State {
  PackedStream stream;
  std::string pending;  ///< not yet packed
  std::string bytes{kMagic};
  Deposit last;
  std::uint64_t events = 0;
  std::uint64_t hash = 0;
};

TraceWriter::TraceWriter(const RuleSet& rules, const SwarmConfig& config, const std::string& kind)
    : state_(std::make_unique<State>()) {
  assert(kind == "swarm" || kind == "given");
  put_block(state_->pending, header_of(rules, config, kind).dump());
  put_block(state_->pending, print_rule_set(rules));
  for (const PlacedBrick& b : rules.start) state_->hash += placement_hash(b.at, b.brick);
}

TraceWriter::~TraceWriter() = default;

void TraceWriter::deposit(const Deposit& d) {
  assert(d.agent >= -1);
  State& s = *state_;
  std::string& out = s.pending;
  out.push_back(static_cast<char>(kEvent));
  put_zigzag(out, std::int64_t{d.site.x} - s.last.site.x);
  put_zigzag(out, std::int64_t{d.site.y} - s.last.site.y);
  put_zigzag(out, std::int64_t{d.site.z} - s.last.site.z);
  put_varint(out, d.colour);
  put_varint(out, d.match.rule);
  put_varint(out, d.match.orientation);
  put_varint(out, static_cast<std::uint64_t>(d.agent + 1));
  put_varint(out, d.step - s.last.step);
  s.last = d;
  s.hash += placement_hash(d.site, d.colour);
  if (++s.events % kTraceHashEvery == 0) {
    out.push_back(static_cast<char>(kHash));
    put(out, s.hash);
  }
  // 64 KB at a time: large enough to compress well, small next to the rest of a run.
  if (out.size() > 1U << 16) {
    s.stream.add(out, s.bytes);
    out.clear();
  }
}

std::string TraceWriter::finish(std::uint64_t steps, Terminated terminated) {
  State& s = *state_;
  s.pending.push_back(static_cast<char>(kEnd));
  put_varint(s.pending, steps);
  put_varint(s.pending, static_cast<std::uint64_t>(terminated));
  put(s.pending, s.hash);
  s.stream.finish(s.pending, s.bytes);
  return std::move(s.bytes);
}

std::optional<Trace> read_trace(const std::string& path, const std::string& bytes,
                                Diagnostics& diagnostics) {
  const auto fail = [&](const std::string& what) {
    diagnostics.add(Code::F450, {std::make_shared<SourceFile>(path, ""), 0, 0},
                    "not a readable trace: " + what);
    return std::nullopt;
  };
  if (!std::string_view(bytes).starts_with(kMagic)) {
    return fail("it does not begin with \"" + std::string(kMagic) + "\"");
  }
  const auto payload = unpacked(std::string_view(bytes).substr(kMagic.size()), kMostTraceBytes);
  if (!payload) return fail("its compressed part is damaged, cut short or too large");
  Trace trace;
  const std::string problem = read_payload(*payload, trace);
  if (!problem.empty()) return fail(problem);
  return trace;
}

}  // namespace stig::lattice
