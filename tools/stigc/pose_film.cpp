// SPDX-License-Identifier: MIT
#include "pose_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera_place.h"
#include "physical/simulation/loaded_scene.h"
#include "physical/simulation/simulation.h"
#include "physical/trace/pose_frames.h"
#include "simulate_report.h"
#include "view/pose_glb.h"
#include "view/pose_svg.h"
#include "view/trace_picture.h"

namespace stig::cli {
namespace {

constexpr std::uint64_t kFramedMoments = 256;  ///< of a run, that its view is fitted to
constexpr double kAway = 0.005;                ///< m: a ghost nearer to its block is not drawn
constexpr Rgb kGhostLine{142, 152, 168};

bool is_shown(const std::vector<Slice>& slices, const Vec3& p) {
  return std::all_of(slices.begin(), slices.end(), [&](const Slice& slice) {
    const double along = slice.axis == 0 ? p.x : slice.axis == 1 ? p.y : p.z;
    return along >= slice.low && along <= slice.high;
  });
}

/// The camera after a turn about the upright through the middle of what stands on the floor.
PictureView turned_view(PictureView view, const PictureFloor& about, double turn) {
  if (turn == 0) return view;
  const Vec3 middle = (about.low + about.high) * 0.5;
  const Pose round{{}, rotation({0, 0, turn})};
  view.X_WC = Pose{middle, {}} * round * Pose{-middle, {}} * view.X_WC;
  return view;
}

/// The points of a ring about the points: the same from all around.
std::vector<Vec3> ring_about(const std::vector<Vec3>& points) {
  constexpr int kSides = 48;
  const PictureFloor box = floor_under(points);
  const Vec3 middle = (box.low + box.high) * 0.5;
  double radius = 0;
  for (const Vec3& p : points)
    radius = std::max(radius, std::hypot(p.x - middle.x, p.y - middle.y));
  std::vector<Vec3> out;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    const double x = middle.x + radius * std::cos(angle), y = middle.y + radius * std::sin(angle);
    out.push_back({x, y, box.low.z});
    out.push_back({x, y, box.high.z});
  }
  return out;
}

class PosePictures {
 public:
  PosePictures(std::shared_ptr<const PoseTrace> trace, RenderOptions options, bool floor)
      : trace_(std::move(trace)), options_(std::move(options)), with_floor_(floor) {
    std::vector<Vec3> points = points_of_run();
    floor_ = floor_under(points);
    if (options_.view.orbit) points = ring_about(points);
    PictureLook look;
    look.width = *options_.width;
    look.height = *options_.height;
    look.azimuth = options_.view.azimuth.value_or(look.azimuth);
    look.elevation = options_.view.elevation.value_or(look.elevation);
    view_ = view_holding(points, look);
    if (options_.ghost) last_ = bodies_at(frame_at(*trace_, trace_->end.ticks));
  }

  std::string draw(double time, double turn) const {
    const double step = trace_->header.step;
    const auto tick = static_cast<std::uint64_t>(std::llround(time / step));
    const TraceFrame frame = frame_at(*trace_, tick);
    const std::vector<PictureBody> bodies = bodies_at(frame);
    std::vector<PictureLine> lines = picture_lines(*trace_, frame);
    add_ghosts(bodies, lines);
    const PictureView view = turned_view(view_, floor_, turn);
    // From below, the floor would hide what stands on it.
    const bool above = view.X_WC.p.z > 0;
    const auto floor = with_floor_ && above ? std::optional(floor_) : std::nullopt;
    const std::string caption =
        options_.no_title
            ? ""
            : picture_caption(trace_->header.title, static_cast<double>(frame.tick) * step,
                              floor ? floor_.grid : 0);
    if (film_ending(options_) == ".svg") return pose_svg(bodies, view, floor, lines, caption);
    return png_of(draw_bodies(bodies, view, floor, lines), caption);
  }

 private:
  std::vector<PictureBody> bodies_at(const TraceFrame& frame) const {
    std::vector<PictureBody> out = picture_bodies(*trace_, frame);
    std::erase_if(out, [&](const auto& body) { return !is_shown(options_.slices, body.X_WB.p); });
    for (PictureBody& body : out) {
      if (options_.palette == Palette::file || body.led == Led::off) continue;
      body.glow = rgb_in(options_.palette, static_cast<Colour>(body.led));
    }
    return out;
  }

