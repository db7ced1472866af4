// SPDX-License-Identifier: MIT
#include "physical/simulation/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "base/byte_members.h"
#include "base/hash.h"
#include "base/packed.h"
#include "physical/render/show_json.h"
#include "physical/scene/scene_crew.h"
#include "physical/simulation/scene_script.h"
#include "physical/simulation/script_record.h"

namespace stig {

namespace {

constexpr double kFrameSeconds = 0.02, kHashSeconds = 1;
constexpr std::uint32_t kScriptAgent = 0xffffff;  ///< beyond all robots and blocks
constexpr std::string_view kCheckpointMagic = "stigchk2";
constexpr std::size_t kMostCheckpoint = std::size_t{1} << 30;

std::uint64_t ticks_in(double seconds, double step) {
  return static_cast<std::uint64_t>(std::max<long long>(1, std::llround(seconds / step)));
}

BodyId id(std::size_t i) { return BodyId{static_cast<std::uint32_t>(i)}; }

/// Bodies that have not come yet have left, so to speak.
TraceFrame frame_of(const World& world, std::size_t bodies) {
  TraceFrame frame{world.tick(), {}};
  for (std::size_t i = 0; i < world.size(); ++i) {
    frame.bodies.push_back(trace_state(world.state(id(i))));
  }
  BodyState absent;
  absent.left = true;
  absent.awake = false;
  frame.bodies.resize(bodies, trace_state(absent));
  return frame;
}

constexpr double kCacheSeconds = 0.2;  ///< between looks at a cache
enum : std::uint32_t { kLedChannel, kLogChannel, kShowChannel };

/// All alike: one digit; otherwise a digit an LED.
std::string led_bytes(const std::array<Led, kBlockLeds>& leds) {
  std::string out;
  for (const Led led : leds) out += static_cast<char>('0' + static_cast<int>(led));
  if (out.find_first_not_of(out[0]) == std::string::npos) out.resize(1);
  return out;
}

std::optional<LuaScript> script_of(const Scene& scene, const PlacedScene& placed) {
  if (scene.script == RobotSpawn::kNoProgram) return std::nullopt;
  LuaSettings settings;
  settings.id = "script";
  settings.limits.instructions *= 10;
  settings.seed = placed.seed;
  settings.agent = kScriptAgent;
  return LuaScript(scene.programs[scene.script], settings);
}

bool has_programs(const Scene& scene) {
  return std::any_of(scene.block_programs.begin(), scene.block_programs.end(),
                     [](std::size_t program) { return program != RobotSpawn::kNoProgram; });
}

}  // namespace

Simulation::Simulation(const Scene& scene, const PlacedScene& placed, bool resumable)
    : scene_(&scene),
      placed_(placed),
      stop_asleep_(scene.stop_asleep),
      frame_every_(ticks_in(kFrameSeconds, placed.config.step)),
      hash_every_(ticks_in(kHashSeconds, placed.config.step)),
      world_(placed.config),
      dropped_(scene.caches.size() + 1, 0),
      last_places_(scene.robots.size()),
      driven_(scene.robots.size(), 0),
      resumable_(resumable) {
  for (std::size_t i = 0; i < scene.robots.size(); ++i) last_places_[i] = scene.robots[i].X_WR.p;
  script_ = script_of(scene, placed);
  // A script may colour blocks.
  if (script_ || !scene.robots.empty() || has_programs(scene)) {
    CrewConfig crew = crew_of(scene, placed);
    crew.resumable = resumable;
    crew_.emplace(std::move(crew), placed.config);
  }
}

Led Simulation::led(std::size_t body) const {
  if (!crew_ || body >= world_.size()) return placed_.bodies[body].colour;
  const std::size_t block = crew_->block_of(id(body));
  return block < crew_->blocks() ? crew_->colour(block) : Led::off;
}

std::array<int, 6> Simulation::faces(std::size_t body) const {
  std::array<int, 6> out{};
  out.fill(static_cast<int>(led(body)));
  const std::size_t block = crew_ ? crew_->block_of(id(body)) : 0;
  if (!crew_ || block == crew_->blocks()) return out;
  const auto& leds = crew_->leds(block);
  for (std::size_t face = 0; face < out.size(); ++face) {
    std::array<int, 5> shown{};
    for (std::size_t i = 0; i < 4; ++i) ++shown[static_cast<std::size_t>(leds[4 * face + i])];
    out[face] = static_cast<int>(std::max_element(shown.begin(), shown.end()) - shown.begin());
  }
  return out;
}

bool Simulation::blocks_near(const CacheSpawn& cache) const {
  for (std::size_t i = 0; i < world_.size(); ++i) {
    if (!placed_.bodies[i].block) continue;
    const BodyState state = world_.state(id(i));
    const double x = state.X_WB.p.x - cache.at.x, y = state.X_WB.p.y - cache.at.y;
    if (!state.left && x * x + y * y < cache.radius * cache.radius) return true;
  }
  return false;
}

void Simulation::refill_caches() {
  for (std::size_t i = 0; i < scene_->caches.size(); ++i) {
    const CacheSpawn& cache = scene_->caches[i];
    if (dropped_[i] == cache.stock || blocks_near(cache)) continue;
    // A robot may stand there: then later.
    const Pose X_WB =
        jittered({cache.at, rotation({0, 0, cache.yaw})}, cache.jitter, cache.turn_jitter,
                 placed_.seed, kCacheJitter + static_cast<std::uint32_t>(i), dropped_[i]);
    if (add_block(X_WB).problem.empty()) ++dropped_[i];
  }
}

AddResult Simulation::add_block(const Pose& X_WB) {
  Addition addition;
  addition.bodies.push_back(block_body(scene_->models[scene_->stock_model], X_WB));
  const Shape shape = addition.bodies[0].shape;
  const AddResult added = world_.add(addition);
  if (added.problem.empty() && crew_) {
    crew_->add(crew_block(*scene_, placed_, static_cast<std::size_t>(added.body)), shape);
  }
  return added;
}

void Simulation::apply_pushes() {
  std::erase_if(pushes_, [this](const ScriptPush& one) { return one.until <= world_.tick(); });
  for (const ScriptPush& one : pushes_) world_.push(BodyId{one.body}, one.force, {});
}

void Simulation::measure_ways() {
  for (std::size_t i = 0; crew_ && i < driven_.size(); ++i) {
    Vec3 at = crew_->robot_pose(world_, i).p;
    at.z = 0;
    driven_[i] += length(at - last_places_[i]);
    last_places_[i] = at;
  }
}

void Simulation::before_step(const RunHooks& hooks) {
  const std::uint64_t look = ticks_in(kCacheSeconds, placed_.config.step);
  const bool now = world_.tick() % look == 0;
  if (now) measure_ways();
  if (now && script_ && world_.tick() == 0) run_script(ScriptCall::start, hooks);
  if (now && script_ && !stop_) run_script(ScriptCall::step, hooks);
  if (now) refill_caches();
  apply_pushes();
  if (!crew_) return;
  crew_->before_step(world_);
  note_crew(hooks);
}

/// What programs said and showed in this tick, into hooks and the trace.
void Simulation::note_crew(const RunHooks& hooks) {
  for (const CrewLine& line : crew_->take_log()) {
    if (hooks.on_line) hooks.on_line(line);
    if (writer_ != nullptr) {
      writer_->value({world_.tick(), kLogChannel, static_cast<std::uint32_t>(line.body),
                      line.who + ": " + line.text});
    }
  }
  for (const std::size_t block : crew_->take_changed()) {
    if (writer_ == nullptr) continue;
    writer_->value({world_.tick(), kLedChannel,
                    static_cast<std::uint32_t>(crew_->block_body(block)),
                    led_bytes(crew_->leds(block))});
  }
  for (const std::size_t robot : crew_->take_stepped()) {
    if (writer_ == nullptr) continue;
    writer_->value({world_.tick(), kShowChannel,
                    static_cast<std::uint32_t>(crew_->root_body(robot)),
                    show_json(crew_->commands(robot).user, inverse(crew_->root_pose(robot)))});
  }
}

void Simulation::record(PoseTraceWriter& writer) {
  writer_ = &writer;
  framed_ = UINT64_MAX;
  if (world_.tick() == 0) write_frame();
}

void Simulation::write_frame() {
  if (framed_ == world_.tick()) return;
  framed_ = world_.tick();
  writer_->frame(frame_of(world_, placed_.bodies.size()));
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
  if (tick % hash_every_ == 0) writer_->hash({tick, hash()});
}

void Simulation::run_script(ScriptCall which, const RunHooks& hooks) {
  SceneScript world(*this);
  std::string answers;
  RecordedWorld recorded(world, answers);
  ScriptWorld& seen = resumable_ ? static_cast<ScriptWorld&>(recorded) : world;
  std::vector<std::string> log;
  script_ended(script_->call(which, seen, log));
  if (resumable_) {
    std::string record(1, static_cast<char>(which));
    put_block(record, answers);
    record.push_back(script_failed_ ? '\1' : '\0');
    script_history_.add(record);
  }
  for (const std::string& line : log) {
    if (hooks.on_line) hooks.on_line({world_.tick(), "script", {}, line, false});
  }
}

/// A failure ends the run as a stop does.
void Simulation::script_ended(ControllerStatus status) {
  if (status.ok) return;
  script_failed_ = stop_ = true;
  message_ = status.error;
}

/// A fresh script, with the answers that the last one had.
bool Simulation::bring_back_script() {
  if (!script_) return true;
  return script_history_.each([this](ByteReader& in) {
    const std::uint8_t which = in.u8();
    ByteReader answers(in.block());
    const bool failed = in.u8() == 1;
    if (!in.good() || which > static_cast<std::uint8_t>(ScriptCall::end)) return false;
    ReplayedWorld world(answers);
    std::vector<std::string> said;
    script_ended(script_->call(static_cast<ScriptCall>(which), world, said));
    if (world.stopped) {
      stop_ = true;
      message_ = *world.stopped;
    }
    for (const auto& [name, value] : world.measures) measures_[name] = value;
    return answers.good() && answers.left() == 0 && script_failed_ == failed;
  });
}

RunEnd Simulation::until(double duration, const RunHooks& hooks) {
  // A multiple of the step that rounding has put a hair above the duration is its end.
  const auto last = static_cast<std::uint64_t>(std::ceil(duration / placed_.config.step - 1e-6));
  while (world_.tick() < last) {
    if (stop_) return RunEnd::script;
    if (hooks.stop != nullptr && hooks.stop->load(std::memory_order_relaxed)) {
      return RunEnd::interrupted;
    }
    before_step(hooks);
    if (stop_) return RunEnd::script;
    if (scene_->stop_failed && crew_ && crew_->all_failed()) return RunEnd::failed;
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
  writer_->finish({world_.tick(), end, hash(), message_});
  writer_ = nullptr;
}

std::uint64_t Simulation::hash() const {
  if (!crew_) return world_.hash();
  return combine(world_.hash(), hash_text(crew_->state()));
}

std::string Simulation::state() const {
  std::string out;
  assert(resumable_);
  put_block(out, world_.checkpoint());
  for (const std::uint64_t n :
       {tally_.contacts, tally_.slept, tally_.woke, tally_.snapped, tally_.let_go}) {
    put_varint(out, n);
  }
  put_varint(out, tally_.left.size());
  for (const std::uint32_t body : tally_.left) put_varint(out, body);
  for (const std::size_t blocks : dropped_) put_varint(out, blocks);
  for (std::size_t i = 0; i < driven_.size(); ++i) {
    for (const double value : {driven_[i], last_places_[i].x, last_places_[i].y}) {
      put(out, std::bit_cast<std::uint64_t>(value));
    }
  }
  put_varint(out, pushes_.size());
  for (const ScriptPush& push : pushes_) {
    put_varint(out, push.body);
    put_varint(out, push.until);
    for (const double value : {push.force.x, push.force.y, push.force.z}) {
      put(out, std::bit_cast<std::uint64_t>(value));
    }
  }
  BytesOut script;
  each_member(script, script_history_);
  out += script.take();
  put_block(out, crew_ ? crew_->checkpoint() : "");
  return out;
}

bool Simulation::resume(std::string_view state) {
  Simulation next(*scene_, placed_, resumable_);
  ByteReader in(state);
  if (!next.take_state(in)) return false;
  next.writer_ = writer_;
  *this = std::move(next);
  return true;
}

/// Of one that has not begun; of no use when it is false.
bool Simulation::take_state(ByteReader& in) {
  if (!world_.resume(in.block()) || world_.size() > placed_.bodies.size()) return false;
  for (std::uint64_t* n :
       {&tally_.contacts, &tally_.slept, &tally_.woke, &tally_.snapped, &tally_.let_go}) {
    *n = in.varint();
  }
  const std::uint64_t left = in.varint();
  if (left > world_.size()) return false;
  for (std::uint64_t i = 0; i < left; ++i) {
    const std::uint64_t body = in.varint();
    if (body >= world_.size()) return false;
    tally_.left.push_back(static_cast<std::uint32_t>(body));
  }
  std::size_t added = placed_.config.bodies.size();
  for (std::size_t i = 0; i < dropped_.size(); ++i) {
    dropped_[i] = in.varint();
    if (dropped_[i] > (i < scene_->caches.size() ? scene_->caches[i].stock : scene_->stock)) {
      return false;
    }
    added += dropped_[i];
  }
  if (added != world_.size()) return false;
  for (std::size_t i = 0; i < driven_.size(); ++i) {
    for (double* value : {&driven_[i], &last_places_[i].x, &last_places_[i].y}) {
      *value = std::bit_cast<double>(in.u64());
    }
  }
  if (!take_pushes(in)) return false;
  BytesIn script(in);
  each_member(script, script_history_);
  const std::string_view programs = in.block();
  if (!in.good() || in.left() > 0 || !bring_back_script()) return false;
  if (!crew_) return programs.empty();
  for (std::size_t i = placed_.config.bodies.size(); i < world_.size(); ++i) {
    crew_->add(crew_block(*scene_, placed_, i),
               block_body(scene_->models[scene_->stock_model], {}).shape);
  }
  if (!crew_->resume(programs)) return false;
  crew_->take_changed();
  return true;
}

bool Simulation::take_pushes(ByteReader& in) {
  const std::uint64_t pushes = in.varint();
  for (std::uint64_t i = 0; i < pushes && in.good(); ++i) {
    ScriptPush push;
    const std::uint64_t body = in.varint();
    push.body = static_cast<std::uint32_t>(body);
    push.until = in.varint();
    for (double* value : {&push.force.x, &push.force.y, &push.force.z}) {
      *value = std::bit_cast<double>(in.u64());
    }
    if (body >= world_.size() || !is_finite(push.force)) return false;
    pushes_.push_back(push);
  }
  return in.good();
}

PoseTraceHeader trace_header(const Scene& scene, const PlacedScene& placed) {
  PoseTraceHeader header;
  header.title = scene.title;
  header.seed = placed.seed;
  header.step = placed.config.step;
  header.frame_every = ticks_in(kFrameSeconds, header.step);
  header.hash_every = ticks_in(kHashSeconds, header.step);
  for (std::size_t i = 0; i < placed.bodies.size(); ++i) {
    const SceneBody& from = placed.bodies[i];
    TraceBody body;
    body.name = from.name;
    body.block = from.block;
    body.led = from.colour;
    body.rgb = from.rgb;
    if (i < placed.config.bodies.size()) {
      body.shape = placed.config.bodies[i].shape;
      body.fixed = placed.config.bodies[i].fixed;
    } else {
      body.shape = block_body(scene.models[scene.stock_model], {}).shape;
    }
    header.bodies.push_back(std::move(body));
  }
  header.channels = {"leds", "log", "show"};
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
  Simulation run(loaded.scene, loaded.placed, false);
  const double step = loaded.placed.config.step;
  // Where scripts or programs ended it, or physics could not go on, the beginning of a step of
  // which no end came has left its marks; and a script has had its last words.
  const RunEnd why = trace.end.why;
  const std::uint64_t begun =
      why == RunEnd::script || why == RunEnd::failed || why == RunEnd::diverged ? 1 : 0;
  const auto compare = [&](const TraceHash& expected, bool last) {
    const std::uint64_t ticks = expected.tick + (last ? begun : 0);
    const RunEnd end = run.until(static_cast<double>(ticks) * step, hooks);
    if (last) run.end_script(hooks);
    if (end == RunEnd::interrupted) {
      report.difference = "the comparison was interrupted";
    } else if (run.world().tick() != expected.tick) {
      report.difference =
          fmt::format("it ends in tick {}, before tick {}", run.world().tick(), expected.tick);
    } else if (run.hash() != expected.hash) {
      report.difference = fmt::format("the state in tick {} is another", expected.tick);
    } else {
      ++report.compared;
    }
    return report.difference.empty();
  };
  report.identical = std::all_of(trace.hashes.begin(), trace.hashes.end(),
                                 [&](const TraceHash& one) { return compare(one, false); }) &&
                     compare({trace.end.ticks, trace.end.hash}, true);
  return report;
}

}  // namespace stig
