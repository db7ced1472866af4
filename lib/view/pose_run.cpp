// SPDX-License-Identifier: MIT
// A page has columns of whole numbers (page_data.h), so every list of the trace is turned into one
// column for each member. Names of members are those that tools/viewer/src/pose_run.ts reads.
#include "view/pose_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "base/text.h"
#include "physical/trace/pose_frames.h"
#include "view/pose_devices.h"
#include "view/pose_track.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::int64_t>;

// Coarser than a trace's own: nobody sees a tenth of a millimetre.
constexpr std::int64_t kPlaceSteps = 10;  ///< of kPlaceQuantum
constexpr std::int64_t kTurnSteps = 4;    ///< of kTurnQuantum

std::int64_t rounded(std::int64_t value, std::int64_t steps) {
  return (value + (value < 0 ? -steps / 2 : steps / 2)) / steps;
}

std::string_view shape_name(ShapeKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"box", "sphere", "cylinder", "hull"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// As the trace's channel has LEDs: a digit for all, or one for each.
std::string leds_text(Led shown) {
  std::string out;
  for (const Led led : leds_showing(shown)) out += static_cast<char>('0' + static_cast<int>(led));
  if (out.find_first_not_of(out[0]) == std::string::npos) out.resize(1);
  return out;
}

Json body_json(const TraceBody& body) {
  const Vec3& half = body.shape.half;
  Json out{{"name", printable(body.name)},
           {"shape", shape_name(body.shape.kind)},
           {"half", {half.x, half.y, half.z}},
           {"color", to_color(body.rgb)},
           {"block", body.block},
           {"led", leds_text(body.led)}};
  if (body.shape.kind == ShapeKind::hull) {
    for (const Vec3& p : body.shape.convex->points) out["points"].push_back({p.x, p.y, p.z});
  }
  if (body.visual) {
    Json& surface =
        out["surface"] = {{"points", Json::array()}, {"triangles", body.visual->triangles}};
    for (const Vec3& p : body.visual->points) surface["points"].push_back({p.x, p.y, p.z});
  }
  return out;
}

/// The tracks of all bodies, one after the other in each column.
Json tracks_json(const PoseTrace& trace, PageColumns& columns) {
  std::vector<PoseTrack> tracks(trace.header.bodies.size());
  for_each_frame(trace, [&](const TraceFrame& frame) {
    for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].add({frame.tick, frame.bodies[i]});
  });
  Numbers counts, ticks, left;
  std::array<Numbers, 7> parts;
  for (PoseTrack& track : tracks) {
    const std::vector<TrackKey> keys = track.finish();
    counts.push_back(static_cast<std::int64_t>(keys.size()));
    for (const TrackKey& key : keys) {
      ticks.push_back(static_cast<std::int64_t>(key.tick));
      left.push_back(key.state.left ? 1 : 0);
      for (std::size_t k = 0; k < 3; ++k) {
        parts[k].push_back(rounded(key.state.place[k], kPlaceSteps));
      }
      for (std::size_t k = 0; k < 4; ++k) {
        parts[3 + k].push_back(rounded(key.state.turn[k], kTurnSteps));
      }
    }
  }
  Json out{{"counts", columns.add(counts)},
           {"ticks", columns.add(ticks)},
           {"left", columns.add(left)},
           {"parts", Json::array()}};
  for (const Numbers& part : parts) out["parts"].push_back(columns.add(part));
  return out;
}

/// Without falling asleep and waking up, which are most of the events and nothing that is seen.
Json events_json(const PoseTrace& trace, PageColumns& columns) {
  Numbers ticks, kinds, bodies, others;
  for (const TraceEvent& event : trace.events) {
    const EventKind kind = event.event.kind;
    if (kind == EventKind::slept || kind == EventKind::woke) continue;
    ticks.push_back(static_cast<std::int64_t>(event.tick));
    kinds.push_back(static_cast<std::int64_t>(kind));
    bodies.push_back(static_cast<std::uint32_t>(event.event.body));
    const bool floor = event.event.other == kFloorId;
    others.push_back(floor ? -1 : std::int64_t{static_cast<std::uint32_t>(event.event.other)});
  }
  return {{"ticks", columns.add(ticks)},
          {"kinds", columns.add(kinds)},
          {"bodies", columns.add(bodies)},
          {"others", columns.add(others)}};
}

/// What a channel said: ticks, bodies and texts, which stand in a list once each. States are said
/// again at the beginning of each chunk of a trace, which is left out here; happenings are not.
Json values_json(const PoseTrace& trace, const std::string& name, PageColumns& columns) {
  const auto& channels = trace.header.channels;
  const auto found = std::find(channels.begin(), channels.end(), name);
  const auto channel = static_cast<std::uint32_t>(found - channels.begin());
  Numbers ticks, bodies, texts;
  Json list = Json::array();
  std::map<std::string, std::int64_t> known;
  std::map<std::uint32_t, std::int64_t> said;  // by each body, last
  for (const TraceValue& value : trace.values) {
    if (value.channel != channel) continue;
    const auto [place, fresh] = known.try_emplace(value.bytes, known.size());
    if (fresh) list.push_back(value.bytes);
    std::int64_t& last = said.try_emplace(value.body, -1).first->second;
    if (last == place->second && name != "log") continue;
    last = place->second;
    ticks.push_back(static_cast<std::int64_t>(value.tick));
    bodies.push_back(value.body);
    texts.push_back(place->second);
  }
  return {{"list", list},
          {"ticks", columns.add(ticks)},
          {"bodies", columns.add(bodies)},
          {"texts", columns.add(texts)}};
}

}  // namespace

void add_pose_run(const PoseTrace& trace, const std::string& name, PageContent& page) {
  const PoseTraceHeader& header = trace.header;
  const double end = static_cast<double>(trace.end.ticks) * header.step;
  PageColumns& columns = page.columns();
  Json bodies = Json::array();
  for (const TraceBody& body : header.bodies) bodies.push_back(body_json(body));
  const std::string ended = trace.end.message.empty() ? std::string(to_string(trace.end.why))
                                                      : printable(trace.end.message);
  page.add(
      {{"kind", "poses"},
       {"name", printable(name)},
       {"title", printable(header.title.empty() ? name : header.title)},
       {"step", header.step},
       {"end", trace.end.ticks},
       {"place", kPlaceQuantum * kPlaceSteps},
       {"facts", Json::array({Json::array({"seed", std::to_string(header.seed)}),
                              Json::array({"bodies", std::to_string(header.bodies.size())}),
                              Json::array({"ended", fmt::format("{} after {:.2f} s", ended, end)}),
                              Json::array({"hash", to_hex(trace.end.hash)})})},
       {"bodies", std::move(bodies)},
       {"tracks", tracks_json(trace, columns)},
       {"events", events_json(trace, columns)},
       {"leds", values_json(trace, "leds", columns)},
       {"log", values_json(trace, "log", columns)},
       {"show", values_json(trace, "show", columns)},
       {"senses", values_json(trace, "senses", columns)},
       {"magnets", values_json(trace, "magnets", columns)},
       {"contacts", values_json(trace, "contacts", columns)},
       {"pulls", values_json(trace, "pulls", columns)},
       {"devices", devices_json(trace)}});
}

}  // namespace stig::view
