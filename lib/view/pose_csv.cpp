// SPDX-License-Identifier: MIT
// Digits are those that the trace has: places to 10 µm, turns to 1/16384.
#include "view/pose_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "base/text.h"
#include "physical/trace/pose_frames.h"

namespace stig::view {
namespace {

/// What of a row is the same at every moment: ",body,kind".
std::vector<std::string> middles_of(const PoseTrace& trace) {
  std::vector<std::string> out;
  for (const TraceBody& body : trace.header.bodies) {
    out.push_back(
        fmt::format(",{},{}", csv_field(printable(body.name)), body.block ? "block" : "robot"));
  }
  return out;
}

void add_row(std::string& rows, const std::string& time, const std::string& middle,
             const TraceState& state) {
  const Pose pose = state.pose();
  // A trace may hold a turn of nothing but zeros.
  const Quat q = std::isfinite(pose.q.w) ? pose.q : Quat{};
  fmt::format_to(std::back_inserter(rows),
                 "{}{},{:.5f},{:.5f},{:.5f},{:.6f},{:.6f},{:.6f},{:.6f},{}\n", time, middle,
                 pose.p.x, pose.p.y, pose.p.z, q.w, q.x, q.y, q.z, state.awake ? 1 : 0);
}

}  // namespace

void write_pose_csv(const PoseTrace& trace, const std::function<bool(std::string_view)>& sink) {
  bool wanted = sink("time,body,kind,x,y,z,qw,qx,qy,qz,awake\n");
  const std::vector<std::string> middles = middles_of(trace);
  std::string rows;
  for_each_frame(trace, [&](const TraceFrame& frame) {
    if (!wanted) return;
    rows.clear();
    const std::string time =
        fmt::format("{:.6f}", static_cast<double>(frame.tick) * trace.header.step);
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      if (trace.header.bodies[i].fixed || frame.bodies[i].left) continue;
      add_row(rows, time, middles[i], frame.bodies[i]);
    }
    wanted = sink(rows);
  });
}

}  // namespace stig::view
