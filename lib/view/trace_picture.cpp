// SPDX-License-Identifier: MIT
#include "view/trace_picture.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "physical/render/show_json.h"

namespace stig::view {

namespace {

/// What bodies showed in a channel at a tick: the newest value of each that has one. Linear over
/// all values of the trace: a picture is drawn once.
std::map<std::uint32_t, const std::string*> shown_at(const PoseTrace& trace, std::uint64_t tick,
                                                     std::string_view channel) {
  std::map<std::uint32_t, const std::string*> out;
  for (const TraceValue& value : trace.values) {
    if (value.tick > tick || trace.header.channels[value.channel] != channel) continue;
    // Values come in the order of ticks, so the last one stays.
    out[value.body] = &value.bytes;
  }
  return out;
}

/// What a block's LEDs show: a digit for all, or one for each.
Led shown_by_digits(std::string_view digits) {
  BlockLeds leds{};
  for (std::size_t i = 0; i < leds.size() && !digits.empty(); ++i) {
    const char digit = digits[std::min(i, digits.size() - 1)];
    // A trace may hold any bytes as a value.
    if (digit >= '0' && digit <= '4') leds[i] = static_cast<Led>(digit - '0');
  }
  return shown_by(leds);
}

/// What a block showed at a tick: what its program had set, or what it had when the trace began.
std::vector<Led> leds_at(const PoseTrace& trace, std::uint64_t tick) {
  const auto set = shown_at(trace, tick, "leds");
  std::vector<Led> out;
  for (std::uint32_t i = 0; i < trace.header.bodies.size(); ++i) {
    const TraceBody& body = trace.header.bodies[i];
    const auto found = set.find(i);
    const Led led = found == set.end() ? body.led : shown_by_digits(*found->second);
    out.push_back(body.block ? led : Led::off);
  }
  return out;
}

}  // namespace

std::vector<PictureBody> picture_bodies(const PoseTrace& trace, const TraceFrame& frame) {
  const std::vector<Led> leds = leds_at(trace, frame.tick);
  std::vector<PictureBody> out;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    if (frame.bodies[i].left) continue;
    const TraceBody& body = trace.header.bodies[i];
    out.push_back({body.shape, frame.bodies[i].pose(), body.rgb, body.block, leds[i]});
  }
  return out;
}

std::vector<PictureLine> picture_lines(const PoseTrace& trace, const TraceFrame& frame) {
  std::vector<PictureLine> out;
  for (const auto& [body, json] : shown_at(trace, frame.tick, "show")) {
    // A body that is not in the frame has no lines there.
    if (body >= frame.bodies.size()) continue;
    const auto lines = show_lines(*json, frame.bodies[body].pose());
    out.insert(out.end(), lines.begin(), lines.end());
  }
  return out;
}

std::vector<std::vector<LedChange>> led_changes(const PoseTrace& trace, std::uint64_t first,
                                                std::uint64_t last) {
  std::vector<std::vector<LedChange>> out;
  for (const Led led : leds_at(trace, first)) out.push_back({{first, led}});
  for (const TraceValue& value : trace.values) {
    if (value.tick <= first || value.tick > last) continue;
    if (trace.header.channels[value.channel] != "leds") continue;
    if (value.body >= out.size() || !trace.header.bodies[value.body].block) continue;
    const Led led = shown_by_digits(value.bytes);
    std::vector<LedChange>& changes = out[value.body];
    if (changes.back().led != led) changes.push_back({value.tick, led});
  }
  return out;
}

}  // namespace stig::view
