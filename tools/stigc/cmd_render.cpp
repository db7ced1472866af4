// SPDX-License-Identifier: MIT
// stigc render: pictures and films of runs and structures, without a window.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "commands.h"
#include "encoder.h"
#include "film_files.h"
#include "lattice/picture.h"
#include "lattice_film.h"
#include "outputs.h"
#include "pose_film.h"
#include "trace_rules.h"

namespace stig::cli {
namespace {

constexpr std::size_t kMostFrames = 100'000;

bool is_picture(const std::string& ending) { return ending == ".png" || ending == ".svg"; }

/// By its ending or, whatever it is called, its first bytes.
bool is_trace(const std::string& file) {
  if (file.ends_with(".stigt") || file.ends_with(".stigp")) return true;
  std::error_code ignored;
  std::array<char, kPoseTraceMagic.size()> first{};
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::ifstream(file, std::ios::binary).read(first.data(), first.size());
  const std::string_view magic(first.data(), first.size());
  return magic == kPoseTraceMagic || magic == kTraceMagic;
}

/// What is wrong with the options together; empty: nothing.
std::string usage_problem(const RenderOptions& o, const std::string& ending) {
  const bool known =
      std::find(kFilmEndings.begin(), kFilmEndings.end(), ending) != kFilmEndings.end();
  std::error_code ignored;
  const bool folder = o.output.ends_with('/') || std::filesystem::is_directory(o.output, ignored);
  if (!known && !(ending.empty() && folder)) {
    return fmt::format("'{}' is none of {}, nor a folder with a / at its end", o.output,
                       fmt::join(kFilmEndings, " "));
  }
  const bool film_times = o.from || o.to || o.fps || o.speed;
  if (is_picture(ending) && film_times) {
    return "--from, --to, --fps and --speed are of films; a picture has --time";
  }
  if (!is_picture(ending) && o.time) return "--time is of a picture; a film has --from and --to";
  if (o.from && o.to && *o.from > *o.to) return "--to is before --from";
  if (ending == ".glb") {
    const bool seen = o.camera || o.ghost || o.width || o.view.orbit || o.view.azimuth ||
                      o.no_title || o.no_legend;
    if (seen) return "a .glb has no camera, size, words or ghosts: whoever opens it chooses";
  }
  for (auto one = o.slices.begin(); one != o.slices.end(); ++one) {
    const auto same = [one](const Slice& other) { return other.axis == one->axis; };
    if (std::any_of(o.slices.begin(), one, same)) return "there are two --slice for one axis";
  }
  if (o.camera && (o.width || o.view.azimuth || o.view.orbit || o.ghost || !o.slices.empty() ||
                   o.palette != Palette::file)) {
    return "--camera shows what a robot sees, as large as it does: leave out --size, --view, "
           "--ghost, --slice and --palette";
  }
  return {};
}

/// What is wrong with them for a file of this kind.
std::string kind_problem(const RenderOptions& o, const std::string& ending, const Film& film) {
  const bool physical = film.time == FilmTime::seconds;
  if (o.camera && ending == ".svg") return "what a camera sees are pixels: draw a .png";
  if (!physical && o.camera) return "--camera is of physical runs";
  const bool film_wanted = !is_picture(ending) && ending != ".glb";
  if (film.time == FilmTime::none && (o.time || o.ghost)) {
    return "a structure has no time: --time and --ghost are of runs";
  }
  if (film.time == FilmTime::none && film_wanted && !o.view.orbit) {
    return "a structure has no time to film: add --view orbit, or draw a .png";
  }
  return {};
}

std::optional<Film> open_film(const RenderOptions& options, const App& app, int& code) {
  code = kFailed;
  if (!is_trace(options.file)) return structure_film(options, app);
  auto bytes = trace_bytes(options.file, app);
  if (!bytes) return std::nullopt;
  if (!bytes->starts_with(kPoseTraceMagic)) return lattice_film(options, *bytes, app);
  Diagnostics diagnostics;
  auto trace = read_pose_trace(options.file, std::move(*bytes), diagnostics);
  app.report(diagnostics);
  if (!trace) return std::nullopt;
  return pose_film(options, std::make_shared<const PoseTrace>(std::move(*trace)), app, code);
}

int write_one(const RenderOptions& options, const std::string& bytes, const std::string& problem,
              const App& app) {
  if (!bytes.empty()) return write_output(options.output, bytes, app);
  app.complain(problem);
  return kRunFailed;
}

int write_picture_or_glb(const RenderOptions& options, const std::string& ending, const Film& film,
                         const FilmTimes& times, const App& app) {
  if (const int code = check_outputs({options.output}, app); code != kOk) return code;
  std::string problem = ending == ".svg" ? fmt::format(
                                               "the picture has more than {} faces, too "
                                               "many for an .svg: draw a .png",
                                               kMostSvgFaces)
                                         : "the picture cannot be drawn";
  if (ending != ".glb") {
    const double time = std::min(options.time.value_or(film.end), film.end);
    if (options.time && *options.time > time) {
      app.say(fmt::format("the end is drawn, {:g} {}", film.end,
                          film.time == FilmTime::seconds ? "s" : "bricks"));
    }
    return write_one(options, film.picture(time, 0), problem, app);
  }
  const std::string bytes = film.glb(times, problem);
  return write_one(options, bytes, problem, app);
}

/// The video, or where there is no ffmpeg its frames.
int write_video(const RenderOptions& options, std::string ending, const Film& film,
                const FilmTimes& times, App& app) {
  std::string output = options.output;
  while (output.size() > 1 && output.ends_with('/')) output.pop_back();
  const bool frames_alone = !ending.empty() && !find_ffmpeg();
  if (frames_alone) {
    output = frames_folder(output);
    ending.clear();
  }
  if (const int code = prepare_film(output, ending, times.frames, app); code != kOk) return code;
  const int code = write_film(film, times, options.view.orbit, output, ending, app);
  if (code == kOk && frames_alone) {
    app.complain(
        fmt::format("there is no ffmpeg here, which makes videos: '{}' has not been "
                    "written, but its frames into '{}'",
                    printable(options.output), printable(output)));
  }
  return code;
}

}  // namespace

int run(const RenderOptions& given, App& app) {
  const RenderOptions options = with_size(given);
  const std::string ending = film_ending(options);
  std::string problem = usage_problem(given, ending);
  if (!problem.empty()) {
    app.complain(printable(problem));
    return kUsage;
  }
  int code = kFailed;
  const std::optional<Film> film = open_film(options, app, code);
  if (!film) return code;
  const FilmTimes times = film_times(options, *film);
  problem = kind_problem(options, ending, *film);
  if (problem.empty() && times.frames > kMostFrames && !is_picture(ending)) {
    problem = fmt::format("{} frames are more than {}: take a greater --speed or fewer --fps",
                          times.frames, kMostFrames);
  }
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  return is_picture(ending) || ending == ".glb"
             ? write_picture_or_glb(options, ending, *film, times, app)
             : write_video(options, ending, *film, times, app);
}

}  // namespace stig::cli
