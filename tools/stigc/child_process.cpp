// SPDX-License-Identifier: MIT
#include "child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "base/text.h"

namespace stig::cli {
namespace {

constexpr std::size_t kMostWords = 600;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// Starts it with no input. It stays in our group, so that Ctrl-C ends it too.
int spawn(const std::string& program, const std::vector<std::string>& arguments, int out, int words,
          pid_t& process) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, words, STDERR_FILENO);
  sigset_t usual;
  sigemptyset(&usual);
  for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&usual, signal);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  const int error =
      posix_spawn(&process, program.c_str(), &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

/// The file from its beginning, up to `most` bytes.
std::string contents(std::FILE* file, std::size_t most) {
  std::fseek(file, 0, SEEK_END);
  const long size = std::ftell(file);
  std::string out(std::min(most, static_cast<std::size_t>(std::max(size, 0L))), '\0');
  std::rewind(file);
  out.resize(std::fread(out.data(), 1, out.size(), file));
  return out;
}

}  // namespace

std::FILE* nameless_file() {
  const char* named = std::getenv("TMPDIR");
  std::string path = named != nullptr && *named != 0 ? named : "/tmp";
  path += "/stigc-XXXXXX";
  const int descriptor = mkostemp(path.data(), O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  unlink(path.c_str());
  return fdopen(descriptor, "w+b");
}

std::optional<Finished> run_program(const std::string& program,
                                    const std::vector<std::string>& arguments, std::size_t most,
                                    std::string& problem) {
  const File out(nameless_file()), words(nameless_file());
  if (!out || !words) {
    problem = fmt::format("cannot make a temporary file: {}", strerror(errno));
    return std::nullopt;
  }
  pid_t process = -1;
  const int error = spawn(program, arguments, fileno(out.get()), fileno(words.get()), process);
  if (error != 0) {
    problem = fmt::format("cannot run '{}': {}", printable(program), strerror(error));
    return std::nullopt;
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  Finished finished;
  if (WIFEXITED(status)) finished.exit_code = WEXITSTATUS(status);
  finished.out = contents(out.get(), most + 1);
  finished.words = contents(words.get(), kMostWords);
  if (finished.out.size() > most) {
    problem = fmt::format("'{}' printed more than {} bytes", printable(program), most);
    return std::nullopt;
  }
  return finished;
}

}  // namespace stig::cli
