// SPDX-License-Identifier: MIT
// A picture of a run is made from what a trace of it would have, so that both look alike.
#include "physical/simulation/run_picture.h"

#include "physical/render/show_json.h"

namespace stig::physics {

std::vector<PictureBody> picture_bodies(const Simulation& run) {
  std::vector<PictureBody> out;
  const PlacedScene& placed = run.placed();
  const PoseTraceHeader header = trace_header(run.scene(), placed);
  for (std::size_t i = 0; i < run.world().size(); ++i) {
    const BodyState state = run.world().state(BodyId{static_cast<std::uint32_t>(i)});
    if (state.left) continue;
    const TraceBody& body = header.bodies[i];
    out.push_back({body.shape, state.X_WB, body.rgb, body.block, run.led(i)});
  }
  return out;
}

std::vector<PictureLine> picture_lines(const Simulation& run) {
  std::vector<PictureLine> out;
  for (std::size_t i = 0; run.crew() != nullptr && i < run.crew()->robots(); ++i) {
    const Crew& crew = *run.crew();
    const std::string shown = show_json(crew.commands(i).user, inverse(crew.root_pose(i)));
    const auto lines = show_lines(shown, run.world().state(crew.root_body(i)).X_WB);
    out.insert(out.end(), lines.begin(), lines.end());
  }
  return out;
}

}  // namespace stig::physics
