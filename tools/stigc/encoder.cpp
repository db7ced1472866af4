// SPDX-License-Identifier: MIT
#include "encoder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "base/file_io.h"

namespace stig::cli {
namespace {

constexpr int kFilmDescriptor = 3;  ///< of the program

/// What ffmpeg is told. Without metadata, which would name its version; sides of yuv420p are even.
std::vector<std::string> arguments_of(const std::string& ending, double fps) {
  std::vector<std::string> out = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y"};
  const auto add = [&](std::initializer_list<const char*> more) {
    out.insert(out.end(), more.begin(), more.end());
  };
  add({"-f", "image2pipe", "-framerate"});
  out.push_back(fmt::format("{:.6f}", fps));
  add({"-c:v", "png", "-i", "pipe:0", "-an", "-map_metadata", "-1", "-fflags", "+bitexact"});
  add({"-flags:v", "+bitexact"});
  const char* even = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white";
  if (ending == ".mp4") {
    add({"-vf", even, "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p"});
    add({"-movflags", "+faststart", "-f", "mp4"});
  } else if (ending == ".webm") {
    add({"-vf", even, "-c:v", "libvpx-vp9", "-crf", "32", "-b:v", "0", "-cpu-used", "4"});
    add({"-pix_fmt", "yuv420p", "-f", "webm"});
  } else {
    // Plain surfaces need no dithering, which would make files large.
    add({"-filter_complex",
         "[0:v]split[a][b];[a]palettegen=max_colors=128:stats_mode=full[p];"
         "[b][p]paletteuse=dither=none:diff_mode=rectangle"});
    add({"-loop", "0", "-f", "gif"});
  }
  out.push_back(fmt::format("/dev/fd/{}", kFilmDescriptor));
  return out;
}

/// Copies beyond the descriptors that the program's own take, so that none is lost before it is
/// used; closed when a program is started.
int moved_up(int descriptor) { return fcntl(descriptor, F_DUPFD_CLOEXEC, 10); }

}  // namespace

std::optional<std::string> find_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string folder(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    // An empty entry would be the working directory, from which nothing is run.
    if (folder.empty() || folder[0] != '/') continue;
    const std::string program = folder + "/ffmpeg";
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  return std::nullopt;
}

Encoder::~Encoder() {
  if (pipe_ >= 0) close(pipe_);
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

bool Encoder::start(const std::string& program, const std::string& ending, double fps,
                    std::string& problem) {
  film_ = nameless_file();
  words_ = nameless_file();
  std::array<int, 2> ends{-1, -1};
  if (!film_ || !words_ || pipe2(ends.data(), O_CLOEXEC) != 0) {
    problem = fmt::format("cannot make a temporary file: {}", strerror(errno));
    return false;
  }
  pipe_ = moved_up(ends[1]);
  close(ends[1]);
  const std::array<int, 3> up = {moved_up(ends[0]), moved_up(fileno(film_.get())),
                                 moved_up(fileno(words_.get()))};
  close(ends[0]);
  const ProgramStart begin{program,
                           arguments_of(ending, fps),
                           {{up[0], STDIN_FILENO},
                            {up[2], STDOUT_FILENO},
                            {up[2], STDERR_FILENO},
                            {up[1], kFilmDescriptor}},
                           true};
  const int error = start_program(begin, process_);
  for (const int descriptor : up) close(descriptor);
  if (error == 0) return true;
  process_ = -1;
  problem = fmt::format("cannot run '{}': {}", printable(program), strerror(error));
  return false;
}

bool Encoder::add(std::string_view png, std::string& problem) {
  if (write_all(pipe_, png)) return true;
  // It has gone; what it said is the reason.
  problem = "ffmpeg stopped: " + words();
  return false;
}

bool Encoder::finish(const std::string& path, std::string& problem) {
  close(pipe_);
  pipe_ = -1;
  const int code = exit_code_of(process_);
  process_ = -1;
  if (code != 0) {
    problem = "ffmpeg failed: " + words();
    return false;
  }
  GrowingFile file;
  FileError error;
  bool good = file.open(path, error);
  std::rewind(film_.get());
  std::string piece(std::size_t{1} << 20, '\0');
  std::size_t all = 0;
  while (good) {
    const std::size_t size = std::fread(piece.data(), 1, piece.size(), film_.get());
    if (size == 0) break;
    all += size;
    good = file.append({piece.data(), size}, error);
  }
  if (good && (all == 0 || std::ferror(film_.get()) != 0)) {
    problem = "ffmpeg wrote nothing: " + words();
    return false;
  }
  good = good && file.commit(error);
  problem = error.message;
  return good;
}

std::string Encoder::words() const {
  std::string out = contents(words_.get(), kMostWords);
  while (!out.empty() && out.back() == '\n') out.pop_back();
  return out.empty() ? "it does not say why" : printable(out);
}

}  // namespace stig::cli
