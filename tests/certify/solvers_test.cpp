// SPDX-License-Identifier: MIT
// Proofs as a solver writes them, and verdicts beside those of two others; each part runs
// where the programs are installed (packages cadical, minisat, picosat).
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "base/file_io.h"
#include "base/random.h"
#include "certify/drat.h"
#include "support/uses.h"

namespace stig {
namespace {

const std::string kCadical = STIG_CADICAL, kMinisat = STIG_MINISAT, kPicosat = STIG_PICOSAT;
constexpr int kSatisfiable = 10, kUnsatisfiable = 20;  // exit codes of solvers

class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "stig-solvers-XXXXXX";
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

bool installed(const std::string& program) { return program.find("NOTFOUND") == std::string::npos; }

int run(const std::string& command) {
  const int status = std::system((command + " > /dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string bytes_of(const std::string& path) {
  FileError error;
  const auto bytes = read_file(path, std::size_t{1} << 30, error);
  REQUIRE_MESSAGE(bytes, error.message);
  return *bytes;
}

std::string as_cnf(int variables, int clauses, const std::string& text) {
  return fmt::format("p cnf {} {}\n{}", variables, clauses, text);
}

/// More pigeons than holes, by one.
std::string pigeons(int holes) {
  std::string text;
  int clauses = 0;
  const auto in = [&](int pigeon, int hole) { return pigeon * holes + hole + 1; };
  for (int p = 0; p <= holes; ++p, ++clauses) {
    for (int h = 0; h < holes; ++h) text += fmt::format("{} ", in(p, h));
    text += "0\n";
  }
  for (int h = 0; h < holes; ++h) {
    for (int p = 0; p <= holes; ++p) {
      for (int q = 0; q < p; ++q, ++clauses) text += fmt::format("-{} -{} 0\n", in(p, h), in(q, h));
    }
  }
  return as_cnf((holes + 1) * holes, clauses, text);
}

/// Three literals a clause, so many clauses a variable.
std::string random_formula(int variables, double ratio, std::uint32_t number) {
  Random random(number, 0, Purpose::test, 0, 0);
  const int clauses = static_cast<int>(variables * ratio);
  std::string text;
  for (int i = 0; i < clauses; ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto variable = random.below(static_cast<std::uint64_t>(variables)) + 1;
      text += fmt::format("{}{} ", random.below(2) == 0 ? "-" : "", variable);
    }
    text += "0\n";
  }
  return as_cnf(variables, clauses, text);
}

void write(const std::string& path, const std::string& text) {
  FileError error;
  REQUIRE(write_file(path, text, error));
}

TEST_CASE("a solver's proofs are accepted, in both forms, and changed ones are not") {
  if (!installed(kCadical)) return;
  const Folder folder;
  for (const std::string& formula : {pigeons(4), pigeons(6), random_formula(100, 5, 1)}) {
    write(folder / "f.cnf", formula);
    for (const std::string form : {"", "--no-binary "}) {
      REQUIRE(run(fmt::format("{} -q {}{} {}", kCadical, form, folder / "f.cnf",
                              folder / "f.drat")) == kUnsatisfiable);
      const std::string proof = bytes_of(folder / "f.drat");
      const DratReport report = check_drat(formula, proof);
      CHECK(report.refusal == "");
      CHECK(report.lemmas > 10);
      CHECK_FALSE(check_drat(formula, proof.substr(0, proof.size() / 4)).refuted);
      // Without its first clause the formula has a solution: no proof can be one.
      std::string easier = formula;
      const std::size_t first = easier.find('\n') + 1;
      easier.erase(first, easier.find('\n', first) + 1 - first);
      const std::size_t count = easier.find(' ', 6) + 1;
      easier.replace(count, first - 1 - count, std::to_string(std::stoi(easier.substr(count)) - 1));
      if (formula[first] == '1') CHECK_FALSE(check_drat(easier, proof).refuted);
    }
  }
}

TEST_CASE("verdicts agree with those of other solvers") {
  if (!installed(kCadical) || !installed(kMinisat) || !installed(kPicosat)) return;
  const Folder folder;
  int refuted = 0;
  for (std::uint32_t number = 0; number < 30; ++number) {
    const std::string formula = random_formula(60, 4.4, number);
    write(folder / "f.cnf", formula);
    const int verdict =
        run(fmt::format("{} -q {} {}", kCadical, folder / "f.cnf", folder / "f.drat"));
    CHECK(run(kMinisat + " " + (folder / "f.cnf")) == verdict);
    CHECK(run(kPicosat + " " + (folder / "f.cnf")) == verdict);
    REQUIRE((verdict == kSatisfiable || verdict == kUnsatisfiable));
    CHECK(check_drat(formula, bytes_of(folder / "f.drat")).refuted == (verdict == kUnsatisfiable));
    refuted += verdict == kUnsatisfiable ? 1 : 0;
  }
  CHECK(refuted > 3);
  CHECK(refuted < 27);
}

}  // namespace
}  // namespace stig
