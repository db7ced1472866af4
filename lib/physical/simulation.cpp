// SPDX-License-Identifier: MIT
#include "physical/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/bytes.h"
#include "physical/packed.h"

namespace stig {

namespace {

constexpr double kFrameSeconds = 0.02, kHashSeconds = 1;
constexpr std::string_view kCheckpointMagic = "stigchk1";
constexpr std::size_t kMostCheckpoint = std::size_t{1} << 30;

std::uint64_t ticks_in(double seconds, double step) {
  return static_cast<std::uint64_t>(std::max<long long>(1, std::llround(seconds / step)));
}

BodyId id(std::size_t i) { return BodyId{static_cast<std::uint32_t>(i)}; }

TraceFrame frame_of(const World& world) {
  TraceFrame frame{world.tick(), {}};
  for (std::size_t i = 0; i < world.size(); ++i) {
    frame.bodies.push_back(trace_state(world.state(id(i))));
  }
  return frame;
}

}  // namespace

Simulation::Simulation(const Scene& scene, const PlacedScene& placed)
    : placed_(placed),
      stop_asleep_(scene.stop_asleep),
      frame_every_(ticks_in(kFrameSeconds, placed.config.step)),
      hash_every_(ticks_in(kHashSeconds, placed.config.step)),
      world_(placed.config) {}

void Simulation::record(PoseTraceWriter& writer) {
  writer_ = &writer;
  framed_ = UINT64_MAX;
  if (world_.tick() == 0) write_frame();
}

void Simulation::write_frame() {
  if (framed_ == world_.tick()) return;
  framed_ = world_.tick();
  writer_->frame(frame_of(world_));
}

void Simulation::count(const WorldEvent& event) {
  switch (event.kind) {
    case EventKind::contact_began:
      ++tally_.contacts;
      break;
    case EventKind::slept:
      ++tally_.slept;
      break;
    case EventKind::woke:
      ++tally_.woke;
      break;
    case EventKind::snapped:
      ++tally_.snapped;
      break;
    case EventKind::let_go:
      ++tally_.let_go;
      break;
    case EventKind::left_arena:
      tally_.left.push_back(static_cast<std::uint32_t>(event.body));
      break;
  }
}

void Simulation::after_step() {
  const std::uint64_t tick = world_.tick();
  for (const WorldEvent& event : world_.events()) {
    count(event);
    if (writer_ != nullptr) writer_->event({tick, event});
  }
  if (writer_ == nullptr) return;
  if (tick % frame_every_ == 0) write_frame();
  if (tick % hash_every_ == 0) writer_->hash({tick, world_.hash()});
}

RunEnd Simulation::until(double duration, const RunHooks& hooks) {
  // A multiple of the step that rounding has put a hair above the duration is its end.
  const auto last = static_cast<std::uint64_t>(std::ceil(duration / placed_.config.step - 1e-6));
  while (world_.tick() < last) {
    if (hooks.stop != nullptr && hooks.stop->load(std::memory_order_relaxed)) {
      return RunEnd::interrupted;
    }
    const StepResult result = world_.step();
    if (!result.ok) {
      const auto body = static_cast<std::size_t>(result.body);
      message_ = fmt::format("physics diverged in tick {} ({:.3f} s) at '{}'", world_.tick() + 1,
                             world_.time(), placed_.bodies[body].name);
      return RunEnd::diverged;
    }
    after_step();
    if (hooks.after_step) hooks.after_step(world_);
    if (stop_asleep_ && world_.awake_count() == 0) return RunEnd::asleep;
  }
  return RunEnd::duration;
}

void Simulation::finish(RunEnd end) {
  if (writer_ == nullptr) return;
  if (world_.tick() % frame_every_ != 0) write_frame();
  writer_->finish({world_.tick(), end, world_.hash(), message_});
  writer_ = nullptr;
}

std::string Simulation::state() const {
  std::string out;
  put_block(out, world_.checkpoint());
  for (const std::uint64_t n :
       {tally_.contacts, tally_.slept, tally_.woke, tally_.snapped, tally_.let_go}) {
    put_varint(out, n);
  }
  put_varint(out, tally_.left.size());
  for (const std::uint32_t body : tally_.left) put_varint(out, body);
  return out;
}

bool Simulation::resume(std::string_view state) {
  ByteReader in(state);
  const std::string_view world = in.block();
  RunTally tally;
  for (std::uint64_t* n :
       {&tally.contacts, &tally.slept, &tally.woke, &tally.snapped, &tally.let_go}) {
    *n = in.varint();
  }
  const std::uint64_t left = in.varint();
  if (left > world_.size()) return false;
  for (std::uint64_t i = 0; i < left; ++i) {
    const std::uint64_t body = in.varint();
    if (body >= world_.size()) return false;
    tally.left.push_back(static_cast<std::uint32_t>(body));
  }
  if (!in.good() || in.left() > 0 || !world_.resume(world)) return false;
  tally_ = std::move(tally);
  return true;
}

PoseTraceHeader trace_header(const Scene& scene, const PlacedScene& placed) {
  PoseTraceHeader header;
  header.title = scene.title;
  header.seed = placed.seed;
  header.step = placed.config.step;
  header.frame_every = ticks_in(kFrameSeconds, header.step);
  header.hash_every = ticks_in(kHashSeconds, header.step);
  for (std::size_t i = 0; i < placed.bodies.size(); ++i) {
    const BodyDef& def = placed.config.bodies[i];
    TraceBody body;
    body.name = placed.bodies[i].name;
    body.shape = def.shape;
    body.block = true;
    body.led = placed.bodies[i].colour;
    body.fixed = def.fixed;
    header.bodies.push_back(std::move(body));
  }
  header.files = scene.files;
  return header;
}

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
  std::string payload;
  put_varint(payload, checkpoint.seed);
  put_varint(payload, checkpoint.files.size());
  for (const SceneFile& file : checkpoint.files) {
    put_block(payload, file.name);
    put_block(payload, file.text);
  }
  put_block(payload, checkpoint.state);
  return std::string(kCheckpointMagic) + packed(payload);
}

