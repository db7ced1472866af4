// SPDX-License-Identifier: MIT
// Frames are due every 20 ms of simulated time, hashes every second, in whole ticks, so that a
// trace does not depend on when it was begun or looked at.
#include "physical/simulation/trace_recorder.h"

#include <cassert>

#include "physical/dynamics/ticks.h"
#include "physical/render/show_json.h"
#include "physical/simulation/detail_json.h"
#include "physical/simulation/run_state.h"

namespace stig::physics {

namespace {

constexpr double kFrameSeconds = 0.02, kHashSeconds = 1, kDetailSeconds = 0.1;
constexpr const char *kSenses = "senses", *kMagnets = "magnets", *kContacts = "contacts",
                     *kPulls = "pulls";
enum : std::uint32_t { kLedChannel, kLogChannel, kShowChannel };

/// Every frame has all bodies that may ever come, so that numbers in a trace are those of the
/// scene. Bodies that have not come yet have left, so to speak.
TraceFrame frame_of(const World& world, std::size_t bodies) {
  TraceFrame frame{world.tick(), {}};
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    frame.bodies.push_back(trace_state(world.state(BodyId{i})));
  }
  BodyState absent;
  absent.left = true;
  absent.awake = false;
  frame.bodies.resize(bodies, trace_state(absent));
  return frame;
}

/// All alike: one digit; otherwise a digit an LED. Digits are the colours' numbers.
std::string led_bytes(const BlockLeds& leds) {
  std::string out;
  for (const Led led : leds) out += static_cast<char>('0' + static_cast<int>(led));
  if (out.find_first_not_of(out[0]) == std::string::npos) out.resize(1);
  return out;
}

bool is_due(const RunState& run, double seconds) {
  return run.world.tick() % ticks_in(seconds, run.placed.config.step) == 0;
}

}  // namespace

PoseTraceHeader trace_header(const Scene& scene, const PlacedScene& placed, bool detailed) {
  assert(placed.robots.size() == scene.robots.size());
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
    body.visual = from.visual;
    if (i < placed.config.bodies.size()) {
      body.shape = placed.config.bodies[i].shape;
      body.fixed = placed.config.bodies[i].fixed;
    } else {
      body.shape = block_body(scene.models[scene.stock_model], {}).shape;
    }
    header.bodies.push_back(std::move(body));
  }
  header.channels = {"leds", "log", "show"};
  if (detailed)
    header.channels.insert(header.channels.end(), {kSenses, kMagnets, kContacts, kPulls});
  header.files = scene.files;
  return header;
}

// The frame of tick 0 is the state before the first step; a resumed run has it already.
void TraceRecorder::begin(const RunState& run, PoseTraceWriter& writer) {
  writer_ = &writer;
  framed_ = UINT64_MAX;
  if (run.world.tick() == 0) write_frame(run);
}

void TraceRecorder::note(const RunState& run, const CrewLine& line) {
  if (writer_ == nullptr) return;
  writer_->value({run.world.tick(), kLogChannel, static_cast<std::uint32_t>(line.body),
                  line.who + ": " + line.text});
}

void TraceRecorder::hand(const RunState& run, const HandAction& action) {
  if (writer_ != nullptr) writer_->hand({run.world.tick(), action});
}

void TraceRecorder::before_step(RunState& run, const RunHooks& /*hooks*/) {
  // Before the step rather than after it, as a run that is taken up again writes the values of its
  // first tick anew.
  if (writer_ != nullptr && is_due(run, kDetailSeconds)) write_details(run);
  Crew* crew = run.agents.crew();
  if (crew == nullptr) return;
  // Asked for also when there is no writer, so that lists do not grow.
  const std::vector<std::size_t> changed = crew->take_changed(), stepped = crew->take_stepped();
  if (writer_ == nullptr) return;
  for (const std::size_t block : changed) {
    writer_->value({run.world.tick(), kLedChannel,
                    static_cast<std::uint32_t>(crew->block_body(block)),
                    led_bytes(crew->leds(block))});
  }
  const auto senses = writer_->channel(kSenses);
  for (const std::size_t robot : stepped) {
    const auto body = static_cast<std::uint32_t>(crew->root_body(robot));
    const RobotCommands& commands = crew->commands(robot);
    writer_->value({run.world.tick(), kShowChannel, body,
                    show_json(commands.user, inverse(crew->root_pose(robot)))});
    if (!senses) continue;
    writer_->value({run.world.tick(), *senses, body,
                    senses_json(crew->model(robot), crew->readings(robot), commands)});
  }
}

void TraceRecorder::after_step(RunState& run) {
  if (writer_ == nullptr) return;
  // Events happen at the end of the step that caused them.
  for (const WorldEvent& event : run.world.events()) writer_->event({run.world.tick(), event});
  if (is_due(run, kFrameSeconds)) write_frame(run);
  if (is_due(run, kHashSeconds)) writer_->hash({run.world.tick(), hash_of(run)});
}

void TraceRecorder::write_frame(const RunState& run) {
  // A run that ends on a frame's tick has it already.
  if (framed_ == run.world.tick()) return;
  framed_ = run.world.tick();
  writer_->frame(frame_of(run.world, run.placed.bodies.size()));
}

void TraceRecorder::write_details(const RunState& run) {
  if (const auto channel = writer_->channel(kMagnets)) write_magnets(run, *channel);
  if (const auto channel = writer_->channel(kContacts)) write_contacts(run, *channel);
  if (const auto channel = writer_->channel(kPulls)) write_pulls(run, *channel);
}

// Of each body, also where nothing acts: what is as it was is left out by the writer. Both follow
// from what a checkpoint has, so that a run which is taken up again writes the same.
void TraceRecorder::write_contacts(const RunState& run, std::uint32_t channel) {
  const std::vector<ContactForce> all = run.world.contact_forces();
  auto next = all.begin();
  for (std::uint32_t i = 0; i < run.world.size(); ++i) {
    const auto first = next;
    while (next != all.end() && next->a == BodyId{i}) ++next;
    writer_->value({run.world.tick(), channel, i, contacts_json({first, next})});
  }
}

void TraceRecorder::write_pulls(const RunState& run, std::uint32_t channel) {
  if (!run.scene->magnets) return;
  const std::vector<Vec3> all = run.world.magnet_forces();
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    writer_->value({run.world.tick(), channel, i, force_json(all[i])});
  }
}

// Those of a body asleep stay as they were written last; a body that has just fallen asleep was
// awake a moment before. Fixed bodies are never awake, and their magnets turn all the same.
void TraceRecorder::write_magnets(const RunState& run, std::uint32_t channel) {
  if (!run.scene->magnets) return;
  for (std::uint32_t i = 0; i < run.world.size(); ++i) {
    const auto& defined = run.placed.config.bodies;
    const bool turns = run.world.state(BodyId{i}).awake || (i < defined.size() && defined[i].fixed);
    if (!run.placed.bodies[i].block || !(turns || run.world.tick() == 0)) continue;
    const BlockModel& model = run.scene->models[block_model(*run.scene, run.placed, i)];
    if (!model.has_magnets()) continue;
    const std::size_t count = model.magnet_places().size();
    writer_->value({run.world.tick(), channel, i, magnets_json(run.world, BodyId{i}, count)});
  }
}

void TraceRecorder::finish(const RunState& run, RunEnd end) {
  if (writer_ == nullptr) return;
  if (!is_due(run, kFrameSeconds)) write_frame(run);
  writer_->finish({run.world.tick(), end, hash_of(run), run.message});
  writer_ = nullptr;
}

}  // namespace stig::physics