  // Places at moments all over the run, and at its end.
  std::vector<Vec3> points_of_run() const {
    const std::uint64_t every = std::max<std::uint64_t>(1, trace_->frames / kFramedMoments);
    std::vector<Vec3> points;
    std::uint64_t number = 0;
    const auto add = [&](const TraceFrame& frame) {
      const std::vector<PictureBody> bodies = bodies_at(frame);
      if (bodies.empty()) return;
      const std::vector<Vec3> more = points_about(bodies);
      points.insert(points.end(), more.begin(), more.end());
    };
    for_each_frame(*trace_, [&](const TraceFrame& frame) {
      if (number++ % every == 0) add(frame);
    });
    add(frame_at(*trace_, trace_->end.ticks));
    return points.empty() ? points_about({}) : points;
  }

  /// Where blocks will be at the end, as edges.
  void add_ghosts(const std::vector<PictureBody>& now, std::vector<PictureLine>& lines) const {
    for (const PictureBody& ghost : last_) {
      const bool there = std::any_of(now.begin(), now.end(), [&](const PictureBody& body) {
        return body.block && length(body.X_WB.p - ghost.X_WB.p) < kAway;
      });
      if (!ghost.block || there) continue;
      for (const SolidFace& face : faces_of(ghost.shape)) {
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
          lines.push_back({ghost.X_WB * face.corners[i],
                           ghost.X_WB * face.corners[(i + 1) % face.corners.size()], 1.3,
                           kGhostLine, 4e-4});
        }
      }
    }
  }

  std::shared_ptr<const PoseTrace> trace_;
  RenderOptions options_;
  bool with_floor_;
  PictureFloor floor_;
  PictureView view_;
  std::vector<PictureBody> last_;  ///< ghosts
};

/// Runs the trace's scene again: what a camera sees depends on more than a trace has.
class CameraPictures {
 public:
  explicit CameraPictures(LoadedScene loaded)
      : loaded_(std::move(loaded)), run_(loaded_.scene, loaded_.placed, false) {}

  bool find(const std::string& name, std::string& problem) {
    const auto found = camera_named(run_, name, problem);
    if (found) place_ = *found;
    return found.has_value();
  }

  std::string draw(double time) {
    RunHooks hooks;
    hooks.stop = &stop_requested();
    const double step = loaded_.placed.config.step;
    run_.until(std::round(time / step) * step, hooks);
    return stop_requested() ? std::string{} : view_png(run_, place_);
  }

 private:
  LoadedScene loaded_;
  Simulation run_;
  CameraPlace place_;
};

std::optional<Film> through_camera(const RenderOptions& options, const PoseTrace& trace,
                                   const App& app, int& code) {
  Diagnostics diagnostics;
  auto loaded = load_scene(trace.header.files, trace.header.seed, diagnostics);
  code = kFailed;
  if (!loaded) {
    app.report(diagnostics);
    return std::nullopt;
  }
  auto pictures = std::make_shared<CameraPictures>(std::move(*loaded));
  std::string problem;
  if (!pictures->find(*options.camera, problem)) {
    app.complain(printable(problem));
    code = kUsage;
    return std::nullopt;
  }
  code = kOk;
  Film film;
  film.time = FilmTime::seconds;
  film.picture = [pictures](double time, double) { return pictures->draw(time); };
  return film;
}

/// As its scene says, which the trace holds.
bool has_floor(const PoseTrace& trace) {
  Diagnostics ignored;
  const auto loaded = load_scene(trace.header.files, trace.header.seed, ignored);
  // A trace whose scene cannot be read gets a floor: most have one.
  return !loaded || loaded->placed.config.floor;
}

}  // namespace

std::optional<Film> pose_film(const RenderOptions& options,
                              const std::shared_ptr<const PoseTrace>& trace, const App& app,
                              int& code) {
  code = kOk;
  std::optional<Film> film =
      options.camera ? through_camera(options, *trace, app, code) : std::optional(Film{});
  if (!film) return std::nullopt;
  film->time = FilmTime::seconds;
  film->end = static_cast<double>(trace->end.ticks) * trace->header.step;
  if (!options.camera) {
    // Made with the first picture: a .glb takes none.
    auto pictures = std::make_shared<std::unique_ptr<PosePictures>>();
    film->picture = [trace, options, pictures](double time, double turn) {
      if (!*pictures) {
        *pictures = std::make_unique<PosePictures>(trace, options, has_floor(*trace));
      }
      return (*pictures)->draw(time, turn);
    };
  }
  film->glb = [trace, options](const FilmTimes& times, std::string&) {
    PoseLook look;
    if (!options.slices.empty()) {
      look.shown = [&options](const Vec3& place) { return is_shown(options.slices, place); };
    }
    if (options.palette != Palette::file) {
      look.glow = [&options](Led led) { return rgb_in(options.palette, static_cast<Colour>(led)); };
    }
    return pose_glb(*trace, {times.from, times.to, times.speed}, look);
  };
  return film;
}

}  // namespace stig::cli
