// SPDX-License-Identifier: MIT
// A folder of frames is marked as one by the list of them, which is written first: what an earlier
// film left there is replaced, anything else is not touched.
#include "film_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>

#include "base/file_io.h"
#include "encoder.h"
#include "outputs.h"
#include "progress.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = "frames.csv";

std::string frame_name(std::size_t frame) { return fmt::format("frame-{:05}.png", frame); }

std::string list_of(const Film& film, const FilmTimes& times) {
  std::string out = film.time == FilmTime::bricks ? "frame,bricks\n" : "frame,seconds\n";
  for (std::size_t i = 0; i < times.frames; ++i) {
    out += fmt::format("{},{:.6g}\n", frame_name(i), times.at(i));
  }
  return out;
}

bool has_list(const std::string& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder + "/" + kList, ignored);
}

/// Takes away frames of a longer film that was there before.
void remove_surplus(const std::string& folder, std::size_t frames) {
  std::error_code ignored;
  while (fs::remove(folder + "/" + frame_name(frames), ignored)) ++frames;
}

/// Where pictures go, one after the other.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual bool add(std::size_t frame, const std::string& png, std::string& problem) = 0;
  virtual bool finish(std::string& problem) = 0;
};

class FolderSink : public FrameSink {
 public:
  explicit FolderSink(std::string folder) : folder_(std::move(folder)) {}

  bool add(std::size_t frame, const std::string& png, std::string& problem) override {
    FileError error;
    const bool good = write_file(folder_ + "/" + frame_name(frame), png, error);
    problem = error.message;
    return good;
  }
  bool finish(std::string&) override { return true; }

 private:
  std::string folder_;
};

class VideoSink : public FrameSink {
 public:
  VideoSink(std::string path, Encoder& encoder) : path_(std::move(path)), encoder_(encoder) {}

  bool add(std::size_t, const std::string& png, std::string& problem) override {
    return encoder_.add(png, problem);
  }
  bool finish(std::string& problem) override { return encoder_.finish(path_, problem); }

 private:
  std::string path_;
  Encoder& encoder_;
};

/// Draws all frames; an exit code.
int draw_frames(const Film& film, const FilmTimes& times, bool orbit, FrameSink& sink, App& app) {
  stop_on_signals();
  Progress progress(app);
  std::string problem;
  for (std::size_t i = 0; i < times.frames; ++i) {
    // The frame after the last one would be the first again.
    const double share = static_cast<double>(i) / static_cast<double>(times.frames);
    const std::string png = film.picture(times.at(i), orbit ? 2 * std::numbers::pi * share : 0);
    progress.show(share, fmt::format("frame {} of {}", i + 1, times.frames));
    if (stop_requested()) problem = fmt::format("interrupted after {} frames", i);
    if (problem.empty() && png.empty()) problem = fmt::format("frame {} cannot be drawn", i + 1);
    if (problem.empty() && sink.add(i, png, problem)) continue;
    progress.clear();
    app.complain(problem);
    return kRunFailed;
  }
  progress.show(1, "the video is made");
  const bool good = sink.finish(problem);
  progress.clear();
  if (!good) app.complain(problem);
  return good ? kOk : kRunFailed;
}

std::string in_words(const Film& film, const FilmTimes& times) {
  std::string out = fmt::format("{} frames, {:.6g} a second", times.frames, times.fps);
  if (film.time == FilmTime::bricks) out += fmt::format(", {:.3g} bricks a second", times.speed);
  if (film.time == FilmTime::seconds && times.speed != 1) {
    out += fmt::format(", {:.3g} times as fast as the run", times.speed);
  }
  return out;
}

}  // namespace

std::string frames_folder(const std::string& output) {
  return fs::path(output).replace_extension().string() + "-frames";
}

int prepare_film(const std::string& output, const std::string& ending, std::size_t frames,
                 const App& app) {
  if (!ending.empty()) return check_outputs({output}, app);
  FolderOutputs outputs{output, {kList}, has_list(output), "film"};
  for (std::size_t i = 0; i < frames; ++i) outputs.names.push_back(frame_name(i));
  return prepare_folder(outputs, app);
}

int write_film(const Film& film, const FilmTimes& times, bool orbit, const std::string& output,
               const std::string& ending, App& app) {
  if (ending.empty()) {
    FileError error;
    if (!write_file(output + "/" + kList, list_of(film, times), error)) {
      app.complain(error.message);
      return kRunFailed;
    }
    remove_surplus(output, times.frames);
    FolderSink sink(output);
    const int code = draw_frames(film, times, orbit, sink, app);
    if (code == kOk) app.say(fmt::format("wrote {}: {}", printable(output), in_words(film, times)));
    return code;
  }
  const auto program = find_ffmpeg();
  Encoder encoder;
  std::string problem = "ffmpeg has gone";
  if (!program || !encoder.start(*program, ending, times.fps, problem)) {
    app.complain(problem);
    return kRunFailed;
  }
  VideoSink sink(output, encoder);
  const int code = draw_frames(film, times, orbit, sink, app);
  if (code == kOk) app.say(fmt::format("wrote {}: {}", printable(output), in_words(film, times)));
  return code;
}

}  // namespace stig::cli