std::optional<Checkpoint> read_checkpoint_file(std::string_view bytes, std::string& problem) {
  if (!bytes.starts_with(kCheckpointMagic)) {
    problem = "it is no checkpoint of stigc simulate";
    return std::nullopt;
  }
  const auto payload = unpacked(bytes.substr(kCheckpointMagic.size()), kMostCheckpoint);
  problem = "it is damaged or cut short";
  if (!payload) return std::nullopt;
  ByteReader in(*payload);
  Checkpoint out;
  out.seed = in.varint();
  const std::uint64_t files = in.varint();
  for (std::uint64_t i = 0; i < files && in.good(); ++i) {
    const std::string name(in.block());
    out.files.push_back({name, std::string(in.block())});
  }
  out.state = std::string(in.block());
  if (!in.good() || in.left() > 0 || out.files.empty()) return std::nullopt;
  problem.clear();
  return out;
}

std::optional<LoadedScene> load_scene(const std::vector<SceneFile>& files, std::uint64_t seed,
                                      Diagnostics& diagnostics) {
  if (files.empty()) {
    diagnostics.add(Code::F480, {}, "the file holds no scene");
    return std::nullopt;
  }
  const auto source = std::make_shared<const SourceFile>(files[0].name, files[0].text);
  auto scene = read_scene(source, memory_loader({files.begin() + 1, files.end()}), diagnostics);
  if (!scene) return std::nullopt;
  auto placed = place_scene(*scene, seed, diagnostics);
  if (!placed) return std::nullopt;
  return LoadedScene{std::move(*scene), std::move(*placed)};
}

VerifyReport verify_trace(const PoseTrace& trace, const LoadedScene& loaded,
                          const RunHooks& hooks) {
  VerifyReport report;
  Simulation run(loaded.scene, loaded.placed);
  const double step = loaded.placed.config.step;
  const auto compare = [&](const TraceHash& expected) {
    const RunEnd end = run.until(static_cast<double>(expected.tick) * step, hooks);
    if (end == RunEnd::interrupted) {
      report.difference = "the comparison was interrupted";
    } else if (run.world().tick() != expected.tick) {
      report.difference =
          fmt::format("it ends in tick {}, before tick {}", run.world().tick(), expected.tick);
    } else if (run.world().hash() != expected.hash) {
      report.difference = fmt::format("the state in tick {} is another", expected.tick);
    } else {
      ++report.compared;
    }
    return report.difference.empty();
  };
  std::vector<TraceHash> hashes = trace.hashes;
  hashes.push_back({trace.end.ticks, trace.end.hash});
  report.identical = std::all_of(hashes.begin(), hashes.end(), compare);
  return report;
}

}  // namespace stig
