// SPDX-License-Identifier: MIT
#include "child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "base/text.h"

namespace stig::cli {

std::string temporary_folder() {
  const char* named = std::getenv("TMPDIR");
  return named != nullptr && *named != 0 ? named : "/tmp";
}

OpenFile nameless_file() {
  std::string path = temporary_folder() + "/stigc-XXXXXX";
  const int descriptor = mkostemp(path.data(), O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  unlink(path.c_str());
  return OpenFile(fdopen(descriptor, "w+b"));
}

std::string contents(std::FILE* file, std::size_t most) {
  std::fseek(file, 0, SEEK_END);
  const long size = std::ftell(file);
  std::string out(std::min(most, static_cast<std::size_t>(std::max(size, 0L))), '\0');
  std::rewind(file);
  out.resize(std::fread(out.data(), 1, out.size(), file));
  return out;
}

int start_program(const ProgramStart& start, pid_t& process) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const auto& [ours, its] : start.descriptors) {
    posix_spawn_file_actions_adddup2(&files, ours, its);
  }
  sigset_t usual;
  sigemptyset(&usual);
  for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&usual, signal);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int group = start.own_group ? POSIX_SPAWN_SETPGROUP : 0;
  posix_spawnattr_setflags(&attributes, static_cast<short>(POSIX_SPAWN_SETSIGDEF | group));
  std::vector<char*> argv;
  for (const std::string& word : start.words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const int error =
      posix_spawn(&process, start.program.c_str(), &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

int exit_code_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::optional<Finished> run_program(const std::string& program,
                                    const std::vector<std::string>& arguments, std::size_t most,
                                    std::string& problem) {
  const OpenFile out = nameless_file(), words = nameless_file();
  if (!out || !words) {
    problem = fmt::format("cannot make a temporary file: {}", strerror(errno));
    return std::nullopt;
  }
  ProgramStart start{program, {program}, {}};
  start.words.insert(start.words.end(), arguments.begin(), arguments.end());
  start.descriptors = {{fileno(out.get()), STDOUT_FILENO}, {fileno(words.get()), STDERR_FILENO}};
  pid_t process = -1;
  if (const int error = start_program(start, process); error != 0) {
    problem = fmt::format("cannot run '{}': {}", printable(program), strerror(error));
    return std::nullopt;
  }
  Finished finished;
  finished.exit_code = exit_code_of(process);
  finished.out = contents(out.get(), most + 1);
  finished.words = contents(words.get(), kMostWords);
  if (finished.out.size() > most) {
    problem = fmt::format("'{}' printed more than {} bytes", printable(program), most);
    return std::nullopt;
  }
  return finished;
}

}  // namespace stig::cli
