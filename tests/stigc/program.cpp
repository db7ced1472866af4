// SPDX-License-Identifier: MIT
#include "program.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

namespace fs = std::filesystem;

std::string fresh_folder() {
  std::string name = (fs::temp_directory_path() / "stigc-test-XXXXXX").string();
  REQUIRE(mkdtemp(name.data()) != nullptr);
  return name;
}

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void redirect(const std::string& path, int descriptor) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
  close(file);
}

/// In the child: becomes the program.
[[noreturn]] void become(const std::string& folder, const std::string& streams,
                         const std::vector<std::string>& words) {
  if (chdir(folder.c_str()) != 0) _exit(126);
  // A shell may have started the tests in the background, with these ignored.
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
  redirect(streams + "/out", STDOUT_FILENO);
  redirect(streams + "/err", STDERR_FILENO);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

pid_t spawn(const std::string& folder, const std::string& streams,
            const std::vector<std::string>& words) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) become(folder, streams, words);
  return child;
}

}  // namespace

Workplace::Workplace() : folder_(fresh_folder()), streams_(fresh_folder()) {
  fs::create_directory_symlink(STIG_TESTS_DIR "/stigc/sets", folder_ + "/sets");
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  fs::remove_all(streams_, ignored);
}

pid_t Workplace::start(const std::vector<std::string>& arguments) const {
  std::vector<std::string> words{STIGC_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return spawn(folder_, streams_, words);
}

void Workplace::let_work(pid_t process) {
  clockid_t clock{};
  REQUIRE(clock_getcpuclockid(process, &clock) == 0);
  timespec worked{};
  for (int i = 0; i < 6000; ++i) {
    REQUIRE(clock_gettime(clock, &worked) == 0);
    if (worked.tv_sec > 0 || worked.tv_nsec > 500'000'000) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL("it does not work");
}

Outcome Workplace::finish(pid_t process) const {
  int status = 0;
  REQUIRE(waitpid(process, &status, 0) == process);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(streams_ + "/out"),
          bytes_of(streams_ + "/err")};
}

Outcome Workplace::stigc(const std::vector<std::string>& arguments) const {
  return finish(start(arguments));
}

Outcome Workplace::shell(const std::string& line) const {
  // By its name, since programs start it as well as the shell.
  const std::string folder = fs::path(STIGC_PROGRAM).parent_path().string();
  const std::string script = "export PATH='" + folder + "':\"$PATH\"\n" + line;
  return finish(spawn(folder_, streams_, {"bash", "-c", script}));
}

bool Workplace::has(const std::string& name) const { return fs::exists(path(name)); }

std::string Workplace::file(const std::string& name) const {
  REQUIRE_MESSAGE(has(name), name);
  return bytes_of(path(name));
}

void Workplace::write(const std::string& name, const std::string& bytes) const {
  std::ofstream out(path(name), std::ios::binary);
  out << bytes;
}

std::vector<std::string> Workplace::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (entry.path().filename() != "sets") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string transcript(const std::string& line, const Outcome& outcome) {
  return "$ " + line + "\n" + outcome.out + "--- standard error\n" + outcome.err + "--- exit " +
         std::to_string(outcome.exit_code) + "\n";
}

void hold(const Workplace& place, const std::string& name, const std::string& line) {
  CAPTURE(line);
  check_golden("tests/stigc/golden/" + name + ".txt", transcript(line, place.shell(line)));
}

}  // namespace stig
